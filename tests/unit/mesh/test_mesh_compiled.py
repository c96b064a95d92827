"""Compiled mesh analysis against its NumPy twins, on any meshes."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import shapes
import tolerances as tol
from native_twins import both, level, needs_library, numpy_twins, relative_gap, threads
from skinshade._core import native
from skinshade.mesh import (
    compiled,
    compiled_tables,
    mesh_curvature,
    mesh_curvature_tensor,
    mesh_uv_scale,
)
from skinshade.mesh.curvature import tensor_to_world
from skinshade.mesh.normals import vertex_normals
from skinshade.mesh.repairs import first_of_equal
from skinshade.mesh.shape_operator import ShapeOperator
from skinshade.mesh.topology import (
    corner_areas,
    face_areas,
    open_edge_counts,
    used_vertices,
    weld,
)

pytestmark = needs_library


def bumpy_square(cells, seed, hole=False):
    """Return a square with noise in its positions: positions, faces."""
    flat = shapes.square(1.0, cells)
    rng = np.random.default_rng(seed)
    positions = flat.positions + rng.uniform(-0.3, 0.3, flat.positions.shape) / cells
    faces = flat.faces[rng.permutation(len(flat.faces))]
    return positions, faces[len(faces) // 10 :] if hole else faces


def shuffled(positions, faces, seed=0):
    """Return a mesh with its vertices and faces in a random order."""
    rng = np.random.default_rng(seed)
    order = rng.permutation(len(positions))
    number = np.empty_like(order)
    number[order] = np.arange(len(order))
    return positions[order], number[faces][rng.permutation(len(faces))]


@st.composite
def any_mesh(draw):
    """Positions on a lattice, so that many are equal, and faces between any of them."""
    count = draw(st.integers(3, 40))
    corner = st.integers(0, count - 1)
    faces = draw(st.lists(st.tuples(corner, corner, corner), min_size=1, max_size=80))
    lattice = draw(st.lists(st.tuples(*[st.integers(-1, 1)] * 3), min_size=count, max_size=count))
    unit = draw(st.sampled_from([1.0, 0.1, 1e-12, 1e12]))
    return np.array(lattice) * unit, np.array(faces, dtype=np.int64)


@pytest.fixture(params=["as given", "sorted by position"], autouse=True)
def order(request, monkeypatch):
    """Work in the order of the mesh, and in an order that keeps neighbours near."""
    monkeypatch.setattr(compiled_tables, "is_disordered", lambda faces: request.param != "as given")


def in_every_order(function):
    """Return the result of a function in both orders of `corners`."""
    results = []
    for disordered in (False, True):
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(compiled_tables, "is_disordered", lambda faces, answer=disordered: answer)
            results.append(function())
    return results


# -- topology: equal -------------------------------------------------------------------------------


@given(any_mesh())
def test_groups_of_equal_positions_are_those_of_numpy(mesh):
    positions, _ = mesh
    (group, first), (twin, twin_first) = both(weld, positions)
    assert np.array_equal(group[:, None] == group, twin[:, None] == twin)
    assert np.array_equal(first[group], twin_first[twin])
    assert (np.diff(first) > 0).all()


@pytest.mark.parametrize("count", [1, 100, 30_000])
def test_all_vertices_of_one_position_are_one_group(count):
    group, first = weld(np.ones((count, 3)))
    assert first.tolist() == [0]
    assert not group.any()


def test_large_sets_of_positions_are_welded_as_by_numpy():
    rng = np.random.default_rng(0)
    positions = rng.integers(0, 30, (40_000, 3)) * 0.1
    (group, first), (twin, twin_first) = both(weld, positions)
    assert np.array_equal(np.sort(first), np.sort(twin_first))
    assert np.array_equal(first[group], twin_first[twin])


@given(any_mesh())
def test_counts_of_faulty_edges_are_those_of_numpy(mesh):
    for result in in_every_order(lambda: open_edge_counts(*mesh)):
        with numpy_twins():
            assert result == open_edge_counts(*mesh)


def test_edges_of_a_vertex_with_many_faces_are_counted():
    rim = 300
    angle = np.arange(rim) * 2.0 * np.pi / rim
    positions = np.vstack([np.zeros(3), np.stack([np.cos(angle), np.sin(angle), angle], axis=1)])
    corner = 1 + np.random.default_rng(0).permutation(rim)
    faces = np.stack([np.zeros_like(corner), corner, corner % rim + 1], axis=1)
    faces = np.concatenate([faces, faces[:5], faces[10:13, ::-1]])
    compiled_counts, twin = both(open_edge_counts, positions, faces)
    assert compiled_counts == twin
    assert twin["non-manifold edges"] > 0


@given(any_mesh())
def test_the_first_of_equal_faces_is_that_of_numpy(mesh):
    positions, faces = mesh
    turned = np.concatenate([faces, np.roll(faces, 1, axis=1), faces[:, ::-1]])
    first, twin = both(first_of_equal, turned, len(positions))
    assert np.array_equal(first, twin)


@given(any_mesh())
def test_areas_and_used_vertices_are_those_of_numpy(mesh):
    positions, faces = mesh
    for function in (face_areas, lambda p, f: corner_areas(p, f, len(p))):
        areas, twin = both(function, positions, faces)
        assert np.array_equal(areas, twin)
    used, twin = both(used_vertices, faces, len(positions))
    assert np.array_equal(used, twin)


# -- normals, curvature and scale: equal within rounding --------------------------------------------


@pytest.mark.parametrize("hole", [False, True])
@pytest.mark.parametrize("cells", [1, 2, 9, 70])
def test_normals_are_those_of_numpy(cells, hole):
    positions, faces = bumpy_square(cells, seed=cells, hole=hole)
    for mesh in ((positions, faces), shuffled(positions, faces)):
        normals, twin = both(vertex_normals, *mesh)
        assert np.abs(normals - twin).max() <= tol.NATIVE_NORMALS.value


def test_three_open_fans_at_a_vertex_of_a_grid_are_no_closed_fan():
    # The sums of the next and of the previous vertices are equal, and so are the sums of their squares.
    positions = np.random.default_rng(0).normal(size=(3400, 3))
    faces = np.array([[3294, 3366, 3295], [3222, 3294, 3223], [3293, 3365, 3294]])
    for normals in in_every_order(lambda: vertex_normals(positions, faces)):
        with numpy_twins():
            gap = np.abs(normals - vertex_normals(positions, faces)).max()
        assert gap <= tol.NATIVE_NORMALS.value


@given(any_mesh())
def test_normals_of_any_mesh_are_unit_vectors_or_zero(mesh):
    for normals in in_every_order(lambda: vertex_normals(*mesh)):
        length = np.linalg.norm(normals, axis=1)
        assert np.isclose(length, np.round(length), atol=tol.ROUNDING.value).all()
        assert length.max() < 1.5


def world_tensor(positions, faces, normals, smoothing):
    tensor = mesh_curvature_tensor(positions, faces, normals, smoothing=smoothing)
    own = vertex_normals(positions, faces) if normals is None else normals
    unit = own / np.maximum(np.linalg.norm(own, axis=1), 1e-300)[:, None]
    return tensor_to_world(tensor, unit)


@given(any_mesh(), st.integers(0, 3), st.booleans())
def test_curvature_of_any_mesh_is_that_of_numpy(mesh, smoothing, aligned):
    positions, faces = mesh
    normals = np.random.default_rng(len(faces)).normal(size=positions.shape)
    if aligned:
        normals = np.tile([0.0, 0.6, 0.8], (len(positions), 1))

    def analysis():
        mean = mesh_curvature(positions, faces, normals, smoothing=smoothing)
        tensor = world_tensor(positions, faces, normals, smoothing)
        return mean, tensor, ShapeOperator.fit(positions, faces, normals).bounded_vertices

    with numpy_twins():
        twin = analysis()
    for result in in_every_order(analysis):
        assert relative_gap(result[0], twin[0]) <= tol.NATIVE_ANY_MESH.value
        assert relative_gap(result[1], twin[1]) <= tol.NATIVE_ANY_MESH.value
        assert result[2] == twin[2]


@pytest.mark.parametrize("smoothing", [0, 1, 2, 5])
@pytest.mark.parametrize("given_normals", [True, False])
@pytest.mark.parametrize("split", [False, True])
def test_curvature_of_surfaces_is_that_of_numpy(smoothing, given_normals, split):
    shape = shapes.ellipsoid("random", 4000, (3.0, 2.0, 1.0))
    positions, faces, normals = shape.positions, shape.faces[20:], 2.0 * shape.normals
    if split:
        positions, faces, normals, _ = shapes.split_seam(shape)
    mesh = positions, faces, normals if given_normals else None
    mean, twin = both(lambda: mesh_curvature(*mesh, smoothing=smoothing))
    assert relative_gap(mean, twin) <= tol.NATIVE_CURVATURE.value
    tensor, twin = both(lambda: world_tensor(*mesh, smoothing))
    assert relative_gap(tensor, twin) <= tol.NATIVE_CURVATURE.value


@given(st.integers(1, 2000), st.integers(0, 100))
def test_the_uv_scale_is_that_of_numpy(count, seed):
    rng = np.random.default_rng(seed)
    positions, uvs = rng.normal(size=(50, 3)), rng.normal(size=(50, 2))
    positions[:3], uvs[3:6] = 0.0, 0.0
    positions *= 10.0 ** rng.integers(-12, 12)
    uvs *= 10.0 ** rng.integers(-160, 12)
    faces = np.vstack([rng.integers(0, 50, (count, 3)), [0, 1, 2], [3, 4, 5], [0, 10, 20]])
    scale, twin = both(mesh_uv_scale, positions, uvs, faces)
    assert scale == pytest.approx(twin, rel=tol.NATIVE_CURVATURE.value)


# -- the same bytes --------------------------------------------------------------------------------


def analysis(positions, faces, normals):
    """Return all results of the kernels for a mesh."""
    operator = ShapeOperator.fit(positions, faces, normals)
    return [
        mesh_curvature(positions, faces),
        mesh_curvature(positions, faces, normals),
        operator.mean(0),
        operator.tensor(),
        vertex_normals(positions, faces),
        corner_areas(positions, faces, len(positions)),
        *weld(positions),
        first_of_equal(np.concatenate([faces, faces[::3]]), len(positions)),
        np.array(list(open_edge_counts(positions, faces).values())),
        mesh_uv_scale(positions, positions[:, :2], faces),
    ]


MESHES = {
    "open, with a seam": lambda: shapes.split_seam(shapes.cylinder(1.0, 3.0, 64, 40))[:3],
    "random": lambda: (lambda s: (s.positions, s.faces, s.normals))(shapes.torus("random", 4000)),
}


def assert_same_bytes(results, expected):
    for result, other in zip(results, expected, strict=True):
        assert np.array_equal(result, other)


@pytest.mark.parametrize("make", MESHES.values(), ids=MESHES)
def test_results_have_the_same_bytes_for_any_number_of_threads(make):
    mesh = make()
    with threads(1):
        expected = analysis(*mesh)
    for count in (2, 7):
        with threads(count):
            assert_same_bytes(analysis(*mesh), expected)


@pytest.mark.skipif(native.reason() != "compiled, x86-64-v3", reason="no second level")
@pytest.mark.parametrize("make", MESHES.values(), ids=MESHES)
def test_results_have_the_same_bytes_for_all_levels_of_instructions(make):
    mesh = make()
    with level("v2"):
        expected = analysis(*mesh)
    with level("v3"):
        assert_same_bytes(analysis(*mesh), expected)


def test_mean_curvature_has_the_same_bytes_as_that_of_the_operator():
    positions, faces, normals = MESHES["open, with a seam"]()
    operator = ShapeOperator.fit(positions, faces, normals)
    for smoothing in (0, 2):
        mean = mesh_curvature(positions, faces, normals, smoothing=smoothing)
        assert np.array_equal(operator.mean(smoothing), mean)


# -- types and layouts -----------------------------------------------------------------------------


def test_positions_may_be_float32_and_faces_int32():
    shape = shapes.sphere("random", 2000)
    positions, faces = shape.positions.astype(np.float32), shape.faces.astype(np.int32)
    wide = positions.astype(np.float64)
    assert np.array_equal(compiled.weld(positions)[0], compiled.weld(wide)[0])
    assert np.array_equal(
        compiled.face_areas(positions, faces), compiled.face_areas(wide, shape.faces)
    )
    assert np.array_equal(
        compiled.vertex_normals(positions, faces), compiled.vertex_normals(wide, shape.faces)
    )


def test_arrays_may_have_any_strides():
    shape = shapes.sphere("random", 2000)
    expected = mesh_curvature(shape.positions, shape.faces, shape.normals)
    columns = [np.asfortranarray(a) for a in (shape.positions, shape.faces, shape.normals)]
    assert np.array_equal(mesh_curvature(*columns), expected)
    gaps = [np.repeat(a, 2, axis=1)[:, ::2] for a in (shape.positions, shape.faces, shape.normals)]
    assert np.array_equal(mesh_curvature(*gaps), expected)


def test_arguments_are_not_changed():
    shape = shapes.sphere("random", 500)
    before = [shape.positions, shape.faces, 3.0 * shape.normals]
    arrays = [array.copy() for array in before]
    results = [mesh_curvature(*arrays), mesh_curvature_tensor(*arrays), vertex_normals(*arrays[:2])]
    assert all(np.array_equal(array, copy) for array, copy in zip(arrays, before, strict=True))
    assert not any(np.shares_memory(result, array) for result in results for array in arrays)


def test_meshes_beyond_the_indices_of_the_tables_are_left_to_numpy(monkeypatch):
    shape = shapes.sphere("icosphere", 1)
    monkeypatch.setattr(compiled, "MOST_ROWS", len(shape.faces))
    monkeypatch.setattr(compiled.Corners, "of", lambda *_: pytest.fail("compiled"))
    mesh_curvature(shape.positions, shape.faces)


# -- orders ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("seed", [0, 1])
def test_only_random_orders_are_sorted(seed, monkeypatch):
    monkeypatch.undo()
    grid = shapes.square(1.0, 250)
    assert not compiled_tables.is_disordered(grid.faces)
    assert not compiled_tables.is_disordered(grid.faces[::-1])
    _, faces = shuffled(grid.positions, grid.faces, seed)
    assert compiled_tables.is_disordered(faces)
    rng = np.random.default_rng(seed)
    assert compiled_tables.is_disordered(grid.faces[rng.permutation(len(grid.faces))])
    assert not compiled_tables.is_disordered(grid.faces[:1])


def test_a_far_point_does_not_change_the_others():
    positions, faces = bumpy_square(20, 0)
    expected = vertex_normals(positions, faces)
    far = np.vstack([positions, [1e15, -1e15, 1e15]])
    for normals in in_every_order(lambda: vertex_normals(far, faces)):
        assert np.array_equal(normals[:-1], expected)
        assert not normals[-1].any()
