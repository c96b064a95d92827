"""Doubled faces: one side is kept, and the analysis is that of the single-sided mesh."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import shapes
import tolerances as tol
from skinshade._core.errors import MeshError
from skinshade.mesh import Mesh, mesh_curvature, mesh_curvature_tensor, mesh_thickness
from skinshade.mesh.diffusion import diffuse_on_mesh
from skinshade.mesh.tensors import tensor_to_world
from skinshade.mesh.topology import weld

DOUBLED = "faces doubled with opposite winding dropped"
BALL = shapes.sphere("icosphere", 2, 20.0)
BODY = shapes.ellipsoid("icosphere", 3, (30.0, 20.0, 12.0))
SHEET = shapes.square(3.0, 8)
BODIES = {"ball": BALL, "ellipsoid": BODY, "open sheet": SHEET}
EVERY_BODY = pytest.mark.parametrize("shape", BODIES.values(), ids=BODIES)


def two_sided(shape):
    """Return a mesh whose faces all have a second side with separate vertices and opposite normals."""
    count = len(shape.positions)
    return {
        "positions": np.concatenate([shape.positions, shape.positions]),
        "faces": np.concatenate([shape.faces, shape.faces[:, ::-1] + count]),
        "normals": np.concatenate([shape.normals, -shape.normals]),
    }


def checked(positions, faces, **options):
    return Mesh.checked(positions, faces, unit_mm=1.0, **options)


def repairs_of(mesh):
    return {key: count for key, count in mesh.repairs.items() if "dropped" in key}


# -- repair ----------------------------------------------------------------------------------------


@EVERY_BODY
def test_the_second_side_of_every_face_is_dropped_with_its_vertices(shape):
    mesh = checked(**two_sided(shape))
    assert repairs_of(mesh) == {
        DOUBLED: len(shape.faces),
        "unreferenced vertices dropped": len(shape.positions),
    }
    single = checked(shape.positions, shape.faces, normals=shape.normals)
    assert np.array_equal(mesh.faces, single.faces)
    assert np.array_equal(mesh.normals, single.normals)
    edges = {key: count for key, count in mesh.repairs.items() if "edges" in key}
    assert edges == single.repairs


def test_a_second_side_with_the_same_vertices_is_dropped():
    faces = np.concatenate([BALL.faces, np.roll(BALL.faces[:, ::-1], 1, axis=1)])
    mesh = checked(BALL.positions, faces, normals=BALL.normals)
    assert mesh.repairs == {DOUBLED: len(BALL.faces)}
    assert np.array_equal(mesh.faces, BALL.faces)


def test_only_the_doubled_faces_of_a_mesh_are_dropped():
    faces = np.concatenate([BALL.faces, BALL.faces[[5, 70], ::-1]])
    mesh = checked(BALL.positions, faces, normals=BALL.normals)
    assert mesh.repairs == {DOUBLED: 2}
    assert np.array_equal(mesh.faces, BALL.faces)


def test_a_single_triangle_with_two_sides_keeps_the_first():
    mesh = checked(np.eye(3), [[0, 1, 2], [2, 1, 0]])
    assert mesh.faces.tolist() == [[0, 1, 2]]
    assert mesh.repairs[DOUBLED] == 1
    assert mesh.repairs["open edges"] == 3


def test_faces_of_equal_winding_and_separate_vertices_are_kept():
    count = len(BALL.positions)
    positions = np.concatenate([BALL.positions, BALL.positions])
    mesh = checked(positions, np.concatenate([BALL.faces, BALL.faces + count]))
    assert repairs_of(mesh) == {}
    assert len(mesh.faces) == 2 * len(BALL.faces)


def test_of_three_faces_at_the_same_positions_those_of_the_first_winding_are_kept():
    positions = np.concatenate([np.eye(3)] * 3)
    mesh = checked(positions, [[0, 1, 2], [4, 3, 5], [7, 8, 6]])
    assert mesh.positions[mesh.faces].tolist() == [
        np.eye(3).tolist(),
        np.eye(3)[[1, 2, 0]].tolist(),
    ]
    assert repairs_of(mesh) == {DOUBLED: 1, "unreferenced vertices dropped": 3}


# -- choice of the side ----------------------------------------------------------------------------


def inside_first(shape):
    return np.concatenate([shape.faces[:, ::-1], shape.faces])


def test_of_a_closed_body_the_outside_is_kept_also_if_the_inside_comes_first():
    mesh = checked(BODY.positions, inside_first(BODY), normals=BODY.normals)
    assert np.array_equal(mesh.faces, BODY.faces)
    assert mesh.repairs == {DOUBLED: len(BODY.faces)}


def test_the_outside_is_kept_for_a_body_far_from_the_origin():
    mesh = checked(BODY.positions + 1e6, inside_first(BODY), normals=BODY.normals)
    assert np.array_equal(mesh.faces, BODY.faces)


def test_of_an_open_sheet_the_first_side_is_kept():
    mesh = checked(SHEET.positions, inside_first(SHEET), normals=SHEET.normals)
    assert np.array_equal(mesh.faces, SHEET.faces[:, ::-1])


def test_the_first_side_is_kept_unless_every_face_is_doubled():
    faces = np.concatenate([BODY.faces[:, ::-1], BODY.faces[1:]])
    mesh = checked(BODY.positions, faces, normals=BODY.normals)
    assert np.array_equal(mesh.faces, BODY.faces[:, ::-1])


def test_the_first_side_is_kept_if_the_first_sides_do_not_agree():
    turned = BODY.faces.copy()
    turned[::2] = turned[::2, ::-1]
    mesh = checked(BODY.positions, np.concatenate([turned, turned[:, ::-1]]))
    assert np.array_equal(mesh.faces, turned)


# -- analysis --------------------------------------------------------------------------------------


@EVERY_BODY
@pytest.mark.parametrize("smoothing", [0, 2])
def test_the_curvature_at_both_sides_is_that_of_the_single_sided_mesh(shape, smoothing):
    mesh = checked(**two_sided(shape), keep_vertices=True)
    assert repairs_of(mesh) == {DOUBLED: len(shape.faces)}
    single = checked(shape.positions, shape.faces, normals=shape.normals)
    scale = 1.0 / np.ptp(shape.positions, axis=0).max()
    accuracy = tol.ROUNDING_SUMS.value * scale
    mean, once = (
        mesh_curvature(m.positions, m.faces, m.normals, smoothing=smoothing) for m in (mesh, single)
    )
    assert np.abs(mean.reshape(2, -1) - once).max() <= accuracy
    both, single_tensor = (
        tensor_to_world(
            mesh_curvature_tensor(m.positions, m.faces, m.normals, smoothing=smoothing), m.normals
        )
        for m in (mesh, single)
    )
    assert np.abs(both.reshape(2, -1, 6) - single_tensor).max() <= accuracy


def test_the_curvature_of_a_two_sided_sphere_is_that_of_the_sphere():
    mesh = checked(**two_sided(BALL), keep_vertices=True)
    curvature = mesh_curvature(mesh.positions, mesh.faces, mesh.normals)
    assert np.abs(curvature * 20.0 - 1.0).max() <= tol.SPHERE_CURVATURE.value


@EVERY_BODY
@pytest.mark.parametrize("tracing", ["builtin", "auto"])
def test_the_thickness_at_both_sides_is_that_of_the_single_sided_mesh(shape, tracing):
    mesh = checked(**two_sided(shape), keep_vertices=True)
    both = mesh_thickness(mesh.positions, mesh.faces, mesh.normals, rays=8, tracing=tracing)
    once = mesh_thickness(shape.positions, shape.faces, shape.normals, rays=8, tracing=tracing)
    size = np.ptp(shape.positions, axis=0).max()
    assert np.abs(both.reshape(2, -1) - once).max() <= tol.ROUNDING_SUMS.value * size


def test_unused_vertices_away_from_the_body_have_the_thickness_of_their_own_rays():
    positions = np.vstack([BALL.positions, [[0.0, 0.0, 0.0]]])
    normals = np.vstack([BALL.normals, [[0.0, 0.0, 1.0]]])
    thickness = mesh_thickness(positions, BALL.faces, normals, rays=8, tracing="builtin")
    once = mesh_thickness(BALL.positions, BALL.faces, BALL.normals, rays=8, tracing="builtin")
    assert np.allclose(thickness[:-1], once, rtol=tol.ROUNDING_SUMS.value)
    assert 0.5 * 20.0 < thickness[-1] < 20.0


def test_diffusion_leaves_out_the_values_of_unused_vertices(deon):
    mesh = checked(**two_sided(BALL), keep_vertices=True)
    both = diffuse_on_mesh(mesh.positions, mesh.faces, mesh.normals, deon)
    once = diffuse_on_mesh(BALL.positions, BALL.faces, BALL.normals, deon)
    assert np.abs(both.reshape(2, *once.shape) - once).max() <= tol.ROUNDING_SUMS.value


# -- generated meshes ------------------------------------------------------------------------------


@given(
    hnp.arrays(np.float64, (8, 3), elements=st.integers(0, 1).map(float)),
    hnp.arrays(np.int64, st.tuples(st.integers(1, 20), st.just(3)), elements=st.integers(0, 7)),
)
def test_no_face_remains_with_the_corners_of_another_and_the_opposite_winding(positions, faces):
    try:
        mesh = checked(positions, faces)
    except MeshError:
        return
    group, _ = weld(mesh.positions)
    turned = {tuple(np.roll(face, -np.argmin(face))) for face in group[mesh.faces].tolist()}
    assert not turned & {(a, c, b) for a, b, c in turned}
