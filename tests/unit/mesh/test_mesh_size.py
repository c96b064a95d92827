"""A body of implausible size warns, whatever the file's format and the source of its unit."""

import warnings
from pathlib import Path

import numpy as np
import pytest
import trimesh

import shapes
from skinshade._core.errors import UnitWarning
from skinshade.baking import BakeSettings, bake
from skinshade.mesh import load_mesh
from skinshade.mesh.size import PLAUSIBLE_MM, warn_of_size

HEAD = shapes.ellipsoid("icosphere", 2, (0.11, 0.15, 0.13))
"""A body of the size of a head, in metres."""
SUFFIXES = [".glb", ".gltf", ".obj", ".ply", ".stl"]
EVERY_SUFFIX = pytest.mark.parametrize("suffix", SUFFIXES)


def exported(folder, suffix, scale=1.0):
    """Write the head, with its positions in metres multiplied by a scale."""
    mesh = trimesh.Trimesh(HEAD.positions * scale, HEAD.faces, process=False)
    file = folder / f"head{suffix}"
    if suffix == ".gltf":
        for name, content in trimesh.exchange.gltf.export_gltf(trimesh.Scene(mesh)).items():
            (folder / ("head.gltf" if name.endswith(".gltf") else name)).write_bytes(content)
    else:
        mesh.export(file)
    return file


def assert_silent(function, *arguments, **options):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        return function(*arguments, **options)


def size_warning(function, *arguments, **options):
    """Return the only warning of a call, which names the caller's file."""
    with pytest.warns(UnitWarning) as caught:
        function(*arguments, **options)
    assert len(caught) == 1
    assert caught[0].filename == __file__
    return str(caught[0].message)


@EVERY_SUFFIX
@pytest.mark.parametrize(("unit_mm", "size"), [(50_000.0, "22.7 m"), (100.0, "45.4 mm")])
def test_a_given_unit_that_makes_a_head_implausible_warns(tmp_path, suffix, unit_mm, size):
    file = exported(tmp_path, suffix)
    message = size_warning(load_mesh, file, unit_mm=unit_mm)
    start = f"{file}: with the given unit of {unit_mm:g} mm, the object is {size} across; "
    assert message.startswith(start)
    assert "give unit_mm, the length of one unit of the file in mm" in message


@EVERY_SUFFIX
@pytest.mark.parametrize("unit_mm", [200.0, 1000.0, 6500.0])
def test_a_given_unit_of_plausible_size_does_not_warn(tmp_path, suffix, unit_mm):
    assert assert_silent(load_mesh, exported(tmp_path, suffix), unit_mm=unit_mm).unit_mm == unit_mm


@pytest.mark.parametrize("suffix", [".glb", ".gltf"])
@pytest.mark.parametrize(("scale", "size"), [(50.0, "22.7 m"), (0.1, "45.4 mm")])
def test_gltf_of_implausible_size_in_metres_warns(tmp_path, suffix, scale, size):
    file = exported(tmp_path, suffix, scale)
    message = size_warning(load_mesh, file)
    assert message.startswith(f"{file}: in metres, the unit of glTF, the object is {size} across; ")


@pytest.mark.parametrize("scale", [0.2, 1.0, 6.5])
def test_gltf_of_plausible_size_in_metres_does_not_warn(tmp_path, scale):
    assert assert_silent(load_mesh, exported(tmp_path, ".glb", scale)).unit_mm == 1000.0


def test_a_head_in_centimetres_that_is_read_in_millimetres_warns(tmp_path):
    message = size_warning(load_mesh, exported(tmp_path, ".obj", 100.0), unit_mm=1.0)
    assert "the object is 45.4 mm across" in message


def test_a_file_that_was_baked_with_an_implausible_unit_warns(tmp_path):
    source = exported(tmp_path, ".obj")
    size_warning(bake, source, tmp_path / "baked.glb", BakeSettings(unit_mm=50_000.0))
    message = size_warning(load_mesh, tmp_path / "baked.glb")
    assert "in the unit of its bake, 1000 mm, the object is 22.7 m across" in message


@pytest.mark.parametrize("factor", [0.99, 1.01])
@pytest.mark.parametrize("bound", PLAUSIBLE_MM)
def test_the_diagonal_decides(bound, factor):
    extent = np.array([2.0, 3.0, 6.0]) / 7.0 * bound * factor
    is_plausible = PLAUSIBLE_MM[0] <= bound * factor <= PLAUSIBLE_MM[1]
    if is_plausible:
        assert_silent(warn_of_size, extent, Path("head.obj"), 1.0, "given")
    else:
        with pytest.warns(UnitWarning, match=r"^head\.obj: with the given unit of 1 mm, "):
            warn_of_size(extent, Path("head.obj"), 1.0, "given")


@pytest.mark.parametrize("extent", [0.0, 1e200, np.inf])
def test_extents_of_any_size_warn_without_another_warning(extent):
    with pytest.warns(UnitWarning) as caught:
        warn_of_size(np.full(3, extent), Path("head.obj"), 1.0, "given")
    assert len(caught) == 1
