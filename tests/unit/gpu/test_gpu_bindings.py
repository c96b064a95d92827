"""Bind points and override constants are read by name from the text of a WGSL program."""

from __future__ import annotations

import pytest

from codegen.compiler import PASSES
from skinshade._core.errors import ArgumentError
from skinshade._core.generated import generated_text
from skinshade.gpu.bindings import BindPoint, bind_points, override_ids

PROGRAM = """
@group(1) @binding(3) var<uniform> block : Block;
@binding(7) @group(0) var lut_0 : texture_2d<f32>;
@group(0) @binding(8) var<storage, read> rows : array<vec4<f32>>;
@group(0) @binding(9) var<storage, read_write> results : array<f32>;
@id(2) override TAPS_0 : i32 = i32(8);
@id(0) override plain : f32;
"""
PASS_NAMES = sorted(path.stem for path in PASSES.glob("*_pass.slang"))


def test_bind_points_are_read_whichever_attribute_comes_first():
    assert bind_points(PROGRAM) == {
        "block": BindPoint(1, 3, "Block", "uniform"),
        "lut": BindPoint(0, 7, "texture_2d<f32>"),
        "rows": BindPoint(0, 8, "array<vec4<f32>>", "storage"),
        "results": BindPoint(0, 9, "array<f32>", "storage, read_write"),
    }


def test_override_constants_are_read_by_name():
    assert override_ids(PROGRAM) == {"TAPS": "2", "plain": "0"}


def test_a_program_without_bind_points_is_an_error():
    with pytest.raises(ArgumentError, match="the program has no @group"):
        bind_points("fn main() {}")


def test_the_renderer_has_four_passes():
    assert PASS_NAMES == ["blur_pass", "present_pass", "shadow_pass", "skin_pass"]


@pytest.mark.parametrize("name", PASS_NAMES)
def test_no_two_globals_of_a_pass_share_a_binding(name):
    text = generated_text(f"{name}.wgsl")
    points = bind_points(text)
    bindings = {(point.group, point.binding) for point in points.values()}
    assert len(bindings) == len(points) == text.count("@binding(")


def test_the_globals_of_the_skin_pass_have_the_names_of_its_source():
    text = generated_text("skin_pass.wgsl")
    assert {"skin_block", "scatter_block", "albedo_map", "depths"} <= set(bind_points(text))
