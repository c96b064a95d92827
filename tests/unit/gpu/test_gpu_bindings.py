"""Bind points and constants by the names in a program's text."""

from __future__ import annotations

import pytest

from skinshade._core.errors import ArgumentError
from skinshade.codegen.build import PASSES
from skinshade.gpu.bindings import BindPoint, bind_points, override_ids
from skinshade.shaders import generated_text

PROGRAM = """
@group(1) @binding(3) var<uniform> block : Block;
@binding(7) @group(0) var lut_0 : texture_2d<f32>;
@group(0) @binding(8) var<storage, read> rows : array<vec4<f32>>;
@group(0) @binding(9) var<storage, read_write> found : array<f32>;
@id(2) override TAPS_0 : i32 = i32(8);
@id(0) override plain : f32;
"""


def test_every_global_is_found_whichever_attribute_comes_first():
    assert bind_points(PROGRAM) == {
        "block": BindPoint(1, 3, "Block", "uniform"),
        "lut": BindPoint(0, 7, "texture_2d<f32>"),
        "rows": BindPoint(0, 8, "array<vec4<f32>>", "storage"),
        "found": BindPoint(0, 9, "array<f32>", "storage, read_write"),
    }


def test_constants_are_known_by_name():
    assert override_ids(PROGRAM) == {"TAPS": "2", "plain": "0"}


def test_a_program_without_globals_is_an_error():
    with pytest.raises(ArgumentError, match="no @group"):
        bind_points("fn main() {}")


@pytest.mark.parametrize("name", PASSES)
def test_no_two_globals_of_a_pass_share_a_place(name):
    text = generated_text(f"{name}.wgsl")
    found = bind_points(text)
    places = [(point.group, point.binding) for point in found.values()]
    assert len(set(places)) == len(places) == text.count("@binding(")


def test_the_globals_of_the_skin_pass_have_the_names_of_its_source():
    text = generated_text("skin_pass.wgsl")
    assert {"skin_block", "scatter_block", "albedo_map", "depths"} <= set(bind_points(text))
