/* Corners of the faces around every vertex, by a counting sort: of each corner the next and the previous vertex.
 * NumPy twin: Neighbours of skinshade/mesh/topology.py.
 *
 * Four successive vertices share a slab: its rows hold a corner of each of them, as fans.h reads them. Several parts
 * of the faces are counted and filled at once, each with its own table of counts; the corners of a vertex have the
 * order of the faces, for any number of parts. */
#include "rows.h"

#include <string.h>

SKN_INLINE void count_corners(const void *faces, int32_t kind, int64_t first, int64_t last, const uint32_t *remap,
                              uint32_t *counts)
{
    for (int64_t i = first; i < last; i++) {
        int64_t face[3];
        skn_face(faces, kind, i, face);
        for (int corner = 0; corner < 3; corner++)
            counts[remap ? remap[face[corner]] : face[corner]]++;
    }
}

SKN_INLINE void put(uint32_t *cursors, uint32_t *corners, uint32_t vertex, uint32_t next, uint32_t previous)
{
    uint32_t *out = corners + 2 * (size_t)cursors[vertex];
    cursors[vertex] += LANES;
    out[0] = next, out[1] = previous;
}

SKN_INLINE void fill_corners(const void *faces, int32_t kind, int64_t first, int64_t last, const uint32_t *remap,
                             uint32_t *cursors, uint32_t *corners)
{
    for (int64_t i = first; i < last; i++) {
        int64_t face[3];
        skn_face(faces, kind, i, face);
        const uint32_t a = remap ? remap[face[0]] : (uint32_t)face[0];
        const uint32_t b = remap ? remap[face[1]] : (uint32_t)face[1];
        const uint32_t c = remap ? remap[face[2]] : (uint32_t)face[2];
        put(cursors, corners, a, b, c);
        put(cursors, corners, b, c, a);
        put(cursors, corners, c, a, b);
    }
}

/* Writes the counts of the corners at every vertex. */
void SKN(corner_count)(const void *faces, int32_t kind, int64_t first, int64_t last, const uint32_t *remap,
                       int64_t vertices, uint32_t *counts)
{
    memset(counts, 0, (size_t)vertices * sizeof *counts);
    if (kind == SKN_I32)
        count_corners(faces, SKN_I32, first, last, remap, counts);
    else
        count_corners(faces, SKN_I64, first, last, remap, counts);
}

/* Writes the sums of the counts of all tables, and returns the number of rows of the slabs first..last - 1. */
int64_t SKN(corner_sum)(const uint32_t *tables, int64_t parts, int64_t vertices, int64_t first, int64_t last,
                        uint32_t *counts)
{
    int64_t rows = 0;
    for (int64_t slab = first; slab < last; slab++) {
        const int64_t end = LANES * (slab + 1) < vertices ? LANES * (slab + 1) : vertices;
        uint32_t most = 0;
        for (int64_t vertex = LANES * slab; vertex < end; vertex++) {
            uint32_t sum = 0;
            for (int64_t part = 0; part < parts; part++)
                sum += tables[part * vertices + vertex];
            counts[vertex] = sum;
            most = sum > most ? sum : most;
        }
        rows += most;
    }
    return rows;
}

/* Writes the first row of every slab and the corners that no face fills, and replaces the counts in the tables by the
 * place of the first corner of each part. */
void SKN(corner_starts)(uint32_t *tables, int64_t parts, int64_t vertices, const uint32_t *counts, int64_t first,
                        int64_t last, int64_t row, uint32_t *starts, uint32_t *corners)
{
    for (int64_t slab = first; slab < last; slab++) {
        const int64_t end = LANES * (slab + 1) < vertices ? LANES * (slab + 1) : vertices;
        uint32_t most = 0;
        starts[slab] = (uint32_t)row;
        for (int64_t vertex = LANES * slab; vertex < end; vertex++)
            most = counts[vertex] > most ? counts[vertex] : most;
        for (int lane = 0; lane < LANES; lane++) {
            const int64_t vertex = LANES * slab + lane;
            uint32_t at = (uint32_t)(LANES * row + lane), filled = 0;
            for (int64_t part = 0; part < parts && vertex < vertices; part++) {
                const uint32_t count = tables[part * vertices + vertex];
                tables[part * vertices + vertex] = at + LANES * filled;
                filled += count;
            }
            for (uint32_t k = filled; k < most; k++)
                corners[2 * (size_t)(at + LANES * k)] = corners[2 * (size_t)(at + LANES * k) + 1] =
                    (uint32_t)(vertex < vertices ? vertex : vertices - 1);
        }
        row += most;
    }
}

/* Writes the corners of faces. */
void SKN(corner_fill)(const void *faces, int32_t kind, int64_t first, int64_t last, const uint32_t *remap,
                      uint32_t *cursors, uint32_t *corners)
{
    if (kind == SKN_I32)
        fill_corners(faces, SKN_I32, first, last, remap, cursors, corners);
    else
        fill_corners(faces, SKN_I64, first, last, remap, cursors, corners);
}
