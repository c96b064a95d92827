import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad

import tolerances as tol
from skinshade._core.errors import ArgumentError
from skinshade.profile import Profile
from skinshade.profile.burley import skin_walk_mean_free_path_mm
from skinshade.profile.dipole import fresnel_diffuse_reflectance

# skin2 of [Jensen2001]: albedo, mean free path and diffuse mean free path of its red channel.
ALBEDO, FREE_PATH_MM, DIFFUSE_FREE_PATH_MM = 0.623, 0.907, 4.82


@pytest.mark.parametrize(
    ("kind", "length_mm", "published_mm"),
    [
        ("mean-free-path-searchlight", FREE_PATH_MM, 0.72),
        ("mean-free-path-diffuse", FREE_PATH_MM, 0.65),
        ("diffuse-mean-free-path", DIFFUSE_FREE_PATH_MM, 1.14),
        ("shape", 0.72, 0.72),
    ],
)
def test_every_kind_of_length_gives_the_published_shape_length(kind, length_mm, published_mm):
    profile = Profile.burley(length_mm=length_mm, kind=kind, albedo=ALBEDO)
    assert np.abs(profile.kernel.d_mm - published_mm).max() <= tol.PUBLISHED_DIGIT.value * 0.01


@given(st.floats(0.0, 0.99), st.floats(0.01, 10.0))
def test_the_scalings_are_those_of_the_paper(albedo, length):
    def shape(kind):
        return Profile.burley(length_mm=length, kind=kind, albedo=albedo).kernel.d_mm[0] / length

    a = albedo
    expected = {
        "mean-free-path-searchlight": 1.85 - a + 7.0 * abs(a - 0.8) ** 3,
        "mean-free-path-diffuse": 1.9 - a + 3.5 * (a - 0.8) ** 2,
        "diffuse-mean-free-path": 3.5 + 100.0 * (a - 0.33) ** 4,
    }
    for kind, scaling in expected.items():
        assert shape(kind) == pytest.approx(1.0 / scaling, rel=tol.ROUNDING.value)


@given(st.floats(0.01, 10.0))
def test_the_rms_radius_is_root_fourteen_times_the_shape_length(d):
    profile = Profile.burley(length_mm=(d, 2 * d, 3 * d), kind="shape", albedo=0.5)
    expected = np.sqrt(14.0) * d * np.array([1.0, 2.0, 3.0])
    assert np.allclose(profile.rms_radius_mm, expected, rtol=tol.ROUNDING.value)


@pytest.mark.parametrize("r_over_d", [0.1, 0.5, 1.0, 3.0, 10.0])
def test_the_light_within_a_radius_has_its_closed_form(r_over_d):
    profile = Profile.burley(length_mm=(1.0, 0.3, 2.0), kind="shape", albedo=0.5)
    for channel, d in enumerate(profile.kernel.d_mm):
        within, _ = quad(
            lambda r, c=channel: 2.0 * np.pi * r * profile.radial(r)[c],
            1e-12,
            r_over_d * d,
            epsabs=1e-11,
        )
        closed = 1.0 - 0.25 * np.exp(-r_over_d) - 0.75 * np.exp(-r_over_d / 3.0)
        assert within == pytest.approx(closed, abs=tol.HANKEL.value)


def test_the_profile_is_infinite_at_the_centre_without_a_warning():
    profile = Profile.burley(length_mm=1.0, kind="shape", albedo=0.5)
    assert np.isposinf(profile.radial(0.0)).all()


def test_channels_have_separate_lengths():
    profile = Profile.burley(length_mm=(1.0, 0.5, 0.25), kind="shape", albedo=0.5)
    one = Profile.burley(length_mm=0.5, kind="shape", albedo=0.5)
    assert np.allclose(profile.transfer(2.0)[1], one.transfer(2.0)[1], rtol=tol.ROUNDING.value)


@pytest.mark.parametrize("kind", ["radius", "", "Shape", None, ["shape"]])
def test_an_unknown_kind_of_length_is_refused_with_the_choices(kind):
    with pytest.raises(ArgumentError, match=r"searchlight.*diffuse-mean-free-path"):
        Profile.burley(length_mm=1.0, kind=kind, albedo=0.5)


def test_the_kind_has_no_default():
    with pytest.raises(TypeError, match="kind"):
        Profile.burley(length_mm=1.0, albedo=0.5)


@pytest.mark.parametrize("length", [0.0, -1.0, np.nan, (1.0, 2.0), (1.0, 0.0, 1.0)])
def test_a_length_that_is_not_positive_is_refused(length):
    with pytest.raises(ArgumentError, match="length_mm"):
        Profile.burley(length_mm=length, kind="shape", albedo=0.5)


def test_the_radius_of_the_skin_closure_gives_the_edge_that_its_walk_draws(data_dir):
    edge = np.load(data_dir / "truth" / "cycles_skin_edge.npz")
    profile = Profile.burley(
        length_mm=[3.67, 1.37, 0.68], kind="blender-skin-radius", albedo=[0.545, 0.317, 0.264]
    )
    is_used = edge["ks"] <= 3.0
    error = (profile.transfer(edge["ks"]) - edge["T"])[is_used]
    assert np.abs(np.sqrt(np.mean(error**2, axis=0))).max() <= tol.SKIN_CLOSURE_EDGE.value
    assert np.allclose(
        profile.rms_radius_mm, [1.92, 1.04, 0.57], atol=0.01 * tol.PUBLISHED_DIGIT.value
    )


@pytest.mark.parametrize("albedo", [1e-4, 0.3, 0.9, 0.999])
def test_the_skin_closure_is_a_dipole_of_the_albedo(albedo):
    """Its reduced albedo is found by bisection; the dipole of that albedo has the albedo again."""
    albedos = np.full(3, albedo)
    ratio = skin_walk_mean_free_path_mm(np.ones(3), albedos)  # √(3 (1 − α'))
    reduced = 1.0 - ratio**2 / 3.0
    reflected = fresnel_diffuse_reflectance(1.4)
    boundary = 4.0 / 3.0 * (1.0 + reflected) / (1.0 - reflected)
    again = 0.5 * reduced * (1.0 + np.exp(-boundary * ratio)) * np.exp(-ratio)
    assert np.allclose(again, albedo, rtol=tol.ROUNDING_SUMS.value)
