struct LightBlock_std430_0
{
    @align(16) view_x_0 : vec4<f32>,
    @align(16) view_y_0 : vec4<f32>,
    @align(16) view_z_0 : vec4<f32>,
    @align(16) clip_x_0 : vec4<f32>,
    @align(16) clip_y_0 : vec4<f32>,
    @align(16) clip_w_0 : vec4<f32>,
    @align(16) direction_0 : vec4<f32>,
    @align(16) position_mm_0 : vec4<f32>,
    @align(16) irradiance_0 : vec4<f32>,
    @align(16) cone_cosines_0 : vec2<f32>,
    @align(8) depth_mm_0 : vec2<f32>,
    @align(16) near_0 : f32,
    @align(4) target_distance_mm_0 : f32,
    @align(8) blur_texels_0 : f32,
};

@binding(0) @group(0) var<storage, read> lights_0 : array<LightBlock_std430_0>;

@binding(1) @group(0) var source_0 : texture_2d_array<f32>;

@id(0) override VERTICAL_0 : i32 = i32(0);

struct ScreenFragment_0
{
    @invariant @builtin(position) clip_0 : vec4<f32>,
    @interpolate(flat) @location(0) light_index_0 : u32,
};

@vertex
fn vertex_main(@builtin(vertex_index) corner_0 : u32, @builtin(instance_index) light_index_1 : u32) -> ScreenFragment_0
{
    var o_0 : ScreenFragment_0;
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
    o_0.clip_0 = vec4<f32>(_S1, _S2, 0.0f, 1.0f);
    o_0.light_index_0 = light_index_1;
    return o_0;
}

fn moments_of_0( texel_0 : vec2<i32>,  light_index_2 : u32) -> vec2<f32>
{
    var _S3 : vec2<i32> = clamp(texel_0, vec2<i32>(i32(0)), vec2<i32>(i32(1023)));
    if(VERTICAL_0 > i32(0))
    {
        var _S4 : vec4<i32> = vec4<i32>(_S3, i32(0), i32(0));
        return (textureLoad((source_0), ((_S4)).xy, i32(((_S4)).z), ((_S4)).w)).xy;
    }
    var _S5 : vec4<i32> = vec4<i32>(_S3, i32(u32(2) * light_index_2 + u32(1)), i32(0));
    var _S6 : f32 = min((textureLoad((source_0), ((_S5)).xy, i32(((_S5)).z), ((_S5)).w)).x - lights_0[light_index_2].depth_mm_0.x, lights_0[light_index_2].depth_mm_0.y);
    return vec2<f32>(_S6, _S6 * _S6);
}

struct pixelOutput_0
{
    @location(0) output_0 : vec2<f32>,
};

struct pixelInput_0
{
    @interpolate(flat) @location(0) light_index_3 : u32,
};

@fragment
fn fragment_main( _S7 : pixelInput_0, @invariant @builtin(position) clip_1 : vec4<f32>) -> pixelOutput_0
{
    var sigma_0 : f32 = lights_0[_S7.light_index_3].blur_texels_0;
    var reach_0 : i32 = i32(3.0f * lights_0[_S7.light_index_3].blur_texels_0 + 0.5f);
    var _S8 : vec2<i32>;
    if(VERTICAL_0 > i32(0))
    {
        _S8 = vec2<i32>(i32(0), i32(1));
    }
    else
    {
        _S8 = vec2<i32>(i32(1), i32(0));
    }
    var _S9 : vec2<f32> = vec2<f32>(0.0f);
    var step_0 : i32 = - reach_0;
    var total_0 : vec2<f32> = _S9;
    var weights_0 : f32 = 0.0f;
    for(;;)
    {
        if(step_0 <= reach_0)
        {
        }
        else
        {
            break;
        }
        var from_middle_0 : f32 = f32(step_0) / sigma_0;
        var weight_0 : f32 = exp(-0.5f * from_middle_0 * from_middle_0);
        var total_1 : vec2<f32> = total_0 + vec2<f32>(weight_0) * moments_of_0(vec2<i32>(clip_1.xy) + vec2<i32>(step_0) * _S8, _S7.light_index_3);
        var weights_1 : f32 = weights_0 + weight_0;
        step_0 = step_0 + i32(1);
        total_0 = total_1;
        weights_0 = weights_1;
    }
    var _S10 : pixelOutput_0 = pixelOutput_0( total_0 / vec2<f32>(weights_0) );
    return _S10;
}

