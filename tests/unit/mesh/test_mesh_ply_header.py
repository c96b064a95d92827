"""Headers of PLY files: what they state, and what is refused before any data are read."""

from __future__ import annotations

import tracemalloc
from pathlib import Path

import pytest

from mesh_files import BIG, INDICES, LITTLE, POSITION, ply_bytes
from skinshade._core.errors import MeshFileError
from skinshade.mesh import load_mesh
from skinshade.mesh.ply_header import LONGEST_HEADER, Element, Property, read_header

FILE = Path("in.ply")
ROWS = {"vertex": (POSITION, [(0.0, 0.0, 0.0)]), "face": (INDICES, [((0, 0, 0),)])}
HEADER = """ply
format ascii 1.0
comment  made by hand
obj_info anything
element  vertex   3
property float x
property	list uint8 int64 ids
element none 0
end_header
"""


def test_a_header_states_elements_and_properties():
    header = read_header(FILE, HEADER.encode() + b"data")
    assert header.byte_order == ""
    assert header.comments == ("made by hand",)
    properties = (Property("x", "f4"), Property("ids", "i8", "u1"))
    assert header.elements == (Element("vertex", 3, properties), Element("none", 0, ()))
    assert header.size == len(HEADER)


@pytest.mark.parametrize("line", ["", "obj_info x", "Created by a program", "comments x"])
def test_other_lines_of_a_header_are_ignored(line):
    content = HEADER.replace("obj_info anything", line).encode()
    assert read_header(FILE, content).elements == read_header(FILE, HEADER.encode()).elements


@pytest.mark.parametrize(("form", "order"), [(LITTLE, "<"), (BIG, ">")])
def test_a_binary_format_has_a_byte_order(form, order):
    assert read_header(FILE, ply_bytes(ROWS, form)).byte_order == order


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("ply\n", "pny\n", "not a PLY file; its first line is not 'ply'"),
        ("end_header", "endheader", f"no line 'end_header' within {LONGEST_HEADER} bytes"),
        ("format ascii 1.0\n", "", "the header states no format"),
        ("ascii 1.0", "ascii", "line 2 of the header, 'format ascii', must name one of"),
        ("ascii 1.0", "text 1.0", "line 2 of the header, 'format text 1.0', must name one of"),
        ("ascii 1.0", "ascii 1.1", "'format ascii 1.1', has a version other than 1.0"),
        ("float x", "real x", "line 6 of the header, 'property real x', has the unknown type 'real'"),
        ("float x", "float", "'property float', must have a type and a name, or 'list', two types"),
        ("uint8 int64", "uint8", "'property list uint8 ids', must have a type and a name, or 'list'"),
        ("uint8 int64", "float int", "counts a list by a type that is not whole"),
        ("int64 ids", "int64 x", "'property list uint8 int64 x', repeats the name of a property"),
        ("element none", "element vertex", "'element vertex 0', repeats the name of an element"),
        ("vertex   3", "vertex -3", "'element vertex -3', must have a name and a number of rows"),
        ("vertex   3", "vertex 3.0", "'element vertex 3.0', must have a name and a number of rows"),
        ("vertex   3", "vertex", "'element vertex', must have a name and a number of rows"),
        ("vertex   3", "vertex ٣", "'element vertex ٣', must have a name and a number of rows"),
        ("element  vertex   3\n", "", "'property float x', is before all elements"),
    ],
)  # fmt: skip
def test_a_faulty_header_is_refused_with_its_line(old, new, message):
    assert old in HEADER
    with pytest.raises(MeshFileError) as caught:
        read_header(FILE, HEADER.replace(old, new, 1).encode())
    assert str(caught.value).startswith("in.ply: ")
    assert message in str(caught.value)


@pytest.mark.parametrize("form", ["ascii", LITTLE, BIG])
@pytest.mark.parametrize("element", ["vertex", "face"])
def test_a_count_that_the_file_cannot_hold_is_refused_before_memory_is_reserved(
    tmp_path, form, element
):
    content = ply_bytes(ROWS, form)
    row = f"element {element} 1".encode()
    assert row in content
    (tmp_path / "in.ply").write_bytes(content.replace(row, row + 12 * b"0"))
    tracemalloc.start()
    with pytest.raises(MeshFileError, match=f"states 1000000000000 rows of element {element}"):
        load_mesh(tmp_path / "in.ply", unit_mm=1.0)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 1 << 18


@pytest.mark.parametrize("form", [LITTLE, BIG])
@pytest.mark.parametrize("count", ["uint", "uint64", "int64"])
def test_a_list_that_the_file_cannot_hold_is_refused_before_memory_is_reserved(
    tmp_path, form, count
):
    faces = ([f"list {count} double vertex_indices"], [((0.0, 0.0, 0.0),)] * 2)
    content = ply_bytes({"vertex": ROWS["vertex"], "face": faces}, form)
    size = 4 if count == "uint" else 8
    start = len(content) - 2 * (size + 24)
    length = b"\x7f" + b"\xff" * (size - 1)
    content = content[:start] + (length if form == BIG else length[::-1]) + content[start + size :]
    (tmp_path / "in.ply").write_bytes(content)
    tracemalloc.start()
    with pytest.raises(MeshFileError, match="element face, row 0, goes on past the end"):
        load_mesh(tmp_path / "in.ply", unit_mm=1.0)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 1 << 18


def test_rows_of_elements_without_properties_take_no_time(tmp_path):
    content = HEADER.replace("element none 0", "element none 999999999999999999").encode()
    assert read_header(FILE, content).elements[1].rows == 999999999999999999
    for form in ("ascii", LITTLE):
        (tmp_path / "in.ply").write_bytes(
            ply_bytes(ROWS, form).replace(b"end_header", b"element none 999999999999\nend_header")
        )
        with pytest.raises(Exception, match="no face has an area"):
            load_mesh(tmp_path / "in.ply", unit_mm=1.0)


@pytest.mark.parametrize(
    ("elements", "message"),
    [
        ({"face": ROWS["face"]}, "has no element vertex"),
        ({"vertex": (POSITION[:2], [(0.0, 0.0)])}, "element vertex has no numbers x, y and z"),
        ({"vertex": ROWS["vertex"]}, "holds no triangles"),
        (ROWS | {"face": (INDICES, [])}, "holds no triangles"),
        (ROWS | {"face": (["int a", "int b"], [(1, 2)])}, "element face has no list vertex_indices"),
        (
            ROWS | {"face": (["list uchar float vertex_indices"], [((0.0, 0.0, 0.0),)])},
            "element face: the type of vertex_indices is not whole",
        ),
    ],
)  # fmt: skip
def test_a_file_without_what_a_mesh_needs_is_refused(tmp_path, elements, message):
    for form in ("ascii", LITTLE):
        (tmp_path / "in.ply").write_bytes(ply_bytes(elements, form))
        with pytest.raises(MeshFileError, match=message):
            load_mesh(tmp_path / "in.ply", unit_mm=1.0)
