/* Nearest faces and depths at the samples of an image, by homogeneous edge functions [Olano1997].
 * NumPy twins: rasterize and depth_maps of skinshade/rendering/prepare/rasterizer.py.
 *
 * A range is a band of image rows. Every band visits all faces in their order, so that the result does not depend on
 * the bands. `screen` has x·w, y·w (down) and w of the vertices, in pixels; `view` has width, height, and the position
 * of the sample within a pixel. */
#include "rows.h"

#include <float.h>

#define EDGE_SLACK 1e-14 /* as in the twin */
#define BOX_SLACK 1e-6   /* as in the twin */
#define BEHIND 1e-9      /* w up to which a corner lies behind the eye, as in the twin */

enum { SPAN = 16 };                    /* width of a box in pixels from which the covered part of a row is computed */
enum { NEAREST = 0, DEPTHS = 1, LIST = 2 }; /* what is done with covered samples */

typedef struct {
    double edge[3][3]; /* coefficients of x, y and 1; the corner's barycentric coordinate over w */
    double determinant;
} functions;

typedef struct {
    double width, height, x, y;
    int64_t first, last; /* rows */
} band;

typedef struct {
    double *nearest, *other;  /* (H, W) depths */
    int64_t *face, *pixel;    /* winners (H, W), or a list with pixels */
    double *depth;            /* depths of the list */
    int64_t from, count;      /* first face that is drawn; entries of the list */
} target;

SKN_INLINE void cross_of(const double *a, const double *b, double *result)
{
    result[0] = a[1] * b[2] - a[2] * b[1];
    result[1] = a[2] * b[0] - a[0] * b[2];
    result[2] = a[0] * b[1] - a[1] * b[0];
}

SKN_INLINE double larger(double a, double b) { return a > b ? a : b; }
SKN_INLINE double smaller(double a, double b) { return a < b ? a : b; }

/* Sets the edge functions of a face; returns 0 for a face that is seen edge-on. */
SKN_INLINE int set_functions(const double *a, const double *b, const double *c, functions *result)
{
    cross_of(b, c, result->edge[0]), cross_of(c, a, result->edge[1]), cross_of(a, b, result->edge[2]);
    const double *e = result->edge[0], determinant = a[0] * e[0] + a[1] * e[1] + a[2] * e[2];
    const double greatest = larger(larger(fabs(a[0]), fabs(a[1])), fabs(a[2]));
    result->determinant = determinant;
    if (!(fabs(determinant) > 1e-12 * larger(greatest * greatest, 1e-300)))
        return 0;
    const double scale = 1.0 / determinant;
    for (int corner = 0; corner < 3; corner++)
        for (int k = 0; k < 3; k++)
            result->edge[corner][k] *= scale;
    return 1;
}

/* Returns a number as an index low..high; NaN becomes low. */
SKN_INLINE int64_t bounded(double value, int64_t low, int64_t high)
{
    const double least = value > (double)low ? value : (double)low;
    return (int64_t)(least < (double)high ? least : (double)high);
}

/* Sets the rows and columns from..to of the box of a face within a band; returns 0 if it is empty. */
SKN_INLINE int set_box(const double *corners[3], const band *in, int64_t from[2], int64_t to[2])
{
    int behind = 0;
    for (int corner = 0; corner < 3; corner++)
        behind += corners[corner][2] <= BEHIND;
    if (behind == 3)
        return 0;
    const int64_t width = (int64_t)in->width;
    from[0] = 0, to[0] = width - 1, from[1] = in->first, to[1] = in->last - 1;
    if (behind)
        return 1;
    double low[2] = {DBL_MAX, DBL_MAX}, high[2] = {-DBL_MAX, -DBL_MAX};
    for (int axis = 1; axis >= 0; axis--) {
        for (int corner = 0; corner < 3; corner++) {
            const double value = corners[corner][axis] / corners[corner][2];
            low[axis] = smaller(low[axis], value), high[axis] = larger(high[axis], value);
        }
        const double offset = axis ? in->y : in->x;
        from[axis] = bounded(ceil(low[axis] - offset - BOX_SLACK), from[axis], to[axis] + 1);
        to[axis] = bounded(floor(high[axis] - offset + BOX_SLACK), from[axis] - 1, to[axis]);
        if (from[axis] > to[axis])
            return 0;
    }
    return 1;
}

/* Narrows columns from..to to those that lie within the edges in a row, and a pixel on either side. */
SKN_INLINE void narrow(double edge[3][3], double y, double x_offset, int64_t *from, int64_t *to)
{
    double low = (double)*from, high = (double)*to;
    for (int corner = 0; corner < 3; corner++) {
        const double a = edge[corner][0], by = edge[corner][1] * y, c = edge[corner][2];
        if (a == 0.0)
            continue;
        const double at = -(by + c) / a - x_offset, error = 1e-12 * ((fabs(by) + fabs(c)) / fabs(a));
        if (a > 0.0)
            low = larger(low, at - error - 1.0);
        else
            high = smaller(high, at + error + 1.0);
    }
    *from = bounded(low, *from, *to + 1), *to = bounded(ceil(high), *from - 1, *to);
}

SKN_INLINE void draw_face(const functions *of, const double depths[3], const band *in, int64_t face,
                          const int64_t box_from[2], const int64_t box_to[2], int mode, target *out)
{
    double edge[3][3], over_w[3], inverse_w[3];
    for (int k = 0; k < 3; k++) {
        over_w[k] = depths[0] * of->edge[0][k] + depths[1] * of->edge[1][k] + depths[2] * of->edge[2][k];
        inverse_w[k] = of->edge[0][k] + of->edge[1][k] + of->edge[2][k];
    }
    for (int corner = 0; corner < 3; corner++) {
        const double *e = of->edge[corner];
        const double reach = fabs(e[0]) * in->width + fabs(e[1]) * in->height + fabs(e[2]);
        edge[corner][0] = e[0], edge[corner][1] = e[1], edge[corner][2] = e[2] + EDGE_SLACK * reach;
    }
    const int faces_away = of->determinant > 0.0; /* y runs down, which reverses the winding */
    for (int64_t row = box_from[1]; row <= box_to[1]; row++) {
        const double y = (double)row + in->y, by[3] = {edge[0][1] * y, edge[1][1] * y, edge[2][1] * y};
        int64_t from = box_from[0], to = box_to[0];
        if (to - from >= SPAN)
            narrow(edge, y, in->x, &from, &to);
        for (int64_t column = from; column <= to; column++) {
            const double x = (double)column + in->x;
            if (!(edge[0][0] * x + by[0] + edge[0][2] >= 0.0) || !(edge[1][0] * x + by[1] + edge[1][2] >= 0.0) ||
                !(edge[2][0] * x + by[2] + edge[2][2] >= 0.0))
                continue;
            const double inverse = inverse_w[0] * x + inverse_w[1] * y + inverse_w[2];
            if (!(inverse > 0.0))
                continue;
            const double depth = (over_w[0] * x + over_w[1] * y + over_w[2]) / inverse;
            const int64_t pixel = row * (int64_t)in->width + column;
            if (mode == DEPTHS) {
                out->nearest[pixel] = smaller(depth, out->nearest[pixel]);
                if (faces_away)
                    out->other[pixel] = smaller(depth, out->other[pixel]);
            } else if (depth <= out->nearest[pixel]) { /* of equal depths the last face wins */
                if (mode == NEAREST) {
                    out->nearest[pixel] = depth, out->face[pixel] = face;
                } else {
                    if (out->face)
                        out->face[out->count] = face, out->pixel[out->count] = pixel, out->depth[out->count] = depth;
                    out->count++;
                }
            }
        }
    }
}

SKN_INLINE void draw(const double *screen, const double *depth, const int64_t *faces, int64_t from, int64_t to,
                     const double *view, int64_t first, int64_t last, int mode, target *out)
{
    const band in = {view[0], view[1], view[2], view[3], first, last};
    for (int64_t i = from; i < to; i++) {
        const int64_t *face = faces + 3 * i;
        const double *corners[3] = {screen + 3 * face[0], screen + 3 * face[1], screen + 3 * face[2]};
        const double depths[3] = {depth[face[0]], depth[face[1]], depth[face[2]]};
        int64_t box_from[2], box_to[2];
        functions of;
        if (set_box(corners, &in, box_from, box_to) && set_functions(corners[0], corners[1], corners[2], &of))
            draw_face(&of, depths, &in, i, box_from, box_to, mode, out);
    }
}

/* Draws faces from..to - 1 into the rows first..last - 1 of `nearest` and `winner`. */
void SKN(raster_nearest)(const double *screen, const double *depth, const int64_t *faces, int64_t from, int64_t to,
                         const double *view, int64_t first, int64_t last, double *nearest, int64_t *winner)
{
    target out = {.nearest = nearest, .face = winner};
    draw(screen, depth, faces, from, to, view, first, last, NEAREST, &out);
}

/* Lists the samples of faces that are not behind `nearest`, or counts them if the list is NULL. */
int64_t SKN(raster_list)(const double *screen, const double *depth, const int64_t *faces, int64_t from, int64_t to,
                         const double *view, int64_t first, int64_t last, double *nearest, int64_t *face,
                         int64_t *pixel, double *depths)
{
    target out = {.nearest = nearest, .face = face, .pixel = pixel, .depth = depths};
    draw(screen, depth, faces, from, to, view, first, last, LIST, &out);
    return out.count;
}

/* Draws the depths of all faces, and of those that face away. */
void SKN(raster_depths)(const double *screen, const double *depth, const int64_t *faces, int64_t count,
                        const double *view, int64_t first, int64_t last, double *nearest, double *facing_away)
{
    target out = {.nearest = nearest, .other = facing_away};
    draw(screen, depth, faces, 0, count, view, first, last, DEPTHS, &out);
}

/* Writes the barycentric coordinates of faces at pixels, and their changes along x and y. */
void SKN(raster_resolve)(const double *screen, const int64_t *faces, const int64_t *face, const int64_t *pixel,
                         const double *view, int64_t first, int64_t last, double *barycentric, double *along_x,
                         double *along_y)
{
    const int64_t width = (int64_t)view[0];
    for (int64_t i = first; i < last; i++) {
        const int64_t *corner = faces + 3 * face[i];
        functions of;
        set_functions(screen + 3 * corner[0], screen + 3 * corner[1], screen + 3 * corner[2], &of);
        const double x = (double)(pixel[i] % width) + view[2], y = (double)(pixel[i] / width) + view[3];
        double value[3], slope[2] = {0.0, 0.0}, total = 0.0;
        for (int k = 0; k < 3; k++) {
            value[k] = of.edge[k][0] * x + of.edge[k][1] * y + of.edge[k][2];
            total += value[k], slope[0] += of.edge[k][0], slope[1] += of.edge[k][1];
        }
        for (int k = 0; k < 3; k++) {
            const double share = value[k] / total;
            barycentric[3 * i + k] = share;
            along_x[3 * i + k] = (of.edge[k][0] - share * slope[0]) / total;
            along_y[3 * i + k] = (of.edge[k][1] - share * slope[1]) / total;
        }
    }
}
