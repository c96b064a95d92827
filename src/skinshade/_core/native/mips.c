/* Levels of a mip-mapped texture: averages of 2x2 texels. NumPy twin: _halved of
 * skinshade/rendering/prepare/mips.py, with the same order of operations, so that the results have the same bytes. */
#include "rows.h"

/* Writes `count` texels of a row. `step` is the distance of the second column: 0 if the image is one texel wide. */
SKN_INLINE void halve_row(const float *upper, const float *lower, int64_t channels, int64_t step, int64_t count,
                          float *result)
{
    for (int64_t i = 0; i < count; i++) {
        for (int64_t c = 0; c < channels; c++) {
            const int64_t left = 2 * channels * i + c, right = left + step;
            const float first = (upper[left] + lower[left]) * 0.5f;
            const float second = (upper[right] + lower[right]) * 0.5f;
            result[channels * i + c] = (first + second) * 0.5f;
        }
    }
}

/* Writes rows [first, last) of an image of half the size. An odd last row or column is dropped; a side of one texel
 * stays. The mean of a finite number below 1.7e38 and itself is this number. */
void SKN(halve_image)(const float *image, int64_t width, int64_t height, int64_t channels, int64_t first, int64_t last,
                      float *result)
{
    const int64_t stride = width * channels, count = width > 1 ? width / 2 : 1;
    const int64_t step = width > 1 ? channels : 0;
    for (int64_t row = first; row < last; row++) {
        const float *upper = image + 2 * row * stride, *lower = height > 1 ? upper + stride : upper;
        float *out = result + row * count * channels;
        switch (channels) {
        case 2:
            halve_row(upper, lower, 2, step, count, out);
            break;
        case 3:
            halve_row(upper, lower, 3, step, count, out);
            break;
        case 4:
            halve_row(upper, lower, 4, step, count, out);
            break;
        default:
            halve_row(upper, lower, channels, step, count, out);
        }
    }
}
