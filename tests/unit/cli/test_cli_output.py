"""What the commands write when nothing is wrong."""

from __future__ import annotations

import re
import threading
from collections.abc import Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import numpy as np
import pytest
import trimesh
from test_cli_entry import Ran, contents, run, run_each, write_inputs

import shading_tolerances as tol
import skinshade as sk
from skinshade.lut.classic import classic_shadow_lut
from skinshade.scene.images import read_image
from skinshade.shading.tonemap import filmic, srgb_from_linear

SIZE = (64, 36)
BALL = ("--size", "64x36", "--samples", "2", "-o")
SCENE = ("{in}/good.json", "--seed", "3", "--tone", "filmic", *BALL)
MODEL = ("{in}/ball.obj", "--unit-mm", "1", *BALL)
RENDERS = {
    "one": (*SCENE, "one.png"),
    "again": (*SCENE, "again.png"),
    "other seed": (*SCENE, "other.png", "--seed", "4"),
    "linear": (*SCENE, "one.exr"),
    "compared": (*SCENE, "row.png", "--compare", "lambert,classic,transfer+deep"),
    "lambert": (*SCENE, "lambert.png", "--shading", "lambert"),
    "no sss": (*SCENE, "nosss.png", "--no-sss"),
    "turning": (*SCENE, "turn.png", "--turntable", "3"),
    "srgb": (*SCENE, "srgb.png", "--tone", "srgb", "--exposure", "0.5"),
    "backdrop": (*SCENE, "back.exr", "--background", "0.25,0.5,2"),
    "albedo": (*SCENE, "albedo.png", "--debug-view", "albedo"),
    "millimetres": (*MODEL, "mm.exr"),
    "centimetres": ("{in}/small.obj", "--unit-mm", "cm", *BALL, "cm.exr"),
    "mapped": (*MODEL, "mapped.png", "--albedo", "{in}/grey.png", "--debug-view", "albedo"),
    "tiny": ("{in}/tiny.glb", *BALL, "tiny.png"),
}


@pytest.fixture(scope="module")
def pictures(tmp_path_factory) -> tuple[Path, dict[str, Ran]]:
    """Every request above, drawn into one folder."""
    inputs, folder = tmp_path_factory.mktemp("inputs"), tmp_path_factory.mktemp("pictures")
    write_inputs(inputs)
    shrunk = re.sub(
        r"(?m)^v (\S+) (\S+) (\S+)$",
        lambda found: "v " + " ".join(f"{float(x) / 10.0:.12g}" for x in found.groups()),
        (inputs / "ball.obj").read_text("utf-8"),
    )
    (inputs / "small.obj").write_text(shrunk, encoding="utf-8")
    mesh = sk.load_mesh(inputs / "ball.glb")
    tiny = trimesh.Trimesh(mesh.positions / 100.0, mesh.faces, process=False)
    (inputs / "tiny.glb").write_bytes(tiny.export(file_type="glb"))
    words = [["render", *(w.replace("{in}", str(inputs)) for w in ws)] for ws in RENDERS.values()]
    ran = run_each([(folder, each) for each in words])
    return folder, dict(zip(RENDERS, ran, strict=True))


def steps(file: Path) -> np.ndarray:
    return np.rint(read_image(file).astype(float) * 255.0).astype(int)


@pytest.mark.slow
@pytest.mark.parametrize("name", RENDERS)
def test_a_picture_is_announced_in_one_line_and_nothing_else_is_said(pictures, name):
    ran = pictures[1][name]
    assert ran.code == 0, ran.err
    assert re.fullmatch(r"[\w*-]+\.(png|exr): .*\n", ran.out)
    assert ran.err == "" or name == "tiny"
    assert not re.search(r"[\r\x1b━█]", ran.out + ran.err), "no progress where nobody looks"


@pytest.mark.slow
def test_metres_that_make_a_head_of_a_grain_of_sand_are_questioned_and_drawn(pictures):
    assert re.fullmatch(
        r"skinshade: warning: .*tiny\.glb: .*metres.*unit_mm.*\n", pictures[1]["tiny"].err
    )
    assert (pictures[0] / "tiny.png").is_file()


@pytest.mark.slow
def test_the_seed_decides_the_picture_to_the_byte(pictures):
    one, again, other = ((pictures[0] / f"{n}.png").read_bytes() for n in ("one", "again", "other"))
    assert one == again
    assert one != other


@pytest.mark.slow
def test_exr_holds_the_light_that_png_shows(pictures):
    linear = read_image(pictures[0] / "one.exr", 4).astype(float)
    assert linear.shape == (SIZE[1], SIZE[0], 4)
    for name, curve in (("one", filmic(linear)), ("srgb", srgb_from_linear(0.5 * linear))):
        shown = np.rint(np.clip(curve[..., :3], 0.0, 1.0) * 255.0)
        assert np.abs(steps(pictures[0] / f"{name}.png") - shown).max() <= tol.BYTE_STEP.value
    assert linear[0, 0, 3] == 0.0
    assert linear[SIZE[1] // 2, SIZE[0] // 2, 3] == 1.0


@pytest.mark.slow
def test_a_comparison_is_the_pictures_side_by_side(pictures):
    row = steps(pictures[0] / "row.png")
    assert row.shape == (SIZE[1], 3 * SIZE[0], 3)
    above_the_label = slice(0, SIZE[1] // 2)
    left, right = row[above_the_label, : SIZE[0]], row[above_the_label, 2 * SIZE[0] + 1 :]
    assert np.array_equal(left, steps(pictures[0] / "lambert.png")[above_the_label])
    assert np.array_equal(right, steps(pictures[0] / "one.png")[above_the_label, 1:])
    for index in range(3):
        panel = row[-SIZE[1] // 3 :, index * SIZE[0] : (index + 1) * SIZE[0]]
        assert (panel > 220).all(axis=2).any(), "each has its name below"


@pytest.mark.slow
def test_no_sss_is_lambert(pictures):
    plain, lambert = ((pictures[0] / f"{n}.png").read_bytes() for n in ("nosss", "lambert"))
    assert plain == lambert
    assert lambert != (pictures[0] / "one.png").read_bytes()


@pytest.mark.slow
def test_a_turntable_is_numbered_files_that_begin_with_the_picture(pictures):
    frames = sorted(pictures[0].glob("turn-*.png"))
    assert [frame.name for frame in frames] == ["turn-0.png", "turn-1.png", "turn-2.png"]
    assert not (pictures[0] / "turn.png").exists()
    assert frames[0].read_bytes() == (pictures[0] / "one.png").read_bytes()
    assert len({frame.read_bytes() for frame in frames}) == 3


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "linear"),
    [("albedo", (0.48, 0.29, 0.21)), ("mapped", (((128 / 255 + 0.055) / 1.055) ** 2.4,) * 3)],
)
def test_the_albedo_view_shows_the_colour_that_was_asked_for(pictures, name, linear):
    middle = steps(pictures[0] / f"{name}.png")[SIZE[1] // 2, SIZE[0] // 2]
    assert np.abs(middle - np.rint(255.0 * srgb_from_linear(np.array(linear)))).max() <= 1


@pytest.mark.slow
def test_the_unit_is_all_that_a_model_in_another_unit_needs(pictures):
    millimetres, centimetres = (read_image(pictures[0] / f"{n}.exr", 4) for n in ("mm", "cm"))
    assert np.abs(millimetres - centimetres).max() <= tol.OTHER_UNIT.value


@pytest.mark.slow
def test_the_background_is_what_was_asked_for(pictures):
    assert read_image(pictures[0] / "back.exr")[0, 0].tolist() == [0.25, 0.5, 2.0]


@pytest.mark.slow
def test_a_scene_in_json_is_drawn_from_its_own_camera(pictures):
    cover = read_image(pictures[0] / "one.exr", 4)[..., 3]
    # A ball of 80 mm, 700 mm away, seen in 20° over 36 rows.
    radius = 80.0 / np.sqrt(700.0**2 - 80.0**2) / np.tan(np.radians(10.0)) * SIZE[1] / 2.0
    assert cover.sum() == pytest.approx(np.pi * radius**2, rel=tol.COVER.value)


@pytest.mark.parametrize(
    ("words", "build"),
    [
        (("curvature",), sk.build_curvature_lut),
        (("curvature", "--kernel", "ring"), partial(sk.build_curvature_lut, kernel="ring")),
        (
            ("curvature", "--no-energy-gain", "--radius-mm", "2,40"),
            partial(sk.build_curvature_lut, energy_gain=False, radius_mm=(2.0, 40.0)),
        ),
        (("shadow",), sk.build_shadow_lut),
        (
            ("shadow", "--width-mm", "4,50", "--sharpening", "5"),
            partial(sk.build_shadow_lut, width_mm=(4.0, 50.0), sharpening=5.0),
        ),
        (("shadow", "--classic"), classic_shadow_lut),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, tuple) else "",
)
@pytest.mark.slow
def test_a_table_on_disk_is_the_table_of_the_library(tmp_path, words, build):
    suffixes = (".exr", ".png", ".npz")
    extra = ["--size", "16x8", "--diffusion-radius-mm", "5.4", "-o"]
    ran = run_each([(tmp_path, ["lut", *words, *extra, f"table{s}"]) for s in suffixes])
    truth = build(sk.Profile.preset("skin-deon2007").scaled(2.0), size=(16, 8))
    span = truth.value_range[1] - truth.value_range[0]
    for suffix, each in zip(suffixes, ran, strict=True):
        assert (each.code, each.err) == (0, "")
        assert "16×8" in each.out
        loaded = sk.Lut.load(tmp_path / f"table{suffix}")
        error = np.abs(loaded.values.astype(float) - truth.values).max()
        assert error <= (tol.PNG16_STEP.value * span if suffix == ".png" else 0.0)
        assert (loaded.columns, loaded.rows) == (truth.columns, truth.rows)


def test_a_profile_is_shown_and_plotted(tmp_path):
    ran = run(tmp_path, "profile", "marble", "--scale", "2", "-o", "plot.png")
    assert ran.code == 0, ran.err
    marble = sk.Profile.preset("marble")
    for line, values in (("albedo", marble.albedo), ("rms radius", 2.0 * marble.rms_radius_mm)):
        assert line + " " * (12 - len(line)) + "  ".join(f"{v:.4f}" for v in values) in ran.out
    assert list(ran.after) == ["plot.png"]
    ink = (read_image(tmp_path / "plot.png") < 0.9).any(axis=2)
    assert ink.shape[1] > ink.shape[0] > 300
    middle = ink.shape[1] // 2
    assert min(ink[:, :middle].mean(), ink[:, middle:].mean()) > 0.005, "two graphs have lines"


@pytest.fixture
def server(tmp_path, data_dir) -> Iterator[str]:
    """A server that has the scan under /right/, and something else of that name under /wrong/."""
    name = "LeePerrySmith.glb"
    for folder, data in (
        ("right", (data_dir / "lps" / name).read_bytes()),
        ("wrong", b"glTF, but another"),
    ):
        (tmp_path / "site" / folder).mkdir(parents=True)
        (tmp_path / "site" / folder / name).write_bytes(data)

    class Quiet(SimpleHTTPRequestHandler):
        def log_message(self, *_):
            pass

    with ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=tmp_path / "site")) as site:
        thread = threading.Thread(target=site.serve_forever)
        thread.start()
        yield f"http://127.0.0.1:{site.server_port}"
        site.shutdown()
        thread.join()


def test_a_scan_is_fetched_and_another_of_its_name_is_refused(tmp_path, server):
    folder = tmp_path / "kept"
    folder.mkdir()
    fetch = ("assets", "get", "lee-perry-smith", "--folder", str(folder), "--base-url")
    wrong, gone, right = (run(folder, *fetch, f"{server}/{n}/") for n in ("wrong", "gone", "right"))
    assert (wrong.code, gone.code, right.code) == (1, 1, 0)
    assert "not the file that was promised" in wrong.err
    assert wrong.after == {}
    assert "cannot be fetched" in gone.err
    assert f"{server}/gone/LeePerrySmith.glb" in gone.err
    assert gone.after == {}
    assert "Traceback" not in wrong.err + gone.err + right.err
    assert "CC-BY 3.0" in right.out
    assert contents(folder) == contents(tmp_path / "site" / "right")
