/* Values at points of faces, from those at the corners. NumPy twins: VertexTable.interpolated and VertexTable.mixed of
 * skinshade/rendering/prepare/attributes.py. */
#include "rows.h"

enum { POINTS = 64, MOST_COLUMNS = 8 };

SKN_INLINE void mix(const double *values, int64_t stride, int64_t columns, const int64_t *faces, const int64_t *face,
                    const double *weights, int64_t points, int64_t count, double *results)
{
    for (int64_t i = 0; i < points; i++) {
        const int64_t *corner = faces + 3 * face[i];
        const double *a = values + stride * corner[0], *b = values + stride * corner[1];
        const double *c = values + stride * corner[2], *w = weights + 3 * i;
        for (int64_t k = 0; k < columns; k++)
            results[count * k + i] = a[k] * w[0] + b[k] * w[1] + c[k] * w[2];
    }
}

/* Writes an array of `count` numbers for each column; `count` is the number of points of all ranges. Few columns of
 * few points are written at a time, because every column is in other cache lines. */
void SKN(interpolate)(const double *values, int64_t columns, const int64_t *faces, const int64_t *face,
                      const double *weights, int64_t count, int64_t first, int64_t last, double *results)
{
    for (int64_t i = first; i < last; i += POINTS) {
        const int64_t points = last - i < POINTS ? last - i : POINTS;
        for (int64_t k = 0; k < columns; k += MOST_COLUMNS) {
            const int64_t width = columns - k < MOST_COLUMNS ? columns - k : MOST_COLUMNS;
            mix(values + k, columns, width, faces, face + i, weights + 3 * i, points, count, results + count * k + i);
        }
    }
}
