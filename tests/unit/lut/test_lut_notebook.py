"""What notebooks and consoles show for a lookup table."""

import io

import numpy as np
import pytest
from PIL import Image

from skinshade._core.srgb import srgb_from_linear
from skinshade.lut import Axis, Lut, build_shadow_lut, build_transfer_lut, curvature_lut

AXIS = Axis("a", "1", 0.0, 1.0)
BUILDERS = {
    "curvature": lambda profile: curvature_lut(profile, size=(12, 5)),
    "shadow": lambda profile: build_shadow_lut(profile, size=(7, 9)),
    "transfer": lambda profile: build_transfer_lut(profile, size=(16, 2)),
}
EVERY_KIND = pytest.mark.parametrize("kind", BUILDERS)


def opened(table):
    with Image.open(io.BytesIO(table._repr_png_())) as image:
        image.load()
        return image


@EVERY_KIND
def test_the_repr_states_kind_size_and_range(kind, deon):
    table = BUILDERS[kind](deon)
    height, width, _ = table.values.shape
    text = repr(table)
    assert text.startswith(f"Lut({kind!r}, {width}×{height}, values ")
    low, high = (float(word) for word in text[:-1].split("values ")[1].split(" to "))
    assert (low, high) == pytest.approx(table.value_range, rel=5e-3)


@pytest.mark.parametrize("scale", [1e-38, 1.0, 3e38])
def test_the_repr_has_at_most_200_characters(scale):
    values = np.linspace(-scale, scale, 12, dtype=np.float32).reshape(2, 2, 3)
    provenance = {"profile": "p" * 1000}
    text = repr(Lut(values, "shadow", AXIS, AXIS, provenance))
    assert len(text) <= 200
    assert "\n" not in text


@EVERY_KIND
def test_the_png_has_the_size_of_the_table(kind, deon):
    table = BUILDERS[kind](deon)
    height, width, _ = table.values.shape
    image = opened(table)
    assert image.format == "PNG"
    assert image.size == (width, height)


@EVERY_KIND
def test_the_png_shows_the_values_in_srgb(kind, deon):
    table = BUILDERS[kind](deon)
    display = srgb_from_linear(table.values.astype(np.float64))
    assert np.array_equal(np.asarray(opened(table)), np.rint(display * 255.0))


def test_values_outside_0_to_1_are_black_and_white():
    values = np.array([[[-5.0, 0.0, 1.0], [2.0, 1e9, -1e9]]] * 2, dtype=np.float32)
    pixels = np.asarray(opened(Lut(values, "curvature", AXIS, AXIS)))
    assert pixels[0].tolist() == [[0, 0, 255], [255, 255, 0]]
