import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import shading_tolerances as tol
from skinshade.shading.ambient import (
    ambient_irradiance,
    ambient_normals,
    ambient_of_three,
    bounced_visibility,
    sh_basis,
    specular_visibility,
)

VECTOR = hnp.arrays(float, 3, elements=st.floats(-1.0, 1.0)).filter(
    lambda v: np.linalg.norm(v) > 0.1
)
COEFFICIENTS = hnp.arrays(float, (9, 3), elements=st.floats(-1.0, 1.0))
BAND = np.array([0, 1, 1, 1, 2, 2, 2, 2, 2])


def sphere_quadrature(count=24):
    """Directions and weights, exact for polynomials up to degree 2·count − 1."""
    z, w = np.polynomial.legendre.leggauss(count)
    phi = (np.arange(2 * count) + 0.5) * np.pi / count
    r = np.sqrt(1.0 - z * z)
    d = np.stack(
        [np.outer(r, np.cos(phi)), np.outer(r, np.sin(phi)), np.outer(z, np.ones_like(phi))], -1
    )
    return d.reshape(-1, 3), np.repeat(w * np.pi / count, phi.size)


def one_normal(n):
    return np.tile(n / np.linalg.norm(n), (1, 3, 1))


def rotation_to(n):
    """An orthonormal frame whose last row is n."""
    n = n / np.linalg.norm(n)
    u = np.cross(n, np.eye(3)[np.argmin(np.abs(n))])
    u /= np.linalg.norm(u)
    return np.stack([u, np.cross(n, u), n])


def test_the_harmonics_are_orthonormal():
    d, w = sphere_quadrature()
    basis = sh_basis(d)
    assert np.abs(basis.T @ (w[:, None] * basis) - np.eye(9)).max() <= tol.QUADRATURE.value


def test_each_band_is_an_eigenspace_of_the_laplacian():
    """Harmonic polynomials of degree l: r^l Y_l has no Laplacian, checked by mean values."""
    d, w = sphere_quadrature()
    for centre in np.eye(3)[[0, 2]] * 0.4:
        point = centre + 0.3 * d
        r = np.linalg.norm(point, axis=1)
        values = sh_basis(point / r[:, None]) * r[:, None] ** BAND
        at = sh_basis(centre[None] / 0.4)[0] * 0.4**BAND
        assert np.abs(w @ values / (4.0 * np.pi) - at).max() <= tol.QUADRATURE.value


@given(VECTOR, st.floats(0.0, 5.0))
def test_the_same_light_from_everywhere_lights_every_normal_alike(n, level):
    constant = np.zeros((9, 3))
    constant[0] = level * np.sqrt(4.0 * np.pi)
    found = ambient_irradiance(constant, one_normal(n))
    assert np.abs(found - level).max() <= tol.ROUNDING_SUMS.value


@given(VECTOR, COEFFICIENTS)
def test_irradiance_is_the_integral_of_radiance_times_the_clamped_cosine(n, coefficients):
    z, w = np.polynomial.legendre.leggauss(16)
    z, w = 0.5 * (z + 1.0), 0.5 * w  # the upper half alone: there the cosine is smooth
    phi = (np.arange(24) + 0.5) * 2.0 * np.pi / 24
    r = np.sqrt(1.0 - z * z)
    local = np.stack(
        [np.outer(r, np.cos(phi)), np.outer(r, np.sin(phi)), np.outer(z, np.ones(24))], axis=-1
    )
    radiance = sh_basis(local.reshape(-1, 3) @ rotation_to(n)) @ coefficients
    weight = np.repeat(w * z, 24) * 2.0 * np.pi / 24
    truth = np.maximum(weight @ radiance / np.pi, 0.0)
    found = ambient_irradiance(coefficients, one_normal(n))[0]
    assert np.abs(found - truth).max() <= tol.QUADRATURE.value


def test_nine_harmonics_are_within_a_hundredth_of_a_sky():
    """The claim of [Ramamoorthi2001], on a sky with a bright lobe over a floor."""
    d, w = sphere_quadrature(64)
    sky = 0.3 + np.maximum(d[:, 1], 0.0) ** 8
    coefficients = np.repeat((sh_basis(d).T @ (w * sky))[:, None], 3, axis=1)
    for n in np.random.default_rng(3).normal(size=(20, 3)):
        unit = n / np.linalg.norm(n)
        truth = w @ (sky * np.maximum(d @ unit, 0.0)) / np.pi
        found = ambient_irradiance(coefficients, one_normal(unit))[0, 0]
        assert found == pytest.approx(truth, rel=tol.NINE_HARMONICS.value)


@given(VECTOR, COEFFICIENTS, st.floats(0.1, 1.0))
def test_a_shorter_normal_keeps_band_0_and_damps_1_and_2_by_its_length_and_cube(n, sh, length):
    bands = [np.where((band == BAND)[:, None], sh, 0.0) for band in range(3)]
    lift = np.zeros((9, 3))
    lift[0] = 40.0  # far above 0, where the result is clamped
    for band, power in ((0, 0), (1, 1), (2, 3)):
        full, short, floor = (
            ambient_irradiance(lift + part, scale * one_normal(n))
            for part, scale in ((bands[band], 1.0), (bands[band], length), (0.0, 1.0))
        )
        assert np.allclose(short - floor, length**power * (full - floor), atol=1e-12)


@given(VECTOR, COEFFICIENTS, hnp.arrays(float, (1, 3, 3), elements=st.floats(0.0, 1.0)))
def test_band_transfer_multiplies_each_band_of_each_channel(n, sh, transfer):
    lift = np.zeros((9, 3))
    lift[0] = 40.0
    floor = ambient_irradiance(lift, one_normal(n))
    unit = np.ones((1, 3, 3))
    total = np.zeros((1, 3))
    for band in range(3):
        part = np.where((band == BAND)[:, None], sh, 0.0)
        alone = ambient_irradiance(lift + part, one_normal(n)) - floor
        total += alone * transfer[:, band]
    keep_band_0 = transfer.copy()
    keep_band_0[:, 0] = unit[:, 0]
    with_0 = np.where((BAND == 0)[:, None], 0.0, sh)
    found = ambient_irradiance(lift + with_0, one_normal(n), keep_band_0) - floor
    alone_0 = ambient_irradiance(lift + sh - with_0, one_normal(n)) - floor
    assert np.allclose(found, total - alone_0 * transfer[:, 0], atol=1e-11)


@given(COEFFICIENTS, VECTOR)
def test_light_is_never_negative_and_channels_do_not_mix(sh, n):
    found = ambient_irradiance(sh, one_normal(n))
    assert (found >= 0.0).all()
    red_only = sh * (1.0, 0.0, 0.0)
    assert np.allclose(ambient_irradiance(red_only, one_normal(n)), found * (1, 0, 0), atol=1e-15)


@given(hnp.arrays(np.int64, (3, 3), elements=st.integers(-9, 9)))
def test_three_normals_serve_any_other_light(vectors):
    unit = ambient_normals(vectors.astype(float))
    lengths = np.linalg.norm(unit, axis=1)
    assert np.all((np.abs(lengths - 1.0) <= tol.ROUNDING.value) | ~vectors.any(axis=1))
    assert np.allclose(unit * np.linalg.norm(vectors, axis=1)[:, None], vectors, atol=1e-15)
    red, green, blue = vectors
    assert ambient_of_three(red, green, blue).tolist() == [red[0], green[1], blue[2]]


@given(st.floats(0.0, 1.0), st.floats(0.0, 1.0))
def test_returned_light_only_adds_and_an_open_sky_stays_open(visibility, albedo):
    found = float(bounced_visibility(np.array(visibility), np.array(albedo)))
    assert visibility <= found <= 1.0 + tol.BOUNCE_FIT.value
    assert bounced_visibility(np.array(1.0), np.array(albedo)) == pytest.approx(
        1.0, abs=tol.BOUNCE_FIT.value
    )


@given(st.floats(0.01, 0.99))
def test_brighter_walls_return_more(visibility):
    found = bounced_visibility(np.full(5, visibility), np.linspace(0.1, 0.9, 5))
    assert np.all(np.diff(found) >= 0.0)


@given(st.floats(0.0, 1.0), st.floats(0.0, 1.0), st.floats(0.0, 1.0))
def test_reflections_are_hidden_where_the_sky_is(cosine, visibility, roughness):
    r = np.array(roughness)
    found = specular_visibility(np.array(cosine), np.array(visibility), r)
    assert 0.0 <= found <= 1.0
    assert specular_visibility(np.array(cosine), np.array(1.0), r) == pytest.approx(1.0, abs=1e-15)
    assert specular_visibility(np.array(0.0), np.array(0.0), r) == 0.0
    more = specular_visibility(np.array(cosine), np.array(min(visibility + 0.1, 1.0)), r)
    assert more >= found
