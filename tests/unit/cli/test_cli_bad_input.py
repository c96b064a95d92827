"""Every kind of wrong input, on the command line and in the library."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from cli_runs import Run, contents, run_all, write_inputs

import skinshade as sk
from skinshade._core import errors
from skinshade._core.units import parse_unit_mm
from skinshade.cli.compare import parse_variant
from skinshade.cli.values import parse_numbers, parse_pair, parse_size
from skinshade.heads import fetch_scan, load_head
from skinshade.rendering import RenderSettings, open_renderer, render
from skinshade.rendering.images import check_image_path

KEPT = b"content before the run"
HEAD = ("render", "{in}/bare.obj", "--unit-mm", "1", "-o", "kept.png", "--size", "32x18")
CURVATURE = ("lut", "curvature", "-o", "kept.exr", "--size", "8x8")
SHADOW = ("lut", "shadow", "-o", "kept.exr", "--size", "8x8")


@dataclass(frozen=True)
class Case:
    """Arguments, words of the message, and a call of the library that raises the same error."""

    words: tuple[str, ...]
    message: tuple[str, ...]
    kind: type[errors.SkinshadeError] = errors.ArgumentError
    call: Callable[[Path], Any] | None = None
    code: int = 2


def mesh_case(name: str, kind: type[errors.SkinshadeError], *message: str) -> Case:
    words = ("render", "{in}/" + name, "--unit-mm", "1", "-o", "kept.png", "--size", "32x18")
    return Case(words, (name, *message), kind, lambda at: sk.load_mesh(at / name, unit_mm=1.0))


def scene_case(name: str, *message: str, kind: Any = errors.SceneFileError) -> Case:
    words = ("render", f"{{in}}/{name}.json", "-o", "kept.png", "--size", "32x18")
    expected = (f"{name}.json", *message) if kind is errors.SceneFileError else message
    return Case(words, expected, kind, lambda at: sk.load_scene(at / f"{name}.json"))


def map_case(option: str, name: str, *message: str) -> Case:
    words = ("render", "{in}/ball.obj", "--unit-mm", "1", "-o", "kept.png", option, "{in}/" + name)
    keyword = option.removeprefix("--").replace("-", "_")

    def call(at: Path) -> Any:
        if option == "--env":
            return sk.Environment.load(at / name)
        return load_head(at / "ball.obj", unit_mm=1.0, **{keyword: at / name})

    return Case(words, (name, *message), errors.ImageFileError, call)


def unit_case(text: str) -> Case:
    words = ("render", "{in}/ball.obj", "--unit-mm", text, "-o", "kept.png")
    return Case(words, ("unit", text), errors.UnitError, lambda at: parse_unit_mm(text))


def option_case(option: str, value: str, *message: str, call: Any = None, **more: Any) -> Case:
    return Case((*HEAD, option, value), (option, value, *message), call=call, **more)


def settings_case(field: str, value: Any) -> Case:
    option = "--" + field.replace("_", "-")
    return option_case(option, str(value), call=lambda at: RenderSettings(**{field: value}))


def params_case(field: str, value: float, *message: str) -> Case:
    option = "--" + field.replace("_", "-")
    return option_case(
        option, str(value), *message, call=lambda at: sk.SkinParams(**{field: value})
    )


def lut_case(
    table: tuple[str, ...], option: str, value: str, *message: str, **request: Any
) -> Case:
    build = sk.build_curvature_lut if table is CURVATURE else sk.build_shadow_lut
    call = (lambda at: build(sk.Profile.preset("skin-deon2007"), **request)) if request else None
    return Case((*table, option, value), (option, *message), call=call)


def portrait(at: Path) -> sk.Scene:
    return sk.head_scene(load_head(at / "bare.obj", unit_mm=1.0))


def picture(at: Path, **request: Any) -> np.ndarray:
    return render(portrait(at), **({"size": (4, 4), "samples": 1} | request))


def light(*values: float) -> Callable[[Path], Any]:
    return lambda at: sk.DirectionalLight.from_angles(*values)


MESHES = {
    "missing model": mesh_case("none.glb", errors.MeshFileError, "no such file"),
    "model is a folder": mesh_case("", errors.MeshFileError, "not a file"),
    "model of another kind": mesh_case("notes.txt", errors.MeshFileError, ".glb", ".obj"),
    "truncated GLB": mesh_case("cut.glb", errors.MeshFileError, "bytes"),
    "GLB of noise": mesh_case("noise.glb", errors.MeshFileError, "cannot be read"),
    "NaN position": mesh_case("nan.obj", errors.ArgumentError, "positions[7, 1]", "nan"),
    "infinite position": mesh_case("infinite.obj", errors.ArgumentError, "positions[7, 2]", "inf"),
    "index out of range": mesh_case("beyond.obj", errors.MeshFileError, "99999", "there are"),
    "index 0": mesh_case("zeroth.obj", errors.MeshFileError, "vertex index 0"),
    "no faces": mesh_case("faceless.obj", errors.MeshFileError, "no triangles"),
    "empty file": mesh_case("empty.obj", errors.MeshFileError, "empty"),
    "no area": mesh_case("line.obj", errors.MeshError, "no face has an area"),
    "OBJ without unit": Case(
        ("render", "{in}/ball.obj", "-o", "kept.png"),
        ("ball.obj", "unit_mm"),
        errors.UnitError,
        lambda at: sk.load_mesh(at / "ball.obj"),
    ),
    **{f"unit {text}": unit_case(text) for text in ("wide", "0.0", "-3.0", "nan", "inf", "1e+300")},
}
IMAGES = {
    "corrupt HDR": map_case("--env", "noise.hdr", "not an image"),
    "missing HDR": map_case("--env", "none.hdr", "no such file"),
    "HDR of NaN": map_case("--env", "nan.exr", "NaN"),
    "corrupt colour map": map_case("--albedo", "noise.png"),
    "truncated colour map": map_case("--albedo", "cut.png"),
    "corrupt JPEG": map_case("--albedo", "noise.jpg"),
    "corrupt normal map": map_case("--normal-map", "noise.png"),
    "no tangent-space map": map_case("--normal-map", "objectspace.png", "tangent-space"),
    "map without UVs": Case(
        (*HEAD, "--albedo", "{in}/grey.png"),
        ("bare.obj", "no UVs"),
        call=lambda at: load_head(at / "bare.obj", unit_mm=1.0, albedo=at / "grey.png"),
    ),
}
SCENES = {
    "scene is no JSON": scene_case("broken", "not JSON"),
    "scene is a list": scene_case("list", "object"),
    "scene with a repeated key": scene_case("repeated", "'skinshade' twice"),
    "scene without mesh": scene_case("no-mesh", "mesh: missing"),
    "scene without target": scene_case("no-camera-target", "camera.target: missing"),
    "scene of another version": scene_case("version-is-2", "skinshade", "'2'"),
    "scene with an unknown key": scene_case("unknown-key", "colour: unknown key"),
    "scene's unit is text": scene_case("unit-is-text", "unit_mm", "wide"),
    "scene's unit is zero": scene_case("unit-is-zero", "unit_mm"),
    "scene's camera": scene_case("camera-is-five", "camera: should be an object"),
    "scene's mesh": scene_case(
        "mesh-is-missing", "none.glb", "no such file", kind=errors.MeshFileError
    ),
    "scene's map": scene_case(
        "albedo-is-missing", "none.png", "no such file", kind=errors.ImageFileError
    ),
    "scene's sky": scene_case("sky-is-five", "environment: should be an object"),
    "scene's light": scene_case("light-without-direction", "'front'", "to_light is 0, 0, 0"),
    "camera in two numbers": scene_case("camera-is-flat", "camera.position[2]: missing"),
    "field of view of zero": scene_case("fov-is-zero", "camera.vertical_fov_deg"),
    "negative length": scene_case("length-is-negative", "material.profile.length_mm[1]"),
    "unknown light": Case(
        ("render", "{in}/good.json", "--light", "back", "-o", "kept.png"),
        ("good.json", "'back'", "front, side"),
        errors.SceneFileError,
        lambda at: sk.load_scene(at / "good.json", lights=["back"]),
    ),
    "angles as the name of a light": Case(
        ("render", "{in}/good.json", "--light", "1,2,3", "-o", "kept.png"),
        ("good.json", "'1,2,3'", "front, side"),
        errors.SceneFileError,
        lambda at: sk.load_scene(at / "good.json", lights=["1,2,3"]),
    ),
}
OPTIONS = {
    "size without x": option_case(
        "--size", "64", "1280x720", call=lambda at: parse_size("64", "--size")
    ),
    "size in other digits": option_case("--size", "²x²", call=lambda at: parse_size("²x²")),
    "size of zero": Case(
        (*HEAD, "--size", "0x5"),
        ("size is 0×5", "1..16384"),
        call=lambda at: picture(at, size=(0, 5)),
    ),
    "size too large": Case(
        (*HEAD, "--size", "99999x5"),
        ("size is 99999×5", "1..16384"),
        call=lambda at: picture(at, size=(99999, 5)),
    ),
    "no samples": option_case("--samples", "0", "256", call=lambda at: picture(at, samples=0)),
    "many samples": option_case(
        "--samples", "257", "256", call=lambda at: picture(at, samples=257)
    ),
    "samples in words": Case((*HEAD, "--samples", "few"), ("--samples", "integer")),
    "unknown shading": settings_case("shading", "phong"),
    "unknown tier": settings_case("tier", "fourth"),
    "unknown shadow filter": settings_case("shadow_filter", "box"),
    "unknown antialiasing": settings_case("antialiasing", "none"),
    "odd taps": settings_case("deep_scatter_taps", 7),
    "four fetches": settings_case("normal_fetches", 4),
    "unknown view": settings_case("debug_view", "x-ray"),
    "negative seed": settings_case("seed", -1),
    "unknown comparison": option_case(
        "--compare", "phong", "lambert", call=lambda at: parse_variant("phong", RenderSettings())
    ),
    "light of two numbers": option_case(
        "--light", "1,2", call=lambda at: parse_numbers("1,2", 3, "--light")
    ),
    "light of NaN": option_case(
        "--light", "1,2,nan", call=lambda at: parse_numbers("1,2,nan", 3, "--light")
    ),
    "dark light": Case(
        (*HEAD, "--light", "1,2,-1"), ("irradiance", "-3.14"), call=light(1.0, 2.0, -1.0)
    ),
    "view of three numbers": option_case(
        "--view", "1,2,3", call=lambda at: parse_pair("1,2,3", "--view")
    ),
    "background of two numbers": option_case(
        "--background", "1,2", call=lambda at: parse_numbers("1,2", 3, "--background")
    ),
    "negative background": Case(
        (*HEAD, "--background", "0,-1,0"),
        ("background[1] is -1",),
        call=lambda at: sk.head_scene(portrait(at), background=(0, -1, 0)),
    ),
    "negative environment": Case(
        (*HEAD, "--env-scale", "-1"),
        ("environment scale",),
        call=lambda at: sk.Environment.studio(scale=-0.55),
    ),
    "unknown profile": option_case(
        "--profile", "chalk", "skin-deon2007", call=lambda at: sk.Profile.preset("chalk")
    ),
    "gloss of two": params_case("gloss", 2.0, "[0, 1]"),
    "roughness of two": params_case("roughness", 2.0, "[0, 1]"),
    "roughness of NaN": params_case("roughness", float("nan")),
    "scatter scale of zero": params_case("scatter_scale", 0.0),
    "normal strength of three": params_case("normal_strength", 3.0),
    "negative deep scatter": params_case("deep_scatter_strength", -1.0),
    "negative turntable": option_case("--turntable", "-1"),
    "long turntable": option_case("--turntable", "3601"),
    "exposure of NaN": option_case("--exposure", "nan"),
    "negative exposure": option_case("--exposure", "-1"),
    "unknown tone": option_case("--tone", "sepia"),
    "unknown timings": option_case("--timings", "xml"),
    "unknown option": Case((*HEAD, "--bogus"), ("--bogus",)),
    "unknown backend": option_case(
        "--backend", "abacus", "cpu", call=lambda at: picture(at, backend="abacus")
    ),
    "no such GPU": option_case(
        "--adapter",
        "a voodoo",
        "adapter",
        code=1,
        kind=errors.BackendError,
        call=lambda at: open_renderer(portrait(at), adapter="a voodoo"),
    ),
    "suffix of a picture": Case(
        (*HEAD[:4], "-o", "kept.tiff"),
        ("kept.tiff", ".png", ".exr"),
        call=lambda at: check_image_path("kept.tiff"),
    ),
    "suffix of a comparison": Case(
        (*HEAD[:4], "-o", "kept.exr", "--compare", "lambert"),
        ("kept.exr", ".png"),
        call=lambda at: check_image_path("kept.exr", (".png",)),
    ),
    "no such folder": Case(
        (*HEAD[:4], "-o", "none/x.png"),
        ("none/x.png", "the folder none does not exist"),
        errors.OutputError,
        lambda at: check_image_path("none/x.png"),
    ),
}
TABLES = {
    "suffix of a plot": Case(("profile", "skin1", "-o", "kept.exr"), ("kept.exr", ".png")),
    "profile of another name": Case(
        ("profile", "chalk"),
        ("chalk", "skin-deon2007"),
        call=lambda at: sk.Profile.preset("chalk"),
    ),
    "scale of zero": Case(("profile", "skin1", "--scale", "0"), ("--scale is 0.0", "above 0")),
    "suffix of a table": Case(("lut", "shadow", "-o", "kept.bmp"), ("kept.bmp", ".exr")),
    "folder of a table": Case(("lut", "shadow", "-o", "none/x.exr"), ("none/x.exr",)),
    "kernel of a table": lut_case(CURVATURE, "--kernel", "cube", "cube", kernel="cube"),
    "size of a table": lut_case(CURVATURE, "--size", "1x8", "1×8", size=(1, 8)),
    "radii of a table": lut_case(CURVATURE, "--radius-mm", "5,1", "(5, 1)", radius_mm=(5.0, 1.0)),
    "profile of a table": lut_case(CURVATURE, "--profile", "chalk", "chalk", "skin1"),
    "widths of a table": lut_case(SHADOW, "--width-mm", "8", "'8'"),
    "sharpening of a table": lut_case(SHADOW, "--sharpening", "0.5", "0.5", sharpening=0.5),
    "scale of a table": lut_case(SHADOW, "--diffusion-radius-mm", "0", "0.0", "above 0"),
    "unknown language": Case(
        ("shaders", "export", "--language", "cobol", "-o", "kept"), ("--language", "cobol", "hlsl")
    ),
    "unknown scan": Case(
        ("assets", "get", "venus", "--folder", "."),
        ("venus", "lee-perry-smith"),
        call=lambda at: fetch_scan("venus", at),
    ),
    "bake of no model": Case(("bake", "-o", "kept.png"), ("Missing argument",)),
    "bake into a file": Case(
        ("bake", "{in}/ball.obj", "{in}/bare.obj", "--unit-mm", "1", "-o", "kept.png"),
        ("kept.png", "several models need a folder"),
        errors.OutputError,
    ),
    "bake of a missing model": Case(
        ("bake", "{in}/none.glb", "-o", "kept.glb"), ("none.glb",), errors.MeshFileError
    ),
    "bake of glTF with z up": Case(
        ("bake", "{in}/ball.glb", "--up", "z", "-o", "kept.glb"),
        ("ball.glb", "up is 'z'", "glTF prescribes y"),
        call=lambda at: sk.load_mesh(at / "ball.glb", up="z"),
    ),
    "unknown up axis": Case(
        ("render", "{in}/ball.obj", "--up", "x", "-o", "kept.png"), ("--up", "x")
    ),
    "up axis of the built-in head": Case(
        ("render", "--up", "z", "-o", "kept.png"), ("--up needs a model", "the built-in head")
    ),
    "bake with no rays": Case(
        ("bake", "{in}/ball.glb", "-o", "kept.glb", "--rays", "0"),
        ("rays is 0",),
        call=lambda at: sk.BakeSettings(rays=0),
    ),
}
CASES = MESHES | IMAGES | SCENES | OPTIONS | TABLES


@pytest.fixture(scope="module")
def inputs(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("inputs")
    write_inputs(folder)
    return folder


@pytest.fixture(scope="module")
def runs(tmp_path_factory, inputs) -> dict[str, Run]:
    """Every case, each in its own folder, which has files at the paths of the outputs."""
    folders = [tmp_path_factory.mktemp("case") for _ in CASES]
    for folder in folders:
        for suffix in (".png", ".exr", ".tiff", ".bmp"):
            (folder / f"kept{suffix}").write_bytes(KEPT)
    words = [[word.replace("{in}", str(inputs)) for word in case.words] for case in CASES.values()]
    return dict(zip(CASES, run_all(list(zip(folders, words, strict=True))), strict=True))


def without_dashes(text: str) -> str:
    """Return a text in which options read as the keywords of the library, debug_view for --debug-view."""
    return re.sub(r"(?<![\w.])--", "", text).replace("-", "_")


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_a_wrong_input_has_its_exit_code_and_a_message_that_names_it(runs, name):
    case, run = CASES[name], runs[name]
    assert run.code == case.code, run.err
    err = without_dashes(run.err)
    assert [word for word in case.message if without_dashes(word) not in err] == []
    assert "Traceback" not in run.err
    assert "internal error" not in run.err
    assert "kept" not in run.out


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_a_failed_run_writes_nothing_and_keeps_the_files(runs, name):
    assert runs[name].after == runs[name].before
    assert runs[name].before["kept.png"] == KEPT


def message_of(run: Run) -> str:
    """Return the message of a run; empty if it is an error of the parser, with usage."""
    match = re.search(r"^skinshade: error: (.+)", run.err, re.MULTILINE)
    return match[1] if match else ""


@pytest.mark.slow
def test_an_error_is_one_line(runs):
    own = {name: run.err for name, run in runs.items() if "Usage:" not in run.err}
    assert len(own) > len(CASES) - 16
    assert [name for name, text in own.items() if not message_of(runs[name])] == []
    assert [n for n, text in own.items() if text.count("skinshade: error: ") != 1] == []
    # The libraries that read images add a line or two of their own.
    assert max(text.count("\n") for text in own.values()) <= 3


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name, case in CASES.items() if case.call])
def test_the_library_raises_the_error_that_the_command_line_shows(inputs, runs, name):
    """Every value is checked once, by the library, whose message the program shows."""
    case = CASES[name]
    before = contents(inputs)
    with pytest.raises(case.kind) as caught:
        case.call(inputs)
    assert type(caught.value) is case.kind
    assert caught.value.exit_code == case.code
    assert contents(inputs) == before
    assert message_of(runs[name]) in ("", str(caught.value))
