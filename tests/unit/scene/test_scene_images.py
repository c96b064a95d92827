import numpy as np
import OpenImageIO as oiio  # noqa: N813
import pytest

import shading_tolerances as tol
from skinshade._core.errors import ImageFileError, OutputError, SkinshadeError
from skinshade.scene.images import read_image, read_linear, write_exr, write_png
from skinshade.scene.maps import read_normal_map
from skinshade.shading.tonemap import linear_from_srgb


def store(file, pixels):
    """Write (H, W, C) of 8 or 16 bits or float32 without conversion, and return the file."""
    kind = {"uint8": "uint8", "uint16": "uint16", "float32": "float"}[str(pixels.dtype)]
    out = oiio.ImageOutput.create(str(file))
    spec = oiio.ImageSpec(*pixels.shape[1::-1], pixels.shape[2], kind)
    spec.attribute("oiio:UnassociatedAlpha", 1)
    assert out.open(str(file), spec)
    assert out.write_image(np.ascontiguousarray(pixels))
    out.close()
    return file


# -- reading ---------------------------------------------------------------------------------------


def test_every_byte_is_decoded_by_the_srgb_curve(tmp_path):
    byte = np.arange(256, dtype=np.uint8).reshape(16, 16, 1).repeat(3, axis=2)
    light = read_linear(store(tmp_path / "all.png", byte))
    assert np.abs(light - linear_from_srgb(byte / 255.0)).max() <= tol.FLOAT32.value
    known = {0: 0.0, 1: 1 / (255 * 12.92), 128: 0.2158605, 188: 0.5028865, 255: 1.0}
    flat = light[..., 0].ravel()
    for value, truth in known.items():
        assert flat[value] == pytest.approx(truth, abs=tol.SRGB_DIGITS.value)
    assert light.dtype == np.float32


def test_16_bits_are_kept(tmp_path):
    words = np.random.default_rng(1).integers(0, 65536, (8, 8, 3)).astype(np.uint16)
    file = store(tmp_path / "deep.png", words)
    assert np.abs(read_image(file) - words / 65535.0).max() <= tol.FLOAT32.value
    truth = linear_from_srgb(words / 65535.0)
    assert np.abs(read_linear(file) - truth).max() <= tol.FLOAT32.value


@pytest.mark.parametrize("suffix", [".exr", ".hdr"])
def test_hdr_and_exr_are_linear(tmp_path, suffix):
    light = np.tile(np.array([0.25, 0.5, 8.0], dtype=np.float32), (4, 6, 1))
    assert np.allclose(read_linear(store(tmp_path / f"sky{suffix}", light)), light, rtol=0.01)


def test_grey_becomes_three_channels_and_alpha_is_dropped(tmp_path):
    values = np.arange(32, dtype=np.uint8).reshape(4, 4, 2) * 8
    grey = read_image(store(tmp_path / "grey.png", values[..., :1]))
    with_alpha = read_image(store(tmp_path / "alpha.png", values))
    for image in (grey, with_alpha):
        assert np.allclose(image, values[..., :1].repeat(3, axis=2) / 255.0, atol=1e-6)
    rgba = np.random.default_rng(2).integers(0, 256, (4, 4, 4)).astype(np.uint8)
    rgba[..., 3] = 255
    image = read_image(store(tmp_path / "rgba.png", rgba))
    assert np.allclose(image, rgba[..., :3] / 255.0, atol=1e-6)
    assert read_image(store(tmp_path / "rgba.png", rgba), 4).shape == (4, 4, 4)
    with pytest.raises(ImageFileError, match=r"rgb.png: has 3 channels; 4 are needed"):
        read_image(store(tmp_path / "rgb.png", rgba[..., :3].copy()), 4)


@pytest.mark.parametrize("read", [read_image, read_linear, read_normal_map])
@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("none.png", None),
        ("empty.png", b""),
        ("noise.png", bytes(range(256))),
        ("noise.jpg", b"\xff\xd8\xff\xe0" + bytes(200)),
        ("noise.hdr", b"#?RADIANCE\nnothing"),
        ("noise.exr", b"\x76\x2f\x31\x01" + bytes(60)),
    ],
)
def test_a_file_that_is_no_image_is_an_error_that_names_it(tmp_path, read, name, content):
    if content is not None:
        (tmp_path / name).write_bytes(content)
    with pytest.raises(ImageFileError, match=name) as caught:
        read(tmp_path / name)
    assert isinstance(caught.value, SkinshadeError)


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_an_image_with_values_that_are_not_finite_is_an_error(tmp_path, value):
    pixels = np.zeros((4, 4, 3), dtype=np.float32)
    pixels[1, 2, 0] = value
    with pytest.raises(ImageFileError, match=r"bad\.exr: holds NaN or infinite"):
        read_linear(store(tmp_path / "bad.exr", pixels))


def test_a_truncated_image_is_an_error(tmp_path):
    noise = np.random.default_rng(4).integers(0, 256, (64, 64, 3)).astype(np.uint8)
    whole = store(tmp_path / "whole.png", noise).read_bytes()
    (tmp_path / "cut.png").write_bytes(whole[: len(whole) // 2])
    with pytest.raises(ImageFileError, match=r"cut\.png: corrupt"):
        read_image(tmp_path / "cut.png")


# -- writing ---------------------------------------------------------------------------------------


def test_images_are_read_as_they_were_written(tmp_path):
    rng = np.random.default_rng(5)
    linear = (rng.random((5, 7, 4)) * 3.0).astype(np.float32)
    display = rng.random((5, 7, 3))
    write_exr(tmp_path / "a.exr", linear)
    write_png(tmp_path / "a.png", display)
    assert np.array_equal(read_image(tmp_path / "a.exr", 4), linear)
    assert np.abs(read_image(tmp_path / "a.png") - display).max() <= 0.5 / 255.0 + 1e-6
    write_png(tmp_path / "b.png", np.array([[[-1.0, 0.5, 2.0]]]))
    assert np.allclose(read_image(tmp_path / "b.png") * 255.0, [[[0, 128, 255]]])
    eight_bits = np.array([[[0, 127, 255]]], dtype=np.uint8)
    write_png(tmp_path / "c.png", eight_bits)
    assert np.array_equal(np.rint(read_image(tmp_path / "c.png") * 255.0), eight_bits)


def test_a_folder_that_does_not_exist_is_an_error_that_names_the_file(tmp_path):
    image = np.zeros((2, 2, 4), dtype=np.float32)
    with pytest.raises(OutputError, match=r"a\.exr: the folder .*none does not exist"):
        write_exr(tmp_path / "none" / "a.exr", image)
    assert list(tmp_path.iterdir()) == []
