import hashlib
from importlib.resources import files
from pathlib import Path

import numpy as np
import pooch
import pytest
from scipy.spatial import cKDTree

import shading_tolerances as tol
from skinshade._core.errors import ArgumentError, DownloadError, MeshFileError
from skinshade.mesh.topology import weld
from skinshade.render.cpu.raster import rasterize
from skinshade.scene import Environment, heads
from skinshade.scene.head_maps import head_maps
from skinshade.scene.heads import SCANS, Scan, builtin_head, fetch_scan, head_scene, model

GLB = files("skinshade.scene").joinpath("assets/head.glb")


@pytest.fixture(scope="module")
def head():
    return builtin_head()


@pytest.fixture(scope="module")
def small_maps(head):
    """Maps of 256 texels of two seeds, the first one twice."""
    mesh, _ = head
    regions = mesh.attributes["_REGION"] / 255.0
    given = (mesh.positions_mm, mesh.normals, mesh.uvs, mesh.faces, regions)
    return [head_maps(*given, size=256, seed=seed) for seed in (0, 0, 1)]


def test_the_head_ships_in_less_than_a_megabyte():
    assert len(GLB.read_bytes()) <= 1_000_000


def test_the_head_needed_no_repair_and_is_closed_once_its_seams_are_welded(head):
    mesh, _ = head
    assert mesh.repairs == {}
    group, first = weld(mesh.positions)
    faces = group[mesh.faces]
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    assert len(np.unique(edges, axis=0)) == len(edges), "each edge once in each direction"
    assert np.array_equal(np.unique(edges, axis=0), np.unique(edges[:, ::-1], axis=0))
    assert first.size - len(edges) // 2 + len(faces) == 2, "a body without handles"
    p = mesh.positions_mm[mesh.faces]
    volume = np.einsum("ij,ij->i", p[:, 0], np.cross(p[:, 1], p[:, 2])).sum() / 6.0
    assert 3e6 < volume < 8e6, "mm³, and turned outwards"


def test_the_head_is_as_large_as_a_mans(head):
    low, high = (f(head[0].positions_mm, axis=0) for f in (np.min, np.max))
    width, height, depth = high - low
    assert 150.0 < width < 190.0, "ear to ear"
    assert 180.0 < depth < 230.0
    assert 250.0 < height < 350.0, "with its neck"
    assert high[2] > -low[2], "the nose points to +z"


def test_normals_are_unit_and_point_the_way_of_their_faces(head):
    mesh, _ = head
    assert np.abs(np.linalg.norm(mesh.normals, axis=1) - 1.0).max() <= tol.ROUNDING.value
    p = mesh.positions[mesh.faces]
    across = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
    agree = np.einsum("fk,fik->fi", across, mesh.normals[mesh.faces]) > 0.0
    assert agree.mean() >= 1.0 - tol.FOLDED_CORNERS.value


def test_both_halves_are_alike_and_not_the_same(head):
    p = head[0].positions_mm
    apart, _ = cKDTree(p).query(p * (-1.0, 1.0, 1.0))
    assert apart.max() <= tol.FACE_HALVES_MM.value


def test_uvs_lie_within_the_texture_unmirrored_and_do_not_overlap(head):
    mesh, _ = head
    assert mesh.uvs.min() >= 0.0
    assert mesh.uvs.max() <= 1.0
    q = mesh.uvs[mesh.faces]
    d1, d2 = q[:, 1] - q[:, 0], q[:, 2] - q[:, 0]
    area = 0.5 * (d1[:, 0] * d2[:, 1] - d1[:, 1] * d2[:, 0])
    assert area.max() < 0.0, "v runs down: what is not mirrored turns clockwise"
    assert 0.5 < -area.sum() < 1.0
    ends = np.tile([0.0, 1.0], (len(mesh.uvs), 1))
    clip = np.concatenate([2.0 * mesh.uvs - 1.0, ends], axis=1)
    covered = rasterize(clip, mesh.faces, (512, 512)).pixel.size / 512.0**2
    assert covered == pytest.approx(-area.sum(), abs=tol.CHART_AREA.value)


def test_maps_are_light_unit_normals_and_gloss(head):
    _, skin = head
    assert skin.albedo.shape[:2] == skin.normal.shape[:2] == (2048, 2048)
    assert skin.specular.shape[:2] == skin.deep_scatter.shape[:2] == (1024, 1024)
    for name in ("albedo", "deep_scatter"):
        picture = getattr(skin, name)
        assert picture.min() >= 0.0
        assert picture.max() <= 1.0
        red, green, blue = picture.reshape(-1, 3).mean(axis=0)
        assert red > green > blue, "skin, and blood"
    length = np.linalg.norm(skin.normal, axis=2)
    assert np.abs(length - 1.0).max() <= tol.FLOAT32.value
    assert skin.normal[..., 2].min() > 0.5
    assert 0.0 <= skin.specular[..., 1].min() <= skin.specular[..., 1].max() <= 1.0
    assert 0.2 < skin.specular[..., 0].min() < 1.0 < skin.specular[..., 0].max() < 3.0


def test_maps_are_what_their_seed_makes_them(small_maps):
    one, again, other = small_maps
    for name in ("albedo", "normal", "specular", "deep_scatter"):
        assert getattr(one, name).tobytes() == getattr(again, name).tobytes()
        assert getattr(one, name).tobytes() != getattr(other, name).tobytes()
    means = [maps.albedo.mean(axis=(0, 1)) for maps in (one, other)]
    assert np.allclose(*means, rtol=0.05), "another seed is the same skin"


@pytest.mark.parametrize("seed", [-1, 0.5, None])
def test_a_seed_that_is_none_is_refused_by_name(seed):
    with pytest.raises(ArgumentError, match=f"seed is {seed}; it must be a whole number"):
        builtin_head(seed)


@pytest.mark.parametrize("size", [15, 14, 17])
def test_a_texture_that_cannot_be_halved_is_refused_by_name(size):
    none = np.zeros((0, 3))
    with pytest.raises(ArgumentError, match=f"size is {size}; it must be even"):
        head_maps(none, none, none, none.astype(int), none, size=size)


def test_the_head_is_made_once():
    assert builtin_head() is builtin_head()


@pytest.mark.parametrize("aspect", [1.0, 16.0 / 9.0])
@pytest.mark.parametrize("yaw", [0.0, 28.0, -90.0])
def test_a_portrait_holds_the_whole_head_and_little_more(head, aspect, yaw):
    scene = head_scene(*head, yaw_deg=yaw)
    p = scene.mesh.positions_mm
    matrix = scene.camera.view_projection(aspect)
    clip = p @ matrix[:, :3].T + matrix[:, 3]
    x, y = (clip[:, :2] / clip[:, 3:]).T
    skull = p[:, 1] > -100.0  # above the chin
    assert np.abs(x[skull]).max() < 1.0
    assert np.abs(y[skull]).max() < 1.0
    assert y.max() > 0.7
    assert len(scene.lights) == 1
    assert scene.environment is not None


def test_a_portrait_takes_other_lights_and_grounds(head):
    even = Environment.constant(1.0)
    scene = head_scene(*head, lights=(), environment=even, background=(1, 2, 3))
    assert scene.lights == ()
    assert scene.environment is even
    assert scene.background.tolist() == [1.0, 2.0, 3.0]


def test_a_model_without_uvs_takes_no_maps(tmp_path):
    (tmp_path / "bare.obj").write_text("v 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\n")
    for request in ({"albedo": "x.png"}, {"normal_map": "x.png"}, {"flip_v": True}):
        with pytest.raises(ArgumentError, match=r"bare\.obj: has no UVs"):
            model(tmp_path / "bare.obj", unit_mm=1.0, **request)
    with pytest.raises(MeshFileError, match=r"gone\.glb"):
        model(tmp_path / "gone.glb")


@pytest.fixture
def served(monkeypatch, tmp_path):
    """A scan of one file, "fetched" from a folder in place of the network."""
    promised = b"what was promised"
    scan = Scan(
        "https://example.invalid/", {"a.glb": hashlib.sha256(promised).hexdigest()}, "x", 1.0
    )
    monkeypatch.setattr(heads, "SCANS", {"test": scan})
    site = tmp_path / "site"
    site.mkdir()
    asked = []

    def from_folder(url, **_):
        def fetch(url, output, pooch_, **_):
            asked.append(url)
            Path(output).write_bytes((site / url.rsplit("/", 1)[-1]).read_bytes())

        return fetch

    monkeypatch.setattr(pooch.core, "choose_downloader", from_folder)
    return site, tmp_path / "kept", promised, asked


def test_a_scan_is_fetched_once(served):
    site, kept, promised, asked = served
    (site / "a.glb").write_bytes(promised)
    paths = fetch_scan("test", kept, "https://mirror.invalid/")
    assert [path.read_bytes() for path in paths] == [promised]
    assert asked == ["https://mirror.invalid/a.glb"]
    assert fetch_scan("test", kept) == paths
    assert len(asked) == 1, "what is there and right is not asked for again"


def test_a_scan_with_another_hash_is_refused_and_not_kept(served):
    site, kept, _, _ = served
    (site / "a.glb").write_bytes(b"something else")
    with pytest.raises(DownloadError, match=r"a\.glb: is not the file that was promised"):
        fetch_scan("test", kept)
    assert list(kept.iterdir()) == []


def test_a_spoilt_copy_is_fetched_again(served):
    site, kept, promised, asked = served
    (site / "a.glb").write_bytes(promised)
    kept.mkdir()
    (kept / "a.glb").write_bytes(b"spoilt")
    assert fetch_scan("test", kept)[0].read_bytes() == promised
    assert len(asked) == 1


def test_a_scan_that_cannot_be_reached_says_from_where(served):
    _, kept, _, _ = served
    with pytest.raises(DownloadError, match=r"https://example\.invalid/a\.glb: cannot be fetched"):
        fetch_scan("test", kept)


def test_a_scan_that_there_is_not_is_named_with_those_that_are():
    with pytest.raises(ArgumentError, match="no scan 'venus'; there are lee-perry-smith"):
        fetch_scan("venus")
    for scan in SCANS.values():
        assert scan.base_url.startswith("https://")
        assert scan.base_url.endswith("/")
        assert all(len(sha) == 64 for sha in scan.sha256.values())
        assert "CC" in scan.credit
