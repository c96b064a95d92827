"""Parts of a body with materials of their own, on both backends."""

from dataclasses import replace

import numpy as np
import pytest

import shading_tolerances as tol
from gpu_device import adapter_or_skip
from shapes import square, unit_icosphere
from skinshade._core.errors import ArgumentError
from skinshade.mesh import Mesh
from skinshade.params import SkinParams
from skinshade.profile import Profile
from skinshade.rendering import RenderSettings, open_renderer
from skinshade.rendering.prepare.parts import arrange_parts
from skinshade.scene import Camera, DirectionalLight, Environment, Material, Part, Scene
from skinshade.shading.skin import Skin

SIZE = (96, 80)
SETTINGS = RenderSettings()
RED = np.array([[[0.6, 0.1, 0.1]]], dtype=np.float32)
GREY = np.array([[[0.4, 0.4, 0.4]]], dtype=np.float32)
LIGHTS = (DirectionalLight((-0.6, 0.5, 0.7), 3.0),)


def merged(*pieces):
    """Return one mesh of pieces (positions, faces, normals), whose number is the material of the faces."""
    starts = np.cumsum([0, *(len(positions) for positions, _, _ in pieces)])
    return Mesh.checked(
        np.concatenate([positions for positions, _, _ in pieces]),
        np.concatenate(
            [faces + start for (_, faces, _), start in zip(pieces, starts, strict=False)]
        ),
        unit_mm=1.0,
        normals=np.concatenate([normals for _, _, normals in pieces]),
        uvs=np.concatenate([positions[:, :2] / 100.0 + 0.5 for positions, _, _ in pieces]),
        materials=np.repeat(np.arange(len(pieces)), [len(faces) for _, faces, _ in pieces]),
    )


def ball(radius=40.0, centre=(0.0, 0.0, 0.0)):
    u, faces = unit_icosphere(3)
    return radius * u + centre, faces, u


def card(depth=60.0):
    plane = square(100.0, 4)
    shifted = plane.positions + np.array([-50.0, -50.0, depth])
    return shifted, plane.faces, np.tile([0.0, 0.0, 1.0], (25, 1))


def scene_of(mesh, parts=(), **more):
    environment = Environment.constant((0.3, 0.35, 0.4))
    material = Material(albedo=GREY)
    camera = Camera((90.0, 60.0, 400.0), (0.0, 0.0, 0.0))
    return Scene(mesh, camera, material, LIGHTS, environment, parts=tuple(parts), **more)


def pictures(scene, settings=SETTINGS):
    adapter_or_skip()
    return [
        open_renderer(scene, backend).draw(scene.camera, SIZE, 1, settings)
        for backend in ("cpu", "gpu")
    ]


def other(number, albedo=GREY, **more):
    return Part(number, Material(albedo=albedo), is_skin=False, **more)


def test_a_body_that_is_not_skin_is_drawn_as_without_scattering():
    mesh = merged(ball())
    lambert = pictures(scene_of(mesh), RenderSettings(shading="lambert"))
    plain = pictures(scene_of(mesh, [other(0)]))
    scattering = pictures(scene_of(mesh))
    for without, image, skin in zip(lambert, plain, scattering, strict=True):
        np.testing.assert_array_equal(image, without)
        assert np.abs(skin - image).max() > tol.BACKENDS_TAIL.value / 255.0


def test_skin_beside_another_part_is_drawn_as_alone():
    """The other part is behind the camera, so that it neither hides nor shadows the skin."""
    alone = pictures(replace(scene_of(merged(ball())), environment=None))
    behind = ball(5.0, (0.0, 0.0, 5000.0))
    both = scene_of(merged(ball(), behind), [other(1)])
    both = replace(both, environment=None, lights=())
    alone = pictures(replace(scene_of(merged(ball())), environment=None, lights=()))
    for image, single in zip(pictures(both), alone, strict=True):
        np.testing.assert_array_equal(image, single)


def test_two_parts_of_one_skin_are_drawn_as_one_material():
    u, faces = unit_icosphere(3)
    numbers = (u[faces].mean(axis=1)[:, 0] > 0.0).astype(int)
    mesh = Mesh.checked(40.0 * u, faces, unit_mm=1.0, normals=u, materials=numbers)
    one = scene_of(mesh)
    two = scene_of(mesh, [Part(1, one.material)])
    for single, split in zip(pictures(one), pictures(two), strict=True):
        np.testing.assert_allclose(split, single, atol=tol.BACKENDS_MEAN.value / 255.0)


def test_both_backends_draw_the_same_parts():
    opacity = np.indices((8, 8)).sum(axis=0)[..., None] % 2 * 1.0
    colours = np.broadcast_to(RED, (8, 8, 3)).astype(np.float32)
    parts = [other(1, RED), other(2, colours, opacity=opacity)]
    mesh = merged(ball(), ball(15.0, (25.0, 20.0, 30.0)), card())
    cpu, gpu = pictures(scene_of(mesh, parts))
    difference = np.abs(cpu - gpu)[..., :3].max(axis=2)
    differs = difference > tol.BACKENDS_TAIL.value / 255.0
    assert differs.mean() < tol.OPACITY_EDGES.value
    assert difference[~differs].mean() < tol.BACKENDS_MEAN.value / 255.0
    assert (cpu[..., 0] > 2.0 * cpu[..., 1]).mean() > 0.02, "the red parts are missing"


def test_a_part_without_opacity_shows_nothing_and_casts_no_shadow():
    colours = np.broadcast_to(RED, (4, 4, 3)).astype(np.float32)
    clear = other(1, colours, opacity=np.zeros((4, 4, 1)))
    scene = scene_of(merged(ball(), card()), [clear])
    without = replace(scene, environment=None)
    (cpu, gpu) = pictures(without)
    alone = replace(scene_of(merged(ball())), environment=None)
    for image, single in zip((cpu, gpu), pictures(alone), strict=True):
        np.testing.assert_allclose(image, single, atol=tol.BACKENDS_MEAN.value / 255.0)


def test_an_opaque_card_casts_a_shadow():
    camera = Camera((0.0, 300.0, 20.0), (0.0, 0.0, 20.0), 20.0, (0.0, 0.0, 1.0))
    lights = (DirectionalLight((0.0, 0.3, 1.0), 3.0),)
    view = RenderSettings(debug_view="shadow")
    for with_card, expected in ((True, 0.1), (False, 1.0)):
        mesh = merged(ball(), card(50.0)) if with_card else merged(ball())
        parts = [other(1)] if with_card else []
        scene = replace(scene_of(mesh, parts), environment=None, camera=camera, lights=lights)
        for image in pictures(scene, view):
            top_of_ball = image[SIZE[1] // 2, SIZE[0] // 2, 0]
            assert abs(top_of_ball - expected) <= 0.1


def test_skin_comes_first_and_parts_with_opacity_last():
    parts = [other(0, opacity=np.ones((1, 1, 1))), other(1), Part(2, Material(albedo=GREY))]
    scene = scene_of(merged(ball(), ball(5.0), ball(6.0), ball(7.0)), parts)
    skin = Skin.of(scene.material.profile, SkinParams(), luts=())
    arranged, faces = arrange_parts(scene, skin)
    assert [part.is_skin for part in arranged] == [True, True, False, False]
    assert [part.opacity is None for part in arranged] == [True, True, True, False]
    assert sorted(map(tuple, faces)) == sorted(map(tuple, scene.mesh.faces))
    assert sum(part.face_count for part in arranged) == len(faces)


def test_changes_of_parameters_and_profile_apply_to_all_skin_and_nothing_else():
    parts = [Part(1, Material(albedo=GREY)), other(2)]
    scene = scene_of(merged(ball(), ball(5.0), ball(6.0)), parts)
    profile = Profile.preset("skin1")
    changed = scene.with_params(gloss=0.9).with_profile(profile)
    materials = [changed.material, *(part.material for part in changed.parts)]
    assert [material.params.gloss == 0.9 for material in materials] == [True, True, False]
    assert [material.profile == profile for material in materials] == [True, True, False]


@pytest.mark.parametrize(
    ("parts", "complaint"),
    [
        ([other(0), other(0)], "every number occurs once"),
        ([Part(0, Material(profile=Profile.preset("skin1")))], "one profile"),
    ],
)
def test_contradictory_parts_are_refused(parts, complaint):
    with pytest.raises(ArgumentError, match=complaint):
        scene_of(merged(ball()), parts)


def test_parts_of_a_mesh_without_material_numbers_are_refused():
    u, faces = unit_icosphere(1)
    mesh = Mesh.checked(u, faces, unit_mm=1.0)
    with pytest.raises(ArgumentError, match="no material numbers"):
        scene_of(mesh, [other(0)])


def test_skin_with_an_opacity_map_is_refused():
    with pytest.raises(ArgumentError, match="skin is opaque"):
        Part(0, Material(albedo=GREY), opacity=np.ones((1, 1, 1)))
