// What skinshade adds to pygfx's mesh shader. Every formula of the lighting model is a function skin_...
// of the library; here is what it is given: attributes, maps, and the depths that pygfx's lights see.
{$ include 'pygfx.light_common.wgsl' $}
{$ include 'skinshade.skin.wgsl' $}
{$ include 'skinshade.depths.wgsl' $}

// -- attributes: {{ skin_numbers }} numbers a vertex in one buffer -----------------------------------------

$$ for channel, (first, count) in skin_channels.items()
$$ if count == 1
fn load_s_texcoords{{ channel }}(vertex: i32) -> f32 {
    return load_s_skin(vertex * {{ skin_numbers }} + {{ first }});
}
$$ else
fn load_s_texcoords{{ channel }}(vertex: i32) -> vec3<f32> {
    let first = vertex * {{ skin_numbers }} + {{ first }};
    return vec3<f32>(load_s_skin(first), load_s_skin(first + 1), load_s_skin(first + 2));
}
$$ endif
$$ endfor

struct SkinSurface {
    position: vec3<f32>,
    view: vec3<f32>,
    mesh_normal: vec3<f32>,
    sharp: vec3<f32>,
    blurred: vec3<f32>,
    seen: mat3x3<f32>,   // rows, as the library has them: the normal of each channel
    tensor: mat3x3<f32>,
    gain: vec3<f32>,
    albedo: vec3<f32>,
    curvature_per_mm: f32,
    gloss: f32,
    reflectance: f32,
};

// Curvature is that of the mesh: a body twice as large is half as curved, and UVs are twice as long.
fn skinshade_scale() -> f32 {
    return length(u_wobject.world_transform[0].xyz);
}

$$ if skin_tier == "tensor"
fn skinshade_tensor(upper: vec3<f32>, lower: vec3<f32>) -> mat3x3<f32> {
    let m = u_wobject.world_transform;
    let scale = skinshade_scale();
    let turn = mat3x3<f32>(m[0].xyz / scale, m[1].xyz / scale, m[2].xyz / scale);
    let of_mesh = mat3x3<f32>(upper, vec3<f32>(upper.y, lower.xy), vec3<f32>(upper.z, lower.yz));
    return turn * of_mesh * transpose(turn) * (1.0 / scale);
}
$$ endif

$$ if use_normal_map is defined
// Sharp, narrow and wide blur, none of them made of unit length.
fn skinshade_fetch(uv: vec2<f32>, frame: mat3x3<f32>) -> mat3x3<f32> {
    let size = vec2<f32>(textureDimensions(t_normal_map));
    let level = skin_map_level(size, dpdx(uv), dpdy(uv));
    let longer = max(size.x, size.y);
    let uv_scale_mm = {{ skin_uv_scale_mm }} * skinshade_scale();
    let blurs = u_scatter.normal_sigmas_mm;
    let levels = vec3<f32>(
        level,
        skin_blur_level(blurs.x, uv_scale_mm, longer, level),
        skin_blur_level(blurs.y, uv_scale_mm, longer, level));
    let normal = frame[2];
    let tangent = skin_unit_vectors(frame[0] - normal * dot(frame[0], normal));
    let side = cross(normal, tangent);
    let upright = mat3x3<f32>(tangent, side * sign(dot(side, frame[1])), normal);
    var fetched: mat3x3<f32>;
    for (var i = 0; i < 3; i++) {
        fetched[i] = upright * (textureSampleLevel(t_normal_map, s_normal_map, uv, levels[i]).xyz * 2.0 - 1.0);
    }
    return fetched;
}
$$ endif

fn skinshade_blend() -> mat3x3<f32> {
    return mat3x3<f32>(u_scatter.blend_red.xyz, u_scatter.blend_green.xyz, u_scatter.blend_blue.xyz);
}

// -- light ------------------------------------------------------------------------------------------------

fn skinshade_diffused(s: SkinSurface, to_light: vec3<f32>) -> vec3<f32> {
    $$ if skin_tier == "tensor"
    let bends = skin_directional_curvature(s.tensor, s.mesh_normal, to_light);
    return skin_direct_tensor(
        t_ring_table, s_table, u_scatter.ring_axes, t_transfer_table, s_table, u_scatter.transfer_axes,
        s.seen, to_light, bends.x, bends.y, s.gain);
    $$ else
    return skin_direct_scalar(t_sphere_table, s_table, u_scatter.sphere_axes, s.seen, to_light, s.curvature_per_mm, s.gain);
    $$ endif
}

fn skinshade_add(light: SkinIncident, s: SkinSurface, sum: ptr<function, ReflectedLight>) {
    $$ if skin_taps > 0
    let passed = skin_transmittance(light.thickness_mm, u_scatter.albedo.xyz, u_scatter.sigma_per_mm.xyz);
    let deep = skin_direct_deep_scatter(
        passed / u_scatter.albedo.xyz, dot(s.blurred, light.to_light), u_skin.deep_scatter_strength);
    (*sum).direct_diffuse += light.radiance * deep * u_skin.deep_scatter_tint.xyz * s.albedo;
    $$ endif
    // The tables' ends are pinned: where the wide filter sees no light, none bleeds in.
    if (light.shadow_filter == 0.0) {
        return;
    }
    let shadow = skin_diffused_shadow(
        t_shadow_table, s_table, u_scatter.shadow_axes,
        light.shadow_filter, dot(s.mesh_normal, light.to_light), u_skin.shadow_filter_width_mm);
    (*sum).direct_diffuse += light.radiance * skinshade_diffused(s, light.to_light) * shadow * s.albedo;
    (*sum).direct_specular += light.radiance
        * skin_sharpened_shadow(light.shadow_filter, u_skin.shadow_sharpening)
        * skin_specular(s.sharp, s.view, light.to_light, s.gloss, s.reflectance);
}

// pygfx calls it for its ambient light and light maps: an even sky, of which band 0 alone is left.
fn RE_IndirectDiffuse(irradiance: vec3<f32>, g: GeometricContext, s: SkinSurface, sum: ptr<function, ReflectedLight>) {
    let radiance = irradiance * RECIPROCAL_PI;
    let even = radiance / {{ skin_even_basis }};
    let o = vec3<f32>(0.0);
    let bands = mat3x3<f32>(s.gain, o, o);
    (*sum).indirect_diffuse += s.albedo * skin_ambient_irradiance(
        mat3x3<f32>(vec3<f32>(even.r, 0.0, 0.0), o, o),
        mat3x3<f32>(vec3<f32>(even.g, 0.0, 0.0), o, o),
        mat3x3<f32>(vec3<f32>(even.b, 0.0, 0.0), o, o),
        s.seen, bands);
    (*sum).indirect_specular += radiance * skin_ambient_specular_fresnel(dot(s.sharp, s.view), s.gloss, s.reflectance);
}
