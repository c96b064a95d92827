/* Smoothing: the mean over the faces around a vertex of their means, weighted by the areas of the corners.
 * NumPy twin: _smoothed of skinshade/mesh/curvature.py. */
#include "fans.h"

enum { WORLD = 8, AREA = 6 }; /* a weighted tensor: six numbers, the area and a filler */

/* Writes area * value and area of vertices. */
void SKN(weigh_mean)(const double *values, const double *areas, int64_t first, int64_t last, double *weighted)
{
    for (int64_t i = first; i < last; i++) {
        weighted[2 * i] = areas[i] * values[i];
        weighted[2 * i + 1] = areas[i];
    }
}

/* Writes area * tensor (xx, xy, xz, yy, yz, zz) and area of vertices. */
void SKN(weigh_world)(const double *tensor, const double *areas, const double *normals, int64_t first, int64_t last,
                      double *weighted)
{
    for (int64_t i = first; i < last; i++) {
        const double *k = tensor + 3 * i, area = areas[i];
        double u[3], v[3], su[3], sv[3], *out = weighted + WORLD * i;
        skn_frame(normals + 3 * i, u, v);
        for (int axis = 0; axis < 3; axis++) {
            su[axis] = k[0] * u[axis] + k[1] * v[axis];
            sv[axis] = k[1] * u[axis] + k[2] * v[axis];
        }
        out[0] = area * (su[0] * u[0] + sv[0] * v[0]);
        out[1] = area * (su[0] * u[1] + sv[0] * v[1]);
        out[2] = area * (su[0] * u[2] + sv[0] * v[2]);
        out[3] = area * (su[1] * u[1] + sv[1] * v[1]);
        out[4] = area * (su[1] * u[2] + sv[1] * v[2]);
        out[5] = area * (su[2] * u[2] + sv[2] * v[2]);
        out[AREA] = area;
        out[7] = 0.0;
    }
}

SKN_INLINE void pairs(const double *weighted, size_t a, size_t b, size_t c, size_t d, f64x4 *value, f64x4 *area)
{
    lanes_pair(weighted + 2 * a, weighted + 2 * b, weighted + 2 * c, weighted + 2 * d, value, area);
}

/* Writes area * smoothed value and area of the vertices of slabs, or the smoothed values alone. */
void SKN(smooth_mean)(const double *weighted, const uint32_t *starts, const uint32_t *counts, const uint32_t *corners,
                      int64_t vertices, int64_t first, int64_t last, int32_t values_only, double *smoothed)
{
    for (int64_t slab = first; slab < last; slab++) {
        const fans fan = fans_of(starts, counts, corners, vertices, slab);
        f64x4 value, area, one, one_area, other, other_area, sum = lanes_of(0.0), uses;
        pairs(weighted, fan.own[0], fan.own[1], fan.own[2], fan.own[3], &value, &area);
        for (uint32_t k = 0; k < fan.most; k++) {
            const uint32_t *at = fan.row + 2 * LANES * (size_t)k;
            pairs(weighted, at[0], at[2], at[4], at[6], &one, &one_area);
            pairs(weighted, at[1], at[3], at[5], at[7], &other, &other_area);
            f64x4 mean = (value + one + other) / lanes_max(area + one_area + other_area, lanes_of(SKN_TINY));
            if (k >= fan.least)
                for (int lane = 0; lane < LANES; lane++)
                    mean[lane] = k < fan.count[lane] ? mean[lane] : 0.0;
            sum += mean;
        }
        for (int lane = 0; lane < LANES; lane++)
            uses[lane] = fan.count[lane] > 0 ? fan.count[lane] : 1.0;
        sum /= uses;
        const f64x4 product = sum * area;
        for (int lane = 0; lane < fans_lanes(vertices, slab); lane++) {
            const int64_t vertex = LANES * slab + lane;
            if (values_only)
                smoothed[vertex] = sum[lane];
            else
                smoothed[2 * vertex] = product[lane], smoothed[2 * vertex + 1] = area[lane];
        }
    }
}

/* Writes area * smoothed tensor and area of the vertices of slabs, or the smoothed tensors alone in the same places. */
void SKN(smooth_world)(const double *weighted, const uint32_t *starts, const uint32_t *counts,
                       const uint32_t *corners, int64_t vertices, int64_t first, int64_t last, int32_t values_only,
                       double *smoothed)
{
    for (int64_t slab = first; slab < last; slab++) {
        for (int lane = 0; lane < fans_lanes(vertices, slab); lane++) {
            const int64_t vertex = LANES * slab + lane;
            const uint32_t *corner = corners + 2 * (LANES * (size_t)starts[slab] + (size_t)lane);
            const double *own = weighted + WORLD * vertex;
            const f64x4 own_low = lanes_load(own), own_high = lanes_load(own + LANES);
            f64x4 sum_low = lanes_of(0.0), sum_high = lanes_of(0.0);
            for (uint32_t k = 0; k < counts[vertex]; k++, corner += 2 * LANES) {
                const double *one = weighted + WORLD * (size_t)corner[0];
                const double *other = weighted + WORLD * (size_t)corner[1];
                const f64x4 low = own_low + lanes_load(one) + lanes_load(other);
                const f64x4 high = own_high + lanes_load(one + LANES) + lanes_load(other + LANES);
                const f64x4 total = lanes_of(high[AREA - LANES] > SKN_TINY ? high[AREA - LANES] : SKN_TINY);
                sum_low += low / total, sum_high += high / total;
            }
            const f64x4 uses = lanes_of(counts[vertex] > 0 ? counts[vertex] : 1.0);
            const f64x4 scale = lanes_of(values_only ? 1.0 : own[AREA]);
            double *out = smoothed + WORLD * vertex;
            lanes_store(out, sum_low / uses * scale);
            lanes_store(out + LANES, sum_high / uses * scale);
            out[AREA] = own[AREA];
        }
    }
}
