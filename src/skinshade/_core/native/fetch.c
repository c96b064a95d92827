/* Bilinear and trilinear fetches from images and tables of float32, computed in float64. NumPy twins: Texture.sample of
 * skinshade/rendering/prepare/mips.py, bilinear of skinshade/shading/image_light.py, and Lut._bilinear of
 * skinshade/lut/table.py.
 *
 * Results have an array of `count` numbers for each channel, so that NumPy works on long rows; `count` is the number of
 * points of all ranges. */
#include "rows.h"

enum { MOST_CHANNELS = 4 };

/* Returns the index of a texel of a repeating image. `position` is a whole number. */
SKN_INLINE int64_t repeated(double position, int64_t count)
{
    if (SKN_LIKELY(position >= 0.0 && position < (double)count))
        return (int64_t)position;
    if (!(position > -4e18 && position < 4e18))
        return 0;
    const int64_t rest = (int64_t)position % count;
    return rest < 0 ? rest + count : rest;
}

SKN_INLINE void mix_four(const float *upper_left, const float *upper_right, const float *lower_left,
                         const float *lower_right, double fx, double fy, int64_t channels, double *result)
{
    for (int64_t c = 0; c < channels; c++) {
        const double upper = (double)upper_left[c] * (1.0 - fx) + (double)upper_right[c] * fx;
        const double lower = (double)lower_left[c] * (1.0 - fx) + (double)lower_right[c] * fx;
        result[c] = upper * (1.0 - fy) + lower * fy;
    }
}

SKN_INLINE void fetch_level(const float *texels, int64_t channels, const int64_t *size, double u, double v,
                            double *result)
{
    const int64_t start = size[0], width = size[1], height = size[2];
    const double x = u * (double)width - 0.5, y = v * (double)height - 0.5, left = floor(x), top = floor(y);
    const int64_t column = repeated(left, width), row = repeated(top, height);
    const int64_t next = column + 1 < width ? column + 1 : 0, next_row = row + 1 < height ? row + 1 : 0;
    const float *upper = texels + (start + row * width) * channels;
    const float *lower = texels + (start + next_row * width) * channels;
    mix_four(upper + column * channels, upper + next * channels, lower + column * channels, lower + next * channels,
             x - left, y - top, channels, result);
}

SKN_INLINE void fetch_texture(const float *texels, int64_t channels, const int64_t *sizes, int64_t levels,
                              const double *across, const double *down, const double *level, int64_t count,
                              int64_t first, int64_t last, double *values)
{
    const double top = (double)(levels - 1);
    for (int64_t i = first; i < last; i++) {
        const double least = level[i] > 0.0 ? level[i] : 0.0, bounded = least < top ? least : top;
        const int64_t low = (int64_t)bounded;
        const double share = bounded - (double)low, u = across[i], v = down[i];
        double value[MOST_CHANNELS], above[MOST_CHANNELS];
        fetch_level(texels, channels, sizes + 3 * low, u, v, value);
        if (share > 0.0) {
            fetch_level(texels, channels, sizes + 3 * (low + 1), u, v, above);
            for (int64_t c = 0; c < channels; c++)
                value[c] += share * (above[c] - value[c]);
        }
        for (int64_t c = 0; c < channels; c++)
            values[count * c + i] = value[c];
    }
}

/* Writes trilinear values of a repeating texture. `sizes` has the first texel, width and height of the levels. */
void SKN(fetch_texture)(const float *texels, int64_t channels, const int64_t *sizes, int64_t levels, const double *u,
                        const double *v, const double *level, int64_t count, int64_t first, int64_t last,
                        double *values)
{
    if (channels == 3)
        fetch_texture(texels, 3, sizes, levels, u, v, level, count, first, last, values);
    else if (channels == 4)
        fetch_texture(texels, 4, sizes, levels, u, v, level, count, first, last, values);
    else
        fetch_texture(texels, channels, sizes, levels, u, v, level, count, first, last, values);
}

/* Writes bilinear values of equirectangular images; u repeats, and v clamps. `size` has images, height and width. */
void SKN(fetch_panorama)(const float *images, const int64_t *size, const int64_t *index, const double *u,
                         const double *v, int64_t count, int64_t first, int64_t last, double *values)
{
    const int64_t height = size[1], width = size[2];
    for (int64_t i = first; i < last; i++) {
        double value[3];
        const double x = u[i] * (double)width - 0.5, left = floor(x);
        const double raw = v[i] * (double)height - 0.5, least = raw > 0.0 ? raw : 0.0;
        const double y = least < (double)(height - 1) ? least : (double)(height - 1);
        const int64_t row = (int64_t)y < height - 2 ? (int64_t)y : height - 2;
        const int64_t column = repeated(left, width), next = column + 1 < width ? column + 1 : 0;
        const float *upper = images + ((index[i] * height + row) * width) * 3, *lower = upper + 3 * width;
        mix_four(upper + 3 * column, upper + 3 * next, lower + 3 * column, lower + 3 * next, x - left,
                 y - (double)row, 3, value);
        for (int64_t c = 0; c < 3; c++)
            values[count * c + i] = value[c];
    }
}

/* Returns a coordinate 0..1 in texels from the first centre, and the index of the texel before it. */
SKN_INLINE double clamped(double coordinate, int64_t count, int64_t *before)
{
    const double raw = coordinate * (double)count - 0.5, least = raw > 0.0 ? raw : 0.0;
    const double at = least < (double)(count - 1) ? least : (double)(count - 1);
    *before = (int64_t)at < count - 2 ? (int64_t)at : count - 2;
    return at - (double)*before;
}

/* Writes bilinear values (3) of a table; `columns` is 3 if every channel has an array of u of its own, or 1. */
void SKN(fetch_table)(const float *table, int64_t height, int64_t width, const double *u, int64_t columns,
                      const double *v, int64_t count, int64_t first, int64_t last, double *values)
{
    for (int64_t i = first; i < last; i++) {
        int64_t row, column = 0;
        const double fy = clamped(v[i], height, &row);
        double fx = 0.0;
        for (int64_t c = 0; c < 3; c++) {
            if (c < columns)
                fx = clamped(u[count * c + i], width, &column);
            const float *upper = table + (row * width + column) * 3 + c, *lower = upper + 3 * width;
            const double first_row = (double)upper[0] * (1.0 - fx) + (double)upper[3] * fx;
            const double second_row = (double)lower[0] * (1.0 - fx) + (double)lower[3] * fx;
            values[count * c + i] = first_row * (1.0 - fy) + second_row * fy;
        }
    }
}
