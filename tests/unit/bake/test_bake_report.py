"""The page about a run: whole in one file, true to the results, safe whatever assets are called."""

from __future__ import annotations

import base64
import re
from html.parser import HTMLParser

import numpy as np
import pytest

import shapes
from skinshade._core.pixels import read_pixels
from skinshade.bake.analysis import Body, analyse
from skinshade.bake.gltf_bake import BakedMesh
from skinshade.bake.jobs import plan, run
from skinshade.bake.report import write_page
from skinshade.bake.settings import BakeSettings
from skinshade.bake.thumbnails import SIZE, thumbnails
from skinshade.profile import Profile

SETTINGS = BakeSettings(unit_mm=1.0, thickness=True, rays=8)
SKIN = Profile.preset("skin-deon2007")
EVIL = "<script>alert(1)<script>.obj"


def write_ball(path, radius):
    ball = shapes.sphere("icosphere", 2, radius)
    lines = [f"v {x} {y} {z}" for x, y, z in ball.positions]
    lines += [f"f {a} {b} {c}" for a, b, c in ball.faces + 1]
    path.write_text("\n".join(lines), encoding="utf-8")


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    folder = tmp_path_factory.mktemp("assets")
    write_ball(folder / "ball.obj", 10.0)
    write_ball(folder / EVIL, 20.0)
    (folder / "broken.obj").write_text("f 1 2 3\n")
    jobs = plan([folder], folder / "out", SETTINGS, pictured=True)
    results = [run(job) for job in jobs]
    write_page(jobs, results, folder / "out" / "page.html")
    return results, (folder / "out" / "page.html").read_text("utf-8")


class Reader(HTMLParser):
    def __init__(self):
        super().__init__()
        self.tags, self.links, self.text = [], [], []

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.links += [value for name, value in attrs if name in ("src", "href")]

    def handle_data(self, data):
        self.text.append(data)


def test_it_tells_of_every_asset_and_needs_no_other_file(page):
    results, text = page
    reader = Reader()
    reader.feed(text)
    told = " ".join(reader.text)
    assert sorted(each.status for each in results) == ["baked", "baked", "failed"]
    assert "2 baked, 0 current, 1 failed" in told
    assert "ball.glb" in told
    assert "162 vertices, 320 triangles" in told
    assert all(link.startswith("data:image/png;base64,") for link in reader.links)
    assert len(reader.links) == 2


def test_what_assets_are_called_is_text(page):
    _, text = page
    reader = Reader()
    reader.feed(text)
    assert "script" not in reader.tags
    assert EVIL.removesuffix(".obj") in " ".join(reader.text)


def test_its_pictures_are_pictures(page, tmp_path):
    _, text = page
    data = re.search(r"base64,([^\"]+)", text).group(1)
    (tmp_path / "a.png").write_bytes(base64.b64decode(data))
    pixels, _ = read_pixels(tmp_path / "a.png", ValueError)
    assert pixels.shape == (SIZE, 3 * SIZE, 3)


def pictured(shape):
    body = Body(shape.positions, shape.faces, shape.normals, None)
    mesh = BakedMesh("it", 1.0, body, analyse(body, SETTINGS, "it"))
    picture = thumbnails([mesh], SKIN)
    return [picture[:, at * SIZE : (at + 1) * SIZE] for at in range(3)]


def test_a_ball_is_red_where_it_bulges_bright_where_thick_and_lit_from_the_upper_left():
    curvature, thickness, shaded = pictured(shapes.sphere("icosphere", 4, 12.0))
    middle = SIZE // 2
    red, green, blue = curvature[middle, middle]
    assert red > 1.5 * green > 1.5 * blue
    # 1.5 r of the 30 mm that are white
    assert thickness[middle, middle] == pytest.approx([18.0 / 30.0] * 3, abs=0.02)
    up_left, down_right = shaded[middle - 30, middle - 30], shaded[middle + 30, middle + 30]
    assert up_left.sum() > 1.5 * down_right.sum()
    assert np.ptp(curvature[0, 0]) == 0.0, "paper behind it"


def test_a_second_run_is_current_and_has_its_picture(page, tmp_path):
    write_ball(tmp_path / "one.obj", 10.0)
    bare = plan([tmp_path / "one.obj"], tmp_path / "out", SETTINGS)
    assert run(bare[0]).status == "baked"
    pictured_job = plan([tmp_path / "one.obj"], tmp_path / "out", SETTINGS, pictured=True)[0]
    assert run(pictured_job).status == "baked", "its picture is missing"
    assert run(pictured_job).status == "current"
    assert pictured_job.picture.is_file()
