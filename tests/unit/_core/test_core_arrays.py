import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import tolerances as tol
from skinshade._core.arrays import (
    LARGEST_POSITION,
    as_faces,
    as_floats,
    as_positions,
    as_rgb,
    as_triple,
    bounding_sphere,
    dot,
    unit_vectors,
)
from skinshade._core.errors import ArgumentError

FINITE = st.floats(-1e100, 1e100)


@given(hnp.arrays(np.float64, hnp.array_shapes(max_dims=3), elements=FINITE))
def test_finite_floats_pass_unchanged(array):
    assert np.array_equal(as_floats("x", array.tolist()), array)


@given(
    hnp.arrays(np.float64, hnp.array_shapes(max_dims=3), elements=FINITE),
    st.sampled_from([np.nan, np.inf, -np.inf]),
    st.data(),
)
def test_the_first_value_that_is_not_finite_is_named(array, bad, data):
    index = tuple(data.draw(st.integers(0, n - 1)) for n in array.shape)
    array[index] = bad
    with pytest.raises(ArgumentError) as caught:
        as_floats("speed", array)
    assert f"speed[{', '.join(map(str, index))}] is {bad}" in str(caught.value)


@pytest.mark.parametrize(
    ("value", "passes"), [(0.0, True), (1.0, True), (-1e-9, False), (1.1, False)]
)
def test_the_range_is_closed(value, passes):
    if passes:
        assert as_floats("x", value, low=0.0, high=1.0) == value
    else:
        with pytest.raises(ArgumentError, match=r"x is .*must lie in \[0, 1\]"):
            as_floats("x", value, low=0.0, high=1.0)


@pytest.mark.parametrize("shape", [(3,), (2, 4), (2, 3, 1), ()])
def test_another_shape_is_refused_and_named(shape):
    with pytest.raises(ArgumentError) as caught:
        as_floats("points", np.zeros(shape), (None, 3))
    assert f"points: shape is {shape}; it must be (any, 3)" in str(caught.value)


def test_an_axis_of_none_accepts_any_length():
    assert as_floats("points", np.zeros((5, 3)), (None, 3)).shape == (5, 3)
    assert as_floats("points", np.zeros((0, 3)), (None, 3)).shape == (0, 3)


@pytest.mark.parametrize("value", ["red", [[1, 2], [3]], [object()], {"a": 1}])
def test_a_value_that_is_no_array_of_numbers_is_refused_by_name(value):
    with pytest.raises(ArgumentError, match="colour: not an array of numbers"):
        as_floats("colour", value)


@pytest.mark.parametrize("value", [1.0 + 2.0j, np.array([1.0 + 2.0j])])
def test_complex_numbers_are_refused(value):
    with pytest.raises(ArgumentError, match="wave"):
        as_floats("wave", value)


def test_one_number_becomes_three_channels():
    assert as_rgb("albedo", 0.5).tolist() == [0.5, 0.5, 0.5]
    assert as_rgb("albedo", (0.1, 0.2, 0.3)).tolist() == [0.1, 0.2, 0.3]


def test_three_channels_are_a_copy():
    channels = np.array([0.1, 0.2, 0.3])
    as_rgb("albedo", channels)[0] = 9.0
    assert channels[0] == 0.1


@pytest.mark.parametrize("value", [(1.0, 2.0), np.zeros((3, 1)), []])
def test_other_counts_of_channels_are_refused(value):
    with pytest.raises(ArgumentError, match="one number or three"):
        as_rgb("albedo", value)


@pytest.mark.parametrize(
    ("faces", "position", "value"),
    [([[0, 1, 4]], "[0, 2]", 4), ([[0, 1, 2], [0, -1, 2]], "[1, 1]", -1)],
)
def test_an_index_out_of_range_is_named_with_its_position(faces, position, value):
    with pytest.raises(ArgumentError) as caught:
        as_faces("faces", np.array(faces), 4)
    assert f"faces{position} is {value}" in str(caught.value)
    assert "4 vertices" in str(caught.value)


@pytest.mark.parametrize("kind", [np.int32, np.uint8, np.uint64, np.int64])
def test_faces_of_any_integer_type_become_int64(kind):
    faces = as_faces("faces", np.array([[0, 1, 3]], dtype=kind), 4)
    assert faces.dtype == np.int64
    assert faces.tolist() == [[0, 1, 3]]


@pytest.mark.parametrize("faces", [[[0.0, 1.0, 2.0]], [[True, False, True]], [["a", "b", "c"]]])
def test_faces_of_another_type_are_refused(faces):
    with pytest.raises(ArgumentError, match="must be an integer type"):
        as_faces("faces", faces, 4)


@pytest.mark.parametrize("faces", [[0, 1, 2], [[0, 1, 2, 3]], []])
def test_faces_of_another_shape_are_refused(faces):
    with pytest.raises(ArgumentError, match=r"must be \(any, 3\)"):
        as_faces("faces", faces, 4)


def test_ragged_faces_are_refused_by_name():
    with pytest.raises(ArgumentError, match="faces"):
        as_faces("faces", [[0, 1, 2], [0, 1]], 4)


@given(hnp.arrays(np.float64, (6, 3), elements=st.floats(-1e3, 1e3).map(lambda x: round(x, 3))))
def test_unit_vectors_have_length_one_and_keep_their_direction(vectors):
    unit = unit_vectors(vectors)
    length = np.linalg.norm(vectors, axis=1)
    zero = length == 0.0
    assert np.allclose(np.linalg.norm(unit[~zero], axis=1), 1.0, rtol=tol.ROUNDING.value)
    assert np.allclose(unit * length[:, None], vectors, rtol=0, atol=1e3 * tol.ROUNDING.value)
    assert (unit[zero] == 0.0).all()


@pytest.mark.parametrize("length", [1e-100, 1e-9, 1.0, 1e100])
def test_a_vector_of_any_length_becomes_one_of_length_one(length):
    unit = unit_vectors(np.array([[0.0, 0.6, -0.8]]) * length)
    assert np.allclose(unit, [[0.0, 0.6, -0.8]], rtol=tol.ROUNDING.value)


@given(*[hnp.arrays(np.float64, (4, 3), elements=st.floats(-10, 10)) for _ in range(2)])
def test_dot_is_the_sum_of_products(a, b):
    assert np.allclose(dot(a, b), (a * b).sum(axis=-1), rtol=0, atol=300 * tol.ROUNDING.value)


def test_a_triple_holds_the_numbers_of_the_array():
    assert as_triple(np.array([0.1, -2.0, 3e9])) == (0.1, -2.0, 3e9)
    assert all(type(value) is float for value in as_triple(np.arange(3.0)))


@given(
    hnp.arrays(np.float64, st.tuples(st.integers(1, 9), st.just(3)), elements=st.floats(-1e3, 1e3))
)
def test_a_bounding_sphere_touches_the_farthest_point(points):
    middle, radius = bounding_sphere(points)
    distance = np.linalg.norm(points - middle, axis=1)
    assert distance.max() == pytest.approx(radius, rel=tol.ROUNDING.value)
    assert np.array_equal(middle, 0.5 * (points.min(axis=0) + points.max(axis=0)))


@pytest.mark.parametrize("value", [LARGEST_POSITION, -LARGEST_POSITION])
def test_positions_are_accepted_to_the_greatest_coordinate(value):
    assert as_positions("points", [[0.0, value, 0.0]]).tolist() == [[0.0, value, 0.0]]
    with pytest.raises(ArgumentError, match=r"points\[0, 1\] is .*1e\+15"):
        as_positions("points", [[0.0, 1.001 * value, 0.0]])


def test_a_scalar_product_beyond_the_range_is_infinite_without_a_warning():
    vector = np.array([[1e200, 1.0, 1.0], [np.inf, 1.0, 0.0], [3.0, 4.0, 0.0]])
    assert dot(vector, vector).tolist() == [np.inf, np.inf, 25.0]
