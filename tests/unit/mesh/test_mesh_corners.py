"""Triangles of polygons, and vertices from corners."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from skinshade.mesh import corners
from skinshade.mesh.corners import fan_triangles, first_of_equal_rows, merged_corners

SMALL = st.integers(0, 3)


@given(st.lists(st.integers(1, 7), min_size=1, max_size=20))
def test_a_fan_has_two_triangles_fewer_than_corners(sizes):
    triangles = fan_triangles(np.array(sizes))
    start, expected = 0, []
    for size in sizes:
        last = start + size - 1
        fan = [(start, min(start + i + 1, last), min(start + i + 2, last)) for i in range(size - 2)]
        expected += fan or [(start, min(start + 1, last), last)]
        start += size
    assert triangles.tolist() == [list(triangle) for triangle in expected]


@given(st.lists(st.tuples(SMALL, SMALL, SMALL), min_size=1, max_size=40))
def test_corners_are_merged_if_they_are_equal_in_all_columns(rows):
    table = np.array(rows)
    kept, vertex = merged_corners(list(table.T))
    np.testing.assert_array_equal(table[kept][vertex], table)
    assert len(kept) == len(set(rows))
    assert all(rows.index(rows[corner]) == corner for corner in kept)
    assert kept.tolist() == sorted(kept, key=lambda corner: (rows[corner][0], corner))


@pytest.mark.parametrize("odd", [corners.ODD, np.uint64(0)], ids=["mixed", "all collide"])
@given(st.lists(st.tuples(SMALL, SMALL), min_size=1, max_size=30))
def test_the_first_of_equal_rows_is_exact_also_if_their_numbers_collide(odd, rows):
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(corners, "ODD", odd)
        first = first_of_equal_rows(np.array(rows) * 0.1)
    assert first.tolist() == [rows.index(row) for row in rows]


def test_negative_zero_equals_zero():
    assert first_of_equal_rows(np.array([[0.0], [-0.0], [1.0]])).tolist() == [0, 0, 2]
