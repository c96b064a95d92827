// Wide shadow filter and thickness of the body from pygfx's depth maps, as in skinshade.shading.shadow and
// skinshade.shading.deep_scatter. The bindings are those of pygfx: comparison samplers and cube maps.

struct SkinIncident {
    to_light: vec3<f32>,
    radiance: vec3<f32>,
    shadow_filter: f32,
    thickness_mm: f32,
};

// Camera of a light, recovered from its matrix; parallel or perspective.
struct SkinView {
    right: vec3<f32>,
    up: vec3<f32>,
    forward: vec3<f32>,
    projection: mat4x4<f32>, // rows; depths of a parallel projection begin at the near plane
};

fn skinshade_row(m: mat4x4<f32>, i: i32) -> vec4<f32> {
    return vec4<f32>(m[0][i], m[1][i], m[2][i], m[3][i]);
}

fn skinshade_view(m: mat4x4<f32>) -> SkinView {
    let z = skinshade_row(m, 2);
    let w = skinshade_row(m, 3);
    let parallel = dot(w.xyz, w.xyz) < 1e-12;
    var v: SkinView;
    v.right = normalize(skinshade_row(m, 0).xyz);
    v.up = normalize(skinshade_row(m, 1).xyz);
    v.forward = normalize(select(w.xyz, z.xyz, parallel));
    let slope = dot(z.xyz, v.forward);
    let zero = vec4<f32>(0.0);
    v.projection = mat4x4<f32>(zero, zero, vec4<f32>(0.0, 0.0, slope, 0.0), vec4<f32>(0.0, 0.0, 0.0, 1.0));
    if (!parallel) {
        v.projection[2].w = z.w - slope * w.w;
        v.projection[3] = vec4<f32>(0.0, 0.0, 1.0, 0.0);
    }
    return v;
}

// Receiver of the wide filter: its position, and the increase of the plane's depth per mm to the right and down.
struct SkinReceiver {
    position: vec3<f32>,
    slope: vec2<f32>,
};

fn skinshade_receiver(v: SkinView, s: SkinSurface, to_light: vec3<f32>) -> SkinReceiver {
    return SkinReceiver(
        skin_shadow_receiver(s.position, s.mesh_normal, to_light, s.curvature_per_mm),
        skin_shadow_slope(s.mesh_normal, to_light, s.curvature_per_mm, v.right, v.up));
}

// Position of a tap, and in w the depth that receiver plane and bias add at the tap, mm.
fn skinshade_tap(v: SkinView, r: SkinReceiver, tap: i32) -> vec4<f32> {
    let across = 0.5 * u_skin.shadow_filter_width_mm * SKIN_SHADOW_DISK_{{ skin_filter_taps }}[tap];
    return vec4<f32>(r.position + v.right * across.x - v.up * across.y, dot(r.slope, across) - {{ skin_bias_mm }});
}

$$ if receive_shadow and num_dir_lights + num_spot_lights > 0
fn skinshade_filter(depths: texture_depth_2d_array, layer: i32, m: mat4x4<f32>, s: SkinSurface, to_light: vec3<f32>) -> f32 {
    let v = skinshade_view(m);
    let r = skinshade_receiver(v, s, to_light);
    var total = 0.0;
    for (var tap = 0; tap < {{ skin_filter_taps }}; tap++) {
        let point = skinshade_tap(v, r, tap);
        let clip = m * vec4<f32>(point.xyz, 1.0);
        let p = clip.xy / clip.w;
        let depth = (clip.z + v.projection[2].z * point.w) / (clip.w + v.projection[3].z * point.w);
        let uv = p * vec2<f32>(0.5, -0.5) + 0.5;
        let lit = textureSampleCompareLevel(depths, u_shadow_sampler, uv, layer, saturate(depth));
        total += select(1.0, lit, clip.w > 0.0 && all(abs(p) <= vec2<f32>(1.0)));
    }
    return total / f32({{ skin_filter_taps }});
}

$$ if skin_taps > 0
fn skinshade_thickness(depths: texture_depth_2d_array, layer: i32, m: mat4x4<f32>, s: SkinSurface) -> f32 {
    let v = skinshade_view(m);
    let size = vec2<f32>(textureDimensions(depths));
    let inward = skin_inward_offset(s.position, s.mesh_normal, u_skin.deep_scatter_offset_mm);
    var total = 0.0;
    for (var tap = 0; tap < {{ skin_taps }}; tap++) {
        let across = SKIN_POISSON_{{ skin_taps }}[tap] * vec2<f32>(1.0, -1.0) * u_skin.deep_scatter_filter_mm;
        let clip = m * vec4<f32>(inward + v.right * across.x + v.up * across.y, 1.0);
        let p = clip.xyz / clip.w;
        let uv = p.xy * vec2<f32>(0.5, -0.5) + 0.5;
        let nearest = textureLoad(depths, vec2<i32>(clamp(uv * size, vec2<f32>(0.0), size - 1.0)), layer, 0);
        let thickness = skin_linear_depth(p.z, v.projection) - skin_linear_depth(nearest, v.projection);
        let covered = nearest < 1.0 && clip.w > 0.0 && all(abs(p.xy) <= vec2<f32>(1.0));
        total += select(0.0, max(thickness, 0.0), covered);
    }
    return total / f32({{ skin_taps }});
}
$$ endif
$$ endif

$$ if receive_shadow and num_point_lights > 0
// Filter of a point light: taps on a disk across the ray to the light, looked up in pygfx's cube map.
fn skinshade_filter_cube(layer: i32, light: PointLight, s: SkinSurface, to_light: vec3<f32>) -> f32 {
    let reference = select(vec3<f32>(0.0, 1.0, 0.0), vec3<f32>(1.0, 0.0, 0.0), abs(to_light.y) > 0.9);
    var v: SkinView;
    v.forward = -to_light;
    v.right = normalize(cross(to_light, reference));
    v.up = cross(v.right, v.forward);
    let r = skinshade_receiver(v, s, to_light);
    var total = 0.0;
    for (var tap = 0; tap < {{ skin_filter_taps }}; tap++) {
        let point = skinshade_tap(v, r, tap);
        let towards = normalize(light.world_transform[3].xyz - point.xyz);
        let position = point.xyz - towards * point.w;
        total += get_cube_shadow(
            u_shadow_map_point_light, u_shadow_sampler, layer, light.light_view_proj_matrix, position, towards, 0.0);
    }
    return total / f32({{ skin_filter_taps }});
}
$$ endif
