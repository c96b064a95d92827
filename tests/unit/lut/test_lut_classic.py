"""The tables of 2014 against an independent construction by quadrature, in steps of 8 bits."""

from functools import cache

import numpy as np
import pytest
from scipy.special import ndtr

import tolerances as tol
from skinshade._core.errors import ArgumentError
from skinshade.lut import Lut, curvature_lut
from skinshade.lut.classic import (
    CLASSIC_DIFFUSION_RADIUS_MM,
    classic_curvature_lut,
    classic_shadow_lut,
)
from skinshade.profile import Profile

WIDTH, HEIGHT = 512, 48
ROWS = [0, 1, 5, 12, 24, 36, 46, 47]
COLUMNS = [0, 10, 20, 21, 100, 200, 250, 255, 256, 262, 300, 400, 511]
CUT_MM = 10.0


@cache
def curvature_table() -> Lut:
    return classic_curvature_lut(Profile.preset("skin-deon2007"), size=(WIDTH, HEIGHT))


@cache
def shadow_table() -> Lut:
    return classic_shadow_lut(Profile.preset("skin-deon2007"), size=(WIDTH, HEIGHT))


def line_profile(mixture, x_mm):
    lobes = np.exp(-0.5 * x_mm[..., None] ** 2 / mixture.variances_mm2)
    return (lobes / np.sqrt(2.0 * np.pi * mixture.variances_mm2)) @ mixture.weights


def panels(edges):
    x, w = np.polynomial.legendre.leggauss(24)
    half = 0.5 * np.diff(edges)[:, None]
    return (edges[:-1, None] + half * (x + 1.0)).ravel(), (half * w).ravel()


def ring_integral_of_2014(mixture, theta, curvature):
    """Return the integral around the ring, cut off at half a turn or 10 mm and not normalised."""
    reach = min(np.pi / curvature, CUT_MM)
    kinks = (np.array([-0.5, 0.5, 1.5]) * np.pi - theta) / curvature
    fine = np.concatenate([np.linspace(-reach, reach, 33), np.linspace(-0.6, 0.6, 33)])
    edges = np.union1d(fine, kinks)
    x, weight = panels(edges[np.abs(edges) <= reach])
    light = np.maximum(np.cos(theta + x * curvature), 0.0)
    return (light * weight) @ line_profile(mixture, x)


def srgb(linear):
    return np.where(
        linear <= 0.0031308, 12.92 * linear, 1.055 * np.maximum(linear, 1e-9) ** (1 / 2.4) - 0.055
    )


def stored_curvature(values, n_dot_l):
    return np.clip((values - np.maximum(n_dot_l, 0.0)[:, None]) * 2.0 + 0.5, 0.0, 1.0) * 255.0


@pytest.mark.parametrize("row", ROWS)
def test_the_curvature_table_equals_the_construction_of_2014(deon, row):
    table = curvature_table()
    n_dot_l = table.columns.centres(WIDTH)[COLUMNS]
    curvature = table.rows.centres(HEIGHT)[row]
    mixture, _ = deon.gaussian_fit()
    expected = np.array([ring_integral_of_2014(mixture, np.arccos(x), curvature) for x in n_dot_l])
    steps = stored_curvature(table.values[row, COLUMNS], n_dot_l) - stored_curvature(
        expected, n_dot_l
    )
    assert np.abs(steps).max() <= tol.CLASSIC_STEPS.value


@pytest.mark.parametrize("row", ROWS)
def test_the_shadow_table_equals_the_construction_of_2014(deon, row):
    table = shadow_table()
    u = table.columns.centres(WIDTH)[COLUMNS]
    position = 0.5 + 0.5 * (np.sqrt(u) - np.sqrt(1.0 - u))
    per_mm = table.rows.centres(HEIGHT)[row]
    x, weight = panels(np.union1d(np.linspace(-CUT_MM, CUT_MM, 65), np.linspace(-0.6, 0.6, 33)))
    p = np.clip((position[:, None] + x * per_mm - 0.5) * 10.0 + 0.5, 0.0, 1.0)
    light = (p * p * (3.0 - 2.0 * p) * weight) @ line_profile(deon.kernel, x)
    light *= np.minimum(u / 0.04, 1.0)[:, None]
    steps = 255.0 * (srgb(table.values[row, COLUMNS].astype(float)) - srgb(light))
    assert np.abs(steps).max() <= tol.CLASSIC_STEPS.value


def test_the_curvature_table_holds_whole_steps_of_8_bits():
    table = curvature_table()
    n_dot_l = table.columns.centres(WIDTH)
    stored = (table.values - np.maximum(n_dot_l, 0.0)[:, None]) * 2.0 + 0.5
    assert np.abs(stored * 255.0 - np.rint(stored * 255.0)).max() <= tol.WHOLE_STEP.value
    assert stored.min() >= -tol.FLOAT32.value
    assert stored.max() <= 1.0 + tol.FLOAT32.value


def test_the_shadow_table_holds_whole_steps_of_8_bits():
    stored = srgb(shadow_table().values.astype(float)) * 255.0
    assert np.abs(stored - np.rint(stored)).max() <= tol.WHOLE_STEP.value


def test_the_8_bits_clip_red_below_a_radius_of_1_1_mm(deon):
    # The 8 bits hold differences to Lambert of ±0.25; at the lit pole the exact one is greater.
    for radius_mm, clipped in ((1.3, False), (1.0, True), (0.7, True)):
        span = (radius_mm, radius_mm * 1.001)
        exact = curvature_lut(deon, size=(256, 2), radius_mm=span, kernel="ring")
        assert (exact.values[-1, -1, 0] - exact.columns.centres(256)[-1] < -0.25) == clipped
        table = classic_curvature_lut(deon, size=(256, 2), radius_mm=span)
        stored = stored_curvature(table.values[-1], table.columns.centres(256))
        assert (stored[-1, 0] < 0.5) == clipped


def test_rows_are_linear_in_curvature_from_1_to_100_mm():
    rows = curvature_table().rows
    assert (rows.low, rows.high, rows.spacing) == (0.01, 1.0, "linear")
    assert rows.centres(512)[0] == pytest.approx(0.01 + 0.99 / 1024, rel=tol.ROUNDING.value)


def test_the_first_columns_of_the_shadow_table_fade_to_black(deon):
    wide = deon.scaled(4.0)
    table = classic_shadow_lut(wide, size=(512, 8)).values[-1, :, 0]
    column = int(0.02 * 512)
    assert table[0] < 0.1 * table[column * 2]
    assert (np.diff(table[:21]) > 0.0).all()


def test_the_diffusion_radius_is_the_widest_gaussian_of_skin(deon):
    assert deon.kernel.sigmas_mm.max() == pytest.approx(CLASSIC_DIFFUSION_RADIUS_MM, abs=0.05)


def test_light_beyond_10_mm_is_cut_off(deon):
    # On a nearly flat surface a lobe with σ = 10 mm keeps Φ(1) − Φ(−1) of its light.
    wide = Profile.gaussians(variances_mm2=[100.0], weights=[[1, 1, 1]], albedo=0.5)
    table = classic_curvature_lut(wide, size=(512, 2), radius_mm=(900.0, 1e4))
    kept = 0.5 + 255.0 * 2.0 * ndtr(1.0) - 255.0 * 1.0
    lost_steps = (1.0 - (kept - 0.5) / 255.0) * 2.0 * 255.0
    stored = stored_curvature(table.values[0], table.columns.centres(WIDTH))[511, 0]
    assert stored == pytest.approx(max(127.5 - lost_steps, 0.0), abs=1.5)


@pytest.mark.parametrize("build", [classic_curvature_lut, classic_shadow_lut])
@pytest.mark.parametrize("size", [(1, 4), (4, 0)])
def test_an_invalid_size_is_refused(deon, build, size):
    with pytest.raises(ArgumentError, match="size"):
        build(deon, size=size)


@pytest.mark.parametrize("radius_mm", [(0.0, 1.0), (2.0, 1.0)])
def test_invalid_radii_are_refused(deon, radius_mm):
    with pytest.raises(ArgumentError, match="radius_mm"):
        classic_curvature_lut(deon, size=(4, 4), radius_mm=radius_mm)


@pytest.mark.parametrize("sharpening", [0.0, np.nan, (1.0, 2.0)])
def test_an_invalid_sharpening_is_refused(deon, sharpening):
    with pytest.raises(ArgumentError, match="sharpening"):
        classic_shadow_lut(deon, size=(4, 4), sharpening=sharpening)
