import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import tolerances as tol
from skinshade._core.errors import ArgumentError
from skinshade.lut import Axis, Lut

LINEAR = Axis("shadow_filter", "1", 0.0, 1.0)
ROOT = Axis("curvature", "1/mm", 0.01, 1.0, "sqrt")
SHAPES = st.tuples(st.integers(2, 7), st.integers(2, 7), st.just(3))
VALUES = SHAPES.flatmap(
    lambda shape: hnp.arrays(np.float32, shape, elements=st.floats(-2.0, 2.0, width=32))
)


@st.composite
def axes(draw):
    low = draw(st.floats(0.0, 10.0))
    high = draw(st.floats(0.0, 20.0))
    assume(high > low + 0.01)
    return Axis("a", "1/mm", low, high, draw(st.sampled_from(["linear", "sqrt"])))


@st.composite
def tables(draw):
    return Lut(draw(VALUES), "curvature", draw(axes()), draw(axes()), {})


@given(axes(), st.integers(1, 64))
def test_texel_centres_are_half_a_texel_from_the_edges(axis, count):
    assert np.allclose(
        axis.coordinate(axis.centres(count)),
        (np.arange(count) + 0.5) / count,
        rtol=0,
        atol=tol.ROUNDING_SUMS.value,
    )


@given(axes(), st.floats(0.0, 1.0))
def test_a_coordinate_is_inverted_by_the_spacing(axis, share):
    value = axis.low + share * (axis.high - axis.low)
    coordinate = axis.coordinate(np.array(value))
    if axis.spacing == "linear":
        recovered = axis.low + coordinate * (axis.high - axis.low)
    else:
        root = np.sqrt(axis.low) + coordinate * (np.sqrt(axis.high) - np.sqrt(axis.low))
        recovered = root**2
    assert recovered == pytest.approx(value, abs=tol.ROUNDING_SUMS.value)


@given(axes(), st.floats(0.0, 1e3))
def test_coordinates_are_clamped_to_the_table(axis, beyond):
    assert axis.coordinate(np.array(axis.high + beyond)) == pytest.approx(1.0, abs=1e-12)
    assert axis.coordinate(np.array(axis.low - beyond)) == 0.0


@given(tables())
def test_a_sample_at_a_texel_centre_is_the_texel(table):
    height, width, _ = table.values.shape
    column, row = np.meshgrid(table.columns.centres(width), table.rows.centres(height))
    assert np.allclose(table.sample(column, row), table.values, rtol=0, atol=tol.SAMPLE.value)


@given(tables())
def test_a_sample_between_four_texels_is_their_mean(table):
    height, width, _ = table.values.shape
    u, v = np.meshgrid(np.arange(1, width) / width, np.arange(1, height) / height)
    t = table.values.astype(float)
    mean = 0.25 * (t[1:, 1:] + t[:-1, 1:] + t[1:, :-1] + t[:-1, :-1])
    assert np.allclose(table.sample_at(u, v), mean, rtol=0, atol=tol.SAMPLE.value)


@given(tables(), st.floats(-100.0, 100.0), st.floats(-100.0, 100.0))
def test_samples_outside_the_table_are_those_of_its_edge(table, column, row):
    height, width, _ = table.values.shape
    x = table.columns.centres(width)
    y = table.rows.centres(height)
    inside = table.sample(np.clip(column, x[0], x[-1]), np.clip(row, y[0], y[-1]))
    assert np.allclose(table.sample(column, row), inside, rtol=0, atol=tol.SAMPLE.value)


@given(tables(), st.floats(-1.0, 21.0), st.floats(-1.0, 21.0))
def test_a_sample_lies_between_the_least_and_the_greatest_value(table, column, row):
    low, high = table.value_range
    value = table.sample(column, row)
    assert (value >= low - tol.FLOAT32.value).all()
    assert (value <= high + tol.FLOAT32.value).all()
    assert low == table.values.min()
    assert high == table.values.max()


@given(tables(), hnp.arrays(np.float64, (4, 3), elements=st.floats(0.0, 1.0)), st.floats(0.0, 1.0))
def test_channels_can_be_sampled_at_separate_columns(table, u, v):
    mixed = table.sample_channels(u, np.full(4, v))
    for channel in range(3):
        alone = table.sample_at(u[:, channel], np.full(4, v))[:, channel]
        assert np.allclose(mixed[:, channel], alone, rtol=0, atol=tol.ROUNDING.value)


@pytest.mark.parametrize("shape", [(), (4,), (2, 3)])
def test_channels_are_the_last_axis(shape):
    table = Lut(np.zeros((4, 5, 3), np.float32), "shadow", LINEAR, LINEAR)
    assert table.sample(np.zeros(shape), 0.5).shape == (*shape, 3)


@pytest.mark.parametrize("bad", [np.nan, np.inf, "dark"])
def test_coordinates_that_are_not_finite_are_refused(bad):
    table = Lut(np.zeros((4, 5, 3), np.float32), "shadow", LINEAR, LINEAR)
    with pytest.raises(ArgumentError, match="column"):
        table.sample(bad, 0.5)
    with pytest.raises(ArgumentError, match="row"):
        table.sample(0.5, bad)


@pytest.mark.parametrize("shape", [(4, 5), (4, 5, 4), (1, 5, 3), (4, 1, 3)])
def test_values_of_another_shape_are_refused(shape):
    with pytest.raises(ArgumentError, match="values: shape"):
        Lut(np.zeros(shape, np.float32), "shadow", LINEAR, LINEAR)


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_values_that_are_not_finite_are_refused(bad):
    values = np.zeros((4, 4, 3), np.float32)
    values[1, 2, 0] = bad
    with pytest.raises(ArgumentError, match="finite"):
        Lut(values, "shadow", LINEAR, LINEAR)


def test_an_unknown_kind_is_refused():
    with pytest.raises(ArgumentError, match="kind is 'specular'"):
        Lut(np.zeros((4, 4, 3), np.float32), "specular", LINEAR, LINEAR)


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        ((1.0, 1.0), "low must be less than high"),
        ((2.0, 1.0), "low must be less than high"),
        ((np.nan, 1.0), "low must be less than high"),
        ((0.0, np.inf), "low must be less than high"),
        ((0.0, 1.0, "cubic"), "spacing is 'cubic'"),
        ((-1.0, 1.0, "sqrt"), "low is -1.0; it must be 0 or more with spacing sqrt"),
    ],
)
def test_an_invalid_axis_is_refused(arguments, complaint):
    with pytest.raises(ArgumentError, match=complaint):
        Axis("a", "1", *arguments)


def test_the_description_holds_kind_axes_and_provenance():
    table = Lut(np.zeros((4, 4, 3), np.float32), "curvature", LINEAR, ROOT, {"profile": "skin1"})
    assert table.description() == {
        "kind": "curvature",
        "columns": {
            "name": "shadow_filter",
            "unit": "1",
            "low": 0.0,
            "high": 1.0,
            "spacing": "linear",
        },
        "rows": {"name": "curvature", "unit": "1/mm", "low": 0.01, "high": 1.0, "spacing": "sqrt"},
        "provenance": {"profile": "skin1"},
    }
