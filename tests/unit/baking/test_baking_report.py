"""The report states every result without folders of the machine, and escapes names; and thumbnails."""

from __future__ import annotations

import json
import re
from html.parser import HTMLParser
from urllib.parse import unquote_to_bytes

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import shapes
from skinshade._core.pixels import read_pixels
from skinshade._core.text import printable
from skinshade.baking.analysis import BakedMesh, analyse
from skinshade.baking.jobs import Job, JobResult, failure, plan_jobs, run_job
from skinshade.baking.records import MeshRecord
from skinshade.baking.report import write_page, write_report
from skinshade.baking.settings import BakeSettings
from skinshade.baking.thumbnails import SIZE, thumbnails
from skinshade.mesh import Mesh
from skinshade.profile import Profile

SETTINGS = BakeSettings(unit_mm=1.0, thickness=True, rays=8)
SKIN = Profile.preset("skin-deon2007")
SCRIPT_NAME = "<script>alert(1)<script>.obj"
MEBIBYTE = 1 << 20


def write_sphere(path, radius):
    sphere = shapes.sphere("icosphere", 2, radius)
    lines = [f"v {x} {y} {z}" for x, y, z in sphere.positions]
    lines += [f"f {a} {b} {c}" for a, b, c in sphere.faces + 1]
    path.write_text("\n".join(lines), encoding="utf-8")


@pytest.fixture(scope="module")
def report(tmp_path_factory):
    """The folder, the results and the report of three valid assets and three broken ones."""
    folder = tmp_path_factory.mktemp("assets")
    (folder / "big shelf").mkdir()
    write_sphere(folder / "big shelf" / "ball.obj", 10.0)
    write_sphere(folder / SCRIPT_NAME, 20.0)
    write_sphere(folder / "100% #1?.obj", 20.0)
    (folder / "broken.obj").write_text("f 1 2 3\n")
    for name in ("empty.obj", "void.ply"):
        (folder / name).touch()
    jobs = plan_jobs([folder], folder / "out", SETTINGS, with_thumbnails=True)
    results = [run_job(job) for job in jobs]
    write_page(jobs, results, folder / "out" / "page.html", seconds=4000.0)
    write_report(jobs, results, folder / "out" / "report.json")
    return folder, results, (folder / "out" / "page.html").read_text("utf-8")


class Reader(HTMLParser):
    """Collects tags, links, and text outside of the style and the script."""

    def __init__(self, page):
        super().__init__()
        self.tags, self.links, self.parts = [], [], []
        self.feed(page)
        self.text = " ".join("".join(self.parts).split())

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.links += [value for name, value in attrs if name in ("src", "href", "srcset", "data")]
        assert not any(name.startswith("on") for name, _ in attrs)

    def handle_data(self, data):
        if self.tags[-1:] not in (["style"], ["script"]):
            self.parts.append(data)


# -- content ---------------------------------------------------------------------------------------


def test_the_page_lists_every_asset(report):
    _, results, page = report
    text = Reader(page).text
    assert sorted(result.status for result in results) == ["baked"] * 3 + ["failed"] * 3
    assert "3 baked · 0 current · 3 failed · 1 h 6 min" in text
    assert "big shelf/ball.glb baked" in text
    assert "162 vertices, 320 triangles" in text
    assert "line 1 has the corner '1'; there are 0 vertices" in text


def test_the_links_of_the_page_are_the_thumbnails_below_its_folder(report):
    folder, _, page = report
    links = Reader(page).links
    assert len(links) == 3
    for link in links:
        assert link.startswith(".skinshade/")
        assert re.fullmatch(r"[\w.~/%-]+", link, re.ASCII), "percent-encoded"
        path = folder / "out" / unquote_to_bytes(link).decode()
        pixels, _ = read_pixels(path, ValueError)
        assert pixels.shape == (SIZE, 3 * SIZE, 3)
    assert page.count('loading="lazy"') == 3
    assert "http:" not in page
    assert "https:" not in page


def test_failures_of_one_reason_are_one_group(report):
    _, _, page = report
    text = Reader(page).text
    assert text.count("the file is empty") == 1
    assert "2 × the file is empty empty.obj void.ply" in text


def test_failures_that_differ_in_numbers_and_quoted_text_are_one_group(tmp_path):
    jobs = [job_of(tmp_path, f"{name}.glb") for name in "abc"]
    reasons = ["buffer 0: 5 of 7 bytes", "buffer 12: 1.5e+3 of 9 bytes", "key 'x' is unknown"]
    results = [
        failure(job, f"{job.source}: {reason}") for job, reason in zip(jobs, reasons, strict=True)
    ]
    write_page(jobs, results, tmp_path / "page.html")
    page = (tmp_path / "page.html").read_text("utf-8")
    text = Reader(page).text
    assert "2 × buffer …: … of … bytes" in text
    assert "a.glb: buffer 0: 5 of 7 bytes" in text
    assert "1 × key 'x' is unknown" in text
    assert page.count("<details") == 2


def test_no_file_of_the_library_contains_its_folders(report):
    folder, _, _ = report
    files = [p for p in (folder / "out").rglob("*") if p.suffix in (".json", ".html")]
    assert len(files) == 5
    assert [path.name for path in files if str(folder).encode() in path.read_bytes()] == []
    content = json.loads((folder / "out" / "report.json").read_text("ascii"))
    assert [content[status] for status in ("baked", "current", "failed")] == [3, 0, 3]
    by_source = {asset["source"]: asset for asset in content["assets"]}
    assert by_source["big shelf/ball.obj"]["output"] == "big shelf/ball.glb"
    assert by_source["broken.obj"]["error"].startswith("broken.obj: ")
    (mesh,) = by_source["big shelf/ball.obj"]["meshes"]
    assert mesh["vertices"] == sum(mesh["histograms"]["thickness"]) == 162


def test_errors_name_no_folder_wherever_they_name_a_file(tmp_path):
    job = job_of(tmp_path / "x", "a.glb")
    message = (
        f"{job.source}: buffer 0: {tmp_path}/x/in/b.bin, {job.output}: not in {tmp_path}/x/out"
    )
    write_report([job], [failure(job, message)], tmp_path / "report.json")
    (asset,) = json.loads((tmp_path / "report.json").read_text("ascii"))["assets"]
    assert asset["error"] == "a.glb: buffer 0: b.bin, a.glb: not in out"


# -- names -----------------------------------------------------------------------------------------

TAGS = {
    "html",
    "head",
    "meta",
    "title",
    "style",
    "body",
    "header",
    "main",
    "script",
    "label",
    "input",
}
TAGS |= {
    "output",
    "section",
    "details",
    "summary",
    "article",
    "figure",
    "figcaption",
    "svg",
    "path",
}
TAGS |= {"h1", "h2", "h3", "p", "b", "bdi", "br", "div", "img", "li", "small", "span", "ul"}
ANY_TEXT = st.text(st.characters(), min_size=1)  # includes lone surrogates
NAMES = st.text(st.characters(exclude_characters="/\0."), min_size=1)


def job_of(folder, name):
    sources, outputs = folder / "in", folder / "out"
    record, thumbnail = (outputs / ".skinshade" / f"{name}.{kind}" for kind in ("json", "png"))
    source, output = sources / name, outputs / name
    return Job(source, output, record, thumbnail, SETTINGS, True, sources, outputs)


def mesh_of(name="0", notes=None):
    counts = list(range(48))
    attributes = ("curvature", "thickness")
    return MeshRecord(
        name=name,
        unit_mm=1.0,
        vertices=10**6,
        triangles=2 * 10**6,
        size_mm=[1.0, 2.0, 3.0],
        uv_scale_mm=None,
        ranges={key: [-1.0, 1.0] for key in attributes},
        histograms=dict.fromkeys(attributes, counts),
        notes=notes or {},
    )


def test_markup_in_names_is_text(report):
    _, _, page = report
    reader = Reader(page)
    assert reader.tags.count("script") == 1
    assert SCRIPT_NAME.removesuffix(".obj") in reader.text


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(name=NAMES, text=ANY_TEXT)
@pytest.mark.parametrize("status", ["baked", "failed"])
def test_any_name_note_and_error_is_text_on_the_page(tmp_path, status, name, text):
    job = job_of(tmp_path, name)
    names = str(job.source), str(job.output), status
    if status == "failed":
        result = JobResult(*names, error=f"{job.source}: {text}")
    else:
        mesh = mesh_of(text.encode("utf-8", "backslashreplace").decode()[:200])
        result = JobResult(*names, meshes=[mesh])
    write_page([job], [result], tmp_path / "page.html")
    reader = Reader((tmp_path / "page.html").read_text("utf-8"))
    assert set(reader.tags) <= TAGS
    assert reader.tags.count("script") == 1
    assert " ".join(printable(name).split()) in reader.text
    write_report([job], [result], tmp_path / "report.json")
    (asset,) = json.loads((tmp_path / "report.json").read_text("ascii"))["assets"]
    assert asset["source"] == name


def test_an_error_of_a_million_characters_does_not_fill_the_page(tmp_path):
    job = job_of(tmp_path, "a.glb")
    write_page([job], [failure(job, "x" * 10**6)], tmp_path / "page.html")
    assert (tmp_path / "page.html").stat().st_size < 20_000


# -- size ------------------------------------------------------------------------------------------


def test_the_page_of_1222_assets_takes_less_than_4_mebibytes(tmp_path):
    """With embedded images it took 24 to 66 MB."""
    jobs = [job_of(tmp_path, f"shelf{i % 40:02}/character{i:04}/head.glb") for i in range(1222)]
    notes = {"normals computed": 20_000, "open edges": 700}
    results = [
        JobResult(str(j.source), str(j.output), "baked", meshes=[mesh_of("head", notes)])
        for j in jobs
    ]
    for job in jobs:
        job.thumbnail.parent.mkdir(parents=True, exist_ok=True)
        job.thumbnail.touch()
    write_page(jobs, results, tmp_path / "out" / "page.html")
    page = (tmp_path / "out" / "page.html").read_text("utf-8")
    assert page.count("<img") == 1222
    assert len(page.encode()) < 4 * MEBIBYTE


def test_the_page_describes_the_first_meshes_of_an_asset_with_thousands(tmp_path):
    job = job_of(tmp_path, "a.glb")
    meshes = [mesh_of(str(index)) for index in range(5000)]
    result = JobResult(str(job.source), str(job.output), "baked", meshes=meshes)
    write_page([job], [result], tmp_path / "page.html")
    page = (tmp_path / "page.html").read_text("utf-8")
    assert "and 4,976 more meshes" in page
    assert page.count("vertices") == 24


# -- thumbnails ------------------------------------------------------------------------------------


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
