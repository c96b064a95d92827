from dataclasses import replace

import numpy as np
import pytest

from shapes import square
from skinshade._core.errors import ArgumentError
from skinshade.mesh import Mesh
from skinshade.params.gloss import gloss_from_roughness
from skinshade.scene import Camera, Material, Scene

CAMERA = Camera((0.0, 0.0, 100.0), (0.0, 0.0, 0.0))
MAPS = {"albedo": 3, "normal": 3, "specular": 2, "deep_scatter": 3}


def sheet(uvs=False):
    plane = square(10.0, 1)
    coordinates = plane.positions[:, :2] / 10.0 if uvs else None
    return Mesh.checked(plane.positions, plane.faces, unit_mm=1.0, uvs=coordinates)


@pytest.fixture
def scene():
    return Scene(sheet(), CAMERA, Material())


def test_one_number_is_a_grey_background(scene):
    assert replace(scene, background=0.25).background.tolist() == [0.25, 0.25, 0.25]
    assert scene.background.tolist() == [0.05, 0.05, 0.05]


def test_with_params_changes_the_named_parameters_of_a_new_scene(scene):
    other = scene.with_params(gloss=0.7, scatter_scale=2.0)
    assert (other.material.params.gloss, other.material.params.scatter_scale) == (0.7, 2.0)
    assert other.material.params.reflectance == scene.material.params.reflectance
    assert scene.material.params.gloss == 0.35
    assert other.mesh is scene.mesh
    with pytest.raises(ArgumentError, match="gloss is 2"):
        scene.with_params(gloss=2.0)


def test_with_params_takes_a_roughness_in_place_of_a_gloss(scene):
    rough = scene.with_params(roughness=0.45)
    assert rough.material.params.gloss == float(gloss_from_roughness(0.45))
    assert rough.with_params(scatter_scale=2.0).material.params.gloss == rough.material.params.gloss


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"background": -0.1}, "background is -0.1"),
        ({"background": (0.1, np.nan, 0.1)}, r"background\[1\] is nan"),
        ({"background": (0.1, 0.2)}, r"background: shape is \(2,\)"),
        ({"exposure": np.nan}, "exposure is nan"),
        ({"exposure": -1.0}, "exposure is -1"),
        ({"tone": "sepia"}, "tone is 'sepia'; .* filmic"),
    ],
)
def test_a_wrong_value_of_a_scene_is_an_error_that_names_it(scene, change, message):
    with pytest.raises(ArgumentError, match=message):
        replace(scene, **change)


@pytest.mark.parametrize("name", MAPS)
def test_maps_need_uvs_and_one_texel_does_not(name):
    def scene(size, uvs):
        image = np.full((size, size, MAPS[name]), 0.5, dtype=np.float32)
        return Scene(sheet(uvs), CAMERA, Material(**{name: image}))

    with pytest.raises(
        ArgumentError, match="the mesh has no UVs, which the maps of the material need"
    ):
        scene(2, uvs=False)
    assert scene(2, uvs=True).mesh.uvs is not None
    if name != "normal":
        assert scene(1, uvs=False).mesh.uvs is None
