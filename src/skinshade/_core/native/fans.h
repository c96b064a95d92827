/* Fans: the corners of the faces around four successive vertices, from the table of corners.c. */
#ifndef SKINSHADE_FANS_H
#define SKINSHADE_FANS_H

#include "lanes.h"

/* Four vertices and their corners.
 * row: of each corner of each vertex the next and the previous vertex of the face; corners past the count of a vertex
 * are the vertex itself, so that their edges are 0. count: corners of each vertex. most: the greatest count. */
typedef struct {
    const uint32_t *row;
    uint32_t own[LANES], count[LANES], least, most;
} fans;

SKN_INLINE fans fans_of(const uint32_t *starts, const uint32_t *counts, const uint32_t *corners, int64_t vertices,
                        int64_t slab)
{
    fans fan = {.row = corners + 2 * LANES * (size_t)starts[slab], .least = UINT32_MAX, .most = 0};
    for (int lane = 0; lane < LANES; lane++) {
        /* Lanes past the end are the last vertex without corners. */
        const int64_t vertex = LANES * slab + lane;
        fan.own[lane] = (uint32_t)(vertex < vertices ? vertex : vertices - 1);
        fan.count[lane] = vertex < vertices ? counts[vertex] : 0;
        fan.least = fan.count[lane] < fan.least ? fan.count[lane] : fan.least;
        fan.most = fan.count[lane] > fan.most ? fan.count[lane] : fan.most;
    }
    return fan;
}

/* Numbers of vertices that exist. */
SKN_INLINE int fans_lanes(int64_t vertices, int64_t slab)
{
    return vertices - LANES * slab < LANES ? (int)(vertices - LANES * slab) : LANES;
}

SKN_INLINE vec3x4 fans_own(const double *rows, const fans *fan)
{
    return lanes_rows(rows, fan->own[0], fan->own[1], fan->own[2], fan->own[3]);
}

SKN_INLINE vec3x4 fans_next(const double *rows, const fans *fan, uint32_t k)
{
    const uint32_t *at = fan->row + 2 * LANES * (size_t)k;
    return lanes_rows(rows, at[0], at[2], at[4], at[6]);
}

SKN_INLINE vec3x4 fans_previous(const double *rows, const fans *fan, uint32_t k)
{
    const uint32_t *at = fan->row + 2 * LANES * (size_t)k;
    return lanes_rows(rows, at[1], at[3], at[5], at[7]);
}

enum { ROWS_AHEAD = 8 }; /* rows between a prefetch and its use; the table has as many more rows */

/* Fetches the rows of the next vertices of a later corner into the cache. */
SKN_INLINE void fans_prefetch(const double *rows, const fans *fan, uint32_t k)
{
    const uint32_t *at = fan->row + 2 * LANES * ((size_t)k + ROWS_AHEAD);
    for (int lane = 0; lane < LANES; lane++)
        SKN_PREFETCH(rows + 3 * (size_t)at[2 * lane]);
}

/* Hashes of the low halves of numbers. The second product mixes the bits of the first: sums of plain products, and of
 * squares of indices, are often equal for different neighbours in a grid. */
SKN_INLINE u64x4 fans_hash(u64x4 index)
{
    const uint64_t key = 0x9E3779B1u;
    const u64x4 product = lanes_product(index, (u64x4){key, key, key, key});
    const u64x4 mixed = product ^ (product >> 25);
    return product + lanes_product(mixed, mixed);
}

/* Difference of hashes of the next and previous vertices. Its sum over the corners of a vertex is 0 if the previous
 * vertices are the next ones in another order: if every edge has two faces of equal winding. */
SKN_INLINE u64x4 fans_balance(const fans *fan, uint32_t k)
{
    u64x4 pairs;
    memcpy(&pairs, fan->row + 2 * LANES * (size_t)k, sizeof pairs);
    return fans_hash(pairs) - fans_hash(pairs >> 32);
}

/* Returns whether all sums of fans_balance are 0. */
SKN_INLINE int fans_all_closed(u64x4 balance)
{
    return (balance[0] | balance[1] | balance[2] | balance[3]) == 0;
}

#endif
