// Curvature by the method of 2014 in one loop, as a baseline: the mean of the least and the greatest
// |change of normal| / |edge| over the edges of every vertex, then passes that replace the value of a vertex by the
// mean of its neighbours' values over the corners of the faces around it.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace {

struct Vector {
    float x, y, z;
};

float length(const Vector &a, const Vector &b)
{
    const float x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return std::sqrt(x * x + y * y + z * z);
}

}  // namespace

#if defined(_WIN32)
extern "C" __declspec(dllexport)
#else
extern "C"
#endif
void curvature_2014(const Vector *points, const Vector *normals, const std::uint32_t *faces, std::int64_t vertices,
                    std::int64_t count, int passes, float *curvature)
{
    std::vector<float> least(vertices, std::numeric_limits<float>::max()), greatest(vertices, 0.0f);
    for (std::int64_t i = 0; i < count; i++) {
        const std::uint32_t *face = faces + 3 * i;
        for (int corner = 0; corner < 3; corner++) {
            const std::uint32_t a = face[corner], b = face[corner == 2 ? 0 : corner + 1];
            const float edge = length(points[a], points[b]);
            if (edge > 0.0f) {
                const float ratio = length(normals[a], normals[b]) / edge;
                least[a] = std::min(least[a], ratio), least[b] = std::min(least[b], ratio);
                greatest[a] = std::max(greatest[a], ratio), greatest[b] = std::max(greatest[b], ratio);
            }
        }
    }
    for (std::int64_t i = 0; i < vertices; i++)
        curvature[i] = 0.5f * (std::min(least[i], greatest[i]) + greatest[i]);
    std::vector<float> sum(vertices);
    std::vector<std::uint32_t> uses(vertices);
    for (int pass = 0; pass < passes; pass++) {
        std::fill(sum.begin(), sum.end(), 0.0f);
        std::fill(uses.begin(), uses.end(), 0u);
        for (std::int64_t i = 0; i < count; i++) {
            const std::uint32_t a = faces[3 * i], b = faces[3 * i + 1], c = faces[3 * i + 2];
            sum[a] += curvature[b] + curvature[c], uses[a] += 2;
            sum[b] += curvature[c] + curvature[a], uses[b] += 2;
            sum[c] += curvature[a] + curvature[b], uses[c] += 2;
        }
        for (std::int64_t i = 0; i < vertices; i++)
            curvature[i] = uses[i] ? sum[i] / static_cast<float>(uses[i]) : curvature[i];
    }
}
