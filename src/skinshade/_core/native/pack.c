/* Rows of vertices in another order: positions, normals and results. */
#include "rows.h"

enum { AHEAD = 16 }; /* rows between a prefetch and its use */

SKN_INLINE void pack_rows(const void *rows, int32_t kind, const uint32_t *sources, int64_t first, int64_t last,
                          int32_t unit, double *packed)
{
    const size_t size = 3 * (kind == SKN_F32 ? sizeof(float) : sizeof(double));
    for (int64_t i = first; i < last; i++) {
        if (sources && i + AHEAD < last)
            SKN_PREFETCH((const char *)rows + size * sources[i + AHEAD]);
        skn_row(rows, kind, sources ? sources[i] : i, packed + 3 * i);
        if (unit)
            skn_unit(packed + 3 * i);
    }
}

/* Writes rows as doubles in the order of `sources`, or in their own if it is NULL; at length 1 if `unit` is 1. */
void SKN(pack)(const void *rows, int32_t kind, const uint32_t *sources, int64_t first, int64_t last, int32_t unit,
               double *packed)
{
    SKN_WITH_FLOATS(kind, pack_rows(rows, SKN_F32, sources, first, last, unit, packed),
                    pack_rows(rows, SKN_F64, sources, first, last, unit, packed));
}

/* Returns how many vectors differ in length from 1 by more than rounding, or are zero. */
int64_t SKN(count_not_unit)(const double *vectors, int64_t first, int64_t last)
{
    int64_t count = 0;
    for (int64_t i = first; i < last; i++) {
        const double *v = vectors + 3 * i, square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        count += !(square > 1.0 - 1e-15 && square < 1.0 + 1e-15);
    }
    return count;
}

/* Writes the unit normals of the groups first..last - 1: the sums over their vertices that faces use. */
void SKN(sum_normals)(const void *normals, int32_t kind, const uint8_t *used, const uint32_t *remap, int64_t count,
                      int64_t first, int64_t last, double *sums)
{
    for (int64_t i = 3 * first; i < 3 * last; i++)
        sums[i] = 0.0;
    for (int64_t i = 0; i < count; i++) {
        const int64_t group = remap[i];
        if (used[i] && group >= first && group < last) {
            double normal[3];
            skn_row(normals, kind, i, normal);
            skn_unit(normal);
            for (int axis = 0; axis < 3; axis++)
                sums[3 * group + axis] += normal[axis];
        }
    }
    for (int64_t group = first; group < last; group++)
        skn_unit(sums + 3 * group);
}

SKN_INLINE void unpack_rows(const double *rows, int64_t columns, const uint32_t *remap, int64_t first, int64_t last,
                            double *result)
{
    for (int64_t i = first; i < last; i++) {
        if (i + AHEAD < last)
            SKN_PREFETCH(rows + columns * remap[i + AHEAD]);
        for (int64_t column = 0; column < columns; column++)
            result[columns * i + column] = rows[columns * remap[i] + column];
    }
}

/* Writes the rows of groups to their vertices. */
void SKN(unpack)(const double *rows, int64_t columns, const uint32_t *remap, int64_t first, int64_t last,
                 double *result)
{
    if (columns == 1)
        unpack_rows(rows, 1, remap, first, last, result);
    else
        unpack_rows(rows, columns, remap, first, last, result);
}

/* Writes tensors xx, xy, xz, yy, yz, zz of groups in the frames of the vertices' normals: k_uu, k_uv, k_vv. */
void SKN(project)(const double *world, int64_t stride, const void *normals, int32_t kind, const uint32_t *remap,
                  int64_t first, int64_t last, double *tensor)
{
    for (int64_t i = first; i < last; i++) {
        const double *t = world + stride * (remap ? remap[i] : i);
        double n[3], u[3], v[3];
        skn_row(normals, kind, i, n);
        skn_unit(n);
        skn_frame(n, u, v);
        const double su[3] = {t[0] * u[0] + t[1] * u[1] + t[2] * u[2], t[1] * u[0] + t[3] * u[1] + t[4] * u[2],
                              t[2] * u[0] + t[4] * u[1] + t[5] * u[2]};
        const double sv[3] = {t[0] * v[0] + t[1] * v[1] + t[2] * v[2], t[1] * v[0] + t[3] * v[1] + t[4] * v[2],
                              t[2] * v[0] + t[4] * v[1] + t[5] * v[2]};
        tensor[3 * i] = su[0] * u[0] + su[1] * u[1] + su[2] * u[2];
        tensor[3 * i + 1] = su[0] * v[0] + su[1] * v[1] + su[2] * v[2];
        tensor[3 * i + 2] = sv[0] * v[0] + sv[1] * v[1] + sv[2] * v[2];
    }
}
