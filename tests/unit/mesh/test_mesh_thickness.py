"""Thickness by rays: slabs, spheres and shells of known thickness, holes, units, rigid motion."""

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
    pytest.param("embree", marks=pytest.mark.skipif(not EMBREE, reason="embreex is not installed")),
]
EVERY_TRACING = pytest.mark.parametrize("tracing", TRACINGS)


def slab(width, height):
    box = trimesh.creation.box((width, width, height))
    return np.array(box.vertices), np.array(box.faces)


def mean_over_cone(across, cone_deg):
    """Return the cosine-weighted mean of a function of cos θ and sin² θ over a cone."""
    greatest = np.sin(np.radians(cone_deg)) ** 2  # sin² θ is uniform over the cone
    integral, _ = quad(lambda s: across(np.sqrt(1.0 - s), s), 0.0, greatest, limit=200)
    return integral / greatest


# -- shapes of known thickness ---------------------------------------------------------------------


@EVERY_TRACING
@pytest.mark.parametrize("cone_deg", [5.0, 30.0, 45.0, 80.0])
def test_the_thickness_of_a_sphere_is_r_times_1_plus_cos2(tracing, cone_deg):
    ball = shapes.sphere("icosphere", 4, 7.0)
    subset = np.arange(0, len(ball.positions), 40)
    thickness = mesh_thickness(
        ball.positions,
        ball.faces,
        ball.normals[subset],
        points=ball.positions[subset],
        cone_deg=cone_deg,
        tracing=tracing,
    )
    truth = 7.0 * (1.0 + np.cos(np.radians(cone_deg)) ** 2)
    np.testing.assert_allclose(thickness, truth, rtol=THICKNESS.value)


@EVERY_TRACING
@pytest.mark.parametrize("cone_deg", [1.0, 45.0, 60.0])
@pytest.mark.parametrize("count", [1, 64])
def test_the_thickness_of_a_slab_is_exact(tracing, cone_deg, count):
    positions, faces = slab(100.0, 3.0)
    at = np.array([[1.0, 2.0, 1.5], [-7.0, 3.0, 1.5], [5.0, 5.0, -1.5]])
    normals = np.array([[0, 0, 1.0], [0, 0, 1.0], [0, 0, -1.0]])
    thickness = mesh_thickness(
        positions, faces, normals, points=at, rays=count, cone_deg=cone_deg, tracing=tracing
    )
    within = ROUNDING_SUMS if tracing == "builtin" else EMBREE_THICKNESS
    np.testing.assert_allclose(thickness, 3.0, rtol=within.value)


@pytest.fixture(scope="module")
def shell():
    """Return the body between two spheres: outer vertices, then inner ones, wound inwards."""
    outer, inner = shapes.sphere("icosphere", 4, 10.0), shapes.sphere("icosphere", 4, 7.0)
    positions = np.concatenate([outer.positions, inner.positions])
    faces = np.concatenate([outer.faces, inner.faces[:, ::-1] + len(outer.positions)])
    return positions, faces, np.concatenate([outer.normals, -inner.normals])


@EVERY_TRACING
def test_rays_in_a_shell_end_at_the_first_wall(shell, tracing):
    positions, faces, normals = shell
    subset = np.arange(0, len(positions), 61)
    thickness = mesh_thickness(
        positions, faces, normals[subset], points=positions[subset], rays=512, tracing=tracing
    )

    def inwards(cosine, s):
        missed = s >= 0.49
        return cosine * (2.0 * 10.0 * cosine if missed else 10.0 * cosine - np.sqrt(49 - 100 * s))

    def outwards(cosine, s):
        return cosine * (np.sqrt(100.0 - 49.0 * s) - 7.0 * cosine)

    is_outer = subset < len(positions) // 2
    np.testing.assert_allclose(
        thickness[is_outer], mean_over_cone(inwards, 45.0), rtol=THICKNESS_FEW_RAYS.value
    )
    np.testing.assert_allclose(
        thickness[~is_outer], mean_over_cone(outwards, 45.0), rtol=THICKNESS_FEW_RAYS.value
    )


@EVERY_TRACING
def test_a_body_beyond_a_gap_does_not_count(tracing):
    near, faces = slab(100.0, 3.0)
    positions = np.concatenate([near, near - (0.0, 0.0, 20.0)])
    both = np.concatenate([faces, faces + len(near)])
    thickness = mesh_thickness(
        positions, both, [[0.0, 0.0, 1.0]], points=[[0.3, 0.2, 1.5]], tracing=tracing
    )
    np.testing.assert_allclose(thickness, 3.0, rtol=EMBREE_THICKNESS.value)


@EVERY_TRACING
def test_a_face_that_a_ray_enters_through_does_not_end_it(tracing):
    outer, faces = slab(100.0, 3.0)
    inner, _ = slab(50.0, 1.0)  # a body inside another, as an eyeball in a head
    both = np.concatenate([faces, faces + len(outer)])
    thickness = mesh_thickness(
        np.concatenate([outer, inner]),
        both,
        [[0.0, 0.0, 1.0]],
        points=[[0.3, 0.2, 1.5]],
        tracing=tracing,
    )
    np.testing.assert_allclose(thickness, 2.0, rtol=EMBREE_THICKNESS.value)


@EVERY_TRACING
def test_rays_through_a_hole_do_not_count(tracing):
    ball = shapes.sphere("icosphere", 4, 1.0)
    upper = ball.faces[(ball.positions[ball.faces][:, :, 2] > -1e-9).all(axis=1)]
    rim = np.abs(ball.positions[:, 2]) < 1e-9
    assert rim.sum() > 20
    subset = np.append(np.flatnonzero(rim), np.argmax(ball.positions[:, 2]))
    *at_rim, at_pole = mesh_thickness(
        ball.positions,
        upper,
        ball.normals[subset],
        points=ball.positions[subset],
        rays=256,
        tracing=tracing,
    )
    # Half of the rays of a rim vertex hit the wall, as in the sphere.
    np.testing.assert_allclose(at_rim, 1.5, rtol=THICKNESS_HALF_CONE.value)
    # All rays of the pole leave through the hole: its thickness is the size of the body.
    assert at_pole == np.linalg.norm(np.ptp(ball.positions, axis=0))


def test_reversed_faces_are_no_holes():
    ball = shapes.sphere("icosphere", 3, 1.0)
    faces = ball.faces.copy()
    faces[::7] = faces[::7, ::-1]
    thickness = mesh_thickness(ball.positions, faces, ball.normals, tracing="builtin")
    np.testing.assert_allclose(thickness, 1.5, rtol=THICKNESS_FEW_RAYS.value)


# -- ray casters -----------------------------------------------------------------------------------


@pytest.mark.skipif(not EMBREE, reason="embreex is not installed")
def test_embree_finds_the_walls_that_the_builtin_caster_finds(shell):
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
def test_rays_that_hit_no_wall_have_infinite_distance(tracing):
    positions, faces = slab(2.0, 2.0)
    caster = open_caster(positions, faces, tracing)
    origins = np.array([[0.0, 0.0, 5.0], [0.2, 0.1, 0.0], [5.0, 5.0, 0.0]])
    directions = np.array([[0.0, 0.0, 1.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]])
    np.testing.assert_allclose(caster.exit_distances(origins, directions), [np.inf, 1.0, np.inf])


def test_coincident_faces_are_intersected_in_batches(monkeypatch):
    """Every ray intersects the boxes of all of them; batches bound the memory for the pairs."""
    positions, faces = slab(100.0, 3.0)
    pile = np.tile(faces, (40, 1))
    caster = casting.Hierarchy(positions, pile)
    counts = []
    nearest = casting.Hierarchy._nearest
    monkeypatch.setattr(casting, "MOST_PAIRS", 500)
    monkeypatch.setattr(
        casting.Hierarchy, "_nearest", lambda *a: counts.append(len(a[3])) or nearest(*a)
    )
    origins = np.random.default_rng(1).uniform(-1.0, 1.0, (64, 3))
    distances = caster.exit_distances(origins, np.tile([0.0, 0.0, 1.0], (64, 1)))
    np.testing.assert_allclose(distances, 1.5 - origins[:, 2], rtol=ROUNDING_SUMS.value)
    assert max(counts) <= 500


# -- units, motions, chunks ------------------------------------------------------------------------


@EVERY_TRACING
@pytest.mark.parametrize("unit", [1e-25, 1e-6, 1000.0, 1e14])
def test_thickness_scales_with_the_unit(tracing, unit):
    ball = shapes.ellipsoid("icosphere", 2, (1.0, 0.7, 0.5))
    thickness, scaled = (
        mesh_thickness(ball.positions * k, ball.faces, ball.normals, rays=16, tracing=tracing)
        for k in (1.0, unit)
    )
    within = ROUNDING_SUMS if tracing == "builtin" else EMBREE_THICKNESS
    np.testing.assert_allclose(scaled / unit, thickness, rtol=within.value)


@settings(max_examples=15)
@given(seed=st.integers(0, 10_000), shift=st.floats(-1e3, 1e3))
def test_thickness_is_invariant_under_rigid_motion(seed, shift):
    ball = shapes.ellipsoid("icosphere", 3, (1.0, 0.8, 0.6))
    turn = Rotation.random(random_state=seed).as_matrix()
    subset = np.arange(0, len(ball.positions), 31)
    still, moved = (
        mesh_thickness(p, ball.faces, n[subset], points=p[subset], rays=256, tracing="builtin")
        for p, n in (
            (ball.positions, ball.normals),
            (ball.positions @ turn.T + (shift, 0.0, -shift), ball.normals @ turn.T),
        )
    )
    np.testing.assert_allclose(moved, still, rtol=THICKNESS_FEW_RAYS.value)


def test_chunks_do_not_change_the_result_and_progress_increases_to_1(monkeypatch):
    ball = shapes.sphere("icosphere", 2)
    whole = mesh_thickness(ball.positions, ball.faces, ball.normals, rays=8, tracing="builtin")
    monkeypatch.setattr(module, "CHUNK", 100)
    fractions = []
    parts = mesh_thickness(
        ball.positions,
        ball.faces,
        ball.normals,
        rays=8,
        tracing="builtin",
        progress=lambda what, share: fractions.append(share),
    )
    np.testing.assert_array_equal(parts, whole)
    assert fractions == sorted(fractions)
    assert fractions[-1] == 1.0


# -- refused arguments -----------------------------------------------------------------------------

BALL = shapes.sphere("icosphere", 1)


@pytest.mark.parametrize(
    ("wrong", "message"),
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
        ({"points": BALL.positions}, "normals: give the normals of the points"),
        ({"points": [[0.0, 0.0]], "normals": [[0, 0, 1]]}, "points"),
    ],
)
def test_a_bad_argument_is_named(wrong, message):
    with pytest.raises(ArgumentError, match=message):
        mesh_thickness(**({"positions": BALL.positions, "faces": BALL.faces} | wrong))


def test_embree_that_is_not_installed_is_named(monkeypatch):
    monkeypatch.setattr(casting, "find_spec", lambda name: None)
    with pytest.raises(ArgumentError, match=r"skinshade\[embree\]"):
        mesh_thickness(BALL.positions, BALL.faces, tracing="embree")
    auto = mesh_thickness(BALL.positions, BALL.faces, tracing="auto")
    np.testing.assert_array_equal(
        auto, mesh_thickness(BALL.positions, BALL.faces, tracing="builtin")
    )
