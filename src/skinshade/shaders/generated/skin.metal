// The skinshade library, generated from shaders/skin by `python -m skinshade.codegen`.
#include <metal_stdlib>
using namespace metal;
constant array<float2, int(32)> SKIN_POISSON_32_0 = { float2(-0.02096010930836201f, 0.01299272011965513f), float2(0.69517123699188232f, -0.04910685122013092f), float2(0.28034570813179016f, 0.66283899545669556f), float2(0.03107489086687565f, -0.69704329967498779f), float2(-0.49904009699821472f, 0.54098159074783325f), float2(-0.70408397912979126f, -0.14709833264350891f), float2(0.53451526165008545f, -0.56702268123626709f), float2(-0.48678380250930786f, -0.61486828327178955f), float2(0.68837428092956543f, 0.41418349742889404f), float2(-0.14107078313827515f, 0.8102262020111084f), float2(0.21897397935390472f, -0.3123532235622406f), float2(0.31406453251838684f, 0.24951401352882385f), float2(-0.83115619421005249f, 0.28457203507423401f), float2(-0.40699386596679688f, 0.14198443293571472f), float2(-0.10747358947992325f, 0.41360348463058472f), float2(-0.19334819912910461f, -0.34689420461654663f), float2(0.80768358707427979f, -0.37000563740730286f), float2(0.33436411619186401f, -0.82407790422439575f), float2(-0.79105347394943237f, -0.45378401875495911f), float2(-0.23485180735588074f, -0.86940687894821167f), float2(0.37255629897117615f, -0.05855973064899445f), float2(0.5726354718208313f, 0.72984015941619873f), float2(0.8966706395149231f, 0.17047682404518127f), float2(-0.43273070454597473f, 0.81860679388046265f), float2(0.1212853416800499f, 0.92984902858734131f), float2(-0.42749753594398499f, -0.15111121535301208f), float2(-0.94129812717437744f, 0.00735718011856079f), float2(0.52211439609527588f, -0.28702935576438904f), float2(-0.79033631086349487f, 0.5402228832244873f), float2(-0.23410981893539429f, -0.59940856695175171f), float2(0.28244560956954956f, -0.563071608543396f), float2(0.57051312923431396f, 0.18359191715717316f) };
constant array<float2, int(8)> SKIN_POISSON_8_0 = { float2(-0.16089901328086853f, -0.04573699831962585f), float2(-0.89243310689926147f, 0.18877510726451874f), float2(-0.17830690741539001f, 0.7200586199760437f), float2(-0.53433239459991455f, -0.70478206872940063f), float2(0.22474820911884308f, -0.69165337085723877f), float2(0.5559992790222168f, 0.1985180526971817f), float2(0.64686292409896851f, -0.3364911675453186f), float2(0.33836102485656738f, 0.67131179571151733f) };

float skin_blur_level(float sigma_mm_0, float uv_scale_mm_0, float map_size_0, float hardware_level_0)
{
    return max(hardware_level_0, log2(max(2.0f * sigma_mm_0 * map_size_0 / uv_scale_mm_0, 1.0f)));
}

float3 skin_weighted(matrix<float,int(3),int(3)>  rows_0, float3 weights_0)
{
    return float3(weights_0.x)  * rows_0[int(0)] + float3(weights_0.y)  * rows_0[int(1)] + float3(weights_0.z)  * rows_0[int(2)];
}

matrix<float,int(3),int(3)>  skin_blend_normals(matrix<float,int(3),int(3)>  fetched_0, matrix<float,int(3),int(3)>  blend_0)
{
    return matrix<float,int(3),int(3)> (skin_weighted(fetched_0, blend_0[int(0)]), skin_weighted(fetched_0, blend_0[int(1)]), skin_weighted(fetched_0, blend_0[int(2)]));
}

float skin_safe_length(float3 v_0)
{
    return sqrt(max(dot(v_0, v_0), 1.00000004581370497e-18f));
}

float3 skin_displaced(float3 from_texture_0, float3 from_mesh_0, float3 mesh_normal_0)
{
    return from_texture_0 + float3(skin_safe_length(from_texture_0))  * (from_mesh_0 - mesh_normal_0);
}

matrix<float,int(3),int(3)>  skin_add_mesh_diffusion(matrix<float,int(3),int(3)>  from_texture_1, matrix<float,int(3),int(3)>  from_mesh_1, float3 mesh_normal_1)
{
    return matrix<float,int(3),int(3)> (skin_displaced(from_texture_1[int(0)], from_mesh_1[int(0)], mesh_normal_1), skin_displaced(from_texture_1[int(1)], from_mesh_1[int(1)], mesh_normal_1), skin_displaced(from_texture_1[int(2)], from_mesh_1[int(2)], mesh_normal_1));
}

float skin_relief_bump(float m_0, float s_0)
{
    float _S1 = max(s_0, 9.99999971718068537e-10f);
    float _S2 = min(abs(m_0) / _S1, 8.0f);
    return _S1 * (0.39894229173660278f * exp(-0.5f * _S2 * _S2)) / (1.0f + _S2 * (1.25119507312774658f + _S2 * (0.58454132080078125f + _S2 * 0.06752368807792664f)));
}

float3 skin_lengths(matrix<float,int(3),int(3)>  normals_0)
{
    return float3(skin_safe_length(normals_0[int(0)]), skin_safe_length(normals_0[int(1)]), skin_safe_length(normals_0[int(2)]));
}

float3 skin_cosines(matrix<float,int(3),int(3)>  normals_1, float3 light_0, float3 lengths_0)
{
    return clamp(float3(dot(normals_1[int(0)], light_0), dot(normals_1[int(1)], light_0), dot(normals_1[int(2)], light_0)) / max(lengths_0, float3(9.99999971718068537e-10f) ), float3(-1.0f) , float3(1.0f) );
}

float3 skin_curvature_table(texture2d<float, access::sample> lut_0, sampler lut_sampler_0, float4 lut_axes_0, float3 cos_theta_0, float curvature_per_mm_0)
{
    float row_0 = sqrt(max(curvature_per_mm_0, 0.0f));
    float2 _S3 = lut_axes_0.xz;
    float2 _S4 = lut_axes_0.yw;
    return float3(((lut_0).sample((lut_sampler_0), (saturate((float2(cos_theta_0.x, row_0) - _S3) * _S4)), level((0.0f)))).xyz.x, ((lut_0).sample((lut_sampler_0), (saturate((float2(cos_theta_0.y, row_0) - _S3) * _S4)), level((0.0f)))).xyz.y, ((lut_0).sample((lut_sampler_0), (saturate((float2(cos_theta_0.z, row_0) - _S3) * _S4)), level((0.0f)))).xyz.z);
}

float3 skin_lost_relief(float3 lengths_1, float3 cos_theta_1)
{
    float3 _S5 = float3(0.0f) ;
    float3 slope_0 = sqrt(max(- log(clamp(lengths_1, float3(0.00100000004749745f) , float3(1.0f) )), _S5));
    float3 sine_0 = sqrt(max(float3(1.0f)  - cos_theta_1 * cos_theta_1, _S5));
    return float3(skin_relief_bump(lengths_1.x * cos_theta_1.x, slope_0.x * sine_0.x), skin_relief_bump(lengths_1.y * cos_theta_1.y, slope_0.y * sine_0.y), skin_relief_bump(lengths_1.z * cos_theta_1.z, slope_0.z * sine_0.z));
}

float3 skin_direct_scalar(texture2d<float, access::sample> lut_1, sampler lut_sampler_1, float4 lut_axes_1, matrix<float,int(3),int(3)>  normals_2, float3 light_1, float curvature_per_mm_1, float3 gain_0)
{
    float3 lengths_2 = skin_lengths(normals_2);
    float3 cos_theta_2 = skin_cosines(normals_2, light_1, lengths_2);
    return gain_0 * (lengths_2 * skin_curvature_table(lut_1, lut_sampler_1, lut_axes_1, cos_theta_2, abs(curvature_per_mm_1)) + skin_lost_relief(lengths_2, cos_theta_2));
}

float3 skin_transfer(texture2d<float, access::sample> transfer_0, sampler transfer_sampler_0, float4 transfer_axes_0, float k_per_mm_0)
{
    return ((transfer_0).sample((transfer_sampler_0), (saturate((float2(sqrt(max(k_per_mm_0, 0.0f)), 0.5f) - transfer_axes_0.xz) * transfer_axes_0.yw)), level((0.0f)))).xyz;
}

float3 skin_direct_tensor(texture2d<float, access::sample> lut_2, sampler lut_sampler_2, float4 lut_axes_2, texture2d<float, access::sample> transfer_1, sampler transfer_sampler_1, float4 transfer_axes_1, matrix<float,int(3),int(3)>  normals_3, float3 light_2, float directional_per_mm_0, float total_per_mm_0, float3 gain_1)
{
    float3 lengths_3 = skin_lengths(normals_3);
    float3 cos_theta_3 = skin_cosines(normals_3, light_2, lengths_3);
    return gain_1 * (lengths_3 * (skin_curvature_table(lut_2, lut_sampler_2, lut_axes_2, cos_theta_3, directional_per_mm_0) * skin_transfer(transfer_1, transfer_sampler_1, transfer_axes_1, sqrt(max((total_per_mm_0 - directional_per_mm_0) * (total_per_mm_0 + directional_per_mm_0), 0.0f)))) + skin_lost_relief(lengths_3, cos_theta_3));
}

float3 skin_direct_diffused_normals(texture2d<float, access::sample> lut_3, sampler lut_sampler_3, float4 lut_axes_3, texture2d<float, access::sample> transfer_2, sampler transfer_sampler_2, float4 transfer_axes_2, matrix<float,int(3),int(3)>  normals_4, float3 relief_length_0, float3 light_3, float directional_per_mm_1, float3 gain_2)
{
    float3 lengths_4 = skin_lengths(normals_4);
    float3 cos_theta_4 = skin_cosines(normals_4, light_3, lengths_4);
    return gain_2 * (skin_curvature_table(lut_3, lut_sampler_3, lut_axes_3, cos_theta_4, directional_per_mm_1) * min(lengths_4 / max(skin_transfer(transfer_2, transfer_sampler_2, transfer_axes_2, directional_per_mm_1), float3(9.99999997475242708e-07f) ), float3(1.0f) ) + skin_lost_relief(relief_length_0, cos_theta_4));
}

float3 skin_unexplained_length(texture2d<float, access::sample> transfer_3, sampler transfer_sampler_3, float4 transfer_axes_3, matrix<float,int(3),int(3)>  from_texture_2, matrix<float,int(3),int(3)>  from_mesh_2, float total_per_mm_1)
{
    return skin_lengths(from_texture_2) * min(skin_lengths(from_mesh_2) / max(float3(0.97500002384185791f)  * skin_transfer(transfer_3, transfer_sampler_3, transfer_axes_3, total_per_mm_1), float3(9.99999997475242708e-07f) ), float3(1.0f) );
}

float2 skin_directional_curvature(matrix<float,int(3),int(3)>  tensor_world_0, float3 normal_0, float3 light_4)
{
    float3 tangential_0 = light_4 - normal_0 * float3(dot(light_4, normal_0)) ;
    float3 turn_0 = float3(dot(tensor_world_0[int(0)], tangential_0), dot(tensor_world_0[int(1)], tangential_0), dot(tensor_world_0[int(2)], tangential_0));
    float total_0 = sqrt(dot(tensor_world_0[int(0)], tensor_world_0[int(0)]) + dot(tensor_world_0[int(1)], tensor_world_0[int(1)]) + dot(tensor_world_0[int(2)], tensor_world_0[int(2)]));
    return float2(min(sqrt(dot(turn_0, turn_0) / max(dot(tangential_0, tangential_0), 9.999999960041972e-13f)), total_0), total_0);
}

float3 skin_energy_gain(float3 albedo_0, float3 rms_radius_mm_0, float3 curvature_per_mm_2)
{
    float3 _S6 = float3(1.0f) ;
    float3 absorbed_0 = _S6 - albedo_0;
    float3 u_0 = float3(1.20000004768371582f)  * absorbed_0 * rms_radius_mm_0 * max(curvature_per_mm_2, float3(0.0f) );
    float3 bound_0 = u_0 * albedo_0 / absorbed_0;
    return _S6 + u_0 / sqrt(_S6 + bound_0 * bound_0);
}

float skin_smoothstep(float p_0)
{
    float q_0 = saturate(p_0);
    return q_0 * q_0 * (3.0f - 2.0f * q_0);
}

float3 skin_diffused_shadow(texture2d<float, access::sample> lut_4, sampler lut_sampler_4, float4 lut_axes_4, float shadow_filter_0, float n_dot_l_0, float filter_width_mm_0)
{
    return ((lut_4).sample((lut_sampler_4), (saturate((float2(shadow_filter_0, max(n_dot_l_0, 0.05000000074505806f) / filter_width_mm_0) - lut_axes_4.xz) * lut_axes_4.yw)), level((0.0f)))).xyz;
}

float skin_sharpened_shadow(float shadow_filter_1, float sharpening_0)
{
    return skin_smoothstep((0.5f - sin(asin(1.0f - 2.0f * saturate(shadow_filter_1)) / 3.0f) - 0.5f) * sharpening_0 + 0.5f);
}

float skin_variance_shadow(float mean_depth_mm_0, float mean_square_depth_mm2_0, float depth_mm_0)
{
    float _S7 = max(mean_square_depth_mm2_0 - mean_depth_mm_0 * mean_depth_mm_0, 0.00999999977648258f);
    float _S8 = max(depth_mm_0 - mean_depth_mm_0, 0.0f);
    return _S7 / (_S7 + _S8 * _S8);
}

float3 skin_sh_bands(matrix<float,int(3),int(3)>  sh_0, float3 d_0)
{
    float _S9 = d_0.y;
    float _S10 = d_0.z;
    float _S11 = d_0.x;
    return float3(0.282094806432724f * sh_0[int(0)].x, 0.48860251903533936f * (sh_0[int(0)].y * _S9 + sh_0[int(0)].z * _S10 + sh_0[int(1)].x * _S11), 1.09254848957061768f * (sh_0[int(1)].y * _S11 * _S9 + sh_0[int(1)].z * _S9 * _S10 + sh_0[int(2)].y * _S11 * _S10) + 0.31539157032966614f * sh_0[int(2)].x * (3.0f * _S10 * _S10 - 1.0f) + 0.54627424478530884f * sh_0[int(2)].z * (_S11 * _S11 - _S9 * _S9));
}

float skin_ambient_channel(matrix<float,int(3),int(3)>  sh_1, float3 normal_1, float3 band_transfer_0)
{
    float l_0 = skin_safe_length(normal_1);
    return max(dot(skin_sh_bands(sh_1, normal_1 / float3(l_0) ), float3(1.0f, l_0, l_0 * l_0 * l_0) * band_transfer_0 * float3(1.0f, 0.66666668653488159f, 0.25f)), 0.0f);
}

float3 skin_ambient_irradiance(matrix<float,int(3),int(3)>  radiance_sh_red_0, matrix<float,int(3),int(3)>  radiance_sh_green_0, matrix<float,int(3),int(3)>  radiance_sh_blue_0, matrix<float,int(3),int(3)>  normals_5, matrix<float,int(3),int(3)>  band_transfer_1)
{
    matrix<float,int(3),int(3)>  t_0 = transpose(band_transfer_1);
    return float3(skin_ambient_channel(radiance_sh_red_0, normals_5[int(0)], t_0[int(0)]), skin_ambient_channel(radiance_sh_green_0, normals_5[int(1)], t_0[int(1)]), skin_ambient_channel(radiance_sh_blue_0, normals_5[int(2)], t_0[int(2)]));
}

float3 skin_unit_vectors(float3 v_1)
{
    return v_1 / float3(skin_safe_length(v_1)) ;
}

matrix<float,int(3),int(3)>  skin_ambient_normals(matrix<float,int(3),int(3)>  normals_6)
{
    return matrix<float,int(3),int(3)> (skin_unit_vectors(normals_6[int(0)]), skin_unit_vectors(normals_6[int(1)]), skin_unit_vectors(normals_6[int(2)]));
}

float3 skin_ambient_of_three(float3 red_0, float3 green_0, float3 blue_0)
{
    return float3(red_0.x, green_0.y, blue_0.z);
}

float3 skin_bounced_visibility(float3 visibility_0, float3 albedo_1)
{
    return max(visibility_0, ((visibility_0 * (float3(2.04040002822875977f)  * albedo_1 - float3(0.33239999413490295f) ) + (float3(-4.79510021209716797f)  * albedo_1 + float3(0.64170002937316895f) )) * visibility_0 + (float3(2.75519990921020508f)  * albedo_1 + float3(0.69029998779296875f) )) * visibility_0);
}

float skin_specular_visibility(float n_dot_v_0, float visibility_1, float roughness_0)
{
    float exponent_0 = exp2(-16.0f * roughness_0 - 1.0f);
    float base_0 = n_dot_v_0 + visibility_1;
    float open_0;
    if(base_0 > 0.0f)
    {
        open_0 = pow(base_0, exponent_0);
    }
    else
    {
        open_0 = 0.0f;
    }
    return saturate(open_0 - 1.0f + visibility_1);
}

float skin_linear_depth(float depth_0, matrix<float,int(4),int(4)>  projection_0)
{
    return abs((depth_0 * projection_0[int(3)][int(3)] - projection_0[int(2)][int(3)]) / (projection_0[int(2)][int(2)] - depth_0 * projection_0[int(3)][int(2)]));
}

float3 skin_inward_offset(float3 position_mm_0, float3 normal_2, float offset_mm_0)
{
    return position_mm_0 - normal_2 * float3(offset_mm_0) ;
}

float skin_thickness(texture2d<float, access::sample> depth_map_0, sampler depth_map_sampler_0, matrix<float,int(4),int(4)>  projection_1, float2 uv_0, float receiver_mm_0, float2 radius_uv_0, int taps_0)
{
    int tap_0 = int(0);
    float total_1 = 0.0f;
    for(;;)
    {
        if(tap_0 < taps_0)
        {
        }
        else
        {
            break;
        }
        float2 place_0;
        if(taps_0 == int(8))
        {
            place_0 = SKIN_POISSON_8_0[min(tap_0, int(7))];
        }
        else
        {
            place_0 = SKIN_POISSON_32_0[min(tap_0, int(31))];
        }
        float total_2 = total_1 + max(receiver_mm_0 - skin_linear_depth(((depth_map_0).sample((depth_map_sampler_0), (uv_0 + place_0 * radius_uv_0), level((0.0f)))).x, projection_1), 0.0f);
        tap_0 = tap_0 + int(1);
        total_1 = total_2;
    }
    return total_1 / float(max(taps_0, int(1)));
}

float3 skin_transmittance(float thickness_mm_0, float3 albedo_2, float3 sigma_per_mm_0)
{
    float3 a2_0 = albedo_2 * albedo_2;
    float3 _S12 = float3(1.0f) ;
    float3 _S13 = float3(2.0f) ;
    float3 _S14 = _S13 * albedo_2;
    float3 a_0 = (_S12 + a2_0) / _S14;
    float3 b_0 = (_S12 - a2_0) / _S14;
    float3 decay_0 = exp(- sigma_per_mm_0 * float3(thickness_mm_0) );
    return _S13 * b_0 * decay_0 / (a_0 + b_0 - (a_0 - b_0) * decay_0 * decay_0);
}

float skin_classic_transmittance(float thickness_mm_1, float radius_mm_0)
{
    float t_1 = thickness_mm_1 / radius_mm_0;
    return exp(-0.5f * t_1 * t_1);
}

float3 skin_direct_deep_scatter(float3 transmitted_0, float n_dot_l_1, float strength_0)
{
    return float3(strength_0)  * transmitted_0 * float3(max(- n_dot_l_1, 0.0f)) ;
}

float3 skin_ambient_deep_scatter(float3 transmitted_1, float3 irradiance_behind_0, float strength_1)
{
    return float3(strength_1)  * transmitted_1 * irradiance_behind_0;
}

float skin_specular_power(float gloss_0)
{
    return exp2(13.0f * gloss_0);
}

float skin_gloss_of_relief(float gloss_1, float normal_length_0)
{
    float l_1 = clamp(normal_length_0, 0.00100000004749745f, 1.0f);
    float power_0 = skin_specular_power(gloss_1);
    return log2(max(l_1 * power_0 / (l_1 + power_0 * (1.0f - l_1)), 1.0f)) / 13.0f;
}

float skin_gloss_from_roughness(float roughness_1)
{
    float _S15 = max(roughness_1, 0.00100000004749745f);
    float r2_0 = _S15 * _S15;
    return clamp(log2(max(2.0f / (r2_0 * r2_0) - 2.0f, 1.0f)) / 13.0f, 0.0f, 1.0f);
}

float skin_lobe(float n_dot_h_0, float n_dot_l_2, float n_dot_v_1, float power_1)
{
    float k_0 = rsqrt(3.14159274101257324f * power_1 / 4.0f + 1.57079637050628662f);
    float _S16 = 1.0f - k_0;
    return (power_1 + 2.0f) / 6.28318548202514648f * pow(max(n_dot_h_0, 9.99999971718068537e-10f), power_1) * (0.25f / ((k_0 + _S16 * n_dot_l_2) * (k_0 + _S16 * n_dot_v_1)));
}

float skin_specular(float3 normal_3, float3 view_0, float3 light_5, float gloss_2, float reflectance_0)
{
    float3 half_vector_0 = skin_unit_vectors(view_0 + light_5);
    float n_dot_l_3 = saturate(dot(normal_3, light_5));
    float n_dot_v_2 = clamp(dot(normal_3, view_0), 0.00009999999747379f, 1.0f);
    float n_dot_h_1 = saturate(dot(normal_3, half_vector_0));
    float wide_0 = skin_specular_power(gloss_2);
    float away_0 = 1.0f - saturate(dot(view_0, half_vector_0));
    float away2_0 = away_0 * away_0;
    return 3.14159274101257324f * (0.94999998807907104f * skin_lobe(n_dot_h_1, n_dot_l_3, n_dot_v_2, wide_0) + 0.05000000074505806f * skin_lobe(n_dot_h_1, n_dot_l_3, n_dot_v_2, min(wide_0 * wide_0, 8192.0f))) * (reflectance_0 + (1.0f - reflectance_0) * away2_0 * away2_0 * away_0) * n_dot_l_3;
}

float3 skin_reflected(float3 normal_4, float3 view_1)
{
    return float3((2.0f * dot(normal_4, view_1)))  * normal_4 - view_1;
}

float skin_ambient_specular_fresnel(float n_dot_v_3, float gloss_3, float reflectance_1)
{
    float away_1 = 1.0f - saturate(n_dot_v_3);
    float away2_1 = away_1 * away_1;
    return reflectance_1 + (1.0f - reflectance_1) * away2_1 * away2_1 * away_1 / (4.0f - 3.0f * gloss_3);
}

float skin_diffuse_share(float n_dot_v_4, float gloss_4, float reflectance_2)
{
    return 1.0f - skin_ambient_specular_fresnel(n_dot_v_4, gloss_4, reflectance_2);
}

float2 skin_equirectangular_uv(float3 direction_0)
{
    float _S17 = direction_0.x;
    float _S18 = direction_0.z;
    float level_0 = sqrt(_S17 * _S17 + _S18 * _S18);
    float x_0;
    if(level_0 > 0.0f)
    {
        x_0 = _S17;
    }
    else
    {
        x_0 = 1.0f;
    }
    return float2(0.5f + atan2(_S18, x_0) / 6.28318548202514648f, atan2(level_0, direction_0.y) / 3.14159274101257324f);
}

float skin_reflection_level(float power_2)
{
    return clamp(0.5f * log2(max(power_2, 1.0f)), 0.0f, 4.0f);
}

float3 skin_preconvolved(texture2d<float, access::sample> preconvolved_0, sampler preconvolved_sampler_0, float2 uv_1, float power_3)
{
    float level_1 = skin_reflection_level(power_3);
    float _S19 = min(floor(level_1), 3.0f);
    float row_1 = clamp(uv_1.y, 0.0078125f, 0.9921875f);
    float _S20 = uv_1.x;
    return mix(((preconvolved_0).sample((preconvolved_sampler_0), (float2(_S20, (_S19 + row_1) / 5.0f)), level((0.0f)))).xyz, ((preconvolved_0).sample((preconvolved_sampler_0), (float2(_S20, (_S19 + 1.0f + row_1) / 5.0f)), level((0.0f)))).xyz, float3((level_1 - _S19)) );
}

float3 skin_reflected_radiance(texture2d<float, access::sample> preconvolved_1, sampler preconvolved_sampler_1, float3 direction_1, float gloss_5)
{
    float2 uv_2 = skin_equirectangular_uv(direction_1);
    float power_4 = skin_specular_power(gloss_5);
    return mix(skin_preconvolved(preconvolved_1, preconvolved_sampler_1, uv_2, power_4 / 4.0f), skin_preconvolved(preconvolved_1, preconvolved_sampler_1, uv_2, power_4 * power_4 / 4.0f), float3(0.05000000074505806f) );
}

float3 skin_filmic(float3 light_6)
{
    float3 x_1 = max(light_6 - float3(0.00400000018998981f) , float3(0.0f) );
    float3 _S21 = float3(6.19999980926513672f)  * x_1;
    return x_1 * (_S21 + float3(0.5f) ) / (x_1 * (_S21 + float3(1.70000004768371582f) ) + float3(0.05999999865889549f) );
}

float skin_srgb_curve(float x_2)
{
    float _S22;
    if(x_2 <= 0.00313080009073019f)
    {
        _S22 = 12.92000007629394531f * x_2;
    }
    else
    {
        _S22 = 1.0549999475479126f * pow(max(x_2, 9.999999960041972e-13f), 0.4166666567325592f) - 0.05499999970197678f;
    }
    return _S22;
}

float3 skin_srgb_from_linear(float3 light_7)
{
    float3 x_3 = saturate(light_7);
    return float3(skin_srgb_curve(x_3.x), skin_srgb_curve(x_3.y), skin_srgb_curve(x_3.z));
}

float skin_linear_curve(float x_4)
{
    float _S23;
    if(x_4 <= 0.04044999927282333f)
    {
        _S23 = x_4 / 12.92000007629394531f;
    }
    else
    {
        _S23 = pow((x_4 + 0.05499999970197678f) / 1.0549999475479126f, 2.40000009536743164f);
    }
    return _S23;
}

float3 skin_linear_from_srgb(float3 display_0)
{
    float3 x_5 = saturate(display_0);
    return float3(skin_linear_curve(x_5.x), skin_linear_curve(x_5.y), skin_linear_curve(x_5.z));
}

float skin_classic_blur_level(float radius_mm_1, float uv_scale_mm_1, float map_size_1, float hardware_level_1)
{
    return max(hardware_level_1, log2(max(map_size_1 * radius_mm_1, uv_scale_mm_1) / uv_scale_mm_1));
}

float3 skin_classic_direct(texture2d<float, access::sample> lut_5, sampler lut_sampler_5, float4 lut_axes_5, float3 sharp_0, float3 blurred_0, float3 light_8, float curvature_per_mm_3)
{
    float blurred_cosine_0 = dot(blurred_0, light_8);
    float k_1 = saturate(1.0f - blurred_cosine_0);
    float k_2 = k_1 * k_1;
    return saturate(saturate(float3(blurred_cosine_0, dot(skin_unit_vectors(mix(sharp_0, blurred_0, float3((0.30000001192092896f + 0.69999998807907104f * k_2)) )), light_8), dot(skin_unit_vectors(mix(sharp_0, blurred_0, float3(k_2) )), light_8))) + (((lut_5).sample((lut_sampler_5), (saturate((float2(blurred_cosine_0, abs(curvature_per_mm_3)) - lut_axes_5.xz) * lut_axes_5.yw)), level((0.0f)))).xyz - float3(max(blurred_cosine_0, 0.0f)) ));
}

matrix<float,int(3),int(3)>  skin_classic_ambient_normals(float3 sharp_1, float3 blurred_1)
{
    return matrix<float,int(3),int(3)> (blurred_1, skin_unit_vectors(mix(sharp_1, blurred_1, float3(0.30000001192092896f) )), sharp_1);
}

float skin_classic_sharpened_shadow(float shadow_filter_2, float sharpening_1)
{
    return skin_smoothstep(0.89999997615814209f * sharpening_1 * (shadow_filter_2 - 0.5f) + 0.5f);
}

float skin_classic_deep_scatter(float thickness_mm_2, float n_dot_l_4, float radius_mm_2, float strength_2)
{
    return strength_2 * skin_classic_transmittance(thickness_mm_2, radius_mm_2) * max(0.30000001192092896f - n_dot_l_4, 0.0f);
}
