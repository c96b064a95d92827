"""The three tiers compared with diffusion over the mesh, on the bodies of benchmarks/three_tiers.py."""

from __future__ import annotations

import numpy as np
import pytest

import shading_tolerances as tol
from benchmark_scripts import benchmark
from skinshade.profile import Profile

three_tiers = benchmark("three_tiers")
SKIN = Profile.preset("skin-deon2007")
ORDER = ("lambert", "scalar ring", "scalar sphere", "tensor", "diffused normals")

PUBLISHED = {
    "torus R=12 r=4": (0.0139, 0.0101, 0.0090, 0.0021, 0.0007),
    "torus R=30 r=8": (0.0046, 0.0033, 0.0030, 0.0005, 0.0002),
    "ellipsoid 15, 10, 5": (0.0116, 0.0076, 0.0067, 0.0064, 0.0032),
    "ellipsoid 20, 6, 6": (0.0116, 0.0066, 0.0056, 0.0041, 0.0022),
}
"""RMS error of each tier of `ORDER`, over four random lights: MODEL §2."""


@pytest.fixture(scope="module")
def tables():
    return three_tiers.tables(SKIN)


@pytest.mark.slow
@pytest.mark.parametrize("name", PUBLISHED)
def test_the_error_of_each_tier_is_the_published_one_and_less_than_that_of_the_tier_before(
    name, tables
):
    errors = three_tiers.errors(three_tiers.BODIES[name](SKIN), tables)
    ordered = [errors[tier] for tier in ORDER]
    assert ordered == sorted(ordered, reverse=True)
    for tier, limit in zip(ORDER, PUBLISHED[name], strict=True):
        assert errors[tier] <= tol.TIER_OVER_PUBLISHED.value * limit + tol.TIER_DIGIT.value, tier


@pytest.mark.slow
def test_on_a_sphere_the_sphere_table_and_the_tensor_tiers_are_exact(tables):
    body = three_tiers.ellipsoid((20.0, 20.0, 20.0), SKIN)
    errors = three_tiers.errors(body, tables)
    for name in ("scalar sphere", "tensor", "diffused normals"):
        assert errors[name] <= tol.TIER_ON_SPHERE.value, name
    assert errors["lambert"] > 10.0 * tol.TIER_ON_SPHERE.value


@pytest.mark.slow
def test_on_the_scan_with_shadows_diffused_normals_have_the_least_error(
    data_dir, tables, monkeypatch
):
    monkeypatch.setattr(three_tiers, "DATA", data_dir)
    body = three_tiers.scan(SKIN, cuts=1)
    light = np.array(three_tiers.SCAN_LIGHT) / np.linalg.norm(three_tiers.SCAN_LIGHT)
    results = three_tiers.scan_light(body, light, tables)
    truth = results["truth"]
    rms = {name: body.mean_square(value - truth) ** 0.5 for name, value in results.items()}
    assert rms["diffused normals"] < rms["tensor"] < rms["lambert"]
    assert rms["diffused normals"] < rms["classic (2014)"]
