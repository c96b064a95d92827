/* The shape operator: a bounded fit of the change of normals along the edges of every vertex.
 * NumPy twin: skinshade/mesh/shape_operator.py. */
#include "fans.h"

#define FIT_RIDGE 1e-9                 /* as FIT_RIDGE of the twin */
#define LEAST_SQUARE (8.0 * SKN_TINY) /* as LEAST_SQUARE of the twin */

/* Moments of the edges of four vertices in their tangent planes: of steps, and of steps with turns of the normal.
 * greatest: greatest 1/edge^2; steepest: greatest square of turn per length. */
typedef struct {
    f64x4 xx, xy, yy, a, b, c;
    f64x4 greatest, steepest;
} moments;

SKN_INLINE void moments_add(moments *sums, vec3x4 step, vec3x4 turn, vec3x4 u, vec3x4 v)
{
    const f64x4 square = lanes_dot(step, step);
    const f64x4 weight = lanes_of(1.0) / lanes_max(square, lanes_of(LEAST_SQUARE));
    const f64x4 x = lanes_dot(step, u), y = lanes_dot(step, v);
    const f64x4 p = lanes_dot(turn, u), q = lanes_dot(turn, v);
    const f64x4 wx = weight * x, wy = weight * y;
    sums->xx += wx * x;
    sums->xy += wx * y;
    sums->yy += wy * y;
    sums->a += wx * p;
    sums->b += wx * q + wy * p;
    sums->c += wy * q;
    /* Edges without length do not count. */
    const f64x4 counted = lanes_select(square > lanes_of(0.0), weight, lanes_of(0.0));
    sums->greatest = lanes_max(counted, sums->greatest);
    sums->steepest = lanes_max(lanes_dot(turn, turn) * counted, sums->steepest);
}

/* Solves [[xx, xy, 0], [xy, xx+yy, xy], [0, xy, yy]] (k_uu, k_uv, k_vv) = (a, b, c) by Cramer's rule. */
SKN_INLINE vec3x4 moments_solve(const moments *sums)
{
    const f64x4 total = sums->xx + sums->yy, xy = sums->xy, a = sums->a, b = sums->b, c = sums->c;
    const f64x4 ridge = lanes_of(FIT_RIDGE) * total + lanes_of(SKN_TINY);
    const f64x4 xx = sums->xx + ridge, yy = sums->yy + ridge, middle = total + ridge;
    f64x4 determinant = xx * middle * yy - xy * xy * (xx + yy);
    /* The curvature of a vertex without edges is 0. */
    determinant = lanes_select(determinant > lanes_of(0.0), determinant, lanes_of(INFINITY));
    return (vec3x4){(a * (middle * yy - xy * xy) - xy * (b * yy - xy * c)) / determinant,
                    (xx * (b * yy - xy * c) - xy * a * yy) / determinant,
                    (c * (xx * middle - xy * xy) - xy * (xx * b - xy * a)) / determinant};
}

/* Scales tensors down to the greatest principal curvature that the edges resolve; returns which exceeded it.
 * bounds: the greatest ratio to the steepest turn, the greatest product with the shortest edge, and the length as
 * which shorter edges count. */
SKN_INLINE i64x4 moments_bound(const moments *sums, const double bounds[3], vec3x4 *k)
{
    const f64x4 half = lanes_of(0.5), one = lanes_of(1.0);
    const f64x4 steepest = lanes_sqrt(sums->steepest);
    const f64x4 shortest = one / lanes_sqrt(lanes_max(sums->greatest, lanes_of(LEAST_SQUARE)));
    const f64x4 limit = lanes_min(lanes_of(bounds[0]) * steepest,
                                  lanes_of(bounds[1]) / lanes_max(shortest, lanes_of(bounds[2])));
    const f64x4 difference = half * (k->x - k->z);
    const f64x4 greatest = lanes_absolute(half * (k->x + k->z)) + lanes_sqrt(difference * difference + k->y * k->y);
    const i64x4 exceeds = greatest > limit;
    if (exceeds[0] | exceeds[1] | exceeds[2] | exceeds[3]) {
        const f64x4 scale = lanes_select(exceeds, limit / lanes_select(exceeds, greatest, one), one);
        k->x *= scale, k->y *= scale, k->z *= scale;
    }
    return exceeds;
}

SKN_INLINE void slab_fit(const double *points, const double *normals, const uint32_t *starts, const uint32_t *counts,
                         const uint32_t *corners, int64_t vertices, int64_t slab, const double bounds[3],
                         int with_areas, int with_tensor, double *fitted, double *areas, uint8_t *bounded)
{
    const fans fan = fans_of(starts, counts, corners, vertices, slab);
    const vec3x4 p = fans_own(points, &fan), n = fans_own(normals, &fan);
    const f64x4 zero = lanes_of(0.0);
    vec3x4 u, v;
    lanes_frame(n, &u, &v);

    moments sums = {zero, zero, zero, zero, zero, zero, zero, zero};
    f64x4 area = zero;
    u64x4 balance = {0, 0, 0, 0};
    for (uint32_t k = 0; k < fan.most; k++) {
        const vec3x4 step = lanes_minus(fans_next(points, &fan, k), p);
        const vec3x4 turn = lanes_minus(fans_next(normals, &fan, k), n);
        balance += fans_balance(&fan, k);
        fans_prefetch(points, &fan, k);
        fans_prefetch(normals, &fan, k);
        moments_add(&sums, step, turn, u, v);
        if (with_areas) {
            const vec3x4 normal = lanes_cross(step, lanes_minus(fans_previous(points, &fan, k), p));
            area += lanes_sqrt(lanes_dot(normal, normal));
        }
    }
    /* Around a closed fan the previous vertices are the next vertices again. Elsewhere both count, so that an edge of
     * one face has half the weight of an edge of two. */
    if (!fans_all_closed(balance)) {
        const moments closed = sums;
        for (uint32_t k = 0; k < fan.most; k++) {
            const vec3x4 step = lanes_minus(fans_previous(points, &fan, k), p);
            const vec3x4 turn = lanes_minus(fans_previous(normals, &fan, k), n);
            moments_add(&sums, step, turn, u, v);
        }
        const i64x4 is_closed = balance == (u64x4){0, 0, 0, 0};
        sums.xx = lanes_select(is_closed, closed.xx, sums.xx);
        sums.xy = lanes_select(is_closed, closed.xy, sums.xy);
        sums.yy = lanes_select(is_closed, closed.yy, sums.yy);
        sums.a = lanes_select(is_closed, closed.a, sums.a);
        sums.b = lanes_select(is_closed, closed.b, sums.b);
        sums.c = lanes_select(is_closed, closed.c, sums.c);
    }
    vec3x4 tensor = moments_solve(&sums);
    const i64x4 exceeds = moments_bound(&sums, bounds, &tensor);
    const f64x4 mean = lanes_of(0.5) * (tensor.x + tensor.z), third = area / lanes_of(6.0);
    for (int lane = 0; lane < fans_lanes(vertices, slab); lane++) {
        const int64_t at = LANES * slab + lane;
        if (with_tensor) {
            fitted[3 * at] = tensor.x[lane], fitted[3 * at + 1] = tensor.y[lane], fitted[3 * at + 2] = tensor.z[lane];
            bounded[at] = exceeds[lane] != 0;
        } else {
            fitted[at] = mean[lane];
        }
        if (with_areas)
            areas[at] = third[lane];
    }
}

/* Writes of the vertices of slabs: unless `areas` is NULL, a third of the area of the faces around them; if `bounded`
 * is NULL, the mean curvature; else k_uu, k_uv, k_vv in the frame of the normal, and whether a bound reduced them. */
void SKN(fit)(const double *points, const double *normals, const uint32_t *starts, const uint32_t *counts,
              const uint32_t *corners, int64_t vertices, int64_t first, int64_t last, const double *bounds,
              double *fitted, double *areas, uint8_t *bounded)
{
    for (int64_t slab = first; slab < last; slab++) {
        if (areas && !bounded)
            slab_fit(points, normals, starts, counts, corners, vertices, slab, bounds, 1, 0, fitted, areas, NULL);
        else if (areas)
            slab_fit(points, normals, starts, counts, corners, vertices, slab, bounds, 1, 1, fitted, areas, bounded);
        else
            slab_fit(points, normals, starts, counts, corners, vertices, slab, bounds, 0, bounded != NULL, fitted, NULL,
                     bounded);
    }
}
