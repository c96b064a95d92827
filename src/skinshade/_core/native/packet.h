/* Eight rays at once through the hierarchy of bvh.h: exits of rays that start near each other in similar directions.
 *
 * Every lane has the operations of trace.h, so that the distances have the same bytes as those of single rays. */
#ifndef SKINSHADE_PACKET_H
#define SKINSHADE_PACKET_H

#include "trace.h"

enum { PACKET = 8, PACKET_HALF = 4 };

/* Rays that have the same axes x, y, z. Positions in floats are relative to the first origin. */
typedef struct {
    f64x4 x[2], y[2], z[2], shear_x[2], shear_y[2], shear_z[2];
    f64x4 distance[2];
    i64x4 negative[2];
    f32x8 origin[3], inverse[3];
    double middle[3];
    float margin[3]; /* the rounding of `origin` */
    int axes[3];
} packet;

/* Arranges rays as a packet, and returns whether they have the same axes. */
SKN_INLINE int packet_of(const double origins[PACKET][3], const double directions[PACKET][3], packet *rays)
{
    float largest[3] = {0.0f, 0.0f, 0.0f};
    for (int lane = 0; lane < PACKET; lane++) {
        const trace_ray ray = trace_ray_of(origins[lane], directions[lane]);
        const int half = lane / PACKET_HALF, part = lane % PACKET_HALF;
        if (lane == 0) {
            rays->axes[0] = ray.x, rays->axes[1] = ray.y, rays->axes[2] = ray.z;
            memcpy(rays->middle, ray.origin, sizeof rays->middle);
        } else if (ray.z != rays->axes[2]) {
            return 0;
        }
        rays->x[half][part] = ray.origin[ray.x], rays->y[half][part] = ray.origin[ray.y];
        rays->z[half][part] = ray.origin[ray.z];
        rays->shear_x[half][part] = ray.shear[0], rays->shear_y[half][part] = ray.shear[1];
        rays->shear_z[half][part] = ray.shear[2];
        rays->negative[half][part] = ray.shear[2] < 0.0 ? -1 : 0;
        for (int axis = 0; axis < 3; axis++) {
            const float moved = (float)(ray.origin[axis] - rays->middle[axis]);
            rays->origin[axis][lane] = moved, rays->inverse[axis][lane] = ray.inverse[axis];
            largest[axis] = fabsf(moved) > largest[axis] ? fabsf(moved) : largest[axis];
        }
    }
    for (int axis = 0; axis < 3; axis++)
        rays->margin[axis] = largest[axis] * 4.8e-7f; /* 2^-21 */
    rays->distance[0] = rays->distance[1] = lanes_of(INFINITY);
    return 1;
}

/* Intersects a leaf, for the rays of the halves that `bits` has. */
SKN_INLINE void packet_leaf(const bvh *tree, packet *rays, uint32_t leaf, uint32_t bits)
{
    const size_t count = (leaf >> BVH_COUNT_SHIFT & 3) + 1;
    const double *at = tree->corners + 9 * (size_t)(leaf & BVH_PLACE);
    const double *x = at + count * (size_t)rays->axes[0], *y = at + count * (size_t)rays->axes[1];
    const double *z = at + count * (size_t)rays->axes[2];
    const f64x4 zero = lanes_of(0.0);
    for (int half = 0; half < 2; half++) {
        if (!(bits >> (PACKET_HALF * half) & 15))
            continue;
        const f64x4 ox = rays->x[half], oy = rays->y[half], oz = rays->z[half];
        const f64x4 sx = rays->shear_x[half], sy = rays->shear_y[half], sz = rays->shear_z[half];
        for (size_t i = 0; i < count; i++) {
            const size_t one = 3 * count + i, two = 6 * count + i;
            const f64x4 az = lanes_of(z[i]) - oz, bz = lanes_of(z[one]) - oz, cz = lanes_of(z[two]) - oz;
            const f64x4 ax = lanes_of(x[i]) - ox - sx * az, ay = lanes_of(y[i]) - oy - sy * az;
            const f64x4 bx = lanes_of(x[one]) - ox - sx * bz, by = lanes_of(y[one]) - oy - sy * bz;
            const f64x4 cx = lanes_of(x[two]) - ox - sx * cz, cy = lanes_of(y[two]) - oy - sy * cz;
            const f64x4 u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
            const i64x4 least = (u >= zero) & (v >= zero) & (w >= zero);
            const i64x4 greatest = (u <= zero) & (v <= zero) & (w <= zero);
            const i64x4 inside = (least & rays->negative[half]) | (greatest & ~rays->negative[half]);
            if (SKN_LIKELY(!(inside[0] | inside[1] | inside[2] | inside[3])))
                continue;
            const f64x4 determinant = u + v + w;
            const f64x4 distance = (u * (sz * az) + v * (sz * bz) + w * (sz * cz)) / determinant;
            const i64x4 hits = inside & (determinant != zero) & (distance > zero) & (distance < rays->distance[half]);
            rays->distance[half] = lanes_select(hits, distance, rays->distance[half]);
        }
    }
}

/* Returns the distances of the rays as floats. */
SKN_INLINE f32x8 packet_limits(const packet *rays)
{
    f32x8 limits;
    for (int lane = 0; lane < PACKET; lane++) {
        const double distance = rays->distance[lane / PACKET_HALF][lane % PACKET_HALF];
        limits[lane] = distance < TRACE_FAR ? (float)distance : TRACE_FAR;
    }
    return limits;
}

/* Writes the distances at which the rays first leave the body to rays->distance. */
SKN_INLINE void packet_exits(const bvh *tree, packet *rays)
{
    struct {
        f32x8 near;
        uint32_t reference, bits;
        float distance;
    } open[BVH_STACK];
    f32x8 limits = packet_limits(rays);
    uint32_t reference = tree->root, bits = 255;
    int left = 0;
    while (reference != BVH_EMPTY) {
        if (reference & BVH_IS_LEAF) {
            packet_leaf(tree, rays, reference, bits);
            limits = packet_limits(rays);
        } else {
            const bvh_node *node = tree->nodes + reference;
            float low[3][BVH_WIDTH], high[3][BVH_WIDTH];
            for (int axis = 0; axis < 3; axis++) {
                const f32x8 scale = octet_of(node->scale[axis]), margin = octet_of(rays->margin[axis]);
                const f32x8 origin = octet_of((float)(node->origin[axis] - rays->middle[axis]));
                octet_store(low[axis], octet_of_bytes(node->low[axis]) * scale + (origin - margin));
                octet_store(high[axis], octet_of_bytes(node->high[axis]) * scale + (origin + margin));
            }
            const int bottom = left;
            for (uint32_t child = 0; child < node->count; child++) {
                f32x8 near = octet_of(0.0f), far = limits;
                for (int axis = 0; axis < 3; axis++) {
                    const f32x8 one = (octet_of(low[axis][child]) - rays->origin[axis]) * rays->inverse[axis];
                    const f32x8 other = (octet_of(high[axis][child]) - rays->origin[axis]) * rays->inverse[axis];
                    near = octet_max(near, octet_min(one, other));
                    far = octet_min(far, octet_max(one, other));
                }
                const uint32_t entered = octet_at_most(near, far * octet_of(TRACE_SLACK));
                if (!entered)
                    continue;
                const float distance = near[__builtin_ctz(entered)];
                int to = left++;
                trace_fetch(tree, node->child[child]);
                for (; to > bottom && open[to - 1].distance < distance; to--)
                    open[to] = open[to - 1];
                open[to].reference = node->child[child], open[to].bits = entered;
                open[to].near = near, open[to].distance = distance;
            }
        }
        reference = BVH_EMPTY;
        while (left > 0) {
            left--;
            bits = open[left].bits & octet_at_most(open[left].near, limits * octet_of(TRACE_SLACK));
            if (bits) {
                reference = open[left].reference;
                break;
            }
        }
    }
}

#endif
