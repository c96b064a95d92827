"""Enumerations of settings: texts, numbers for shaders, and which views show light."""

import re

import pytest

from skinshade._core.choice import Choice
from skinshade._core.generated import generated_text
from skinshade.params import choices
from skinshade.params.choices import (
    SHADER_CHOICES,
    TERM_VIEWS,
    MaterialMap,
    PresentStage,
    ToneCurve,
    View,
)
from skinshade.shading.compose import TERMS

ENUMERATIONS = [
    value
    for value in vars(choices).values()
    if isinstance(value, type) and issubclass(value, Choice) and value is not Choice
]
EVERY_ENUMERATION = pytest.mark.parametrize(
    "enumeration", ENUMERATIONS, ids=lambda enumeration: enumeration.__name__
)


def test_every_enumeration_is_public():
    assert len(ENUMERATIONS) == 11
    assert {enumeration.__name__ for enumeration in ENUMERATIONS} <= set(choices.__all__)


@EVERY_ENUMERATION
def test_the_text_of_a_member_is_its_name_in_lower_case(enumeration):
    for member in enumeration:
        assert member.value.replace("-", "_").upper() == member.name
        assert enumeration.of(member.value, "setting") is member


def shader_constants(prefix):
    """Return the constants of a prefix in the generated shader, by the rest of their names."""
    pattern = rf"static const int {prefix}_([A-Z_]+) = (\d+);"
    return {name: int(value) for name, value in re.findall(pattern, generated_text("passes.slang"))}


@pytest.mark.parametrize("prefix", SHADER_CHOICES)
def test_shader_constants_are_the_numbers_of_the_members(prefix):
    members = {member.name: member.number for member in SHADER_CHOICES[prefix]}
    assert members == {
        name: value for name, value in shader_constants(prefix).items() if name in members
    }
    assert sorted(members.values()) == list(range(len(members)))


def test_material_maps_have_distinct_bits_that_shaders_share():
    bits = {material_map.name: material_map.bit for material_map in MaterialMap}
    assert bits == {"ALBEDO": 1, "SPECULAR": 2, "DEEP_SCATTER": 4, "NORMAL": 8}
    assert {name: shader_constants("MAP")[name] for name in bits} == bits


def test_the_first_view_is_the_picture():
    assert next(iter(View)) is View.PICTURE
    assert View.PICTURE.number == 0


def test_every_term_of_the_light_has_one_view():
    assert sorted(TERM_VIEWS.values()) == sorted(TERMS)
    assert [view for view in View if view.is_term] == list(TERM_VIEWS)
    for view, term in TERM_VIEWS.items():
        assert view.value == term.replace("_", "-")


def test_views_of_light_are_the_picture_and_the_terms():
    assert {view for view in View if view.is_light} == {View.PICTURE, *TERM_VIEWS}
    assert not View.PICTURE.is_term
    assert not View.NORMAL.is_light


def test_the_present_pass_has_a_stage_for_every_tone_curve():
    assert {curve.value for curve in ToneCurve} <= {stage.value for stage in PresentStage}
