"""`load_mesh` takes unit and attributes from a baked file, and places them by its node."""

from __future__ import annotations

import json
import struct

import numpy as np
import pytest

import shapes
from skinshade.baking import BakeSettings, bake
from skinshade.mesh import Mesh, load_mesh, vertex_attributes
from skinshade.mesh import attributes as module
from skinshade.profile import Profile

SKIN = Profile.preset("skin-deon2007")
ALL = BakeSettings(unit_mm=10.0, tensor=True, thickness=True, rays=8)
FLOAT32 = 2e-6


def set_node_matrix(path, matrix):
    """Set the matrix of the first node of a GLB; its JSON chunk can change its length."""
    data = path.read_bytes()
    (length,) = struct.unpack_from("<I", data, 12)
    document = json.loads(data[20 : 20 + length])
    document["nodes"][0]["matrix"] = np.asarray(matrix).T.ravel().tolist()
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    body = struct.pack("<II", len(text), 0x4E4F534A) + text + data[20 + length :]
    path.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body)
    return path


@pytest.fixture(scope="module")
def baked(tmp_path_factory):
    """An ellipsoid of 60, 40 and 24 mm, baked to GLB in metres."""
    folder = tmp_path_factory.mktemp("baked")
    sphere = shapes.sphere("icosphere", 3)
    body = Mesh.checked(sphere.positions * (3.0, 2.0, 1.2), sphere.faces, unit_mm=10.0)
    lines = [f"v {x} {y} {z}" for x, y, z in body.positions]
    lines += [f"f {a} {b} {c}" for a, b, c in body.faces + 1]
    (folder / "body.obj").write_text("\n".join(lines))
    bake(folder / "body.obj", folder / "body.glb", ALL)
    return folder / "body.glb"


def test_a_baked_file_states_its_unit(baked):
    mesh = load_mesh(baked)
    assert mesh.unit_mm == 1000.0
    assert set(mesh.attributes) >= {"curvature", "tensor", "thickness"}
    assert np.ptp(mesh.positions_mm, axis=0) == pytest.approx([60.0, 40.0, 24.0], rel=1e-3)


def test_baked_attributes_are_used_for_shading_without_a_new_analysis(baked, monkeypatch):
    def refuse(*_, **__):
        raise AssertionError("the attribute is in the file")

    mesh = load_mesh(baked)
    monkeypatch.setattr(module.ShapeOperator, "fit", refuse)
    attributes = vertex_attributes(mesh, SKIN)
    assert np.array_equal(attributes["curvature"][:, 0], mesh.attributes["curvature"])
    assert np.array_equal(attributes["tensor"], mesh.attributes["tensor"])


@pytest.mark.parametrize("scale", [1.0, 0.25])
def test_baked_attributes_are_turned_with_their_node_and_fix_the_size_in_mm(baked, tmp_path, scale):
    """A node that is scaled after the bake changes the unit of the file, not the size in mm."""
    turn = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))[0]
    turn *= np.sign(np.linalg.det(turn))
    matrix = np.eye(4)
    matrix[:3, :3] = scale * turn
    copy = tmp_path / "turned.glb"
    copy.write_bytes(baked.read_bytes())
    mesh = load_mesh(set_node_matrix(copy, matrix))
    without = Mesh.checked(mesh.positions, mesh.faces, unit_mm=mesh.unit_mm, normals=mesh.normals)
    stored, computed = (vertex_attributes(body, SKIN) for body in (mesh, without))
    assert mesh.unit_mm == pytest.approx(1000.0 / scale)
    for name in ("curvature", "tensor"):
        assert np.abs(stored[name] - computed[name]).max() <= FLOAT32 * 100.0


def test_baked_attributes_are_ignored_for_another_unit(baked):
    mesh = load_mesh(baked, unit_mm=500.0)
    assert not {"curvature", "tensor", "thickness"} & set(mesh.attributes)
    half = vertex_attributes(mesh, SKIN)["curvature"]
    assert np.median(half / vertex_attributes(load_mesh(baked), SKIN)["curvature"]) == (
        pytest.approx(2.0, rel=1e-3)
    )


def test_attributes_with_a_baked_name_but_without_the_note_are_not_baked_ones(baked, tmp_path):
    data = baked.read_bytes().replace(b'"skinshade":{', b'"skinshadd":{')
    copy = tmp_path / "other.glb"
    copy.write_bytes(data)
    assert "curvature" not in load_mesh(copy, unit_mm=1000.0).attributes
