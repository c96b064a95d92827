"""The pygfx material: its buffers and textures, its errors, and pictures that pygfx draws with it."""

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
from skinshade.rendering.prepare.light_view import LightView
from skinshade.scene import DirectionalLight, SpotLight
from skinshade.shading.skin import Skin
from skinshade.shading.tables import BUILT_FOR

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


def head(material, geometry=None, **changes):
    shadows = {"cast_shadow": True, "receive_shadow": True} | changes
    return pygfx.Mesh(geometry or skin_geometry(ball()), material, **shadows)


def draw(*objects):
    """Return a picture (H, W, 4), sRGB in 8 bits; a ball of 50 mm fills most of it."""
    adapter_or_skip()
    canvas = offscreen.OffscreenRenderCanvas(size=SIZE, pixel_ratio=1)
    renderer = pygfx.renderers.WgpuRenderer(canvas, ppaa="none", pixel_ratio=1)
    scene = pygfx.Scene()
    scene.add(*objects)
    camera = pygfx.PerspectiveCamera(30.0, 1.0, depth_range=(10.0, 1000.0))
    camera.local.position = (0.0, 0.0, 240.0)
    renderer.render(scene, camera, flush=False)
    return np.asarray(renderer.snapshot()).astype(int)


def buffer_bytes(material, name):
    return getattr(material._store, name).data.tobytes()


# -- blocks ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("tier", ["scalar", "tensor"])
def test_the_uniforms_are_the_bytes_of_the_parameters(tier):
    params = SkinParams(gloss=0.41, reflectance=0.04, scatter_scale=1.5)
    material = SkinMaterial(params=params, tier=tier)
    luts = ("sphere",) if tier == "scalar" else ("ring", "transfer")
    skin = Skin.of(material.skin.profile.scaled(1.0 / 1.5), params, luts=(*luts, "shadow", "coat"))
    assert buffer_bytes(material, "skin_buffer") == params.pack()
    assert buffer_bytes(material, "scatter_buffer") == skin.scatter_params().pack()


def test_new_parameters_rewrite_both_uniforms():
    """The decay of deep scatter is in the profile's uniform."""
    material = SkinMaterial()
    before = buffer_bytes(material, "scatter_buffer")
    params = SkinParams(gloss=0.6, deep_scatter_sigma_per_mm=(0.3, 0.6, 0.9))
    material.params = params
    assert material.params == params
    assert buffer_bytes(material, "skin_buffer") == params.pack()
    expected = replace(material.skin.scatter_params(), sigma_per_mm=(0.3, 0.6, 0.9))
    assert buffer_bytes(material, "scatter_buffer") == expected.pack() != before


@pytest.mark.parametrize("name", BUILT_FOR)
def test_a_parameter_that_the_tables_depend_on_cannot_change(name):
    material = SkinMaterial()
    changed = replace(material.params, **{name: 1.25 * getattr(material.params, name)})
    with pytest.raises(ArgumentError, match=f"{name} is .*, but the tables were built for"):
        material.params = changed
    assert buffer_bytes(material, "skin_buffer") == SkinParams().pack()


def test_a_parameter_that_the_mips_depend_on_cannot_change():
    flat = np.tile((0.0, 0.0, 1.0), (4, 4, 1))
    without_map = SkinMaterial()
    without_map.params = SkinParams(normal_strength=0.5)
    assert without_map.params.normal_strength == 0.5
    with pytest.raises(ArgumentError, match=r"normal_strength is 0\.5, but the mips"):
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
def test_a_wrong_argument_is_reported_by_name(wrong, message):
    with pytest.raises(ArgumentError, match=message):
        SkinMaterial(**wrong)


def test_a_geometry_without_curvature_is_an_error_that_names_skin_geometry():
    with pytest.raises(ArgumentError, match="skin_geometry"):
        draw(head(SkinMaterial(), pygfx.sphere_geometry(50.0)))


def test_a_normal_map_needs_the_length_of_the_uv_unit():
    flat = np.tile((0.0, 0.0, 1.0), (4, 4, 1))
    geometry = skin_geometry(ball(uvs=False))
    geometry.texcoords = pygfx.Buffer(np.zeros((geometry.positions.nitems, 2), dtype=np.float32))
    with pytest.raises(ArgumentError, match="uv_scale_mm"):
        draw(head(SkinMaterial(normal_map=flat), geometry))
    lit = draw(
        head(SkinMaterial(normal_map=flat, uv_scale_mm=90.0), geometry), skin_light(LAMP, ball())
    )
    assert lit[..., :3].max() > 100


def test_a_scale_that_differs_between_axes_is_an_error():
    stretched = head(SkinMaterial())
    stretched.local.scale = (1.0, 1.0, 1.2)
    with pytest.raises(ArgumentError, match=r"scaled by 1 to 1\.2 along its axes"):
        shader.SkinShader(stretched)


def test_instances_face_colours_and_deforming_meshes_with_tensors_are_errors():
    geometry = skin_geometry(ball())
    with pytest.raises(ArgumentError, match="instances"):
        shader.SkinShader(pygfx.InstancedMesh(geometry, SkinMaterial(), 2))
    with pytest.raises(ArgumentError, match="not of faces"):
        shader.SkinShader(head(SkinMaterial(color_mode="face")))
    bending = pygfx.SkinnedMesh(geometry, SkinMaterial())
    with pytest.raises(ArgumentError, match='tier="scalar"'):
        shader.SkinShader(bending)
    bending.material = SkinMaterial(tier="scalar")
    assert shader.SkinShader(bending)["skin_tier"] == "scalar"


def test_another_mesh_shader_of_pygfx_is_an_error_that_names_the_required_version(monkeypatch):
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
        (
            "import pygfx.renderers.wgpu as w; del w.GfxSampler",
            "BackendError",
            "differs from pygfx 0.17",
        ),
    ],
)
def test_without_the_required_pygfx_the_import_error_says_what_to_install(before, kind, message):
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


def test_the_geometry_holds_the_vertex_attributes_of_the_mesh_in_mm():
    mesh = replace(ball(5.0), unit_mm=10.0)
    material = SkinMaterial()
    geometry = skin_geometry(mesh, material.skin.profile)
    columns = vertex_attributes(mesh, material.skin.profile)
    for name, column in (("positions", "position"), ("normals", "normal"), ("tangents", "tangent")):
        expected = columns[column].astype(np.float32)
        np.testing.assert_array_equal(getattr(geometry, name).data, expected)
    skin = geometry.skin_attributes.data.reshape(-1, 10)
    np.testing.assert_array_equal(skin[:, 0], columns["curvature"][:, 0].astype(np.float32))
    np.testing.assert_array_equal(skin[:, 1:4], columns["diffused_curvature"].astype(np.float32))
    np.testing.assert_array_equal(skin[:, 4:], columns["tensor"].astype(np.float32))
    assert abs(np.median(skin[:, 0]) * RADIUS_MM - 1.0) < tol.FACETED_BALL.value
    scale = mesh_uv_scale(mesh.positions_mm, mesh.uvs, mesh.faces)
    assert geometry.uv_scale_mm == scale
    assert not hasattr(skin_geometry(ball(uvs=False)), "texcoords")


def test_a_normal_map_of_8_bits_becomes_floats_with_mips_and_one_of_floats_stays():
    data = np.full((8, 8, 4), 128, dtype=np.uint8)
    texture = SkinMaterial(normal_map=pygfx.Texture(data, dim=2)).normal_map.texture
    assert texture.generate_mipmaps
    assert texture.data.dtype == np.float32
    np.testing.assert_allclose(texture.data[..., :3], 128 / 255, rtol=tol.FLOAT32.value)
    own = pygfx.Texture(texture.data, dim=2, generate_mipmaps=True)
    assert SkinMaterial(normal_map=pygfx.TextureMap(own)).normal_map.texture is own


def test_a_normal_map_without_possible_mips_or_with_a_strength_of_its_own_is_an_error():
    empty = pygfx.Texture(dim=2, size=(8, 8), format="rgba8unorm")
    with pytest.raises(ArgumentError, match="generate_mipmaps=True"):
        SkinMaterial(normal_map=empty)
    with pytest.raises(ArgumentError, match=r"normal_map: is uint8 \(8, 8\)"):
        SkinMaterial(normal_map=pygfx.Texture(np.zeros((8, 8), dtype=np.uint8), dim=2))
    texture = pygfx.Texture(np.full((8, 8, 4), 128, dtype=np.uint8), dim=2)
    with pytest.raises(ArgumentError, match="normal_strength"):
        SkinMaterial(params=SkinParams(normal_strength=0.5), normal_map=texture)


def test_slopes_are_scaled_by_the_strength_before_mips_are_computed():
    slope = np.tile((0.6, 0.0, 0.8), (4, 4, 1))
    material = SkinMaterial(params=SkinParams(normal_strength=0.5), normal_map=slope)
    expected = np.array([0.3, 0.0, 0.8]) / np.hypot(0.3, 0.8)
    normal = 2.0 * material.normal_map.texture.data[0, 0, :3] - 1.0
    np.testing.assert_allclose(normal, expected, atol=tol.FLOAT32.value)


@pytest.mark.parametrize(
    "light",
    [LAMP, SpotLight((200.0, 100.0, 250.0), (0.0, 5.0, 0.0), (3.0, 2.0, 1.0), 20.0)],
    ids=["directional", "spot"],
)
def test_a_light_has_the_irradiance_and_the_shadow_camera_of_skinshades_light(light):
    pygfx_light = skin_light(light, ball())
    strength = np.array(pygfx_light.color.to_physical()) * pygfx_light.intensity
    if isinstance(light, SpotLight):
        distance = np.linalg.norm(light.position_mm - light.target_mm)
        strength /= distance**2
        assert pygfx_light.decay == 2.0
    np.testing.assert_allclose(strength, light.irradiance, rtol=tol.LAMP_COLOUR.value)
    pygfx_light._gfx_update_uniform_buffer()
    pygfx_light.shadow._gfx_update_uniform_buffer(pygfx_light)  # pygfx calls both before a frame
    view = LightView.of(light, ball())
    matrix = pygfx_light.uniform_buffer.data["light_view_proj_matrix"].T
    expected = view.projection @ view.view
    atol = tol.LAMP_MATRIX.value * np.abs(expected).max()
    np.testing.assert_allclose(matrix, expected, atol=atol)
    assert pygfx_light.shadow.cull_mode == "back"


def test_a_light_takes_bounds_and_empty_bounds_are_an_error():
    points = ball().positions_mm
    pygfx_light = skin_light(LAMP, (points.min(axis=0), points.max(axis=0)), cast_shadow=False)
    # The corners of the box lie outside the ball.
    assert pygfx_light.shadow.camera.width > skin_light(LAMP, ball()).shadow.camera.width
    assert not pygfx_light.cast_shadow
    for bounds in (np.zeros((2, 3)), (points.max(axis=0), points.min(axis=0)), np.zeros(3)):
        with pytest.raises(ArgumentError, match="bounds"):
            skin_light(LAMP, bounds)
    dark = skin_light(DirectionalLight((0, 0, 1), (0, 0, 0)), ball())
    assert dark.intensity == 0.0


# -- pictures --------------------------------------------------------------------------------------


def test_new_parameters_apply_from_the_next_frame():
    material = SkinMaterial()
    objects = (head(material), skin_light(LAMP, ball()))
    first = draw(*objects)
    material.params = SkinParams(gloss=0.7, reflectance=0.2)
    second = draw(*objects)
    assert np.abs(second - first).max() > 20
    material.params = SkinParams()
    np.testing.assert_array_equal(draw(*objects), first)


def test_light_comes_through_the_body_only_with_taps_and_a_shadow_map():
    behind = DirectionalLight((0.0, 0.3, -1.0), np.full(3, 30.0))
    mesh = ball(6.0)
    lamp = skin_light(behind, mesh)
    material = SkinMaterial(params=SkinParams(deep_scatter_sigma_per_mm=(0.05, 0.1, 0.2)))
    red = []
    for taps in (0, 8, 32):
        material.deep_scatter_taps = taps
        picture = draw(head(material, skin_geometry(mesh)), lamp)
        red.append(picture[SIZE[1] // 2, SIZE[0] // 2, 0])
    assert red[0] == 0
    assert min(red[1:]) > 20
    without = draw(head(material, skin_geometry(mesh), receive_shadow=False), lamp)
    assert without[SIZE[1] // 2, SIZE[0] // 2, 0] == 0


def bumps(size=512, strength=0.7):
    """Return random normals (size, size, 3), steep enough to be visible after a blur of several texels."""
    slopes = np.random.default_rng(3).normal(0.0, strength, (size, size, 2))
    normals = np.dstack([slopes, np.ones((size, size))])
    return normals / np.linalg.norm(normals, axis=2, keepdims=True)


@pytest.mark.parametrize("tier", ["scalar", "tensor"])
def test_a_mesh_of_half_the_size_scaled_by_two_looks_the_same(tier):
    lamp = skin_light(LAMP, ball())
    params = SkinParams(scatter_scale=3.0)  # blurs wider than a pixel
    material = SkinMaterial(params=params, tier=tier, normal_map=bumps())
    large = draw(head(material, skin_geometry(ball(), material.skin.profile)), lamp)
    half = skin_geometry(ball(0.5 * RADIUS_MM), material.skin.profile.scaled(0.5))
    scaled = head(material, half)
    scaled.local.scale = 2.0
    assert np.abs(draw(scaled, lamp) - large).max() <= 1
    assert large[..., :3].max() > 100


def test_a_mirrored_map_on_mirrored_uvs_looks_the_same():
    mesh = ball()
    mirrored = replace(mesh, uvs=mesh.uvs * (-1.0, 1.0) + (1.0, 0.0))
    normals = bumps(16)
    lamp = skin_light(LAMP, mesh, cast_shadow=False)
    plain = draw(head(SkinMaterial(normal_map=normals), skin_geometry(mesh)), lamp)
    other = SkinMaterial(normal_map=normals[:, ::-1] * (-1.0, 1.0, 1.0))
    assert np.abs(draw(head(other, skin_geometry(mirrored)), lamp) - plain).max() <= 3
    flat = draw(head(SkinMaterial(), skin_geometry(mesh)), lamp)
    assert np.abs(flat - plain).max() > 50


def test_the_shape_operator_rotates_with_its_object():
    """A rotated long body looks like a mesh whose vertices were rotated."""
    mesh = ball()
    long = Mesh.checked(mesh.positions_mm * (1.0, 0.2, 0.2), mesh.faces, unit_mm=1.0)
    turned = Mesh.checked(long.positions[:, [1, 0, 2]] * (-1.0, 1.0, 1.0), long.faces, unit_mm=1.0)
    # A wide profile makes the direction of curvature visible.
    material = SkinMaterial(params=SkinParams(scatter_scale=3.0))
    lamp = skin_light(LAMP, mesh, cast_shadow=False)
    expected = draw(head(material, skin_geometry(turned, material.skin.profile)), lamp)
    moved = head(material, skin_geometry(long, material.skin.profile))
    moved.local.rotation = (0.0, 0.0, np.sqrt(0.5), np.sqrt(0.5))
    assert np.abs(draw(moved, lamp) - expected).max() <= 1
    unmoved = head(material, skin_geometry(long, material.skin.profile))
    assert np.abs(draw(unmoved, lamp) - expected).max() > 50


def test_a_white_body_in_a_uniform_environment_has_its_radiance():
    params = SkinParams(scatter_scale=0.05)  # a wide profile gains light from curvature
    body = head(SkinMaterial(params=params, color="#fff"))
    radiance = 0.5
    picture = draw(body, pygfx.AmbientLight("#fff", np.pi * radiance))
    covered = picture[..., 3] == 255
    assert covered.sum() > 1000
    srgb = 255.0 * (1.055 * radiance ** (1 / 2.4) - 0.055)
    assert np.abs(picture[covered][:, :3] - srgb).max() <= 2.0


def test_every_kind_of_light_has_a_highlight_that_a_specular_map_dims():
    point = pygfx.PointLight("#fff", 1.5e4, decay=2, cast_shadow=True)
    point.local.position = (80.0, 60.0, 200.0)
    point.shadow.cull_mode = "back"
    spot = SpotLight((80.0, 60.0, 200.0), (0.0, 0.0, 0.0), np.full(3, 0.5), 30.0)
    sun = replace(LAMP, irradiance=np.full(3, 0.5))
    glossy = SkinParams(gloss=0.6, reflectance=0.2)
    for lamp in (point, skin_light(spot, ball()), skin_light(sun, ball())):
        plain = draw(head(SkinMaterial(params=glossy)), lamp)
        black = pygfx.Texture(np.zeros((2, 2, 4), dtype=np.float32), dim=2)
        dull = draw(head(SkinMaterial(params=glossy, specular_map=black)), lamp)
        assert plain[..., :3].max() > dull[..., :3].max() + 20
        assert dull[..., :3].max() > 60
