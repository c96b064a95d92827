"""The view factor: its mean, its limits, Monte Carlo, and which closure a material has."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import shading_tolerances as tol
from skinshade._core.errors import ArgumentError
from skinshade.params import SkinParams
from skinshade.params.choices import Boundary
from skinshade.profile import Profile
from skinshade.shading.skin import Skin
from skinshade.shading.view_factor import closure_view_factor, root_absorption, view_factor

UNIT_RANGE = st.floats(0.0, 1.0)
NODES, WEIGHTS = np.polynomial.legendre.leggauss(64)
COSINES, COSINE_WEIGHTS = 0.5 + 0.5 * NODES, (0.5 + 0.5 * NODES) * WEIGHTS
"""Quadrature of 2∫fμdμ."""


def closure(albedo, n_dot_v, reflectance):
    return closure_view_factor(albedo, n_dot_v)


BOTH = pytest.mark.parametrize("factor", [view_factor, closure])


def mean(factor, albedo, reflectance):
    colours = np.full((64, 3), albedo)
    return COSINE_WEIGHTS @ factor(colours, COSINES, np.array(reflectance))[:, 0]


@given(UNIT_RANGE)
def test_the_root_of_absorption_solves_the_albedo_of_a_half_space(albedo):
    gamma = float(root_absorption(np.array(albedo)))
    assert 0.0 <= gamma <= 1.0
    s = gamma / (1.0 + gamma)
    assert (1.0 - 2.0 * s) * (1.0 - s / 3.0) == pytest.approx(albedo, abs=tol.ROUNDING.value)


@BOTH
@given(albedo=UNIT_RANGE, reflectance=st.floats(0.0, 0.2))
def test_the_mean_over_the_cosine_is_one(factor, albedo, reflectance):
    assert mean(factor, albedo, reflectance) == pytest.approx(1.0, abs=tol.VIEW_FACTOR_MEAN.value)


@given(albedo=UNIT_RANGE)
def test_the_mean_over_the_cosine_is_one_for_skin(albedo):
    assert mean(view_factor, albedo, 0.028) == pytest.approx(
        1.0, abs=tol.VIEW_FACTOR_MEAN_OF_SKIN.value
    )


@BOTH
@given(n_dot_v=UNIT_RANGE, reflectance=st.floats(0.0, 0.2))
def test_white_light_leaves_alike_in_all_directions(factor, n_dot_v, reflectance):
    result = factor(np.ones((1, 3)), np.array([n_dot_v]), np.array(reflectance))
    assert np.abs(result - 1.0).max() <= tol.ROUNDING.value


@BOTH
@given(albedo=st.floats(0.0, 0.99), reflectance=st.floats(0.0, 0.2))
def test_less_light_leaves_towards_the_normal_than_along_the_surface(factor, albedo, reflectance):
    cosines = np.linspace(0.0, 1.0, 20)
    values = factor(np.full((20, 3), albedo), cosines, np.array(reflectance))[:, 0]
    assert (np.diff(values) < 0.0).all()
    assert values[0] > 1.0 > values[-1]


@BOTH
@given(albedo=UNIT_RANGE, n_dot_v=UNIT_RANGE)
def test_the_factor_brightens_no_surface_beyond_white(factor, albedo, n_dot_v):
    colour = np.full((1, 3), albedo)
    assert (albedo * factor(colour, np.array([n_dot_v]), np.array(0.028))).max() <= 1.0 + 1e-12


def test_albedos_and_cosines_beyond_their_ranges_have_the_values_of_the_ends():
    beyond = view_factor(np.array([[-1.0, 2.0, 0.5]]), np.array([-0.3]), np.array(0.028))
    ends = view_factor(np.array([[0.0, 1.0, 0.5]]), np.array([0.0]), np.array(0.028))
    assert np.array_equal(beyond, ends)


def test_the_factor_of_a_matched_boundary_is_that_of_the_random_walk(data_dir):
    walk = np.load(data_dir / "truth" / "mc_halfspace.npz")
    seen = walk["mu"] >= 0.03
    truth = walk["Rd_mu_matched"] / walk["albedo_matched"][:, None]
    albedo = np.broadcast_to(walk["albedo_matched"], (walk["mu"].size, 3))
    result = view_factor(albedo, walk["mu"], np.array(0.0)).T
    assert np.abs(result / truth - 1.0)[:, seen].max() <= tol.VIEW_FACTOR_WALK.value


def test_the_closure_of_blender_is_half_cosine_and_half_rough():
    """Both halves by quadrature, as the closure defines them."""
    for albedo in (0.05, 0.3, 0.6, 0.9):
        slope = 2.0 * float(root_absorption(np.array(albedo)))
        cosine = COSINE_WEIGHTS @ (1.0 / (1.0 + slope * COSINES))
        rough = 1.0 / (1.0 + slope * (0.13 + 0.75 * COSINES))
        truth = (cosine + rough) / (cosine + COSINE_WEIGHTS @ rough)
        result = closure_view_factor(np.full((64, 3), albedo), COSINES)[:, 1]
        assert np.abs(result - truth).max() <= tol.VIEW_FACTOR_CLOSURE.value


def test_the_boundary_is_that_of_the_parameters_or_else_of_the_profile():
    blender = Profile.burley(length_mm=1.0, kind="blender-skin-radius", albedo=0.5)
    plain = Profile.burley(length_mm=1.0, kind="shape", albedo=0.5)
    assert (blender.closure, plain.closure) == ("blender-skin", "")
    assert blender.scaled(2.0).closure == "blender-skin"
    cases = (
        (plain, None, Boundary.SMOOTH),
        (blender, None, Boundary.BLENDER_SKIN),
        (blender, "smooth", Boundary.SMOOTH),
        (plain, "blender-skin", Boundary.BLENDER_SKIN),
    )
    for profile, boundary, expected in cases:
        skin = Skin.of(profile, SkinParams(boundary=boundary), luts=(), fetches=())
        assert skin.boundary is expected


def test_profiles_of_other_closures_are_not_equal():
    profile = Profile.burley(length_mm=1.0, kind="shape", albedo=0.5)
    assert profile.equals(replace(profile))
    assert not profile.equals(replace(profile, closure="blender-skin"))


def test_an_unknown_boundary_or_specular_model_is_an_error_that_names_the_members():
    with pytest.raises(
        ArgumentError, match="boundary is 'rough'; it must be one of smooth, blender"
    ):
        SkinParams(boundary="rough")
    with pytest.raises(ArgumentError, match="specular is 'phong'; it must be one of ggx, ggx-two"):
        SkinParams(specular="phong")
