"""Files that are no pictures, and places where none can be written."""

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
from skinshade._core.pixels import LARGEST_SIDE, MOST_PIXELS, read_pixels, write_pixels

AS_ROOT = hasattr(os, "geteuid") and os.geteuid() == 0


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("faults")


def sample(height=6, width=5, kind=np.uint8):
    steps = np.random.default_rng(7).integers(0, 256, (height, width, 3))
    return (steps / np.float32(255.0)).astype(kind) if kind is np.float32 else steps.astype(kind)


# -- files that are no pictures --------------------------------------------------------------------


def chunk(kind, data):
    body = kind + data
    return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))


def png_that_claims(width, height, data=b""):
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    parts = [(b"IHDR", header), (b"IDAT", zlib.compress(data)), (b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(chunk(*part) for part in parts)


def hdr_that_claims(width, height):
    return f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n".encode()


NO_PICTURES = {
    "text.png": b"not a picture at all",
    "text.exr": b"\x76\x2f\x31\x01 but no more",
    "zeros.jpg": bytes(4096),
    "no-suffix": b"\x00\x01\x02",
    "no-pixels.png": png_that_claims(0, 3),
    "no-data.png": png_that_claims(4, 4),
    "half-a-row.png": png_that_claims(4, 4, b"\x00" * 20),
    "no-data.hdr": hdr_that_claims(4, 4),
    "huge.png": png_that_claims(2**31 - 1, 2**31 - 1),
    "long.png": png_that_claims(LARGEST_SIDE + 1, 1, bytes(3 * LARGEST_SIDE + 4)),
    "large.png": png_that_claims(LARGEST_SIDE, LARGEST_SIDE),
    "large.hdr": hdr_that_claims(LARGEST_SIDE, LARGEST_SIDE),
}


def complaint(path, kind=ImageFileError):
    with pytest.raises(kind) as caught:
        read_pixels(path, kind)
    message = str(caught.value)
    assert str(path) in message
    assert len(message.splitlines()) == 1, message
    return message


@pytest.mark.parametrize("name", NO_PICTURES)
def test_what_is_no_picture_is_an_error_in_one_line_that_names_it(tmp_path, name):
    (tmp_path / name).write_bytes(NO_PICTURES[name])
    complaint(tmp_path / name)


def test_the_longest_side_that_is_believed_is_read(tmp_path):
    rows = bytes(3 * LARGEST_SIDE + 1)
    (tmp_path / "long.png").write_bytes(png_that_claims(LARGEST_SIDE, 1, rows))
    assert read_pixels(tmp_path / "long.png", ImageFileError)[0].shape == (1, LARGEST_SIDE, 3)


@pytest.mark.parametrize(
    ("width", "height"), [(LARGEST_SIDE + 1, 1), (LARGEST_SIDE, MOST_PIXELS // LARGEST_SIDE + 1)]
)
def test_a_size_that_is_not_believed_is_told(tmp_path, width, height):
    (tmp_path / "big.png").write_bytes(png_that_claims(width, height))
    assert f"claims {width}×{height} pixels; too large" in complaint(tmp_path / "big.png")


@pytest.mark.skipif(sys.platform != "linux", reason="needs a system that can limit memory")
@pytest.mark.parametrize("name", ["large.png", "large.hdr", "huge.png"])
def test_a_header_that_claims_gigabytes_takes_no_memory(tmp_path, name):
    (tmp_path / name).write_bytes(NO_PICTURES[name])
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
def test_a_file_that_was_cut_off_is_never_taken_for_a_picture(folder, suffix, share):
    path = folder / f"cut{suffix}"
    kind = np.float32 if suffix in (".exr", ".hdr") else np.uint8
    write_pixels(path, sample(40, 50, kind=kind))
    data = path.read_bytes()
    path.write_bytes(data[: max(1, int(share * len(data)))])
    complaint(path)


@pytest.mark.parametrize("suffix", [".png", ".exr"])
@given(place=st.floats(0.0, 1.0, exclude_max=True), value=st.integers(0, 255))
def test_a_wrong_byte_is_an_error_of_the_tree_or_does_no_harm(folder, suffix, place, value):
    path = folder / f"wrong{suffix}"
    kind = np.float32 if suffix == ".exr" else np.uint8
    write_pixels(path, sample(20, 20, kind=kind), "axes")
    data = bytearray(path.read_bytes())
    data[int(place * len(data))] = value
    path.write_bytes(data)
    try:
        found, text = read_pixels(path, ImageFileError)
    except ImageFileError as error:
        assert str(path) in str(error)
    else:
        assert found.dtype == np.float32
        assert found.ndim == 3
        assert isinstance(text, str)


@pytest.mark.parametrize("part", [b"axes", b"channels", b"chlist"])
def test_text_of_a_file_that_is_no_unicode_is_an_error_that_names_it(tmp_path, part):
    path = tmp_path / "a.exr"
    write_pixels(path, sample(kind=np.float32), "axes")
    data = path.read_bytes()
    assert part in data
    path.write_bytes(data.replace(part, b"\xff" * len(part)))
    complaint(path)


@pytest.mark.parametrize("kind", [ImageFileError, LutFileError])
def test_missing_empty_and_folder_are_named_with_the_error_asked_for(tmp_path, kind):
    (tmp_path / "empty.png").touch()
    (tmp_path / "folder.png").mkdir()
    assert "no such file" in complaint(tmp_path / "missing.png", kind)
    assert "empty" in complaint(tmp_path / "empty.png", kind)
    assert "not a file" in complaint(tmp_path / "folder.png", kind)


# -- places that cannot be written -----------------------------------------------------------------


@pytest.mark.parametrize(
    ("place", "reason"),
    [
        ("missing/a.png", "no folder"),
        ("folder.png", "is a folder"),
        ("a.dwg", "cannot write"),
        ("a", "cannot write"),
    ],
)
def test_a_place_that_cannot_be_written_is_named_and_left_as_it_was(tmp_path, place, reason):
    (tmp_path / "folder.png").mkdir()
    with pytest.raises(OutputError, match=reason) as caught:
        write_pixels(tmp_path / place, sample())
    assert str(tmp_path / place) in str(caught.value)
    assert [path.name for path in tmp_path.iterdir()] == ["folder.png"]


@pytest.mark.skipif(AS_ROOT, reason="root may write everywhere")
def test_a_folder_without_permission_is_named(tmp_path):
    tmp_path.chmod(0o500)
    with pytest.raises(OutputError, match="cannot write"):
        write_pixels(tmp_path / "a.png", sample())


@pytest.mark.parametrize(
    ("name", "kind", "said"),
    [
        ("a.png", np.float32, "the format holds uint8 or uint16"),
        ("a.exr", np.uint8, "the format holds float32"),
        ("a.exr", np.uint16, "the format holds float32"),
        ("a.png", np.float64, "uint8, uint16 or float32 is stored"),
        ("a.exr", np.int64, "uint8, uint16 or float32 is stored"),
    ],
)
def test_a_type_that_would_be_converted_is_refused_with_those_that_are_kept(
    tmp_path, name, kind, said
):
    with pytest.raises(ArgumentError, match=rf"{name}: pixels are {np.dtype(kind)}; {said}"):
        write_pixels(tmp_path / name, np.zeros((2, 2, 3), dtype=kind))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("shape", [(0, 4, 3), (4, 0, 3), (4, 4, 5)], ids=str)
def test_what_the_format_cannot_hold_leaves_the_old_file(tmp_path, shape):
    target = tmp_path / "a.png"
    write_pixels(target, sample())
    old = target.read_bytes()
    with pytest.raises(OutputError, match=r"a\.png: cannot write it"):
        write_pixels(target, np.zeros(shape, dtype=np.uint8))
    assert target.read_bytes() == old
    assert list(tmp_path.iterdir()) == [target]
