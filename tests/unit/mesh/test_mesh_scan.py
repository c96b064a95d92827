"""The scanned head: known counts and size, and the same surface from two files."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

import shapes
import tolerances as tol
from skinshade._core.errors import UnitError, UnitWarning
from skinshade.mesh import (
    Mesh,
    diffuse_on_mesh,
    load_mesh,
    mesh_curvature,
    mesh_uv_scale,
)
from skinshade.mesh.shape_operator import ShapeOperator
from skinshade.mesh.topology import weld

SIZE_MM = (430.0, 400.0, 261.0)


@pytest.fixture(scope="module")
def glb(data_dir) -> Mesh:
    return load_mesh(data_dir / "lps" / "LeePerrySmith.glb", unit_mm=50.35)


@pytest.fixture(scope="module")
def obj(data_dir) -> Mesh:
    return load_mesh(data_dir / "lps" / "head.obj", unit_mm=10.0)


def centred(mesh):
    p = mesh.positions_mm
    return p - 0.5 * (p.min(axis=0) + p.max(axis=0))


def test_the_scan_has_its_known_counts_and_size(glb):
    assert glb.positions.shape == (9279, 3)
    assert glb.faces.shape == (17_684, 3)
    assert glb.repairs == {}
    assert glb.uvs is not None
    extent = np.ptp(glb.positions_mm, axis=0)
    assert np.abs(extent - SIZE_MM).max() <= tol.SCAN_SIZE_MM.value


def test_both_files_hold_the_same_surface(glb, obj):
    assert len(obj.faces) == len(glb.faces)
    extent = np.ptp(obj.positions_mm, axis=0) - np.ptp(glb.positions_mm, axis=0)
    assert np.abs(extent).max() <= tol.SCAN_FILES_AGREE_MM.value
    distance, _ = cKDTree(centred(glb)).query(centred(obj))
    assert distance.max() <= tol.SCAN_FILES_AGREE_MM.value
    assert weld(glb.positions)[1].size == weld(obj.positions)[1].size == 8844


def test_both_files_have_uvs_of_equal_scale(glb, obj):
    assert obj.uvs is not None
    scales = [mesh_uv_scale(mesh.positions_mm, mesh.uvs, mesh.faces) for mesh in (glb, obj)]
    assert scales[1] == pytest.approx(scales[0], rel=0.02)


def test_both_files_have_the_same_curvature(glb, obj):
    one = mesh_curvature(glb.positions_mm, glb.faces)
    other = mesh_curvature(obj.positions_mm, obj.faces)
    _, index = cKDTree(centred(glb)).query(centred(obj))
    assert np.corrcoef(one[index], other)[0, 1] >= tol.SCAN_CORRELATION.value
    scale = np.sqrt(np.mean(np.square(other)))
    percent = np.arange(2, 99)
    gap = np.percentile(one[index], percent) - np.percentile(other, percent)
    assert np.abs(gap).max() <= tol.SCAN_CURVATURE.value * scale


def test_the_curvature_of_the_scan_is_plausible_for_a_head(glb):
    curvature = mesh_curvature(glb.positions_mm, glb.faces, glb.normals)
    assert np.isfinite(curvature).all()
    # Concave as a nostril, convex as the rim of an ear, and half of the head as flat as a brow.
    low, middle, high = np.percentile(curvature, [1, 50, 99])
    assert -1.0 < low < -0.1
    assert 0.0 < middle < 0.02
    assert 0.1 < high < 1.0


def test_the_bounds_of_the_fit_reduce_three_vertices_of_the_scan(glb, obj):
    # With the stored normals, the fit at these vertices exceeds 4 over their shortest edge: 57 per mm at one.
    assert ShapeOperator.fit(glb.positions_mm, glb.faces, glb.normals).bounded_vertices == 3
    for mesh, normals in ((glb, None), (obj, obj.normals), (obj, None)):
        assert ShapeOperator.fit(mesh.positions_mm, mesh.faces, normals).bounded_vertices == 0


def test_vertices_split_at_seams_have_equal_curvature(glb):
    group, first = weld(glb.positions)
    curvature = mesh_curvature(glb.positions_mm, glb.faces, glb.normals)
    assert len(first) < len(group)
    assert np.array_equal(curvature, curvature[first][group])


def test_curvature_by_computed_normals_is_near_that_by_stored_normals(glb):
    own = mesh_curvature(glb.positions_mm, glb.faces)
    given = mesh_curvature(glb.positions_mm, glb.faces, glb.normals)
    assert shapes.relative_rms(own, given) < 0.5


def test_diffused_normals_of_the_scan_are_shorter_at_high_curvature(glb, deon):
    diffused = diffuse_on_mesh(glb.positions_mm, glb.faces, glb.normals, deon, tolerance=1e-4)
    normals = np.swapaxes(diffused, 1, 2)
    length = np.linalg.norm(normals, axis=-1)
    assert np.isfinite(normals).all()
    curvature = np.abs(mesh_curvature(glb.positions_mm, glb.faces, glb.normals))
    flat, sharp = curvature < np.percentile(curvature, 20), curvature > np.percentile(curvature, 95)
    assert np.median(length[flat], axis=0).min() > 0.995
    assert np.median(length[sharp][:, 0]) < 0.9
    assert (np.median(length[sharp], axis=0)[:-1] < np.median(length[sharp], axis=0)[1:]).all()


def test_the_scan_in_metres_is_implausibly_large_and_warns(data_dir):
    with pytest.warns(
        UnitWarning, match=r"in metres, the unit of glTF, the object is 12\.8 m across"
    ):
        load_mesh(data_dir / "lps" / "LeePerrySmith.glb")


def test_the_obj_of_the_scan_needs_unit_mm(data_dir):
    with pytest.raises(UnitError, match="states no unit; give unit_mm"):
        load_mesh(data_dir / "lps" / "head.obj")
