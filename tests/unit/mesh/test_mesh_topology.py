import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import shapes
import tolerances as tol
from skinshade.mesh.topology import (
    Neighbours,
    corner_areas,
    face_areas,
    half_edges,
    open_edge_counts,
    weld,
)

GRID_POINTS = hnp.arrays(
    np.int64, st.tuples(st.integers(1, 30), st.just(3)), elements=st.integers(0, 2)
)
NO_FAULTS = {"open edges": 0, "non-manifold edges": 0, "edges of opposite winding": 0}


@given(GRID_POINTS, st.floats(0.1, 10.0))
def test_vertices_are_welded_when_and_only_when_their_positions_are_equal(lattice, unit):
    positions = lattice * unit
    group, first = weld(positions)
    equal_positions = (lattice[:, None] == lattice[None, :]).all(axis=-1)
    assert np.array_equal(group[:, None] == group[None, :], equal_positions)
    assert np.array_equal(positions[first][group], positions)
    assert sorted(set(group)) == list(range(first.size))


def test_unequal_positions_with_an_equal_sort_key_are_not_welded():
    # The sort key is x + √2 y + π z, which is √2 for both.
    positions = np.array([[np.sqrt(2.0), 0.0, 0.0], [0.0, 1.0, 0.0], [np.sqrt(2.0), 0.0, 0.0]])
    group, first = weld(positions)
    assert group[0] == group[2] != group[1]
    assert first.size == 2


def test_positive_and_negative_zero_are_equal_positions():
    assert weld(np.array([[0.0, 0.0, 0.0], [-0.0, 0.0, -0.0]]))[1].size == 1


def test_an_inner_edge_has_one_half_edge_in_each_direction():
    shape = shapes.sphere("icosphere", 2)
    start, end = half_edges(shape.faces)
    forward = set(zip(start.tolist(), end.tolist(), strict=True))
    assert len(forward) == 3 * len(shape.faces)
    assert forward == {(b, a) for a, b in forward}


def test_the_area_of_a_triangle_is_half_its_base_times_its_height():
    positions = np.array([[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [1.0, 0.0, 4.0]])
    assert face_areas(positions, np.array([[0, 1, 2]])) == pytest.approx(6.0)


@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
def test_corner_areas_sum_to_the_total_area(scale):
    shape = shapes.sphere("random", 1000)
    areas = corner_areas(shape.positions * scale, shape.faces, 1000)
    whole = face_areas(shape.positions * scale, shape.faces).sum()
    assert areas.sum() == pytest.approx(whole, rel=tol.ROUNDING_SUMS.value)
    assert whole == pytest.approx(4.0 * np.pi * scale**2, rel=0.02)


def test_a_closed_surface_has_no_faulty_edges():
    for shape in (shapes.sphere("icosphere", 2), shapes.torus("regular", 24)):
        assert open_edge_counts(shape.positions, shape.faces) == NO_FAULTS


def test_the_edges_of_a_hole_are_open():
    shape = shapes.sphere("icosphere", 2)
    counts = open_edge_counts(shape.positions, shape.faces[1:])
    assert counts == NO_FAULTS | {"open edges": 3}


def test_the_edges_at_both_ends_of_a_tube_are_open():
    tube = shapes.cylinder(1.0, 2.0, 12, 3)
    assert open_edge_counts(tube.positions, tube.faces) == NO_FAULTS | {"open edges": 24}


def test_an_edge_of_three_faces_is_non_manifold():
    shape = shapes.sphere("icosphere", 1)
    a, b = shape.faces[0, :2]
    positions = np.vstack([shape.positions, [5.0, 5.0, 5.0]])
    faces = np.vstack([shape.faces, [a, b, len(shape.positions)]])
    counts = open_edge_counts(positions, faces)
    assert counts == NO_FAULTS | {"open edges": 2, "non-manifold edges": 1}


def test_a_reversed_face_has_three_edges_of_opposite_winding():
    shape = shapes.sphere("icosphere", 2)
    faces = shape.faces.copy()
    faces[5] = faces[5, ::-1]
    counts = open_edge_counts(shape.positions, faces)
    assert counts == NO_FAULTS | {"edges of opposite winding": 3}


def test_a_seam_has_no_open_edges():
    positions, faces, _, _ = shapes.split_seam(shapes.sphere("icosphere", 3))
    assert len(positions) > len(shapes.sphere("icosphere", 3).positions)
    assert open_edge_counts(positions, faces) == NO_FAULTS


def expected_sums(faces, count, values):
    """Return the sums of `Neighbours` in a loop: half a difference for either end of every side."""
    result = np.zeros(count)
    for face in faces:
        for a, b in ((0, 1), (1, 2), (2, 0)):
            i, j = face[a], face[b]
            result[i] += 0.5 * (values[j] - values[i])
            result[j] += 0.5 * (values[i] - values[j])
    return result


@given(st.data())
def test_sums_over_neighbours_count_both_ends_of_every_side(data):
    """Faces can be open, reversed, repeated or non-manifold, and vertices unreferenced."""
    count = data.draw(st.integers(4, 9))
    corner = st.integers(0, count - 1)
    triangle = st.tuples(corner, corner, corner).filter(lambda t: len(set(t)) == 3)
    faces = np.array(data.draw(st.lists(triangle, min_size=1, max_size=12)))
    values = np.random.default_rng(count).normal(size=count)
    neighbours = Neighbours.of(faces, count)
    sums = neighbours.sums(neighbours.differences(values))
    assert np.allclose(sums, expected_sums(faces, count, values), atol=1e-12)


def test_shares_are_stored_only_for_open_surfaces():
    ball = shapes.sphere("icosphere", 3)
    neighbours = Neighbours.of(ball.faces, len(ball.positions))
    assert neighbours.shares is None
    assert neighbours.ends.size == ball.faces.size
    cut = Neighbours.of(ball.faces[5:], len(ball.positions))
    assert cut.shares is not None
    assert set(np.unique(cut.shares)) == {0.5, 1.0}
