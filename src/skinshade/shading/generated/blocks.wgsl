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

struct EyeBlock
{
    iris_uv : vec4<f32>, // -16..16. Centre of the iris in its map, its radius there, and turns counterclockwise.
    sclera_radius_mm : f32, // 8..16 mm. Radius of the sclera.
    limbus_radius_mm : f32, // 4..8 mm. Radius of the limbus, where cornea and sclera meet; half the white-to-white distance.
    limbus_width_mm : f32, // 0.1..1.5 mm. Half the width of the blend between cornea and sclera.
    cornea_radius_mm : f32, // 6..10 mm. Radius of curvature at the apex of the cornea.
    cornea_asphericity : f32, // -0.8..0.3. Asphericity Q of the cornea; 0 for a sphere.
    refraction_index : f32, // 1..1.6. Index of the one refracting surface that replaces both surfaces of the cornea.
    tear_index : f32, // 1..1.6. Index of tears, which reflect.
    aqueous_index : f32, // 1..1.6. Index of the aqueous humour.
    iris_depth_mm : f32, // 1..6 mm. Depth of the iris behind the apex of the cornea, on the axis.
    iris_slope : f32, // -0.3..0.3. Fall of the iris with the distance from the axis; 0 for a plane.
    iris_radius_mm : f32, // 3..8 mm. Outer radius of the iris.
    pupil_radius_mm : f32, // 0.5..4.5 mm. Radius of the pupil.
    pupil_in_map : f32, // 0..0.9. Radius of the pupil in the map of the iris, over that of the iris.
    virtual_cornea : f32, // 0..1. 1 for a mesh without a bulge: rays meet the cornea itself.
    cornea_roughness_deg : f32, // 0.1..10 deg. Angle by which the cornea widens a reflection.
    sclera_roughness_deg : f32, // 1..20 deg. Angle by which the sclera widens a reflection.
    sclera_normal_strength : f32, // 0..2. Factor on the slopes of the normal map of the sclera.
    meniscus_height_mm : f32, // 0..0.7 mm. Height of the tears on the margins of the lids.
    iris_height_mm : f32, // 0..0.3 mm. Height of the relief of the iris at 1 in its map.
};

struct EyePlaceBlock
{
    eye_x : vec4<f32>, // -1e+30..1e+30. Row x of the matrix from the world to mm of the eye.
    eye_y : vec4<f32>, // -1e+30..1e+30. Row y of the matrix from the world to mm of the eye.
    eye_z : vec4<f32>, // -1e+30..1e+30. Row z of the matrix from the world to mm of the eye.
    lid_upper : vec4<f32>, // -100..100. Plane n, D (mm) that the upper lid lies beyond.
    lid_lower : vec4<f32>, // -100..100. Plane n, D (mm) that the lower lid lies beyond.
    lamp_axes : vec4<f32>, // -1e+06..1e+06. Axes of the table of a lamp: low and 1/(high − low) of the columns, mm, then of the rows.
    surroundings_axes : vec4<f32>, // -1e+06..1e+06. Axes of the table of the surroundings: low and 1/(high − low) of the columns, mm, then of the rows.
    lid_radiance : vec4<f32>, // 0..1e+30. Radiance of the inner sides of the lids.
    lid_radius_mm : f32, // 8..30 mm. Radius of the ball whose surface is the outer side of the lids.
};
