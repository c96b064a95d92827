"""Light at the back of a cylinder that is lit from one side, beside a random walk in its medium."""

import numpy as np
import pytest

import shading_tolerances as tol
import skinshade as sk
from skinshade.shading.deep_scatter import (
    default_sigma_per_mm,
    direct_deep_scatter,
    through_beyond,
    transmittance,
)
from skinshade.shading.energy import energy_gain

ALBEDO = 0.545
RADIUS_MM = 3.67
"""Radius of Blender's skin closure; the mean free path of its walk is .813 mm."""
FREE_PATH_MM, SINGLE_ALBEDO = 0.813, 0.9316
"""Medium of the walk: the albedo of a half-space with this single scattering albedo is `ALBEDO`."""
PHOTONS, BINS = 60_000, 18
PROFILE = sk.Profile.burley(length_mm=RADIUS_MM, kind="blender-skin-radius", albedo=ALBEDO)
ANGLES = (np.arange(BINS) + 0.5) / BINS * 0.5 * np.pi
"""Angles from the middle of the back."""


def random_walk(radius_mm):
    """Return the radiosity (BINS,) of the back of a cylinder, over the irradiance that faces the light."""
    rng = np.random.default_rng(3)
    x = rng.uniform(-radius_mm, radius_mm, PHOTONS)
    point = np.stack([x, np.sqrt(radius_mm**2 - x * x)], axis=1)
    normal = point / radius_mm
    # Lambertian entry; the component along the cylinder only lengthens the path.
    cosine = np.sqrt(rng.random(PHOTONS))
    turn = 2.0 * np.pi * rng.random(PHOTONS)
    across = np.sqrt(1.0 - cosine**2) * np.cos(turn)
    flat = -cosine[:, None] * normal + across[:, None] * normal[:, ::-1] * (1.0, -1.0)
    weight = np.ones(PHOTONS)
    light = np.zeros(BINS)
    while weight.size:
        step = -FREE_PATH_MM * np.log(rng.random(weight.size))
        a, b = (flat * flat).sum(axis=1), (point * flat).sum(axis=1)
        c = (point * point).sum(axis=1) - radius_mm**2
        exit_mm = (np.sqrt(np.maximum(b * b - a * c, 0.0)) - b) / np.maximum(a, 1e-12)
        leaves = step >= exit_mm
        left = point[leaves] + exit_mm[leaves, None] * flat[leaves]
        angle = np.arccos(np.clip(-left[:, 1] / radius_mm, -1.0, 1.0))
        light += np.histogram(angle, BINS, (0.0, 0.5 * np.pi), weights=weight[leaves])[0]
        point = (point + step[:, None] * flat)[~leaves]
        weight = weight[~leaves] * SINGLE_ALBEDO
        z, turn = rng.uniform(-1.0, 1.0, weight.size), 2.0 * np.pi * rng.random(weight.size)
        flat = np.sqrt(1.0 - z * z)[:, None] * np.stack([np.cos(turn), np.sin(turn)], axis=1)
        faint = weight < 1e-3
        ends = faint & (rng.random(weight.size) > 0.1)
        weight = np.where(faint, 10.0 * weight, weight)[~ends]
        point, flat = point[~ends], flat[~ends]
    area = 2.0 * radius_mm * 0.5 * np.pi / BINS
    return light * 2.0 * radius_mm / PHOTONS / area


def model(radius_mm):
    """Return diffused light and light through the body (BINS,), both times the albedo."""
    lut = sk.build_curvature_lut(
        PROFILE, size=(256, 64), radius_mm=(1.0, 20.0), kernel="ring", energy_gain=False
    )
    diffused = np.array([lut.sample(-np.cos(angle), 1.0 / radius_mm)[0] for angle in ANGLES])
    gain = energy_gain(PROFILE.albedo, PROFILE.rms_radius_mm, np.array([[0.5 / radius_mm]]))[0, 0]
    sigma = default_sigma_per_mm(PROFILE.rms_radius_mm)
    passed = transmittance(2.0 * radius_mm * np.cos(ANGLES), PROFILE.albedo, sigma)
    through = direct_deep_scatter(passed / PROFILE.albedo, -np.cos(ANGLES), 1.0)[:, 0]
    return ALBEDO * gain * diffused, ALBEDO * through


@pytest.mark.parametrize("radius_mm", [1.5, 2.0, 3.0])
def test_the_back_of_a_thin_cylinder_has_the_light_of_a_random_walk(radius_mm):
    truth = random_walk(radius_mm).mean()
    diffused, through = model(radius_mm)
    together = diffused + through_beyond(through, diffused)
    assert together.mean() == pytest.approx(truth, rel=tol.THIN_PARTS.value)
    assert (diffused + through).mean() > 1.35 * truth, "both describe the same light"


def test_only_the_excess_over_diffused_light_comes_through():
    rng = np.random.default_rng(1)
    through, diffused = rng.random((2, 100, 3))
    assert np.array_equal(
        diffused + through_beyond(through, diffused), np.maximum(through, diffused)
    )
