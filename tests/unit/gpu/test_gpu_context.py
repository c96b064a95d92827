"""Skin in somebody else's wgpu shader: found by name, refused by name."""

from __future__ import annotations

import numpy as np
import pytest

from gpu_device import adapter_or_skip
from skinshade._core.errors import ArgumentError, ShaderError
from skinshade.gpu import SkinContext, wgsl_library
from skinshade.params import SkinParams
from skinshade.params.packing import layout
from skinshade.profile import Profile
from skinshade.shading.skin import Skin

GLOBALS = """
@group(2) @binding(7) var<uniform> skin_block : SkinBlock;
@binding(1) @group(2) var<uniform> scatter_block : ScatterBlock;
@group(2) @binding(2) var sphere_lut : texture_2d<f32>;
@group(3) @binding(0) var lut_sampler : sampler;
@group(0) @binding(0) var<storage, read_write> found : array<f32>;
"""
MAIN = """
@compute @workgroup_size(1) fn main() {
    found[0] = skin_block.gloss;
    found[1] = scatter_block.sphere_axes.y;
    let light = skin_direct_scalar(sphere_lut, lut_sampler, scatter_block.sphere_axes,
        mat3x3<f32>(vec3<f32>(0.0, 0.0, 1.0), vec3<f32>(0.0, 0.0, 1.0), vec3<f32>(0.0, 0.0, 1.0)),
        vec3<f32>(0.6, 0.0, 0.8), 0.05, vec3<f32>(1.0));
    found[2] = light.x;
}
"""
GOOD = wgsl_library() + GLOBALS + MAIN


@pytest.fixture(scope="module")
def skin():
    return Skin.of(Profile.preset("skin-deon2007"), SkinParams(gloss=0.25))


@pytest.fixture(scope="module")
def context(skin):
    adapter_or_skip()
    from skinshade.gpu.device import open_device

    return SkinContext(open_device(), skin)


def test_resources_are_found_wherever_the_shader_wants_them(context):
    places = {name: (p.group, p.binding) for name, p in context.bind_points(GOOD).items()}
    assert places == {
        "skin_block": (2, 7),
        "scatter_block": (2, 1),
        "sphere_lut": (2, 2),
        "lut_sampler": (3, 0),
    }
    assert {entry["binding"] for entry in context.entries(GOOD, group=2)} == {7, 1, 2}


def run(context, code):
    import wgpu

    device, usage = context.device, wgpu.BufferUsage
    read = device.create_buffer(size=16, usage=usage.STORAGE | usage.COPY_SRC)
    module = device.create_shader_module(code=code)
    pipeline = device.create_compute_pipeline(
        layout="auto", compute={"module": module, "entry_point": "main"}
    )
    encoder = device.create_command_encoder()
    work = encoder.begin_compute_pass()
    work.set_pipeline(pipeline)
    own = [{"binding": 0, "resource": {"buffer": read}}]
    for group, entries in (
        (0, own),
        (1, []),
        (2, context.entries(code, group=2)),
        (3, context.entries(code, group=3)),
    ):
        described = pipeline.get_bind_group_layout(group)
        work.set_bind_group(group, device.create_bind_group(layout=described, entries=entries))
    work.dispatch_workgroups(1)
    work.end()
    device.queue.submit([encoder.finish()])
    return np.frombuffer(device.queue.read_buffer(read), dtype=np.float32)


def test_a_users_kernel_reads_block_and_table(context, skin):
    found = run(context, GOOD)
    assert found[0] == np.float32(0.25)
    assert found[1] == np.float32(skin.sphere.axes[1])
    assert found[2] == pytest.approx(skin.sphere.sample(0.8, 0.05)[0], abs=1e-4)


def test_what_is_written_is_what_the_next_draw_reads(context):
    context.write(SkinParams(gloss=0.75))
    assert run(context, GOOD)[0] == np.float32(0.75)
    context.write(SkinParams(gloss=0.25))


@pytest.mark.parametrize("name", ["scatter_scale", "shadow_filter_width_mm", "shadow_sharpening"])
def test_what_the_tables_were_made_for_cannot_change_under_them(context, name):
    with pytest.raises(ArgumentError, match=f"{name}: the tables were made for"):
        context.write(SkinParams(**{name: 2.0}))


SKIN_FIELDS = layout()["SkinBlock"]["fields"]


def mutated(old, new):
    assert GOOD.count(old) == 1, old
    return GOOD.replace(old, new)


FAULTS = {
    "a texture of another kind": (
        mutated("var sphere_lut : texture_2d<f32>", "var sphere_lut : texture_2d<u32>"),
        r"@group\(2\) @binding\(2\) sphere_lut: is texture_2d<u32>; declare it texture_2d<f32>",
    ),
    "a sampler that compares": (
        mutated("var lut_sampler : sampler;", "var lut_sampler : sampler_comparison;"),
        r"lut_sampler: is sampler_comparison; declare it sampler",
    ),
    "a block in storage": (
        mutated("var<uniform> skin_block", "var<storage, read> skin_block"),
        r"skin_block: is var<storage>; declare it var<uniform>",
    ),
    "blocks that changed places": (
        mutated("skin_block : SkinBlock", "skin_block : ScatterBlock"),
        r"skin_block: field 0 of ScatterBlock is albedo vec4<f32>; this version's SkinBlock has",
    ),
    "another type of a field": (
        mutated("    gloss : f32,", "    gloss : vec2<f32>,"),
        r"of SkinBlock is gloss vec2<f32>; this version's SkinBlock has gloss : f32",
    ),
    "another name of a field": (
        mutated("    gloss : f32,", "    smoothness : f32,"),
        r"of SkinBlock is smoothness f32; this version's SkinBlock has gloss : f32",
    ),
    "a field too many": (
        mutated(
            "    classic_deep_scatter_radius_mm : f32,",
            "    classic_deep_scatter_radius_mm : f32, extra : f32,",
        ),
        r"SkinBlock has a field extra",
    ),
    "a struct that is not there": (
        mutated("skin_block : SkinBlock", "skin_block : SkinBlok"),
        r"skin_block: is SkinBlok, which is no struct of the shader; paste SkinBlock",
    ),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_a_shader_that_declares_it_otherwise_is_told_what_and_where(context, fault):
    code, told = FAULTS[fault]
    with pytest.raises(ShaderError, match=told):
        context.bind_points(code)


@pytest.mark.parametrize("at", range(len(SKIN_FIELDS)))
def test_no_field_of_a_block_can_be_missing(context, at):
    """A block of an older version lacks one."""
    name = sorted(SKIN_FIELDS, key=lambda each: SKIN_FIELDS[each]["offset"])[at]
    struct_start = GOOD.index("struct SkinBlock")
    struct_end = GOOD.index("};", struct_start)
    struct = GOOD[struct_start:struct_end]
    kept = [line for line in struct.splitlines() if not line.strip().startswith(f"{name} :")]
    with pytest.raises(ShaderError, match=f"has {name} : "):
        context.bind_points(GOOD.replace(struct, "\n".join(kept) + "\n"))


def test_a_shader_without_anything_of_ours_is_told_the_names(context):
    with pytest.raises(ShaderError, match="declares none of skin_block, scatter_block, ring_lut"):
        context.bind_points("@group(0) @binding(0) var mine : sampler;")
    with pytest.raises(
        ShaderError, match=r"@group\(1\) has nothing of skinshade's; groups \[2, 3\]"
    ):
        context.entries(GOOD, group=1)
