#version 330
// Your shader: SkinProgram inserts skinshade's functions, blocks and tables after the line above.
uniform vec3 eye_mm, to_light, light_radiance;
uniform float uv_scale_mm;
uniform sampler2D albedo_map, normal_map;
in vec3 position, normal;
in vec4 tangent;
in vec2 uv;
in vec3 xx_xy_xz, yy_yz_zz, curvature;
out vec4 colour;

vec3 world_normal(vec3 n, float level)
{
    vec3 t = normalize(tangent.xyz - n * dot(tangent.xyz, n)), b = cross(n, t) * sign(tangent.w);
    return mat3(t, b, n) * textureLod(normal_map, uv, level).xyz; // not normalised: the length matters
}

void main()
{
    vec3 n = normalize(normal), view = normalize(eye_mm - position);
    vec2 size = vec2(textureSize(normal_map, 0));
    float level = skin_map_level(size, dFdx(uv), dFdy(uv)), side = max(size.x, size.y);
    vec2 sigmas_mm = scatter_block.normal_sigmas_mm;
    mat3 fetched = mat3(
        world_normal(n, level),
        world_normal(n, skin_blur_level(sigmas_mm.x, uv_scale_mm, side, level)),
        world_normal(n, skin_blur_level(sigmas_mm.y, uv_scale_mm, side, level)));
    mat3 weights = mat3(scatter_block.blend_red.xyz, scatter_block.blend_green.xyz, scatter_block.blend_blue.xyz);
    mat3 tensor = mat3(xx_xy_xz, xx_xy_xz.y, yy_yz_zz.xy, xx_xy_xz.z, yy_yz_zz.yz);

    float gloss = skin_gloss_of_relief(skin_block.gloss, length(fetched[0]));
    vec3 gain = skin_energy_gain(scatter_block.albedo.xyz, scatter_block.rms_radius_mm.xyz, curvature);
    vec2 curvatures = skin_directional_curvature(tensor, n, to_light);
    vec3 diffuse = skin_direct_tensor(
        ring_lut, scatter_block.ring_axes, transfer_lut, scatter_block.transfer_axes,
        skin_blend_normals(fetched, weights), to_light, curvatures.x, curvatures.y, gain);
    vec2 albedo_size = vec2(textureSize(albedo_map, 0));
    vec3 albedo = textureLod(albedo_map, uv, skin_map_level(albedo_size, dFdx(uv), dFdy(uv))).rgb;
    vec3 sharp = normalize(fetched[0]);
    float f0 = skin_block.reflectance, n_dot_v = dot(sharp, view);
    vec2 coat = skin_coat(coat_lut, scatter_block.coat_axes, n_dot_v, gloss, f0, scatter_block.coat_reflectance);
    vec3 body = albedo * skin_view_factor(albedo, n_dot_v, f0) * (1.0 - coat.x);
    float highlight = skin_coat_highlight(sharp, view, to_light, gloss, f0);
    colour = vec4(light_radiance * (body * diffuse + highlight), 1.0);
}
