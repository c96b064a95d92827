"""Light on the iris from the tables beside photons and Newton's method; reflection by tears; the pupil."""

from __future__ import annotations

import numpy as np
import pytest

import shading_tolerances as tol
from eye_truth import (
    FATES,
    TrueEye,
    irradiance_in_bins,
    newton_irradiance,
    photons,
    reflectance,
    tilted,
)
from skinshade.params import EyeParams
from skinshade.shading.eye import eye_height, eye_iris_hit, eye_limbal_opacity, eye_normal
from skinshade.shading.eye_light import (
    dielectric_fresnel,
    eye_ambient,
    eye_inside,
    eye_light,
    lamp_highlight,
    pupil_radius,
)
from skinshade.shading.eye_tables import build_eye_lut

EYE, TRUTH = EyeParams(), TrueEye()


@pytest.fixture(scope="module")
def luts():
    return build_eye_lut()


def on_cone(xy):
    r = np.hypot(xy[..., 0], xy[..., 1])
    return np.concatenate([xy, (EYE.iris[0] - EYE.iris[1] * r)[..., None]], axis=-1)


def lit(luts, xy, angle_deg):
    """Return irradiance and entry at points (..., 2) of the iris."""
    hit = on_cone(xy)
    return eye_light(luts.lamp, hit, np.broadcast_to(tilted(angle_deg)[0], hit.shape))


# -- lamps -----------------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("angle", tol.EYE_TABLE_PHOTONS)
def test_the_table_of_a_lamp_agrees_with_photons(luts, angle):
    centres, irradiance = irradiance_in_bins(TRUTH, angle, 400_000)
    inside = (
        np.stack(np.meshgrid(*[np.arange(4) + 0.5] * 2), axis=-1).reshape(-1, 2) / 4 - 0.5
    ) * 0.5
    own = lit(luts, centres[:, None] + inside, angle)[..., 0].mean(axis=1)
    rms = np.sqrt(np.mean((own - irradiance) ** 2))
    assert rms <= tol.EYE_TABLE_PHOTONS[angle].value


@pytest.mark.parametrize("angle", [0.0, 20.0, 40.0, 60.0])
def test_the_table_of_a_lamp_agrees_with_newtons_method(luts, angle):
    r, phi = np.meshgrid(np.linspace(0.2, 4.5, 6), np.linspace(0.0, np.pi, 7))
    target = np.stack([r * np.cos(phi), r * np.sin(phi)], axis=-1).reshape(-1, 2)
    irradiance, entry = newton_irradiance(TRUTH, target, tilted(angle)[0])
    own = lit(luts, target, angle)
    assert np.isfinite(irradiance).all()
    assert np.sqrt(np.mean((own[:, 0] - irradiance) ** 2)) <= tol.EYE_TABLE_ORACLE.value
    assert np.sqrt(np.mean((own[:, 1:] - entry) ** 2)) <= tol.EYE_TABLE_ENTRY.value


@pytest.mark.parametrize("angle", [0.0, 50.0])
def test_the_table_holds_the_flux_that_reaches_the_iris(luts, angle):
    _, _, _, sums, arriving = photons(TRUTH, angle, 200_000)
    assert abs(sum(sums[name] for name in FATES) / arriving - 1.0) <= tol.EYE_FLUX_BALANCE.value
    line = (np.arange(96) + 0.5) / 8.0 - 6.0
    xy = np.stack(np.meshgrid(line, line), axis=-1).reshape(-1, 2)
    xy = xy[np.hypot(xy[:, 0], xy[:, 1]) < 6.0]
    area = np.sqrt(1.0 + EYE.iris_slope**2) / 64.0
    flux = lit(luts, xy, angle)[:, 0].sum() * area
    assert abs(flux / sums["iris"] - 1.0) <= tol.EYE_TABLE_FLUX.value


def test_straight_light_is_80_per_cent_on_the_iris_and_2_per_cent_reflected():
    _, _, _, sums, arriving = photons(TRUTH, 0.0, 100_000)
    shares = [sums[name] / arriving for name in ("iris", "limbus", "reflected")]
    assert np.abs(np.subtract(shares, [0.80, 0.17, 0.023])).max() <= tol.EYE_FLUX_SHARE.value


def test_light_turns_with_the_lamp_and_is_mirrored_with_the_point(luts):
    rng = np.random.default_rng(1)
    xy = rng.uniform(-4.0, 4.0, (50, 2))
    light = np.broadcast_to(tilted(50.0)[0], (50, 3))
    base = eye_light(luts.lamp, on_cone(xy), light)
    c, s = np.cos(2.0), np.sin(2.0)
    turn = np.array([[c, -s], [s, c]])
    turned_light = np.concatenate([light[:, :2] @ turn.T, light[:, 2:]], axis=1)
    turned = eye_light(luts.lamp, on_cone(xy @ turn.T), turned_light)
    assert np.abs(turned[:, 0] - base[:, 0]).max() <= tol.ROUNDING_SUMS.value
    assert np.abs(turned[:, 1:] - base[:, 1:] @ turn.T).max() <= tol.ROUNDING_SUMS.value
    mirrored = eye_light(luts.lamp, on_cone(xy * [1.0, -1.0]), light)
    assert np.abs(mirrored - base * [1.0, 1.0, -1.0]).max() <= tol.ROUNDING_SUMS.value


def test_light_from_behind_does_not_reach_the_iris(luts):
    assert lit(luts, np.array([[0.0, 0.0], [3.0, 0.0]]), 130.0)[:, 0].max() <= 0.01


# -- surroundings ----------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def sky_photons():
    """Distance from the axis and response to bands of photons of an even sky, at points turned to +x."""
    rng = np.random.default_rng(2)
    count, outer = 500_000, TRUTH.limbus + TRUTH.blend
    r, phi = outer * np.sqrt(rng.random(count)), 2 * np.pi * rng.random(count)
    z = rng.uniform(-0.35, 1.0, count)
    turn = 2 * np.pi * rng.random(count)
    light = np.stack([np.sqrt(1 - z * z) * np.cos(turn), np.sqrt(1 - z * z) * np.sin(turn), z], -1)
    x, y = r * np.cos(phi), r * np.sin(phi)
    hit, passed, cosine = TRUTH.traced(x, y, light)
    point, normal = TRUTH.surface(x, y)
    passed = np.where(TRUTH.hidden_by_sclera(point, light), np.nan, passed)
    flux = np.nan_to_num(passed) * cosine / normal[:, 2] * (1 - TRUTH.opacity(r))
    flux *= 2 * np.pi * 1.35 * np.pi * outer**2 / count / np.sqrt(1 + TRUTH.slope**2) / np.pi
    used = flux > 0
    hit, light, flux = hit[used], light[used], flux[used]
    radius = np.hypot(hit[:, 0], hit[:, 1])
    along = (hit[:, 0] * light[:, 0] + hit[:, 1] * light[:, 1]) / radius
    return radius, np.stack([along, light[:, 2]], -1), flux


@pytest.mark.slow
@pytest.mark.parametrize("band", [0, 1, 2])
@pytest.mark.parametrize("ring", [(0.0, 1.5), (1.5, 3.0), (3.5, 4.5), (4.8, 5.5)])
def test_the_factors_of_surroundings_agree_with_photons(luts, sky_photons, ring, band):
    radius, direction, flux = sky_photons
    used = (radius >= ring[0]) & (radius < ring[1])
    weight = flux[used] / (np.pi * (ring[1] ** 2 - ring[0] ** 2))
    r = radius[used]
    factors = eye_ambient(luts.surroundings, np.sqrt(np.linspace(ring[0] ** 2, ring[1] ** 2, 200)))
    sine, cosine = np.sin(factors[:, 3]), np.cos(factors[:, 3])
    own = [
        np.mean(factors[:, 0]),
        np.mean(factors[:, 1] * cosine) * 2.0 / 3.0,
        np.mean(factors[:, 2] * (1.5 * cosine**2 - 0.5)) / 4.0,
    ][band]
    z = direction[used, 1]
    truth = [weight.sum(), (weight * z).sum(), (weight * (1.5 * z * z - 0.5)).sum()][band]
    bound = (tol.EYE_EVEN_SKY, tol.EYE_BAND_1, tol.EYE_BAND_2)[band]
    assert r.size > 1000
    assert abs(own - truth) <= bound.value, (own, truth)
    if band == 1:
        aside = (weight * direction[used, 0]).sum()
        assert abs(np.mean(factors[:, 1] * sine) * 2.0 / 3.0 - aside) <= bound.value


def test_an_even_sky_draws_a_dark_ring_at_the_limbus(luts):
    r = np.linspace(0.0, 7.5, 400)
    point = np.stack([r, 0.0 * r, eye_height(r, EYE.cornea, EYE.limbus)], axis=-1)
    view = tilted(0.0, r.size)
    normal = eye_normal(point, EYE.cornea, EYE.limbus)
    hit = eye_iris_hit(point, normal, view, EYE.cornea, EYE.iris)
    opacity = eye_limbal_opacity(r, EYE.limbus)
    irradiance = eye_ambient(luts.surroundings, np.abs(hit[:, 0]))[:, 0]
    iris = 0.2 * irradiance * eye_inside(normal[:, 2], np.array(EYE.aqueous_index))
    radiance = (1.0 - opacity) * iris + opacity * 0.65
    assert 5.2 <= r[np.argmin(radiance)] <= 5.7
    assert radiance.min() <= 0.5 * np.interp(3.0, r, radiance)


# -- reflection ------------------------------------------------------------------------------------


@pytest.mark.parametrize("index", [1.336, 1.337, 1.5])
def test_the_reflectance_is_fresnels(index):
    cosine = np.cos(np.radians(np.linspace(0.0, 89.9, 200)))
    error = dielectric_fresnel(cosine, np.array(index)) - reflectance(cosine, 1.0, index)
    assert np.abs(error).max() <= tol.FRESNEL_EXACT.value
    assert dielectric_fresnel(np.array(0.0), np.array(index)) == 1.0


def test_the_approximation_of_schlick_would_be_too_dark_at_60_and_too_bright_at_84_degrees():
    cosine = np.cos(np.radians([60.0, 84.0]))
    exact = dielectric_fresnel(cosine, np.array(1.337))
    schlick = 0.0208 + (1.0 - 0.0208) * (1.0 - cosine) ** 5
    assert schlick[0] / exact[0] < 0.86
    assert schlick[1] - exact[1] > 0.05


@pytest.mark.parametrize("lamp_deg", [0.3, 3.0, 10.0])
@pytest.mark.parametrize("roughness_deg", [0.4, 6.0])
def test_a_highlight_holds_the_energy_of_the_lamp(lamp_deg, roughness_deg):
    angle = np.linspace(0.0, 0.5, 20_001)
    reflected = np.stack([np.sin(angle), 0.0 * angle, np.cos(angle)], axis=-1)
    light = np.array([0.0, 0.0, 1.0])
    value = lamp_highlight(reflected, light, np.radians(lamp_deg), np.radians(roughness_deg))
    integral = np.trapezoid(value * 2.0 * np.pi * np.sin(angle), angle)
    assert abs(integral / np.pi - 1.0) <= tol.HIGHLIGHT_ENERGY.value


def test_the_pupil_is_7_9_mm_wide_in_the_dark_and_1_9_mm_in_the_sun():
    width = 2.0 * pupil_radius(np.array([1e-8, 1.0, 1e9]))
    assert width == pytest.approx([7.9, 4.9, 1.9], abs=0.06)
    assert (np.diff(pupil_radius(np.logspace(-5, 6, 50))) < 0.0).all()
