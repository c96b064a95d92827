"""The command itself, and how the other files here run it."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import OpenImageIO as oiio  # noqa: N813
import pytest
import trimesh

import skinshade
from skinshade.profile import presets
from skinshade.scene.heads import SCANS

SOURCE = str(Path(skinshade.__file__).parents[1])
NONSENSE = b"\xff\xd8\xff\xe0" + bytes(range(256)) * 16


FORKING = """
import json, os, runpy, sys, traceback
import scipy.ndimage, trimesh, skinshade.cli.app, skinshade.render.cpu.renderer

codes = []
for index, (folder, words) in enumerate(json.load(sys.stdin)):
    child = os.fork()
    if not child:
        code = 0
        try:
            os.chdir(folder)
            for stream in (1, 2):
                os.dup2(os.open(f"{folder}.{index}.{stream}", os.O_CREAT | os.O_WRONLY), stream)
            sys.argv = ["skinshade", *words]
            runpy.run_module("skinshade", run_name="__main__", alter_sys=True)
        except SystemExit as end:
            code = end.code or 0
        except BaseException:
            traceback.print_exc()
            code = 99
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code)
    codes.append(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
print(json.dumps(codes))
"""
"""Runs ``python -m skinshade`` many times for one import of what it needs: .1 s each, not a second."""


@dataclass(frozen=True)
class Ran:
    """How a command ended, what it said, and its folder before and after."""

    code: int
    out: str
    err: str
    before: dict[str, bytes | None]
    after: dict[str, bytes | None]


def _python(folder: Path, *words: str, said: str = "") -> subprocess.CompletedProcess[str]:
    environment = os.environ | {"PYTHONPATH": SOURCE, "COLUMNS": "200", "NO_COLOR": "1"}
    return subprocess.run(
        [sys.executable, *words],
        cwd=folder,
        env=environment,
        input=said,
        capture_output=True,
        text=True,
        encoding="utf-8",
        timeout=300,
        check=False,
    )


def run(folder: Path, *words: str) -> Ran:
    """Run ``python -m skinshade`` in a folder, its output piped, as a script would."""
    before = contents(folder)
    ended = _python(folder, "-m", "skinshade", *words)
    return Ran(ended.returncode, ended.stdout, ended.stderr, before, contents(folder))


def run_each(requests: list[tuple[Path, list[str]]]) -> list[Ran]:
    """Run it for each (folder, words), one after the other, in children of one interpreter."""
    if not hasattr(os, "fork"):
        return [run(folder, *words) for folder, words in requests]
    before = [contents(folder) for folder, _ in requests]
    asked = json.dumps([(str(folder), words) for folder, words in requests])
    driver = _python(requests[0][0], "-c", FORKING, said=asked)
    assert driver.returncode == 0, driver.stderr
    codes = json.loads(driver.stdout)
    ran = []
    for index, (folder, _) in enumerate(requests):
        said = [Path(f"{folder}.{index}.{stream}").read_text("utf-8") for stream in (1, 2)]
        ran.append(Ran(codes[index], *said, before[index], contents(folder)))
    return ran


def contents(folder: Path) -> dict[str, bytes | None]:
    return {
        str(path.relative_to(folder)): path.read_bytes() if path.is_file() else None
        for path in sorted(folder.rglob("*"))
    }


def obj_text(positions: np.ndarray, faces: np.ndarray, uvs: np.ndarray | None = None) -> str:
    lines = ["v " + " ".join(f"{x:.9g}" for x in p) for p in positions]
    lines += [] if uvs is None else [f"vt {u:.6g} {v:.6g}" for u, v in uvs]
    corner = "{0}" if uvs is None else "{0}/{0}"
    lines += ["f " + " ".join(corner.format(i + 1) for i in face) for face in faces]
    return "\n".join(lines) + "\n"


def write_pixels(path: Path, pixels: np.ndarray, kind: str = "uint8") -> None:
    out = oiio.ImageOutput.create(str(path))
    assert out.open(str(path), oiio.ImageSpec(pixels.shape[1], pixels.shape[0], 3, kind))
    assert out.write_image(np.ascontiguousarray(pixels))
    out.close()


def write_inputs(folder: Path) -> None:
    """Good and bad files: a ball of 160 mm with UVs, and ways to spoil it, maps and scenes."""
    ball = trimesh.creation.icosphere(subdivisions=3, radius=80.0)
    p, faces = np.array(ball.vertices), np.array(ball.faces)
    uvs = 0.5 + p[:, :2] / 200.0
    good = obj_text(p, faces, uvs)
    lines = good.splitlines()
    first_face = next(i for i, line in enumerate(lines) if line.startswith("f "))

    def spoiled(at: int, line: str) -> str:
        return "\n".join([*lines[:at], line, *lines[at + 1 :]]) + "\n"

    texts = {
        "ball.obj": good,
        "bare.obj": obj_text(p, faces),
        "nan.obj": spoiled(7, "v 1 nan 3"),
        "infinite.obj": spoiled(7, "v 1 2 inf"),
        "beyond.obj": spoiled(first_face, "f 1/1 99999/1 3/1"),
        "zeroth.obj": spoiled(first_face, "f 0/1 5/5 9/9"),
        "faceless.obj": obj_text(p, faces[:0]),
        "empty.obj": "",
        "line.obj": "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n",
        "notes.txt": good,
        "broken.json": "{nope",
        "list.json": "[1]",
    }
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")
    whole = trimesh.Trimesh(p / 1000.0, faces, process=False).export(file_type="glb")
    (folder / "ball.glb").write_bytes(whole)
    (folder / "cut.glb").write_bytes(whole[: len(whole) // 2])
    (folder / "noise.glb").write_bytes(NONSENSE)
    for name in ("noise.hdr", "noise.png", "noise.jpg", "noise.exr"):
        (folder / name).write_bytes(NONSENSE)
    grey = np.full((8, 16, 3), 128, dtype=np.uint8)
    write_pixels(folder / "grey.png", grey)
    write_pixels(folder / "sky.exr", np.full((8, 16, 3), 0.5, dtype=np.float32), "float")
    (folder / "cut.png").write_bytes((folder / "grey.png").read_bytes()[:60])
    write_pixels(folder / "nan.exr", np.full((8, 16, 3), np.nan, dtype=np.float32), "float")
    write_pixels(folder / "objectspace.png", np.zeros((8, 16, 3), dtype=np.uint8))
    write_scenes(folder)


def write_scenes(folder: Path) -> None:
    sun = {"irradiance_perpendicular": [3, 3, 3], "to_light": {"front": [0, 0, 1]}}
    camera = {"position": [0, 0, 700], "target": [0, 0, 0], "vfov_deg": 20}
    good = {"unit_mm": 1.0, "mesh": {"path": "ball.obj"}, "camera": camera, "sun": sun}
    changes = {
        "good": {},
        "no-mesh": {"mesh": None},
        "no-vfov": {"camera": {k: v for k, v in camera.items() if k != "vfov_deg"}},
        "unit-is-text": {"unit_mm": "wide"},
        "unit-is-zero": {"unit_mm": 0},
        "camera-is-five": {"camera": 5},
        "mesh-is-gone": {"mesh": {"path": "gone.glb"}},
        "sky-is-five": {"environment": 5},
        "colour-is-gone": {"textures": {"color": "gone.png"}},
        "sun-is-a-list": {"sun": sun | {"to_light": [0, 0, 1]}},
        "camera-is-flat": {"camera": camera | {"position": [0, 1]}},
        "fov-is-zero": {"camera": camera | {"vfov_deg": 0}},
        "radius-is-negative": {"materials": {"skin": {"radius_mm": [1, -1, 1]}}},
    }
    for name, change in changes.items():
        record = {key: value for key, value in (good | change).items() if value is not None}
        (folder / f"{name}.json").write_text(json.dumps(record), encoding="utf-8")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--version"], [skinshade.__version__]),
        (["--help"], ["render", "profile", "lut", "assets", "doctor"]),
        (["render", "--help"], ["--compare", "--turntable", "--debug-view", "--unit-mm", "--seed"]),
        (["profile"], presets()),
        (["assets", "list"], [*SCANS, SCANS["lee-perry-smith"].credit]),
        (["doctor"], ["numpy", "trimesh", "backend cpu", "backend gpu"]),
    ],
    ids=lambda value: "-".join(value).strip("-") if isinstance(value, list) else None,
)
def test_it_tells_what_it_can_do(tmp_path, words, said):
    outcome = run(tmp_path, *words)
    assert outcome.code == 0, outcome.err
    assert [word for word in said if word not in outcome.out] == []
    assert outcome.err == ""
    assert contents(tmp_path) == {}


def test_without_a_command_it_shows_its_help_and_fails(tmp_path):
    outcome = run(tmp_path)
    assert outcome.code == 2
    assert "render" in outcome.out + outcome.err
