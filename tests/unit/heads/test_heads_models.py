import numpy as np
import pytest

import shading_tolerances as tol
from skinshade._core.errors import ArgumentError, ImageFileError, MeshFileError, UnitError
from skinshade.heads import load_head
from skinshade.scene import Material
from skinshade.scene.images import read_linear, write_png
from skinshade.scene.maps import read_normal_map

CORNERS = "v 0 0 0\nv 9 0 0\nv 0 9 0\n"
UVS = "vt 0 0.25\nvt 1 0.25\nvt 0 1\n"


@pytest.fixture
def folder(tmp_path):
    """A triangle with and without UVs, and two maps."""
    (tmp_path / "bare.obj").write_text(CORNERS + "f 1 2 3\n")
    (tmp_path / "face.obj").write_text(CORNERS + UVS + "f 1/1 2/2 3/3\n")
    rng = np.random.default_rng(1)
    write_png(tmp_path / "albedo.png", rng.random((4, 4, 3)))
    write_png(tmp_path / "normal.png", 0.5 + 0.5 * rng.uniform(0.3, 0.9, (4, 4, 3)))
    return tmp_path


def test_a_model_without_maps_has_the_default_material(folder):
    head = load_head(folder / "bare.obj", unit_mm=10.0)
    assert head.mesh.unit_mm == 10.0
    assert np.ptp(head.mesh.positions_mm, axis=0).tolist() == [90.0, 90.0, 0.0]
    default = Material()
    assert np.array_equal(head.material.albedo, default.albedo)
    assert head.material.params == default.params
    assert head.material.normal is None


def test_maps_of_a_model_are_read_as_their_kind_of_image(folder):
    head = load_head(
        folder / "face.obj",
        unit_mm=1.0,
        albedo=folder / "albedo.png",
        normal_map=folder / "normal.png",
    )
    assert np.array_equal(head.material.albedo, read_linear(folder / "albedo.png"))
    assert np.array_equal(head.material.normal, read_normal_map(folder / "normal.png"))


def test_flip_v_reverses_v(folder):
    plain, flipped = (
        load_head(folder / "face.obj", unit_mm=1.0, flip_v=flip).mesh for flip in (False, True)
    )
    truth = plain.uvs * (1.0, -1.0) + (0.0, 1.0)
    assert np.allclose(flipped.uvs, truth, atol=tol.ROUNDING.value)
    assert not np.allclose(flipped.uvs, plain.uvs)


@pytest.mark.parametrize(
    "options", [{"albedo": "albedo.png"}, {"normal_map": "normal.png"}, {"flip_v": True}]
)
def test_maps_for_a_model_without_uvs_are_an_error_that_names_the_model(folder, options):
    with pytest.raises(ArgumentError, match=r"bare\.obj: the mesh has no UVs, which maps need"):
        load_head(folder / "bare.obj", unit_mm=1.0, **options)


def test_a_file_that_cannot_be_used_is_an_error_that_names_it(folder):
    with pytest.raises(MeshFileError, match=r"none\.glb: no such file"):
        load_head(folder / "none.glb")
    with pytest.raises(UnitError, match=r"face\.obj.*unit_mm"):
        load_head(folder / "face.obj")
    for option in ("albedo", "normal_map"):
        with pytest.raises(ImageFileError, match=r"none\.png: no such file"):
            load_head(folder / "face.obj", unit_mm=1.0, **{option: folder / "none.png"})
