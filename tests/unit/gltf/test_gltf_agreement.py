"""`load_mesh`, a renderer and a bake place a glTF mesh at the same, analytic positions.

The models use the parts of the format that readers often lack: sparse accessors, skins whose node has
its own transform, triangle fans and strips.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field

import numpy as np
import pytest

import gltf_shapes
import skinshade as sk
from gltf_validator import validator_messages
from skinshade.baking import BakedAsset
from tolerances import FLOAT32_FILE, ROUNDING

IGNORED_TRANSFORM = Counter({"warning: NODE_SKINNED_MESH_LOCAL_TRANSFORMS": 1})
"""Warning of the validator about the transform of a skinned node, which has no effect."""


@dataclass(frozen=True)
class Case:
    """A model with its geometry according to the specification of glTF.

    Attributes
    ----------
    model
        The model.
    meshes
        Positions (V, 3), m, in the axes of each mesh, and triangles (F, 3).
    matrix
        (4, 4) from the axes of the meshes to those of the scene.
    warnings
        Warnings of the validator that the model provokes on purpose.
    """

    model: gltf_shapes.GltfModel
    meshes: list[tuple[np.ndarray, np.ndarray]]
    matrix: np.ndarray = field(default_factory=lambda: np.eye(4))
    warnings: Counter[str] = field(default_factory=Counter)

    def placed_mm(self, positions_m):
        return 1000.0 * (positions_m @ self.matrix[:3, :3].T + self.matrix[:3, 3])

    @property
    def positions_mm(self):
        """(V, 3) of all meshes in the scene."""
        return self.placed_mm(np.concatenate([positions for positions, _ in self.meshes]))

    @property
    def faces(self):
        """(F, 3) of all meshes."""
        starts = np.cumsum([0, *(len(positions) for positions, _ in self.meshes)])
        faces = [faces + start for (_, faces), start in zip(self.meshes, starts, strict=False)]
        return np.concatenate(faces)


# -- models ----------------------------------------------------------------------------------------


def sparse_over_a_base():
    """Ten positions of the base are wrong; a sparse accessor corrects them."""
    p, _, _, faces = gltf_shapes.sphere()
    return Case(gltf_shapes.sparse(), [(p, faces)])


def sparse_without_a_base():
    """The first vertex is the origin, the value that every element has without a base."""
    p, n, t, faces = gltf_shapes.sphere()
    p = (p - p[0]).astype("<f4")
    rows = np.arange(1, len(p))
    model = gltf_shapes.empty_model()
    indices = model.add_view(rows.astype("<u2").tobytes())
    sparse = {
        "count": len(rows),
        "indices": {"bufferView": indices, "componentType": gltf_shapes.CODES["u2"]},
        "values": {"bufferView": model.add_view(p[rows].tobytes())},
    }
    attributes = {
        "POSITION": model.add_accessor_entry(p, "f4", sparse=sparse),
        "NORMAL": model.add_accessor(n),
        "TEXCOORD_0": model.add_accessor(t),
    }
    model.add_mesh(gltf_shapes.primitive(model, faces, **attributes))
    return Case(model.with_nodes({"mesh": 0}), [(p, faces)])


def skinned():
    """The skin turns, moves and halves the mesh; the scale and translation of its node do not apply."""
    model = gltf_shapes.skinned()
    p, _, _, faces = gltf_shapes.sphere(0.16)
    mesh_node, root, _ = model.document["nodes"]
    mesh_node |= {"scale": [100.0, 100.0, 100.0], "translation": [7.0, 8.0, 9.0]}
    root |= {"rotation": [0.6, 0.0, 0.0, 0.8], "translation": [0.1, 0.2, -0.3]}
    matrix = np.eye(4)
    # The inverse bind matrices scale by 2, the root joint by 1/4. (0.6, 0, 0, 0.8) is a rotation
    # about x, whose cosine is 0.8² − 0.6² and whose sine is 2 · 0.6 · 0.8.
    matrix[:3, :3] = 0.5 * np.array([[1.0, 0.0, 0.0], [0.0, 0.28, -0.96], [0.0, 0.96, 0.28]])
    matrix[:3, 3] = 0.1, 0.2, -0.3
    return Case(model, [(p, faces)], matrix, IGNORED_TRANSFORM)


def fan():
    """A cap: its centre, and thirteen points of a circle."""
    around = np.arange(13) * (2.0 * np.pi / 12)
    x, y = 0.3 * np.cos(around), 0.3 * np.sin(around)
    rim = np.stack([x, y, np.full(13, np.sqrt(1.0 - 0.3**2))], axis=1)
    p = 0.08 * np.concatenate([[[0.0, 0.0, 1.0]], rim])
    return Case(gltf_shapes.fan(), [(p, np.array([[0, i, i + 1] for i in range(1, 13)]))])


def strips():
    """A band of two circles, as a strip without indices and as a strip with indices."""
    longitude, latitude = np.arange(25) * (2.0 * np.pi / 24), np.array([0.15, -0.15])
    phi, theta = (x.ravel() for x in np.meshgrid(longitude, latitude, indexing="ij"))
    x, y = np.cos(theta) * np.cos(phi), np.cos(theta) * np.sin(phi)
    p = 0.08 * np.stack([x, y, np.sin(theta)], axis=1)
    faces = np.array([[i, i + 1 + i % 2, i + 2 - i % 2] for i in range(48)])
    return Case(gltf_shapes.strips(), [(p, faces), (p, faces)])


BUILDERS = [sparse_over_a_base, sparse_without_a_base, skinned, fan, strips]
CASES = {build.__name__: build for build in BUILDERS}


@dataclass(frozen=True)
class Result:
    """Results for one case: the mesh as loaded, its prepared vertices, and bakes by suffix."""

    case: Case
    source: object
    loaded: sk.Mesh
    prepared: object
    baked: dict[str, BakedAsset]


@pytest.fixture(scope="module", params=list(CASES))
def result(request, tmp_path_factory):
    """A case as a GLB file, loaded, prepared for rendering, and baked."""
    name = request.param
    folder = tmp_path_factory.mktemp(name)
    case = CASES[name]()
    source = gltf_shapes.write(case.model, folder, stem=name)
    loaded = sk.load_mesh(source)
    scene = sk.Scene(loaded, sk.Camera((0.0, 0.0, 900.0), (0.0, 0.0, 0.0)), sk.Material())
    prepared = sk.open_renderer(scene, "cpu").prepared.vertices
    baked = {
        suffix: sk.bake(source, folder / f"out{suffix}") for suffix in (".glb", ".gltf", ".ply")
    }
    return Result(case, source, loaded, prepared, baked)


def assert_analytic(case, positions_mm, faces):
    """Assert the positions, up to the rounding of the file, and the exact triangles."""
    largest = np.abs(case.positions_mm).max()
    np.testing.assert_allclose(
        positions_mm, case.positions_mm, rtol=0.0, atol=FLOAT32_FILE.value * largest
    )
    np.testing.assert_array_equal(faces, case.faces)


def test_load_mesh_gives_the_analytic_positions(result):
    assert_analytic(result.case, result.loaded.positions_mm, result.loaded.faces)


def test_a_renderer_has_the_positions_of_load_mesh(result):
    assert_analytic(result.case, result.prepared.column("position"), result.prepared.faces)
    np.testing.assert_array_equal(result.prepared.column("position"), result.loaded.positions_mm)


@pytest.mark.parametrize("suffix", [".glb", ".gltf"])
def test_a_bake_to_gltf_analyses_each_mesh_at_its_size_in_the_scene(result, suffix):
    meshes = [baked.mesh for baked in result.baked[suffix].meshes]
    scale = np.cbrt(np.linalg.det(result.case.matrix[:3, :3]))
    for mesh, (positions, faces) in zip(meshes, result.case.meshes, strict=True):
        assert mesh.unit_mm == pytest.approx(1000.0 * scale, rel=FLOAT32_FILE.value)
        own = 1000.0 * scale * positions
        atol = FLOAT32_FILE.value * np.abs(own).max()
        np.testing.assert_allclose(mesh.positions_mm, own, rtol=0.0, atol=atol)
        np.testing.assert_array_equal(mesh.faces, faces)
    placed = result.case.placed_mm(np.concatenate([mesh.positions for mesh in meshes]))
    np.testing.assert_allclose(
        placed, result.loaded.positions_mm, rtol=0.0, atol=ROUNDING.value * np.abs(placed).max()
    )


def test_a_bake_to_ply_analyses_the_scene_of_load_mesh(result):
    (baked,) = result.baked[".ply"].meshes
    np.testing.assert_array_equal(baked.mesh.positions_mm, result.loaded.positions_mm)
    np.testing.assert_array_equal(baked.mesh.faces, result.loaded.faces)
    reloaded = sk.load_mesh(result.baked[".ply"].written[-1], unit_mm=1000.0)
    assert_analytic(result.case, reloaded.positions_mm, reloaded.faces)


@pytest.mark.parametrize("suffix", [".glb", ".gltf"])
def test_a_baked_file_is_reloaded_with_the_same_positions(result, suffix):
    reloaded = sk.load_mesh(result.baked[suffix].written[-1])
    np.testing.assert_array_equal(reloaded.positions_mm, result.loaded.positions_mm)
    np.testing.assert_array_equal(reloaded.faces, result.loaded.faces)
    baked = result.baked[suffix].meshes
    curvature = np.concatenate([mesh.analysis.attributes["curvature"] for mesh in baked])
    np.testing.assert_array_equal(reloaded.attributes["curvature"], curvature[:, 0].astype("f4"))


def test_khronos_accepts_the_source_and_the_baked_files(result):
    outputs = [result.baked[suffix].written[-1] for suffix in (".glb", ".gltf")]
    assert validator_messages(result.source, *outputs) == 3 * [result.case.warnings]
