"""Mesh.checked: repairs, counts and refusals."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import shapes
import tolerances as tol
from skinshade._core.errors import ArgumentError, InputError, MeshError, UnitError
from skinshade.mesh import Mesh
from skinshade.mesh.repairs import first_of_equal

BALL = shapes.sphere("icosphere", 2)
COUNT = len(BALL.positions)
UVS = BALL.positions[:, :2] * 0.5 + 0.5


def checked(positions=BALL.positions, faces=BALL.faces, **options):
    return Mesh.checked(positions, faces, **({"unit_mm": 10.0, "name": "head.glb"} | options))


def test_a_valid_mesh_is_unchanged():
    mesh = checked(normals=BALL.normals, uvs=UVS, attributes={"thickness": np.arange(COUNT)})
    assert np.array_equal(mesh.positions, BALL.positions)
    assert np.array_equal(mesh.faces, BALL.faces)
    assert np.allclose(mesh.normals, BALL.normals, rtol=0, atol=tol.ROUNDING.value)
    assert np.array_equal(mesh.uvs, UVS)
    assert np.array_equal(mesh.attributes["thickness"], np.arange(COUNT))
    assert mesh.repairs == {}


def test_positions_in_mm_are_positions_times_the_unit():
    assert np.array_equal(checked(unit_mm=50.35).positions_mm, BALL.positions * 50.35)


# -- repairs ---------------------------------------------------------------------------------------


def test_faces_without_area_are_dropped_and_counted():
    flat = [[0, 0, 1], [5, 5, 5]]
    mesh = checked(faces=np.vstack([BALL.faces, flat]), normals=BALL.normals)
    assert mesh.repairs == {"faces without area dropped": 2}
    assert np.array_equal(mesh.faces, BALL.faces)


def test_a_zero_length_edge_between_two_vertices_makes_a_face_without_area():
    positions = np.vstack([BALL.positions, BALL.positions[:1]])
    faces = np.vstack([BALL.faces, [[0, COUNT, 1]]])
    mesh = checked(positions, faces)
    assert mesh.repairs["faces without area dropped"] == 1
    assert mesh.repairs["unreferenced vertices dropped"] == 1


def test_repeated_faces_are_dropped_and_counted_from_any_first_corner():
    again = np.roll(BALL.faces[[3, 7]], 1, axis=1)
    mesh = checked(faces=np.vstack([BALL.faces, again, BALL.faces[:1]]), normals=BALL.normals)
    assert mesh.repairs == {"repeated faces dropped": 3}
    assert np.array_equal(mesh.faces, BALL.faces)


def test_unreferenced_vertices_are_dropped_from_every_array():
    extra = np.array([[9.0, 9.0, 9.0]])
    positions = np.concatenate([extra, BALL.positions, extra])
    mesh = checked(
        positions,
        BALL.faces + 1,
        normals=np.concatenate([extra, BALL.normals, extra]),
        uvs=np.concatenate([[[5.0, 5.0]], UVS, [[5.0, 5.0]]]),
        attributes={"id": np.arange(COUNT + 2), "colour": np.ones((COUNT + 2, 4))},
    )
    assert mesh.repairs == {"unreferenced vertices dropped": 2}
    assert np.array_equal(mesh.positions, BALL.positions)
    assert np.array_equal(mesh.faces, BALL.faces)
    assert np.array_equal(mesh.uvs, UVS)
    assert np.array_equal(mesh.attributes["id"], np.arange(1, COUNT + 1))
    assert mesh.attributes["colour"].shape == (COUNT, 4)


@pytest.mark.parametrize("bad", [0.0, np.nan, np.inf])
def test_invalid_normals_are_computed_and_counted(bad):
    normals = BALL.normals.copy()
    normals[[2, 11, 40]] = bad
    mesh = checked(normals=normals)
    assert mesh.repairs == {"normals computed": 3}
    assert np.abs(mesh.normals - BALL.normals).max() <= tol.COARSE_NORMALS.value


def test_missing_normals_are_computed_and_counted():
    mesh = checked()
    assert mesh.repairs == {"normals computed": COUNT}
    assert np.abs(mesh.normals - BALL.normals).max() <= tol.COARSE_NORMALS.value


def test_normals_of_any_length_are_normalised():
    lengths = np.geomspace(1e-3, 1e3, COUNT)[:, None]
    mesh = checked(normals=BALL.normals * lengths)
    assert mesh.repairs == {}
    assert np.allclose(mesh.normals, BALL.normals, rtol=0, atol=tol.ROUNDING.value)


def test_faulty_edges_are_counted_and_kept():
    a, b = BALL.faces[0, :2]
    positions = np.vstack([BALL.positions, [[3.0, 3.0, 3.0]]])
    turned = BALL.faces.copy()
    turned[9] = turned[9, ::-1]
    mesh = checked(positions, np.vstack([turned, [[a, b, COUNT]]]))
    counted = {key: mesh.repairs[key] for key in mesh.repairs if "edges" in key}
    assert counted == {"open edges": 2, "non-manifold edges": 1, "edges of opposite winding": 3}
    assert len(mesh.faces) == len(BALL.faces) + 1


def test_a_seam_needs_no_repair():
    positions, faces, normals, _ = shapes.split_seam(BALL)
    assert checked(positions, faces, normals=normals).repairs == {}


def test_a_sheet_with_faces_on_both_sides_has_unit_normals():
    sheet = shapes.square(1.0, 2)
    both = np.vstack([sheet.faces, sheet.faces[:, ::-1]])
    mesh = checked(sheet.positions, both)
    assert np.allclose(np.linalg.norm(mesh.normals, axis=1), 1.0)


def test_the_arrays_of_the_caller_are_unchanged():
    normals = BALL.normals.copy()
    normals[4] = np.nan
    kept = normals.copy()
    checked(normals=normals)
    assert np.array_equal(normals, kept, equal_nan=True)


# -- refusals --------------------------------------------------------------------------------------


def with_value(array, index, value):
    result = np.array(array, dtype=float)
    result[index] = value
    return result


FAULTS = {
    "no vertices": ({"positions": np.zeros((0, 3)), "faces": np.zeros((0, 3), int)}, "no vertices"),
    "no faces": ({"faces": np.zeros((0, 3), int)}, "no faces"),
    "nan": ({"positions": with_value(BALL.positions, (7, 1), np.nan)}, r"positions\[7, 1\] is nan"),
    "infinite": (
        {"positions": with_value(BALL.positions, (7, 1), np.inf)},
        r"positions\[7, 1\] is inf",
    ),
    "index too high": (
        {"faces": np.vstack([BALL.faces, [[0, 1, COUNT]]])},
        rf"faces\[320, 2\] is {COUNT}",
    ),
    "index negative": ({"faces": np.vstack([BALL.faces, [[0, -1, 2]]])}, r"faces\[320, 1\] is -1"),
    "fractional index": ({"faces": BALL.faces + 0.5}, "faces: type is float64"),
    "quadrilaterals": ({"faces": [[0, 1, 2, 3]]}, "faces: shape"),
    "ragged faces": ({"faces": [[0, 1, 2], [0, 1]]}, "faces"),
    "flat positions": ({"positions": BALL.positions[:, :2]}, "positions: shape"),
    "text": ({"positions": [["a", "b", "c"]]}, "positions: not an array of numbers"),
    "only lines": ({"faces": [[0, 0, 1], [2, 3, 3]]}, "no face has an area"),
    "normals of another count": ({"normals": BALL.normals[1:]}, "normals have shape"),
    "normals of text": ({"normals": [["a", "b", "c"]] * COUNT}, "normals"),
    "uvs of another count": ({"uvs": UVS[1:]}, "uvs: shape"),
    "uvs not finite": ({"uvs": with_value(UVS, (3, 0), np.nan)}, r"uvs\[3, 0\] is nan"),
    "attribute of another count": ({"attributes": {"mask": np.zeros(3)}}, "mask has shape"),
    "attribute not finite": (
        {"attributes": {"mask": with_value(np.zeros(COUNT), 5, np.inf)}},
        r"mask\[5\] is inf",
    ),
}


@pytest.mark.parametrize(("fault", "complaint"), FAULTS.values(), ids=FAULTS)
def test_a_fault_without_repair_is_refused_with_name_array_and_index(fault, complaint):
    with pytest.raises((MeshError, ArgumentError), match=complaint) as caught:
        checked(**fault)
    assert str(caught.value).startswith("head.glb: ")


@pytest.mark.parametrize("unit_mm", [0.0, -1.0, np.nan, np.inf, "cm", None])
def test_a_unit_that_is_no_positive_length_is_refused(unit_mm):
    with pytest.raises(UnitError, match=r"head\.glb"):
        checked(unit_mm=unit_mm)


@pytest.mark.parametrize("scale", [1e-200, 1e-90, 1e60, 1e90, 1e200, 1e300])
def test_extreme_sizes_are_refused_or_have_finite_normals(scale):
    try:
        mesh = checked(BALL.positions * scale)
    except InputError:
        return
    assert np.isfinite(mesh.normals).all()
    assert np.allclose(np.linalg.norm(mesh.normals, axis=1), 1.0)


# -- generated meshes ------------------------------------------------------------------------------

COORDINATES = (
    st.integers(-2, 2).map(float) | st.floats(-1e3, 1e3) | st.sampled_from([np.nan, np.inf])
)
MESHES = st.integers(1, 8).flatmap(
    lambda count: st.tuples(
        hnp.arrays(np.float64, (count, 3), elements=COORDINATES),
        hnp.arrays(
            np.int64, st.tuples(st.integers(0, 12), st.just(3)), elements=st.integers(-1, count)
        ),
        st.none() | hnp.arrays(np.float64, (count, 3), elements=COORDINATES),
        st.none() | hnp.arrays(np.float64, (count, 2), elements=COORDINATES),
    )
)
VALID_MESHES = st.integers(3, 9).flatmap(
    lambda count: st.tuples(
        hnp.arrays(np.float64, (count, 3), elements=st.integers(-2, 2).map(float)),
        hnp.arrays(
            np.int64, st.tuples(st.integers(1, 12), st.just(3)), elements=st.integers(0, count - 1)
        ),
        st.none() | hnp.arrays(np.float64, (count, 3), elements=st.floats(-2.0, 2.0)),
    )
)


def assert_usable(mesh):
    count = len(mesh.positions)
    assert len(mesh.faces) > 0
    assert set(mesh.faces.ravel()) == set(range(count))
    for array in (mesh.positions, mesh.normals, *([] if mesh.uvs is None else [mesh.uvs])):
        assert len(array) == count
        assert np.isfinite(array).all()
    assert np.allclose(np.linalg.norm(mesh.normals, axis=1), 1.0)
    corners = mesh.positions[mesh.faces]
    area = np.linalg.norm(
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
    )
    assert (area > 0.0).all()
    turned = [tuple(np.roll(face, -np.argmin(face))) for face in mesh.faces]
    assert len(set(turned)) == len(turned)
    assert all(times > 0 for times in mesh.repairs.values())


@given(MESHES)
def test_any_arrays_give_a_usable_mesh_or_an_input_error(arrays):
    positions, faces, normals, uvs = arrays
    try:
        mesh = checked(positions, faces, normals=normals, uvs=uvs)
    except InputError as error:
        assert str(error).startswith("head.glb: ")
        return
    assert_usable(mesh)


@given(VALID_MESHES)
def test_finite_triangles_give_a_usable_mesh_unless_none_has_an_area(arrays):
    positions, faces, normals = arrays
    corners = positions[faces]
    area = np.linalg.norm(
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
    )
    if not (area > 0.0).any():
        with pytest.raises(MeshError, match="no face has an area"):
            checked(positions, faces, normals=normals)
        return
    mesh = checked(positions, faces, normals=normals)
    assert_usable(mesh)
    assert mesh.repairs.get("faces without area dropped", 0) == (area == 0.0).sum()


@given(VALID_MESHES)
def test_a_checked_mesh_needs_no_further_repair(arrays):
    try:
        once = checked(arrays[0], arrays[1], normals=arrays[2])
    except MeshError:
        return
    twice = checked(once.positions, once.faces, normals=once.normals)
    assert not [key for key in twice.repairs if "dropped" in key or "computed" in key]
    assert np.array_equal(twice.faces, once.faces)


# -- texture coordinates ---------------------------------------------------------------------------


def test_flipping_uvs_reverses_v_and_is_its_own_inverse():
    mesh = checked(uvs=UVS)
    flipped = mesh.with_uvs_flipped()
    assert np.array_equal(flipped.uvs[:, 0], UVS[:, 0])
    assert np.allclose(flipped.uvs[:, 1], 1.0 - UVS[:, 1], rtol=0, atol=tol.ROUNDING.value)
    assert np.allclose(flipped.with_uvs_flipped().uvs, UVS, rtol=0, atol=tol.ROUNDING.value)
    assert np.array_equal(mesh.uvs, UVS)


def test_flipping_uvs_of_a_mesh_without_uvs_is_refused():
    with pytest.raises(MeshError, match="no UVs"):
        checked().with_uvs_flipped()


# -- vertices that keep their index ----------------------------------------------------------------


def test_unreferenced_vertices_can_be_kept():
    extra = np.array([[9.0, 9.0, 9.0]])
    positions = np.concatenate([extra, BALL.positions, extra])
    values = np.arange(COUNT + 2)
    mesh = checked(positions, BALL.faces + 1, attributes={"id": values}, keep_vertices=True)
    assert np.array_equal(mesh.positions, positions)
    assert np.array_equal(mesh.faces, BALL.faces + 1)
    assert np.array_equal(mesh.attributes["id"], values)
    assert mesh.repairs == {"normals computed": COUNT + 2}
    assert mesh.normals[[0, -1]].tolist() == [[0.0, 0.0, 1.0]] * 2
    dropped = checked(positions, BALL.faces + 1)
    assert np.allclose(mesh.normals[1:-1], dropped.normals, rtol=0, atol=tol.ROUNDING.value)


@given(VALID_MESHES)
def test_kept_vertices_do_not_change_the_faces(arrays):
    positions, faces, normals = arrays
    try:
        dropped = checked(positions, faces, normals=normals)
    except MeshError:
        with pytest.raises(MeshError, match="no face has an area"):
            checked(positions, faces, normals=normals, keep_vertices=True)
        return
    kept = checked(positions, faces, normals=normals, keep_vertices=True)
    assert np.array_equal(kept.positions, positions)
    assert np.array_equal(kept.positions[kept.faces], dropped.positions[dropped.faces])
    assert np.allclose(np.linalg.norm(kept.normals, axis=1), 1.0)


@given(
    hnp.arrays(np.int64, st.tuples(st.integers(1, 30), st.just(3)), elements=st.integers(0, 4)),
    st.sampled_from([5, 1 << 20, (1 << 21) - 1]),
)
def test_the_first_of_equal_faces_is_kept_for_any_number_of_vertices(triangles, vertex_count):
    first = first_of_equal(triangles, vertex_count)
    turned = [tuple(np.roll(face, -np.argmin(face))) for face in triangles]
    assert first.tolist() == sorted({face: turned.index(face) for face in turned}.values())
    assert np.array_equal(first, first_of_equal(triangles, 1 << 21))
