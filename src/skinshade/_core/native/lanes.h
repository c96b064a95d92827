/* Four vertices at a time: vectors of four doubles by the vector extensions of GCC and Clang.
 *
 * The compiler maps them to AVX, to pairs of SSE or NEON registers, or to scalars; the results are the same bytes.
 */
#ifndef SKINSHADE_LANES_H
#define SKINSHADE_LANES_H

#include "rows.h"

#include <string.h>

#if defined(__AVX2__)
#include <immintrin.h>
#endif

#if defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define SKN_SHUFFLES
#endif
#endif

typedef double f64x2 __attribute__((vector_size(16)));
typedef double f64x4 __attribute__((vector_size(32)));
typedef int64_t i64x4 __attribute__((vector_size(32)));
typedef uint64_t u64x4 __attribute__((vector_size(32)));

typedef struct {
    f64x4 x, y, z;
} vec3x4;

SKN_INLINE f64x4 lanes_of(double value)
{
    return (f64x4){value, value, value, value};
}

SKN_INLINE f64x4 lanes_load(const double *from)
{
    f64x4 lanes;
    memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

SKN_INLINE void lanes_store(double *to, f64x4 lanes)
{
    memcpy(to, &lanes, sizeof lanes);
}

/* Intrinsics are used where compilers do not find the instruction; they compute the same as the other lines. */
SKN_INLINE f64x4 lanes_select(i64x4 mask, f64x4 yes, f64x4 no)
{
    return (f64x4)((mask & (i64x4)yes) | (~mask & (i64x4)no));
}

SKN_INLINE f64x4 lanes_max(f64x4 a, f64x4 b)
{
#if defined(__AVX2__)
    return (f64x4)_mm256_max_pd((__m256d)a, (__m256d)b);
#else
    return lanes_select(a > b, a, b);
#endif
}

SKN_INLINE f64x4 lanes_min(f64x4 a, f64x4 b)
{
#if defined(__AVX2__)
    return (f64x4)_mm256_min_pd((__m256d)a, (__m256d)b);
#else
    return lanes_select(a < b, a, b);
#endif
}

SKN_INLINE f64x4 lanes_absolute(f64x4 a)
{
    const i64x4 all_but_sign = {INT64_MAX, INT64_MAX, INT64_MAX, INT64_MAX};
    return (f64x4)((i64x4)a & all_but_sign);
}

SKN_INLINE f64x4 lanes_sqrt(f64x4 a)
{
#if defined(__AVX2__)
    return (f64x4)_mm256_sqrt_pd((__m256d)a);
#else
    return (f64x4){sqrt(a[0]), sqrt(a[1]), sqrt(a[2]), sqrt(a[3])};
#endif
}

SKN_INLINE f64x4 lanes_dot(vec3x4 a, vec3x4 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

SKN_INLINE vec3x4 lanes_minus(vec3x4 a, vec3x4 b)
{
    return (vec3x4){a.x - b.x, a.y - b.y, a.z - b.z};
}

SKN_INLINE vec3x4 lanes_cross(vec3x4 a, vec3x4 b)
{
    return (vec3x4){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/* Returns unit vectors; zero vectors stay zero. */
SKN_INLINE vec3x4 lanes_unit(vec3x4 a)
{
    const f64x4 length = lanes_sqrt(lanes_dot(a, a));
    const f64x4 scale = lanes_select(length > lanes_of(0.0), length, lanes_of(1.0));
    return (vec3x4){a.x / scale, a.y / scale, a.z / scale};
}

/* Returns two neighbouring numbers of four rows. */
SKN_INLINE void lanes_pair(const double *a, const double *b, const double *c, const double *d, f64x4 *one, f64x4 *two)
{
#ifdef SKN_SHUFFLES
    f64x2 from_a, from_b, from_c, from_d;
    memcpy(&from_a, a, sizeof from_a), memcpy(&from_b, b, sizeof from_b);
    memcpy(&from_c, c, sizeof from_c), memcpy(&from_d, d, sizeof from_d);
    const f64x4 ac = __builtin_shufflevector(from_a, from_c, 0, 1, 2, 3);
    const f64x4 bd = __builtin_shufflevector(from_b, from_d, 0, 1, 2, 3);
    *one = __builtin_shufflevector(ac, bd, 0, 4, 2, 6);
    *two = __builtin_shufflevector(ac, bd, 1, 5, 3, 7);
#else
    *one = (f64x4){a[0], b[0], c[0], d[0]};
    *two = (f64x4){a[1], b[1], c[1], d[1]};
#endif
}

/* Returns four rows of three numbers. */
SKN_INLINE vec3x4 lanes_rows(const double *rows, size_t a, size_t b, size_t c, size_t d)
{
    const double *at_a = rows + 3 * a, *at_b = rows + 3 * b, *at_c = rows + 3 * c, *at_d = rows + 3 * d;
    vec3x4 result;
    lanes_pair(at_a, at_b, at_c, at_d, &result.x, &result.y);
    result.z = (f64x4){at_a[2], at_b[2], at_c[2], at_d[2]};
    return result;
}

/* Two unit vectors that form a frame with unit normals [Duff2017]. */
SKN_INLINE void lanes_frame(vec3x4 n, vec3x4 *u, vec3x4 *v)
{
    const u64x4 sign_bit = {1ull << 63, 1ull << 63, 1ull << 63, 1ull << 63};
    const f64x4 one = lanes_of(1.0);
    const f64x4 sign = (f64x4)(((u64x4)n.z & sign_bit) | (u64x4)one);
    const f64x4 a = -one / (sign + n.z);
    const f64x4 b = n.x * n.y * a;
    *u = (vec3x4){one + sign * n.x * n.x * a, sign * b, -sign * n.x};
    *v = (vec3x4){b, sign + n.y * n.y * a, -n.y};
}

/* Returns the products of the low halves of numbers. */
SKN_INLINE u64x4 lanes_product(u64x4 a, u64x4 b)
{
#if defined(__AVX2__)
    return (u64x4)_mm256_mul_epu32((__m256i)a, (__m256i)b);
#else
    return (a & 0xFFFFFFFFu) * (b & 0xFFFFFFFFu);
#endif
}

#endif
