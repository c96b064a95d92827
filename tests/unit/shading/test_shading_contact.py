"""Contact shadow as a term of the model: its slope, its filter over analytic depth maps, and its bleed."""

import numpy as np
import pytest

import shading_tolerances as tol
from skinshade.lut import build_shadow_lut
from skinshade.profile import Profile
from skinshade.shading.contact import (
    CONTACT_BIAS_MM,
    CONTACT_BIAS_PER_SLOPE_MM,
    CONTACT_FADE_FROM,
    CONTACT_FADE_TO,
    CONTACT_RADIUS_MM,
    contact_filter,
    contact_shadow,
    contact_slope,
    faded_contact,
)
from skinshade.shading.shadow import light_coordinates

SIZE, REACH_MM = 512, 70.0
TEXEL_MM = 2.0 * REACH_MM / SIZE
OTHER_HAND = np.diag([1.0, 1.0, -1.0, 1.0])
WIDTH_MM = 8.0
UP = np.array([0.0, 0.0, 1.0])


def light_matrices(hand="right"):
    """Return view and projection of a light above the origin that looks down on 140 mm."""
    view, projection = np.eye(4), np.diag([1.0 / REACH_MM, 1.0 / REACH_MM, -1e-3, 1.0])
    view[2, 3] = -500.0
    if hand == "left":
        return OTHER_HAND @ view, projection @ OTHER_HAND
    return view, projection


def texel_middles():
    """Return x and y (S, S) of the middles of the texels, mm."""
    middle = (2.0 * (np.arange(SIZE) + 0.5) / SIZE - 1.0) * REACH_MM
    return np.meshgrid(middle, -middle)


def contact_on(height_mm, points, normal, hand="right"):
    """Return the filter at points (N, 3) of faces with a normal (3,), below a surface of heights (S, S)."""
    view, projection = light_matrices(hand)
    depth = (500.0 - height_mm) * 1e-3
    normals, to_light = np.broadcast_to(normal, points.shape), np.broadcast_to(UP, points.shape)
    extent = np.full(2, float(SIZE))
    return contact_filter(depth, extent, view, projection, points, normals, to_light)


def on_plane(normal, count=200):
    """Return points (N, 3) of the plane through the origin with a normal (3,)."""
    points = np.random.default_rng(3).uniform(-20.0, 20.0, (count, 3))
    points[:, 2] = -(points[:, :2] @ normal[:2]) / normal[2]
    return points


@pytest.mark.parametrize("hand", ["right", "left"])
@pytest.mark.parametrize("cosine", [1.0, 0.5, 0.2, 0.06])
def test_a_flat_face_never_hides_itself_however_oblique_the_light(cosine, hand):
    sine = np.sqrt(1.0 - cosine**2)
    normal = np.array([0.6 * sine, -0.8 * sine, cosine])
    x, y = texel_middles()
    height = -(normal[0] * x + normal[1] * y) / cosine
    result = contact_on(height, on_plane(normal), normal, hand)
    assert result.min() >= 1.0 - tol.ROUNDING.value


@pytest.mark.parametrize("hand", ["right", "left"])
def test_the_slope_is_the_change_of_depth_to_the_right_and_down_in_the_map(hand):
    view, projection = light_matrices(hand)
    normal = np.array([0.48, 0.36, 0.8])
    right, up = np.array([1.0, 0.0, -0.6]), np.array([0.0, 1.0, -0.45])
    points = np.stack([np.zeros(3), right, -up])
    depth = light_coordinates(points, view, projection)[:, 2]
    slope = contact_slope(normal, UP, view[0, :3], view[1, :3])
    assert slope == pytest.approx(depth[1:] - depth[0], abs=tol.ROUNDING_SUMS.value)


def test_an_edge_hides_all_of_the_disk_on_one_side_and_nothing_on_the_other():
    x, _ = texel_middles()
    height = np.where(x < 0.0, 2.0, 0.0)
    along = np.linspace(-3.0, 3.0, 121)
    points = np.stack([along, np.full(121, 0.37), np.zeros(121)], axis=1)
    result = contact_on(height, points, UP)
    reach = CONTACT_RADIUS_MM + TEXEL_MM
    assert (result[along < -reach] == 0.0).all()
    assert result[along > reach] == pytest.approx(1.0, abs=tol.ROUNDING.value)
    assert result[60] == pytest.approx(0.5, abs=tol.CONTACT_EDGE.value)


@pytest.mark.parametrize("slope", [0.0, 2.0])
def test_a_surface_hides_a_face_if_it_rises_more_than_the_bias(slope):
    normal = np.array([-slope, 0.0, 1.0]) / np.hypot(1.0, slope)
    bias = CONTACT_BIAS_MM + CONTACT_BIAS_PER_SLOPE_MM * slope
    x, _ = texel_middles()
    points = on_plane(normal)
    assert contact_on(slope * x + 1.01 * bias, points, normal).max() == 0.0
    below = contact_on(slope * x + 0.99 * bias, points, normal)
    assert below == pytest.approx(1.0, abs=tol.ROUNDING.value)


def test_the_contact_shadow_fades_out_where_a_face_is_seen_edge_on():
    cosine = np.array([-1.0, CONTACT_FADE_FROM, CONTACT_FADE_TO, 1.0])
    result = faded_contact(np.zeros(4), cosine)
    assert result == pytest.approx([1.0, 1.0, 0.0, 0.0], abs=tol.ROUNDING.value)


def skin_table(sharpening=64.0):
    profile = Profile.preset("skin-deon2007")
    return profile, build_shadow_lut(
        profile, size=(2048, 64), width_mm=(WIDTH_MM, 160.0), sharpening=sharpening
    )


def test_the_bleed_is_the_light_of_a_half_plane_at_the_radius_from_its_edge():
    """The edge of a sharp table is a step, which the profile diffuses to a sum of Gaussian integrals."""
    from scipy.special import ndtr

    profile, lut = skin_table()
    mixture, _ = profile.gaussian_fit()
    truth = ndtr(-CONTACT_RADIUS_MM / np.asarray(mixture.sigmas_mm)) @ mixture.weights
    bleed = contact_shadow(lut, np.ones(3), np.array(0.0), WIDTH_MM)
    assert bleed == pytest.approx(truth, abs=tol.CONTACT_BLEED.value)


def test_contact_only_darkens_and_full_contact_changes_nothing():
    _, lut = skin_table(8.0)
    shadow = np.random.default_rng(5).random((64, 3))
    contact = np.linspace(0.0, 1.0, 64)
    result = contact_shadow(lut, shadow, contact, WIDTH_MM)
    assert (result <= shadow).all()
    assert (contact_shadow(lut, shadow, np.ones(64), WIDTH_MM) == shadow).all()
    lit = contact_shadow(lut, np.ones((64, 3)), contact, WIDTH_MM)
    assert (np.diff(lit, axis=0) > 0.0).all(), "light rises with the unhidden share"
