@binding(0) @group(0) var<storage, read> inputs_0 : array<f32>;

@binding(1) @group(0) var<storage, read_write> outputs_0 : array<f32>;

@binding(4) @group(0) var lut_0 : texture_2d<f32>;

@binding(5) @group(0) var lut_sampler_0 : sampler;

@binding(8) @group(0) var transfer_0 : texture_2d<f32>;

@binding(9) @group(0) var transfer_sampler_0 : sampler;

@binding(2) @group(0) var depth_map_0 : texture_2d<f32>;

@binding(3) @group(0) var depth_map_sampler_0 : sampler;

@binding(6) @group(0) var preconvolved_0 : texture_2d<f32>;

@binding(7) @group(0) var preconvolved_sampler_0 : sampler;

fn rsqrt_0( x_0 : f32) -> f32
{
    return 1.0f / sqrt(x_0);
}

var<private> SKIN_POISSON_32_0 : array<vec2<f32>, i32(32)> = array<vec2<f32>, i32(32)>( vec2<f32>(-0.02096010930836201f, 0.01299272011965513f), vec2<f32>(0.69517123699188232f, -0.04910685122013092f), vec2<f32>(0.28034570813179016f, 0.66283899545669556f), vec2<f32>(0.03107489086687565f, -0.69704329967498779f), vec2<f32>(-0.49904009699821472f, 0.54098159074783325f), vec2<f32>(-0.70408397912979126f, -0.14709833264350891f), vec2<f32>(0.53451526165008545f, -0.56702268123626709f), vec2<f32>(-0.48678380250930786f, -0.61486828327178955f), vec2<f32>(0.68837428092956543f, 0.41418349742889404f), vec2<f32>(-0.14107078313827515f, 0.8102262020111084f), vec2<f32>(0.21897397935390472f, -0.3123532235622406f), vec2<f32>(0.31406453251838684f, 0.24951401352882385f), vec2<f32>(-0.83115619421005249f, 0.28457203507423401f), vec2<f32>(-0.40699386596679688f, 0.14198443293571472f), vec2<f32>(-0.10747358947992325f, 0.41360348463058472f), vec2<f32>(-0.19334819912910461f, -0.34689420461654663f), vec2<f32>(0.80768358707427979f, -0.37000563740730286f), vec2<f32>(0.33436411619186401f, -0.82407790422439575f), vec2<f32>(-0.79105347394943237f, -0.45378401875495911f), vec2<f32>(-0.23485180735588074f, -0.86940687894821167f), vec2<f32>(0.37255629897117615f, -0.05855973064899445f), vec2<f32>(0.5726354718208313f, 0.72984015941619873f), vec2<f32>(0.8966706395149231f, 0.17047682404518127f), vec2<f32>(-0.43273070454597473f, 0.81860679388046265f), vec2<f32>(0.1212853416800499f, 0.92984902858734131f), vec2<f32>(-0.42749753594398499f, -0.15111121535301208f), vec2<f32>(-0.94129812717437744f, 0.00735718011856079f), vec2<f32>(0.52211439609527588f, -0.28702935576438904f), vec2<f32>(-0.79033631086349487f, 0.5402228832244873f), vec2<f32>(-0.23410981893539429f, -0.59940856695175171f), vec2<f32>(0.28244560956954956f, -0.563071608543396f), vec2<f32>(0.57051312923431396f, 0.18359191715717316f) );
var<private> SKIN_POISSON_8_0 : array<vec2<f32>, i32(8)> = array<vec2<f32>, i32(8)>( vec2<f32>(-0.16089901328086853f, -0.04573699831962585f), vec2<f32>(-0.89243310689926147f, 0.18877510726451874f), vec2<f32>(-0.17830690741539001f, 0.7200586199760437f), vec2<f32>(-0.53433239459991455f, -0.70478206872940063f), vec2<f32>(0.22474820911884308f, -0.69165337085723877f), vec2<f32>(0.5559992790222168f, 0.1985180526971817f), vec2<f32>(0.64686292409896851f, -0.3364911675453186f), vec2<f32>(0.33836102485656738f, 0.67131179571151733f) );
var<private> SKIN_CONTACT_DISK_0 : array<vec2<f32>, i32(12)> = array<vec2<f32>, i32(12)>( vec2<f32>(0.16725532710552216f, 0.0f), vec2<f32>(-0.21519750356674194f, 0.19713853299617767f), vec2<f32>(0.0332011915743351f, -0.3783104419708252f), vec2<f32>(0.27573889493942261f, 0.35965254902839661f), vec2<f32>(-0.51071953773498535f, -0.09033908694982529f), vec2<f32>(0.48873069882392883f, -0.31089046597480774f), vec2<f32>(-0.16532173752784729f, 0.61498862504959106f), vec2<f32>(-0.31931877136230469f, -0.61482888460159302f), vec2<f32>(0.70304751396179199f, 0.25675183534622192f), vec2<f32>(-0.74441087245941162f, 0.3072819709777832f), vec2<f32>(0.36706140637397766f, -0.78438889980316162f), vec2<f32>(0.28072324395179749f, 0.89498996734619141f) );
var<private> SKIN_SHADOW_DISK_48_0 : array<vec2<f32>, i32(48)> = array<vec2<f32>, i32(48)>( vec2<f32>(0.08340597897768021f, 0.0f), vec2<f32>(-0.10671073943376541f, 0.09775578230619431f), vec2<f32>(0.01636306010186672f, -0.1864485889673233f), vec2<f32>(0.13498826324939728f, 0.17606829106807709f), vec2<f32>(-0.24817833304405212f, -0.04389924928545952f), vec2<f32>(0.2355383038520813f, -0.14983019232749939f), vec2<f32>(-0.07893361896276474f, 0.29362913966178894f), vec2<f32>(-0.15082783997058868f, -0.29040983319282532f), vec2<f32>(0.32788398861885071f, 0.11974270641803741f), vec2<f32>(-0.34179624915122986f, 0.14108851552009583f), vec2<f32>(0.16510665416717529f, -0.35282331705093384f), vec2<f32>(0.12226484715938568f, 0.38979959487915039f), vec2<f32>(-0.36929354071617126f, -0.21401314437389374f), vec2<f32>(0.4341655969619751f, -0.09545008838176727f), vec2<f32>(-0.2655525803565979f, 0.37772122025489807f), vec2<f32>(-0.06148780882358551f, -0.47449716925621033f), vec2<f32>(0.37834861874580383f, 0.31887263059616089f), vec2<f32>(-0.51034331321716309f, 0.02110430039465427f), vec2<f32>(0.37315717339515686f, -0.37134122848510742f), vec2<f32>(-0.02502750046551228f, 0.54124277830123901f), vec2<f32>(-0.3568427562713623f, -0.42761686444282532f), vec2<f32>(0.56674838066101074f, 0.0762551873922348f), vec2<f32>(-0.48148587346076965f, 0.33500534296035767f), vec2<f32>(0.13193005323410034f, -0.58644229173660278f), vec2<f32>(0.30600649118423462f, 0.53402209281921387f), vec2<f32>(-0.59994620084762573f, -0.1913992166519165f), vec2<f32>(0.58451014757156372f, -0.27005851268768311f), vec2<f32>(-0.25400349497795105f, 0.60692840814590454f), vec2<f32>(-0.22741274535655975f, -0.63226538896560669f), vec2<f32>(0.60710901021957397f, 0.31907948851585388f), vec2<f32>(-0.6766400933265686f, 0.17836016416549683f), vec2<f32>(0.38596493005752563f, -0.60026413202285767f), vec2<f32>(0.12322843074798584f, 0.71703100204467773f), vec2<f32>(-0.58622837066650391f, -0.45400822162628174f), vec2<f32>(0.75288873910903931f, -0.06237528845667839f), vec2<f32>(-0.52258288860321045f, 0.56489682197570801f), vec2<f32>(0.0038233099039644f, -0.78373259305953979f), vec2<f32>(0.53622621297836304f, 0.59111112356185913f), vec2<f32>(-0.80917233228683472f, -0.07499390840530396f), vec2<f32>(0.65910446643829346f, -0.50023680925369263f), vec2<f32>(-0.15080370008945465f, 0.82895052433013916f), vec2<f32>(-0.45701694488525391f, -0.72624564170837402f), vec2<f32>(0.84303575754165649f, 0.23104114830493927f), vec2<f32>(-0.79258495569229126f, 0.40674149990081787f), vec2<f32>(0.31582745909690857f, -0.85189038515090942f), vec2<f32>(0.34976369142532349f, 0.85918575525283813f), vec2<f32>(-0.85765814781188965f, -0.40646019577980042f), vec2<f32>(0.93254464864730835f, -0.28751349449157715f) );
var<private> SKIN_SHADOW_DISK_16_0 : array<vec2<f32>, i32(16)> = array<vec2<f32>, i32(16)>( vec2<f32>(0.14471825957298279f, 0.0f), vec2<f32>(-0.18583981692790985f, 0.170244500041008f), vec2<f32>(0.02860930934548378f, -0.32598838210105896f), vec2<f32>(0.23701368272304535f, 0.30914238095283508f), vec2<f32>(-0.43773865699768066f, -0.07742980122566223f), vec2<f32>(0.41749045252799988f, -0.26557326316833496f), vec2<f32>(-0.14065909385681152f, 0.52324479818344116f), vec2<f32>(-0.27035140991210938f, -0.52054518461227417f), vec2<f32>(0.59152573347091675f, 0.21602423489093781f), vec2<f32>(-0.6210860013961792f, 0.25637525320053101f), vec2<f32>(0.30247461795806885f, -0.64637070894241333f), vec2<f32>(0.22609943151473999f, 0.72084063291549683f), vec2<f32>(-0.69051814079284668f, -0.40016940236091614f), vec2<f32>(0.82290405035018921f, -0.18091315031051636f), vec2<f32>(-0.5123591423034668f, 0.7287781834602356f), vec2<f32>(-0.12196926772594452f, -0.94122844934463501f) );
fn skin_map_level_0( map_extent_0 : vec2<f32>,  uv_along_x_0 : vec2<f32>,  uv_along_y_0 : vec2<f32>) -> f32
{
    var texels_x_0 : vec2<f32> = uv_along_x_0 * map_extent_0;
    var texels_y_0 : vec2<f32> = uv_along_y_0 * map_extent_0;
    var x_1 : f32 = dot(texels_x_0, texels_x_0);
    var y_0 : f32 = dot(texels_y_0, texels_y_0);
    return max(0.5f * log2(max(max(min(x_1, y_0), max(x_1, y_0) / 64.0f), 1.00000000317107685e-30f)), 0.0f);
}

@compute
@workgroup_size(64, 1, 1)
fn run_map_level(@builtin(global_invocation_id) thread_0 : vec3<u32>)
{
    var _S1 : u32 = thread_0.x;
    var start_0 : u32 = _S1 * u32(6);
    outputs_0[_S1] = skin_map_level_0(vec2<f32>(inputs_0[start_0], inputs_0[start_0 + u32(1)]), vec2<f32>(inputs_0[start_0 + u32(2)], inputs_0[start_0 + u32(3)]), vec2<f32>(inputs_0[start_0 + u32(4)], inputs_0[start_0 + u32(5)]));
    return;
}

fn skin_blur_level_0( sigma_mm_0 : f32,  uv_scale_mm_0 : f32,  map_size_0 : f32,  hardware_level_0 : f32) -> f32
{
    return max(hardware_level_0, log2(max(2.0f * sigma_mm_0 * map_size_0 / uv_scale_mm_0, 1.0f)));
}

@compute
@workgroup_size(64, 1, 1)
fn run_blur_level(@builtin(global_invocation_id) thread_1 : vec3<u32>)
{
    var _S2 : u32 = thread_1.x;
    var start_1 : u32 = _S2 * u32(4);
    outputs_0[_S2] = skin_blur_level_0(inputs_0[start_1], inputs_0[start_1 + u32(1)], inputs_0[start_1 + u32(2)], inputs_0[start_1 + u32(3)]);
    return;
}

fn skin_weighted_sum_0( rows_0 : mat3x3<f32>,  weights_0 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(weights_0.x) * rows_0[i32(0)] + vec3<f32>(weights_0.y) * rows_0[i32(1)] + vec3<f32>(weights_0.z) * rows_0[i32(2)];
}

fn skin_blend_normals_0( fetched_0 : mat3x3<f32>,  blend_0 : mat3x3<f32>) -> mat3x3<f32>
{
    return mat3x3<f32>(skin_weighted_sum_0(fetched_0, blend_0[i32(0)]), skin_weighted_sum_0(fetched_0, blend_0[i32(1)]), skin_weighted_sum_0(fetched_0, blend_0[i32(2)]));
}

@compute
@workgroup_size(64, 1, 1)
fn run_blend_normals(@builtin(global_invocation_id) thread_2 : vec3<u32>)
{
    var _S3 : u32 = thread_2.x;
    var start_2 : u32 = _S3 * u32(18);
    var result_0 : mat3x3<f32> = skin_blend_normals_0(mat3x3<f32>(inputs_0[start_2], inputs_0[start_2 + u32(1)], inputs_0[start_2 + u32(2)], inputs_0[start_2 + u32(3)], inputs_0[start_2 + u32(4)], inputs_0[start_2 + u32(5)], inputs_0[start_2 + u32(6)], inputs_0[start_2 + u32(7)], inputs_0[start_2 + u32(8)]), mat3x3<f32>(inputs_0[start_2 + u32(9)], inputs_0[start_2 + u32(10)], inputs_0[start_2 + u32(11)], inputs_0[start_2 + u32(12)], inputs_0[start_2 + u32(13)], inputs_0[start_2 + u32(14)], inputs_0[start_2 + u32(15)], inputs_0[start_2 + u32(16)], inputs_0[start_2 + u32(17)]));
    var _S4 : u32 = _S3 * u32(9);
    outputs_0[_S4] = result_0[i32(0)][i32(0)];
    outputs_0[_S4 + u32(1)] = result_0[i32(0)][i32(1)];
    outputs_0[_S4 + u32(2)] = result_0[i32(0)][i32(2)];
    outputs_0[_S4 + u32(3)] = result_0[i32(1)][i32(0)];
    outputs_0[_S4 + u32(4)] = result_0[i32(1)][i32(1)];
    outputs_0[_S4 + u32(5)] = result_0[i32(1)][i32(2)];
    outputs_0[_S4 + u32(6)] = result_0[i32(2)][i32(0)];
    outputs_0[_S4 + u32(7)] = result_0[i32(2)][i32(1)];
    outputs_0[_S4 + u32(8)] = result_0[i32(2)][i32(2)];
    return;
}

fn skin_safe_length_0( v_0 : vec3<f32>) -> f32
{
    return sqrt(max(dot(v_0, v_0), 1.00000004581370497e-18f));
}

fn skin_with_mesh_diffusion_0( from_texture_0 : vec3<f32>,  from_mesh_0 : vec3<f32>,  mesh_normal_0 : vec3<f32>) -> vec3<f32>
{
    return from_texture_0 + vec3<f32>(skin_safe_length_0(from_texture_0)) * (from_mesh_0 - mesh_normal_0);
}

fn skin_add_mesh_diffusion_0( from_texture_1 : mat3x3<f32>,  from_mesh_1 : mat3x3<f32>,  mesh_normal_1 : vec3<f32>) -> mat3x3<f32>
{
    return mat3x3<f32>(skin_with_mesh_diffusion_0(from_texture_1[i32(0)], from_mesh_1[i32(0)], mesh_normal_1), skin_with_mesh_diffusion_0(from_texture_1[i32(1)], from_mesh_1[i32(1)], mesh_normal_1), skin_with_mesh_diffusion_0(from_texture_1[i32(2)], from_mesh_1[i32(2)], mesh_normal_1));
}

@compute
@workgroup_size(64, 1, 1)
fn run_add_mesh_diffusion(@builtin(global_invocation_id) thread_3 : vec3<u32>)
{
    var _S5 : u32 = thread_3.x;
    var start_3 : u32 = _S5 * u32(21);
    var result_1 : mat3x3<f32> = skin_add_mesh_diffusion_0(mat3x3<f32>(inputs_0[start_3], inputs_0[start_3 + u32(1)], inputs_0[start_3 + u32(2)], inputs_0[start_3 + u32(3)], inputs_0[start_3 + u32(4)], inputs_0[start_3 + u32(5)], inputs_0[start_3 + u32(6)], inputs_0[start_3 + u32(7)], inputs_0[start_3 + u32(8)]), mat3x3<f32>(inputs_0[start_3 + u32(9)], inputs_0[start_3 + u32(10)], inputs_0[start_3 + u32(11)], inputs_0[start_3 + u32(12)], inputs_0[start_3 + u32(13)], inputs_0[start_3 + u32(14)], inputs_0[start_3 + u32(15)], inputs_0[start_3 + u32(16)], inputs_0[start_3 + u32(17)]), vec3<f32>(inputs_0[start_3 + u32(18)], inputs_0[start_3 + u32(19)], inputs_0[start_3 + u32(20)]));
    var _S6 : u32 = _S5 * u32(9);
    outputs_0[_S6] = result_1[i32(0)][i32(0)];
    outputs_0[_S6 + u32(1)] = result_1[i32(0)][i32(1)];
    outputs_0[_S6 + u32(2)] = result_1[i32(0)][i32(2)];
    outputs_0[_S6 + u32(3)] = result_1[i32(1)][i32(0)];
    outputs_0[_S6 + u32(4)] = result_1[i32(1)][i32(1)];
    outputs_0[_S6 + u32(5)] = result_1[i32(1)][i32(2)];
    outputs_0[_S6 + u32(6)] = result_1[i32(2)][i32(0)];
    outputs_0[_S6 + u32(7)] = result_1[i32(2)][i32(1)];
    outputs_0[_S6 + u32(8)] = result_1[i32(2)][i32(2)];
    return;
}

fn skin_relief_bump_0( m_0 : f32,  s_0 : f32) -> f32
{
    var _S7 : f32 = max(s_0, 9.99999971718068537e-10f);
    var _S8 : f32 = max(1.0f - abs(m_0) / (4.40000009536743164f * _S7), 0.0f);
    var t2_0 : f32 = _S8 * _S8;
    return _S7 * t2_0 * t2_0 * (0.16452799737453461f + _S8 * (-1.55506408214569092f + _S8 * (7.10253477096557617f + _S8 * (-16.75164794921875f + _S8 * (22.75126266479492188f + _S8 * (-15.08054447174072266f + _S8 * 3.76787090301513672f))))));
}

@compute
@workgroup_size(64, 1, 1)
fn run_relief_bump(@builtin(global_invocation_id) thread_4 : vec3<u32>)
{
    var _S9 : u32 = thread_4.x;
    var start_4 : u32 = _S9 * u32(2);
    outputs_0[_S9] = skin_relief_bump_0(inputs_0[start_4], inputs_0[start_4 + u32(1)]);
    return;
}

fn skin_lengths_0( normals_0 : mat3x3<f32>) -> vec3<f32>
{
    return vec3<f32>(skin_safe_length_0(normals_0[i32(0)]), skin_safe_length_0(normals_0[i32(1)]), skin_safe_length_0(normals_0[i32(2)]));
}

fn skin_cosines_0( normals_1 : mat3x3<f32>,  light_0 : vec3<f32>,  lengths_0 : vec3<f32>) -> vec3<f32>
{
    return clamp(vec3<f32>(dot(normals_1[i32(0)], light_0), dot(normals_1[i32(1)], light_0), dot(normals_1[i32(2)], light_0)) / lengths_0, vec3<f32>(-1.0f), vec3<f32>(1.0f));
}

fn skin_curvature_table_0( lut_1 : texture_2d<f32>,  lut_sampler_1 : sampler,  lut_axes_0 : vec4<f32>,  cos_theta_0 : vec3<f32>,  curvature_per_mm_0 : f32) -> vec3<f32>
{
    var row_0 : f32 = sqrt(max(curvature_per_mm_0, 0.0f));
    var _S10 : vec2<f32> = lut_axes_0.xz;
    var _S11 : vec2<f32> = lut_axes_0.yw;
    return vec3<f32>((textureSampleLevel((lut_1), (lut_sampler_1), (saturate((vec2<f32>(cos_theta_0.x, row_0) - _S10) * _S11)), (0.0f))).xyz.x, (textureSampleLevel((lut_1), (lut_sampler_1), (saturate((vec2<f32>(cos_theta_0.y, row_0) - _S10) * _S11)), (0.0f))).xyz.y, (textureSampleLevel((lut_1), (lut_sampler_1), (saturate((vec2<f32>(cos_theta_0.z, row_0) - _S10) * _S11)), (0.0f))).xyz.z);
}

fn skin_relief_light_0( lengths_1 : vec3<f32>,  cos_theta_1 : vec3<f32>) -> vec3<f32>
{
    var slope_0 : vec3<f32> = sqrt(max((vec3<f32>(0) - log(clamp(lengths_1, vec3<f32>(0.00100000004749745f), vec3<f32>(1.0f)))) * (vec3<f32>(1.0f) - cos_theta_1 * cos_theta_1), vec3<f32>(0.0f)));
    return vec3<f32>(skin_relief_bump_0(lengths_1.x * cos_theta_1.x, slope_0.x), skin_relief_bump_0(lengths_1.y * cos_theta_1.y, slope_0.y), skin_relief_bump_0(lengths_1.z * cos_theta_1.z, slope_0.z));
}

fn skin_direct_scalar_0( lut_2 : texture_2d<f32>,  lut_sampler_2 : sampler,  lut_axes_1 : vec4<f32>,  normals_2 : mat3x3<f32>,  light_1 : vec3<f32>,  curvature_per_mm_1 : f32,  gain_0 : vec3<f32>) -> vec3<f32>
{
    var lengths_2 : vec3<f32> = skin_lengths_0(normals_2);
    var cos_theta_2 : vec3<f32> = skin_cosines_0(normals_2, light_1, lengths_2);
    return gain_0 * (lengths_2 * skin_curvature_table_0(lut_2, lut_sampler_2, lut_axes_1, cos_theta_2, abs(curvature_per_mm_1)) + skin_relief_light_0(lengths_2, cos_theta_2));
}

@compute
@workgroup_size(64, 1, 1)
fn run_direct_scalar(@builtin(global_invocation_id) thread_5 : vec3<u32>)
{
    var _S12 : u32 = thread_5.x;
    var start_5 : u32 = _S12 * u32(20);
    var result_2 : vec3<f32> = skin_direct_scalar_0(lut_0, lut_sampler_0, vec4<f32>(inputs_0[start_5], inputs_0[start_5 + u32(1)], inputs_0[start_5 + u32(2)], inputs_0[start_5 + u32(3)]), mat3x3<f32>(inputs_0[start_5 + u32(4)], inputs_0[start_5 + u32(5)], inputs_0[start_5 + u32(6)], inputs_0[start_5 + u32(7)], inputs_0[start_5 + u32(8)], inputs_0[start_5 + u32(9)], inputs_0[start_5 + u32(10)], inputs_0[start_5 + u32(11)], inputs_0[start_5 + u32(12)]), vec3<f32>(inputs_0[start_5 + u32(13)], inputs_0[start_5 + u32(14)], inputs_0[start_5 + u32(15)]), inputs_0[start_5 + u32(16)], vec3<f32>(inputs_0[start_5 + u32(17)], inputs_0[start_5 + u32(18)], inputs_0[start_5 + u32(19)]));
    var _S13 : u32 = _S12 * u32(3);
    outputs_0[_S13] = result_2[i32(0)];
    outputs_0[_S13 + u32(1)] = result_2[i32(1)];
    outputs_0[_S13 + u32(2)] = result_2[i32(2)];
    return;
}

fn skin_transfer_0( transfer_1 : texture_2d<f32>,  transfer_sampler_1 : sampler,  transfer_axes_0 : vec4<f32>,  k_per_mm_0 : f32) -> vec3<f32>
{
    return (textureSampleLevel((transfer_1), (transfer_sampler_1), (saturate((vec2<f32>(sqrt(max(k_per_mm_0, 0.0f)), 0.5f) - transfer_axes_0.xz) * transfer_axes_0.yw)), (0.0f))).xyz;
}

fn skin_direct_tensor_0( lut_3 : texture_2d<f32>,  lut_sampler_3 : sampler,  lut_axes_2 : vec4<f32>,  transfer_2 : texture_2d<f32>,  transfer_sampler_2 : sampler,  transfer_axes_1 : vec4<f32>,  normals_3 : mat3x3<f32>,  light_2 : vec3<f32>,  directional_per_mm_0 : f32,  total_per_mm_0 : f32,  gain_1 : vec3<f32>) -> vec3<f32>
{
    var lengths_3 : vec3<f32> = skin_lengths_0(normals_3);
    var cos_theta_3 : vec3<f32> = skin_cosines_0(normals_3, light_2, lengths_3);
    return gain_1 * (lengths_3 * (skin_curvature_table_0(lut_3, lut_sampler_3, lut_axes_2, cos_theta_3, directional_per_mm_0) * skin_transfer_0(transfer_2, transfer_sampler_2, transfer_axes_1, sqrt(max((total_per_mm_0 - directional_per_mm_0) * (total_per_mm_0 + directional_per_mm_0), 0.0f)))) + skin_relief_light_0(lengths_3, cos_theta_3));
}

@compute
@workgroup_size(64, 1, 1)
fn run_direct_tensor(@builtin(global_invocation_id) thread_6 : vec3<u32>)
{
    var _S14 : u32 = thread_6.x;
    var start_6 : u32 = _S14 * u32(25);
    var result_3 : vec3<f32> = skin_direct_tensor_0(lut_0, lut_sampler_0, vec4<f32>(inputs_0[start_6], inputs_0[start_6 + u32(1)], inputs_0[start_6 + u32(2)], inputs_0[start_6 + u32(3)]), transfer_0, transfer_sampler_0, vec4<f32>(inputs_0[start_6 + u32(4)], inputs_0[start_6 + u32(5)], inputs_0[start_6 + u32(6)], inputs_0[start_6 + u32(7)]), mat3x3<f32>(inputs_0[start_6 + u32(8)], inputs_0[start_6 + u32(9)], inputs_0[start_6 + u32(10)], inputs_0[start_6 + u32(11)], inputs_0[start_6 + u32(12)], inputs_0[start_6 + u32(13)], inputs_0[start_6 + u32(14)], inputs_0[start_6 + u32(15)], inputs_0[start_6 + u32(16)]), vec3<f32>(inputs_0[start_6 + u32(17)], inputs_0[start_6 + u32(18)], inputs_0[start_6 + u32(19)]), inputs_0[start_6 + u32(20)], inputs_0[start_6 + u32(21)], vec3<f32>(inputs_0[start_6 + u32(22)], inputs_0[start_6 + u32(23)], inputs_0[start_6 + u32(24)]));
    var _S15 : u32 = _S14 * u32(3);
    outputs_0[_S15] = result_3[i32(0)];
    outputs_0[_S15 + u32(1)] = result_3[i32(1)];
    outputs_0[_S15 + u32(2)] = result_3[i32(2)];
    return;
}

fn skin_direct_diffused_normals_0( lut_4 : texture_2d<f32>,  lut_sampler_4 : sampler,  lut_axes_3 : vec4<f32>,  transfer_3 : texture_2d<f32>,  transfer_sampler_3 : sampler,  transfer_axes_2 : vec4<f32>,  normals_4 : mat3x3<f32>,  relief_length_0 : vec3<f32>,  light_3 : vec3<f32>,  directional_per_mm_1 : f32,  gain_2 : vec3<f32>) -> vec3<f32>
{
    var lengths_4 : vec3<f32> = skin_lengths_0(normals_4);
    var cos_theta_4 : vec3<f32> = skin_cosines_0(normals_4, light_3, lengths_4);
    return gain_2 * (skin_curvature_table_0(lut_4, lut_sampler_4, lut_axes_3, cos_theta_4, directional_per_mm_1) * min(lengths_4 / max(skin_transfer_0(transfer_3, transfer_sampler_3, transfer_axes_2, directional_per_mm_1), vec3<f32>(9.99999997475242708e-07f)), vec3<f32>(1.0f)) + skin_relief_light_0(relief_length_0, cos_theta_4));
}

@compute
@workgroup_size(64, 1, 1)
fn run_direct_diffused_normals(@builtin(global_invocation_id) thread_7 : vec3<u32>)
{
    var _S16 : u32 = thread_7.x;
    var start_7 : u32 = _S16 * u32(27);
    var result_4 : vec3<f32> = skin_direct_diffused_normals_0(lut_0, lut_sampler_0, vec4<f32>(inputs_0[start_7], inputs_0[start_7 + u32(1)], inputs_0[start_7 + u32(2)], inputs_0[start_7 + u32(3)]), transfer_0, transfer_sampler_0, vec4<f32>(inputs_0[start_7 + u32(4)], inputs_0[start_7 + u32(5)], inputs_0[start_7 + u32(6)], inputs_0[start_7 + u32(7)]), mat3x3<f32>(inputs_0[start_7 + u32(8)], inputs_0[start_7 + u32(9)], inputs_0[start_7 + u32(10)], inputs_0[start_7 + u32(11)], inputs_0[start_7 + u32(12)], inputs_0[start_7 + u32(13)], inputs_0[start_7 + u32(14)], inputs_0[start_7 + u32(15)], inputs_0[start_7 + u32(16)]), vec3<f32>(inputs_0[start_7 + u32(17)], inputs_0[start_7 + u32(18)], inputs_0[start_7 + u32(19)]), vec3<f32>(inputs_0[start_7 + u32(20)], inputs_0[start_7 + u32(21)], inputs_0[start_7 + u32(22)]), inputs_0[start_7 + u32(23)], vec3<f32>(inputs_0[start_7 + u32(24)], inputs_0[start_7 + u32(25)], inputs_0[start_7 + u32(26)]));
    var _S17 : u32 = _S16 * u32(3);
    outputs_0[_S17] = result_4[i32(0)];
    outputs_0[_S17 + u32(1)] = result_4[i32(1)];
    outputs_0[_S17 + u32(2)] = result_4[i32(2)];
    return;
}

fn skin_relief_length_0( transfer_4 : texture_2d<f32>,  transfer_sampler_4 : sampler,  transfer_axes_3 : vec4<f32>,  from_texture_2 : mat3x3<f32>,  from_mesh_2 : mat3x3<f32>,  total_per_mm_1 : f32) -> vec3<f32>
{
    return skin_lengths_0(from_texture_2) * min(skin_lengths_0(from_mesh_2) / max(vec3<f32>(0.97500002384185791f) * skin_transfer_0(transfer_4, transfer_sampler_4, transfer_axes_3, total_per_mm_1), vec3<f32>(9.99999997475242708e-07f)), vec3<f32>(1.0f));
}

@compute
@workgroup_size(64, 1, 1)
fn run_relief_length(@builtin(global_invocation_id) thread_8 : vec3<u32>)
{
    var _S18 : u32 = thread_8.x;
    var start_8 : u32 = _S18 * u32(23);
    var result_5 : vec3<f32> = skin_relief_length_0(transfer_0, transfer_sampler_0, vec4<f32>(inputs_0[start_8], inputs_0[start_8 + u32(1)], inputs_0[start_8 + u32(2)], inputs_0[start_8 + u32(3)]), mat3x3<f32>(inputs_0[start_8 + u32(4)], inputs_0[start_8 + u32(5)], inputs_0[start_8 + u32(6)], inputs_0[start_8 + u32(7)], inputs_0[start_8 + u32(8)], inputs_0[start_8 + u32(9)], inputs_0[start_8 + u32(10)], inputs_0[start_8 + u32(11)], inputs_0[start_8 + u32(12)]), mat3x3<f32>(inputs_0[start_8 + u32(13)], inputs_0[start_8 + u32(14)], inputs_0[start_8 + u32(15)], inputs_0[start_8 + u32(16)], inputs_0[start_8 + u32(17)], inputs_0[start_8 + u32(18)], inputs_0[start_8 + u32(19)], inputs_0[start_8 + u32(20)], inputs_0[start_8 + u32(21)]), inputs_0[start_8 + u32(22)]);
    var _S19 : u32 = _S18 * u32(3);
    outputs_0[_S19] = result_5[i32(0)];
    outputs_0[_S19 + u32(1)] = result_5[i32(1)];
    outputs_0[_S19 + u32(2)] = result_5[i32(2)];
    return;
}

fn skin_directional_curvature_0( tensor_world_0 : mat3x3<f32>,  normal_0 : vec3<f32>,  light_4 : vec3<f32>) -> vec2<f32>
{
    var tangential_0 : vec3<f32> = light_4 - normal_0 * vec3<f32>(dot(light_4, normal_0));
    var change_0 : vec3<f32> = vec3<f32>(dot(tensor_world_0[i32(0)], tangential_0), dot(tensor_world_0[i32(1)], tangential_0), dot(tensor_world_0[i32(2)], tangential_0));
    var total_0 : f32 = sqrt(dot(tensor_world_0[i32(0)], tensor_world_0[i32(0)]) + dot(tensor_world_0[i32(1)], tensor_world_0[i32(1)]) + dot(tensor_world_0[i32(2)], tensor_world_0[i32(2)]));
    return vec2<f32>(min(sqrt(dot(change_0, change_0) / max(dot(tangential_0, tangential_0), 9.999999960041972e-13f)), total_0), total_0);
}

@compute
@workgroup_size(64, 1, 1)
fn run_directional_curvature(@builtin(global_invocation_id) thread_9 : vec3<u32>)
{
    var _S20 : u32 = thread_9.x;
    var start_9 : u32 = _S20 * u32(15);
    var result_6 : vec2<f32> = skin_directional_curvature_0(mat3x3<f32>(inputs_0[start_9], inputs_0[start_9 + u32(1)], inputs_0[start_9 + u32(2)], inputs_0[start_9 + u32(3)], inputs_0[start_9 + u32(4)], inputs_0[start_9 + u32(5)], inputs_0[start_9 + u32(6)], inputs_0[start_9 + u32(7)], inputs_0[start_9 + u32(8)]), vec3<f32>(inputs_0[start_9 + u32(9)], inputs_0[start_9 + u32(10)], inputs_0[start_9 + u32(11)]), vec3<f32>(inputs_0[start_9 + u32(12)], inputs_0[start_9 + u32(13)], inputs_0[start_9 + u32(14)]));
    var _S21 : u32 = _S20 * u32(2);
    outputs_0[_S21] = result_6[i32(0)];
    outputs_0[_S21 + u32(1)] = result_6[i32(1)];
    return;
}

fn skin_energy_gain_0( albedo_0 : vec3<f32>,  rms_radius_mm_0 : vec3<f32>,  curvature_per_mm_2 : vec3<f32>) -> vec3<f32>
{
    var scaled_curvature_0 : vec3<f32> = vec3<f32>(1.20000004768371582f) * rms_radius_mm_0 * max(curvature_per_mm_2, vec3<f32>(0.0f));
    var bound_0 : vec3<f32> = albedo_0 * scaled_curvature_0;
    var _S22 : vec3<f32> = vec3<f32>(1.0f);
    return _S22 + (_S22 - albedo_0) * scaled_curvature_0 / sqrt(_S22 + bound_0 * bound_0);
}

@compute
@workgroup_size(64, 1, 1)
fn run_energy_gain(@builtin(global_invocation_id) thread_10 : vec3<u32>)
{
    var _S23 : u32 = thread_10.x;
    var start_10 : u32 = _S23 * u32(9);
    var result_7 : vec3<f32> = skin_energy_gain_0(vec3<f32>(inputs_0[start_10], inputs_0[start_10 + u32(1)], inputs_0[start_10 + u32(2)]), vec3<f32>(inputs_0[start_10 + u32(3)], inputs_0[start_10 + u32(4)], inputs_0[start_10 + u32(5)]), vec3<f32>(inputs_0[start_10 + u32(6)], inputs_0[start_10 + u32(7)], inputs_0[start_10 + u32(8)]));
    var _S24 : u32 = _S23 * u32(3);
    outputs_0[_S24] = result_7[i32(0)];
    outputs_0[_S24 + u32(1)] = result_7[i32(1)];
    outputs_0[_S24 + u32(2)] = result_7[i32(2)];
    return;
}

fn skin_root_absorption_0( albedo_1 : vec3<f32>) -> vec3<f32>
{
    var bounded_0 : vec3<f32> = saturate(albedo_1);
    var _S25 : vec3<f32> = vec3<f32>(1.0f);
    var s_1 : vec3<f32> = vec3<f32>(6.0f) * (_S25 - bounded_0) / (vec3<f32>(7.0f) + sqrt(vec3<f32>(25.0f) + vec3<f32>(24.0f) * bounded_0));
    return s_1 / (_S25 - s_1);
}

@compute
@workgroup_size(64, 1, 1)
fn run_root_absorption(@builtin(global_invocation_id) thread_11 : vec3<u32>)
{
    var start_11 : u32 = thread_11.x * u32(3);
    var _S26 : u32 = start_11 + u32(1);
    var _S27 : u32 = start_11 + u32(2);
    var result_8 : vec3<f32> = skin_root_absorption_0(vec3<f32>(inputs_0[start_11], inputs_0[_S26], inputs_0[_S27]));
    outputs_0[start_11] = result_8[i32(0)];
    outputs_0[_S26] = result_8[i32(1)];
    outputs_0[_S27] = result_8[i32(2)];
    return;
}

fn skin_inner_cosine_0( cosine_0 : f32,  inverse_ior_0 : f32) -> f32
{
    return sqrt(max(1.0f - (1.0f - cosine_0 * cosine_0) * inverse_ior_0 * inverse_ior_0, 0.0f));
}

fn skin_mean_escape_0( slope_1 : vec3<f32>,  low_0 : f32,  high_0 : f32) -> vec3<f32>
{
    var _S28 : vec3<f32> = vec3<f32>(1.0f);
    return (_S28 + slope_1 * vec3<f32>((0.36391723155975342f * high_0 + 0.63608276844024658f * low_0))) / ((_S28 + slope_1 * vec3<f32>(low_0)) * (_S28 + slope_1 * vec3<f32>(high_0)));
}

fn skin_view_factor_0( albedo_2 : vec3<f32>,  n_dot_v_0 : f32,  reflectance_0 : f32) -> vec3<f32>
{
    var root_0 : f32 = sqrt(clamp(reflectance_0, 0.0f, 0.89999997615814209f));
    var inverse_ior_1 : f32 = (1.0f - root_0) / (1.0f + root_0);
    var slope_2 : vec3<f32> = vec3<f32>(2.0f) * skin_root_absorption_0(albedo_2);
    var _S29 : vec3<f32> = vec3<f32>(1.0f);
    return _S29 / ((_S29 + slope_2 * vec3<f32>(skin_inner_cosine_0(saturate(n_dot_v_0), inverse_ior_1))) * skin_mean_escape_0(slope_2, skin_inner_cosine_0(0.35505104064941406f, inverse_ior_1), skin_inner_cosine_0(0.84494894742965698f, inverse_ior_1)));
}

@compute
@workgroup_size(64, 1, 1)
fn run_view_factor(@builtin(global_invocation_id) thread_12 : vec3<u32>)
{
    var _S30 : u32 = thread_12.x;
    var start_12 : u32 = _S30 * u32(5);
    var result_9 : vec3<f32> = skin_view_factor_0(vec3<f32>(inputs_0[start_12], inputs_0[start_12 + u32(1)], inputs_0[start_12 + u32(2)]), inputs_0[start_12 + u32(3)], inputs_0[start_12 + u32(4)]);
    var _S31 : u32 = _S30 * u32(3);
    outputs_0[_S31] = result_9[i32(0)];
    outputs_0[_S31 + u32(1)] = result_9[i32(1)];
    outputs_0[_S31 + u32(2)] = result_9[i32(2)];
    return;
}

fn skin_closure_view_factor_0( albedo_3 : vec3<f32>,  n_dot_v_1 : f32) -> vec3<f32>
{
    var slope_3 : vec3<f32> = vec3<f32>(2.0f) * skin_root_absorption_0(albedo_3);
    var diffuse_0 : vec3<f32> = skin_mean_escape_0(slope_3, 0.35505104064941406f, 0.84494894742965698f);
    var _S32 : vec3<f32> = vec3<f32>(1.0f);
    return (diffuse_0 + _S32 / (_S32 + slope_3 * vec3<f32>((0.12999999523162842f + 0.75f * saturate(n_dot_v_1))))) / (diffuse_0 + skin_mean_escape_0(slope_3, 0.39628827571868896f, 0.76371169090270996f));
}

@compute
@workgroup_size(64, 1, 1)
fn run_closure_view_factor(@builtin(global_invocation_id) thread_13 : vec3<u32>)
{
    var _S33 : u32 = thread_13.x;
    var start_13 : u32 = _S33 * u32(4);
    var result_10 : vec3<f32> = skin_closure_view_factor_0(vec3<f32>(inputs_0[start_13], inputs_0[start_13 + u32(1)], inputs_0[start_13 + u32(2)]), inputs_0[start_13 + u32(3)]);
    var _S34 : u32 = _S33 * u32(3);
    outputs_0[_S34] = result_10[i32(0)];
    outputs_0[_S34 + u32(1)] = result_10[i32(1)];
    outputs_0[_S34 + u32(2)] = result_10[i32(2)];
    return;
}

fn skin_smoothstep_0( p_0 : f32) -> f32
{
    var q_0 : f32 = saturate(p_0);
    return q_0 * q_0 * (3.0f - 2.0f * q_0);
}

@compute
@workgroup_size(64, 1, 1)
fn run_smoothstep(@builtin(global_invocation_id) thread_14 : vec3<u32>)
{
    var _S35 : u32 = thread_14.x;
    outputs_0[_S35] = skin_smoothstep_0(inputs_0[_S35]);
    return;
}

fn skin_light_coordinates_0( position_mm_0 : vec3<f32>,  view_0 : mat4x4<f32>,  projection_0 : mat4x4<f32>) -> vec4<f32>
{
    var p_1 : vec4<f32> = vec4<f32>(position_mm_0, 1.0f);
    var _S36 : f32 = dot(view_0[i32(2)], p_1);
    var in_view_0 : vec4<f32> = vec4<f32>(dot(view_0[i32(0)], p_1), dot(view_0[i32(1)], p_1), _S36, 1.0f);
    var w_0 : f32 = dot(projection_0[i32(3)], in_view_0);
    var w_1 : f32;
    if((abs(w_0)) < 9.99999971718068537e-10f)
    {
        w_1 = 9.99999971718068537e-10f;
    }
    else
    {
        w_1 = w_0;
    }
    return vec4<f32>(0.5f + 0.5f * (dot(projection_0[i32(0)], in_view_0) / w_1), 0.5f - 0.5f * (dot(projection_0[i32(1)], in_view_0) / w_1), abs(_S36), w_1);
}

@compute
@workgroup_size(64, 1, 1)
fn run_light_coordinates(@builtin(global_invocation_id) thread_15 : vec3<u32>)
{
    var _S37 : u32 = thread_15.x;
    var start_14 : u32 = _S37 * u32(35);
    var result_11 : vec4<f32> = skin_light_coordinates_0(vec3<f32>(inputs_0[start_14], inputs_0[start_14 + u32(1)], inputs_0[start_14 + u32(2)]), mat4x4<f32>(inputs_0[start_14 + u32(3)], inputs_0[start_14 + u32(4)], inputs_0[start_14 + u32(5)], inputs_0[start_14 + u32(6)], inputs_0[start_14 + u32(7)], inputs_0[start_14 + u32(8)], inputs_0[start_14 + u32(9)], inputs_0[start_14 + u32(10)], inputs_0[start_14 + u32(11)], inputs_0[start_14 + u32(12)], inputs_0[start_14 + u32(13)], inputs_0[start_14 + u32(14)], inputs_0[start_14 + u32(15)], inputs_0[start_14 + u32(16)], inputs_0[start_14 + u32(17)], inputs_0[start_14 + u32(18)]), mat4x4<f32>(inputs_0[start_14 + u32(19)], inputs_0[start_14 + u32(20)], inputs_0[start_14 + u32(21)], inputs_0[start_14 + u32(22)], inputs_0[start_14 + u32(23)], inputs_0[start_14 + u32(24)], inputs_0[start_14 + u32(25)], inputs_0[start_14 + u32(26)], inputs_0[start_14 + u32(27)], inputs_0[start_14 + u32(28)], inputs_0[start_14 + u32(29)], inputs_0[start_14 + u32(30)], inputs_0[start_14 + u32(31)], inputs_0[start_14 + u32(32)], inputs_0[start_14 + u32(33)], inputs_0[start_14 + u32(34)]));
    var _S38 : u32 = _S37 * u32(4);
    outputs_0[_S38] = result_11[i32(0)];
    outputs_0[_S38 + u32(1)] = result_11[i32(1)];
    outputs_0[_S38 + u32(2)] = result_11[i32(2)];
    outputs_0[_S38 + u32(3)] = result_11[i32(3)];
    return;
}

fn skin_unit_vectors_0( v_1 : vec3<f32>) -> vec3<f32>
{
    return v_1 / vec3<f32>(skin_safe_length_0(v_1));
}

fn skin_shadow_receiver_0( position_mm_1 : vec3<f32>,  normal_1 : vec3<f32>,  to_light_0 : vec3<f32>,  curvature_per_mm_3 : f32) -> vec3<f32>
{
    var cosine_1 : f32 = dot(normal_1, to_light_0);
    return position_mm_1 + skin_unit_vectors_0(to_light_0 - normal_1 * vec3<f32>(cosine_1)) * vec3<f32>(min(max(- cosine_1, 0.0f) / max(curvature_per_mm_3, 0.00100000004749745f), 8.0f));
}

@compute
@workgroup_size(64, 1, 1)
fn run_shadow_receiver(@builtin(global_invocation_id) thread_16 : vec3<u32>)
{
    var _S39 : u32 = thread_16.x;
    var start_15 : u32 = _S39 * u32(10);
    var result_12 : vec3<f32> = skin_shadow_receiver_0(vec3<f32>(inputs_0[start_15], inputs_0[start_15 + u32(1)], inputs_0[start_15 + u32(2)]), vec3<f32>(inputs_0[start_15 + u32(3)], inputs_0[start_15 + u32(4)], inputs_0[start_15 + u32(5)]), vec3<f32>(inputs_0[start_15 + u32(6)], inputs_0[start_15 + u32(7)], inputs_0[start_15 + u32(8)]), inputs_0[start_15 + u32(9)]);
    var _S40 : u32 = _S39 * u32(3);
    outputs_0[_S40] = result_12[i32(0)];
    outputs_0[_S40 + u32(1)] = result_12[i32(1)];
    outputs_0[_S40 + u32(2)] = result_12[i32(2)];
    return;
}

fn skin_plane_slope_0( normal_2 : vec3<f32>,  to_light_1 : vec3<f32>,  light_right_0 : vec3<f32>,  light_up_0 : vec3<f32>,  least_cosine_0 : f32) -> vec2<f32>
{
    var axis_0 : vec3<f32> = cross(light_right_0, light_up_0);
    var handedness_0 : f32;
    if((dot(to_light_1, axis_0)) < 0.0f)
    {
        handedness_0 = -1.0f;
    }
    else
    {
        handedness_0 = 1.0f;
    }
    return vec2<f32>(dot(normal_2, light_right_0), - dot(normal_2, light_up_0)) / vec2<f32>(max(handedness_0 * dot(normal_2, axis_0), least_cosine_0));
}

fn skin_shadow_slope_0( normal_3 : vec3<f32>,  to_light_2 : vec3<f32>,  curvature_per_mm_4 : f32,  light_right_1 : vec3<f32>,  light_up_1 : vec3<f32>) -> vec2<f32>
{
    var slope_4 : vec2<f32> = skin_plane_slope_0(skin_unit_vectors_0(normal_3 + to_light_2 * vec3<f32>(max(- dot(normal_3, to_light_2), 0.0f))), to_light_2, light_right_1, light_up_1, 0.00100000004749745f);
    return slope_4 / vec2<f32>(max(length(slope_4) / (1.0f + 7.0f * saturate(1.0f + curvature_per_mm_4 / 0.03999999910593033f)), 1.0f));
}

@compute
@workgroup_size(64, 1, 1)
fn run_shadow_slope(@builtin(global_invocation_id) thread_17 : vec3<u32>)
{
    var _S41 : u32 = thread_17.x;
    var start_16 : u32 = _S41 * u32(13);
    var result_13 : vec2<f32> = skin_shadow_slope_0(vec3<f32>(inputs_0[start_16], inputs_0[start_16 + u32(1)], inputs_0[start_16 + u32(2)]), vec3<f32>(inputs_0[start_16 + u32(3)], inputs_0[start_16 + u32(4)], inputs_0[start_16 + u32(5)]), inputs_0[start_16 + u32(6)], vec3<f32>(inputs_0[start_16 + u32(7)], inputs_0[start_16 + u32(8)], inputs_0[start_16 + u32(9)]), vec3<f32>(inputs_0[start_16 + u32(10)], inputs_0[start_16 + u32(11)], inputs_0[start_16 + u32(12)]));
    var _S42 : u32 = _S41 * u32(2);
    outputs_0[_S42] = result_13[i32(0)];
    outputs_0[_S42 + u32(1)] = result_13[i32(1)];
    return;
}

fn skin_shadow_occluder_depth_0( depth_mm_0 : f32,  faces_light_0 : f32) -> f32
{
    return depth_mm_0 + 4.0f * faces_light_0;
}

@compute
@workgroup_size(64, 1, 1)
fn run_shadow_occluder_depth(@builtin(global_invocation_id) thread_18 : vec3<u32>)
{
    var _S43 : u32 = thread_18.x;
    var start_17 : u32 = _S43 * u32(2);
    outputs_0[_S43] = skin_shadow_occluder_depth_0(inputs_0[start_17], inputs_0[start_17 + u32(1)]);
    return;
}

fn skin_linear_depth_0( depth_0 : f32,  projection_1 : mat4x4<f32>) -> f32
{
    return abs((depth_0 * projection_1[i32(3)][i32(3)] - projection_1[i32(2)][i32(3)]) / (projection_1[i32(2)][i32(2)] - depth_0 * projection_1[i32(3)][i32(2)]));
}

fn skin_shadow_compare_0( depth_map_1 : texture_2d<f32>,  depth_map_sampler_1 : sampler,  map_extent_1 : vec2<f32>,  projection_2 : mat4x4<f32>,  uv_0 : vec2<f32>,  receiver_mm_0 : f32) -> f32
{
    var _S44 : vec2<f32> = vec2<f32>(0.5f);
    var position_0 : vec2<f32> = uv_0 * map_extent_1 - _S44;
    var corner_0 : vec2<f32> = floor(position_0);
    var weights_1 : vec2<f32> = position_0 - corner_0;
    var _S45 : vec2<f32> = vec2<f32>(0.0f);
    var _S46 : vec2<f32> = vec2<f32>(1.0f);
    var _S47 : vec2<f32> = map_extent_1 - _S46;
    var low_1 : vec2<f32> = (clamp(corner_0, _S45, _S47) + _S44) / map_extent_1;
    var high_1 : vec2<f32> = (clamp(corner_0 + _S46, _S45, _S47) + _S44) / map_extent_1;
    var lit_0 : vec4<f32> = step(vec4<f32>(receiver_mm_0, receiver_mm_0, receiver_mm_0, receiver_mm_0), vec4<f32>(skin_linear_depth_0((textureSampleLevel((depth_map_1), (depth_map_sampler_1), (low_1), (0.0f))).x, projection_2), skin_linear_depth_0((textureSampleLevel((depth_map_1), (depth_map_sampler_1), (vec2<f32>(high_1.x, low_1.y)), (0.0f))).x, projection_2), skin_linear_depth_0((textureSampleLevel((depth_map_1), (depth_map_sampler_1), (vec2<f32>(low_1.x, high_1.y)), (0.0f))).x, projection_2), skin_linear_depth_0((textureSampleLevel((depth_map_1), (depth_map_sampler_1), (high_1), (0.0f))).x, projection_2)));
    var rows_1 : vec2<f32> = mix(lit_0.xz, lit_0.yw, vec2<f32>(weights_1.x));
    return mix(rows_1.x, rows_1.y, weights_1.y);
}

fn skin_shadow_filter_0( depth_map_2 : texture_2d<f32>,  depth_map_sampler_2 : sampler,  map_extent_2 : vec2<f32>,  view_1 : mat4x4<f32>,  projection_3 : mat4x4<f32>,  position_mm_2 : vec3<f32>,  normal_4 : vec3<f32>,  to_light_3 : vec3<f32>,  curvature_per_mm_5 : f32,  filter_width_mm_0 : f32,  bias_mm_0 : f32,  taps_0 : i32) -> f32
{
    var coordinates_0 : vec4<f32> = skin_light_coordinates_0(skin_shadow_receiver_0(position_mm_2, normal_4, to_light_3, curvature_per_mm_5), view_1, projection_3);
    var _S48 : vec2<f32> = skin_shadow_slope_0(normal_4, to_light_3, curvature_per_mm_5, view_1[i32(0)].xyz, view_1[i32(1)].xyz);
    var _S49 : vec2<f32> = vec2<f32>(0.5f) * vec2<f32>(abs(projection_3[i32(0)].x), abs(projection_3[i32(1)].y)) / vec2<f32>(abs(coordinates_0.w));
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
        var disk_0 : vec2<f32>;
        if(taps_0 == i32(16))
        {
            disk_0 = SKIN_SHADOW_DISK_16_0[min(tap_0, i32(15))];
        }
        else
        {
            disk_0 = SKIN_SHADOW_DISK_48_0[min(tap_0, i32(47))];
        }
        var across_mm_0 : vec2<f32> = vec2<f32>((0.5f * filter_width_mm_0)) * disk_0;
        var total_2 : f32 = total_1 + skin_shadow_compare_0(depth_map_2, depth_map_sampler_2, map_extent_2, projection_3, coordinates_0.xy + across_mm_0 * _S49, coordinates_0.z - bias_mm_0 + dot(_S48, across_mm_0));
        tap_0 = tap_0 + i32(1);
        total_1 = total_2;
    }
    return total_1 / f32(max(taps_0, i32(1)));
}

@compute
@workgroup_size(64, 1, 1)
fn run_shadow_filter(@builtin(global_invocation_id) thread_19 : vec3<u32>)
{
    var _S50 : u32 = thread_19.x;
    var start_18 : u32 = _S50 * u32(47);
    outputs_0[_S50] = skin_shadow_filter_0(depth_map_0, depth_map_sampler_0, vec2<f32>(inputs_0[start_18], inputs_0[start_18 + u32(1)]), mat4x4<f32>(inputs_0[start_18 + u32(2)], inputs_0[start_18 + u32(3)], inputs_0[start_18 + u32(4)], inputs_0[start_18 + u32(5)], inputs_0[start_18 + u32(6)], inputs_0[start_18 + u32(7)], inputs_0[start_18 + u32(8)], inputs_0[start_18 + u32(9)], inputs_0[start_18 + u32(10)], inputs_0[start_18 + u32(11)], inputs_0[start_18 + u32(12)], inputs_0[start_18 + u32(13)], inputs_0[start_18 + u32(14)], inputs_0[start_18 + u32(15)], inputs_0[start_18 + u32(16)], inputs_0[start_18 + u32(17)]), mat4x4<f32>(inputs_0[start_18 + u32(18)], inputs_0[start_18 + u32(19)], inputs_0[start_18 + u32(20)], inputs_0[start_18 + u32(21)], inputs_0[start_18 + u32(22)], inputs_0[start_18 + u32(23)], inputs_0[start_18 + u32(24)], inputs_0[start_18 + u32(25)], inputs_0[start_18 + u32(26)], inputs_0[start_18 + u32(27)], inputs_0[start_18 + u32(28)], inputs_0[start_18 + u32(29)], inputs_0[start_18 + u32(30)], inputs_0[start_18 + u32(31)], inputs_0[start_18 + u32(32)], inputs_0[start_18 + u32(33)]), vec3<f32>(inputs_0[start_18 + u32(34)], inputs_0[start_18 + u32(35)], inputs_0[start_18 + u32(36)]), vec3<f32>(inputs_0[start_18 + u32(37)], inputs_0[start_18 + u32(38)], inputs_0[start_18 + u32(39)]), vec3<f32>(inputs_0[start_18 + u32(40)], inputs_0[start_18 + u32(41)], inputs_0[start_18 + u32(42)]), inputs_0[start_18 + u32(43)], inputs_0[start_18 + u32(44)], inputs_0[start_18 + u32(45)], i32(inputs_0[start_18 + u32(46)]));
    return;
}

fn skin_diffused_shadow_0( lut_5 : texture_2d<f32>,  lut_sampler_5 : sampler,  lut_axes_4 : vec4<f32>,  shadow_filter_0 : f32,  n_dot_l_0 : f32,  filter_width_mm_1 : f32) -> vec3<f32>
{
    return (textureSampleLevel((lut_5), (lut_sampler_5), (saturate((vec2<f32>(shadow_filter_0, max(n_dot_l_0, 0.05000000074505806f) / filter_width_mm_1) - lut_axes_4.xz) * lut_axes_4.yw)), (0.0f))).xyz;
}

@compute
@workgroup_size(64, 1, 1)
fn run_diffused_shadow(@builtin(global_invocation_id) thread_20 : vec3<u32>)
{
    var _S51 : u32 = thread_20.x;
    var start_19 : u32 = _S51 * u32(7);
    var result_14 : vec3<f32> = skin_diffused_shadow_0(lut_0, lut_sampler_0, vec4<f32>(inputs_0[start_19], inputs_0[start_19 + u32(1)], inputs_0[start_19 + u32(2)], inputs_0[start_19 + u32(3)]), inputs_0[start_19 + u32(4)], inputs_0[start_19 + u32(5)], inputs_0[start_19 + u32(6)]);
    var _S52 : u32 = _S51 * u32(3);
    outputs_0[_S52] = result_14[i32(0)];
    outputs_0[_S52 + u32(1)] = result_14[i32(1)];
    outputs_0[_S52 + u32(2)] = result_14[i32(2)];
    return;
}

fn skin_sharpened_shadow_0( shadow_filter_1 : f32,  sharpening_0 : f32) -> f32
{
    return skin_smoothstep_0((0.5f - sin(asin(1.0f - 2.0f * saturate(shadow_filter_1)) / 3.0f) - 0.5f) * sharpening_0 + 0.5f);
}

@compute
@workgroup_size(64, 1, 1)
fn run_sharpened_shadow(@builtin(global_invocation_id) thread_21 : vec3<u32>)
{
    var _S53 : u32 = thread_21.x;
    var start_20 : u32 = _S53 * u32(2);
    outputs_0[_S53] = skin_sharpened_shadow_0(inputs_0[start_20], inputs_0[start_20 + u32(1)]);
    return;
}

fn skin_variance_shadow_0( mean_depth_mm_0 : f32,  mean_square_depth_mm2_0 : f32,  depth_mm_1 : f32) -> f32
{
    var _S54 : f32 = max(mean_square_depth_mm2_0 - mean_depth_mm_0 * mean_depth_mm_0, 0.00999999977648258f);
    var _S55 : f32 = max(depth_mm_1 - mean_depth_mm_0, 0.0f);
    return _S54 / (_S54 + _S55 * _S55);
}

@compute
@workgroup_size(64, 1, 1)
fn run_variance_shadow(@builtin(global_invocation_id) thread_22 : vec3<u32>)
{
    var _S56 : u32 = thread_22.x;
    var start_21 : u32 = _S56 * u32(3);
    outputs_0[_S56] = skin_variance_shadow_0(inputs_0[start_21], inputs_0[start_21 + u32(1)], inputs_0[start_21 + u32(2)]);
    return;
}

fn skin_contact_slope_0( face_normal_0 : vec3<f32>,  to_light_4 : vec3<f32>,  light_right_2 : vec3<f32>,  light_up_2 : vec3<f32>) -> vec2<f32>
{
    return skin_plane_slope_0(face_normal_0, to_light_4, light_right_2, light_up_2, 0.05000000074505806f);
}

@compute
@workgroup_size(64, 1, 1)
fn run_contact_slope(@builtin(global_invocation_id) thread_23 : vec3<u32>)
{
    var _S57 : u32 = thread_23.x;
    var start_22 : u32 = _S57 * u32(12);
    var result_15 : vec2<f32> = skin_contact_slope_0(vec3<f32>(inputs_0[start_22], inputs_0[start_22 + u32(1)], inputs_0[start_22 + u32(2)]), vec3<f32>(inputs_0[start_22 + u32(3)], inputs_0[start_22 + u32(4)], inputs_0[start_22 + u32(5)]), vec3<f32>(inputs_0[start_22 + u32(6)], inputs_0[start_22 + u32(7)], inputs_0[start_22 + u32(8)]), vec3<f32>(inputs_0[start_22 + u32(9)], inputs_0[start_22 + u32(10)], inputs_0[start_22 + u32(11)]));
    var _S58 : u32 = _S57 * u32(2);
    outputs_0[_S58] = result_15[i32(0)];
    outputs_0[_S58 + u32(1)] = result_15[i32(1)];
    return;
}

fn skin_faded_contact_0( share_0 : f32,  cosine_2 : f32) -> f32
{
    return 1.0f - saturate((cosine_2 - 0.05000000074505806f) / 0.10000000894069672f) * (1.0f - share_0);
}

@compute
@workgroup_size(64, 1, 1)
fn run_faded_contact(@builtin(global_invocation_id) thread_24 : vec3<u32>)
{
    var _S59 : u32 = thread_24.x;
    var start_23 : u32 = _S59 * u32(2);
    outputs_0[_S59] = skin_faded_contact_0(inputs_0[start_23], inputs_0[start_23 + u32(1)]);
    return;
}

fn skin_contact_bias_0( slope_5 : vec2<f32>) -> f32
{
    return 0.80000001192092896f + 0.30000001192092896f * length(slope_5);
}

fn skin_contact_compare_0( depths_0 : vec4<f32>,  receiver_mm_1 : f32,  rise_0 : vec2<f32>,  weights_2 : vec2<f32>) -> f32
{
    var _S60 : f32 = rise_0.x;
    var _S61 : f32 = rise_0.y;
    var lit_1 : vec4<f32> = step(vec4<f32>(receiver_mm_1) + vec4<f32>(0.0f, _S60, _S61, _S60 + _S61), depths_0);
    var rows_2 : vec2<f32> = mix(lit_1.xz, lit_1.yw, vec2<f32>(weights_2.x));
    return mix(rows_2.x, rows_2.y, weights_2.y);
}

fn skin_contact_filter_0( depth_map_3 : texture_2d<f32>,  depth_map_sampler_3 : sampler,  map_extent_3 : vec2<f32>,  view_2 : mat4x4<f32>,  projection_4 : mat4x4<f32>,  position_mm_3 : vec3<f32>,  face_normal_1 : vec3<f32>,  to_light_5 : vec3<f32>) -> f32
{
    var coordinates_1 : vec4<f32> = skin_light_coordinates_0(position_mm_3, view_2, projection_4);
    var slope_6 : vec2<f32> = skin_contact_slope_0(face_normal_1, to_light_5, view_2[i32(0)].xyz, view_2[i32(1)].xyz);
    var _S62 : vec2<f32> = vec2<f32>(0.5f);
    var texels_per_mm_0 : vec2<f32> = _S62 * vec2<f32>(abs(projection_4[i32(0)].x), abs(projection_4[i32(1)].y)) / vec2<f32>(abs(coordinates_1.w)) * map_extent_3;
    var _S63 : vec2<f32> = slope_6 / texels_per_mm_0;
    var _S64 : vec2<f32> = coordinates_1.xy * map_extent_3 - _S62;
    var _S65 : f32 = coordinates_1.z - skin_contact_bias_0(slope_6);
    var tap_1 : i32 = i32(0);
    var total_3 : f32 = 0.0f;
    for(;;)
    {
        if(tap_1 < i32(12))
        {
        }
        else
        {
            break;
        }
        var position_1 : vec2<f32> = _S64 + vec2<f32>(0.60000002384185791f) * SKIN_CONTACT_DISK_0[tap_1] * texels_per_mm_0;
        var corner_1 : vec2<f32> = floor(position_1);
        var _S66 : vec2<f32> = vec2<f32>(0.0f);
        var _S67 : vec2<f32> = vec2<f32>(1.0f);
        var _S68 : vec2<f32> = map_extent_3 - _S67;
        var low_2 : vec2<f32> = (clamp(corner_1, _S66, _S68) + _S62) / map_extent_3;
        var high_2 : vec2<f32> = (clamp(corner_1 + _S67, _S66, _S68) + _S62) / map_extent_3;
        var total_4 : f32 = total_3 + skin_contact_compare_0(vec4<f32>(skin_linear_depth_0((textureSampleLevel((depth_map_3), (depth_map_sampler_3), (low_2), (0.0f))).x, projection_4), skin_linear_depth_0((textureSampleLevel((depth_map_3), (depth_map_sampler_3), (vec2<f32>(high_2.x, low_2.y)), (0.0f))).x, projection_4), skin_linear_depth_0((textureSampleLevel((depth_map_3), (depth_map_sampler_3), (vec2<f32>(low_2.x, high_2.y)), (0.0f))).x, projection_4), skin_linear_depth_0((textureSampleLevel((depth_map_3), (depth_map_sampler_3), (high_2), (0.0f))).x, projection_4)), _S65 + dot(corner_1 - _S64, _S63), _S63, position_1 - corner_1);
        tap_1 = tap_1 + i32(1);
        total_3 = total_4;
    }
    return skin_faded_contact_0(total_3 / 12.0f, dot(face_normal_1, to_light_5));
}

@compute
@workgroup_size(64, 1, 1)
fn run_contact_filter(@builtin(global_invocation_id) thread_25 : vec3<u32>)
{
    var _S69 : u32 = thread_25.x;
    var start_24 : u32 = _S69 * u32(43);
    outputs_0[_S69] = skin_contact_filter_0(depth_map_0, depth_map_sampler_0, vec2<f32>(inputs_0[start_24], inputs_0[start_24 + u32(1)]), mat4x4<f32>(inputs_0[start_24 + u32(2)], inputs_0[start_24 + u32(3)], inputs_0[start_24 + u32(4)], inputs_0[start_24 + u32(5)], inputs_0[start_24 + u32(6)], inputs_0[start_24 + u32(7)], inputs_0[start_24 + u32(8)], inputs_0[start_24 + u32(9)], inputs_0[start_24 + u32(10)], inputs_0[start_24 + u32(11)], inputs_0[start_24 + u32(12)], inputs_0[start_24 + u32(13)], inputs_0[start_24 + u32(14)], inputs_0[start_24 + u32(15)], inputs_0[start_24 + u32(16)], inputs_0[start_24 + u32(17)]), mat4x4<f32>(inputs_0[start_24 + u32(18)], inputs_0[start_24 + u32(19)], inputs_0[start_24 + u32(20)], inputs_0[start_24 + u32(21)], inputs_0[start_24 + u32(22)], inputs_0[start_24 + u32(23)], inputs_0[start_24 + u32(24)], inputs_0[start_24 + u32(25)], inputs_0[start_24 + u32(26)], inputs_0[start_24 + u32(27)], inputs_0[start_24 + u32(28)], inputs_0[start_24 + u32(29)], inputs_0[start_24 + u32(30)], inputs_0[start_24 + u32(31)], inputs_0[start_24 + u32(32)], inputs_0[start_24 + u32(33)]), vec3<f32>(inputs_0[start_24 + u32(34)], inputs_0[start_24 + u32(35)], inputs_0[start_24 + u32(36)]), vec3<f32>(inputs_0[start_24 + u32(37)], inputs_0[start_24 + u32(38)], inputs_0[start_24 + u32(39)]), vec3<f32>(inputs_0[start_24 + u32(40)], inputs_0[start_24 + u32(41)], inputs_0[start_24 + u32(42)]));
    return;
}

fn skin_contact_shadow_0( lut_6 : texture_2d<f32>,  lut_sampler_6 : sampler,  lut_axes_5 : vec4<f32>,  shadow_0 : vec3<f32>,  contact_0 : f32,  filter_width_mm_2 : f32) -> vec3<f32>
{
    return min(shadow_0, vec3<f32>(contact_0) + vec3<f32>((1.0f - contact_0)) * skin_diffused_shadow_0(lut_6, lut_sampler_6, lut_axes_5, skin_smoothstep_0(0.5f - 0.60000002384185791f / filter_width_mm_2), 1.0f, filter_width_mm_2));
}

@compute
@workgroup_size(64, 1, 1)
fn run_contact_shadow(@builtin(global_invocation_id) thread_26 : vec3<u32>)
{
    var _S70 : u32 = thread_26.x;
    var start_25 : u32 = _S70 * u32(9);
    var result_16 : vec3<f32> = skin_contact_shadow_0(lut_0, lut_sampler_0, vec4<f32>(inputs_0[start_25], inputs_0[start_25 + u32(1)], inputs_0[start_25 + u32(2)], inputs_0[start_25 + u32(3)]), vec3<f32>(inputs_0[start_25 + u32(4)], inputs_0[start_25 + u32(5)], inputs_0[start_25 + u32(6)]), inputs_0[start_25 + u32(7)], inputs_0[start_25 + u32(8)]);
    var _S71 : u32 = _S70 * u32(3);
    outputs_0[_S71] = result_16[i32(0)];
    outputs_0[_S71 + u32(1)] = result_16[i32(1)];
    outputs_0[_S71 + u32(2)] = result_16[i32(2)];
    return;
}

fn skin_sh_bands_0( sh_0 : mat3x3<f32>,  d_0 : vec3<f32>) -> vec3<f32>
{
    var _S72 : f32 = d_0.y;
    var _S73 : f32 = d_0.z;
    var _S74 : f32 = d_0.x;
    return vec3<f32>(0.282094806432724f * sh_0[i32(0)].x, 0.48860251903533936f * (sh_0[i32(0)].y * _S72 + sh_0[i32(0)].z * _S73 + sh_0[i32(1)].x * _S74), 1.09254848957061768f * (sh_0[i32(1)].y * _S74 * _S72 + sh_0[i32(1)].z * _S72 * _S73 + sh_0[i32(2)].y * _S74 * _S73) + 0.31539157032966614f * sh_0[i32(2)].x * (3.0f * _S73 * _S73 - dot(d_0, d_0)) + 0.54627424478530884f * sh_0[i32(2)].z * (_S74 * _S74 - _S72 * _S72));
}

fn skin_ambient_channel_0( sh_1 : mat3x3<f32>,  normal_5 : vec3<f32>,  band_transfer_0 : vec3<f32>) -> f32
{
    return max(dot(skin_sh_bands_0(sh_1, normal_5), vec3<f32>(1.0f, 1.0f, skin_safe_length_0(normal_5)) * band_transfer_0 * vec3<f32>(1.0f, 0.66666668653488159f, 0.25f)), 0.0f);
}

fn skin_ambient_irradiance_0( radiance_sh_red_0 : mat3x3<f32>,  radiance_sh_green_0 : mat3x3<f32>,  radiance_sh_blue_0 : mat3x3<f32>,  normals_5 : mat3x3<f32>,  band_transfer_1 : mat3x3<f32>) -> vec3<f32>
{
    var t_0 : mat3x3<f32> = transpose(band_transfer_1);
    return vec3<f32>(skin_ambient_channel_0(radiance_sh_red_0, normals_5[i32(0)], t_0[i32(0)]), skin_ambient_channel_0(radiance_sh_green_0, normals_5[i32(1)], t_0[i32(1)]), skin_ambient_channel_0(radiance_sh_blue_0, normals_5[i32(2)], t_0[i32(2)]));
}

@compute
@workgroup_size(64, 1, 1)
fn run_ambient_irradiance(@builtin(global_invocation_id) thread_27 : vec3<u32>)
{
    var _S75 : u32 = thread_27.x;
    var start_26 : u32 = _S75 * u32(45);
    var result_17 : vec3<f32> = skin_ambient_irradiance_0(mat3x3<f32>(inputs_0[start_26], inputs_0[start_26 + u32(1)], inputs_0[start_26 + u32(2)], inputs_0[start_26 + u32(3)], inputs_0[start_26 + u32(4)], inputs_0[start_26 + u32(5)], inputs_0[start_26 + u32(6)], inputs_0[start_26 + u32(7)], inputs_0[start_26 + u32(8)]), mat3x3<f32>(inputs_0[start_26 + u32(9)], inputs_0[start_26 + u32(10)], inputs_0[start_26 + u32(11)], inputs_0[start_26 + u32(12)], inputs_0[start_26 + u32(13)], inputs_0[start_26 + u32(14)], inputs_0[start_26 + u32(15)], inputs_0[start_26 + u32(16)], inputs_0[start_26 + u32(17)]), mat3x3<f32>(inputs_0[start_26 + u32(18)], inputs_0[start_26 + u32(19)], inputs_0[start_26 + u32(20)], inputs_0[start_26 + u32(21)], inputs_0[start_26 + u32(22)], inputs_0[start_26 + u32(23)], inputs_0[start_26 + u32(24)], inputs_0[start_26 + u32(25)], inputs_0[start_26 + u32(26)]), mat3x3<f32>(inputs_0[start_26 + u32(27)], inputs_0[start_26 + u32(28)], inputs_0[start_26 + u32(29)], inputs_0[start_26 + u32(30)], inputs_0[start_26 + u32(31)], inputs_0[start_26 + u32(32)], inputs_0[start_26 + u32(33)], inputs_0[start_26 + u32(34)], inputs_0[start_26 + u32(35)]), mat3x3<f32>(inputs_0[start_26 + u32(36)], inputs_0[start_26 + u32(37)], inputs_0[start_26 + u32(38)], inputs_0[start_26 + u32(39)], inputs_0[start_26 + u32(40)], inputs_0[start_26 + u32(41)], inputs_0[start_26 + u32(42)], inputs_0[start_26 + u32(43)], inputs_0[start_26 + u32(44)]));
    var _S76 : u32 = _S75 * u32(3);
    outputs_0[_S76] = result_17[i32(0)];
    outputs_0[_S76 + u32(1)] = result_17[i32(1)];
    outputs_0[_S76 + u32(2)] = result_17[i32(2)];
    return;
}

fn skin_ambient_normals_0( normals_6 : mat3x3<f32>) -> mat3x3<f32>
{
    return mat3x3<f32>(skin_unit_vectors_0(normals_6[i32(0)]), skin_unit_vectors_0(normals_6[i32(1)]), skin_unit_vectors_0(normals_6[i32(2)]));
}

@compute
@workgroup_size(64, 1, 1)
fn run_ambient_normals(@builtin(global_invocation_id) thread_28 : vec3<u32>)
{
    var start_27 : u32 = thread_28.x * u32(9);
    var _S77 : u32 = start_27 + u32(1);
    var _S78 : u32 = start_27 + u32(2);
    var _S79 : u32 = start_27 + u32(3);
    var _S80 : u32 = start_27 + u32(4);
    var _S81 : u32 = start_27 + u32(5);
    var _S82 : u32 = start_27 + u32(6);
    var _S83 : u32 = start_27 + u32(7);
    var _S84 : u32 = start_27 + u32(8);
    var result_18 : mat3x3<f32> = skin_ambient_normals_0(mat3x3<f32>(inputs_0[start_27], inputs_0[_S77], inputs_0[_S78], inputs_0[_S79], inputs_0[_S80], inputs_0[_S81], inputs_0[_S82], inputs_0[_S83], inputs_0[_S84]));
    outputs_0[start_27] = result_18[i32(0)][i32(0)];
    outputs_0[_S77] = result_18[i32(0)][i32(1)];
    outputs_0[_S78] = result_18[i32(0)][i32(2)];
    outputs_0[_S79] = result_18[i32(1)][i32(0)];
    outputs_0[_S80] = result_18[i32(1)][i32(1)];
    outputs_0[_S81] = result_18[i32(1)][i32(2)];
    outputs_0[_S82] = result_18[i32(2)][i32(0)];
    outputs_0[_S83] = result_18[i32(2)][i32(1)];
    outputs_0[_S84] = result_18[i32(2)][i32(2)];
    return;
}

fn skin_ambient_of_three_0( red_0 : vec3<f32>,  green_0 : vec3<f32>,  blue_0 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(red_0.x, green_0.y, blue_0.z);
}

@compute
@workgroup_size(64, 1, 1)
fn run_ambient_of_three(@builtin(global_invocation_id) thread_29 : vec3<u32>)
{
    var _S85 : u32 = thread_29.x;
    var start_28 : u32 = _S85 * u32(9);
    var result_19 : vec3<f32> = skin_ambient_of_three_0(vec3<f32>(inputs_0[start_28], inputs_0[start_28 + u32(1)], inputs_0[start_28 + u32(2)]), vec3<f32>(inputs_0[start_28 + u32(3)], inputs_0[start_28 + u32(4)], inputs_0[start_28 + u32(5)]), vec3<f32>(inputs_0[start_28 + u32(6)], inputs_0[start_28 + u32(7)], inputs_0[start_28 + u32(8)]));
    var _S86 : u32 = _S85 * u32(3);
    outputs_0[_S86] = result_19[i32(0)];
    outputs_0[_S86 + u32(1)] = result_19[i32(1)];
    outputs_0[_S86 + u32(2)] = result_19[i32(2)];
    return;
}

fn skin_bounced_visibility_0( visibility_0 : vec3<f32>,  albedo_4 : vec3<f32>) -> vec3<f32>
{
    return max(visibility_0, ((visibility_0 * (vec3<f32>(2.04040002822875977f) * albedo_4 - vec3<f32>(0.33239999413490295f)) + (vec3<f32>(-4.79510021209716797f) * albedo_4 + vec3<f32>(0.64170002937316895f))) * visibility_0 + (vec3<f32>(2.75519990921020508f) * albedo_4 + vec3<f32>(0.69029998779296875f))) * visibility_0);
}

@compute
@workgroup_size(64, 1, 1)
fn run_bounced_visibility(@builtin(global_invocation_id) thread_30 : vec3<u32>)
{
    var _S87 : u32 = thread_30.x;
    var start_29 : u32 = _S87 * u32(6);
    var result_20 : vec3<f32> = skin_bounced_visibility_0(vec3<f32>(inputs_0[start_29], inputs_0[start_29 + u32(1)], inputs_0[start_29 + u32(2)]), vec3<f32>(inputs_0[start_29 + u32(3)], inputs_0[start_29 + u32(4)], inputs_0[start_29 + u32(5)]));
    var _S88 : u32 = _S87 * u32(3);
    outputs_0[_S88] = result_20[i32(0)];
    outputs_0[_S88 + u32(1)] = result_20[i32(1)];
    outputs_0[_S88 + u32(2)] = result_20[i32(2)];
    return;
}

fn skin_sh_product_0( a_0 : mat3x3<f32>,  b_0 : mat3x3<f32>) -> f32
{
    return dot(a_0[i32(0)], b_0[i32(0)]) + dot(a_0[i32(1)], b_0[i32(1)]) + dot(a_0[i32(2)], b_0[i32(2)]);
}

fn skin_transferred_irradiance_0( ambient_transfer_red_0 : mat3x3<f32>,  ambient_transfer_green_0 : mat3x3<f32>,  ambient_transfer_blue_0 : mat3x3<f32>,  radiance_sh_red_1 : mat3x3<f32>,  radiance_sh_green_1 : mat3x3<f32>,  radiance_sh_blue_1 : mat3x3<f32>) -> vec3<f32>
{
    return max(vec3<f32>(skin_sh_product_0(ambient_transfer_red_0, radiance_sh_red_1), skin_sh_product_0(ambient_transfer_green_0, radiance_sh_green_1), skin_sh_product_0(ambient_transfer_blue_0, radiance_sh_blue_1)), vec3<f32>(0.0f));
}

@compute
@workgroup_size(64, 1, 1)
fn run_transferred_irradiance(@builtin(global_invocation_id) thread_31 : vec3<u32>)
{
    var _S89 : u32 = thread_31.x;
    var start_30 : u32 = _S89 * u32(54);
    var result_21 : vec3<f32> = skin_transferred_irradiance_0(mat3x3<f32>(inputs_0[start_30], inputs_0[start_30 + u32(1)], inputs_0[start_30 + u32(2)], inputs_0[start_30 + u32(3)], inputs_0[start_30 + u32(4)], inputs_0[start_30 + u32(5)], inputs_0[start_30 + u32(6)], inputs_0[start_30 + u32(7)], inputs_0[start_30 + u32(8)]), mat3x3<f32>(inputs_0[start_30 + u32(9)], inputs_0[start_30 + u32(10)], inputs_0[start_30 + u32(11)], inputs_0[start_30 + u32(12)], inputs_0[start_30 + u32(13)], inputs_0[start_30 + u32(14)], inputs_0[start_30 + u32(15)], inputs_0[start_30 + u32(16)], inputs_0[start_30 + u32(17)]), mat3x3<f32>(inputs_0[start_30 + u32(18)], inputs_0[start_30 + u32(19)], inputs_0[start_30 + u32(20)], inputs_0[start_30 + u32(21)], inputs_0[start_30 + u32(22)], inputs_0[start_30 + u32(23)], inputs_0[start_30 + u32(24)], inputs_0[start_30 + u32(25)], inputs_0[start_30 + u32(26)]), mat3x3<f32>(inputs_0[start_30 + u32(27)], inputs_0[start_30 + u32(28)], inputs_0[start_30 + u32(29)], inputs_0[start_30 + u32(30)], inputs_0[start_30 + u32(31)], inputs_0[start_30 + u32(32)], inputs_0[start_30 + u32(33)], inputs_0[start_30 + u32(34)], inputs_0[start_30 + u32(35)]), mat3x3<f32>(inputs_0[start_30 + u32(36)], inputs_0[start_30 + u32(37)], inputs_0[start_30 + u32(38)], inputs_0[start_30 + u32(39)], inputs_0[start_30 + u32(40)], inputs_0[start_30 + u32(41)], inputs_0[start_30 + u32(42)], inputs_0[start_30 + u32(43)], inputs_0[start_30 + u32(44)]), mat3x3<f32>(inputs_0[start_30 + u32(45)], inputs_0[start_30 + u32(46)], inputs_0[start_30 + u32(47)], inputs_0[start_30 + u32(48)], inputs_0[start_30 + u32(49)], inputs_0[start_30 + u32(50)], inputs_0[start_30 + u32(51)], inputs_0[start_30 + u32(52)], inputs_0[start_30 + u32(53)]));
    var _S90 : u32 = _S89 * u32(3);
    outputs_0[_S90] = result_21[i32(0)];
    outputs_0[_S90 + u32(1)] = result_21[i32(1)];
    outputs_0[_S90 + u32(2)] = result_21[i32(2)];
    return;
}

fn skin_reflected_visibility_0( sky_harmonics_0 : mat3x3<f32>,  normal_6 : vec3<f32>,  direction_0 : vec3<f32>) -> f32
{
    var bands_0 : vec3<f32> = skin_sh_bands_0(sky_harmonics_0, direction_0);
    var _S91 : f32 = max(dot(normal_6, direction_0), 0.0f);
    return saturate((bands_0.x + bands_0.y + bands_0.z) / ((0.375f + _S91 * (2.0f + 1.875f * _S91)) * 0.07957746833562851f));
}

@compute
@workgroup_size(64, 1, 1)
fn run_reflected_visibility(@builtin(global_invocation_id) thread_32 : vec3<u32>)
{
    var _S92 : u32 = thread_32.x;
    var start_31 : u32 = _S92 * u32(15);
    outputs_0[_S92] = skin_reflected_visibility_0(mat3x3<f32>(inputs_0[start_31], inputs_0[start_31 + u32(1)], inputs_0[start_31 + u32(2)], inputs_0[start_31 + u32(3)], inputs_0[start_31 + u32(4)], inputs_0[start_31 + u32(5)], inputs_0[start_31 + u32(6)], inputs_0[start_31 + u32(7)], inputs_0[start_31 + u32(8)]), vec3<f32>(inputs_0[start_31 + u32(9)], inputs_0[start_31 + u32(10)], inputs_0[start_31 + u32(11)]), vec3<f32>(inputs_0[start_31 + u32(12)], inputs_0[start_31 + u32(13)], inputs_0[start_31 + u32(14)]));
    return;
}

fn skin_occluded_reflection_0( sky_0 : vec3<f32>,  bounced_0 : vec3<f32>,  sky_harmonics_1 : mat3x3<f32>,  normal_7 : vec3<f32>,  direction_1 : vec3<f32>) -> vec3<f32>
{
    return mix(bounced_0 / vec3<f32>(max(1.0f - sky_harmonics_1[i32(0)].x / 0.282094806432724f, 0.01999999955296516f)), sky_0, vec3<f32>(skin_reflected_visibility_0(sky_harmonics_1, normal_7, direction_1)));
}

@compute
@workgroup_size(64, 1, 1)
fn run_occluded_reflection(@builtin(global_invocation_id) thread_33 : vec3<u32>)
{
    var _S93 : u32 = thread_33.x;
    var start_32 : u32 = _S93 * u32(21);
    var result_22 : vec3<f32> = skin_occluded_reflection_0(vec3<f32>(inputs_0[start_32], inputs_0[start_32 + u32(1)], inputs_0[start_32 + u32(2)]), vec3<f32>(inputs_0[start_32 + u32(3)], inputs_0[start_32 + u32(4)], inputs_0[start_32 + u32(5)]), mat3x3<f32>(inputs_0[start_32 + u32(6)], inputs_0[start_32 + u32(7)], inputs_0[start_32 + u32(8)], inputs_0[start_32 + u32(9)], inputs_0[start_32 + u32(10)], inputs_0[start_32 + u32(11)], inputs_0[start_32 + u32(12)], inputs_0[start_32 + u32(13)], inputs_0[start_32 + u32(14)]), vec3<f32>(inputs_0[start_32 + u32(15)], inputs_0[start_32 + u32(16)], inputs_0[start_32 + u32(17)]), vec3<f32>(inputs_0[start_32 + u32(18)], inputs_0[start_32 + u32(19)], inputs_0[start_32 + u32(20)]));
    var _S94 : u32 = _S93 * u32(3);
    outputs_0[_S94] = result_22[i32(0)];
    outputs_0[_S94 + u32(1)] = result_22[i32(1)];
    outputs_0[_S94 + u32(2)] = result_22[i32(2)];
    return;
}

fn skin_specular_visibility_0( n_dot_v_2 : f32,  visibility_1 : f32,  roughness_0 : f32) -> f32
{
    var exponent_0 : f32 = exp2(-16.0f * roughness_0 - 1.0f);
    var base_0 : f32 = n_dot_v_2 + visibility_1;
    var power_0 : f32;
    if(base_0 > 0.0f)
    {
        power_0 = pow(base_0, exponent_0);
    }
    else
    {
        power_0 = 0.0f;
    }
    return saturate(power_0 - 1.0f + visibility_1);
}

@compute
@workgroup_size(64, 1, 1)
fn run_specular_visibility(@builtin(global_invocation_id) thread_34 : vec3<u32>)
{
    var _S95 : u32 = thread_34.x;
    var start_33 : u32 = _S95 * u32(3);
    outputs_0[_S95] = skin_specular_visibility_0(inputs_0[start_33], inputs_0[start_33 + u32(1)], inputs_0[start_33 + u32(2)]);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn run_linear_depth(@builtin(global_invocation_id) thread_35 : vec3<u32>)
{
    var _S96 : u32 = thread_35.x;
    var start_34 : u32 = _S96 * u32(17);
    outputs_0[_S96] = skin_linear_depth_0(inputs_0[start_34], mat4x4<f32>(inputs_0[start_34 + u32(1)], inputs_0[start_34 + u32(2)], inputs_0[start_34 + u32(3)], inputs_0[start_34 + u32(4)], inputs_0[start_34 + u32(5)], inputs_0[start_34 + u32(6)], inputs_0[start_34 + u32(7)], inputs_0[start_34 + u32(8)], inputs_0[start_34 + u32(9)], inputs_0[start_34 + u32(10)], inputs_0[start_34 + u32(11)], inputs_0[start_34 + u32(12)], inputs_0[start_34 + u32(13)], inputs_0[start_34 + u32(14)], inputs_0[start_34 + u32(15)], inputs_0[start_34 + u32(16)]));
    return;
}

fn skin_inward_offset_0( position_mm_4 : vec3<f32>,  normal_8 : vec3<f32>,  offset_mm_0 : f32) -> vec3<f32>
{
    return position_mm_4 - normal_8 * vec3<f32>(offset_mm_0);
}

@compute
@workgroup_size(64, 1, 1)
fn run_inward_offset(@builtin(global_invocation_id) thread_36 : vec3<u32>)
{
    var _S97 : u32 = thread_36.x;
    var start_35 : u32 = _S97 * u32(7);
    var result_23 : vec3<f32> = skin_inward_offset_0(vec3<f32>(inputs_0[start_35], inputs_0[start_35 + u32(1)], inputs_0[start_35 + u32(2)]), vec3<f32>(inputs_0[start_35 + u32(3)], inputs_0[start_35 + u32(4)], inputs_0[start_35 + u32(5)]), inputs_0[start_35 + u32(6)]);
    var _S98 : u32 = _S97 * u32(3);
    outputs_0[_S98] = result_23[i32(0)];
    outputs_0[_S98 + u32(1)] = result_23[i32(1)];
    outputs_0[_S98 + u32(2)] = result_23[i32(2)];
    return;
}

fn skin_thickness_0( depth_map_4 : texture_2d<f32>,  depth_map_sampler_4 : sampler,  projection_5 : mat4x4<f32>,  uv_1 : vec2<f32>,  receiver_mm_2 : f32,  radius_uv_0 : vec2<f32>,  taps_1 : i32) -> f32
{
    var tap_2 : i32 = i32(0);
    var total_5 : f32 = 0.0f;
    for(;;)
    {
        if(tap_2 < taps_1)
        {
        }
        else
        {
            break;
        }
        var offset_0 : vec2<f32>;
        if(taps_1 == i32(8))
        {
            offset_0 = SKIN_POISSON_8_0[min(tap_2, i32(7))];
        }
        else
        {
            offset_0 = SKIN_POISSON_32_0[min(tap_2, i32(31))];
        }
        var total_6 : f32 = total_5 + max(receiver_mm_2 - skin_linear_depth_0((textureSampleLevel((depth_map_4), (depth_map_sampler_4), (uv_1 + offset_0 * radius_uv_0), (0.0f))).x, projection_5), 0.0f);
        tap_2 = tap_2 + i32(1);
        total_5 = total_6;
    }
    return total_5 / f32(max(taps_1, i32(1)));
}

@compute
@workgroup_size(64, 1, 1)
fn run_thickness(@builtin(global_invocation_id) thread_37 : vec3<u32>)
{
    var _S99 : u32 = thread_37.x;
    var start_36 : u32 = _S99 * u32(22);
    outputs_0[_S99] = skin_thickness_0(depth_map_0, depth_map_sampler_0, mat4x4<f32>(inputs_0[start_36], inputs_0[start_36 + u32(1)], inputs_0[start_36 + u32(2)], inputs_0[start_36 + u32(3)], inputs_0[start_36 + u32(4)], inputs_0[start_36 + u32(5)], inputs_0[start_36 + u32(6)], inputs_0[start_36 + u32(7)], inputs_0[start_36 + u32(8)], inputs_0[start_36 + u32(9)], inputs_0[start_36 + u32(10)], inputs_0[start_36 + u32(11)], inputs_0[start_36 + u32(12)], inputs_0[start_36 + u32(13)], inputs_0[start_36 + u32(14)], inputs_0[start_36 + u32(15)]), vec2<f32>(inputs_0[start_36 + u32(16)], inputs_0[start_36 + u32(17)]), inputs_0[start_36 + u32(18)], vec2<f32>(inputs_0[start_36 + u32(19)], inputs_0[start_36 + u32(20)]), i32(inputs_0[start_36 + u32(21)]));
    return;
}

fn skin_transmittance_0( thickness_mm_0 : f32,  albedo_5 : vec3<f32>,  sigma_per_mm_0 : vec3<f32>) -> vec3<f32>
{
    var a2_0 : vec3<f32> = albedo_5 * albedo_5;
    var decay_0 : vec3<f32> = exp((vec3<f32>(0) - sigma_per_mm_0) * vec3<f32>(thickness_mm_0));
    var _S100 : vec3<f32> = vec3<f32>(1.0f);
    return (_S100 - a2_0) * decay_0 / (_S100 - a2_0 * decay_0 * decay_0);
}

@compute
@workgroup_size(64, 1, 1)
fn run_transmittance(@builtin(global_invocation_id) thread_38 : vec3<u32>)
{
    var _S101 : u32 = thread_38.x;
    var start_37 : u32 = _S101 * u32(7);
    var result_24 : vec3<f32> = skin_transmittance_0(inputs_0[start_37], vec3<f32>(inputs_0[start_37 + u32(1)], inputs_0[start_37 + u32(2)], inputs_0[start_37 + u32(3)]), vec3<f32>(inputs_0[start_37 + u32(4)], inputs_0[start_37 + u32(5)], inputs_0[start_37 + u32(6)]));
    var _S102 : u32 = _S101 * u32(3);
    outputs_0[_S102] = result_24[i32(0)];
    outputs_0[_S102 + u32(1)] = result_24[i32(1)];
    outputs_0[_S102 + u32(2)] = result_24[i32(2)];
    return;
}

fn skin_classic_transmittance_0( thickness_mm_1 : f32,  radius_mm_0 : f32) -> f32
{
    var t_1 : f32 = thickness_mm_1 / radius_mm_0;
    return exp(-0.5f * t_1 * t_1);
}

@compute
@workgroup_size(64, 1, 1)
fn run_classic_transmittance(@builtin(global_invocation_id) thread_39 : vec3<u32>)
{
    var _S103 : u32 = thread_39.x;
    var start_38 : u32 = _S103 * u32(2);
    outputs_0[_S103] = skin_classic_transmittance_0(inputs_0[start_38], inputs_0[start_38 + u32(1)]);
    return;
}

fn skin_direct_deep_scatter_0( transmitted_0 : vec3<f32>,  n_dot_l_1 : f32,  strength_0 : f32) -> vec3<f32>
{
    return vec3<f32>(strength_0) * transmitted_0 * vec3<f32>(max(- n_dot_l_1, 0.0f));
}

@compute
@workgroup_size(64, 1, 1)
fn run_direct_deep_scatter(@builtin(global_invocation_id) thread_40 : vec3<u32>)
{
    var _S104 : u32 = thread_40.x;
    var start_39 : u32 = _S104 * u32(5);
    var result_25 : vec3<f32> = skin_direct_deep_scatter_0(vec3<f32>(inputs_0[start_39], inputs_0[start_39 + u32(1)], inputs_0[start_39 + u32(2)]), inputs_0[start_39 + u32(3)], inputs_0[start_39 + u32(4)]);
    var _S105 : u32 = _S104 * u32(3);
    outputs_0[_S105] = result_25[i32(0)];
    outputs_0[_S105 + u32(1)] = result_25[i32(1)];
    outputs_0[_S105 + u32(2)] = result_25[i32(2)];
    return;
}

fn skin_through_beyond_0( through_0 : vec3<f32>,  diffused_0 : vec3<f32>) -> vec3<f32>
{
    return max(through_0 - diffused_0, vec3<f32>(0.0f));
}

@compute
@workgroup_size(64, 1, 1)
fn run_through_beyond(@builtin(global_invocation_id) thread_41 : vec3<u32>)
{
    var _S106 : u32 = thread_41.x;
    var start_40 : u32 = _S106 * u32(6);
    var result_26 : vec3<f32> = skin_through_beyond_0(vec3<f32>(inputs_0[start_40], inputs_0[start_40 + u32(1)], inputs_0[start_40 + u32(2)]), vec3<f32>(inputs_0[start_40 + u32(3)], inputs_0[start_40 + u32(4)], inputs_0[start_40 + u32(5)]));
    var _S107 : u32 = _S106 * u32(3);
    outputs_0[_S107] = result_26[i32(0)];
    outputs_0[_S107 + u32(1)] = result_26[i32(1)];
    outputs_0[_S107 + u32(2)] = result_26[i32(2)];
    return;
}

fn skin_ambient_deep_scatter_0( transmitted_1 : vec3<f32>,  irradiance_behind_0 : vec3<f32>,  strength_1 : f32) -> vec3<f32>
{
    return vec3<f32>(strength_1) * transmitted_1 * irradiance_behind_0;
}

@compute
@workgroup_size(64, 1, 1)
fn run_ambient_deep_scatter(@builtin(global_invocation_id) thread_42 : vec3<u32>)
{
    var _S108 : u32 = thread_42.x;
    var start_41 : u32 = _S108 * u32(7);
    var result_27 : vec3<f32> = skin_ambient_deep_scatter_0(vec3<f32>(inputs_0[start_41], inputs_0[start_41 + u32(1)], inputs_0[start_41 + u32(2)]), vec3<f32>(inputs_0[start_41 + u32(3)], inputs_0[start_41 + u32(4)], inputs_0[start_41 + u32(5)]), inputs_0[start_41 + u32(6)]);
    var _S109 : u32 = _S108 * u32(3);
    outputs_0[_S109] = result_27[i32(0)];
    outputs_0[_S109 + u32(1)] = result_27[i32(1)];
    outputs_0[_S109 + u32(2)] = result_27[i32(2)];
    return;
}

fn skin_specular_power_0( gloss_0 : f32) -> f32
{
    return exp2(13.0f * gloss_0);
}

@compute
@workgroup_size(64, 1, 1)
fn run_specular_power(@builtin(global_invocation_id) thread_43 : vec3<u32>)
{
    var _S110 : u32 = thread_43.x;
    outputs_0[_S110] = skin_specular_power_0(inputs_0[_S110]);
    return;
}

fn skin_gloss_of_relief_0( gloss_1 : f32,  normal_length_0 : f32) -> f32
{
    var clamped_length_0 : f32 = clamp(normal_length_0, 0.00100000004749745f, 1.0f);
    var power_1 : f32 = skin_specular_power_0(gloss_1);
    return log2(max(clamped_length_0 * power_1 / (clamped_length_0 + power_1 * (1.0f - clamped_length_0)), 1.0f)) / 13.0f;
}

@compute
@workgroup_size(64, 1, 1)
fn run_gloss_of_relief(@builtin(global_invocation_id) thread_44 : vec3<u32>)
{
    var _S111 : u32 = thread_44.x;
    var start_42 : u32 = _S111 * u32(2);
    outputs_0[_S111] = skin_gloss_of_relief_0(inputs_0[start_42], inputs_0[start_42 + u32(1)]);
    return;
}

fn skin_gloss_from_roughness_0( roughness_1 : f32) -> f32
{
    var _S112 : f32 = max(roughness_1, 0.00100000004749745f);
    var r2_0 : f32 = _S112 * _S112;
    return clamp(log2(max(2.0f / (r2_0 * r2_0) - 2.0f, 1.0f)) / 13.0f, 0.0f, 1.0f);
}

@compute
@workgroup_size(64, 1, 1)
fn run_gloss_from_roughness(@builtin(global_invocation_id) thread_45 : vec3<u32>)
{
    var _S113 : u32 = thread_45.x;
    outputs_0[_S113] = skin_gloss_from_roughness_0(inputs_0[_S113]);
    return;
}

fn skin_lobe_0( n_dot_h_0 : f32,  n_dot_l_2 : f32,  n_dot_v_3 : f32,  power_2 : f32) -> f32
{
    var k_0 : f32 = rsqrt_0(3.14159274101257324f * power_2 / 4.0f + 1.57079637050628662f);
    var _S114 : f32 = 1.0f - k_0;
    return (power_2 + 2.0f) / 6.28318548202514648f * pow(max(n_dot_h_0, 9.99999971718068537e-10f), power_2) * (0.25f / ((k_0 + _S114 * n_dot_l_2) * (k_0 + _S114 * n_dot_v_3)));
}

fn skin_specular_0( normal_9 : vec3<f32>,  view_3 : vec3<f32>,  light_5 : vec3<f32>,  gloss_2 : f32,  reflectance_1 : f32) -> f32
{
    var half_vector_0 : vec3<f32> = skin_unit_vectors_0(view_3 + light_5);
    var n_dot_l_3 : f32 = saturate(dot(normal_9, light_5));
    var n_dot_v_4 : f32 = clamp(dot(normal_9, view_3), 0.00009999999747379f, 1.0f);
    var n_dot_h_1 : f32 = saturate(dot(normal_9, half_vector_0));
    var wide_0 : f32 = skin_specular_power_0(gloss_2);
    var grazing_0 : f32 = 1.0f - saturate(dot(view_3, half_vector_0));
    var grazing2_0 : f32 = grazing_0 * grazing_0;
    return 3.14159274101257324f * (0.94999998807907104f * skin_lobe_0(n_dot_h_1, n_dot_l_3, n_dot_v_4, wide_0) + 0.05000000074505806f * skin_lobe_0(n_dot_h_1, n_dot_l_3, n_dot_v_4, min(wide_0 * wide_0, 8192.0f))) * (reflectance_1 + (1.0f - reflectance_1) * grazing2_0 * grazing2_0 * grazing_0) * n_dot_l_3;
}

@compute
@workgroup_size(64, 1, 1)
fn run_specular(@builtin(global_invocation_id) thread_46 : vec3<u32>)
{
    var _S115 : u32 = thread_46.x;
    var start_43 : u32 = _S115 * u32(11);
    outputs_0[_S115] = skin_specular_0(vec3<f32>(inputs_0[start_43], inputs_0[start_43 + u32(1)], inputs_0[start_43 + u32(2)]), vec3<f32>(inputs_0[start_43 + u32(3)], inputs_0[start_43 + u32(4)], inputs_0[start_43 + u32(5)]), vec3<f32>(inputs_0[start_43 + u32(6)], inputs_0[start_43 + u32(7)], inputs_0[start_43 + u32(8)]), inputs_0[start_43 + u32(9)], inputs_0[start_43 + u32(10)]);
    return;
}

fn skin_reflected_0( normal_10 : vec3<f32>,  view_4 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>((2.0f * dot(normal_10, view_4))) * normal_10 - view_4;
}

@compute
@workgroup_size(64, 1, 1)
fn run_reflected(@builtin(global_invocation_id) thread_47 : vec3<u32>)
{
    var _S116 : u32 = thread_47.x;
    var start_44 : u32 = _S116 * u32(6);
    var result_28 : vec3<f32> = skin_reflected_0(vec3<f32>(inputs_0[start_44], inputs_0[start_44 + u32(1)], inputs_0[start_44 + u32(2)]), vec3<f32>(inputs_0[start_44 + u32(3)], inputs_0[start_44 + u32(4)], inputs_0[start_44 + u32(5)]));
    var _S117 : u32 = _S116 * u32(3);
    outputs_0[_S117] = result_28[i32(0)];
    outputs_0[_S117 + u32(1)] = result_28[i32(1)];
    outputs_0[_S117 + u32(2)] = result_28[i32(2)];
    return;
}

fn skin_ambient_specular_fresnel_0( n_dot_v_5 : f32,  gloss_3 : f32,  reflectance_2 : f32) -> f32
{
    var grazing_1 : f32 = 1.0f - saturate(n_dot_v_5);
    var grazing2_1 : f32 = grazing_1 * grazing_1;
    return reflectance_2 + (1.0f - reflectance_2) * grazing2_1 * grazing2_1 * grazing_1 / (4.0f - 3.0f * gloss_3);
}

@compute
@workgroup_size(64, 1, 1)
fn run_ambient_specular_fresnel(@builtin(global_invocation_id) thread_48 : vec3<u32>)
{
    var _S118 : u32 = thread_48.x;
    var start_45 : u32 = _S118 * u32(3);
    outputs_0[_S118] = skin_ambient_specular_fresnel_0(inputs_0[start_45], inputs_0[start_45 + u32(1)], inputs_0[start_45 + u32(2)]);
    return;
}

fn skin_diffuse_share_0( n_dot_v_6 : f32,  gloss_4 : f32,  reflectance_3 : f32) -> f32
{
    return 1.0f - skin_ambient_specular_fresnel_0(n_dot_v_6, gloss_4, reflectance_3);
}

@compute
@workgroup_size(64, 1, 1)
fn run_diffuse_share(@builtin(global_invocation_id) thread_49 : vec3<u32>)
{
    var _S119 : u32 = thread_49.x;
    var start_46 : u32 = _S119 * u32(3);
    outputs_0[_S119] = skin_diffuse_share_0(inputs_0[start_46], inputs_0[start_46 + u32(1)], inputs_0[start_46 + u32(2)]);
    return;
}

fn skin_alpha_from_gloss_0( gloss_5 : f32) -> f32
{
    return sqrt(2.0f / (skin_specular_power_0(gloss_5) + 2.0f));
}

@compute
@workgroup_size(64, 1, 1)
fn run_alpha_from_gloss(@builtin(global_invocation_id) thread_50 : vec3<u32>)
{
    var _S120 : u32 = thread_50.x;
    outputs_0[_S120] = skin_alpha_from_gloss_0(inputs_0[_S120]);
    return;
}

fn skin_second_gloss_0( gloss_6 : f32) -> f32
{
    return min(2.0f * gloss_6, 1.0f);
}

@compute
@workgroup_size(64, 1, 1)
fn run_second_gloss(@builtin(global_invocation_id) thread_51 : vec3<u32>)
{
    var _S121 : u32 = thread_51.x;
    outputs_0[_S121] = skin_second_gloss_0(inputs_0[_S121]);
    return;
}

fn skin_coat_fresnel_0( cosine_3 : f32,  reflectance_4 : f32) -> f32
{
    var root_1 : f32 = sqrt(clamp(reflectance_4, 0.0f, 0.89999997615814209f));
    var _S122 : f32 = 1.0f - root_1;
    var excess_0 : f32 = 4.0f * root_1 / (_S122 * _S122);
    var _S123 : f32 = max(sqrt(excess_0 + cosine_3 * cosine_3) + cosine_3, 9.99999971718068537e-10f);
    var across_0 : f32 = excess_0 / (_S123 * _S123);
    var along_0 : f32 = (cosine_3 * _S123 - 1.0f) / (cosine_3 * excess_0 / _S123 + 1.0f);
    return 0.5f * across_0 * across_0 * (1.0f + along_0 * along_0);
}

@compute
@workgroup_size(64, 1, 1)
fn run_coat_fresnel(@builtin(global_invocation_id) thread_52 : vec3<u32>)
{
    var _S124 : u32 = thread_52.x;
    var start_47 : u32 = _S124 * u32(2);
    outputs_0[_S124] = skin_coat_fresnel_0(inputs_0[start_47], inputs_0[start_47 + u32(1)]);
    return;
}

fn skin_coat_highlight_0( normal_11 : vec3<f32>,  view_5 : vec3<f32>,  light_6 : vec3<f32>,  gloss_7 : f32,  reflectance_5 : f32) -> f32
{
    var half_vector_1 : vec3<f32> = skin_unit_vectors_0(view_5 + light_6);
    var n_dot_l_4 : f32 = saturate(dot(normal_11, light_6));
    var n_dot_v_7 : f32 = clamp(dot(normal_11, view_5), 0.00009999999747379f, 1.0f);
    var n_dot_h_2 : f32 = saturate(dot(normal_11, half_vector_1));
    var v_dot_h_0 : f32 = saturate(dot(view_5, half_vector_1));
    var squared_0 : f32 = 2.0f / (skin_specular_power_0(gloss_7) + 2.0f);
    var side_0 : vec3<f32> = cross(normal_11, half_vector_1);
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
    var _S125 : f32 = 1.0f - squared_0;
    return root_2 * root_2 / squared_0 * (0.5f / (n_dot_l_4 * sqrt(n_dot_v_7 * n_dot_v_7 * _S125 + squared_0) + n_dot_v_7 * sqrt(n_dot_l_4 * n_dot_l_4 * _S125 + squared_0))) * skin_coat_fresnel_0(v_dot_h_0, reflectance_5) * n_dot_l_4;
}

@compute
@workgroup_size(64, 1, 1)
fn run_coat_highlight(@builtin(global_invocation_id) thread_53 : vec3<u32>)
{
    var _S126 : u32 = thread_53.x;
    var start_48 : u32 = _S126 * u32(11);
    outputs_0[_S126] = skin_coat_highlight_0(vec3<f32>(inputs_0[start_48], inputs_0[start_48 + u32(1)], inputs_0[start_48 + u32(2)]), vec3<f32>(inputs_0[start_48 + u32(3)], inputs_0[start_48 + u32(4)], inputs_0[start_48 + u32(5)]), vec3<f32>(inputs_0[start_48 + u32(6)], inputs_0[start_48 + u32(7)], inputs_0[start_48 + u32(8)]), inputs_0[start_48 + u32(9)], inputs_0[start_48 + u32(10)]);
    return;
}

fn skin_coat_0( lut_7 : texture_2d<f32>,  lut_sampler_7 : sampler,  lut_axes_6 : vec4<f32>,  n_dot_v_8 : f32,  gloss_8 : f32,  reflectance_6 : f32,  coat_reflectance_0 : f32) -> vec2<f32>
{
    var entry_0 : vec3<f32> = (textureSampleLevel((lut_7), (lut_sampler_7), (saturate((vec2<f32>(sqrt(saturate(n_dot_v_8)), gloss_8) - lut_axes_6.xz) * lut_axes_6.yw)), (0.0f))).xyz;
    var _S127 : f32 = entry_0.z;
    return vec2<f32>(clamp(_S127 + (1.0f - reflectance_6) / (1.0f - coat_reflectance_0) * (entry_0.x - _S127), 0.0f, _S127), entry_0.y);
}

@compute
@workgroup_size(64, 1, 1)
fn run_coat(@builtin(global_invocation_id) thread_54 : vec3<u32>)
{
    var _S128 : u32 = thread_54.x;
    var start_49 : u32 = _S128 * u32(8);
    var result_29 : vec2<f32> = skin_coat_0(lut_0, lut_sampler_0, vec4<f32>(inputs_0[start_49], inputs_0[start_49 + u32(1)], inputs_0[start_49 + u32(2)], inputs_0[start_49 + u32(3)]), inputs_0[start_49 + u32(4)], inputs_0[start_49 + u32(5)], inputs_0[start_49 + u32(6)], inputs_0[start_49 + u32(7)]);
    var _S129 : u32 = _S128 * u32(2);
    outputs_0[_S129] = result_29[i32(0)];
    outputs_0[_S129 + u32(1)] = result_29[i32(1)];
    return;
}

fn skin_coat_direction_0( normal_12 : vec3<f32>,  view_6 : vec3<f32>,  pull_0 : f32) -> vec3<f32>
{
    var mirrored_0 : vec3<f32> = skin_reflected_0(normal_12, view_6);
    return skin_unit_vectors_0(mirrored_0 + vec3<f32>(pull_0) * (normal_12 - mirrored_0));
}

@compute
@workgroup_size(64, 1, 1)
fn run_coat_direction(@builtin(global_invocation_id) thread_55 : vec3<u32>)
{
    var _S130 : u32 = thread_55.x;
    var start_50 : u32 = _S130 * u32(7);
    var result_30 : vec3<f32> = skin_coat_direction_0(vec3<f32>(inputs_0[start_50], inputs_0[start_50 + u32(1)], inputs_0[start_50 + u32(2)]), vec3<f32>(inputs_0[start_50 + u32(3)], inputs_0[start_50 + u32(4)], inputs_0[start_50 + u32(5)]), inputs_0[start_50 + u32(6)]);
    var _S131 : u32 = _S130 * u32(3);
    outputs_0[_S131] = result_30[i32(0)];
    outputs_0[_S131 + u32(1)] = result_30[i32(1)];
    outputs_0[_S131 + u32(2)] = result_30[i32(2)];
    return;
}

fn skin_turns_0( y_1 : f32,  x_2 : f32) -> f32
{
    var size_0 : vec2<f32> = abs(vec2<f32>(x_2, y_1));
    var _S132 : f32 = size_0.x;
    var _S133 : f32 = size_0.y;
    var r_0 : f32 = min(_S132, _S133) / max(max(_S132, _S133), 1.00000000317107685e-30f);
    var r2_1 : f32 = r_0 * r_0;
    var turns_0 : f32 = r_0 * (0.15915107727050781f + r2_1 * (-0.05293257534503937f + r2_1 * (0.03076364658772945f + r2_1 * (-0.01842727139592171f + r2_1 * (0.00826387945562601f - r2_1 * 0.00181874714326113f)))));
    var turns_1 : f32;
    if(_S133 > _S132)
    {
        turns_1 = 0.25f - turns_0;
    }
    else
    {
        turns_1 = turns_0;
    }
    if(x_2 < 0.0f)
    {
        turns_1 = 0.5f - turns_1;
    }
    if(y_1 < 0.0f)
    {
        turns_1 = - turns_1;
    }
    return turns_1;
}

fn skin_equirectangular_uv_0( direction_2 : vec3<f32>) -> vec2<f32>
{
    var _S134 : f32 = direction_2.x;
    var _S135 : f32 = direction_2.z;
    return vec2<f32>(0.5f + skin_turns_0(_S135, _S134), 2.0f * skin_turns_0(sqrt(_S134 * _S134 + _S135 * _S135), direction_2.y));
}

@compute
@workgroup_size(64, 1, 1)
fn run_equirectangular_uv(@builtin(global_invocation_id) thread_56 : vec3<u32>)
{
    var _S136 : u32 = thread_56.x;
    var start_51 : u32 = _S136 * u32(3);
    var result_31 : vec2<f32> = skin_equirectangular_uv_0(vec3<f32>(inputs_0[start_51], inputs_0[start_51 + u32(1)], inputs_0[start_51 + u32(2)]));
    var _S137 : u32 = _S136 * u32(2);
    outputs_0[_S137] = result_31[i32(0)];
    outputs_0[_S137 + u32(1)] = result_31[i32(1)];
    return;
}

fn skin_reflection_level_0( power_3 : f32) -> f32
{
    return clamp(0.5f * log2(max(power_3, 1.0f)), 0.0f, 4.0f);
}

@compute
@workgroup_size(64, 1, 1)
fn run_reflection_level(@builtin(global_invocation_id) thread_57 : vec3<u32>)
{
    var _S138 : u32 = thread_57.x;
    outputs_0[_S138] = skin_reflection_level_0(inputs_0[_S138]);
    return;
}

fn skin_preconvolved_0( preconvolved_1 : texture_2d<f32>,  preconvolved_sampler_1 : sampler,  uv_2 : vec2<f32>,  power_4 : f32) -> vec3<f32>
{
    var level_0 : f32 = skin_reflection_level_0(power_4);
    var _S139 : f32 = min(floor(level_0), 3.0f);
    var row_1 : f32 = clamp(uv_2.y, 0.0078125f, 0.9921875f);
    var _S140 : f32 = uv_2.x;
    return mix((textureSampleLevel((preconvolved_1), (preconvolved_sampler_1), (vec2<f32>(_S140, (_S139 + row_1) / 5.0f)), (0.0f))).xyz, (textureSampleLevel((preconvolved_1), (preconvolved_sampler_1), (vec2<f32>(_S140, (_S139 + 1.0f + row_1) / 5.0f)), (0.0f))).xyz, vec3<f32>((level_0 - _S139)));
}

fn skin_reflected_radiance_0( preconvolved_2 : texture_2d<f32>,  preconvolved_sampler_2 : sampler,  direction_3 : vec3<f32>,  gloss_9 : f32) -> vec3<f32>
{
    var uv_3 : vec2<f32> = skin_equirectangular_uv_0(direction_3);
    var power_5 : f32 = skin_specular_power_0(gloss_9);
    return mix(skin_preconvolved_0(preconvolved_2, preconvolved_sampler_2, uv_3, power_5 / 4.0f), skin_preconvolved_0(preconvolved_2, preconvolved_sampler_2, uv_3, power_5 * power_5 / 4.0f), vec3<f32>(0.05000000074505806f));
}

@compute
@workgroup_size(64, 1, 1)
fn run_reflected_radiance(@builtin(global_invocation_id) thread_58 : vec3<u32>)
{
    var _S141 : u32 = thread_58.x;
    var start_52 : u32 = _S141 * u32(4);
    var result_32 : vec3<f32> = skin_reflected_radiance_0(preconvolved_0, preconvolved_sampler_0, vec3<f32>(inputs_0[start_52], inputs_0[start_52 + u32(1)], inputs_0[start_52 + u32(2)]), inputs_0[start_52 + u32(3)]);
    var _S142 : u32 = _S141 * u32(3);
    outputs_0[_S142] = result_32[i32(0)];
    outputs_0[_S142 + u32(1)] = result_32[i32(1)];
    outputs_0[_S142 + u32(2)] = result_32[i32(2)];
    return;
}

fn skin_coat_radiance_0( preconvolved_3 : texture_2d<f32>,  preconvolved_sampler_3 : sampler,  direction_4 : vec3<f32>,  n_dot_v_9 : f32,  gloss_10 : f32) -> vec3<f32>
{
    return skin_preconvolved_0(preconvolved_3, preconvolved_sampler_3, skin_equirectangular_uv_0(direction_4), (skin_specular_power_0(gloss_10) + 2.0f) / (8.0f * max(n_dot_v_9, 0.00999999977648258f)));
}

@compute
@workgroup_size(64, 1, 1)
fn run_coat_radiance(@builtin(global_invocation_id) thread_59 : vec3<u32>)
{
    var _S143 : u32 = thread_59.x;
    var start_53 : u32 = _S143 * u32(5);
    var result_33 : vec3<f32> = skin_coat_radiance_0(preconvolved_0, preconvolved_sampler_0, vec3<f32>(inputs_0[start_53], inputs_0[start_53 + u32(1)], inputs_0[start_53 + u32(2)]), inputs_0[start_53 + u32(3)], inputs_0[start_53 + u32(4)]);
    var _S144 : u32 = _S143 * u32(3);
    outputs_0[_S144] = result_33[i32(0)];
    outputs_0[_S144 + u32(1)] = result_33[i32(1)];
    outputs_0[_S144 + u32(2)] = result_33[i32(2)];
    return;
}

fn skin_filmic_0( light_7 : vec3<f32>) -> vec3<f32>
{
    var x_3 : vec3<f32> = max(light_7 - vec3<f32>(0.00400000018998981f), vec3<f32>(0.0f));
    var _S145 : vec3<f32> = vec3<f32>(6.19999980926513672f) * x_3;
    return x_3 * (_S145 + vec3<f32>(0.5f)) / (x_3 * (_S145 + vec3<f32>(1.70000004768371582f)) + vec3<f32>(0.05999999865889549f));
}

@compute
@workgroup_size(64, 1, 1)
fn run_filmic(@builtin(global_invocation_id) thread_60 : vec3<u32>)
{
    var start_54 : u32 = thread_60.x * u32(3);
    var _S146 : u32 = start_54 + u32(1);
    var _S147 : u32 = start_54 + u32(2);
    var result_34 : vec3<f32> = skin_filmic_0(vec3<f32>(inputs_0[start_54], inputs_0[_S146], inputs_0[_S147]));
    outputs_0[start_54] = result_34[i32(0)];
    outputs_0[_S146] = result_34[i32(1)];
    outputs_0[_S147] = result_34[i32(2)];
    return;
}

fn skin_srgb_curve_0( x_4 : f32) -> f32
{
    var _S148 : f32;
    if(x_4 <= 0.00313080009073019f)
    {
        _S148 = 12.92000007629394531f * x_4;
    }
    else
    {
        _S148 = 1.0549999475479126f * pow(max(x_4, 9.999999960041972e-13f), 0.4166666567325592f) - 0.05499999970197678f;
    }
    return _S148;
}

fn skin_srgb_from_linear_0( light_8 : vec3<f32>) -> vec3<f32>
{
    var x_5 : vec3<f32> = saturate(light_8);
    return vec3<f32>(skin_srgb_curve_0(x_5.x), skin_srgb_curve_0(x_5.y), skin_srgb_curve_0(x_5.z));
}

@compute
@workgroup_size(64, 1, 1)
fn run_srgb_from_linear(@builtin(global_invocation_id) thread_61 : vec3<u32>)
{
    var start_55 : u32 = thread_61.x * u32(3);
    var _S149 : u32 = start_55 + u32(1);
    var _S150 : u32 = start_55 + u32(2);
    var result_35 : vec3<f32> = skin_srgb_from_linear_0(vec3<f32>(inputs_0[start_55], inputs_0[_S149], inputs_0[_S150]));
    outputs_0[start_55] = result_35[i32(0)];
    outputs_0[_S149] = result_35[i32(1)];
    outputs_0[_S150] = result_35[i32(2)];
    return;
}

fn skin_linear_curve_0( x_6 : f32) -> f32
{
    var _S151 : f32;
    if(x_6 <= 0.04044999927282333f)
    {
        _S151 = x_6 / 12.92000007629394531f;
    }
    else
    {
        _S151 = pow((x_6 + 0.05499999970197678f) / 1.0549999475479126f, 2.40000009536743164f);
    }
    return _S151;
}

fn skin_linear_from_srgb_0( display_0 : vec3<f32>) -> vec3<f32>
{
    var x_7 : vec3<f32> = saturate(display_0);
    return vec3<f32>(skin_linear_curve_0(x_7.x), skin_linear_curve_0(x_7.y), skin_linear_curve_0(x_7.z));
}

@compute
@workgroup_size(64, 1, 1)
fn run_linear_from_srgb(@builtin(global_invocation_id) thread_62 : vec3<u32>)
{
    var start_56 : u32 = thread_62.x * u32(3);
    var _S152 : u32 = start_56 + u32(1);
    var _S153 : u32 = start_56 + u32(2);
    var result_36 : vec3<f32> = skin_linear_from_srgb_0(vec3<f32>(inputs_0[start_56], inputs_0[_S152], inputs_0[_S153]));
    outputs_0[start_56] = result_36[i32(0)];
    outputs_0[_S152] = result_36[i32(1)];
    outputs_0[_S153] = result_36[i32(2)];
    return;
}

fn skin_classic_blur_level_0( radius_mm_1 : f32,  uv_scale_mm_1 : f32,  map_size_1 : f32,  hardware_level_1 : f32) -> f32
{
    return max(hardware_level_1, log2(max(map_size_1 * radius_mm_1, uv_scale_mm_1) / uv_scale_mm_1));
}

@compute
@workgroup_size(64, 1, 1)
fn run_classic_blur_level(@builtin(global_invocation_id) thread_63 : vec3<u32>)
{
    var _S154 : u32 = thread_63.x;
    var start_57 : u32 = _S154 * u32(4);
    outputs_0[_S154] = skin_classic_blur_level_0(inputs_0[start_57], inputs_0[start_57 + u32(1)], inputs_0[start_57 + u32(2)], inputs_0[start_57 + u32(3)]);
    return;
}

fn skin_classic_direct_0( lut_8 : texture_2d<f32>,  lut_sampler_8 : sampler,  lut_axes_7 : vec4<f32>,  sharp_0 : vec3<f32>,  blurred_0 : vec3<f32>,  light_9 : vec3<f32>,  curvature_per_mm_6 : f32) -> vec3<f32>
{
    var blurred_cosine_0 : f32 = dot(blurred_0, light_9);
    var k_1 : f32 = saturate(1.0f - blurred_cosine_0);
    var k_2 : f32 = k_1 * k_1;
    return saturate(saturate(vec3<f32>(blurred_cosine_0, dot(skin_unit_vectors_0(mix(sharp_0, blurred_0, vec3<f32>((0.30000001192092896f + 0.69999998807907104f * k_2)))), light_9), dot(skin_unit_vectors_0(mix(sharp_0, blurred_0, vec3<f32>(k_2))), light_9))) + ((textureSampleLevel((lut_8), (lut_sampler_8), (saturate((vec2<f32>(blurred_cosine_0, abs(curvature_per_mm_6)) - lut_axes_7.xz) * lut_axes_7.yw)), (0.0f))).xyz - vec3<f32>(max(blurred_cosine_0, 0.0f))));
}

@compute
@workgroup_size(64, 1, 1)
fn run_classic_direct(@builtin(global_invocation_id) thread_64 : vec3<u32>)
{
    var _S155 : u32 = thread_64.x;
    var start_58 : u32 = _S155 * u32(14);
    var result_37 : vec3<f32> = skin_classic_direct_0(lut_0, lut_sampler_0, vec4<f32>(inputs_0[start_58], inputs_0[start_58 + u32(1)], inputs_0[start_58 + u32(2)], inputs_0[start_58 + u32(3)]), vec3<f32>(inputs_0[start_58 + u32(4)], inputs_0[start_58 + u32(5)], inputs_0[start_58 + u32(6)]), vec3<f32>(inputs_0[start_58 + u32(7)], inputs_0[start_58 + u32(8)], inputs_0[start_58 + u32(9)]), vec3<f32>(inputs_0[start_58 + u32(10)], inputs_0[start_58 + u32(11)], inputs_0[start_58 + u32(12)]), inputs_0[start_58 + u32(13)]);
    var _S156 : u32 = _S155 * u32(3);
    outputs_0[_S156] = result_37[i32(0)];
    outputs_0[_S156 + u32(1)] = result_37[i32(1)];
    outputs_0[_S156 + u32(2)] = result_37[i32(2)];
    return;
}

fn skin_classic_ambient_normals_0( sharp_1 : vec3<f32>,  blurred_1 : vec3<f32>) -> mat3x3<f32>
{
    return mat3x3<f32>(blurred_1, skin_unit_vectors_0(mix(sharp_1, blurred_1, vec3<f32>(0.30000001192092896f))), sharp_1);
}

@compute
@workgroup_size(64, 1, 1)
fn run_classic_ambient_normals(@builtin(global_invocation_id) thread_65 : vec3<u32>)
{
    var _S157 : u32 = thread_65.x;
    var start_59 : u32 = _S157 * u32(6);
    var result_38 : mat3x3<f32> = skin_classic_ambient_normals_0(vec3<f32>(inputs_0[start_59], inputs_0[start_59 + u32(1)], inputs_0[start_59 + u32(2)]), vec3<f32>(inputs_0[start_59 + u32(3)], inputs_0[start_59 + u32(4)], inputs_0[start_59 + u32(5)]));
    var _S158 : u32 = _S157 * u32(9);
    outputs_0[_S158] = result_38[i32(0)][i32(0)];
    outputs_0[_S158 + u32(1)] = result_38[i32(0)][i32(1)];
    outputs_0[_S158 + u32(2)] = result_38[i32(0)][i32(2)];
    outputs_0[_S158 + u32(3)] = result_38[i32(1)][i32(0)];
    outputs_0[_S158 + u32(4)] = result_38[i32(1)][i32(1)];
    outputs_0[_S158 + u32(5)] = result_38[i32(1)][i32(2)];
    outputs_0[_S158 + u32(6)] = result_38[i32(2)][i32(0)];
    outputs_0[_S158 + u32(7)] = result_38[i32(2)][i32(1)];
    outputs_0[_S158 + u32(8)] = result_38[i32(2)][i32(2)];
    return;
}

fn skin_classic_sharpened_shadow_0( shadow_filter_2 : f32,  sharpening_1 : f32) -> f32
{
    return skin_smoothstep_0(0.89999997615814209f * sharpening_1 * (shadow_filter_2 - 0.5f) + 0.5f);
}

@compute
@workgroup_size(64, 1, 1)
fn run_classic_sharpened_shadow(@builtin(global_invocation_id) thread_66 : vec3<u32>)
{
    var _S159 : u32 = thread_66.x;
    var start_60 : u32 = _S159 * u32(2);
    outputs_0[_S159] = skin_classic_sharpened_shadow_0(inputs_0[start_60], inputs_0[start_60 + u32(1)]);
    return;
}

fn skin_classic_deep_scatter_0( thickness_mm_2 : f32,  n_dot_l_5 : f32,  radius_mm_2 : f32,  strength_2 : f32) -> f32
{
    return strength_2 * skin_classic_transmittance_0(thickness_mm_2, radius_mm_2) * max(0.30000001192092896f - n_dot_l_5, 0.0f);
}

@compute
@workgroup_size(64, 1, 1)
fn run_classic_deep_scatter(@builtin(global_invocation_id) thread_67 : vec3<u32>)
{
    var _S160 : u32 = thread_67.x;
    var start_61 : u32 = _S160 * u32(4);
    outputs_0[_S160] = skin_classic_deep_scatter_0(inputs_0[start_61], inputs_0[start_61 + u32(1)], inputs_0[start_61 + u32(2)], inputs_0[start_61 + u32(3)]);
    return;
}

fn skin_eye_root_0( value_0 : f32) -> f32
{
    return sqrt(max(value_0, 9.99999997475242708e-07f));
}

fn skin_eye_cornea_0( cornea_radius_mm_0 : f32,  cornea_asphericity_0 : f32,  refraction_index_0 : f32,  limbus_0 : vec4<f32>) -> vec4<f32>
{
    var r_1 : f32 = limbus_0.x;
    var ratio_0 : f32 = r_1 / cornea_radius_mm_0;
    var _S161 : f32 = r_1 * r_1;
    var _S162 : f32 = limbus_0.z;
    return vec4<f32>(skin_eye_root_0(_S162 * _S162 - _S161) + _S161 / (cornea_radius_mm_0 * (1.0f + skin_eye_root_0(1.0f - (1.0f + cornea_asphericity_0) * ratio_0 * ratio_0))), cornea_radius_mm_0, cornea_asphericity_0, refraction_index_0);
}

@compute
@workgroup_size(64, 1, 1)
fn run_eye_cornea(@builtin(global_invocation_id) thread_68 : vec3<u32>)
{
    var _S163 : u32 = thread_68.x;
    var start_62 : u32 = _S163 * u32(7);
    var result_39 : vec4<f32> = skin_eye_cornea_0(inputs_0[start_62], inputs_0[start_62 + u32(1)], inputs_0[start_62 + u32(2)], vec4<f32>(inputs_0[start_62 + u32(3)], inputs_0[start_62 + u32(4)], inputs_0[start_62 + u32(5)], inputs_0[start_62 + u32(6)]));
    var _S164 : u32 = _S163 * u32(4);
    outputs_0[_S164] = result_39[i32(0)];
    outputs_0[_S164 + u32(1)] = result_39[i32(1)];
    outputs_0[_S164 + u32(2)] = result_39[i32(2)];
    outputs_0[_S164 + u32(3)] = result_39[i32(3)];
    return;
}

fn skin_eye_conic_0( r_2 : f32,  cornea_0 : vec4<f32>) -> vec2<f32>
{
    var _S165 : f32 = cornea_0.y;
    var ratio_1 : f32 = r_2 / _S165;
    var root_3 : f32 = skin_eye_root_0(1.0f - (1.0f + cornea_0.z) * ratio_1 * ratio_1);
    return vec2<f32>(cornea_0.x - r_2 * r_2 / (_S165 * (1.0f + root_3)), -1.0f / (_S165 * root_3));
}

fn skin_eye_profile_0( r_3 : f32,  cornea_1 : vec4<f32>,  limbus_1 : vec4<f32>) -> vec2<f32>
{
    var _S166 : f32 = limbus_1.x;
    var _S167 : f32 = limbus_1.y;
    var inner_0 : f32 = _S166 - _S167;
    var outer_0 : f32 = _S166 + _S167;
    var width_0 : f32 = outer_0 - inner_0;
    if(r_3 < inner_0)
    {
        return skin_eye_conic_0(r_3, cornea_1);
    }
    if(r_3 >= outer_0)
    {
        var _S168 : f32 = limbus_1.z;
        var sphere_0 : f32 = skin_eye_root_0(_S168 * _S168 - r_3 * r_3);
        return vec2<f32>(sphere_0, -1.0f / sphere_0);
    }
    var start_63 : vec2<f32> = skin_eye_conic_0(inner_0, cornea_1);
    var _S169 : f32 = limbus_1.z;
    var end_0 : f32 = skin_eye_root_0(_S169 * _S169 - outer_0 * outer_0);
    var m0_0 : f32 = width_0 * inner_0 * start_63.y;
    var m1_0 : f32 = - width_0 * outer_0 / end_0;
    var t_2 : f32 = (r_3 - inner_0) / width_0;
    var _S170 : f32 = start_63.x;
    var rise_1 : f32 = end_0 - _S170;
    var c2_0 : f32 = 3.0f * rise_1 - 2.0f * m0_0 - m1_0;
    var c3_0 : f32 = m0_0 + m1_0 - 2.0f * rise_1;
    return vec2<f32>(_S170 + t_2 * (m0_0 + t_2 * (c2_0 + t_2 * c3_0)), (m0_0 + t_2 * (2.0f * c2_0 + t_2 * (3.0f * c3_0))) / (width_0 * max(r_3, 9.99999997475242708e-07f)));
}

fn skin_eye_height_0( r_mm_0 : f32,  cornea_2 : vec4<f32>,  limbus_2 : vec4<f32>) -> f32
{
    return skin_eye_profile_0(r_mm_0, cornea_2, limbus_2).x;
}

@compute
@workgroup_size(64, 1, 1)
fn run_eye_height(@builtin(global_invocation_id) thread_69 : vec3<u32>)
{
    var _S171 : u32 = thread_69.x;
    var start_64 : u32 = _S171 * u32(9);
    outputs_0[_S171] = skin_eye_height_0(inputs_0[start_64], vec4<f32>(inputs_0[start_64 + u32(1)], inputs_0[start_64 + u32(2)], inputs_0[start_64 + u32(3)], inputs_0[start_64 + u32(4)]), vec4<f32>(inputs_0[start_64 + u32(5)], inputs_0[start_64 + u32(6)], inputs_0[start_64 + u32(7)], inputs_0[start_64 + u32(8)]));
    return;
}

fn skin_eye_normal_0( position_mm_5 : vec3<f32>,  cornea_3 : vec4<f32>,  limbus_3 : vec4<f32>) -> vec3<f32>
{
    var _S172 : vec2<f32> = position_mm_5.xy;
    var r_4 : f32 = sqrt(dot(_S172, _S172));
    var slope_over_r_0 : f32 = skin_eye_profile_0(r_4, cornea_3, limbus_3).y;
    var in_front_0 : bool;
    if((position_mm_5.z) > 0.0f)
    {
        in_front_0 = r_4 < (limbus_3.x + limbus_3.y);
    }
    else
    {
        in_front_0 = false;
    }
    var normal_13 : vec3<f32> = vec3<f32>(vec2<f32>(- slope_over_r_0) * _S172, 1.0f);
    var _S173 : vec3<f32>;
    if(in_front_0)
    {
        _S173 = normal_13;
    }
    else
    {
        _S173 = position_mm_5;
    }
    return skin_unit_vectors_0(_S173);
}

@compute
@workgroup_size(64, 1, 1)
fn run_eye_normal(@builtin(global_invocation_id) thread_70 : vec3<u32>)
{
    var _S174 : u32 = thread_70.x;
    var start_65 : u32 = _S174 * u32(11);
    var result_40 : vec3<f32> = skin_eye_normal_0(vec3<f32>(inputs_0[start_65], inputs_0[start_65 + u32(1)], inputs_0[start_65 + u32(2)]), vec4<f32>(inputs_0[start_65 + u32(3)], inputs_0[start_65 + u32(4)], inputs_0[start_65 + u32(5)], inputs_0[start_65 + u32(6)]), vec4<f32>(inputs_0[start_65 + u32(7)], inputs_0[start_65 + u32(8)], inputs_0[start_65 + u32(9)], inputs_0[start_65 + u32(10)]));
    var _S175 : u32 = _S174 * u32(3);
    outputs_0[_S175] = result_40[i32(0)];
    outputs_0[_S175 + u32(1)] = result_40[i32(1)];
    outputs_0[_S175 + u32(2)] = result_40[i32(2)];
    return;
}

fn skin_eye_cornea_hit_0( origin_mm_0 : vec3<f32>,  direction_5 : vec3<f32>,  cornea_4 : vec4<f32>) -> vec4<f32>
{
    var q_1 : f32 = 1.0f + cornea_4.z;
    var s_2 : f32 = cornea_4.x - origin_mm_0.z;
    var _S176 : f32 = direction_5.z;
    var _S177 : vec2<f32> = origin_mm_0.xy;
    var _S178 : f32 = cornea_4.y;
    var _S179 : f32 = q_1 * s_2;
    var b_1 : f32 = dot(_S177, direction_5.xy) + _S176 * (_S178 - _S179);
    var c_0 : f32 = dot(_S177, _S177) - 2.0f * _S178 * s_2 + _S179 * s_2;
    var radicand_0 : f32 = b_1 * b_1 - (1.0f - (1.0f - q_1) * _S176 * _S176) * c_0;
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
        distance_0 = c_0 / max(skin_eye_root_0(radicand_0) - b_1, 9.99999997475242708e-07f);
    }
    else
    {
        distance_0 = 0.0f;
    }
    var _S180 : vec3<f32> = origin_mm_0 + vec3<f32>(distance_0) * direction_5;
    if(meets_0)
    {
        distance_0 = 1.0f;
    }
    else
    {
        distance_0 = 0.0f;
    }
    return vec4<f32>(_S180, distance_0);
}

@compute
@workgroup_size(64, 1, 1)
fn run_eye_cornea_hit(@builtin(global_invocation_id) thread_71 : vec3<u32>)
{
    var _S181 : u32 = thread_71.x;
    var start_66 : u32 = _S181 * u32(10);
    var result_41 : vec4<f32> = skin_eye_cornea_hit_0(vec3<f32>(inputs_0[start_66], inputs_0[start_66 + u32(1)], inputs_0[start_66 + u32(2)]), vec3<f32>(inputs_0[start_66 + u32(3)], inputs_0[start_66 + u32(4)], inputs_0[start_66 + u32(5)]), vec4<f32>(inputs_0[start_66 + u32(6)], inputs_0[start_66 + u32(7)], inputs_0[start_66 + u32(8)], inputs_0[start_66 + u32(9)]));
    var _S182 : u32 = _S181 * u32(4);
    outputs_0[_S182] = result_41[i32(0)];
    outputs_0[_S182 + u32(1)] = result_41[i32(1)];
    outputs_0[_S182 + u32(2)] = result_41[i32(2)];
    outputs_0[_S182 + u32(3)] = result_41[i32(3)];
    return;
}

fn skin_smooth_0( t_3 : f32) -> f32
{
    var clamped_0 : f32 = saturate(t_3);
    return clamped_0 * clamped_0 * (3.0f - 2.0f * clamped_0);
}

fn skin_eye_limbal_opacity_0( r_mm_1 : f32,  limbus_4 : vec4<f32>) -> f32
{
    var _S183 : f32 = limbus_4.y;
    return skin_smooth_0((r_mm_1 - limbus_4.x + _S183) / (2.0f * _S183));
}

@compute
@workgroup_size(64, 1, 1)
fn run_eye_limbal_opacity(@builtin(global_invocation_id) thread_72 : vec3<u32>)
{
    var _S184 : u32 = thread_72.x;
    var start_67 : u32 = _S184 * u32(5);
    outputs_0[_S184] = skin_eye_limbal_opacity_0(inputs_0[start_67], vec4<f32>(inputs_0[start_67 + u32(1)], inputs_0[start_67 + u32(2)], inputs_0[start_67 + u32(3)], inputs_0[start_67 + u32(4)]));
    return;
}

fn skin_eye_iris_hit_0( position_mm_6 : vec3<f32>,  normal_14 : vec3<f32>,  view_7 : vec3<f32>,  cornea_5 : vec4<f32>,  iris_0 : vec4<f32>) -> vec3<f32>
{
    var eta_0 : f32 = 1.0f / cornea_5.w;
    var _S185 : f32 = max(dot(normal_14, view_7), 0.0f);
    var d_1 : vec3<f32> = vec3<f32>((eta_0 * _S185 - sqrt(max(1.0f - eta_0 * eta_0 * (1.0f - _S185 * _S185), 0.0f)))) * normal_14 - vec3<f32>(eta_0) * view_7;
    var h_0 : f32 = iris_0.x - position_mm_6.z;
    var _S186 : f32 = iris_0.y;
    var m2_0 : f32 = _S186 * _S186;
    var _S187 : f32 = d_1.z;
    var _S188 : vec2<f32> = d_1.xy;
    var a_1 : f32 = _S187 * _S187 - m2_0 * dot(_S188, _S188);
    var _S189 : vec2<f32> = position_mm_6.xy;
    var b_2 : f32 = h_0 * _S187 + m2_0 * dot(_S189, _S188);
    var e_0 : f32 = h_0 * h_0 - m2_0 * dot(_S189, _S189);
    var apart_0 : vec2<f32> = vec2<f32>(h_0) * _S188 + vec2<f32>(_S187) * _S189;
    var cross_product_0 : f32 = d_1.x * position_mm_6.y - d_1.y * position_mm_6.x;
    var root_4 : f32 = abs(_S186) * sqrt(max(dot(apart_0, apart_0) - m2_0 * cross_product_0 * cross_product_0, 0.0f));
    var distance_1 : f32;
    if(_S186 < 0.0f)
    {
        distance_1 = e_0 / max(b_2 + root_4, 9.99999997475242708e-07f);
    }
    else
    {
        distance_1 = (b_2 + root_4) / max(a_1, 0.00009999999747379f);
    }
    return position_mm_6 + vec3<f32>(distance_1) * d_1;
}

@compute
@workgroup_size(64, 1, 1)
fn run_eye_iris_hit(@builtin(global_invocation_id) thread_73 : vec3<u32>)
{
    var _S190 : u32 = thread_73.x;
    var start_68 : u32 = _S190 * u32(17);
    var result_42 : vec3<f32> = skin_eye_iris_hit_0(vec3<f32>(inputs_0[start_68], inputs_0[start_68 + u32(1)], inputs_0[start_68 + u32(2)]), vec3<f32>(inputs_0[start_68 + u32(3)], inputs_0[start_68 + u32(4)], inputs_0[start_68 + u32(5)]), vec3<f32>(inputs_0[start_68 + u32(6)], inputs_0[start_68 + u32(7)], inputs_0[start_68 + u32(8)]), vec4<f32>(inputs_0[start_68 + u32(9)], inputs_0[start_68 + u32(10)], inputs_0[start_68 + u32(11)], inputs_0[start_68 + u32(12)]), vec4<f32>(inputs_0[start_68 + u32(13)], inputs_0[start_68 + u32(14)], inputs_0[start_68 + u32(15)], inputs_0[start_68 + u32(16)]));
    var _S191 : u32 = _S190 * u32(3);
    outputs_0[_S191] = result_42[i32(0)];
    outputs_0[_S191 + u32(1)] = result_42[i32(1)];
    outputs_0[_S191 + u32(2)] = result_42[i32(2)];
    return;
}

fn skin_eye_iris_uv_0( hit_mm_0 : vec3<f32>,  iris_1 : vec4<f32>,  pupil_in_map_0 : f32,  iris_uv_0 : vec4<f32>) -> vec2<f32>
{
    var _S192 : vec2<f32> = hit_mm_0.xy;
    var r_5 : f32 = sqrt(dot(_S192, _S192));
    var pupil_0 : f32 = iris_1.w;
    var _S193 : f32 = min((r_5 - pupil_0) / max(iris_1.z - pupil_0, 9.99999997475242708e-07f), 1.0f);
    var radius_0 : f32;
    if(r_5 < pupil_0)
    {
        radius_0 = pupil_in_map_0 * r_5 / max(pupil_0, 9.99999997475242708e-07f);
    }
    else
    {
        radius_0 = pupil_in_map_0 + (1.0f - pupil_in_map_0) * _S193;
    }
    var scale_0 : f32 = iris_uv_0.z * radius_0 / max(r_5, 9.99999997475242708e-07f);
    var angle_0 : f32 = 6.28318548202514648f * iris_uv_0.w;
    var cosine_4 : f32 = cos(angle_0);
    var sine_0 : f32 = sin(angle_0);
    var _S194 : f32 = hit_mm_0.x;
    var _S195 : f32 = hit_mm_0.y;
    return vec2<f32>(iris_uv_0.x + scale_0 * (cosine_4 * _S194 - sine_0 * _S195), iris_uv_0.y - scale_0 * (sine_0 * _S194 + cosine_4 * _S195));
}

@compute
@workgroup_size(64, 1, 1)
fn run_eye_iris_uv(@builtin(global_invocation_id) thread_74 : vec3<u32>)
{
    var _S196 : u32 = thread_74.x;
    var start_69 : u32 = _S196 * u32(12);
    var result_43 : vec2<f32> = skin_eye_iris_uv_0(vec3<f32>(inputs_0[start_69], inputs_0[start_69 + u32(1)], inputs_0[start_69 + u32(2)]), vec4<f32>(inputs_0[start_69 + u32(3)], inputs_0[start_69 + u32(4)], inputs_0[start_69 + u32(5)], inputs_0[start_69 + u32(6)]), inputs_0[start_69 + u32(7)], vec4<f32>(inputs_0[start_69 + u32(8)], inputs_0[start_69 + u32(9)], inputs_0[start_69 + u32(10)], inputs_0[start_69 + u32(11)]));
    var _S197 : u32 = _S196 * u32(2);
    outputs_0[_S197] = result_43[i32(0)];
    outputs_0[_S197 + u32(1)] = result_43[i32(1)];
    return;
}

fn skin_eye_iris_parallax_0( hit_mm_1 : vec3<f32>,  direction_6 : vec3<f32>,  iris_normal_0 : vec3<f32>,  height_mm_0 : f32) -> vec3<f32>
{
    return hit_mm_1 - direction_6 * vec3<f32>((height_mm_0 / max(- dot(direction_6, iris_normal_0), 0.10000000149011612f)));
}

@compute
@workgroup_size(64, 1, 1)
fn run_eye_iris_parallax(@builtin(global_invocation_id) thread_75 : vec3<u32>)
{
    var _S198 : u32 = thread_75.x;
    var start_70 : u32 = _S198 * u32(10);
    var result_44 : vec3<f32> = skin_eye_iris_parallax_0(vec3<f32>(inputs_0[start_70], inputs_0[start_70 + u32(1)], inputs_0[start_70 + u32(2)]), vec3<f32>(inputs_0[start_70 + u32(3)], inputs_0[start_70 + u32(4)], inputs_0[start_70 + u32(5)]), vec3<f32>(inputs_0[start_70 + u32(6)], inputs_0[start_70 + u32(7)], inputs_0[start_70 + u32(8)]), inputs_0[start_70 + u32(9)]);
    var _S199 : u32 = _S198 * u32(3);
    outputs_0[_S199] = result_44[i32(0)];
    outputs_0[_S199 + u32(1)] = result_44[i32(1)];
    outputs_0[_S199 + u32(2)] = result_44[i32(2)];
    return;
}

fn skin_eye_warped_0( cosine_5 : f32) -> f32
{
    var size_1 : f32 = pow(max(abs(cosine_5), 9.99999971718068537e-10f), 0.69999998807907104f);
    var _S200 : f32;
    if(cosine_5 < 0.0f)
    {
        _S200 = - size_1;
    }
    else
    {
        _S200 = size_1;
    }
    return _S200;
}

fn skin_eye_slice_0( cosine_6 : f32) -> f32
{
    var least_0 : f32 = skin_eye_warped_0(-0.34202015399932861f);
    return 15.0f * (skin_eye_warped_0(clamp(cosine_6, -0.34202015399932861f, 1.0f)) - least_0) / (1.0f - least_0);
}

fn skin_eye_light_0( lut_9 : texture_2d<f32>,  lut_sampler_9 : sampler,  lut_axes_8 : vec4<f32>,  hit_mm_2 : vec3<f32>,  light_10 : vec3<f32>) -> vec3<f32>
{
    var _S201 : vec2<f32> = light_10.xy;
    var across_1 : f32 = sqrt(dot(_S201, _S201));
    var turn_0 : vec2<f32>;
    if(across_1 > 9.99999997475242708e-07f)
    {
        turn_0 = _S201 / vec2<f32>(across_1);
    }
    else
    {
        turn_0 = vec2<f32>(1.0f, 0.0f);
    }
    var x_8 : f32 = dot(hit_mm_2.xy, turn_0);
    var _S202 : f32 = turn_0.x;
    var _S203 : f32 = turn_0.y;
    var y_2 : f32 = hit_mm_2.y * _S202 - hit_mm_2.x * _S203;
    var index_0 : f32 = skin_eye_slice_0(light_10.z);
    var _S204 : f32 = min(floor(index_0), 14.0f);
    var row_2 : f32 = 0.5f + 15.0f * min(abs(y_2) / (- lut_axes_8.x * 31.0f / 32.0f), 1.0f) + 16.0f * _S204;
    var _S205 : vec2<f32> = lut_axes_8.xz;
    var _S206 : vec2<f32> = lut_axes_8.yw;
    var first_0 : vec3<f32> = (textureSampleLevel((lut_9), (lut_sampler_9), (saturate((vec2<f32>(x_8, row_2) - _S205) * _S206)), (0.0f))).xyz;
    var second_0 : vec3<f32> = (textureSampleLevel((lut_9), (lut_sampler_9), (saturate((vec2<f32>(x_8, row_2 + 16.0f) - _S205) * _S206)), (0.0f))).xyz;
    var straight_0 : f32 = 1.0f - min(across_1 / 0.50550216436386108f, 1.0f);
    var moved_0 : f32;
    if(_S204 > 13.5f)
    {
        moved_0 = straight_0;
    }
    else
    {
        moved_0 = index_0 - _S204;
    }
    var value_1 : vec3<f32> = mix(first_0, second_0, vec3<f32>(index_0 - _S204, moved_0, moved_0));
    var entry_y_0 : f32;
    if(y_2 < 0.0f)
    {
        entry_y_0 = - value_1.z;
    }
    else
    {
        entry_y_0 = value_1.z;
    }
    var _S207 : f32 = value_1.y;
    return vec3<f32>(value_1.x, _S207 * _S202 - entry_y_0 * _S203, _S207 * _S203 + entry_y_0 * _S202);
}

@compute
@workgroup_size(64, 1, 1)
fn run_eye_light(@builtin(global_invocation_id) thread_76 : vec3<u32>)
{
    var _S208 : u32 = thread_76.x;
    var start_71 : u32 = _S208 * u32(10);
    var result_45 : vec3<f32> = skin_eye_light_0(lut_0, lut_sampler_0, vec4<f32>(inputs_0[start_71], inputs_0[start_71 + u32(1)], inputs_0[start_71 + u32(2)], inputs_0[start_71 + u32(3)]), vec3<f32>(inputs_0[start_71 + u32(4)], inputs_0[start_71 + u32(5)], inputs_0[start_71 + u32(6)]), vec3<f32>(inputs_0[start_71 + u32(7)], inputs_0[start_71 + u32(8)], inputs_0[start_71 + u32(9)]));
    var _S209 : u32 = _S208 * u32(3);
    outputs_0[_S209] = result_45[i32(0)];
    outputs_0[_S209 + u32(1)] = result_45[i32(1)];
    outputs_0[_S209 + u32(2)] = result_45[i32(2)];
    return;
}

fn skin_eye_ambient_0( lut_10 : texture_2d<f32>,  lut_sampler_10 : sampler,  lut_axes_9 : vec4<f32>,  r_mm_2 : f32) -> vec4<f32>
{
    var _S210 : vec2<f32> = lut_axes_9.xz;
    var _S211 : vec2<f32> = lut_axes_9.yw;
    return vec4<f32>((textureSampleLevel((lut_10), (lut_sampler_10), (saturate((vec2<f32>(r_mm_2, 0.0f) - _S210) * _S211)), (0.0f))).xyz, (textureSampleLevel((lut_10), (lut_sampler_10), (saturate((vec2<f32>(r_mm_2, 1.0f) - _S210) * _S211)), (0.0f))).xyz.x);
}

@compute
@workgroup_size(64, 1, 1)
fn run_eye_ambient(@builtin(global_invocation_id) thread_77 : vec3<u32>)
{
    var _S212 : u32 = thread_77.x;
    var start_72 : u32 = _S212 * u32(5);
    var result_46 : vec4<f32> = skin_eye_ambient_0(lut_0, lut_sampler_0, vec4<f32>(inputs_0[start_72], inputs_0[start_72 + u32(1)], inputs_0[start_72 + u32(2)], inputs_0[start_72 + u32(3)]), inputs_0[start_72 + u32(4)]);
    var _S213 : u32 = _S212 * u32(4);
    outputs_0[_S213] = result_46[i32(0)];
    outputs_0[_S213 + u32(1)] = result_46[i32(1)];
    outputs_0[_S213 + u32(2)] = result_46[i32(2)];
    outputs_0[_S213 + u32(3)] = result_46[i32(3)];
    return;
}

fn skin_dielectric_fresnel_0( cosine_7 : f32,  index_1 : f32) -> f32
{
    var c_1 : f32 = saturate(cosine_7);
    var _S214 : f32 = index_1 * index_1;
    var inside_0 : f32 = sqrt(max(_S214 - 1.0f + c_1 * c_1, 0.0f));
    var s_3 : f32 = (c_1 - inside_0) / max(c_1 + inside_0, 9.99999997475242708e-07f);
    var _S215 : f32 = _S214 * c_1;
    var p_2 : f32 = (_S215 - inside_0) / max(_S215 + inside_0, 9.99999997475242708e-07f);
    return 0.5f * (s_3 * s_3 + p_2 * p_2);
}

@compute
@workgroup_size(64, 1, 1)
fn run_dielectric_fresnel(@builtin(global_invocation_id) thread_78 : vec3<u32>)
{
    var _S216 : u32 = thread_78.x;
    var start_73 : u32 = _S216 * u32(2);
    outputs_0[_S216] = skin_dielectric_fresnel_0(inputs_0[start_73], inputs_0[start_73 + u32(1)]);
    return;
}

fn skin_eye_inside_0( n_dot_v_10 : f32,  index_2 : f32) -> f32
{
    return (1.0f - skin_dielectric_fresnel_0(n_dot_v_10, index_2)) / (index_2 * index_2);
}

@compute
@workgroup_size(64, 1, 1)
fn run_eye_inside(@builtin(global_invocation_id) thread_79 : vec3<u32>)
{
    var _S217 : u32 = thread_79.x;
    var start_74 : u32 = _S217 * u32(2);
    outputs_0[_S217] = skin_eye_inside_0(inputs_0[start_74], inputs_0[start_74 + u32(1)]);
    return;
}

fn skin_lamp_highlight_0( reflected_0 : vec3<f32>,  light_11 : vec3<f32>,  lamp_0 : f32,  roughness_2 : f32) -> f32
{
    var apart_1 : vec3<f32> = reflected_0 - light_11;
    var chord2_0 : f32 = dot(apart_1, apart_1);
    var wide_1 : f32 = sqrt(lamp_0 * lamp_0 + roughness_2 * roughness_2);
    var _S218 : f32 = max(roughness_2, 0.00009999999747379f);
    var sine_1 : f32 = sin(wide_1);
    return skin_smooth_0((wide_1 + _S218 - sqrt(chord2_0) * (1.0f + chord2_0 * (0.0416666679084301f + chord2_0 * 0.00468750018626451f))) / (2.0f * _S218)) / (sine_1 * sine_1 + _S218 * _S218 / 5.0f);
}

@compute
@workgroup_size(64, 1, 1)
fn run_lamp_highlight(@builtin(global_invocation_id) thread_80 : vec3<u32>)
{
    var _S219 : u32 = thread_80.x;
    var start_75 : u32 = _S219 * u32(8);
    outputs_0[_S219] = skin_lamp_highlight_0(vec3<f32>(inputs_0[start_75], inputs_0[start_75 + u32(1)], inputs_0[start_75 + u32(2)]), vec3<f32>(inputs_0[start_75 + u32(3)], inputs_0[start_75 + u32(4)], inputs_0[start_75 + u32(5)]), inputs_0[start_75 + u32(6)], inputs_0[start_75 + u32(7)]);
    return;
}

fn skin_pupil_radius_0( luminance_0 : f32) -> f32
{
    return 2.45000004768371582f - 1.5f * tanh(0.12041200697422028f * log2(clamp(luminance_0, 9.99999997475242708e-07f, 1.0e+08f)));
}

@compute
@workgroup_size(64, 1, 1)
fn run_pupil_radius(@builtin(global_invocation_id) thread_81 : vec3<u32>)
{
    var _S220 : u32 = thread_81.x;
    outputs_0[_S220] = skin_pupil_radius_0(inputs_0[_S220]);
    return;
}

fn skin_lid_share_0( position_mm_7 : vec3<f32>,  exit_mm_0 : vec3<f32>,  penumbra_0 : f32,  ramp_0 : f32,  lid_0 : vec4<f32>) -> f32
{
    var _S221 : f32 = lid_0.w;
    var _S222 : vec3<f32> = lid_0.xyz;
    return skin_smooth_0((_S221 - dot(_S222, exit_mm_0)) / penumbra_0 + 0.5f) * saturate((_S221 - dot(_S222, position_mm_7)) / ramp_0 + 0.5f);
}

fn skin_lid_visibility_0( position_mm_8 : vec3<f32>,  direction_7 : vec3<f32>,  spread_0 : f32,  margin_mm_0 : f32,  upper_0 : vec4<f32>,  lower_0 : vec4<f32>,  radius_mm_3 : f32) -> f32
{
    var along_1 : f32 = dot(position_mm_8, direction_7);
    var distance_2 : f32 = sqrt(max(along_1 * along_1 + (radius_mm_3 * radius_mm_3 - dot(position_mm_8, position_mm_8)), 0.0f)) - along_1;
    var exit_mm_1 : vec3<f32> = position_mm_8 + vec3<f32>(distance_2) * direction_7;
    var _S223 : f32 = max(2.0f * distance_2 * spread_0, 0.00009999999747379f);
    var _S224 : f32 = max(2.0f * margin_mm_0, 0.00009999999747379f);
    return skin_lid_share_0(position_mm_8, exit_mm_1, _S223, _S224, upper_0) * skin_lid_share_0(position_mm_8, exit_mm_1, _S223, _S224, lower_0);
}

@compute
@workgroup_size(64, 1, 1)
fn run_lid_visibility(@builtin(global_invocation_id) thread_82 : vec3<u32>)
{
    var _S225 : u32 = thread_82.x;
    var start_76 : u32 = _S225 * u32(17);
    outputs_0[_S225] = skin_lid_visibility_0(vec3<f32>(inputs_0[start_76], inputs_0[start_76 + u32(1)], inputs_0[start_76 + u32(2)]), vec3<f32>(inputs_0[start_76 + u32(3)], inputs_0[start_76 + u32(4)], inputs_0[start_76 + u32(5)]), inputs_0[start_76 + u32(6)], inputs_0[start_76 + u32(7)], vec4<f32>(inputs_0[start_76 + u32(8)], inputs_0[start_76 + u32(9)], inputs_0[start_76 + u32(10)], inputs_0[start_76 + u32(11)]), vec4<f32>(inputs_0[start_76 + u32(12)], inputs_0[start_76 + u32(13)], inputs_0[start_76 + u32(14)], inputs_0[start_76 + u32(15)]), inputs_0[start_76 + u32(16)]);
    return;
}

fn skin_lid_hidden_0( position_mm_9 : vec3<f32>,  normal_15 : vec3<f32>,  lid_1 : vec4<f32>,  radius_mm_4 : f32) -> f32
{
    var _S226 : vec3<f32> = lid_1.xyz;
    var toward_0 : f32 = dot(_S226, normal_15);
    var tangent_0 : f32 = sqrt(max(1.0f - toward_0 * toward_0, 0.00009999999747379f));
    var _S227 : vec3<f32> = vec3<f32>(toward_0);
    var _S228 : vec3<f32> = vec3<f32>(tangent_0);
    var bare_0 : f32 = lid_1.w - dot(_S226, position_mm_9);
    var foot_0 : vec3<f32> = position_mm_9 + vec3<f32>(bare_0) * _S226;
    var along_2 : f32 = dot(foot_0, _S228 * normal_15 - _S227 * ((_S226 - _S227 * normal_15) / _S228));
    var radicand_1 : f32 = along_2 * along_2 - (dot(foot_0, foot_0) - radius_mm_4 * radius_mm_4);
    var length_0 : f32 = sqrt(max(radicand_1, 0.0f)) - along_2;
    var above_0 : f32 = bare_0 * toward_0 + length_0 * tangent_0;
    var beside_0 : f32 = bare_0 * tangent_0 - length_0 * toward_0;
    var cosine_8 : f32 = beside_0 / max(sqrt(above_0 * above_0 + beside_0 * beside_0), 0.00009999999747379f);
    var _S229 : bool;
    if(above_0 > 0.0f)
    {
        _S229 = radicand_1 > 0.0f;
    }
    else
    {
        _S229 = false;
    }
    var _S230 : f32;
    if(_S229)
    {
        _S230 = 0.5f * (1.0f - cosine_8);
    }
    else
    {
        _S230 = 0.0f;
    }
    return _S230;
}

fn skin_lid_openness_0( position_mm_10 : vec3<f32>,  normal_16 : vec3<f32>,  upper_1 : vec4<f32>,  lower_1 : vec4<f32>,  radius_mm_5 : f32) -> f32
{
    return saturate(1.0f - skin_lid_hidden_0(position_mm_10, normal_16, upper_1, radius_mm_5) - skin_lid_hidden_0(position_mm_10, normal_16, lower_1, radius_mm_5));
}

@compute
@workgroup_size(64, 1, 1)
fn run_lid_openness(@builtin(global_invocation_id) thread_83 : vec3<u32>)
{
    var _S231 : u32 = thread_83.x;
    var start_77 : u32 = _S231 * u32(15);
    outputs_0[_S231] = skin_lid_openness_0(vec3<f32>(inputs_0[start_77], inputs_0[start_77 + u32(1)], inputs_0[start_77 + u32(2)]), vec3<f32>(inputs_0[start_77 + u32(3)], inputs_0[start_77 + u32(4)], inputs_0[start_77 + u32(5)]), vec4<f32>(inputs_0[start_77 + u32(6)], inputs_0[start_77 + u32(7)], inputs_0[start_77 + u32(8)], inputs_0[start_77 + u32(9)]), vec4<f32>(inputs_0[start_77 + u32(10)], inputs_0[start_77 + u32(11)], inputs_0[start_77 + u32(12)], inputs_0[start_77 + u32(13)]), inputs_0[start_77 + u32(14)]);
    return;
}

fn skin_lid_iris_hidden_0( position_mm_11 : vec3<f32>,  narrowed_0 : f32,  lid_2 : vec4<f32>) -> f32
{
    var a_2 : f32 = lid_2.w - dot(lid_2.xyz, position_mm_11) - 0.57999998331069946f * narrowed_0;
    var width_1 : f32 = 2.58999991416931152f * narrowed_0;
    return 0.5f * (1.0f - a_2 / sqrt(a_2 * a_2 + width_1 * width_1));
}

fn skin_lid_iris_openness_0( hit_mm_3 : vec3<f32>,  cornea_6 : vec4<f32>,  limbus_5 : vec4<f32>,  upper_2 : vec4<f32>,  lower_2 : vec4<f32>) -> f32
{
    var _S232 : vec2<f32> = hit_mm_3.xy;
    var _S233 : f32 = limbus_5.x;
    var squared_1 : f32 = dot(_S232, _S232) / (_S233 * _S233);
    var rim_0 : f32 = squared_1 * squared_1;
    var entry_1 : vec2<f32> = vec2<f32>((0.82999998331069946f + 0.40999999642372131f * rim_0)) * _S232;
    var _S234 : f32 = max(1.0f - 1.12000000476837158f * rim_0, 0.05000000074505806f);
    var position_2 : vec3<f32> = vec3<f32>(entry_1, skin_eye_height_0(sqrt(dot(entry_1, entry_1)), cornea_6, limbus_5));
    return saturate(1.0f - skin_lid_iris_hidden_0(position_2, _S234, upper_2) - skin_lid_iris_hidden_0(position_2, _S234, lower_2));
}

@compute
@workgroup_size(64, 1, 1)
fn run_lid_iris_openness(@builtin(global_invocation_id) thread_84 : vec3<u32>)
{
    var _S235 : u32 = thread_84.x;
    var start_78 : u32 = _S235 * u32(19);
    outputs_0[_S235] = skin_lid_iris_openness_0(vec3<f32>(inputs_0[start_78], inputs_0[start_78 + u32(1)], inputs_0[start_78 + u32(2)]), vec4<f32>(inputs_0[start_78 + u32(3)], inputs_0[start_78 + u32(4)], inputs_0[start_78 + u32(5)], inputs_0[start_78 + u32(6)]), vec4<f32>(inputs_0[start_78 + u32(7)], inputs_0[start_78 + u32(8)], inputs_0[start_78 + u32(9)], inputs_0[start_78 + u32(10)]), vec4<f32>(inputs_0[start_78 + u32(11)], inputs_0[start_78 + u32(12)], inputs_0[start_78 + u32(13)], inputs_0[start_78 + u32(14)]), vec4<f32>(inputs_0[start_78 + u32(15)], inputs_0[start_78 + u32(16)], inputs_0[start_78 + u32(17)], inputs_0[start_78 + u32(18)]));
    return;
}

fn skin_tear_normal_0( position_mm_12 : vec3<f32>,  normal_17 : vec3<f32>,  lid_3 : vec4<f32>,  height_mm_1 : f32) -> vec3<f32>
{
    var _S236 : vec3<f32> = lid_3.xyz;
    var sine_2 : f32 = saturate(1.0f - (lid_3.w - dot(_S236, position_mm_12)) / max(height_mm_1, 0.00009999999747379f));
    return skin_unit_vectors_0(vec3<f32>(sqrt(max(1.0f - sine_2 * sine_2, 0.0f))) * normal_17 - vec3<f32>(sine_2) * skin_unit_vectors_0(_S236 - vec3<f32>(dot(_S236, normal_17)) * normal_17));
}

@compute
@workgroup_size(64, 1, 1)
fn run_tear_normal(@builtin(global_invocation_id) thread_85 : vec3<u32>)
{
    var _S237 : u32 = thread_85.x;
    var start_79 : u32 = _S237 * u32(11);
    var result_47 : vec3<f32> = skin_tear_normal_0(vec3<f32>(inputs_0[start_79], inputs_0[start_79 + u32(1)], inputs_0[start_79 + u32(2)]), vec3<f32>(inputs_0[start_79 + u32(3)], inputs_0[start_79 + u32(4)], inputs_0[start_79 + u32(5)]), vec4<f32>(inputs_0[start_79 + u32(6)], inputs_0[start_79 + u32(7)], inputs_0[start_79 + u32(8)], inputs_0[start_79 + u32(9)]), inputs_0[start_79 + u32(10)]);
    var _S238 : u32 = _S237 * u32(3);
    outputs_0[_S238] = result_47[i32(0)];
    outputs_0[_S238 + u32(1)] = result_47[i32(1)];
    outputs_0[_S238 + u32(2)] = result_47[i32(2)];
    return;
}

