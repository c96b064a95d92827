"""The HTML report is one file that agrees with the results and escapes names; and thumbnails."""

from __future__ import annotations

import base64
import re
from html.parser import HTMLParser

import numpy as np
import pytest

import shapes
from skinshade._core.pixels import read_pixels
from skinshade.baking.analysis import BakedMesh, analyse
from skinshade.baking.jobs import plan_jobs, run_job
from skinshade.baking.report import write_page
from skinshade.baking.settings import BakeSettings
from skinshade.baking.thumbnails import SIZE, thumbnails
from skinshade.mesh import Mesh
from skinshade.profile import Profile

SETTINGS = BakeSettings(unit_mm=1.0, thickness=True, rays=8)
SKIN = Profile.preset("skin-deon2007")
SCRIPT_NAME = "<script>alert(1)<script>.obj"


def write_sphere(path, radius):
    sphere = shapes.sphere("icosphere", 2, radius)
    lines = [f"v {x} {y} {z}" for x, y, z in sphere.positions]
    lines += [f"f {a} {b} {c}" for a, b, c in sphere.faces + 1]
    path.write_text("\n".join(lines), encoding="utf-8")


@pytest.fixture(scope="module")
def report(tmp_path_factory):
    """The results and the report of two valid assets and a broken one."""
    folder = tmp_path_factory.mktemp("assets")
    write_sphere(folder / "ball.obj", 10.0)
    write_sphere(folder / SCRIPT_NAME, 20.0)
    (folder / "broken.obj").write_text("f 1 2 3\n")
    jobs = plan_jobs([folder], folder / "out", SETTINGS, with_thumbnails=True)
    results = [run_job(job) for job in jobs]
    write_page(jobs, results, folder / "out" / "page.html")
    return results, (folder / "out" / "page.html").read_text("utf-8")


class Reader(HTMLParser):
    """Collects tags, links and text."""

    def __init__(self):
        super().__init__()
        self.tags, self.links, self.text = [], [], []

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.links += [value for name, value in attrs if name in ("src", "href")]

    def handle_data(self, data):
        self.text.append(data)


def test_the_report_lists_every_asset_and_needs_no_other_file(report):
    results, page = report
    reader = Reader()
    reader.feed(page)
    text = " ".join(reader.text)
    assert sorted(result.status for result in results) == ["baked", "baked", "failed"]
    assert "2 baked, 0 current, 1 failed" in text
    assert "ball.glb" in text
    assert "162 vertices, 320 triangles" in text
    assert all(link.startswith("data:image/png;base64,") for link in reader.links)
    assert len(reader.links) == 2


def test_markup_in_the_name_of_an_asset_is_escaped(report):
    _, page = report
    reader = Reader()
    reader.feed(page)
    assert "script" not in reader.tags
    assert SCRIPT_NAME.removesuffix(".obj") in " ".join(reader.text)


def test_the_report_embeds_the_thumbnails(report, tmp_path):
    _, page = report
    data = re.search(r"base64,([^\"]+)", page).group(1)
    (tmp_path / "a.png").write_bytes(base64.b64decode(data))
    pixels, _ = read_pixels(tmp_path / "a.png", ValueError)
    assert pixels.shape == (SIZE, 3 * SIZE, 3)


def thumbnails_of(shape):
    """Return the thumbnails of curvature, thickness and shading of a shape in mm."""
    mesh = Mesh.checked(shape.positions, shape.faces, unit_mm=1.0, normals=shape.normals)
    baked = BakedMesh("shape", mesh, analyse(mesh, SETTINGS, "shape"))
    strip = thumbnails([baked], SKIN)
    return [strip[:, index * SIZE : (index + 1) * SIZE] for index in range(3)]


def test_thumbnails_of_a_sphere_are_red_where_convex_bright_where_thick_and_lit_from_upper_left():
    curvature, thickness, shaded = thumbnails_of(shapes.sphere("icosphere", 4, 12.0))
    middle = SIZE // 2
    red, green, blue = curvature[middle, middle]
    assert red > 1.5 * green > 1.5 * blue
    # The thickness of a sphere is 1.5 times its radius; white is 30 mm.
    assert thickness[middle, middle] == pytest.approx([18.0 / 30.0] * 3, abs=0.02)
    upper_left, lower_right = shaded[middle - 30, middle - 30], shaded[middle + 30, middle + 30]
    assert upper_left.sum() > 1.5 * lower_right.sum()
    assert np.ptp(curvature[0, 0]) == 0.0, "the background is grey"


def test_a_current_asset_without_its_thumbnail_is_baked_again(tmp_path):
    write_sphere(tmp_path / "one.obj", 10.0)
    (bare,) = plan_jobs([tmp_path / "one.obj"], tmp_path / "out", SETTINGS)
    assert run_job(bare).status == "baked"
    (job,) = plan_jobs([tmp_path / "one.obj"], tmp_path / "out", SETTINGS, with_thumbnails=True)
    assert run_job(job).status == "baked", "the thumbnail is missing"
    assert run_job(job).status == "current"
    assert job.thumbnail.is_file()
