from importlib.resources import files

import numpy as np
import pytest
from scipy.spatial import cKDTree

import shading_tolerances as tol
from skinshade._core.errors import ArgumentError
from skinshade.heads import Head, builtin_head
from skinshade.mesh.topology import weld
from skinshade.rendering.prepare.rasterizer import rasterize

GLB = files("skinshade.heads").joinpath("assets/head.glb")


@pytest.fixture(scope="module")
def head():
    return builtin_head()


def test_the_file_of_the_head_is_at_most_a_megabyte():
    assert len(GLB.read_bytes()) <= 1_000_000


def test_the_head_is_read_once():
    assert isinstance(builtin_head(), Head)
    assert builtin_head() is builtin_head()


@pytest.mark.parametrize("seed", [-1, 0.5, None])
def test_a_seed_that_is_no_whole_number_is_an_error_that_names_it(seed):
    with pytest.raises(ArgumentError, match=f"seed is {seed}; it must be a whole number, 0 or mo"):
        builtin_head(seed)


# -- the mesh --------------------------------------------------------------------------------------


def test_the_mesh_needs_no_repair_and_is_closed_when_its_seams_are_welded(head):
    mesh = head.mesh
    assert mesh.repairs == {}
    group, first = weld(mesh.positions)
    faces = group[mesh.faces]
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    assert len(np.unique(edges, axis=0)) == len(edges), "every edge once in each direction"
    assert np.array_equal(np.unique(edges, axis=0), np.unique(edges[:, ::-1], axis=0))
    assert first.size - len(edges) // 2 + len(faces) == 2, "Euler characteristic of a sphere"
    p = mesh.positions_mm[mesh.faces]
    volume = np.einsum("ij,ij->i", p[:, 0], np.cross(p[:, 1], p[:, 2])).sum() / 6.0
    assert 3e6 < volume < 8e6, "mm³; positive, so that faces point outwards"


def test_the_mesh_has_the_size_of_an_adult_head(head):
    low, high = (f(head.mesh.positions_mm, axis=0) for f in (np.min, np.max))
    width, height, depth = high - low
    assert 150.0 < width < 190.0, "ear to ear"
    assert 180.0 < depth < 230.0
    assert 250.0 < height < 350.0, "with its neck"
    assert high[2] > -low[2], "the nose points to +z"


def test_normals_are_unit_vectors_on_the_outer_side_of_their_faces(head):
    mesh = head.mesh
    assert np.abs(np.linalg.norm(mesh.normals, axis=1) - 1.0).max() <= tol.ROUNDING.value
    p = mesh.positions[mesh.faces]
    face_normals = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
    agree = np.einsum("fk,fik->fi", face_normals, mesh.normals[mesh.faces]) > 0.0
    assert agree.mean() >= 1.0 - tol.FOLDED_CORNERS.value


def test_both_halves_of_the_face_are_nearly_mirror_images(head):
    p = head.mesh.positions_mm
    distance, _ = cKDTree(p).query(p * (-1.0, 1.0, 1.0))
    assert distance.max() <= tol.FACE_HALVES_MM.value


def test_weights_of_regions_lie_between_0_and_1(head):
    regions = head.mesh.attributes["_REGION"]
    assert regions.shape == (len(head.mesh.positions), 4)
    assert regions.min() == 0.0
    assert 0.5 < regions.max() <= 1.0


def test_uvs_lie_within_the_texture_and_charts_are_neither_mirrored_nor_overlapping(head):
    mesh = head.mesh
    assert mesh.uvs.min() >= 0.0
    assert mesh.uvs.max() <= 1.0
    q = mesh.uvs[mesh.faces]
    d1, d2 = q[:, 1] - q[:, 0], q[:, 2] - q[:, 0]
    area = 0.5 * (d1[:, 0] * d2[:, 1] - d1[:, 1] * d2[:, 0])
    assert area.max() < 0.0, "v counts down, so that an unmirrored chart is clockwise"
    assert 0.5 < -area.sum() < 1.0
    depth_and_w = np.tile([0.0, 1.0], (len(mesh.uvs), 1))
    clip = np.concatenate([2.0 * mesh.uvs - 1.0, depth_and_w], axis=1)
    covered = rasterize(clip, mesh.faces, (512, 512)).pixel.size / 512.0**2
    assert covered == pytest.approx(-area.sum(), abs=tol.CHART_AREA.value)


# -- the maps --------------------------------------------------------------------------------------


def test_maps_hold_reflectances_unit_normals_and_gloss_in_range(head):
    skin = head.material
    assert skin.albedo.shape[:2] == skin.normal.shape[:2] == (2048, 2048)
    assert skin.specular.shape[:2] == skin.deep_scatter.shape[:2] == (1024, 1024)
    for name in ("albedo", "deep_scatter"):
        image = getattr(skin, name)
        assert image.min() >= 0.0
        assert image.max() <= 1.0
        red, green, blue = image.reshape(-1, 3).mean(axis=0)
        assert red > green > blue, "the order of skin, and of blood"
    length = np.linalg.norm(skin.normal, axis=2)
    assert np.abs(length - 1.0).max() <= tol.FLOAT32.value
    assert skin.normal[..., 2].min() > 0.5
    assert 0.0 <= skin.specular[..., 1].min() <= skin.specular[..., 1].max() <= 1.0
    assert 0.2 < skin.specular[..., 0].min() < 1.0 < skin.specular[..., 0].max() < 3.0
