/* An order of vertices and faces that keeps neighbours near in memory, for meshes in a random order.
 *
 * Vertices are sorted by the Morton code of their cells, faces by the block of their first vertex. Both sorts are
 * stable, so that the result does not depend on the number of threads. */
#include "rows.h"

enum { AXIS_BITS = 8 }; /* 24 bits: cells of a 256th of the box hold a few dozen vertices of large meshes */

SKN_INLINE void grow_box(const void *points, int32_t kind, int64_t first, int64_t last, double *box)
{
    for (int64_t i = first; i < last; i++) {
        double p[3];
        skn_row(points, kind, i, p);
        for (int axis = 0; axis < 3; axis++) {
            box[axis] = p[axis] < box[axis] ? p[axis] : box[axis];
            box[3 + axis] = p[axis] > box[3 + axis] ? p[axis] : box[3 + axis];
        }
    }
}

/* Writes the least and greatest coordinates of points. */
void SKN(bounds)(const void *points, int32_t kind, int64_t first, int64_t last, double *box)
{
    for (int axis = 0; axis < 3; axis++)
        box[axis] = INFINITY, box[3 + axis] = -INFINITY;
    SKN_WITH_FLOATS(kind, grow_box(points, SKN_F32, first, last, box), grow_box(points, SKN_F64, first, last, box));
}

/* Spreads 8 bits to every third bit. */
SKN_INLINE uint32_t spread_bits(uint32_t x)
{
    x = (x | x << 8) & 0x0300F00Fu;
    x = (x | x << 4) & 0x030C30C3u;
    return (x | x << 2) & 0x09249249u;
}

/* Writes entries: Morton code << 32 | number of the group. */
void SKN(order_keys)(const void *points, int32_t kind, const uint32_t *firsts, int64_t first, int64_t last,
                     const double *box, uint64_t *entries)
{
    double scale[3];
    for (int axis = 0; axis < 3; axis++) {
        const double size = box[3 + axis] - box[axis];
        scale[axis] = size > 0.0 ? (double)((1 << AXIS_BITS) - 1) / size : 0.0;
    }
    for (int64_t i = first; i < last; i++) {
        double p[3];
        uint32_t code = 0;
        skn_row(points, kind, firsts ? firsts[i] : i, p);
        for (int axis = 0; axis < 3; axis++) {
            const double cell = (p[axis] - box[axis]) * scale[axis];
            /* Also false where a size below the least normal number has an infinite scale. */
            const int inside = cell >= 0.0 && cell <= (double)((1 << AXIS_BITS) - 1);
            code |= spread_bits(inside ? (uint32_t)cell : 0) << axis;
        }
        entries[i] = (uint64_t)code << 32 | (uint64_t)i;
    }
}

void SKN(radix_count)(const uint64_t *entries, int64_t first, int64_t last, int32_t shift, int32_t bits,
                      uint32_t *counts)
{
    const uint64_t mask = (1u << bits) - 1;
    for (int64_t i = first; i < last; i++)
        counts[entries[i] >> shift & mask]++;
}

void SKN(radix_scatter)(const uint64_t *entries, int64_t first, int64_t last, int32_t shift, int32_t bits,
                        uint32_t *cursors, uint64_t *sorted)
{
    const uint64_t mask = (1u << bits) - 1;
    for (int64_t i = first; i < last; i++)
        sorted[cursors[entries[i] >> shift & mask]++] = entries[i];
}

/* Writes the rank of every group. */
void SKN(order_ranks)(const uint64_t *entries, int64_t first, int64_t last, uint32_t *ranks)
{
    for (int64_t i = first; i < last; i++)
        ranks[(uint32_t)entries[i]] = (uint32_t)i;
}

/* Writes the first vertex of the group of every rank. */
void SKN(order_sources)(const uint64_t *entries, const uint32_t *firsts, int64_t first, int64_t last,
                        uint32_t *sources)
{
    for (int64_t i = first; i < last; i++)
        sources[i] = firsts ? firsts[(uint32_t)entries[i]] : (uint32_t)entries[i];
}

/* Replaces indices by their entries in a table. */
void SKN(look_up)(const uint32_t *table, int64_t first, int64_t last, uint32_t *indices)
{
    for (int64_t i = first; i < last; i++)
        indices[i] = table[indices[i]];
}

enum { AHEAD = 24 }; /* faces between a prefetch and its use */

SKN_INLINE void remap_faces(const void *faces, int32_t kind, int64_t first, int64_t last, const uint32_t *remap,
                            int32_t shift, uint32_t *remapped, uint32_t *counts)
{
    for (int64_t i = first; i < last; i++) {
        int64_t face[3];
        if (i + AHEAD < last) {
            skn_face(faces, kind, i + AHEAD, face);
            SKN_PREFETCH(remap + face[0]);
            SKN_PREFETCH(remap + face[1]);
            SKN_PREFETCH(remap + face[2]);
        }
        skn_face(faces, kind, i, face);
        uint32_t *out = remapped + 3 * i;
        out[0] = remap[face[0]], out[1] = remap[face[1]], out[2] = remap[face[2]];
        counts[out[0] >> shift]++;
    }
}

/* Writes faces with the ranks of their vertices, and counts the faces of every block of first vertices. */
void SKN(faces_remap)(const void *faces, int32_t kind, int64_t first, int64_t last, const uint32_t *remap,
                      int32_t shift, uint32_t *remapped, uint32_t *counts)
{
    if (kind == SKN_I32)
        remap_faces(faces, SKN_I32, first, last, remap, shift, remapped, counts);
    else
        remap_faces(faces, SKN_I64, first, last, remap, shift, remapped, counts);
}

/* Writes the faces in the order of the blocks of their first vertices. */
void SKN(faces_scatter)(const uint32_t *faces, int64_t first, int64_t last, int32_t shift, uint32_t *cursors,
                        uint32_t *sorted)
{
    for (int64_t i = first; i < last; i++) {
        const uint32_t *face = faces + 3 * i;
        uint32_t *out = sorted + 3 * (size_t)cursors[face[0] >> shift]++;
        out[0] = face[0], out[1] = face[1], out[2] = face[2];
    }
}
