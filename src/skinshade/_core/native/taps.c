/* Disks of taps in depth maps. NumPy twins: lit_share of skinshade/shading/shadow.py and mean_thickness of
 * skinshade/shading/deep_scatter.py.
 *
 * Points are worked on in groups of POINTS, so that compilers use vectors. Lookups outside the map clamp to its edge. */
#include "rows.h"

enum { POINTS = 16 };

SKN_INLINE float within(float value, float low, float high)
{
    const float least = value > low ? value : low; /* NaN becomes the least */
    return least < high ? least : high;
}

/* Returns the greatest whole number up to a value of a few thousand. GCC has vectors for it, but not for floorf. */
SKN_INLINE int32_t whole(float value)
{
    const int32_t towards_zero = (int32_t)value;
    return towards_zero - ((float)towards_zero > value);
}

SKN_INLINE int32_t index_within(int32_t index, int32_t last)
{
    const int32_t least = index > 0 ? index : 0;
    return least < last ? least : last;
}

/* Adds the lit share of four texels, compared one by one and interpolated, at a tap of a group of points. */
SKN_INLINE void add_tap(const float *depths, int32_t width, int32_t height, const float point[7][POINTS], float right,
                        float down, float *sums)
{
    for (int k = 0; k < POINTS; k++) {
        const float x = within(point[0][k] + right * point[3][k], -1.0f, (float)width);
        const float y = within(point[1][k] + down * point[4][k], -1.0f, (float)height);
        const float depth = point[2][k] + right * point[5][k] + down * point[6][k];
        const int32_t left = whole(x), top = whole(y);
        const float fx = x - (float)left, fy = y - (float)top;
        const int32_t column = index_within(left, width - 1), next = index_within(left + 1, width - 1);
        const int32_t row = index_within(top, height - 1) * width;
        const int32_t next_row = index_within(top + 1, height - 1) * width;
        const float a = (float)(depths[row + column] >= depth), b = (float)(depths[row + next] >= depth);
        const float c = (float)(depths[next_row + column] >= depth), d = (float)(depths[next_row + next] >= depth);
        sums[k] += (a * (1.0f - fx) + b * fx) * (1.0f - fy) + (c * (1.0f - fx) + d * fx) * fy;
    }
}

/* Writes the share of a disk that no occluder hides, in float32. `disk` has the taps: right, down. */
void SKN(lit_share)(const float *depths, int64_t width, int64_t height, const double *uv, const double *receiver,
                    const double *radius, const double *rise, const double *disk, int64_t taps, int64_t first,
                    int64_t last, double *lit)
{
    for (int64_t start = first; start < last; start += POINTS) {
        float point[7][POINTS], sums[POINTS] = {0.0f};
        const int64_t count = last - start < POINTS ? last - start : POINTS;
        for (int64_t k = 0; k < POINTS; k++) {
            const int64_t i = start + (k < count ? k : 0);
            point[0][k] = (float)(uv[2 * i] * (double)width - 0.5);
            point[1][k] = (float)(uv[2 * i + 1] * (double)height - 0.5);
            point[2][k] = (float)receiver[i];
            point[3][k] = (float)(radius[2 * i] * (double)width);
            point[4][k] = (float)(radius[2 * i + 1] * (double)height);
            point[5][k] = (float)rise[2 * i], point[6][k] = (float)rise[2 * i + 1];
        }
        for (int64_t tap = 0; tap < taps; tap++)
            add_tap(depths, (int32_t)width, (int32_t)height, (const float(*)[POINTS])point, (float)disk[2 * tap],
                    (float)disk[2 * tap + 1], sums);
        for (int64_t k = 0; k < count; k++)
            lit[start + k] = (double)sums[k] / (double)taps;
    }
}

SKN_INLINE int64_t texel_of(double position, int64_t count)
{
    const double least = position > 0.0 ? position : 0.0; /* NaN becomes 0 */
    return least < (double)count ? (int64_t)least : count - 1;
}

/* Writes the mean of max(0, receiver - depth) over a disk of taps at the nearest texels. */
void SKN(mean_thickness)(const double *depths, int64_t width, int64_t height, const double *uv, const double *receiver,
                         const double *radius, const double *disk, int64_t taps, int64_t first, int64_t last,
                         double *thickness)
{
    for (int64_t i = first; i < last; i++) {
        const double u = uv[2 * i], v = uv[2 * i + 1], ru = radius[2 * i], rv = radius[2 * i + 1];
        double sum = 0.0;
        for (int64_t tap = 0; tap < taps; tap++) {
            const int64_t column = texel_of((u + disk[2 * tap] * ru) * (double)width, width);
            const int64_t row = texel_of((v + disk[2 * tap + 1] * rv) * (double)height, height);
            const double depth = receiver[i] - depths[row * width + column];
            sum += depth > 0.0 ? depth : 0.0;
        }
        thickness[i] = sum / (double)taps;
    }
}
