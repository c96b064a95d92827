"""Light on whole spheres against a random walk in the same medium."""

import numpy as np
import pytest

import tolerances as tol
from skinshade.lut.spectral import diffuse_grid
from skinshade.shading.energy import energy_gain

MODE = "matched_lambertentry"


@pytest.fixture(scope="module")
def walk(data_dir):
    with np.load(data_dir / "truth" / "mc_sphere.npz") as archive:
        return dict(archive)


def averaged_over_bins(edges, light):
    """Return means over bins of cosθ of a function from N·L (n,) to light (n, 3)."""
    x, w = np.polynomial.legendre.leggauss(8)
    half = 0.5 * np.diff(edges)[:, None]
    values = light((edges[:-1, None] + half * (x + 1.0)).ravel())
    return np.einsum("bqc,q->bc", values.reshape(half.size, x.size, 3), 0.5 * w)


def models(measured, edges, radius_mm):
    """Return the light of the models by name, in units of E0, without the albedo."""
    curvature = np.array([1.0 / radius_mm])
    gain = energy_gain(measured.albedo, measured.rms_radius_mm, curvature)

    def grid(kernel):
        return averaged_over_bins(edges, lambda x: diffuse_grid(measured, x, curvature, kernel)[0])

    lambert = averaged_over_bins(edges, lambda x: np.repeat(np.maximum(x, 0.0)[:, None], 3, axis=1))
    sphere, ring = grid("sphere"), grid("ring")
    return {"lambert": lambert, "ring": ring, "sphere": sphere, "sphere·gain": sphere * gain}


def rms_per_channel(measured, walk, radius_mm):
    index = int(np.flatnonzero(walk["radii_mm"] == radius_mm)[0])
    truth = walk[f"radiosity_{MODE}"][index].T / measured.albedo
    light = models(measured, walk["cos_theta_edges"], radius_mm)
    return {name: np.sqrt(np.mean((v - truth) ** 2, axis=0)) for name, v in light.items()}


@pytest.mark.parametrize(
    ("radius_mm", "mean", "pooled"),
    [
        (5.0, tol.MC_SPHERE_5MM, tol.MC_SPHERE_5MM_POOLED),
        (20.0, tol.MC_SPHERE_20MM, tol.MC_SPHERE_20MM_POOLED),
    ],
)
def test_the_sphere_with_gain_agrees_with_the_random_walk(measured, walk, radius_mm, mean, pooled):
    rms = rms_per_channel(measured, walk, radius_mm)["sphere·gain"]
    assert rms.mean() <= mean.value
    assert np.sqrt(np.mean(rms**2)) <= pooled.value


@pytest.mark.parametrize("radius_mm", [5.0, 20.0])
@pytest.mark.parametrize("model", ["lambert", "ring", "sphere"])
def test_the_error_without_gain_is_several_times_larger(measured, walk, radius_mm, model):
    rms = rms_per_channel(measured, walk, radius_mm)
    assert rms[model].mean() >= tol.GAIN_GAP.value * rms["sphere·gain"].mean()


@pytest.mark.parametrize("radius_mm", [5.0, 20.0])
def test_the_gain_is_the_ratio_of_sphere_to_plane(measured, walk, radius_mm):
    index = int(np.flatnonzero(walk["radii_mm"] == radius_mm)[0])
    returned = walk[f"radiosity_{MODE}"][index].mean(axis=1) / 0.25
    gain = energy_gain(measured.albedo, measured.rms_radius_mm, np.array([1.0 / radius_mm]))
    assert np.abs(returned / measured.albedo / gain - 1.0).max() <= tol.GAIN_TOTAL.value
