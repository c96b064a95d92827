"""Runs of the program as scripts see it, and files for it to read."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import OpenImageIO as oiio  # noqa: N813
import trimesh

import skinshade

SOURCE = str(Path(skinshade.__file__).parents[1])
NOISE = b"\xff\xd8\xff\xe0" + bytes(range(256)) * 16
"""Bytes that are no file of any format."""
IMPORTED = (
    "scipy.ndimage",
    "skinshade.rendering.cpu.renderer",
    "skinshade.scene.schema",
    "trimesh",
)
IMPORTED += tuple(f"skinshade.cli.{name}" for name in ("render", "bake", "lut", "shaders"))
"""Modules that the interpreter of `run_all` imports once for all its runs."""

FORKING = """
import json, os, runpy, sys, traceback
import {imported}

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
""".replace("{imported}", ", ".join(IMPORTED))
"""Runs ``python -m skinshade`` many times and imports its modules once: 0.1 s a run, not 1 s."""


@dataclass(frozen=True)
class Run:
    """Exit code and output of a run, and the content of its folder before and after."""

    code: int
    out: str
    err: str
    before: dict[str, bytes | None]
    after: dict[str, bytes | None]


def run(folder: Path, *words: str) -> Run:
    """Run ``python -m skinshade`` in a folder, with pipes for its output."""
    before = contents(folder)
    process = _python(folder, "-m", "skinshade", *words)
    return Run(process.returncode, process.stdout, process.stderr, before, contents(folder))


def run_all(requests: list[tuple[Path, list[str]]]) -> list[Run]:
    """Run ``python -m skinshade`` for every (folder, words), in children of one interpreter."""
    if not hasattr(os, "fork"):
        return [run(folder, *words) for folder, words in requests]
    before = [contents(folder) for folder, _ in requests]
    text = json.dumps([(str(folder), words) for folder, words in requests])
    process = _python(requests[0][0], "-c", FORKING, stdin=text)
    assert process.returncode == 0, process.stderr
    codes = json.loads(process.stdout)
    runs = []
    for index, (folder, _) in enumerate(requests):
        streams = [Path(f"{folder}.{index}.{stream}").read_text("utf-8") for stream in (1, 2)]
        runs.append(Run(codes[index], *streams, before[index], contents(folder)))
    return runs


def contents(folder: Path) -> dict[str, bytes | None]:
    """Return the bytes of every file below a folder by its path, and None for folders."""
    return {
        str(path.relative_to(folder)): path.read_bytes() if path.is_file() else None
        for path in sorted(folder.rglob("*"))
    }


def _python(folder: Path, *words: str, stdin: str = "") -> subprocess.CompletedProcess[str]:
    environment = os.environ | {"PYTHONPATH": SOURCE, "COLUMNS": "200", "NO_COLOR": "1"}
    return subprocess.run(
        [sys.executable, *words],
        cwd=folder,
        env=environment,
        input=stdin,
        capture_output=True,
        text=True,
        encoding="utf-8",
        timeout=300,
        check=False,
    )


# -- files -----------------------------------------------------------------------------------------


def write_inputs(folder: Path) -> None:
    """Write a ball of 160 mm with UVs, maps and scenes, and damaged versions of all."""
    ball = trimesh.creation.icosphere(subdivisions=3, radius=80.0)
    p, faces = np.array(ball.vertices), np.array(ball.faces)
    uvs = 0.5 + p[:, :2] / 200.0
    good = _obj_text(p, faces, uvs)
    lines = good.splitlines()
    first_face = next(i for i, line in enumerate(lines) if line.startswith("f "))

    def with_line(index: int, line: str) -> str:
        return "\n".join([*lines[:index], line, *lines[index + 1 :]]) + "\n"

    texts = {
        "ball.obj": good,
        "bare.obj": _obj_text(p, faces),
        "nan.obj": with_line(7, "v 1 nan 3"),
        "infinite.obj": with_line(7, "v 1 2 inf"),
        "beyond.obj": with_line(first_face, "f 1/1 99999/1 3/1"),
        "zeroth.obj": with_line(first_face, "f 0/1 5/5 9/9"),
        "faceless.obj": _obj_text(p, faces[:0]),
        "empty.obj": "",
        "line.obj": "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n",
        "notes.txt": good,
        "broken.json": "{nope",
        "list.json": "[1]",
        "repeated.json": '{"skinshade": 1, "skinshade": 1}',
    }
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")
    whole = trimesh.Trimesh(p / 1000.0, faces, process=False).export(file_type="glb")
    (folder / "ball.glb").write_bytes(whole)
    (folder / "cut.glb").write_bytes(whole[: len(whole) // 2])
    for name in ("noise.glb", "noise.hdr", "noise.png", "noise.jpg", "noise.exr"):
        (folder / name).write_bytes(NOISE)
    _write_image(folder / "grey.png", np.full((8, 16, 3), 128, dtype=np.uint8))
    _write_image(folder / "objectspace.png", np.zeros((8, 16, 3), dtype=np.uint8))
    _write_image(folder / "sky.exr", np.full((8, 16, 3), 0.5, dtype=np.float32))
    _write_image(folder / "nan.exr", np.full((8, 16, 3), np.nan, dtype=np.float32))
    (folder / "cut.png").write_bytes((folder / "grey.png").read_bytes()[:60])
    _write_scenes(folder)


def _obj_text(positions: np.ndarray, faces: np.ndarray, uvs: np.ndarray | None = None) -> str:
    lines = ["v " + " ".join(f"{x:.9g}" for x in p) for p in positions]
    lines += [] if uvs is None else [f"vt {u:.6g} {v:.6g}" for u, v in uvs]
    corner = "{0}" if uvs is None else "{0}/{0}"
    lines += ["f " + " ".join(corner.format(i + 1) for i in face) for face in faces]
    return "\n".join(lines) + "\n"


def _write_image(path: Path, pixels: np.ndarray) -> None:
    kind = "uint8" if pixels.dtype == np.uint8 else "float"
    out = oiio.ImageOutput.create(str(path))
    assert out.open(str(path), oiio.ImageSpec(pixels.shape[1], pixels.shape[0], 3, kind))
    assert out.write_image(np.ascontiguousarray(pixels))
    out.close()


def _write_scenes(folder: Path) -> None:
    camera = {"position": [0, 0, 700], "target": [0, 0, 0], "vertical_fov_deg": 20}
    front = {"name": "front", "kind": "sun", "to_light": [0, 0, 1], "irradiance": [3, 3, 3]}
    side = front | {"name": "side", "to_light": [1, 0, 0], "enabled": False}
    good = {
        "skinshade": 1,
        "unit_mm": 1.0,
        "mesh": {"path": "ball.obj"},
        "camera": camera,
        "lights": [front, side],
    }
    profile = {"kind": "burley", "length_mm": [1, -1, 1], "length_kind": "shape"}
    changes = {
        "good": {},
        "no-mesh": {"mesh": None},
        "no-camera-target": {"camera": {"position": [0, 0, 700]}},
        "version-is-2": {"skinshade": 2},
        "unknown-key": {"colour": "grey.png"},
        "unit-is-text": {"unit_mm": "wide"},
        "unit-is-zero": {"unit_mm": 0},
        "camera-is-five": {"camera": 5},
        "mesh-is-missing": {"mesh": {"path": "none.glb"}},
        "sky-is-five": {"environment": 5},
        "albedo-is-missing": {"material": {"albedo": {"path": "none.png"}}},
        "light-without-direction": {"lights": [front | {"to_light": [0, 0, 0]}]},
        "camera-is-flat": {"camera": camera | {"position": [0, 1]}},
        "fov-is-zero": {"camera": camera | {"vertical_fov_deg": 0}},
        "length-is-negative": {
            "material": {"profile": profile | {"albedo": [0.5, 0.5, 0.5]}},
        },
    }
    for name, change in changes.items():
        document = {key: value for key, value in (good | change).items() if value is not None}
        (folder / f"{name}.json").write_text(json.dumps(document), encoding="utf-8")
