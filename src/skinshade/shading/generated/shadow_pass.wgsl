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

@id(0) override OCCLUDERS_0 : i32 = i32(0);

struct DepthFragment_0
{
    @invariant @builtin(position) clip_0 : vec4<f32>,
    @location(0) depth_mm_1 : f32,
    @interpolate(flat) @location(1) range_mm_0 : vec2<f32>,
};

struct vertexInput_0
{
    @location(0) position_mm_1 : vec4<f32>,
};

@vertex
fn vertex_main( _S1 : vertexInput_0, @builtin(instance_index) light_index_0 : u32) -> DepthFragment_0
{
    var p_0 : vec4<f32> = vec4<f32>(_S1.position_mm_1.xyz, 1.0f);
    var _S2 : f32 = dot(lights_0[light_index_0].view_z_0, p_0);
    var in_view_0 : vec4<f32> = vec4<f32>(dot(lights_0[light_index_0].view_x_0, p_0), dot(lights_0[light_index_0].view_y_0, p_0), _S2, 1.0f);
    var w_0 : f32 = dot(lights_0[light_index_0].clip_w_0, in_view_0);
    var o_0 : DepthFragment_0;
    o_0.depth_mm_1 = - _S2;
    o_0.range_mm_0 = lights_0[light_index_0].depth_mm_0;
    o_0.clip_0 = vec4<f32>(dot(lights_0[light_index_0].clip_x_0, in_view_0), dot(lights_0[light_index_0].clip_y_0, in_view_0), 0.5f * w_0, w_0);
    return o_0;
}

fn skin_shadow_occluder_depth_0( depth_mm_2 : f32,  faces_light_0 : f32) -> f32
{
    return depth_mm_2 + 4.0f * faces_light_0;
}

struct DepthTexel_0
{
    @location(0) depth_mm_3 : f32,
    @builtin(frag_depth) order_0 : f32,
};

struct pixelInput_0
{
    @location(0) depth_mm_4 : f32,
    @interpolate(flat) @location(1) range_mm_1 : vec2<f32>,
};

@fragment
fn fragment_main( _S3 : pixelInput_0, @builtin(front_facing) front_0 : bool, @invariant @builtin(position) clip_1 : vec4<f32>) -> DepthTexel_0
{
    var texel_0 : DepthTexel_0;
    texel_0.depth_mm_3 = _S3.depth_mm_4;
    if(OCCLUDERS_0 > i32(0))
    {
        var _S4 : f32;
        if(front_0)
        {
            _S4 = 1.0f;
        }
        else
        {
            _S4 = 0.0f;
        }
        texel_0.depth_mm_3 = skin_shadow_occluder_depth_0(_S3.depth_mm_4, _S4);
    }
    texel_0.order_0 = saturate(0.5f + 0.25f * (texel_0.depth_mm_3 - _S3.range_mm_1.x) / _S3.range_mm_1.y);
    return texel_0;
}

