@binding(6) @group(0) var<storage, read_write> echoed_0 : array<f32>;

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
struct EyeBlock_std140_0
{
    @align(16) iris_uv_0 : vec4<f32>,
    @align(16) sclera_radius_mm_0 : f32,
    @align(4) limbus_radius_mm_0 : f32,
    @align(8) limbus_width_mm_0 : f32,
    @align(4) cornea_radius_mm_0 : f32,
    @align(16) cornea_asphericity_0 : f32,
    @align(4) refraction_index_0 : f32,
    @align(8) tear_index_0 : f32,
    @align(4) aqueous_index_0 : f32,
    @align(16) iris_depth_mm_0 : f32,
    @align(4) iris_slope_0 : f32,
    @align(8) iris_radius_mm_0 : f32,
    @align(4) pupil_radius_mm_0 : f32,
    @align(16) pupil_in_map_0 : f32,
    @align(4) virtual_cornea_0 : f32,
    @align(8) cornea_roughness_deg_0 : f32,
    @align(4) sclera_roughness_deg_0 : f32,
    @align(16) sclera_normal_strength_0 : f32,
    @align(4) meniscus_height_mm_0 : f32,
    @align(8) iris_height_mm_0 : f32,
};

@binding(2) @group(0) var<uniform> eye_block_0 : EyeBlock_std140_0;
struct EyePlaceBlock_std140_0
{
    @align(16) eye_x_0 : vec4<f32>,
    @align(16) eye_y_0 : vec4<f32>,
    @align(16) eye_z_0 : vec4<f32>,
    @align(16) lid_upper_0 : vec4<f32>,
    @align(16) lid_lower_0 : vec4<f32>,
    @align(16) lamp_axes_0 : vec4<f32>,
    @align(16) surroundings_axes_0 : vec4<f32>,
    @align(16) lid_radiance_0 : vec4<f32>,
    @align(16) lid_radius_mm_0 : f32,
};

@binding(3) @group(0) var<uniform> eye_place_block_0 : EyePlaceBlock_std140_0;
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

@binding(4) @group(0) var<uniform> frame_block_0 : FrameBlock_std140_0;
struct LightBlock_std140_0
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

@binding(5) @group(0) var<uniform> light_block_0 : LightBlock_std140_0;
@compute
@workgroup_size(1, 1, 1)
fn echo_SkinBlock()
{
    echoed_0[i32(0)] = skin_block_0.deep_scatter_sigma_per_mm_0.x;
    echoed_0[i32(1)] = skin_block_0.deep_scatter_sigma_per_mm_0.y;
    echoed_0[i32(2)] = skin_block_0.deep_scatter_sigma_per_mm_0.z;
    echoed_0[i32(3)] = skin_block_0.deep_scatter_sigma_per_mm_0.w;
    echoed_0[i32(4)] = skin_block_0.deep_scatter_tint_0.x;
    echoed_0[i32(5)] = skin_block_0.deep_scatter_tint_0.y;
    echoed_0[i32(6)] = skin_block_0.deep_scatter_tint_0.z;
    echoed_0[i32(7)] = skin_block_0.deep_scatter_tint_0.w;
    echoed_0[i32(8)] = skin_block_0.scatter_scale_0;
    echoed_0[i32(9)] = skin_block_0.normal_strength_0;
    echoed_0[i32(10)] = skin_block_0.gloss_0;
    echoed_0[i32(11)] = skin_block_0.reflectance_0;
    echoed_0[i32(12)] = skin_block_0.shadow_filter_width_mm_0;
    echoed_0[i32(13)] = skin_block_0.shadow_sharpening_0;
    echoed_0[i32(14)] = skin_block_0.deep_scatter_strength_0;
    echoed_0[i32(15)] = skin_block_0.deep_scatter_offset_mm_0;
    echoed_0[i32(16)] = skin_block_0.deep_scatter_filter_mm_0;
    echoed_0[i32(17)] = skin_block_0.classic_deep_scatter_radius_mm_0;
    return;
}

@compute
@workgroup_size(1, 1, 1)
fn echo_ScatterBlock()
{
    echoed_0[i32(0)] = scatter_block_0.albedo_0.x;
    echoed_0[i32(1)] = scatter_block_0.albedo_0.y;
    echoed_0[i32(2)] = scatter_block_0.albedo_0.z;
    echoed_0[i32(3)] = scatter_block_0.albedo_0.w;
    echoed_0[i32(4)] = scatter_block_0.rms_radius_mm_0.x;
    echoed_0[i32(5)] = scatter_block_0.rms_radius_mm_0.y;
    echoed_0[i32(6)] = scatter_block_0.rms_radius_mm_0.z;
    echoed_0[i32(7)] = scatter_block_0.rms_radius_mm_0.w;
    echoed_0[i32(8)] = scatter_block_0.sigma_per_mm_0.x;
    echoed_0[i32(9)] = scatter_block_0.sigma_per_mm_0.y;
    echoed_0[i32(10)] = scatter_block_0.sigma_per_mm_0.z;
    echoed_0[i32(11)] = scatter_block_0.sigma_per_mm_0.w;
    echoed_0[i32(12)] = scatter_block_0.blend_red_0.x;
    echoed_0[i32(13)] = scatter_block_0.blend_red_0.y;
    echoed_0[i32(14)] = scatter_block_0.blend_red_0.z;
    echoed_0[i32(15)] = scatter_block_0.blend_red_0.w;
    echoed_0[i32(16)] = scatter_block_0.blend_green_0.x;
    echoed_0[i32(17)] = scatter_block_0.blend_green_0.y;
    echoed_0[i32(18)] = scatter_block_0.blend_green_0.z;
    echoed_0[i32(19)] = scatter_block_0.blend_green_0.w;
    echoed_0[i32(20)] = scatter_block_0.blend_blue_0.x;
    echoed_0[i32(21)] = scatter_block_0.blend_blue_0.y;
    echoed_0[i32(22)] = scatter_block_0.blend_blue_0.z;
    echoed_0[i32(23)] = scatter_block_0.blend_blue_0.w;
    echoed_0[i32(24)] = scatter_block_0.ring_axes_0.x;
    echoed_0[i32(25)] = scatter_block_0.ring_axes_0.y;
    echoed_0[i32(26)] = scatter_block_0.ring_axes_0.z;
    echoed_0[i32(27)] = scatter_block_0.ring_axes_0.w;
    echoed_0[i32(28)] = scatter_block_0.sphere_axes_0.x;
    echoed_0[i32(29)] = scatter_block_0.sphere_axes_0.y;
    echoed_0[i32(30)] = scatter_block_0.sphere_axes_0.z;
    echoed_0[i32(31)] = scatter_block_0.sphere_axes_0.w;
    echoed_0[i32(32)] = scatter_block_0.transfer_axes_0.x;
    echoed_0[i32(33)] = scatter_block_0.transfer_axes_0.y;
    echoed_0[i32(34)] = scatter_block_0.transfer_axes_0.z;
    echoed_0[i32(35)] = scatter_block_0.transfer_axes_0.w;
    echoed_0[i32(36)] = scatter_block_0.shadow_axes_0.x;
    echoed_0[i32(37)] = scatter_block_0.shadow_axes_0.y;
    echoed_0[i32(38)] = scatter_block_0.shadow_axes_0.z;
    echoed_0[i32(39)] = scatter_block_0.shadow_axes_0.w;
    echoed_0[i32(40)] = scatter_block_0.classic_axes_0.x;
    echoed_0[i32(41)] = scatter_block_0.classic_axes_0.y;
    echoed_0[i32(42)] = scatter_block_0.classic_axes_0.z;
    echoed_0[i32(43)] = scatter_block_0.classic_axes_0.w;
    echoed_0[i32(44)] = scatter_block_0.classic_shadow_axes_0.x;
    echoed_0[i32(45)] = scatter_block_0.classic_shadow_axes_0.y;
    echoed_0[i32(46)] = scatter_block_0.classic_shadow_axes_0.z;
    echoed_0[i32(47)] = scatter_block_0.classic_shadow_axes_0.w;
    echoed_0[i32(48)] = scatter_block_0.coat_axes_0.x;
    echoed_0[i32(49)] = scatter_block_0.coat_axes_0.y;
    echoed_0[i32(50)] = scatter_block_0.coat_axes_0.z;
    echoed_0[i32(51)] = scatter_block_0.coat_axes_0.w;
    echoed_0[i32(52)] = scatter_block_0.normal_sigmas_mm_0.x;
    echoed_0[i32(53)] = scatter_block_0.normal_sigmas_mm_0.y;
    echoed_0[i32(54)] = scatter_block_0.coat_reflectance_0;
    return;
}

@compute
@workgroup_size(1, 1, 1)
fn echo_EyeBlock()
{
    echoed_0[i32(0)] = eye_block_0.iris_uv_0.x;
    echoed_0[i32(1)] = eye_block_0.iris_uv_0.y;
    echoed_0[i32(2)] = eye_block_0.iris_uv_0.z;
    echoed_0[i32(3)] = eye_block_0.iris_uv_0.w;
    echoed_0[i32(4)] = eye_block_0.sclera_radius_mm_0;
    echoed_0[i32(5)] = eye_block_0.limbus_radius_mm_0;
    echoed_0[i32(6)] = eye_block_0.limbus_width_mm_0;
    echoed_0[i32(7)] = eye_block_0.cornea_radius_mm_0;
    echoed_0[i32(8)] = eye_block_0.cornea_asphericity_0;
    echoed_0[i32(9)] = eye_block_0.refraction_index_0;
    echoed_0[i32(10)] = eye_block_0.tear_index_0;
    echoed_0[i32(11)] = eye_block_0.aqueous_index_0;
    echoed_0[i32(12)] = eye_block_0.iris_depth_mm_0;
    echoed_0[i32(13)] = eye_block_0.iris_slope_0;
    echoed_0[i32(14)] = eye_block_0.iris_radius_mm_0;
    echoed_0[i32(15)] = eye_block_0.pupil_radius_mm_0;
    echoed_0[i32(16)] = eye_block_0.pupil_in_map_0;
    echoed_0[i32(17)] = eye_block_0.virtual_cornea_0;
    echoed_0[i32(18)] = eye_block_0.cornea_roughness_deg_0;
    echoed_0[i32(19)] = eye_block_0.sclera_roughness_deg_0;
    echoed_0[i32(20)] = eye_block_0.sclera_normal_strength_0;
    echoed_0[i32(21)] = eye_block_0.meniscus_height_mm_0;
    echoed_0[i32(22)] = eye_block_0.iris_height_mm_0;
    return;
}

@compute
@workgroup_size(1, 1, 1)
fn echo_EyePlaceBlock()
{
    echoed_0[i32(0)] = eye_place_block_0.eye_x_0.x;
    echoed_0[i32(1)] = eye_place_block_0.eye_x_0.y;
    echoed_0[i32(2)] = eye_place_block_0.eye_x_0.z;
    echoed_0[i32(3)] = eye_place_block_0.eye_x_0.w;
    echoed_0[i32(4)] = eye_place_block_0.eye_y_0.x;
    echoed_0[i32(5)] = eye_place_block_0.eye_y_0.y;
    echoed_0[i32(6)] = eye_place_block_0.eye_y_0.z;
    echoed_0[i32(7)] = eye_place_block_0.eye_y_0.w;
    echoed_0[i32(8)] = eye_place_block_0.eye_z_0.x;
    echoed_0[i32(9)] = eye_place_block_0.eye_z_0.y;
    echoed_0[i32(10)] = eye_place_block_0.eye_z_0.z;
    echoed_0[i32(11)] = eye_place_block_0.eye_z_0.w;
    echoed_0[i32(12)] = eye_place_block_0.lid_upper_0.x;
    echoed_0[i32(13)] = eye_place_block_0.lid_upper_0.y;
    echoed_0[i32(14)] = eye_place_block_0.lid_upper_0.z;
    echoed_0[i32(15)] = eye_place_block_0.lid_upper_0.w;
    echoed_0[i32(16)] = eye_place_block_0.lid_lower_0.x;
    echoed_0[i32(17)] = eye_place_block_0.lid_lower_0.y;
    echoed_0[i32(18)] = eye_place_block_0.lid_lower_0.z;
    echoed_0[i32(19)] = eye_place_block_0.lid_lower_0.w;
    echoed_0[i32(20)] = eye_place_block_0.lamp_axes_0.x;
    echoed_0[i32(21)] = eye_place_block_0.lamp_axes_0.y;
    echoed_0[i32(22)] = eye_place_block_0.lamp_axes_0.z;
    echoed_0[i32(23)] = eye_place_block_0.lamp_axes_0.w;
    echoed_0[i32(24)] = eye_place_block_0.surroundings_axes_0.x;
    echoed_0[i32(25)] = eye_place_block_0.surroundings_axes_0.y;
    echoed_0[i32(26)] = eye_place_block_0.surroundings_axes_0.z;
    echoed_0[i32(27)] = eye_place_block_0.surroundings_axes_0.w;
    echoed_0[i32(28)] = eye_place_block_0.lid_radiance_0.x;
    echoed_0[i32(29)] = eye_place_block_0.lid_radiance_0.y;
    echoed_0[i32(30)] = eye_place_block_0.lid_radiance_0.z;
    echoed_0[i32(31)] = eye_place_block_0.lid_radiance_0.w;
    echoed_0[i32(32)] = eye_place_block_0.lid_radius_mm_0;
    return;
}

@compute
@workgroup_size(1, 1, 1)
fn echo_FrameBlock()
{
    echoed_0[i32(0)] = frame_block_0.radiance_sh_0[i32(0)].x;
    echoed_0[i32(1)] = frame_block_0.radiance_sh_0[i32(0)].y;
    echoed_0[i32(2)] = frame_block_0.radiance_sh_0[i32(0)].z;
    echoed_0[i32(3)] = frame_block_0.radiance_sh_0[i32(0)].w;
    echoed_0[i32(4)] = frame_block_0.radiance_sh_0[i32(1)].x;
    echoed_0[i32(5)] = frame_block_0.radiance_sh_0[i32(1)].y;
    echoed_0[i32(6)] = frame_block_0.radiance_sh_0[i32(1)].z;
    echoed_0[i32(7)] = frame_block_0.radiance_sh_0[i32(1)].w;
    echoed_0[i32(8)] = frame_block_0.radiance_sh_0[i32(2)].x;
    echoed_0[i32(9)] = frame_block_0.radiance_sh_0[i32(2)].y;
    echoed_0[i32(10)] = frame_block_0.radiance_sh_0[i32(2)].z;
    echoed_0[i32(11)] = frame_block_0.radiance_sh_0[i32(2)].w;
    echoed_0[i32(12)] = frame_block_0.radiance_sh_0[i32(3)].x;
    echoed_0[i32(13)] = frame_block_0.radiance_sh_0[i32(3)].y;
    echoed_0[i32(14)] = frame_block_0.radiance_sh_0[i32(3)].z;
    echoed_0[i32(15)] = frame_block_0.radiance_sh_0[i32(3)].w;
    echoed_0[i32(16)] = frame_block_0.radiance_sh_0[i32(4)].x;
    echoed_0[i32(17)] = frame_block_0.radiance_sh_0[i32(4)].y;
    echoed_0[i32(18)] = frame_block_0.radiance_sh_0[i32(4)].z;
    echoed_0[i32(19)] = frame_block_0.radiance_sh_0[i32(4)].w;
    echoed_0[i32(20)] = frame_block_0.radiance_sh_0[i32(5)].x;
    echoed_0[i32(21)] = frame_block_0.radiance_sh_0[i32(5)].y;
    echoed_0[i32(22)] = frame_block_0.radiance_sh_0[i32(5)].z;
    echoed_0[i32(23)] = frame_block_0.radiance_sh_0[i32(5)].w;
    echoed_0[i32(24)] = frame_block_0.radiance_sh_0[i32(6)].x;
    echoed_0[i32(25)] = frame_block_0.radiance_sh_0[i32(6)].y;
    echoed_0[i32(26)] = frame_block_0.radiance_sh_0[i32(6)].z;
    echoed_0[i32(27)] = frame_block_0.radiance_sh_0[i32(6)].w;
    echoed_0[i32(28)] = frame_block_0.radiance_sh_0[i32(7)].x;
    echoed_0[i32(29)] = frame_block_0.radiance_sh_0[i32(7)].y;
    echoed_0[i32(30)] = frame_block_0.radiance_sh_0[i32(7)].z;
    echoed_0[i32(31)] = frame_block_0.radiance_sh_0[i32(7)].w;
    echoed_0[i32(32)] = frame_block_0.radiance_sh_0[i32(8)].x;
    echoed_0[i32(33)] = frame_block_0.radiance_sh_0[i32(8)].y;
    echoed_0[i32(34)] = frame_block_0.radiance_sh_0[i32(8)].z;
    echoed_0[i32(35)] = frame_block_0.radiance_sh_0[i32(8)].w;
    echoed_0[i32(36)] = frame_block_0.clip_x_0.x;
    echoed_0[i32(37)] = frame_block_0.clip_x_0.y;
    echoed_0[i32(38)] = frame_block_0.clip_x_0.z;
    echoed_0[i32(39)] = frame_block_0.clip_x_0.w;
    echoed_0[i32(40)] = frame_block_0.clip_y_0.x;
    echoed_0[i32(41)] = frame_block_0.clip_y_0.y;
    echoed_0[i32(42)] = frame_block_0.clip_y_0.z;
    echoed_0[i32(43)] = frame_block_0.clip_y_0.w;
    echoed_0[i32(44)] = frame_block_0.clip_z_0.x;
    echoed_0[i32(45)] = frame_block_0.clip_z_0.y;
    echoed_0[i32(46)] = frame_block_0.clip_z_0.z;
    echoed_0[i32(47)] = frame_block_0.clip_z_0.w;
    echoed_0[i32(48)] = frame_block_0.clip_w_0.x;
    echoed_0[i32(49)] = frame_block_0.clip_w_0.y;
    echoed_0[i32(50)] = frame_block_0.clip_w_0.z;
    echoed_0[i32(51)] = frame_block_0.clip_w_0.w;
    echoed_0[i32(52)] = frame_block_0.eye_mm_0.x;
    echoed_0[i32(53)] = frame_block_0.eye_mm_0.y;
    echoed_0[i32(54)] = frame_block_0.eye_mm_0.z;
    echoed_0[i32(55)] = frame_block_0.eye_mm_0.w;
    echoed_0[i32(56)] = frame_block_0.ray_across_0.x;
    echoed_0[i32(57)] = frame_block_0.ray_across_0.y;
    echoed_0[i32(58)] = frame_block_0.ray_across_0.z;
    echoed_0[i32(59)] = frame_block_0.ray_across_0.w;
    echoed_0[i32(60)] = frame_block_0.ray_up_0.x;
    echoed_0[i32(61)] = frame_block_0.ray_up_0.y;
    echoed_0[i32(62)] = frame_block_0.ray_up_0.z;
    echoed_0[i32(63)] = frame_block_0.ray_up_0.w;
    echoed_0[i32(64)] = frame_block_0.ray_ahead_0.x;
    echoed_0[i32(65)] = frame_block_0.ray_ahead_0.y;
    echoed_0[i32(66)] = frame_block_0.ray_ahead_0.z;
    echoed_0[i32(67)] = frame_block_0.ray_ahead_0.w;
    echoed_0[i32(68)] = frame_block_0.background_0.x;
    echoed_0[i32(69)] = frame_block_0.background_0.y;
    echoed_0[i32(70)] = frame_block_0.background_0.z;
    echoed_0[i32(71)] = frame_block_0.background_0.w;
    echoed_0[i32(72)] = frame_block_0.footprint_0;
    echoed_0[i32(73)] = frame_block_0.sample_weight_0;
    echoed_0[i32(74)] = frame_block_0.uv_scale_mm_0;
    echoed_0[i32(75)] = frame_block_0.environment_scale_0;
    echoed_0[i32(76)] = frame_block_0.exposure_0;
    return;
}

@compute
@workgroup_size(1, 1, 1)
fn echo_LightBlock()
{
    echoed_0[i32(0)] = light_block_0.view_x_0.x;
    echoed_0[i32(1)] = light_block_0.view_x_0.y;
    echoed_0[i32(2)] = light_block_0.view_x_0.z;
    echoed_0[i32(3)] = light_block_0.view_x_0.w;
    echoed_0[i32(4)] = light_block_0.view_y_0.x;
    echoed_0[i32(5)] = light_block_0.view_y_0.y;
    echoed_0[i32(6)] = light_block_0.view_y_0.z;
    echoed_0[i32(7)] = light_block_0.view_y_0.w;
    echoed_0[i32(8)] = light_block_0.view_z_0.x;
    echoed_0[i32(9)] = light_block_0.view_z_0.y;
    echoed_0[i32(10)] = light_block_0.view_z_0.z;
    echoed_0[i32(11)] = light_block_0.view_z_0.w;
    echoed_0[i32(12)] = light_block_0.clip_x_1.x;
    echoed_0[i32(13)] = light_block_0.clip_x_1.y;
    echoed_0[i32(14)] = light_block_0.clip_x_1.z;
    echoed_0[i32(15)] = light_block_0.clip_x_1.w;
    echoed_0[i32(16)] = light_block_0.clip_y_1.x;
    echoed_0[i32(17)] = light_block_0.clip_y_1.y;
    echoed_0[i32(18)] = light_block_0.clip_y_1.z;
    echoed_0[i32(19)] = light_block_0.clip_y_1.w;
    echoed_0[i32(20)] = light_block_0.clip_w_1.x;
    echoed_0[i32(21)] = light_block_0.clip_w_1.y;
    echoed_0[i32(22)] = light_block_0.clip_w_1.z;
    echoed_0[i32(23)] = light_block_0.clip_w_1.w;
    echoed_0[i32(24)] = light_block_0.direction_0.x;
    echoed_0[i32(25)] = light_block_0.direction_0.y;
    echoed_0[i32(26)] = light_block_0.direction_0.z;
    echoed_0[i32(27)] = light_block_0.direction_0.w;
    echoed_0[i32(28)] = light_block_0.position_mm_0.x;
    echoed_0[i32(29)] = light_block_0.position_mm_0.y;
    echoed_0[i32(30)] = light_block_0.position_mm_0.z;
    echoed_0[i32(31)] = light_block_0.position_mm_0.w;
    echoed_0[i32(32)] = light_block_0.irradiance_0.x;
    echoed_0[i32(33)] = light_block_0.irradiance_0.y;
    echoed_0[i32(34)] = light_block_0.irradiance_0.z;
    echoed_0[i32(35)] = light_block_0.irradiance_0.w;
    echoed_0[i32(36)] = light_block_0.cone_cosines_0.x;
    echoed_0[i32(37)] = light_block_0.cone_cosines_0.y;
    echoed_0[i32(38)] = light_block_0.depth_mm_0.x;
    echoed_0[i32(39)] = light_block_0.depth_mm_0.y;
    echoed_0[i32(40)] = light_block_0.near_0;
    echoed_0[i32(41)] = light_block_0.target_distance_mm_0;
    echoed_0[i32(42)] = light_block_0.blur_texels_0;
    return;
}

