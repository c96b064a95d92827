// The skinshade library, generated from shading/*.slang by `python -m codegen`.
static const float2  SKIN_CONTACT_DISK[int(12)] = { float2(0.16725532710552216f, 0.0f), float2(-0.21519750356674194f, 0.19713853299617767f), float2(0.0332011915743351f, -0.3783104419708252f), float2(0.27573889493942261f, 0.35965254902839661f), float2(-0.51071953773498535f, -0.09033908694982529f), float2(0.48873069882392883f, -0.31089046597480774f), float2(-0.16532173752784729f, 0.61498862504959106f), float2(-0.31931877136230469f, -0.61482888460159302f), float2(0.70304751396179199f, 0.25675183534622192f), float2(-0.74441087245941162f, 0.3072819709777832f), float2(0.36706140637397766f, -0.78438889980316162f), float2(0.28072324395179749f, 0.89498996734619141f) };
static const float2  SKIN_SHADOW_DISK_48[int(48)] = { float2(0.08340597897768021f, 0.0f), float2(-0.10671073943376541f, 0.09775578230619431f), float2(0.01636306010186672f, -0.1864485889673233f), float2(0.13498826324939728f, 0.17606829106807709f), float2(-0.24817833304405212f, -0.04389924928545952f), float2(0.2355383038520813f, -0.14983019232749939f), float2(-0.07893361896276474f, 0.29362913966178894f), float2(-0.15082783997058868f, -0.29040983319282532f), float2(0.32788398861885071f, 0.11974270641803741f), float2(-0.34179624915122986f, 0.14108851552009583f), float2(0.16510665416717529f, -0.35282331705093384f), float2(0.12226484715938568f, 0.38979959487915039f), float2(-0.36929354071617126f, -0.21401314437389374f), float2(0.4341655969619751f, -0.09545008838176727f), float2(-0.2655525803565979f, 0.37772122025489807f), float2(-0.06148780882358551f, -0.47449716925621033f), float2(0.37834861874580383f, 0.31887263059616089f), float2(-0.51034331321716309f, 0.02110430039465427f), float2(0.37315717339515686f, -0.37134122848510742f), float2(-0.02502750046551228f, 0.54124277830123901f), float2(-0.3568427562713623f, -0.42761686444282532f), float2(0.56674838066101074f, 0.0762551873922348f), float2(-0.48148587346076965f, 0.33500534296035767f), float2(0.13193005323410034f, -0.58644229173660278f), float2(0.30600649118423462f, 0.53402209281921387f), float2(-0.59994620084762573f, -0.1913992166519165f), float2(0.58451014757156372f, -0.27005851268768311f), float2(-0.25400349497795105f, 0.60692840814590454f), float2(-0.22741274535655975f, -0.63226538896560669f), float2(0.60710901021957397f, 0.31907948851585388f), float2(-0.6766400933265686f, 0.17836016416549683f), float2(0.38596493005752563f, -0.60026413202285767f), float2(0.12322843074798584f, 0.71703100204467773f), float2(-0.58622837066650391f, -0.45400822162628174f), float2(0.75288873910903931f, -0.06237528845667839f), float2(-0.52258288860321045f, 0.56489682197570801f), float2(0.0038233099039644f, -0.78373259305953979f), float2(0.53622621297836304f, 0.59111112356185913f), float2(-0.80917233228683472f, -0.07499390840530396f), float2(0.65910446643829346f, -0.50023680925369263f), float2(-0.15080370008945465f, 0.82895052433013916f), float2(-0.45701694488525391f, -0.72624564170837402f), float2(0.84303575754165649f, 0.23104114830493927f), float2(-0.79258495569229126f, 0.40674149990081787f), float2(0.31582745909690857f, -0.85189038515090942f), float2(0.34976369142532349f, 0.85918575525283813f), float2(-0.85765814781188965f, -0.40646019577980042f), float2(0.93254464864730835f, -0.28751349449157715f) };
static const float2  SKIN_SHADOW_DISK_16[int(16)] = { float2(0.14471825957298279f, 0.0f), float2(-0.18583981692790985f, 0.170244500041008f), float2(0.02860930934548378f, -0.32598838210105896f), float2(0.23701368272304535f, 0.30914238095283508f), float2(-0.43773865699768066f, -0.07742980122566223f), float2(0.41749045252799988f, -0.26557326316833496f), float2(-0.14065909385681152f, 0.52324479818344116f), float2(-0.27035140991210938f, -0.52054518461227417f), float2(0.59152573347091675f, 0.21602423489093781f), float2(-0.6210860013961792f, 0.25637525320053101f), float2(0.30247461795806885f, -0.64637070894241333f), float2(0.22609943151473999f, 0.72084063291549683f), float2(-0.69051814079284668f, -0.40016940236091614f), float2(0.82290405035018921f, -0.18091315031051636f), float2(-0.5123591423034668f, 0.7287781834602356f), float2(-0.12196926772594452f, -0.94122844934463501f) };
static const float2  SKIN_POISSON_32[int(32)] = { float2(-0.02096010930836201f, 0.01299272011965513f), float2(0.69517123699188232f, -0.04910685122013092f), float2(0.28034570813179016f, 0.66283899545669556f), float2(0.03107489086687565f, -0.69704329967498779f), float2(-0.49904009699821472f, 0.54098159074783325f), float2(-0.70408397912979126f, -0.14709833264350891f), float2(0.53451526165008545f, -0.56702268123626709f), float2(-0.48678380250930786f, -0.61486828327178955f), float2(0.68837428092956543f, 0.41418349742889404f), float2(-0.14107078313827515f, 0.8102262020111084f), float2(0.21897397935390472f, -0.3123532235622406f), float2(0.31406453251838684f, 0.24951401352882385f), float2(-0.83115619421005249f, 0.28457203507423401f), float2(-0.40699386596679688f, 0.14198443293571472f), float2(-0.10747358947992325f, 0.41360348463058472f), float2(-0.19334819912910461f, -0.34689420461654663f), float2(0.80768358707427979f, -0.37000563740730286f), float2(0.33436411619186401f, -0.82407790422439575f), float2(-0.79105347394943237f, -0.45378401875495911f), float2(-0.23485180735588074f, -0.86940687894821167f), float2(0.37255629897117615f, -0.05855973064899445f), float2(0.5726354718208313f, 0.72984015941619873f), float2(0.8966706395149231f, 0.17047682404518127f), float2(-0.43273070454597473f, 0.81860679388046265f), float2(0.1212853416800499f, 0.92984902858734131f), float2(-0.42749753594398499f, -0.15111121535301208f), float2(-0.94129812717437744f, 0.00735718011856079f), float2(0.52211439609527588f, -0.28702935576438904f), float2(-0.79033631086349487f, 0.5402228832244873f), float2(-0.23410981893539429f, -0.59940856695175171f), float2(0.28244560956954956f, -0.563071608543396f), float2(0.57051312923431396f, 0.18359191715717316f) };
static const float2  SKIN_POISSON_8[int(8)] = { float2(-0.16089901328086853f, -0.04573699831962585f), float2(-0.89243310689926147f, 0.18877510726451874f), float2(-0.17830690741539001f, 0.7200586199760437f), float2(-0.53433239459991455f, -0.70478206872940063f), float2(0.22474820911884308f, -0.69165337085723877f), float2(0.5559992790222168f, 0.1985180526971817f), float2(0.64686292409896851f, -0.3364911675453186f), float2(0.33836102485656738f, 0.67131179571151733f) };

float skin_map_level(float2 map_extent, float2 uv_along_x, float2 uv_along_y)
{
    float2 texels_x_0 = uv_along_x * map_extent;
    float2 texels_y_0 = uv_along_y * map_extent;
    float x_0 = dot(texels_x_0, texels_x_0);
    float y_0 = dot(texels_y_0, texels_y_0);
    return max(0.5f * log2(max(max(min(x_0, y_0), max(x_0, y_0) / 64.0f), 1.00000000317107685e-30f)), 0.0f);
}

float skin_blur_level(float sigma_mm, float uv_scale_mm, float map_size, float hardware_level)
{
    return max(hardware_level, log2(max(2.0f * sigma_mm * map_size / uv_scale_mm, 1.0f)));
}

float3 skin_weighted_sum(float3x3 rows, float3 weights)
{
    return weights.x * rows[int(0)] + weights.y * rows[int(1)] + weights.z * rows[int(2)];
}

float3x3 skin_blend_normals(float3x3 fetched, float3x3 blend)
{
    return float3x3(skin_weighted_sum(fetched, blend[int(0)]), skin_weighted_sum(fetched, blend[int(1)]), skin_weighted_sum(fetched, blend[int(2)]));
}

float skin_safe_length(float3 v)
{
    return sqrt(max(dot(v, v), 1.00000004581370497e-18f));
}

float3 skin_with_mesh_diffusion(float3 from_texture, float3 from_mesh, float3 mesh_normal)
{
    return from_texture + skin_safe_length(from_texture) * (from_mesh - mesh_normal);
}

float3x3 skin_add_mesh_diffusion(float3x3 from_texture, float3x3 from_mesh, float3 mesh_normal)
{
    return float3x3(skin_with_mesh_diffusion(from_texture[int(0)], from_mesh[int(0)], mesh_normal), skin_with_mesh_diffusion(from_texture[int(1)], from_mesh[int(1)], mesh_normal), skin_with_mesh_diffusion(from_texture[int(2)], from_mesh[int(2)], mesh_normal));
}

float skin_relief_bump(float m, float s)
{
    float _S1 = max(s, 9.99999971718068537e-10f);
    float _S2 = max(1.0f - abs(m) / (4.40000009536743164f * _S1), 0.0f);
    float t2_0 = _S2 * _S2;
    return _S1 * t2_0 * t2_0 * (0.16452799737453461f + _S2 * (-1.55506408214569092f + _S2 * (7.10253477096557617f + _S2 * (-16.75164794921875f + _S2 * (22.75126266479492188f + _S2 * (-15.08054447174072266f + _S2 * 3.76787090301513672f))))));
}

float3 skin_lengths(float3x3 normals)
{
    return float3(skin_safe_length(normals[int(0)]), skin_safe_length(normals[int(1)]), skin_safe_length(normals[int(2)]));
}

float3 skin_cosines(float3x3 normals, float3 light, float3 lengths)
{
    return clamp(float3(dot(normals[int(0)], light), dot(normals[int(1)], light), dot(normals[int(2)], light)) / lengths, (float3)-1.0f, (float3)1.0f);
}

float3 skin_curvature_table(Texture2D<float4 > lut, SamplerState lut_sampler, float4 lut_axes, float3 cos_theta, float curvature_per_mm)
{
    float row_0 = sqrt(max(curvature_per_mm, 0.0f));
    float2 _S3 = lut_axes.xz;
    float2 _S4 = lut_axes.yw;
    return float3(lut.SampleLevel(lut_sampler, saturate((float2(cos_theta.x, row_0) - _S3) * _S4), 0.0f).xyz.x, lut.SampleLevel(lut_sampler, saturate((float2(cos_theta.y, row_0) - _S3) * _S4), 0.0f).xyz.y, lut.SampleLevel(lut_sampler, saturate((float2(cos_theta.z, row_0) - _S3) * _S4), 0.0f).xyz.z);
}

float3 skin_relief_light(float3 lengths, float3 cos_theta)
{
    float3 slope_0 = sqrt(max(- log(clamp(lengths, (float3)0.00100000004749745f, (float3)1.0f)) * (1.0f - cos_theta * cos_theta), (float3)0.0f));
    return float3(skin_relief_bump(lengths.x * cos_theta.x, slope_0.x), skin_relief_bump(lengths.y * cos_theta.y, slope_0.y), skin_relief_bump(lengths.z * cos_theta.z, slope_0.z));
}

float3 skin_direct_scalar(Texture2D<float4 > lut, SamplerState lut_sampler, float4 lut_axes, float3x3 normals, float3 light, float curvature_per_mm, float3 gain)
{
    float3 lengths_2 = skin_lengths(normals);
    float3 cos_theta_2 = skin_cosines(normals, light, lengths_2);
    return gain * (lengths_2 * skin_curvature_table(lut, lut_sampler, lut_axes, cos_theta_2, abs(curvature_per_mm)) + skin_relief_light(lengths_2, cos_theta_2));
}

float3 skin_transfer(Texture2D<float4 > transfer, SamplerState transfer_sampler, float4 transfer_axes, float k_per_mm)
{
    return transfer.SampleLevel(transfer_sampler, saturate((float2(sqrt(max(k_per_mm, 0.0f)), 0.5f) - transfer_axes.xz) * transfer_axes.yw), 0.0f).xyz;
}

float3 skin_direct_tensor(Texture2D<float4 > lut, SamplerState lut_sampler, float4 lut_axes, Texture2D<float4 > transfer, SamplerState transfer_sampler, float4 transfer_axes, float3x3 normals, float3 light, float directional_per_mm, float total_per_mm, float3 gain)
{
    float3 lengths_3 = skin_lengths(normals);
    float3 cos_theta_3 = skin_cosines(normals, light, lengths_3);
    return gain * (lengths_3 * (skin_curvature_table(lut, lut_sampler, lut_axes, cos_theta_3, directional_per_mm) * skin_transfer(transfer, transfer_sampler, transfer_axes, sqrt(max((total_per_mm - directional_per_mm) * (total_per_mm + directional_per_mm), 0.0f)))) + skin_relief_light(lengths_3, cos_theta_3));
}

float3 skin_direct_diffused_normals(Texture2D<float4 > lut, SamplerState lut_sampler, float4 lut_axes, Texture2D<float4 > transfer, SamplerState transfer_sampler, float4 transfer_axes, float3x3 normals, float3 relief_length, float3 light, float directional_per_mm, float3 gain)
{
    float3 lengths_4 = skin_lengths(normals);
    float3 cos_theta_4 = skin_cosines(normals, light, lengths_4);
    return gain * (skin_curvature_table(lut, lut_sampler, lut_axes, cos_theta_4, directional_per_mm) * min(lengths_4 / max(skin_transfer(transfer, transfer_sampler, transfer_axes, directional_per_mm), (float3)9.99999997475242708e-07f), (float3)1.0f) + skin_relief_light(relief_length, cos_theta_4));
}

float3 skin_relief_length(Texture2D<float4 > transfer, SamplerState transfer_sampler, float4 transfer_axes, float3x3 from_texture, float3x3 from_mesh, float total_per_mm)
{
    return skin_lengths(from_texture) * min(skin_lengths(from_mesh) / max(0.97500002384185791f * skin_transfer(transfer, transfer_sampler, transfer_axes, total_per_mm), (float3)9.99999997475242708e-07f), (float3)1.0f);
}

float2 skin_directional_curvature(float3x3 tensor_world, float3 normal, float3 light)
{
    float3 tangential_0 = light - normal * dot(light, normal);
    float3 change_0 = float3(dot(tensor_world[int(0)], tangential_0), dot(tensor_world[int(1)], tangential_0), dot(tensor_world[int(2)], tangential_0));
    float total_0 = sqrt(dot(tensor_world[int(0)], tensor_world[int(0)]) + dot(tensor_world[int(1)], tensor_world[int(1)]) + dot(tensor_world[int(2)], tensor_world[int(2)]));
    return float2(min(sqrt(dot(change_0, change_0) / max(dot(tangential_0, tangential_0), 9.999999960041972e-13f)), total_0), total_0);
}

float3 skin_energy_gain(float3 albedo, float3 rms_radius_mm, float3 curvature_per_mm)
{
    float3 scaled_curvature_0 = 1.20000004768371582f * rms_radius_mm * max(curvature_per_mm, (float3)0.0f);
    float3 bound_0 = albedo * scaled_curvature_0;
    return 1.0f + (1.0f - albedo) * scaled_curvature_0 / sqrt(1.0f + bound_0 * bound_0);
}

float3 skin_root_absorption(float3 albedo)
{
    float3 bounded_0 = saturate(albedo);
    float3 s_1 = 6.0f * (1.0f - bounded_0) / (7.0f + sqrt(25.0f + 24.0f * bounded_0));
    return s_1 / (1.0f - s_1);
}

float skin_inner_cosine(float cosine, float inverse_ior)
{
    return sqrt(max(1.0f - (1.0f - cosine * cosine) * inverse_ior * inverse_ior, 0.0f));
}

float3 skin_mean_escape(float3 slope, float low, float high)
{
    return (1.0f + slope * (0.36391723155975342f * high + 0.63608276844024658f * low)) / ((1.0f + slope * low) * (1.0f + slope * high));
}

float3 skin_view_factor(float3 albedo, float n_dot_v, float reflectance)
{
    float root_0 = sqrt(clamp(reflectance, 0.0f, 0.89999997615814209f));
    float inverse_ior_1 = (1.0f - root_0) / (1.0f + root_0);
    float3 slope_2 = 2.0f * skin_root_absorption(albedo);
    return 1.0f / ((1.0f + slope_2 * skin_inner_cosine(saturate(n_dot_v), inverse_ior_1)) * skin_mean_escape(slope_2, skin_inner_cosine(0.35505104064941406f, inverse_ior_1), skin_inner_cosine(0.84494894742965698f, inverse_ior_1)));
}

float3 skin_closure_view_factor(float3 albedo, float n_dot_v)
{
    float3 slope_3 = 2.0f * skin_root_absorption(albedo);
    float3 diffuse_0 = skin_mean_escape(slope_3, 0.35505104064941406f, 0.84494894742965698f);
    return (diffuse_0 + 1.0f / (1.0f + slope_3 * (0.12999999523162842f + 0.75f * saturate(n_dot_v)))) / (diffuse_0 + skin_mean_escape(slope_3, 0.39628827571868896f, 0.76371169090270996f));
}

float skin_linear_depth(float depth, float4x4 projection)
{
    return abs((depth * projection[int(3)][int(3)] - projection[int(2)][int(3)]) / (projection[int(2)][int(2)] - depth * projection[int(3)][int(2)]));
}

float3 skin_inward_offset(float3 position_mm, float3 normal, float offset_mm)
{
    return position_mm - normal * offset_mm;
}

float skin_thickness(Texture2D<float4 > depth_map, SamplerState depth_map_sampler, float4x4 projection, float2 uv, float receiver_mm, float2 radius_uv, int taps)
{
    int tap_0 = int(0);
    float total_1 = 0.0f;
    for(;;)
    {
        if(tap_0 < taps)
        {
        }
        else
        {
            break;
        }
        float2 offset_0;
        if(taps == int(8))
        {
            offset_0 = SKIN_POISSON_8[min(tap_0, int(7))];
        }
        else
        {
            offset_0 = SKIN_POISSON_32[min(tap_0, int(31))];
        }
        float total_2 = total_1 + max(receiver_mm - skin_linear_depth(depth_map.SampleLevel(depth_map_sampler, uv + offset_0 * radius_uv, 0.0f).x, projection), 0.0f);
        tap_0 = tap_0 + int(1);
        total_1 = total_2;
    }
    return total_1 / float(max(taps, int(1)));
}

float3 skin_transmittance(float thickness_mm, float3 albedo, float3 sigma_per_mm)
{
    float3 a2_0 = albedo * albedo;
    float3 decay_0 = exp(- sigma_per_mm * thickness_mm);
    return (1.0f - a2_0) * decay_0 / (1.0f - a2_0 * decay_0 * decay_0);
}

float skin_classic_transmittance(float thickness_mm, float radius_mm)
{
    float t_0 = thickness_mm / radius_mm;
    return exp(-0.5f * t_0 * t_0);
}

float3 skin_direct_deep_scatter(float3 transmitted, float n_dot_l, float strength)
{
    return strength * transmitted * max(- n_dot_l, 0.0f);
}

float3 skin_through_beyond(float3 through, float3 diffused)
{
    return max(through - diffused, (float3)0.0f);
}

float3 skin_ambient_deep_scatter(float3 transmitted, float3 irradiance_behind, float strength)
{
    return strength * transmitted * irradiance_behind;
}

float skin_smoothstep(float p)
{
    float q_0 = saturate(p);
    return q_0 * q_0 * (3.0f - 2.0f * q_0);
}

float4 skin_light_coordinates(float3 position_mm, float4x4 view, float4x4 projection)
{
    float4 p_1 = float4(position_mm, 1.0f);
    float _S5 = dot(view[int(2)], p_1);
    float4 in_view_0 = float4(dot(view[int(0)], p_1), dot(view[int(1)], p_1), _S5, 1.0f);
    float w_0 = dot(projection[int(3)], in_view_0);
    float w_1;
    if((abs(w_0)) < 9.99999971718068537e-10f)
    {
        w_1 = 9.99999971718068537e-10f;
    }
    else
    {
        w_1 = w_0;
    }
    return float4(0.5f + 0.5f * (dot(projection[int(0)], in_view_0) / w_1), 0.5f - 0.5f * (dot(projection[int(1)], in_view_0) / w_1), abs(_S5), w_1);
}

float3 skin_unit_vectors(float3 v)
{
    return v / skin_safe_length(v);
}

float3 skin_shadow_receiver(float3 position_mm, float3 normal, float3 to_light, float curvature_per_mm)
{
    float cosine_1 = dot(normal, to_light);
    return position_mm + skin_unit_vectors(to_light - normal * cosine_1) * min(max(- cosine_1, 0.0f) / max(curvature_per_mm, 0.00100000004749745f), 8.0f);
}

float2 skin_plane_slope(float3 normal, float3 to_light, float3 light_right, float3 light_up, float least_cosine)
{
    float3 axis_0 = cross(light_right, light_up);
    float handedness_0;
    if((dot(to_light, axis_0)) < 0.0f)
    {
        handedness_0 = -1.0f;
    }
    else
    {
        handedness_0 = 1.0f;
    }
    return float2(dot(normal, light_right), - dot(normal, light_up)) / max(handedness_0 * dot(normal, axis_0), least_cosine);
}

float2 skin_shadow_slope(float3 normal, float3 to_light, float curvature_per_mm, float3 light_right, float3 light_up)
{
    float2 slope_4 = skin_plane_slope(skin_unit_vectors(normal + to_light * max(- dot(normal, to_light), 0.0f)), to_light, light_right, light_up, 0.00100000004749745f);
    return slope_4 / max(length(slope_4) / (1.0f + 7.0f * saturate(1.0f + curvature_per_mm / 0.03999999910593033f)), 1.0f);
}

float skin_shadow_occluder_depth(float depth_mm, float faces_light)
{
    return depth_mm + 4.0f * faces_light;
}

float skin_shadow_compare(Texture2D<float4 > depth_map, SamplerState depth_map_sampler, float2 map_extent, float4x4 projection, float2 uv, float receiver_mm)
{
    float2 position_0 = uv * map_extent - 0.5f;
    float2 corner_0 = floor(position_0);
    float2 weights_1 = position_0 - corner_0;
    float2 _S6 = (float2)0.0f;
    float2 _S7 = map_extent - 1.0f;
    float2 low_1 = (clamp(corner_0, _S6, _S7) + 0.5f) / map_extent;
    float2 high_1 = (clamp(corner_0 + 1.0f, _S6, _S7) + 0.5f) / map_extent;
    float4 lit_0 = step(float4(receiver_mm, receiver_mm, receiver_mm, receiver_mm), float4(skin_linear_depth(depth_map.SampleLevel(depth_map_sampler, low_1, 0.0f).x, projection), skin_linear_depth(depth_map.SampleLevel(depth_map_sampler, float2(high_1.x, low_1.y), 0.0f).x, projection), skin_linear_depth(depth_map.SampleLevel(depth_map_sampler, float2(low_1.x, high_1.y), 0.0f).x, projection), skin_linear_depth(depth_map.SampleLevel(depth_map_sampler, high_1, 0.0f).x, projection)));
    float2 rows_1 = lerp(lit_0.xz, lit_0.yw, (float2)weights_1.x);
    return lerp(rows_1.x, rows_1.y, weights_1.y);
}

float skin_shadow_filter(Texture2D<float4 > depth_map, SamplerState depth_map_sampler, float2 map_extent, float4x4 view, float4x4 projection, float3 position_mm, float3 normal, float3 to_light, float curvature_per_mm, float filter_width_mm, float bias_mm, int taps)
{
    float4 coordinates_0 = skin_light_coordinates(skin_shadow_receiver(position_mm, normal, to_light, curvature_per_mm), view, projection);
    float2 _S8 = skin_shadow_slope(normal, to_light, curvature_per_mm, view[int(0)].xyz, view[int(1)].xyz);
    float2 _S9 = 0.5f * float2(abs(projection[int(0)].x), abs(projection[int(1)].y)) / abs(coordinates_0.w);
    int tap_1 = int(0);
    float total_3 = 0.0f;
    for(;;)
    {
        if(tap_1 < taps)
        {
        }
        else
        {
            break;
        }
        float2 disk_0;
        if(taps == int(16))
        {
            disk_0 = SKIN_SHADOW_DISK_16[min(tap_1, int(15))];
        }
        else
        {
            disk_0 = SKIN_SHADOW_DISK_48[min(tap_1, int(47))];
        }
        float2 across_mm_0 = 0.5f * filter_width_mm * disk_0;
        float total_4 = total_3 + skin_shadow_compare(depth_map, depth_map_sampler, map_extent, projection, coordinates_0.xy + across_mm_0 * _S9, coordinates_0.z - bias_mm + dot(_S8, across_mm_0));
        tap_1 = tap_1 + int(1);
        total_3 = total_4;
    }
    return total_3 / float(max(taps, int(1)));
}

float3 skin_diffused_shadow(Texture2D<float4 > lut, SamplerState lut_sampler, float4 lut_axes, float shadow_filter, float n_dot_l, float filter_width_mm)
{
    return lut.SampleLevel(lut_sampler, saturate((float2(shadow_filter, max(n_dot_l, 0.05000000074505806f) / filter_width_mm) - lut_axes.xz) * lut_axes.yw), 0.0f).xyz;
}

float skin_sharpened_shadow(float shadow_filter, float sharpening)
{
    return skin_smoothstep((0.5f - sin(asin(1.0f - 2.0f * saturate(shadow_filter)) / 3.0f) - 0.5f) * sharpening + 0.5f);
}

float skin_variance_shadow(float mean_depth_mm, float mean_square_depth_mm2, float depth_mm)
{
    float _S10 = max(mean_square_depth_mm2 - mean_depth_mm * mean_depth_mm, 0.00999999977648258f);
    float _S11 = max(depth_mm - mean_depth_mm, 0.0f);
    return _S10 / (_S10 + _S11 * _S11);
}

float2 skin_contact_slope(float3 face_normal, float3 to_light, float3 light_right, float3 light_up)
{
    return skin_plane_slope(face_normal, to_light, light_right, light_up, 0.05000000074505806f);
}

float skin_faded_contact(float share, float cosine)
{
    return 1.0f - saturate((cosine - 0.05000000074505806f) / 0.10000000894069672f) * (1.0f - share);
}

float skin_contact_bias(float2 slope)
{
    return 0.80000001192092896f + 0.30000001192092896f * length(slope);
}

float skin_contact_compare(float4 depths, float receiver_mm, float2 rise, float2 weights)
{
    float _S12 = rise.x;
    float _S13 = rise.y;
    float4 lit_1 = step(receiver_mm + float4(0.0f, _S12, _S13, _S12 + _S13), depths);
    float2 rows_2 = lerp(lit_1.xz, lit_1.yw, (float2)weights.x);
    return lerp(rows_2.x, rows_2.y, weights.y);
}

float skin_contact_filter(Texture2D<float4 > depth_map, SamplerState depth_map_sampler, float2 map_extent, float4x4 view, float4x4 projection, float3 position_mm, float3 face_normal, float3 to_light)
{
    float4 coordinates_1 = skin_light_coordinates(position_mm, view, projection);
    float2 slope_6 = skin_contact_slope(face_normal, to_light, view[int(0)].xyz, view[int(1)].xyz);
    float2 texels_per_mm_0 = 0.5f * float2(abs(projection[int(0)].x), abs(projection[int(1)].y)) / abs(coordinates_1.w) * map_extent;
    float2 _S14 = slope_6 / texels_per_mm_0;
    float2 _S15 = coordinates_1.xy * map_extent - 0.5f;
    float _S16 = coordinates_1.z - skin_contact_bias(slope_6);
    int tap_2 = int(0);
    float total_5 = 0.0f;
    for(;;)
    {
        if(tap_2 < int(12))
        {
        }
        else
        {
            break;
        }
        float2 position_1 = _S15 + 0.60000002384185791f * SKIN_CONTACT_DISK[tap_2] * texels_per_mm_0;
        float2 corner_1 = floor(position_1);
        float2 _S17 = (float2)0.0f;
        float2 _S18 = map_extent - 1.0f;
        float2 low_2 = (clamp(corner_1, _S17, _S18) + 0.5f) / map_extent;
        float2 high_2 = (clamp(corner_1 + 1.0f, _S17, _S18) + 0.5f) / map_extent;
        float total_6 = total_5 + skin_contact_compare(float4(skin_linear_depth(depth_map.SampleLevel(depth_map_sampler, low_2, 0.0f).x, projection), skin_linear_depth(depth_map.SampleLevel(depth_map_sampler, float2(high_2.x, low_2.y), 0.0f).x, projection), skin_linear_depth(depth_map.SampleLevel(depth_map_sampler, float2(low_2.x, high_2.y), 0.0f).x, projection), skin_linear_depth(depth_map.SampleLevel(depth_map_sampler, high_2, 0.0f).x, projection)), _S16 + dot(corner_1 - _S15, _S14), _S14, position_1 - corner_1);
        tap_2 = tap_2 + int(1);
        total_5 = total_6;
    }
    return skin_faded_contact(total_5 / 12.0f, dot(face_normal, to_light));
}

float3 skin_contact_shadow(Texture2D<float4 > lut, SamplerState lut_sampler, float4 lut_axes, float3 shadow, float contact, float filter_width_mm)
{
    return min(shadow, contact + (1.0f - contact) * skin_diffused_shadow(lut, lut_sampler, lut_axes, skin_smoothstep(0.5f - 0.60000002384185791f / filter_width_mm), 1.0f, filter_width_mm));
}

float3 skin_sh_bands(float3x3 sh, float3 d)
{
    float _S19 = d.y;
    float _S20 = d.z;
    float _S21 = d.x;
    return float3(0.282094806432724f * sh[int(0)].x, 0.48860251903533936f * (sh[int(0)].y * _S19 + sh[int(0)].z * _S20 + sh[int(1)].x * _S21), 1.09254848957061768f * (sh[int(1)].y * _S21 * _S19 + sh[int(1)].z * _S19 * _S20 + sh[int(2)].y * _S21 * _S20) + 0.31539157032966614f * sh[int(2)].x * (3.0f * _S20 * _S20 - dot(d, d)) + 0.54627424478530884f * sh[int(2)].z * (_S21 * _S21 - _S19 * _S19));
}

float skin_ambient_channel(float3x3 sh, float3 normal, float3 band_transfer)
{
    return max(dot(skin_sh_bands(sh, normal), float3(1.0f, 1.0f, skin_safe_length(normal)) * band_transfer * float3(1.0f, 0.66666668653488159f, 0.25f)), 0.0f);
}

float3 skin_ambient_irradiance(float3x3 radiance_sh_red, float3x3 radiance_sh_green, float3x3 radiance_sh_blue, float3x3 normals, float3x3 band_transfer)
{
    float3x3 t_1 = transpose(band_transfer);
    return float3(skin_ambient_channel(radiance_sh_red, normals[int(0)], t_1[int(0)]), skin_ambient_channel(radiance_sh_green, normals[int(1)], t_1[int(1)]), skin_ambient_channel(radiance_sh_blue, normals[int(2)], t_1[int(2)]));
}

float3x3 skin_ambient_normals(float3x3 normals)
{
    return float3x3(skin_unit_vectors(normals[int(0)]), skin_unit_vectors(normals[int(1)]), skin_unit_vectors(normals[int(2)]));
}

float3 skin_ambient_of_three(float3 red, float3 green, float3 blue)
{
    return float3(red.x, green.y, blue.z);
}

float3 skin_bounced_visibility(float3 visibility, float3 albedo)
{
    return max(visibility, ((visibility * (2.04040002822875977f * albedo - 0.33239999413490295f) + (-4.79510021209716797f * albedo + 0.64170002937316895f)) * visibility + (2.75519990921020508f * albedo + 0.69029998779296875f)) * visibility);
}

float skin_sh_product(float3x3 a, float3x3 b)
{
    return dot(a[int(0)], b[int(0)]) + dot(a[int(1)], b[int(1)]) + dot(a[int(2)], b[int(2)]);
}

float3 skin_transferred_irradiance(float3x3 ambient_transfer_red, float3x3 ambient_transfer_green, float3x3 ambient_transfer_blue, float3x3 radiance_sh_red, float3x3 radiance_sh_green, float3x3 radiance_sh_blue)
{
    return max(float3(skin_sh_product(ambient_transfer_red, radiance_sh_red), skin_sh_product(ambient_transfer_green, radiance_sh_green), skin_sh_product(ambient_transfer_blue, radiance_sh_blue)), (float3)0.0f);
}

float skin_reflected_visibility(float3x3 sky_harmonics, float3 normal, float3 direction)
{
    float3 bands_0 = skin_sh_bands(sky_harmonics, direction);
    float _S22 = max(dot(normal, direction), 0.0f);
    return saturate((bands_0.x + bands_0.y + bands_0.z) / ((0.375f + _S22 * (2.0f + 1.875f * _S22)) * 0.07957746833562851f));
}

float3 skin_occluded_reflection(float3 sky, float3 bounced, float3x3 sky_harmonics, float3 normal, float3 direction)
{
    return lerp(bounced / max(1.0f - sky_harmonics[int(0)].x / 0.282094806432724f, 0.01999999955296516f), sky, (float3)skin_reflected_visibility(sky_harmonics, normal, direction));
}

float skin_specular_visibility(float n_dot_v, float visibility, float roughness)
{
    float exponent_0 = (exp2((-16.0f * roughness - 1.0f)));
    float base_0 = n_dot_v + visibility;
    float power_0;
    if(base_0 > 0.0f)
    {
        power_0 = pow(base_0, exponent_0);
    }
    else
    {
        power_0 = 0.0f;
    }
    return saturate(power_0 - 1.0f + visibility);
}

float skin_specular_power(float gloss)
{
    return (exp2((13.0f * gloss)));
}

float skin_gloss_of_relief(float gloss, float normal_length)
{
    float clamped_length_0 = clamp(normal_length, 0.00100000004749745f, 1.0f);
    float power_1 = skin_specular_power(gloss);
    return log2(max(clamped_length_0 * power_1 / (clamped_length_0 + power_1 * (1.0f - clamped_length_0)), 1.0f)) / 13.0f;
}

float skin_gloss_from_roughness(float roughness)
{
    float _S23 = max(roughness, 0.00100000004749745f);
    float r2_0 = _S23 * _S23;
    return clamp(log2(max(2.0f / (r2_0 * r2_0) - 2.0f, 1.0f)) / 13.0f, 0.0f, 1.0f);
}

float skin_lobe(float n_dot_h, float n_dot_l, float n_dot_v, float power)
{
    float k_0 = rsqrt(3.14159274101257324f * power / 4.0f + 1.57079637050628662f);
    float _S24 = 1.0f - k_0;
    return (power + 2.0f) / 6.28318548202514648f * pow(max(n_dot_h, 9.99999971718068537e-10f), power) * (0.25f / ((k_0 + _S24 * n_dot_l) * (k_0 + _S24 * n_dot_v)));
}

float skin_specular(float3 normal, float3 view, float3 light, float gloss, float reflectance)
{
    float3 half_vector_0 = skin_unit_vectors(view + light);
    float n_dot_l_3 = saturate(dot(normal, light));
    float n_dot_v_4 = clamp(dot(normal, view), 0.00009999999747379f, 1.0f);
    float n_dot_h_1 = saturate(dot(normal, half_vector_0));
    float wide_0 = skin_specular_power(gloss);
    float grazing_0 = 1.0f - saturate(dot(view, half_vector_0));
    float grazing2_0 = grazing_0 * grazing_0;
    return 3.14159274101257324f * (0.94999998807907104f * skin_lobe(n_dot_h_1, n_dot_l_3, n_dot_v_4, wide_0) + 0.05000000074505806f * skin_lobe(n_dot_h_1, n_dot_l_3, n_dot_v_4, min(wide_0 * wide_0, 8192.0f))) * (reflectance + (1.0f - reflectance) * grazing2_0 * grazing2_0 * grazing_0) * n_dot_l_3;
}

float3 skin_reflected(float3 normal, float3 view)
{
    return 2.0f * dot(normal, view) * normal - view;
}

float skin_ambient_specular_fresnel(float n_dot_v, float gloss, float reflectance)
{
    float grazing_1 = 1.0f - saturate(n_dot_v);
    float grazing2_1 = grazing_1 * grazing_1;
    return reflectance + (1.0f - reflectance) * grazing2_1 * grazing2_1 * grazing_1 / (4.0f - 3.0f * gloss);
}

float skin_diffuse_share(float n_dot_v, float gloss, float reflectance)
{
    return 1.0f - skin_ambient_specular_fresnel(n_dot_v, gloss, reflectance);
}

float skin_alpha_from_gloss(float gloss)
{
    return sqrt(2.0f / (skin_specular_power(gloss) + 2.0f));
}

float skin_second_gloss(float gloss)
{
    return min(2.0f * gloss, 1.0f);
}

float skin_coat_fresnel(float cosine, float reflectance)
{
    float root_1 = sqrt(clamp(reflectance, 0.0f, 0.89999997615814209f));
    float _S25 = 1.0f - root_1;
    float excess_0 = 4.0f * root_1 / (_S25 * _S25);
    float _S26 = max(sqrt(excess_0 + cosine * cosine) + cosine, 9.99999971718068537e-10f);
    float across_0 = excess_0 / (_S26 * _S26);
    float along_0 = (cosine * _S26 - 1.0f) / (cosine * excess_0 / _S26 + 1.0f);
    return 0.5f * across_0 * across_0 * (1.0f + along_0 * along_0);
}

float skin_coat_highlight(float3 normal, float3 view, float3 light, float gloss, float reflectance)
{
    float3 half_vector_1 = skin_unit_vectors(view + light);
    float n_dot_l_4 = saturate(dot(normal, light));
    float n_dot_v_7 = clamp(dot(normal, view), 0.00009999999747379f, 1.0f);
    float n_dot_h_2 = saturate(dot(normal, half_vector_1));
    float v_dot_h_0 = saturate(dot(view, half_vector_1));
    float squared_0 = 2.0f / (skin_specular_power(gloss) + 2.0f);
    float3 side_0 = cross(normal, half_vector_1);
    float sine2_0;
    if(n_dot_h_2 > 0.0f)
    {
        sine2_0 = dot(side_0, side_0);
    }
    else
    {
        sine2_0 = 1.0f;
    }
    float root_2 = squared_0 / (n_dot_h_2 * n_dot_h_2 * squared_0 + sine2_0);
    float _S27 = 1.0f - squared_0;
    return root_2 * root_2 / squared_0 * (0.5f / (n_dot_l_4 * sqrt(n_dot_v_7 * n_dot_v_7 * _S27 + squared_0) + n_dot_v_7 * sqrt(n_dot_l_4 * n_dot_l_4 * _S27 + squared_0))) * skin_coat_fresnel(v_dot_h_0, reflectance) * n_dot_l_4;
}

float2 skin_coat(Texture2D<float4 > lut, SamplerState lut_sampler, float4 lut_axes, float n_dot_v, float gloss, float reflectance, float coat_reflectance)
{
    float3 entry_0 = lut.SampleLevel(lut_sampler, saturate((float2(sqrt(saturate(n_dot_v)), gloss) - lut_axes.xz) * lut_axes.yw), 0.0f).xyz;
    float _S28 = entry_0.z;
    return float2(clamp(_S28 + (1.0f - reflectance) / (1.0f - coat_reflectance) * (entry_0.x - _S28), 0.0f, _S28), entry_0.y);
}

float3 skin_coat_direction(float3 normal, float3 view, float pull)
{
    float3 mirrored_0 = skin_reflected(normal, view);
    return skin_unit_vectors(mirrored_0 + pull * (normal - mirrored_0));
}

float skin_turns(float y, float x)
{
    float2 size_0 = abs(float2(x, y));
    float _S29 = size_0.x;
    float _S30 = size_0.y;
    float r_0 = min(_S29, _S30) / max(max(_S29, _S30), 1.00000000317107685e-30f);
    float r2_1 = r_0 * r_0;
    float turns_0 = r_0 * (0.15915107727050781f + r2_1 * (-0.05293257534503937f + r2_1 * (0.03076364658772945f + r2_1 * (-0.01842727139592171f + r2_1 * (0.00826387945562601f - r2_1 * 0.00181874714326113f)))));
    float turns_1;
    if(_S30 > _S29)
    {
        turns_1 = 0.25f - turns_0;
    }
    else
    {
        turns_1 = turns_0;
    }
    if(x < 0.0f)
    {
        turns_1 = 0.5f - turns_1;
    }
    else
    {
    }
    if(y < 0.0f)
    {
        turns_1 = - turns_1;
    }
    else
    {
    }
    return turns_1;
}

float2 skin_equirectangular_uv(float3 direction)
{
    float _S31 = direction.x;
    float _S32 = direction.z;
    return float2(0.5f + skin_turns(_S32, _S31), 2.0f * skin_turns(sqrt(_S31 * _S31 + _S32 * _S32), direction.y));
}

float skin_reflection_level(float power)
{
    return clamp(0.5f * log2(max(power, 1.0f)), 0.0f, 4.0f);
}

float3 skin_preconvolved(Texture2D<float4 > preconvolved, SamplerState preconvolved_sampler, float2 uv, float power)
{
    float level_0 = skin_reflection_level(power);
    float _S33 = min(floor(level_0), 3.0f);
    float row_1 = clamp(uv.y, 0.0078125f, 0.9921875f);
    float _S34 = uv.x;
    return lerp(preconvolved.SampleLevel(preconvolved_sampler, float2(_S34, (_S33 + row_1) / 5.0f), 0.0f).xyz, preconvolved.SampleLevel(preconvolved_sampler, float2(_S34, (_S33 + 1.0f + row_1) / 5.0f), 0.0f).xyz, (float3)(level_0 - _S33));
}

float3 skin_reflected_radiance(Texture2D<float4 > preconvolved, SamplerState preconvolved_sampler, float3 direction, float gloss)
{
    float2 uv_3 = skin_equirectangular_uv(direction);
    float power_5 = skin_specular_power(gloss);
    return lerp(skin_preconvolved(preconvolved, preconvolved_sampler, uv_3, power_5 / 4.0f), skin_preconvolved(preconvolved, preconvolved_sampler, uv_3, power_5 * power_5 / 4.0f), (float3)0.05000000074505806f);
}

float3 skin_coat_radiance(Texture2D<float4 > preconvolved, SamplerState preconvolved_sampler, float3 direction, float n_dot_v, float gloss)
{
    return skin_preconvolved(preconvolved, preconvolved_sampler, skin_equirectangular_uv(direction), (skin_specular_power(gloss) + 2.0f) / (8.0f * max(n_dot_v, 0.00999999977648258f)));
}

float3 skin_filmic(float3 light)
{
    float3 x_2 = max(light - 0.00400000018998981f, (float3)0.0f);
    float3 _S35 = 6.19999980926513672f * x_2;
    return x_2 * (_S35 + 0.5f) / (x_2 * (_S35 + 1.70000004768371582f) + 0.05999999865889549f);
}

float skin_srgb_curve(float x)
{
    float _S36;
    if(x <= 0.00313080009073019f)
    {
        _S36 = 12.92000007629394531f * x;
    }
    else
    {
        _S36 = 1.0549999475479126f * pow(max(x, 9.999999960041972e-13f), 0.4166666567325592f) - 0.05499999970197678f;
    }
    return _S36;
}

float3 skin_srgb_from_linear(float3 light)
{
    float3 x_4 = saturate(light);
    return float3(skin_srgb_curve(x_4.x), skin_srgb_curve(x_4.y), skin_srgb_curve(x_4.z));
}

float skin_linear_curve(float x)
{
    float _S37;
    if(x <= 0.04044999927282333f)
    {
        _S37 = x / 12.92000007629394531f;
    }
    else
    {
        _S37 = pow((x + 0.05499999970197678f) / 1.0549999475479126f, 2.40000009536743164f);
    }
    return _S37;
}

float3 skin_linear_from_srgb(float3 display)
{
    float3 x_6 = saturate(display);
    return float3(skin_linear_curve(x_6.x), skin_linear_curve(x_6.y), skin_linear_curve(x_6.z));
}

float skin_classic_blur_level(float radius_mm, float uv_scale_mm, float map_size, float hardware_level)
{
    return max(hardware_level, log2(max(map_size * radius_mm, uv_scale_mm) / uv_scale_mm));
}

float3 skin_classic_direct(Texture2D<float4 > lut, SamplerState lut_sampler, float4 lut_axes, float3 sharp, float3 blurred, float3 light, float curvature_per_mm)
{
    float blurred_cosine_0 = dot(blurred, light);
    float k_1 = saturate(1.0f - blurred_cosine_0);
    float k_2 = k_1 * k_1;
    return saturate(saturate(float3(blurred_cosine_0, dot(skin_unit_vectors(lerp(sharp, blurred, (float3)(0.30000001192092896f + 0.69999998807907104f * k_2))), light), dot(skin_unit_vectors(lerp(sharp, blurred, (float3)k_2)), light))) + (lut.SampleLevel(lut_sampler, saturate((float2(blurred_cosine_0, abs(curvature_per_mm)) - lut_axes.xz) * lut_axes.yw), 0.0f).xyz - max(blurred_cosine_0, 0.0f)));
}

float3x3 skin_classic_ambient_normals(float3 sharp, float3 blurred)
{
    return float3x3(blurred, skin_unit_vectors(lerp(sharp, blurred, (float3)0.30000001192092896f)), sharp);
}

float skin_classic_sharpened_shadow(float shadow_filter, float sharpening)
{
    return skin_smoothstep(0.89999997615814209f * sharpening * (shadow_filter - 0.5f) + 0.5f);
}

float skin_classic_deep_scatter(float thickness_mm, float n_dot_l, float radius_mm, float strength)
{
    return strength * skin_classic_transmittance(thickness_mm, radius_mm) * max(0.30000001192092896f - n_dot_l, 0.0f);
}

float skin_eye_root(float value)
{
    return sqrt(max(value, 9.99999997475242708e-07f));
}

float4 skin_eye_cornea(float cornea_radius_mm, float cornea_asphericity, float refraction_index, float4 limbus)
{
    float r_1 = limbus.x;
    float ratio_0 = r_1 / cornea_radius_mm;
    float _S38 = r_1 * r_1;
    float _S39 = limbus.z;
    return float4(skin_eye_root(_S39 * _S39 - _S38) + _S38 / (cornea_radius_mm * (1.0f + skin_eye_root(1.0f - (1.0f + cornea_asphericity) * ratio_0 * ratio_0))), cornea_radius_mm, cornea_asphericity, refraction_index);
}

float2 skin_eye_conic(float r, float4 cornea)
{
    float _S40 = cornea.y;
    float ratio_1 = r / _S40;
    float root_3 = skin_eye_root(1.0f - (1.0f + cornea.z) * ratio_1 * ratio_1);
    return float2(cornea.x - r * r / (_S40 * (1.0f + root_3)), -1.0f / (_S40 * root_3));
}

float2 skin_eye_profile(float r, float4 cornea, float4 limbus)
{
    float _S41 = limbus.x;
    float _S42 = limbus.y;
    float inner_0 = _S41 - _S42;
    float outer_0 = _S41 + _S42;
    float width_0 = outer_0 - inner_0;
    if(r < inner_0)
    {
        return skin_eye_conic(r, cornea);
    }
    if(r >= outer_0)
    {
        float _S43 = limbus.z;
        float sphere_0 = skin_eye_root(_S43 * _S43 - r * r);
        return float2(sphere_0, -1.0f / sphere_0);
    }
    float2 start_0 = skin_eye_conic(inner_0, cornea);
    float _S44 = limbus.z;
    float end_0 = skin_eye_root(_S44 * _S44 - outer_0 * outer_0);
    float m0_0 = width_0 * inner_0 * start_0.y;
    float m1_0 = - width_0 * outer_0 / end_0;
    float t_2 = (r - inner_0) / width_0;
    float _S45 = start_0.x;
    float rise_1 = end_0 - _S45;
    float c2_0 = 3.0f * rise_1 - 2.0f * m0_0 - m1_0;
    float c3_0 = m0_0 + m1_0 - 2.0f * rise_1;
    return float2(_S45 + t_2 * (m0_0 + t_2 * (c2_0 + t_2 * c3_0)), (m0_0 + t_2 * (2.0f * c2_0 + t_2 * (3.0f * c3_0))) / (width_0 * max(r, 9.99999997475242708e-07f)));
}

float skin_eye_height(float r_mm, float4 cornea, float4 limbus)
{
    return skin_eye_profile(r_mm, cornea, limbus).x;
}

float3 skin_eye_normal(float3 position_mm, float4 cornea, float4 limbus)
{
    float2 _S46 = position_mm.xy;
    float r_4 = sqrt(dot(_S46, _S46));
    float slope_over_r_0 = skin_eye_profile(r_4, cornea, limbus).y;
    bool in_front_0;
    if((position_mm.z) > 0.0f)
    {
        in_front_0 = r_4 < (limbus.x + limbus.y);
    }
    else
    {
        in_front_0 = false;
    }
    float3 normal_13 = float3(- slope_over_r_0 * _S46, 1.0f);
    float3 _S47;
    if(in_front_0)
    {
        _S47 = normal_13;
    }
    else
    {
        _S47 = position_mm;
    }
    return skin_unit_vectors(_S47);
}

float4 skin_eye_cornea_hit(float3 origin_mm, float3 direction, float4 cornea)
{
    float q_1 = 1.0f + cornea.z;
    float s_2 = cornea.x - origin_mm.z;
    float _S48 = direction.z;
    float2 _S49 = origin_mm.xy;
    float _S50 = cornea.y;
    float _S51 = q_1 * s_2;
    float b_1 = dot(_S49, direction.xy) + _S48 * (_S50 - _S51);
    float c_0 = dot(_S49, _S49) - 2.0f * _S50 * s_2 + _S51 * s_2;
    float radicand_0 = b_1 * b_1 - (1.0f - (1.0f - q_1) * _S48 * _S48) * c_0;
    bool meets_0;
    if(radicand_0 >= 0.0f)
    {
        meets_0 = b_1 < 0.0f;
    }
    else
    {
        meets_0 = false;
    }
    float distance_0;
    if(meets_0)
    {
        distance_0 = c_0 / max(skin_eye_root(radicand_0) - b_1, 9.99999997475242708e-07f);
    }
    else
    {
        distance_0 = 0.0f;
    }
    float3 _S52 = origin_mm + distance_0 * direction;
    if(meets_0)
    {
        distance_0 = 1.0f;
    }
    else
    {
        distance_0 = 0.0f;
    }
    return float4(_S52, distance_0);
}

float skin_smooth(float t)
{
    float clamped_0 = saturate(t);
    return clamped_0 * clamped_0 * (3.0f - 2.0f * clamped_0);
}

float skin_eye_limbal_opacity(float r_mm, float4 limbus)
{
    float _S53 = limbus.y;
    return skin_smooth((r_mm - limbus.x + _S53) / (2.0f * _S53));
}

float3 skin_eye_iris_hit(float3 position_mm, float3 normal, float3 view, float4 cornea, float4 iris)
{
    float eta_0 = 1.0f / cornea.w;
    float _S54 = max(dot(normal, view), 0.0f);
    float3 d_1 = (eta_0 * _S54 - sqrt(max(1.0f - eta_0 * eta_0 * (1.0f - _S54 * _S54), 0.0f))) * normal - eta_0 * view;
    float h_0 = iris.x - position_mm.z;
    float _S55 = iris.y;
    float m2_0 = _S55 * _S55;
    float _S56 = d_1.z;
    float2 _S57 = d_1.xy;
    float a_1 = _S56 * _S56 - m2_0 * dot(_S57, _S57);
    float2 _S58 = position_mm.xy;
    float b_2 = h_0 * _S56 + m2_0 * dot(_S58, _S57);
    float e_0 = h_0 * h_0 - m2_0 * dot(_S58, _S58);
    float2 apart_0 = h_0 * _S57 + _S56 * _S58;
    float cross_product_0 = d_1.x * position_mm.y - d_1.y * position_mm.x;
    float root_4 = abs(_S55) * sqrt(max(dot(apart_0, apart_0) - m2_0 * cross_product_0 * cross_product_0, 0.0f));
    float distance_1;
    if(_S55 < 0.0f)
    {
        distance_1 = e_0 / max(b_2 + root_4, 9.99999997475242708e-07f);
    }
    else
    {
        distance_1 = (b_2 + root_4) / max(a_1, 0.00009999999747379f);
    }
    return position_mm + distance_1 * d_1;
}

float2 skin_eye_iris_uv(float3 hit_mm, float4 iris, float pupil_in_map, float4 iris_uv)
{
    float2 _S59 = hit_mm.xy;
    float r_5 = sqrt(dot(_S59, _S59));
    float pupil_0 = iris.w;
    float _S60 = min((r_5 - pupil_0) / max(iris.z - pupil_0, 9.99999997475242708e-07f), 1.0f);
    float radius_0;
    if(r_5 < pupil_0)
    {
        radius_0 = pupil_in_map * r_5 / max(pupil_0, 9.99999997475242708e-07f);
    }
    else
    {
        radius_0 = pupil_in_map + (1.0f - pupil_in_map) * _S60;
    }
    float scale_0 = iris_uv.z * radius_0 / max(r_5, 9.99999997475242708e-07f);
    float angle_0 = 6.28318548202514648f * iris_uv.w;
    float cosine_4 = cos(angle_0);
    float sine_0 = sin(angle_0);
    float _S61 = hit_mm.x;
    float _S62 = hit_mm.y;
    return float2(iris_uv.x + scale_0 * (cosine_4 * _S61 - sine_0 * _S62), iris_uv.y - scale_0 * (sine_0 * _S61 + cosine_4 * _S62));
}

float3 skin_eye_iris_parallax(float3 hit_mm, float3 direction, float3 iris_normal, float height_mm)
{
    return hit_mm - direction * (height_mm / max(- dot(direction, iris_normal), 0.10000000149011612f));
}

float skin_eye_warped(float cosine)
{
    float size_1 = pow(max(abs(cosine), 9.99999971718068537e-10f), 0.69999998807907104f);
    float _S63;
    if(cosine < 0.0f)
    {
        _S63 = - size_1;
    }
    else
    {
        _S63 = size_1;
    }
    return _S63;
}

float skin_eye_slice(float cosine)
{
    float least_0 = skin_eye_warped(-0.34202015399932861f);
    return 15.0f * (skin_eye_warped(clamp(cosine, -0.34202015399932861f, 1.0f)) - least_0) / (1.0f - least_0);
}

float3 skin_eye_light(Texture2D<float4 > lut, SamplerState lut_sampler, float4 lut_axes, float3 hit_mm, float3 light)
{
    float2 _S64 = light.xy;
    float across_1 = sqrt(dot(_S64, _S64));
    float2 turn_0;
    if(across_1 > 9.99999997475242708e-07f)
    {
        turn_0 = _S64 / across_1;
    }
    else
    {
        turn_0 = float2(1.0f, 0.0f);
    }
    float x_7 = dot(hit_mm.xy, turn_0);
    float _S65 = turn_0.x;
    float _S66 = turn_0.y;
    float y_2 = hit_mm.y * _S65 - hit_mm.x * _S66;
    float index_0 = skin_eye_slice(light.z);
    float _S67 = min(floor(index_0), 14.0f);
    float row_2 = 0.5f + 15.0f * min(abs(y_2) / (- lut_axes.x * 31.0f / 32.0f), 1.0f) + 16.0f * _S67;
    float2 _S68 = lut_axes.xz;
    float2 _S69 = lut_axes.yw;
    float3 first_0 = lut.SampleLevel(lut_sampler, saturate((float2(x_7, row_2) - _S68) * _S69), 0.0f).xyz;
    float3 second_0 = lut.SampleLevel(lut_sampler, saturate((float2(x_7, row_2 + 16.0f) - _S68) * _S69), 0.0f).xyz;
    float straight_0 = 1.0f - min(across_1 / 0.50550216436386108f, 1.0f);
    float moved_0;
    if(_S67 > 13.5f)
    {
        moved_0 = straight_0;
    }
    else
    {
        moved_0 = index_0 - _S67;
    }
    float3 value_1 = lerp(first_0, second_0, float3(index_0 - _S67, moved_0, moved_0));
    float entry_y_0;
    if(y_2 < 0.0f)
    {
        entry_y_0 = - value_1.z;
    }
    else
    {
        entry_y_0 = value_1.z;
    }
    float _S70 = value_1.y;
    return float3(value_1.x, _S70 * _S65 - entry_y_0 * _S66, _S70 * _S66 + entry_y_0 * _S65);
}

float4 skin_eye_ambient(Texture2D<float4 > lut, SamplerState lut_sampler, float4 lut_axes, float r_mm)
{
    float2 _S71 = lut_axes.xz;
    float2 _S72 = lut_axes.yw;
    return float4(lut.SampleLevel(lut_sampler, saturate((float2(r_mm, 0.0f) - _S71) * _S72), 0.0f).xyz, lut.SampleLevel(lut_sampler, saturate((float2(r_mm, 1.0f) - _S71) * _S72), 0.0f).xyz.x);
}

float skin_dielectric_fresnel(float cosine, float index)
{
    float c_1 = saturate(cosine);
    float _S73 = index * index;
    float inside_0 = sqrt(max(_S73 - 1.0f + c_1 * c_1, 0.0f));
    float s_3 = (c_1 - inside_0) / max(c_1 + inside_0, 9.99999997475242708e-07f);
    float _S74 = _S73 * c_1;
    float p_2 = (_S74 - inside_0) / max(_S74 + inside_0, 9.99999997475242708e-07f);
    return 0.5f * (s_3 * s_3 + p_2 * p_2);
}

float skin_eye_inside(float n_dot_v, float index)
{
    return (1.0f - skin_dielectric_fresnel(n_dot_v, index)) / (index * index);
}

float skin_lamp_highlight(float3 reflected, float3 light, float lamp, float roughness)
{
    float3 apart_1 = reflected - light;
    float chord2_0 = dot(apart_1, apart_1);
    float wide_1 = sqrt(lamp * lamp + roughness * roughness);
    float _S75 = max(roughness, 0.00009999999747379f);
    float sine_1 = sin(wide_1);
    return skin_smooth((wide_1 + _S75 - sqrt(chord2_0) * (1.0f + chord2_0 * (0.0416666679084301f + chord2_0 * 0.00468750018626451f))) / (2.0f * _S75)) / (sine_1 * sine_1 + _S75 * _S75 / 5.0f);
}

float skin_pupil_radius(float luminance)
{
    return 2.45000004768371582f - 1.5f * tanh(0.12041200697422028f * log2(clamp(luminance, 9.99999997475242708e-07f, 1.0e+08f)));
}

float skin_lid_share(float3 position_mm, float3 exit_mm, float penumbra, float ramp, float4 lid)
{
    float _S76 = lid.w;
    float3 _S77 = lid.xyz;
    return skin_smooth((_S76 - dot(_S77, exit_mm)) / penumbra + 0.5f) * saturate((_S76 - dot(_S77, position_mm)) / ramp + 0.5f);
}

float skin_lid_visibility(float3 position_mm, float3 direction, float spread, float margin_mm, float4 upper, float4 lower, float radius_mm)
{
    float along_1 = dot(position_mm, direction);
    float distance_2 = sqrt(max(along_1 * along_1 + (radius_mm * radius_mm - dot(position_mm, position_mm)), 0.0f)) - along_1;
    float3 exit_mm_1 = position_mm + distance_2 * direction;
    float _S78 = max(2.0f * distance_2 * spread, 0.00009999999747379f);
    float _S79 = max(2.0f * margin_mm, 0.00009999999747379f);
    return skin_lid_share(position_mm, exit_mm_1, _S78, _S79, upper) * skin_lid_share(position_mm, exit_mm_1, _S78, _S79, lower);
}

float skin_lid_hidden(float3 position_mm, float3 normal, float4 lid, float radius_mm)
{
    float3 _S80 = lid.xyz;
    float toward_0 = dot(_S80, normal);
    float tangent_0 = sqrt(max(1.0f - toward_0 * toward_0, 0.00009999999747379f));
    float bare_0 = lid.w - dot(_S80, position_mm);
    float3 foot_0 = position_mm + bare_0 * _S80;
    float along_2 = dot(foot_0, tangent_0 * normal - toward_0 * ((_S80 - toward_0 * normal) / tangent_0));
    float radicand_1 = along_2 * along_2 - (dot(foot_0, foot_0) - radius_mm * radius_mm);
    float length_0 = sqrt(max(radicand_1, 0.0f)) - along_2;
    float above_0 = bare_0 * toward_0 + length_0 * tangent_0;
    float beside_0 = bare_0 * tangent_0 - length_0 * toward_0;
    float cosine_8 = beside_0 / max(sqrt(above_0 * above_0 + beside_0 * beside_0), 0.00009999999747379f);
    bool _S81;
    if(above_0 > 0.0f)
    {
        _S81 = radicand_1 > 0.0f;
    }
    else
    {
        _S81 = false;
    }
    float _S82;
    if(_S81)
    {
        _S82 = 0.5f * (1.0f - cosine_8);
    }
    else
    {
        _S82 = 0.0f;
    }
    return _S82;
}

float skin_lid_openness(float3 position_mm, float3 normal, float4 upper, float4 lower, float radius_mm)
{
    return saturate(1.0f - skin_lid_hidden(position_mm, normal, upper, radius_mm) - skin_lid_hidden(position_mm, normal, lower, radius_mm));
}

float skin_lid_iris_hidden(float3 position_mm, float narrowed, float4 lid)
{
    float a_2 = lid.w - dot(lid.xyz, position_mm) - 0.57999998331069946f * narrowed;
    float width_1 = 2.58999991416931152f * narrowed;
    return 0.5f * (1.0f - a_2 / sqrt(a_2 * a_2 + width_1 * width_1));
}

float skin_lid_iris_openness(float3 hit_mm, float4 cornea, float4 limbus, float4 upper, float4 lower)
{
    float2 _S83 = hit_mm.xy;
    float _S84 = limbus.x;
    float squared_1 = dot(_S83, _S83) / (_S84 * _S84);
    float rim_0 = squared_1 * squared_1;
    float2 entry_1 = (0.82999998331069946f + 0.40999999642372131f * rim_0) * _S83;
    float _S85 = max(1.0f - 1.12000000476837158f * rim_0, 0.05000000074505806f);
    float3 position_2 = float3(entry_1, skin_eye_height(sqrt(dot(entry_1, entry_1)), cornea, limbus));
    return saturate(1.0f - skin_lid_iris_hidden(position_2, _S85, upper) - skin_lid_iris_hidden(position_2, _S85, lower));
}

float3 skin_tear_normal(float3 position_mm, float3 normal, float4 lid, float height_mm)
{
    float3 _S86 = lid.xyz;
    float sine_2 = saturate(1.0f - (lid.w - dot(_S86, position_mm)) / max(height_mm, 0.00009999999747379f));
    return skin_unit_vectors(sqrt(max(1.0f - sine_2 * sine_2, 0.0f)) * normal - sine_2 * skin_unit_vectors(_S86 - dot(_S86, normal) * normal));
}
