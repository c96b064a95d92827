"""Invariances of curvature, and the arguments that it refuses."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import shapes
import tolerances as tol
from skinshade._core.errors import ArgumentError
from skinshade.mesh import mesh_curvature, mesh_curvature_tensor

ELLIPSOID = shapes.ellipsoid("random", 600, (3.0, 2.0, 1.0))
TORUS = shapes.torus("regular", 36)
METHODS = pytest.mark.parametrize("method", ["shape-operator", "edges"])
ANGLES = st.tuples(*[st.floats(-np.pi, np.pi)] * 3)


def assert_same(a, b, scale):
    assert np.abs(a - b).max() <= tol.ROTATION.value * scale


@METHODS
@pytest.mark.parametrize("shape", [ELLIPSOID, TORUS], ids=["ellipsoid", "torus"])
@settings(max_examples=20)
@given(ANGLES, st.tuples(*[st.floats(-5.0, 5.0)] * 3), st.booleans())
def test_curvature_is_invariant_under_rigid_motion(shape, method, angles, shift, own):
    turn = Rotation.from_euler("xyz", angles).as_matrix()
    normals = None if own else shape.normals
    moved_normals = None if own else shape.normals @ turn.T
    before = mesh_curvature(shape.positions, shape.faces, normals, method=method)
    after = mesh_curvature(
        shape.positions @ turn.T + shift, shape.faces, moved_normals, method=method
    )
    # Computed normals come from a fit whose frame turns with the mesh, which amplifies rounding.
    assert_same(after, before, np.abs(before).max() * (100.0 if own else 1.0))


@METHODS
@given(st.floats(1e-4, 1e4))
def test_curvature_scales_with_one_over_length(method, factor):
    before = mesh_curvature(ELLIPSOID.positions, ELLIPSOID.faces, ELLIPSOID.normals, method=method)
    after = mesh_curvature(
        ELLIPSOID.positions * factor, ELLIPSOID.faces, ELLIPSOID.normals, method=method
    )
    assert_same(after * factor, before, np.abs(before).max())


def test_reversed_faces_and_normals_negate_the_curvature():
    for shape in (ELLIPSOID, TORUS):
        outside = mesh_curvature(shape.positions, shape.faces, shape.normals)
        inside = mesh_curvature(shape.positions, shape.faces[:, ::-1], -shape.normals)
        assert_same(inside, -outside, np.abs(outside).max())
        own = mesh_curvature(shape.positions, shape.faces)
        own_inside = mesh_curvature(shape.positions, shape.faces[:, ::-1])
        assert_same(own_inside, -own, np.abs(own).max())


@given(st.randoms(use_true_random=False))
def test_the_order_of_vertices_and_faces_does_not_matter(random):
    order = list(range(len(TORUS.positions)))
    random.shuffle(order)
    new_index = np.argsort(order)
    faces = new_index[TORUS.faces]
    rows = list(range(len(faces)))
    random.shuffle(rows)
    before = mesh_curvature(TORUS.positions, TORUS.faces, TORUS.normals)
    after = mesh_curvature(TORUS.positions[order], faces[rows], TORUS.normals[order])
    assert_same(after, before[order], np.abs(before).max())


@pytest.mark.parametrize("with_normals", [True, False])
@pytest.mark.parametrize("smoothing", [0, 3])
def test_vertices_split_at_a_seam_have_the_curvature_of_the_unsplit_mesh(with_normals, smoothing):
    for shape in (ELLIPSOID, TORUS):
        positions, faces, normals, original = shapes.split_seam(shape)
        whole = mesh_curvature(
            shape.positions,
            shape.faces,
            shape.normals if with_normals else None,
            smoothing=smoothing,
        )
        split = mesh_curvature(
            positions, faces, normals if with_normals else None, smoothing=smoothing
        )
        assert_same(split, whole[original], np.abs(whole).max())


def test_the_length_of_the_normals_does_not_matter():
    before = mesh_curvature(TORUS.positions, TORUS.faces, TORUS.normals)
    after = mesh_curvature(TORUS.positions, TORUS.faces, 7.0 * TORUS.normals)
    assert_same(after, before, np.abs(before).max())


# -- faults ----------------------------------------------------------------------------------------

TETRAHEDRON = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
TETRAHEDRON_FACES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
EVERY_MEASURE = pytest.mark.parametrize(
    "measure",
    [
        mesh_curvature,
        lambda *a, **k: mesh_curvature(*a, method="edges", **k),
        mesh_curvature_tensor,
    ],
    ids=["shape-operator", "edges", "tensor"],
)


@EVERY_MEASURE
@pytest.mark.parametrize(
    ("positions", "faces", "complaint"),
    [
        (np.zeros((0, 3)), np.zeros((0, 3), int), "positions: there are no vertices"),
        (TETRAHEDRON, np.zeros((0, 3), int), "faces: there are no faces"),
        (TETRAHEDRON, TETRAHEDRON_FACES + 1, r"faces\[1, 2\] is 4"),
        (TETRAHEDRON, TETRAHEDRON_FACES - 1, r"faces\[0, 0\] is -1"),
        (
            np.where(TETRAHEDRON == 1.0, np.nan, TETRAHEDRON),
            TETRAHEDRON_FACES,
            r"positions\[1, 0\] is nan",
        ),
        (
            np.where(TETRAHEDRON == 1.0, np.inf, TETRAHEDRON),
            TETRAHEDRON_FACES,
            r"positions\[1, 0\] is inf",
        ),
        (TETRAHEDRON[:, :2], TETRAHEDRON_FACES, "positions: shape"),
        (TETRAHEDRON, TETRAHEDRON_FACES[:, :2], "faces: shape"),
        (TETRAHEDRON, TETRAHEDRON_FACES * 1.0, "faces: type"),
    ],
)
def test_a_malformed_mesh_is_refused(measure, positions, faces, complaint):
    with pytest.raises(ArgumentError, match=complaint):
        measure(positions, faces)


@EVERY_MEASURE
@pytest.mark.parametrize("normals", [np.zeros((3, 3)), np.full((4, 3), np.nan), np.zeros((4, 2))])
def test_malformed_normals_are_refused(measure, normals):
    with pytest.raises(ArgumentError, match="normals"):
        measure(TETRAHEDRON, TETRAHEDRON_FACES, normals)


@EVERY_MEASURE
@pytest.mark.parametrize("smoothing", [-1, 101])
def test_passes_outside_0_to_100_are_refused(measure, smoothing):
    with pytest.raises(ArgumentError, match=f"smoothing is {smoothing}"):
        measure(TETRAHEDRON, TETRAHEDRON_FACES, smoothing=smoothing)


def test_an_unknown_method_is_refused_with_the_choices():
    with pytest.raises(ArgumentError, match="method is 'curl'; it must be shape-operator or edges"):
        mesh_curvature(TETRAHEDRON, TETRAHEDRON_FACES, method="curl")


DEFECTS = {
    "a vertex that no face uses": ([[5.0, 5, 5]], np.zeros((0, 3), int)),
    "a face that is one vertex": ([[5.0, 5, 5]], [[4, 4, 4]]),
    "a face that is one point": ([[5.0, 5, 5]] * 3, [[4, 5, 6]]),
    "a face that is a line": ([[5.0, 5, 5], [6, 6, 6], [7, 7, 7]], [[4, 5, 6]]),
    "a zero-length edge beside the others": ([[1.0, 0, 0]], [[1, 4, 2]]),
}


@EVERY_MEASURE
@pytest.mark.parametrize(("more", "extra"), DEFECTS.values(), ids=DEFECTS)
@pytest.mark.parametrize("smoothing", [0, 2])
@pytest.mark.parametrize("with_normals", [False, True])
def test_curvature_is_finite_on_meshes_with_defects(measure, more, extra, smoothing, with_normals):
    positions = np.vstack([TETRAHEDRON, more])
    faces = np.vstack([TETRAHEDRON_FACES, extra])
    normals = positions - 0.25 if with_normals else None
    try:
        result = measure(positions, faces, normals, smoothing=smoothing)
    except ArgumentError:
        return
    assert np.isfinite(result).all()
    sound = measure(
        TETRAHEDRON,
        TETRAHEDRON_FACES,
        None if normals is None else normals[:4],
        smoothing=smoothing,
    )
    assert np.abs(result[0] - sound[0]).max() <= 0.5 * np.abs(sound[0]).max()
