import numpy as np
import OpenImageIO as oiio  # noqa: N813
import pytest

import shading_tolerances as tol
from skinshade._core.errors import ArgumentError, ImageFileError, OutputError, SkinshadeError
from skinshade.scene import Material
from skinshade.scene.images import read_image, read_linear, write_exr, write_png
from skinshade.scene.maps import read_normal_map
from skinshade.shading.tonemap import linear_from_srgb


def store(file, pixels):
    """Write (H, W, C) of 8 or 16 bits or float32 as it is."""
    kind = {"uint8": "uint8", "uint16": "uint16", "float32": "float"}[str(pixels.dtype)]
    out = oiio.ImageOutput.create(str(file))
    spec = oiio.ImageSpec(*pixels.shape[1::-1], pixels.shape[2], kind)
    spec.attribute("oiio:UnassociatedAlpha", 1)
    assert out.open(str(file), spec)
    assert out.write_image(np.ascontiguousarray(pixels))
    out.close()
    return file


def encoded(normals, top):
    return np.rint((0.5 + 0.5 * np.asarray(normals)) * top)


def test_every_byte_of_srgb_becomes_its_light(tmp_path):
    byte = np.arange(256, dtype=np.uint8).reshape(16, 16, 1).repeat(3, axis=2)
    found = read_linear(store(tmp_path / "all.png", byte))
    assert np.abs(found - linear_from_srgb(byte / 255.0)).max() <= tol.FLOAT32.value
    known = {0: 0.0, 1: 1 / (255 * 12.92), 128: 0.2158605, 188: 0.5028865, 255: 1.0}
    flat = found[..., 0].ravel()
    for value, light in known.items():
        assert flat[value] == pytest.approx(light, abs=tol.SRGB_DIGITS.value)
    assert found.dtype == np.float32


def test_16_bits_are_kept(tmp_path):
    words = np.random.default_rng(1).integers(0, 65536, (8, 8, 3)).astype(np.uint16)
    file = store(tmp_path / "deep.png", words)
    assert np.abs(read_image(file) - words / 65535.0).max() <= tol.FLOAT32.value
    truth = linear_from_srgb(words / 65535.0)
    assert np.abs(read_linear(file) - truth).max() <= tol.FLOAT32.value


@pytest.mark.parametrize("suffix", [".exr", ".hdr"])
def test_hdr_and_exr_are_light_already(tmp_path, suffix):
    light = np.tile(np.array([0.25, 0.5, 8.0], dtype=np.float32), (4, 6, 1))
    assert np.allclose(read_linear(store(tmp_path / f"sky{suffix}", light)), light, rtol=0.01)


def test_grey_becomes_three_channels_and_alpha_is_dropped(tmp_path):
    values = np.arange(32, dtype=np.uint8).reshape(4, 4, 2) * 8
    grey = read_image(store(tmp_path / "grey.png", values[..., :1]))
    both = read_image(store(tmp_path / "both.png", values))
    for found in (grey, both):
        assert np.allclose(found, values[..., :1].repeat(3, axis=2) / 255.0, atol=1e-6)
    rgba = np.random.default_rng(2).integers(0, 256, (4, 4, 4)).astype(np.uint8)
    rgba[..., 3] = 255
    found = read_image(store(tmp_path / "rgba.png", rgba))
    assert np.allclose(found, rgba[..., :3] / 255.0, atol=1e-6)
    assert read_image(store(tmp_path / "rgba.png", rgba), 4).shape == (4, 4, 4)
    with pytest.raises(ImageFileError, match=r"rgb.png: has 3 channels; 4 are needed"):
        read_image(store(tmp_path / "rgb.png", rgba[..., :3].copy()), 4)


@pytest.mark.parametrize(("kind", "top"), [(np.uint8, 255), (np.uint16, 65535)])
def test_a_normal_map_gives_unit_normals_with_y_up(tmp_path, kind, top):
    rng = np.random.default_rng(3)
    n = rng.normal(size=(8, 8, 3)) * 0.4 + (0.0, 0.0, 1.5)
    n /= np.linalg.norm(n, axis=-1, keepdims=True)
    found = read_normal_map(store(tmp_path / "n.png", encoded(n, top).astype(kind)))
    assert np.abs(found - n).max() <= 2.0 / top
    assert np.abs(np.linalg.norm(found, axis=-1) - 1.0).max() <= tol.FLOAT32.value


@pytest.mark.parametrize("normal", [(0.6, 0.0, -0.8), (0.0, 0.8, -0.6)])
def test_a_map_that_faces_inwards_is_refused(tmp_path, normal):
    file = store(tmp_path / "in.png", np.tile(encoded(normal, 255).astype(np.uint8), (4, 4, 1)))
    with pytest.raises(ImageFileError, match=r"in\.png: not a tangent-space normal map"):
        read_normal_map(file)


def test_a_map_of_two_channels_is_refused(tmp_path):
    file = store(tmp_path / "rg.png", np.full((4, 4, 3), (140, 120, 0), dtype=np.uint8))
    with pytest.raises(ImageFileError, match="three channels"):
        read_normal_map(file)


@pytest.mark.parametrize("read", [read_image, read_linear, read_normal_map])
@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("gone.png", None),
        ("empty.png", b""),
        ("noise.png", bytes(range(256))),
        ("noise.jpg", b"\xff\xd8\xff\xe0" + bytes(200)),
        ("noise.hdr", b"#?RADIANCE\nnothing"),
        ("noise.exr", b"\x76\x2f\x31\x01" + bytes(60)),
    ],
)
def test_a_file_that_is_no_picture_is_named(tmp_path, read, name, content):
    if content is not None:
        (tmp_path / name).write_bytes(content)
    with pytest.raises(ImageFileError, match=name) as caught:
        read(tmp_path / name)
    assert isinstance(caught.value, SkinshadeError)


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_a_picture_of_nan_is_refused(tmp_path, bad):
    pixels = np.zeros((4, 4, 3), dtype=np.float32)
    pixels[1, 2, 0] = bad
    with pytest.raises(ImageFileError, match=r"bad\.exr: holds NaN or infinite"):
        read_linear(store(tmp_path / "bad.exr", pixels))


def test_a_picture_cut_short_is_refused(tmp_path):
    noise = np.random.default_rng(4).integers(0, 256, (64, 64, 3)).astype(np.uint8)
    whole = store(tmp_path / "whole.png", noise).read_bytes()
    (tmp_path / "cut.png").write_bytes(whole[: len(whole) // 2])
    with pytest.raises(ImageFileError, match=r"cut\.png: corrupt"):
        read_image(tmp_path / "cut.png")


def test_pictures_come_back_as_they_were_written(tmp_path):
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


def test_a_place_that_cannot_be_written_is_named(tmp_path):
    picture = np.zeros((2, 2, 4), dtype=np.float32)
    with pytest.raises(OutputError, match=r"a\.exr: there is no folder"):
        write_exr(tmp_path / "gone" / "a.exr", picture)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("name", "shape"),
    [
        ("albedo", (4, 4)),
        ("albedo", (4, 4, 4)),
        ("albedo", (0, 4, 3)),
        ("normal", (4, 4, 2)),
        ("specular", (4, 4, 3)),
        ("deep_scatter", (4, 4, 1)),
    ],
)
def test_a_map_of_a_wrong_shape_is_refused_by_name(name, shape):
    with pytest.raises(ArgumentError, match=f"material {name}: shape is "):
        Material(**{name: np.ones(shape, dtype=np.float32)})


@pytest.mark.parametrize("name", ["albedo", "normal", "specular", "deep_scatter"])
def test_a_map_of_nan_is_refused_by_name(name):
    channels = 2 if name == "specular" else 3
    with pytest.raises(ArgumentError, match=f"material {name}: must be finite"):
        Material(**{name: np.full((2, 2, channels), np.nan, dtype=np.float32)})
