// Additions to pygfx's mesh shader. The formulas of the lighting model are the functions skin_... of the library; these
// functions pass pygfx's attributes, texture maps and depth maps to them.
{$ include 'pygfx.light_common.wgsl' $}
{$ include 'skinshade.skin.wgsl' $}
{$ include 'skinshade.depths.wgsl' $}

// -- attributes: {{ skin_numbers }} numbers per vertex in one buffer ----------------------------------------

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
    normals: mat3x3<f32>, // normals of the channels, one per row of the library's matrix
    tensor: mat3x3<f32>,
    gain: vec3<f32>,
    albedo: vec3<f32>,
    curvature_per_mm: f32,
    gloss: f32,
    reflectance: f32,
};

// Scale of the object. Attributes are in the scale of the mesh: an object of twice the size has half the curvature and
// twice the length per unit of UV.
fn skinshade_scale() -> f32 {
    return length(u_wobject.world_transform[0].xyz);
}

$$ if skin_tier == "tensor"
fn skinshade_tensor(upper: vec3<f32>, lower: vec3<f32>) -> mat3x3<f32> {
    let m = u_wobject.world_transform;
    let scale = skinshade_scale();
    let rotation = mat3x3<f32>(m[0].xyz / scale, m[1].xyz / scale, m[2].xyz / scale);
    let tensor = mat3x3<f32>(upper, vec3<f32>(upper.y, lower.xy), vec3<f32>(upper.z, lower.yz));
    return rotation * tensor * transpose(rotation) * (1.0 / scale);
}
$$ endif

$$ if use_normal_map is defined
// Normals of the normal map: sharp, narrow blur, wide blur; not of unit length.
fn skinshade_fetch(uv: vec2<f32>, frame: mat3x3<f32>) -> mat3x3<f32> {
    let size = vec2<f32>(textureDimensions(t_normal_map));
    let level = skin_map_level(size, dpdx(uv), dpdy(uv));
    let map_size = max(size.x, size.y);
    let uv_scale_mm = {{ skin_uv_scale_mm }} * skinshade_scale();
    let blurs = u_scatter.normal_sigmas_mm;
    let levels = vec3<f32>(
        level,
        skin_blur_level(blurs.x, uv_scale_mm, map_size, level),
        skin_blur_level(blurs.y, uv_scale_mm, map_size, level));
    let normal = frame[2];
    let tangent = skin_unit_vectors(frame[0] - normal * dot(frame[0], normal));
    let side = cross(normal, tangent);
    let orthonormal = mat3x3<f32>(tangent, side * sign(dot(side, frame[1])), normal);
    var fetched: mat3x3<f32>;
    for (var i = 0; i < 3; i++) {
        fetched[i] = orthonormal * (textureSampleLevel(t_normal_map, s_normal_map, uv, levels[i]).xyz * 2.0 - 1.0);
    }
    return fetched;
}
$$ endif

fn skinshade_blend() -> mat3x3<f32> {
    return mat3x3<f32>(u_scatter.blend_red.xyz, u_scatter.blend_green.xyz, u_scatter.blend_blue.xyz);
}

// -- light ------------------------------------------------------------------------------------------------

fn skinshade_diffuse(s: SkinSurface, to_light: vec3<f32>) -> vec3<f32> {
    $$ if skin_tier == "tensor"
    let curvatures = skin_directional_curvature(s.tensor, s.mesh_normal, to_light);
    return skin_direct_tensor(
        t_ring_table, s_table, u_scatter.ring_axes, t_transfer_table, s_table, u_scatter.transfer_axes,
        s.normals, to_light, curvatures.x, curvatures.y, s.gain);
    $$ else
    return skin_direct_scalar(t_sphere_table, s_table, u_scatter.sphere_axes, s.normals, to_light, s.curvature_per_mm, s.gain);
    $$ endif
}

fn skinshade_highlight(s: SkinSurface, to_light: vec3<f32>) -> f32 {
    $$ if skin_specular == "blinn-phong"
    return skin_specular(s.sharp, s.view, to_light, s.gloss, s.reflectance);
    $$ else
    let first = skin_coat_highlight(s.sharp, s.view, to_light, s.gloss, s.reflectance);
    $$ if skin_specular == "ggx-two-lobes"
    let second = skin_coat_highlight(s.sharp, s.view, to_light, skin_second_gloss(s.gloss), s.reflectance);
    return mix(first, second, {{ skin_sharp_lobe_share }});
    $$ else
    return first;
    $$ endif
    $$ endif
}

// Share of an even sky that the coat reflects to the eye.
fn skinshade_sky_share(s: SkinSurface) -> f32 {
    let n_dot_v = dot(s.sharp, s.view);
    $$ if skin_specular == "blinn-phong"
    return skin_ambient_specular_fresnel(n_dot_v, s.gloss, s.reflectance);
    $$ else
    let first = skin_coat(
        t_coat_table, s_table, u_scatter.coat_axes, n_dot_v, s.gloss, s.reflectance, u_scatter.coat_reflectance);
    $$ if skin_specular == "ggx-two-lobes"
    let second = skin_coat(
        t_coat_table, s_table, u_scatter.coat_axes,
        n_dot_v, skin_second_gloss(s.gloss), s.reflectance, u_scatter.coat_reflectance);
    return mix(first.x, second.x, {{ skin_sharp_lobe_share }});
    $$ else
    return first.x;
    $$ endif
    $$ endif
}

// Share of the light in the body that leaves towards the eye.
fn skinshade_body(s: SkinSurface, albedo: vec3<f32>) -> vec3<f32> {
    $$ if skin_boundary == "blender-skin"
    let factor = skin_closure_view_factor(albedo, dot(s.sharp, s.view));
    $$ else
    let factor = skin_view_factor(albedo, dot(s.sharp, s.view), u_skin.reflectance);
    $$ endif
    $$ if skin_specular == "blinn-phong"
    return albedo * factor * skin_diffuse_share(dot(s.mesh_normal, s.view), s.gloss, s.reflectance);
    $$ else
    return albedo * factor * (1.0 - skinshade_sky_share(s));
    $$ endif
}

fn skinshade_add(light: SkinIncident, s: SkinSurface, sum: ptr<function, ReflectedLight>) {
    // The shadow table is 0 where the wide filter is 0, so that no light bleeds in.
    var diffuse = vec3<f32>(0.0);
    if (light.shadow_filter > 0.0) {
        let shadow = skin_diffused_shadow(
            t_shadow_table, s_table, u_scatter.shadow_axes,
            light.shadow_filter, dot(s.mesh_normal, light.to_light), u_skin.shadow_filter_width_mm);
        diffuse = skinshade_diffuse(s, light.to_light) * shadow;
        (*sum).direct_specular += light.radiance
            * skin_sharpened_shadow(light.shadow_filter, u_skin.shadow_sharpening)
            * skinshade_highlight(s, light.to_light);
    }
    (*sum).direct_diffuse += light.radiance * diffuse * s.albedo;
    $$ if skin_taps > 0
    let transmittance = skin_transmittance(light.thickness_mm, u_scatter.albedo.xyz, u_scatter.sigma_per_mm.xyz);
    let through = skin_direct_deep_scatter(
        transmittance / u_scatter.albedo.xyz, dot(s.blurred, light.to_light), u_skin.deep_scatter_strength);
    (*sum).direct_diffuse += light.radiance * skin_through_beyond(through, diffuse)
        * u_skin.deep_scatter_tint.xyz * s.albedo;
    $$ endif
}

// pygfx calls this function for ambient light and light maps, which are a uniform environment: band 0 only.
fn RE_IndirectDiffuse(irradiance: vec3<f32>, g: GeometricContext, s: SkinSurface, sum: ptr<function, ReflectedLight>) {
    let radiance = irradiance * RECIPROCAL_PI;
    let band_0 = radiance / {{ skin_band_0_basis }};
    let zero = vec3<f32>(0.0);
    let bands = mat3x3<f32>(s.gain, zero, zero);
    (*sum).indirect_diffuse += s.albedo * skin_ambient_irradiance(
        mat3x3<f32>(vec3<f32>(band_0.r, 0.0, 0.0), zero, zero),
        mat3x3<f32>(vec3<f32>(band_0.g, 0.0, 0.0), zero, zero),
        mat3x3<f32>(vec3<f32>(band_0.b, 0.0, 0.0), zero, zero),
        s.normals, bands);
    (*sum).indirect_specular += radiance * skinshade_sky_share(s);
}
