/* Identity of the library, and the instructions of this processor. Compiled once. */
#include "kernels.h"

#if defined(__x86_64__)
#include <cpuid.h>
#endif

#ifndef SKN_SOURCE_HASH
#error "compile with tools/native_library.py, which defines SKN_SOURCE_HASH"
#endif

/* Returns the hash of the sources, by which skinshade/_core/native.py recognizes a stale library. */
SKN_EXPORT const char *skn_source_hash(void)
{
    return SKN_SOURCE_HASH;
}

/* Returns 1 if processor and operating system have the instructions of x86-64-v3. */
SKN_EXPORT int32_t skn_has_v3(void)
{
#if defined(__x86_64__)
    enum { FMA = 1 << 12, MOVBE = 1 << 22, OSXSAVE = 1 << 27, AVX = 1 << 28, F16C = 1 << 29 };
    enum { BMI1 = 1 << 3, AVX2 = 1 << 5, BMI2 = 1 << 8, LZCNT = 1 << 5, YMM_STATE = 6 };
    const unsigned wanted = FMA | MOVBE | OSXSAVE | AVX | F16C, extended = BMI1 | AVX2 | BMI2;
    unsigned a, b, c, d, low, high;
    if (!__get_cpuid(1, &a, &b, &c, &d) || (c & wanted) != wanted)
        return 0;
    __asm__("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
    if ((low & YMM_STATE) != YMM_STATE)
        return 0;
    if (!__get_cpuid_count(7, 0, &a, &b, &c, &d) || (b & extended) != extended)
        return 0;
    return __get_cpuid(0x80000001u, &a, &b, &c, &d) && (c & LZCNT) != 0;
#else
    return 0;
#endif
}
