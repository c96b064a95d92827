import re

import numpy as np
import pytest

import tolerances as tol
from skinshade._core.errors import ArgumentError
from skinshade.profile import Profile, presets
from skinshade.profile.presets import preset_record

EVERY_PRESET = pytest.mark.parametrize("name", presets())

# σs' and σa per mm, as printed in [Jensen2001] and in d'Eon & Luebke's table for the default.
MEASURED = {
    "skin1": ((0.74, 0.88, 1.01), (0.032, 0.17, 0.48), 1.3),
    "skin2": ((1.09, 1.59, 1.79), (0.013, 0.070, 0.145), 1.3),
    "marble": ((2.19, 2.62, 3.00), (0.0021, 0.0041, 0.0071), 1.5),
    "whole-milk": ((2.55, 3.21, 3.77), (0.0011, 0.0024, 0.014), 1.3),
}


def keys_of_references(repository) -> set[str]:
    text = (repository / "REFERENCES.bib").read_text(encoding="utf-8")
    return set(re.findall(r"^\s*@\w+\s*\{\s*([^,\s]+)\s*,", text, flags=re.MULTILINE))


def test_the_presets_are_those_documented_with_skin_first():
    assert presets() == ["skin-deon2007", "skin1", "skin2", "marble", "whole-milk"]


@EVERY_PRESET
def test_every_preset_states_its_source_kind_and_unit(name):
    record = preset_record(name)
    assert record["source"]
    assert record["kind"] in ("gaussians", "dipole", "burley")
    assert (
        record["unit"] == {"gaussians": "mm2", "dipole": "per mm", "burley": "mm"}[record["kind"]]
    )
    assert record["about"]


@EVERY_PRESET
def test_the_source_of_every_preset_is_in_the_references(name, repository):
    assert preset_record(name)["source"] in keys_of_references(repository)


@pytest.mark.parametrize("build", ["burley", "dipole"])
def test_the_source_of_every_model_is_in_the_references(build, repository):
    arguments = {
        "burley": {"length_mm": 1.0, "kind": "shape", "albedo": 0.5},
        "dipole": {"sigma_s_prime_per_mm": 1.0, "sigma_a_per_mm": 0.1},
    }[build]
    assert getattr(Profile, build)(**arguments).source in keys_of_references(repository)


@EVERY_PRESET
def test_a_preset_has_its_name_and_source(name):
    profile = Profile.preset(name)
    assert profile.name == name
    assert profile.source == preset_record(name)["source"]
    assert ((profile.albedo > 0.0) & (profile.albedo < 1.0)).all()


@pytest.mark.parametrize("name", MEASURED)
def test_the_media_have_the_measured_coefficients(name):
    scattering, absorption, ior = MEASURED[name]
    kernel = Profile.preset(name).kernel
    assert np.array_equal(kernel.sigma_s_prime_per_mm, scattering)
    assert np.array_equal(kernel.sigma_a_per_mm, absorption)
    assert kernel.ior == ior


def test_the_six_gaussians_are_those_of_gpu_gems_3(deon):
    variances = (0.0064, 0.0484, 0.187, 0.567, 1.99, 7.41)
    red = (0.233, 0.100, 0.118, 0.113, 0.358, 0.078)
    green = (0.455, 0.336, 0.198, 0.007, 0.004, 0.0)
    blue = (0.649, 0.344, 0.0, 0.007, 0.0, 0.0)
    assert np.array_equal(deon.kernel.variances_mm2, variances)
    assert np.allclose(deon.kernel.weights.T, (red, green, blue), rtol=0, atol=tol.ROUNDING.value)


def test_the_rms_radius_in_skin_decreases_from_red_to_blue():
    for name in ("skin-deon2007", "skin1", "skin2"):
        assert (np.diff(Profile.preset(name).rms_radius_mm) < 0.0).all()


def test_a_preset_can_be_built_twice():
    assert np.array_equal(Profile.preset("skin1").albedo, Profile.preset("skin1").albedo)


@pytest.mark.parametrize("name", ["", "skin", "Skin1", None])
def test_an_unknown_name_is_refused_with_the_known_names(name):
    with pytest.raises(ArgumentError) as caught:
        Profile.preset(name)
    assert repr(name) in str(caught.value)
    assert all(known in str(caught.value) for known in presets())
