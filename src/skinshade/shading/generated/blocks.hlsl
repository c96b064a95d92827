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

struct EyeBlock
{
    float4 iris_uv; // -16..16. Centre of the iris in its map, its radius there, and turns counterclockwise.
    float sclera_radius_mm; // 8..16 mm. Radius of the sclera.
    float limbus_radius_mm; // 4..8 mm. Radius of the limbus, where cornea and sclera meet; half the white-to-white distance.
    float limbus_width_mm; // 0.1..1.5 mm. Half the width of the blend between cornea and sclera.
    float cornea_radius_mm; // 6..10 mm. Radius of curvature at the apex of the cornea.
    float cornea_asphericity; // -0.8..0.3. Asphericity Q of the cornea; 0 for a sphere.
    float refraction_index; // 1..1.6. Index of the one refracting surface that replaces both surfaces of the cornea.
    float tear_index; // 1..1.6. Index of tears, which reflect.
    float aqueous_index; // 1..1.6. Index of the aqueous humour.
    float iris_depth_mm; // 1..6 mm. Depth of the iris behind the apex of the cornea, on the axis.
    float iris_slope; // -0.3..0.3. Fall of the iris with the distance from the axis; 0 for a plane.
    float iris_radius_mm; // 3..8 mm. Outer radius of the iris.
    float pupil_radius_mm; // 0.5..4.5 mm. Radius of the pupil.
    float pupil_in_map; // 0..0.9. Radius of the pupil in the map of the iris, over that of the iris.
    float virtual_cornea; // 0..1. 1 for a mesh without a bulge: rays meet the cornea itself.
    float cornea_roughness_deg; // 0.1..10 deg. Angle by which the cornea widens a reflection.
    float sclera_roughness_deg; // 1..20 deg. Angle by which the sclera widens a reflection.
    float sclera_normal_strength; // 0..2. Factor on the slopes of the normal map of the sclera.
    float meniscus_height_mm; // 0..0.7 mm. Height of the tears on the margins of the lids.
    float iris_height_mm; // 0..0.3 mm. Height of the relief of the iris at 1 in its map.
};

struct EyePlaceBlock
{
    float4 eye_x; // -1e+30..1e+30. Row x of the matrix from the world to mm of the eye.
    float4 eye_y; // -1e+30..1e+30. Row y of the matrix from the world to mm of the eye.
    float4 eye_z; // -1e+30..1e+30. Row z of the matrix from the world to mm of the eye.
    float4 lid_upper; // -100..100. Plane n, D (mm) that the upper lid lies beyond.
    float4 lid_lower; // -100..100. Plane n, D (mm) that the lower lid lies beyond.
    float4 lamp_axes; // -1e+06..1e+06. Axes of the table of a lamp: low and 1/(high − low) of the columns, mm, then of the rows.
    float4 surroundings_axes; // -1e+06..1e+06. Axes of the table of the surroundings: low and 1/(high − low) of the columns, mm, then of the rows.
    float4 lid_radiance; // 0..1e+30. Radiance of the inner sides of the lids.
    float lid_radius_mm; // 8..30 mm. Radius of the ball whose surface is the outer side of the lids.
};
