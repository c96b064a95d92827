/* Counts of open edges, non-manifold edges and edges of opposite winding.
 * NumPy twin: open_edge_counts of skinshade/mesh/topology.py. */
#include "rows.h"

enum { OPEN = 0, NON_MANIFOLD = 1, OPPOSITE = 2 };

SKN_INLINE void sift_down(uint32_t *keys, uint32_t root, uint32_t count)
{
    for (uint64_t child = 2 * (uint64_t)root + 1; child < count; child = 2 * (uint64_t)root + 1) {
        child += child + 1 < count && keys[child] < keys[child + 1];
        if (keys[root] >= keys[child])
            return;
        const uint32_t key = keys[root];
        keys[root] = keys[child], keys[child] = key;
        root = (uint32_t)child;
    }
}

SKN_INLINE void sort_keys(uint32_t *keys, uint32_t count)
{
    if (count <= 32) {
        for (uint32_t i = 1; i < count; i++) {
            const uint32_t key = keys[i];
            uint32_t j = i;
            for (; j > 0 && keys[j - 1] > key; j--)
                keys[j] = keys[j - 1];
            keys[j] = key;
        }
        return;
    }
    for (uint32_t root = count / 2; root-- > 0;)
        sift_down(keys, root, count);
    for (uint32_t end = count - 1; end > 0; end--) {
        const uint32_t key = keys[0];
        keys[0] = keys[end], keys[end] = key;
        sift_down(keys, 0, end);
    }
}

/* Adds the faulty edges of the vertices of slabs to their higher neighbours to three counts. `keys` holds twice the
 * corners of any vertex. */
void SKN(edge_faults)(const uint32_t *starts, const uint32_t *counts, const uint32_t *corners, int64_t vertices,
                      int64_t first, int64_t last, uint32_t *keys, int64_t *faults)
{
    const int64_t end = LANES * last < vertices ? LANES * last : vertices;
    for (int64_t vertex = LANES * first; vertex < end; vertex++) {
        /* Sides of the vertex, as 2 * other end + direction. A side of a vertex with itself occurs in two corners and
         * counts once. */
        const uint32_t own = (uint32_t)vertex;
        const uint32_t *corner = corners + 2 * (LANES * (size_t)starts[vertex / LANES] + (size_t)(vertex % LANES));
        uint32_t sides = 0;
        for (uint32_t k = 0; k < counts[vertex]; k++, corner += 2 * LANES) {
            if (corner[0] >= own)
                keys[sides++] = 2 * corner[0] + (corner[0] > own);
            if (corner[1] > own)
                keys[sides++] = 2 * corner[1];
        }
        sort_keys(keys, sides);
        for (uint32_t begin = 0, next; begin < sides; begin = next) {
            uint32_t forward = 0;
            for (next = begin; next < sides && keys[next] / 2 == keys[begin] / 2; next++)
                forward += keys[next] & 1;
            faults[OPEN] += next - begin == 1;
            faults[NON_MANIFOLD] += next - begin > 2;
            faults[OPPOSITE] += next - begin == 2 && forward != 1;
        }
    }
}
