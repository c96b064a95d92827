"""Direct light in three tiers of geometry, the relief of normals, and curvature along the light."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import integrate, stats

import shading_tolerances as tol
import shapes
from skinshade.mesh import mesh_curvature_tensor
from skinshade.mesh.curvature import tensor_to_world
from skinshade.params import SkinParams
from skinshade.profile import Profile
from skinshade.shading.direct import (
    SMOOTH_SHORTFALL,
    direct_diffused_normals,
    direct_scalar,
    direct_tensor,
    directional_curvature,
    relief_bump,
    relief_length,
)
from skinshade.shading.skin import Skin
from skinshade.shading.tables import build_curvature_lut

ONE = np.ones(3)
COLUMNS = 512
COSINES = np.linspace(-1.0, 1.0, 2 * COLUMNS + 1)[1::2]
"""N·L at the texel centres of a table, where bilinear sampling has no error."""
COSINE = st.floats(-1.0, 1.0)
ANGLE = st.floats(0.0, 2.0 * np.pi)


@pytest.fixture(scope="module")
def skin() -> Skin:
    return Skin.of(Profile.preset("skin-deon2007"), SkinParams())


def lit_from(cosines, lengths=1.0):
    """Return normals (n, 3, 3) along z of some lengths, and lights (n, 3) at angles to them."""
    c = np.atleast_1d(np.asarray(cosines, dtype=float))
    light = np.stack([np.sqrt(1.0 - c * c), 0.0 * c, c], axis=-1)
    normals = np.zeros((c.size, 3, 3))
    normals[..., 2] = lengths
    return normals, light


def every_tier(skin, normals, light, gain, directional=0.0, total=0.0):
    count = len(light)
    d, t = np.full(count, directional), np.full(count, total)
    relief = np.linalg.norm(normals, axis=-1)
    return {
        "scalar": direct_scalar(skin.lut("sphere"), normals, light, d, gain),
        "tensor": direct_tensor(skin.lut("ring"), skin.transfer, normals, light, d, t, gain),
        "diffused": direct_diffused_normals(
            skin.lut("ring"), skin.transfer, normals, relief, light, d, gain
        ),
    }


def test_a_plane_is_lambert_in_every_tier(skin):
    normals, light = lit_from(np.linspace(-1.0, 1.0, 2001))
    truth = np.maximum(light[:, 2:], 0.0)
    for name, value in every_tier(skin, normals, light, ONE).items():
        assert np.abs(value - truth).max() <= tol.TABLE_EDGE.value, name


def tables(profile, radius):
    request = {"size": (COLUMNS, 2), "radius_mm": (0.999 * radius, 1.001 * radius)}
    return {
        kernel: build_curvature_lut(profile, kernel=kernel, energy_gain=False, **request)
        for kernel in ("sphere", "ring")
    }


def sphere_tiers(profile, radius):
    """Return the light of each tier on a sphere, whose diffused normals have the length T(√2κ)."""
    normals, light = lit_from(COSINES)
    table, transfer = tables(profile, radius), profile.kernel.transfer
    kappa = np.full(COLUMNS, 1.0 / radius)
    shortened = normals * transfer(np.sqrt(2.0) * kappa)[:, :, None]
    full = np.ones((COLUMNS, 3))
    return (
        direct_scalar(table["sphere"], normals, light, kappa, ONE),
        direct_tensor(table["ring"], transfer, normals, light, kappa, np.sqrt(2) * kappa, ONE),
        direct_diffused_normals(table["ring"], transfer, shortened, full, light, kappa, ONE),
    )


@pytest.mark.parametrize("radius", [5.0, 10.0, 20.0, 40.0])
def test_on_a_sphere_the_tiers_agree_to_the_cube_of_sigma_over_radius(radius):
    lobe = Profile.gaussians(variances_mm2=[1.0], weights=[[1.0, 1.0, 1.0]], albedo=0.5)
    scalar, tensor, diffused = sphere_tiers(lobe, radius)
    assert np.abs(scalar - tensor).max() * radius**3 <= tol.TIER_CUBE.value
    assert np.abs(tensor - diffused).max() <= tol.ROUNDING.value


def test_on_a_sphere_the_difference_of_the_tiers_is_cubic_in_curvature():
    lobe = Profile.gaussians(variances_mm2=[1.0], weights=[[1.0, 1.0, 1.0]], albedo=0.5)
    gaps = [np.abs(np.subtract(*sphere_tiers(lobe, r)[:2])).max() for r in (5.0, 10.0, 20.0)]
    assert np.log2(np.array(gaps[:-1]) / gaps[1:]) == pytest.approx(3.0, abs=tol.CUBIC.value)


def test_on_large_spheres_diffused_normals_give_the_light_of_the_tensor_tier(deon):
    for radius in (20.0, 50.0):
        _, tensor, diffused = sphere_tiers(deon, radius)
        assert np.abs(tensor - diffused).max() <= tol.MIXTURE_TIERS.value / radius**4


def test_on_a_cylinder_lit_along_its_axis_the_light_is_n_dot_l_times_the_transfer(skin):
    """The curvature along the light is 0; the rest of the curvature damps the light."""
    r, cosine = 6.0, np.array([0.2, 0.6, 0.95])
    normals, light = lit_from(cosine)
    axis_curvature = np.tile([0.0, 0.0, 0.0, 1.0 / r, 0.0, 0.0], (3, 1))  # curved along y only
    directional, total = directional_curvature(axis_curvature, normals[:, 0], light)
    assert np.abs(directional).max() <= tol.ROUNDING.value
    ring = skin.lut("ring")
    value = direct_tensor(ring, skin.transfer, normals, light, directional, total, ONE)
    truth = cosine[:, None] * skin.transfer(np.array(1.0 / r))
    assert np.abs(value - truth).max() <= tol.TABLE_EDGE.value


@given(COSINE, st.floats(0.0, 0.5), st.floats(0.3, 1.0), st.floats(0.5, 3.0))
def test_the_gain_multiplies_the_light_of_every_tier(skin, cosine, kappa, length, gain):
    normals, light = lit_from(cosine, length)
    plain = every_tier(skin, normals, light, ONE, kappa, 1.5 * kappa)
    gained = every_tier(skin, normals, light, gain * ONE, kappa, 1.5 * kappa)
    for name, value in plain.items():
        assert np.allclose(gained[name], gain * value, rtol=tol.ROUNDING.value, atol=0.0)


@given(COSINE, st.floats(0.3, 1.0))
def test_relief_on_a_plane_follows_the_formula_in_every_tier(skin, cosine, length):
    normals, light = lit_from(cosine, length)
    m, s = length * cosine, np.sqrt(-np.log(length) * (1.0 - cosine**2))
    truth = max(m, 0.0) if s == 0.0 else m * stats.norm.cdf(m / s) + s * stats.norm.pdf(m / s)
    for value in every_tier(skin, normals, light, ONE).values():
        assert np.abs(value - truth).max() <= tol.TABLE_EDGE.value


@given(st.floats(-2.0, 2.0), st.floats(0.01, 1.0))
def test_the_relief_term_is_the_mean_lambert_over_gaussian_slopes_minus_lambert(m, s):
    """E[max(0, m + s·z)] − max(0, m) for normal z, by quadrature."""
    mean, _ = integrate.quad(
        lambda z: (m + s * z) * stats.norm.pdf(z), -m / s, 12.0, epsabs=1e-12, epsrel=1e-12
    )
    bump = float(relief_bump(np.array(m), np.array(s)))
    assert bump == pytest.approx(mean - max(m, 0.0), abs=tol.BUMP.value)


@given(st.floats(-5.0, 5.0), st.floats(0.0, 3.0))
def test_the_relief_term_is_even_positive_and_greatest_at_the_terminator(m, s):
    at, mirrored, top = relief_bump(np.array([m, -m, 0.0]), np.full(3, s))
    assert at == mirrored
    assert 0.0 <= at <= top
    assert top == pytest.approx(s / np.sqrt(2.0 * np.pi), abs=tol.NO_SLOPE.value)


def test_without_slope_the_relief_term_is_zero():
    bump = relief_bump(np.array([-1.0, -1e-3, 0.0, 1e-3, 1.0]), np.zeros(5))
    assert np.abs(bump).max() <= tol.NO_SLOPE.value


@given(ANGLE, COSINE, st.floats(1.0, 50.0))
def test_on_a_cylinder_the_directional_curvature_is_sine_over_radius(angle, cosine, radius):
    """The angle is that of the light to the axis in the tangent plane; elevation has no effect."""
    sine = np.sqrt(1.0 - cosine**2)
    light = np.array([[sine * np.cos(angle), sine * np.sin(angle), cosine]])
    tensor = np.array([[0.0, 0.0, 0.0, 1.0 / radius, 0.0, 0.0]])
    directional, total = directional_curvature(tensor, np.array([[0.0, 0.0, 1.0]]), light)
    assert total[0] == pytest.approx(1.0 / radius, rel=tol.ROUNDING.value)
    if sine > 1e-3:
        assert directional[0] * radius == pytest.approx(abs(np.sin(angle)), abs=tol.STEEP.value)


@given(ANGLE, COSINE, st.floats(-0.5, 0.5), st.floats(-0.5, 0.5), st.integers(0, 2**16))
def test_directional_curvature_lies_between_the_principal_curvatures(angle, cosine, k1, k2, seed):
    rotation = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))[0]
    u, v, n = rotation
    shape = k1 * np.outer(u, u) + k2 * np.outer(v, v)
    tensor = shape[[0, 0, 0, 1, 1, 2], [0, 1, 2, 1, 2, 2]]
    light = cosine * n + np.sqrt(1 - cosine**2) * (np.cos(angle) * u + np.sin(angle) * v)
    directional, total = directional_curvature(tensor, n, light)
    assert total == pytest.approx(np.hypot(k1, k2), abs=tol.STEEP.value)
    assert directional <= max(abs(k1), abs(k2)) + tol.STEEP.value
    if 1.0 - cosine**2 > 1e-6:
        assert directional >= min(abs(k1), abs(k2)) - tol.STEEP.value
        truth = np.hypot(k1 * np.cos(angle), k2 * np.sin(angle))
        assert directional == pytest.approx(truth, abs=tol.STEEP.value)


def test_on_a_mesh_of_a_sphere_the_directional_curvature_is_one_over_the_radius():
    ball = shapes.sphere("icosphere", 4, 12.0)
    tensor = tensor_to_world(
        mesh_curvature_tensor(ball.positions, ball.faces, ball.normals), ball.normals
    )
    light = np.broadcast_to([0.48, 0.6, 0.64], ball.normals.shape)
    directional, total = directional_curvature(tensor, ball.normals, light)
    assert np.abs(12.0 * directional - 1.0).max() <= tol.MESH_TENSOR.value
    assert np.abs(12.0 * total - np.sqrt(2.0)).max() <= tol.MESH_TENSOR.value


@given(st.floats(0.0, 0.3), st.floats(0.0, 0.3), st.floats(0.2, 1.0))
def test_on_a_body_of_constant_curvature_the_relief_length_is_that_of_the_texture(
    deon, k1, k2, texture
):
    """Shorter diffused normals are relief of the mesh, beyond `SMOOTH_SHORTFALL`; longer ones are not."""
    total = np.array(np.hypot(k1, k2))
    map_normals = np.tile([0.0, 0.0, texture], (3, 1))
    mesh_normals = np.zeros((3, 3))
    mesh_normals[:, 2] = deon.transfer(total)
    smooth = 1.0 - SMOOTH_SHORTFALL
    for scale, share in ((1.0, 1.0), (0.5, 0.5 / smooth), (smooth, 1.0), (1.5, 1.0)):
        length = relief_length(deon.kernel.transfer, map_normals, scale * mesh_normals, total)
        assert np.abs(length - share * texture).max() <= tol.ROUNDING.value, scale
