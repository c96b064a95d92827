/* Rays through a hierarchy. NumPy twin: Hierarchy of skinshade/mesh/rays.py. */
#include "packet.h"

SKN_INLINE bvh tree_of(const uint8_t *nodes, const double *corners, const uint32_t *ids, int64_t root)
{
    return (bvh){(const bvh_node *)nodes, corners, ids, (uint32_t)root};
}

/* Writes the distances to the first faces that rays leave through. */
void SKN(ray_exits)(const uint8_t *nodes, const double *corners, const uint32_t *ids, int64_t root,
                    const double *origins, const double *directions, int64_t first, int64_t last, double *distances)
{
    const bvh tree = tree_of(nodes, corners, ids, root);
    for (int64_t i = first; i < last; i++)
        distances[i] = trace(&tree, origins + 3 * i, directions + 3 * i, INFINITY, TRACE_EXIT).distance;
}

/* Writes the nearest faces, the distances to them, and the weights of their corners. */
void SKN(ray_hits)(const uint8_t *nodes, const double *corners, const uint32_t *ids, int64_t root,
                   const double *origins, const double *directions, int64_t first, int64_t last, double *distances,
                   int64_t *faces, double *weights)
{
    const bvh tree = tree_of(nodes, corners, ids, root);
    for (int64_t i = first; i < last; i++) {
        const trace_hit hit = trace(&tree, origins + 3 * i, directions + 3 * i, INFINITY, TRACE_NEAREST);
        distances[i] = hit.distance, faces[i] = hit.triangle;
        memcpy(weights + 3 * i, hit.weight, sizeof hit.weight);
    }
}

/* Writes whether rays hit a face within their limits. */
void SKN(ray_blocks)(const uint8_t *nodes, const double *corners, const uint32_t *ids, int64_t root,
                     const double *origins, const double *directions, const double *limits, int64_t first,
                     int64_t last, uint8_t *blocked)
{
    const bvh tree = tree_of(nodes, corners, ids, root);
    for (int64_t i = first; i < last; i++)
        blocked[i] = trace(&tree, origins + 3 * i, directions + 3 * i, limits[i], TRACE_ANY).triangle >= 0;
}

/* Writes the distances at which eight rays leave the body. */
SKN_INLINE void exits(const bvh *tree, const double origins[PACKET][3], const double directions[PACKET][3],
                      double distances[PACKET])
{
    packet rays;
    if (packet_of(origins, directions, &rays)) {
        packet_exits(tree, &rays);
        lanes_store(distances, rays.distance[0]);
        lanes_store(distances + PACKET_HALF, rays.distance[1]);
        return;
    }
    for (int lane = 0; lane < PACKET; lane++)
        distances[lane] = trace(tree, origins[lane], directions[lane], INFINITY, TRACE_EXIT).distance;
}

/* Writes the sum of d cos over the rays of points that leave the body, and the number of these rays. Blocks of eight
 * points take turns with the sets of rays: components along the frame of the normal, and against it. */
void SKN(ray_sums)(const uint8_t *nodes, const double *corners, const uint32_t *ids, int64_t root,
                   const double *origins, const double *normals, int64_t points, int64_t first, int64_t last,
                   const double *sets, int64_t set_count, int64_t rays, double *sums)
{
    const bvh tree = tree_of(nodes, corners, ids, root);
    for (int64_t block = first; block < last; block++) {
        const double *local = sets + 3 * rays * (block % set_count);
        const int64_t left = points - PACKET * block, count = left < PACKET ? left : PACKET;
        double origin[PACKET][3], frame[PACKET][3][3], direction[PACKET][3], distance[PACKET];
        double sum[PACKET] = {0.0}, hits[PACKET] = {0.0};
        for (int lane = 0; lane < PACKET; lane++) { /* lanes past the end repeat the last point */
            const int64_t point = PACKET * block + (lane < count ? lane : count - 1);
            memcpy(origin[lane], origins + 3 * point, sizeof origin[lane]);
            memcpy(frame[lane][2], normals + 3 * point, sizeof frame[lane][2]);
            skn_frame(frame[lane][2], frame[lane][0], frame[lane][1]);
        }
        for (int64_t ray = 0; ray < rays; ray++, local += 3) {
            for (int lane = 0; lane < PACKET; lane++)
                for (int axis = 0; axis < 3; axis++)
                    direction[lane][axis] = local[0] * frame[lane][0][axis] + local[1] * frame[lane][1][axis]
                                            - local[2] * frame[lane][2][axis];
            exits(&tree, origin, direction, distance);
            for (int lane = 0; lane < PACKET; lane++)
                if (distance[lane] < INFINITY)
                    sum[lane] += distance[lane] * local[2], hits[lane] += 1.0;
        }
        for (int lane = 0; lane < count; lane++) {
            sums[2 * (PACKET * block + lane)] = sum[lane];
            sums[2 * (PACKET * block + lane) + 1] = hits[lane];
        }
    }
}
