"""The wide shadow filter as a term of the model: receiver, receiver plane, disk and depth map.

The depth maps are analytic. The light stands `HEIGHT_MM` above the origin and looks down; its map has
other numbers of texels, and other extents in mm, along its two sides.
"""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import shading_tolerances as tol
from skinshade._core.errors import ArgumentError
from skinshade.shading.deep_scatter import linear_depth
from skinshade.shading.shadow import (
    ATTACHED_MM,
    HOLLOW_PER_MM,
    SHADOW_BIAS_MM,
    SHADOW_TAPS,
    STEEPEST_SLOPE,
    TERMINATOR_REACH_MM,
    light_coordinates,
    lit_share,
    shadow_disk,
    shadow_filter,
    shadow_occluder_depth,
    shadow_receiver,
    shadow_slope,
    smoothstep,
)

HEIGHT_MM, ROOF_MM = 700.0, 50.0
NEAR_MM, FAR_MM = 100.0, 900.0
EXTENT_MM = np.array([60.0, 40.0])
"""Half the width and half the height of the map, at the origin."""
SHAPE = (256, 512)
OTHER_HAND = np.diag([1.0, 1.0, -1.0, 1.0])
UP = np.array([0.0, 0.0, 1.0])
ALONG_MM = np.linspace(-12.0, 12.0, 97)
SEED = st.integers(0, 2**20)
ANGLE = st.floats(0.0, 2.0 * np.pi)

every_projection = pytest.mark.parametrize("kind", ["parallel", "perspective"])
every_hand = pytest.mark.parametrize("hand", ["right", "left"])


def matrices(kind, hand="right"):
    """Return view and projection (4, 4) of the light; left-handed views look along +z."""
    view, projection = np.eye(4), np.zeros((4, 4))
    view[2, 3] = -HEIGHT_MM
    depth = FAR_MM - NEAR_MM
    if kind == "parallel":
        projection[:2, :2] = np.diag(1.0 / EXTENT_MM)
        projection[2:, 2:] = [[-1.0 / depth, -NEAR_MM / depth], [0.0, 1.0]]
    else:
        projection[:2, :2] = np.diag(HEIGHT_MM / EXTENT_MM)
        projection[2:, 2:] = [[-FAR_MM / depth, -FAR_MM * NEAR_MM / depth], [-1.0, 0.0]]
    if hand == "left":
        return OTHER_HAND @ view, projection @ OTHER_HAND
    return view, projection


def stored(depth_mm, projection):
    """Return depths as a projection stores them."""
    z = depth_mm * np.sign(projection[3, 2] or projection[2, 2])
    a, b, c, d = projection[2:, 2:].ravel()
    return (a * z + b) / (c * z + d)


def texel_rays(projection):
    """Return x and y (H, W) of the texel centres: mm, or mm per mm of depth with perspective."""
    rows, columns = SHAPE
    x = (2.0 * (np.arange(columns) + 0.5) / columns - 1.0) / projection[0, 0]
    y = (1.0 - 2.0 * (np.arange(rows) + 0.5) / rows) / projection[1, 1]
    return np.meshgrid(x, y)


def to_light_at(points, kind):
    if kind == "parallel":
        return np.broadcast_to(UP, points.shape)
    towards = HEIGHT_MM * UP - points
    return towards / np.linalg.norm(towards, axis=-1, keepdims=True)


def roof_depths(projection, kind, azimuth, edge_mm):
    """Return the depths (H, W) of the floor z = 0 and of a roof that ends at a straight edge."""
    x, y = texel_rays(projection)
    scale = 1.0 if kind == "parallel" else HEIGHT_MM - ROOF_MM
    across = scale * (x * np.cos(azimuth) + y * np.sin(azimuth))
    return np.where(across < edge_mm, HEIGHT_MM - ROOF_MM, HEIGHT_MM)


def filter_at(
    points,
    normal,
    depth_mm,
    kind,
    hand="right",
    *,
    width_mm=8.0,
    bias_mm=SHADOW_BIAS_MM,
    taps=16,
    curvature_per_mm=0.0,
):
    """Return the filter (N,) at points (N, 3) of one normal (3,), from depths (H, W) of occluders."""
    view, projection = matrices(kind, hand)
    return shadow_filter(
        stored(depth_mm, projection),
        np.array(SHAPE[::-1], dtype=float),
        view,
        projection,
        points,
        np.broadcast_to(normal, points.shape),
        to_light_at(points, kind),
        np.full(len(points), curvature_per_mm),
        width_mm,
        bias_mm,
        taps,
    )


def across_the_edge(kind, hand, azimuth, edge_mm, width_mm=8.0, taps=16, nearest=False):
    """Return the filter on the floor at `ALONG_MM` from the edge of the roof's shadow."""
    depth = roof_depths(matrices(kind)[1], kind, azimuth, edge_mm)
    bias = SHADOW_BIAS_MM + ATTACHED_MM
    if not nearest:
        depth, bias = shadow_occluder_depth(depth, np.ones(())), SHADOW_BIAS_MM
    magnified = 1.0 if kind == "parallel" else HEIGHT_MM / (HEIGHT_MM - ROOF_MM)
    direction = np.array([np.cos(azimuth), np.sin(azimuth), 0.0])
    points = (magnified * edge_mm + ALONG_MM)[:, None] * direction
    return filter_at(points, UP, depth, kind, hand, width_mm=width_mm, bias_mm=bias, taps=taps)


# -- the receiver ----------------------------------------------------------------------------------


def unit(rng, *shape):
    v = rng.normal(size=(*shape, 3))
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


@given(SEED)
def test_the_receiver_moves_past_the_terminator_only(seed):
    rng = np.random.default_rng(seed)
    position, normal, light = rng.normal(0.0, 50.0, (40, 3)), unit(rng, 40), unit(rng, 40)
    receiver = shadow_receiver(position, normal, light, rng.uniform(-0.2, 0.2, 40))
    moved = (receiver != position).any(axis=1)
    assert np.array_equal(moved, (normal * light).sum(axis=1) < 0.0)


@given(SEED)
def test_the_receiver_moves_along_the_surface_towards_the_light_by_the_arc_or_its_limit(seed):
    rng = np.random.default_rng(seed)
    position, normal, light = rng.normal(0.0, 50.0, (40, 3)), unit(rng, 40), unit(rng, 40)
    curvature = rng.uniform(-0.2, 0.5, 40)
    step = shadow_receiver(position, normal, light, curvature) - position
    length, cosine = np.linalg.norm(step, axis=1), (normal * light).sum(axis=1)
    assert np.abs((step * normal).sum(axis=1)).max() <= tol.ROUNDING_SUMS.value
    assert ((step * light).sum(axis=1) >= -tol.ROUNDING_SUMS.value).all()
    assert length.max() <= TERMINATOR_REACH_MM + tol.ROUNDING_SUMS.value
    convex = (cosine < 0.0) & (curvature > 1e-3)
    arc = np.minimum(-cosine[convex] / curvature[convex], TERMINATOR_REACH_MM)
    assert np.abs(length[convex] - arc).max(initial=0.0) <= tol.ROUNDING_SUMS.value
    flat = (cosine < -0.01) & (curvature <= 1e-3)
    assert np.abs(length[flat] - TERMINATOR_REACH_MM).max(initial=0.0) <= tol.ROUNDING_SUMS.value


@given(st.floats(0.0, 0.3), st.floats(1.0, 20.0), ANGLE)
def test_on_a_sphere_the_receiver_reaches_the_terminator_to_third_order(past, radius, azimuth):
    across = np.sqrt(1.0 - past**2)
    normal = np.array([[across * np.cos(azimuth), across * np.sin(azimuth), -past]])
    curvature = np.array([1.0 / radius])
    receiver = shadow_receiver(radius * normal, normal, UP[None], curvature)
    assert abs(receiver[0, 2]) <= radius * past**3 + tol.ROUNDING_SUMS.value


# -- the receiver plane ----------------------------------------------------------------------------


def light_axes(seed):
    """Return right, up and direction to the light, orthonormal."""
    turn = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))[0]
    return turn[0], turn[1], np.cross(turn[0], turn[1])


@given(SEED, ANGLE, st.floats(0.0, STEEPEST_SLOPE))
def test_the_slope_is_the_change_of_depth_of_the_plane_to_the_right_and_down(seed, azimuth, slope):
    right, up, light = light_axes(seed)
    to_right, to_down = slope * np.cos(azimuth), slope * np.sin(azimuth)
    # Depth counts away from the light: this normal is perpendicular to both steps in the plane.
    normal = np.cross(right - to_right * light, up + to_down * light)[None]
    normal /= np.linalg.norm(normal)
    result = shadow_slope(normal, light[None], np.zeros(1), right, up)[0]
    assert result == pytest.approx([to_right, to_down], abs=tol.ROUNDING_SUMS.value)


@given(SEED, st.floats(-0.2, 0.2))
def test_facing_the_light_the_slope_is_0(seed, curvature):
    right, up, light = light_axes(seed)
    result = shadow_slope(light[None], light[None], np.array([curvature]), right, up)
    assert np.abs(result).max() <= tol.ROUNDING.value


@given(SEED, st.floats(-0.2, 0.2))
def test_the_slope_is_limited_and_in_a_hollow_the_limit_falls_to_1(seed, curvature):
    right, up, light = light_axes(seed)
    normal = unit(np.random.default_rng(seed + 1), 40)
    result = shadow_slope(normal, light[None], np.full(40, curvature), right, up)
    limit = 1.0 + (STEEPEST_SLOPE - 1.0) * np.clip(1.0 + curvature / HOLLOW_PER_MM, 0.0, 1.0)
    length = np.linalg.norm(result, axis=1)
    assert length.max() <= limit + tol.ROUNDING_SUMS.value
    past = normal @ light < 0.0
    assert np.abs(length[past] - limit).max(initial=0.0) <= tol.ROUNDING_SUMS.value
    # The limit shortens the slope and keeps its direction, that of the normal across the light.
    across = np.stack([normal @ right, -(normal @ up)], axis=1)
    turned = result[:, 0] * across[:, 1] - result[:, 1] * across[:, 0]
    assert np.abs(turned).max() <= tol.ROUNDING_SUMS.value
    assert ((result * across).sum(axis=1) >= 0.0).all()


# -- the disk, the coordinates and the map ---------------------------------------------------------


@pytest.mark.parametrize("taps", SHADOW_TAPS)
def test_the_share_of_the_disk_on_one_side_of_a_line_is_a_smoothstep(taps):
    disk = shadow_disk(taps)
    assert disk.shape == (taps, 2)
    assert np.linalg.norm(disk, axis=1).max() < 1.0
    position = np.linspace(-1.0, 1.0, 401)
    for angle in np.radians(np.arange(0.0, 360.0, 3.0)):
        along = disk @ [np.cos(angle), np.sin(angle)]
        share = (along < position[:, None]).mean(axis=1)
        error = np.abs(share - smoothstep(0.5 * position + 0.5)).max()
        assert error <= tol.SHADOW_DISK[taps].value


@pytest.mark.parametrize("taps", [0, -3, 257])
def test_a_disk_with_a_number_of_taps_outside_1_to_256_is_an_error(taps):
    with pytest.raises(ArgumentError, match=f"taps is {taps}; it must be 1..256"):
        shadow_disk(taps)


@every_hand
@every_projection
@given(seed=SEED)
def test_light_coordinates_are_uv_with_v_down_depth_in_mm_and_clip_w(kind, hand, seed):
    view, projection = matrices(kind, hand)
    points = np.random.default_rng(seed).uniform(-30.0, 30.0, (20, 3))
    u, v, depth, w = light_coordinates(points, view, projection).T
    expected_w, scale = np.ones(20), np.ones(20)
    if kind == "perspective":
        expected_w, scale = depth, depth / HEIGHT_MM
    x, y = (points[:, :2] / (EXTENT_MM * scale[:, None])).T
    assert depth == pytest.approx(HEIGHT_MM - points[:, 2], rel=tol.ROUNDING.value)
    assert w == pytest.approx(expected_w, rel=tol.ROUNDING.value)
    assert u == pytest.approx(0.5 + 0.5 * x, abs=tol.ROUNDING.value)
    assert v == pytest.approx(0.5 - 0.5 * y, abs=tol.ROUNDING.value)
    depth_of_map = linear_depth(stored(depth, projection), projection)
    assert depth_of_map == pytest.approx(depth, rel=tol.DEPTH.value)


@given(st.floats(1.0, 1000.0))
def test_a_map_stores_faces_towards_the_light_deeper_and_others_at_their_depth(depth):
    result = shadow_occluder_depth(np.array([depth, depth]), np.array([1.0, 0.0]))
    assert result.tolist() == [depth + ATTACHED_MM, depth]


@given(st.floats(0.0, 1.0), st.floats(0.0, 1.0))
def test_results_of_comparisons_are_interpolated_between_four_texels(right, down):
    depths = np.array([[90.0, 110.0], [110.0, 110.0]])
    uv = np.array([[0.25 + 0.5 * right, 0.25 + 0.5 * down]])
    lit = lit_share(depths, uv, np.array([100.0]), np.zeros((1, 2)), np.zeros((1, 2)), 1)
    assert lit[0] == pytest.approx(1.0 - (1.0 - right) * (1.0 - down), abs=tol.ROUNDING.value)


@given(SEED, st.sampled_from(SHADOW_TAPS))
def test_lookups_outside_the_map_clamp_to_its_edge(seed, taps):
    """A map that is extended by copies of its edge gives the same result."""
    rng = np.random.default_rng(seed)
    rows, columns, margin = 24, 32, 48
    depths = rng.uniform(100.0, 110.0, (rows, columns))
    uv, radius = rng.uniform(-0.4, 1.4, (30, 2)), rng.uniform(0.0, 0.2, (30, 2))
    receiver, rise = rng.uniform(100.0, 110.0, 30), rng.uniform(-2.0, 2.0, (30, 2))
    size = np.array([columns, rows])
    extended = np.pad(depths, margin, mode="edge")
    shifted = (uv * size + margin) / (size + 2 * margin)
    result = lit_share(depths, uv, receiver, radius, rise, taps)
    expected = lit_share(
        extended, shifted, receiver, radius * size / (size + 2 * margin), rise, taps
    )
    assert np.abs(result - expected).max() <= tol.ROUNDING_SUMS.value
    assert ((result >= 0.0) & (result <= 1.0)).all()


@given(SEED, st.floats(0.0, 3.0))
def test_a_receiver_farther_from_the_light_is_darker_or_equally_lit(seed, farther):
    rng = np.random.default_rng(seed)
    depths, uv = rng.uniform(100.0, 110.0, (16, 16)), rng.random((30, 2))
    receiver, radius = rng.uniform(95.0, 115.0, 30), np.full((30, 2), 0.15)
    near = lit_share(depths, uv, receiver, radius, np.zeros((30, 2)), 16)
    far = lit_share(depths, uv, receiver + farther, radius, np.zeros((30, 2)), 16)
    assert (far <= near).all()


# -- the whole filter ------------------------------------------------------------------------------


@pytest.mark.parametrize("width_mm", [4.0, 8.0, 16.0])
@pytest.mark.parametrize("taps", SHADOW_TAPS)
@every_projection
def test_across_a_straight_edge_the_filter_is_a_smoothstep_of_its_width(kind, taps, width_mm):
    """The edge of a roof over a floor, in 12 directions, at and beside the middle of the map.

    The directions are oblique to the texels: along them a map moves an edge by up to half a texel.
    """
    limit = tol.SHADOW_PROFILE if taps == 48 else tol.SHADOW_PROFILE_16_TAPS
    expected = smoothstep(ALONG_MM / width_mm + 0.5)
    for azimuth in np.radians(np.arange(15.0, 360.0, 30.0)):
        for edge_mm in (0.0, 7.3):
            lit = across_the_edge(kind, "right", azimuth, edge_mm, width_mm, taps)
            assert np.abs(lit - expected).max() <= limit.value, (azimuth, edge_mm)
            outside = 0.5 * width_mm + 1.0
            assert (lit[-outside > ALONG_MM] == 0.0).all()
            assert (lit[outside < ALONG_MM] == 1.0).all()


@every_projection
@given(azimuth=ANGLE, edge_mm=st.floats(-8.0, 8.0))
def test_views_of_either_hand_give_the_same_filter(kind, azimuth, edge_mm):
    right, left = (across_the_edge(kind, hand, azimuth, edge_mm) for hand in ("right", "left"))
    assert np.abs(right - left).max() <= tol.ROUNDING.value
    assert 0.0 < right.mean() < 1.0


@every_projection
@given(azimuth=ANGLE, edge_mm=st.floats(-8.0, 8.0))
def test_a_map_of_the_nearest_surface_gives_the_same_filter_with_the_greater_bias(
    kind, azimuth, edge_mm
):
    occluders, nearest = (
        across_the_edge(kind, "right", azimuth, edge_mm, nearest=nearest)
        for nearest in (False, True)
    )
    assert np.array_equal(occluders, nearest)


@every_projection
@pytest.mark.parametrize("bias_mm", [SHADOW_BIAS_MM, SHADOW_BIAS_MM + ATTACHED_MM])
def test_an_occluder_shadows_only_receivers_farther_behind_it_than_the_bias(kind, bias_mm):
    for before_mm, expected in ((bias_mm - 0.01, 1.0), (bias_mm + 0.01, 0.0)):
        occluder = np.full(SHAPE, HEIGHT_MM - before_mm)
        lit = filter_at(np.zeros((1, 3)), UP, occluder, kind, bias_mm=bias_mm)
        assert lit.tolist() == [expected]


def plane_depths(projection, kind, slope):
    """Return the depths (H, W) of a plane through the origin; slope to +x and +y, mm per mm."""
    x, y = texel_rays(projection)
    rise = slope[0] * x + slope[1] * y
    return HEIGHT_MM + rise if kind == "parallel" else HEIGHT_MM / (1.0 - rise)


@every_hand
@every_projection
@given(azimuth=ANGLE, slope=st.floats(0.0, STEEPEST_SLOPE), curvature=st.floats(0.0, 0.1))
def test_a_lit_plane_does_not_shadow_itself_at_any_slope_up_to_the_limit(
    kind, hand, azimuth, slope, curvature
):
    """With perspective the depth of a plane is not linear in the map: the point is on the axis."""
    gradient = slope * np.array([np.cos(azimuth), np.sin(azimuth)])
    depth = plane_depths(matrices(kind)[1], kind, gradient)
    offsets = np.array(
        [[0.0, 0.0], [5.0, 3.0], [-11.0, 6.0]] if kind == "parallel" else [[0.0, 0.0]]
    )
    points = np.column_stack([offsets, -offsets @ gradient])
    normal = np.array([*gradient, 1.0]) / np.sqrt(1.0 + slope**2)
    occluder = shadow_occluder_depth(depth, np.ones(()))
    lit = filter_at(points, normal, occluder, kind, hand, taps=48, curvature_per_mm=curvature)
    assert (lit == 1.0).all()
