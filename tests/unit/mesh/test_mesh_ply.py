"""PLY files in text and binary, with every kind of property, and faulty ones."""

from __future__ import annotations

import numpy as np
import pytest

from mesh_files import BIG, INDICES, LITTLE, POSITION, ply_bytes
from skinshade._core.errors import ArgumentError, MeshFileError
from skinshade.mesh import load_mesh

POSITIONS = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]
TRIANGLES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
FACES = (INDICES, [(face,) for face in TRIANGLES])
UVS = [(0.25, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 0.75)]
FORMS = pytest.mark.parametrize("form", ["ascii", LITTLE, BIG])
COLOURS = ["uchar red", "uchar green", "uchar blue"]


def vertices(properties=(), rows=((), (), (), ())):
    """Return the element of the vertices of the tetrahedron, with further properties."""
    return ([*POSITION, *properties], [(*p, *row) for p, row in zip(POSITIONS, rows, strict=True)])


def read(folder, content):
    file = folder / "in.ply"
    file.write_bytes(content)
    return load_mesh(file, unit_mm=1.0)


def assert_tetrahedron(mesh):
    np.testing.assert_array_equal(mesh.positions, POSITIONS)
    np.testing.assert_array_equal(mesh.faces, TRIANGLES)


def assert_refused(folder, content, message, kind=MeshFileError):
    with pytest.raises(kind) as caught:
        read(folder, content)
    assert str(caught.value).endswith(f"in.ply: {message}")


# -- text ------------------------------------------------------------------------------------------


def test_a_byte_order_mark_is_ignored(tmp_path):
    for form in ("ascii", LITTLE):
        content = ply_bytes({"vertex": vertices(), "face": FACES}, form)
        assert_tetrahedron(read(tmp_path, b"\xef\xbb\xbf" + content))


@FORMS
@pytest.mark.parametrize("line_end", ["\r\n", "\r"])
def test_the_header_can_have_any_line_end(tmp_path, form, line_end):
    elements = {"vertex": vertices(), "face": FACES}
    assert_tetrahedron(read(tmp_path, ply_bytes(elements, form, line_end=line_end)))


def test_after_a_header_with_cr_a_line_feed_belongs_to_the_data(tmp_path):
    first = np.frombuffer(b"\n\x00\x80\x3f", "<f4")[0]  # 1.000001
    rows = [(first, 0.0, 0.0), *POSITIONS[1:]]
    content = ply_bytes({"vertex": (POSITION, rows), "face": FACES}, LITTLE, line_end="\r")
    assert b"end_header\r\n" in content
    assert read(tmp_path, content).positions[0, 0] == first


def test_a_truncated_text_is_refused(tmp_path):
    content = ply_bytes({"vertex": vertices(), "face": FACES})
    for size in range(1, len(content) - 1):
        with pytest.raises(MeshFileError):
            read(tmp_path, content[:size])
    assert_tetrahedron(read(tmp_path, content[:-1]))
    assert_refused(tmp_path, content[:-8], "ends early; element face has 3 of 4 rows")


VERTEX, FACE = b"\n1.0 0.0 0.0\n", b"3 0 1 3"
NOT_WHOLE = "has a number in the list vertex_indices that is not whole"
WRONG_LENGTH = "has a wrong length of vertex_indices"


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (VERTEX, b"\n1.0 0.0\n", "line 11 (element vertex, row 1) has too few numbers"),
        (VERTEX, b"\n1 0 0 0\n", "line 11 (element vertex, row 1) has too many numbers"),
        (VERTEX, b"\nx 0 0\n", "line 11 cannot be read as numbers: 'x 0 0'"),
        (FACE, b"2 0 1 3", "line 15 (element face, row 1) has too many numbers"),
        (FACE, b"3 0 1 nan", f"line 15 (element face, row 1) {NOT_WHOLE}"),
        (FACE, b"3 0 1 2.5", f"line 15 (element face, row 1) {NOT_WHOLE}"),
        (FACE, b"nan 0 1 3", f"line 15 (element face, row 1) {WRONG_LENGTH}"),
        (FACE, b"-1e300 0 1 3", f"line 15 (element face, row 1) {WRONG_LENGTH}"),
        (FACE, b"1e300 0 1 3", f"line 15 (element face, row 1) {WRONG_LENGTH}"),
        (
            FACE,
            b"3 0 1",
            "line 15 (element face, row 1) has too few numbers for the list vertex_indices",
        ),
        (b"3 1 2 3\n", b"3 1 2 3\n3 0 1 2\n", "line 18 follows the last element"),
    ],
)
def test_a_faulty_row_of_text_is_named_with_its_line(tmp_path, old, new, message):
    content = ply_bytes({"vertex": vertices(), "face": FACES})
    assert old in content
    assert_refused(tmp_path, content.replace(old, new), message)


# -- lists -----------------------------------------------------------------------------------------


@FORMS
@pytest.mark.parametrize("count", ["char", "uchar", "short", "ushort", "int", "uint", "int64"])
@pytest.mark.parametrize("index", ["int8", "uint16", "int32", "uint32", "uint64"])
def test_lists_have_any_whole_types(tmp_path, form, count, index):
    faces = ([f"list {count} {index} vertex_index"], FACES[1])
    assert_tetrahedron(read(tmp_path, ply_bytes({"vertex": vertices(), "face": faces}, form)))


@FORMS
def test_triangles_quads_and_polygons_can_alternate(tmp_path, form):
    points = [(float(x), float(x * x), 0.0) for x in range(7)]
    rows = [((0, 1, 2),), ((0, 1, 3, 4),), ((2, 3, 4, 5, 6),), ((0, 5, 6),)]
    elements = {"vertex": (POSITION, points), "face": (INDICES, rows)}
    np.testing.assert_array_equal(
        read(tmp_path, ply_bytes(elements, form)).faces,
        [[0, 1, 2], [0, 1, 3], [0, 3, 4], [2, 3, 4], [2, 4, 5], [2, 5, 6], [0, 5, 6]],
    )


@FORMS
def test_a_face_can_have_further_numbers_and_lists(tmp_path, form):
    properties = ["uchar flags", *INDICES, "list int double weights", "short group"]
    rows = [(1, face, [0.5] * number, -7) for number, face in enumerate(TRIANGLES)]
    elements = {"vertex": vertices(), "face": (properties, rows)}
    assert_tetrahedron(read(tmp_path, ply_bytes(elements, form)))


@FORMS
def test_elements_can_be_in_any_order_and_of_any_name(tmp_path, form):
    edges = (["int vertex1", "int vertex2"], [(0, 1), (1, 2)])
    lists = (["list uchar float values"], [((),), ((0.5,),), ((1.0, 2.0),)])
    empty = (["list uchar int a", "double b"], [])
    elements = {"x": lists, "face": FACES, "edge": edges, "none": empty, "vertex": vertices()}
    assert_tetrahedron(read(tmp_path, ply_bytes(elements | {"y": lists}, form)))


@FORMS
def test_vertices_can_have_lists(tmp_path, form):
    rows = [((0.5,) * number, number) for number in range(4)]
    element = vertices(["list uchar float weights", "int number"], rows)
    mesh = read(tmp_path, ply_bytes({"vertex": element, "face": FACES}, form))
    assert_tetrahedron(mesh)
    np.testing.assert_array_equal(mesh.attributes["number"], [0.0, 1.0, 2.0, 3.0])


@FORMS
@pytest.mark.parametrize(
    "rows",
    [
        [((0, 2, 1, 3, 0, 2),)],
        [((0, 2, 1, -1, 0, 1, 3, -1, 0, 3, 2, -1, -1, 1, 2, 3, -1),)],
        [((0, 2, 1),), ((0, 1, 3),), ((0, 3, 2, 1),), ((),)],
        [((0, 2, 1, 1, 1, 0, 0, 1, 3, 3, 3, 0, 0, 3, 2, 2, 2, 1, 1, 2, 3),)],
    ],
    ids=["one", "restarts", "rows", "repeated vertices"],
)
def test_strips_become_triangles(tmp_path, form, rows):
    strips = (["list int int vertex_indices"], rows)
    mesh = read(tmp_path, ply_bytes({"vertex": vertices(), "tristrips": strips}, form))
    turned = {tuple(np.roll(face, -np.argmin(face)).tolist()) for face in mesh.faces}
    assert turned == set(TRIANGLES)
    assert set(mesh.repairs) == {"normals computed"}


@pytest.mark.parametrize("form", [LITTLE, BIG])
def test_a_truncated_binary_is_refused(tmp_path, form):
    rows = [(1, face, [0.5] * number) for number, face in enumerate(TRIANGLES)]
    uneven = (["uchar a", *INDICES, "list ushort double b"], rows)
    for faces in (FACES, uneven):
        content = ply_bytes({"vertex": vertices(), "face": faces}, form)
        for size in range(len(content) - 100, len(content)):
            with pytest.raises(MeshFileError):
                read(tmp_path, content[:size])


def test_bytes_after_the_last_element_are_refused_unless_they_are_padding(tmp_path):
    content = ply_bytes({"vertex": vertices(), "face": FACES}, LITTLE)
    assert_tetrahedron(read(tmp_path, content + b"\0\0\r\n"))
    message = "5 bytes follow the last element; the header states fewer rows"
    assert_refused(tmp_path, content + b"3\0\0\0\1", message)


@pytest.mark.parametrize("form", [LITTLE, BIG])
def test_a_list_of_negative_length_is_refused(tmp_path, form):
    faces = (["list short int vertex_indices"], FACES[1])
    content = ply_bytes({"vertex": vertices(), "face": faces}, form)
    last = content.rindex(np.array(3, ">i2" if form == BIG else "<i2").tobytes(), 0, -12)
    broken = content[:last] + b"\xff\xff" + content[last + 2 :]
    assert_refused(tmp_path, broken, "element face, row 3, has a list of -1 numbers")


def test_a_face_without_corners_is_refused(tmp_path):
    faces = (INDICES, [*FACES[1], ((),)])
    for form in ("ascii", LITTLE):
        content = ply_bytes({"vertex": vertices(), "face": faces}, form)
        assert_refused(tmp_path, content, "element face, row 4, has no corners")


@pytest.mark.parametrize("index", [4, -1])
def test_an_index_out_of_range_is_refused(tmp_path, index):
    for properties, row in (
        (INDICES, ((0, 1, index),)),
        ([*INDICES, "list uchar float texcoord"], ((0, 1, index), [0.0] * 6)),
    ):
        content = ply_bytes({"vertex": vertices(), "face": (properties, [row])}, LITTLE)
        with pytest.raises(ArgumentError, match=rf"in\.ply: faces\[0, 2\] is {index}; there are 4"):
            read(tmp_path, content)


# -- vertices --------------------------------------------------------------------------------------


@FORMS
@pytest.mark.parametrize(("u", "v"), [("s", "t"), ("u", "v"), ("texture_u", "texture_v")])
def test_uvs_of_vertices_have_several_names_and_v_down(tmp_path, form, u, v):
    element = vertices([f"float {u}", f"float {v}"], UVS)
    mesh = read(tmp_path, ply_bytes({"vertex": element, "face": FACES}, form))
    assert_tetrahedron(mesh)
    np.testing.assert_array_equal(mesh.uvs, [(a, 1.0 - b) for a, b in UVS])
    assert mesh.attributes == {}


@FORMS
def test_uvs_of_corners_split_the_vertices_of_a_seam(tmp_path, form):
    coordinates = [[x for i in face for x in UVS[i]] for face in TRIANGLES]
    coordinates[1][:2] = [0.5, 0.5]
    faces = ([*INDICES, "list uchar float texcoord", "int texnumber"], [])
    faces[1].extend((f, c, 0) for f, c in zip(TRIANGLES, coordinates, strict=True))
    element = vertices(COLOURS, [(n, 2 * n, 3 * n) for n in range(4)])
    mesh = read(tmp_path, ply_bytes({"vertex": element, "face": faces}, form))
    np.testing.assert_array_equal(mesh.positions[mesh.faces], np.array(POSITIONS)[TRIANGLES])
    expected = np.array(coordinates).reshape(-1, 3, 2) * (1.0, -1.0) + (0.0, 1.0)
    np.testing.assert_array_equal(mesh.uvs[mesh.faces], expected)
    assert len(mesh.positions) == 5
    np.testing.assert_array_equal(mesh.attributes["color"][:, 0], [0.0, 0.0, 1.0, 2.0, 3.0])


def test_uvs_of_corners_can_be_missing_at_some_faces(tmp_path):
    rows = [(face, [0.5] * 6) for face in TRIANGLES[:3]] + [(TRIANGLES[3], [])]
    faces = ([*INDICES, "list uchar float texcoord"], rows)
    mesh = read(tmp_path, ply_bytes({"vertex": vertices(), "face": faces}, LITTLE))
    assert_tetrahedron(mesh)
    assert mesh.uvs is None


def test_uvs_of_corners_of_a_wrong_length_are_refused(tmp_path):
    rows = [(face, [0.5] * 6) for face in TRIANGLES[:3]] + [(TRIANGLES[3], [0.5] * 4)]
    faces = ([*INDICES, "list uchar float texcoord"], rows)
    message = "element face, row 3, has 4 numbers in the list texcoord; 3 corners have 6"
    assert_refused(tmp_path, ply_bytes({"vertex": vertices(), "face": faces}), message)


@FORMS
@pytest.mark.parametrize("further", [[], ["float s", "float t"]])
def test_colours_are_one_attribute_with_and_without_uvs(tmp_path, form, further):
    rows = [(255, n, 0, *UVS[n][: len(further)]) for n in range(4)]
    element = vertices([*COLOURS, *further], rows)
    mesh = read(tmp_path, ply_bytes({"vertex": element, "face": FACES}, form))
    assert_tetrahedron(mesh)
    expected = [(255.0, n, 0.0) for n in range(4)]
    np.testing.assert_array_equal(mesh.attributes["color"], expected)
    alpha = vertices([*COLOURS, "uchar alpha"], [(9, 8, 7, 6)] * 4)
    mesh = read(tmp_path, ply_bytes({"vertex": alpha, "face": FACES}, form))
    np.testing.assert_array_equal(mesh.attributes["color"], [[9.0, 8.0, 7.0, 6.0]] * 4)


@FORMS
def test_numbers_of_vertices_become_attributes_by_their_names(tmp_path, form):
    element = vertices(["double quality", "short region"], [(0.1 * n, -n) for n in range(4)])
    mesh = read(tmp_path, ply_bytes({"vertex": element, "face": FACES}, form))
    np.testing.assert_array_equal(mesh.attributes["quality"], [0.1 * n for n in range(4)])
    np.testing.assert_array_equal(mesh.attributes["region"], [0.0, -1.0, -2.0, -3.0])


def test_an_attribute_that_is_not_finite_is_left_out(tmp_path):
    rows = [(float("nan"), 1.0), (0.0, 2.0), (0.0, 3.0), (0.0, 4.0)]
    element = vertices(["float quality", "float depth"], rows)
    mesh = read(tmp_path, ply_bytes({"vertex": element, "face": FACES}, LITTLE))
    assert list(mesh.attributes) == ["depth"]


def test_a_signalling_nan_is_found_without_a_warning(tmp_path):
    elements = {"vertex": vertices(["float quality"], [(1.0,)] * 4), "face": FACES}
    content = ply_bytes(elements, LITTLE)
    start = content.index(b"end_header\n") + len(b"end_header\n")
    signalling = bytes([1, 0, 128, 127])
    in_attribute = content[: start + 12] + signalling + content[start + 16 :]
    assert read(tmp_path, in_attribute).attributes == {}
    with pytest.raises(ArgumentError, match=r"positions\[0, 1\] is nan"):
        read(tmp_path, content[: start + 4] + signalling + content[start + 8 :])


@FORMS
def test_normals_are_read_and_positions_have_any_type(tmp_path, form):
    properties = ["short x", "short y", "double z", "float nx", "float ny", "float nz"]
    rows = [(int(x), int(y), z, 0.0, 0.0, 2.0) for x, y, z in POSITIONS]
    mesh = read(tmp_path, ply_bytes({"vertex": (properties, rows), "face": FACES}, form))
    assert_tetrahedron(mesh)
    np.testing.assert_array_equal(mesh.normals, [(0.0, 0.0, 1.0)] * 4)
    assert mesh.repairs == {}


def test_a_texture_that_is_missing_prints_nothing(tmp_path, capfd):
    element = vertices(["float s", "float t"], UVS)
    content = ply_bytes({"vertex": element, "face": FACES}, comments=["TextureFile none.png"])
    assert_tetrahedron(read(tmp_path, content))
    assert capfd.readouterr() == ("", "")
