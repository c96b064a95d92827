"""STL files, binary and ASCII, and faulty ones."""

from __future__ import annotations

import struct
import tracemalloc

import numpy as np
import pytest

from skinshade._core.errors import ArgumentError, MeshFileError
from skinshade.mesh import load_mesh, text
from skinshade.mesh.stl import read_stl

CORNERS = np.array([[[0.0, 0, 0], [0, 1, 0], [1, 0, 0]], [[0, 0, 0], [1, 0, 0], [0, 0, 1]]])


def binary(corners=CORNERS, header=b"", count=None):
    body = [struct.pack("<12fH", 0, 0, 0, *np.ravel(c), 7) for c in corners]
    number = struct.pack("<I", len(corners) if count is None else count)
    return header.ljust(80, b"\0") + number + b"".join(body)


def ascii_text(corners=CORNERS, name="head"):
    lines = [f"solid {name}"]
    for triangle in corners:
        lines += ["facet normal 0 0 1", "  outer loop"]
        lines += ["    vertex " + " ".join(map(str, corner)) for corner in np.asarray(triangle)]
        lines += ["  endloop", "endfacet"]
    return "\n".join([*lines, f"endsolid {name}", ""])


def read(folder, content):
    file = folder / "in.stl"
    file.write_bytes(content if isinstance(content, bytes) else content.encode())
    return load_mesh(file, unit_mm=1.0)


def assert_corners(mesh, corners=CORNERS):
    np.testing.assert_array_equal(mesh.positions[mesh.faces], corners)


def assert_refused(folder, content, message):
    with pytest.raises(MeshFileError) as caught:
        read(folder, content)
    assert str(caught.value).endswith(f"in.stl: {message}")


# -- binary ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "header", [b"", b"solid head", b"SOLID\n", b"solid a\nfacet normal 0 0 1\n", b"\xff\xfehead"]
)
def test_a_binary_file_can_have_any_header(tmp_path, header):
    assert_corners(read(tmp_path, binary(header=header)))


def test_a_truncated_binary_is_refused(tmp_path):
    content = binary()
    message = "ends early, or is no STL file; 2 facets need 184 bytes, and the file has {}"
    for size in range(84, len(content)):
        assert_refused(tmp_path, content[:size], message.format(size))
    assert_refused(
        tmp_path, content[:70], message.replace("2 ", "0 ").replace("184", "84").format(70)
    )


@pytest.mark.parametrize("header", [b"head", b"solid head"])
def test_a_count_that_the_file_cannot_hold_is_refused_before_memory_is_reserved(tmp_path, header):
    tracemalloc.start()
    with pytest.raises(MeshFileError):
        read(tmp_path, binary(header=header, count=4 * 10**9))
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 1 << 18


def test_bytes_after_the_last_facet_are_refused_unless_they_are_padding(tmp_path):
    assert_corners(read(tmp_path, binary() + b"\0\0\n"))
    message = "9 bytes follow the 2 facets of the header"
    assert_refused(tmp_path, binary() + b"signature", message)


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_a_position_that_is_not_finite_is_refused(tmp_path, value):
    corners = CORNERS.copy()
    corners[1, 2, 0] = value
    for content in (binary(corners), ascii_text(corners)):
        with pytest.raises(ArgumentError, match=rf"in\.stl: positions\[5, 0\] is {value}"):
            read(tmp_path, content)


def test_a_signalling_nan_is_refused_without_a_warning(tmp_path):
    signalling = struct.pack("<I", 0x7F800001)
    content = binary()
    with pytest.raises(ArgumentError, match=r"positions\[0, 0\] is nan"):
        read(tmp_path, content[:96] + signalling + content[100:])


def test_no_facets_are_no_mesh(tmp_path):
    for content in (binary([]), ascii_text([]), binary([], header=b"solid")):
        assert_refused(tmp_path, content, "holds no triangles")


# -- ASCII -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("line_end", ["\n", "\r\n", "\r", "\n\n"])
def test_every_line_end_is_one(tmp_path, line_end):
    assert_corners(read(tmp_path, ascii_text().replace("\n", line_end)))


def test_a_byte_order_mark_blank_lines_and_capitals_are_accepted(tmp_path):
    assert_corners(read(tmp_path, b"\xef\xbb\xbf" + ascii_text().encode()))
    assert_corners(read(tmp_path, "\n \n" + ascii_text().upper()))


@pytest.mark.parametrize("name", ["", "endsolid", "vertex 1 2 3", "facet normal", "t\u00eate 1e5"])
def test_a_solid_can_have_any_name(tmp_path, name):
    assert_corners(read(tmp_path, ascii_text(name=name)))


def test_several_solids_are_joined_without_merging_vertices(tmp_path):
    mesh = read(tmp_path, ascii_text(CORNERS[:1], "a") + ascii_text(CORNERS[1:], "b"))
    assert_corners(mesh)
    assert len(mesh.positions) == 6


def test_facets_across_the_ends_of_pieces_are_whole(tmp_path, monkeypatch):
    (tmp_path / "in.stl").write_text(ascii_text())
    for size in (1, 10, 30, 100):
        monkeypatch.setattr(text, "PIECE", size)
        np.testing.assert_array_equal(
            read_stl(tmp_path / "in.stl")[0].positions, CORNERS.reshape(-1, 3)
        )


def test_a_truncated_text_is_refused(tmp_path):
    content = ascii_text()
    for size in range(84, content.rindex("endsolid") + len("endsolid") - 1):
        with pytest.raises(MeshFileError):
            read(tmp_path, content[:size])
    no_end = content[: content.rindex("endsolid")]
    assert_refused(tmp_path, no_end, "ends early; its last line is not 'endsolid'")


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("vertex 0.0 1.0 0.0", "vertex 0 x 0", "line 5 cannot be read as numbers: 'vertex 0 x 0'"),
        ("vertex 0.0 1.0 0.0", "vertex 0 1", "line 5 has 2 numbers; a vertex has 3"),
        ("vertex 0.0 1.0 0.0", "vertex 0 1 0 0", "line 5 has 4 numbers; a vertex has 3"),
        ("vertex 0.0 1.0 0.0", "", "line 7 begins with 'endloop' instead of 'vertex'"),
        ("vertex 0.0 1.0 0.0", "color 0 1 0", "line 5 begins with 'color' instead of 'vertex'"),
        ("  endloop", "vertex 0 0 1\nendloop", "line 7 begins with 'vertex' instead of 'endloop'"),
        ("  outer loop", "endsolid", "line 3 begins with 'endsolid' instead of 'outer'"),
    ],
)
def test_a_faulty_line_is_named(tmp_path, old, new, message):
    content = ascii_text()
    assert old in content
    assert_refused(tmp_path, content.replace(old, new, 1), message)
