/* Declarations of all compiled kernels.
 *
 * Every kernel file is compiled once for each level of instructions (v2 and v3 on x86-64, base elsewhere), and
 * every kernel has its level in its name: skn_face_areas_v3. skinshade/_core/native.py chooses the level.
 *
 * Rules: a kernel works on a range [first, last) of blocks, rows, faces or vertices, allocates nothing and starts
 * no thread. Its result depends on its input only, not on the ranges: sums have a fixed order, and only
 * + - * / and square roots are used. Sizes and indices in arguments are int64_t; indices in tables are uint32_t.
 */
#ifndef SKINSHADE_KERNELS_H
#define SKINSHADE_KERNELS_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32)
#define SKN_EXPORT __declspec(dllexport)
#else
#define SKN_EXPORT __attribute__((visibility("default")))
#endif

#ifndef SKN_LEVEL
#define SKN_LEVEL base
#endif
#define SKN_JOINED(name, level) skn_##name##_##level
#define SKN_NAMED(name, level) SKN_JOINED(name, level)
#define SKN(name) SKN_NAMED(name, SKN_LEVEL)

/* Types of rows of three numbers. */
enum { SKN_F32 = 0, SKN_F64 = 1, SKN_I32 = 2, SKN_I64 = 3 };

/* Vertices of a slab, which are worked on at once. */
enum { LANES = 4 };

#define SKN_TINY 2.2250738585072014e-308 /* least normal double */

/* checks.c */
SKN_EXPORT int64_t SKN(first_outside)(const void *values, int32_t kind, int64_t first, int64_t last, double low,
                                      double high);
SKN_EXPORT int64_t SKN(first_bad_index)(const void *values, int32_t kind, int64_t first, int64_t last,
                                        int64_t limit);

/* equal.c */
SKN_EXPORT void SKN(equal_count)(const void *rows, int32_t kind, int64_t first, int64_t last, int32_t shift,
                                 uint32_t *counts);
SKN_EXPORT void SKN(equal_scatter)(const void *rows, int32_t kind, int64_t first, int64_t last, int32_t shift,
                                   uint32_t *cursors, uint64_t *entries, uint32_t *match);
SKN_EXPORT int64_t SKN(equal_match)(const void *rows, int32_t kind, const uint64_t *entries, const uint32_t *starts,
                                    int64_t first, int64_t last, uint32_t *table, uint32_t *match);
SKN_EXPORT int64_t SKN(equal_firsts)(const uint32_t *match, int64_t first, int64_t last);
SKN_EXPORT void SKN(equal_number)(const uint32_t *match, int64_t first, int64_t last, int64_t number,
                                  uint32_t *numbers, uint32_t *firsts);
SKN_EXPORT void SKN(equal_group)(const uint32_t *match, const uint32_t *numbers, int64_t first, int64_t last,
                                 uint32_t *group);

/* order.c */
SKN_EXPORT void SKN(bounds)(const void *points, int32_t kind, int64_t first, int64_t last, double *box);
SKN_EXPORT void SKN(order_keys)(const void *points, int32_t kind, const uint32_t *firsts, int64_t first,
                                int64_t last, const double *box, uint64_t *entries);
SKN_EXPORT void SKN(radix_count)(const uint64_t *entries, int64_t first, int64_t last, int32_t shift, int32_t bits,
                                 uint32_t *counts);
SKN_EXPORT void SKN(radix_scatter)(const uint64_t *entries, int64_t first, int64_t last, int32_t shift,
                                   int32_t bits, uint32_t *cursors, uint64_t *sorted);
SKN_EXPORT void SKN(order_ranks)(const uint64_t *entries, int64_t first, int64_t last, uint32_t *ranks);
SKN_EXPORT void SKN(order_sources)(const uint64_t *entries, const uint32_t *firsts, int64_t first, int64_t last,
                                   uint32_t *sources);
SKN_EXPORT void SKN(look_up)(const uint32_t *table, int64_t first, int64_t last, uint32_t *indices);
SKN_EXPORT void SKN(faces_remap)(const void *faces, int32_t kind, int64_t first, int64_t last,
                                 const uint32_t *remap, int32_t shift, uint32_t *remapped, uint32_t *counts);
SKN_EXPORT void SKN(faces_scatter)(const uint32_t *faces, int64_t first, int64_t last, int32_t shift,
                                   uint32_t *cursors, uint32_t *sorted);

/* pack.c */
SKN_EXPORT void SKN(pack)(const void *rows, int32_t kind, const uint32_t *sources, int64_t first, int64_t last,
                          int32_t unit, double *packed);
SKN_EXPORT int64_t SKN(count_not_unit)(const double *vectors, int64_t first, int64_t last);
SKN_EXPORT void SKN(sum_normals)(const void *normals, int32_t kind, const uint8_t *used, const uint32_t *remap,
                                 int64_t count, int64_t first, int64_t last, double *sums);
SKN_EXPORT void SKN(unpack)(const double *rows, int64_t columns, const uint32_t *remap, int64_t first, int64_t last,
                            double *result);
SKN_EXPORT void SKN(project)(const double *world, int64_t stride, const void *normals, int32_t kind,
                             const uint32_t *remap, int64_t first, int64_t last, double *tensor);

/* corners.c */
SKN_EXPORT void SKN(corner_count)(const void *faces, int32_t kind, int64_t first, int64_t last,
                                  const uint32_t *remap, int64_t vertices, uint32_t *counts);
SKN_EXPORT int64_t SKN(corner_sum)(const uint32_t *tables, int64_t parts, int64_t vertices, int64_t first,
                                   int64_t last, uint32_t *counts);
SKN_EXPORT void SKN(corner_starts)(uint32_t *tables, int64_t parts, int64_t vertices, const uint32_t *counts,
                                   int64_t first, int64_t last, int64_t row, uint32_t *starts, uint32_t *corners);
SKN_EXPORT void SKN(corner_fill)(const void *faces, int32_t kind, int64_t first, int64_t last,
                                 const uint32_t *remap, uint32_t *cursors, uint32_t *corners);

/* normals.c */
SKN_EXPORT void SKN(vertex_normals)(const double *points, const uint32_t *starts, const uint32_t *counts,
                                    const uint32_t *corners, int64_t vertices, int64_t first, int64_t last,
                                    double *normals, double *areas);

/* fit.c */
SKN_EXPORT void SKN(fit)(const double *points, const double *normals, const uint32_t *starts, const uint32_t *counts,
                         const uint32_t *corners, int64_t vertices, int64_t first, int64_t last, const double *bounds,
                         double *fitted, double *areas, uint8_t *bounded);

/* smooth.c */
SKN_EXPORT void SKN(weigh_mean)(const double *values, const double *areas, int64_t first, int64_t last,
                                double *weighted);
SKN_EXPORT void SKN(weigh_world)(const double *tensor, const double *areas, const double *normals, int64_t first,
                                 int64_t last, double *weighted);
SKN_EXPORT void SKN(smooth_mean)(const double *weighted, const uint32_t *starts, const uint32_t *counts,
                                 const uint32_t *corners, int64_t vertices, int64_t first, int64_t last,
                                 int32_t values_only, double *smoothed);
SKN_EXPORT void SKN(smooth_world)(const double *weighted, const uint32_t *starts, const uint32_t *counts,
                                  const uint32_t *corners, int64_t vertices, int64_t first, int64_t last,
                                  int32_t values_only, double *smoothed);

/* faces.c */
SKN_EXPORT void SKN(face_areas)(const void *points, int32_t kind, const void *faces, int32_t face_kind,
                                int64_t first, int64_t last, double *areas);
SKN_EXPORT void SKN(add_thirds)(const double *areas, const void *faces, int32_t kind, int64_t count, int64_t first,
                                int64_t last, double *sums);
SKN_EXPORT void SKN(mark_used)(const void *faces, int32_t kind, int64_t first, int64_t last, uint8_t *used);
SKN_EXPORT void SKN(side_squares)(const void *points, int32_t kind, const void *faces, int32_t face_kind,
                                  int64_t step, int64_t first, int64_t last, double *squares);

/* diffuse.c */
SKN_EXPORT void SKN(edges_fill)(const double *points, const uint32_t *starts, const uint32_t *counts,
                                const uint32_t *corners, int64_t vertices, int64_t first, int64_t last,
                                double floor_area, const int64_t *rooms, uint32_t *ends, double *weights,
                                uint32_t *edges, double *masses, double *bounds);
SKN_EXPORT void SKN(edges_pack)(const int64_t *rooms, const uint32_t *ends, const double *weights, int64_t first,
                                int64_t last, const int64_t *firsts, uint32_t *packed, double *packed_weights);
SKN_EXPORT void SKN(chebyshev_step)(const int64_t *firsts, const uint32_t *ends, const double *weights,
                                    const double *rates, int64_t first, int64_t last, int32_t start,
                                    const double *now, double *previous, const double *factors, double *sums);

/* edges.c */
SKN_EXPORT void SKN(edge_faults)(const uint32_t *starts, const uint32_t *counts, const uint32_t *corners,
                                 int64_t vertices, int64_t first, int64_t last, uint32_t *keys, int64_t *faults);

/* bvh.c */
SKN_EXPORT void SKN(bvh_boxes)(const double *points, const void *faces, int32_t kind, int64_t first, int64_t last,
                               float *boxes, uint64_t *entries);
SKN_EXPORT void SKN(bvh_subtrees)(const float *boxes, const uint64_t *entries, const int64_t *starts,
                                  const int64_t *spaces, int64_t first, int64_t last, uint32_t *order,
                                  uint8_t *leaves, uint8_t *nodes, uint32_t *roots, float *cells);
SKN_EXPORT void SKN(bvh_top)(const float *cells, const uint32_t *roots, int64_t first, int64_t last, int64_t space,
                             uint32_t *order, uint8_t *nodes, uint32_t *root);
SKN_EXPORT void SKN(bvh_corners)(const double *points, const void *faces, int32_t kind, const uint32_t *order,
                                 const uint8_t *leaves, int64_t first, int64_t last, double *corners);

/* rays.c */
SKN_EXPORT void SKN(ray_exits)(const uint8_t *nodes, const double *corners, const uint32_t *ids, int64_t root,
                               const double *origins, const double *directions, int64_t first, int64_t last,
                               double *distances);
SKN_EXPORT void SKN(ray_hits)(const uint8_t *nodes, const double *corners, const uint32_t *ids, int64_t root,
                              const double *origins, const double *directions, int64_t first, int64_t last,
                              double *distances, int64_t *faces, double *weights);
SKN_EXPORT void SKN(ray_blocks)(const uint8_t *nodes, const double *corners, const uint32_t *ids, int64_t root,
                                const double *origins, const double *directions, const double *limits, int64_t first,
                                int64_t last, uint8_t *blocked);
SKN_EXPORT void SKN(ray_sums)(const uint8_t *nodes, const double *corners, const uint32_t *ids, int64_t root,
                              const double *origins, const double *normals, int64_t points, int64_t first,
                              int64_t last, const double *sets, int64_t set_count, int64_t rays, double *sums);

/* noise.c */
SKN_EXPORT void SKN(sample_volume)(const float *volume, int64_t size, const float *points, int64_t first,
                                   int64_t last, double scale, float *values);

/* uv_scale.c */
SKN_EXPORT void SKN(uv_ratios)(const void *points, int32_t kind, const double *uvs, const void *faces,
                               int32_t face_kind, int64_t count, int64_t first, int64_t last, double *products);

/* raster.c */
SKN_EXPORT void SKN(raster_nearest)(const double *screen, const double *depth, const int64_t *faces, int64_t from,
                                    int64_t to, const double *view, int64_t first, int64_t last, double *nearest,
                                    int64_t *winner);
SKN_EXPORT int64_t SKN(raster_list)(const double *screen, const double *depth, const int64_t *faces, int64_t from,
                                    int64_t to, const double *view, int64_t first, int64_t last, double *nearest,
                                    int64_t *face, int64_t *pixel, double *depths);
SKN_EXPORT void SKN(raster_depths)(const double *screen, const double *depth, const int64_t *faces, int64_t count,
                                   const double *view, int64_t first, int64_t last, double *nearest,
                                   double *facing_away);
SKN_EXPORT void SKN(raster_resolve)(const double *screen, const int64_t *faces, const int64_t *face,
                                    const int64_t *pixel, const double *view, int64_t first, int64_t last,
                                    double *barycentric, double *along_x, double *along_y);

/* taps.c */
SKN_EXPORT void SKN(lit_share)(const float *depths, int64_t width, int64_t height, const double *uv,
                               const double *receiver, const double *radius, const double *rise, const double *disk,
                               int64_t taps, int64_t first, int64_t last, double *lit);
SKN_EXPORT void SKN(mean_thickness)(const double *depths, int64_t width, int64_t height, const double *uv,
                                    const double *receiver, const double *radius, const double *disk, int64_t taps,
                                    int64_t first, int64_t last, double *thickness);

/* fetch.c */
SKN_EXPORT void SKN(fetch_texture)(const float *texels, int64_t channels, const int64_t *sizes, int64_t levels,
                                   const double *u, const double *v, const double *level, int64_t count,
                                   int64_t first, int64_t last, double *values);
SKN_EXPORT void SKN(fetch_panorama)(const float *images, const int64_t *size, const int64_t *index, const double *u,
                                    const double *v, int64_t count, int64_t first, int64_t last, double *values);
SKN_EXPORT void SKN(fetch_table)(const float *table, int64_t height, int64_t width, const double *u, int64_t columns,
                                 const double *v, int64_t count, int64_t first, int64_t last, double *values);

/* mips.c */
SKN_EXPORT void SKN(halve_image)(const float *image, int64_t width, int64_t height, int64_t channels, int64_t first,
                                 int64_t last, float *result);

/* interpolate.c */
SKN_EXPORT void SKN(interpolate)(const double *values, int64_t columns, const int64_t *faces, const int64_t *face,
                                 const double *weights, int64_t count, int64_t first, int64_t last,
                                 double *results);

#endif
