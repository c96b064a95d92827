// Your shader; the text of skinshade.gpu.wgsl_library() precedes it.
struct Frame { clip : mat4x4<f32>, eye : vec4<f32>, to_light : vec4<f32>, radiance : vec4<f32> };
@group(0) @binding(0) var<uniform> frame : Frame;
@group(0) @binding(1) var albedo_map : texture_2d<f32>;
@group(1) @binding(0) var<uniform> skin_block : SkinBlock;       // skinshade's blocks and tables: declare those
@group(1) @binding(1) var<uniform> scatter_block : ScatterBlock; // that you use, in any group
@group(1) @binding(2) var ring_lut : texture_2d<f32>;
@group(1) @binding(3) var transfer_lut : texture_2d<f32>;
@group(1) @binding(4) var coat_lut : texture_2d<f32>;
@group(1) @binding(5) var lut_sampler : sampler;

struct Vertex {
    @location(0) position : vec3<f32>,
    @location(1) normal : vec3<f32>,
    @location(2) uv : vec2<f32>,
    @location(3) xx_xy_xz : vec3<f32>,
    @location(4) yy_yz_zz : vec3<f32>,
    @location(5) curvature : vec3<f32>,
};
struct Fragment { @builtin(position) clip : vec4<f32>, @location(0) position : vec3<f32>,
    @location(1) normal : vec3<f32>, @location(2) uv : vec2<f32>, @location(3) xx_xy_xz : vec3<f32>,
    @location(4) yy_yz_zz : vec3<f32>, @location(5) curvature : vec3<f32> };

@vertex fn vertex_main(v : Vertex) -> Fragment {
    let clip = frame.clip * vec4<f32>(v.position, 1.0);
    return Fragment(clip, v.position, v.normal, v.uv, v.xx_xy_xz, v.yy_yz_zz, v.curvature);
}
@fragment fn fragment_main(v : Fragment) -> @location(0) vec4<f32> {
    let n = normalize(v.normal);
    let view = normalize(frame.eye.xyz - v.position);
    let light = frame.to_light.xyz;
    let a = v.xx_xy_xz;
    let b = v.yy_yz_zz;
    let tensor = mat3x3<f32>(a, vec3<f32>(a.y, b.x, b.y), vec3<f32>(a.z, b.y, b.z));
    let s = scatter_block;
    let gain = skin_energy_gain(s.albedo.xyz, s.rms_radius_mm.xyz, v.curvature);
    let curvatures = skin_directional_curvature(tensor, n, light);
    let diffuse = skin_direct_tensor(ring_lut, lut_sampler, s.ring_axes, transfer_lut, lut_sampler,
        s.transfer_axes, mat3x3<f32>(n, n, n), light, curvatures.x, curvatures.y, gain);
    let gloss = skin_block.gloss;
    let f0 = skin_block.reflectance;
    let albedo = textureSampleLevel(albedo_map, lut_sampler, v.uv, 0.0).rgb;
    let coat = skin_coat(coat_lut, lut_sampler, s.coat_axes, dot(n, view), gloss, f0, s.coat_reflectance);
    let body = albedo * skin_view_factor(albedo, dot(n, view), f0) * (1.0 - coat.x);
    let highlight = skin_coat_highlight(n, view, light, gloss, f0);
    return vec4<f32>(frame.radiance.rgb * (body * diffuse + highlight), 1.0);
}
