/* Areas and sides of faces. NumPy twins: face_areas, corner_areas and used_vertices of skinshade/mesh/topology.py, and
 * _median_edge of skinshade/mesh/shape_operator.py. */
#include "rows.h"

SKN_INLINE void areas_of(const void *points, int32_t kind, const void *faces, int32_t face_kind, int64_t first,
                         int64_t last, double *areas)
{
    for (int64_t i = first; i < last; i++) {
        int64_t face[3];
        double a[3], b[3], c[3];
        skn_face(faces, face_kind, i, face);
        skn_row(points, kind, face[0], a);
        skn_row(points, kind, face[1], b);
        skn_row(points, kind, face[2], c);
        const double x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2];
        const double u = c[0] - a[0], v = c[1] - a[1], w = c[2] - a[2];
        const double p = y * w - z * v, q = z * u - x * w, r = x * v - y * u;
        areas[i] = 0.5 * sqrt(p * p + q * q + r * r);
    }
}

/* Writes the areas of faces. */
void SKN(face_areas)(const void *points, int32_t kind, const void *faces, int32_t face_kind, int64_t first,
                     int64_t last, double *areas)
{
    if (face_kind == SKN_I32)
        SKN_WITH_FLOATS(kind, areas_of(points, SKN_F32, faces, SKN_I32, first, last, areas),
                        areas_of(points, SKN_F64, faces, SKN_I32, first, last, areas));
    else
        SKN_WITH_FLOATS(kind, areas_of(points, SKN_F32, faces, SKN_I64, first, last, areas),
                        areas_of(points, SKN_F64, faces, SKN_I64, first, last, areas));
}

/* Adds a third of the areas of all `count` faces to those of their corners that lie in first..last - 1. */
void SKN(add_thirds)(const double *areas, const void *faces, int32_t kind, int64_t count, int64_t first, int64_t last,
                     double *sums)
{
    for (int64_t i = 0; i < count; i++) {
        int64_t face[3];
        skn_face(faces, kind, i, face);
        const double third = areas[i] / 3.0;
        for (int corner = 0; corner < 3; corner++)
            if (face[corner] >= first && face[corner] < last)
                sums[face[corner]] += third;
    }
}

/* Marks the vertices of faces. */
void SKN(mark_used)(const void *faces, int32_t kind, int64_t first, int64_t last, uint8_t *used)
{
    for (int64_t i = first; i < last; i++) {
        int64_t face[3];
        skn_face(faces, kind, i, face);
        used[face[0]] = used[face[1]] = used[face[2]] = 1;
    }
}

/* Writes the squares of the lengths of the sides of every `step`th face. */
void SKN(side_squares)(const void *points, int32_t kind, const void *faces, int32_t face_kind, int64_t step,
                       int64_t first, int64_t last, double *squares)
{
    for (int64_t i = first; i < last; i++) {
        int64_t face[3];
        double p[3][3];
        skn_face(faces, face_kind, i * step, face);
        for (int corner = 0; corner < 3; corner++)
            skn_row(points, kind, face[corner], p[corner]);
        for (int corner = 0; corner < 3; corner++) {
            const int other = corner == 2 ? 0 : corner + 1;
            const double x = p[other][0] - p[corner][0], y = p[other][1] - p[corner][1];
            const double z = p[other][2] - p[corner][2];
            squares[3 * i + corner] = x * x + y * y + z * z;
        }
    }
}
