// The skinshade library, generated from shaders/skin by `python -m skinshade.codegen`.
vec3 saturate_0(vec3 x_0)
{
    return clamp(x_0, vec3(0.0), vec3(1.0));
}

const vec2  SKIN_POISSON_32_0[32] = vec2[](vec2(-0.02096010930836201, 0.01299272011965513), vec2(0.69517123699188232, -0.04910685122013092), vec2(0.28034570813179016, 0.66283899545669556), vec2(0.03107489086687565, -0.69704329967498779), vec2(-0.49904009699821472, 0.54098159074783325), vec2(-0.70408397912979126, -0.14709833264350891), vec2(0.53451526165008545, -0.56702268123626709), vec2(-0.48678380250930786, -0.61486828327178955), vec2(0.68837428092956543, 0.41418349742889404), vec2(-0.14107078313827515, 0.8102262020111084), vec2(0.21897397935390472, -0.3123532235622406), vec2(0.31406453251838684, 0.24951401352882385), vec2(-0.83115619421005249, 0.28457203507423401), vec2(-0.40699386596679688, 0.14198443293571472), vec2(-0.10747358947992325, 0.41360348463058472), vec2(-0.19334819912910461, -0.34689420461654663), vec2(0.80768358707427979, -0.37000563740730286), vec2(0.33436411619186401, -0.82407790422439575), vec2(-0.79105347394943237, -0.45378401875495911), vec2(-0.23485180735588074, -0.86940687894821167), vec2(0.37255629897117615, -0.05855973064899445), vec2(0.5726354718208313, 0.72984015941619873), vec2(0.8966706395149231, 0.17047682404518127), vec2(-0.43273070454597473, 0.81860679388046265), vec2(0.1212853416800499, 0.92984902858734131), vec2(-0.42749753594398499, -0.15111121535301208), vec2(-0.94129812717437744, 0.00735718011856079), vec2(0.52211439609527588, -0.28702935576438904), vec2(-0.79033631086349487, 0.5402228832244873), vec2(-0.23410981893539429, -0.59940856695175171), vec2(0.28244560956954956, -0.563071608543396), vec2(0.57051312923431396, 0.18359191715717316));
const vec2  SKIN_POISSON_8_0[8] = vec2[](vec2(-0.16089901328086853, -0.04573699831962585), vec2(-0.89243310689926147, 0.18877510726451874), vec2(-0.17830690741539001, 0.7200586199760437), vec2(-0.53433239459991455, -0.70478206872940063), vec2(0.22474820911884308, -0.69165337085723877), vec2(0.5559992790222168, 0.1985180526971817), vec2(0.64686292409896851, -0.3364911675453186), vec2(0.33836102485656738, 0.67131179571151733));
float saturate_1(float x_1)
{
    return clamp(x_1, 0.0, 1.0);
}

vec2 saturate_2(vec2 x_2)
{
    return clamp(x_2, vec2(0.0), vec2(1.0));
}

float skin_blur_level(float sigma_mm_0, float uv_scale_mm_0, float map_size_0, float hardware_level_0)
{
    return max(hardware_level_0, log2(max(2.0 * sigma_mm_0 * map_size_0 / uv_scale_mm_0, 1.0)));
}

vec3 skin_weighted(mat3x3 rows_0, vec3 weights_0)
{
    return weights_0.x * rows_0[0] + weights_0.y * rows_0[1] + weights_0.z * rows_0[2];
}

mat3x3 skin_blend_normals(mat3x3 fetched_0, mat3x3 blend_0)
{
    return mat3x3(skin_weighted(fetched_0, blend_0[0]), skin_weighted(fetched_0, blend_0[1]), skin_weighted(fetched_0, blend_0[2]));
}

float skin_safe_length(vec3 v_0)
{
    return sqrt(max(dot(v_0, v_0), 1.00000004581370497e-18));
}

vec3 skin_displaced(vec3 from_texture_0, vec3 from_mesh_0, vec3 mesh_normal_0)
{
    return from_texture_0 + skin_safe_length(from_texture_0) * (from_mesh_0 - mesh_normal_0);
}

mat3x3 skin_add_mesh_diffusion(mat3x3 from_texture_1, mat3x3 from_mesh_1, vec3 mesh_normal_1)
{
    return mat3x3(skin_displaced(from_texture_1[0], from_mesh_1[0], mesh_normal_1), skin_displaced(from_texture_1[1], from_mesh_1[1], mesh_normal_1), skin_displaced(from_texture_1[2], from_mesh_1[2], mesh_normal_1));
}

float skin_relief_bump(float m_0, float s_0)
{
    float _S1 = max(s_0, 9.99999971718068537e-10);
    float _S2 = min(abs(m_0) / _S1, 8.0);
    return _S1 * (0.39894229173660278 * exp(-0.5 * _S2 * _S2)) / (1.0 + _S2 * (1.25119507312774658 + _S2 * (0.58454132080078125 + _S2 * 0.06752368807792664)));
}

vec3 skin_lengths(mat3x3 normals_0)
{
    return vec3(skin_safe_length(normals_0[0]), skin_safe_length(normals_0[1]), skin_safe_length(normals_0[2]));
}

vec3 skin_cosines(mat3x3 normals_1, vec3 light_0, vec3 lengths_0)
{
    return clamp(vec3(dot(normals_1[0], light_0), dot(normals_1[1], light_0), dot(normals_1[2], light_0)) / max(lengths_0, vec3(9.99999971718068537e-10)), vec3(-1.0), vec3(1.0));
}

vec3 skin_curvature_table(sampler2D lut_0, vec4 lut_axes_0, vec3 cos_theta_0, float curvature_per_mm_0)
{
    float row_0 = sqrt(max(curvature_per_mm_0, 0.0));
    vec2 _S3 = lut_axes_0.xz;
    vec2 _S4 = lut_axes_0.yw;
    return vec3((textureLod((lut_0), (saturate_2((vec2(cos_theta_0.x, row_0) - _S3) * _S4)), (0.0))).xyz.x, (textureLod((lut_0), (saturate_2((vec2(cos_theta_0.y, row_0) - _S3) * _S4)), (0.0))).xyz.y, (textureLod((lut_0), (saturate_2((vec2(cos_theta_0.z, row_0) - _S3) * _S4)), (0.0))).xyz.z);
}

vec3 skin_lost_relief(vec3 lengths_1, vec3 cos_theta_1)
{
    const vec3 _S5 = vec3(0.0);
    vec3 slope_0 = sqrt(max(- log(clamp(lengths_1, vec3(0.00100000004749745), vec3(1.0))), _S5));
    vec3 sine_0 = sqrt(max(1.0 - cos_theta_1 * cos_theta_1, _S5));
    return vec3(skin_relief_bump(lengths_1.x * cos_theta_1.x, slope_0.x * sine_0.x), skin_relief_bump(lengths_1.y * cos_theta_1.y, slope_0.y * sine_0.y), skin_relief_bump(lengths_1.z * cos_theta_1.z, slope_0.z * sine_0.z));
}

vec3 skin_direct_scalar(sampler2D lut_1, vec4 lut_axes_1, mat3x3 normals_2, vec3 light_1, float curvature_per_mm_1, vec3 gain_0)
{
    vec3 lengths_2 = skin_lengths(normals_2);
    vec3 cos_theta_2 = skin_cosines(normals_2, light_1, lengths_2);
    return gain_0 * (lengths_2 * skin_curvature_table(lut_1, lut_axes_1, cos_theta_2, abs(curvature_per_mm_1)) + skin_lost_relief(lengths_2, cos_theta_2));
}

vec3 skin_transfer(sampler2D transfer_0, vec4 transfer_axes_0, float k_per_mm_0)
{
    return (textureLod((transfer_0), (saturate_2((vec2(sqrt(max(k_per_mm_0, 0.0)), 0.5) - transfer_axes_0.xz) * transfer_axes_0.yw)), (0.0))).xyz;
}

vec3 skin_direct_tensor(sampler2D lut_2, vec4 lut_axes_2, sampler2D transfer_1, vec4 transfer_axes_1, mat3x3 normals_3, vec3 light_2, float directional_per_mm_0, float total_per_mm_0, vec3 gain_1)
{
    vec3 lengths_3 = skin_lengths(normals_3);
    vec3 cos_theta_3 = skin_cosines(normals_3, light_2, lengths_3);
    return gain_1 * (lengths_3 * (skin_curvature_table(lut_2, lut_axes_2, cos_theta_3, directional_per_mm_0) * skin_transfer(transfer_1, transfer_axes_1, sqrt(max((total_per_mm_0 - directional_per_mm_0) * (total_per_mm_0 + directional_per_mm_0), 0.0)))) + skin_lost_relief(lengths_3, cos_theta_3));
}

vec3 skin_direct_diffused_normals(sampler2D lut_3, vec4 lut_axes_3, sampler2D transfer_2, vec4 transfer_axes_2, mat3x3 normals_4, vec3 relief_length_0, vec3 light_3, float directional_per_mm_1, vec3 gain_2)
{
    vec3 lengths_4 = skin_lengths(normals_4);
    vec3 cos_theta_4 = skin_cosines(normals_4, light_3, lengths_4);
    return gain_2 * (skin_curvature_table(lut_3, lut_axes_3, cos_theta_4, directional_per_mm_1) * min(lengths_4 / max(skin_transfer(transfer_2, transfer_axes_2, directional_per_mm_1), vec3(9.99999997475242708e-07)), vec3(1.0)) + skin_lost_relief(relief_length_0, cos_theta_4));
}

vec3 skin_unexplained_length(sampler2D transfer_3, vec4 transfer_axes_3, mat3x3 from_texture_2, mat3x3 from_mesh_2, float total_per_mm_1)
{
    return skin_lengths(from_texture_2) * min(skin_lengths(from_mesh_2) / max(0.97500002384185791 * skin_transfer(transfer_3, transfer_axes_3, total_per_mm_1), vec3(9.99999997475242708e-07)), vec3(1.0));
}

vec2 skin_directional_curvature(mat3x3 tensor_world_0, vec3 normal_0, vec3 light_4)
{
    vec3 tangential_0 = light_4 - normal_0 * dot(light_4, normal_0);
    vec3 turn_0 = vec3(dot(tensor_world_0[0], tangential_0), dot(tensor_world_0[1], tangential_0), dot(tensor_world_0[2], tangential_0));
    float total_0 = sqrt(dot(tensor_world_0[0], tensor_world_0[0]) + dot(tensor_world_0[1], tensor_world_0[1]) + dot(tensor_world_0[2], tensor_world_0[2]));
    return vec2(min(sqrt(dot(turn_0, turn_0) / max(dot(tangential_0, tangential_0), 9.999999960041972e-13)), total_0), total_0);
}

vec3 skin_energy_gain(vec3 albedo_0, vec3 rms_radius_mm_0, vec3 curvature_per_mm_2)
{
    vec3 absorbed_0 = 1.0 - albedo_0;
    vec3 u_0 = 1.20000004768371582 * absorbed_0 * rms_radius_mm_0 * max(curvature_per_mm_2, vec3(0.0));
    vec3 bound_0 = u_0 * albedo_0 / absorbed_0;
    return 1.0 + u_0 / sqrt(1.0 + bound_0 * bound_0);
}

float skin_smoothstep(float p_0)
{
    float q_0 = saturate_1(p_0);
    return q_0 * q_0 * (3.0 - 2.0 * q_0);
}

vec3 skin_diffused_shadow(sampler2D lut_4, vec4 lut_axes_4, float shadow_filter_0, float n_dot_l_0, float filter_width_mm_0)
{
    return (textureLod((lut_4), (saturate_2((vec2(shadow_filter_0, max(n_dot_l_0, 0.05000000074505806) / filter_width_mm_0) - lut_axes_4.xz) * lut_axes_4.yw)), (0.0))).xyz;
}

float skin_sharpened_shadow(float shadow_filter_1, float sharpening_0)
{
    return skin_smoothstep((0.5 - sin(asin(1.0 - 2.0 * saturate_1(shadow_filter_1)) / 3.0) - 0.5) * sharpening_0 + 0.5);
}

float skin_variance_shadow(float mean_depth_mm_0, float mean_square_depth_mm2_0, float depth_mm_0)
{
    float _S6 = max(mean_square_depth_mm2_0 - mean_depth_mm_0 * mean_depth_mm_0, 0.00999999977648258);
    float _S7 = max(depth_mm_0 - mean_depth_mm_0, 0.0);
    return _S6 / (_S6 + _S7 * _S7);
}

vec3 skin_sh_bands(mat3x3 sh_0, vec3 d_0)
{
    float _S8 = d_0.y;
    float _S9 = d_0.z;
    float _S10 = d_0.x;
    return vec3(0.282094806432724 * sh_0[0].x, 0.48860251903533936 * (sh_0[0].y * _S8 + sh_0[0].z * _S9 + sh_0[1].x * _S10), 1.09254848957061768 * (sh_0[1].y * _S10 * _S8 + sh_0[1].z * _S8 * _S9 + sh_0[2].y * _S10 * _S9) + 0.31539157032966614 * sh_0[2].x * (3.0 * _S9 * _S9 - 1.0) + 0.54627424478530884 * sh_0[2].z * (_S10 * _S10 - _S8 * _S8));
}

float skin_ambient_channel(mat3x3 sh_1, vec3 normal_1, vec3 band_transfer_0)
{
    float l_0 = skin_safe_length(normal_1);
    return max(dot(skin_sh_bands(sh_1, normal_1 / l_0), vec3(1.0, l_0, l_0 * l_0 * l_0) * band_transfer_0 * vec3(1.0, 0.66666668653488159, 0.25)), 0.0);
}

vec3 skin_ambient_irradiance(mat3x3 radiance_sh_red_0, mat3x3 radiance_sh_green_0, mat3x3 radiance_sh_blue_0, mat3x3 normals_5, mat3x3 band_transfer_1)
{
    mat3x3 t_0 = transpose(band_transfer_1);
    return vec3(skin_ambient_channel(radiance_sh_red_0, normals_5[0], t_0[0]), skin_ambient_channel(radiance_sh_green_0, normals_5[1], t_0[1]), skin_ambient_channel(radiance_sh_blue_0, normals_5[2], t_0[2]));
}

vec3 skin_unit_vectors(vec3 v_1)
{
    return v_1 / skin_safe_length(v_1);
}

mat3x3 skin_ambient_normals(mat3x3 normals_6)
{
    return mat3x3(skin_unit_vectors(normals_6[0]), skin_unit_vectors(normals_6[1]), skin_unit_vectors(normals_6[2]));
}

vec3 skin_ambient_of_three(vec3 red_0, vec3 green_0, vec3 blue_0)
{
    return vec3(red_0.x, green_0.y, blue_0.z);
}

vec3 skin_bounced_visibility(vec3 visibility_0, vec3 albedo_1)
{
    return max(visibility_0, ((visibility_0 * (2.04040002822875977 * albedo_1 - 0.33239999413490295) + (-4.79510021209716797 * albedo_1 + 0.64170002937316895)) * visibility_0 + (2.75519990921020508 * albedo_1 + 0.69029998779296875)) * visibility_0);
}

float skin_specular_visibility(float n_dot_v_0, float visibility_1, float roughness_0)
{
    float exponent_0 = (exp2((-16.0 * roughness_0 - 1.0)));
    float base_0 = n_dot_v_0 + visibility_1;
    float open_0;
    if(base_0 > 0.0)
    {
        open_0 = pow(base_0, exponent_0);
    }
    else
    {
        open_0 = 0.0;
    }
    return saturate_1(open_0 - 1.0 + visibility_1);
}

float skin_linear_depth(float depth_0, mat4x4 projection_0)
{
    return abs((depth_0 * projection_0[3][3] - projection_0[2][3]) / (projection_0[2][2] - depth_0 * projection_0[3][2]));
}

vec3 skin_inward_offset(vec3 position_mm_0, vec3 normal_2, float offset_mm_0)
{
    return position_mm_0 - normal_2 * offset_mm_0;
}

float skin_thickness(sampler2D depth_map_0, mat4x4 projection_1, vec2 uv_0, float receiver_mm_0, vec2 radius_uv_0, int taps_0)
{
    int tap_0 = 0;
    float total_1 = 0.0;
    for(;;)
    {
        if(tap_0 < taps_0)
        {
        }
        else
        {
            break;
        }
        vec2 place_0;
        if(taps_0 == 8)
        {
            place_0 = SKIN_POISSON_8_0[min(tap_0, 7)];
        }
        else
        {
            place_0 = SKIN_POISSON_32_0[min(tap_0, 31)];
        }
        float total_2 = total_1 + max(receiver_mm_0 - skin_linear_depth((textureLod((depth_map_0), (uv_0 + place_0 * radius_uv_0), (0.0))).x, projection_1), 0.0);
        tap_0 = tap_0 + 1;
        total_1 = total_2;
    }
    return total_1 / float(max(taps_0, 1));
}

vec3 skin_transmittance(float thickness_mm_0, vec3 albedo_2, vec3 sigma_per_mm_0)
{
    vec3 a2_0 = albedo_2 * albedo_2;
    vec3 _S11 = 2.0 * albedo_2;
    vec3 a_0 = (1.0 + a2_0) / _S11;
    vec3 b_0 = (1.0 - a2_0) / _S11;
    vec3 decay_0 = exp(- sigma_per_mm_0 * thickness_mm_0);
    return 2.0 * b_0 * decay_0 / (a_0 + b_0 - (a_0 - b_0) * decay_0 * decay_0);
}

float skin_classic_transmittance(float thickness_mm_1, float radius_mm_0)
{
    float t_1 = thickness_mm_1 / radius_mm_0;
    return exp(-0.5 * t_1 * t_1);
}

vec3 skin_direct_deep_scatter(vec3 transmitted_0, float n_dot_l_1, float strength_0)
{
    return strength_0 * transmitted_0 * max(- n_dot_l_1, 0.0);
}

vec3 skin_ambient_deep_scatter(vec3 transmitted_1, vec3 irradiance_behind_0, float strength_1)
{
    return strength_1 * transmitted_1 * irradiance_behind_0;
}

float skin_specular_power(float gloss_0)
{
    return (exp2((13.0 * gloss_0)));
}

float skin_gloss_of_relief(float gloss_1, float normal_length_0)
{
    float l_1 = clamp(normal_length_0, 0.00100000004749745, 1.0);
    float power_0 = skin_specular_power(gloss_1);
    return log2(max(l_1 * power_0 / (l_1 + power_0 * (1.0 - l_1)), 1.0)) / 13.0;
}

float skin_gloss_from_roughness(float roughness_1)
{
    float _S12 = max(roughness_1, 0.00100000004749745);
    float r2_0 = _S12 * _S12;
    return clamp(log2(max(2.0 / (r2_0 * r2_0) - 2.0, 1.0)) / 13.0, 0.0, 1.0);
}

float skin_lobe(float n_dot_h_0, float n_dot_l_2, float n_dot_v_1, float power_1)
{
    float k_0 = (inversesqrt((3.14159274101257324 * power_1 / 4.0 + 1.57079637050628662)));
    float _S13 = 1.0 - k_0;
    return (power_1 + 2.0) / 6.28318548202514648 * pow(max(n_dot_h_0, 9.99999971718068537e-10), power_1) * (0.25 / ((k_0 + _S13 * n_dot_l_2) * (k_0 + _S13 * n_dot_v_1)));
}

float skin_specular(vec3 normal_3, vec3 view_0, vec3 light_5, float gloss_2, float reflectance_0)
{
    vec3 half_vector_0 = skin_unit_vectors(view_0 + light_5);
    float n_dot_l_3 = saturate_1(dot(normal_3, light_5));
    float n_dot_v_2 = clamp(dot(normal_3, view_0), 0.00009999999747379, 1.0);
    float n_dot_h_1 = saturate_1(dot(normal_3, half_vector_0));
    float wide_0 = skin_specular_power(gloss_2);
    float away_0 = 1.0 - saturate_1(dot(view_0, half_vector_0));
    float away2_0 = away_0 * away_0;
    return 3.14159274101257324 * (0.94999998807907104 * skin_lobe(n_dot_h_1, n_dot_l_3, n_dot_v_2, wide_0) + 0.05000000074505806 * skin_lobe(n_dot_h_1, n_dot_l_3, n_dot_v_2, min(wide_0 * wide_0, 8192.0))) * (reflectance_0 + (1.0 - reflectance_0) * away2_0 * away2_0 * away_0) * n_dot_l_3;
}

vec3 skin_reflected(vec3 normal_4, vec3 view_1)
{
    return 2.0 * dot(normal_4, view_1) * normal_4 - view_1;
}

float skin_ambient_specular_fresnel(float n_dot_v_3, float gloss_3, float reflectance_1)
{
    float away_1 = 1.0 - saturate_1(n_dot_v_3);
    float away2_1 = away_1 * away_1;
    return reflectance_1 + (1.0 - reflectance_1) * away2_1 * away2_1 * away_1 / (4.0 - 3.0 * gloss_3);
}

float skin_diffuse_share(float n_dot_v_4, float gloss_4, float reflectance_2)
{
    return 1.0 - skin_ambient_specular_fresnel(n_dot_v_4, gloss_4, reflectance_2);
}

vec2 skin_equirectangular_uv(vec3 direction_0)
{
    float _S14 = direction_0.x;
    float _S15 = direction_0.z;
    float level_0 = sqrt(_S14 * _S14 + _S15 * _S15);
    float x_3;
    if(level_0 > 0.0)
    {
        x_3 = _S14;
    }
    else
    {
        x_3 = 1.0;
    }
    return vec2(0.5 + (atan((_S15),(x_3))) / 6.28318548202514648, (atan((level_0),(direction_0.y))) / 3.14159274101257324);
}

float skin_reflection_level(float power_2)
{
    return clamp(0.5 * log2(max(power_2, 1.0)), 0.0, 4.0);
}

vec3 skin_preconvolved(sampler2D preconvolved_0, vec2 uv_1, float power_3)
{
    float level_1 = skin_reflection_level(power_3);
    float _S16 = min(floor(level_1), 3.0);
    float row_1 = clamp(uv_1.y, 0.0078125, 0.9921875);
    float _S17 = uv_1.x;
    return mix((textureLod((preconvolved_0), (vec2(_S17, (_S16 + row_1) / 5.0)), (0.0))).xyz, (textureLod((preconvolved_0), (vec2(_S17, (_S16 + 1.0 + row_1) / 5.0)), (0.0))).xyz, vec3(level_1 - _S16));
}

vec3 skin_reflected_radiance(sampler2D preconvolved_1, vec3 direction_1, float gloss_5)
{
    vec2 uv_2 = skin_equirectangular_uv(direction_1);
    float power_4 = skin_specular_power(gloss_5);
    return mix(skin_preconvolved(preconvolved_1, uv_2, power_4 / 4.0), skin_preconvolved(preconvolved_1, uv_2, power_4 * power_4 / 4.0), vec3(0.05000000074505806));
}

vec3 skin_filmic(vec3 light_6)
{
    vec3 x_4 = max(light_6 - 0.00400000018998981, vec3(0.0));
    vec3 _S18 = 6.19999980926513672 * x_4;
    return x_4 * (_S18 + 0.5) / (x_4 * (_S18 + 1.70000004768371582) + 0.05999999865889549);
}

float skin_srgb_curve(float x_5)
{
    float _S19;
    if(x_5 <= 0.00313080009073019)
    {
        _S19 = 12.92000007629394531 * x_5;
    }
    else
    {
        _S19 = 1.0549999475479126 * pow(max(x_5, 9.999999960041972e-13), 0.4166666567325592) - 0.05499999970197678;
    }
    return _S19;
}

vec3 skin_srgb_from_linear(vec3 light_7)
{
    vec3 x_6 = saturate_0(light_7);
    return vec3(skin_srgb_curve(x_6.x), skin_srgb_curve(x_6.y), skin_srgb_curve(x_6.z));
}

float skin_linear_curve(float x_7)
{
    float _S20;
    if(x_7 <= 0.04044999927282333)
    {
        _S20 = x_7 / 12.92000007629394531;
    }
    else
    {
        _S20 = pow((x_7 + 0.05499999970197678) / 1.0549999475479126, 2.40000009536743164);
    }
    return _S20;
}

vec3 skin_linear_from_srgb(vec3 display_0)
{
    vec3 x_8 = saturate_0(display_0);
    return vec3(skin_linear_curve(x_8.x), skin_linear_curve(x_8.y), skin_linear_curve(x_8.z));
}

float skin_classic_blur_level(float radius_mm_1, float uv_scale_mm_1, float map_size_1, float hardware_level_1)
{
    return max(hardware_level_1, log2(max(map_size_1 * radius_mm_1, uv_scale_mm_1) / uv_scale_mm_1));
}

vec3 skin_classic_direct(sampler2D lut_5, vec4 lut_axes_5, vec3 sharp_0, vec3 blurred_0, vec3 light_8, float curvature_per_mm_3)
{
    float blurred_cosine_0 = dot(blurred_0, light_8);
    float k_1 = saturate_1(1.0 - blurred_cosine_0);
    float k_2 = k_1 * k_1;
    return saturate_0(saturate_0(vec3(blurred_cosine_0, dot(skin_unit_vectors(mix(sharp_0, blurred_0, vec3(0.30000001192092896 + 0.69999998807907104 * k_2))), light_8), dot(skin_unit_vectors(mix(sharp_0, blurred_0, vec3(k_2))), light_8))) + ((textureLod((lut_5), (saturate_2((vec2(blurred_cosine_0, abs(curvature_per_mm_3)) - lut_axes_5.xz) * lut_axes_5.yw)), (0.0))).xyz - max(blurred_cosine_0, 0.0)));
}

mat3x3 skin_classic_ambient_normals(vec3 sharp_1, vec3 blurred_1)
{
    return mat3x3(blurred_1, skin_unit_vectors(mix(sharp_1, blurred_1, vec3(0.30000001192092896))), sharp_1);
}

float skin_classic_sharpened_shadow(float shadow_filter_2, float sharpening_1)
{
    return skin_smoothstep(0.89999997615814209 * sharpening_1 * (shadow_filter_2 - 0.5) + 0.5);
}

float skin_classic_deep_scatter(float thickness_mm_2, float n_dot_l_4, float radius_mm_2, float strength_2)
{
    return strength_2 * skin_classic_transmittance(thickness_mm_2, radius_mm_2) * max(0.30000001192092896 - n_dot_l_4, 0.0);
}
