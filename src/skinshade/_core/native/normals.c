/* Vertex normals: a weighted mean of face normals [Max1999], corrected by the osculating quadric [Cazals2005].
 * NumPy twin: skinshade/mesh/normals.py. */
#include "fans.h"

#define FIT_RIDGE 1e-3 /* as FIT_RIDGE of the twin */
#define LEAST_SQUARE 1e-30

enum { TERMS = 5, KEPT = 16 }; /* terms of a quadric; corners whose edges are kept for the second loop */

/* Weighted sums of x^i y^j with i + j = 2, 3 and 4, and of z times the terms x, y, xx, xy, yy. */
typedef struct {
    f64x4 second[3], third[4], fourth[5], right[TERMS];
} quadric;

SKN_INLINE void quadric_add(quadric *sums, vec3x4 d, vec3x4 u, vec3x4 v, vec3x4 n)
{
    const f64x4 x = lanes_dot(d, u), y = lanes_dot(d, v), z = lanes_dot(d, n);
    const f64x4 weight = lanes_of(1.0) / lanes_max(lanes_dot(d, d), lanes_of(LEAST_SQUARE));
    const f64x4 xx = x * x, xy = x * y, yy = y * y, wz = weight * z;
    const f64x4 wxx = weight * xx, wxy = weight * xy, wyy = weight * yy;
    sums->second[0] += wxx, sums->second[1] += wxy, sums->second[2] += wyy;
    sums->third[0] += wxx * x, sums->third[1] += wxx * y, sums->third[2] += wyy * x, sums->third[3] += wyy * y;
    sums->fourth[0] += wxx * xx, sums->fourth[1] += wxx * xy, sums->fourth[2] += wxx * yy;
    sums->fourth[3] += wyy * xy, sums->fourth[4] += wyy * yy;
    sums->right[0] += wz * x, sums->right[1] += wz * y;
    sums->right[2] += wz * xx, sums->right[3] += wz * xy, sums->right[4] += wz * yy;
}

/* Solves for the coefficients of x and y by LDL^T; the ridge makes the matrix positive definite. The unknowns are in
 * the order yy, xy, xx, y, x, so that those of x and y are the first of the back substitution. */
SKN_INLINE void quadric_slope(const quadric *sums, f64x4 factor, f64x4 *slope_x, f64x4 *slope_y)
{
    const f64x4 *s = sums->second, *t = sums->third, *f = sums->fourth;
    f64x4 m[TERMS][TERMS] = {
        {f[4], f[3], f[2], t[3], t[2]},
        {{0}, f[2], f[1], t[2], t[1]},
        {{0}, {0}, f[0], t[1], t[0]},
        {{0}, {0}, {0}, s[2], s[1]},
        {{0}, {0}, {0}, {0}, s[0]},
    };
    f64x4 b[TERMS] = {sums->right[4], sums->right[3], sums->right[2], sums->right[1], sums->right[0]};
    for (int row = 0; row < TERMS; row++) {
        b[row] *= factor;
        for (int column = row; column < TERMS; column++)
            m[row][column] *= factor;
        /* a2 + b2/2 + c2 is invariant to rotation. */
        m[row][row] += lanes_of(row == 1 ? 0.5 * FIT_RIDGE : FIT_RIDGE);
    }
    for (int pivot = 0; pivot < TERMS; pivot++) {
        const f64x4 inverse = lanes_of(1.0) / m[pivot][pivot];
        for (int row = pivot + 1; row < TERMS; row++) {
            const f64x4 share = m[pivot][row] * inverse;
            for (int column = row; column < TERMS; column++)
                m[row][column] -= share * m[pivot][column];
            b[row] -= share * b[pivot];
        }
    }
    *slope_x = b[4] / m[4][4];
    *slope_y = (b[3] - m[3][4] * *slope_x) / m[3][3];
}

SKN_INLINE void slab_normals(const double *points, const uint32_t *starts, const uint32_t *counts,
                             const uint32_t *corners, int64_t vertices, int64_t slab, double *normals, double *areas)
{
    const fans fan = fans_of(starts, counts, corners, vertices, slab);
    const vec3x4 p = fans_own(points, &fan);
    const f64x4 zero = lanes_of(0.0), one = lanes_of(1.0);
    vec3x4 kept[KEPT], total = {zero, zero, zero}, u, v;
    f64x4 spread = zero, area = zero, sides;
    u64x4 balance = {0, 0, 0, 0};
    for (uint32_t k = 0; k < fan.most; k++) {
        const vec3x4 a = lanes_minus(fans_next(points, &fan, k), p);
        const vec3x4 b = lanes_minus(fans_previous(points, &fan, k), p);
        const f64x4 aa = lanes_dot(a, a), bb = lanes_dot(b, b), scale = aa * bb;
        const f64x4 share = one / lanes_select(scale > zero, scale, one);
        const vec3x4 normal = lanes_cross(a, b);
        balance += fans_balance(&fan, k);
        total.x += normal.x * share, total.y += normal.y * share, total.z += normal.z * share;
        area += lanes_sqrt(lanes_dot(normal, normal));
        spread += aa + bb;
        if (k < KEPT)
            kept[k] = a;
    }
    for (int lane = 0; lane < LANES; lane++)
        sides[lane] = fan.count[lane] > 0 ? 2.0 * fan.count[lane] : 1.0;
    spread /= sides;
    const f64x4 scale = one / lanes_sqrt(lanes_select(spread > zero, spread, one));
    const vec3x4 n = lanes_unit(total);
    lanes_frame(n, &u, &v);

    quadric sums = {{zero}, {zero}, {zero}, {zero}};
    for (uint32_t k = 0; k < fan.most; k++) {
        const vec3x4 d = k < KEPT ? kept[k] : lanes_minus(fans_next(points, &fan, k), p);
        quadric_add(&sums, (vec3x4){d.x * scale, d.y * scale, d.z * scale}, u, v, n);
    }
    /* Around a closed fan the previous vertices are the next vertices again. */
    const i64x4 closed = balance == (u64x4){0, 0, 0, 0};
    if (!fans_all_closed(balance)) {
        const f64x4 open_scale = lanes_select(closed, zero, scale);
        for (uint32_t k = 0; k < fan.most; k++) {
            const vec3x4 d = lanes_minus(fans_previous(points, &fan, k), p);
            quadric_add(&sums, (vec3x4){d.x * open_scale, d.y * open_scale, d.z * open_scale}, u, v, n);
        }
    }
    f64x4 slope_x, slope_y;
    quadric_slope(&sums, lanes_select(closed, lanes_of(2.0), one), &slope_x, &slope_y);
    const vec3x4 result = lanes_unit((vec3x4){n.x - slope_x * u.x - slope_y * v.x,
                                              n.y - slope_x * u.y - slope_y * v.y,
                                              n.z - slope_x * u.z - slope_y * v.z});
    const f64x4 third = area / lanes_of(6.0);
    for (int lane = 0; lane < fans_lanes(vertices, slab); lane++) {
        double *out = normals + 3 * (LANES * slab + lane);
        out[0] = result.x[lane], out[1] = result.y[lane], out[2] = result.z[lane];
        areas[LANES * slab + lane] = third[lane];
    }
}

/* Writes unit normals of the vertices of slabs, and a third of the area of the faces around them. */
void SKN(vertex_normals)(const double *points, const uint32_t *starts, const uint32_t *counts,
                         const uint32_t *corners, int64_t vertices, int64_t first, int64_t last, double *normals,
                         double *areas)
{
    for (int64_t slab = first; slab < last; slab++)
        slab_normals(points, starts, counts, corners, vertices, slab, normals, areas);
}
