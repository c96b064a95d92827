"""Geometry compressed by Draco: decoded for the analysis, and left as it is in the file."""

from __future__ import annotations

import numpy as np
import pytest

import shapes
from skinshade._core.errors import MeshFileError, SkinshadeError
from skinshade.bake import BakeSettings, bake
from skinshade.bake import draco as module
from skinshade.bake.accessors import read_accessor
from skinshade.bake.gltf import glb_bytes, read_gltf

DracoPy = pytest.importorskip("DracoPy")

RADIUS_M = 0.02
SETTINGS = BakeSettings(tensor=True)
QUANTISED = 0.02
"""Relative error of curvature from positions of 14 bits and computed normals."""


def compressed(path, *, count=None, spoil=False, kind="SCALAR"):
    """A sphere of 2 cm, as an exporter would compress it."""
    ball = shapes.sphere("icosphere", 3, RADIUS_M)
    data = DracoPy.encode(
        ball.positions.astype(np.float64),
        ball.faces.astype(np.uint32),
        quantization_bits=14,
        compression_level=5,
    )
    held = DracoPy.decode(data)
    (places,) = [each for each in held.attributes if each["attribute_type"] == 0]
    vertices = len(held.points)
    if spoil:
        data = data[: len(data) // 2] + bytes(len(data) - len(data) // 2)
    described = {"bufferView": 0, "attributes": {"POSITION": places["unique_id"]}}
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
                        "extensions": {"KHR_draco_mesh_compression": described},
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
            {"componentType": 5125, "count": ball.faces.size, "type": kind},
        ],
        "bufferViews": [{"buffer": 0, "byteLength": len(data)}],
        "buffers": [{"byteLength": len(data)}],
    }
    path.write_bytes(glb_bytes(document, data))
    return held, data


def test_a_compressed_ball_has_the_curvature_of_a_ball_and_stays_compressed(tmp_path):
    held, data = compressed(tmp_path / "ball.glb")
    baked = bake(tmp_path / "ball.glb", tmp_path / "out.glb", SETTINGS)
    curvature = baked.meshes[0].analysed.attributes["curvature"]
    assert np.abs(curvature * 1000.0 * RADIUS_M - 1.0).max() <= QUANTISED
    out = read_gltf(tmp_path / "out.glb")
    primitive = out.document["meshes"][0]["primitives"][0]
    assert primitive["extensions"]["KHR_draco_mesh_compression"]["bufferView"] == 0
    assert out.buffer(0, "test")[: len(data)] == data
    stored = read_accessor(out, primitive["attributes"]["_CURVATURE"], "test", width=1)
    assert len(stored) == len(held.points), "in the order in which it decodes"
    assert np.allclose(stored, curvature, rtol=1e-6)


def test_without_the_decoder_the_error_says_what_to_install(tmp_path, monkeypatch):
    compressed(tmp_path / "ball.glb")
    monkeypatch.setattr(module, "find_spec", lambda name: None)
    with pytest.raises(
        MeshFileError, match=r"compressed by Draco: pip install \"skinshade\[draco\]\""
    ):
        bake(tmp_path / "ball.glb", tmp_path / "out.glb", SETTINGS)
    assert not (tmp_path / "out.glb").exists()


@pytest.mark.parametrize(
    ("fault", "told"),
    [
        ({"spoil": True}, "Draco cannot decode it|Draco gives|after decoding"),
        ({"count": 7}, "not 7"),
    ],
    ids=["spoilt", "miscounted"],
)
def test_data_that_is_not_what_the_file_says_is_refused(tmp_path, fault, told):
    compressed(tmp_path / "ball.glb", **fault)
    with pytest.raises(MeshFileError, match=told):
        bake(tmp_path / "ball.glb", tmp_path / "out.glb", SETTINGS)


@pytest.mark.parametrize(
    "described", [None, {}, {"attributes": {}}, {"bufferView": 9, "attributes": {}}]
)
def test_a_malformed_extension_is_named(tmp_path, described):
    compressed(tmp_path / "ball.glb")
    gltf = read_gltf(tmp_path / "ball.glb")
    primitive = gltf.document["meshes"][0]["primitives"][0]
    primitive["extensions"]["KHR_draco_mesh_compression"] = described
    (tmp_path / "bad.glb").write_bytes(glb_bytes(gltf.document, gltf.buffer(0, "test")))
    with pytest.raises(MeshFileError, match=r"bad\.glb"):
        bake(tmp_path / "bad.glb", tmp_path / "out.glb", SETTINGS)
    assert not (tmp_path / "out.glb").exists()


def test_spoilt_bytes_are_an_error_of_ours_or_a_whole_result(tmp_path):
    compressed(tmp_path / "ball.glb")
    whole = (tmp_path / "ball.glb").read_bytes()
    start, rng = whole.find(b"DRACO"), np.random.default_rng(5)
    outcomes = set()
    for _ in range(150):
        spoilt = bytearray(whole)
        for at in rng.integers(start, len(whole), rng.integers(1, 6)):
            spoilt[at] = rng.integers(256)
        (tmp_path / "bad.glb").write_bytes(spoilt)
        try:
            baked = bake(tmp_path / "bad.glb", tmp_path / "out.glb", BakeSettings())
        except SkinshadeError:
            outcomes.add("refused")
            continue
        outcomes.add("baked")
        assert np.isfinite(baked.meshes[0].analysed.attributes["curvature"]).all()
    assert outcomes == {"refused", "baked"}
