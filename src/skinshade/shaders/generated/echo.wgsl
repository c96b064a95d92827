@binding(2) @group(0) var<storage, read_write> echoed_0 : array<f32>;

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
    @align(16) normal_sigmas_mm_0 : vec2<f32>,
};

@binding(1) @group(0) var<uniform> scatter_block_0 : ScatterBlock_std140_0;
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
    echoed_0[i32(48)] = scatter_block_0.normal_sigmas_mm_0.x;
    echoed_0[i32(49)] = scatter_block_0.normal_sigmas_mm_0.y;
    return;
}

