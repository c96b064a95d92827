/* Trilinear interpolation in a periodic volume.
 * NumPy twin: sample_smooth of skinshade/heads/maps/noise.py, with the same order of operations as SciPy's
 * map_coordinates, so that the results have the same bytes. */
#include "rows.h"

/* Writes the values of a volume of size^3 samples at points (rows of three float32) times `scale`. */
void SKN(sample_volume)(const float *volume, int64_t size, const float *points, int64_t first, int64_t last,
                        double scale, float *values)
{
    const float factor = (float)scale;
    const double period = (double)size;
    for (int64_t i = first; i < last; i++) {
        int64_t at[3][2];
        double weight[3][2];
        for (int axis = 0; axis < 3; axis++) {
            const float scaled = points[3 * i + axis] * factor;
            double position = scaled;
            position -= period * floor(position / period);
            const double low = floor(position);
            weight[axis][1] = position - low;
            weight[axis][0] = 1.0 - weight[axis][1];
            /* A position that is rounded to the period is the first sample. */
            at[axis][0] = low >= period ? 0 : (int64_t)low;
            at[axis][1] = at[axis][0] + 1 == size ? 0 : at[axis][0] + 1;
        }
        double sum = 0.0;
        for (int x = 0; x < 2; x++)
            for (int y = 0; y < 2; y++)
                for (int z = 0; z < 2; z++) {
                    const float sample = volume[(at[0][x] * size + at[1][y]) * size + at[2][z]];
                    sum += sample * weight[0][x] * weight[1][y] * weight[2][z];
                }
        values[i] = (float)sum;
    }
}
