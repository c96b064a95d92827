"""The curvature table: texels against adaptive quadrature, axes, energy gain."""

from functools import cache

import numpy as np
import pytest
from numpy.polynomial import legendre
from scipy.integrate import quad

import tolerances as tol
from skinshade._core.errors import ArgumentError
from skinshade.lut import DiffusionGeometry, Lut, curvature_lut
from skinshade.profile import Profile
from skinshade.shading.energy import energy_gain
from skinshade.shading.tables import build_curvature_lut

ROWS = [0, 1, 3, 20, 55, 90, 140, 200, 260, 330, 420, 511]
COLUMNS = [0, 40, 128, 200, 236, 250, 253, 254, 255, 256, 257, 258, 262, 275, 310, 400, 511]


@cache
def full_table(kernel: str) -> Lut:
    return curvature_lut(Profile.preset("skin-deon2007"), kernel=kernel)


def ring_by_quadrature(theta: float, s: float) -> float:
    """Return the integral over the lit half of the ring of a Gaussian wrapped around it."""

    def integrand(angle):
        turns = 2.0 * np.pi * np.arange(-3, 4)
        lobe = np.exp(-0.5 * ((angle - theta + turns) / s) ** 2).sum() / (s * np.sqrt(2.0 * np.pi))
        return np.cos(angle) * lobe

    edge = 0.5 * np.pi
    marks = np.clip([theta - 8.0 * s, theta, theta + 8.0 * s], -edge, edge)
    return quad(integrand, -edge, edge, points=marks, epsabs=1e-9, epsrel=1e-9, limit=200)[0]


@cache
def heat_on_sphere(s: float, reach: float, panels: int) -> tuple[np.ndarray, ...]:
    """Return distances, their weights of area, and the heat kernel by its Legendre series."""
    order = np.arange(int(9.0 / s) + 8)
    shares = (2 * order + 1) / (4.0 * np.pi) * np.exp(-0.5 * s * s * order * (order + 1.0))
    x, w = np.polynomial.legendre.leggauss(32)
    edges = np.linspace(0.0, reach, panels + 1)
    half = 0.5 * np.diff(edges)[:, None]
    distance = (edges[:-1, None] + half * (x + 1.0)).ravel()
    area = 2.0 * np.pi * np.sin(distance) * (half * w).ravel()
    return distance, area, legendre.legval(np.cos(distance), shares)


def sphere_by_quadrature(n_dot_l: np.ndarray, s: float) -> np.ndarray:
    """Return the integral of the heat kernel times exact means of the light over circles."""
    distance, area, kernel = heat_on_sphere(s, min(np.pi, 9.0 * s), 40)
    level = n_dot_l[:, None] * np.cos(distance)
    swing = np.sqrt(1.0 - n_dot_l**2)[:, None] * np.sin(distance)
    lit_angle = np.arccos(np.clip(-level / np.maximum(swing, 1e-300), -1.0, 1.0))
    mean = (level * lit_angle + swing * np.sin(lit_angle)) / np.pi
    return mean @ (area * kernel)


def mixed(deon, values_per_lobe):
    return np.einsum("l...,lc->...c", np.array(values_per_lobe), deon.kernel.weights)


def test_the_ring_table_equals_the_physical_integral(deon):
    table = full_table("ring")
    theta = np.arccos(table.columns.centres(512)[COLUMNS])
    for row in ROWS:
        s = deon.kernel.sigmas_mm * table.rows.centres(512)[row]
        expected = mixed(deon, [[ring_by_quadrature(t, lobe) for t in theta] for lobe in s])
        assert np.abs(table.values[row, COLUMNS] - expected).max() <= tol.LUT_QUADRATURE.value


def test_the_sphere_table_equals_the_physical_integral(deon):
    table = full_table("sphere")
    n_dot_l = table.columns.centres(512)[COLUMNS]
    for row in ROWS:
        s = deon.kernel.sigmas_mm * table.rows.centres(512)[row]
        expected = mixed(deon, [sphere_by_quadrature(n_dot_l, lobe) for lobe in s])
        assert np.abs(table.values[row, COLUMNS] - expected).max() <= tol.LUT_QUADRATURE.value


def test_the_default_is_the_sphere_with_energy_gain_from_1_to_100_mm(deon):
    table = build_curvature_lut(deon, size=(8, 8))
    assert table.kind == "curvature"
    assert (table.columns.low, table.columns.high) == (-1.0, 1.0)
    assert (table.rows.low, table.rows.high) == (0.01, 1.0)
    assert table.rows.spacing == "sqrt"
    assert table.values.dtype == np.float32
    described = {k: table.provenance[k] for k in ("kernel", "energy_gain", "profile")}
    assert described == {"kernel": "sphere", "energy_gain": True, "profile": "skin-deon2007"}


@pytest.mark.parametrize("kernel", ["sphere", "ring"])
def test_the_energy_gain_multiplies_the_rows(deon, kernel):
    options = {"size": (64, 32), "radius_mm": (2.0, 50.0), "kernel": kernel}
    plain = build_curvature_lut(deon, energy_gain=False, **options)
    gained = build_curvature_lut(deon, energy_gain=True, **options)
    curvature = plain.rows.centres(32)
    gain = energy_gain(deon.albedo, deon.rms_radius_mm, curvature[:, None])[:, None, :]
    assert gain.min() > 1.0
    assert np.allclose(gained.values, plain.values * gain, rtol=0, atol=tol.FLOAT32.value)


def test_a_gain_is_called_with_the_curvature_of_the_rows(deon):
    plain = curvature_lut(deon, size=(8, 5))
    gained = curvature_lut(
        deon, size=(8, 5), gain=lambda curvature: curvature[:, None] * (1.0, 2.0, 3.0)
    )
    factors = plain.rows.centres(5)[:, None, None] * (1.0, 2.0, 3.0)
    assert np.allclose(gained.values, plain.values * factors, rtol=0, atol=tol.FLOAT32.value)
    assert (plain.provenance["energy_gain"], gained.provenance["energy_gain"]) == (False, True)


@pytest.mark.parametrize("kernel", list(DiffusionGeometry))
def test_a_kernel_is_given_as_a_member_or_as_its_text(deon, kernel):
    member = curvature_lut(deon, size=(8, 4), kernel=kernel)
    text = curvature_lut(deon, size=(8, 4), kernel=kernel.value)
    assert np.array_equal(member.values, text.values)
    assert member.provenance["kernel"] == text.provenance["kernel"] == kernel.value


def test_size_is_width_by_height(deon):
    assert curvature_lut(deon, size=(16, 4)).values.shape == (4, 16, 3)


def test_dark_columns_are_brighter_in_rows_of_higher_curvature(deon):
    dark = full_table("sphere").values[:, 100]
    assert (np.diff(dark, axis=0) >= -tol.FLOAT32.value).all()
    assert (dark[-1] > dark[0] + 1e-4).all()


def test_dark_columns_are_brightest_in_red_and_darkest_in_blue(deon):
    dark = full_table("sphere").values[300, 150]
    assert dark[0] > dark[1] > dark[2] >= 0.0


def test_32_rows_interpolate_512_because_they_are_linear_in_the_root(deon):
    coarse = curvature_lut(deon, size=(512, 32))
    n_dot_l, curvature = np.meshgrid(
        coarse.columns.centres(512), full_table("sphere").rows.centres(512)
    )
    inside = (curvature >= coarse.rows.centres(32)[0]) & (curvature <= coarse.rows.centres(32)[-1])
    error = np.abs(coarse.sample(n_dot_l, curvature) - full_table("sphere").values)[inside]
    assert error.max() <= tol.COARSE_ROWS.value


@pytest.mark.parametrize(
    ("options", "complaint"),
    [
        ({"size": (1, 8)}, r"size is 1×8"),
        ({"size": (8, 16385)}, r"size is 8×16385"),
        ({"size": (8,)}, "size"),
        ({"size": 8}, "size"),
        ({"size": (np.nan, 8)}, "size"),
        ({"radius_mm": (0.0, 1.0)}, "must be positive and increase"),
        ({"radius_mm": (2.0, 1.0)}, "must be positive and increase"),
        ({"radius_mm": (1.0, np.inf)}, r"radius_mm\[1\] is inf"),
        ({"radius_mm": 5.0}, "radius_mm: shape"),
        ({"kernel": "disk"}, "kernel is 'disk'; it must be one of sphere, ring"),
    ],
)
@pytest.mark.parametrize("build", [curvature_lut, build_curvature_lut])
def test_an_invalid_argument_is_refused(deon, build, options, complaint):
    with pytest.raises(ArgumentError, match=complaint):
        build(deon, **({"size": (4, 4)} | options))
