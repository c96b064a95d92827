/* Diffusion over a mesh: the cotangent Laplacian as a table of edges, and a step of Chebyshev's recurrence with it.
 * NumPy twins: edges_of of skinshade/mesh/laplacian.py, and filtered of skinshade/mesh/chebyshev.py. */
#include "lanes.h"

enum { COLUMNS = LANES, CHANNELS = 3, TERMS = 3, FEW = 48 };

/* Half the cotangents of the angles at the corners of a face, its area, and the greatest eigenvalue of its own
 * Laplacian, whose mass at every corner is a third of the area. */
typedef struct {
    double half[3], area, greatest;
} cotangents;

/* The result has the same bytes for all three corners of a face: the corner of the lowest index comes first. */
SKN_INLINE cotangents cotangents_of(const double *points, const uint32_t face[3], double floor_area)
{
    double p[3][3], e01[3], e02[3], e12[3];
    for (int corner = 0; corner < 3; corner++)
        skn_row(points, SKN_F64, face[corner], p[corner]);
    for (int axis = 0; axis < 3; axis++) {
        e01[axis] = p[1][axis] - p[0][axis];
        e02[axis] = p[2][axis] - p[0][axis];
        e12[axis] = p[2][axis] - p[1][axis];
    }
    const double x = e01[1] * e02[2] - e01[2] * e02[1], y = e01[2] * e02[0] - e01[0] * e02[2];
    const double z = e01[0] * e02[1] - e01[1] * e02[0];
    const double area = 0.5 * sqrt(x * x + y * y + z * z);
    /* Half a cotangent is the dot product of two sides over four times the area. */
    const double scale = 0.25 / (area > floor_area ? area : floor_area);
    cotangents face_of = {.area = area};
    face_of.half[0] = scale * (e01[0] * e02[0] + e01[1] * e02[1] + e01[2] * e02[2]);
    face_of.half[1] = -scale * (e01[0] * e12[0] + e01[1] * e12[1] + e01[2] * e12[2]);
    face_of.half[2] = scale * (e02[0] * e12[0] + e02[1] * e12[1] + e02[2] * e12[2]);
    const double a = face_of.half[0], b = face_of.half[1], c = face_of.half[2];
    const double sum = a + b + c, square = sum * sum - 3.0 * (a * b + b * c + c * a);
    const double root = sum + sqrt(square > 0.0 ? square : 0.0);
    face_of.greatest = area > 0.0 ? 3.0 * root / area : HUGE_VAL;
    return face_of;
}

/* Rotates the corners of a face so that the lowest index comes first, and returns the position of the first. */
SKN_INLINE int rotated(uint32_t a, uint32_t b, uint32_t c, uint32_t face[3])
{
    if (a <= b && a <= c)
        return face[0] = a, face[1] = b, face[2] = c, 0;
    if (c <= a && c <= b)
        return face[0] = c, face[1] = a, face[2] = b, 1;
    return face[0] = b, face[1] = c, face[2] = a, 2;
}

/* Adds a weight to the edge to a vertex in a row of edges, and returns the number of edges. A long row is not searched:
 * it is sorted later, and edges with equal ends are joined. */
SKN_INLINE uint32_t add_edge(uint32_t *ends, double *weights, uint32_t edges, uint32_t end, double weight)
{
    if (edges <= FEW)
        for (uint32_t k = edges; k-- > 0;)
            if (ends[k] == end) {
                weights[k] += weight;
                return edges;
            }
    ends[edges] = end;
    weights[edges] = weight;
    return edges + 1;
}

SKN_INLINE void swap_edges(uint32_t *ends, double *weights, uint32_t i, uint32_t j)
{
    const uint32_t end = ends[i];
    const double weight = weights[i];
    ends[i] = ends[j], ends[j] = end;
    weights[i] = weights[j], weights[j] = weight;
}

SKN_INLINE void sift_edge(uint32_t *ends, double *weights, uint32_t root, uint32_t count)
{
    for (uint64_t child = 2 * (uint64_t)root + 1; child < count; child = 2 * (uint64_t)root + 1) {
        child += child + 1 < count && ends[child] < ends[child + 1];
        if (ends[root] >= ends[child])
            return;
        swap_edges(ends, weights, root, (uint32_t)child);
        root = (uint32_t)child;
    }
}

/* Sorts a long row of edges and joins those with equal ends; returns how many remain. */
static uint32_t joined(uint32_t *ends, double *weights, uint32_t edges)
{
    for (uint32_t root = edges / 2; root-- > 0;)
        sift_edge(ends, weights, root, edges);
    for (uint32_t end = edges - 1; end > 0; end--) {
        swap_edges(ends, weights, 0, end);
        sift_edge(ends, weights, 0, end);
    }
    uint32_t last = 0;
    for (uint32_t k = 1; k < edges; k++) {
        if (ends[k] == ends[last])
            weights[last] += weights[k];
        else
            last++, ends[last] = ends[k], weights[last] = weights[k];
    }
    return last + 1;
}

/* Writes the edges of vertices (their other ends and weights) from the place `rooms` of each vertex on, the numbers
 * of edges, a third of the areas around, and two upper bounds of the eigenvalues: by faces and by rows. A vertex has
 * room for twice its corners. */
void SKN(edges_fill)(const double *points, const uint32_t *starts, const uint32_t *counts, const uint32_t *corners,
                     int64_t vertices, int64_t first, int64_t last, double floor_area, const int64_t *rooms,
                     uint32_t *ends, double *weights, uint32_t *edges, double *masses, double *bounds)
{
    const int64_t stop = LANES * last < vertices ? LANES * last : vertices;
    for (int64_t vertex = LANES * first; vertex < stop; vertex++) {
        const uint32_t own = (uint32_t)vertex;
        const uint32_t *corner = corners + 2 * (LANES * (size_t)starts[vertex / LANES] + (size_t)(vertex % LANES));
        uint32_t *row = ends + rooms[vertex], count = 0;
        double *row_weights = weights + rooms[vertex], area = 0.0, greatest = 0.0, total = 0.0, size = 0.0;
        for (uint32_t k = 0; k < counts[vertex]; k++, corner += 2 * LANES) {
            const uint32_t next = corner[0], previous = corner[1];
            uint32_t face[3];
            if (next == own || previous == own || next == previous)
                continue; /* a face without area */
            const int at = rotated(own, next, previous, face);
            const cotangents face_of = cotangents_of(points, face, floor_area);
            area += face_of.area;
            greatest = greatest > face_of.greatest ? greatest : face_of.greatest;
            /* An edge lies opposite to the third corner of the face. */
            count = add_edge(row, row_weights, count, next, face_of.half[(at + 2) % 3]);
            count = add_edge(row, row_weights, count, previous, face_of.half[(at + 1) % 3]);
        }
        if (count > FEW)
            count = joined(row, row_weights, count);
        for (uint32_t k = 0; k < count; k++)
            total += row_weights[k], size += fabs(row_weights[k]);
        edges[vertex] = count;
        masses[vertex] = area / 3.0;
        bounds[2 * vertex] = greatest;
        bounds[2 * vertex + 1] = area > 0.0 ? 3.0 * (fabs(total) + size) / area : HUGE_VAL;
    }
}

/* Copies the edges of vertices from the place `rooms` of each vertex to the places `firsts`. */
void SKN(edges_pack)(const int64_t *rooms, const uint32_t *ends, const double *weights, int64_t first, int64_t last,
                     const int64_t *firsts, uint32_t *packed, double *packed_weights)
{
    for (int64_t vertex = first; vertex < last; vertex++) {
        const size_t count = (size_t)(firsts[vertex + 1] - firsts[vertex]);
        memcpy(packed + firsts[vertex], ends + rooms[vertex], count * sizeof *ends);
        memcpy(packed_weights + firsts[vertex], weights + rooms[vertex], count * sizeof *weights);
    }
}

/* Replaces previous (T[k - 1]) by next (T[k + 1]) = 2 Y now - previous, where now is T[k] and Y is
 * 1 - rate / 2 * Laplacian, and adds up to three terms to the sums of the channels. The rows have four columns.
 * start: next is Y now, and sums are overwritten. factors: of previous, now and next for every channel, or all 0. */
void SKN(chebyshev_step)(const int64_t *firsts, const uint32_t *ends, const double *weights, const double *rates,
                         int64_t first, int64_t last, int32_t start, const double *now, double *previous,
                         const double *factors, double *sums)
{
    int used[CHANNELS];
    for (int channel = 0; channel < CHANNELS; channel++) {
        const double *f = factors + TERMS * channel;
        used[channel] = start || f[0] != 0.0 || f[1] != 0.0 || f[2] != 0.0;
    }
    for (int64_t i = first; i < last; i++) {
        const f64x4 own = lanes_load(now + COLUMNS * i), before = lanes_load(previous + COLUMNS * i);
        f64x4 flow = lanes_of(0.0);
        for (int64_t k = firsts[i]; k < firsts[i + 1]; k++)
            flow += lanes_of(weights[k]) * (own - lanes_load(now + COLUMNS * (size_t)ends[k]));
        const f64x4 twice = own + own - lanes_of(rates[i]) * flow;
        const f64x4 next = start ? lanes_of(0.5) * twice : twice - before;
        lanes_store(previous + COLUMNS * i, next);
        for (int channel = 0; channel < CHANNELS; channel++) {
            const double *f = factors + TERMS * channel;
            double *sum = sums + COLUMNS * (CHANNELS * i + channel);
            if (!used[channel])
                continue;
            const f64x4 added = lanes_of(f[1]) * own + lanes_of(f[2]) * next;
            lanes_store(sum, start ? added : lanes_load(sum) + lanes_of(f[0]) * before + added);
        }
    }
}
