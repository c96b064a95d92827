// Generated from skinshade.params by `python -m skinshade.codegen`.

struct SkinBlock
{
    vec4 deep_scatter_sigma_per_mm; // 0..50 1/mm. Decay of light that comes through; 0: 1.2/rms radius.
    vec4 deep_scatter_tint; // 0..1. Colour of light that comes through, beside its texture.
    float scatter_scale; // 0.05..20. Multiplies every length of the diffusion profile.
    float normal_strength; // 0..2. Multiplies the slopes of the normal map.
    float gloss; // 0..1. Of the first specular lobe: its power is 2^(13 gloss).
    float reflectance; // 0..0.2. Specular at normal incidence; .028 is skin's index 1.4.
    float shadow_filter_width_mm; // 1..100 mm. Width across the light of the wide shadow filter, the same everywhere.
    float shadow_sharpening; // 1..100. How many times narrower than the filter the cast shadow's edge is.
    float deep_scatter_strength; // 0..10. Multiplies light that comes through the body; 1 is physical.
    float deep_scatter_offset_mm; // 0..10 mm. How far inwards the point moves before its depth is compared.
    float deep_scatter_filter_mm; // 0..20 mm. Radius of the disk over which thickness is averaged.
    float classic_deep_scatter_radius_mm; // 0.1..100 mm. Of the falloff of 2014, used by classic shading alone.
};

struct ScatterBlock
{
    vec4 albedo; // 0.0001..0.9999. Diffuse albedo of the profile.
    vec4 rms_radius_mm; // 0..10000 mm. Root of the profile's mean square radius.
    vec4 sigma_per_mm; // 0..1e+06 1/mm. Decay of light that comes through.
    vec4 blend_red; // 0..1. Red's weights of the sharp, narrow and wide normal.
    vec4 blend_green; // 0..1. Green's weights of the sharp, narrow and wide normal.
    vec4 blend_blue; // 0..1. Blue's weights of the sharp, narrow and wide normal.
    vec4 ring_axes; // -1e+06..1e+06. Axes of the ring's table, rows √(1/mm): low and 1/(high − low) of the columns, then of the rows.
    vec4 sphere_axes; // -1e+06..1e+06. Axes of the sphere's table, rows √(1/mm): low and 1/(high − low) of the columns, then of the rows.
    vec4 transfer_axes; // -1e+06..1e+06. Axes of T(k), columns √(rad/mm): low and 1/(high − low) of the columns, then of the rows.
    vec4 shadow_axes; // -1e+06..1e+06. Axes of the shadow table, rows 1/mm: low and 1/(high − low) of the columns, then of the rows.
    vec4 classic_axes; // -1e+06..1e+06. Axes of 2014's curvature table, rows 1/mm: low and 1/(high − low) of the columns, then of the rows.
    vec4 classic_shadow_axes; // -1e+06..1e+06. Axes of 2014's shadow table, rows 1/mm: low and 1/(high − low) of the columns, then of the rows.
    vec2 normal_sigmas_mm; // 0..10000 mm. Blur of the narrow and the wide normal.
};
