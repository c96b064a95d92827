// The skinshade library, generated from shading/*.slang by `python -m codegen`.
fn skin_rsqrt_0(x : f32) -> f32
{
    return 1.0f / sqrt(x);
}

var<private> SKIN_CONTACT_DISK : array<vec2<f32>, i32(12)> = array<vec2<f32>, i32(12)>( vec2<f32>(0.16725532710552216f, 0.0f), vec2<f32>(-0.21519750356674194f, 0.19713853299617767f), vec2<f32>(0.0332011915743351f, -0.3783104419708252f), vec2<f32>(0.27573889493942261f, 0.35965254902839661f), vec2<f32>(-0.51071953773498535f, -0.09033908694982529f), vec2<f32>(0.48873069882392883f, -0.31089046597480774f), vec2<f32>(-0.16532173752784729f, 0.61498862504959106f), vec2<f32>(-0.31931877136230469f, -0.61482888460159302f), vec2<f32>(0.70304751396179199f, 0.25675183534622192f), vec2<f32>(-0.74441087245941162f, 0.3072819709777832f), vec2<f32>(0.36706140637397766f, -0.78438889980316162f), vec2<f32>(0.28072324395179749f, 0.89498996734619141f) );
var<private> SKIN_SHADOW_DISK_48 : array<vec2<f32>, i32(48)> = array<vec2<f32>, i32(48)>( vec2<f32>(0.08340597897768021f, 0.0f), vec2<f32>(-0.10671073943376541f, 0.09775578230619431f), vec2<f32>(0.01636306010186672f, -0.1864485889673233f), vec2<f32>(0.13498826324939728f, 0.17606829106807709f), vec2<f32>(-0.24817833304405212f, -0.04389924928545952f), vec2<f32>(0.2355383038520813f, -0.14983019232749939f), vec2<f32>(-0.07893361896276474f, 0.29362913966178894f), vec2<f32>(-0.15082783997058868f, -0.29040983319282532f), vec2<f32>(0.32788398861885071f, 0.11974270641803741f), vec2<f32>(-0.34179624915122986f, 0.14108851552009583f), vec2<f32>(0.16510665416717529f, -0.35282331705093384f), vec2<f32>(0.12226484715938568f, 0.38979959487915039f), vec2<f32>(-0.36929354071617126f, -0.21401314437389374f), vec2<f32>(0.4341655969619751f, -0.09545008838176727f), vec2<f32>(-0.2655525803565979f, 0.37772122025489807f), vec2<f32>(-0.06148780882358551f, -0.47449716925621033f), vec2<f32>(0.37834861874580383f, 0.31887263059616089f), vec2<f32>(-0.51034331321716309f, 0.02110430039465427f), vec2<f32>(0.37315717339515686f, -0.37134122848510742f), vec2<f32>(-0.02502750046551228f, 0.54124277830123901f), vec2<f32>(-0.3568427562713623f, -0.42761686444282532f), vec2<f32>(0.56674838066101074f, 0.0762551873922348f), vec2<f32>(-0.48148587346076965f, 0.33500534296035767f), vec2<f32>(0.13193005323410034f, -0.58644229173660278f), vec2<f32>(0.30600649118423462f, 0.53402209281921387f), vec2<f32>(-0.59994620084762573f, -0.1913992166519165f), vec2<f32>(0.58451014757156372f, -0.27005851268768311f), vec2<f32>(-0.25400349497795105f, 0.60692840814590454f), vec2<f32>(-0.22741274535655975f, -0.63226538896560669f), vec2<f32>(0.60710901021957397f, 0.31907948851585388f), vec2<f32>(-0.6766400933265686f, 0.17836016416549683f), vec2<f32>(0.38596493005752563f, -0.60026413202285767f), vec2<f32>(0.12322843074798584f, 0.71703100204467773f), vec2<f32>(-0.58622837066650391f, -0.45400822162628174f), vec2<f32>(0.75288873910903931f, -0.06237528845667839f), vec2<f32>(-0.52258288860321045f, 0.56489682197570801f), vec2<f32>(0.0038233099039644f, -0.78373259305953979f), vec2<f32>(0.53622621297836304f, 0.59111112356185913f), vec2<f32>(-0.80917233228683472f, -0.07499390840530396f), vec2<f32>(0.65910446643829346f, -0.50023680925369263f), vec2<f32>(-0.15080370008945465f, 0.82895052433013916f), vec2<f32>(-0.45701694488525391f, -0.72624564170837402f), vec2<f32>(0.84303575754165649f, 0.23104114830493927f), vec2<f32>(-0.79258495569229126f, 0.40674149990081787f), vec2<f32>(0.31582745909690857f, -0.85189038515090942f), vec2<f32>(0.34976369142532349f, 0.85918575525283813f), vec2<f32>(-0.85765814781188965f, -0.40646019577980042f), vec2<f32>(0.93254464864730835f, -0.28751349449157715f) );
var<private> SKIN_SHADOW_DISK_16 : array<vec2<f32>, i32(16)> = array<vec2<f32>, i32(16)>( vec2<f32>(0.14471825957298279f, 0.0f), vec2<f32>(-0.18583981692790985f, 0.170244500041008f), vec2<f32>(0.02860930934548378f, -0.32598838210105896f), vec2<f32>(0.23701368272304535f, 0.30914238095283508f), vec2<f32>(-0.43773865699768066f, -0.07742980122566223f), vec2<f32>(0.41749045252799988f, -0.26557326316833496f), vec2<f32>(-0.14065909385681152f, 0.52324479818344116f), vec2<f32>(-0.27035140991210938f, -0.52054518461227417f), vec2<f32>(0.59152573347091675f, 0.21602423489093781f), vec2<f32>(-0.6210860013961792f, 0.25637525320053101f), vec2<f32>(0.30247461795806885f, -0.64637070894241333f), vec2<f32>(0.22609943151473999f, 0.72084063291549683f), vec2<f32>(-0.69051814079284668f, -0.40016940236091614f), vec2<f32>(0.82290405035018921f, -0.18091315031051636f), vec2<f32>(-0.5123591423034668f, 0.7287781834602356f), vec2<f32>(-0.12196926772594452f, -0.94122844934463501f) );
var<private> SKIN_POISSON_32 : array<vec2<f32>, i32(32)> = array<vec2<f32>, i32(32)>( vec2<f32>(-0.02096010930836201f, 0.01299272011965513f), vec2<f32>(0.69517123699188232f, -0.04910685122013092f), vec2<f32>(0.28034570813179016f, 0.66283899545669556f), vec2<f32>(0.03107489086687565f, -0.69704329967498779f), vec2<f32>(-0.49904009699821472f, 0.54098159074783325f), vec2<f32>(-0.70408397912979126f, -0.14709833264350891f), vec2<f32>(0.53451526165008545f, -0.56702268123626709f), vec2<f32>(-0.48678380250930786f, -0.61486828327178955f), vec2<f32>(0.68837428092956543f, 0.41418349742889404f), vec2<f32>(-0.14107078313827515f, 0.8102262020111084f), vec2<f32>(0.21897397935390472f, -0.3123532235622406f), vec2<f32>(0.31406453251838684f, 0.24951401352882385f), vec2<f32>(-0.83115619421005249f, 0.28457203507423401f), vec2<f32>(-0.40699386596679688f, 0.14198443293571472f), vec2<f32>(-0.10747358947992325f, 0.41360348463058472f), vec2<f32>(-0.19334819912910461f, -0.34689420461654663f), vec2<f32>(0.80768358707427979f, -0.37000563740730286f), vec2<f32>(0.33436411619186401f, -0.82407790422439575f), vec2<f32>(-0.79105347394943237f, -0.45378401875495911f), vec2<f32>(-0.23485180735588074f, -0.86940687894821167f), vec2<f32>(0.37255629897117615f, -0.05855973064899445f), vec2<f32>(0.5726354718208313f, 0.72984015941619873f), vec2<f32>(0.8966706395149231f, 0.17047682404518127f), vec2<f32>(-0.43273070454597473f, 0.81860679388046265f), vec2<f32>(0.1212853416800499f, 0.92984902858734131f), vec2<f32>(-0.42749753594398499f, -0.15111121535301208f), vec2<f32>(-0.94129812717437744f, 0.00735718011856079f), vec2<f32>(0.52211439609527588f, -0.28702935576438904f), vec2<f32>(-0.79033631086349487f, 0.5402228832244873f), vec2<f32>(-0.23410981893539429f, -0.59940856695175171f), vec2<f32>(0.28244560956954956f, -0.563071608543396f), vec2<f32>(0.57051312923431396f, 0.18359191715717316f) );
var<private> SKIN_POISSON_8 : array<vec2<f32>, i32(8)> = array<vec2<f32>, i32(8)>( vec2<f32>(-0.16089901328086853f, -0.04573699831962585f), vec2<f32>(-0.89243310689926147f, 0.18877510726451874f), vec2<f32>(-0.17830690741539001f, 0.7200586199760437f), vec2<f32>(-0.53433239459991455f, -0.70478206872940063f), vec2<f32>(0.22474820911884308f, -0.69165337085723877f), vec2<f32>(0.5559992790222168f, 0.1985180526971817f), vec2<f32>(0.64686292409896851f, -0.3364911675453186f), vec2<f32>(0.33836102485656738f, 0.67131179571151733f) );

fn skin_map_level(map_extent : vec2<f32>, uv_along_x : vec2<f32>, uv_along_y : vec2<f32>) -> f32
{
    var texels_x_0 : vec2<f32> = uv_along_x * map_extent;
    var texels_y_0 : vec2<f32> = uv_along_y * map_extent;
    var x_1 : f32 = dot(texels_x_0, texels_x_0);
    var y_0 : f32 = dot(texels_y_0, texels_y_0);
    return max(0.5f * log2(max(max(min(x_1, y_0), max(x_1, y_0) / 64.0f), 1.00000000317107685e-30f)), 0.0f);
}

fn skin_blur_level(sigma_mm : f32, uv_scale_mm : f32, map_size : f32, hardware_level : f32) -> f32
{
    return max(hardware_level, log2(max(2.0f * sigma_mm * map_size / uv_scale_mm, 1.0f)));
}

fn skin_weighted_sum(rows : mat3x3<f32>, weights : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(weights.x) * rows[i32(0)] + vec3<f32>(weights.y) * rows[i32(1)] + vec3<f32>(weights.z) * rows[i32(2)];
}

fn skin_blend_normals(fetched : mat3x3<f32>, blend : mat3x3<f32>) -> mat3x3<f32>
{
    return mat3x3<f32>(skin_weighted_sum(fetched, blend[i32(0)]), skin_weighted_sum(fetched, blend[i32(1)]), skin_weighted_sum(fetched, blend[i32(2)]));
}

fn skin_safe_length(v : vec3<f32>) -> f32
{
    return sqrt(max(dot(v, v), 1.00000004581370497e-18f));
}

fn skin_with_mesh_diffusion(from_texture : vec3<f32>, from_mesh : vec3<f32>, mesh_normal : vec3<f32>) -> vec3<f32>
{
    return from_texture + vec3<f32>(skin_safe_length(from_texture)) * (from_mesh - mesh_normal);
}

fn skin_add_mesh_diffusion(from_texture : mat3x3<f32>, from_mesh : mat3x3<f32>, mesh_normal : vec3<f32>) -> mat3x3<f32>
{
    return mat3x3<f32>(skin_with_mesh_diffusion(from_texture[i32(0)], from_mesh[i32(0)], mesh_normal), skin_with_mesh_diffusion(from_texture[i32(1)], from_mesh[i32(1)], mesh_normal), skin_with_mesh_diffusion(from_texture[i32(2)], from_mesh[i32(2)], mesh_normal));
}

fn skin_relief_bump(m : f32, s : f32) -> f32
{
    var _S1 : f32 = max(s, 9.99999971718068537e-10f);
    var _S2 : f32 = max(1.0f - abs(m) / (4.40000009536743164f * _S1), 0.0f);
    var t2_0 : f32 = _S2 * _S2;
    return _S1 * t2_0 * t2_0 * (0.16452799737453461f + _S2 * (-1.55506408214569092f + _S2 * (7.10253477096557617f + _S2 * (-16.75164794921875f + _S2 * (22.75126266479492188f + _S2 * (-15.08054447174072266f + _S2 * 3.76787090301513672f))))));
}

fn skin_lengths(normals : mat3x3<f32>) -> vec3<f32>
{
    return vec3<f32>(skin_safe_length(normals[i32(0)]), skin_safe_length(normals[i32(1)]), skin_safe_length(normals[i32(2)]));
}

fn skin_cosines(normals : mat3x3<f32>, light : vec3<f32>, lengths : vec3<f32>) -> vec3<f32>
{
    return clamp(vec3<f32>(dot(normals[i32(0)], light), dot(normals[i32(1)], light), dot(normals[i32(2)], light)) / lengths, vec3<f32>(-1.0f), vec3<f32>(1.0f));
}

fn skin_curvature_table(lut : texture_2d<f32>, lut_sampler : sampler, lut_axes : vec4<f32>, cos_theta : vec3<f32>, curvature_per_mm : f32) -> vec3<f32>
{
    var row_0 : f32 = sqrt(max(curvature_per_mm, 0.0f));
    var _S3 : vec2<f32> = lut_axes.xz;
    var _S4 : vec2<f32> = lut_axes.yw;
    return vec3<f32>((textureSampleLevel((lut), (lut_sampler), (saturate((vec2<f32>(cos_theta.x, row_0) - _S3) * _S4)), (0.0f))).xyz.x, (textureSampleLevel((lut), (lut_sampler), (saturate((vec2<f32>(cos_theta.y, row_0) - _S3) * _S4)), (0.0f))).xyz.y, (textureSampleLevel((lut), (lut_sampler), (saturate((vec2<f32>(cos_theta.z, row_0) - _S3) * _S4)), (0.0f))).xyz.z);
}

fn skin_relief_light(lengths : vec3<f32>, cos_theta : vec3<f32>) -> vec3<f32>
{
    var slope_0 : vec3<f32> = sqrt(max((vec3<f32>(0) - log(clamp(lengths, vec3<f32>(0.00100000004749745f), vec3<f32>(1.0f)))) * (vec3<f32>(1.0f) - cos_theta * cos_theta), vec3<f32>(0.0f)));
    return vec3<f32>(skin_relief_bump(lengths.x * cos_theta.x, slope_0.x), skin_relief_bump(lengths.y * cos_theta.y, slope_0.y), skin_relief_bump(lengths.z * cos_theta.z, slope_0.z));
}

fn skin_direct_scalar(lut : texture_2d<f32>, lut_sampler : sampler, lut_axes : vec4<f32>, normals : mat3x3<f32>, light : vec3<f32>, curvature_per_mm : f32, gain : vec3<f32>) -> vec3<f32>
{
    var lengths_2 : vec3<f32> = skin_lengths(normals);
    var cos_theta_2 : vec3<f32> = skin_cosines(normals, light, lengths_2);
    return gain * (lengths_2 * skin_curvature_table(lut, lut_sampler, lut_axes, cos_theta_2, abs(curvature_per_mm)) + skin_relief_light(lengths_2, cos_theta_2));
}

fn skin_transfer(transfer : texture_2d<f32>, transfer_sampler : sampler, transfer_axes : vec4<f32>, k_per_mm : f32) -> vec3<f32>
{
    return (textureSampleLevel((transfer), (transfer_sampler), (saturate((vec2<f32>(sqrt(max(k_per_mm, 0.0f)), 0.5f) - transfer_axes.xz) * transfer_axes.yw)), (0.0f))).xyz;
}

fn skin_direct_tensor(lut : texture_2d<f32>, lut_sampler : sampler, lut_axes : vec4<f32>, transfer : texture_2d<f32>, transfer_sampler : sampler, transfer_axes : vec4<f32>, normals : mat3x3<f32>, light : vec3<f32>, directional_per_mm : f32, total_per_mm : f32, gain : vec3<f32>) -> vec3<f32>
{
    var lengths_3 : vec3<f32> = skin_lengths(normals);
    var cos_theta_3 : vec3<f32> = skin_cosines(normals, light, lengths_3);
    return gain * (lengths_3 * (skin_curvature_table(lut, lut_sampler, lut_axes, cos_theta_3, directional_per_mm) * skin_transfer(transfer, transfer_sampler, transfer_axes, sqrt(max((total_per_mm - directional_per_mm) * (total_per_mm + directional_per_mm), 0.0f)))) + skin_relief_light(lengths_3, cos_theta_3));
}

fn skin_direct_diffused_normals(lut : texture_2d<f32>, lut_sampler : sampler, lut_axes : vec4<f32>, transfer : texture_2d<f32>, transfer_sampler : sampler, transfer_axes : vec4<f32>, normals : mat3x3<f32>, relief_length : vec3<f32>, light : vec3<f32>, directional_per_mm : f32, gain : vec3<f32>) -> vec3<f32>
{
    var lengths_4 : vec3<f32> = skin_lengths(normals);
    var cos_theta_4 : vec3<f32> = skin_cosines(normals, light, lengths_4);
    return gain * (skin_curvature_table(lut, lut_sampler, lut_axes, cos_theta_4, directional_per_mm) * min(lengths_4 / max(skin_transfer(transfer, transfer_sampler, transfer_axes, directional_per_mm), vec3<f32>(9.99999997475242708e-07f)), vec3<f32>(1.0f)) + skin_relief_light(relief_length, cos_theta_4));
}

fn skin_relief_length(transfer : texture_2d<f32>, transfer_sampler : sampler, transfer_axes : vec4<f32>, from_texture : mat3x3<f32>, from_mesh : mat3x3<f32>, total_per_mm : f32) -> vec3<f32>
{
    return skin_lengths(from_texture) * min(skin_lengths(from_mesh) / max(vec3<f32>(0.97500002384185791f) * skin_transfer(transfer, transfer_sampler, transfer_axes, total_per_mm), vec3<f32>(9.99999997475242708e-07f)), vec3<f32>(1.0f));
}

fn skin_directional_curvature(tensor_world : mat3x3<f32>, normal : vec3<f32>, light : vec3<f32>) -> vec2<f32>
{
    var tangential_0 : vec3<f32> = light - normal * vec3<f32>(dot(light, normal));
    var change_0 : vec3<f32> = vec3<f32>(dot(tensor_world[i32(0)], tangential_0), dot(tensor_world[i32(1)], tangential_0), dot(tensor_world[i32(2)], tangential_0));
    var total_0 : f32 = sqrt(dot(tensor_world[i32(0)], tensor_world[i32(0)]) + dot(tensor_world[i32(1)], tensor_world[i32(1)]) + dot(tensor_world[i32(2)], tensor_world[i32(2)]));
    return vec2<f32>(min(sqrt(dot(change_0, change_0) / max(dot(tangential_0, tangential_0), 9.999999960041972e-13f)), total_0), total_0);
}

fn skin_energy_gain(albedo : vec3<f32>, rms_radius_mm : vec3<f32>, curvature_per_mm : vec3<f32>) -> vec3<f32>
{
    var scaled_curvature_0 : vec3<f32> = vec3<f32>(1.20000004768371582f) * rms_radius_mm * max(curvature_per_mm, vec3<f32>(0.0f));
    var bound_0 : vec3<f32> = albedo * scaled_curvature_0;
    var _S5 : vec3<f32> = vec3<f32>(1.0f);
    return _S5 + (_S5 - albedo) * scaled_curvature_0 / sqrt(_S5 + bound_0 * bound_0);
}

fn skin_root_absorption(albedo : vec3<f32>) -> vec3<f32>
{
    var bounded_0 : vec3<f32> = saturate(albedo);
    var _S6 : vec3<f32> = vec3<f32>(1.0f);
    var s_1 : vec3<f32> = vec3<f32>(6.0f) * (_S6 - bounded_0) / (vec3<f32>(7.0f) + sqrt(vec3<f32>(25.0f) + vec3<f32>(24.0f) * bounded_0));
    return s_1 / (_S6 - s_1);
}

fn skin_inner_cosine(cosine : f32, inverse_ior : f32) -> f32
{
    return sqrt(max(1.0f - (1.0f - cosine * cosine) * inverse_ior * inverse_ior, 0.0f));
}

fn skin_mean_escape(slope : vec3<f32>, low : f32, high : f32) -> vec3<f32>
{
    var _S7 : vec3<f32> = vec3<f32>(1.0f);
    return (_S7 + slope * vec3<f32>((0.36391723155975342f * high + 0.63608276844024658f * low))) / ((_S7 + slope * vec3<f32>(low)) * (_S7 + slope * vec3<f32>(high)));
}

fn skin_view_factor(albedo : vec3<f32>, n_dot_v : f32, reflectance : f32) -> vec3<f32>
{
    var root_0 : f32 = sqrt(clamp(reflectance, 0.0f, 0.89999997615814209f));
    var inverse_ior_1 : f32 = (1.0f - root_0) / (1.0f + root_0);
    var slope_2 : vec3<f32> = vec3<f32>(2.0f) * skin_root_absorption(albedo);
    var _S8 : vec3<f32> = vec3<f32>(1.0f);
    return _S8 / ((_S8 + slope_2 * vec3<f32>(skin_inner_cosine(saturate(n_dot_v), inverse_ior_1))) * skin_mean_escape(slope_2, skin_inner_cosine(0.35505104064941406f, inverse_ior_1), skin_inner_cosine(0.84494894742965698f, inverse_ior_1)));
}

fn skin_closure_view_factor(albedo : vec3<f32>, n_dot_v : f32) -> vec3<f32>
{
    var slope_3 : vec3<f32> = vec3<f32>(2.0f) * skin_root_absorption(albedo);
    var diffuse_0 : vec3<f32> = skin_mean_escape(slope_3, 0.35505104064941406f, 0.84494894742965698f);
    var _S9 : vec3<f32> = vec3<f32>(1.0f);
    return (diffuse_0 + _S9 / (_S9 + slope_3 * vec3<f32>((0.12999999523162842f + 0.75f * saturate(n_dot_v))))) / (diffuse_0 + skin_mean_escape(slope_3, 0.39628827571868896f, 0.76371169090270996f));
}

fn skin_linear_depth(depth : f32, projection : mat4x4<f32>) -> f32
{
    return abs((depth * projection[i32(3)][i32(3)] - projection[i32(2)][i32(3)]) / (projection[i32(2)][i32(2)] - depth * projection[i32(3)][i32(2)]));
}

fn skin_inward_offset(position_mm : vec3<f32>, normal : vec3<f32>, offset_mm : f32) -> vec3<f32>
{
    return position_mm - normal * vec3<f32>(offset_mm);
}

fn skin_thickness(depth_map : texture_2d<f32>, depth_map_sampler : sampler, projection : mat4x4<f32>, uv : vec2<f32>, receiver_mm : f32, radius_uv : vec2<f32>, taps : i32) -> f32
{
    var tap_0 : i32 = i32(0);
    var total_1 : f32 = 0.0f;
    for(;;)
    {
        if(tap_0 < taps)
        {
        }
        else
        {
            break;
        }
        var offset_0 : vec2<f32>;
        if(taps == i32(8))
        {
            offset_0 = SKIN_POISSON_8[min(tap_0, i32(7))];
        }
        else
        {
            offset_0 = SKIN_POISSON_32[min(tap_0, i32(31))];
        }
        var total_2 : f32 = total_1 + max(receiver_mm - skin_linear_depth((textureSampleLevel((depth_map), (depth_map_sampler), (uv + offset_0 * radius_uv), (0.0f))).x, projection), 0.0f);
        tap_0 = tap_0 + i32(1);
        total_1 = total_2;
    }
    return total_1 / f32(max(taps, i32(1)));
}

fn skin_transmittance(thickness_mm : f32, albedo : vec3<f32>, sigma_per_mm : vec3<f32>) -> vec3<f32>
{
    var a2_0 : vec3<f32> = albedo * albedo;
    var decay_0 : vec3<f32> = exp((vec3<f32>(0) - sigma_per_mm) * vec3<f32>(thickness_mm));
    var _S10 : vec3<f32> = vec3<f32>(1.0f);
    return (_S10 - a2_0) * decay_0 / (_S10 - a2_0 * decay_0 * decay_0);
}

fn skin_classic_transmittance(thickness_mm : f32, radius_mm : f32) -> f32
{
    var t_0 : f32 = thickness_mm / radius_mm;
    return exp(-0.5f * t_0 * t_0);
}

fn skin_direct_deep_scatter(transmitted : vec3<f32>, n_dot_l : f32, strength : f32) -> vec3<f32>
{
    return vec3<f32>(strength) * transmitted * vec3<f32>(max(- n_dot_l, 0.0f));
}

fn skin_through_beyond(through : vec3<f32>, diffused : vec3<f32>) -> vec3<f32>
{
    return max(through - diffused, vec3<f32>(0.0f));
}

fn skin_ambient_deep_scatter(transmitted : vec3<f32>, irradiance_behind : vec3<f32>, strength : f32) -> vec3<f32>
{
    return vec3<f32>(strength) * transmitted * irradiance_behind;
}

fn skin_smoothstep(p : f32) -> f32
{
    var q_0 : f32 = saturate(p);
    return q_0 * q_0 * (3.0f - 2.0f * q_0);
}

fn skin_light_coordinates(position_mm : vec3<f32>, view : mat4x4<f32>, projection : mat4x4<f32>) -> vec4<f32>
{
    var p_1 : vec4<f32> = vec4<f32>(position_mm, 1.0f);
    var _S11 : f32 = dot(view[i32(2)], p_1);
    var in_view_0 : vec4<f32> = vec4<f32>(dot(view[i32(0)], p_1), dot(view[i32(1)], p_1), _S11, 1.0f);
    var w_0 : f32 = dot(projection[i32(3)], in_view_0);
    var w_1 : f32;
    if((abs(w_0)) < 9.99999971718068537e-10f)
    {
        w_1 = 9.99999971718068537e-10f;
    }
    else
    {
        w_1 = w_0;
    }
    return vec4<f32>(0.5f + 0.5f * (dot(projection[i32(0)], in_view_0) / w_1), 0.5f - 0.5f * (dot(projection[i32(1)], in_view_0) / w_1), abs(_S11), w_1);
}

fn skin_unit_vectors(v : vec3<f32>) -> vec3<f32>
{
    return v / vec3<f32>(skin_safe_length(v));
}

fn skin_shadow_receiver(position_mm : vec3<f32>, normal : vec3<f32>, to_light : vec3<f32>, curvature_per_mm : f32) -> vec3<f32>
{
    var cosine_1 : f32 = dot(normal, to_light);
    return position_mm + skin_unit_vectors(to_light - normal * vec3<f32>(cosine_1)) * vec3<f32>(min(max(- cosine_1, 0.0f) / max(curvature_per_mm, 0.00100000004749745f), 8.0f));
}

fn skin_plane_slope(normal : vec3<f32>, to_light : vec3<f32>, light_right : vec3<f32>, light_up : vec3<f32>, least_cosine : f32) -> vec2<f32>
{
    var axis_0 : vec3<f32> = cross(light_right, light_up);
    var handedness_0 : f32;
    if((dot(to_light, axis_0)) < 0.0f)
    {
        handedness_0 = -1.0f;
    }
    else
    {
        handedness_0 = 1.0f;
    }
    return vec2<f32>(dot(normal, light_right), - dot(normal, light_up)) / vec2<f32>(max(handedness_0 * dot(normal, axis_0), least_cosine));
}

fn skin_shadow_slope(normal : vec3<f32>, to_light : vec3<f32>, curvature_per_mm : f32, light_right : vec3<f32>, light_up : vec3<f32>) -> vec2<f32>
{
    var slope_4 : vec2<f32> = skin_plane_slope(skin_unit_vectors(normal + to_light * vec3<f32>(max(- dot(normal, to_light), 0.0f))), to_light, light_right, light_up, 0.00100000004749745f);
    return slope_4 / vec2<f32>(max(length(slope_4) / (1.0f + 7.0f * saturate(1.0f + curvature_per_mm / 0.03999999910593033f)), 1.0f));
}

fn skin_shadow_occluder_depth(depth_mm : f32, faces_light : f32) -> f32
{
    return depth_mm + 4.0f * faces_light;
}

fn skin_shadow_compare(depth_map : texture_2d<f32>, depth_map_sampler : sampler, map_extent : vec2<f32>, projection : mat4x4<f32>, uv : vec2<f32>, receiver_mm : f32) -> f32
{
    var _S12 : vec2<f32> = vec2<f32>(0.5f);
    var position_0 : vec2<f32> = uv * map_extent - _S12;
    var corner_0 : vec2<f32> = floor(position_0);
    var weights_1 : vec2<f32> = position_0 - corner_0;
    var _S13 : vec2<f32> = vec2<f32>(0.0f);
    var _S14 : vec2<f32> = vec2<f32>(1.0f);
    var _S15 : vec2<f32> = map_extent - _S14;
    var low_1 : vec2<f32> = (clamp(corner_0, _S13, _S15) + _S12) / map_extent;
    var high_1 : vec2<f32> = (clamp(corner_0 + _S14, _S13, _S15) + _S12) / map_extent;
    var lit_0 : vec4<f32> = step(vec4<f32>(receiver_mm, receiver_mm, receiver_mm, receiver_mm), vec4<f32>(skin_linear_depth((textureSampleLevel((depth_map), (depth_map_sampler), (low_1), (0.0f))).x, projection), skin_linear_depth((textureSampleLevel((depth_map), (depth_map_sampler), (vec2<f32>(high_1.x, low_1.y)), (0.0f))).x, projection), skin_linear_depth((textureSampleLevel((depth_map), (depth_map_sampler), (vec2<f32>(low_1.x, high_1.y)), (0.0f))).x, projection), skin_linear_depth((textureSampleLevel((depth_map), (depth_map_sampler), (high_1), (0.0f))).x, projection)));
    var rows_1 : vec2<f32> = mix(lit_0.xz, lit_0.yw, vec2<f32>(weights_1.x));
    return mix(rows_1.x, rows_1.y, weights_1.y);
}

fn skin_shadow_filter(depth_map : texture_2d<f32>, depth_map_sampler : sampler, map_extent : vec2<f32>, view : mat4x4<f32>, projection : mat4x4<f32>, position_mm : vec3<f32>, normal : vec3<f32>, to_light : vec3<f32>, curvature_per_mm : f32, filter_width_mm : f32, bias_mm : f32, taps : i32) -> f32
{
    var coordinates_0 : vec4<f32> = skin_light_coordinates(skin_shadow_receiver(position_mm, normal, to_light, curvature_per_mm), view, projection);
    var _S16 : vec2<f32> = skin_shadow_slope(normal, to_light, curvature_per_mm, view[i32(0)].xyz, view[i32(1)].xyz);
    var _S17 : vec2<f32> = vec2<f32>(0.5f) * vec2<f32>(abs(projection[i32(0)].x), abs(projection[i32(1)].y)) / vec2<f32>(abs(coordinates_0.w));
    var tap_1 : i32 = i32(0);
    var total_3 : f32 = 0.0f;
    for(;;)
    {
        if(tap_1 < taps)
        {
        }
        else
        {
            break;
        }
        var disk_0 : vec2<f32>;
        if(taps == i32(16))
        {
            disk_0 = SKIN_SHADOW_DISK_16[min(tap_1, i32(15))];
        }
        else
        {
            disk_0 = SKIN_SHADOW_DISK_48[min(tap_1, i32(47))];
        }
        var across_mm_0 : vec2<f32> = vec2<f32>((0.5f * filter_width_mm)) * disk_0;
        var total_4 : f32 = total_3 + skin_shadow_compare(depth_map, depth_map_sampler, map_extent, projection, coordinates_0.xy + across_mm_0 * _S17, coordinates_0.z - bias_mm + dot(_S16, across_mm_0));
        tap_1 = tap_1 + i32(1);
        total_3 = total_4;
    }
    return total_3 / f32(max(taps, i32(1)));
}

fn skin_diffused_shadow(lut : texture_2d<f32>, lut_sampler : sampler, lut_axes : vec4<f32>, shadow_filter : f32, n_dot_l : f32, filter_width_mm : f32) -> vec3<f32>
{
    return (textureSampleLevel((lut), (lut_sampler), (saturate((vec2<f32>(shadow_filter, max(n_dot_l, 0.05000000074505806f) / filter_width_mm) - lut_axes.xz) * lut_axes.yw)), (0.0f))).xyz;
}

fn skin_sharpened_shadow(shadow_filter : f32, sharpening : f32) -> f32
{
    return skin_smoothstep((0.5f - sin(asin(1.0f - 2.0f * saturate(shadow_filter)) / 3.0f) - 0.5f) * sharpening + 0.5f);
}

fn skin_variance_shadow(mean_depth_mm : f32, mean_square_depth_mm2 : f32, depth_mm : f32) -> f32
{
    var _S18 : f32 = max(mean_square_depth_mm2 - mean_depth_mm * mean_depth_mm, 0.00999999977648258f);
    var _S19 : f32 = max(depth_mm - mean_depth_mm, 0.0f);
    return _S18 / (_S18 + _S19 * _S19);
}

fn skin_contact_slope(face_normal : vec3<f32>, to_light : vec3<f32>, light_right : vec3<f32>, light_up : vec3<f32>) -> vec2<f32>
{
    return skin_plane_slope(face_normal, to_light, light_right, light_up, 0.05000000074505806f);
}

fn skin_faded_contact(share : f32, cosine : f32) -> f32
{
    return 1.0f - saturate((cosine - 0.05000000074505806f) / 0.10000000894069672f) * (1.0f - share);
}

fn skin_contact_bias(slope : vec2<f32>) -> f32
{
    return 0.80000001192092896f + 0.30000001192092896f * length(slope);
}

fn skin_contact_compare(depths : vec4<f32>, receiver_mm : f32, rise : vec2<f32>, weights : vec2<f32>) -> f32
{
    var _S20 : f32 = rise.x;
    var _S21 : f32 = rise.y;
    var lit_1 : vec4<f32> = step(vec4<f32>(receiver_mm) + vec4<f32>(0.0f, _S20, _S21, _S20 + _S21), depths);
    var rows_2 : vec2<f32> = mix(lit_1.xz, lit_1.yw, vec2<f32>(weights.x));
    return mix(rows_2.x, rows_2.y, weights.y);
}

fn skin_contact_filter(depth_map : texture_2d<f32>, depth_map_sampler : sampler, map_extent : vec2<f32>, view : mat4x4<f32>, projection : mat4x4<f32>, position_mm : vec3<f32>, face_normal : vec3<f32>, to_light : vec3<f32>) -> f32
{
    var coordinates_1 : vec4<f32> = skin_light_coordinates(position_mm, view, projection);
    var slope_6 : vec2<f32> = skin_contact_slope(face_normal, to_light, view[i32(0)].xyz, view[i32(1)].xyz);
    var _S22 : vec2<f32> = vec2<f32>(0.5f);
    var texels_per_mm_0 : vec2<f32> = _S22 * vec2<f32>(abs(projection[i32(0)].x), abs(projection[i32(1)].y)) / vec2<f32>(abs(coordinates_1.w)) * map_extent;
    var _S23 : vec2<f32> = slope_6 / texels_per_mm_0;
    var _S24 : vec2<f32> = coordinates_1.xy * map_extent - _S22;
    var _S25 : f32 = coordinates_1.z - skin_contact_bias(slope_6);
    var tap_2 : i32 = i32(0);
    var total_5 : f32 = 0.0f;
    for(;;)
    {
        if(tap_2 < i32(12))
        {
        }
        else
        {
            break;
        }
        var position_1 : vec2<f32> = _S24 + vec2<f32>(0.60000002384185791f) * SKIN_CONTACT_DISK[tap_2] * texels_per_mm_0;
        var corner_1 : vec2<f32> = floor(position_1);
        var _S26 : vec2<f32> = vec2<f32>(0.0f);
        var _S27 : vec2<f32> = vec2<f32>(1.0f);
        var _S28 : vec2<f32> = map_extent - _S27;
        var low_2 : vec2<f32> = (clamp(corner_1, _S26, _S28) + _S22) / map_extent;
        var high_2 : vec2<f32> = (clamp(corner_1 + _S27, _S26, _S28) + _S22) / map_extent;
        var total_6 : f32 = total_5 + skin_contact_compare(vec4<f32>(skin_linear_depth((textureSampleLevel((depth_map), (depth_map_sampler), (low_2), (0.0f))).x, projection), skin_linear_depth((textureSampleLevel((depth_map), (depth_map_sampler), (vec2<f32>(high_2.x, low_2.y)), (0.0f))).x, projection), skin_linear_depth((textureSampleLevel((depth_map), (depth_map_sampler), (vec2<f32>(low_2.x, high_2.y)), (0.0f))).x, projection), skin_linear_depth((textureSampleLevel((depth_map), (depth_map_sampler), (high_2), (0.0f))).x, projection)), _S25 + dot(corner_1 - _S24, _S23), _S23, position_1 - corner_1);
        tap_2 = tap_2 + i32(1);
        total_5 = total_6;
    }
    return skin_faded_contact(total_5 / 12.0f, dot(face_normal, to_light));
}

fn skin_contact_shadow(lut : texture_2d<f32>, lut_sampler : sampler, lut_axes : vec4<f32>, shadow : vec3<f32>, contact : f32, filter_width_mm : f32) -> vec3<f32>
{
    return min(shadow, vec3<f32>(contact) + vec3<f32>((1.0f - contact)) * skin_diffused_shadow(lut, lut_sampler, lut_axes, skin_smoothstep(0.5f - 0.60000002384185791f / filter_width_mm), 1.0f, filter_width_mm));
}

fn skin_sh_bands(sh : mat3x3<f32>, d : vec3<f32>) -> vec3<f32>
{
    var _S29 : f32 = d.y;
    var _S30 : f32 = d.z;
    var _S31 : f32 = d.x;
    return vec3<f32>(0.282094806432724f * sh[i32(0)].x, 0.48860251903533936f * (sh[i32(0)].y * _S29 + sh[i32(0)].z * _S30 + sh[i32(1)].x * _S31), 1.09254848957061768f * (sh[i32(1)].y * _S31 * _S29 + sh[i32(1)].z * _S29 * _S30 + sh[i32(2)].y * _S31 * _S30) + 0.31539157032966614f * sh[i32(2)].x * (3.0f * _S30 * _S30 - dot(d, d)) + 0.54627424478530884f * sh[i32(2)].z * (_S31 * _S31 - _S29 * _S29));
}

fn skin_ambient_channel(sh : mat3x3<f32>, normal : vec3<f32>, band_transfer : vec3<f32>) -> f32
{
    return max(dot(skin_sh_bands(sh, normal), vec3<f32>(1.0f, 1.0f, skin_safe_length(normal)) * band_transfer * vec3<f32>(1.0f, 0.66666668653488159f, 0.25f)), 0.0f);
}

fn skin_ambient_irradiance(radiance_sh_red : mat3x3<f32>, radiance_sh_green : mat3x3<f32>, radiance_sh_blue : mat3x3<f32>, normals : mat3x3<f32>, band_transfer : mat3x3<f32>) -> vec3<f32>
{
    var t_1 : mat3x3<f32> = transpose(band_transfer);
    return vec3<f32>(skin_ambient_channel(radiance_sh_red, normals[i32(0)], t_1[i32(0)]), skin_ambient_channel(radiance_sh_green, normals[i32(1)], t_1[i32(1)]), skin_ambient_channel(radiance_sh_blue, normals[i32(2)], t_1[i32(2)]));
}

fn skin_ambient_normals(normals : mat3x3<f32>) -> mat3x3<f32>
{
    return mat3x3<f32>(skin_unit_vectors(normals[i32(0)]), skin_unit_vectors(normals[i32(1)]), skin_unit_vectors(normals[i32(2)]));
}

fn skin_ambient_of_three(red : vec3<f32>, green : vec3<f32>, blue : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(red.x, green.y, blue.z);
}

fn skin_bounced_visibility(visibility : vec3<f32>, albedo : vec3<f32>) -> vec3<f32>
{
    return max(visibility, ((visibility * (vec3<f32>(2.04040002822875977f) * albedo - vec3<f32>(0.33239999413490295f)) + (vec3<f32>(-4.79510021209716797f) * albedo + vec3<f32>(0.64170002937316895f))) * visibility + (vec3<f32>(2.75519990921020508f) * albedo + vec3<f32>(0.69029998779296875f))) * visibility);
}

fn skin_sh_product(a : mat3x3<f32>, b : mat3x3<f32>) -> f32
{
    return dot(a[i32(0)], b[i32(0)]) + dot(a[i32(1)], b[i32(1)]) + dot(a[i32(2)], b[i32(2)]);
}

fn skin_transferred_irradiance(ambient_transfer_red : mat3x3<f32>, ambient_transfer_green : mat3x3<f32>, ambient_transfer_blue : mat3x3<f32>, radiance_sh_red : mat3x3<f32>, radiance_sh_green : mat3x3<f32>, radiance_sh_blue : mat3x3<f32>) -> vec3<f32>
{
    return max(vec3<f32>(skin_sh_product(ambient_transfer_red, radiance_sh_red), skin_sh_product(ambient_transfer_green, radiance_sh_green), skin_sh_product(ambient_transfer_blue, radiance_sh_blue)), vec3<f32>(0.0f));
}

fn skin_reflected_visibility(sky_harmonics : mat3x3<f32>, normal : vec3<f32>, direction : vec3<f32>) -> f32
{
    var bands_0 : vec3<f32> = skin_sh_bands(sky_harmonics, direction);
    var _S32 : f32 = max(dot(normal, direction), 0.0f);
    return saturate((bands_0.x + bands_0.y + bands_0.z) / ((0.375f + _S32 * (2.0f + 1.875f * _S32)) * 0.07957746833562851f));
}

fn skin_occluded_reflection(sky : vec3<f32>, bounced : vec3<f32>, sky_harmonics : mat3x3<f32>, normal : vec3<f32>, direction : vec3<f32>) -> vec3<f32>
{
    return mix(bounced / vec3<f32>(max(1.0f - sky_harmonics[i32(0)].x / 0.282094806432724f, 0.01999999955296516f)), sky, vec3<f32>(skin_reflected_visibility(sky_harmonics, normal, direction)));
}

fn skin_specular_visibility(n_dot_v : f32, visibility : f32, roughness : f32) -> f32
{
    var exponent_0 : f32 = exp2(-16.0f * roughness - 1.0f);
    var base_0 : f32 = n_dot_v + visibility;
    var power_0 : f32;
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

fn skin_specular_power(gloss : f32) -> f32
{
    return exp2(13.0f * gloss);
}

fn skin_gloss_of_relief(gloss : f32, normal_length : f32) -> f32
{
    var clamped_length_0 : f32 = clamp(normal_length, 0.00100000004749745f, 1.0f);
    var power_1 : f32 = skin_specular_power(gloss);
    return log2(max(clamped_length_0 * power_1 / (clamped_length_0 + power_1 * (1.0f - clamped_length_0)), 1.0f)) / 13.0f;
}

fn skin_gloss_from_roughness(roughness : f32) -> f32
{
    var _S33 : f32 = max(roughness, 0.00100000004749745f);
    var r2_0 : f32 = _S33 * _S33;
    return clamp(log2(max(2.0f / (r2_0 * r2_0) - 2.0f, 1.0f)) / 13.0f, 0.0f, 1.0f);
}

fn skin_lobe(n_dot_h : f32, n_dot_l : f32, n_dot_v : f32, power : f32) -> f32
{
    var k_0 : f32 = skin_rsqrt_0(3.14159274101257324f * power / 4.0f + 1.57079637050628662f);
    var _S34 : f32 = 1.0f - k_0;
    return (power + 2.0f) / 6.28318548202514648f * pow(max(n_dot_h, 9.99999971718068537e-10f), power) * (0.25f / ((k_0 + _S34 * n_dot_l) * (k_0 + _S34 * n_dot_v)));
}

fn skin_specular(normal : vec3<f32>, view : vec3<f32>, light : vec3<f32>, gloss : f32, reflectance : f32) -> f32
{
    var half_vector_0 : vec3<f32> = skin_unit_vectors(view + light);
    var n_dot_l_3 : f32 = saturate(dot(normal, light));
    var n_dot_v_4 : f32 = clamp(dot(normal, view), 0.00009999999747379f, 1.0f);
    var n_dot_h_1 : f32 = saturate(dot(normal, half_vector_0));
    var wide_0 : f32 = skin_specular_power(gloss);
    var grazing_0 : f32 = 1.0f - saturate(dot(view, half_vector_0));
    var grazing2_0 : f32 = grazing_0 * grazing_0;
    return 3.14159274101257324f * (0.94999998807907104f * skin_lobe(n_dot_h_1, n_dot_l_3, n_dot_v_4, wide_0) + 0.05000000074505806f * skin_lobe(n_dot_h_1, n_dot_l_3, n_dot_v_4, min(wide_0 * wide_0, 8192.0f))) * (reflectance + (1.0f - reflectance) * grazing2_0 * grazing2_0 * grazing_0) * n_dot_l_3;
}

fn skin_reflected(normal : vec3<f32>, view : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>((2.0f * dot(normal, view))) * normal - view;
}

fn skin_ambient_specular_fresnel(n_dot_v : f32, gloss : f32, reflectance : f32) -> f32
{
    var grazing_1 : f32 = 1.0f - saturate(n_dot_v);
    var grazing2_1 : f32 = grazing_1 * grazing_1;
    return reflectance + (1.0f - reflectance) * grazing2_1 * grazing2_1 * grazing_1 / (4.0f - 3.0f * gloss);
}

fn skin_diffuse_share(n_dot_v : f32, gloss : f32, reflectance : f32) -> f32
{
    return 1.0f - skin_ambient_specular_fresnel(n_dot_v, gloss, reflectance);
}

fn skin_alpha_from_gloss(gloss : f32) -> f32
{
    return sqrt(2.0f / (skin_specular_power(gloss) + 2.0f));
}

fn skin_second_gloss(gloss : f32) -> f32
{
    return min(2.0f * gloss, 1.0f);
}

fn skin_coat_fresnel(cosine : f32, reflectance : f32) -> f32
{
    var root_1 : f32 = sqrt(clamp(reflectance, 0.0f, 0.89999997615814209f));
    var _S35 : f32 = 1.0f - root_1;
    var excess_0 : f32 = 4.0f * root_1 / (_S35 * _S35);
    var _S36 : f32 = max(sqrt(excess_0 + cosine * cosine) + cosine, 9.99999971718068537e-10f);
    var across_0 : f32 = excess_0 / (_S36 * _S36);
    var along_0 : f32 = (cosine * _S36 - 1.0f) / (cosine * excess_0 / _S36 + 1.0f);
    return 0.5f * across_0 * across_0 * (1.0f + along_0 * along_0);
}

fn skin_coat_highlight(normal : vec3<f32>, view : vec3<f32>, light : vec3<f32>, gloss : f32, reflectance : f32) -> f32
{
    var half_vector_1 : vec3<f32> = skin_unit_vectors(view + light);
    var n_dot_l_4 : f32 = saturate(dot(normal, light));
    var n_dot_v_7 : f32 = clamp(dot(normal, view), 0.00009999999747379f, 1.0f);
    var n_dot_h_2 : f32 = saturate(dot(normal, half_vector_1));
    var v_dot_h_0 : f32 = saturate(dot(view, half_vector_1));
    var squared_0 : f32 = 2.0f / (skin_specular_power(gloss) + 2.0f);
    var side_0 : vec3<f32> = cross(normal, half_vector_1);
    var sine2_0 : f32;
    if(n_dot_h_2 > 0.0f)
    {
        sine2_0 = dot(side_0, side_0);
    }
    else
    {
        sine2_0 = 1.0f;
    }
    var root_2 : f32 = squared_0 / (n_dot_h_2 * n_dot_h_2 * squared_0 + sine2_0);
    var _S37 : f32 = 1.0f - squared_0;
    return root_2 * root_2 / squared_0 * (0.5f / (n_dot_l_4 * sqrt(n_dot_v_7 * n_dot_v_7 * _S37 + squared_0) + n_dot_v_7 * sqrt(n_dot_l_4 * n_dot_l_4 * _S37 + squared_0))) * skin_coat_fresnel(v_dot_h_0, reflectance) * n_dot_l_4;
}

fn skin_coat(lut : texture_2d<f32>, lut_sampler : sampler, lut_axes : vec4<f32>, n_dot_v : f32, gloss : f32, reflectance : f32, coat_reflectance : f32) -> vec2<f32>
{
    var entry_0 : vec3<f32> = (textureSampleLevel((lut), (lut_sampler), (saturate((vec2<f32>(sqrt(saturate(n_dot_v)), gloss) - lut_axes.xz) * lut_axes.yw)), (0.0f))).xyz;
    var _S38 : f32 = entry_0.z;
    return vec2<f32>(clamp(_S38 + (1.0f - reflectance) / (1.0f - coat_reflectance) * (entry_0.x - _S38), 0.0f, _S38), entry_0.y);
}

fn skin_coat_direction(normal : vec3<f32>, view : vec3<f32>, pull : f32) -> vec3<f32>
{
    var mirrored_0 : vec3<f32> = skin_reflected(normal, view);
    return skin_unit_vectors(mirrored_0 + vec3<f32>(pull) * (normal - mirrored_0));
}

fn skin_turns(y : f32, x : f32) -> f32
{
    var size_0 : vec2<f32> = abs(vec2<f32>(x, y));
    var _S39 : f32 = size_0.x;
    var _S40 : f32 = size_0.y;
    var r_0 : f32 = min(_S39, _S40) / max(max(_S39, _S40), 1.00000000317107685e-30f);
    var r2_1 : f32 = r_0 * r_0;
    var turns_0 : f32 = r_0 * (0.15915107727050781f + r2_1 * (-0.05293257534503937f + r2_1 * (0.03076364658772945f + r2_1 * (-0.01842727139592171f + r2_1 * (0.00826387945562601f - r2_1 * 0.00181874714326113f)))));
    var turns_1 : f32;
    if(_S40 > _S39)
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
    if(y < 0.0f)
    {
        turns_1 = - turns_1;
    }
    return turns_1;
}

fn skin_equirectangular_uv(direction : vec3<f32>) -> vec2<f32>
{
    var _S41 : f32 = direction.x;
    var _S42 : f32 = direction.z;
    return vec2<f32>(0.5f + skin_turns(_S42, _S41), 2.0f * skin_turns(sqrt(_S41 * _S41 + _S42 * _S42), direction.y));
}

fn skin_reflection_level(power : f32) -> f32
{
    return clamp(0.5f * log2(max(power, 1.0f)), 0.0f, 4.0f);
}

fn skin_preconvolved(preconvolved : texture_2d<f32>, preconvolved_sampler : sampler, uv : vec2<f32>, power : f32) -> vec3<f32>
{
    var level_0 : f32 = skin_reflection_level(power);
    var _S43 : f32 = min(floor(level_0), 3.0f);
    var row_1 : f32 = clamp(uv.y, 0.0078125f, 0.9921875f);
    var _S44 : f32 = uv.x;
    return mix((textureSampleLevel((preconvolved), (preconvolved_sampler), (vec2<f32>(_S44, (_S43 + row_1) / 5.0f)), (0.0f))).xyz, (textureSampleLevel((preconvolved), (preconvolved_sampler), (vec2<f32>(_S44, (_S43 + 1.0f + row_1) / 5.0f)), (0.0f))).xyz, vec3<f32>((level_0 - _S43)));
}

fn skin_reflected_radiance(preconvolved : texture_2d<f32>, preconvolved_sampler : sampler, direction : vec3<f32>, gloss : f32) -> vec3<f32>
{
    var uv_3 : vec2<f32> = skin_equirectangular_uv(direction);
    var power_5 : f32 = skin_specular_power(gloss);
    return mix(skin_preconvolved(preconvolved, preconvolved_sampler, uv_3, power_5 / 4.0f), skin_preconvolved(preconvolved, preconvolved_sampler, uv_3, power_5 * power_5 / 4.0f), vec3<f32>(0.05000000074505806f));
}

fn skin_coat_radiance(preconvolved : texture_2d<f32>, preconvolved_sampler : sampler, direction : vec3<f32>, n_dot_v : f32, gloss : f32) -> vec3<f32>
{
    return skin_preconvolved(preconvolved, preconvolved_sampler, skin_equirectangular_uv(direction), (skin_specular_power(gloss) + 2.0f) / (8.0f * max(n_dot_v, 0.00999999977648258f)));
}

fn skin_filmic(light : vec3<f32>) -> vec3<f32>
{
    var x_3 : vec3<f32> = max(light - vec3<f32>(0.00400000018998981f), vec3<f32>(0.0f));
    var _S45 : vec3<f32> = vec3<f32>(6.19999980926513672f) * x_3;
    return x_3 * (_S45 + vec3<f32>(0.5f)) / (x_3 * (_S45 + vec3<f32>(1.70000004768371582f)) + vec3<f32>(0.05999999865889549f));
}

fn skin_srgb_curve(x : f32) -> f32
{
    var _S46 : f32;
    if(x <= 0.00313080009073019f)
    {
        _S46 = 12.92000007629394531f * x;
    }
    else
    {
        _S46 = 1.0549999475479126f * pow(max(x, 9.999999960041972e-13f), 0.4166666567325592f) - 0.05499999970197678f;
    }
    return _S46;
}

fn skin_srgb_from_linear(light : vec3<f32>) -> vec3<f32>
{
    var x_5 : vec3<f32> = saturate(light);
    return vec3<f32>(skin_srgb_curve(x_5.x), skin_srgb_curve(x_5.y), skin_srgb_curve(x_5.z));
}

fn skin_linear_curve(x : f32) -> f32
{
    var _S47 : f32;
    if(x <= 0.04044999927282333f)
    {
        _S47 = x / 12.92000007629394531f;
    }
    else
    {
        _S47 = pow((x + 0.05499999970197678f) / 1.0549999475479126f, 2.40000009536743164f);
    }
    return _S47;
}

fn skin_linear_from_srgb(display : vec3<f32>) -> vec3<f32>
{
    var x_7 : vec3<f32> = saturate(display);
    return vec3<f32>(skin_linear_curve(x_7.x), skin_linear_curve(x_7.y), skin_linear_curve(x_7.z));
}

fn skin_classic_blur_level(radius_mm : f32, uv_scale_mm : f32, map_size : f32, hardware_level : f32) -> f32
{
    return max(hardware_level, log2(max(map_size * radius_mm, uv_scale_mm) / uv_scale_mm));
}

fn skin_classic_direct(lut : texture_2d<f32>, lut_sampler : sampler, lut_axes : vec4<f32>, sharp : vec3<f32>, blurred : vec3<f32>, light : vec3<f32>, curvature_per_mm : f32) -> vec3<f32>
{
    var blurred_cosine_0 : f32 = dot(blurred, light);
    var k_1 : f32 = saturate(1.0f - blurred_cosine_0);
    var k_2 : f32 = k_1 * k_1;
    return saturate(saturate(vec3<f32>(blurred_cosine_0, dot(skin_unit_vectors(mix(sharp, blurred, vec3<f32>((0.30000001192092896f + 0.69999998807907104f * k_2)))), light), dot(skin_unit_vectors(mix(sharp, blurred, vec3<f32>(k_2))), light))) + ((textureSampleLevel((lut), (lut_sampler), (saturate((vec2<f32>(blurred_cosine_0, abs(curvature_per_mm)) - lut_axes.xz) * lut_axes.yw)), (0.0f))).xyz - vec3<f32>(max(blurred_cosine_0, 0.0f))));
}

fn skin_classic_ambient_normals(sharp : vec3<f32>, blurred : vec3<f32>) -> mat3x3<f32>
{
    return mat3x3<f32>(blurred, skin_unit_vectors(mix(sharp, blurred, vec3<f32>(0.30000001192092896f))), sharp);
}

fn skin_classic_sharpened_shadow(shadow_filter : f32, sharpening : f32) -> f32
{
    return skin_smoothstep(0.89999997615814209f * sharpening * (shadow_filter - 0.5f) + 0.5f);
}

fn skin_classic_deep_scatter(thickness_mm : f32, n_dot_l : f32, radius_mm : f32, strength : f32) -> f32
{
    return strength * skin_classic_transmittance(thickness_mm, radius_mm) * max(0.30000001192092896f - n_dot_l, 0.0f);
}

fn skin_eye_root(value : f32) -> f32
{
    return sqrt(max(value, 9.99999997475242708e-07f));
}

fn skin_eye_cornea(cornea_radius_mm : f32, cornea_asphericity : f32, refraction_index : f32, limbus : vec4<f32>) -> vec4<f32>
{
    var r_1 : f32 = limbus.x;
    var ratio_0 : f32 = r_1 / cornea_radius_mm;
    var _S48 : f32 = r_1 * r_1;
    var _S49 : f32 = limbus.z;
    return vec4<f32>(skin_eye_root(_S49 * _S49 - _S48) + _S48 / (cornea_radius_mm * (1.0f + skin_eye_root(1.0f - (1.0f + cornea_asphericity) * ratio_0 * ratio_0))), cornea_radius_mm, cornea_asphericity, refraction_index);
}

fn skin_eye_conic(r : f32, cornea : vec4<f32>) -> vec2<f32>
{
    var _S50 : f32 = cornea.y;
    var ratio_1 : f32 = r / _S50;
    var root_3 : f32 = skin_eye_root(1.0f - (1.0f + cornea.z) * ratio_1 * ratio_1);
    return vec2<f32>(cornea.x - r * r / (_S50 * (1.0f + root_3)), -1.0f / (_S50 * root_3));
}

fn skin_eye_profile(r : f32, cornea : vec4<f32>, limbus : vec4<f32>) -> vec2<f32>
{
    var _S51 : f32 = limbus.x;
    var _S52 : f32 = limbus.y;
    var inner_0 : f32 = _S51 - _S52;
    var outer_0 : f32 = _S51 + _S52;
    var width_0 : f32 = outer_0 - inner_0;
    if(r < inner_0)
    {
        return skin_eye_conic(r, cornea);
    }
    if(r >= outer_0)
    {
        var _S53 : f32 = limbus.z;
        var sphere_0 : f32 = skin_eye_root(_S53 * _S53 - r * r);
        return vec2<f32>(sphere_0, -1.0f / sphere_0);
    }
    var start_0 : vec2<f32> = skin_eye_conic(inner_0, cornea);
    var _S54 : f32 = limbus.z;
    var end_0 : f32 = skin_eye_root(_S54 * _S54 - outer_0 * outer_0);
    var m0_0 : f32 = width_0 * inner_0 * start_0.y;
    var m1_0 : f32 = - width_0 * outer_0 / end_0;
    var t_2 : f32 = (r - inner_0) / width_0;
    var _S55 : f32 = start_0.x;
    var rise_1 : f32 = end_0 - _S55;
    var c2_0 : f32 = 3.0f * rise_1 - 2.0f * m0_0 - m1_0;
    var c3_0 : f32 = m0_0 + m1_0 - 2.0f * rise_1;
    return vec2<f32>(_S55 + t_2 * (m0_0 + t_2 * (c2_0 + t_2 * c3_0)), (m0_0 + t_2 * (2.0f * c2_0 + t_2 * (3.0f * c3_0))) / (width_0 * max(r, 9.99999997475242708e-07f)));
}

fn skin_eye_height(r_mm : f32, cornea : vec4<f32>, limbus : vec4<f32>) -> f32
{
    return skin_eye_profile(r_mm, cornea, limbus).x;
}

fn skin_eye_normal(position_mm : vec3<f32>, cornea : vec4<f32>, limbus : vec4<f32>) -> vec3<f32>
{
    var _S56 : vec2<f32> = position_mm.xy;
    var r_4 : f32 = sqrt(dot(_S56, _S56));
    var slope_over_r_0 : f32 = skin_eye_profile(r_4, cornea, limbus).y;
    var in_front_0 : bool;
    if((position_mm.z) > 0.0f)
    {
        in_front_0 = r_4 < (limbus.x + limbus.y);
    }
    else
    {
        in_front_0 = false;
    }
    var normal_13 : vec3<f32> = vec3<f32>(vec2<f32>(- slope_over_r_0) * _S56, 1.0f);
    var _S57 : vec3<f32>;
    if(in_front_0)
    {
        _S57 = normal_13;
    }
    else
    {
        _S57 = position_mm;
    }
    return skin_unit_vectors(_S57);
}

fn skin_eye_cornea_hit(origin_mm : vec3<f32>, direction : vec3<f32>, cornea : vec4<f32>) -> vec4<f32>
{
    var q_1 : f32 = 1.0f + cornea.z;
    var s_2 : f32 = cornea.x - origin_mm.z;
    var _S58 : f32 = direction.z;
    var _S59 : vec2<f32> = origin_mm.xy;
    var _S60 : f32 = cornea.y;
    var _S61 : f32 = q_1 * s_2;
    var b_1 : f32 = dot(_S59, direction.xy) + _S58 * (_S60 - _S61);
    var c_0 : f32 = dot(_S59, _S59) - 2.0f * _S60 * s_2 + _S61 * s_2;
    var radicand_0 : f32 = b_1 * b_1 - (1.0f - (1.0f - q_1) * _S58 * _S58) * c_0;
    var meets_0 : bool;
    if(radicand_0 >= 0.0f)
    {
        meets_0 = b_1 < 0.0f;
    }
    else
    {
        meets_0 = false;
    }
    var distance_0 : f32;
    if(meets_0)
    {
        distance_0 = c_0 / max(skin_eye_root(radicand_0) - b_1, 9.99999997475242708e-07f);
    }
    else
    {
        distance_0 = 0.0f;
    }
    var _S62 : vec3<f32> = origin_mm + vec3<f32>(distance_0) * direction;
    if(meets_0)
    {
        distance_0 = 1.0f;
    }
    else
    {
        distance_0 = 0.0f;
    }
    return vec4<f32>(_S62, distance_0);
}

fn skin_smooth(t : f32) -> f32
{
    var clamped_0 : f32 = saturate(t);
    return clamped_0 * clamped_0 * (3.0f - 2.0f * clamped_0);
}

fn skin_eye_limbal_opacity(r_mm : f32, limbus : vec4<f32>) -> f32
{
    var _S63 : f32 = limbus.y;
    return skin_smooth((r_mm - limbus.x + _S63) / (2.0f * _S63));
}

fn skin_eye_iris_hit(position_mm : vec3<f32>, normal : vec3<f32>, view : vec3<f32>, cornea : vec4<f32>, iris : vec4<f32>) -> vec3<f32>
{
    var eta_0 : f32 = 1.0f / cornea.w;
    var _S64 : f32 = max(dot(normal, view), 0.0f);
    var d_1 : vec3<f32> = vec3<f32>((eta_0 * _S64 - sqrt(max(1.0f - eta_0 * eta_0 * (1.0f - _S64 * _S64), 0.0f)))) * normal - vec3<f32>(eta_0) * view;
    var h_0 : f32 = iris.x - position_mm.z;
    var _S65 : f32 = iris.y;
    var m2_0 : f32 = _S65 * _S65;
    var _S66 : f32 = d_1.z;
    var _S67 : vec2<f32> = d_1.xy;
    var a_1 : f32 = _S66 * _S66 - m2_0 * dot(_S67, _S67);
    var _S68 : vec2<f32> = position_mm.xy;
    var b_2 : f32 = h_0 * _S66 + m2_0 * dot(_S68, _S67);
    var e_0 : f32 = h_0 * h_0 - m2_0 * dot(_S68, _S68);
    var apart_0 : vec2<f32> = vec2<f32>(h_0) * _S67 + vec2<f32>(_S66) * _S68;
    var cross_product_0 : f32 = d_1.x * position_mm.y - d_1.y * position_mm.x;
    var root_4 : f32 = abs(_S65) * sqrt(max(dot(apart_0, apart_0) - m2_0 * cross_product_0 * cross_product_0, 0.0f));
    var distance_1 : f32;
    if(_S65 < 0.0f)
    {
        distance_1 = e_0 / max(b_2 + root_4, 9.99999997475242708e-07f);
    }
    else
    {
        distance_1 = (b_2 + root_4) / max(a_1, 0.00009999999747379f);
    }
    return position_mm + vec3<f32>(distance_1) * d_1;
}

fn skin_eye_iris_uv(hit_mm : vec3<f32>, iris : vec4<f32>, pupil_in_map : f32, iris_uv : vec4<f32>) -> vec2<f32>
{
    var _S69 : vec2<f32> = hit_mm.xy;
    var r_5 : f32 = sqrt(dot(_S69, _S69));
    var pupil_0 : f32 = iris.w;
    var _S70 : f32 = min((r_5 - pupil_0) / max(iris.z - pupil_0, 9.99999997475242708e-07f), 1.0f);
    var radius_0 : f32;
    if(r_5 < pupil_0)
    {
        radius_0 = pupil_in_map * r_5 / max(pupil_0, 9.99999997475242708e-07f);
    }
    else
    {
        radius_0 = pupil_in_map + (1.0f - pupil_in_map) * _S70;
    }
    var scale_0 : f32 = iris_uv.z * radius_0 / max(r_5, 9.99999997475242708e-07f);
    var angle_0 : f32 = 6.28318548202514648f * iris_uv.w;
    var cosine_4 : f32 = cos(angle_0);
    var sine_0 : f32 = sin(angle_0);
    var _S71 : f32 = hit_mm.x;
    var _S72 : f32 = hit_mm.y;
    return vec2<f32>(iris_uv.x + scale_0 * (cosine_4 * _S71 - sine_0 * _S72), iris_uv.y - scale_0 * (sine_0 * _S71 + cosine_4 * _S72));
}

fn skin_eye_iris_parallax(hit_mm : vec3<f32>, direction : vec3<f32>, iris_normal : vec3<f32>, height_mm : f32) -> vec3<f32>
{
    return hit_mm - direction * vec3<f32>((height_mm / max(- dot(direction, iris_normal), 0.10000000149011612f)));
}

fn skin_eye_warped(cosine : f32) -> f32
{
    var size_1 : f32 = pow(max(abs(cosine), 9.99999971718068537e-10f), 0.69999998807907104f);
    var _S73 : f32;
    if(cosine < 0.0f)
    {
        _S73 = - size_1;
    }
    else
    {
        _S73 = size_1;
    }
    return _S73;
}

fn skin_eye_slice(cosine : f32) -> f32
{
    var least_0 : f32 = skin_eye_warped(-0.34202015399932861f);
    return 15.0f * (skin_eye_warped(clamp(cosine, -0.34202015399932861f, 1.0f)) - least_0) / (1.0f - least_0);
}

fn skin_eye_light(lut : texture_2d<f32>, lut_sampler : sampler, lut_axes : vec4<f32>, hit_mm : vec3<f32>, light : vec3<f32>) -> vec3<f32>
{
    var _S74 : vec2<f32> = light.xy;
    var across_1 : f32 = sqrt(dot(_S74, _S74));
    var turn_0 : vec2<f32>;
    if(across_1 > 9.99999997475242708e-07f)
    {
        turn_0 = _S74 / vec2<f32>(across_1);
    }
    else
    {
        turn_0 = vec2<f32>(1.0f, 0.0f);
    }
    var x_8 : f32 = dot(hit_mm.xy, turn_0);
    var _S75 : f32 = turn_0.x;
    var _S76 : f32 = turn_0.y;
    var y_2 : f32 = hit_mm.y * _S75 - hit_mm.x * _S76;
    var index_0 : f32 = skin_eye_slice(light.z);
    var _S77 : f32 = min(floor(index_0), 14.0f);
    var row_2 : f32 = 0.5f + 15.0f * min(abs(y_2) / (- lut_axes.x * 31.0f / 32.0f), 1.0f) + 16.0f * _S77;
    var _S78 : vec2<f32> = lut_axes.xz;
    var _S79 : vec2<f32> = lut_axes.yw;
    var first_0 : vec3<f32> = (textureSampleLevel((lut), (lut_sampler), (saturate((vec2<f32>(x_8, row_2) - _S78) * _S79)), (0.0f))).xyz;
    var second_0 : vec3<f32> = (textureSampleLevel((lut), (lut_sampler), (saturate((vec2<f32>(x_8, row_2 + 16.0f) - _S78) * _S79)), (0.0f))).xyz;
    var straight_0 : f32 = 1.0f - min(across_1 / 0.50550216436386108f, 1.0f);
    var moved_0 : f32;
    if(_S77 > 13.5f)
    {
        moved_0 = straight_0;
    }
    else
    {
        moved_0 = index_0 - _S77;
    }
    var value_1 : vec3<f32> = mix(first_0, second_0, vec3<f32>(index_0 - _S77, moved_0, moved_0));
    var entry_y_0 : f32;
    if(y_2 < 0.0f)
    {
        entry_y_0 = - value_1.z;
    }
    else
    {
        entry_y_0 = value_1.z;
    }
    var _S80 : f32 = value_1.y;
    return vec3<f32>(value_1.x, _S80 * _S75 - entry_y_0 * _S76, _S80 * _S76 + entry_y_0 * _S75);
}

fn skin_eye_ambient(lut : texture_2d<f32>, lut_sampler : sampler, lut_axes : vec4<f32>, r_mm : f32) -> vec4<f32>
{
    var _S81 : vec2<f32> = lut_axes.xz;
    var _S82 : vec2<f32> = lut_axes.yw;
    return vec4<f32>((textureSampleLevel((lut), (lut_sampler), (saturate((vec2<f32>(r_mm, 0.0f) - _S81) * _S82)), (0.0f))).xyz, (textureSampleLevel((lut), (lut_sampler), (saturate((vec2<f32>(r_mm, 1.0f) - _S81) * _S82)), (0.0f))).xyz.x);
}

fn skin_dielectric_fresnel(cosine : f32, index : f32) -> f32
{
    var c_1 : f32 = saturate(cosine);
    var _S83 : f32 = index * index;
    var inside_0 : f32 = sqrt(max(_S83 - 1.0f + c_1 * c_1, 0.0f));
    var s_3 : f32 = (c_1 - inside_0) / max(c_1 + inside_0, 9.99999997475242708e-07f);
    var _S84 : f32 = _S83 * c_1;
    var p_2 : f32 = (_S84 - inside_0) / max(_S84 + inside_0, 9.99999997475242708e-07f);
    return 0.5f * (s_3 * s_3 + p_2 * p_2);
}

fn skin_eye_inside(n_dot_v : f32, index : f32) -> f32
{
    return (1.0f - skin_dielectric_fresnel(n_dot_v, index)) / (index * index);
}

fn skin_lamp_highlight(reflected : vec3<f32>, light : vec3<f32>, lamp : f32, roughness : f32) -> f32
{
    var apart_1 : vec3<f32> = reflected - light;
    var chord2_0 : f32 = dot(apart_1, apart_1);
    var wide_1 : f32 = sqrt(lamp * lamp + roughness * roughness);
    var _S85 : f32 = max(roughness, 0.00009999999747379f);
    var sine_1 : f32 = sin(wide_1);
    return skin_smooth((wide_1 + _S85 - sqrt(chord2_0) * (1.0f + chord2_0 * (0.0416666679084301f + chord2_0 * 0.00468750018626451f))) / (2.0f * _S85)) / (sine_1 * sine_1 + _S85 * _S85 / 5.0f);
}

fn skin_pupil_radius(luminance : f32) -> f32
{
    return 2.45000004768371582f - 1.5f * tanh(0.12041200697422028f * log2(clamp(luminance, 9.99999997475242708e-07f, 1.0e+08f)));
}

fn skin_lid_share(position_mm : vec3<f32>, exit_mm : vec3<f32>, penumbra : f32, ramp : f32, lid : vec4<f32>) -> f32
{
    var _S86 : f32 = lid.w;
    var _S87 : vec3<f32> = lid.xyz;
    return skin_smooth((_S86 - dot(_S87, exit_mm)) / penumbra + 0.5f) * saturate((_S86 - dot(_S87, position_mm)) / ramp + 0.5f);
}

fn skin_lid_visibility(position_mm : vec3<f32>, direction : vec3<f32>, spread : f32, margin_mm : f32, upper : vec4<f32>, lower : vec4<f32>, radius_mm : f32) -> f32
{
    var along_1 : f32 = dot(position_mm, direction);
    var distance_2 : f32 = sqrt(max(along_1 * along_1 + (radius_mm * radius_mm - dot(position_mm, position_mm)), 0.0f)) - along_1;
    var exit_mm_1 : vec3<f32> = position_mm + vec3<f32>(distance_2) * direction;
    var _S88 : f32 = max(2.0f * distance_2 * spread, 0.00009999999747379f);
    var _S89 : f32 = max(2.0f * margin_mm, 0.00009999999747379f);
    return skin_lid_share(position_mm, exit_mm_1, _S88, _S89, upper) * skin_lid_share(position_mm, exit_mm_1, _S88, _S89, lower);
}

fn skin_lid_hidden(position_mm : vec3<f32>, normal : vec3<f32>, lid : vec4<f32>, radius_mm : f32) -> f32
{
    var _S90 : vec3<f32> = lid.xyz;
    var toward_0 : f32 = dot(_S90, normal);
    var tangent_0 : f32 = sqrt(max(1.0f - toward_0 * toward_0, 0.00009999999747379f));
    var _S91 : vec3<f32> = vec3<f32>(toward_0);
    var _S92 : vec3<f32> = vec3<f32>(tangent_0);
    var bare_0 : f32 = lid.w - dot(_S90, position_mm);
    var foot_0 : vec3<f32> = position_mm + vec3<f32>(bare_0) * _S90;
    var along_2 : f32 = dot(foot_0, _S92 * normal - _S91 * ((_S90 - _S91 * normal) / _S92));
    var radicand_1 : f32 = along_2 * along_2 - (dot(foot_0, foot_0) - radius_mm * radius_mm);
    var length_0 : f32 = sqrt(max(radicand_1, 0.0f)) - along_2;
    var above_0 : f32 = bare_0 * toward_0 + length_0 * tangent_0;
    var beside_0 : f32 = bare_0 * tangent_0 - length_0 * toward_0;
    var cosine_8 : f32 = beside_0 / max(sqrt(above_0 * above_0 + beside_0 * beside_0), 0.00009999999747379f);
    var _S93 : bool;
    if(above_0 > 0.0f)
    {
        _S93 = radicand_1 > 0.0f;
    }
    else
    {
        _S93 = false;
    }
    var _S94 : f32;
    if(_S93)
    {
        _S94 = 0.5f * (1.0f - cosine_8);
    }
    else
    {
        _S94 = 0.0f;
    }
    return _S94;
}

fn skin_lid_openness(position_mm : vec3<f32>, normal : vec3<f32>, upper : vec4<f32>, lower : vec4<f32>, radius_mm : f32) -> f32
{
    return saturate(1.0f - skin_lid_hidden(position_mm, normal, upper, radius_mm) - skin_lid_hidden(position_mm, normal, lower, radius_mm));
}

fn skin_lid_iris_hidden(position_mm : vec3<f32>, narrowed : f32, lid : vec4<f32>) -> f32
{
    var a_2 : f32 = lid.w - dot(lid.xyz, position_mm) - 0.57999998331069946f * narrowed;
    var width_1 : f32 = 2.58999991416931152f * narrowed;
    return 0.5f * (1.0f - a_2 / sqrt(a_2 * a_2 + width_1 * width_1));
}

fn skin_lid_iris_openness(hit_mm : vec3<f32>, cornea : vec4<f32>, limbus : vec4<f32>, upper : vec4<f32>, lower : vec4<f32>) -> f32
{
    var _S95 : vec2<f32> = hit_mm.xy;
    var _S96 : f32 = limbus.x;
    var squared_1 : f32 = dot(_S95, _S95) / (_S96 * _S96);
    var rim_0 : f32 = squared_1 * squared_1;
    var entry_1 : vec2<f32> = vec2<f32>((0.82999998331069946f + 0.40999999642372131f * rim_0)) * _S95;
    var _S97 : f32 = max(1.0f - 1.12000000476837158f * rim_0, 0.05000000074505806f);
    var position_2 : vec3<f32> = vec3<f32>(entry_1, skin_eye_height(sqrt(dot(entry_1, entry_1)), cornea, limbus));
    return saturate(1.0f - skin_lid_iris_hidden(position_2, _S97, upper) - skin_lid_iris_hidden(position_2, _S97, lower));
}

fn skin_tear_normal(position_mm : vec3<f32>, normal : vec3<f32>, lid : vec4<f32>, height_mm : f32) -> vec3<f32>
{
    var _S98 : vec3<f32> = lid.xyz;
    var sine_2 : f32 = saturate(1.0f - (lid.w - dot(_S98, position_mm)) / max(height_mm, 0.00009999999747379f));
    return skin_unit_vectors(vec3<f32>(sqrt(max(1.0f - sine_2 * sine_2, 0.0f))) * normal - vec3<f32>(sine_2) * skin_unit_vectors(_S98 - vec3<f32>(dot(_S98, normal)) * normal));
}
