/* Ranges of numbers and indices. NumPy twins: as_floats and as_faces of skinshade/_core/arrays.py. */
#include "rows.h"

enum { SPAN = 4096 };

/* Returns the first index at fault in a span that holds a fault. */
#define FIRST_AT_FAULT(fault)                       \
    for (int64_t i = begin; i < end; i++)           \
        if (fault)                                  \
            return i;

#define OUTSIDE(type, low, high)                                                   \
    {                                                                              \
        const type *v = (const type *)values;                                      \
        for (int64_t begin = first; begin < last; begin += SPAN) {                 \
            const int64_t end = begin + SPAN < last ? begin + SPAN : last;         \
            int32_t faults = 0;                                                    \
            for (int64_t i = begin; i < end; i++)                                  \
                faults |= !((v[i] >= (low)) & (v[i] <= (high)));                   \
            if (faults)                                                            \
                FIRST_AT_FAULT(!(v[i] >= (low) && v[i] <= (high)))                 \
        }                                                                          \
    }

/* Returns the index of the first number that is not finite or not in [low, high], or -1. */
int64_t SKN(first_outside)(const void *values, int32_t kind, int64_t first, int64_t last, double low, double high)
{
    const double least = low < -1.7976931348623157e308 ? -1.7976931348623157e308 : low;
    const double greatest = high > 1.7976931348623157e308 ? 1.7976931348623157e308 : high;
    if (kind == SKN_F32)
        OUTSIDE(float, least, greatest)
    else
        OUTSIDE(double, least, greatest)
    return -1;
}

/* Returns the position of the first index that is not in 0..limit - 1, or -1. */
int64_t SKN(first_bad_index)(const void *values, int32_t kind, int64_t first, int64_t last, int64_t limit)
{
    if (kind == SKN_I32)
        OUTSIDE(int32_t, 0, limit - 1)
    else
        OUTSIDE(int64_t, 0, limit - 1)
    return -1;
}
