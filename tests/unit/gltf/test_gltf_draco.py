"""Geometry compressed by Draco: a bake decodes it for the analysis and leaves it compressed."""

from __future__ import annotations

import numpy as np
import pytest

import shapes
from skinshade._core.errors import MeshFileError, SkinshadeError
from skinshade.baking import BakeSettings, bake
from skinshade.gltf import draco as module
from skinshade.gltf import read_gltf, read_mesh
from skinshade.gltf.accessors import read_accessor
from skinshade.gltf.write import glb_bytes
from skinshade.mesh import load_mesh

DracoPy = pytest.importorskip("DracoPy")

RADIUS_M = 0.02
SETTINGS = BakeSettings(tensor=True)
QUANTISED = 0.02
"""Relative error of curvature from positions of 14 bits and computed normals."""


def write_compressed(path, *, count=None, corrupt=False, kind="SCALAR"):
    """Write a sphere of 2 cm compressed as by an exporter; return it decoded, and its bytes."""
    sphere = shapes.sphere("icosphere", 3, RADIUS_M)
    data = DracoPy.encode(
        sphere.positions.astype(np.float64),
        sphere.faces.astype(np.uint32),
        quantization_bits=14,
        compression_level=5,
    )
    decoded = DracoPy.decode(data)
    (position,) = [entry for entry in decoded.attributes if entry["attribute_type"] == 0]
    vertices = len(decoded.points)
    if corrupt:
        data = data[: len(data) // 2] + bytes(len(data) - len(data) // 2)
    extension = {"bufferView": 0, "attributes": {"POSITION": position["unique_id"]}}
    document = {
        "asset": {"version": "2.0"},
        "extensionsUsed": ["KHR_draco_mesh_compression"],
        "extensionsRequired": ["KHR_draco_mesh_compression"],
        "nodes": [{"mesh": 0}],
        "meshes": [
            {
                "primitives": [
                    {
                        "attributes": {"POSITION": 0},
                        "indices": 1,
                        "extensions": {"KHR_draco_mesh_compression": extension},
                    }
                ]
            }
        ],
        "accessors": [
            {
                "componentType": 5126,
                "count": vertices if count is None else count,
                "type": "VEC3",
                "min": [-RADIUS_M] * 3,
                "max": [RADIUS_M] * 3,
            },
            {"componentType": 5125, "count": sphere.faces.size, "type": kind},
        ],
        "bufferViews": [{"buffer": 0, "byteLength": len(data)}],
        "buffers": [{"byteLength": len(data)}],
    }
    path.write_bytes(glb_bytes(document, data))
    return decoded, data


def test_a_compressed_sphere_has_the_curvature_of_a_sphere_and_stays_compressed(tmp_path):
    decoded, data = write_compressed(tmp_path / "ball.glb")
    baked = bake(tmp_path / "ball.glb", tmp_path / "out.glb", SETTINGS)
    curvature = baked.meshes[0].analysis.attributes["curvature"]
    assert np.abs(curvature * 1000.0 * RADIUS_M - 1.0).max() <= QUANTISED
    out = read_gltf(tmp_path / "out.glb")
    primitive = out.json["meshes"][0]["primitives"][0]
    assert primitive["extensions"]["KHR_draco_mesh_compression"]["bufferView"] == 0
    assert out.buffer(0, "test")[: len(data)] == data
    stored = read_accessor(out, primitive["attributes"]["_CURVATURE"], "test", width=1)
    assert len(stored) == len(decoded.points), "one value for each vertex, in decoding order"
    assert np.allclose(stored, curvature, rtol=1e-6)


def test_the_decoded_vertices_and_triangles_are_those_of_the_decoder(tmp_path):
    decoded, _ = write_compressed(tmp_path / "ball.glb")
    _, triangles = read_mesh(read_gltf(tmp_path / "ball.glb"), 0)
    np.testing.assert_array_equal(triangles.positions, decoded.points)
    np.testing.assert_array_equal(triangles.faces, decoded.faces)
    np.testing.assert_array_equal(load_mesh(tmp_path / "ball.glb").positions, decoded.points)


def test_without_the_decoder_the_error_states_what_to_install(tmp_path, monkeypatch):
    write_compressed(tmp_path / "ball.glb")
    monkeypatch.setattr(module, "find_spec", lambda name: None)
    with pytest.raises(
        MeshFileError, match=r"compressed by Draco: pip install \"skinshade\[draco\]\""
    ):
        bake(tmp_path / "ball.glb", tmp_path / "out.glb", SETTINGS)
    assert not (tmp_path / "out.glb").exists()


@pytest.mark.parametrize(
    ("fault", "message"),
    [
        ({"corrupt": True}, "Draco cannot decode it|Draco returns|after decoding"),
        ({"count": 7}, "not 7"),
    ],
    ids=["corrupt", "wrong count"],
)
def test_data_that_contradicts_the_document_is_refused(tmp_path, fault, message):
    write_compressed(tmp_path / "ball.glb", **fault)
    with pytest.raises(MeshFileError, match=message):
        bake(tmp_path / "ball.glb", tmp_path / "out.glb", SETTINGS)


@pytest.mark.parametrize(
    "extension", [None, {}, {"attributes": {}}, {"bufferView": 9, "attributes": {}}]
)
def test_the_error_of_a_malformed_extension_names_the_file(tmp_path, extension):
    write_compressed(tmp_path / "ball.glb")
    gltf = read_gltf(tmp_path / "ball.glb")
    primitive = gltf.json["meshes"][0]["primitives"][0]
    primitive["extensions"]["KHR_draco_mesh_compression"] = extension
    (tmp_path / "bad.glb").write_bytes(glb_bytes(gltf.json, gltf.buffer(0, "test")))
    with pytest.raises(MeshFileError, match=r"bad\.glb"):
        bake(tmp_path / "bad.glb", tmp_path / "out.glb", SETTINGS)
    assert not (tmp_path / "out.glb").exists()


def test_corrupt_bytes_raise_an_error_of_skinshade_or_give_finite_values(tmp_path):
    write_compressed(tmp_path / "ball.glb")
    whole = (tmp_path / "ball.glb").read_bytes()
    start, rng = whole.find(b"DRACO"), np.random.default_rng(5)
    outcomes = set()
    for _ in range(150):
        corrupt = bytearray(whole)
        for index in rng.integers(start, len(whole), rng.integers(1, 6)):
            corrupt[index] = rng.integers(256)
        (tmp_path / "bad.glb").write_bytes(corrupt)
        try:
            baked = bake(tmp_path / "bad.glb", tmp_path / "out.glb", BakeSettings())
        except SkinshadeError:
            outcomes.add("refused")
            continue
        outcomes.add("baked")
        assert np.isfinite(baked.meshes[0].analysis.attributes["curvature"]).all()
    assert outcomes == {"refused", "baked"}
