"""Shape of an eye and refraction by one surface, beside a tracer of both surfaces of the cornea."""

from __future__ import annotations

import numpy as np
import pytest

import shading_tolerances as tol
from eye_truth import TrueEye, parallel_view, tilted
from skinshade.params import EyeParams
from skinshade.shading.eye import (
    eye_cornea_hit,
    eye_height,
    eye_iris_hit,
    eye_iris_parallax,
    eye_iris_uv,
    eye_limbal_opacity,
    eye_normal,
)

EYE, TRUTH = EyeParams(), TrueEye()
ANGLES = [0.0, 20.0, 40.0, 60.0, 70.0, 80.0]


def refraction_rms(truth, angle_deg, index=EYE.refraction_index):
    """Return the error of the visible points of the iris, mm, in a parallel view of the cornea."""
    point, normal, view, hit, weight = parallel_view(truth, angle_deg)
    cornea = np.array([*EYE.cornea[:3], index])
    error = eye_iris_hit(point, normal, view, cornea, EYE.iris) - hit
    return np.sqrt(np.sum(weight * np.sum(error**2, axis=-1)) / np.sum(weight))


def surface_points(r):
    phi = np.linspace(0.0, 6.0, r.size)
    z = eye_height(r, EYE.cornea, EYE.limbus)
    return np.stack([r * np.cos(phi), r * np.sin(phi), z], axis=-1)


# -- shape -----------------------------------------------------------------------------------------


def test_height_and_normals_are_those_of_the_true_front():
    r = np.linspace(0.0, 11.0, 400)
    phi = np.linspace(0.0, 40.0, r.size)
    point, normal = TRUTH.surface(r * np.cos(phi), r * np.sin(phi))
    assert (
        np.abs(eye_height(r, EYE.cornea, EYE.limbus) - point[:, 2]).max() <= tol.EYE_SURFACE.value
    )
    own = eye_normal(point, EYE.cornea, EYE.limbus)
    assert np.abs(own - normal).max() <= tol.EYE_SURFACE.value


@pytest.mark.parametrize("edge", [5.3, 6.5])
def test_the_blend_meets_cornea_and_sclera_without_a_crease(edge):
    r = np.array([edge - 1e-9, edge + 1e-9])
    height = eye_height(r, EYE.cornea, EYE.limbus)
    assert abs(np.diff(height)[0]) <= tol.EYE_SLOPE_JUMP.value
    normal = eye_normal(np.stack([r, 0.0 * r, height], axis=-1), EYE.cornea, EYE.limbus)
    assert np.abs(np.diff(normal[:, 0] / normal[:, 2])).max() <= tol.EYE_SLOPE_JUMP.value


def test_the_slope_of_the_normal_is_the_derivative_of_the_height():
    r, step = np.linspace(0.1, 9.0, 300), 1e-5
    rise = eye_height(r + step, EYE.cornea, EYE.limbus) - eye_height(
        r - step, EYE.cornea, EYE.limbus
    )
    points = np.stack([r, 0.0 * r, eye_height(r, EYE.cornea, EYE.limbus)], axis=-1)
    normal = eye_normal(points, EYE.cornea, EYE.limbus)
    assert np.abs(-normal[:, 0] / normal[:, 2] - rise / (2.0 * step)).max() <= tol.EYE_SLOPE.value


def test_the_normal_behind_the_middle_of_the_eye_is_that_of_the_sclera():
    point = np.array([[1.0, 2.0, -11.8], [3.0, 0.0, -11.0]])
    expected = point / np.linalg.norm(point, axis=-1, keepdims=True)
    assert np.abs(eye_normal(point, EYE.cornea, EYE.limbus) - expected).max() <= tol.ROUNDING.value


def test_the_limbus_is_clear_inside_half_opaque_at_its_radius_and_opaque_outside():
    opacity = eye_limbal_opacity(np.array([0.0, 5.3, 5.9, 6.5, 12.0]), EYE.limbus)
    assert np.abs(opacity - [0.0, 0.0, 0.5, 1.0, 1.0]).max() <= tol.ROUNDING.value


# -- rays ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("offset", [3.0, -1.5])
def test_rays_meet_the_cornea_from_in_front_and_from_a_mesh_inside(offset):
    target = surface_points(np.linspace(0.0, 5.2, 60))
    direction = -np.broadcast_to(tilted(25.0)[0], target.shape)
    hit = eye_cornea_hit(target - offset * direction, direction, EYE.cornea)
    assert (hit[:, 3] == 1.0).all()
    assert np.abs(hit[:, :3] - target).max() <= tol.EYE_ON_SURFACE.value


def test_a_ray_beside_the_cornea_stays_at_its_origin():
    origin = np.array([[0.0, 20.0, 20.0], [0.0, 0.0, 20.0]])
    direction = np.array([[0.0, 0.0, -1.0], [0.0, 0.0, 1.0]])
    hit = eye_cornea_hit(origin, direction, EYE.cornea)
    assert np.array_equal(hit[:, :3], origin)
    assert hit[:, 3].tolist() == [0.0, 0.0]


@pytest.mark.parametrize("slope", [-0.2, 0.0, 0.08, 0.2])
@pytest.mark.parametrize("angle", [0.0, 40.0, 75.0])
def test_refracted_rays_end_on_the_cone_of_the_iris(slope, angle):
    eye = EyeParams(iris_slope=slope, iris_depth_mm=4.0)
    point, normal, view, _, _ = parallel_view(TRUTH, angle, side=24)
    hit = eye_iris_hit(point, normal, view, eye.cornea, eye.iris)
    r = np.hypot(hit[:, 0], hit[:, 1])
    assert np.abs(hit[:, 2] - (eye.iris[0] - slope * r)).max() <= tol.EYE_ON_SURFACE.value


@pytest.mark.parametrize("angle", ANGLES)
def test_one_refraction_shows_the_point_that_both_surfaces_show(angle):
    assert refraction_rms(TRUTH, angle) <= tol.EYE_REFRACTION.value


def test_one_refraction_errs_by_a_hundredth_of_a_millimetre_over_all_angles():
    rms = [refraction_rms(TRUTH, angle) for angle in ANGLES]
    assert np.sqrt(np.mean(np.square(rms))) <= tol.EYE_REFRACTION_ALL.value


@pytest.mark.parametrize(
    "back", [(6.4, -0.60, 0.50), (6.5, 0.0, 0.55), (6.4, -0.60, 0.55, 1.3374)], ids=repr
)
def test_the_index_fits_three_published_corneas_best(back):
    truth = TRUTH.with_cornea(*back)
    indices = np.arange(1.334, 1.348, 0.001)
    errors = [
        sum(refraction_rms(truth, angle, index) ** 2 for angle in (20.0, 60.0)) for index in indices
    ]
    assert abs(indices[np.argmin(errors)] - 1.3405) <= tol.EYE_OTHER_CORNEAS.value


def test_the_pupil_looks_13_per_cent_larger():
    apparent = np.linspace(2.0, 2.5, 101)
    hit, _, _ = TRUTH.traced(apparent, 0.0 * apparent, tilted(0.0, apparent.size))
    point, normal = TRUTH.surface(apparent, 0.0 * apparent)
    own = eye_iris_hit(point, normal, tilted(0.0, apparent.size), EYE.cornea, EYE.iris)
    for x in (hit[:, 0], own[:, 0]):
        assert abs(np.interp(2.0, x, apparent) / 2.0 - 1.13) <= tol.EYE_PUPIL.value


# -- maps ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("pupil", [1.0, 2.0, 4.0])
def test_the_map_of_the_iris_stretches_from_the_pupil_to_the_rim(pupil):
    eye = EyeParams(pupil_radius_mm=pupil)
    hit = np.array([[0.0, 0.0, 9.4], [0.0, pupil, 9.3], [6.0, 0.0, 9.0], [-9.0, 0.0, 8.7]])
    uv = eye_iris_uv(hit, eye.iris, np.array(0.3), np.array([0.5, 0.5, 0.5, 0.0]))
    expected = [[0.5, 0.5], [0.5, 0.35], [1.0, 0.5], [0.0, 0.5]]
    assert np.abs(uv - expected).max() <= tol.ROUNDING.value


def test_the_map_of_the_iris_may_lie_anywhere_and_be_turned():
    uv = eye_iris_uv(
        np.array([6.0, 0.0, 9.0]), EYE.iris, np.array(0.3), np.array([1.25, 0.5, 0.2, 0.25])
    )
    assert np.abs(uv - [1.25, 0.3]).max() <= tol.ROUNDING.value


def test_relief_of_the_iris_moves_points_towards_the_viewer_by_its_height():
    hit, normal = np.array([[1.0, 2.0, 9.2]]), np.array([[0.0, 0.0, 1.0]])
    direction = -tilted(30.0)
    flat = eye_iris_parallax(hit, direction, normal, np.array([0.0]))
    raised = eye_iris_parallax(hit, direction, normal, np.array([0.3]))
    assert np.array_equal(flat, hit)
    assert abs((raised - hit)[0, 2] - 0.3) <= tol.ROUNDING.value
    assert (raised - hit)[0, 0] > 0.0
