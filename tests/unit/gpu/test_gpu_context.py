"""The resources of a skin, bound by name in a user's wgpu shader; wrong declarations are errors."""

from __future__ import annotations

import numpy as np
import pytest

import shading_tolerances as tol
from gpu_device import adapter_or_skip
from skinshade._core.errors import ArgumentError, ShaderError
from skinshade.gpu import SkinContext, wgsl_library
from skinshade.params import SkinParams
from skinshade.params.packing import layout
from skinshade.profile import Profile
from skinshade.shading.skin import Skin
from skinshade.shading.tables import BUILT_FOR

GLOBALS = """
@group(2) @binding(7) var<uniform> skin_block : SkinBlock;
@binding(1) @group(2) var<uniform> scatter_block : ScatterBlock;
@group(2) @binding(2) var sphere_lut : texture_2d<f32>;
@group(3) @binding(0) var lut_sampler : sampler;
@group(0) @binding(0) var<storage, read_write> results : array<f32>;
"""
MAIN = """
@compute @workgroup_size(1) fn main() {
    results[0] = skin_block.gloss;
    results[1] = scatter_block.sphere_axes.y;
    let light = skin_direct_scalar(sphere_lut, lut_sampler, scatter_block.sphere_axes,
        mat3x3<f32>(vec3<f32>(0.0, 0.0, 1.0), vec3<f32>(0.0, 0.0, 1.0), vec3<f32>(0.0, 0.0, 1.0)),
        vec3<f32>(0.6, 0.0, 0.8), 0.05, vec3<f32>(1.0));
    results[2] = light.x;
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


def test_resources_are_bound_at_the_group_and_binding_that_the_shader_declares(context):
    bindings = {name: (p.group, p.binding) for name, p in context.bind_points(GOOD).items()}
    assert bindings == {
        "skin_block": (2, 7),
        "scatter_block": (2, 1),
        "sphere_lut": (2, 2),
        "lut_sampler": (3, 0),
    }
    assert {entry["binding"] for entry in context.entries(GOOD, group=2)} == {7, 1, 2}


def run(context, code):
    """Return the four numbers that a compute shader writes."""
    import wgpu

    device, usage = context.device, wgpu.BufferUsage
    output = device.create_buffer(size=16, usage=usage.STORAGE | usage.COPY_SRC)
    module = device.create_shader_module(code=code)
    pipeline = device.create_compute_pipeline(
        layout="auto", compute={"module": module, "entry_point": "main"}
    )
    encoder = device.create_command_encoder()
    work = encoder.begin_compute_pass()
    work.set_pipeline(pipeline)
    own = [{"binding": 0, "resource": {"buffer": output}}]
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
    return np.frombuffer(device.queue.read_buffer(output), dtype=np.float32)


def test_a_users_kernel_reads_block_and_table(context, skin):
    results, sphere = run(context, GOOD), skin.lut("sphere")
    assert results[0] == np.float32(0.25)
    assert results[1] == np.float32(sphere.axes[1])
    expected = sphere.sample(0.8, 0.05)[0]
    assert results[2] == pytest.approx(expected, abs=tol.GPU_LOOKUP.value)


def test_a_table_that_the_skin_was_made_without_is_reported_by_name(context):
    bare = Skin.of(Profile.preset("skin-deon2007"), SkinParams(), luts=("ring",))
    with pytest.raises(ArgumentError, match="the skin has no table 'sphere'; make it with luts="):
        SkinContext(context.device, bare).entries(GOOD, group=2)


def test_the_next_draw_reads_the_parameters_that_were_written(context):
    context.write(SkinParams(gloss=0.75))
    assert run(context, GOOD)[0] == np.float32(0.75)
    context.write(SkinParams(gloss=0.25))
    assert run(context, GOOD)[0] == np.float32(0.25)


@pytest.mark.parametrize("name", BUILT_FOR)
def test_a_parameter_that_the_tables_depend_on_cannot_be_written(context, name):
    with pytest.raises(ArgumentError, match=f"{name} is 2.0, but the tables were built for"):
        context.write(SkinParams(**{name: 2.0}))
    assert run(context, GOOD)[0] == np.float32(0.25)


SKIN_FIELDS = layout()["SkinBlock"]["fields"]
FIELDS_IN_ORDER = sorted(SKIN_FIELDS, key=lambda name: SKIN_FIELDS[name]["offset"])


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
    "the struct of the other block": (
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
    "an additional field": (
        mutated(
            "    classic_deep_scatter_radius_mm : f32,",
            "    classic_deep_scatter_radius_mm : f32, extra : f32,",
        ),
        r"SkinBlock has a field extra that SkinBlock does not have",
    ),
    "a struct that is not defined": (
        mutated("skin_block : SkinBlock", "skin_block : SkinBlok"),
        r"skin_block: is SkinBlok, which the shader does not define; paste SkinBlock",
    ),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_a_wrong_declaration_is_reported_with_its_name_and_what_to_declare(context, fault):
    code, message = FAULTS[fault]
    with pytest.raises(ShaderError, match=message):
        context.bind_points(code)


@pytest.mark.parametrize("name", FIELDS_IN_ORDER)
def test_a_missing_field_of_a_block_is_reported(context, name):
    """The block of an older version can lack a field."""
    struct_start = GOOD.index("struct SkinBlock")
    struct_end = GOOD.index("};", struct_start)
    struct = GOOD[struct_start:struct_end]
    kept = [line for line in struct.splitlines() if not line.strip().startswith(f"{name} :")]
    assert len(kept) == len(struct.splitlines()) - 1
    with pytest.raises(ShaderError, match=f"has {name} : "):
        context.bind_points(GOOD.replace(struct, "\n".join(kept) + "\n"))


def test_a_shader_without_resources_of_skinshade_is_an_error_that_lists_their_names(context):
    with pytest.raises(ShaderError, match="declares none of skin_block, scatter_block, ring_lut"):
        context.bind_points("@group(0) @binding(0) var mine : sampler;")
    with pytest.raises(
        ShaderError, match=r"@group\(1\) declares no resource of skinshade; groups \[2, 3\] do"
    ):
        context.entries(GOOD, group=1)
