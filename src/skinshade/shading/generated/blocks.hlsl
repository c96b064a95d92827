// Generated from skinshade.params by `python -m codegen`.

struct SkinBlock
{
    float4 deep_scatter_sigma_per_mm; // 0..50 1/mm. Decay of light that passes through the body; 0 means 1.2/rms radius.
    float4 deep_scatter_tint; // 0..1. Colour of light that passes through the body, multiplied by the colour of its map.
    float scatter_scale; // 0.05..20. Factor on every length of the diffusion profile.
    float normal_strength; // 0..2. Factor on the slopes of the normal map.
    float gloss; // 0..1. Gloss of the first specular lobe, whose Blinn-Phong power is 2^(13 gloss).
    float reflectance; // 0..0.2. Specular reflectance at normal incidence; .028 for skin, whose refractive index is 1.4.
    float shadow_filter_width_mm; // 1..100 mm. Width of the wide shadow filter, across the light.
    float shadow_sharpening; // 1..100. Width of the wide shadow filter, divided by the width of the edge of a cast shadow.
    float deep_scatter_strength; // 0..10. Factor on light that passes through the body; 1 is physically correct.
    float deep_scatter_offset_mm; // 0..10 mm. Distance by which a point moves inwards before its depth is compared.
    float deep_scatter_filter_mm; // 0..20 mm. Radius of the disk over which thickness is averaged.
    float classic_deep_scatter_radius_mm; // 0.1..100 mm. Radius of the falloff of deep scatter in classic shading.
};

struct ScatterBlock
{
    float4 albedo; // 0.0001..0.9999. Diffuse albedo of the profile.
    float4 rms_radius_mm; // 0..10000 mm. Root mean square radius of the profile.
    float4 sigma_per_mm; // 0..1e+06 1/mm. Decay of light that passes through the body.
    float4 blend_red; // 0..1. Weights of the sharp, narrow and wide normal for red light.
    float4 blend_green; // 0..1. Weights of the sharp, narrow and wide normal for green light.
    float4 blend_blue; // 0..1. Weights of the sharp, narrow and wide normal for blue light.
    float4 ring_axes; // -1e+06..1e+06. Axes of the ring's table, rows √(1/mm): low and 1/(high − low) of the columns, then of the rows.
    float4 sphere_axes; // -1e+06..1e+06. Axes of the sphere's table, rows √(1/mm): low and 1/(high − low) of the columns, then of the rows.
    float4 transfer_axes; // -1e+06..1e+06. Axes of T(k), columns √(rad/mm): low and 1/(high − low) of the columns, then of the rows.
    float4 shadow_axes; // -1e+06..1e+06. Axes of the shadow table, rows 1/mm: low and 1/(high − low) of the columns, then of the rows.
    float4 classic_axes; // -1e+06..1e+06. Axes of the curvature table of 2014, rows 1/mm: low and 1/(high − low) of the columns, then of the rows.
    float4 classic_shadow_axes; // -1e+06..1e+06. Axes of the shadow table of 2014, rows 1/mm: low and 1/(high − low) of the columns, then of the rows.
    float4 coat_axes; // -1e+06..1e+06. Axes of the coat's table, columns √(N·V), rows gloss: low and 1/(high − low) of the columns, then of the rows.
    float2 normal_sigmas_mm; // 0..10000 mm. Standard deviations of the narrow and the wide blur of the normal map.
    float coat_reflectance; // 0..0.2. Reflectance at normal incidence that the coat's table was built for.
};
