/* Ratios of longest edges in space to longest edges in UV. NumPy twin: skinshade/mesh/uv_scale.py.
 *
 * The twin takes the mean of logarithms. Here the factors of a block of faces are multiplied, so that the
 * logarithm of the product is taken once; their exponents are added apart, so that nothing overflows. */
#include "rows.h"

#include <string.h>

enum { FACES = 512 }; /* in a block; a product of so many factors in [1, 2) is finite */

/* Splits a positive number into a factor in [1, 2) and an exponent. */
SKN_INLINE double split(double value, int64_t *exponent)
{
    uint64_t bits;
    if (value < SKN_TINY)
        value *= 18446744073709551616.0, *exponent -= 64;
    memcpy(&bits, &value, sizeof bits);
    *exponent += (int64_t)(bits >> 52) - 1023;
    bits = (bits & 0x000FFFFFFFFFFFFFu) | 0x3FF0000000000000u;
    memcpy(&value, &bits, sizeof value);
    return value;
}

SKN_INLINE double greater(double a, double b)
{
    return a > b ? a : b;
}

SKN_INLINE void block_ratio(const void *points, int32_t kind, const double *uvs, const void *faces,
                            int32_t face_kind, int64_t first, int64_t last, double out[4])
{
    double space = 1.0, plane = 1.0;
    int64_t exponent = 0, minus = 0, usable = 0;
    for (int64_t i = first; i < last; i++) {
        int64_t face[3];
        double p[3][3], in_space = 0.0, in_plane = 0.0;
        skn_face(faces, face_kind, i, face);
        for (int corner = 0; corner < 3; corner++)
            skn_row(points, kind, face[corner], p[corner]);
        for (int corner = 0; corner < 3; corner++) {
            const int other = corner == 2 ? 0 : corner + 1;
            const double x = p[corner][0] - p[other][0], y = p[corner][1] - p[other][1];
            const double z = p[corner][2] - p[other][2];
            in_space = greater(x * x + y * y + z * z, in_space);
            const double *s = uvs + 2 * face[corner], *t = uvs + 2 * face[other];
            const double u = s[0] - t[0], v = s[1] - t[1];
            in_plane = greater(u * u + v * v, in_plane);
        }
        if (in_space > 0.0 && in_plane > 0.0 && in_plane < INFINITY) {
            space *= split(in_space, &exponent);
            plane *= split(in_plane, &minus);
            usable++;
        }
    }
    out[0] = space, out[1] = plane, out[2] = (double)(exponent - minus), out[3] = (double)usable;
}

/* Writes of blocks of 512 faces: the product of the factors of squared longest edges in space, the same in UV, the
 * difference of the sums of their exponents, and the number of faces that have an extent in both. */
void SKN(uv_ratios)(const void *points, int32_t kind, const double *uvs, const void *faces, int32_t face_kind,
                    int64_t count, int64_t first, int64_t last, double *products)
{
    for (int64_t block = first; block < last; block++) {
        const int64_t begin = block * FACES, end = begin + FACES < count ? begin + FACES : count;
        if (kind == SKN_F32)
            block_ratio(points, kind, uvs, faces, face_kind, begin, end, products + 4 * block);
        else if (face_kind == SKN_I64)
            block_ratio(points, SKN_F64, uvs, faces, SKN_I64, begin, end, products + 4 * block);
        else
            block_ratio(points, SKN_F64, uvs, faces, SKN_I32, begin, end, products + 4 * block);
    }
}
