"""Thickness by rays: slabs, spheres and shells whose value is known, holes, units, motions."""

import importlib.util

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad
from scipy.spatial.transform import Rotation

import shapes
from skinshade._core.errors import ArgumentError
from skinshade.mesh import rays as casting
from skinshade.mesh import thickness as module
from skinshade.mesh.rays import open_caster
from skinshade.mesh.thickness import mesh_thickness
from tolerances import (
    EMBREE_THICKNESS,
    EMBREE_WALL,
    ROUNDING_SUMS,
    THICKNESS,
    THICKNESS_FEW_RAYS,
    THICKNESS_HALF_CONE,
)

EMBREE = importlib.util.find_spec("embreex") is not None
TRACINGS = [
    "builtin",
    pytest.param("embree", marks=pytest.mark.skipif(not EMBREE, reason="embreex is not there")),
]
EVERY_TRACING = pytest.mark.parametrize("tracing", TRACINGS)


def slab(width, height):
    box = trimesh.creation.box((width, width, height))
    return np.array(box.vertices), np.array(box.faces)


def mean_over_cone(across, cone_deg):
    """The mean of across(cos θ, sin² θ) over a cone, by the cosine: sin² θ is evenly spread."""
    most = np.sin(np.radians(cone_deg)) ** 2
    return quad(lambda s: across(np.sqrt(1.0 - s), s), 0.0, most, limit=200)[0] / most


# -- shapes whose value is known -------------------------------------------------------------------


@EVERY_TRACING
@pytest.mark.parametrize("cone_deg", [5.0, 30.0, 45.0, 80.0])
def test_a_sphere_is_r_times_one_plus_cos2(tracing, cone_deg):
    ball = shapes.sphere("icosphere", 4, 7.0)
    some = np.arange(0, len(ball.positions), 40)
    found = mesh_thickness(
        ball.positions,
        ball.faces,
        ball.normals[some],
        points=ball.positions[some],
        cone_deg=cone_deg,
        tracing=tracing,
    )
    truth = 7.0 * (1.0 + np.cos(np.radians(cone_deg)) ** 2)
    np.testing.assert_allclose(found, truth, rtol=THICKNESS.value)


@EVERY_TRACING
@pytest.mark.parametrize("cone_deg", [1.0, 45.0, 60.0])
@pytest.mark.parametrize("count", [1, 64])
def test_a_slab_is_exactly_as_thick_as_it_is(tracing, cone_deg, count):
    positions, faces = slab(100.0, 3.0)
    at = np.array([[1.0, 2.0, 1.5], [-7.0, 3.0, 1.5], [5.0, 5.0, -1.5]])
    normals = np.array([[0, 0, 1.0], [0, 0, 1.0], [0, 0, -1.0]])
    found = mesh_thickness(
        positions, faces, normals, points=at, rays=count, cone_deg=cone_deg, tracing=tracing
    )
    within = ROUNDING_SUMS if tracing == "builtin" else EMBREE_THICKNESS
    np.testing.assert_allclose(found, 3.0, rtol=within.value)


@pytest.fixture(scope="module")
def shell():
    """A body between two spheres, the inner one wound inwards: outer points, then inner ones."""
    outer, inner = shapes.sphere("icosphere", 4, 10.0), shapes.sphere("icosphere", 4, 7.0)
    positions = np.concatenate([outer.positions, inner.positions])
    faces = np.concatenate([outer.faces, inner.faces[:, ::-1] + len(outer.positions)])
    return positions, faces, np.concatenate([outer.normals, -inner.normals])


@EVERY_TRACING
def test_a_shell_ends_at_its_first_wall(shell, tracing):
    positions, faces, normals = shell
    some = np.arange(0, len(positions), 61)
    found = mesh_thickness(
        positions, faces, normals[some], points=positions[some], rays=512, tracing=tracing
    )

    def inwards(cosine, s):
        missed = s >= 0.49
        return cosine * (2.0 * 10.0 * cosine if missed else 10.0 * cosine - np.sqrt(49 - 100 * s))

    def outwards(cosine, s):
        return cosine * (np.sqrt(100.0 - 49.0 * s) - 7.0 * cosine)

    is_outer = some < len(positions) // 2
    np.testing.assert_allclose(
        found[is_outer], mean_over_cone(inwards, 45.0), rtol=THICKNESS_FEW_RAYS.value
    )
    np.testing.assert_allclose(
        found[~is_outer], mean_over_cone(outwards, 45.0), rtol=THICKNESS_FEW_RAYS.value
    )


@EVERY_TRACING
def test_what_lies_beyond_a_gap_does_not_count(tracing):
    near, faces = slab(100.0, 3.0)
    positions = np.concatenate([near, near - (0.0, 0.0, 20.0)])
    both = np.concatenate([faces, faces + len(near)])
    found = mesh_thickness(
        positions, both, [[0.0, 0.0, 1.0]], points=[[0.3, 0.2, 1.5]], tracing=tracing
    )
    np.testing.assert_allclose(found, 3.0, rtol=EMBREE_THICKNESS.value)


@EVERY_TRACING
def test_a_wall_that_a_ray_enters_by_is_passed(tracing):
    outer, faces = slab(100.0, 3.0)
    inner, _ = slab(50.0, 1.0)  # an eyeball in its head: what is left first is the inner body
    both = np.concatenate([faces, faces + len(outer)])
    found = mesh_thickness(
        np.concatenate([outer, inner]),
        both,
        [[0.0, 0.0, 1.0]],
        points=[[0.3, 0.2, 1.5]],
        tracing=tracing,
    )
    np.testing.assert_allclose(found, 2.0, rtol=EMBREE_THICKNESS.value)


@EVERY_TRACING
def test_rays_through_a_hole_count_for_nothing(tracing):
    ball = shapes.sphere("icosphere", 4, 1.0)
    upper = ball.faces[(ball.positions[ball.faces][:, :, 2] > -1e-9).all(axis=1)]
    rim = np.abs(ball.positions[:, 2]) < 1e-9
    assert rim.sum() > 20
    some = np.append(np.flatnonzero(rim), np.argmax(ball.positions[:, 2]))
    *at_rim, at_pole = mesh_thickness(
        ball.positions,
        upper,
        ball.normals[some],
        points=ball.positions[some],
        rays=256,
        tracing=tracing,
    )
    # Half of a rim's rays meet the wall, and they are those of the sphere.
    np.testing.assert_allclose(at_rim, 1.5, rtol=THICKNESS_HALF_CONE.value)
    # All of the pole's leave through the hole: it is as thick as the body is large.
    assert at_pole == np.linalg.norm(np.ptp(ball.positions, axis=0))


def test_a_face_that_is_turned_does_not_make_a_hole():
    ball = shapes.sphere("icosphere", 3, 1.0)
    faces = ball.faces.copy()
    faces[::7] = faces[::7, ::-1]
    found = mesh_thickness(ball.positions, faces, ball.normals, tracing="builtin")
    np.testing.assert_allclose(found, 1.5, rtol=THICKNESS_FEW_RAYS.value)


# -- the two ways of casting -----------------------------------------------------------------------


@pytest.mark.skipif(not EMBREE, reason="embreex is not there")
def test_embree_finds_the_walls_of_the_built_in(shell):
    positions, faces, _ = shell
    random = np.random.default_rng(3)
    direction = random.normal(size=(4000, 3))
    direction /= np.linalg.norm(direction, axis=1)[:, None]
    origins = 8.5 * np.roll(direction, 1, axis=0)
    one, other = (
        open_caster(positions, faces, tracing).exit_distances(origins, direction)
        for tracing in ("builtin", "embree")
    )
    assert np.isfinite(one).all()
    np.testing.assert_allclose(one, other, atol=EMBREE_WALL.value * 20.0)


@EVERY_TRACING
def test_rays_that_meet_nothing_go_on_forever(tracing):
    positions, faces = slab(2.0, 2.0)
    caster = open_caster(positions, faces, tracing)
    origins = np.array([[0.0, 0.0, 5.0], [0.2, 0.1, 0.0], [5.0, 5.0, 0.0]])
    directions = np.array([[0.0, 0.0, 1.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]])
    np.testing.assert_allclose(caster.exit_distances(origins, directions), [np.inf, 1.0, np.inf])


def test_many_faces_on_top_of_each_other_are_met_by_parts(monkeypatch):
    """Every ray meets the boxes of all of them: the pairs of one batch took memory without a bound."""
    positions, faces = slab(100.0, 3.0)
    pile = np.tile(faces, (40, 1))
    caster = casting.Hierarchy(positions, pile)
    most = []
    whole = casting.Hierarchy._nearest
    monkeypatch.setattr(casting, "MOST_PAIRS", 500)
    monkeypatch.setattr(
        casting.Hierarchy, "_nearest", lambda *a: most.append(len(a[3])) or whole(*a)
    )
    origins = np.random.default_rng(1).uniform(-1.0, 1.0, (64, 3))
    found = caster.exit_distances(origins, np.tile([0.0, 0.0, 1.0], (64, 1)))
    np.testing.assert_allclose(found, 1.5 - origins[:, 2], rtol=ROUNDING_SUMS.value)
    assert max(most) <= 500


# -- units, motions, chunks ------------------------------------------------------------------------


@EVERY_TRACING
@pytest.mark.parametrize("unit", [1e-25, 1e-6, 1000.0, 1e14])
def test_it_scales_with_the_unit(tracing, unit):
    ball = shapes.ellipsoid("icosphere", 2, (1.0, 0.7, 0.5))
    found, scaled = (
        mesh_thickness(ball.positions * k, ball.faces, ball.normals, rays=16, tracing=tracing)
        for k in (1.0, unit)
    )
    within = ROUNDING_SUMS if tracing == "builtin" else EMBREE_THICKNESS
    np.testing.assert_allclose(scaled / unit, found, rtol=within.value)


@settings(max_examples=15)
@given(seed=st.integers(0, 10_000), shift=st.floats(-1e3, 1e3))
def test_a_rigid_motion_changes_nothing(seed, shift):
    ball = shapes.ellipsoid("icosphere", 3, (1.0, 0.8, 0.6))
    turn = Rotation.random(random_state=seed).as_matrix()
    some = np.arange(0, len(ball.positions), 31)
    still, moved = (
        mesh_thickness(p, ball.faces, n[some], points=p[some], rays=256, tracing="builtin")
        for p, n in (
            (ball.positions, ball.normals),
            (ball.positions @ turn.T + (shift, 0.0, -shift), ball.normals @ turn.T),
        )
    )
    np.testing.assert_allclose(moved, still, rtol=THICKNESS_FEW_RAYS.value)


def test_chunks_leave_no_seam_and_progress_ends_at_one(monkeypatch):
    ball = shapes.sphere("icosphere", 2)
    whole = mesh_thickness(ball.positions, ball.faces, ball.normals, rays=8, tracing="builtin")
    monkeypatch.setattr(module, "CHUNK", 100)
    told = []
    parts = mesh_thickness(
        ball.positions,
        ball.faces,
        ball.normals,
        rays=8,
        tracing="builtin",
        progress=lambda what, share: told.append(share),
    )
    np.testing.assert_array_equal(parts, whole)
    assert told == sorted(told)
    assert told[-1] == 1.0


# -- what is refused -------------------------------------------------------------------------------

BALL = shapes.sphere("icosphere", 1)


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"rays": 0}, "rays is 0"),
        ({"rays": 4097}, "rays is 4097"),
        ({"rays": 2.5}, "rays is 2.5"),
        ({"rays": float("nan")}, "rays is nan"),
        ({"cone_deg": 0.5}, "cone_deg is 0.5"),
        ({"cone_deg": 90.0}, "cone_deg is 90"),
        ({"cone_deg": float("nan")}, "cone_deg is nan"),
        ({"tracing": "gpu"}, "tracing is 'gpu'"),
        ({"positions": BALL.positions * np.nan}, "positions"),
        ({"positions": np.zeros((0, 3))}, "there are 0 vertices"),
        ({"faces": np.zeros((0, 3), int)}, "faces"),
        ({"faces": BALL.faces + 1}, "faces"),
        ({"faces": BALL.faces * 1.0}, "faces"),
        ({"normals": BALL.normals[:3]}, "normals"),
        ({"points": BALL.positions}, "normals: points need theirs"),
        ({"points": [[0.0, 0.0]], "normals": [[0, 0, 1]]}, "points"),
    ],
)
def test_a_bad_argument_is_named(wrong, said):
    with pytest.raises(ArgumentError, match=said):
        mesh_thickness(**({"positions": BALL.positions, "faces": BALL.faces} | wrong))


def test_embree_that_is_not_installed_is_named(monkeypatch):
    monkeypatch.setattr(casting, "find_spec", lambda name: None)
    with pytest.raises(ArgumentError, match=r"skinshade\[embree\]"):
        mesh_thickness(BALL.positions, BALL.faces, tracing="embree")
    auto = mesh_thickness(BALL.positions, BALL.faces, tracing="auto")
    np.testing.assert_array_equal(
        auto, mesh_thickness(BALL.positions, BALL.faces, tracing="builtin")
    )
