// Generated from skinshade.params by `python -m codegen`.

struct SkinBlock
{
    deep_scatter_sigma_per_mm : vec4<f32>, // 0..50 1/mm. Decay of light that passes through the body; 0 means 1.2/rms radius.
    deep_scatter_tint : vec4<f32>, // 0..1. Colour of light that passes through the body, multiplied by the colour of its map.
    scatter_scale : f32, // 0.05..20. Factor on every length of the diffusion profile.
    normal_strength : f32, // 0..2. Factor on the slopes of the normal map.
    gloss : f32, // 0..1. Gloss of the first specular lobe, whose Blinn-Phong power is 2^(13 gloss).
    reflectance : f32, // 0..0.2. Specular reflectance at normal incidence; .028 for skin, whose refractive index is 1.4.
    shadow_filter_width_mm : f32, // 1..100 mm. Width of the wide shadow filter, across the light.
    shadow_sharpening : f32, // 1..100. Width of the wide shadow filter, divided by the width of the edge of a cast shadow.
    deep_scatter_strength : f32, // 0..10. Factor on light that passes through the body; 1 is physically correct.
    deep_scatter_offset_mm : f32, // 0..10 mm. Distance by which a point moves inwards before its depth is compared.
    deep_scatter_filter_mm : f32, // 0..20 mm. Radius of the disk over which thickness is averaged.
    classic_deep_scatter_radius_mm : f32, // 0.1..100 mm. Radius of the falloff of deep scatter in classic shading.
};

struct ScatterBlock
{
    albedo : vec4<f32>, // 0.0001..0.9999. Diffuse albedo of the profile.
    rms_radius_mm : vec4<f32>, // 0..10000 mm. Root mean square radius of the profile.
    sigma_per_mm : vec4<f32>, // 0..1e+06 1/mm. Decay of light that passes through the body.
    blend_red : vec4<f32>, // 0..1. Weights of the sharp, narrow and wide normal for red light.
    blend_green : vec4<f32>, // 0..1. Weights of the sharp, narrow and wide normal for green light.
    blend_blue : vec4<f32>, // 0..1. Weights of the sharp, narrow and wide normal for blue light.
    ring_axes : vec4<f32>, // -1e+06..1e+06. Axes of the ring's table, rows √(1/mm): low and 1/(high − low) of the columns, then of the rows.
    sphere_axes : vec4<f32>, // -1e+06..1e+06. Axes of the sphere's table, rows √(1/mm): low and 1/(high − low) of the columns, then of the rows.
    transfer_axes : vec4<f32>, // -1e+06..1e+06. Axes of T(k), columns √(rad/mm): low and 1/(high − low) of the columns, then of the rows.
    shadow_axes : vec4<f32>, // -1e+06..1e+06. Axes of the shadow table, rows 1/mm: low and 1/(high − low) of the columns, then of the rows.
    classic_axes : vec4<f32>, // -1e+06..1e+06. Axes of the curvature table of 2014, rows 1/mm: low and 1/(high − low) of the columns, then of the rows.
    classic_shadow_axes : vec4<f32>, // -1e+06..1e+06. Axes of the shadow table of 2014, rows 1/mm: low and 1/(high − low) of the columns, then of the rows.
    coat_axes : vec4<f32>, // -1e+06..1e+06. Axes of the coat's table, columns √(N·V), rows gloss: low and 1/(high − low) of the columns, then of the rows.
    normal_sigmas_mm : vec2<f32>, // 0..10000 mm. Standard deviations of the narrow and the wide blur of the normal map.
    coat_reflectance : f32, // 0..0.2. Reflectance at normal incidence that the coat's table was built for.
};
