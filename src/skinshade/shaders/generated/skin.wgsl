// The skinshade library, generated from shaders/skin by `python -m skinshade.codegen`.
fn rsqrt_0( x_0 : f32) -> f32
{
    return 1.0f / sqrt(x_0);
}

var<private> SKIN_POISSON_32_0 : array<vec2<f32>, i32(32)> = array<vec2<f32>, i32(32)>( vec2<f32>(-0.02096010930836201f, 0.01299272011965513f), vec2<f32>(0.69517123699188232f, -0.04910685122013092f), vec2<f32>(0.28034570813179016f, 0.66283899545669556f), vec2<f32>(0.03107489086687565f, -0.69704329967498779f), vec2<f32>(-0.49904009699821472f, 0.54098159074783325f), vec2<f32>(-0.70408397912979126f, -0.14709833264350891f), vec2<f32>(0.53451526165008545f, -0.56702268123626709f), vec2<f32>(-0.48678380250930786f, -0.61486828327178955f), vec2<f32>(0.68837428092956543f, 0.41418349742889404f), vec2<f32>(-0.14107078313827515f, 0.8102262020111084f), vec2<f32>(0.21897397935390472f, -0.3123532235622406f), vec2<f32>(0.31406453251838684f, 0.24951401352882385f), vec2<f32>(-0.83115619421005249f, 0.28457203507423401f), vec2<f32>(-0.40699386596679688f, 0.14198443293571472f), vec2<f32>(-0.10747358947992325f, 0.41360348463058472f), vec2<f32>(-0.19334819912910461f, -0.34689420461654663f), vec2<f32>(0.80768358707427979f, -0.37000563740730286f), vec2<f32>(0.33436411619186401f, -0.82407790422439575f), vec2<f32>(-0.79105347394943237f, -0.45378401875495911f), vec2<f32>(-0.23485180735588074f, -0.86940687894821167f), vec2<f32>(0.37255629897117615f, -0.05855973064899445f), vec2<f32>(0.5726354718208313f, 0.72984015941619873f), vec2<f32>(0.8966706395149231f, 0.17047682404518127f), vec2<f32>(-0.43273070454597473f, 0.81860679388046265f), vec2<f32>(0.1212853416800499f, 0.92984902858734131f), vec2<f32>(-0.42749753594398499f, -0.15111121535301208f), vec2<f32>(-0.94129812717437744f, 0.00735718011856079f), vec2<f32>(0.52211439609527588f, -0.28702935576438904f), vec2<f32>(-0.79033631086349487f, 0.5402228832244873f), vec2<f32>(-0.23410981893539429f, -0.59940856695175171f), vec2<f32>(0.28244560956954956f, -0.563071608543396f), vec2<f32>(0.57051312923431396f, 0.18359191715717316f) );
var<private> SKIN_POISSON_8_0 : array<vec2<f32>, i32(8)> = array<vec2<f32>, i32(8)>( vec2<f32>(-0.16089901328086853f, -0.04573699831962585f), vec2<f32>(-0.89243310689926147f, 0.18877510726451874f), vec2<f32>(-0.17830690741539001f, 0.7200586199760437f), vec2<f32>(-0.53433239459991455f, -0.70478206872940063f), vec2<f32>(0.22474820911884308f, -0.69165337085723877f), vec2<f32>(0.5559992790222168f, 0.1985180526971817f), vec2<f32>(0.64686292409896851f, -0.3364911675453186f), vec2<f32>(0.33836102485656738f, 0.67131179571151733f) );

fn skin_blur_level( sigma_mm_0 : f32,  uv_scale_mm_0 : f32,  map_size_0 : f32,  hardware_level_0 : f32) -> f32
{
    return max(hardware_level_0, log2(max(2.0f * sigma_mm_0 * map_size_0 / uv_scale_mm_0, 1.0f)));
}

fn skin_weighted( rows_0 : mat3x3<f32>,  weights_0 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(weights_0.x) * rows_0[i32(0)] + vec3<f32>(weights_0.y) * rows_0[i32(1)] + vec3<f32>(weights_0.z) * rows_0[i32(2)];
}

fn skin_blend_normals( fetched_0 : mat3x3<f32>,  blend_0 : mat3x3<f32>) -> mat3x3<f32>
{
    return mat3x3<f32>(skin_weighted(fetched_0, blend_0[i32(0)]), skin_weighted(fetched_0, blend_0[i32(1)]), skin_weighted(fetched_0, blend_0[i32(2)]));
}

fn skin_safe_length( v_0 : vec3<f32>) -> f32
{
    return sqrt(max(dot(v_0, v_0), 1.00000004581370497e-18f));
}

fn skin_displaced( from_texture_0 : vec3<f32>,  from_mesh_0 : vec3<f32>,  mesh_normal_0 : vec3<f32>) -> vec3<f32>
{
    return from_texture_0 + vec3<f32>(skin_safe_length(from_texture_0)) * (from_mesh_0 - mesh_normal_0);
}

fn skin_add_mesh_diffusion( from_texture_1 : mat3x3<f32>,  from_mesh_1 : mat3x3<f32>,  mesh_normal_1 : vec3<f32>) -> mat3x3<f32>
{
    return mat3x3<f32>(skin_displaced(from_texture_1[i32(0)], from_mesh_1[i32(0)], mesh_normal_1), skin_displaced(from_texture_1[i32(1)], from_mesh_1[i32(1)], mesh_normal_1), skin_displaced(from_texture_1[i32(2)], from_mesh_1[i32(2)], mesh_normal_1));
}

fn skin_relief_bump( m_0 : f32,  s_0 : f32) -> f32
{
    var _S1 : f32 = max(s_0, 9.99999971718068537e-10f);
    var _S2 : f32 = min(abs(m_0) / _S1, 8.0f);
    return _S1 * (0.39894229173660278f * exp(-0.5f * _S2 * _S2)) / (1.0f + _S2 * (1.25119507312774658f + _S2 * (0.58454132080078125f + _S2 * 0.06752368807792664f)));
}

fn skin_lengths( normals_0 : mat3x3<f32>) -> vec3<f32>
{
    return vec3<f32>(skin_safe_length(normals_0[i32(0)]), skin_safe_length(normals_0[i32(1)]), skin_safe_length(normals_0[i32(2)]));
}

fn skin_cosines( normals_1 : mat3x3<f32>,  light_0 : vec3<f32>,  lengths_0 : vec3<f32>) -> vec3<f32>
{
    return clamp(vec3<f32>(dot(normals_1[i32(0)], light_0), dot(normals_1[i32(1)], light_0), dot(normals_1[i32(2)], light_0)) / max(lengths_0, vec3<f32>(9.99999971718068537e-10f)), vec3<f32>(-1.0f), vec3<f32>(1.0f));
}

fn skin_curvature_table( lut_0 : texture_2d<f32>,  lut_sampler_0 : sampler,  lut_axes_0 : vec4<f32>,  cos_theta_0 : vec3<f32>,  curvature_per_mm_0 : f32) -> vec3<f32>
{
    var row_0 : f32 = sqrt(max(curvature_per_mm_0, 0.0f));
    var _S3 : vec2<f32> = lut_axes_0.xz;
    var _S4 : vec2<f32> = lut_axes_0.yw;
    return vec3<f32>((textureSampleLevel((lut_0), (lut_sampler_0), (saturate((vec2<f32>(cos_theta_0.x, row_0) - _S3) * _S4)), (0.0f))).xyz.x, (textureSampleLevel((lut_0), (lut_sampler_0), (saturate((vec2<f32>(cos_theta_0.y, row_0) - _S3) * _S4)), (0.0f))).xyz.y, (textureSampleLevel((lut_0), (lut_sampler_0), (saturate((vec2<f32>(cos_theta_0.z, row_0) - _S3) * _S4)), (0.0f))).xyz.z);
}

fn skin_lost_relief( lengths_1 : vec3<f32>,  cos_theta_1 : vec3<f32>) -> vec3<f32>
{
    var _S5 : vec3<f32> = vec3<f32>(0.0f);
    var slope_0 : vec3<f32> = sqrt(max((vec3<f32>(0) - log(clamp(lengths_1, vec3<f32>(0.00100000004749745f), vec3<f32>(1.0f)))), _S5));
    var sine_0 : vec3<f32> = sqrt(max(vec3<f32>(1.0f) - cos_theta_1 * cos_theta_1, _S5));
    return vec3<f32>(skin_relief_bump(lengths_1.x * cos_theta_1.x, slope_0.x * sine_0.x), skin_relief_bump(lengths_1.y * cos_theta_1.y, slope_0.y * sine_0.y), skin_relief_bump(lengths_1.z * cos_theta_1.z, slope_0.z * sine_0.z));
}

fn skin_direct_scalar( lut_1 : texture_2d<f32>,  lut_sampler_1 : sampler,  lut_axes_1 : vec4<f32>,  normals_2 : mat3x3<f32>,  light_1 : vec3<f32>,  curvature_per_mm_1 : f32,  gain_0 : vec3<f32>) -> vec3<f32>
{
    var lengths_2 : vec3<f32> = skin_lengths(normals_2);
    var cos_theta_2 : vec3<f32> = skin_cosines(normals_2, light_1, lengths_2);
    return gain_0 * (lengths_2 * skin_curvature_table(lut_1, lut_sampler_1, lut_axes_1, cos_theta_2, abs(curvature_per_mm_1)) + skin_lost_relief(lengths_2, cos_theta_2));
}

fn skin_transfer( transfer_0 : texture_2d<f32>,  transfer_sampler_0 : sampler,  transfer_axes_0 : vec4<f32>,  k_per_mm_0 : f32) -> vec3<f32>
{
    return (textureSampleLevel((transfer_0), (transfer_sampler_0), (saturate((vec2<f32>(sqrt(max(k_per_mm_0, 0.0f)), 0.5f) - transfer_axes_0.xz) * transfer_axes_0.yw)), (0.0f))).xyz;
}

fn skin_direct_tensor( lut_2 : texture_2d<f32>,  lut_sampler_2 : sampler,  lut_axes_2 : vec4<f32>,  transfer_1 : texture_2d<f32>,  transfer_sampler_1 : sampler,  transfer_axes_1 : vec4<f32>,  normals_3 : mat3x3<f32>,  light_2 : vec3<f32>,  directional_per_mm_0 : f32,  total_per_mm_0 : f32,  gain_1 : vec3<f32>) -> vec3<f32>
{
    var lengths_3 : vec3<f32> = skin_lengths(normals_3);
    var cos_theta_3 : vec3<f32> = skin_cosines(normals_3, light_2, lengths_3);
    return gain_1 * (lengths_3 * (skin_curvature_table(lut_2, lut_sampler_2, lut_axes_2, cos_theta_3, directional_per_mm_0) * skin_transfer(transfer_1, transfer_sampler_1, transfer_axes_1, sqrt(max((total_per_mm_0 - directional_per_mm_0) * (total_per_mm_0 + directional_per_mm_0), 0.0f)))) + skin_lost_relief(lengths_3, cos_theta_3));
}

fn skin_direct_diffused_normals( lut_3 : texture_2d<f32>,  lut_sampler_3 : sampler,  lut_axes_3 : vec4<f32>,  transfer_2 : texture_2d<f32>,  transfer_sampler_2 : sampler,  transfer_axes_2 : vec4<f32>,  normals_4 : mat3x3<f32>,  relief_length_0 : vec3<f32>,  light_3 : vec3<f32>,  directional_per_mm_1 : f32,  gain_2 : vec3<f32>) -> vec3<f32>
{
    var lengths_4 : vec3<f32> = skin_lengths(normals_4);
    var cos_theta_4 : vec3<f32> = skin_cosines(normals_4, light_3, lengths_4);
    return gain_2 * (skin_curvature_table(lut_3, lut_sampler_3, lut_axes_3, cos_theta_4, directional_per_mm_1) * min(lengths_4 / max(skin_transfer(transfer_2, transfer_sampler_2, transfer_axes_2, directional_per_mm_1), vec3<f32>(9.99999997475242708e-07f)), vec3<f32>(1.0f)) + skin_lost_relief(relief_length_0, cos_theta_4));
}

fn skin_unexplained_length( transfer_3 : texture_2d<f32>,  transfer_sampler_3 : sampler,  transfer_axes_3 : vec4<f32>,  from_texture_2 : mat3x3<f32>,  from_mesh_2 : mat3x3<f32>,  total_per_mm_1 : f32) -> vec3<f32>
{
    return skin_lengths(from_texture_2) * min(skin_lengths(from_mesh_2) / max(vec3<f32>(0.97500002384185791f) * skin_transfer(transfer_3, transfer_sampler_3, transfer_axes_3, total_per_mm_1), vec3<f32>(9.99999997475242708e-07f)), vec3<f32>(1.0f));
}

fn skin_directional_curvature( tensor_world_0 : mat3x3<f32>,  normal_0 : vec3<f32>,  light_4 : vec3<f32>) -> vec2<f32>
{
    var tangential_0 : vec3<f32> = light_4 - normal_0 * vec3<f32>(dot(light_4, normal_0));
    var turn_0 : vec3<f32> = vec3<f32>(dot(tensor_world_0[i32(0)], tangential_0), dot(tensor_world_0[i32(1)], tangential_0), dot(tensor_world_0[i32(2)], tangential_0));
    var total_0 : f32 = sqrt(dot(tensor_world_0[i32(0)], tensor_world_0[i32(0)]) + dot(tensor_world_0[i32(1)], tensor_world_0[i32(1)]) + dot(tensor_world_0[i32(2)], tensor_world_0[i32(2)]));
    return vec2<f32>(min(sqrt(dot(turn_0, turn_0) / max(dot(tangential_0, tangential_0), 9.999999960041972e-13f)), total_0), total_0);
}

fn skin_energy_gain( albedo_0 : vec3<f32>,  rms_radius_mm_0 : vec3<f32>,  curvature_per_mm_2 : vec3<f32>) -> vec3<f32>
{
    var _S6 : vec3<f32> = vec3<f32>(1.0f);
    var absorbed_0 : vec3<f32> = _S6 - albedo_0;
    var u_0 : vec3<f32> = vec3<f32>(1.20000004768371582f) * absorbed_0 * rms_radius_mm_0 * max(curvature_per_mm_2, vec3<f32>(0.0f));
    var bound_0 : vec3<f32> = u_0 * albedo_0 / absorbed_0;
    return _S6 + u_0 / sqrt(_S6 + bound_0 * bound_0);
}

fn skin_smoothstep( p_0 : f32) -> f32
{
    var q_0 : f32 = saturate(p_0);
    return q_0 * q_0 * (3.0f - 2.0f * q_0);
}

fn skin_diffused_shadow( lut_4 : texture_2d<f32>,  lut_sampler_4 : sampler,  lut_axes_4 : vec4<f32>,  shadow_filter_0 : f32,  n_dot_l_0 : f32,  filter_width_mm_0 : f32) -> vec3<f32>
{
    return (textureSampleLevel((lut_4), (lut_sampler_4), (saturate((vec2<f32>(shadow_filter_0, max(n_dot_l_0, 0.05000000074505806f) / filter_width_mm_0) - lut_axes_4.xz) * lut_axes_4.yw)), (0.0f))).xyz;
}

fn skin_sharpened_shadow( shadow_filter_1 : f32,  sharpening_0 : f32) -> f32
{
    return skin_smoothstep((0.5f - sin(asin(1.0f - 2.0f * saturate(shadow_filter_1)) / 3.0f) - 0.5f) * sharpening_0 + 0.5f);
}

fn skin_variance_shadow( mean_depth_mm_0 : f32,  mean_square_depth_mm2_0 : f32,  depth_mm_0 : f32) -> f32
{
    var _S7 : f32 = max(mean_square_depth_mm2_0 - mean_depth_mm_0 * mean_depth_mm_0, 0.00999999977648258f);
    var _S8 : f32 = max(depth_mm_0 - mean_depth_mm_0, 0.0f);
    return _S7 / (_S7 + _S8 * _S8);
}

fn skin_sh_bands( sh_0 : mat3x3<f32>,  d_0 : vec3<f32>) -> vec3<f32>
{
    var _S9 : f32 = d_0.y;
    var _S10 : f32 = d_0.z;
    var _S11 : f32 = d_0.x;
    return vec3<f32>(0.282094806432724f * sh_0[i32(0)].x, 0.48860251903533936f * (sh_0[i32(0)].y * _S9 + sh_0[i32(0)].z * _S10 + sh_0[i32(1)].x * _S11), 1.09254848957061768f * (sh_0[i32(1)].y * _S11 * _S9 + sh_0[i32(1)].z * _S9 * _S10 + sh_0[i32(2)].y * _S11 * _S10) + 0.31539157032966614f * sh_0[i32(2)].x * (3.0f * _S10 * _S10 - 1.0f) + 0.54627424478530884f * sh_0[i32(2)].z * (_S11 * _S11 - _S9 * _S9));
}

fn skin_ambient_channel( sh_1 : mat3x3<f32>,  normal_1 : vec3<f32>,  band_transfer_0 : vec3<f32>) -> f32
{
    var l_0 : f32 = skin_safe_length(normal_1);
    return max(dot(skin_sh_bands(sh_1, normal_1 / vec3<f32>(l_0)), vec3<f32>(1.0f, l_0, l_0 * l_0 * l_0) * band_transfer_0 * vec3<f32>(1.0f, 0.66666668653488159f, 0.25f)), 0.0f);
}

fn skin_ambient_irradiance( radiance_sh_red_0 : mat3x3<f32>,  radiance_sh_green_0 : mat3x3<f32>,  radiance_sh_blue_0 : mat3x3<f32>,  normals_5 : mat3x3<f32>,  band_transfer_1 : mat3x3<f32>) -> vec3<f32>
{
    var t_0 : mat3x3<f32> = transpose(band_transfer_1);
    return vec3<f32>(skin_ambient_channel(radiance_sh_red_0, normals_5[i32(0)], t_0[i32(0)]), skin_ambient_channel(radiance_sh_green_0, normals_5[i32(1)], t_0[i32(1)]), skin_ambient_channel(radiance_sh_blue_0, normals_5[i32(2)], t_0[i32(2)]));
}

fn skin_unit_vectors( v_1 : vec3<f32>) -> vec3<f32>
{
    return v_1 / vec3<f32>(skin_safe_length(v_1));
}

fn skin_ambient_normals( normals_6 : mat3x3<f32>) -> mat3x3<f32>
{
    return mat3x3<f32>(skin_unit_vectors(normals_6[i32(0)]), skin_unit_vectors(normals_6[i32(1)]), skin_unit_vectors(normals_6[i32(2)]));
}

fn skin_ambient_of_three( red_0 : vec3<f32>,  green_0 : vec3<f32>,  blue_0 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(red_0.x, green_0.y, blue_0.z);
}

fn skin_bounced_visibility( visibility_0 : vec3<f32>,  albedo_1 : vec3<f32>) -> vec3<f32>
{
    return max(visibility_0, ((visibility_0 * (vec3<f32>(2.04040002822875977f) * albedo_1 - vec3<f32>(0.33239999413490295f)) + (vec3<f32>(-4.79510021209716797f) * albedo_1 + vec3<f32>(0.64170002937316895f))) * visibility_0 + (vec3<f32>(2.75519990921020508f) * albedo_1 + vec3<f32>(0.69029998779296875f))) * visibility_0);
}

fn skin_specular_visibility( n_dot_v_0 : f32,  visibility_1 : f32,  roughness_0 : f32) -> f32
{
    var exponent_0 : f32 = exp2(-16.0f * roughness_0 - 1.0f);
    var base_0 : f32 = n_dot_v_0 + visibility_1;
    var open_0 : f32;
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

fn skin_linear_depth( depth_0 : f32,  projection_0 : mat4x4<f32>) -> f32
{
    return abs((depth_0 * projection_0[i32(3)][i32(3)] - projection_0[i32(2)][i32(3)]) / (projection_0[i32(2)][i32(2)] - depth_0 * projection_0[i32(3)][i32(2)]));
}

fn skin_inward_offset( position_mm_0 : vec3<f32>,  normal_2 : vec3<f32>,  offset_mm_0 : f32) -> vec3<f32>
{
    return position_mm_0 - normal_2 * vec3<f32>(offset_mm_0);
}

fn skin_thickness( depth_map_0 : texture_2d<f32>,  depth_map_sampler_0 : sampler,  projection_1 : mat4x4<f32>,  uv_0 : vec2<f32>,  receiver_mm_0 : f32,  radius_uv_0 : vec2<f32>,  taps_0 : i32) -> f32
{
    var tap_0 : i32 = i32(0);
    var total_1 : f32 = 0.0f;
    for(;;)
    {
        if(tap_0 < taps_0)
        {
        }
        else
        {
            break;
        }
        var place_0 : vec2<f32>;
        if(taps_0 == i32(8))
        {
            place_0 = SKIN_POISSON_8_0[min(tap_0, i32(7))];
        }
        else
        {
            place_0 = SKIN_POISSON_32_0[min(tap_0, i32(31))];
        }
        var total_2 : f32 = total_1 + max(receiver_mm_0 - skin_linear_depth((textureSampleLevel((depth_map_0), (depth_map_sampler_0), (uv_0 + place_0 * radius_uv_0), (0.0f))).x, projection_1), 0.0f);
        tap_0 = tap_0 + i32(1);
        total_1 = total_2;
    }
    return total_1 / f32(max(taps_0, i32(1)));
}

fn skin_transmittance( thickness_mm_0 : f32,  albedo_2 : vec3<f32>,  sigma_per_mm_0 : vec3<f32>) -> vec3<f32>
{
    var a2_0 : vec3<f32> = albedo_2 * albedo_2;
    var _S12 : vec3<f32> = vec3<f32>(1.0f);
    var _S13 : vec3<f32> = vec3<f32>(2.0f);
    var _S14 : vec3<f32> = _S13 * albedo_2;
    var a_0 : vec3<f32> = (_S12 + a2_0) / _S14;
    var b_0 : vec3<f32> = (_S12 - a2_0) / _S14;
    var decay_0 : vec3<f32> = exp((vec3<f32>(0) - sigma_per_mm_0) * vec3<f32>(thickness_mm_0));
    return _S13 * b_0 * decay_0 / (a_0 + b_0 - (a_0 - b_0) * decay_0 * decay_0);
}

fn skin_classic_transmittance( thickness_mm_1 : f32,  radius_mm_0 : f32) -> f32
{
    var t_1 : f32 = thickness_mm_1 / radius_mm_0;
    return exp(-0.5f * t_1 * t_1);
}

fn skin_direct_deep_scatter( transmitted_0 : vec3<f32>,  n_dot_l_1 : f32,  strength_0 : f32) -> vec3<f32>
{
    return vec3<f32>(strength_0) * transmitted_0 * vec3<f32>(max(- n_dot_l_1, 0.0f));
}

fn skin_ambient_deep_scatter( transmitted_1 : vec3<f32>,  irradiance_behind_0 : vec3<f32>,  strength_1 : f32) -> vec3<f32>
{
    return vec3<f32>(strength_1) * transmitted_1 * irradiance_behind_0;
}

fn skin_specular_power( gloss_0 : f32) -> f32
{
    return exp2(13.0f * gloss_0);
}

fn skin_gloss_of_relief( gloss_1 : f32,  normal_length_0 : f32) -> f32
{
    var l_1 : f32 = clamp(normal_length_0, 0.00100000004749745f, 1.0f);
    var power_0 : f32 = skin_specular_power(gloss_1);
    return log2(max(l_1 * power_0 / (l_1 + power_0 * (1.0f - l_1)), 1.0f)) / 13.0f;
}

fn skin_gloss_from_roughness( roughness_1 : f32) -> f32
{
    var _S15 : f32 = max(roughness_1, 0.00100000004749745f);
    var r2_0 : f32 = _S15 * _S15;
    return clamp(log2(max(2.0f / (r2_0 * r2_0) - 2.0f, 1.0f)) / 13.0f, 0.0f, 1.0f);
}

fn skin_lobe( n_dot_h_0 : f32,  n_dot_l_2 : f32,  n_dot_v_1 : f32,  power_1 : f32) -> f32
{
    var k_0 : f32 = rsqrt_0(3.14159274101257324f * power_1 / 4.0f + 1.57079637050628662f);
    var _S16 : f32 = 1.0f - k_0;
    return (power_1 + 2.0f) / 6.28318548202514648f * pow(max(n_dot_h_0, 9.99999971718068537e-10f), power_1) * (0.25f / ((k_0 + _S16 * n_dot_l_2) * (k_0 + _S16 * n_dot_v_1)));
}

fn skin_specular( normal_3 : vec3<f32>,  view_0 : vec3<f32>,  light_5 : vec3<f32>,  gloss_2 : f32,  reflectance_0 : f32) -> f32
{
    var half_vector_0 : vec3<f32> = skin_unit_vectors(view_0 + light_5);
    var n_dot_l_3 : f32 = saturate(dot(normal_3, light_5));
    var n_dot_v_2 : f32 = clamp(dot(normal_3, view_0), 0.00009999999747379f, 1.0f);
    var n_dot_h_1 : f32 = saturate(dot(normal_3, half_vector_0));
    var wide_0 : f32 = skin_specular_power(gloss_2);
    var away_0 : f32 = 1.0f - saturate(dot(view_0, half_vector_0));
    var away2_0 : f32 = away_0 * away_0;
    return 3.14159274101257324f * (0.94999998807907104f * skin_lobe(n_dot_h_1, n_dot_l_3, n_dot_v_2, wide_0) + 0.05000000074505806f * skin_lobe(n_dot_h_1, n_dot_l_3, n_dot_v_2, min(wide_0 * wide_0, 8192.0f))) * (reflectance_0 + (1.0f - reflectance_0) * away2_0 * away2_0 * away_0) * n_dot_l_3;
}

fn skin_reflected( normal_4 : vec3<f32>,  view_1 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>((2.0f * dot(normal_4, view_1))) * normal_4 - view_1;
}

fn skin_ambient_specular_fresnel( n_dot_v_3 : f32,  gloss_3 : f32,  reflectance_1 : f32) -> f32
{
    var away_1 : f32 = 1.0f - saturate(n_dot_v_3);
    var away2_1 : f32 = away_1 * away_1;
    return reflectance_1 + (1.0f - reflectance_1) * away2_1 * away2_1 * away_1 / (4.0f - 3.0f * gloss_3);
}

fn skin_diffuse_share( n_dot_v_4 : f32,  gloss_4 : f32,  reflectance_2 : f32) -> f32
{
    return 1.0f - skin_ambient_specular_fresnel(n_dot_v_4, gloss_4, reflectance_2);
}

fn skin_equirectangular_uv( direction_0 : vec3<f32>) -> vec2<f32>
{
    var _S17 : f32 = direction_0.x;
    var _S18 : f32 = direction_0.z;
    var level_0 : f32 = sqrt(_S17 * _S17 + _S18 * _S18);
    var x_1 : f32;
    if(level_0 > 0.0f)
    {
        x_1 = _S17;
    }
    else
    {
        x_1 = 1.0f;
    }
    return vec2<f32>(0.5f + atan2(_S18, x_1) / 6.28318548202514648f, atan2(level_0, direction_0.y) / 3.14159274101257324f);
}

fn skin_reflection_level( power_2 : f32) -> f32
{
    return clamp(0.5f * log2(max(power_2, 1.0f)), 0.0f, 4.0f);
}

fn skin_preconvolved( preconvolved_0 : texture_2d<f32>,  preconvolved_sampler_0 : sampler,  uv_1 : vec2<f32>,  power_3 : f32) -> vec3<f32>
{
    var level_1 : f32 = skin_reflection_level(power_3);
    var _S19 : f32 = min(floor(level_1), 3.0f);
    var row_1 : f32 = clamp(uv_1.y, 0.0078125f, 0.9921875f);
    var _S20 : f32 = uv_1.x;
    return mix((textureSampleLevel((preconvolved_0), (preconvolved_sampler_0), (vec2<f32>(_S20, (_S19 + row_1) / 5.0f)), (0.0f))).xyz, (textureSampleLevel((preconvolved_0), (preconvolved_sampler_0), (vec2<f32>(_S20, (_S19 + 1.0f + row_1) / 5.0f)), (0.0f))).xyz, vec3<f32>((level_1 - _S19)));
}

fn skin_reflected_radiance( preconvolved_1 : texture_2d<f32>,  preconvolved_sampler_1 : sampler,  direction_1 : vec3<f32>,  gloss_5 : f32) -> vec3<f32>
{
    var uv_2 : vec2<f32> = skin_equirectangular_uv(direction_1);
    var power_4 : f32 = skin_specular_power(gloss_5);
    return mix(skin_preconvolved(preconvolved_1, preconvolved_sampler_1, uv_2, power_4 / 4.0f), skin_preconvolved(preconvolved_1, preconvolved_sampler_1, uv_2, power_4 * power_4 / 4.0f), vec3<f32>(0.05000000074505806f));
}

fn skin_filmic( light_6 : vec3<f32>) -> vec3<f32>
{
    var x_2 : vec3<f32> = max(light_6 - vec3<f32>(0.00400000018998981f), vec3<f32>(0.0f));
    var _S21 : vec3<f32> = vec3<f32>(6.19999980926513672f) * x_2;
    return x_2 * (_S21 + vec3<f32>(0.5f)) / (x_2 * (_S21 + vec3<f32>(1.70000004768371582f)) + vec3<f32>(0.05999999865889549f));
}

fn skin_srgb_curve( x_3 : f32) -> f32
{
    var _S22 : f32;
    if(x_3 <= 0.00313080009073019f)
    {
        _S22 = 12.92000007629394531f * x_3;
    }
    else
    {
        _S22 = 1.0549999475479126f * pow(max(x_3, 9.999999960041972e-13f), 0.4166666567325592f) - 0.05499999970197678f;
    }
    return _S22;
}

fn skin_srgb_from_linear( light_7 : vec3<f32>) -> vec3<f32>
{
    var x_4 : vec3<f32> = saturate(light_7);
    return vec3<f32>(skin_srgb_curve(x_4.x), skin_srgb_curve(x_4.y), skin_srgb_curve(x_4.z));
}

fn skin_linear_curve( x_5 : f32) -> f32
{
    var _S23 : f32;
    if(x_5 <= 0.04044999927282333f)
    {
        _S23 = x_5 / 12.92000007629394531f;
    }
    else
    {
        _S23 = pow((x_5 + 0.05499999970197678f) / 1.0549999475479126f, 2.40000009536743164f);
    }
    return _S23;
}

fn skin_linear_from_srgb( display_0 : vec3<f32>) -> vec3<f32>
{
    var x_6 : vec3<f32> = saturate(display_0);
    return vec3<f32>(skin_linear_curve(x_6.x), skin_linear_curve(x_6.y), skin_linear_curve(x_6.z));
}

fn skin_classic_blur_level( radius_mm_1 : f32,  uv_scale_mm_1 : f32,  map_size_1 : f32,  hardware_level_1 : f32) -> f32
{
    return max(hardware_level_1, log2(max(map_size_1 * radius_mm_1, uv_scale_mm_1) / uv_scale_mm_1));
}

fn skin_classic_direct( lut_5 : texture_2d<f32>,  lut_sampler_5 : sampler,  lut_axes_5 : vec4<f32>,  sharp_0 : vec3<f32>,  blurred_0 : vec3<f32>,  light_8 : vec3<f32>,  curvature_per_mm_3 : f32) -> vec3<f32>
{
    var blurred_cosine_0 : f32 = dot(blurred_0, light_8);
    var k_1 : f32 = saturate(1.0f - blurred_cosine_0);
    var k_2 : f32 = k_1 * k_1;
    return saturate(saturate(vec3<f32>(blurred_cosine_0, dot(skin_unit_vectors(mix(sharp_0, blurred_0, vec3<f32>((0.30000001192092896f + 0.69999998807907104f * k_2)))), light_8), dot(skin_unit_vectors(mix(sharp_0, blurred_0, vec3<f32>(k_2))), light_8))) + ((textureSampleLevel((lut_5), (lut_sampler_5), (saturate((vec2<f32>(blurred_cosine_0, abs(curvature_per_mm_3)) - lut_axes_5.xz) * lut_axes_5.yw)), (0.0f))).xyz - vec3<f32>(max(blurred_cosine_0, 0.0f))));
}

fn skin_classic_ambient_normals( sharp_1 : vec3<f32>,  blurred_1 : vec3<f32>) -> mat3x3<f32>
{
    return mat3x3<f32>(blurred_1, skin_unit_vectors(mix(sharp_1, blurred_1, vec3<f32>(0.30000001192092896f))), sharp_1);
}

fn skin_classic_sharpened_shadow( shadow_filter_2 : f32,  sharpening_1 : f32) -> f32
{
    return skin_smoothstep(0.89999997615814209f * sharpening_1 * (shadow_filter_2 - 0.5f) + 0.5f);
}

fn skin_classic_deep_scatter( thickness_mm_2 : f32,  n_dot_l_4 : f32,  radius_mm_2 : f32,  strength_2 : f32) -> f32
{
    return strength_2 * skin_classic_transmittance(thickness_mm_2, radius_mm_2) * max(0.30000001192092896f - n_dot_l_4, 0.0f);
}
