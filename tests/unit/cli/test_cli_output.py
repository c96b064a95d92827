"""Files and messages of runs without errors."""

from __future__ import annotations

import json
import re
import threading
from collections.abc import Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import numpy as np
import pytest
import trimesh
from cli_runs import Run, contents, run, run_all, write_inputs

import shading_tolerances as tol
import skinshade as sk
from skinshade.lut.classic import classic_shadow_lut
from skinshade.params.gloss import gloss_from_roughness
from skinshade.scene.images import read_image
from skinshade.sdk import export_shaders
from skinshade.shading.tonemap import filmic, srgb_from_linear

SIZE = (64, 36)
PICTURE = ("--size", "64x36", "--samples", "2", "-o")
SCENE = ("{in}/good.json", "--seed", "3", "--tone", "filmic", *PICTURE)
MODEL = ("{in}/ball.obj", "--unit-mm", "1", *PICTURE)
GLOSS = str(float(gloss_from_roughness(0.3)))
RENDERS = {
    "one": (*SCENE, "one.png"),
    "again": (*SCENE, "again.png"),
    "other seed": (*SCENE, "other.png", "--seed", "4"),
    "linear": (*SCENE, "one.exr"),
    "compared": (*SCENE, "row.png", "--compare", "lambert,classic,transfer+deep"),
    "lambert": (*SCENE, "lambert.png", "--shading", "lambert"),
    "no sss": (*SCENE, "nosss.png", "--no-sss"),
    "turntable": (*SCENE, "turn.png", "--turntable", "3"),
    "srgb": (*SCENE, "srgb.png", "--tone", "srgb", "--exposure", "0.5"),
    "background": (*SCENE, "back.exr", "--background", "0.25,0.5,2"),
    "albedo": (*SCENE, "albedo.png", "--debug-view", "albedo"),
    "rough": (*SCENE, "rough.png", "--roughness", "0.3"),
    "glossy": (*SCENE, "glossy.png", "--gloss", GLOSS),
    "front": (*SCENE, "front.png", "--light", "front"),
    "side": (*SCENE, "side.exr", "--light", "side"),
    "both lights": (*SCENE, "both.exr", "--light", "side", "--light", "front"),
    "millimetres": (*MODEL, "mm.exr"),
    "centimetres": ("{in}/small.obj", "--unit-mm", "cm", *PICTURE, "cm.exr"),
    "mapped": (*MODEL, "mapped.png", "--albedo", "{in}/grey.png", "--debug-view", "albedo"),
    "tiny": ("{in}/tiny.glb", *PICTURE, "tiny.png"),
}


# -- render ----------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def pictures(tmp_path_factory) -> tuple[Path, dict[str, Run]]:
    """The folder of all pictures of RENDERS, and their runs."""
    inputs, folder = tmp_path_factory.mktemp("inputs"), tmp_path_factory.mktemp("pictures")
    write_inputs(inputs)
    shrunk = re.sub(
        r"(?m)^v (\S+) (\S+) (\S+)$",
        lambda match: "v " + " ".join(f"{float(x) / 10.0:.12g}" for x in match.groups()),
        (inputs / "ball.obj").read_text("utf-8"),
    )
    (inputs / "small.obj").write_text(shrunk, encoding="utf-8")
    mesh = sk.load_mesh(inputs / "ball.glb")
    tiny = trimesh.Trimesh(mesh.positions / 100.0, mesh.faces, process=False)
    (inputs / "tiny.glb").write_bytes(tiny.export(file_type="glb"))
    requests = [
        ["render", *(word.replace("{in}", str(inputs)) for word in words)]
        for words in RENDERS.values()
    ]
    runs = run_all([(folder, words) for words in requests])
    return folder, dict(zip(RENDERS, runs, strict=True))


def levels(file: Path) -> np.ndarray:
    """Return the values 0..255 of a picture."""
    return np.rint(read_image(file).astype(float) * 255.0).astype(int)


@pytest.mark.slow
@pytest.mark.parametrize("name", RENDERS)
def test_a_render_prints_one_line_and_no_progress_into_a_pipe(pictures, name):
    outcome = pictures[1][name]
    assert outcome.code == 0, outcome.err
    assert re.fullmatch(r"[\w*-]+\.(png|exr): .*\n", outcome.out)
    assert outcome.err == "" or name == "tiny"
    assert not re.search(r"[\r\x1b━█]", outcome.out + outcome.err)


@pytest.mark.slow
def test_an_implausible_size_in_metres_is_a_warning_and_is_drawn(pictures):
    assert re.fullmatch(
        r"skinshade: warning: .*tiny\.glb: .*metres.*unit_mm.*\n", pictures[1]["tiny"].err
    )
    assert (pictures[0] / "tiny.png").is_file()


@pytest.mark.slow
def test_equal_seeds_give_the_same_bytes_and_other_seeds_do_not(pictures):
    one, again, other = ((pictures[0] / f"{n}.png").read_bytes() for n in ("one", "again", "other"))
    assert one == again
    assert one != other


@pytest.mark.slow
def test_exr_holds_the_linear_light_of_the_png(pictures):
    linear = read_image(pictures[0] / "one.exr", 4).astype(float)
    assert linear.shape == (SIZE[1], SIZE[0], 4)
    for name, curve in (("one", filmic(linear)), ("srgb", srgb_from_linear(0.5 * linear))):
        truth = np.rint(np.clip(curve[..., :3], 0.0, 1.0) * 255.0)
        assert np.abs(levels(pictures[0] / f"{name}.png") - truth).max() <= tol.BYTE_STEP.value
    assert linear[0, 0, 3] == 0.0
    assert linear[SIZE[1] // 2, SIZE[0] // 2, 3] == 1.0


@pytest.mark.slow
def test_a_comparison_is_its_pictures_side_by_side_with_labels(pictures):
    row = levels(pictures[0] / "row.png")
    assert row.shape == (SIZE[1], 3 * SIZE[0], 3)
    above_the_label = slice(0, SIZE[1] // 2)
    left, right = row[above_the_label, : SIZE[0]], row[above_the_label, 2 * SIZE[0] + 1 :]
    assert np.array_equal(left, levels(pictures[0] / "lambert.png")[above_the_label])
    assert np.array_equal(right, levels(pictures[0] / "one.png")[above_the_label, 1:])
    for index in range(3):
        panel = row[-SIZE[1] // 3 :, index * SIZE[0] : (index + 1) * SIZE[0]]
        assert (panel > 220).all(axis=2).any(), "every picture has a label below"


@pytest.mark.slow
def test_no_sss_is_lambert(pictures):
    plain, lambert = ((pictures[0] / f"{n}.png").read_bytes() for n in ("nosss", "lambert"))
    assert plain == lambert
    assert lambert != (pictures[0] / "one.png").read_bytes()


@pytest.mark.slow
def test_a_turntable_is_numbered_files_of_which_the_first_is_the_picture(pictures):
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
def test_the_albedo_view_shows_the_albedo(pictures, name, linear):
    middle = levels(pictures[0] / f"{name}.png")[SIZE[1] // 2, SIZE[0] // 2]
    truth = np.rint(255.0 * srgb_from_linear(np.array(linear)))
    assert np.abs(middle - truth).max() <= tol.BYTE_STEP.value


@pytest.mark.slow
def test_roughness_gives_the_picture_of_the_equivalent_gloss(pictures):
    rough, glossy = ((pictures[0] / f"{n}.png").read_bytes() for n in ("rough", "glossy"))
    assert rough == glossy
    assert rough != (pictures[0] / "one.png").read_bytes()


@pytest.mark.slow
def test_lights_of_a_scene_file_are_chosen_by_name(pictures):
    front, one = ((pictures[0] / f"{n}.png").read_bytes() for n in ("front", "one"))
    assert front == one, "the file enables the front light only"
    light = {n: read_image(pictures[0] / f"{n}.exr").astype(float) for n in ("one", "side", "both")}
    body = read_image(pictures[0] / "one.exr", 4)[..., 3] == 1.0
    left, right = (body & (np.arange(SIZE[0]) // (SIZE[0] // 2) == half) for half in (0, 1))
    assert light["side"][right].sum() > 3.0 * light["side"][left].sum(), "it comes from +x"
    total = light["one"] + light["side"]
    assert np.allclose(light["both"][body], total[body], rtol=1e-5, atol=1e-6)


@pytest.mark.slow
def test_a_model_in_another_unit_gives_the_same_picture(pictures):
    millimetres, centimetres = (read_image(pictures[0] / f"{n}.exr", 4) for n in ("mm", "cm"))
    assert np.abs(millimetres - centimetres).max() <= tol.OTHER_UNIT.value


@pytest.mark.slow
def test_the_background_has_the_given_radiance(pictures):
    assert read_image(pictures[0] / "back.exr")[0, 0].tolist() == [0.25, 0.5, 2.0]


@pytest.mark.slow
def test_a_scene_file_is_drawn_from_its_own_camera(pictures):
    cover = read_image(pictures[0] / "one.exr", 4)[..., 3]
    # A ball of radius 80 mm at 700 mm, in a field of view of 20° over 36 rows.
    radius = 80.0 / np.sqrt(700.0**2 - 80.0**2) / np.tan(np.radians(10.0)) * SIZE[1] / 2.0
    assert cover.sum() == pytest.approx(np.pi * radius**2, rel=tol.COVER.value)


# -- lut, profile, shaders, bake -------------------------------------------------------------------


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
def test_a_table_in_a_file_is_the_table_of_the_library(tmp_path, words, build):
    suffixes = (".exr", ".png", ".npz")
    options = ["--size", "16x8", "--diffusion-radius-mm", "5.4", "-o"]
    runs = run_all([(tmp_path, ["lut", *words, *options, f"table{s}"]) for s in suffixes])
    truth = build(sk.Profile.preset("skin-deon2007").scaled(2.0), size=(16, 8))
    span = truth.value_range[1] - truth.value_range[0]
    for suffix, outcome in zip(suffixes, runs, strict=True):
        assert (outcome.code, outcome.err) == (0, "")
        assert "16×8" in outcome.out
        loaded = sk.Lut.load(tmp_path / f"table{suffix}")
        error = np.abs(loaded.values.astype(float) - truth.values).max()
        assert error <= (tol.PNG16_STEP.value * span if suffix == ".png" else 0.0)
        assert (loaded.columns, loaded.rows) == (truth.columns, truth.rows)


def test_a_profile_is_printed_and_plotted(tmp_path):
    outcome = run(tmp_path, "profile", "marble", "--scale", "2", "-o", "plot.png")
    assert outcome.code == 0, outcome.err
    marble = sk.Profile.preset("marble")
    for line, values in (("albedo", marble.albedo), ("rms radius", 2.0 * marble.rms_radius_mm)):
        assert f"{line:<12}" + "  ".join(f"{v:.4f}" for v in values) in outcome.out
    assert list(outcome.after) == ["plot.png"]
    ink = (read_image(tmp_path / "plot.png") < 0.9).any(axis=2)
    assert ink.shape[1] > ink.shape[0] > 300
    middle = ink.shape[1] // 2
    assert min(ink[:, :middle].mean(), ink[:, middle:].mean()) > 0.005, "both graphs have curves"


@pytest.mark.slow
def test_an_exported_shader_package_is_that_of_the_library(tmp_path):
    (tmp_path / "run").mkdir()
    words = ["--language", "hlsl", "-o", "package", "--scatter-scale", "2"]
    outcome = run(tmp_path / "run", "shaders", "export", *words)
    assert (outcome.code, outcome.err) == (0, "")
    profile, params = sk.Profile.preset("skin-deon2007"), sk.SkinParams(scatter_scale=2.0)
    paths = export_shaders("hlsl", tmp_path / "truth", profile=profile, params=params)
    assert outcome.out.startswith(f"package: {len(paths)} files for ")
    package, truth = contents(tmp_path / "run" / "package"), contents(tmp_path / "truth")
    assert list(package) == list(truth)
    for name, content in truth.items():
        if name.endswith(".exr"):  # its header holds the time of writing
            pixels = [
                read_image(at / name) for at in (tmp_path / "run/package", tmp_path / "truth")
            ]
            assert np.array_equal(*pixels)
        else:
            assert package[name] == content


@pytest.mark.slow
def test_bake_prints_the_range_of_curvature_of_a_model(tmp_path):
    write_inputs(tmp_path)
    outcome = run(tmp_path, "bake", "ball.glb", "-o", "baked.glb")
    assert (outcome.code, outcome.err) == (0, "")
    assert outcome.out.startswith("baked.glb: mesh ")
    assert "one unit is 1000 mm, curvature 0.01" in outcome.out
    baked = sk.load_mesh(tmp_path / "baked.glb").attributes["curvature"]
    assert np.allclose(baked, 1.0 / 80.0, rtol=0.05)


@pytest.mark.slow
@pytest.mark.parametrize(
    "words",
    [
        ("bake", "ball.glb", "-o", "baked.glb"),
        ("bake", "ball.glb", "-o", "folder"),
        ("render", "ball.glb", "-o", "ball.png", "--size", "16x9", "--samples", "1"),
    ],
    ids=["bake", "bake to a folder", "render"],
)
def test_a_unit_that_makes_a_model_implausibly_large_warns_in_one_line(tmp_path, words):
    write_inputs(tmp_path)
    outcome = run(tmp_path, *words, "--unit-mm", "100000")
    assert outcome.code == 0
    (line,) = outcome.err.splitlines()
    assert re.match(r"skinshade: warning: \S*ball\.glb: with the given unit of 100000 mm, ", line)


@pytest.mark.slow
def test_bake_of_several_models_reports_those_that_failed(tmp_path):
    write_inputs(tmp_path)
    words = ("bake", "ball.glb", "cut.glb", "-o", "baked", "--report")
    outcome = run(tmp_path, *words)
    assert outcome.code == 2
    failed, *_, summary = outcome.err.splitlines()
    assert re.fullmatch(r".*cut\.glb: failed: .*", failed)
    assert summary == "skinshade: error: 1 of 2 models failed"
    assert "Traceback" not in outcome.err
    report = json.loads((tmp_path / "baked" / "skinshade-bake.json").read_text("utf-8"))
    assert "cut.glb" in json.dumps(report)
    assert (tmp_path / "baked" / "ball.glb").is_file()
    assert (tmp_path / "baked" / "skinshade-bake.html").is_file()


# -- assets ----------------------------------------------------------------------------------------


@pytest.fixture
def server(tmp_path, data_dir) -> Iterator[str]:
    """Address of a server with the scan below /right/, and another file of its name below /wrong/."""
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


def test_a_scan_is_fetched_and_a_file_with_another_hash_is_refused(tmp_path, server):
    folder = tmp_path / "cache"
    folder.mkdir()
    fetch = ("assets", "get", "lee-perry-smith", "--folder", str(folder), "--base-url")
    wrong, none, right = (run(folder, *fetch, f"{server}/{n}/") for n in ("wrong", "none", "right"))
    assert (wrong.code, none.code, right.code) == (1, 1, 0)
    assert "the file has another hash than expected" in wrong.err
    assert wrong.after == {}
    assert "cannot be fetched" in none.err
    assert f"{server}/none/LeePerrySmith.glb" in none.err
    assert none.after == {}
    assert "Traceback" not in wrong.err + none.err + right.err
    assert "CC-BY 3.0" in right.out
    assert contents(folder) == contents(tmp_path / "site" / "right")
