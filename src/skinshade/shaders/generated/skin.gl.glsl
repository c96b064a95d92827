// The skinshade library, generated from shaders/skin by `python -m skinshade.codegen`.
vec3 skin_saturate_0(vec3 x)
{
    return clamp(x, vec3(0.0), vec3(1.0));
}

const vec2  SKIN_POISSON_32[32] = vec2[](vec2(-0.02096010930836201, 0.01299272011965513), vec2(0.69517123699188232, -0.04910685122013092), vec2(0.28034570813179016, 0.66283899545669556), vec2(0.03107489086687565, -0.69704329967498779), vec2(-0.49904009699821472, 0.54098159074783325), vec2(-0.70408397912979126, -0.14709833264350891), vec2(0.53451526165008545, -0.56702268123626709), vec2(-0.48678380250930786, -0.61486828327178955), vec2(0.68837428092956543, 0.41418349742889404), vec2(-0.14107078313827515, 0.8102262020111084), vec2(0.21897397935390472, -0.3123532235622406), vec2(0.31406453251838684, 0.24951401352882385), vec2(-0.83115619421005249, 0.28457203507423401), vec2(-0.40699386596679688, 0.14198443293571472), vec2(-0.10747358947992325, 0.41360348463058472), vec2(-0.19334819912910461, -0.34689420461654663), vec2(0.80768358707427979, -0.37000563740730286), vec2(0.33436411619186401, -0.82407790422439575), vec2(-0.79105347394943237, -0.45378401875495911), vec2(-0.23485180735588074, -0.86940687894821167), vec2(0.37255629897117615, -0.05855973064899445), vec2(0.5726354718208313, 0.72984015941619873), vec2(0.8966706395149231, 0.17047682404518127), vec2(-0.43273070454597473, 0.81860679388046265), vec2(0.1212853416800499, 0.92984902858734131), vec2(-0.42749753594398499, -0.15111121535301208), vec2(-0.94129812717437744, 0.00735718011856079), vec2(0.52211439609527588, -0.28702935576438904), vec2(-0.79033631086349487, 0.5402228832244873), vec2(-0.23410981893539429, -0.59940856695175171), vec2(0.28244560956954956, -0.563071608543396), vec2(0.57051312923431396, 0.18359191715717316));
const vec2  SKIN_POISSON_8[8] = vec2[](vec2(-0.16089901328086853, -0.04573699831962585), vec2(-0.89243310689926147, 0.18877510726451874), vec2(-0.17830690741539001, 0.7200586199760437), vec2(-0.53433239459991455, -0.70478206872940063), vec2(0.22474820911884308, -0.69165337085723877), vec2(0.5559992790222168, 0.1985180526971817), vec2(0.64686292409896851, -0.3364911675453186), vec2(0.33836102485656738, 0.67131179571151733));
float skin_saturate_1(float x)
{
    return clamp(x, 0.0, 1.0);
}

vec2 skin_saturate_2(vec2 x)
{
    return clamp(x, vec2(0.0), vec2(1.0));
}

float skin_map_level(vec2 map_extent, vec2 uv_along_x, vec2 uv_along_y)
{
    vec2 to_right_0 = uv_along_x * map_extent;
    vec2 upward_0 = uv_along_y * map_extent;
    float x_3 = dot(to_right_0, to_right_0);
    float y_0 = dot(upward_0, upward_0);
    return max(0.5 * log2(max(max(min(x_3, y_0), max(x_3, y_0) / 64.0), 1.00000000317107685e-30)), 0.0);
}

float skin_blur_level(float sigma_mm, float uv_scale_mm, float map_size, float hardware_level)
{
    return max(hardware_level, log2(max(2.0 * sigma_mm * map_size / uv_scale_mm, 1.0)));
}

vec3 skin_weighted(mat3x3 rows, vec3 weights)
{
    return weights.x * rows[0] + weights.y * rows[1] + weights.z * rows[2];
}

mat3x3 skin_blend_normals(mat3x3 fetched, mat3x3 blend)
{
    return mat3x3(skin_weighted(fetched, blend[0]), skin_weighted(fetched, blend[1]), skin_weighted(fetched, blend[2]));
}

float skin_safe_length(vec3 v)
{
    return sqrt(max(dot(v, v), 1.00000004581370497e-18));
}

vec3 skin_displaced(vec3 from_texture, vec3 from_mesh, vec3 mesh_normal)
{
    return from_texture + skin_safe_length(from_texture) * (from_mesh - mesh_normal);
}

mat3x3 skin_add_mesh_diffusion(mat3x3 from_texture, mat3x3 from_mesh, vec3 mesh_normal)
{
    return mat3x3(skin_displaced(from_texture[0], from_mesh[0], mesh_normal), skin_displaced(from_texture[1], from_mesh[1], mesh_normal), skin_displaced(from_texture[2], from_mesh[2], mesh_normal));
}

float skin_relief_bump(float m, float s)
{
    float _S1 = max(s, 9.99999971718068537e-10);
    float _S2 = max(1.0 - abs(m) / (4.40000009536743164 * _S1), 0.0);
    float t2_0 = _S2 * _S2;
    return _S1 * t2_0 * t2_0 * (0.16452799737453461 + _S2 * (-1.55506408214569092 + _S2 * (7.10253477096557617 + _S2 * (-16.75164794921875 + _S2 * (22.75126266479492188 + _S2 * (-15.08054447174072266 + _S2 * 3.76787090301513672))))));
}

vec3 skin_lengths(mat3x3 normals)
{
    return vec3(skin_safe_length(normals[0]), skin_safe_length(normals[1]), skin_safe_length(normals[2]));
}

vec3 skin_cosines(mat3x3 normals, vec3 light, vec3 lengths)
{
    return clamp(vec3(dot(normals[0], light), dot(normals[1], light), dot(normals[2], light)) / lengths, vec3(-1.0), vec3(1.0));
}

vec3 skin_curvature_table(sampler2D lut, vec4 lut_axes, vec3 cos_theta, float curvature_per_mm)
{
    float row_0 = sqrt(max(curvature_per_mm, 0.0));
    vec2 _S3 = lut_axes.xz;
    vec2 _S4 = lut_axes.yw;
    return vec3((textureLod((lut), (skin_saturate_2((vec2(cos_theta.x, row_0) - _S3) * _S4)), (0.0))).xyz.x, (textureLod((lut), (skin_saturate_2((vec2(cos_theta.y, row_0) - _S3) * _S4)), (0.0))).xyz.y, (textureLod((lut), (skin_saturate_2((vec2(cos_theta.z, row_0) - _S3) * _S4)), (0.0))).xyz.z);
}

vec3 skin_lost_relief(vec3 lengths, vec3 cos_theta)
{
    vec3 slope_0 = sqrt(max(- log(clamp(lengths, vec3(0.00100000004749745), vec3(1.0))) * (1.0 - cos_theta * cos_theta), vec3(0.0)));
    return vec3(skin_relief_bump(lengths.x * cos_theta.x, slope_0.x), skin_relief_bump(lengths.y * cos_theta.y, slope_0.y), skin_relief_bump(lengths.z * cos_theta.z, slope_0.z));
}

vec3 skin_direct_scalar(sampler2D lut, vec4 lut_axes, mat3x3 normals, vec3 light, float curvature_per_mm, vec3 gain)
{
    vec3 lengths_2 = skin_lengths(normals);
    vec3 cos_theta_2 = skin_cosines(normals, light, lengths_2);
    return gain * (lengths_2 * skin_curvature_table(lut, lut_axes, cos_theta_2, abs(curvature_per_mm)) + skin_lost_relief(lengths_2, cos_theta_2));
}

vec3 skin_transfer(sampler2D transfer, vec4 transfer_axes, float k_per_mm)
{
    return (textureLod((transfer), (skin_saturate_2((vec2(sqrt(max(k_per_mm, 0.0)), 0.5) - transfer_axes.xz) * transfer_axes.yw)), (0.0))).xyz;
}

vec3 skin_direct_tensor(sampler2D lut, vec4 lut_axes, sampler2D transfer, vec4 transfer_axes, mat3x3 normals, vec3 light, float directional_per_mm, float total_per_mm, vec3 gain)
{
    vec3 lengths_3 = skin_lengths(normals);
    vec3 cos_theta_3 = skin_cosines(normals, light, lengths_3);
    return gain * (lengths_3 * (skin_curvature_table(lut, lut_axes, cos_theta_3, directional_per_mm) * skin_transfer(transfer, transfer_axes, sqrt(max((total_per_mm - directional_per_mm) * (total_per_mm + directional_per_mm), 0.0)))) + skin_lost_relief(lengths_3, cos_theta_3));
}

vec3 skin_direct_diffused_normals(sampler2D lut, vec4 lut_axes, sampler2D transfer, vec4 transfer_axes, mat3x3 normals, vec3 relief_length, vec3 light, float directional_per_mm, vec3 gain)
{
    vec3 lengths_4 = skin_lengths(normals);
    vec3 cos_theta_4 = skin_cosines(normals, light, lengths_4);
    return gain * (skin_curvature_table(lut, lut_axes, cos_theta_4, directional_per_mm) * min(lengths_4 / max(skin_transfer(transfer, transfer_axes, directional_per_mm), vec3(9.99999997475242708e-07)), vec3(1.0)) + skin_lost_relief(relief_length, cos_theta_4));
}

vec3 skin_unexplained_length(sampler2D transfer, vec4 transfer_axes, mat3x3 from_texture, mat3x3 from_mesh, float total_per_mm)
{
    return skin_lengths(from_texture) * min(skin_lengths(from_mesh) / max(0.97500002384185791 * skin_transfer(transfer, transfer_axes, total_per_mm), vec3(9.99999997475242708e-07)), vec3(1.0));
}

vec2 skin_directional_curvature(mat3x3 tensor_world, vec3 normal, vec3 light)
{
    vec3 tangential_0 = light - normal * dot(light, normal);
    vec3 turn_0 = vec3(dot(tensor_world[0], tangential_0), dot(tensor_world[1], tangential_0), dot(tensor_world[2], tangential_0));
    float total_0 = sqrt(dot(tensor_world[0], tensor_world[0]) + dot(tensor_world[1], tensor_world[1]) + dot(tensor_world[2], tensor_world[2]));
    return vec2(min(sqrt(dot(turn_0, turn_0) / max(dot(tangential_0, tangential_0), 9.999999960041972e-13)), total_0), total_0);
}

vec3 skin_energy_gain(vec3 albedo, vec3 rms_radius_mm, vec3 curvature_per_mm)
{
    vec3 bent_0 = 1.20000004768371582 * rms_radius_mm * max(curvature_per_mm, vec3(0.0));
    vec3 bound_0 = albedo * bent_0;
    return 1.0 + (1.0 - albedo) * bent_0 / sqrt(1.0 + bound_0 * bound_0);
}

float skin_smoothstep(float p)
{
    float q_0 = skin_saturate_1(p);
    return q_0 * q_0 * (3.0 - 2.0 * q_0);
}

vec3 skin_diffused_shadow(sampler2D lut, vec4 lut_axes, float shadow_filter, float n_dot_l, float filter_width_mm)
{
    return (textureLod((lut), (skin_saturate_2((vec2(shadow_filter, max(n_dot_l, 0.05000000074505806) / filter_width_mm) - lut_axes.xz) * lut_axes.yw)), (0.0))).xyz;
}

float skin_sharpened_shadow(float shadow_filter, float sharpening)
{
    return skin_smoothstep((0.5 - sin(asin(1.0 - 2.0 * skin_saturate_1(shadow_filter)) / 3.0) - 0.5) * sharpening + 0.5);
}

float skin_variance_shadow(float mean_depth_mm, float mean_square_depth_mm2, float depth_mm)
{
    float _S5 = max(mean_square_depth_mm2 - mean_depth_mm * mean_depth_mm, 0.00999999977648258);
    float _S6 = max(depth_mm - mean_depth_mm, 0.0);
    return _S5 / (_S5 + _S6 * _S6);
}

vec3 skin_sh_bands(mat3x3 sh, vec3 d)
{
    float _S7 = d.y;
    float _S8 = d.z;
    float _S9 = d.x;
    return vec3(0.282094806432724 * sh[0].x, 0.48860251903533936 * (sh[0].y * _S7 + sh[0].z * _S8 + sh[1].x * _S9), 1.09254848957061768 * (sh[1].y * _S9 * _S7 + sh[1].z * _S7 * _S8 + sh[2].y * _S9 * _S8) + 0.31539157032966614 * sh[2].x * (3.0 * _S8 * _S8 - dot(d, d)) + 0.54627424478530884 * sh[2].z * (_S9 * _S9 - _S7 * _S7));
}

float skin_ambient_channel(mat3x3 sh, vec3 normal, vec3 band_transfer)
{
    return max(dot(skin_sh_bands(sh, normal), vec3(1.0, 1.0, skin_safe_length(normal)) * band_transfer * vec3(1.0, 0.66666668653488159, 0.25)), 0.0);
}

vec3 skin_ambient_irradiance(mat3x3 radiance_sh_red, mat3x3 radiance_sh_green, mat3x3 radiance_sh_blue, mat3x3 normals, mat3x3 band_transfer)
{
    mat3x3 t_0 = transpose(band_transfer);
    return vec3(skin_ambient_channel(radiance_sh_red, normals[0], t_0[0]), skin_ambient_channel(radiance_sh_green, normals[1], t_0[1]), skin_ambient_channel(radiance_sh_blue, normals[2], t_0[2]));
}

vec3 skin_unit_vectors(vec3 v)
{
    return v / skin_safe_length(v);
}

mat3x3 skin_ambient_normals(mat3x3 normals)
{
    return mat3x3(skin_unit_vectors(normals[0]), skin_unit_vectors(normals[1]), skin_unit_vectors(normals[2]));
}

vec3 skin_ambient_of_three(vec3 red, vec3 green, vec3 blue)
{
    return vec3(red.x, green.y, blue.z);
}

vec3 skin_bounced_visibility(vec3 visibility, vec3 albedo)
{
    return max(visibility, ((visibility * (2.04040002822875977 * albedo - 0.33239999413490295) + (-4.79510021209716797 * albedo + 0.64170002937316895)) * visibility + (2.75519990921020508 * albedo + 0.69029998779296875)) * visibility);
}

float skin_specular_visibility(float n_dot_v, float visibility, float roughness)
{
    float exponent_0 = (exp2((-16.0 * roughness - 1.0)));
    float base_0 = n_dot_v + visibility;
    float open_0;
    if(base_0 > 0.0)
    {
        open_0 = pow(base_0, exponent_0);
    }
    else
    {
        open_0 = 0.0;
    }
    return skin_saturate_1(open_0 - 1.0 + visibility);
}

float skin_linear_depth(float depth, mat4x4 projection)
{
    return abs((depth * projection[3][3] - projection[2][3]) / (projection[2][2] - depth * projection[3][2]));
}

vec3 skin_inward_offset(vec3 position_mm, vec3 normal, float offset_mm)
{
    return position_mm - normal * offset_mm;
}

float skin_thickness(sampler2D depth_map, mat4x4 projection, vec2 uv, float receiver_mm, vec2 radius_uv, int taps)
{
    int tap_0 = 0;
    float total_1 = 0.0;
    for(;;)
    {
        if(tap_0 < taps)
        {
        }
        else
        {
            break;
        }
        vec2 place_0;
        if(taps == 8)
        {
            place_0 = SKIN_POISSON_8[min(tap_0, 7)];
        }
        else
        {
            place_0 = SKIN_POISSON_32[min(tap_0, 31)];
        }
        float total_2 = total_1 + max(receiver_mm - skin_linear_depth((textureLod((depth_map), (uv + place_0 * radius_uv), (0.0))).x, projection), 0.0);
        tap_0 = tap_0 + 1;
        total_1 = total_2;
    }
    return total_1 / float(max(taps, 1));
}

vec3 skin_transmittance(float thickness_mm, vec3 albedo, vec3 sigma_per_mm)
{
    vec3 a2_0 = albedo * albedo;
    vec3 decay_0 = exp(- sigma_per_mm * thickness_mm);
    return (1.0 - a2_0) * decay_0 / (1.0 - a2_0 * decay_0 * decay_0);
}

float skin_classic_transmittance(float thickness_mm, float radius_mm)
{
    float t_1 = thickness_mm / radius_mm;
    return exp(-0.5 * t_1 * t_1);
}

vec3 skin_direct_deep_scatter(vec3 transmitted, float n_dot_l, float strength)
{
    return strength * transmitted * max(- n_dot_l, 0.0);
}

vec3 skin_ambient_deep_scatter(vec3 transmitted, vec3 irradiance_behind, float strength)
{
    return strength * transmitted * irradiance_behind;
}

float skin_specular_power(float gloss)
{
    return (exp2((13.0 * gloss)));
}

float skin_gloss_of_relief(float gloss, float normal_length)
{
    float l_0 = clamp(normal_length, 0.00100000004749745, 1.0);
    float power_0 = skin_specular_power(gloss);
    return log2(max(l_0 * power_0 / (l_0 + power_0 * (1.0 - l_0)), 1.0)) / 13.0;
}

float skin_gloss_from_roughness(float roughness)
{
    float _S10 = max(roughness, 0.00100000004749745);
    float r2_0 = _S10 * _S10;
    return clamp(log2(max(2.0 / (r2_0 * r2_0) - 2.0, 1.0)) / 13.0, 0.0, 1.0);
}

float skin_lobe(float n_dot_h, float n_dot_l, float n_dot_v, float power)
{
    float k_0 = (inversesqrt((3.14159274101257324 * power / 4.0 + 1.57079637050628662)));
    float _S11 = 1.0 - k_0;
    return (power + 2.0) / 6.28318548202514648 * pow(max(n_dot_h, 9.99999971718068537e-10), power) * (0.25 / ((k_0 + _S11 * n_dot_l) * (k_0 + _S11 * n_dot_v)));
}

float skin_specular(vec3 normal, vec3 view, vec3 light, float gloss, float reflectance)
{
    vec3 half_vector_0 = skin_unit_vectors(view + light);
    float n_dot_l_3 = skin_saturate_1(dot(normal, light));
    float n_dot_v_2 = clamp(dot(normal, view), 0.00009999999747379, 1.0);
    float n_dot_h_1 = skin_saturate_1(dot(normal, half_vector_0));
    float wide_0 = skin_specular_power(gloss);
    float away_0 = 1.0 - skin_saturate_1(dot(view, half_vector_0));
    float away2_0 = away_0 * away_0;
    return 3.14159274101257324 * (0.94999998807907104 * skin_lobe(n_dot_h_1, n_dot_l_3, n_dot_v_2, wide_0) + 0.05000000074505806 * skin_lobe(n_dot_h_1, n_dot_l_3, n_dot_v_2, min(wide_0 * wide_0, 8192.0))) * (reflectance + (1.0 - reflectance) * away2_0 * away2_0 * away_0) * n_dot_l_3;
}

vec3 skin_reflected(vec3 normal, vec3 view)
{
    return 2.0 * dot(normal, view) * normal - view;
}

float skin_ambient_specular_fresnel(float n_dot_v, float gloss, float reflectance)
{
    float away_1 = 1.0 - skin_saturate_1(n_dot_v);
    float away2_1 = away_1 * away_1;
    return reflectance + (1.0 - reflectance) * away2_1 * away2_1 * away_1 / (4.0 - 3.0 * gloss);
}

float skin_diffuse_share(float n_dot_v, float gloss, float reflectance)
{
    return 1.0 - skin_ambient_specular_fresnel(n_dot_v, gloss, reflectance);
}

float skin_turns(float y, float x)
{
    vec2 along_0 = abs(vec2(x, y));
    float _S12 = along_0.x;
    float _S13 = along_0.y;
    float r_0 = min(_S12, _S13) / max(max(_S12, _S13), 1.00000000317107685e-30);
    float r2_1 = r_0 * r_0;
    float turns_0 = r_0 * (0.15915107727050781 + r2_1 * (-0.05293257534503937 + r2_1 * (0.03076364658772945 + r2_1 * (-0.01842727139592171 + r2_1 * (0.00826387945562601 - r2_1 * 0.00181874714326113)))));
    float turns_1;
    if(_S13 > _S12)
    {
        turns_1 = 0.25 - turns_0;
    }
    else
    {
        turns_1 = turns_0;
    }
    if(x < 0.0)
    {
        turns_1 = 0.5 - turns_1;
    }
    else
    {
    }
    if(y < 0.0)
    {
        turns_1 = - turns_1;
    }
    else
    {
    }
    return turns_1;
}

vec2 skin_equirectangular_uv(vec3 direction)
{
    float _S14 = direction.x;
    float _S15 = direction.z;
    return vec2(0.5 + skin_turns(_S15, _S14), 2.0 * skin_turns(sqrt(_S14 * _S14 + _S15 * _S15), direction.y));
}

float skin_reflection_level(float power)
{
    return clamp(0.5 * log2(max(power, 1.0)), 0.0, 4.0);
}

vec3 skin_preconvolved(sampler2D preconvolved, vec2 uv, float power)
{
    float level_0 = skin_reflection_level(power);
    float _S16 = min(floor(level_0), 3.0);
    float row_1 = clamp(uv.y, 0.0078125, 0.9921875);
    float _S17 = uv.x;
    return mix((textureLod((preconvolved), (vec2(_S17, (_S16 + row_1) / 5.0)), (0.0))).xyz, (textureLod((preconvolved), (vec2(_S17, (_S16 + 1.0 + row_1) / 5.0)), (0.0))).xyz, vec3(level_0 - _S16));
}

vec3 skin_reflected_radiance(sampler2D preconvolved, vec3 direction, float gloss)
{
    vec2 uv_2 = skin_equirectangular_uv(direction);
    float power_4 = skin_specular_power(gloss);
    return mix(skin_preconvolved(preconvolved, uv_2, power_4 / 4.0), skin_preconvolved(preconvolved, uv_2, power_4 * power_4 / 4.0), vec3(0.05000000074505806));
}

vec3 skin_filmic(vec3 light)
{
    vec3 x_5 = max(light - 0.00400000018998981, vec3(0.0));
    vec3 _S18 = 6.19999980926513672 * x_5;
    return x_5 * (_S18 + 0.5) / (x_5 * (_S18 + 1.70000004768371582) + 0.05999999865889549);
}

float skin_srgb_curve(float x)
{
    float _S19;
    if(x <= 0.00313080009073019)
    {
        _S19 = 12.92000007629394531 * x;
    }
    else
    {
        _S19 = 1.0549999475479126 * pow(max(x, 9.999999960041972e-13), 0.4166666567325592) - 0.05499999970197678;
    }
    return _S19;
}

vec3 skin_srgb_from_linear(vec3 light)
{
    vec3 x_7 = skin_saturate_0(light);
    return vec3(skin_srgb_curve(x_7.x), skin_srgb_curve(x_7.y), skin_srgb_curve(x_7.z));
}

float skin_linear_curve(float x)
{
    float _S20;
    if(x <= 0.04044999927282333)
    {
        _S20 = x / 12.92000007629394531;
    }
    else
    {
        _S20 = pow((x + 0.05499999970197678) / 1.0549999475479126, 2.40000009536743164);
    }
    return _S20;
}

vec3 skin_linear_from_srgb(vec3 display)
{
    vec3 x_9 = skin_saturate_0(display);
    return vec3(skin_linear_curve(x_9.x), skin_linear_curve(x_9.y), skin_linear_curve(x_9.z));
}

float skin_classic_blur_level(float radius_mm, float uv_scale_mm, float map_size, float hardware_level)
{
    return max(hardware_level, log2(max(map_size * radius_mm, uv_scale_mm) / uv_scale_mm));
}

vec3 skin_classic_direct(sampler2D lut, vec4 lut_axes, vec3 sharp, vec3 blurred, vec3 light, float curvature_per_mm)
{
    float blurred_cosine_0 = dot(blurred, light);
    float k_1 = skin_saturate_1(1.0 - blurred_cosine_0);
    float k_2 = k_1 * k_1;
    return skin_saturate_0(skin_saturate_0(vec3(blurred_cosine_0, dot(skin_unit_vectors(mix(sharp, blurred, vec3(0.30000001192092896 + 0.69999998807907104 * k_2))), light), dot(skin_unit_vectors(mix(sharp, blurred, vec3(k_2))), light))) + ((textureLod((lut), (skin_saturate_2((vec2(blurred_cosine_0, abs(curvature_per_mm)) - lut_axes.xz) * lut_axes.yw)), (0.0))).xyz - max(blurred_cosine_0, 0.0)));
}

mat3x3 skin_classic_ambient_normals(vec3 sharp, vec3 blurred)
{
    return mat3x3(blurred, skin_unit_vectors(mix(sharp, blurred, vec3(0.30000001192092896))), sharp);
}

float skin_classic_sharpened_shadow(float shadow_filter, float sharpening)
{
    return skin_smoothstep(0.89999997615814209 * sharpening * (shadow_filter - 0.5) + 0.5);
}

float skin_classic_deep_scatter(float thickness_mm, float n_dot_l, float radius_mm, float strength)
{
    return strength * skin_classic_transmittance(thickness_mm, radius_mm) * max(0.30000001192092896 - n_dot_l, 0.0);
}
