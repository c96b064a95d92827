// Generated from skinshade.params by `python -m skinshade.codegen`.

struct SkinBlock
{
    deep_scatter_sigma_per_mm : vec4<f32>, // 0..50 1/mm. Decay of light that comes through; 0: 1.2/rms radius.
    deep_scatter_tint : vec4<f32>, // 0..1. Colour of light that comes through, beside its texture.
    scatter_scale : f32, // 0.05..20. Multiplies every length of the diffusion profile.
    normal_strength : f32, // 0..2. Multiplies the slopes of the normal map.
    gloss : f32, // 0..1. Of the first specular lobe: its power is 2^(13 gloss).
    reflectance : f32, // 0..0.2. Specular at normal incidence; .028 is skin's index 1.4.
    shadow_filter_width_mm : f32, // 1..100 mm. Width across the light of the wide shadow filter, the same everywhere.
    shadow_sharpening : f32, // 1..100. How many times narrower than the filter the cast shadow's edge is.
    deep_scatter_strength : f32, // 0..10. Multiplies light that comes through the body; 1 is physical.
    deep_scatter_offset_mm : f32, // 0..10 mm. How far inwards the point moves before its depth is compared.
    deep_scatter_filter_mm : f32, // 0..20 mm. Radius of the disk over which thickness is averaged.
    classic_deep_scatter_radius_mm : f32, // 0.1..100 mm. Of the falloff of 2014, used by classic shading alone.
};

struct ScatterBlock
{
    albedo : vec4<f32>, // 0.0001..0.9999. Diffuse albedo of the profile.
    rms_radius_mm : vec4<f32>, // 0..10000 mm. Root of the profile's mean square radius.
    sigma_per_mm : vec4<f32>, // 0..1e+06 1/mm. Decay of light that comes through.
    blend_red : vec4<f32>, // 0..1. Red's weights of the sharp, narrow and wide normal.
    blend_green : vec4<f32>, // 0..1. Green's weights of the sharp, narrow and wide normal.
    blend_blue : vec4<f32>, // 0..1. Blue's weights of the sharp, narrow and wide normal.
    ring_axes : vec4<f32>, // -1e+06..1e+06. Axes of the ring's table, rows √(1/mm): low and 1/(high − low) of the columns, then of the rows.
    sphere_axes : vec4<f32>, // -1e+06..1e+06. Axes of the sphere's table, rows √(1/mm): low and 1/(high − low) of the columns, then of the rows.
    transfer_axes : vec4<f32>, // -1e+06..1e+06. Axes of T(k), columns √(rad/mm): low and 1/(high − low) of the columns, then of the rows.
    shadow_axes : vec4<f32>, // -1e+06..1e+06. Axes of the shadow table, rows 1/mm: low and 1/(high − low) of the columns, then of the rows.
    classic_axes : vec4<f32>, // -1e+06..1e+06. Axes of 2014's curvature table, rows 1/mm: low and 1/(high − low) of the columns, then of the rows.
    classic_shadow_axes : vec4<f32>, // -1e+06..1e+06. Axes of 2014's shadow table, rows 1/mm: low and 1/(high − low) of the columns, then of the rows.
    normal_sigmas_mm : vec2<f32>, // 0..10000 mm. Blur of the narrow and the wide normal.
};
