"""Files that are no images, and paths that cannot be written."""

from __future__ import annotations

import os
import struct
import subprocess
import sys
import zlib

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from skinshade._core.errors import ArgumentError, ImageFileError, LutFileError, OutputError
from skinshade._core.limits import Limits
from skinshade._core.pixels import read_pixels, write_pixels

SIDE, PIXELS, FREE = Limits().image_side, Limits().image_pixels, Limits().image_free_pixels
AS_ROOT = hasattr(os, "geteuid") and os.geteuid() == 0


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("faults")


def sample(height=6, width=5, kind=np.uint8):
    steps = np.random.default_rng(7).integers(0, 256, (height, width, 3))
    return (steps / np.float32(255.0)).astype(kind) if kind is np.float32 else steps.astype(kind)


# -- files that are no images ----------------------------------------------------------------------


def chunk(kind, data):
    body = kind + data
    return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))


def png_of_size(width, height, data=b""):
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    parts = [(b"IHDR", header), (b"IDAT", zlib.compress(data)), (b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(chunk(*part) for part in parts)


def hdr_of_size(width, height):
    return f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n".encode()


NOT_IMAGES = {
    "text.png": b"not an image",
    "text.exr": b"\x76\x2f\x31\x01 without the rest",
    "zeros.jpg": bytes(4096),
    "no-suffix": b"\x00\x01\x02",
    "no-pixels.png": png_of_size(0, 3),
    "no-data.png": png_of_size(4, 4),
    "half-a-row.png": png_of_size(4, 4, b"\x00" * 20),
    "no-data.hdr": hdr_of_size(4, 4),
    "huge.png": png_of_size(2**31 - 1, 2**31 - 1),
    "long.png": png_of_size(SIDE + 1, 1, bytes(3 * SIDE + 4)),
    "large.png": png_of_size(SIDE, SIDE),
    "large.hdr": hdr_of_size(SIDE, SIDE),
}


def error_message(path, kind=ImageFileError):
    with pytest.raises(kind) as caught:
        read_pixels(path, kind)
    message = str(caught.value)
    assert str(path) in message
    assert len(message.splitlines()) == 1, message
    return message


@pytest.mark.parametrize("name", NOT_IMAGES)
def test_a_file_that_is_no_image_is_named_in_a_message_of_one_line(tmp_path, name):
    (tmp_path / name).write_bytes(NOT_IMAGES[name])
    error_message(tmp_path / name)


def test_an_image_with_the_longest_allowed_side_is_read(tmp_path):
    rows = bytes(3 * SIDE + 1)
    (tmp_path / "long.png").write_bytes(png_of_size(SIDE, 1, rows))
    assert read_pixels(tmp_path / "long.png", ImageFileError)[0].shape == (1, SIDE, 3)


@pytest.mark.parametrize(
    ("width", "height", "limit", "needed"),
    [
        (SIDE + 1, 1, "image_side", SIDE + 1),
        (SIDE, PIXELS // SIDE + 1, "image_pixels", SIDE + PIXELS),
        (8192, 8192, "image_free_pixels", 8192**2 - 1024 * 65),
    ],
)
def test_an_implausible_size_is_an_error_that_states_it_and_the_limit(
    tmp_path, width, height, limit, needed
):
    (tmp_path / "big.png").write_bytes(png_of_size(width, height))
    assert (tmp_path / "big.png").stat().st_size == 65
    message = error_message(tmp_path / "big.png")
    assert f"claims {width}×{height} pixels" in message
    assert (
        f"the limit {limit} is {getattr(Limits(), limit)} (--limit {limit}={needed} or" in message
    )


@pytest.mark.skipif(sys.platform != "linux", reason="needs a limit on memory")
@pytest.mark.parametrize("name", ["large.png", "large.hdr", "huge.png"])
def test_a_header_of_implausible_size_allocates_no_memory(tmp_path, name):
    (tmp_path / name).write_bytes(NOT_IMAGES[name])
    program = (
        "import resource, sys; resource.setrlimit(resource.RLIMIT_AS, (2**32, 2**32))\n"
        "from skinshade._core.pixels import read_pixels\n"
        "try: read_pixels(sys.argv[1], ValueError)\n"
        "except ValueError as error: print('named', sys.argv[1] in str(error))"
    )
    command = [sys.executable, "-c", program, str(tmp_path / name)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.stdout.strip() == "named True", done.stderr


@pytest.mark.parametrize("suffix", [".png", ".exr", ".jpg", ".hdr", ".tif"])
@given(share=st.floats(0.0, 0.97))
def test_a_truncated_file_is_refused(folder, suffix, share):
    path = folder / f"cut{suffix}"
    kind = np.float32 if suffix in (".exr", ".hdr") else np.uint8
    write_pixels(path, sample(40, 50, kind=kind))
    data = path.read_bytes()
    path.write_bytes(data[: max(1, int(share * len(data)))])
    error_message(path)


@pytest.mark.parametrize("suffix", [".png", ".exr"])
@given(position=st.floats(0.0, 1.0, exclude_max=True), value=st.integers(0, 255))
def test_a_wrong_byte_raises_a_file_error_or_yields_a_valid_image(folder, suffix, position, value):
    path = folder / f"wrong{suffix}"
    kind = np.float32 if suffix == ".exr" else np.uint8
    write_pixels(path, sample(20, 20, kind=kind), "axes")
    data = bytearray(path.read_bytes())
    data[int(position * len(data))] = value
    path.write_bytes(data)
    try:
        pixels, text = read_pixels(path, ImageFileError)
    except ImageFileError as error:
        assert str(path) in str(error)
    else:
        assert pixels.dtype == np.float32
        assert pixels.ndim == 3
        assert isinstance(text, str)


@pytest.mark.parametrize("part", [b"axes", b"channels", b"chlist"])
def test_text_that_is_not_utf8_is_an_error_that_names_the_file(tmp_path, part):
    path = tmp_path / "a.exr"
    write_pixels(path, sample(kind=np.float32), "axes")
    data = path.read_bytes()
    assert part in data
    path.write_bytes(data.replace(part, b"\xff" * len(part)))
    error_message(path)


def test_a_description_that_is_no_text_is_refused_or_ignored(tmp_path):
    path = tmp_path / "a.exr"
    write_pixels(path, sample(kind=np.float32), "axes")
    data = path.read_bytes()
    assert data.count(b"comments\x00string\x00") == 1
    path.write_bytes(data.replace(b"comments\x00string\x00", b"comments\x00custom\x00"))
    try:
        _, text = read_pixels(path, ImageFileError)
    except ImageFileError as error:
        assert str(path) in str(error)
    else:
        assert text == ""


@pytest.mark.parametrize("kind", [ImageFileError, LutFileError])
def test_unreadable_paths_are_named_by_an_error_of_the_requested_type(tmp_path, kind):
    (tmp_path / "empty.png").touch()
    (tmp_path / "folder.png").mkdir()
    assert "no such file" in error_message(tmp_path / "missing.png", kind)
    assert "empty" in error_message(tmp_path / "empty.png", kind)
    assert "not a file" in error_message(tmp_path / "folder.png", kind)


# -- paths that cannot be written ------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("missing/a.png", "does not exist"),
        ("folder.png", "is a folder"),
        ("a.dwg", "cannot write"),
        ("a", "cannot write"),
    ],
)
def test_a_path_that_cannot_be_written_is_named_and_unchanged(tmp_path, name, reason):
    (tmp_path / "folder.png").mkdir()
    with pytest.raises(OutputError, match=reason) as caught:
        write_pixels(tmp_path / name, sample())
    assert str(tmp_path / name) in str(caught.value)
    assert [path.name for path in tmp_path.iterdir()] == ["folder.png"]


@pytest.mark.skipif(AS_ROOT, reason="root can write to every folder")
def test_a_folder_without_permission_is_named(tmp_path):
    tmp_path.chmod(0o500)
    with pytest.raises(OutputError, match="cannot write"):
        write_pixels(tmp_path / "a.png", sample())


@pytest.mark.parametrize(
    ("name", "kind", "message"),
    [
        ("a.png", np.float32, "the format holds uint8 or uint16"),
        ("a.exr", np.uint8, "the format holds float32"),
        ("a.exr", np.uint16, "the format holds float32"),
        ("a.png", np.float64, "they must be uint8, uint16 or float32"),
        ("a.exr", np.int64, "they must be uint8, uint16 or float32"),
    ],
)
def test_a_type_that_the_format_does_not_hold_is_refused_with_those_it_holds(
    tmp_path, name, kind, message
):
    with pytest.raises(ArgumentError, match=rf"{name}: pixels are {np.dtype(kind)}; {message}"):
        write_pixels(tmp_path / name, np.zeros((2, 2, 3), dtype=kind))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("shape", [(0, 4, 3), (4, 0, 3), (4, 4, 5)], ids=str)
def test_an_image_that_the_format_cannot_hold_keeps_the_old_file(tmp_path, shape):
    target = tmp_path / "a.png"
    write_pixels(target, sample())
    old = target.read_bytes()
    with pytest.raises(OutputError, match=r"a\.png: cannot write it"):
        write_pixels(target, np.zeros(shape, dtype=np.uint8))
    assert target.read_bytes() == old
    assert list(tmp_path.iterdir()) == [target]
