"""Files with z up are turned to y up, with their normals and baked tensors."""

from __future__ import annotations

import numpy as np
import pytest

import shapes
import tolerances as tol
from mesh_files import INDICES, POSITION, ply_bytes
from skinshade._core.errors import ArgumentError
from skinshade.baking import BakeSettings, bake
from skinshade.heads import load_head
from skinshade.mesh import Mesh, load_mesh, vertex_attributes
from skinshade.mesh.axes import UpAxis
from skinshade.profile import Profile

BALL = shapes.ellipsoid("icosphere", 2, (0.1, 0.15, 0.12))  # y is the longest axis
SETTINGS = BakeSettings(unit_mm=1000.0, tensor=True, thickness=True, rays=4)


def with_z_up(vectors):
    """Return vectors (V, 3) of axes with y up in axes with z up: (x, y, z) becomes (x, −z, y)."""
    return np.stack([vectors[:, 0], -vectors[:, 2], vectors[:, 1]], axis=1)


def write(folder, suffix, turn=with_z_up):
    """Write the ball, after a turn, with normals if the format has them."""
    file = folder / f"ball{suffix}"
    positions, normals = turn(BALL.positions), turn(BALL.normals)
    if suffix == ".obj":
        lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in positions.tolist()]
        lines += [f"vn {x!r} {y!r} {z!r}" for x, y, z in normals.tolist()]
        lines += ["f " + " ".join(f"{i}//{i}" for i in face) for face in BALL.faces + 1]
        file.write_text("\n".join(lines))
    elif suffix == ".ply":
        properties = [name.replace("float", "double") for name in POSITION]
        properties += ["double nx", "double ny", "double nz"]
        rows = np.concatenate([positions, normals], axis=1).tolist()
        faces = (INDICES, [(face,) for face in BALL.faces.tolist()])
        file.write_bytes(ply_bytes({"vertex": (properties, rows), "face": faces}))
    else:
        lines = ["solid"]
        for triangle in positions[BALL.faces].tolist():
            lines += ["facet normal 0 0 1", "outer loop"]
            lines += ["vertex " + " ".join(map(repr, corner)) for corner in triangle]
            lines += ["endloop", "endfacet"]
        file.write_text("\n".join([*lines, "endsolid"]))
    return file


@pytest.mark.parametrize("suffix", [".obj", ".ply", ".stl"])
def test_a_file_with_z_up_gives_the_mesh_of_the_file_with_y_up(tmp_path, suffix):
    turned = load_mesh(write(tmp_path, suffix), unit_mm=1000.0, up="z")
    plain = load_mesh(write(tmp_path, suffix, np.array), unit_mm=1000.0)
    np.testing.assert_array_equal(turned.positions, plain.positions)
    np.testing.assert_array_equal(turned.faces, plain.faces)
    np.testing.assert_allclose(turned.normals, plain.normals, atol=tol.ROUNDING_SUMS.value)
    assert np.argmax(np.ptp(turned.positions, axis=0)) == 1


def test_an_up_axis_is_a_name_or_a_member(tmp_path):
    file = write(tmp_path, ".obj")
    named, member = (load_mesh(file, unit_mm=1.0, up=up) for up in ("z", UpAxis.Z))
    np.testing.assert_array_equal(named.positions, member.positions)
    np.testing.assert_array_equal(
        load_head(file, unit_mm=1.0, up="z").mesh.positions, named.positions
    )
    with pytest.raises(ArgumentError, match="up is 'x'; it must be one of y, z"):
        load_mesh(file, unit_mm=1.0, up="x")
    with pytest.raises(ArgumentError, match="up is 'x'; it must be one of y, z"):
        BakeSettings(up="x")


def test_glb_with_z_up_is_refused_by_a_reader_and_by_bakes(tmp_path):
    baked = bake(write(tmp_path, ".obj"), tmp_path / "ball.glb", SETTINGS).written[-1]
    assert load_mesh(baked, up="y").unit_mm == 1000.0
    with pytest.raises(ArgumentError, match=r"ball\.glb: up is 'z'; glTF prescribes y"):
        load_mesh(baked, up="z")
    for output in ("again.glb", "again.ply"):
        with pytest.raises(ArgumentError, match=r"ball\.glb: up is 'z'; glTF prescribes y"):
            bake(baked, tmp_path / output, BakeSettings(up="z"))
        assert not (tmp_path / output).exists()


@pytest.mark.parametrize("suffix", [".glb", ".ply"])
def test_a_bake_of_a_file_with_z_up_has_y_up(tmp_path, suffix):
    settings = BakeSettings(unit_mm=1000.0, up="z", tensor=True)
    bake(write(tmp_path, ".obj"), tmp_path / f"out{suffix}", settings)
    mesh = load_mesh(tmp_path / f"out{suffix}")
    expected = load_mesh(write(tmp_path, ".obj", np.array), unit_mm=1000.0)
    assert np.abs(mesh.positions - expected.positions).max() <= tol.FLOAT32_FILE.value
    skin = Profile.preset("skin-deon2007")
    stored, computed = (vertex_attributes(body, skin)["tensor"] for body in (mesh, expected))
    assert (
        np.abs(stored - computed).max() <= tol.CURVATURE_OF_ROUNDED.value * np.abs(computed).max()
    )


def test_baked_tensors_are_turned_with_the_mesh(tmp_path):
    """A baked file has y up; one that a program turned to z up, with its tensors, is turned back."""
    bake(write(tmp_path, ".obj", np.array), tmp_path / "plain.ply", SETTINGS)
    mesh = load_mesh(tmp_path / "plain.ply", up="z")
    without = Mesh.checked(mesh.positions, mesh.faces, unit_mm=mesh.unit_mm, normals=mesh.normals)
    skin = Profile.preset("skin-deon2007")
    stored, computed = (vertex_attributes(body, skin) for body in (mesh, without))
    assert "tensor" in mesh.attributes
    for name in ("tensor", "curvature"):
        error = np.abs(stored[name] - computed[name]).max()
        assert error <= tol.CURVATURE_OF_ROUNDED.value * np.abs(computed[name]).max()
