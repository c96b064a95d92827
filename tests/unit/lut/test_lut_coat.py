"""The table of the coat: Fresnel's equations, directional albedo and mean direction by quadrature."""

from functools import cache

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import shading_tolerances as tol
from skinshade._core.errors import ArgumentError
from skinshade.lut import Lut, build_coat_lut
from skinshade.lut.coat import coat_fresnel
from skinshade.params.gloss import gloss_from_roughness

SKIN_F0 = (0.4 / 2.4) ** 2
ROUGHNESS = 0.45
PUBLISHED = {0.1: 0.184, 0.2: 0.139, 0.4: 0.078, 0.6: 0.045, 0.8: 0.031, 1.0: 0.027}
"""Directional albedo of a GGX lobe of roughness .45 under an index of 1.4, by cosine."""


def fresnel_by_snell(cosine, ior):
    """Return the mean of both polarisations, from the angle of refraction."""
    inside = np.sqrt(1.0 - (1.0 - cosine**2) / ior**2)
    across = (cosine - ior * inside) / (cosine + ior * inside)
    along = (inside - ior * cosine) / (inside + ior * cosine)
    return 0.5 * (across**2 + along**2)


@cache
def half_vectors():
    """Return half vectors and solid angles; panels get narrower towards the normal, as lobes do."""
    edges = np.concatenate([[0.0], np.geomspace(1e-3, np.pi / 2.0, 40)])
    x, w = np.polynomial.legendre.leggauss(8)
    theta = (edges[:-1, None] + np.diff(edges)[:, None] * (x + 1.0) / 2.0).ravel()
    weight = (np.diff(edges)[:, None] * w / 2.0).ravel() * np.sin(theta)
    phi = (np.arange(180) + 0.5) * np.pi / 180.0  # the other half is its mirror image
    t, p = np.meshgrid(theta, phi, indexing="ij")
    h = np.stack([np.sin(t) * np.cos(p), np.sin(t) * np.sin(p), np.cos(t)], axis=-1)
    return h.reshape(-1, 3), np.repeat(weight * 2.0 * np.pi / 180.0, 180)


def reflection(cosine, roughness, fresnel):
    """Return the directional albedo and the mean direction (x, z) of a GGX lobe, from its formulas."""
    h, solid_angle = half_vectors()
    v = np.array([np.sqrt(1.0 - cosine**2), 0.0, cosine])
    v_dot_h = h @ v
    light = 2.0 * v_dot_h[:, None] * h - v
    above = (v_dot_h > 0.0) & (light[:, 2] > 0.0)
    h, light, v_dot_h, solid_angle = h[above], light[above], v_dot_h[above], solid_angle[above]
    a2 = roughness**4
    density = a2 / (np.pi * (h[:, 2] ** 2 * (a2 - 1.0) + 1.0) ** 2)

    def smith(c):
        return 0.5 * (np.sqrt(1.0 + a2 * (1.0 / c**2 - 1.0)) - 1.0)

    shadowing = 1.0 / (1.0 + smith(cosine) + smith(light[:, 2]))
    # BRDF · N·L · dω, with dω = 4 V·H dω_h
    share = density * shadowing / (4.0 * cosine) * fresnel(v_dot_h) * 4.0 * v_dot_h * solid_angle
    return share.sum(), (share @ light[:, 0], share @ light[:, 2])


def skin_fresnel(cosine):
    return fresnel_by_snell(cosine, 1.4)


@given(st.floats(1e-3, 1.0), st.floats(1.01, 2.6))
def test_fresnel_is_that_of_snells_law(cosine, ior):
    reflectance = ((ior - 1.0) / (ior + 1.0)) ** 2
    result = coat_fresnel(np.array(cosine), np.array(reflectance))
    assert result == pytest.approx(fresnel_by_snell(cosine, ior), rel=1e-7)


def test_fresnel_is_f0_in_front_one_at_grazing_and_zero_without_a_boundary():
    assert coat_fresnel(np.array(1.0), np.array(SKIN_F0)) == pytest.approx(SKIN_F0)
    assert coat_fresnel(np.array(0.0), np.array(SKIN_F0)) == pytest.approx(1.0)
    assert not coat_fresnel(np.linspace(0.0, 1.0, 9), np.zeros(9)).any()


def test_the_directional_albedo_has_the_published_values():
    gloss = float(gloss_from_roughness(ROUGHNESS))
    table = build_coat_lut(reflectance=SKIN_F0).sample(np.sqrt(list(PUBLISHED)), gloss)
    assert np.abs(table[:, 0] - list(PUBLISHED.values())).max() <= tol.COAT_TABLE.value


@pytest.mark.parametrize("roughness", [0.13, 0.2, 0.3, 0.45, 0.6, 0.75, 0.9])
def test_the_table_is_within_a_thousandth_of_the_quadrature_over_half_vectors(roughness):
    gloss = float(gloss_from_roughness(roughness))
    lut = build_coat_lut(reflectance=SKIN_F0)
    for cosine in (0.03, 0.07, 0.13, 0.33, 0.55, 0.77, 0.99):
        albedo, pull, unit = lut.sample(np.sqrt(cosine), gloss)
        exact, (mean_x, mean_z) = reflection(cosine, roughness, skin_fresnel)
        assert albedo == pytest.approx(exact, abs=tol.COAT_TABLE.value)
        complete, _ = reflection(cosine, roughness, np.ones_like)
        assert unit == pytest.approx(complete, abs=tol.COAT_UNIT_TABLE.value)
        away = np.sqrt(1.0 - cosine**2)
        pulled = np.array([-(1.0 - pull) * away, (1.0 - pull) * cosine + pull])
        angle = np.arctan2(mean_x, mean_z) - np.arctan2(pulled[0], pulled[1])
        assert abs(angle) <= tol.COAT_ANGLE.value


def test_the_axes_reach_both_limits_and_the_table_is_kept():
    lut = build_coat_lut()
    assert isinstance(lut, Lut)
    assert lut.values.shape == (32, 64, 3)
    assert build_coat_lut() is lut
    assert np.allclose(lut.columns.centres(64)[[0, -1]], [0.0, 1.0], atol=tol.ROUNDING.value)
    assert np.allclose(lut.rows.centres(32)[[0, -1]], [0.0, 1.0], atol=tol.ROUNDING.value)
    assert not np.array_equal(build_coat_lut(reflectance=0.05).values, lut.values)


def test_without_a_boundary_the_coat_reflects_nothing():
    lut = build_coat_lut(reflectance=0.0)
    assert not lut.values[..., :2].any()
    assert lut.values[..., 2].min() > 0.2


def test_a_wrong_reflectance_or_size_is_an_error():
    with pytest.raises(ArgumentError, match="reflectance"):
        build_coat_lut(reflectance=1.5)
    with pytest.raises(ArgumentError, match="size"):
        build_coat_lut(size=(1, 8))
