"""The pygfx material: what it hands to pygfx, what it refuses, and what pygfx then draws."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

import shading_tolerances as tol
from gpu_device import adapter_or_skip
from shapes import sphere
from skinshade._core.errors import ArgumentError, BackendError
from skinshade.mesh import Mesh, mesh_uv_scale, vertex_attributes
from skinshade.params import SkinParams
from skinshade.render.light_view import LightView
from skinshade.scene import DirectionalLight, SpotLight
from skinshade.shading.skin import TABLES_HOLD, Skin

pygfx = pytest.importorskip("pygfx", reason="the extra pygfx is not installed")
offscreen = pytest.importorskip("rendercanvas.offscreen", reason="rendercanvas is not installed")

from skinshade.integrations.pygfx import SkinMaterial, shader, skin_geometry, skin_light  # noqa: E402

RADIUS_MM = 50.0
SIZE = (64, 64)
LAMP = DirectionalLight((0.6, 0.5, 1.0), (3.0, 2.0, 1.0))


def ball(radius_mm=RADIUS_MM, uvs=True):
    shape = sphere("icosphere", 3)
    coordinates = shape.positions[:, :2] * 0.5 + 0.5 if uvs else None
    return Mesh.checked(
        shape.positions * radius_mm,
        shape.faces,
        unit_mm=1.0,
        normals=shape.normals,
        uvs=coordinates,
    )


def head(material, geometry=None, **wanted):
    shadows = {"cast_shadow": True, "receive_shadow": True} | wanted
    return pygfx.Mesh(geometry or skin_geometry(ball()), material, **shadows)


def drawn(*objects):
    """(H, W, 4) bytes, sRGB; the ball of 50 mm fills most of the picture."""
    adapter_or_skip()
    canvas = offscreen.OffscreenRenderCanvas(size=SIZE, pixel_ratio=1)
    renderer = pygfx.renderers.WgpuRenderer(canvas, ppaa="none", pixel_ratio=1)
    scene = pygfx.Scene()
    scene.add(*objects)
    camera = pygfx.PerspectiveCamera(30.0, 1.0, depth_range=(10.0, 1000.0))
    camera.local.position = (0.0, 0.0, 240.0)
    renderer.render(scene, camera, flush=False)
    return np.asarray(renderer.snapshot()).astype(int)


def written(material, name):
    return getattr(material._store, name).data.tobytes()


# -- blocks ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("tier", ["scalar", "tensor"])
def test_the_uniforms_are_the_bytes_of_the_parameters(tier):
    params = SkinParams(gloss=0.41, reflectance=0.04, scatter_scale=1.5)
    material = SkinMaterial(params=params, tier=tier)
    skin = Skin.of(material.skin.profile.scaled(1.0 / 1.5), params)
    luts = ("sphere", "shadow") if tier == "scalar" else ("ring", "transfer", "shadow")
    assert written(material, "skin_buffer") == params.pack()
    assert written(material, "scatter_buffer") == skin.scatter_params(luts=luts).pack()


def test_other_parameters_are_other_uniforms_and_so_is_the_decay_that_stands_with_the_profile():
    material = SkinMaterial()
    before = written(material, "scatter_buffer")
    params = SkinParams(gloss=0.6, deep_scatter_sigma_per_mm=(0.3, 0.6, 0.9))
    material.params = params
    assert material.params == params
    assert written(material, "skin_buffer") == params.pack()
    expected = replace(
        material.skin.scatter_params(luts=("ring", "transfer", "shadow")),
        sigma_per_mm=(0.3, 0.6, 0.9),
    )
    assert written(material, "scatter_buffer") == expected.pack() != before


@pytest.mark.parametrize("name", TABLES_HOLD)
def test_a_parameter_of_the_tables_cannot_change(name):
    material = SkinMaterial()
    changed = replace(material.params, **{name: 1.25 * getattr(material.params, name)})
    with pytest.raises(ArgumentError, match=name):
        material.params = changed
    assert written(material, "skin_buffer") == SkinParams().pack()


def test_a_parameter_of_the_mips_cannot_change():
    flat = np.tile((0.0, 0.0, 1.0), (4, 4, 1))
    SkinMaterial().params = SkinParams(normal_strength=0.5)
    with pytest.raises(ArgumentError, match="normal_strength"):
        SkinMaterial(normal_map=flat).params = SkinParams(normal_strength=0.5)


# -- misuse ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"tier": "diffused-normals"}, "tier is 'diffused-normals'; it must be scalar or tensor"),
        ({"deep_scatter_taps": 16}, "deep_scatter_taps is 16; it must be 0, 8 or 32"),
        ({"uv_scale_mm": 0.0}, "uv_scale_mm is 0.0"),
        ({"uv_scale_mm": float("nan")}, "uv_scale_mm is nan"),
        ({"map": np.zeros((4, 4))}, r"map: shape is \(4, 4\)"),
        ({"normal_map": np.zeros((4, 4, 2))}, r"normal_map: shape is \(4, 4, 2\)"),
        ({"normal_map": np.full((4, 4, 3), np.nan)}, "normal_map: must be finite"),
    ],
)
def test_a_wrong_argument_is_named(wrong, message):
    with pytest.raises(ArgumentError, match=message):
        SkinMaterial(**wrong)


def test_a_geometry_without_curvature_is_refused_with_the_name_of_what_makes_one():
    with pytest.raises(ArgumentError, match="skin_geometry"):
        drawn(head(SkinMaterial(), pygfx.sphere_geometry(50.0)))


def test_a_normal_map_without_a_length_of_the_uvs_is_refused():
    flat = np.tile((0.0, 0.0, 1.0), (4, 4, 1))
    geometry = skin_geometry(ball(uvs=False))
    geometry.texcoords = pygfx.Buffer(np.zeros((geometry.positions.nitems, 2), dtype=np.float32))
    with pytest.raises(ArgumentError, match="uv_scale_mm"):
        drawn(head(SkinMaterial(normal_map=flat), geometry))
    lit = drawn(
        head(SkinMaterial(normal_map=flat, uv_scale_mm=90.0), geometry), skin_light(LAMP, ball())
    )
    assert lit[..., :3].max() > 100


def test_an_uneven_scale_is_refused():
    stretched = head(SkinMaterial())
    stretched.local.scale = (1.0, 1.0, 1.2)
    with pytest.raises(ArgumentError, match=r"scaled by 1 to 1\.2 along its axes"):
        shader.SkinShader(stretched)


def test_what_has_no_tensors_or_attributes_of_its_own_is_refused():
    geometry = skin_geometry(ball())
    with pytest.raises(ArgumentError, match="instances"):
        shader.SkinShader(pygfx.InstancedMesh(geometry, SkinMaterial(), 2))
    with pytest.raises(ArgumentError, match="not faces"):
        shader.SkinShader(head(SkinMaterial(color_mode="face")))
    bending = pygfx.SkinnedMesh(geometry, SkinMaterial())
    with pytest.raises(ArgumentError, match='tier="scalar"'):
        shader.SkinShader(bending)
    bending.material = SkinMaterial(tier="scalar")
    assert shader.SkinShader(bending)["skin_tier"] == "scalar"


def test_a_pygfx_with_another_mesh_shader_is_refused_with_the_version_that_is_wanted(monkeypatch):
    real = shader.load_wgsl("mesh.wgsl")
    monkeypatch.setattr(shader, "load_wgsl", lambda name: real.replace("light_punctual", "lamps"))
    with pytest.raises(BackendError, match=r"pygfx 0\.17"):
        SkinMaterial()


@pytest.mark.parametrize(
    ("before", "kind", "message"),
    [
        (
            "import sys; sys.modules['pygfx'] = None",
            "ImportError",
            'pip install "skinshade[pygfx]"',
        ),
        ("import pygfx.renderers.wgpu as w; del w.GfxSampler", "BackendError", "than 0.17"),
    ],
)
def test_without_pygfx_or_with_one_built_otherwise_the_import_says_what_to_install(
    before, kind, message
):
    program = f"""{before}
from skinshade._core.errors import BackendError
try:
    import skinshade.integrations.pygfx
except {kind} as error:
    print(error)
"""
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert message in done.stdout


# -- geometry, maps, lights ------------------------------------------------------------------------


def test_the_geometry_is_that_of_the_mesh_in_mm():
    mesh = replace(ball(5.0), unit_mm=10.0)
    material = SkinMaterial()
    geometry = skin_geometry(mesh, material.skin.profile)
    columns = vertex_attributes(mesh, material.skin.profile)
    for name, column in (("positions", "position"), ("normals", "normal"), ("tangents", "tangent")):
        wanted = columns[column].astype(np.float32)
        np.testing.assert_array_equal(getattr(geometry, name).data, wanted)
    skin = geometry.skin_attributes.data.reshape(-1, 10)
    np.testing.assert_array_equal(skin[:, 0], columns["curvature"][:, 0].astype(np.float32))
    np.testing.assert_array_equal(skin[:, 1:4], columns["diffused_curvature"].astype(np.float32))
    np.testing.assert_array_equal(skin[:, 4:], columns["tensor"].astype(np.float32))
    assert abs(np.median(skin[:, 0]) * RADIUS_MM - 1.0) < tol.FACETED_BALL.value
    scale = mesh_uv_scale(mesh.positions_mm, mesh.uvs, mesh.faces)
    assert geometry.uv_scale_mm == scale
    assert not hasattr(skin_geometry(ball(uvs=False)), "texcoords")


def test_normals_of_eight_bits_get_mips_that_keep_their_length():
    data = np.full((8, 8, 4), 128, dtype=np.uint8)
    made = SkinMaterial(normal_map=pygfx.Texture(data, dim=2)).normal_map.texture
    assert made.generate_mipmaps
    assert made.data.dtype == np.float32
    np.testing.assert_allclose(made.data[..., :3], 128 / 255, rtol=tol.FLOAT32.value)
    own = pygfx.Texture(made.data, dim=2, generate_mipmaps=True)
    assert SkinMaterial(normal_map=pygfx.TextureMap(own)).normal_map.texture is own


def test_a_normal_map_that_cannot_have_mips_or_the_strength_asked_for_is_refused():
    empty = pygfx.Texture(dim=2, size=(8, 8), format="rgba8unorm")
    with pytest.raises(ArgumentError, match="generate_mipmaps=True"):
        SkinMaterial(normal_map=empty)
    with pytest.raises(ArgumentError, match=r"normal_map: is uint8 \(8, 8\)"):
        SkinMaterial(normal_map=pygfx.Texture(np.zeros((8, 8), dtype=np.uint8), dim=2))
    given = pygfx.Texture(np.full((8, 8, 4), 128, dtype=np.uint8), dim=2)
    with pytest.raises(ArgumentError, match="normal_strength"):
        SkinMaterial(params=SkinParams(normal_strength=0.5), normal_map=given)


def test_normals_are_steepened_before_they_are_averaged():
    slope = np.tile((0.6, 0.0, 0.8), (4, 4, 1))
    made = SkinMaterial(params=SkinParams(normal_strength=0.5), normal_map=slope).normal_map
    wanted = np.array([0.3, 0.0, 0.8]) / np.hypot(0.3, 0.8)
    found = 2.0 * made.texture.data[0, 0, :3] - 1.0
    np.testing.assert_allclose(found, wanted, atol=tol.FLOAT32.value)


@pytest.mark.parametrize(
    "light",
    [LAMP, SpotLight((200.0, 100.0, 250.0), (0.0, 5.0, 0.0), (3.0, 2.0, 1.0), 20.0)],
    ids=["directional", "spot"],
)
def test_a_light_shines_as_ours_and_its_map_is_seen_from_the_same_place(light):
    made = skin_light(light, ball())
    strength = np.array(made.color.to_physical()) * made.intensity
    if isinstance(light, SpotLight):
        distance = np.linalg.norm(light.position_mm - light.target_mm)
        strength /= distance**2
        assert made.decay == 2.0
    np.testing.assert_allclose(strength, light.irradiance, rtol=tol.LAMP_COLOUR.value)
    made._gfx_update_uniform_buffer()
    made.shadow._gfx_update_uniform_buffer(made)  # what pygfx does before a frame
    view = LightView.of(light, ball())
    found = made.uniform_buffer.data["light_view_proj_matrix"].T
    wanted = view.projection @ view.view
    np.testing.assert_allclose(found, wanted, atol=tol.LAMP_MATRIX.value * np.abs(wanted).max())
    assert made.shadow.cull_mode == "back"


def test_a_light_takes_bounds_as_well_and_refuses_what_encloses_nothing():
    points = ball().positions_mm
    made = skin_light(LAMP, (points.min(axis=0), points.max(axis=0)), cast_shadow=False)
    # The ball within its box reaches less far than the box's corners do.
    assert made.shadow.camera.width > skin_light(LAMP, ball()).shadow.camera.width
    assert not made.cast_shadow
    for bounds in (np.zeros((2, 3)), (points.max(axis=0), points.min(axis=0)), np.zeros(3)):
        with pytest.raises(ArgumentError, match="bounds"):
            skin_light(LAMP, bounds)
    dark = skin_light(DirectionalLight((0, 0, 1), (0, 0, 0)), ball())
    assert dark.intensity == 0.0


# -- pictures --------------------------------------------------------------------------------------


def test_parameters_and_taps_can_be_changed_between_frames():
    material = SkinMaterial()
    lit = (head(material), skin_light(LAMP, ball()))
    first = drawn(*lit)
    material.params = SkinParams(gloss=0.7, reflectance=0.2)
    second = drawn(*lit)
    assert np.abs(second - first).max() > 20
    material.params = SkinParams()
    np.testing.assert_array_equal(drawn(*lit), first)


def test_light_comes_through_where_taps_measure_the_body_and_a_shadow_map_shows_it():
    behind = DirectionalLight((0.0, 0.3, -1.0), np.full(3, 30.0))
    mesh = ball(6.0)
    lamp = skin_light(behind, mesh)
    material = SkinMaterial(params=SkinParams(deep_scatter_sigma_per_mm=(0.05, 0.1, 0.2)))
    red = []
    for taps in (0, 8, 32):
        material.deep_scatter_taps = taps
        picture = drawn(head(material, skin_geometry(mesh)), lamp)
        red.append(picture[SIZE[1] // 2, SIZE[0] // 2, 0])
    assert red[0] == 0
    assert min(red[1:]) > 20
    without = drawn(head(material, skin_geometry(mesh), receive_shadow=False), lamp)
    assert without[SIZE[1] // 2, SIZE[0] // 2, 0] == 0


def bumps(size=512, strength=0.7):
    """(size, size, 3) random normals, steep enough to show in a blur of some texels."""
    slopes = np.random.default_rng(3).normal(0.0, strength, (size, size, 2))
    normals = np.dstack([slopes, np.ones((size, size))])
    return normals / np.linalg.norm(normals, axis=2, keepdims=True)


@pytest.mark.parametrize("tier", ["scalar", "tensor"])
def test_a_small_mesh_drawn_large_is_the_large_mesh(tier):
    lamp = skin_light(LAMP, ball())
    params = SkinParams(scatter_scale=3.0)  # blurs wider than a pixel
    material = SkinMaterial(params=params, tier=tier, normal_map=bumps())
    large = drawn(head(material, skin_geometry(ball(), material.skin.profile)), lamp)
    half = skin_geometry(ball(0.5 * RADIUS_MM), material.skin.profile.scaled(0.5))
    scaled = head(material, half)
    scaled.local.scale = 2.0
    assert np.abs(drawn(scaled, lamp) - large).max() <= 1
    assert large[..., :3].max() > 100


def test_a_mirrored_map_on_mirrored_uvs_is_the_same_relief():
    mesh = ball()
    mirrored = replace(mesh, uvs=mesh.uvs * (-1.0, 1.0) + (1.0, 0.0))
    normals = bumps(16)
    lamp = skin_light(LAMP, mesh, cast_shadow=False)
    plain = drawn(head(SkinMaterial(normal_map=normals), skin_geometry(mesh)), lamp)
    other = SkinMaterial(normal_map=normals[:, ::-1] * (-1.0, 1.0, 1.0))
    assert np.abs(drawn(head(other, skin_geometry(mirrored)), lamp) - plain).max() <= 3
    flat = drawn(head(SkinMaterial(), skin_geometry(mesh)), lamp)
    assert np.abs(flat - plain).max() > 50


def test_a_tensor_turns_with_its_object():
    """A cylinder-like body: along its axis it is flat, and turning it must not show in the table."""
    mesh = ball()
    long = Mesh.checked(mesh.positions_mm * (1.0, 0.2, 0.2), mesh.faces, unit_mm=1.0)
    turned = Mesh.checked(long.positions[:, [1, 0, 2]] * (-1.0, 1.0, 1.0), long.faces, unit_mm=1.0)
    # A wide profile, so that the way in which the body is curved shows.
    material = SkinMaterial(params=SkinParams(scatter_scale=3.0))
    lamp = skin_light(LAMP, mesh, cast_shadow=False)
    wanted = drawn(head(material, skin_geometry(turned, material.skin.profile)), lamp)
    moved = head(material, skin_geometry(long, material.skin.profile))
    moved.local.rotation = (0.0, 0.0, np.sqrt(0.5), np.sqrt(0.5))
    assert np.abs(drawn(moved, lamp) - wanted).max() <= 1
    flat = head(material, skin_geometry(long, material.skin.profile))
    assert np.abs(drawn(flat, lamp) - wanted).max() > 50


def test_a_white_body_in_an_even_sky_does_not_show():
    params = SkinParams(scatter_scale=0.05)  # a wide one would gain light from its curvature
    body = head(SkinMaterial(params=params, color="#fff"))
    radiance = 0.5
    picture = drawn(body, pygfx.AmbientLight("#fff", np.pi * radiance))
    covered = picture[..., 3] == 255
    assert covered.sum() > 1000
    srgb = 255.0 * (1.055 * radiance ** (1 / 2.4) - 0.055)
    assert np.abs(picture[covered][:, :3] - srgb).max() <= 2.0


def test_every_kind_of_light_lights_and_a_specular_map_dims_the_highlight():
    point = pygfx.PointLight("#fff", 1.5e4, decay=2, cast_shadow=True)
    point.local.position = (80.0, 60.0, 200.0)
    point.shadow.cull_mode = "back"
    spot = SpotLight((80.0, 60.0, 200.0), (0.0, 0.0, 0.0), np.full(3, 0.5), 30.0)
    sun = replace(LAMP, irradiance=np.full(3, 0.5))
    glossy = SkinParams(gloss=0.6, reflectance=0.2)
    for lamp in (point, skin_light(spot, ball()), skin_light(sun, ball())):
        plain = drawn(head(SkinMaterial(params=glossy)), lamp)
        black = pygfx.Texture(np.zeros((2, 2, 4), dtype=np.float32), dim=2)
        dull = drawn(head(SkinMaterial(params=glossy, specular_map=black)), lamp)
        assert plain[..., :3].max() > dull[..., :3].max() + 20
        assert dull[..., :3].max() > 60
