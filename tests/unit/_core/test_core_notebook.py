"""PNG, HTML and SVG that notebooks show for objects."""

import io
import xml.etree.ElementTree as ET

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from PIL import Image

from skinshade._core.notebook import PLOT_SIZE, curves_svg, png_bytes, table_html

TEXT = st.text(
    st.characters(codec="utf-8", exclude_categories=("Cc", "Cn", "Co", "Cs", "Zl", "Zp"))
)
MARKUP = "<script>alert('x') & \"y\"</script>"


def opened(png):
    with Image.open(io.BytesIO(png)) as image:
        image.load()
        return image


# -- PNG -------------------------------------------------------------------------------------------


@given(
    hnp.arrays(
        np.float64,
        st.tuples(st.integers(1, 9), st.integers(1, 9), st.just(3)),
        elements=st.floats(-1.0, 2.0),
    )
)
def test_a_png_has_the_size_and_the_rounded_values_of_the_image(display):
    image = opened(png_bytes(display))
    height, width, _ = display.shape
    assert image.format == "PNG"
    assert image.mode == "RGB"
    assert image.size == (width, height)
    assert np.array_equal(np.asarray(image), np.rint(np.clip(display, 0.0, 1.0) * 255.0))


# -- HTML ------------------------------------------------------------------------------------------


def cells(html):
    """Return the title and the cells of a table, with their markup undone."""
    page = ET.fromstring(html)
    rows = [[cell.text or "" for cell in row] for row in page.iter("tr")]
    return page.findtext("b") or "", rows


@given(TEXT, st.dictionaries(TEXT, TEXT, max_size=5))
def test_a_table_is_well_formed_and_holds_its_texts(title, rows):
    assert cells(table_html(title, rows)) == (title, [list(row) for row in rows.items()])


def test_markup_in_names_and_values_is_escaped():
    html = table_html(MARKUP, {MARKUP: MARKUP, "list": ["<b>"]})
    assert "<script" not in html
    assert cells(html) == (MARKUP, [[MARKUP, MARKUP], ["list", "['<b>']"]])


def test_values_of_any_type_are_written_as_their_text():
    rows = {"count": 3, "numbers": np.array([0.5, 2.0]), "nothing": None}
    assert cells(table_html("t", rows))[1] == [
        ["count", "3"],
        ["numbers", "[0.5 2. ]"],
        ["nothing", "None"],
    ]


# -- SVG -------------------------------------------------------------------------------------------


def polylines(svg):
    lines = [line.get("points") for line in ET.fromstring(svg).iter("polyline")]
    return [np.array([point.split(",") for point in line.split()], dtype=float) for line in lines]


def test_a_plot_has_a_curve_of_every_point_for_each_channel():
    x = np.linspace(2.0, 5.0, 40)
    channels = np.stack([x - 2.0, 0.5 * (x - 2.0), 0.0 * x], axis=1)
    curves = polylines(curves_svg(x, channels, "caption"))
    width, height = PLOT_SIZE
    assert len(curves) == 3
    step = 0.051  # coordinates have one decimal
    for channel, curve in enumerate(curves):
        assert np.abs(curve[:, 0] - (x - 2.0) / 3.0 * width).max() <= step
        assert np.abs(curve[:, 1] - height * (1.0 - channels[:, channel] / 3.0)).max() <= step


@given(hnp.arrays(np.float64, (7, 3), elements=st.floats(0.0, 1e9)))
def test_curves_stay_within_the_plot(channels):
    width, height = PLOT_SIZE
    for curve in polylines(curves_svg(np.linspace(0.0, 1.0, 7), channels, "")):
        assert ((curve >= 0.0) & (curve <= (width, height))).all()


def test_channels_of_zero_are_the_base_line():
    curves = polylines(curves_svg(np.linspace(0.0, 1.0, 3), np.zeros((3, 3)), "dark"))
    assert all((curve[:, 1] == PLOT_SIZE[1]).all() for curve in curves)


@pytest.mark.parametrize("caption", ["0 to 3 mm", MARKUP])
def test_the_caption_is_escaped_text(caption):
    svg = curves_svg(np.linspace(0.0, 1.0, 3), np.ones((3, 3)), caption)
    assert ET.fromstring(svg).findtext("text") == caption
    assert "<script" not in svg
