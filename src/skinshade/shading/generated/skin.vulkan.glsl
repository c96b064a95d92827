// The skinshade library, generated from shading/*.slang by `python -m codegen`.
const vec2  SKIN_CONTACT_DISK[12] = vec2[](vec2(0.16725532710552216, 0.0), vec2(-0.21519750356674194, 0.19713853299617767), vec2(0.0332011915743351, -0.3783104419708252), vec2(0.27573889493942261, 0.35965254902839661), vec2(-0.51071953773498535, -0.09033908694982529), vec2(0.48873069882392883, -0.31089046597480774), vec2(-0.16532173752784729, 0.61498862504959106), vec2(-0.31931877136230469, -0.61482888460159302), vec2(0.70304751396179199, 0.25675183534622192), vec2(-0.74441087245941162, 0.3072819709777832), vec2(0.36706140637397766, -0.78438889980316162), vec2(0.28072324395179749, 0.89498996734619141));
const vec2  SKIN_SHADOW_DISK_48[48] = vec2[](vec2(0.08340597897768021, 0.0), vec2(-0.10671073943376541, 0.09775578230619431), vec2(0.01636306010186672, -0.1864485889673233), vec2(0.13498826324939728, 0.17606829106807709), vec2(-0.24817833304405212, -0.04389924928545952), vec2(0.2355383038520813, -0.14983019232749939), vec2(-0.07893361896276474, 0.29362913966178894), vec2(-0.15082783997058868, -0.29040983319282532), vec2(0.32788398861885071, 0.11974270641803741), vec2(-0.34179624915122986, 0.14108851552009583), vec2(0.16510665416717529, -0.35282331705093384), vec2(0.12226484715938568, 0.38979959487915039), vec2(-0.36929354071617126, -0.21401314437389374), vec2(0.4341655969619751, -0.09545008838176727), vec2(-0.2655525803565979, 0.37772122025489807), vec2(-0.06148780882358551, -0.47449716925621033), vec2(0.37834861874580383, 0.31887263059616089), vec2(-0.51034331321716309, 0.02110430039465427), vec2(0.37315717339515686, -0.37134122848510742), vec2(-0.02502750046551228, 0.54124277830123901), vec2(-0.3568427562713623, -0.42761686444282532), vec2(0.56674838066101074, 0.0762551873922348), vec2(-0.48148587346076965, 0.33500534296035767), vec2(0.13193005323410034, -0.58644229173660278), vec2(0.30600649118423462, 0.53402209281921387), vec2(-0.59994620084762573, -0.1913992166519165), vec2(0.58451014757156372, -0.27005851268768311), vec2(-0.25400349497795105, 0.60692840814590454), vec2(-0.22741274535655975, -0.63226538896560669), vec2(0.60710901021957397, 0.31907948851585388), vec2(-0.6766400933265686, 0.17836016416549683), vec2(0.38596493005752563, -0.60026413202285767), vec2(0.12322843074798584, 0.71703100204467773), vec2(-0.58622837066650391, -0.45400822162628174), vec2(0.75288873910903931, -0.06237528845667839), vec2(-0.52258288860321045, 0.56489682197570801), vec2(0.0038233099039644, -0.78373259305953979), vec2(0.53622621297836304, 0.59111112356185913), vec2(-0.80917233228683472, -0.07499390840530396), vec2(0.65910446643829346, -0.50023680925369263), vec2(-0.15080370008945465, 0.82895052433013916), vec2(-0.45701694488525391, -0.72624564170837402), vec2(0.84303575754165649, 0.23104114830493927), vec2(-0.79258495569229126, 0.40674149990081787), vec2(0.31582745909690857, -0.85189038515090942), vec2(0.34976369142532349, 0.85918575525283813), vec2(-0.85765814781188965, -0.40646019577980042), vec2(0.93254464864730835, -0.28751349449157715));
const vec2  SKIN_SHADOW_DISK_16[16] = vec2[](vec2(0.14471825957298279, 0.0), vec2(-0.18583981692790985, 0.170244500041008), vec2(0.02860930934548378, -0.32598838210105896), vec2(0.23701368272304535, 0.30914238095283508), vec2(-0.43773865699768066, -0.07742980122566223), vec2(0.41749045252799988, -0.26557326316833496), vec2(-0.14065909385681152, 0.52324479818344116), vec2(-0.27035140991210938, -0.52054518461227417), vec2(0.59152573347091675, 0.21602423489093781), vec2(-0.6210860013961792, 0.25637525320053101), vec2(0.30247461795806885, -0.64637070894241333), vec2(0.22609943151473999, 0.72084063291549683), vec2(-0.69051814079284668, -0.40016940236091614), vec2(0.82290405035018921, -0.18091315031051636), vec2(-0.5123591423034668, 0.7287781834602356), vec2(-0.12196926772594452, -0.94122844934463501));
const vec2  SKIN_POISSON_32[32] = vec2[](vec2(-0.02096010930836201, 0.01299272011965513), vec2(0.69517123699188232, -0.04910685122013092), vec2(0.28034570813179016, 0.66283899545669556), vec2(0.03107489086687565, -0.69704329967498779), vec2(-0.49904009699821472, 0.54098159074783325), vec2(-0.70408397912979126, -0.14709833264350891), vec2(0.53451526165008545, -0.56702268123626709), vec2(-0.48678380250930786, -0.61486828327178955), vec2(0.68837428092956543, 0.41418349742889404), vec2(-0.14107078313827515, 0.8102262020111084), vec2(0.21897397935390472, -0.3123532235622406), vec2(0.31406453251838684, 0.24951401352882385), vec2(-0.83115619421005249, 0.28457203507423401), vec2(-0.40699386596679688, 0.14198443293571472), vec2(-0.10747358947992325, 0.41360348463058472), vec2(-0.19334819912910461, -0.34689420461654663), vec2(0.80768358707427979, -0.37000563740730286), vec2(0.33436411619186401, -0.82407790422439575), vec2(-0.79105347394943237, -0.45378401875495911), vec2(-0.23485180735588074, -0.86940687894821167), vec2(0.37255629897117615, -0.05855973064899445), vec2(0.5726354718208313, 0.72984015941619873), vec2(0.8966706395149231, 0.17047682404518127), vec2(-0.43273070454597473, 0.81860679388046265), vec2(0.1212853416800499, 0.92984902858734131), vec2(-0.42749753594398499, -0.15111121535301208), vec2(-0.94129812717437744, 0.00735718011856079), vec2(0.52211439609527588, -0.28702935576438904), vec2(-0.79033631086349487, 0.5402228832244873), vec2(-0.23410981893539429, -0.59940856695175171), vec2(0.28244560956954956, -0.563071608543396), vec2(0.57051312923431396, 0.18359191715717316));
const vec2  SKIN_POISSON_8[8] = vec2[](vec2(-0.16089901328086853, -0.04573699831962585), vec2(-0.89243310689926147, 0.18877510726451874), vec2(-0.17830690741539001, 0.7200586199760437), vec2(-0.53433239459991455, -0.70478206872940063), vec2(0.22474820911884308, -0.69165337085723877), vec2(0.5559992790222168, 0.1985180526971817), vec2(0.64686292409896851, -0.3364911675453186), vec2(0.33836102485656738, 0.67131179571151733));
float skin_saturate_0(float x)
{
    return clamp(x, 0.0, 1.0);
}

vec3 skin_saturate_1(vec3 x)
{
    return clamp(x, vec3(0.0), vec3(1.0));
}

vec2 skin_saturate_2(vec2 x)
{
    return clamp(x, vec2(0.0), vec2(1.0));
}

float skin_map_level(vec2 map_extent, vec2 uv_along_x, vec2 uv_along_y)
{
    vec2 texels_x_0 = uv_along_x * map_extent;
    vec2 texels_y_0 = uv_along_y * map_extent;
    float x_3 = dot(texels_x_0, texels_x_0);
    float y_0 = dot(texels_y_0, texels_y_0);
    return max(0.5 * log2(max(max(min(x_3, y_0), max(x_3, y_0) / 64.0), 1.00000000317107685e-30)), 0.0);
}

float skin_blur_level(float sigma_mm, float uv_scale_mm, float map_size, float hardware_level)
{
    return max(hardware_level, log2(max(2.0 * sigma_mm * map_size / uv_scale_mm, 1.0)));
}

vec3 skin_weighted_sum(mat3x3 rows, vec3 weights)
{
    return weights.x * rows[0] + weights.y * rows[1] + weights.z * rows[2];
}

mat3x3 skin_blend_normals(mat3x3 fetched, mat3x3 blend)
{
    return mat3x3(skin_weighted_sum(fetched, blend[0]), skin_weighted_sum(fetched, blend[1]), skin_weighted_sum(fetched, blend[2]));
}

float skin_safe_length(vec3 v)
{
    return sqrt(max(dot(v, v), 1.00000004581370497e-18));
}

vec3 skin_with_mesh_diffusion(vec3 from_texture, vec3 from_mesh, vec3 mesh_normal)
{
    return from_texture + skin_safe_length(from_texture) * (from_mesh - mesh_normal);
}

mat3x3 skin_add_mesh_diffusion(mat3x3 from_texture, mat3x3 from_mesh, vec3 mesh_normal)
{
    return mat3x3(skin_with_mesh_diffusion(from_texture[0], from_mesh[0], mesh_normal), skin_with_mesh_diffusion(from_texture[1], from_mesh[1], mesh_normal), skin_with_mesh_diffusion(from_texture[2], from_mesh[2], mesh_normal));
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

vec3 skin_curvature_table(texture2D lut, sampler lut_sampler, vec4 lut_axes, vec3 cos_theta, float curvature_per_mm)
{
    float row_0 = sqrt(max(curvature_per_mm, 0.0));
    vec2 _S3 = lut_axes.xz;
    vec2 _S4 = lut_axes.yw;
    return vec3((textureLod(sampler2D(lut,lut_sampler), (skin_saturate_2((vec2(cos_theta.x, row_0) - _S3) * _S4)), (0.0))).xyz.x, (textureLod(sampler2D(lut,lut_sampler), (skin_saturate_2((vec2(cos_theta.y, row_0) - _S3) * _S4)), (0.0))).xyz.y, (textureLod(sampler2D(lut,lut_sampler), (skin_saturate_2((vec2(cos_theta.z, row_0) - _S3) * _S4)), (0.0))).xyz.z);
}

vec3 skin_relief_light(vec3 lengths, vec3 cos_theta)
{
    vec3 slope_0 = sqrt(max(- log(clamp(lengths, vec3(0.00100000004749745), vec3(1.0))) * (1.0 - cos_theta * cos_theta), vec3(0.0)));
    return vec3(skin_relief_bump(lengths.x * cos_theta.x, slope_0.x), skin_relief_bump(lengths.y * cos_theta.y, slope_0.y), skin_relief_bump(lengths.z * cos_theta.z, slope_0.z));
}

vec3 skin_direct_scalar(texture2D lut, sampler lut_sampler, vec4 lut_axes, mat3x3 normals, vec3 light, float curvature_per_mm, vec3 gain)
{
    vec3 lengths_2 = skin_lengths(normals);
    vec3 cos_theta_2 = skin_cosines(normals, light, lengths_2);
    return gain * (lengths_2 * skin_curvature_table(lut, lut_sampler, lut_axes, cos_theta_2, abs(curvature_per_mm)) + skin_relief_light(lengths_2, cos_theta_2));
}

vec3 skin_transfer(texture2D transfer, sampler transfer_sampler, vec4 transfer_axes, float k_per_mm)
{
    return (textureLod(sampler2D(transfer,transfer_sampler), (skin_saturate_2((vec2(sqrt(max(k_per_mm, 0.0)), 0.5) - transfer_axes.xz) * transfer_axes.yw)), (0.0))).xyz;
}

vec3 skin_direct_tensor(texture2D lut, sampler lut_sampler, vec4 lut_axes, texture2D transfer, sampler transfer_sampler, vec4 transfer_axes, mat3x3 normals, vec3 light, float directional_per_mm, float total_per_mm, vec3 gain)
{
    vec3 lengths_3 = skin_lengths(normals);
    vec3 cos_theta_3 = skin_cosines(normals, light, lengths_3);
    return gain * (lengths_3 * (skin_curvature_table(lut, lut_sampler, lut_axes, cos_theta_3, directional_per_mm) * skin_transfer(transfer, transfer_sampler, transfer_axes, sqrt(max((total_per_mm - directional_per_mm) * (total_per_mm + directional_per_mm), 0.0)))) + skin_relief_light(lengths_3, cos_theta_3));
}

vec3 skin_direct_diffused_normals(texture2D lut, sampler lut_sampler, vec4 lut_axes, texture2D transfer, sampler transfer_sampler, vec4 transfer_axes, mat3x3 normals, vec3 relief_length, vec3 light, float directional_per_mm, vec3 gain)
{
    vec3 lengths_4 = skin_lengths(normals);
    vec3 cos_theta_4 = skin_cosines(normals, light, lengths_4);
    return gain * (skin_curvature_table(lut, lut_sampler, lut_axes, cos_theta_4, directional_per_mm) * min(lengths_4 / max(skin_transfer(transfer, transfer_sampler, transfer_axes, directional_per_mm), vec3(9.99999997475242708e-07)), vec3(1.0)) + skin_relief_light(relief_length, cos_theta_4));
}

vec3 skin_relief_length(texture2D transfer, sampler transfer_sampler, vec4 transfer_axes, mat3x3 from_texture, mat3x3 from_mesh, float total_per_mm)
{
    return skin_lengths(from_texture) * min(skin_lengths(from_mesh) / max(0.97500002384185791 * skin_transfer(transfer, transfer_sampler, transfer_axes, total_per_mm), vec3(9.99999997475242708e-07)), vec3(1.0));
}

vec2 skin_directional_curvature(mat3x3 tensor_world, vec3 normal, vec3 light)
{
    vec3 tangential_0 = light - normal * dot(light, normal);
    vec3 change_0 = vec3(dot(tensor_world[0], tangential_0), dot(tensor_world[1], tangential_0), dot(tensor_world[2], tangential_0));
    float total_0 = sqrt(dot(tensor_world[0], tensor_world[0]) + dot(tensor_world[1], tensor_world[1]) + dot(tensor_world[2], tensor_world[2]));
    return vec2(min(sqrt(dot(change_0, change_0) / max(dot(tangential_0, tangential_0), 9.999999960041972e-13)), total_0), total_0);
}

vec3 skin_energy_gain(vec3 albedo, vec3 rms_radius_mm, vec3 curvature_per_mm)
{
    vec3 scaled_curvature_0 = 1.20000004768371582 * rms_radius_mm * max(curvature_per_mm, vec3(0.0));
    vec3 bound_0 = albedo * scaled_curvature_0;
    return 1.0 + (1.0 - albedo) * scaled_curvature_0 / sqrt(1.0 + bound_0 * bound_0);
}

vec3 skin_root_absorption(vec3 albedo)
{
    vec3 bounded_0 = skin_saturate_1(albedo);
    vec3 s_1 = 6.0 * (1.0 - bounded_0) / (7.0 + sqrt(25.0 + 24.0 * bounded_0));
    return s_1 / (1.0 - s_1);
}

float skin_inner_cosine(float cosine, float inverse_ior)
{
    return sqrt(max(1.0 - (1.0 - cosine * cosine) * inverse_ior * inverse_ior, 0.0));
}

vec3 skin_mean_escape(vec3 slope, float low, float high)
{
    return (1.0 + slope * (0.36391723155975342 * high + 0.63608276844024658 * low)) / ((1.0 + slope * low) * (1.0 + slope * high));
}

vec3 skin_view_factor(vec3 albedo, float n_dot_v, float reflectance)
{
    float root_0 = sqrt(clamp(reflectance, 0.0, 0.89999997615814209));
    float inverse_ior_1 = (1.0 - root_0) / (1.0 + root_0);
    vec3 slope_2 = 2.0 * skin_root_absorption(albedo);
    return 1.0 / ((1.0 + slope_2 * skin_inner_cosine(skin_saturate_0(n_dot_v), inverse_ior_1)) * skin_mean_escape(slope_2, skin_inner_cosine(0.35505104064941406, inverse_ior_1), skin_inner_cosine(0.84494894742965698, inverse_ior_1)));
}

vec3 skin_closure_view_factor(vec3 albedo, float n_dot_v)
{
    vec3 slope_3 = 2.0 * skin_root_absorption(albedo);
    vec3 diffuse_0 = skin_mean_escape(slope_3, 0.35505104064941406, 0.84494894742965698);
    return (diffuse_0 + 1.0 / (1.0 + slope_3 * (0.12999999523162842 + 0.75 * skin_saturate_0(n_dot_v)))) / (diffuse_0 + skin_mean_escape(slope_3, 0.39628827571868896, 0.76371169090270996));
}

float skin_linear_depth(float depth, mat4x4 projection)
{
    return abs((depth * projection[3][3] - projection[2][3]) / (projection[2][2] - depth * projection[3][2]));
}

vec3 skin_inward_offset(vec3 position_mm, vec3 normal, float offset_mm)
{
    return position_mm - normal * offset_mm;
}

float skin_thickness(texture2D depth_map, sampler depth_map_sampler, mat4x4 projection, vec2 uv, float receiver_mm, vec2 radius_uv, int taps)
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
        vec2 offset_0;
        if(taps == 8)
        {
            offset_0 = SKIN_POISSON_8[min(tap_0, 7)];
        }
        else
        {
            offset_0 = SKIN_POISSON_32[min(tap_0, 31)];
        }
        float total_2 = total_1 + max(receiver_mm - skin_linear_depth((textureLod(sampler2D(depth_map,depth_map_sampler), (uv + offset_0 * radius_uv), (0.0))).x, projection), 0.0);
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
    float t_0 = thickness_mm / radius_mm;
    return exp(-0.5 * t_0 * t_0);
}

vec3 skin_direct_deep_scatter(vec3 transmitted, float n_dot_l, float strength)
{
    return strength * transmitted * max(- n_dot_l, 0.0);
}

vec3 skin_through_beyond(vec3 through, vec3 diffused)
{
    return max(through - diffused, vec3(0.0));
}

vec3 skin_ambient_deep_scatter(vec3 transmitted, vec3 irradiance_behind, float strength)
{
    return strength * transmitted * irradiance_behind;
}

float skin_smoothstep(float p)
{
    float q_0 = skin_saturate_0(p);
    return q_0 * q_0 * (3.0 - 2.0 * q_0);
}

vec4 skin_light_coordinates(vec3 position_mm, mat4x4 view, mat4x4 projection)
{
    vec4 p_1 = vec4(position_mm, 1.0);
    float _S5 = dot(view[2], p_1);
    vec4 in_view_0 = vec4(dot(view[0], p_1), dot(view[1], p_1), _S5, 1.0);
    float w_0 = dot(projection[3], in_view_0);
    float w_1;
    if((abs(w_0)) < 9.99999971718068537e-10)
    {
        w_1 = 9.99999971718068537e-10;
    }
    else
    {
        w_1 = w_0;
    }
    return vec4(0.5 + 0.5 * (dot(projection[0], in_view_0) / w_1), 0.5 - 0.5 * (dot(projection[1], in_view_0) / w_1), abs(_S5), w_1);
}

vec3 skin_unit_vectors(vec3 v)
{
    return v / skin_safe_length(v);
}

vec3 skin_shadow_receiver(vec3 position_mm, vec3 normal, vec3 to_light, float curvature_per_mm)
{
    float cosine_1 = dot(normal, to_light);
    return position_mm + skin_unit_vectors(to_light - normal * cosine_1) * min(max(- cosine_1, 0.0) / max(curvature_per_mm, 0.00100000004749745), 8.0);
}

vec2 skin_plane_slope(vec3 normal, vec3 to_light, vec3 light_right, vec3 light_up, float least_cosine)
{
    vec3 axis_0 = cross(light_right, light_up);
    float handedness_0;
    if((dot(to_light, axis_0)) < 0.0)
    {
        handedness_0 = -1.0;
    }
    else
    {
        handedness_0 = 1.0;
    }
    return vec2(dot(normal, light_right), - dot(normal, light_up)) / max(handedness_0 * dot(normal, axis_0), least_cosine);
}

vec2 skin_shadow_slope(vec3 normal, vec3 to_light, float curvature_per_mm, vec3 light_right, vec3 light_up)
{
    vec2 slope_4 = skin_plane_slope(skin_unit_vectors(normal + to_light * max(- dot(normal, to_light), 0.0)), to_light, light_right, light_up, 0.00100000004749745);
    return slope_4 / max(length(slope_4) / (1.0 + 7.0 * skin_saturate_0(1.0 + curvature_per_mm / 0.03999999910593033)), 1.0);
}

float skin_shadow_occluder_depth(float depth_mm, float faces_light)
{
    return depth_mm + 4.0 * faces_light;
}

float skin_shadow_compare(texture2D depth_map, sampler depth_map_sampler, vec2 map_extent, mat4x4 projection, vec2 uv, float receiver_mm)
{
    vec2 position_0 = uv * map_extent - 0.5;
    vec2 corner_0 = floor(position_0);
    vec2 weights_1 = position_0 - corner_0;
    const vec2 _S6 = vec2(0.0);
    vec2 _S7 = map_extent - 1.0;
    vec2 low_1 = (clamp(corner_0, _S6, _S7) + 0.5) / map_extent;
    vec2 high_1 = (clamp(corner_0 + 1.0, _S6, _S7) + 0.5) / map_extent;
    vec4 lit_0 = step(vec4(receiver_mm, receiver_mm, receiver_mm, receiver_mm), vec4(skin_linear_depth((textureLod(sampler2D(depth_map,depth_map_sampler), (low_1), (0.0))).x, projection), skin_linear_depth((textureLod(sampler2D(depth_map,depth_map_sampler), (vec2(high_1.x, low_1.y)), (0.0))).x, projection), skin_linear_depth((textureLod(sampler2D(depth_map,depth_map_sampler), (vec2(low_1.x, high_1.y)), (0.0))).x, projection), skin_linear_depth((textureLod(sampler2D(depth_map,depth_map_sampler), (high_1), (0.0))).x, projection)));
    vec2 rows_1 = mix(lit_0.xz, lit_0.yw, vec2(weights_1.x));
    return mix(rows_1.x, rows_1.y, weights_1.y);
}

float skin_shadow_filter(texture2D depth_map, sampler depth_map_sampler, vec2 map_extent, mat4x4 view, mat4x4 projection, vec3 position_mm, vec3 normal, vec3 to_light, float curvature_per_mm, float filter_width_mm, float bias_mm, int taps)
{
    vec4 coordinates_0 = skin_light_coordinates(skin_shadow_receiver(position_mm, normal, to_light, curvature_per_mm), view, projection);
    vec2 _S8 = skin_shadow_slope(normal, to_light, curvature_per_mm, view[0].xyz, view[1].xyz);
    vec2 _S9 = 0.5 * vec2(abs(projection[0].x), abs(projection[1].y)) / abs(coordinates_0.w);
    int tap_1 = 0;
    float total_3 = 0.0;
    for(;;)
    {
        if(tap_1 < taps)
        {
        }
        else
        {
            break;
        }
        vec2 disk_0;
        if(taps == 16)
        {
            disk_0 = SKIN_SHADOW_DISK_16[min(tap_1, 15)];
        }
        else
        {
            disk_0 = SKIN_SHADOW_DISK_48[min(tap_1, 47)];
        }
        vec2 across_mm_0 = 0.5 * filter_width_mm * disk_0;
        float total_4 = total_3 + skin_shadow_compare(depth_map, depth_map_sampler, map_extent, projection, coordinates_0.xy + across_mm_0 * _S9, coordinates_0.z - bias_mm + dot(_S8, across_mm_0));
        tap_1 = tap_1 + 1;
        total_3 = total_4;
    }
    return total_3 / float(max(taps, 1));
}

vec3 skin_diffused_shadow(texture2D lut, sampler lut_sampler, vec4 lut_axes, float shadow_filter, float n_dot_l, float filter_width_mm)
{
    return (textureLod(sampler2D(lut,lut_sampler), (skin_saturate_2((vec2(shadow_filter, max(n_dot_l, 0.05000000074505806) / filter_width_mm) - lut_axes.xz) * lut_axes.yw)), (0.0))).xyz;
}

float skin_sharpened_shadow(float shadow_filter, float sharpening)
{
    return skin_smoothstep((0.5 - sin(asin(1.0 - 2.0 * skin_saturate_0(shadow_filter)) / 3.0) - 0.5) * sharpening + 0.5);
}

float skin_variance_shadow(float mean_depth_mm, float mean_square_depth_mm2, float depth_mm)
{
    float _S10 = max(mean_square_depth_mm2 - mean_depth_mm * mean_depth_mm, 0.00999999977648258);
    float _S11 = max(depth_mm - mean_depth_mm, 0.0);
    return _S10 / (_S10 + _S11 * _S11);
}

vec2 skin_contact_slope(vec3 face_normal, vec3 to_light, vec3 light_right, vec3 light_up)
{
    return skin_plane_slope(face_normal, to_light, light_right, light_up, 0.05000000074505806);
}

float skin_faded_contact(float share, float cosine)
{
    return 1.0 - skin_saturate_0((cosine - 0.05000000074505806) / 0.10000000894069672) * (1.0 - share);
}

float skin_contact_bias(vec2 slope)
{
    return 0.80000001192092896 + 0.30000001192092896 * length(slope);
}

float skin_contact_compare(vec4 depths, float receiver_mm, vec2 rise, vec2 weights)
{
    float _S12 = rise.x;
    float _S13 = rise.y;
    vec4 lit_1 = step(receiver_mm + vec4(0.0, _S12, _S13, _S12 + _S13), depths);
    vec2 rows_2 = mix(lit_1.xz, lit_1.yw, vec2(weights.x));
    return mix(rows_2.x, rows_2.y, weights.y);
}

float skin_contact_filter(texture2D depth_map, sampler depth_map_sampler, vec2 map_extent, mat4x4 view, mat4x4 projection, vec3 position_mm, vec3 face_normal, vec3 to_light)
{
    vec4 coordinates_1 = skin_light_coordinates(position_mm, view, projection);
    vec2 slope_6 = skin_contact_slope(face_normal, to_light, view[0].xyz, view[1].xyz);
    vec2 texels_per_mm_0 = 0.5 * vec2(abs(projection[0].x), abs(projection[1].y)) / abs(coordinates_1.w) * map_extent;
    vec2 _S14 = slope_6 / texels_per_mm_0;
    vec2 _S15 = coordinates_1.xy * map_extent - 0.5;
    float _S16 = coordinates_1.z - skin_contact_bias(slope_6);
    int tap_2 = 0;
    float total_5 = 0.0;
    for(;;)
    {
        if(tap_2 < 12)
        {
        }
        else
        {
            break;
        }
        vec2 position_1 = _S15 + 0.60000002384185791 * SKIN_CONTACT_DISK[tap_2] * texels_per_mm_0;
        vec2 corner_1 = floor(position_1);
        const vec2 _S17 = vec2(0.0);
        vec2 _S18 = map_extent - 1.0;
        vec2 low_2 = (clamp(corner_1, _S17, _S18) + 0.5) / map_extent;
        vec2 high_2 = (clamp(corner_1 + 1.0, _S17, _S18) + 0.5) / map_extent;
        float total_6 = total_5 + skin_contact_compare(vec4(skin_linear_depth((textureLod(sampler2D(depth_map,depth_map_sampler), (low_2), (0.0))).x, projection), skin_linear_depth((textureLod(sampler2D(depth_map,depth_map_sampler), (vec2(high_2.x, low_2.y)), (0.0))).x, projection), skin_linear_depth((textureLod(sampler2D(depth_map,depth_map_sampler), (vec2(low_2.x, high_2.y)), (0.0))).x, projection), skin_linear_depth((textureLod(sampler2D(depth_map,depth_map_sampler), (high_2), (0.0))).x, projection)), _S16 + dot(corner_1 - _S15, _S14), _S14, position_1 - corner_1);
        tap_2 = tap_2 + 1;
        total_5 = total_6;
    }
    return skin_faded_contact(total_5 / 12.0, dot(face_normal, to_light));
}

vec3 skin_contact_shadow(texture2D lut, sampler lut_sampler, vec4 lut_axes, vec3 shadow, float contact, float filter_width_mm)
{
    return min(shadow, contact + (1.0 - contact) * skin_diffused_shadow(lut, lut_sampler, lut_axes, skin_smoothstep(0.5 - 0.60000002384185791 / filter_width_mm), 1.0, filter_width_mm));
}

vec3 skin_sh_bands(mat3x3 sh, vec3 d)
{
    float _S19 = d.y;
    float _S20 = d.z;
    float _S21 = d.x;
    return vec3(0.282094806432724 * sh[0].x, 0.48860251903533936 * (sh[0].y * _S19 + sh[0].z * _S20 + sh[1].x * _S21), 1.09254848957061768 * (sh[1].y * _S21 * _S19 + sh[1].z * _S19 * _S20 + sh[2].y * _S21 * _S20) + 0.31539157032966614 * sh[2].x * (3.0 * _S20 * _S20 - dot(d, d)) + 0.54627424478530884 * sh[2].z * (_S21 * _S21 - _S19 * _S19));
}

float skin_ambient_channel(mat3x3 sh, vec3 normal, vec3 band_transfer)
{
    return max(dot(skin_sh_bands(sh, normal), vec3(1.0, 1.0, skin_safe_length(normal)) * band_transfer * vec3(1.0, 0.66666668653488159, 0.25)), 0.0);
}

vec3 skin_ambient_irradiance(mat3x3 radiance_sh_red, mat3x3 radiance_sh_green, mat3x3 radiance_sh_blue, mat3x3 normals, mat3x3 band_transfer)
{
    mat3x3 t_1 = transpose(band_transfer);
    return vec3(skin_ambient_channel(radiance_sh_red, normals[0], t_1[0]), skin_ambient_channel(radiance_sh_green, normals[1], t_1[1]), skin_ambient_channel(radiance_sh_blue, normals[2], t_1[2]));
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

float skin_sh_product(mat3x3 a, mat3x3 b)
{
    return dot(a[0], b[0]) + dot(a[1], b[1]) + dot(a[2], b[2]);
}

vec3 skin_transferred_irradiance(mat3x3 ambient_transfer_red, mat3x3 ambient_transfer_green, mat3x3 ambient_transfer_blue, mat3x3 radiance_sh_red, mat3x3 radiance_sh_green, mat3x3 radiance_sh_blue)
{
    return max(vec3(skin_sh_product(ambient_transfer_red, radiance_sh_red), skin_sh_product(ambient_transfer_green, radiance_sh_green), skin_sh_product(ambient_transfer_blue, radiance_sh_blue)), vec3(0.0));
}

float skin_reflected_visibility(mat3x3 sky_harmonics, vec3 normal, vec3 direction)
{
    vec3 bands_0 = skin_sh_bands(sky_harmonics, direction);
    float _S22 = max(dot(normal, direction), 0.0);
    return skin_saturate_0((bands_0.x + bands_0.y + bands_0.z) / ((0.375 + _S22 * (2.0 + 1.875 * _S22)) * 0.07957746833562851));
}

vec3 skin_occluded_reflection(vec3 sky, vec3 bounced, mat3x3 sky_harmonics, vec3 normal, vec3 direction)
{
    return mix(bounced / max(1.0 - sky_harmonics[0].x / 0.282094806432724, 0.01999999955296516), sky, vec3(skin_reflected_visibility(sky_harmonics, normal, direction)));
}

float skin_specular_visibility(float n_dot_v, float visibility, float roughness)
{
    float exponent_0 = (exp2((-16.0 * roughness - 1.0)));
    float base_0 = n_dot_v + visibility;
    float power_0;
    if(base_0 > 0.0)
    {
        power_0 = pow(base_0, exponent_0);
    }
    else
    {
        power_0 = 0.0;
    }
    return skin_saturate_0(power_0 - 1.0 + visibility);
}

float skin_specular_power(float gloss)
{
    return (exp2((13.0 * gloss)));
}

float skin_gloss_of_relief(float gloss, float normal_length)
{
    float clamped_length_0 = clamp(normal_length, 0.00100000004749745, 1.0);
    float power_1 = skin_specular_power(gloss);
    return log2(max(clamped_length_0 * power_1 / (clamped_length_0 + power_1 * (1.0 - clamped_length_0)), 1.0)) / 13.0;
}

float skin_gloss_from_roughness(float roughness)
{
    float _S23 = max(roughness, 0.00100000004749745);
    float r2_0 = _S23 * _S23;
    return clamp(log2(max(2.0 / (r2_0 * r2_0) - 2.0, 1.0)) / 13.0, 0.0, 1.0);
}

float skin_lobe(float n_dot_h, float n_dot_l, float n_dot_v, float power)
{
    float k_0 = (inversesqrt((3.14159274101257324 * power / 4.0 + 1.57079637050628662)));
    float _S24 = 1.0 - k_0;
    return (power + 2.0) / 6.28318548202514648 * pow(max(n_dot_h, 9.99999971718068537e-10), power) * (0.25 / ((k_0 + _S24 * n_dot_l) * (k_0 + _S24 * n_dot_v)));
}

float skin_specular(vec3 normal, vec3 view, vec3 light, float gloss, float reflectance)
{
    vec3 half_vector_0 = skin_unit_vectors(view + light);
    float n_dot_l_3 = skin_saturate_0(dot(normal, light));
    float n_dot_v_4 = clamp(dot(normal, view), 0.00009999999747379, 1.0);
    float n_dot_h_1 = skin_saturate_0(dot(normal, half_vector_0));
    float wide_0 = skin_specular_power(gloss);
    float grazing_0 = 1.0 - skin_saturate_0(dot(view, half_vector_0));
    float grazing2_0 = grazing_0 * grazing_0;
    return 3.14159274101257324 * (0.94999998807907104 * skin_lobe(n_dot_h_1, n_dot_l_3, n_dot_v_4, wide_0) + 0.05000000074505806 * skin_lobe(n_dot_h_1, n_dot_l_3, n_dot_v_4, min(wide_0 * wide_0, 8192.0))) * (reflectance + (1.0 - reflectance) * grazing2_0 * grazing2_0 * grazing_0) * n_dot_l_3;
}

vec3 skin_reflected(vec3 normal, vec3 view)
{
    return 2.0 * dot(normal, view) * normal - view;
}

float skin_ambient_specular_fresnel(float n_dot_v, float gloss, float reflectance)
{
    float grazing_1 = 1.0 - skin_saturate_0(n_dot_v);
    float grazing2_1 = grazing_1 * grazing_1;
    return reflectance + (1.0 - reflectance) * grazing2_1 * grazing2_1 * grazing_1 / (4.0 - 3.0 * gloss);
}

float skin_diffuse_share(float n_dot_v, float gloss, float reflectance)
{
    return 1.0 - skin_ambient_specular_fresnel(n_dot_v, gloss, reflectance);
}

float skin_alpha_from_gloss(float gloss)
{
    return sqrt(2.0 / (skin_specular_power(gloss) + 2.0));
}

float skin_second_gloss(float gloss)
{
    return min(2.0 * gloss, 1.0);
}

float skin_coat_fresnel(float cosine, float reflectance)
{
    float root_1 = sqrt(clamp(reflectance, 0.0, 0.89999997615814209));
    float _S25 = 1.0 - root_1;
    float excess_0 = 4.0 * root_1 / (_S25 * _S25);
    float _S26 = max(sqrt(excess_0 + cosine * cosine) + cosine, 9.99999971718068537e-10);
    float across_0 = excess_0 / (_S26 * _S26);
    float along_0 = (cosine * _S26 - 1.0) / (cosine * excess_0 / _S26 + 1.0);
    return 0.5 * across_0 * across_0 * (1.0 + along_0 * along_0);
}

float skin_coat_highlight(vec3 normal, vec3 view, vec3 light, float gloss, float reflectance)
{
    vec3 half_vector_1 = skin_unit_vectors(view + light);
    float n_dot_l_4 = skin_saturate_0(dot(normal, light));
    float n_dot_v_7 = clamp(dot(normal, view), 0.00009999999747379, 1.0);
    float n_dot_h_2 = skin_saturate_0(dot(normal, half_vector_1));
    float v_dot_h_0 = skin_saturate_0(dot(view, half_vector_1));
    float squared_0 = 2.0 / (skin_specular_power(gloss) + 2.0);
    vec3 side_0 = cross(normal, half_vector_1);
    float sine2_0;
    if(n_dot_h_2 > 0.0)
    {
        sine2_0 = dot(side_0, side_0);
    }
    else
    {
        sine2_0 = 1.0;
    }
    float root_2 = squared_0 / (n_dot_h_2 * n_dot_h_2 * squared_0 + sine2_0);
    float _S27 = 1.0 - squared_0;
    return root_2 * root_2 / squared_0 * (0.5 / (n_dot_l_4 * sqrt(n_dot_v_7 * n_dot_v_7 * _S27 + squared_0) + n_dot_v_7 * sqrt(n_dot_l_4 * n_dot_l_4 * _S27 + squared_0))) * skin_coat_fresnel(v_dot_h_0, reflectance) * n_dot_l_4;
}

vec2 skin_coat(texture2D lut, sampler lut_sampler, vec4 lut_axes, float n_dot_v, float gloss, float reflectance, float coat_reflectance)
{
    vec3 entry_0 = (textureLod(sampler2D(lut,lut_sampler), (skin_saturate_2((vec2(sqrt(skin_saturate_0(n_dot_v)), gloss) - lut_axes.xz) * lut_axes.yw)), (0.0))).xyz;
    float _S28 = entry_0.z;
    return vec2(clamp(_S28 + (1.0 - reflectance) / (1.0 - coat_reflectance) * (entry_0.x - _S28), 0.0, _S28), entry_0.y);
}

vec3 skin_coat_direction(vec3 normal, vec3 view, float pull)
{
    vec3 mirrored_0 = skin_reflected(normal, view);
    return skin_unit_vectors(mirrored_0 + pull * (normal - mirrored_0));
}

float skin_turns(float y, float x)
{
    vec2 size_0 = abs(vec2(x, y));
    float _S29 = size_0.x;
    float _S30 = size_0.y;
    float r_0 = min(_S29, _S30) / max(max(_S29, _S30), 1.00000000317107685e-30);
    float r2_1 = r_0 * r_0;
    float turns_0 = r_0 * (0.15915107727050781 + r2_1 * (-0.05293257534503937 + r2_1 * (0.03076364658772945 + r2_1 * (-0.01842727139592171 + r2_1 * (0.00826387945562601 - r2_1 * 0.00181874714326113)))));
    float turns_1;
    if(_S30 > _S29)
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
    float _S31 = direction.x;
    float _S32 = direction.z;
    return vec2(0.5 + skin_turns(_S32, _S31), 2.0 * skin_turns(sqrt(_S31 * _S31 + _S32 * _S32), direction.y));
}

float skin_reflection_level(float power)
{
    return clamp(0.5 * log2(max(power, 1.0)), 0.0, 4.0);
}

vec3 skin_preconvolved(texture2D preconvolved, sampler preconvolved_sampler, vec2 uv, float power)
{
    float level_0 = skin_reflection_level(power);
    float _S33 = min(floor(level_0), 3.0);
    float row_1 = clamp(uv.y, 0.0078125, 0.9921875);
    float _S34 = uv.x;
    return mix((textureLod(sampler2D(preconvolved,preconvolved_sampler), (vec2(_S34, (_S33 + row_1) / 5.0)), (0.0))).xyz, (textureLod(sampler2D(preconvolved,preconvolved_sampler), (vec2(_S34, (_S33 + 1.0 + row_1) / 5.0)), (0.0))).xyz, vec3(level_0 - _S33));
}

vec3 skin_reflected_radiance(texture2D preconvolved, sampler preconvolved_sampler, vec3 direction, float gloss)
{
    vec2 uv_3 = skin_equirectangular_uv(direction);
    float power_5 = skin_specular_power(gloss);
    return mix(skin_preconvolved(preconvolved, preconvolved_sampler, uv_3, power_5 / 4.0), skin_preconvolved(preconvolved, preconvolved_sampler, uv_3, power_5 * power_5 / 4.0), vec3(0.05000000074505806));
}

vec3 skin_coat_radiance(texture2D preconvolved, sampler preconvolved_sampler, vec3 direction, float n_dot_v, float gloss)
{
    return skin_preconvolved(preconvolved, preconvolved_sampler, skin_equirectangular_uv(direction), (skin_specular_power(gloss) + 2.0) / (8.0 * max(n_dot_v, 0.00999999977648258)));
}

vec3 skin_filmic(vec3 light)
{
    vec3 x_5 = max(light - 0.00400000018998981, vec3(0.0));
    vec3 _S35 = 6.19999980926513672 * x_5;
    return x_5 * (_S35 + 0.5) / (x_5 * (_S35 + 1.70000004768371582) + 0.05999999865889549);
}

float skin_srgb_curve(float x)
{
    float _S36;
    if(x <= 0.00313080009073019)
    {
        _S36 = 12.92000007629394531 * x;
    }
    else
    {
        _S36 = 1.0549999475479126 * pow(max(x, 9.999999960041972e-13), 0.4166666567325592) - 0.05499999970197678;
    }
    return _S36;
}

vec3 skin_srgb_from_linear(vec3 light)
{
    vec3 x_7 = skin_saturate_1(light);
    return vec3(skin_srgb_curve(x_7.x), skin_srgb_curve(x_7.y), skin_srgb_curve(x_7.z));
}

float skin_linear_curve(float x)
{
    float _S37;
    if(x <= 0.04044999927282333)
    {
        _S37 = x / 12.92000007629394531;
    }
    else
    {
        _S37 = pow((x + 0.05499999970197678) / 1.0549999475479126, 2.40000009536743164);
    }
    return _S37;
}

vec3 skin_linear_from_srgb(vec3 display)
{
    vec3 x_9 = skin_saturate_1(display);
    return vec3(skin_linear_curve(x_9.x), skin_linear_curve(x_9.y), skin_linear_curve(x_9.z));
}

float skin_classic_blur_level(float radius_mm, float uv_scale_mm, float map_size, float hardware_level)
{
    return max(hardware_level, log2(max(map_size * radius_mm, uv_scale_mm) / uv_scale_mm));
}

vec3 skin_classic_direct(texture2D lut, sampler lut_sampler, vec4 lut_axes, vec3 sharp, vec3 blurred, vec3 light, float curvature_per_mm)
{
    float blurred_cosine_0 = dot(blurred, light);
    float k_1 = skin_saturate_0(1.0 - blurred_cosine_0);
    float k_2 = k_1 * k_1;
    return skin_saturate_1(skin_saturate_1(vec3(blurred_cosine_0, dot(skin_unit_vectors(mix(sharp, blurred, vec3(0.30000001192092896 + 0.69999998807907104 * k_2))), light), dot(skin_unit_vectors(mix(sharp, blurred, vec3(k_2))), light))) + ((textureLod(sampler2D(lut,lut_sampler), (skin_saturate_2((vec2(blurred_cosine_0, abs(curvature_per_mm)) - lut_axes.xz) * lut_axes.yw)), (0.0))).xyz - max(blurred_cosine_0, 0.0)));
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

float skin_eye_root(float value)
{
    return sqrt(max(value, 9.99999997475242708e-07));
}

vec4 skin_eye_cornea(float cornea_radius_mm, float cornea_asphericity, float refraction_index, vec4 limbus)
{
    float r_1 = limbus.x;
    float ratio_0 = r_1 / cornea_radius_mm;
    float _S38 = r_1 * r_1;
    float _S39 = limbus.z;
    return vec4(skin_eye_root(_S39 * _S39 - _S38) + _S38 / (cornea_radius_mm * (1.0 + skin_eye_root(1.0 - (1.0 + cornea_asphericity) * ratio_0 * ratio_0))), cornea_radius_mm, cornea_asphericity, refraction_index);
}

vec2 skin_eye_conic(float r, vec4 cornea)
{
    float _S40 = cornea.y;
    float ratio_1 = r / _S40;
    float root_3 = skin_eye_root(1.0 - (1.0 + cornea.z) * ratio_1 * ratio_1);
    return vec2(cornea.x - r * r / (_S40 * (1.0 + root_3)), -1.0 / (_S40 * root_3));
}

vec2 skin_eye_profile(float r, vec4 cornea, vec4 limbus)
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
        return vec2(sphere_0, -1.0 / sphere_0);
    }
    vec2 start_0 = skin_eye_conic(inner_0, cornea);
    float _S44 = limbus.z;
    float end_0 = skin_eye_root(_S44 * _S44 - outer_0 * outer_0);
    float m0_0 = width_0 * inner_0 * start_0.y;
    float m1_0 = - width_0 * outer_0 / end_0;
    float t_2 = (r - inner_0) / width_0;
    float _S45 = start_0.x;
    float rise_1 = end_0 - _S45;
    float c2_0 = 3.0 * rise_1 - 2.0 * m0_0 - m1_0;
    float c3_0 = m0_0 + m1_0 - 2.0 * rise_1;
    return vec2(_S45 + t_2 * (m0_0 + t_2 * (c2_0 + t_2 * c3_0)), (m0_0 + t_2 * (2.0 * c2_0 + t_2 * (3.0 * c3_0))) / (width_0 * max(r, 9.99999997475242708e-07)));
}

float skin_eye_height(float r_mm, vec4 cornea, vec4 limbus)
{
    return skin_eye_profile(r_mm, cornea, limbus).x;
}

vec3 skin_eye_normal(vec3 position_mm, vec4 cornea, vec4 limbus)
{
    vec2 _S46 = position_mm.xy;
    float r_4 = sqrt(dot(_S46, _S46));
    float slope_over_r_0 = skin_eye_profile(r_4, cornea, limbus).y;
    bool in_front_0;
    if((position_mm.z) > 0.0)
    {
        in_front_0 = r_4 < (limbus.x + limbus.y);
    }
    else
    {
        in_front_0 = false;
    }
    vec3 normal_13 = vec3(- slope_over_r_0 * _S46, 1.0);
    vec3 _S47;
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

vec4 skin_eye_cornea_hit(vec3 origin_mm, vec3 direction, vec4 cornea)
{
    float q_1 = 1.0 + cornea.z;
    float s_2 = cornea.x - origin_mm.z;
    float _S48 = direction.z;
    vec2 _S49 = origin_mm.xy;
    float _S50 = cornea.y;
    float _S51 = q_1 * s_2;
    float b_1 = dot(_S49, direction.xy) + _S48 * (_S50 - _S51);
    float c_0 = dot(_S49, _S49) - 2.0 * _S50 * s_2 + _S51 * s_2;
    float radicand_0 = b_1 * b_1 - (1.0 - (1.0 - q_1) * _S48 * _S48) * c_0;
    bool meets_0;
    if(radicand_0 >= 0.0)
    {
        meets_0 = b_1 < 0.0;
    }
    else
    {
        meets_0 = false;
    }
    float distance_0;
    if(meets_0)
    {
        distance_0 = c_0 / max(skin_eye_root(radicand_0) - b_1, 9.99999997475242708e-07);
    }
    else
    {
        distance_0 = 0.0;
    }
    vec3 _S52 = origin_mm + distance_0 * direction;
    if(meets_0)
    {
        distance_0 = 1.0;
    }
    else
    {
        distance_0 = 0.0;
    }
    return vec4(_S52, distance_0);
}

float skin_smooth(float t)
{
    float clamped_0 = skin_saturate_0(t);
    return clamped_0 * clamped_0 * (3.0 - 2.0 * clamped_0);
}

float skin_eye_limbal_opacity(float r_mm, vec4 limbus)
{
    float _S53 = limbus.y;
    return skin_smooth((r_mm - limbus.x + _S53) / (2.0 * _S53));
}

vec3 skin_eye_iris_hit(vec3 position_mm, vec3 normal, vec3 view, vec4 cornea, vec4 iris)
{
    float eta_0 = 1.0 / cornea.w;
    float _S54 = max(dot(normal, view), 0.0);
    vec3 d_1 = (eta_0 * _S54 - sqrt(max(1.0 - eta_0 * eta_0 * (1.0 - _S54 * _S54), 0.0))) * normal - eta_0 * view;
    float h_0 = iris.x - position_mm.z;
    float _S55 = iris.y;
    float m2_0 = _S55 * _S55;
    float _S56 = d_1.z;
    vec2 _S57 = d_1.xy;
    float a_1 = _S56 * _S56 - m2_0 * dot(_S57, _S57);
    vec2 _S58 = position_mm.xy;
    float b_2 = h_0 * _S56 + m2_0 * dot(_S58, _S57);
    float e_0 = h_0 * h_0 - m2_0 * dot(_S58, _S58);
    vec2 apart_0 = h_0 * _S57 + _S56 * _S58;
    float cross_product_0 = d_1.x * position_mm.y - d_1.y * position_mm.x;
    float root_4 = abs(_S55) * sqrt(max(dot(apart_0, apart_0) - m2_0 * cross_product_0 * cross_product_0, 0.0));
    float distance_1;
    if(_S55 < 0.0)
    {
        distance_1 = e_0 / max(b_2 + root_4, 9.99999997475242708e-07);
    }
    else
    {
        distance_1 = (b_2 + root_4) / max(a_1, 0.00009999999747379);
    }
    return position_mm + distance_1 * d_1;
}

vec2 skin_eye_iris_uv(vec3 hit_mm, vec4 iris, float pupil_in_map, vec4 iris_uv)
{
    vec2 _S59 = hit_mm.xy;
    float r_5 = sqrt(dot(_S59, _S59));
    float pupil_0 = iris.w;
    float _S60 = min((r_5 - pupil_0) / max(iris.z - pupil_0, 9.99999997475242708e-07), 1.0);
    float radius_0;
    if(r_5 < pupil_0)
    {
        radius_0 = pupil_in_map * r_5 / max(pupil_0, 9.99999997475242708e-07);
    }
    else
    {
        radius_0 = pupil_in_map + (1.0 - pupil_in_map) * _S60;
    }
    float scale_0 = iris_uv.z * radius_0 / max(r_5, 9.99999997475242708e-07);
    float angle_0 = 6.28318548202514648 * iris_uv.w;
    float cosine_4 = cos(angle_0);
    float sine_0 = sin(angle_0);
    float _S61 = hit_mm.x;
    float _S62 = hit_mm.y;
    return vec2(iris_uv.x + scale_0 * (cosine_4 * _S61 - sine_0 * _S62), iris_uv.y - scale_0 * (sine_0 * _S61 + cosine_4 * _S62));
}

vec3 skin_eye_iris_parallax(vec3 hit_mm, vec3 direction, vec3 iris_normal, float height_mm)
{
    return hit_mm - direction * (height_mm / max(- dot(direction, iris_normal), 0.10000000149011612));
}

float skin_eye_warped(float cosine)
{
    float size_1 = pow(max(abs(cosine), 9.99999971718068537e-10), 0.69999998807907104);
    float _S63;
    if(cosine < 0.0)
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
    float least_0 = skin_eye_warped(-0.34202015399932861);
    return 15.0 * (skin_eye_warped(clamp(cosine, -0.34202015399932861, 1.0)) - least_0) / (1.0 - least_0);
}

vec3 skin_eye_light(texture2D lut, sampler lut_sampler, vec4 lut_axes, vec3 hit_mm, vec3 light)
{
    vec2 _S64 = light.xy;
    float across_1 = sqrt(dot(_S64, _S64));
    vec2 turn_0;
    if(across_1 > 9.99999997475242708e-07)
    {
        turn_0 = _S64 / across_1;
    }
    else
    {
        turn_0 = vec2(1.0, 0.0);
    }
    float x_10 = dot(hit_mm.xy, turn_0);
    float _S65 = turn_0.x;
    float _S66 = turn_0.y;
    float y_2 = hit_mm.y * _S65 - hit_mm.x * _S66;
    float index_0 = skin_eye_slice(light.z);
    float _S67 = min(floor(index_0), 14.0);
    float row_2 = 0.5 + 15.0 * min(abs(y_2) / (- lut_axes.x * 31.0 / 32.0), 1.0) + 16.0 * _S67;
    vec2 _S68 = lut_axes.xz;
    vec2 _S69 = lut_axes.yw;
    vec3 first_0 = (textureLod(sampler2D(lut,lut_sampler), (skin_saturate_2((vec2(x_10, row_2) - _S68) * _S69)), (0.0))).xyz;
    vec3 second_0 = (textureLod(sampler2D(lut,lut_sampler), (skin_saturate_2((vec2(x_10, row_2 + 16.0) - _S68) * _S69)), (0.0))).xyz;
    float straight_0 = 1.0 - min(across_1 / 0.50550216436386108, 1.0);
    float moved_0;
    if(_S67 > 13.5)
    {
        moved_0 = straight_0;
    }
    else
    {
        moved_0 = index_0 - _S67;
    }
    vec3 value_1 = mix(first_0, second_0, vec3(index_0 - _S67, moved_0, moved_0));
    float entry_y_0;
    if(y_2 < 0.0)
    {
        entry_y_0 = - value_1.z;
    }
    else
    {
        entry_y_0 = value_1.z;
    }
    float _S70 = value_1.y;
    return vec3(value_1.x, _S70 * _S65 - entry_y_0 * _S66, _S70 * _S66 + entry_y_0 * _S65);
}

vec4 skin_eye_ambient(texture2D lut, sampler lut_sampler, vec4 lut_axes, float r_mm)
{
    vec2 _S71 = lut_axes.xz;
    vec2 _S72 = lut_axes.yw;
    return vec4((textureLod(sampler2D(lut,lut_sampler), (skin_saturate_2((vec2(r_mm, 0.0) - _S71) * _S72)), (0.0))).xyz, (textureLod(sampler2D(lut,lut_sampler), (skin_saturate_2((vec2(r_mm, 1.0) - _S71) * _S72)), (0.0))).xyz.x);
}

float skin_dielectric_fresnel(float cosine, float index)
{
    float c_1 = skin_saturate_0(cosine);
    float _S73 = index * index;
    float inside_0 = sqrt(max(_S73 - 1.0 + c_1 * c_1, 0.0));
    float s_3 = (c_1 - inside_0) / max(c_1 + inside_0, 9.99999997475242708e-07);
    float _S74 = _S73 * c_1;
    float p_2 = (_S74 - inside_0) / max(_S74 + inside_0, 9.99999997475242708e-07);
    return 0.5 * (s_3 * s_3 + p_2 * p_2);
}

float skin_eye_inside(float n_dot_v, float index)
{
    return (1.0 - skin_dielectric_fresnel(n_dot_v, index)) / (index * index);
}

float skin_lamp_highlight(vec3 reflected, vec3 light, float lamp, float roughness)
{
    vec3 apart_1 = reflected - light;
    float chord2_0 = dot(apart_1, apart_1);
    float wide_1 = sqrt(lamp * lamp + roughness * roughness);
    float _S75 = max(roughness, 0.00009999999747379);
    float sine_1 = sin(wide_1);
    return skin_smooth((wide_1 + _S75 - sqrt(chord2_0) * (1.0 + chord2_0 * (0.0416666679084301 + chord2_0 * 0.00468750018626451))) / (2.0 * _S75)) / (sine_1 * sine_1 + _S75 * _S75 / 5.0);
}

float skin_pupil_radius(float luminance)
{
    return 2.45000004768371582 - 1.5 * tanh(0.12041200697422028 * log2(clamp(luminance, 9.99999997475242708e-07, 1.0e+08)));
}

float skin_lid_share(vec3 position_mm, vec3 exit_mm, float penumbra, float ramp, vec4 lid)
{
    float _S76 = lid.w;
    vec3 _S77 = lid.xyz;
    return skin_smooth((_S76 - dot(_S77, exit_mm)) / penumbra + 0.5) * skin_saturate_0((_S76 - dot(_S77, position_mm)) / ramp + 0.5);
}

float skin_lid_visibility(vec3 position_mm, vec3 direction, float spread, float margin_mm, vec4 upper, vec4 lower, float radius_mm)
{
    float along_1 = dot(position_mm, direction);
    float distance_2 = sqrt(max(along_1 * along_1 + (radius_mm * radius_mm - dot(position_mm, position_mm)), 0.0)) - along_1;
    vec3 exit_mm_1 = position_mm + distance_2 * direction;
    float _S78 = max(2.0 * distance_2 * spread, 0.00009999999747379);
    float _S79 = max(2.0 * margin_mm, 0.00009999999747379);
    return skin_lid_share(position_mm, exit_mm_1, _S78, _S79, upper) * skin_lid_share(position_mm, exit_mm_1, _S78, _S79, lower);
}

float skin_lid_hidden(vec3 position_mm, vec3 normal, vec4 lid, float radius_mm)
{
    vec3 _S80 = lid.xyz;
    float toward_0 = dot(_S80, normal);
    float tangent_0 = sqrt(max(1.0 - toward_0 * toward_0, 0.00009999999747379));
    float bare_0 = lid.w - dot(_S80, position_mm);
    vec3 foot_0 = position_mm + bare_0 * _S80;
    float along_2 = dot(foot_0, tangent_0 * normal - toward_0 * ((_S80 - toward_0 * normal) / tangent_0));
    float radicand_1 = along_2 * along_2 - (dot(foot_0, foot_0) - radius_mm * radius_mm);
    float length_0 = sqrt(max(radicand_1, 0.0)) - along_2;
    float above_0 = bare_0 * toward_0 + length_0 * tangent_0;
    float beside_0 = bare_0 * tangent_0 - length_0 * toward_0;
    float cosine_8 = beside_0 / max(sqrt(above_0 * above_0 + beside_0 * beside_0), 0.00009999999747379);
    bool _S81;
    if(above_0 > 0.0)
    {
        _S81 = radicand_1 > 0.0;
    }
    else
    {
        _S81 = false;
    }
    float _S82;
    if(_S81)
    {
        _S82 = 0.5 * (1.0 - cosine_8);
    }
    else
    {
        _S82 = 0.0;
    }
    return _S82;
}

float skin_lid_openness(vec3 position_mm, vec3 normal, vec4 upper, vec4 lower, float radius_mm)
{
    return skin_saturate_0(1.0 - skin_lid_hidden(position_mm, normal, upper, radius_mm) - skin_lid_hidden(position_mm, normal, lower, radius_mm));
}

float skin_lid_iris_hidden(vec3 position_mm, float narrowed, vec4 lid)
{
    float a_2 = lid.w - dot(lid.xyz, position_mm) - 0.57999998331069946 * narrowed;
    float width_1 = 2.58999991416931152 * narrowed;
    return 0.5 * (1.0 - a_2 / sqrt(a_2 * a_2 + width_1 * width_1));
}

float skin_lid_iris_openness(vec3 hit_mm, vec4 cornea, vec4 limbus, vec4 upper, vec4 lower)
{
    vec2 _S83 = hit_mm.xy;
    float _S84 = limbus.x;
    float squared_1 = dot(_S83, _S83) / (_S84 * _S84);
    float rim_0 = squared_1 * squared_1;
    vec2 entry_1 = (0.82999998331069946 + 0.40999999642372131 * rim_0) * _S83;
    float _S85 = max(1.0 - 1.12000000476837158 * rim_0, 0.05000000074505806);
    vec3 position_2 = vec3(entry_1, skin_eye_height(sqrt(dot(entry_1, entry_1)), cornea, limbus));
    return skin_saturate_0(1.0 - skin_lid_iris_hidden(position_2, _S85, upper) - skin_lid_iris_hidden(position_2, _S85, lower));
}

vec3 skin_tear_normal(vec3 position_mm, vec3 normal, vec4 lid, float height_mm)
{
    vec3 _S86 = lid.xyz;
    float sine_2 = skin_saturate_0(1.0 - (lid.w - dot(_S86, position_mm)) / max(height_mm, 0.00009999999747379));
    return skin_unit_vectors(sqrt(max(1.0 - sine_2 * sine_2, 0.0)) * normal - sine_2 * skin_unit_vectors(_S86 - dot(_S86, normal) * normal));
}
