"""Compiled rasteriser, taps and fetches against their NumPy twins and against analytic results."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import shapes
import tolerances as tol
from native_twins import both, level, needs_library, numpy_twins, threads
from skinshade._core import native
from skinshade.lut.table import Axis, Lut
from skinshade.rendering.prepare import compiled_fetches
from skinshade.rendering.prepare.attributes import VertexTable
from skinshade.rendering.prepare.mips import build_texture
from skinshade.rendering.prepare.rasterizer import depth_maps, rasterize
from skinshade.scene.camera import look_at, perspective
from skinshade.shading.deep_scatter import mean_thickness, poisson_disk
from skinshade.shading.image_light import bilinear
from skinshade.shading.shadow import lit_share, shadow_disk

pytestmark = needs_library

SEED = st.integers(0, 2**20)
SIZE = (70, 50)
HUGE = [0.0, -1e18, 1e18, 1e300, -1e300, 0.5]


def ball_in_view(subdivisions=3, distance=2.0, seed=0):
    """Return clip coordinates and faces of a bumpy ball, in an order without neighbours."""
    rng = np.random.default_rng(seed)
    positions, faces = shapes.unit_icosphere(subdivisions)
    positions = positions * rng.uniform(0.9, 1.1, len(positions))[:, None]
    eye = np.array([0.3, 0.2, distance])
    view = look_at(eye, np.zeros(3), np.array([0.0, 1.0, 0.0]))
    matrix = perspective(50.0, SIZE[0] / SIZE[1], 0.1, 100.0) @ view
    clip = positions @ matrix[:, :3].T + matrix[:, 3]
    return clip, rng.permutation(faces)


def assert_same_fragments(one, other):
    assert one.pixel.tolist() == other.pixel.tolist()
    assert one.face.tolist() == other.face.tolist()
    for name in ("barycentric", "along_x", "along_y"):
        expected = getattr(other, name)
        error = np.abs(getattr(one, name) - expected) / (1.0 + np.abs(expected))
        assert error.max(initial=0.0) <= tol.NATIVE_RASTER.value


def in_bytes(function, *arguments):
    """Return the bytes of the results for 1, 2 and 5 threads, and for both levels of instructions."""
    results = []
    for count in (1, 2, 5):
        with threads(count):
            results.append(function(*arguments))
    levels = ("v2", "v3") if native.reason().endswith("v3") else ()
    for name in levels:
        with level(name):
            results.append(function(*arguments))
    return [tuple(np.asarray(array).tobytes() for array in result) for result in results]


def seen(clip, faces, size=SIZE, **options):
    fragments = rasterize(clip, faces, size, (0.3, 0.6), **options)
    return (
        fragments.pixel,
        fragments.face,
        fragments.barycentric,
        fragments.along_x,
        fragments.along_y,
    )


# -- rasteriser ------------------------------------------------------------------------------------


@pytest.mark.parametrize("distance", [2.0, 0.5, 1.0])
def test_fragments_are_those_of_numpy_outside_a_body_and_within_it(distance):
    clip, faces = ball_in_view(distance=distance)
    assert_same_fragments(*both(rasterize, clip, faces, SIZE, (0.3, 0.6)))


@given(SEED)
def test_fragments_of_triangles_through_the_eye_are_those_of_numpy(seed):
    rng = np.random.default_rng(seed)
    clip = rng.normal(size=(30, 4)) * (1.0, 1.0, 1.0, 2.0)
    faces = rng.integers(0, 30, (20, 3))
    assert_same_fragments(*both(rasterize, clip, faces, SIZE))


@given(SEED, st.sampled_from([1e-12, 1e-3, 1e6, 1e12]))
def test_faces_of_any_size_cover_what_they_cover_by_numpy(seed, scale):
    rng = np.random.default_rng(seed)
    clip = rng.normal(size=(12, 4)) * (scale, scale, 1.0, 1.0)
    clip[:, 3] = np.abs(clip[:, 3]) + 0.1
    faces = rng.integers(0, 12, (8, 3))
    compiled, twin = both(rasterize, clip, faces, SIZE)
    assert compiled.pixel.tolist() == twin.pixel.tolist()


@pytest.mark.parametrize("size", [(1, 1), (3, 700), (700, 3)])
def test_pictures_of_any_shape_are_those_of_numpy(size):
    clip, faces = ball_in_view(2)
    assert_same_fragments(*both(rasterize, clip, faces, size))


def test_no_faces_cover_nothing():
    empty = np.zeros((0, 3), dtype=np.int64)
    assert rasterize(np.ones((3, 4)), empty, SIZE).pixel.size == 0
    nearest, facing_away = depth_maps(np.ones((3, 4)), np.ones(3), empty, SIZE)
    assert np.isinf(nearest).all()
    assert np.isinf(facing_away).all()


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 1e300])
def test_a_corner_that_is_not_finite_draws_nothing_outside_the_picture(value):
    clip, faces = ball_in_view(1)
    clip[:4, :2] = value
    pixel = rasterize(clip, faces, SIZE).pixel
    assert pixel.size > 0
    assert pixel.min() >= 0
    assert pixel.max() < SIZE[0] * SIZE[1]


def test_a_plane_under_the_eye_covers_the_rows_below_its_horizon():
    matrix = perspective(60.0, 1.0, 0.1, 100.0)
    floor = np.array([[-1e4, -1.0, 1e4], [1e4, -1.0, 1e4], [1e4, -1.0, -1e4], [-1e4, -1.0, -1e4]])
    clip = floor @ matrix[:, :3].T + matrix[:, 3]
    pixel = rasterize(clip, np.array([[0, 1, 2], [0, 2, 3]]), (200, 200)).pixel
    assert pixel.tolist() == list(range(20000, 40000))


def test_wide_faces_leave_no_gap_at_shared_edges():
    plane = shapes.square(2.5, 3)
    xy = plane.positions[:, :2] - 1.25
    w = np.random.default_rng(0).uniform(0.5, 3.0, len(xy))
    clip = np.column_stack([xy * w[:, None], 0.0 * w, w])
    assert rasterize(clip, plane.faces, (300, 200)).pixel.tolist() == list(range(60000))


def test_of_equal_depths_the_last_face_is_visible():
    clip = np.array([[-1.0, -1.0, 0.0, 1.0], [3.0, -1.0, 0.0, 1.0], [-1.0, 3.0, 0.0, 1.0]])
    faces = np.array([[0, 1, 2]] * 3)
    for fragments in both(rasterize, clip, faces, SIZE):
        assert (fragments.face == 2).all()


@pytest.mark.parametrize("opaque", [0, 400, 1280])
def test_hidden_points_show_the_faces_behind_them(opaque):
    clip, faces = ball_in_view()

    def hidden(face, barycentric):
        return (face >= opaque) & (barycentric[:, 0] < 0.4)

    arguments = (clip, faces, SIZE, (0.5, 0.5), hidden, opaque)
    assert_same_fragments(*both(rasterize, *arguments))


def test_a_function_that_hides_nothing_changes_nothing():
    clip, faces = ball_in_view()
    shown = rasterize(clip, faces, SIZE, hidden=lambda face, barycentric: None, opaque=10)
    assert_same_fragments(shown, rasterize(clip, faces, SIZE))


def test_depth_maps_are_those_of_numpy():
    clip, faces = ball_in_view()
    depth = np.linspace(1.0, 3.0, len(clip))
    for compiled, twin in zip(*both(depth_maps, clip, depth, faces, SIZE), strict=True):
        assert np.array_equal(np.isinf(compiled), np.isinf(twin))
        covered = np.isfinite(twin)
        assert np.allclose(compiled[covered], twin[covered], rtol=tol.NATIVE_RASTER.value)


def test_the_rasteriser_has_the_same_bytes_for_any_threads_and_instructions():
    clip, faces = ball_in_view()
    depth = np.linspace(1.0, 3.0, len(clip))
    assert len(set(in_bytes(seen, clip, faces))) == 1
    assert len(set(in_bytes(depth_maps, clip, depth, faces, SIZE))) == 1

    def half(face, barycentric):
        return barycentric[:, 0] < 0.5

    def holes():
        return seen(clip, faces, hidden=half, opaque=100)

    assert len(set(in_bytes(holes))) == 1


# -- taps ------------------------------------------------------------------------------------------


def receivers(seed, count=500):
    """Return uv, depth, radius and rise of points, some of them outside the map."""
    rng = np.random.default_rng(seed)
    return (
        rng.uniform(-0.2, 1.2, (count, 2)),
        rng.uniform(90.0, 110.0, count),
        rng.uniform(0.0, 0.1, (count, 2)),
        rng.uniform(-5.0, 5.0, (count, 2)),
    )


def depth_map(seed, size=(60, 40)):
    rng = np.random.default_rng(seed)
    depths = rng.uniform(90.0, 110.0, size).astype(np.float32).astype(np.float64)
    depths[rng.random(size) < 0.2] = np.inf
    return depths


@given(SEED, st.integers(0, 40), st.sampled_from([1, 16, 48]))
def test_taps_of_the_shadow_are_those_of_numpy(seed, count, taps):
    depths, points = depth_map(seed), receivers(seed, count)
    twin = lit_share(depths, *points, taps)
    single = depths.astype(np.float32)
    compiled = compiled_fetches.lit_share(single, *points, shadow_disk(taps))
    assert np.abs(compiled - twin).max(initial=0.0) <= tol.NATIVE_TAPS.value + 1.0 / taps
    assert np.abs(compiled - twin).mean() <= tol.NATIVE_TAPS.value if count > 30 else True


def test_a_straight_edge_in_the_depth_map_lets_half_of_the_light_pass():
    depths = np.full((64, 64), 100.0, dtype=np.float32)
    depths[:, :32] = 50.0
    middle = (np.full((1, 2), 0.5), np.array([90.0]), np.full((1, 2), 0.2), np.zeros((1, 2)))
    lit = compiled_fetches.lit_share(depths, *middle, shadow_disk(48))
    assert lit == pytest.approx(0.5, abs=1.0 / 48.0)


@given(SEED, st.integers(0, 40), st.sampled_from([8, 32]))
def test_taps_of_the_thickness_are_those_of_numpy(seed, count, taps):
    depths, (uv, receiver, radius, _) = depth_map(seed), receivers(seed, count)
    twin = mean_thickness(depths, uv, receiver, radius, taps)
    compiled = compiled_fetches.mean_thickness(depths, uv, receiver, radius, poisson_disk(taps))
    assert np.allclose(compiled, twin, rtol=tol.NATIVE_FETCH.value)


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 1e30])
def test_taps_at_positions_that_are_not_finite_stay_within_the_map(value):
    depths = depth_map(0)
    uv, receiver, radius, rise = receivers(0, 20)
    uv[:5], radius[5:10] = value, value
    lit = compiled_fetches.lit_share(
        depths.astype(np.float32), uv, receiver, radius, rise, shadow_disk(48)
    )
    thickness = compiled_fetches.mean_thickness(depths, uv, receiver, radius, poisson_disk(8))
    assert np.isfinite(lit[10:]).all()
    assert np.isfinite(thickness[10:]).all()


def test_taps_have_the_same_bytes_for_any_threads_and_instructions():
    depths, points = depth_map(1), receivers(1)
    single = depths.astype(np.float32)

    def lit():
        return (compiled_fetches.lit_share(single, *points, shadow_disk(48)),)

    def thickness():
        return (compiled_fetches.mean_thickness(depths, *points[:3], poisson_disk(32)),)

    assert len(set(in_bytes(lit))) == 1
    assert len(set(in_bytes(thickness))) == 1


# -- fetches ---------------------------------------------------------------------------------------


def image(seed, height, width, channels):
    rng = np.random.default_rng(seed)
    return rng.random((height, width, channels)).astype(np.float32)


@pytest.mark.parametrize("channels", [1, 2, 3, 4])
@pytest.mark.parametrize("size", [(1, 1), (16, 16), (13, 40), (64, 2)])
def test_trilinear_fetches_are_those_of_numpy(channels, size):
    texture = build_texture(image(0, *size, channels))
    rng = np.random.default_rng(1)
    uv, levels = rng.uniform(-3.0, 3.0, (3000, 2)), rng.uniform(-1.0, 9.0, 3000)
    compiled, twin = both(texture.sample, uv, levels)
    assert compiled.shape == (3000, channels)
    assert np.abs(compiled - twin).max() <= tol.NATIVE_FETCH.value


def test_a_trilinear_fetch_of_a_linear_ramp_is_exact():
    ramp = np.repeat(np.arange(64, dtype=np.float32)[None, :, None], 64, axis=0)
    texture = build_texture(ramp)
    u = np.linspace(0.2, 0.8, 200)
    levels = np.linspace(0.0, 3.0, 200)
    values = texture.sample(np.stack([u, 0.5 * u], axis=1), levels)[:, 0]
    assert np.abs(values - (64.0 * u - 0.5)).max() <= 64.0 * tol.NATIVE_FETCH.value


@pytest.mark.parametrize("value", HUGE)
def test_textures_at_any_coordinates_give_values_of_their_texels(value):
    texture = build_texture(image(0, 8, 8, 3))
    values = texture.sample(np.full((1, 2), value), np.zeros(1))
    assert values.shape == (1, 3)
    assert np.isfinite(values).all() or abs(value) > 1e17


@pytest.mark.parametrize("channels", [1, 2, 3, 4, 7])
@pytest.mark.parametrize("size", [(1, 1), (1, 9), (64, 1), (13, 40), (257, 300)])
def test_levels_of_a_texture_have_the_bytes_of_numpy(channels, size):
    source = image(3, *size, channels)
    one, other = both(build_texture, source)
    assert np.array_equal(one.texels, other.texels)
    for count in (1, 2, 5):
        with threads(count):
            assert np.array_equal(build_texture(source).texels, other.texels)


def test_textures_of_five_channels_are_sampled_by_numpy():
    texture = build_texture(image(0, 8, 8, 5))
    assert texture.sample(np.zeros((2, 2)), np.zeros(2)).shape == (2, 5)


@given(SEED)
def test_panorama_fetches_are_those_of_numpy(seed):
    rng = np.random.default_rng(seed)
    levels = rng.random((3, 6, 12, 3)).astype(np.float32)
    index = rng.integers(0, 3, (40, 2))
    u, v = rng.uniform(-0.5, 1.5, (40, 2)), rng.uniform(-0.1, 1.1, (40, 2))
    compiled, twin = both(bilinear, levels, index, u, v)
    assert compiled.shape == (40, 2, 3)
    assert np.abs(compiled - twin).max() <= tol.NATIVE_FETCH.value


@pytest.mark.parametrize("shape", [(), (1,), (20000,), (40, 3)])
def test_table_fetches_are_those_of_numpy(shape):
    values = image(2, 9, 17, 3)
    table = Lut(values, "curvature", Axis("x", "1", 0.0, 1.0), Axis("y", "1", 0.0, 1.0))
    rng = np.random.default_rng(3)
    u, v = rng.uniform(-0.2, 1.2, (*shape, 3)), rng.uniform(-0.2, 1.2, shape)
    for function, columns in ((table.sample_channels, u), (table.sample_at, u[..., 0])):
        compiled, twin = both(function, columns, v)
        assert compiled.shape == twin.shape
        assert np.abs(compiled - twin).max() <= tol.NATIVE_FETCH.value


@pytest.mark.parametrize("count", [0, 1, 63, 64, 65, 20000])
def test_interpolated_columns_are_those_of_numpy(count):
    rng = np.random.default_rng(4)
    width = 44
    table = VertexTable(rng.random((50, width)), rng.integers(0, 50, (70, 3)))
    face, weights = rng.integers(0, 70, count), rng.random((count, 3))
    compiled, twin = both(table.interpolated, face, weights)
    for name, values in compiled.items():
        assert values.shape == twin[name].shape
        assert np.allclose(values, twin[name], rtol=tol.NATIVE_FETCH.value)
    compiled, twin = both(table.mixed, "uv", face, weights)
    assert np.allclose(compiled, twin, rtol=tol.NATIVE_FETCH.value)


def test_fetches_have_the_same_bytes_for_any_threads_and_instructions():
    rng = np.random.default_rng(5)
    texture = build_texture(image(0, 32, 32, 3))
    uv, levels = rng.uniform(-3.0, 3.0, (3000, 2)), rng.uniform(-1.0, 9.0, 3000)
    table = VertexTable(rng.random((50, 44)), rng.integers(0, 50, (70, 3)))
    face, weights = rng.integers(0, 70, 3000), rng.random((3000, 3))
    assert len(set(in_bytes(lambda: (texture.sample(uv, levels),)))) == 1
    assert len(set(in_bytes(lambda: tuple(table.interpolated(face, weights).values())))) == 1


def test_numpy_serves_without_the_library():
    clip, faces = ball_in_view(1)
    with numpy_twins():
        assert not compiled_fetches.serves()
        assert rasterize(clip, faces, SIZE).pixel.size > 0
