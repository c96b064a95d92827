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
def test_the_centres_stand_half_a_texel_from_the_edges(axis, count):
    assert np.allclose(
        axis.coordinate(axis.centres(count)),
        (np.arange(count) + 0.5) / count,
        rtol=0,
        atol=tol.ROUNDING_SUMS.value,
    )


@given(axes(), st.floats(0.0, 1.0))
def test_a_coordinate_leads_back_to_its_value(axis, share):
    value = axis.low + share * (axis.high - axis.low)
    at = axis.coordinate(np.array(value))
    if axis.spacing == "linear":
        back = axis.low + at * (axis.high - axis.low)
    else:
        root = np.sqrt(axis.low) + at * (np.sqrt(axis.high) - np.sqrt(axis.low))
        back = root**2
    assert back == pytest.approx(value, abs=tol.ROUNDING_SUMS.value)


@given(axes(), st.floats(0.0, 1e3))
def test_coordinates_are_clamped_to_the_table(axis, beyond):
    assert axis.coordinate(np.array(axis.high + beyond)) == pytest.approx(1.0, abs=1e-12)
    assert axis.coordinate(np.array(axis.low - beyond)) == 0.0


@given(tables())
def test_a_texels_centre_gives_the_texel(table):
    height, width, _ = table.values.shape
    column, row = np.meshgrid(table.columns.centres(width), table.rows.centres(height))
    assert np.allclose(table.sample(column, row), table.values, rtol=0, atol=tol.SAMPLE.value)


@given(tables())
def test_the_middle_of_four_texels_is_their_mean(table):
    height, width, _ = table.values.shape
    u, v = np.meshgrid(np.arange(1, width) / width, np.arange(1, height) / height)
    t = table.values.astype(float)
    mean = 0.25 * (t[1:, 1:] + t[:-1, 1:] + t[1:, :-1] + t[:-1, :-1])
    assert np.allclose(table.sample_at(u, v), mean, rtol=0, atol=tol.SAMPLE.value)


@given(tables(), st.floats(-100.0, 100.0), st.floats(-100.0, 100.0))
def test_beyond_the_edge_the_edge_goes_on(table, column, row):
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
def test_each_channel_may_look_in_a_column_of_its_own(table, u, v):
    mixed = table.sample_channels(u, np.full(4, v))
    for channel in range(3):
        alone = table.sample_at(u[:, channel], np.full(4, v))[:, channel]
        assert np.allclose(mixed[:, channel], alone, rtol=0, atol=tol.ROUNDING.value)


@pytest.mark.parametrize("shape", [(), (4,), (2, 3)])
def test_channels_are_a_last_axis(shape):
    table = Lut(np.zeros((4, 5, 3), np.float32), "shadow", LINEAR, LINEAR)
    assert table.sample(np.zeros(shape), 0.5).shape == (*shape, 3)


@pytest.mark.parametrize("bad", [np.nan, np.inf, "dark"])
def test_only_finite_places_can_be_looked_up(bad):
    table = Lut(np.zeros((4, 5, 3), np.float32), "shadow", LINEAR, LINEAR)
    with pytest.raises(ArgumentError, match="column"):
        table.sample(bad, 0.5)
    with pytest.raises(ArgumentError, match="row"):
        table.sample(0.5, bad)


@pytest.mark.parametrize("shape", [(4, 5), (4, 5, 4), (1, 5, 3), (4, 1, 3)])
def test_a_table_has_height_width_and_three_channels(shape):
    with pytest.raises(ArgumentError, match="values: shape"):
        Lut(np.zeros(shape, np.float32), "shadow", LINEAR, LINEAR)


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_a_table_is_finite(bad):
    values = np.zeros((4, 4, 3), np.float32)
    values[1, 2, 0] = bad
    with pytest.raises(ArgumentError, match="finite"):
        Lut(values, "shadow", LINEAR, LINEAR)


def test_a_table_is_of_a_known_kind():
    with pytest.raises(ArgumentError, match="kind is 'specular'"):
        Lut(np.zeros((4, 4, 3), np.float32), "specular", LINEAR, LINEAR)


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        ((1.0, 1.0), "does not rise"),
        ((2.0, 1.0), "does not rise"),
        ((np.nan, 1.0), "does not rise"),
        ((0.0, np.inf), "does not rise"),
        ((0.0, 1.0, "cubic"), "spacing is 'cubic'"),
        ((-1.0, 1.0, "sqrt"), "axis"),
    ],
)
def test_an_axis_that_cannot_be_is_refused(arguments, complaint):
    with pytest.raises(ArgumentError, match=complaint):
        Axis("a", "1", *arguments)


def test_the_description_is_all_but_the_values():
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
