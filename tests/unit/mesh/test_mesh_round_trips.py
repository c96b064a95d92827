"""Random meshes, written in random valid spellings, are read as they were written."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from mesh_files import BIG, LITTLE, ply_bytes
from skinshade._core.errors import InputError
from skinshade.mesh.obj import read_obj
from skinshade.mesh.ply import read_ply

SAME_FOLDER = settings(
    suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=60, deadline=None
)
NUMBER = st.floats(-1e6, 1e6, width=32)


def rows_of(width, low, high):
    return st.lists(st.tuples(*[NUMBER] * width), min_size=low, max_size=high)


def fan(polygon):
    """Return the corners of the triangles of a polygon."""
    triangles = [(polygon[0], *polygon[i : i + 2]) for i in range(1, len(polygon) - 1)]
    return [corner for triangle in triangles for corner in triangle]


# -- OBJ -------------------------------------------------------------------------------------------


@st.composite
def obj_files(draw):
    """Return the bytes of an OBJ file, and position, UV and normal (or None) of corners of triangles."""
    spaces = st.sampled_from([" ", "\t", "  ", " \t "])
    forms = st.sampled_from(["{:.9g}", "{:.17g}", "{!r}", "{:+.9e}", "{:.6f}"])
    with_uvs, with_normals = draw(st.booleans()), draw(st.booleans())
    line_end = draw(st.sampled_from(["\n", "\r\n", "\r"]))
    tables = {"v": [], "vt": [], "vn": []}
    lines, expected = [], []

    def number(value):
        text = draw(forms).format(value)
        return text, float(text)

    def add_rows(keyword, width, count):
        for _ in range(count):
            texts, values = zip(*[number(draw(NUMBER)) for _ in range(width)], strict=True)
            tables[keyword].append(values)
            lines.append([keyword, *texts])

    def corner():
        parts = []
        for keyword in ("v", "vt", "vn"):
            given = keyword == "v" or {"vt": with_uvs, "vn": with_normals}[keyword]
            index = draw(st.integers(0, len(tables[keyword]) - 1)) if given else None
            parts.append(index)
        texts = ["" if i is None else index_text(k, i) for k, i in zip(tables, parts, strict=True)]
        return "/".join(texts).rstrip("/"), [
            None if index is None else tables[keyword][index]
            for keyword, index in zip(tables, parts, strict=True)
        ]

    def index_text(keyword, index):
        count = len(tables[keyword])
        return draw(st.sampled_from([str(index + 1), str(index - count), f"0{index + 1}"]))

    for _ in range(draw(st.integers(1, 3))):
        add_rows("v", 3, draw(st.integers(1, 4)))
        add_rows("vt", 2, draw(st.integers(1, 3)))
        add_rows("vn", 3, draw(st.integers(1, 3)))
        for _ in range(draw(st.integers(1, 3))):
            corners = [corner() for _ in range(draw(st.integers(3, 6)))]
            lines.append(["f", *(text for text, _ in corners)])
            expected += fan([values for _, values in corners])
        lines.append(draw(st.sampled_from([["g", "f", "1"], ["#", "v", "0"], [], ["l", "1", "2"]])))
    content = ""
    for words in lines:
        joint = draw(spaces)
        if words and words[0] in tables and draw(st.booleans()):
            joint += f"\\{line_end}"
        end = draw(st.sampled_from(["", " ", "  # f 1 2 3", "#"]))
        content += draw(st.sampled_from(["", " ", "\t"])) + joint.join(words) + end + line_end
    mark = draw(st.sampled_from([b"", b"\xef\xbb\xbf"]))
    return mark + content.encode(), expected


@pytest.mark.slow
@SAME_FOLDER
@given(obj_files())
def test_obj_corners_are_those_that_were_written(tmp_path, case):
    content, expected = case
    (tmp_path / "in.obj").write_bytes(content)
    triangles, _ = read_obj(tmp_path / "in.obj")
    corners = triangles.faces.ravel()
    positions, uvs, normals = zip(*expected, strict=True)
    np.testing.assert_array_equal(triangles.positions[corners], positions)
    assert (triangles.uvs is None) == (uvs[0] is None)
    assert (triangles.normals is None) == (normals[0] is None)
    if triangles.uvs is not None:
        v_down = np.array(uvs) * (1.0, -1.0) + (0.0, 1.0)
        np.testing.assert_array_equal(triangles.uvs[corners], v_down)
    if triangles.normals is not None:
        np.testing.assert_array_equal(triangles.normals[corners], normals)
    assert len(triangles.positions) == len(set(expected_rows(expected)))


def expected_rows(expected):
    return [tuple(x + 0.0 for part in corner if part for x in part) for corner in expected]


# -- PLY -------------------------------------------------------------------------------------------


@st.composite
def ply_files(draw):
    """Return the bytes of a PLY file, its table of vertices by name, its triangles and UVs of corners."""
    form = draw(st.sampled_from(["ascii", LITTLE, BIG]))
    names = ["x", "y", "z", *draw(st.sampled_from([[], ["nx", "ny", "nz"]]))]
    names += draw(st.sampled_from([[], ["s", "t"], ["u", "v"]]))
    names += draw(st.lists(st.sampled_from(["quality", "nx2"]), unique=True))
    names = draw(st.permutations(names))
    rows = draw(rows_of(len(names), 1, 8))
    types = [draw(st.sampled_from(["float", "double", "float32", "float64"])) for _ in names]
    vertex = ([f"{kind} {name}" for kind, name in zip(types, names, strict=True)], rows)
    index = st.integers(0, len(rows) - 1)
    polygons = draw(st.lists(st.lists(index, min_size=3, max_size=6), min_size=1, max_size=6))
    whole = st.sampled_from(["char", "uchar", "short", "ushort", "int", "uint", "int64"])
    name = draw(st.sampled_from(["vertex_index", "vertex_indices"]))
    properties, columns = [f"list {draw(whole)} {draw(whole)} {name}"], [polygons]
    with_uvs = draw(st.booleans())
    if with_uvs:
        uvs = [[draw(NUMBER) for _ in range(2 * len(polygon))] for polygon in polygons]
        properties.append(f"list {draw(whole)} float texcoord")
        columns.append(uvs)
    if draw(st.booleans()):
        properties.append("short group")
        columns.append([draw(st.integers(-9, 9)) for _ in polygons])
    order = draw(st.permutations(range(len(columns))))
    face = (
        [properties[i] for i in order],
        [tuple(columns[i][row] for i in order) for row in range(len(polygons))],
    )
    other = (["list uchar short values", "int number"], [([], 1), ([2, 3], 4)])
    elements = draw(st.permutations([("vertex", vertex), ("face", face), ("other", other)]))
    line_end = draw(st.sampled_from(["\n", "\r\n", "\r"]))
    corner_uvs = None
    if with_uvs:
        pairs = [list(zip(line[0::2], line[1::2], strict=True)) for line in uvs]
        corner_uvs = [pair for polygon in pairs for pair in fan(polygon)]
    corners = [corner for polygon in polygons for corner in fan(polygon)]
    table = {name: np.array(rows)[:, i] for i, name in enumerate(names)}
    return ply_bytes(dict(elements), form, line_end=line_end), table, corners, corner_uvs


@pytest.mark.slow
@SAME_FOLDER
@given(ply_files())
def test_ply_corners_are_those_that_were_written(tmp_path, case):
    content, table, corners, corner_uvs = case
    (tmp_path / "in.ply").write_bytes(content)
    triangles, _ = read_ply(tmp_path / "in.ply")
    read = triangles.faces.ravel()

    def assert_equal(values, names):
        expected = np.stack([table[name][corners] for name in names], axis=1)
        np.testing.assert_array_equal(values[read], expected)

    assert_equal(triangles.positions, ("x", "y", "z"))
    assert (triangles.normals is not None) == ("nx" in table)
    if triangles.normals is not None:
        assert_equal(triangles.normals, ("nx", "ny", "nz"))
    for name in ("quality", "nx2"):
        assert (name in triangles.attributes) == (name in table)
        if name in table:
            assert_equal(triangles.attributes[name], (name,))
    names = next((pair for pair in (("u", "v"), ("s", "t")) if pair[0] in table), None)
    if corner_uvs is None and names is None:
        assert triangles.uvs is None
        return
    expected = corner_uvs or [(table[names[0]][i], table[names[1]][i]) for i in corners]
    v_down = np.array(expected) * (1.0, -1.0) + (0.0, 1.0)
    np.testing.assert_array_equal(triangles.uvs[read], v_down)


@pytest.mark.parametrize("reader", [read_obj, read_ply])
@given(data=st.binary(max_size=300) | st.text("vtnf 0123456789.-/#\\\n", max_size=300))
@SAME_FOLDER
def test_any_bytes_are_read_or_refused(tmp_path, reader, data):
    content = data if isinstance(data, bytes) else data.encode()
    (tmp_path / "in.xyz").write_bytes(content)
    try:
        triangles, _ = reader(tmp_path / "in.xyz")
    except InputError as error:
        assert str(tmp_path) in str(error)
        return
    assert triangles.faces.max() < len(triangles.positions)
