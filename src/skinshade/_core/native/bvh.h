/* Hierarchy of boxes over triangles. Coordinates lie in -1..1.
 *
 * A reference is a node, or the triangles of a leaf. Leaves lie in one table of corners: a leaf of k triangles from
 * place s on has 9 k doubles from 9 s on, the k values of x of the first corners first, then y, z, the second corners
 * and the third ones. */
#ifndef SKINSHADE_BVH_H
#define SKINSHADE_BVH_H

#include "lanes_f32.h"

enum { BVH_WIDTH = 8, BVH_LEAF = 4, BVH_STACK = 640 }; /* nodes that are open at most: 7 in each of 80 levels */

#define BVH_IS_LEAF 0x80000000u
#define BVH_COUNT_SHIFT 29 /* bits 29 and 30 of a leaf: triangles - 1 */
#define BVH_PLACE 0x1FFFFFFFu
#define BVH_EMPTY 0x7FFFFFFFu /* no triangle */

/* Node: boxes of up to eight children, with coordinates origin + scale * byte, rounded outwards. */
typedef struct {
    float origin[3], scale[3];
    uint32_t child[BVH_WIDTH];
    uint8_t low[3][BVH_WIDTH], high[3][BVH_WIDTH];
    uint32_t count, filler[5];
} bvh_node;

#endif
