/* A ray through the hierarchy of bvh.h.
 *
 * Triangles are intersected in the ray's own frame, where the ray is an axis [Woop2013], in doubles: an edge has
 * exactly opposite values for its two triangles, and 0 counts as a hit, so that no ray passes between them. The test
 * of boxes is in floats and allows for their rounding. The result does not depend on the tree. */
#ifndef SKINSHADE_TRACE_H
#define SKINSHADE_TRACE_H

#include "bvh.h"

enum { TRACE_EXIT, TRACE_NEAREST, TRACE_ANY };

#define TRACE_SLACK 1.0000038f /* 1 + 2^-18: the rounding of the test of boxes is below 2^-20 */
#define TRACE_FAR 1e30f        /* farther than all boxes; products with it are finite */

typedef struct {
    const bvh_node *nodes;
    const double *corners;
    const uint32_t *ids; /* triangles by place */
    uint32_t root;
} bvh;

typedef struct {
    double distance, weight[3]; /* infinite without a hit; weights of the corners, for TRACE_NEAREST */
    int64_t triangle;           /* -1 without a hit */
} trace_hit;

/* Ray with its frame: axes x, y, z in a right-handed order, of which the direction is greatest along z. */
typedef struct {
    double origin[3], shear[3];
    float inverse[3];
    int x, y, z;
} trace_ray;

SKN_INLINE trace_ray trace_ray_of(const double origin[3], const double direction[3])
{
    trace_ray ray;
    int z = fabs(direction[1]) > fabs(direction[0]) ? 1 : 0;
    z = fabs(direction[2]) > fabs(direction[z]) ? 2 : z;
    const int x = z == 2 ? 0 : z + 1, y = x == 2 ? 0 : x + 1;
    ray.x = x, ray.y = y, ray.z = z;
    ray.shear[0] = direction[x] / direction[z], ray.shear[1] = direction[y] / direction[z];
    ray.shear[2] = 1.0 / direction[z];
    for (int axis = 0; axis < 3; axis++) {
        const double length = fabs(direction[axis]) > 1e-18 ? fabs(direction[axis]) : 1e-18;
        ray.origin[axis] = origin[axis];
        ray.inverse[axis] = (float)(copysign(1.0, direction[axis]) / length);
    }
    return ray;
}

/* Intersects a leaf. Of equal distances, the hit of the least triangle counts. */
SKN_INLINE void trace_leaf(const bvh *tree, const trace_ray *ray, uint32_t leaf, int mode, trace_hit *hit)
{
    const size_t place = leaf & BVH_PLACE, count = (leaf >> BVH_COUNT_SHIFT & 3) + 1;
    const double *at = tree->corners + 9 * place;
    const f64x4 ox = lanes_of(ray->origin[ray->x]), oy = lanes_of(ray->origin[ray->y]);
    const f64x4 oz = lanes_of(ray->origin[ray->z]);
    const f64x4 sx = lanes_of(ray->shear[0]), sy = lanes_of(ray->shear[1]), sz = lanes_of(ray->shear[2]);
    const f64x4 zero = lanes_of(0.0);
    const size_t x = count * (size_t)ray->x, y = count * (size_t)ray->y, z = count * (size_t)ray->z;
    /* Lanes past the last triangle read what comes next. */
    const f64x4 az = lanes_load(at + z) - oz, bz = lanes_load(at + 3 * count + z) - oz;
    const f64x4 cz = lanes_load(at + 6 * count + z) - oz;
    const f64x4 ax = lanes_load(at + x) - ox - sx * az, ay = lanes_load(at + y) - oy - sy * az;
    const f64x4 bx = lanes_load(at + 3 * count + x) - ox - sx * bz, by = lanes_load(at + 3 * count + y) - oy - sy * bz;
    const f64x4 cx = lanes_load(at + 6 * count + x) - ox - sx * cz, cy = lanes_load(at + 6 * count + y) - oy - sy * cz;
    const f64x4 u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
    /* The frame is reflected where the direction along z is negative. */
    const int negative = ray->shear[2] < 0.0;
    const i64x4 least = (u >= zero) & (v >= zero) & (w >= zero), greatest = (u <= zero) & (v <= zero) & (w <= zero);
    const i64x4 inside = mode != TRACE_EXIT ? least | greatest : negative ? least : greatest;
    const f64x4 determinant = u + v + w;
    const f64x4 distance = (u * (sz * az) + v * (sz * bz) + w * (sz * cz)) / determinant;
    const i64x4 hits = inside & (determinant != zero) & (distance > zero) & (distance <= lanes_of(hit->distance));
    if (SKN_LIKELY(!(hits[0] | hits[1] | hits[2] | hits[3])))
        return;
    for (size_t lane = 0; lane < count; lane++) {
        if (!hits[lane])
            continue;
        if (mode == TRACE_NEAREST) {
            const int64_t triangle = tree->ids[place + lane];
            if (distance[lane] == hit->distance && hit->triangle >= 0 && triangle > hit->triangle)
                continue;
            if (distance[lane] > hit->distance)
                continue;
            hit->triangle = triangle;
            hit->weight[0] = u[lane] / determinant[lane], hit->weight[1] = v[lane] / determinant[lane];
            hit->weight[2] = w[lane] / determinant[lane];
        } else {
            hit->triangle = 0;
        }
        hit->distance = distance[lane] < hit->distance ? distance[lane] : hit->distance;
    }
}

/* Returns the bits of the children of a node that the ray enters before `limit`, and the distances to them. */
SKN_INLINE uint32_t trace_boxes(const bvh_node *node, const trace_ray *ray, double limit, float distances[BVH_WIDTH])
{
    f32x8 near = octet_of(0.0f), far = octet_of(limit < TRACE_FAR ? (float)limit : TRACE_FAR);
    for (int axis = 0; axis < 3; axis++) {
        const float inverse = ray->inverse[axis];
        const f32x8 scale = octet_of(node->scale[axis] * inverse);
        const f32x8 origin = octet_of((float)(node->origin[axis] - ray->origin[axis]) * inverse);
        const f32x8 low = octet_of_bytes(node->low[axis]), high = octet_of_bytes(node->high[axis]);
        const f32x8 one = low * scale + origin, other = high * scale + origin;
        near = octet_max(near, octet_min(one, other));
        far = octet_min(far, octet_max(one, other));
    }
    octet_store(distances, near);
    return octet_at_most(near, far * octet_of(TRACE_SLACK)) & ((1u << node->count) - 1u);
}

/* Fetches a node or a leaf into the cache. */
SKN_INLINE void trace_fetch(const bvh *tree, uint32_t reference)
{
    const char *at = (const char *)(tree->nodes + (reference & BVH_PLACE));
    size_t size = sizeof(bvh_node);
    if (reference & BVH_IS_LEAF) {
        at = (const char *)(tree->corners + 9 * (size_t)(reference & BVH_PLACE));
        size = 72 * (size_t)((reference >> BVH_COUNT_SHIFT & 3) + 1);
    }
    for (size_t line = 0; line < size; line += 64)
        SKN_PREFETCH(at + line);
}

/* Returns the hit of a ray with a distance of at most `limit`: the nearest face that the ray leaves through, the nearest
 * face, or any face. */
SKN_INLINE trace_hit trace(const bvh *tree, const double origin[3], const double direction[3], double limit, int mode)
{
    struct {
        uint32_t reference;
        float distance;
    } open[BVH_STACK];
    trace_hit hit = {.distance = limit, .weight = {0.0, 0.0, 0.0}, .triangle = -1};
    const trace_ray ray = trace_ray_of(origin, direction);
    uint32_t reference = tree->root;
    int left = 0;
    while (reference != BVH_EMPTY) {
        if (reference & BVH_IS_LEAF) {
            trace_leaf(tree, &ray, reference, mode, &hit);
            if (mode == TRACE_ANY && hit.triangle >= 0)
                break;
        } else {
            const bvh_node *node = tree->nodes + reference;
            float distances[BVH_WIDTH];
            uint32_t bits = trace_boxes(node, &ray, hit.distance, distances);
            const int bottom = left;
            while (bits) {
                const int child = __builtin_ctz(bits);
                bits &= bits - 1;
                int to = left++;
                trace_fetch(tree, node->child[child]);
                for (; to > bottom && open[to - 1].distance < distances[child]; to--)
                    open[to] = open[to - 1];
                open[to].reference = node->child[child], open[to].distance = distances[child];
            }
        }
        reference = BVH_EMPTY;
        while (left > 0) {
            left--;
            if ((double)open[left].distance <= hit.distance * (double)TRACE_SLACK) {
                reference = open[left].reference;
                break;
            }
        }
    }
    return hit;
}

#endif
