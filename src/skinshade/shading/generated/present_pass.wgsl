@binding(1) @group(0) var light_texels_0 : texture_2d<f32>;

@binding(2) @group(0) var sum_texels_0 : texture_2d<f32>;

struct FrameBlock_std140_0
{
    @align(16) radiance_sh_0 : array<vec4<f32>, i32(9)>,
    @align(16) clip_x_0 : vec4<f32>,
    @align(16) clip_y_0 : vec4<f32>,
    @align(16) clip_z_0 : vec4<f32>,
    @align(16) clip_w_0 : vec4<f32>,
    @align(16) eye_mm_0 : vec4<f32>,
    @align(16) ray_across_0 : vec4<f32>,
    @align(16) ray_up_0 : vec4<f32>,
    @align(16) ray_ahead_0 : vec4<f32>,
    @align(16) background_0 : vec4<f32>,
    @align(16) footprint_0 : f32,
    @align(4) sample_weight_0 : f32,
    @align(8) uv_scale_mm_0 : f32,
    @align(4) environment_scale_0 : f32,
    @align(16) exposure_0 : f32,
};

@binding(0) @group(0) var<uniform> frame_block_0 : FrameBlock_std140_0;
@binding(3) @group(0) var sky_texels_0 : texture_2d<f32>;

@id(1) override ENVIRONMENT_0 : i32 = i32(0);

struct vertexOutput_0
{
    @invariant @builtin(position) output_0 : vec4<f32>,
};

@vertex
fn vertex_main(@builtin(vertex_index) corner_0 : u32) -> vertexOutput_0
{
    var _S1 : f32;
    if(corner_0 == u32(1))
    {
        _S1 = 3.0f;
    }
    else
    {
        _S1 = -1.0f;
    }
    var _S2 : f32;
    if(corner_0 == u32(2))
    {
        _S2 = 3.0f;
    }
    else
    {
        _S2 = -1.0f;
    }
    var _S3 : vertexOutput_0 = vertexOutput_0( vec4<f32>(_S1, _S2, 0.0f, 1.0f) );
    return _S3;
}

@id(0) override STAGE_0 : i32 = i32(1);

fn skin_safe_length_0( v_0 : vec3<f32>) -> f32
{
    return sqrt(max(dot(v_0, v_0), 1.00000004581370497e-18f));
}

fn skin_unit_vectors_0( v_1 : vec3<f32>) -> vec3<f32>
{
    return v_1 / vec3<f32>(skin_safe_length_0(v_1));
}

fn skin_turns_0( y_0 : f32,  x_0 : f32) -> f32
{
    var size_0 : vec2<f32> = abs(vec2<f32>(x_0, y_0));
    var _S4 : f32 = size_0.x;
    var _S5 : f32 = size_0.y;
    var r_0 : f32 = min(_S4, _S5) / max(max(_S4, _S5), 1.00000000317107685e-30f);
    var r2_0 : f32 = r_0 * r_0;
    var turns_0 : f32 = r_0 * (0.15915107727050781f + r2_0 * (-0.05293257534503937f + r2_0 * (0.03076364658772945f + r2_0 * (-0.01842727139592171f + r2_0 * (0.00826387945562601f - r2_0 * 0.00181874714326113f)))));
    var turns_1 : f32;
    if(_S5 > _S4)
    {
        turns_1 = 0.25f - turns_0;
    }
    else
    {
        turns_1 = turns_0;
    }
    if(x_0 < 0.0f)
    {
        turns_1 = 0.5f - turns_1;
    }
    else
    {
    }
    if(y_0 < 0.0f)
    {
        turns_1 = - turns_1;
    }
    else
    {
    }
    return turns_1;
}

fn skin_equirectangular_uv_0( direction_0 : vec3<f32>) -> vec2<f32>
{
    var _S6 : f32 = direction_0.x;
    var _S7 : f32 = direction_0.z;
    return vec2<f32>(0.5f + skin_turns_0(_S7, _S6), 2.0f * skin_turns_0(sqrt(_S6 * _S6 + _S7 * _S7), direction_0.y));
}

fn sky_radiance_0( direction_1 : vec3<f32>) -> vec3<f32>
{
    var width_0 : u32;
    var height_0 : u32;
    {var dim = textureDimensions((sky_texels_0));((width_0)) = dim.x;((height_0)) = dim.y;};
    var uv_0 : vec2<f32> = skin_equirectangular_uv_0(direction_1);
    var _S8 : f32 = uv_0.x * f32(width_0) - 0.5f;
    var _S9 : f32 = clamp(uv_0.y * f32(height_0) - 0.5f, 0.0f, f32(height_0) - 1.0f);
    var _S10 : f32 = floor(_S8);
    var _S11 : f32 = min(floor(_S9), f32(height_0) - 2.0f);
    var f_0 : vec2<f32> = vec2<f32>(_S8, _S9) - vec2<f32>(_S10, _S11);
    var left_0 : i32 = (i32(_S10) + i32(width_0)) % i32(width_0);
    var right_0 : i32 = (left_0 + i32(1)) % i32(width_0);
    var top_0 : i32 = i32(_S11);
    var _S12 : vec3<i32> = vec3<i32>(left_0, top_0, i32(0));
    var _S13 : vec3<i32> = vec3<i32>(right_0, top_0, i32(0));
    var _S14 : i32 = top_0 + i32(1);
    var _S15 : vec3<i32> = vec3<i32>(left_0, _S14, i32(0));
    var _S16 : vec3<i32> = vec3<i32>(right_0, _S14, i32(0));
    var _S17 : vec3<f32> = vec3<f32>(f_0.x);
    return vec3<f32>(frame_block_0.environment_scale_0) * mix(mix((textureLoad((sky_texels_0), ((_S12)).xy, ((_S12)).z)).xyz, (textureLoad((sky_texels_0), ((_S13)).xy, ((_S13)).z)).xyz, _S17), mix((textureLoad((sky_texels_0), ((_S15)).xy, ((_S15)).z)).xyz, (textureLoad((sky_texels_0), ((_S16)).xy, ((_S16)).z)).xyz, _S17), vec3<f32>(f_0.y));
}

fn skin_srgb_curve_0( x_1 : f32) -> f32
{
    var _S18 : f32;
    if(x_1 <= 0.00313080009073019f)
    {
        _S18 = 12.92000007629394531f * x_1;
    }
    else
    {
        _S18 = 1.0549999475479126f * pow(max(x_1, 9.999999960041972e-13f), 0.4166666567325592f) - 0.05499999970197678f;
    }
    return _S18;
}

fn skin_srgb_from_linear_0( light_0 : vec3<f32>) -> vec3<f32>
{
    var x_2 : vec3<f32> = saturate(light_0);
    return vec3<f32>(skin_srgb_curve_0(x_2.x), skin_srgb_curve_0(x_2.y), skin_srgb_curve_0(x_2.z));
}

fn skin_filmic_0( light_1 : vec3<f32>) -> vec3<f32>
{
    var x_3 : vec3<f32> = max(light_1 - vec3<f32>(0.00400000018998981f), vec3<f32>(0.0f));
    var _S19 : vec3<f32> = vec3<f32>(6.19999980926513672f) * x_3;
    return x_3 * (_S19 + vec3<f32>(0.5f)) / (x_3 * (_S19 + vec3<f32>(1.70000004768371582f)) + vec3<f32>(0.05999999865889549f));
}

struct pixelOutput_0
{
    @location(0) output_1 : vec4<f32>,
};

@fragment
fn fragment_main(@invariant @builtin(position) clip_0 : vec4<f32>) -> pixelOutput_0
{
    var texel_0 : vec3<i32> = vec3<i32>(vec2<i32>(clip_0.xy), i32(0));
    var light_2 : vec4<f32> = (textureLoad((light_texels_0), ((texel_0)).xy, ((texel_0)).z));
    if(STAGE_0 == i32(0))
    {
        var _S20 : pixelOutput_0 = pixelOutput_0( (textureLoad((sum_texels_0), ((texel_0)).xy, ((texel_0)).z)) + vec4<f32>(frame_block_0.sample_weight_0) * light_2 );
        return _S20;
    }
    var _S21 : vec3<f32> = frame_block_0.background_0.xyz;
    var background_1 : vec3<f32>;
    if(ENVIRONMENT_0 > i32(0))
    {
        var width_1 : u32;
        var height_1 : u32;
        {var dim = textureDimensions((light_texels_0));((width_1)) = dim.x;((height_1)) = dim.y;};
        var _S22 : vec3<f32> = sky_radiance_0(skin_unit_vectors_0(frame_block_0.ray_across_0.xyz * vec3<f32>((2.0f * clip_0.x / f32(width_1) - 1.0f)) + frame_block_0.ray_up_0.xyz * vec3<f32>((1.0f - 2.0f * clip_0.y / f32(height_1))) + frame_block_0.ray_ahead_0.xyz));
        background_1 = _S22;
    }
    else
    {
        background_1 = _S21;
    }
    var _S23 : f32 = light_2.w;
    var color_0 : vec3<f32> = light_2.xyz + vec3<f32>((1.0f - _S23)) * background_1;
    var color_1 : vec3<f32>;
    if(STAGE_0 == i32(2))
    {
        color_1 = skin_srgb_from_linear_0(min(color_0 * vec3<f32>(frame_block_0.exposure_0), vec3<f32>(1.0e+06f)));
    }
    else
    {
        color_1 = color_0;
    }
    if(STAGE_0 == i32(3))
    {
        color_1 = skin_filmic_0(min(color_1 * vec3<f32>(frame_block_0.exposure_0), vec3<f32>(1.0e+06f)));
    }
    else
    {
    }
    var _S24 : pixelOutput_0 = pixelOutput_0( vec4<f32>(color_1, _S23) );
    return _S24;
}

