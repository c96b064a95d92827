"""Image files: pixels and descriptions that are written are read back."""

from __future__ import annotations

from itertools import count

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from PIL import Image

import tolerances as tol
from skinshade._core.errors import ImageFileError
from skinshade._core.pixels import read_pixels, write_pixels

NUMBER = count()


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("pixels")


def images(kind, channels, **elements):
    sides = st.integers(1, 9)
    shapes = st.tuples(sides, sides, st.sampled_from(channels))
    return shapes.flatmap(lambda shape: hnp.arrays(kind, shape, elements=elements or None))


def written_and_read(path, pixels, description=""):
    write_pixels(path, pixels, description)
    return read_pixels(path, ImageFileError)


def new_path(folder, suffix):
    return folder / f"{next(NUMBER)}{suffix}"


def sample(height=6, width=5, channels=3, kind=np.uint8):
    steps = np.random.default_rng(7).integers(0, 256, (height, width, channels))
    return (steps / np.float32(255.0)).astype(kind) if kind is np.float32 else steps.astype(kind)


# -- written and read back -------------------------------------------------------------------------


@given(images(np.float32, (1, 2, 3, 4, 5)))
@example(np.array([[[1e-45, -0.0, 3.4e38]]], dtype=np.float32))
@example(np.array([[[np.nan, np.inf, -np.inf]]], dtype=np.float32))
def test_exr_keeps_every_bit_of_every_float(folder, pixels):
    read, _ = written_and_read(new_path(folder, ".exr"), pixels)
    assert read.dtype == np.float32
    assert read.flags.c_contiguous
    assert np.array_equal(read, pixels, equal_nan=True)
    assert np.array_equal(np.signbit(read), np.signbit(pixels))


@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
@given(data=st.data())
def test_png_keeps_every_step_of_grey_and_rgb_images(folder, kind, data):
    pixels = data.draw(images(kind, (1, 3)))
    read, _ = written_and_read(new_path(folder, ".png"), pixels)
    scaled = read * np.float64(np.iinfo(kind).max)
    assert read.shape == pixels.shape
    assert np.array_equal(np.rint(scaled), pixels)
    assert np.abs(read - pixels / np.iinfo(kind).max).max() <= tol.FLOAT32.value


@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
@given(data=st.data())
@example(data=None)
def test_colours_are_not_multiplied_by_alpha(folder, kind, data):
    """The fourth channel of a map is an independent value."""
    clear = np.array([[[200, 100, 50, 0], [200, 100, 50, 128]]], dtype=kind)
    pixels = clear if data is None else data.draw(images(kind, (2, 4)))
    read, _ = written_and_read(new_path(folder, ".png"), pixels)
    assert np.array_equal(np.rint(read * np.float64(np.iinfo(kind).max)), pixels)


@pytest.mark.parametrize("mode", ["LA", "RGBA"])
def test_a_png_of_another_program_keeps_the_stored_colours(tmp_path, mode):
    stored = sample(channels=len(mode))
    Image.fromarray(stored, mode=None).save(tmp_path / "map.png")
    read, _ = read_pixels(tmp_path / "map.png", ImageFileError)
    assert np.array_equal(np.rint(read * 255.0), stored)


@given(images(np.float32, (3,), min_value=0.0, max_value=1.0))
def test_floats_rounded_to_16_bits_are_read_within_half_a_step(folder, pixels):
    steps = np.rint(pixels.astype(np.float64) * 65535.0).astype(np.uint16)
    read, _ = written_and_read(new_path(folder, ".png"), steps)
    half = (tol.PNG_HALF_STEP.value / 65535.0) + tol.FLOAT32.value
    assert np.abs(read - pixels).max() <= half


def test_the_file_has_the_type_of_the_array(tmp_path):
    for kind in (np.uint8, np.uint16):
        write_pixels(tmp_path / "a.png", sample(kind=kind))
        depth = (tmp_path / "a.png").read_bytes()[24]
        assert depth == np.dtype(kind).itemsize * 8
    write_pixels(tmp_path / "a.exr", sample(kind=np.float32))
    data = (tmp_path / "a.exr").read_bytes()
    assert all(bytes([name]) + b"\x00\x02\x00\x00\x00" in data for name in b"RGB")  # FLOAT: 2


def test_rows_go_down_and_columns_go_right(tmp_path):
    pixels = np.zeros((2, 3, 3), dtype=np.uint8)
    pixels[0, 2] = 10, 20, 30
    write_pixels(tmp_path / "a.png", pixels)
    with Image.open(tmp_path / "a.png") as image:
        assert image.size == (3, 2)
        assert image.getpixel((2, 0)) == (10, 20, 30)


def test_an_array_view_with_strides_is_written_correctly(tmp_path):
    pixels = sample(8, 8)
    read, _ = written_and_read(tmp_path / "a.png", pixels[::2, ::-1])
    assert np.array_equal(np.rint(read * 255.0), pixels[::2, ::-1])


def test_palette_and_one_bit_images_are_read_as_their_colours(tmp_path):
    Image.fromarray(sample()).quantize(8).save(tmp_path / "palette.png")
    with Image.open(tmp_path / "palette.png") as image:
        rgb = np.asarray(image.convert("RGB"))
    read, _ = read_pixels(tmp_path / "palette.png", ImageFileError)
    assert np.array_equal(np.rint(read * 255.0), rgb)
    Image.fromarray(np.eye(4, dtype=bool)).save(tmp_path / "bits.png")
    assert np.array_equal(read_pixels(tmp_path / "bits.png", ImageFileError)[0][..., 0], np.eye(4))


def test_hdr_images_keep_eight_bits_of_the_brightest_channel(tmp_path):
    pixels = np.exp2(8.0 * sample(kind=np.float32))
    read, _ = written_and_read(tmp_path / "sky.hdr", pixels)
    step = np.exp2(np.floor(np.log2(pixels.max(axis=-1, keepdims=True))) - 7.0)
    assert (np.abs(read - pixels) <= step).all()


# -- the description -------------------------------------------------------------------------------

TEXTS = st.text(st.characters(codec="utf-8", exclude_categories=("Cc", "Cs")), max_size=200)


@pytest.mark.parametrize("suffix", [".exr", ".png"])
@given(text=TEXTS)
def test_descriptions_in_every_script_are_read_back(folder, suffix, text):
    kind = np.float32 if suffix == ".exr" else np.uint16
    assert written_and_read(new_path(folder, suffix), sample(kind=kind), text)[1] == text


def test_a_description_of_a_megabyte_is_read_back_complete(tmp_path):
    text = '{"a": "b"}' * 100_000
    assert written_and_read(tmp_path / "a.exr", sample(kind=np.float32), text)[1] == text
    assert written_and_read(tmp_path / "a.png", sample(), text)[1] == text


def test_only_pixels_py_imports_the_image_library(repository):
    sources = sorted((repository / "src").rglob("*.py"))
    importers = [p.name for p in sources if "OpenImageIO as" in p.read_text(encoding="utf-8")]
    assert importers == ["pixels.py"]
