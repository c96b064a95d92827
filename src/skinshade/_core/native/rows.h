/* Rows of three numbers of any accepted type, and hints to the compiler. */
#ifndef SKINSHADE_ROWS_H
#define SKINSHADE_ROWS_H

#include "kernels.h"

#define SKN_INLINE static inline __attribute__((always_inline))
#define SKN_LIKELY(condition) __builtin_expect(!!(condition), 1)
#define SKN_PREFETCH(address) __builtin_prefetch(address)

/* Calls an always-inline function with the type of rows as a constant, so that its loop has no branch for it. */
#define SKN_WITH_FLOATS(kind, call_f32, call_f64) \
    do {                                          \
        if ((kind) == SKN_F32) {                  \
            call_f32;                             \
        } else {                                  \
            call_f64;                             \
        }                                         \
    } while (0)

SKN_INLINE void skn_row(const void *rows, int32_t kind, int64_t i, double row[3])
{
    if (kind == SKN_F32) {
        const float *at = (const float *)rows + 3 * i;
        row[0] = at[0], row[1] = at[1], row[2] = at[2];
    } else {
        const double *at = (const double *)rows + 3 * i;
        row[0] = at[0], row[1] = at[1], row[2] = at[2];
    }
}

SKN_INLINE void skn_face(const void *faces, int32_t kind, int64_t i, int64_t face[3])
{
    if (kind == SKN_I32) {
        const uint32_t *at = (const uint32_t *)faces + 3 * i;
        face[0] = at[0], face[1] = at[1], face[2] = at[2];
    } else {
        const int64_t *at = (const int64_t *)faces + 3 * i;
        face[0] = at[0], face[1] = at[1], face[2] = at[2];
    }
}

/* Scales a vector to length 1; a zero vector stays zero. */
SKN_INLINE void skn_unit(double v[3])
{
    const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    const double scale = length > 0.0 ? length : 1.0;
    v[0] /= scale, v[1] /= scale, v[2] /= scale;
}

/* Two unit vectors that form a frame with a unit normal [Duff2017]. */
SKN_INLINE void skn_frame(const double n[3], double u[3], double v[3])
{
    const double sign = copysign(1.0, n[2]), a = -1.0 / (sign + n[2]), b = n[0] * n[1] * a;
    u[0] = 1.0 + sign * n[0] * n[0] * a, u[1] = sign * b, u[2] = -sign * n[0];
    v[0] = b, v[1] = sign + n[1] * n[1] * a, v[2] = -n[1];
}

#endif
