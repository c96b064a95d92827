"""Ambient transfer: harmonics of visibility, bounces and diffusion at the vertices."""

import numpy as np
import pytest

import shading_tolerances as tol
import skinshade as sk
from shapes import square, unit_icosphere
from skinshade._core.harmonics import cosine_factors, harmonics
from skinshade.mesh.ambient_rays import AmbientRays, lattice_directions
from skinshade.mesh.ambient_transfer import mesh_ambient_transfer, share_sent_back

RADIUS_MM = 80.0
EVEN_SKY = np.zeros((25, 3))
EVEN_SKY[0] = np.sqrt(4.0 * np.pi)


def ball(level=3):
    points, faces = unit_icosphere(level)
    return RADIUS_MM * points, faces, points


def inside_of_a_ball(level=3):
    points, faces, normals = ball(level)
    return points, faces[:, ::-1], -normals


def hollowed_ball():
    positions, faces, normals = ball()
    return positions * (1.0 - 0.4 * np.exp(-8.0 * (1.0 - normals[:, 2:]))), faces


def test_harmonics_are_orthonormal_up_to_order_4():
    z, weights = np.polynomial.legendre.leggauss(8)
    angle = np.arange(16) / 16.0 * 2.0 * np.pi
    flat = np.sqrt(1.0 - z * z)
    directions = np.stack(
        [flat[:, None] * np.cos(angle), flat[:, None] * np.sin(angle), np.tile(z[:, None], 16)],
        axis=-1,
    )
    values = harmonics(directions, 4)
    products = np.einsum("zai,zaj,z->ij", values, values, weights) * 2.0 * np.pi / 16.0
    assert np.allclose(products, np.eye(25), atol=tol.ROUNDING_SUMS.value)


@pytest.mark.parametrize("order", [0, 1, 2, 3, 4])
@pytest.mark.parametrize(
    "shape", [ball, lambda: (square(100.0, 6).positions, square(100.0, 6).faces, None)]
)
def test_a_convex_body_and_a_plane_have_the_harmonics_of_a_clamped_cosine(shape, order):
    positions, faces, normals = shape()
    transfer = mesh_ambient_transfer(positions, faces, normals, albedo=0.5, order=order)
    own = np.tile([0.0, 0.0, 1.0], (len(positions), 1)) if normals is None else normals
    truth = cosine_factors(order) * harmonics(own, order)
    assert transfer.order == order
    assert np.allclose(transfer.visible, truth, atol=tol.ROUNDING_SUMS.value)
    assert np.allclose(transfer.total, truth[:, None], atol=tol.ROUNDING_SUMS.value)


def test_the_factors_of_the_clamped_cosine_are_its_integrals_with_legendre_polynomials():
    x, weights = np.polynomial.legendre.leggauss(40)
    x, weights = 0.5 * x + 0.5, 0.5 * weights
    polynomials = np.polynomial.legendre.legvander(x, 4)
    integrals = 2.0 * (weights * x) @ polynomials
    assert np.allclose(cosine_factors(4)[[0, 1, 4, 9, 16]], integrals, atol=tol.ROUNDING.value)


def test_no_light_enters_a_closed_body_and_none_leaves_it():
    positions, faces, normals = inside_of_a_ball()
    transfer = mesh_ambient_transfer(positions, faces, normals, albedo=0.5)
    assert np.abs(transfer.total).max() <= tol.CAVITY_LEAK.value
    rays = AmbientRays.cast(positions, faces, normals)
    light = np.ones((len(positions), 1))
    white = rays.bounced(light, share_sent_back(light), faces, 1)
    assert np.allclose(white, 1.0, atol=1e-6)  # float32 weights


def test_the_light_of_an_even_sky_is_at_most_that_of_the_sky_and_grows_with_the_albedo():
    positions, faces = hollowed_ball()
    dark, grey, white = (
        mesh_ambient_transfer(positions, faces, albedo=albedo).irradiance(EVEN_SKY)
        for albedo in (0.0, 0.5, 1.0)
    )
    assert (dark <= grey).all()
    assert (grey <= white).all()
    assert white.max() <= 1.0 + tol.ROUNDING_SUMS.value


def test_diffusion_keeps_the_light_of_every_channel_over_the_body(deon):
    hollow, faces = hollowed_ball()
    plain, diffused = (
        mesh_ambient_transfer(hollow, faces, albedo=0.5, profile=profile)
        for profile in (None, deon)
    )
    from skinshade.mesh.topology import corner_areas

    area = corner_areas(hollow, faces, len(hollow))
    before, after = (np.einsum("v,vch->ch", area, each.total) for each in (plain, diffused))
    assert np.allclose(before, after, atol=1e-3 * area.sum())
    assert not np.allclose(plain.total, diffused.total, atol=1e-3)


def test_vertices_of_a_large_mesh_share_their_directions(monkeypatch):
    monkeypatch.setattr("skinshade.mesh.ambient_rays.MOST_RAYS", 10_000)
    positions, faces, normals = inside_of_a_ball()
    open_faces = faces[(normals[faces][:, :, 2] <= 0.0).all(axis=1)]
    rays = AmbientRays.cast(positions, open_faces, normals)
    assert rays.directions.shape == (16, 32, 3)
    deep = normals[:, 2] > 0.2
    open_share = rays.arriving(np.ones((16, 32, 1)))[:, 0]
    assert open_share[deep].mean() == pytest.approx(0.5, abs=tol.BOWL_MEAN.value)


def test_rays_from_the_cache_are_those_that_were_cast():
    mesh = sk.builtin_head().mesh
    first, second = (
        AmbientRays.cast(mesh.positions_mm, mesh.faces, mesh.normals) for _ in range(2)
    )
    for name in ("free", "depth", "turn", "directions", "behind"):
        assert np.array_equal(getattr(first, name), getattr(second, name))
    for name in ("starts", "faces", "weights"):
        assert np.array_equal(getattr(first.seen, name), getattr(second.seen, name))


def test_a_damaged_file_of_the_cache_is_not_used(tmp_path, monkeypatch):
    monkeypatch.setenv("SKINSHADE_CACHE", str(tmp_path))
    mesh = sk.builtin_head().mesh
    arguments = mesh.positions_mm, mesh.faces, mesh.normals
    first = AmbientRays.cast(*arguments, directions=32)
    (stored,) = (tmp_path / "arrays").iterdir()
    for content in (b"", b"not an archive", stored.read_bytes()[:1000]):
        stored.write_bytes(content)
        assert np.array_equal(AmbientRays.cast(*arguments, directions=32).free, first.free)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"order": 5}, "order is 5"),
        ({"order": 1.5}, "order is 1.5"),
        ({"bounces": -1}, "bounces is -1"),
        ({"albedo": 1.5}, "albedo"),
        ({"albedo": (0.5, 0.5)}, "albedo: shape"),
        ({"tracing": "magic"}, "tracing"),
    ],
)
def test_an_argument_out_of_range_is_named(arguments, message):
    positions, faces, normals = ball(1)
    with pytest.raises(sk.SkinshadeError, match=message):
        mesh_ambient_transfer(positions, faces, normals, **arguments)


def test_a_lattice_covers_the_sphere_evenly():
    directions = lattice_directions(256)
    assert np.allclose(directions.mean(axis=0), 0.0, atol=0.01)
    assert np.allclose(directions.T @ directions / 256.0, np.eye(3) / 3.0, atol=0.01)
