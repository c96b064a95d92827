/* Runs the kernels of the curvature on a generated mesh, and prints a digest of the bytes of their results.
 *
 * tools/wheels.py compares the digests of several processors. Compile it with the sources of
 * src/skinshade/_core/native and the level of their names. */
#include "kernels.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 120, VERTICES = SIDE * SIDE, FACES = 2 * (SIDE - 1) * (SIDE - 1) };

static uint64_t random_state = 1;

static double random_number(void)
{
    random_state = random_state * 6364136223846793005u + 1442695040888963407u;
    return (double)(random_state >> 11) / 9007199254740992.0;
}

static void *memory(size_t size)
{
    void *block = calloc(1, size);
    if (!block)
        exit(1);
    return block;
}

static void digest(const char *name, const void *bytes, size_t size)
{
    uint64_t hash = 0xCBF29CE484222325u;
    for (size_t i = 0; i < size; i++)
        hash = (hash ^ ((const uint8_t *)bytes)[i]) * 0x100000001B3u;
    printf("%s %016llx\n", name, (unsigned long long)hash);
}

int main(void)
{
    double *points = memory(VERTICES * 3 * sizeof(double)), *normals = memory(VERTICES * 3 * sizeof(double));
    double *areas = memory(VERTICES * sizeof(double)), *mean = memory(VERTICES * sizeof(double));
    double *tensor = memory(VERTICES * 3 * sizeof(double));
    double *one = memory(VERTICES * 8 * sizeof(double)), *other = memory(VERTICES * 8 * sizeof(double));
    int64_t *faces = memory(FACES * 3 * sizeof(int64_t)), *face = faces;
    uint8_t *bounded = memory(VERTICES);
    for (int i = 0; i < VERTICES; i++) {
        const double x = i / SIDE + 0.8 * random_number(), y = i % SIDE + 0.8 * random_number();
        points[3 * i] = x, points[3 * i + 1] = y;
        points[3 * i + 2] = 0.01 * (x * x - y * y) + 0.5 * random_number();
    }
    for (int i = 0; i + 1 < SIDE; i++) {
        for (int j = 0; j + 1 < SIDE; j++) {
            const int64_t a = i * SIDE + j, corners[6] = {a, a + SIDE, a + SIDE + 1, a, a + SIDE + 1, a + 1};
            for (int corner = 0; corner < 6; corner++)
                *face++ = corners[corner];
        }
    }
    const int64_t slabs = (VERTICES + LANES - 1) / LANES;
    uint32_t *cursors = memory(VERTICES * sizeof(uint32_t)), *counts = memory(VERTICES * sizeof(uint32_t));
    uint32_t *starts = memory((size_t)slabs * sizeof(uint32_t));
    SKN(corner_count)(faces, SKN_I64, 0, FACES, NULL, VERTICES, cursors);
    const int64_t rows = SKN(corner_sum)(cursors, 1, VERTICES, 0, slabs, counts);
    uint32_t *corners = memory((size_t)rows * LANES * 2 * sizeof(uint32_t));
    SKN(corner_starts)(cursors, 1, VERTICES, counts, 0, slabs, 0, starts, corners);
    SKN(corner_fill)(faces, SKN_I64, 0, FACES, NULL, cursors, corners);
    SKN(vertex_normals)(points, starts, counts, corners, VERTICES, 0, slabs, normals, areas);
    digest("normals", normals, VERTICES * 3 * sizeof(double));
    digest("areas", areas, VERTICES * sizeof(double));

    const double bounds[3] = {2.0, 4.0, 0.05};
    SKN(fit)(points, normals, starts, counts, corners, VERTICES, 0, slabs, bounds, mean, NULL, NULL);
    SKN(fit)(points, normals, starts, counts, corners, VERTICES, 0, slabs, bounds, tensor, areas, bounded);
    digest("mean", mean, VERTICES * sizeof(double));
    digest("tensor", tensor, VERTICES * 3 * sizeof(double));
    digest("bounded", bounded, VERTICES);
    SKN(weigh_mean)(mean, areas, 0, VERTICES, one);
    SKN(smooth_mean)(one, starts, counts, corners, VERTICES, 0, slabs, 0, other);
    SKN(smooth_mean)(other, starts, counts, corners, VERTICES, 0, slabs, 1, one);
    digest("smoothed mean", one, VERTICES * sizeof(double));
    SKN(weigh_world)(tensor, areas, normals, 0, VERTICES, one);
    SKN(smooth_world)(one, starts, counts, corners, VERTICES, 0, slabs, 1, other);
    digest("smoothed tensor", other, VERTICES * 8 * sizeof(double));
    return 0;
}
