/* Builds the hierarchy of bvh.h: boxes of triangles, subtrees over cells of a grid, and a tree over the subtrees.
 *
 * A node gets its children by repeated splits of the child of the greatest area, where the surface area heuristic in
 * bins is least [Wald2007]. A box is eight floats: low x, y, z and 0, then -high x, y, z and 0, so that the union of
 * boxes is the minimum. NumPy twin: Hierarchy of skinshade/mesh/rays.py, which is another tree. */
#include "bvh.h"

#include <float.h>

enum {
    BOX = 8,         /* floats of a box */
    CELL_BITS = 5,   /* bits of the cell on every axis */
    BINS = 16,       /* bins of the heuristic */
    MOST_DEPTH = 40, /* depth from which nodes are split by number */
    MOST_OPEN = BVH_STACK
};

typedef struct {
    f32x8 box;
    int64_t first, count;
} span;

SKN_INLINE float rounded_down(double value)
{
    const float nearest = (float)value;
    return (double)nearest <= value ? nearest : nearest - (fabsf(nearest) * FLT_EPSILON + FLT_MIN);
}

SKN_INLINE void boxes_of(const double *points, const void *faces, int32_t kind, int64_t first, int64_t last,
                         float *boxes, uint64_t *entries)
{
    for (int64_t i = first; i < last; i++) {
        int64_t face[3];
        uint32_t cell = 0;
        float *box = boxes + BOX * i;
        skn_face(faces, kind, i, face);
        for (int axis = 0; axis < 3; axis++) {
            const double a = points[3 * face[0] + axis], b = points[3 * face[1] + axis];
            const double c = points[3 * face[2] + axis];
            const double low = a < b ? (a < c ? a : c) : (b < c ? b : c);
            const double high = a > b ? (a > c ? a : c) : (b > c ? b : c);
            box[axis] = rounded_down(low), box[4 + axis] = rounded_down(-high);
            const double place = (0.25 * (low + high) + 0.5) * (1 << CELL_BITS);
            const uint32_t most = (1 << CELL_BITS) - 1;
            const uint32_t at = place > 0.0 ? (place < most ? (uint32_t)place : most) : 0;
            for (int bit = 0; bit < CELL_BITS; bit++)
                cell |= (at >> bit & 1) << (3 * bit + axis);
        }
        box[3] = box[7] = 0.0f;
        entries[i] = (uint64_t)cell << 32 | (uint64_t)i;
    }
}

/* Writes the boxes of triangles, and entries: the cell of the centre along the Morton curve, and the triangle. */
void SKN(bvh_boxes)(const double *points, const void *faces, int32_t kind, int64_t first, int64_t last, float *boxes,
                    uint64_t *entries)
{
    if (kind == SKN_I32)
        boxes_of(points, faces, SKN_I32, first, last, boxes, entries);
    else
        boxes_of(points, faces, SKN_I64, first, last, boxes, entries);
}

SKN_INLINE float half_area(f32x8 box)
{
    const float x = -box[4] - box[0], y = -box[5] - box[1], z = -box[6] - box[2];
    return x * y + y * z + z * x;
}

SKN_INLINE int bin_of(f32x8 box, int axis, float low, float scale)
{
    const int bin = (int)((box[axis] - box[4 + axis] - low) * scale);
    return bin < BINS ? bin : BINS - 1;
}

/* Splits a span in two. */
static void split(const float *boxes, uint32_t *order, int depth, span *one, span *other)
{
    const int64_t first = one->first, count = one->count, last = first + count;
    const f32x8 empty = octet_of(FLT_MAX);
    f32x8 centres = empty; /* least, and -greatest, of low + high */
    for (int64_t i = first; i < last; i++) {
        const f32x8 box = octet_load(boxes + BOX * (size_t)order[i]);
        centres = octet_min(centres, box - octet_swap(box));
    }
    f32x8 bin_box[3][BINS];
    int64_t bin_count[3][BINS] = {{0}};
    float scale[3];
    for (int axis = 0; axis < 3; axis++) {
        const float extent = -centres[4 + axis] - centres[axis];
        scale[axis] = extent > 1e-30f && depth < MOST_DEPTH ? (float)BINS / extent : 0.0f;
        for (int bin = 0; bin < BINS; bin++)
            bin_box[axis][bin] = empty;
    }
    for (int64_t i = first; i < last; i++) {
        const f32x8 box = octet_load(boxes + BOX * (size_t)order[i]);
        for (int axis = 0; axis < 3; axis++) {
            const int bin = bin_of(box, axis, centres[axis], scale[axis]);
            bin_box[axis][bin] = octet_min(bin_box[axis][bin], box);
            bin_count[axis][bin]++;
        }
    }
    float least = FLT_MAX;
    int best_axis = -1, best_bin = 0;
    for (int axis = 0; axis < 3; axis++) {
        float right[BINS];
        f32x8 box = empty;
        int64_t number = 0;
        for (int bin = BINS - 1; bin > 0; bin--) {
            box = octet_min(box, bin_box[axis][bin]), number += bin_count[axis][bin];
            right[bin] = number > 0 ? half_area(box) * (float)number : 0.0f;
        }
        box = empty, number = 0;
        for (int bin = 0; bin + 1 < BINS; bin++) {
            box = octet_min(box, bin_box[axis][bin]), number += bin_count[axis][bin];
            if (number == 0 || number == count)
                continue;
            const float cost = half_area(box) * (float)number + right[bin + 1];
            if (cost < least)
                least = cost, best_axis = axis, best_bin = bin;
        }
    }
    int64_t middle = first;
    one->box = other->box = empty;
    if (best_axis < 0) {
        middle = first + count / 2; /* all centres are equal */
    } else {
        for (int64_t end = last; middle < end;) {
            const f32x8 box = octet_load(boxes + BOX * (size_t)order[middle]);
            if (bin_of(box, best_axis, centres[best_axis], scale[best_axis]) <= best_bin) {
                middle++;
            } else {
                const uint32_t moved = order[--end];
                order[end] = order[middle], order[middle] = moved;
            }
        }
    }
    for (int64_t i = first; i < last; i++) {
        span *side = i < middle ? one : other;
        side->box = octet_min(side->box, octet_load(boxes + BOX * (size_t)order[i]));
    }
    one->count = middle - first;
    other->first = middle, other->count = last - middle;
}

/* Writes the boxes of children to a node. */
static void pack(bvh_node *node, const span *children, int count)
{
    f32x8 box = children[0].box;
    for (int child = 1; child < count; child++)
        box = octet_min(box, children[child].box);
    memset(node, 0, sizeof *node);
    node->count = (uint32_t)count;
    for (int axis = 0; axis < 3; axis++) {
        const float low = box[axis], high = -box[4 + axis];
        const float greatest = fabsf(low) > fabsf(high) ? fabsf(low) : fabsf(high);
        /* A step is at least what floats resolve; one and a half of them stay free on both sides. */
        float step = (high - low) / 250.0f;
        step = step > greatest * FLT_EPSILON ? step : greatest * FLT_EPSILON;
        step = step > 1e-18f ? step : 1e-18f;
        node->origin[axis] = low - 1.5f * step, node->scale[axis] = step;
        for (int child = 0; child < count; child++) {
            const double origin = node->origin[axis], margin = 1.0 / 32.0;
            const double from = floor((children[child].box[axis] - origin) / step - margin);
            const double to = ceil((-children[child].box[4 + axis] - origin) / step + margin);
            node->low[axis][child] = (uint8_t)(from > 0.0 ? from : 0.0);
            node->high[axis][child] = (uint8_t)(to < 255.0 ? to : 255.0);
        }
    }
}

/* Builds a tree over boxes, with nodes from `node` on, and writes the reference and the box of its root. Its leaves
 * are spans of triangles, whose lengths `leaves` gets at their first places, or single entries of `references`. */
static void build(const float *boxes, uint32_t *order, int64_t first, int64_t count, uint8_t *leaves,
                  const uint32_t *references, uint8_t *nodes, int64_t node, uint32_t *root, float *box)
{
    struct {
        span whole;
        uint32_t *reference;
        int depth;
    } open[MOST_OPEN];
    const int64_t leaf = leaves ? BVH_LEAF : 1;
    int left = 1;
    open[0].whole = (span){octet_of(FLT_MAX), first, count};
    open[0].reference = root, open[0].depth = 0;
    for (int64_t i = first; i < first + count; i++)
        open[0].whole.box = octet_min(open[0].whole.box, octet_load(boxes + BOX * (size_t)order[i]));
    octet_store(box, open[0].whole.box);
    while (left > 0) {
        left--;
        uint32_t *reference = open[left].reference;
        const int depth = open[left].depth;
        span children[BVH_WIDTH];
        children[0] = open[left].whole;
        if (children[0].count <= leaf) {
            const uint32_t place = (uint32_t)children[0].first;
            if (leaves) {
                *reference = BVH_IS_LEAF | (uint32_t)(children[0].count - 1) << BVH_COUNT_SHIFT | place;
                leaves[place] = (uint8_t)children[0].count;
            } else {
                *reference = references[order[place]];
            }
            continue;
        }
        int number = 1;
        while (number < BVH_WIDTH) {
            int largest = -1;
            float area = -1.0f;
            for (int child = 0; child < number; child++) {
                const float of_child = half_area(children[child].box);
                if (children[child].count > leaf && of_child > area)
                    area = of_child, largest = child;
            }
            if (largest < 0)
                break;
            split(boxes, order, depth, &children[largest], &children[number++]);
        }
        *reference = (uint32_t)node;
        bvh_node *packed = (bvh_node *)nodes + node++;
        pack(packed, children, number);
        for (int child = 0; child < number; child++) {
            open[left].whole = children[child], open[left].depth = depth + 1;
            open[left++].reference = &packed->child[child];
        }
    }
}

/* Builds the subtrees of cells. Cell i has the sorted entries starts[i]..starts[i + 1] - 1, and its nodes start at
 * spaces[i]; they are less than a quarter as many as its triangles. */
void SKN(bvh_subtrees)(const float *boxes, const uint64_t *entries, const int64_t *starts, const int64_t *spaces,
                       int64_t first, int64_t last, uint32_t *order, uint8_t *leaves, uint8_t *nodes, uint32_t *roots,
                       float *cells)
{
    for (int64_t cell = first; cell < last; cell++) {
        for (int64_t i = starts[cell]; i < starts[cell + 1]; i++)
            order[i] = (uint32_t)entries[i], leaves[i] = 0;
        build(boxes, order, starts[cell], starts[cell + 1] - starts[cell], leaves, NULL, nodes, spaces[cell],
              roots + cell, cells + BOX * cell);
    }
}

/* Builds the tree over the cells first..last - 1, with nodes from `space` on, and writes the reference of its root. */
void SKN(bvh_top)(const float *cells, const uint32_t *roots, int64_t first, int64_t last, int64_t space,
                  uint32_t *order, uint8_t *nodes, uint32_t *root)
{
    float box[BOX];
    for (int64_t i = first; i < last; i++)
        order[i] = (uint32_t)i;
    build(cells, order, first, last - first, NULL, roots, nodes, space, root, box);
}

/* Writes the corners of the leaves whose first places lie in a range. */
void SKN(bvh_corners)(const double *points, const void *faces, int32_t kind, const uint32_t *order,
                      const uint8_t *leaves, int64_t first, int64_t last, double *corners)
{
    for (int64_t i = first; i < last; i++) {
        double *leaf = corners + 9 * i;
        for (int lane = 0; lane < leaves[i]; lane++) {
            int64_t face[3];
            skn_face(faces, kind, order[i + lane], face);
            for (int corner = 0; corner < 3; corner++)
                for (int axis = 0; axis < 3; axis++)
                    leaf[(3 * corner + axis) * leaves[i] + lane] = points[3 * face[corner] + axis];
        }
    }
}
