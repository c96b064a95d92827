"""OBJ files in every valid spelling, and faulty ones."""

from __future__ import annotations

import numpy as np
import pytest

from skinshade._core.errors import MeshFileError
from skinshade.mesh import load_mesh, text
from skinshade.mesh.obj import read_obj

V = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
VT = "vt 0.25 0\nvt 1 0\nvt 0 1\nvt 1 0.75\n"
VN = "vn 0 0 1\nvn 1 0 0\nvn 0 1 0\nvn 0 0 -1\n"
F = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
POSITIONS = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
FACES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


def read(folder, content):
    """Return the mesh of an OBJ file with a content of text or bytes."""
    file = folder / "in.obj"
    file.write_bytes(content if isinstance(content, bytes) else content.encode())
    return load_mesh(file, unit_mm=1.0)


def assert_tetrahedron(mesh):
    np.testing.assert_array_equal(mesh.positions, POSITIONS)
    np.testing.assert_array_equal(mesh.faces, FACES)


def assert_refused(folder, content, message):
    with pytest.raises(MeshFileError) as caught:
        read(folder, content)
    assert str(caught.value).endswith(f"in.obj: {message}")


# -- text ------------------------------------------------------------------------------------------


def test_a_byte_order_mark_does_not_hide_the_first_vertex(tmp_path):
    assert_tetrahedron(read(tmp_path, b"\xef\xbb\xbf" + (V + F).encode()))


@pytest.mark.parametrize("line_end", ["\r\n", "\r", "\n\n \n"])
def test_every_line_end_is_one(tmp_path, line_end):
    assert_tetrahedron(read(tmp_path, (V + F).replace("\n", line_end)))


@pytest.mark.parametrize("space", ["\t", "  ", " \t", "\v"])
def test_any_white_space_separates_words(tmp_path, space):
    assert_tetrahedron(read(tmp_path, (V + F).replace(" ", space)))


def test_indented_lines_are_read(tmp_path):
    assert_tetrahedron(read(tmp_path, "".join(f"\t  {line}\n" for line in (V + F).splitlines())))


def test_comments_after_numbers_and_corners_are_ignored(tmp_path):
    assert_tetrahedron(read(tmp_path, (V + F).replace("\n", " # f 1 2 3 # v\n")))
    assert_tetrahedron(read(tmp_path, (V + F).replace("\n", "#1\n")))


@pytest.mark.parametrize("line_end", ["\n", "\r\n", "\r"])
def test_a_backslash_continues_a_line(tmp_path, line_end):
    content = (V + F).replace("v 1 0 0", "v 1 \\\n0 \\\n 0").replace("f 1 3 2", "f \\\n1 3 2")
    assert_tetrahedron(read(tmp_path, content.replace("\n", line_end)))


def test_a_backslash_at_the_end_of_a_comment_does_not_continue_it(tmp_path):
    assert_tetrahedron(read(tmp_path, "# heads\\\n" + V + "# a\\b\\\n" + F))


def test_line_numbers_count_the_lines_of_the_file_also_after_continued_ones(tmp_path):
    content = "v 0 \\\n 0 \\\n 0\r\nv 1 0 0\rv 0 1 0\n\nf 1 2 7\n"
    assert_refused(tmp_path, content, "line 7 has the corner '7'; there are 3 vertices")


@pytest.mark.parametrize("encoding", ["utf-16-le", "utf-16-be"])
def test_text_in_utf_16_is_read(tmp_path, encoding):
    content = ("\ufeffo t\u00eate\r\n" + V + F).encode(encoding)
    assert_tetrahedron(read(tmp_path, content))
    message = "cannot be read as UTF-16 (truncated data)"
    assert_refused(tmp_path, content[:-1], message)


def test_lines_across_the_ends_of_pieces_are_whole(tmp_path, monkeypatch):
    whole = read(tmp_path, V + VT + VN + F.replace("f 1 3 2", "f 1/1/1 3/3/3 2/2/2"))
    for size in (1, 7, 20, 64):
        monkeypatch.setattr(text, "PIECE", size)
        pieces = read(tmp_path, V + VT + VN + F.replace("f 1 3 2", "f 1/1/1 3/3/3 2/2/2"))
        np.testing.assert_array_equal(pieces.positions, whole.positions)
        np.testing.assert_array_equal(pieces.faces, whole.faces)


# -- numbers ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("more", [" 1", " 0.5 0.25 1", " 0.5 0.25 1 1"])
def test_a_vertex_can_have_a_weight_or_a_colour(tmp_path, more):
    mesh = read(tmp_path, V.replace("\n", f"{more}\n") + F)
    assert_tetrahedron(mesh)
    assert list(mesh.attributes) == (["color"] if len(more) > 2 else [])
    if mesh.attributes:
        np.testing.assert_array_equal(mesh.attributes["color"], [[0.5, 0.25, 1.0]] * 4)


def test_colours_that_not_every_vertex_has_are_left_out(tmp_path):
    coloured = V.replace("\n", " 1 1 1\n")
    for vertices in (
        V.replace("v 1 0 0", "v 1 0 0 1 1 1"),
        coloured.replace("v 1 0 0 1 1 1", "v 1 0 0 nan nan nan"),
    ):
        mesh = read(tmp_path, vertices + F)
        assert_tetrahedron(mesh)
        assert mesh.attributes == {}
    assert list(read(tmp_path, coloured + "v 9 9 9 nan 0 0\n" + F).attributes) == ["color"]


def test_colours_stay_with_their_vertices_at_a_seam(tmp_path):
    vertices = "".join(f"v {x} {y} {z} {x} {y} {z}\n" for x, y, z in POSITIONS)
    mesh = read(tmp_path, vertices + VT + "f 1/1 3/3 2/2\nf 1/4 2/2 4/4\nf 1/1 4/4 3/3\n")
    assert len(mesh.positions) == 5
    np.testing.assert_array_equal(mesh.attributes["color"], mesh.positions)


def test_uvs_of_one_or_three_numbers_are_read(tmp_path):
    faces = "f 1/1 3/3 2/2\n"
    three = read(tmp_path, V + VT.replace("\n", " 9\n") + faces)
    np.testing.assert_array_equal(three.uvs, [[0.25, 1.0], [1.0, 1.0], [0.0, 0.0]])
    one = read(tmp_path, V + "vt 0.25\nvt 1\nvt 0\n" + faces)
    np.testing.assert_array_equal(one.uvs, [[0.25, 1.0], [1.0, 1.0], [0.0, 1.0]])


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("v 1 0", "has 2 numbers; a vertex has 3, 4, 6 or 7"),
        ("v 1 2 3 4 5", "has 5 numbers; a vertex has 3, 4, 6 or 7"),
        ("v", "has 0 numbers; a vertex has 3, 4, 6 or 7"),
        ("vt", "has 0 numbers; a UV has 1, 2 or 3"),
        ("vn 0 1", "has 2 numbers; a normal has 3"),
        ("v 1 0-1 0", "cannot be read as numbers: 'v 1 0-1 0'"),
        ("v 1_0 0 0", "cannot be read as numbers: 'v 1_0 0 0'"),
        ("v 1.0.0 0 0", "cannot be read as numbers: 'v 1.0.0 0 0'"),
        ("v 1.-5 0 0", "cannot be read as numbers: 'v 1.-5 0 0'"),
        ("v . 0 0", "cannot be read as numbers: 'v . 0 0'"),
        ("v - 0 0", "cannot be read as numbers: 'v - 0 0'"),
        ("v 0x1 0 0", "cannot be read as numbers: 'v 0x1 0 0'"),
        ("vn 0 0 up", "cannot be read as numbers: 'vn 0 0 up'"),
    ],
)
def test_a_line_with_wrong_numbers_is_named(tmp_path, line, message):
    assert_refused(tmp_path, V + line + "\n" + F, f"line 5 {message}")


# -- faces -----------------------------------------------------------------------------------------


def test_a_tab_after_the_keyword_does_not_hide_faces(tmp_path):
    assert_tetrahedron(read(tmp_path, V + F.replace("f ", "f\t")))


def test_negative_indices_count_from_their_line(tmp_path):
    content = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -1 -2\nv 0 0 1\nf -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1\n"
    assert_tetrahedron(read(tmp_path, content))


def test_negative_indices_of_uvs_and_normals_count_from_their_line(tmp_path):
    first = V + "vt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nvn 0 0 2\nvn 0 0 3\n"
    negative = read(tmp_path, first + "f 1/-3/-3 2/-2/-2 3/-1/-1\nvt 5 5\nvn 1 0 0\nv 9 9 9\n")
    positive = read(tmp_path, first + "f 1/1/1 2/2/2 3/3/3\n")
    for name in ("positions", "uvs", "normals", "faces"):
        np.testing.assert_array_equal(getattr(negative, name), getattr(positive, name))


@pytest.mark.parametrize("zero", ["0", "00", "+0", "-0"])
@pytest.mark.parametrize(
    ("corner", "table"), [("{}", "vertex"), ("1/{}", "UV"), ("1/1/{}", "normal")]
)
def test_index_0_is_refused_in_every_spelling(tmp_path, zero, corner, table):
    content = V + VT + VN + f"f 2 3 {corner.format(zero)}\n"
    assert_refused(tmp_path, content, f"line 13 has {table} index 0; OBJ counts from 1")


@pytest.mark.parametrize(
    ("corner", "message"),
    [
        ("5", "'5'; there are 4 vertices"),
        ("1/5", "'1/5'; there are 4 UVs"),
        ("1//5", "'1//5'; there are 4 normals"),
        ("99999999999", "'99999999999'; there are 4 vertices"),
        ("-5", "'-5', which counts back past the first vertex"),
        ("1/-5", "'1/-5', which counts back past the first UV"),
        ("1//-5", "'1//-5', which counts back past the first normal"),
        ("/1", "'/1', which has no vertex index"),
        ("1/1/1/1", "'1/1/1/1'; it must have at most three indices"),
    ],
)
def test_an_index_out_of_range_is_named_with_its_line(tmp_path, corner, message):
    assert_refused(tmp_path, V + VT + VN + f"f 2 3 {corner}\n", f"line 13 has the corner {message}")


@pytest.mark.parametrize("corner", ["a", "1.5", "1,2", "--1", "+-1", "-", "1/x", "1/+", "9" * 19])
def test_a_corner_that_is_no_index_is_named_with_its_line(tmp_path, corner):
    message = f"line 5 has the corner {corner!r}; it must be indices as in 1, 1/2, 1//3 or 1/2/3"
    assert_refused(tmp_path, V + f"f 2 3 {corner}\n", message)


def test_faces_can_precede_their_vertices(tmp_path):
    assert_tetrahedron(read(tmp_path, F + V))


def test_polygons_become_fans(tmp_path):
    content = "".join(f"v {x} {x * x} 0\n" for x in range(7))
    mesh = read(tmp_path, content + "f 1 2 3\nf 1 2 3 4 5\nf 4 5 6 7\nf 7 1 4\n")
    np.testing.assert_array_equal(
        mesh.faces, [[0, 1, 2], [0, 2, 3], [0, 3, 4], [3, 4, 5], [3, 5, 6], [6, 0, 3]]
    )
    assert mesh.repairs["repeated faces dropped"] == 1


def test_a_face_of_two_corners_is_dropped_and_counted(tmp_path):
    mesh = read(tmp_path, V + F + "f 1 2\nf 3\n")
    assert_tetrahedron(mesh)
    assert mesh.repairs["faces without area dropped"] == 2


def test_corners_with_a_slash_at_the_end_have_no_further_index(tmp_path):
    faces = "f 1/1/ 3/3/ 2/2/\n"
    mesh = read(tmp_path, V + VT + faces)
    np.testing.assert_array_equal(mesh.uvs, [[0.25, 1.0], [1.0, 1.0], [0.0, 0.0]])
    assert mesh.repairs["normals computed"] == 3


def test_forms_of_corners_can_differ_within_a_face(tmp_path):
    mesh = read(tmp_path, V + VT + VN + "f 1 3/3 2//2\nf 1/1/1 2/2/2 4/4/4\n")
    assert mesh.uvs is None
    corners = mesh.positions[mesh.faces]
    np.testing.assert_array_equal(corners, POSITIONS[[[0, 2, 1], [0, 1, 3]]])


def test_normals_of_some_corners_are_kept_and_the_others_computed(tmp_path):
    mesh = read(tmp_path, V + VN + "f 1//1 3//1 2//1\nf 1 2 4\n")
    assert mesh.repairs["normals computed"] == 3
    np.testing.assert_array_equal(mesh.normals[mesh.faces[0]], [[0.0, 0.0, 1.0]] * 3)
    assert np.abs(mesh.normals[mesh.faces[1]] - (0.0, 0.0, 1.0)).max() > 0.1


def test_uvs_that_one_corner_lacks_are_left_out(tmp_path):
    assert read(tmp_path, V + VT + "f 1/1 3/3 2/2\nf 1/1 2/2 4\n").uvs is None


def test_vertices_of_equal_position_uv_and_normal_are_merged(tmp_path):
    faces = "f 1/1/1 3/3/1 2/2/1\nf 5/5/5 6/6/5 8/8/5\n"
    mesh = read(tmp_path, (V + VT + VN) * 2 + faces)
    np.testing.assert_array_equal(mesh.faces, [[0, 2, 1], [0, 1, 3]])
    assert len(mesh.positions) == len(mesh.uvs) == 4


def test_groups_materials_lines_and_curves_are_ignored_and_no_material_file_is_needed(tmp_path):
    names = "mtllib none/none.mtl\no f 1 2 3\ng v 1 1 1\ns off\n"
    others = "usemtl a/b/c\np 1\nl 1 2 3\nvp 0.5\ncstype bezier\ncurv 0 1 1 2\nend\n"
    first, rest = F[:16], F[16:]
    assert_tetrahedron(read(tmp_path, names + V + first + others + rest))


def test_the_old_keyword_of_faces_is_read(tmp_path):
    assert_tetrahedron(read(tmp_path, V + F.replace("f ", "fo ")))


def test_vertices_that_no_face_uses_are_left_out(tmp_path):
    mesh = read(tmp_path, "v nan 9 9\n" + V + F.translate(str.maketrans("1234", "2345")))
    assert_tetrahedron(mesh)


def test_comments_before_the_first_statement_are_returned(tmp_path):
    file = tmp_path / "in.obj"
    file.write_text(f"# one\n\n  #unit_mm 5\n{V}# late\n{F}")
    assert [comment.strip() for comment in read_obj(file)[1]] == ["one", "", "unit_mm 5"]


@pytest.mark.parametrize("content", [V, "o head\n", "\n", "#\n", "f", "f\n"])
def test_a_file_without_faces_is_refused(tmp_path, content):
    with pytest.raises(
        MeshFileError, match=r"in\.obj: (holds no triangles|line 1 has a face with)"
    ):
        read(tmp_path, content)
