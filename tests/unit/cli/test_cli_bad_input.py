"""Every kind of bad input: at the command line, and the same at the API."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from test_cli_entry import Ran, contents, run_each, write_inputs

import skinshade as sk
from skinshade._core import errors
from skinshade._core.units import parse_unit_mm
from skinshade.cli.compare import parse_variant
from skinshade.cli.parse import numbers, size
from skinshade.params import SkinParams
from skinshade.render import RenderSettings, render
from skinshade.render.renderer import open_renderer
from skinshade.scene.heads import fetch_scan, model

KEPT = b"what was there before"
HEAD = ("render", "{in}/bare.obj", "--unit-mm", "1", "-o", "kept.png", "--size", "32x18")
CURVATURE = ("lut", "curvature", "-o", "kept.exr", "--size", "8x8")
SHADOW = ("lut", "shadow", "-o", "kept.exr", "--size", "8x8")


@dataclass(frozen=True)
class Case:
    """Words for the command line, what the message must hold, and the same at the API."""

    words: tuple[str, ...]
    said: tuple[str, ...]
    kind: type[errors.SkinshadeError] = errors.ArgumentError
    call: Callable[[Path], Any] | None = None
    code: int = 2


def of_mesh(name: str, kind: type[errors.SkinshadeError], *said: str) -> Case:
    words = ("render", "{in}/" + name, "--unit-mm", "1", "-o", "kept.png", "--size", "32x18")
    return Case(words, (name, *said), kind, lambda at: sk.load_mesh(at / name, unit_mm=1.0))


def of_scene(name: str, kind: type[errors.SkinshadeError], *said: str) -> Case:
    words = ("render", f"{{in}}/{name}.json", "-o", "kept.png", "--size", "32x18")
    return Case(words, said, kind, lambda at: sk.load_scene(at / f"{name}.json"))


def of_map(option: str, name: str, *said: str, kind: Any = errors.ImageFileError) -> Case:
    words = ("render", "{in}/ball.obj", "--unit-mm", "1", "-o", "kept.png", option, "{in}/" + name)
    keyword = option.removeprefix("--").replace("-", "_")
    if option == "--env":
        return Case(words, (name, *said), kind, lambda at: sk.Environment.load(at / name))
    return Case(
        words,
        (name, *said),
        kind,
        lambda at: model(at / "ball.obj", unit_mm=1.0, **{keyword: at / name}),
    )


def of_unit(text: str) -> Case:
    words = ("render", "{in}/ball.obj", "--unit-mm", text, "-o", "kept.png")
    return Case(words, ("unit", text), errors.UnitError, lambda at: parse_unit_mm(text))


def of_render(option: str, value: str, *said: str, call: Any = None, **more: Any) -> Case:
    return Case((*HEAD, option, value), (option, value, *said), call=call, **more)


def of_settings(field: str, value: Any) -> Case:
    option = "--" + field.replace("_", "-")
    return of_render(option, str(value), call=lambda at: RenderSettings(**{field: value}))


def of_lut(table: tuple[str, ...], option: str, value: str, *said: str, **request: Any) -> Case:
    build = sk.build_curvature_lut if table is CURVATURE else sk.build_shadow_lut
    call = (lambda at: build(sk.Profile.preset("skin-deon2007"), **request)) if request else None
    return Case((*table, option, value), (option, *said), call=call)


def drawn(at: Path, **request: Any) -> np.ndarray:
    scene = sk.head_scene(*model(at / "bare.obj", unit_mm=1.0))
    return render(scene, **({"size": (4, 4), "samples": 1} | request))


CASES = {
    "missing model": of_mesh("none.glb", errors.MeshFileError, "no such file"),
    "model is a folder": of_mesh("", errors.MeshFileError, "not a file"),
    "model of another kind": of_mesh("notes.txt", errors.MeshFileError, ".glb", ".obj"),
    "GLB cut short": of_mesh("cut.glb", errors.MeshFileError, "cannot be read"),
    "GLB of noise": of_mesh("noise.glb", errors.MeshFileError, "cannot be read"),
    "NaN position": of_mesh("nan.obj", errors.ArgumentError, "positions[7, 1]", "nan"),
    "infinite position": of_mesh("infinite.obj", errors.ArgumentError, "positions[7, 2]", "inf"),
    "index out of range": of_mesh("beyond.obj", errors.MeshFileError, "out of bounds"),
    "no faces": of_mesh("faceless.obj", errors.MeshFileError, "no triangles"),
    "empty file": of_mesh("empty.obj", errors.MeshFileError, "empty"),
    "no area": of_mesh("line.obj", errors.MeshError, "no face has an area"),
    "OBJ without unit": Case(
        ("render", "{in}/ball.obj", "-o", "kept.png"),
        ("ball.obj", "unit_mm"),
        errors.UnitError,
        lambda at: sk.load_mesh(at / "ball.obj"),
    ),
    **{f"unit {text}": of_unit(text) for text in ("wide", "0.0", "-3.0", "nan", "inf")},
    "corrupt HDR": of_map("--env", "noise.hdr", "not an image"),
    "missing HDR": of_map("--env", "none.hdr", "no such file"),
    "HDR of NaN": of_map("--env", "nan.exr", "NaN"),
    "corrupt colour map": of_map("--albedo", "noise.png"),
    "colour map cut short": of_map("--albedo", "cut.png"),
    "corrupt JPEG": of_map("--albedo", "noise.jpg"),
    "corrupt normal map": of_map("--normal-map", "noise.png"),
    "no tangent-space map": of_map("--normal-map", "objectspace.png", "tangent-space"),
    "map without UVs": Case(
        (*HEAD, "--albedo", "{in}/grey.png"),
        ("bare.obj", "no UVs"),
        call=lambda at: model(at / "bare.obj", unit_mm=1.0, albedo=at / "grey.png"),
    ),
    "scene is no JSON": of_scene("broken", errors.SceneFileError, "broken.json", "not JSON"),
    "scene is a list": of_scene("list", errors.SceneFileError, "list.json", "object"),
    "scene without mesh": of_scene("no-mesh", errors.SceneFileError, "no-mesh.json", "'mesh'"),
    "scene without angle": of_scene("no-vfov", errors.SceneFileError, "no-vfov.json", "'vfov_deg'"),
    "scene's unit is text": of_scene(
        "unit-is-text", errors.SceneFileError, "unit-is-text.json", "wide"
    ),
    "scene's unit is zero": of_scene("unit-is-zero", errors.InputError, "unit_mm is 0"),
    "scene's camera": of_scene("camera-is-five", errors.SceneFileError, "camera-is-five.json"),
    "scene's mesh": of_scene("mesh-is-gone", errors.MeshFileError, "gone.glb", "no such file"),
    "scene's sky": of_scene("sky-is-five", errors.SceneFileError, "sky-is-five.json"),
    "scene's map": of_scene("colour-is-gone", errors.ImageFileError, "gone.png", "no such file"),
    "scene's sun": of_scene("sun-is-a-list", errors.SceneFileError, "sun-is-a-list.json"),
    "camera in two numbers": of_scene(
        "camera-is-flat", errors.SceneFileError, "camera-is-flat.json"
    ),
    "angle of zero": of_scene("fov-is-zero", errors.SceneFileError, "fov-is-zero.json", "[1, 150]"),
    "negative radius": of_scene(
        "radius-is-negative", errors.SceneFileError, "radius-is-negative.json", "positive"
    ),
    "unknown sun": Case(
        ("render", "{in}/good.json", "--light", "side", "-o", "kept.png"),
        ("good.json", "side", "front"),
        errors.SceneFileError,
        lambda at: sk.load_scene(at / "good.json", light="side"),
    ),
    "size without x": of_render("--size", "64", "1280x720", call=lambda at: size("64")),
    "size of zero": of_render("--size", "0x5", call=lambda at: drawn(at, size=(0, 5))),
    "size too large": of_render("--size", "99999x5", call=lambda at: drawn(at, size=(99999, 5))),
    "no samples": of_render("--samples", "0", "256", call=lambda at: drawn(at, samples=0)),
    "many samples": of_render("--samples", "257", "256", call=lambda at: drawn(at, samples=257)),
    "samples in words": Case((*HEAD, "--samples", "few"), ("--samples", "integer")),
    "unknown shading": of_settings("shading", "phong"),
    "unknown tier": of_settings("tier", "fourth"),
    "odd taps": of_settings("deep_scatter_taps", 7),
    "unknown view": of_settings("debug_view", "x-ray"),
    "negative seed": of_settings("seed", -1),
    "unknown comparison": of_render(
        "--compare", "phong", "lambert", call=lambda at: parse_variant("phong", RenderSettings())
    ),
    "lamp of two numbers": of_render("--light", "1,2", call=lambda at: numbers("1,2", 3, "light")),
    "lamp of NaN": of_render("--light", "1,2,nan", call=lambda at: numbers("1,nan", 2, "light")),
    "dark lamp": Case(
        (*HEAD, "--light", "1,2,-1"),
        ("irradiance", "-3.14"),
        call=lambda at: sk.DirectionalLight.from_angles(1.0, 2.0, -1.0),
    ),
    "unknown profile": of_render(
        "--profile", "chalk", "skin-deon2007", call=lambda at: sk.Profile.preset("chalk")
    ),
    "gloss of two": of_render("--gloss", "2", "[0, 1]", call=lambda at: SkinParams(gloss=2.0)),
    "turntable backwards": of_render("--turntable", "-1"),
    "exposure of NaN": of_render("--exposure", "nan"),
    "unknown tone": of_render("--tone", "sepia"),
    "unknown option": Case((*HEAD, "--bogus"), ("--bogus",)),
    "unknown backend": of_render(
        "--backend", "abacus", "cpu", call=lambda at: drawn(at, backend="abacus")
    ),
    "no such GPU": of_render(
        "--adapter",
        "a voodoo",
        "adapter",
        code=1,
        kind=errors.BackendError,
        call=lambda at: open_renderer(
            sk.head_scene(*model(at / "bare.obj", unit_mm=1)), adapter="a voodoo"
        ),
    ),
    "picture's suffix": Case(
        (*HEAD[:4], "-o", "kept.tiff"),
        ("kept.tiff", ".png", ".exr"),
    ),
    "comparison's suffix": Case((*HEAD[:4], "-o", "k.exr", "--compare", "lambert"), ("k.exr",)),
    "no such folder": Case((*HEAD[:4], "-o", "gone/x.png"), ("gone/x.png",), errors.OutputError),
    "plot's suffix": Case(("profile", "skin1", "-o", "kept.exr"), ("kept.exr", ".png")),
    "scale of zero": Case(
        ("profile", "skin1", "--scale", "0"),
        ("--scale", "0.0", "positive"),
    ),
    "table's suffix": Case(("lut", "shadow", "-o", "kept.bmp"), ("kept.bmp", ".exr")),
    "table's folder": Case(("lut", "shadow", "-o", "gone/x.exr"), ("gone/x.exr",)),
    "table's kernel": of_lut(CURVATURE, "--kernel", "cube", "cube", kernel="cube"),
    "table's size": of_lut(CURVATURE, "--size", "1x8", "1×8", size=(1, 8)),
    "table's radii": of_lut(CURVATURE, "--radius-mm", "5,1", "(5, 1)", radius_mm=(5.0, 1.0)),
    "table's profile": of_lut(CURVATURE, "--profile", "chalk", "chalk", "skin1"),
    "table's widths": of_lut(SHADOW, "--width-mm", "8", "'8'"),
    "table's sharpening": of_lut(SHADOW, "--sharpening", "0.5", "0.5", sharpening=0.5),
    "table's scale": of_lut(SHADOW, "--diffusion-radius-mm", "0", "0.0", "positive"),
    "zeroth index": of_mesh("zeroth.obj", errors.MeshFileError),
    "size in other digits": of_render("--size", "²x²", call=lambda at: size("²x²")),
    "larger than a mountain": Case(
        ("render", "{in}/ball.obj", "--unit-mm", "1e300", "-o", "kept.png"), ("unit", "1e+300")
    ),
    "unknown scan": Case(
        ("assets", "get", "venus", "--folder", "."),
        ("venus", "lee-perry-smith"),
        call=lambda at: fetch_scan("venus", at),
    ),
}


@pytest.fixture(scope="module")
def inputs(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("inputs")
    write_inputs(folder)
    return folder


@pytest.fixture(scope="module")
def outcomes(tmp_path_factory, inputs) -> dict[str, Ran]:
    """Every case, each in a folder of its own with files where its output would go."""
    folders = [tmp_path_factory.mktemp("case") for _ in CASES]
    for folder in folders:
        for suffix in (".png", ".exr", ".tiff", ".bmp"):
            (folder / f"kept{suffix}").write_bytes(KEPT)
    asked = [[word.replace("{in}", str(inputs)) for word in case.words] for case in CASES.values()]
    return dict(zip(CASES, run_each(list(zip(folders, asked, strict=True))), strict=True))


def plain(text: str) -> str:
    """Without what tells an option from a keyword: --debug-view is debug_view."""
    return re.sub(r"(?<![\w.])--", "", text).replace("-", "_")


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_the_command_line_says_what_is_wrong(outcomes, name):
    case, ran = CASES[name], outcomes[name]
    assert ran.code == case.code, ran.err
    assert [word for word in case.said if plain(word) not in plain(ran.err)] == []
    assert "Traceback" not in ran.err
    assert "internal error" not in ran.err
    assert "kept" not in ran.out


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_a_failure_writes_nothing_and_keeps_what_was_there(outcomes, name):
    assert outcomes[name].after == outcomes[name].before
    assert outcomes[name].before["kept.png"] == KEPT


@pytest.mark.slow
def test_messages_are_short_and_begin_alike(outcomes):
    own = [o.err for o in outcomes.values() if o.err and "Usage:" not in o.err]
    assert len(own) > len(CASES) - 6
    assert [text for text in own if not re.search(r"^skinshade: error: .", text, re.M)] == []
    # The libraries that read images add a line or two of their own.
    assert max(text.count("\n") for text in own) <= 3


@pytest.mark.parametrize("name", [name for name, case in CASES.items() if case.call])
def test_the_api_raises_the_error_of_that_kind(inputs, name):
    case = CASES[name]
    before = contents(inputs)
    with pytest.raises(case.kind) as caught:
        case.call(inputs)
    assert caught.value.exit_code == case.code
    assert contents(inputs) == before
