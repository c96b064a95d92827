"""The layout of a vertex: widths, offsets, and the attributes that fill it."""

from itertools import pairwise

import numpy as np
import pytest

import shapes
from skinshade._core.generated import generated_text
from skinshade.mesh import Mesh, vertex_attributes
from skinshade.params.vertex import VERTEX_COLUMNS, VERTEX_VECTORS, VertexColumn, column_slices


@pytest.mark.parametrize(
    ("kind", "width"),
    [("float", 1), ("float2", 2), ("float3", 3), ("float4", 4), ("symmetric", 6), ("float3x3", 9)],
)
def test_a_kind_has_its_number_of_floats(kind, width):
    assert VertexColumn(kind, "1", "A column.").width == width


@pytest.mark.parametrize("name", VERTEX_COLUMNS)
def test_a_column_has_unit_and_description(name):
    column = VERTEX_COLUMNS[name]
    assert column.unit in ("1", "mm", "1/mm")
    assert column.about.endswith(".")


def test_slices_follow_each_other_without_gaps():
    slices = column_slices()
    assert list(slices) == list(VERTEX_COLUMNS)
    assert next(iter(slices.values())).start == 0
    assert all(before.stop == after.start for before, after in pairwise(slices.values()))
    widths = {name: floats.stop - floats.start for name, floats in slices.items()}
    assert widths == {name: column.width for name, column in VERTEX_COLUMNS.items()}


def test_the_vectors_hold_all_columns_with_less_than_one_vector_to_spare():
    floats = max(part.stop for part in column_slices().values())
    assert 0 <= 4 * VERTEX_VECTORS - floats < 4


def test_the_shader_declares_the_vectors():
    text = generated_text("passes.slang")
    assert f"float4 v{VERTEX_VECTORS - 1} : ATTRIBUTE{VERTEX_VECTORS - 1};" in text
    assert f"ATTRIBUTE{VERTEX_VECTORS};" not in text


def test_vertex_attributes_of_a_mesh_have_the_widths_of_their_columns(deon):
    ball = shapes.sphere("icosphere", 1, 10.0)
    attributes = vertex_attributes(Mesh.checked(ball.positions, ball.faces, unit_mm=1.0), deon)
    assert set(attributes) <= set(VERTEX_COLUMNS)
    for name, values in attributes.items():
        assert values.shape == (len(ball.positions), VERTEX_COLUMNS[name].width), name
        assert np.isfinite(values).all()
