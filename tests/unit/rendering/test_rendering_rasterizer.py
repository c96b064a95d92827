from functools import cache

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import shading_tolerances as tol
from shapes import square, unit_icosphere
from skinshade.rendering.prepare import rasterizer
from skinshade.rendering.prepare.rasterizer import depth_maps, rasterize
from skinshade.scene.camera import look_at, parallel, perspective

SEED = st.integers(0, 2**20)
SIZE = (16, 12)
CENTRE = (0.5, 0.5)


def random_triangles(seed, count=8, w=(0.5, 4.0)):
    """Clip coordinates of triangles that share no vertex, larger than the screen or within it."""
    rng = np.random.default_rng(seed)
    depth = rng.uniform(*w, 3 * count)
    ndc = np.repeat(rng.uniform(-1.0, 1.0, (count, 2)), 3, axis=0)
    ndc += rng.normal(size=(3 * count, 2)) * np.repeat(rng.uniform(0.1, 1.0, count), 3)[:, None]
    clip = np.column_stack([ndc * np.abs(depth)[:, None], np.zeros(3 * count), depth])
    return clip, np.arange(3 * count).reshape(-1, 3)


def samples(size, offset):
    y, x = np.divmod(np.arange(size[0] * size[1]), size[0])
    return x + offset[0], y + offset[1]


def flat_reference(clip, faces, size, offset):
    """Each sample against each triangle on the screen: weights there, then 1/w interpolated.

    Returns barycentric (S, F, 3), depth (S, F), least weight (S, F) on the screen.
    """
    w = clip[:, 3][faces]
    sx = ((0.5 * clip[:, 0] / clip[:, 3] + 0.5) * size[0])[faces]
    sy = ((0.5 - 0.5 * clip[:, 1] / clip[:, 3]) * size[1])[faces]
    x, y = (v[:, None] for v in samples(size, offset))

    def area(i, j):
        return (sx[:, i] - x) * (sy[:, j] - y) - (sx[:, j] - x) * (sy[:, i] - y)

    flat = np.stack([area(1, 2), area(2, 0), area(0, 1)], axis=-1)
    flat = flat / flat.sum(axis=-1, keepdims=True)
    over_w = flat / w
    inverse = over_w.sum(axis=-1)
    return over_w / inverse[..., None], 1.0 / inverse, flat.min(axis=-1)


def ray_reference(clip, faces, size, offset):
    """Each sample as a ray from the eye, in (x, y, w): holds for triangles through the eye's plane."""
    x, y = samples(size, offset)
    rays = np.stack([2.0 * x / size[0] - 1.0, 1.0 - 2.0 * y / size[1], np.ones_like(x)], axis=-1)
    corners = clip[:, [0, 1, 3]][faces]
    # Σ bᵢ cornerᵢ = t·ray with Σ bᵢ = 1
    solved = np.einsum("fik,sk->sfi", np.linalg.inv(corners.transpose(0, 2, 1)), rays)
    inverse = solved.sum(axis=-1)
    barycentric = solved / inverse[..., None]
    depth = 1.0 / inverse
    return barycentric, depth, np.where(depth > 0.0, barycentric.min(axis=-1), -1.0)


def assert_seen(clip, faces, reference, offset=CENTRE):
    barycentric, depth, least = reference(clip, faces, SIZE, offset)
    assume(np.abs(least).min() > 1e-9)  # a sample on an edge belongs to either side
    depth = np.where(least > 0.0, depth, np.inf)
    found = rasterize(clip, faces, SIZE, offset)
    covered = np.flatnonzero(np.isfinite(depth).any(axis=1))
    assert found.pixel.tolist() == covered.tolist()
    nearest = depth[covered].argmin(axis=1)
    assert found.face.tolist() == nearest.tolist()
    error = np.abs(found.barycentric - barycentric[covered, nearest])
    assert error.max(initial=0.0) <= tol.RASTER.value
    w = (found.barycentric * clip[:, 3][faces[found.face]]).sum(axis=1)
    assert np.allclose(w, depth[covered].min(axis=1), rtol=tol.RASTER.value)
    return found


@given(SEED, st.floats(0.0, 1.0), st.floats(0.0, 1.0))
def test_each_sample_sees_the_nearest_triangle_that_it_lies_in(seed, x, y):
    assert_seen(*random_triangles(seed), flat_reference, (x, y))


@given(SEED)
def test_triangles_through_the_plane_of_the_eye_are_cut_there(seed):
    clip, faces = random_triangles(seed, w=(-2.0, 4.0))
    assume(np.abs(np.linalg.det(clip[:, [0, 1, 3]][faces])).min() > 1e-6)
    assert_seen(clip, faces, ray_reference)


def test_what_lies_behind_the_eye_is_not_seen():
    clip, faces = random_triangles(3, w=(-4.0, -0.5))
    assert rasterize(clip, faces, SIZE).pixel.size == 0


def test_a_floor_from_under_the_eye_to_far_away_fills_the_picture_up_to_the_horizon():
    matrix = perspective(60.0, 1.0, 0.1, 100.0)
    floor = np.array([[-1e4, -1.0, 1e4], [1e4, -1.0, 1e4], [1e4, -1.0, -1e4], [-1e4, -1.0, -1e4]])
    clip = floor @ matrix[:, :3].T + matrix[:, 3]
    seen = rasterize(clip, np.array([[0, 1, 2], [0, 2, 3]]), (20, 20))
    assert seen.pixel.tolist() == list(range(200, 400))
    depth = (seen.barycentric * clip[:, 3][[[0, 1, 2], [0, 2, 3]]][seen.face]).sum(axis=1)
    slope = (2.0 * (seen.pixel // 20 + 0.5) / 20.0 - 1.0) * np.tan(np.radians(30.0))
    assert np.allclose(depth, 1.0 / slope, rtol=tol.FAR_FLOOR.value)


@given(SEED)
def test_derivatives_are_the_change_from_one_pixel_to_the_next(seed):
    clip, faces = random_triangles(seed, count=3)
    step = 1e-5
    middle = rasterize(clip, faces, SIZE)
    for axis, along in enumerate((middle.along_x, middle.along_y)):
        ends = []
        for sign in (-1.0, 1.0):
            offset = [0.5, 0.5]
            offset[axis] += sign * step
            bary, _, _ = flat_reference(clip, faces, SIZE, tuple(offset))
            ends.append(bary[middle.pixel, middle.face])
        slope = (ends[1] - ends[0]) / (2.0 * step)
        error = np.abs(slope - along) / (1.0 + np.abs(along))
        assert error.max(initial=0.0) <= tol.RASTER_SLOPE.value


@pytest.mark.parametrize("cells", [1, 2, 4, 8])
@given(seed=SEED)
def test_edges_and_corners_at_the_samples_leave_no_gap(cells, seed):
    plane = square(2.5, cells)  # its border lies outside the picture, its corners on samples
    xy = plane.positions[:, :2] - 1.25
    w = np.random.default_rng(seed).uniform(0.5, 3.0, len(xy))
    clip = np.column_stack([xy * w[:, None], 0.0 * w, w])
    for size, offset in (((20, 20), (0.0, 1.0)), ((10, 10), CENTRE), ((5, 5), CENTRE)):
        seen = rasterize(clip, plane.faces, size, offset).pixel
        assert seen.tolist() == list(range(size[0] * size[1]))


@given(SEED)
def test_a_closed_body_seen_from_anywhere_has_no_hole(seed):
    rng = np.random.default_rng(seed)
    u, faces = unit_icosphere(2)
    eye = rng.normal(size=3)
    view = look_at(3.0 * eye / np.linalg.norm(eye), np.zeros(3), rng.normal(size=3))
    matrix = perspective(60.0, 1.0, 0.1, 10.0) @ view
    clip = u @ matrix[:, :3].T + matrix[:, 3]
    seen = np.zeros((31, 31), dtype=bool)
    seen.ravel()[rasterize(clip, faces, (31, 31)).pixel] = True
    x, y = (v.reshape(31, 31) * 2.0 / 31.0 - 1.0 for v in samples((31, 31), CENTRE))
    outline = np.tan(np.arcsin(1.0 / 3.0)) / np.tan(np.radians(30.0))
    assert seen[np.hypot(x, y) < 0.95 * outline].all()
    assert not seen[np.hypot(x, y) > outline].any()


@given(SEED)
def test_samples_within_two_halves_of_a_square_are_seen_once(seed):
    """A triangle and its neighbour never both cover a sample that is off their edge."""
    rng = np.random.default_rng(seed)
    corners, w = rng.uniform(-1.0, 1.0, (4, 2)), rng.uniform(0.5, 3.0, 4)
    clip = np.column_stack([corners * w[:, None], 0.0 * w, w])
    halves = np.array([[0, 1, 2], [0, 2, 3]])
    side = [np.linalg.det(np.column_stack([corners[half], np.ones(3)])) for half in halves]
    assume(side[0] * side[1] > 0.0)
    one, other = (set(rasterize(clip, halves[i : i + 1], SIZE).pixel) for i in (0, 1))
    both = set(rasterize(clip, halves, SIZE).pixel)
    assert not one & other
    assert one | other == both


@given(SEED)
def test_neither_the_order_of_faces_nor_the_size_of_batches_matters(seed):
    clip, faces = random_triangles(seed)
    order = np.random.default_rng(seed).permutation(len(faces))
    plain, shuffled = rasterize(clip, faces, SIZE), rasterize(clip, faces[order], SIZE)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(rasterizer, "CANDIDATES_PER_BATCH", 50)
        batched = rasterize(clip, faces, SIZE)
    assert plain.pixel.tolist() == shuffled.pixel.tolist() == batched.pixel.tolist()
    assert plain.face.tolist() == order[shuffled.face].tolist() == batched.face.tolist()
    assert np.array_equal(plain.barycentric, batched.barycentric)


def test_either_side_of_a_face_is_seen_and_one_seen_edge_on_is_not():
    clip = np.array([[-1.0, -1, 0, 1], [1, -1, 0, 1], [0, 1, 0, 1]])
    front, back = (rasterize(clip, np.array([f]), SIZE) for f in ([0, 1, 2], [2, 1, 0]))
    assert front.pixel.size > 50
    assert np.array_equal(front.pixel, back.pixel)
    assert np.allclose(front.barycentric, back.barycentric[:, ::-1])
    flat = np.array([[0.0, -1, 0, 1], [0, 1, 0, 1], [0, 0, 0, 2]])
    assert rasterize(flat, np.array([[0, 1, 2]]), (15, 15)).pixel.size == 0


@cache
def ball_depths(size=64):
    u, faces = unit_icosphere(5)
    view = look_at(np.array([0.0, 0.0, 5.0]), np.zeros(3), np.array([0.0, 1.0, 0.0]))
    seen = u @ view[:3, :3].T + view[:3, 3]
    clip = seen @ parallel(1.5, 1.0, 9.0)[:, :3].T
    clip[:, 3] = 1.0
    return u, faces, clip, depth_maps(clip, -seen[:, 2], faces, (size, size))


def test_depth_maps_of_a_ball_are_its_near_and_its_far_side():
    _, _, _, (first, away) = ball_depths()
    x, y = (v.reshape(64, 64) * 3.0 / 64.0 - 1.5 for v in samples((64, 64), CENTRE))
    within, outside = np.hypot(x, y) < 0.9, np.hypot(x, y) > 1.0
    half = np.sqrt(np.maximum(1.0 - x * x - y * y, 0.0))
    assert np.abs(first - (5.0 - half))[within].max() <= tol.FACETED_BALL.value
    assert np.abs(away - (5.0 + half))[within].max() <= tol.FACETED_BALL.value
    assert np.isinf(first[outside]).all()
    assert np.isinf(away[outside]).all()


def test_a_ball_turned_inside_out_faces_away_on_its_near_side():
    u, faces, clip, (near, _) = ball_depths()
    first, away = depth_maps(clip, 5.0 - u[:, 2], faces[:, ::-1], (64, 64))
    assert np.array_equal(first, away)
    assert np.allclose(first, near, rtol=tol.ROUNDING_SUMS.value)
