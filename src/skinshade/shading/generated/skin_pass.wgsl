struct FrameBlock_std140_0
{
    @align(16) radiance_sh_0 : array<vec4<f32>, i32(9)>,
    @align(16) clip_x_0 : vec4<f32>,
    @align(16) clip_y_0 : vec4<f32>,
    @align(16) clip_z_0 : vec4<f32>,
    @align(16) clip_w_0 : vec4<f32>,
    @align(16) eye_mm_0 : vec4<f32>,
    @align(16) ray_across_0 : vec4<f32>,
    @align(16) ray_up_0 : vec4<f32>,
    @align(16) ray_ahead_0 : vec4<f32>,
    @align(16) background_0 : vec4<f32>,
    @align(16) footprint_0 : f32,
    @align(4) sample_weight_0 : f32,
    @align(8) uv_scale_mm_0 : f32,
    @align(4) environment_scale_0 : f32,
    @align(16) exposure_0 : f32,
};

@binding(2) @group(0) var<uniform> frame_block_0 : FrameBlock_std140_0;
@binding(18) @group(0) var footprint_sampler_0 : sampler;

@binding(17) @group(0) var map_sampler_0 : sampler;

@binding(15) @group(0) var specular_map_0 : texture_2d<f32>;

struct SkinBlock_std140_0
{
    @align(16) deep_scatter_sigma_per_mm_0 : vec4<f32>,
    @align(16) deep_scatter_tint_0 : vec4<f32>,
    @align(16) scatter_scale_0 : f32,
    @align(4) normal_strength_0 : f32,
    @align(8) gloss_0 : f32,
    @align(4) reflectance_0 : f32,
    @align(16) shadow_filter_width_mm_0 : f32,
    @align(4) shadow_sharpening_0 : f32,
    @align(8) deep_scatter_strength_0 : f32,
    @align(4) deep_scatter_offset_mm_0 : f32,
    @align(16) deep_scatter_filter_mm_0 : f32,
    @align(4) classic_deep_scatter_radius_mm_0 : f32,
};

@binding(0) @group(0) var<uniform> skin_block_0 : SkinBlock_std140_0;
@binding(13) @group(0) var albedo_map_0 : texture_2d<f32>;

@binding(16) @group(0) var tint_map_0 : texture_2d<f32>;

@binding(14) @group(0) var normal_map_0 : texture_2d<f32>;

struct ScatterBlock_std140_0
{
    @align(16) albedo_0 : vec4<f32>,
    @align(16) rms_radius_mm_0 : vec4<f32>,
    @align(16) sigma_per_mm_0 : vec4<f32>,
    @align(16) blend_red_0 : vec4<f32>,
    @align(16) blend_green_0 : vec4<f32>,
    @align(16) blend_blue_0 : vec4<f32>,
    @align(16) ring_axes_0 : vec4<f32>,
    @align(16) sphere_axes_0 : vec4<f32>,
    @align(16) transfer_axes_0 : vec4<f32>,
    @align(16) shadow_axes_0 : vec4<f32>,
    @align(16) classic_axes_0 : vec4<f32>,
    @align(16) classic_shadow_axes_0 : vec4<f32>,
    @align(16) coat_axes_0 : vec4<f32>,
    @align(16) normal_sigmas_mm_0 : vec2<f32>,
    @align(8) coat_reflectance_0 : f32,
};

@binding(1) @group(0) var<uniform> scatter_block_0 : ScatterBlock_std140_0;
struct LightBlock_std430_0
{
    @align(16) view_x_0 : vec4<f32>,
    @align(16) view_y_0 : vec4<f32>,
    @align(16) view_z_0 : vec4<f32>,
    @align(16) clip_x_1 : vec4<f32>,
    @align(16) clip_y_1 : vec4<f32>,
    @align(16) clip_w_1 : vec4<f32>,
    @align(16) direction_0 : vec4<f32>,
    @align(16) position_mm_0 : vec4<f32>,
    @align(16) irradiance_0 : vec4<f32>,
    @align(16) cone_cosines_0 : vec2<f32>,
    @align(8) depth_mm_0 : vec2<f32>,
    @align(16) near_0 : f32,
    @align(4) target_distance_mm_0 : f32,
    @align(8) blur_texels_0 : f32,
};

@binding(3) @group(0) var<storage, read> lights_0 : array<LightBlock_std430_0>;

@binding(23) @group(0) var moments_0 : texture_2d_array<f32>;

@binding(21) @group(0) var depth_sampler_0 : sampler;

@binding(4) @group(0) var<storage, read> taps_0 : array<vec2<f32>>;

@binding(22) @group(0) var depths_0 : texture_2d_array<f32>;

@binding(8) @group(0) var shadow_lut_0 : texture_2d<f32>;

@binding(12) @group(0) var lut_sampler_0 : sampler;

@binding(6) @group(0) var sphere_lut_0 : texture_2d<f32>;

@binding(5) @group(0) var ring_lut_0 : texture_2d<f32>;

@binding(7) @group(0) var transfer_lut_0 : texture_2d<f32>;

@binding(9) @group(0) var classic_lut_0 : texture_2d<f32>;

@binding(10) @group(0) var classic_shadow_lut_0 : texture_2d<f32>;

@binding(19) @group(0) var preconvolved_0 : texture_2d<f32>;

@binding(20) @group(0) var sky_sampler_0 : sampler;

@binding(11) @group(0) var coat_lut_0 : texture_2d<f32>;

@id(12) override SPECULAR_0 : i32 = i32(0);

@id(6) override SHADOW_FILTER_0 : i32 = i32(0);

@id(5) override ENVIRONMENT_0 : i32 = i32(1);

fn rsqrt_0( x_0 : f32) -> f32
{
    return 1.0f / sqrt(x_0);
}

@id(10) override SPOT_LIGHTS_0 : i32 = i32(1);

@id(3) override TAPS_0 : i32 = i32(8);

@id(4) override LIGHTS_0 : i32 = i32(1);

@id(11) override OPACITY_CUTOFF_0 : i32 = i32(0);

@id(14) override CONTACT_0 : i32 = i32(1);

@id(7) override FETCHES_0 : i32 = i32(3);

@id(8) override MULTISAMPLED_0 : i32 = i32(0);

struct Vertex_0
{
     v0_0 : vec4<f32>,
     v1_0 : vec4<f32>,
     v2_0 : vec4<f32>,
     v3_0 : vec4<f32>,
     v4_0 : vec4<f32>,
     v5_0 : vec4<f32>,
     v6_0 : vec4<f32>,
     v7_0 : vec4<f32>,
     v8_0 : vec4<f32>,
     v9_0 : vec4<f32>,
     v10_0 : vec4<f32>,
     v11_0 : vec4<f32>,
     v12_0 : vec4<f32>,
};

fn position_of_0( vertex_0 : Vertex_0) -> vec3<f32>
{
    return vec3<f32>(vertex_0.v0_0.x, vertex_0.v0_0.y, vertex_0.v0_0.z);
}

struct Fragment_0
{
    @invariant @builtin(position) clip_0 : vec4<f32>,
    @location(0) v0_1 : vec4<f32>,
    @location(1) v1_1 : vec4<f32>,
    @location(2) v2_1 : vec4<f32>,
    @location(3) v3_1 : vec4<f32>,
    @location(4) v4_1 : vec4<f32>,
    @location(5) v5_1 : vec4<f32>,
    @location(6) v6_1 : vec4<f32>,
    @location(7) v7_1 : vec4<f32>,
    @location(8) v8_1 : vec4<f32>,
    @location(9) v9_1 : vec4<f32>,
    @location(10) v10_1 : vec4<f32>,
    @location(11) v11_1 : vec4<f32>,
    @location(12) v12_1 : vec4<f32>,
};

fn fragment_of_0( vertex_1 : Vertex_0,  clip_1 : vec4<f32>) -> Fragment_0
{
    var fragment_0 : Fragment_0;
    fragment_0.clip_0 = clip_1;
    fragment_0.v0_1 = vertex_1.v0_0;
    fragment_0.v1_1 = vertex_1.v1_0;
    fragment_0.v2_1 = vertex_1.v2_0;
    fragment_0.v3_1 = vertex_1.v3_0;
    fragment_0.v4_1 = vertex_1.v4_0;
    fragment_0.v5_1 = vertex_1.v5_0;
    fragment_0.v6_1 = vertex_1.v6_0;
    fragment_0.v7_1 = vertex_1.v7_0;
    fragment_0.v8_1 = vertex_1.v8_0;
    fragment_0.v9_1 = vertex_1.v9_0;
    fragment_0.v10_1 = vertex_1.v10_0;
    fragment_0.v11_1 = vertex_1.v11_0;
    fragment_0.v12_1 = vertex_1.v12_0;
    return fragment_0;
}

struct vertexInput_0
{
    @location(0) v0_2 : vec4<f32>,
    @location(1) v1_2 : vec4<f32>,
    @location(2) v2_2 : vec4<f32>,
    @location(3) v3_2 : vec4<f32>,
    @location(4) v4_2 : vec4<f32>,
    @location(5) v5_2 : vec4<f32>,
    @location(6) v6_2 : vec4<f32>,
    @location(7) v7_2 : vec4<f32>,
    @location(8) v8_2 : vec4<f32>,
    @location(9) v9_2 : vec4<f32>,
    @location(10) v10_2 : vec4<f32>,
    @location(11) v11_2 : vec4<f32>,
    @location(12) v12_2 : vec4<f32>,
};

@vertex
fn vertex_main( _S1 : vertexInput_0) -> Fragment_0
{
    var _S2 : Vertex_0 = Vertex_0( _S1.v0_2, _S1.v1_2, _S1.v2_2, _S1.v3_2, _S1.v4_2, _S1.v5_2, _S1.v6_2, _S1.v7_2, _S1.v8_2, _S1.v9_2, _S1.v10_2, _S1.v11_2, _S1.v12_2 );
    var p_0 : vec4<f32> = vec4<f32>(position_of_0(_S2), 1.0f);
    return fragment_of_0(_S2, vec4<f32>(dot(frame_block_0.clip_x_0, p_0), dot(frame_block_0.clip_y_0, p_0), dot(frame_block_0.clip_z_0, p_0), dot(frame_block_0.clip_w_0, p_0)));
}

struct Attributes_0
{
     position_0 : vec3<f32>,
     normal_0 : vec3<f32>,
     tangent_0 : vec4<f32>,
     uv_0 : vec2<f32>,
     curvature_0 : f32,
     tensor_0 : mat3x3<f32>,
     diffused_normals_0 : mat3x3<f32>,
     diffused_curvature_0 : vec3<f32>,
     visibility_0 : vec3<f32>,
     through_0 : vec3<f32>,
     bounced_0 : vec3<f32>,
     sky_harmonics_0 : mat3x3<f32>,
     mesh_relief_0 : vec3<f32>,
};

fn attributes_of_0( fragment_1 : Fragment_0) -> Attributes_0
{
    var a_0 : Attributes_0;
    a_0.position_0 = vec3<f32>(fragment_1.v0_1.x, fragment_1.v0_1.y, fragment_1.v0_1.z);
    a_0.normal_0 = vec3<f32>(fragment_1.v0_1.w, fragment_1.v1_1.x, fragment_1.v1_1.y);
    a_0.tangent_0 = vec4<f32>(fragment_1.v1_1.z, fragment_1.v1_1.w, fragment_1.v2_1.x, fragment_1.v2_1.y);
    a_0.uv_0 = vec2<f32>(fragment_1.v2_1.z, fragment_1.v2_1.w);
    a_0.curvature_0 = fragment_1.v3_1.x;
    var _S3 : f32 = fragment_1.v3_1.z;
    var _S4 : f32 = fragment_1.v3_1.w;
    var _S5 : f32 = fragment_1.v4_1.y;
    a_0.tensor_0 = mat3x3<f32>(vec3<f32>(fragment_1.v3_1.y, _S3, _S4), vec3<f32>(_S3, fragment_1.v4_1.x, _S5), vec3<f32>(_S4, _S5, fragment_1.v4_1.z));
    a_0.diffused_normals_0 = mat3x3<f32>(vec3<f32>(fragment_1.v4_1.w, fragment_1.v5_1.x, fragment_1.v5_1.y), vec3<f32>(fragment_1.v5_1.z, fragment_1.v5_1.w, fragment_1.v6_1.x), vec3<f32>(fragment_1.v6_1.y, fragment_1.v6_1.z, fragment_1.v6_1.w));
    a_0.diffused_curvature_0 = vec3<f32>(fragment_1.v7_1.x, fragment_1.v7_1.y, fragment_1.v7_1.z);
    a_0.visibility_0 = vec3<f32>(fragment_1.v7_1.w, fragment_1.v8_1.x, fragment_1.v8_1.y);
    a_0.through_0 = vec3<f32>(fragment_1.v8_1.z, fragment_1.v8_1.w, fragment_1.v9_1.x);
    a_0.bounced_0 = vec3<f32>(fragment_1.v9_1.y, fragment_1.v9_1.z, fragment_1.v9_1.w);
    a_0.sky_harmonics_0 = mat3x3<f32>(vec3<f32>(fragment_1.v10_1.x, fragment_1.v10_1.y, fragment_1.v10_1.z), vec3<f32>(fragment_1.v10_1.w, fragment_1.v11_1.x, fragment_1.v11_1.y), vec3<f32>(fragment_1.v11_1.z, fragment_1.v11_1.w, fragment_1.v12_1.x));
    a_0.mesh_relief_0 = vec3<f32>(fragment_1.v12_1.y, fragment_1.v12_1.z, fragment_1.v12_1.w);
    return a_0;
}

fn skin_safe_length_0( v_0 : vec3<f32>) -> f32
{
    return sqrt(max(dot(v_0, v_0), 1.00000004581370497e-18f));
}

fn skin_unit_vectors_0( v_1 : vec3<f32>) -> vec3<f32>
{
    return v_1 / vec3<f32>(skin_safe_length_0(v_1));
}

@id(9) override MAPS_0 : i32 = i32(15);

fn map_size_0( map_0 : texture_2d<f32>) -> vec2<f32>
{
    var width_0 : u32;
    var height_0 : u32;
    {var dim = textureDimensions((map_0));((width_0)) = dim.x;((height_0)) = dim.y;};
    return vec2<f32>(f32(width_0), f32(height_0));
}

fn skin_map_level_0( map_extent_0 : vec2<f32>,  uv_along_x_0 : vec2<f32>,  uv_along_y_0 : vec2<f32>) -> f32
{
    var texels_x_0 : vec2<f32> = uv_along_x_0 * map_extent_0;
    var texels_y_0 : vec2<f32> = uv_along_y_0 * map_extent_0;
    var x_1 : f32 = dot(texels_x_0, texels_x_0);
    var y_0 : f32 = dot(texels_y_0, texels_y_0);
    return max(0.5f * log2(max(max(min(x_1, y_0), max(x_1, y_0) / 64.0f), 1.00000000317107685e-30f)), 0.0f);
}

fn map_color_0( map_1 : texture_2d<f32>,  bit_0 : i32,  uv_1 : vec2<f32>,  along_x_0 : vec2<f32>,  along_y_0 : vec2<f32>) -> vec4<f32>
{
    if(((MAPS_0 & (bit_0))) == i32(0))
    {
        const _S6 : vec3<i32> = vec3<i32>(i32(0), i32(0), i32(0));
        return (textureLoad((map_1), ((_S6)).xy, ((_S6)).z));
    }
    if(MULTISAMPLED_0 > i32(0))
    {
        return (textureSampleGrad((map_1), (footprint_sampler_0), (uv_1), (along_x_0), (along_y_0)));
    }
    return (textureSampleLevel((map_1), (map_sampler_0), (uv_1), (skin_map_level_0(map_size_0(map_1), along_x_0, along_y_0))));
}

fn skin_blur_level_0( sigma_mm_0 : f32,  uv_scale_mm_1 : f32,  map_size_1 : f32,  hardware_level_0 : f32) -> f32
{
    return max(hardware_level_0, log2(max(2.0f * sigma_mm_0 * map_size_1 / uv_scale_mm_1, 1.0f)));
}

fn skin_specular_power_0( gloss_1 : f32) -> f32
{
    return exp2(13.0f * gloss_1);
}

fn skin_gloss_of_relief_0( gloss_2 : f32,  normal_length_0 : f32) -> f32
{
    var clamped_length_0 : f32 = clamp(normal_length_0, 0.00100000004749745f, 1.0f);
    var power_0 : f32 = skin_specular_power_0(gloss_2);
    return log2(max(clamped_length_0 * power_0 / (clamped_length_0 + power_0 * (1.0f - clamped_length_0)), 1.0f)) / 13.0f;
}

struct Surface_0
{
     position_1 : vec3<f32>,
     view_0 : vec3<f32>,
     mesh_normal_0 : vec3<f32>,
     face_normal_0 : vec3<f32>,
     sharp_0 : vec3<f32>,
     blurred_0 : vec3<f32>,
     fetched_0 : mat3x3<f32>,
     tensor_1 : mat3x3<f32>,
     diffused_normals_1 : mat3x3<f32>,
     curvature_per_mm_0 : f32,
     gloss_3 : f32,
     reflectance_1 : f32,
     albedo_1 : vec3<f32>,
     tint_0 : vec3<f32>,
     diffused_curvature_per_mm_0 : vec3<f32>,
     mesh_relief_1 : vec3<f32>,
     visibility_1 : vec3<f32>,
     through_1 : vec3<f32>,
     bounced_1 : vec3<f32>,
     sky_harmonics_1 : mat3x3<f32>,
};

fn surface_of_0( a_1 : Attributes_0,  along_x_1 : vec2<f32>,  along_y_1 : vec2<f32>) -> Surface_0
{
    var s_0 : Surface_0;
    s_0.position_1 = a_1.position_0;
    s_0.view_0 = skin_unit_vectors_0(frame_block_0.eye_mm_0.xyz - a_1.position_0);
    var normal_1 : vec3<f32> = skin_unit_vectors_0(a_1.normal_0);
    s_0.mesh_normal_0 = normal_1;
    s_0.face_normal_0 = normal_1;
    s_0.curvature_per_mm_0 = a_1.curvature_0;
    s_0.tensor_1 = a_1.tensor_0;
    s_0.diffused_normals_1 = a_1.diffused_normals_0 * (1.0f / max(skin_safe_length_0(a_1.normal_0), 0.00100000004749745f));
    s_0.diffused_curvature_per_mm_0 = a_1.diffused_curvature_0;
    s_0.mesh_relief_1 = a_1.mesh_relief_0;
    s_0.visibility_1 = a_1.visibility_0;
    s_0.through_1 = a_1.through_0;
    s_0.bounced_1 = a_1.bounced_0;
    s_0.sky_harmonics_1 = a_1.sky_harmonics_0;
    var specular_texel_0 : vec4<f32> = map_color_0(specular_map_0, i32(2), a_1.uv_0, along_x_1, along_y_1);
    s_0.reflectance_1 = skin_block_0.reflectance_0 * specular_texel_0.x;
    s_0.gloss_3 = specular_texel_0.y;
    s_0.albedo_1 = map_color_0(albedo_map_0, i32(1), a_1.uv_0, along_x_1, along_y_1).xyz;
    s_0.tint_0 = map_color_0(tint_map_0, i32(4), a_1.uv_0, along_x_1, along_y_1).xyz;
    s_0.fetched_0 = mat3x3<f32>(normal_1, normal_1, normal_1);
    if(FETCHES_0 > i32(1))
    {
        var _S7 : vec3<f32> = a_1.tangent_0.xyz;
        var tangent_1 : vec3<f32> = skin_unit_vectors_0(_S7 - normal_1 * vec3<f32>(dot(_S7, normal_1)));
        var bitangent_0 : vec3<f32> = cross(normal_1, tangent_1) * vec3<f32>(f32((i32(sign((a_1.tangent_0.w))))));
        var size_0 : vec2<f32> = map_size_0(normal_map_0);
        var _S8 : f32 = max(size_0.x, size_0.y);
        var _S9 : f32 = skin_map_level_0(size_0, along_x_1, along_y_1);
        var sharp_1 : vec3<f32> = map_color_0(normal_map_0, i32(8), a_1.uv_0, along_x_1, along_y_1).xyz;
        s_0.fetched_0[i32(0)] = tangent_1 * vec3<f32>(sharp_1.x) + bitangent_0 * vec3<f32>(sharp_1.y) + normal_1 * vec3<f32>(sharp_1.z);
        var fetch_0 : i32 = i32(1);
        for(;;)
        {
            if(fetch_0 < FETCHES_0)
            {
            }
            else
            {
                break;
            }
            var sigma_mm_1 : f32;
            if(fetch_0 == i32(1))
            {
                sigma_mm_1 = scatter_block_0.normal_sigmas_mm_0.x;
            }
            else
            {
                sigma_mm_1 = scatter_block_0.normal_sigmas_mm_0.y;
            }
            var t_0 : vec3<f32> = (textureSampleLevel((normal_map_0), (map_sampler_0), (a_1.uv_0), (skin_blur_level_0(sigma_mm_1, frame_block_0.uv_scale_mm_0, _S8, _S9)))).xyz;
            s_0.fetched_0[fetch_0] = tangent_1 * vec3<f32>(t_0.x) + bitangent_0 * vec3<f32>(t_0.y) + normal_1 * vec3<f32>(t_0.z);
            fetch_0 = fetch_0 + i32(1);
        }
    }
    s_0.sharp_0 = skin_unit_vectors_0(s_0.fetched_0[i32(0)]);
    var _S10 : vec3<f32>;
    if(FETCHES_0 == i32(2))
    {
        _S10 = s_0.fetched_0[i32(1)];
    }
    else
    {
        _S10 = s_0.fetched_0[i32(2)];
    }
    s_0.blurred_0 = skin_unit_vectors_0(_S10);
    s_0.gloss_3 = skin_gloss_of_relief_0(s_0.gloss_3, skin_safe_length_0(s_0.fetched_0[i32(0)]));
    return s_0;
}

@id(2) override VIEW_0 : i32 = i32(0);

fn skin_linear_curve_0( x_2 : f32) -> f32
{
    var _S11 : f32;
    if(x_2 <= 0.04044999927282333f)
    {
        _S11 = x_2 / 12.92000007629394531f;
    }
    else
    {
        _S11 = pow((x_2 + 0.05499999970197678f) / 1.0549999475479126f, 2.40000009536743164f);
    }
    return _S11;
}

fn skin_linear_from_srgb_0( display_0 : vec3<f32>) -> vec3<f32>
{
    var x_3 : vec3<f32> = saturate(display_0);
    return vec3<f32>(skin_linear_curve_0(x_3.x), skin_linear_curve_0(x_3.y), skin_linear_curve_0(x_3.z));
}

fn curvature_colour_0( curvature_per_mm_1 : f32) -> vec3<f32>
{
    var share_0 : f32 = clamp(curvature_per_mm_1 / 0.20000000298023224f, -1.0f, 1.0f);
    var end_0 : vec3<f32>;
    if(share_0 > 0.0f)
    {
        end_0 = vec3<f32>(0.85000002384185791f, 0.20000000298023224f, 0.10000000149011612f);
    }
    else
    {
        end_0 = vec3<f32>(0.10000000149011612f, 0.30000001192092896f, 0.85000002384185791f);
    }
    var _S12 : vec3<f32> = vec3<f32>(0.92000001668930054f);
    return skin_linear_from_srgb_0(_S12 + (end_0 - _S12) * vec3<f32>(sqrt(abs(share_0))));
}

@id(0) override SHADING_0 : i32 = i32(2);

fn skin_classic_ambient_normals_0( sharp_2 : vec3<f32>,  blurred_1 : vec3<f32>) -> mat3x3<f32>
{
    return mat3x3<f32>(blurred_1, skin_unit_vectors_0(mix(sharp_2, blurred_1, vec3<f32>(0.30000001192092896f))), sharp_2);
}

fn blend_weights_0() -> mat3x3<f32>
{
    return mat3x3<f32>(scatter_block_0.blend_red_0.xyz, scatter_block_0.blend_green_0.xyz, scatter_block_0.blend_blue_0.xyz);
}

fn skin_weighted_sum_0( rows_0 : mat3x3<f32>,  weights_0 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(weights_0.x) * rows_0[i32(0)] + vec3<f32>(weights_0.y) * rows_0[i32(1)] + vec3<f32>(weights_0.z) * rows_0[i32(2)];
}

fn skin_blend_normals_0( fetched_1 : mat3x3<f32>,  blend_0 : mat3x3<f32>) -> mat3x3<f32>
{
    return mat3x3<f32>(skin_weighted_sum_0(fetched_1, blend_0[i32(0)]), skin_weighted_sum_0(fetched_1, blend_0[i32(1)]), skin_weighted_sum_0(fetched_1, blend_0[i32(2)]));
}

@id(1) override TIER_0 : i32 = i32(2);

fn skin_with_mesh_diffusion_0( from_texture_0 : vec3<f32>,  from_mesh_0 : vec3<f32>,  mesh_normal_1 : vec3<f32>) -> vec3<f32>
{
    return from_texture_0 + vec3<f32>(skin_safe_length_0(from_texture_0)) * (from_mesh_0 - mesh_normal_1);
}

fn skin_add_mesh_diffusion_0( from_texture_1 : mat3x3<f32>,  from_mesh_1 : mat3x3<f32>,  mesh_normal_2 : vec3<f32>) -> mat3x3<f32>
{
    return mat3x3<f32>(skin_with_mesh_diffusion_0(from_texture_1[i32(0)], from_mesh_1[i32(0)], mesh_normal_2), skin_with_mesh_diffusion_0(from_texture_1[i32(1)], from_mesh_1[i32(1)], mesh_normal_2), skin_with_mesh_diffusion_0(from_texture_1[i32(2)], from_mesh_1[i32(2)], mesh_normal_2));
}

fn skin_lengths_0( normals_0 : mat3x3<f32>) -> vec3<f32>
{
    return vec3<f32>(skin_safe_length_0(normals_0[i32(0)]), skin_safe_length_0(normals_0[i32(1)]), skin_safe_length_0(normals_0[i32(2)]));
}

struct Diffused_0
{
     normals_1 : mat3x3<f32>,
     with_mesh_0 : mat3x3<f32>,
     relief_length_0 : vec3<f32>,
};

fn diffused_surface_0( s_1 : Surface_0) -> Diffused_0
{
    var d_0 : Diffused_0;
    var _S13 : mat3x3<f32> = skin_blend_normals_0(s_1.fetched_0, blend_weights_0());
    d_0.normals_1 = _S13;
    d_0.with_mesh_0 = _S13;
    d_0.relief_length_0 = vec3<f32>(1.0f);
    if(TIER_0 == i32(2))
    {
        d_0.with_mesh_0 = skin_add_mesh_diffusion_0(d_0.normals_1, s_1.diffused_normals_1, s_1.mesh_normal_0);
        d_0.relief_length_0 = skin_lengths_0(d_0.normals_1) * s_1.mesh_relief_1;
    }
    return d_0;
}

fn skin_energy_gain_0( albedo_2 : vec3<f32>,  rms_radius_mm_1 : vec3<f32>,  curvature_per_mm_2 : vec3<f32>) -> vec3<f32>
{
    var scaled_curvature_0 : vec3<f32> = vec3<f32>(1.20000004768371582f) * rms_radius_mm_1 * max(curvature_per_mm_2, vec3<f32>(0.0f));
    var bound_0 : vec3<f32> = albedo_2 * scaled_curvature_0;
    var _S14 : vec3<f32> = vec3<f32>(1.0f);
    return _S14 + (_S14 - albedo_2) * scaled_curvature_0 / sqrt(_S14 + bound_0 * bound_0);
}

fn skin_shadow_receiver_0( position_mm_1 : vec3<f32>,  normal_2 : vec3<f32>,  to_light_0 : vec3<f32>,  curvature_per_mm_3 : f32) -> vec3<f32>
{
    var cosine_0 : f32 = dot(normal_2, to_light_0);
    return position_mm_1 + skin_unit_vectors_0(to_light_0 - normal_2 * vec3<f32>(cosine_0)) * vec3<f32>(min(max(- cosine_0, 0.0f) / max(curvature_per_mm_3, 0.00100000004749745f), 8.0f));
}

fn skin_light_coordinates_0( position_mm_2 : vec3<f32>,  view_1 : mat4x4<f32>,  projection_0 : mat4x4<f32>) -> vec4<f32>
{
    var p_1 : vec4<f32> = vec4<f32>(position_mm_2, 1.0f);
    var _S15 : f32 = dot(view_1[i32(2)], p_1);
    var in_view_0 : vec4<f32> = vec4<f32>(dot(view_1[i32(0)], p_1), dot(view_1[i32(1)], p_1), _S15, 1.0f);
    var w_0 : f32 = dot(projection_0[i32(3)], in_view_0);
    var w_1 : f32;
    if((abs(w_0)) < 9.99999971718068537e-10f)
    {
        w_1 = 9.99999971718068537e-10f;
    }
    else
    {
        w_1 = w_0;
    }
    return vec4<f32>(0.5f + 0.5f * (dot(projection_0[i32(0)], in_view_0) / w_1), 0.5f - 0.5f * (dot(projection_0[i32(1)], in_view_0) / w_1), abs(_S15), w_1);
}

struct Texels_0
{
     corner_0 : vec2<f32>,
     share_1 : vec2<f32>,
};

fn texels_at_0( uv_2 : vec2<f32>) -> Texels_0
{
    var _S16 : vec2<f32> = vec2<f32>(1024.0f);
    var position_2 : vec2<f32> = uv_2 * _S16 - vec2<f32>(0.5f);
    var first_0 : vec2<f32> = floor(position_2);
    var t_1 : Texels_0;
    t_1.corner_0 = (first_0 + vec2<f32>(1.0f)) / _S16;
    t_1.share_1 = position_2 - first_0;
    return t_1;
}

fn filtered_0( values_0 : vec4<f32>,  share_2 : vec2<f32>) -> f32
{
    var _S17 : f32 = share_2.x;
    return mix(mix(values_0.w, values_0.z, _S17), mix(values_0.x, values_0.y, _S17), share_2.y);
}

fn moments_at_0( uv_3 : vec2<f32>,  layer_0 : i32) -> vec2<f32>
{
    var t_2 : Texels_0 = texels_at_0(uv_3);
    var corner_1 : vec3<f32> = vec3<f32>(t_2.corner_0, f32(layer_0));
    var _S18 : vec4<f32> = (textureGather((i32(0)), (moments_0), (depth_sampler_0), ((corner_1)).xy, u32(((corner_1)).z)));
    var _S19 : f32 = filtered_0(_S18, t_2.share_1);
    var _S20 : vec4<f32> = (textureGather((i32(1)), (moments_0), (depth_sampler_0), ((corner_1)).xy, u32(((corner_1)).z)));
    return vec2<f32>(_S19, filtered_0(_S20, t_2.share_1));
}

fn skin_variance_shadow_0( mean_depth_mm_0 : f32,  mean_square_depth_mm2_0 : f32,  depth_mm_1 : f32) -> f32
{
    var _S21 : f32 = max(mean_square_depth_mm2_0 - mean_depth_mm_0 * mean_depth_mm_0, 0.00999999977648258f);
    var _S22 : f32 = max(depth_mm_1 - mean_depth_mm_0, 0.0f);
    return _S21 / (_S21 + _S22 * _S22);
}

fn skin_plane_slope_0( normal_3 : vec3<f32>,  to_light_1 : vec3<f32>,  light_right_0 : vec3<f32>,  light_up_0 : vec3<f32>,  least_cosine_0 : f32) -> vec2<f32>
{
    var axis_0 : vec3<f32> = cross(light_right_0, light_up_0);
    var handedness_0 : f32;
    if((dot(to_light_1, axis_0)) < 0.0f)
    {
        handedness_0 = -1.0f;
    }
    else
    {
        handedness_0 = 1.0f;
    }
    return vec2<f32>(dot(normal_3, light_right_0), - dot(normal_3, light_up_0)) / vec2<f32>(max(handedness_0 * dot(normal_3, axis_0), least_cosine_0));
}

fn skin_shadow_slope_0( normal_4 : vec3<f32>,  to_light_2 : vec3<f32>,  curvature_per_mm_4 : f32,  light_right_1 : vec3<f32>,  light_up_1 : vec3<f32>) -> vec2<f32>
{
    var slope_0 : vec2<f32> = skin_plane_slope_0(skin_unit_vectors_0(normal_4 + to_light_2 * vec3<f32>(max(- dot(normal_4, to_light_2), 0.0f))), to_light_2, light_right_1, light_up_1, 0.00100000004749745f);
    return slope_0 / vec2<f32>(max(length(slope_0) / (1.0f + 7.0f * saturate(1.0f + curvature_per_mm_4 / 0.03999999910593033f)), 1.0f));
}

fn compared_0( uv_4 : vec2<f32>,  receiver_mm_0 : f32,  layer_1 : i32) -> f32
{
    var t_3 : Texels_0 = texels_at_0(uv_4);
    var _S23 : vec3<f32> = vec3<f32>(t_3.corner_0, f32(layer_1));
    var _S24 : vec4<f32> = (textureGather((i32(0)), (depths_0), (depth_sampler_0), ((_S23)).xy, u32(((_S23)).z)));
    return filtered_0(select(vec4<f32>(0.0f), vec4<f32>(1.0f), _S24 >= vec4<f32>(receiver_mm_0)), t_3.share_1);
}

fn skin_contact_slope_0( face_normal_1 : vec3<f32>,  to_light_3 : vec3<f32>,  light_right_2 : vec3<f32>,  light_up_2 : vec3<f32>) -> vec2<f32>
{
    return skin_plane_slope_0(face_normal_1, to_light_3, light_right_2, light_up_2, 0.05000000074505806f);
}

fn skin_contact_bias_0( slope_1 : vec2<f32>) -> f32
{
    return 0.80000001192092896f + 0.30000001192092896f * length(slope_1);
}

fn skin_contact_compare_0( depths_1 : vec4<f32>,  receiver_mm_1 : f32,  rise_0 : vec2<f32>,  weights_1 : vec2<f32>) -> f32
{
    var _S25 : f32 = rise_0.x;
    var _S26 : f32 = rise_0.y;
    var lit_0 : vec4<f32> = step(vec4<f32>(receiver_mm_1) + vec4<f32>(0.0f, _S25, _S26, _S25 + _S26), depths_1);
    var rows_1 : vec2<f32> = mix(lit_0.xz, lit_0.yw, vec2<f32>(weights_1.x));
    return mix(rows_1.x, rows_1.y, weights_1.y);
}

fn skin_faded_contact_0( share_3 : f32,  cosine_1 : f32) -> f32
{
    return 1.0f - saturate((cosine_1 - 0.05000000074505806f) / 0.10000000894069672f) * (1.0f - share_3);
}

fn skin_inward_offset_0( position_mm_3 : vec3<f32>,  normal_5 : vec3<f32>,  offset_mm_0 : f32) -> vec3<f32>
{
    return position_mm_3 - normal_5 * vec3<f32>(offset_mm_0);
}

struct Incident_0
{
     to_light_4 : vec3<f32>,
     radiance_0 : vec3<f32>,
     shadow_filter_0 : f32,
     thickness_mm_0 : f32,
     contact_0 : f32,
};

fn view_of_0( _S27 : i32) -> mat4x4<f32>
{
    return mat4x4<f32>(lights_0[_S27].view_x_0, lights_0[_S27].view_y_0, lights_0[_S27].view_z_0, vec4<f32>(0.0f, 0.0f, 0.0f, 1.0f));
}

fn projection_of_0( _S28 : i32) -> mat4x4<f32>
{
    return mat4x4<f32>(lights_0[_S28].clip_x_1, lights_0[_S28].clip_y_1, vec4<f32>(0.0f, 0.0f, 0.0f, 0.0f), lights_0[_S28].clip_w_1);
}

fn uv_per_mm_0( _S29 : i32,  _S30 : vec4<f32>) -> f32
{
    return 0.5f * lights_0[_S29].clip_x_1.x / abs(_S30.w);
}

fn wide_filter_0( _S31 : i32,  _S32 : i32,  _S33 : Surface_0,  _S34 : vec3<f32>) -> f32
{
    var coordinates_0 : vec4<f32> = skin_light_coordinates_0(skin_shadow_receiver_0(_S33.position_1, _S33.mesh_normal_0, _S34, _S33.curvature_per_mm_0), view_of_0(_S31), projection_of_0(_S31));
    var receiver_mm_2 : f32 = coordinates_0.z - 0.40000000596046448f;
    if(SHADOW_FILTER_0 == i32(1))
    {
        var mean_0 : vec2<f32> = moments_at_0(coordinates_0.xy, _S32 / i32(2));
        return skin_variance_shadow_0(mean_0.x, mean_0.y, receiver_mm_2 - lights_0[_S31].depth_mm_0.x);
    }
    var _S35 : vec2<f32> = skin_shadow_slope_0(_S33.mesh_normal_0, _S34, _S33.curvature_per_mm_0, lights_0[_S31].view_x_0.xyz, lights_0[_S31].view_y_0.xyz);
    var radius_mm_0 : f32 = 0.5f * skin_block_0.shadow_filter_width_mm_0;
    var _S36 : f32 = min(radius_mm_0 * uv_per_mm_0(_S31, coordinates_0), 1.0f);
    var first_1 : i32 = i32(0);
    var total_0 : f32 = 0.0f;
    for(;;)
    {
        if(first_1 < i32(48))
        {
        }
        else
        {
            break;
        }
        var disk_0 : vec2<f32> = taps_0[first_1];
        var _S37 : vec2<f32> = coordinates_0.xy;
        var _S38 : vec2<f32> = vec2<f32>(_S36);
        var _S39 : f32 = compared_0(_S37 + _S38 * disk_0, receiver_mm_2 + radius_mm_0 * dot(_S35, disk_0), _S32);
        var total_1 : f32 = total_0 + _S39;
        var disk_1 : vec2<f32> = taps_0[first_1 + i32(1)];
        var _S40 : f32 = compared_0(_S37 + _S38 * disk_1, receiver_mm_2 + radius_mm_0 * dot(_S35, disk_1), _S32);
        var total_2 : f32 = total_1 + _S40;
        var disk_2 : vec2<f32> = taps_0[first_1 + i32(2)];
        var _S41 : f32 = compared_0(_S37 + _S38 * disk_2, receiver_mm_2 + radius_mm_0 * dot(_S35, disk_2), _S32);
        var total_3 : f32 = total_2 + _S41;
        var disk_3 : vec2<f32> = taps_0[first_1 + i32(3)];
        var _S42 : f32 = compared_0(_S37 + _S38 * disk_3, receiver_mm_2 + radius_mm_0 * dot(_S35, disk_3), _S32);
        var total_4 : f32 = total_3 + _S42;
        var disk_4 : vec2<f32> = taps_0[first_1 + i32(4)];
        var _S43 : f32 = compared_0(_S37 + _S38 * disk_4, receiver_mm_2 + radius_mm_0 * dot(_S35, disk_4), _S32);
        var total_5 : f32 = total_4 + _S43;
        var disk_5 : vec2<f32> = taps_0[first_1 + i32(5)];
        var _S44 : f32 = compared_0(_S37 + _S38 * disk_5, receiver_mm_2 + radius_mm_0 * dot(_S35, disk_5), _S32);
        var total_6 : f32 = total_5 + _S44;
        var disk_6 : vec2<f32> = taps_0[first_1 + i32(6)];
        var _S45 : f32 = compared_0(_S37 + _S38 * disk_6, receiver_mm_2 + radius_mm_0 * dot(_S35, disk_6), _S32);
        var total_7 : f32 = total_6 + _S45;
        var disk_7 : vec2<f32> = taps_0[first_1 + i32(7)];
        var _S46 : f32 = compared_0(_S37 + _S38 * disk_7, receiver_mm_2 + radius_mm_0 * dot(_S35, disk_7), _S32);
        var total_8 : f32 = total_7 + _S46;
        first_1 = first_1 + i32(8);
        total_0 = total_8;
    }
    return total_0 / 48.0f;
}

fn contact_filter_0( _S47 : i32,  _S48 : i32,  _S49 : Surface_0,  _S50 : vec3<f32>) -> f32
{
    var coordinates_1 : vec4<f32> = skin_light_coordinates_0(_S49.position_1, view_of_0(_S47), projection_of_0(_S47));
    var slope_2 : vec2<f32> = skin_contact_slope_0(_S49.face_normal_0, _S50, lights_0[_S47].view_x_0.xyz, lights_0[_S47].view_y_0.xyz);
    var texels_per_mm_0 : f32 = uv_per_mm_0(_S47, coordinates_1) * 1024.0f;
    var _S51 : vec2<f32> = slope_2 / vec2<f32>(texels_per_mm_0);
    var _S52 : vec2<f32> = vec2<f32>(1024.0f);
    var _S53 : vec2<f32> = coordinates_1.xy * _S52 - vec2<f32>(0.5f);
    var _S54 : f32 = coordinates_1.z - skin_contact_bias_0(slope_2);
    var _S55 : vec2<f32> = vec2<f32>((0.60000002384185791f * texels_per_mm_0));
    var position_3 : vec2<f32> = _S53 + _S55 * vec2<f32>(0.16725532710552216f, 0.0f);
    var corner_2 : vec2<f32> = floor(position_3);
    var _S56 : vec2<f32> = vec2<f32>(1.0f);
    var _S57 : f32 = f32(_S48);
    var _S58 : vec3<f32> = vec3<f32>((corner_2 + _S56) / _S52, _S57);
    var _S59 : vec4<f32> = (textureGather((i32(0)), (depths_0), (depth_sampler_0), ((_S58)).xy, u32(((_S58)).z)));
    var _S60 : f32 = skin_contact_compare_0(_S59.wzxy, _S54 + dot(corner_2 - _S53, _S51), _S51, position_3 - corner_2);
    var position_4 : vec2<f32> = _S53 + _S55 * vec2<f32>(-0.21519750356674194f, 0.19713853299617767f);
    var corner_3 : vec2<f32> = floor(position_4);
    var _S61 : vec3<f32> = vec3<f32>((corner_3 + _S56) / _S52, _S57);
    var _S62 : vec4<f32> = (textureGather((i32(0)), (depths_0), (depth_sampler_0), ((_S61)).xy, u32(((_S61)).z)));
    var total_9 : f32 = _S60 + skin_contact_compare_0(_S62.wzxy, _S54 + dot(corner_3 - _S53, _S51), _S51, position_4 - corner_3);
    var position_5 : vec2<f32> = _S53 + _S55 * vec2<f32>(0.0332011915743351f, -0.3783104419708252f);
    var corner_4 : vec2<f32> = floor(position_5);
    var _S63 : vec3<f32> = vec3<f32>((corner_4 + _S56) / _S52, _S57);
    var _S64 : vec4<f32> = (textureGather((i32(0)), (depths_0), (depth_sampler_0), ((_S63)).xy, u32(((_S63)).z)));
    var total_10 : f32 = total_9 + skin_contact_compare_0(_S64.wzxy, _S54 + dot(corner_4 - _S53, _S51), _S51, position_5 - corner_4);
    var position_6 : vec2<f32> = _S53 + _S55 * vec2<f32>(0.27573889493942261f, 0.35965254902839661f);
    var corner_5 : vec2<f32> = floor(position_6);
    var _S65 : vec3<f32> = vec3<f32>((corner_5 + _S56) / _S52, _S57);
    var _S66 : vec4<f32> = (textureGather((i32(0)), (depths_0), (depth_sampler_0), ((_S65)).xy, u32(((_S65)).z)));
    var total_11 : f32 = total_10 + skin_contact_compare_0(_S66.wzxy, _S54 + dot(corner_5 - _S53, _S51), _S51, position_6 - corner_5);
    var position_7 : vec2<f32> = _S53 + _S55 * vec2<f32>(-0.51071953773498535f, -0.09033908694982529f);
    var corner_6 : vec2<f32> = floor(position_7);
    var _S67 : vec3<f32> = vec3<f32>((corner_6 + _S56) / _S52, _S57);
    var _S68 : vec4<f32> = (textureGather((i32(0)), (depths_0), (depth_sampler_0), ((_S67)).xy, u32(((_S67)).z)));
    var total_12 : f32 = total_11 + skin_contact_compare_0(_S68.wzxy, _S54 + dot(corner_6 - _S53, _S51), _S51, position_7 - corner_6);
    var position_8 : vec2<f32> = _S53 + _S55 * vec2<f32>(0.48873069882392883f, -0.31089046597480774f);
    var corner_7 : vec2<f32> = floor(position_8);
    var _S69 : vec3<f32> = vec3<f32>((corner_7 + _S56) / _S52, _S57);
    var _S70 : vec4<f32> = (textureGather((i32(0)), (depths_0), (depth_sampler_0), ((_S69)).xy, u32(((_S69)).z)));
    var total_13 : f32 = total_12 + skin_contact_compare_0(_S70.wzxy, _S54 + dot(corner_7 - _S53, _S51), _S51, position_8 - corner_7);
    var position_9 : vec2<f32> = _S53 + _S55 * vec2<f32>(-0.16532173752784729f, 0.61498862504959106f);
    var corner_8 : vec2<f32> = floor(position_9);
    var _S71 : vec3<f32> = vec3<f32>((corner_8 + _S56) / _S52, _S57);
    var _S72 : vec4<f32> = (textureGather((i32(0)), (depths_0), (depth_sampler_0), ((_S71)).xy, u32(((_S71)).z)));
    var total_14 : f32 = total_13 + skin_contact_compare_0(_S72.wzxy, _S54 + dot(corner_8 - _S53, _S51), _S51, position_9 - corner_8);
    var position_10 : vec2<f32> = _S53 + _S55 * vec2<f32>(-0.31931877136230469f, -0.61482888460159302f);
    var corner_9 : vec2<f32> = floor(position_10);
    var _S73 : vec3<f32> = vec3<f32>((corner_9 + _S56) / _S52, _S57);
    var _S74 : vec4<f32> = (textureGather((i32(0)), (depths_0), (depth_sampler_0), ((_S73)).xy, u32(((_S73)).z)));
    var total_15 : f32 = total_14 + skin_contact_compare_0(_S74.wzxy, _S54 + dot(corner_9 - _S53, _S51), _S51, position_10 - corner_9);
    var position_11 : vec2<f32> = _S53 + _S55 * vec2<f32>(0.70304751396179199f, 0.25675183534622192f);
    var corner_10 : vec2<f32> = floor(position_11);
    var _S75 : vec3<f32> = vec3<f32>((corner_10 + _S56) / _S52, _S57);
    var _S76 : vec4<f32> = (textureGather((i32(0)), (depths_0), (depth_sampler_0), ((_S75)).xy, u32(((_S75)).z)));
    var total_16 : f32 = total_15 + skin_contact_compare_0(_S76.wzxy, _S54 + dot(corner_10 - _S53, _S51), _S51, position_11 - corner_10);
    var position_12 : vec2<f32> = _S53 + _S55 * vec2<f32>(-0.74441087245941162f, 0.3072819709777832f);
    var corner_11 : vec2<f32> = floor(position_12);
    var _S77 : vec3<f32> = vec3<f32>((corner_11 + _S56) / _S52, _S57);
    var _S78 : vec4<f32> = (textureGather((i32(0)), (depths_0), (depth_sampler_0), ((_S77)).xy, u32(((_S77)).z)));
    var total_17 : f32 = total_16 + skin_contact_compare_0(_S78.wzxy, _S54 + dot(corner_11 - _S53, _S51), _S51, position_12 - corner_11);
    var position_13 : vec2<f32> = _S53 + _S55 * vec2<f32>(0.36706140637397766f, -0.78438889980316162f);
    var corner_12 : vec2<f32> = floor(position_13);
    var _S79 : vec3<f32> = vec3<f32>((corner_12 + _S56) / _S52, _S57);
    var _S80 : vec4<f32> = (textureGather((i32(0)), (depths_0), (depth_sampler_0), ((_S79)).xy, u32(((_S79)).z)));
    var total_18 : f32 = total_17 + skin_contact_compare_0(_S80.wzxy, _S54 + dot(corner_12 - _S53, _S51), _S51, position_13 - corner_12);
    var position_14 : vec2<f32> = _S53 + _S55 * vec2<f32>(0.28072324395179749f, 0.89498996734619141f);
    var corner_13 : vec2<f32> = floor(position_14);
    var _S81 : vec3<f32> = vec3<f32>((corner_13 + _S56) / _S52, _S57);
    var _S82 : vec4<f32> = (textureGather((i32(0)), (depths_0), (depth_sampler_0), ((_S81)).xy, u32(((_S81)).z)));
    return skin_faded_contact_0((total_18 + skin_contact_compare_0(_S82.wzxy, _S54 + dot(corner_13 - _S53, _S51), _S51, position_14 - corner_13)) / 12.0f, dot(_S49.face_normal_0, _S50));
}

fn thickness_0( _S83 : i32,  _S84 : i32,  _S85 : Surface_0) -> f32
{
    var coordinates_2 : vec4<f32> = skin_light_coordinates_0(skin_inward_offset_0(_S85.position_1, _S85.mesh_normal_0, skin_block_0.deep_scatter_offset_mm_0), view_of_0(_S83), projection_of_0(_S83));
    var _S86 : f32 = skin_block_0.deep_scatter_filter_mm_0 * uv_per_mm_0(_S83, coordinates_2);
    var first_2 : i32 = i32(0);
    var total_19 : f32 = 0.0f;
    for(;;)
    {
        if(first_2 < TAPS_0)
        {
        }
        else
        {
            break;
        }
        var _S87 : vec2<f32> = coordinates_2.xy;
        var _S88 : i32 = i32(48) + first_2;
        var _S89 : vec2<f32> = vec2<f32>(_S86);
        var _S90 : f32 = f32(_S84);
        var texel_0 : vec3<f32> = vec3<f32>(_S87 + taps_0[_S88] * _S89, _S90);
        var _S91 : f32 = coordinates_2.z;
        var texel_1 : vec3<f32> = vec3<f32>(_S87 + taps_0[_S88 + i32(1)] * _S89, _S90);
        var texel_2 : vec3<f32> = vec3<f32>(_S87 + taps_0[_S88 + i32(2)] * _S89, _S90);
        var texel_3 : vec3<f32> = vec3<f32>(_S87 + taps_0[_S88 + i32(3)] * _S89, _S90);
        var texel_4 : vec3<f32> = vec3<f32>(_S87 + taps_0[_S88 + i32(4)] * _S89, _S90);
        var texel_5 : vec3<f32> = vec3<f32>(_S87 + taps_0[_S88 + i32(5)] * _S89, _S90);
        var texel_6 : vec3<f32> = vec3<f32>(_S87 + taps_0[_S88 + i32(6)] * _S89, _S90);
        var texel_7 : vec3<f32> = vec3<f32>(_S87 + taps_0[_S88 + i32(7)] * _S89, _S90);
        var total_20 : f32 = total_19 + max(_S91 - (textureSampleLevel((depths_0), (depth_sampler_0), ((texel_0)).xy, i32(((texel_0)).z), (0.0f)).x), 0.0f) + max(_S91 - (textureSampleLevel((depths_0), (depth_sampler_0), ((texel_1)).xy, i32(((texel_1)).z), (0.0f)).x), 0.0f) + max(_S91 - (textureSampleLevel((depths_0), (depth_sampler_0), ((texel_2)).xy, i32(((texel_2)).z), (0.0f)).x), 0.0f) + max(_S91 - (textureSampleLevel((depths_0), (depth_sampler_0), ((texel_3)).xy, i32(((texel_3)).z), (0.0f)).x), 0.0f) + max(_S91 - (textureSampleLevel((depths_0), (depth_sampler_0), ((texel_4)).xy, i32(((texel_4)).z), (0.0f)).x), 0.0f) + max(_S91 - (textureSampleLevel((depths_0), (depth_sampler_0), ((texel_5)).xy, i32(((texel_5)).z), (0.0f)).x), 0.0f) + max(_S91 - (textureSampleLevel((depths_0), (depth_sampler_0), ((texel_6)).xy, i32(((texel_6)).z), (0.0f)).x), 0.0f) + max(_S91 - (textureSampleLevel((depths_0), (depth_sampler_0), ((texel_7)).xy, i32(((texel_7)).z), (0.0f)).x), 0.0f);
        first_2 = first_2 + i32(8);
        total_19 = total_20;
    }
    return total_19 / f32(max(TAPS_0, i32(1)));
}

fn incident_0( index_0 : i32,  s_2 : Surface_0) -> Incident_0
{
    var irradiance_1 : vec3<f32> = lights_0[index_0].irradiance_0.xyz;
    var i_0 : Incident_0;
    var _S92 : vec3<f32> = lights_0[index_0].direction_0.xyz;
    i_0.to_light_4 = _S92;
    var through_2 : bool;
    if(SPOT_LIGHTS_0 > i32(0))
    {
        through_2 = (lights_0[index_0].near_0) > 0.5f;
    }
    else
    {
        through_2 = false;
    }
    var irradiance_2 : vec3<f32>;
    if(through_2)
    {
        var to_lamp_mm_0 : vec3<f32> = lights_0[index_0].position_mm_0.xyz - s_2.position_1;
        var _S93 : vec3<f32> = skin_unit_vectors_0(to_lamp_mm_0);
        i_0.to_light_4 = _S93;
        var outer_0 : f32 = lights_0[index_0].cone_cosines_0.x;
        var t_4 : f32 = saturate((dot(_S93, _S92) - outer_0) / (lights_0[index_0].cone_cosines_0.y - outer_0));
        irradiance_2 = irradiance_1 * vec3<f32>((lights_0[index_0].target_distance_mm_0 * lights_0[index_0].target_distance_mm_0 / max(dot(to_lamp_mm_0, to_lamp_mm_0), 1.0f) * t_4 * t_4 * (3.0f - 2.0f * t_4)));
    }
    else
    {
        irradiance_2 = irradiance_1;
    }
    i_0.radiance_0 = irradiance_2 / vec3<f32>(3.14159274101257324f);
    var cosine_2 : f32 = dot(s_2.mesh_normal_0, i_0.to_light_4);
    i_0.shadow_filter_0 = 0.0f;
    if(cosine_2 > -0.60000002384185791f)
    {
        var _S94 : f32 = wide_filter_0(index_0, i32(2) * index_0, s_2, i_0.to_light_4);
        i_0.shadow_filter_0 = _S94;
    }
    i_0.contact_0 = 1.0f;
    if(CONTACT_0 > i32(0))
    {
        through_2 = (i_0.shadow_filter_0) > 0.0f;
    }
    else
    {
        through_2 = false;
    }
    if(through_2)
    {
        through_2 = (dot(s_2.face_normal_0, i_0.to_light_4)) > 0.05000000074505806f;
    }
    else
    {
        through_2 = false;
    }
    if(through_2)
    {
        var _S95 : f32 = contact_filter_0(index_0, i32(2) * index_0 + i32(1), s_2, i_0.to_light_4);
        i_0.contact_0 = _S95;
    }
    var through_below_0 : f32;
    if(SHADING_0 == i32(1))
    {
        through_below_0 = 0.30000001192092896f;
    }
    else
    {
        through_below_0 = 0.0f;
    }
    if(VIEW_0 == i32(4))
    {
        through_2 = true;
    }
    else
    {
        through_2 = (dot(s_2.blurred_0, i_0.to_light_4)) < through_below_0;
    }
    i_0.thickness_mm_0 = 1000.0f;
    var _S96 : bool;
    if(TAPS_0 > i32(0))
    {
        _S96 = cosine_2 < 0.5f;
    }
    else
    {
        _S96 = false;
    }
    if(_S96)
    {
    }
    else
    {
        through_2 = false;
    }
    if(through_2)
    {
        i_0.thickness_mm_0 = thickness_0(index_0, i32(2) * index_0 + i32(1), s_2);
    }
    return i_0;
}

fn skin_diffused_shadow_0( lut_0 : texture_2d<f32>,  lut_sampler_1 : sampler,  lut_axes_0 : vec4<f32>,  shadow_filter_1 : f32,  n_dot_l_0 : f32,  filter_width_mm_0 : f32) -> vec3<f32>
{
    return (textureSampleLevel((lut_0), (lut_sampler_1), (saturate((vec2<f32>(shadow_filter_1, max(n_dot_l_0, 0.05000000074505806f) / filter_width_mm_0) - lut_axes_0.xz) * lut_axes_0.yw)), (0.0f))).xyz;
}

fn skin_smoothstep_0( p_2 : f32) -> f32
{
    var q_0 : f32 = saturate(p_2);
    return q_0 * q_0 * (3.0f - 2.0f * q_0);
}

fn skin_contact_shadow_0( lut_1 : texture_2d<f32>,  lut_sampler_2 : sampler,  lut_axes_1 : vec4<f32>,  shadow_0 : vec3<f32>,  contact_1 : f32,  filter_width_mm_1 : f32) -> vec3<f32>
{
    return min(shadow_0, vec3<f32>(contact_1) + vec3<f32>((1.0f - contact_1)) * skin_diffused_shadow_0(lut_1, lut_sampler_2, lut_axes_1, skin_smoothstep_0(0.5f - 0.60000002384185791f / filter_width_mm_1), 1.0f, filter_width_mm_1));
}

fn skin_cosines_0( normals_2 : mat3x3<f32>,  light_0 : vec3<f32>,  lengths_0 : vec3<f32>) -> vec3<f32>
{
    return clamp(vec3<f32>(dot(normals_2[i32(0)], light_0), dot(normals_2[i32(1)], light_0), dot(normals_2[i32(2)], light_0)) / lengths_0, vec3<f32>(-1.0f), vec3<f32>(1.0f));
}

fn skin_curvature_table_0( lut_2 : texture_2d<f32>,  lut_sampler_3 : sampler,  lut_axes_2 : vec4<f32>,  cos_theta_0 : vec3<f32>,  curvature_per_mm_5 : f32) -> vec3<f32>
{
    var row_0 : f32 = sqrt(max(curvature_per_mm_5, 0.0f));
    var _S97 : vec2<f32> = lut_axes_2.xz;
    var _S98 : vec2<f32> = lut_axes_2.yw;
    return vec3<f32>((textureSampleLevel((lut_2), (lut_sampler_3), (saturate((vec2<f32>(cos_theta_0.x, row_0) - _S97) * _S98)), (0.0f))).xyz.x, (textureSampleLevel((lut_2), (lut_sampler_3), (saturate((vec2<f32>(cos_theta_0.y, row_0) - _S97) * _S98)), (0.0f))).xyz.y, (textureSampleLevel((lut_2), (lut_sampler_3), (saturate((vec2<f32>(cos_theta_0.z, row_0) - _S97) * _S98)), (0.0f))).xyz.z);
}

fn skin_relief_bump_0( m_0 : f32,  s_3 : f32) -> f32
{
    var _S99 : f32 = max(s_3, 9.99999971718068537e-10f);
    var _S100 : f32 = max(1.0f - abs(m_0) / (4.40000009536743164f * _S99), 0.0f);
    var t2_0 : f32 = _S100 * _S100;
    return _S99 * t2_0 * t2_0 * (0.16452799737453461f + _S100 * (-1.55506408214569092f + _S100 * (7.10253477096557617f + _S100 * (-16.75164794921875f + _S100 * (22.75126266479492188f + _S100 * (-15.08054447174072266f + _S100 * 3.76787090301513672f))))));
}

fn skin_relief_light_0( lengths_1 : vec3<f32>,  cos_theta_1 : vec3<f32>) -> vec3<f32>
{
    var slope_3 : vec3<f32> = sqrt(max((vec3<f32>(0) - log(clamp(lengths_1, vec3<f32>(0.00100000004749745f), vec3<f32>(1.0f)))) * (vec3<f32>(1.0f) - cos_theta_1 * cos_theta_1), vec3<f32>(0.0f)));
    return vec3<f32>(skin_relief_bump_0(lengths_1.x * cos_theta_1.x, slope_3.x), skin_relief_bump_0(lengths_1.y * cos_theta_1.y, slope_3.y), skin_relief_bump_0(lengths_1.z * cos_theta_1.z, slope_3.z));
}

fn skin_direct_scalar_0( lut_3 : texture_2d<f32>,  lut_sampler_4 : sampler,  lut_axes_3 : vec4<f32>,  normals_3 : mat3x3<f32>,  light_1 : vec3<f32>,  curvature_per_mm_6 : f32,  gain_0 : vec3<f32>) -> vec3<f32>
{
    var lengths_2 : vec3<f32> = skin_lengths_0(normals_3);
    var cos_theta_2 : vec3<f32> = skin_cosines_0(normals_3, light_1, lengths_2);
    return gain_0 * (lengths_2 * skin_curvature_table_0(lut_3, lut_sampler_4, lut_axes_3, cos_theta_2, abs(curvature_per_mm_6)) + skin_relief_light_0(lengths_2, cos_theta_2));
}

fn skin_directional_curvature_0( tensor_world_0 : mat3x3<f32>,  normal_6 : vec3<f32>,  light_2 : vec3<f32>) -> vec2<f32>
{
    var tangential_0 : vec3<f32> = light_2 - normal_6 * vec3<f32>(dot(light_2, normal_6));
    var change_0 : vec3<f32> = vec3<f32>(dot(tensor_world_0[i32(0)], tangential_0), dot(tensor_world_0[i32(1)], tangential_0), dot(tensor_world_0[i32(2)], tangential_0));
    var total_21 : f32 = sqrt(dot(tensor_world_0[i32(0)], tensor_world_0[i32(0)]) + dot(tensor_world_0[i32(1)], tensor_world_0[i32(1)]) + dot(tensor_world_0[i32(2)], tensor_world_0[i32(2)]));
    return vec2<f32>(min(sqrt(dot(change_0, change_0) / max(dot(tangential_0, tangential_0), 9.999999960041972e-13f)), total_21), total_21);
}

fn skin_transfer_0( transfer_0 : texture_2d<f32>,  transfer_sampler_0 : sampler,  transfer_axes_1 : vec4<f32>,  k_per_mm_0 : f32) -> vec3<f32>
{
    return (textureSampleLevel((transfer_0), (transfer_sampler_0), (saturate((vec2<f32>(sqrt(max(k_per_mm_0, 0.0f)), 0.5f) - transfer_axes_1.xz) * transfer_axes_1.yw)), (0.0f))).xyz;
}

fn skin_direct_tensor_0( lut_4 : texture_2d<f32>,  lut_sampler_5 : sampler,  lut_axes_4 : vec4<f32>,  transfer_1 : texture_2d<f32>,  transfer_sampler_1 : sampler,  transfer_axes_2 : vec4<f32>,  normals_4 : mat3x3<f32>,  light_3 : vec3<f32>,  directional_per_mm_0 : f32,  total_per_mm_0 : f32,  gain_1 : vec3<f32>) -> vec3<f32>
{
    var lengths_3 : vec3<f32> = skin_lengths_0(normals_4);
    var cos_theta_3 : vec3<f32> = skin_cosines_0(normals_4, light_3, lengths_3);
    return gain_1 * (lengths_3 * (skin_curvature_table_0(lut_4, lut_sampler_5, lut_axes_4, cos_theta_3, directional_per_mm_0) * skin_transfer_0(transfer_1, transfer_sampler_1, transfer_axes_2, sqrt(max((total_per_mm_0 - directional_per_mm_0) * (total_per_mm_0 + directional_per_mm_0), 0.0f)))) + skin_relief_light_0(lengths_3, cos_theta_3));
}

fn skin_direct_diffused_normals_0( lut_5 : texture_2d<f32>,  lut_sampler_6 : sampler,  lut_axes_5 : vec4<f32>,  transfer_2 : texture_2d<f32>,  transfer_sampler_2 : sampler,  transfer_axes_3 : vec4<f32>,  normals_5 : mat3x3<f32>,  relief_length_1 : vec3<f32>,  light_4 : vec3<f32>,  directional_per_mm_1 : f32,  gain_2 : vec3<f32>) -> vec3<f32>
{
    var lengths_4 : vec3<f32> = skin_lengths_0(normals_5);
    var cos_theta_4 : vec3<f32> = skin_cosines_0(normals_5, light_4, lengths_4);
    return gain_2 * (skin_curvature_table_0(lut_5, lut_sampler_6, lut_axes_5, cos_theta_4, directional_per_mm_1) * min(lengths_4 / max(skin_transfer_0(transfer_2, transfer_sampler_2, transfer_axes_3, directional_per_mm_1), vec3<f32>(9.99999997475242708e-07f)), vec3<f32>(1.0f)) + skin_relief_light_0(relief_length_1, cos_theta_4));
}

fn diffused_light_0( s_4 : Surface_0,  d_1 : Diffused_0,  to_light_5 : vec3<f32>,  gain_3 : vec3<f32>) -> vec3<f32>
{
    if(TIER_0 == i32(0))
    {
        return skin_direct_scalar_0(sphere_lut_0, lut_sampler_0, scatter_block_0.sphere_axes_0, d_1.normals_1, to_light_5, s_4.curvature_per_mm_0, gain_3);
    }
    var bends_0 : vec2<f32> = skin_directional_curvature_0(s_4.tensor_1, s_4.mesh_normal_0, to_light_5);
    if(TIER_0 == i32(1))
    {
        return skin_direct_tensor_0(ring_lut_0, lut_sampler_0, scatter_block_0.ring_axes_0, transfer_lut_0, lut_sampler_0, scatter_block_0.transfer_axes_0, d_1.normals_1, to_light_5, bends_0.x, bends_0.y, gain_3);
    }
    return skin_direct_diffused_normals_0(ring_lut_0, lut_sampler_0, scatter_block_0.ring_axes_0, transfer_lut_0, lut_sampler_0, scatter_block_0.transfer_axes_0, d_1.with_mesh_0, d_1.relief_length_0, to_light_5, bends_0.x, gain_3);
}

fn skin_classic_transmittance_0( thickness_mm_1 : f32,  radius_mm_1 : f32) -> f32
{
    var t_5 : f32 = thickness_mm_1 / radius_mm_1;
    return exp(-0.5f * t_5 * t_5);
}

fn skin_classic_deep_scatter_0( thickness_mm_2 : f32,  n_dot_l_1 : f32,  radius_mm_2 : f32,  strength_0 : f32) -> f32
{
    return strength_0 * skin_classic_transmittance_0(thickness_mm_2, radius_mm_2) * max(0.30000001192092896f - n_dot_l_1, 0.0f);
}

fn skin_transmittance_0( thickness_mm_3 : f32,  albedo_3 : vec3<f32>,  sigma_per_mm_1 : vec3<f32>) -> vec3<f32>
{
    var a2_0 : vec3<f32> = albedo_3 * albedo_3;
    var decay_0 : vec3<f32> = exp((vec3<f32>(0) - sigma_per_mm_1) * vec3<f32>(thickness_mm_3));
    var _S101 : vec3<f32> = vec3<f32>(1.0f);
    return (_S101 - a2_0) * decay_0 / (_S101 - a2_0 * decay_0 * decay_0);
}

fn skin_direct_deep_scatter_0( transmitted_0 : vec3<f32>,  n_dot_l_2 : f32,  strength_1 : f32) -> vec3<f32>
{
    return vec3<f32>(strength_1) * transmitted_0 * vec3<f32>(max(- n_dot_l_2, 0.0f));
}

fn light_through_0( s_5 : Surface_0,  light_5 : Incident_0) -> vec3<f32>
{
    var n_dot_l_3 : f32 = dot(s_5.blurred_0, light_5.to_light_4);
    if(SHADING_0 == i32(1))
    {
        return vec3<f32>(skin_classic_deep_scatter_0(light_5.thickness_mm_0, n_dot_l_3, skin_block_0.classic_deep_scatter_radius_mm_0, skin_block_0.deep_scatter_strength_0));
    }
    return skin_direct_deep_scatter_0(skin_transmittance_0(light_5.thickness_mm_0, scatter_block_0.albedo_0.xyz, scatter_block_0.sigma_per_mm_0.xyz) / scatter_block_0.albedo_0.xyz, n_dot_l_3, skin_block_0.deep_scatter_strength_0);
}

fn skin_through_beyond_0( through_3 : vec3<f32>,  diffused_0 : vec3<f32>) -> vec3<f32>
{
    return max(through_3 - diffused_0, vec3<f32>(0.0f));
}

fn skin_sharpened_shadow_0( shadow_filter_2 : f32,  sharpening_0 : f32) -> f32
{
    return skin_smoothstep_0((0.5f - sin(asin(1.0f - 2.0f * saturate(shadow_filter_2)) / 3.0f) - 0.5f) * sharpening_0 + 0.5f);
}

fn skin_classic_sharpened_shadow_0( shadow_filter_3 : f32,  sharpening_1 : f32) -> f32
{
    return skin_smoothstep_0(0.89999997615814209f * sharpening_1 * (shadow_filter_3 - 0.5f) + 0.5f);
}

fn skin_classic_direct_0( lut_6 : texture_2d<f32>,  lut_sampler_7 : sampler,  lut_axes_6 : vec4<f32>,  sharp_3 : vec3<f32>,  blurred_2 : vec3<f32>,  light_6 : vec3<f32>,  curvature_per_mm_7 : f32) -> vec3<f32>
{
    var blurred_cosine_0 : f32 = dot(blurred_2, light_6);
    var k_0 : f32 = saturate(1.0f - blurred_cosine_0);
    var k_1 : f32 = k_0 * k_0;
    return saturate(saturate(vec3<f32>(blurred_cosine_0, dot(skin_unit_vectors_0(mix(sharp_3, blurred_2, vec3<f32>((0.30000001192092896f + 0.69999998807907104f * k_1)))), light_6), dot(skin_unit_vectors_0(mix(sharp_3, blurred_2, vec3<f32>(k_1))), light_6))) + ((textureSampleLevel((lut_6), (lut_sampler_7), (saturate((vec2<f32>(blurred_cosine_0, abs(curvature_per_mm_7)) - lut_axes_6.xz) * lut_axes_6.yw)), (0.0f))).xyz - vec3<f32>(max(blurred_cosine_0, 0.0f))));
}

fn skin_lobe_0( n_dot_h_0 : f32,  n_dot_l_4 : f32,  n_dot_v_0 : f32,  power_1 : f32) -> f32
{
    var k_2 : f32 = rsqrt_0(3.14159274101257324f * power_1 / 4.0f + 1.57079637050628662f);
    var _S102 : f32 = 1.0f - k_2;
    return (power_1 + 2.0f) / 6.28318548202514648f * pow(max(n_dot_h_0, 9.99999971718068537e-10f), power_1) * (0.25f / ((k_2 + _S102 * n_dot_l_4) * (k_2 + _S102 * n_dot_v_0)));
}

fn skin_specular_0( normal_7 : vec3<f32>,  view_2 : vec3<f32>,  light_7 : vec3<f32>,  gloss_4 : f32,  reflectance_2 : f32) -> f32
{
    var half_vector_0 : vec3<f32> = skin_unit_vectors_0(view_2 + light_7);
    var n_dot_l_5 : f32 = saturate(dot(normal_7, light_7));
    var n_dot_v_1 : f32 = clamp(dot(normal_7, view_2), 0.00009999999747379f, 1.0f);
    var n_dot_h_1 : f32 = saturate(dot(normal_7, half_vector_0));
    var wide_0 : f32 = skin_specular_power_0(gloss_4);
    var grazing_0 : f32 = 1.0f - saturate(dot(view_2, half_vector_0));
    var grazing2_0 : f32 = grazing_0 * grazing_0;
    return 3.14159274101257324f * (0.94999998807907104f * skin_lobe_0(n_dot_h_1, n_dot_l_5, n_dot_v_1, wide_0) + 0.05000000074505806f * skin_lobe_0(n_dot_h_1, n_dot_l_5, n_dot_v_1, min(wide_0 * wide_0, 8192.0f))) * (reflectance_2 + (1.0f - reflectance_2) * grazing2_0 * grazing2_0 * grazing_0) * n_dot_l_5;
}

fn skin_coat_fresnel_0( cosine_3 : f32,  reflectance_3 : f32) -> f32
{
    var root_0 : f32 = sqrt(clamp(reflectance_3, 0.0f, 0.89999997615814209f));
    var _S103 : f32 = 1.0f - root_0;
    var excess_0 : f32 = 4.0f * root_0 / (_S103 * _S103);
    var _S104 : f32 = max(sqrt(excess_0 + cosine_3 * cosine_3) + cosine_3, 9.99999971718068537e-10f);
    var across_0 : f32 = excess_0 / (_S104 * _S104);
    var along_0 : f32 = (cosine_3 * _S104 - 1.0f) / (cosine_3 * excess_0 / _S104 + 1.0f);
    return 0.5f * across_0 * across_0 * (1.0f + along_0 * along_0);
}

fn skin_coat_highlight_0( normal_8 : vec3<f32>,  view_3 : vec3<f32>,  light_8 : vec3<f32>,  gloss_5 : f32,  reflectance_4 : f32) -> f32
{
    var half_vector_1 : vec3<f32> = skin_unit_vectors_0(view_3 + light_8);
    var n_dot_l_6 : f32 = saturate(dot(normal_8, light_8));
    var n_dot_v_2 : f32 = clamp(dot(normal_8, view_3), 0.00009999999747379f, 1.0f);
    var n_dot_h_2 : f32 = saturate(dot(normal_8, half_vector_1));
    var v_dot_h_0 : f32 = saturate(dot(view_3, half_vector_1));
    var squared_0 : f32 = 2.0f / (skin_specular_power_0(gloss_5) + 2.0f);
    var side_0 : vec3<f32> = cross(normal_8, half_vector_1);
    var sine2_0 : f32;
    if(n_dot_h_2 > 0.0f)
    {
        sine2_0 = dot(side_0, side_0);
    }
    else
    {
        sine2_0 = 1.0f;
    }
    var root_1 : f32 = squared_0 / (n_dot_h_2 * n_dot_h_2 * squared_0 + sine2_0);
    var _S105 : f32 = 1.0f - squared_0;
    return root_1 * root_1 / squared_0 * (0.5f / (n_dot_l_6 * sqrt(n_dot_v_2 * n_dot_v_2 * _S105 + squared_0) + n_dot_v_2 * sqrt(n_dot_l_6 * n_dot_l_6 * _S105 + squared_0))) * skin_coat_fresnel_0(v_dot_h_0, reflectance_4) * n_dot_l_6;
}

fn skin_second_gloss_0( gloss_6 : f32) -> f32
{
    return min(2.0f * gloss_6, 1.0f);
}

fn highlight_0( s_6 : Surface_0,  to_light_6 : vec3<f32>) -> f32
{
    if(SPECULAR_0 == i32(2))
    {
        return skin_specular_0(s_6.sharp_0, s_6.view_0, to_light_6, s_6.gloss_3, s_6.reflectance_1);
    }
    var first_3 : f32 = skin_coat_highlight_0(s_6.sharp_0, s_6.view_0, to_light_6, s_6.gloss_3, s_6.reflectance_1);
    if(SPECULAR_0 == i32(0))
    {
        return first_3;
    }
    return mix(first_3, skin_coat_highlight_0(s_6.sharp_0, s_6.view_0, to_light_6, skin_second_gloss_0(s_6.gloss_3), s_6.reflectance_1), 0.05000000074505806f);
}

fn skin_sh_bands_0( sh_0 : mat3x3<f32>,  d_2 : vec3<f32>) -> vec3<f32>
{
    var _S106 : f32 = d_2.y;
    var _S107 : f32 = d_2.z;
    var _S108 : f32 = d_2.x;
    return vec3<f32>(0.282094806432724f * sh_0[i32(0)].x, 0.48860251903533936f * (sh_0[i32(0)].y * _S106 + sh_0[i32(0)].z * _S107 + sh_0[i32(1)].x * _S108), 1.09254848957061768f * (sh_0[i32(1)].y * _S108 * _S106 + sh_0[i32(1)].z * _S106 * _S107 + sh_0[i32(2)].y * _S108 * _S107) + 0.31539157032966614f * sh_0[i32(2)].x * (3.0f * _S107 * _S107 - dot(d_2, d_2)) + 0.54627424478530884f * sh_0[i32(2)].z * (_S108 * _S108 - _S106 * _S106));
}

fn skin_ambient_channel_0( sh_1 : mat3x3<f32>,  normal_9 : vec3<f32>,  band_transfer_0 : vec3<f32>) -> f32
{
    return max(dot(skin_sh_bands_0(sh_1, normal_9), vec3<f32>(1.0f, 1.0f, skin_safe_length_0(normal_9)) * band_transfer_0 * vec3<f32>(1.0f, 0.66666668653488159f, 0.25f)), 0.0f);
}

fn skin_ambient_irradiance_0( radiance_sh_red_0 : mat3x3<f32>,  radiance_sh_green_0 : mat3x3<f32>,  radiance_sh_blue_0 : mat3x3<f32>,  normals_6 : mat3x3<f32>,  band_transfer_1 : mat3x3<f32>) -> vec3<f32>
{
    var t_6 : mat3x3<f32> = transpose(band_transfer_1);
    return vec3<f32>(skin_ambient_channel_0(radiance_sh_red_0, normals_6[i32(0)], t_6[i32(0)]), skin_ambient_channel_0(radiance_sh_green_0, normals_6[i32(1)], t_6[i32(1)]), skin_ambient_channel_0(radiance_sh_blue_0, normals_6[i32(2)], t_6[i32(2)]));
}

fn sky_light_0( normals_7 : mat3x3<f32>) -> vec3<f32>
{
    var _S109 : vec3<f32> = vec3<f32>(1.0f);
    return skin_ambient_irradiance_0(mat3x3<f32>(frame_block_0.radiance_sh_0[i32(0)].x, frame_block_0.radiance_sh_0[i32(1)].x, frame_block_0.radiance_sh_0[i32(2)].x, frame_block_0.radiance_sh_0[i32(3)].x, frame_block_0.radiance_sh_0[i32(4)].x, frame_block_0.radiance_sh_0[i32(5)].x, frame_block_0.radiance_sh_0[i32(6)].x, frame_block_0.radiance_sh_0[i32(7)].x, frame_block_0.radiance_sh_0[i32(8)].x), mat3x3<f32>(frame_block_0.radiance_sh_0[i32(0)].y, frame_block_0.radiance_sh_0[i32(1)].y, frame_block_0.radiance_sh_0[i32(2)].y, frame_block_0.radiance_sh_0[i32(3)].y, frame_block_0.radiance_sh_0[i32(4)].y, frame_block_0.radiance_sh_0[i32(5)].y, frame_block_0.radiance_sh_0[i32(6)].y, frame_block_0.radiance_sh_0[i32(7)].y, frame_block_0.radiance_sh_0[i32(8)].y), mat3x3<f32>(frame_block_0.radiance_sh_0[i32(0)].z, frame_block_0.radiance_sh_0[i32(1)].z, frame_block_0.radiance_sh_0[i32(2)].z, frame_block_0.radiance_sh_0[i32(3)].z, frame_block_0.radiance_sh_0[i32(4)].z, frame_block_0.radiance_sh_0[i32(5)].z, frame_block_0.radiance_sh_0[i32(6)].z, frame_block_0.radiance_sh_0[i32(7)].z, frame_block_0.radiance_sh_0[i32(8)].z), normals_7, mat3x3<f32>(_S109, _S109, _S109));
}

fn skin_ambient_specular_fresnel_0( n_dot_v_3 : f32,  gloss_7 : f32,  reflectance_5 : f32) -> f32
{
    var grazing_1 : f32 = 1.0f - saturate(n_dot_v_3);
    var grazing2_1 : f32 = grazing_1 * grazing_1;
    return reflectance_5 + (1.0f - reflectance_5) * grazing2_1 * grazing2_1 * grazing_1 / (4.0f - 3.0f * gloss_7);
}

fn skin_reflected_0( normal_10 : vec3<f32>,  view_4 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>((2.0f * dot(normal_10, view_4))) * normal_10 - view_4;
}

fn skin_turns_0( y_1 : f32,  x_4 : f32) -> f32
{
    var size_1 : vec2<f32> = abs(vec2<f32>(x_4, y_1));
    var _S110 : f32 = size_1.x;
    var _S111 : f32 = size_1.y;
    var r_0 : f32 = min(_S110, _S111) / max(max(_S110, _S111), 1.00000000317107685e-30f);
    var r2_0 : f32 = r_0 * r_0;
    var turns_0 : f32 = r_0 * (0.15915107727050781f + r2_0 * (-0.05293257534503937f + r2_0 * (0.03076364658772945f + r2_0 * (-0.01842727139592171f + r2_0 * (0.00826387945562601f - r2_0 * 0.00181874714326113f)))));
    var turns_1 : f32;
    if(_S111 > _S110)
    {
        turns_1 = 0.25f - turns_0;
    }
    else
    {
        turns_1 = turns_0;
    }
    if(x_4 < 0.0f)
    {
        turns_1 = 0.5f - turns_1;
    }
    if(y_1 < 0.0f)
    {
        turns_1 = - turns_1;
    }
    return turns_1;
}

fn skin_equirectangular_uv_0( direction_1 : vec3<f32>) -> vec2<f32>
{
    var _S112 : f32 = direction_1.x;
    var _S113 : f32 = direction_1.z;
    return vec2<f32>(0.5f + skin_turns_0(_S113, _S112), 2.0f * skin_turns_0(sqrt(_S112 * _S112 + _S113 * _S113), direction_1.y));
}

fn skin_reflection_level_0( power_2 : f32) -> f32
{
    return clamp(0.5f * log2(max(power_2, 1.0f)), 0.0f, 4.0f);
}

fn skin_preconvolved_0( preconvolved_1 : texture_2d<f32>,  preconvolved_sampler_0 : sampler,  uv_5 : vec2<f32>,  power_3 : f32) -> vec3<f32>
{
    var level_0 : f32 = skin_reflection_level_0(power_3);
    var _S114 : f32 = min(floor(level_0), 3.0f);
    var row_1 : f32 = clamp(uv_5.y, 0.0078125f, 0.9921875f);
    var _S115 : f32 = uv_5.x;
    return mix((textureSampleLevel((preconvolved_1), (preconvolved_sampler_0), (vec2<f32>(_S115, (_S114 + row_1) / 5.0f)), (0.0f))).xyz, (textureSampleLevel((preconvolved_1), (preconvolved_sampler_0), (vec2<f32>(_S115, (_S114 + 1.0f + row_1) / 5.0f)), (0.0f))).xyz, vec3<f32>((level_0 - _S114)));
}

fn skin_reflected_radiance_0( preconvolved_2 : texture_2d<f32>,  preconvolved_sampler_1 : sampler,  direction_2 : vec3<f32>,  gloss_8 : f32) -> vec3<f32>
{
    var uv_6 : vec2<f32> = skin_equirectangular_uv_0(direction_2);
    var power_4 : f32 = skin_specular_power_0(gloss_8);
    return mix(skin_preconvolved_0(preconvolved_2, preconvolved_sampler_1, uv_6, power_4 / 4.0f), skin_preconvolved_0(preconvolved_2, preconvolved_sampler_1, uv_6, power_4 * power_4 / 4.0f), vec3<f32>(0.05000000074505806f));
}

fn skin_coat_0( lut_7 : texture_2d<f32>,  lut_sampler_8 : sampler,  lut_axes_7 : vec4<f32>,  n_dot_v_4 : f32,  gloss_9 : f32,  reflectance_6 : f32,  coat_reflectance_1 : f32) -> vec2<f32>
{
    var entry_0 : vec3<f32> = (textureSampleLevel((lut_7), (lut_sampler_8), (saturate((vec2<f32>(sqrt(saturate(n_dot_v_4)), gloss_9) - lut_axes_7.xz) * lut_axes_7.yw)), (0.0f))).xyz;
    var _S116 : f32 = entry_0.z;
    return vec2<f32>(clamp(_S116 + (1.0f - reflectance_6) / (1.0f - coat_reflectance_1) * (entry_0.x - _S116), 0.0f, _S116), entry_0.y);
}

fn coat_of_0( s_7 : Surface_0,  n_dot_v_5 : f32,  gloss_10 : f32) -> vec2<f32>
{
    return skin_coat_0(coat_lut_0, lut_sampler_0, scatter_block_0.coat_axes_0, n_dot_v_5, gloss_10, s_7.reflectance_1, scatter_block_0.coat_reflectance_0);
}

fn skin_coat_direction_0( normal_11 : vec3<f32>,  view_5 : vec3<f32>,  pull_0 : f32) -> vec3<f32>
{
    var mirrored_0 : vec3<f32> = skin_reflected_0(normal_11, view_5);
    return skin_unit_vectors_0(mirrored_0 + vec3<f32>(pull_0) * (normal_11 - mirrored_0));
}

fn skin_coat_radiance_0( preconvolved_3 : texture_2d<f32>,  preconvolved_sampler_2 : sampler,  direction_3 : vec3<f32>,  n_dot_v_6 : f32,  gloss_11 : f32) -> vec3<f32>
{
    return skin_preconvolved_0(preconvolved_3, preconvolved_sampler_2, skin_equirectangular_uv_0(direction_3), (skin_specular_power_0(gloss_11) + 2.0f) / (8.0f * max(n_dot_v_6, 0.00999999977648258f)));
}

fn lobe_of_sky_0( s_8 : Surface_0,  n_dot_v_7 : f32,  gloss_12 : f32,  share_4 : ptr<function, f32>) -> vec3<f32>
{
    var coat_0 : vec2<f32> = coat_of_0(s_8, n_dot_v_7, gloss_12);
    var direction_4 : vec3<f32> = skin_coat_direction_0(s_8.sharp_0, s_8.view_0, coat_0.y);
    var _S117 : f32 = coat_0.x;
    (*share_4) = _S117;
    return vec3<f32>(_S117) * skin_coat_radiance_0(preconvolved_0, sky_sampler_0, direction_4, n_dot_v_7, gloss_12);
}

fn reflected_sky_0( s_9 : Surface_0,  n_dot_v_8 : f32,  share_5 : ptr<function, f32>) -> vec3<f32>
{
    if(SPECULAR_0 == i32(2))
    {
        var _S118 : f32 = skin_ambient_specular_fresnel_0(n_dot_v_8, s_9.gloss_3, s_9.reflectance_1);
        (*share_5) = _S118;
        return vec3<f32>(_S118) * skin_reflected_radiance_0(preconvolved_0, sky_sampler_0, skin_reflected_0(s_9.sharp_0, s_9.view_0), s_9.gloss_3);
    }
    var first_4 : vec3<f32> = lobe_of_sky_0(s_9, n_dot_v_8, s_9.gloss_3, &((*share_5)));
    if(SPECULAR_0 == i32(0))
    {
        return first_4;
    }
    var second_share_0 : f32;
    var second_0 : vec3<f32> = lobe_of_sky_0(s_9, n_dot_v_8, skin_second_gloss_0(s_9.gloss_3), &(second_share_0));
    (*share_5) = mix((*share_5), second_share_0, 0.05000000074505806f);
    return mix(first_4, second_0, vec3<f32>(0.05000000074505806f));
}

fn skin_reflected_visibility_0( sky_harmonics_2 : mat3x3<f32>,  normal_12 : vec3<f32>,  direction_5 : vec3<f32>) -> f32
{
    var bands_0 : vec3<f32> = skin_sh_bands_0(sky_harmonics_2, direction_5);
    var _S119 : f32 = max(dot(normal_12, direction_5), 0.0f);
    return saturate((bands_0.x + bands_0.y + bands_0.z) / ((0.375f + _S119 * (2.0f + 1.875f * _S119)) * 0.07957746833562851f));
}

fn skin_occluded_reflection_0( sky_0 : vec3<f32>,  bounced_2 : vec3<f32>,  sky_harmonics_3 : mat3x3<f32>,  normal_13 : vec3<f32>,  direction_6 : vec3<f32>) -> vec3<f32>
{
    return mix(bounced_2 / vec3<f32>(max(1.0f - sky_harmonics_3[i32(0)].x / 0.282094806432724f, 0.01999999955296516f)), sky_0, vec3<f32>(skin_reflected_visibility_0(sky_harmonics_3, normal_13, direction_6)));
}

@id(13) override BOUNDARY_0 : i32 = i32(0);

fn skin_root_absorption_0( albedo_4 : vec3<f32>) -> vec3<f32>
{
    var bounded_0 : vec3<f32> = saturate(albedo_4);
    var _S120 : vec3<f32> = vec3<f32>(1.0f);
    var s_10 : vec3<f32> = vec3<f32>(6.0f) * (_S120 - bounded_0) / (vec3<f32>(7.0f) + sqrt(vec3<f32>(25.0f) + vec3<f32>(24.0f) * bounded_0));
    return s_10 / (_S120 - s_10);
}

fn skin_inner_cosine_0( cosine_4 : f32,  inverse_ior_0 : f32) -> f32
{
    return sqrt(max(1.0f - (1.0f - cosine_4 * cosine_4) * inverse_ior_0 * inverse_ior_0, 0.0f));
}

fn skin_mean_escape_0( slope_4 : vec3<f32>,  low_0 : f32,  high_0 : f32) -> vec3<f32>
{
    var _S121 : vec3<f32> = vec3<f32>(1.0f);
    return (_S121 + slope_4 * vec3<f32>((0.36391723155975342f * high_0 + 0.63608276844024658f * low_0))) / ((_S121 + slope_4 * vec3<f32>(low_0)) * (_S121 + slope_4 * vec3<f32>(high_0)));
}

fn skin_view_factor_0( albedo_5 : vec3<f32>,  n_dot_v_9 : f32,  reflectance_7 : f32) -> vec3<f32>
{
    var root_2 : f32 = sqrt(clamp(reflectance_7, 0.0f, 0.89999997615814209f));
    var inverse_ior_1 : f32 = (1.0f - root_2) / (1.0f + root_2);
    var slope_5 : vec3<f32> = vec3<f32>(2.0f) * skin_root_absorption_0(albedo_5);
    var _S122 : vec3<f32> = vec3<f32>(1.0f);
    return _S122 / ((_S122 + slope_5 * vec3<f32>(skin_inner_cosine_0(saturate(n_dot_v_9), inverse_ior_1))) * skin_mean_escape_0(slope_5, skin_inner_cosine_0(0.35505104064941406f, inverse_ior_1), skin_inner_cosine_0(0.84494894742965698f, inverse_ior_1)));
}

fn skin_closure_view_factor_0( albedo_6 : vec3<f32>,  n_dot_v_10 : f32) -> vec3<f32>
{
    var slope_6 : vec3<f32> = vec3<f32>(2.0f) * skin_root_absorption_0(albedo_6);
    var diffuse_0 : vec3<f32> = skin_mean_escape_0(slope_6, 0.35505104064941406f, 0.84494894742965698f);
    var _S123 : vec3<f32> = vec3<f32>(1.0f);
    return (diffuse_0 + _S123 / (_S123 + slope_6 * vec3<f32>((0.12999999523162842f + 0.75f * saturate(n_dot_v_10))))) / (diffuse_0 + skin_mean_escape_0(slope_6, 0.39628827571868896f, 0.76371169090270996f));
}

fn skin_diffuse_share_0( n_dot_v_11 : f32,  gloss_13 : f32,  reflectance_8 : f32) -> f32
{
    return 1.0f - skin_ambient_specular_fresnel_0(n_dot_v_11, gloss_13, reflectance_8);
}

fn diffused_share_0( s_11 : Surface_0,  n_dot_v_12 : f32) -> f32
{
    if(SPECULAR_0 == i32(2))
    {
        return skin_diffuse_share_0(dot(s_11.mesh_normal_0, s_11.view_0), s_11.gloss_3, s_11.reflectance_1);
    }
    var first_5 : f32 = coat_of_0(s_11, n_dot_v_12, s_11.gloss_3).x;
    if(SPECULAR_0 == i32(0))
    {
        return 1.0f - first_5;
    }
    return 1.0f - mix(first_5, coat_of_0(s_11, n_dot_v_12, skin_second_gloss_0(s_11.gloss_3)).x, 0.05000000074505806f);
}

struct pixelOutput_0
{
    @location(0) output_0 : vec4<f32>,
};

struct pixelInput_0
{
    @location(0) v0_3 : vec4<f32>,
    @location(1) v1_3 : vec4<f32>,
    @location(2) v2_3 : vec4<f32>,
    @location(3) v3_3 : vec4<f32>,
    @location(4) v4_3 : vec4<f32>,
    @location(5) v5_3 : vec4<f32>,
    @location(6) v6_3 : vec4<f32>,
    @location(7) v7_3 : vec4<f32>,
    @location(8) v8_3 : vec4<f32>,
    @location(9) v9_3 : vec4<f32>,
    @location(10) v10_3 : vec4<f32>,
    @location(11) v11_3 : vec4<f32>,
    @location(12) v12_3 : vec4<f32>,
};

@fragment
fn fragment_main( _S124 : pixelInput_0, @invariant @builtin(position) clip_2 : vec4<f32>) -> pixelOutput_0
{
    var diffuse_1 : vec3<f32>;
    var diffuse_2 : vec3<f32>;
    var diffuse_3 : vec3<f32>;
    var _S125 : Fragment_0 = Fragment_0( clip_2, _S124.v0_3, _S124.v1_3, _S124.v2_3, _S124.v3_3, _S124.v4_3, _S124.v5_3, _S124.v6_3, _S124.v7_3, _S124.v8_3, _S124.v9_3, _S124.v10_3, _S124.v11_3, _S124.v12_3 );
    var a_2 : Attributes_0 = attributes_of_0(_S125);
    var _S126 : vec2<f32> = vec2<f32>(frame_block_0.footprint_0);
    var s_12 : Surface_0 = surface_of_0(a_2, dpdx(a_2.uv_0) * _S126, dpdy(a_2.uv_0) * _S126);
    var gain_4 : vec3<f32>;
    if(CONTACT_0 > i32(0))
    {
        var face_0 : vec3<f32> = cross(dpdx(a_2.position_0), dpdy(a_2.position_0));
        if((dot(face_0, s_12.mesh_normal_0)) < 0.0f)
        {
            gain_4 = (vec3<f32>(0) - face_0);
        }
        else
        {
            gain_4 = face_0;
        }
        s_12.face_normal_0 = skin_unit_vectors_0(gain_4);
    }
    var _S127 : bool;
    if(OPACITY_CUTOFF_0 > i32(0))
    {
        _S127 = (255.0f * (textureSampleLevel((albedo_map_0), (map_sampler_0), (a_2.uv_0), (0.0f))).w) < f32(OPACITY_CUTOFF_0);
    }
    else
    {
        _S127 = false;
    }
    if(_S127)
    {
        discard;
    }
    if(VIEW_0 == i32(1))
    {
        var _S128 : vec3<f32> = vec3<f32>(0.5f);
        var _S129 : pixelOutput_0 = pixelOutput_0( vec4<f32>(skin_linear_from_srgb_0(_S128 + _S128 * s_12.sharp_0), 1.0f) );
        return _S129;
    }
    if(VIEW_0 == i32(2))
    {
        var _S130 : vec3<f32> = vec3<f32>(0.5f);
        var _S131 : pixelOutput_0 = pixelOutput_0( vec4<f32>(skin_linear_from_srgb_0(_S130 + _S130 * s_12.blurred_0), 1.0f) );
        return _S131;
    }
    if(VIEW_0 == i32(3))
    {
        var _S132 : pixelOutput_0 = pixelOutput_0( vec4<f32>(curvature_colour_0(s_12.curvature_per_mm_0), 1.0f) );
        return _S132;
    }
    if(VIEW_0 == i32(6))
    {
        var _S133 : pixelOutput_0 = pixelOutput_0( vec4<f32>(s_12.albedo_1, 1.0f) );
        return _S133;
    }
    var _S134 : mat3x3<f32> = mat3x3<f32>(s_12.sharp_0, s_12.sharp_0, s_12.sharp_0);
    var _S135 : vec3<f32> = vec3<f32>(1.0f);
    var _S136 : bool = SHADING_0 == i32(1);
    var normals_8 : mat3x3<f32>;
    if(_S136)
    {
        normals_8 = skin_classic_ambient_normals_0(s_12.sharp_0, s_12.blurred_0);
    }
    else
    {
        normals_8 = _S134;
    }
    var _S137 : bool = SHADING_0 == i32(2);
    var diffused_1 : Diffused_0;
    if(_S137)
    {
        var diffused_2 : Diffused_0 = diffused_surface_0(s_12);
        var _S138 : vec3<f32> = skin_energy_gain_0(scatter_block_0.albedo_0.xyz, scatter_block_0.rms_radius_mm_0.xyz, s_12.diffused_curvature_per_mm_0);
        diffused_1 = diffused_2;
        gain_4 = _S138;
        normals_8 = diffused_2.normals_1;
    }
    else
    {
        gain_4 = _S135;
    }
    var tint_1 : vec3<f32> = s_12.tint_0 * skin_block_0.deep_scatter_tint_0.xyz;
    var _S139 : vec3<f32> = vec3<f32>(0.0f);
    var largest_filter_0 : f32;
    if(LIGHTS_0 > i32(0))
    {
        largest_filter_0 = 0.0f;
    }
    else
    {
        largest_filter_0 = 1.0f;
    }
    if(LIGHTS_0 > i32(0))
    {
        _S127 = TAPS_0 > i32(0);
    }
    else
    {
        _S127 = false;
    }
    var thinnest_0 : f32;
    if(_S127)
    {
        thinnest_0 = 1.00000001504746622e+30f;
    }
    else
    {
        thinnest_0 = 0.0f;
    }
    var index_1 : i32 = i32(0);
    var deep_0 : vec3<f32> = _S139;
    var direct_0 : vec3<f32> = _S139;
    var specular_0 : vec3<f32> = _S139;
    for(;;)
    {
        if(index_1 < LIGHTS_0)
        {
        }
        else
        {
            break;
        }
        var light_9 : Incident_0 = incident_0(index_1, s_12);
        var _S140 : f32 = max(largest_filter_0, light_9.shadow_filter_0);
        if(TAPS_0 > i32(0))
        {
            thinnest_0 = min(thinnest_0, light_9.thickness_mm_0);
        }
        var n_dot_l_7 : f32 = dot(s_12.mesh_normal_0, light_9.to_light_4);
        var width_1 : f32 = skin_block_0.shadow_filter_width_mm_0;
        if(_S137)
        {
            _S127 = (light_9.shadow_filter_0) > 0.0f;
        }
        else
        {
            _S127 = false;
        }
        if(_S127)
        {
            var shadow_1 : vec3<f32> = skin_diffused_shadow_0(shadow_lut_0, lut_sampler_0, scatter_block_0.shadow_axes_0, light_9.shadow_filter_0, n_dot_l_7, width_1);
            if(CONTACT_0 > i32(0))
            {
                diffuse_1 = skin_contact_shadow_0(shadow_lut_0, lut_sampler_0, scatter_block_0.shadow_axes_0, shadow_1, light_9.contact_0, width_1);
            }
            else
            {
                diffuse_1 = shadow_1;
            }
            diffuse_1 = diffused_light_0(s_12, diffused_1, light_9.to_light_4, gain_4) * diffuse_1;
        }
        else
        {
            diffuse_1 = _S139;
        }
        var _S141 : bool;
        if(TAPS_0 > i32(0))
        {
            _S141 = (dot(s_12.blurred_0, light_9.to_light_4)) < 0.30000001192092896f;
        }
        else
        {
            _S141 = false;
        }
        if(_S141)
        {
            var through_4 : vec3<f32> = light_through_0(s_12, light_9);
            if(_S137)
            {
                diffuse_2 = skin_through_beyond_0(through_4, diffuse_1);
            }
            else
            {
                diffuse_2 = through_4;
            }
            deep_0 = deep_0 + light_9.radiance_0 * tint_1 * diffuse_2;
        }
        if((light_9.shadow_filter_0) == 0.0f)
        {
            var _S142 : i32 = index_1 + i32(1);
            largest_filter_0 = _S140;
            index_1 = _S142;
            continue;
        }
        var lit_1 : f32 = skin_sharpened_shadow_0(light_9.shadow_filter_0, skin_block_0.shadow_sharpening_0);
        var lit_2 : f32;
        if(CONTACT_0 > i32(0))
        {
            lit_2 = min(lit_1, light_9.contact_0);
        }
        else
        {
            lit_2 = lit_1;
        }
        if(SHADING_0 == i32(0))
        {
            diffuse_2 = vec3<f32>((max(dot(s_12.sharp_0, light_9.to_light_4), 0.0f) * lit_2));
        }
        else
        {
            diffuse_2 = diffuse_1;
        }
        var lit_3 : f32;
        if(_S136)
        {
            var diffuse_4 : vec3<f32> = skin_classic_direct_0(classic_lut_0, lut_sampler_0, scatter_block_0.classic_axes_0, s_12.sharp_0, s_12.blurred_0, light_9.to_light_4, s_12.curvature_per_mm_0) * skin_diffused_shadow_0(classic_shadow_lut_0, lut_sampler_0, scatter_block_0.classic_shadow_axes_0, light_9.shadow_filter_0, n_dot_l_7, width_1);
            lit_3 = skin_classic_sharpened_shadow_0(light_9.shadow_filter_0, skin_block_0.shadow_sharpening_0);
            diffuse_3 = diffuse_4;
        }
        else
        {
            lit_3 = lit_2;
            diffuse_3 = diffuse_2;
        }
        var specular_1 : vec3<f32> = specular_0 + light_9.radiance_0 * vec3<f32>(lit_3) * vec3<f32>(highlight_0(s_12, light_9.to_light_4));
        direct_0 = direct_0 + light_9.radiance_0 * diffuse_3;
        specular_0 = specular_1;
        var _S142 : i32 = index_1 + i32(1);
        largest_filter_0 = _S140;
        index_1 = _S142;
    }
    if(VIEW_0 == i32(4))
    {
        var _S143 : pixelOutput_0 = pixelOutput_0( vec4<f32>(skin_linear_from_srgb_0(vec3<f32>(saturate(thinnest_0 / 30.0f))), 1.0f) );
        return _S143;
    }
    if(VIEW_0 == i32(5))
    {
        var _S144 : pixelOutput_0 = pixelOutput_0( vec4<f32>(skin_linear_from_srgb_0(vec3<f32>(largest_filter_0)), 1.0f) );
        return _S144;
    }
    var n_dot_v_13 : f32 = dot(s_12.sharp_0, s_12.view_0);
    if(ENVIRONMENT_0 > i32(0))
    {
        var _S145 : vec3<f32> = gain_4 * (sky_light_0(normals_8) * s_12.visibility_1 + s_12.bounced_1);
        var share_6 : f32;
        var sky_1 : vec3<f32> = reflected_sky_0(s_12, n_dot_v_13, &(share_6));
        var _S146 : vec3<f32> = skin_occluded_reflection_0(sky_1, vec3<f32>(share_6) * s_12.bounced_1, s_12.sky_harmonics_1, s_12.mesh_normal_0, skin_reflected_0(s_12.sharp_0, s_12.view_0));
        if(_S137)
        {
            _S127 = TAPS_0 > i32(0);
        }
        else
        {
            _S127 = false;
        }
        if(_S127)
        {
            diffuse_1 = vec3<f32>(skin_block_0.deep_scatter_strength_0) * s_12.through_1 / scatter_block_0.albedo_0.xyz * tint_1;
        }
        else
        {
            diffuse_1 = _S139;
        }
        var _S147 : vec3<f32> = diffuse_1;
        diffuse_1 = _S146;
        diffuse_2 = _S145;
        diffuse_3 = _S147;
    }
    else
    {
        diffuse_1 = _S139;
        diffuse_2 = _S139;
        diffuse_3 = _S139;
    }
    var body_0 : vec3<f32> = s_12.albedo_1;
    if(_S137)
    {
        _S127 = BOUNDARY_0 == i32(0);
    }
    else
    {
        _S127 = false;
    }
    var body_1 : vec3<f32>;
    if(_S127)
    {
        body_1 = body_0 * skin_view_factor_0(s_12.albedo_1, n_dot_v_13, skin_block_0.reflectance_0);
    }
    else
    {
        body_1 = body_0;
    }
    if(_S137)
    {
        _S127 = BOUNDARY_0 == i32(1);
    }
    else
    {
        _S127 = false;
    }
    if(_S127)
    {
        body_1 = body_1 * skin_closure_view_factor_0(s_12.albedo_1, n_dot_v_13);
    }
    if(SHADING_0 != i32(1))
    {
        body_1 = body_1 * vec3<f32>(diffused_share_0(s_12, n_dot_v_13));
    }
    var direct_1 : vec3<f32> = direct_0 * body_1;
    var deep_1 : vec3<f32> = deep_0 * body_1;
    var ambient_0 : vec3<f32> = diffuse_2 * body_1;
    var ambient_deep_0 : vec3<f32> = diffuse_3 * body_1;
    var _S148 : vec3<f32> = direct_1 + deep_1 + specular_0 + ambient_0 + ambient_deep_0 + diffuse_1;
    var color_0 : vec3<f32>;
    if(VIEW_0 == i32(7))
    {
        color_0 = direct_1;
    }
    else
    {
        color_0 = _S148;
    }
    if(VIEW_0 == i32(8))
    {
        color_0 = deep_1;
    }
    if(VIEW_0 == i32(9))
    {
        color_0 = specular_0;
    }
    if(VIEW_0 == i32(10))
    {
        color_0 = ambient_0;
    }
    if(VIEW_0 == i32(11))
    {
        color_0 = ambient_deep_0;
    }
    if(VIEW_0 == i32(12))
    {
        color_0 = diffuse_1;
    }
    if(MULTISAMPLED_0 > i32(0))
    {
        color_0 = min(color_0, vec3<f32>(60000.0f));
    }
    var _S149 : pixelOutput_0 = pixelOutput_0( vec4<f32>(color_0, 1.0f) );
    return _S149;
}

