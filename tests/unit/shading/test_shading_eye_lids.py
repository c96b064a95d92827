"""Lids and tears beside Monte Carlo between lids of a ball."""

from __future__ import annotations

import numpy as np
import pytest

import shading_tolerances as tol
from eye_lid_truth import (
    BALL_MM,
    exposed_points,
    hemisphere,
    margin_plane,
    true_iris_openness,
    true_lamp,
    true_openness,
)
from eye_truth import TrueEye
from skinshade.params import EyeParams
from skinshade.params.eye import lid_plane
from skinshade.shading.eye_lids import (
    lid_iris_openness,
    lid_openness,
    lid_visibility,
    tear_normal,
)

EYE, TRUTH = EyeParams(), TrueEye()
OPENINGS = [(4.2, -5.6), (3.0, -5.0), (5.5, -6.0), (1.5, -4.5)]
BALL = np.array(BALL_MM)
EVERY_OPENING = pytest.mark.parametrize("opening", OPENINGS, ids=repr)
FAR = np.array([0.0, 1.0, 0.0, 100.0])
"""A lid that covers nothing."""


def planes_of(opening):
    return [np.array(lid_plane(height)) for height in opening]


def rms(error):
    return np.sqrt(np.mean(np.square(error)))


@EVERY_OPENING
def test_the_planes_of_lids_are_those_of_their_margins(opening):
    for height, plane in zip(opening, planes_of(opening), strict=True):
        assert np.abs(margin_plane(height) - plane).max() <= tol.ROUNDING.value * 10.0


def test_openness_agrees_with_an_even_sky_between_the_lids():
    errors = []
    for opening in OPENINGS:
        rng, planes = np.random.default_rng(1), planes_of(opening)
        point, normal = exposed_points(TRUTH, planes, 400, rng)
        truth = true_openness(point, normal, planes, 400, rng)
        errors.append(lid_openness(point, normal, *planes, BALL) - truth)
    assert rms(np.concatenate(errors)) <= tol.EYE_LIDS_OPEN.value


def test_visibility_agrees_with_a_lamp_of_three_degrees():
    errors = []
    for opening in OPENINGS:
        rng, planes = np.random.default_rng(2), planes_of(opening)
        point, normal = exposed_points(TRUTH, planes, 400, rng)
        light = hemisphere(np.tile([0.0, 0.0, 1.0], (len(point), 1)), 1, rng)[:, 0]
        used = np.sum(light * normal, axis=-1) > 0.15
        point, light = point[used], light[used]
        truth = true_lamp(point, light, np.radians(3.0), planes, 400, rng)
        own = lid_visibility(point, light, np.radians(3.0), np.array(0.0), *planes, BALL)
        errors.append(own - truth)
    assert rms(np.concatenate(errors)) <= tol.EYE_LIDS_LAMP.value


@pytest.mark.slow
def test_openness_of_the_iris_agrees_with_paths_through_the_cornea():
    errors = []
    for opening in OPENINGS:
        planes = planes_of(opening)
        centres, truth = true_iris_openness(TRUTH, planes, 0.5, 150_000, np.random.default_rng(3))
        hit = np.concatenate([centres, 0.0 * centres[:, :1]], axis=-1)
        errors.append(lid_iris_openness(hit, EYE.cornea, EYE.limbus, *planes) - truth)
    assert rms(errors[0]) <= tol.EYE_LIDS_IRIS.value
    assert rms(np.concatenate(errors)) <= tol.EYE_LIDS_IRIS_ALL.value


def test_without_lids_everything_is_visible():
    point, normal = exposed_points(TRUTH, [FAR], 50, np.random.default_rng(4))
    assert (lid_openness(point, normal, FAR, FAR, BALL) == 1.0).all()
    assert (lid_visibility(point, normal, 0.05, np.array(0.2), FAR, FAR, BALL) == 1.0).all()


def test_points_under_a_lid_are_dark():
    plane = np.array(lid_plane(4.2))
    point = np.array([[0.0, 8.0, 8.9]])
    assert lid_visibility(point, point / 12.0, 0.05, np.array(0.2), plane, FAR, BALL) == 0.0


def test_the_shadow_of_a_lid_is_wider_for_a_wider_lamp():
    plane = np.array(lid_plane(4.2))
    y = np.linspace(-2.0, 4.0, 200)
    point = np.stack([0.0 * y, y, np.sqrt(144.0 - y * y)], axis=-1)
    light = np.broadcast_to([0.0, np.sin(0.6), np.cos(0.6)], point.shape)
    shares = [lid_visibility(point, light, a, np.array(0.0), plane, FAR, BALL) for a in (0.02, 0.1)]
    partly = [np.sum((share > 0.01) & (share < 0.99)) for share in shares]
    assert partly[1] > 3 * partly[0] > 0
    assert all((np.diff(share) <= 1e-12).all() for share in shares)


def test_tears_turn_the_normal_away_from_the_lid_towards_its_margin():
    plane = np.array(lid_plane(-5.6))
    y = np.linspace(-5.2, -4.4, 81)
    point = np.stack([0.0 * y, y, np.sqrt(144.0 - y * y)], axis=-1)
    normal = point / 12.0
    bare = plane[3] - point @ plane[:3]
    wet = tear_normal(point, normal, plane, np.array(0.2))
    toward = wet @ plane[:3] - normal @ plane[:3]
    beyond = bare > 0.2
    strip = (bare > 0.0) & (bare < 0.2)
    assert beyond.any()
    assert np.abs(wet[beyond] - normal[beyond]).max() <= tol.ROUNDING.value
    assert (toward[strip] < 0.0).all()
    assert np.abs(np.linalg.norm(wet, axis=-1) - 1.0).max() <= tol.ROUNDING.value
    sine = np.sqrt(1.0 - np.sum(wet * normal, axis=-1)[strip] ** 2)
    assert np.abs(sine - (1.0 - bare[strip] / 0.2)).max() <= tol.ROUNDING_SUMS.value * 100.0
