/* Eight floats at a time: the boxes of the hierarchy of bvh.c.
 *
 * Intrinsics are used where compilers do not find the instruction; they compute the same as the other lines. */
#ifndef SKINSHADE_LANES_F32_H
#define SKINSHADE_LANES_F32_H

#include "lanes.h"

#if defined(__SSE4_1__)
#include <smmintrin.h>
#endif

typedef float f32x4 __attribute__((vector_size(16)));
typedef float f32x8 __attribute__((vector_size(32)));
typedef int32_t i32x8 __attribute__((vector_size(32)));

SKN_INLINE f32x8 octet_of(float value)
{
    return (f32x8){value, value, value, value, value, value, value, value};
}

SKN_INLINE f32x8 octet_load(const float *from)
{
    f32x8 octet;
    memcpy(&octet, from, sizeof octet);
    return octet;
}

SKN_INLINE void octet_store(float *to, f32x8 octet)
{
    memcpy(to, &octet, sizeof octet);
}

#if defined(__SSE4_1__) && !defined(__AVX2__)
/* Both halves of eight floats. */
typedef union {
    f32x8 whole;
    __m128 half[2];
} octet_halves;
#endif

SKN_INLINE f32x8 octet_min(f32x8 a, f32x8 b)
{
#if defined(__AVX2__)
    return (f32x8)_mm256_min_ps((__m256)a, (__m256)b);
#elif defined(__SSE4_1__)
    octet_halves one = {.whole = a}, other = {.whole = b};
    one.half[0] = _mm_min_ps(one.half[0], other.half[0]);
    one.half[1] = _mm_min_ps(one.half[1], other.half[1]);
    return one.whole;
#else
    const i32x8 mask = a < b;
    return (f32x8)((mask & (i32x8)a) | (~mask & (i32x8)b));
#endif
}

SKN_INLINE f32x8 octet_max(f32x8 a, f32x8 b)
{
#if defined(__AVX2__)
    return (f32x8)_mm256_max_ps((__m256)a, (__m256)b);
#elif defined(__SSE4_1__)
    octet_halves one = {.whole = a}, other = {.whole = b};
    one.half[0] = _mm_max_ps(one.half[0], other.half[0]);
    one.half[1] = _mm_max_ps(one.half[1], other.half[1]);
    return one.whole;
#else
    const i32x8 mask = a > b;
    return (f32x8)((mask & (i32x8)a) | (~mask & (i32x8)b));
#endif
}

/* Returns eight bytes as floats. */
SKN_INLINE f32x8 octet_of_bytes(const uint8_t *from)
{
#if defined(__AVX2__)
    return (f32x8)_mm256_cvtepi32_ps(_mm256_cvtepu8_epi32(_mm_loadl_epi64((const __m128i *)from)));
#elif defined(__SSE4_1__)
    const __m128i bytes = _mm_loadl_epi64((const __m128i *)from);
    const octet_halves result = {.half = {_mm_cvtepi32_ps(_mm_cvtepu8_epi32(bytes)),
                                          _mm_cvtepi32_ps(_mm_cvtepu8_epi32(_mm_srli_si128(bytes, 4)))}};
    return result.whole;
#else
    f32x8 result;
    for (int lane = 0; lane < 8; lane++)
        result[lane] = (float)from[lane];
    return result;
#endif
}

/* Returns a bit for every lane in which a is at most b. */
SKN_INLINE uint32_t octet_at_most(f32x8 a, f32x8 b)
{
#if defined(__AVX2__)
    return (uint32_t)_mm256_movemask_ps(_mm256_cmp_ps((__m256)a, (__m256)b, _CMP_LE_OQ));
#elif defined(__SSE4_1__)
    const octet_halves one = {.whole = a}, other = {.whole = b};
    return (uint32_t)(_mm_movemask_ps(_mm_cmple_ps(one.half[0], other.half[0]))
                      | _mm_movemask_ps(_mm_cmple_ps(one.half[1], other.half[1])) << 4);
#else
    uint32_t bits = 0;
    for (int lane = 0; lane < 8; lane++)
        bits |= (uint32_t)(a[lane] <= b[lane]) << lane;
    return bits;
#endif
}

/* Exchanges the first and the last four lanes. */
SKN_INLINE f32x8 octet_swap(f32x8 a)
{
#if defined(SKN_SHUFFLES)
    return __builtin_shufflevector(a, a, 4, 5, 6, 7, 0, 1, 2, 3);
#else
    return (f32x8){a[4], a[5], a[6], a[7], a[0], a[1], a[2], a[3]};
#endif
}

#endif
