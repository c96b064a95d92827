"""What notebooks and consoles show for a profile."""

import xml.etree.ElementTree as ET
from dataclasses import replace

import numpy as np
import pytest

from skinshade.profile import Profile, presets

PROFILES = {
    **{name: Profile.preset(name) for name in presets()},
    "burley": Profile.burley(length_mm=(0.6, 0.25, 0.15), kind="shape", albedo=0.5),
    "tabulated": Profile.tabulated(edges_mm=[0.5, 1.0, 3.0], flux=np.ones((3, 2)), albedo=0.5),
    "extreme": Profile.gaussians(
        variances_mm2=[1e-8, 1e12], weights=[[1, 0, 1e-9], [0, 1, 1]], albedo=(1e-9, 0.999999, 0.0)
    ),
}
EVERY_PROFILE = pytest.mark.parametrize("profile", PROFILES.values(), ids=PROFILES)
MARKUP = "<img src=x onerror='a'> & \"b\""


def parsed(profile):
    """Return the HTML of a profile as elements; text that is not well-formed raises."""
    return ET.fromstring(f"<body>{profile._repr_html_()}</body>")


@EVERY_PROFILE
def test_the_repr_is_one_line_of_at_most_200_characters(profile):
    text = repr(profile)
    assert len(text) <= 200
    assert "\n" not in text
    assert text.startswith(f"Profile({profile.name!r}, ")


@EVERY_PROFILE
def test_the_html_is_well_formed_with_title_table_and_three_curves(profile):
    page = parsed(profile)
    assert page.findtext("div/b") == f"Profile {profile.name}"
    rows = {row[0].text: row[1].text for row in page.iter("tr")}
    assert rows["kernel"] == type(profile.kernel).__name__
    assert rows["albedo"] == str(profile.albedo.round(3))
    assert rows["root mean square radius, mm"] == str(profile.rms_radius_mm.round(3))
    curves = [line.get("points") for line in page.iter("polyline")]
    assert len(curves) == 3
    assert all(np.isfinite(np.array(c.replace(",", " ").split(), float)).all() for c in curves)


def test_the_source_is_stated(deon, burley):
    for profile in (deon, burley):
        rows = {row[0].text: row[1].text for row in parsed(profile).iter("tr")}
        assert rows["source"] == profile.source
    unknown = Profile.gaussians(variances_mm2=[1.0], weights=[[1, 1, 1]], albedo=0.5)
    assert {row[0].text: row[1].text for row in parsed(unknown).iter("tr")}["source"] == "none"


def test_markup_in_name_and_source_is_escaped(deon):
    profile = replace(deon, name=MARKUP, source=MARKUP)
    html = profile._repr_html_()
    assert "<img" not in html
    page = parsed(profile)
    assert page.findtext("div/b") == f"Profile {MARKUP}"
    assert [row[1].text for row in page.iter("tr") if row[0].text == "source"] == [MARKUP]
