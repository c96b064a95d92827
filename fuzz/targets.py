"""Targets of the fuzzer: one for each reader of skinshade."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np

from skinshade.baking import BakeSettings, bake
from skinshade.baking.jobs import Job, JobResult
from skinshade.baking.records import read_record
from skinshade.baking.report import write_page, write_report
from skinshade.heads import load_head
from skinshade.lut import Lut
from skinshade.mesh import Mesh, load_mesh
from skinshade.scene import Environment, Material, Scene, load_scene
from skinshade.scene.images import read_image
from skinshade.scene.maps import read_normal_map

from .case import Result, Target

__all__ = ["TARGETS"]


class UnfitResultError(AssertionError):
    """A result that contradicts what the reader promises."""


# -- meshes ----------------------------------------------------------------------------------------


def _mesh_arrays(mesh: Mesh) -> list[Any]:
    if mesh.faces.min() < 0 or mesh.faces.max() >= len(mesh.positions):
        raise UnfitResultError("an index of a face is out of range")
    length = np.abs(np.linalg.norm(mesh.normals, axis=1) - 1.0).max()
    if length > 1e-6:  # rounding of float64 is far below, and float32 is not used
        raise UnfitResultError(f"the length of a normal differs from 1 by {length}")
    uvs = [] if mesh.uvs is None else [mesh.uvs]
    return [mesh.positions_mm, mesh.normals, mesh.unit_mm, *uvs, *mesh.attributes.values()]


def _label(mesh: Mesh) -> str:
    """Return the repairs and the parts of a mesh."""
    parts = [*mesh.repairs, *(("UVs",) if mesh.uvs is not None else ()), *mesh.attributes]
    return f"mesh: {', '.join(part[:40] for part in parts[:10])}"


def read_gltf_mesh(file: Path, output: Path) -> Result:
    """Read a mesh whose format states its unit."""
    mesh = load_mesh(file)
    return Result(_mesh_arrays(mesh), label=_label(mesh))


def read_other_mesh(file: Path, output: Path) -> Result:
    """Read a mesh whose format does not state its unit."""
    mesh = load_mesh(file, unit_mm=1.0)
    return Result(_mesh_arrays(mesh), label=_label(mesh))


def read_head(file: Path, output: Path) -> Result:
    """Read a mesh with its materials and images."""
    head = load_head(file)
    materials = [head.material, *(part.material for part in head.parts)]
    arrays = [array for material in materials for array in _material_arrays(material)]
    arrays += [part.opacity for part in head.parts if part.opacity is not None]
    return Result(_mesh_arrays(head.mesh) + arrays, label=f"{len(head.parts)} parts")


def _material_arrays(material: Material) -> list[Any]:
    maps = (material.albedo, material.normal, material.specular, material.deep_scatter)
    return [array for array in maps if array is not None]


def bake_to(suffix: str, **settings: Any) -> Callable[[Path, Path], Result]:
    """Return a target that bakes a file to a format; OBJ, PLY and STL have the unit of 1 mm."""

    def run(file: Path, output: Path) -> Result:
        is_gltf = file.suffix in (".glb", ".gltf")
        unit = BakeSettings(unit_mm=None if is_gltf else 1.0, **settings)
        asset = bake(file, output / f"baked{suffix}", unit)
        arrays = [
            values
            for baked in asset.meshes
            for values in (*_mesh_arrays(baked.mesh), *baked.analysis.attributes.values())
        ]
        if suffix == ".gltf":
            _strict_json(asset.written[-1].read_bytes())
        elif suffix == ".glb":
            data = asset.written[-1].read_bytes()
            _strict_json(data[20 : 20 + int.from_bytes(data[12:16], "little")])
        elif is_gltf:
            arrays += _mesh_arrays(load_mesh(asset.written[-1], unit_mm=1.0))
        notes = sorted({note for baked in asset.meshes for note in baked.all_notes})
        return Result(arrays, asset.written, f"bake: {', '.join(notes)}")

    return run


def _strict_json(data: bytes) -> Any:
    """Return the value of JSON without NaN, as every other reader needs it."""

    def refuse(name: str) -> float:
        raise UnfitResultError(f"the JSON that was written holds {name}")

    return json.loads(data, parse_constant=refuse)


# -- images and tables -----------------------------------------------------------------------------


def read_picture(file: Path, output: Path) -> Result:
    """Read an image as stored values, as a normal map, and as an environment, which reads it as light."""
    image = read_image(file)
    environment = Environment.load(file)
    normals = read_normal_map(file)
    return Result([image, environment.radiance, normals])


def read_lut(file: Path, output: Path) -> Result:
    """Read a lookup table and look a value up."""
    lut = Lut.load(file)
    values = lut.sample([0.0, 1e9], [0.0, -1e9])
    json.dumps(lut.description())
    return Result([lut.values, values, lut.axes], label=lut.kind)


# -- scenes, records and reports -------------------------------------------------------------------


def read_scene_file(file: Path, output: Path) -> Result:
    """Read a scene description and all files that it names."""
    scene = load_scene(file)
    lights = [light.irradiance for light in scene.lights]
    arrays = [
        *_mesh_arrays(scene.mesh),
        *_material_arrays(scene.material),
        *lights,
        scene.background,
    ]
    arrays += [scene.camera.view_projection(1.0)]
    arrays += [] if scene.environment is None else [scene.environment.radiance]
    return Result(arrays, label=_scene_label(scene))


def _scene_label(scene: Scene) -> str:
    environment = "environment" if scene.environment is not None else ""
    return f"{len(scene.lights)} lights {environment} {len(scene.parts)} parts"


def read_record_file(file: Path, output: Path) -> Result:
    """Read the record of a baked asset."""
    record = read_record(file)
    if record is None:
        return Result(label="refused")
    sizes = [size for mesh in record.meshes for size in (*mesh.size_mm, mesh.unit_mm)]
    return Result([np.array(sizes, dtype=np.float64)], label=f"{len(record.meshes)} meshes")


def write_reports(file: Path, output: Path) -> Result:
    """Write the reports of a record and of failures with any names and messages."""
    try:
        content = json.loads(file.read_bytes())
        description = output / "record.json"
        description.write_text(json.dumps(content["record"]), encoding="ascii")
        record = read_record(description)
        description.unlink()
        failures = [(str(entry["name"]), str(entry["error"])) for entry in content["failures"]]
        seconds = content["seconds"] if isinstance(content["seconds"], (int, float)) else None
    except (ValueError, KeyError, TypeError, RecursionError):
        return Result(label="no results")
    folder = output.parent
    job = Job(
        folder / "a.glb",
        output / "a.glb",
        output / "a.json",
        output / "a.png",
        BakeSettings(),
        False,
        folder,
        output,
    )
    jobs, results = [], []
    for name, error in failures[:50]:
        # A name of a file system has no NUL, no slash, and at most 255 bytes.
        base = name.replace("\0", "").replace("/", "")[:60] or "a"
        jobs.append(replace(job, source=folder / base, output=output / base))
        results.append(JobResult(str(folder / base), str(output / base), "failed", error=error))
    if record is not None:
        jobs.append(job)
        results.append(
            JobResult(
                str(job.source),
                str(job.output),
                "baked",
                "",
                record.key,
                record.files,
                record.meshes,
            )
        )
    page, report = output / "report.html", output / "report.json"
    finite = seconds if seconds is not None and 0 <= seconds < 1e9 else None
    write_page(jobs, results, page, seconds=finite)
    write_report(jobs, results, report)
    _strict_json(report.read_bytes())
    _Page(page.read_text(encoding="utf-8"))
    return Result(
        [], [page, report], f"{len(jobs)} jobs, {len(record.meshes) if record else 0} meshes"
    )


class _Page(HTMLParser):
    """A parser that refuses what a hostile name could add to a page."""

    TAGS = frozenset(
        ("html", "head", "meta", "title", "style", "body", "header", "h1", "h2", "h3", "p", "b",
         "small", "label", "input", "output", "main", "section", "details", "summary", "ul", "li",
         "bdi", "article", "div", "figure", "figcaption", "img", "svg", "path", "span", "br", "script")
    )  # fmt: skip

    def __init__(self, text: str) -> None:
        super().__init__()
        self.scripts = 0
        self.feed(text)
        self.close()
        if self.scripts != 1:
            raise UnfitResultError(f"the page has {self.scripts} scripts")

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Refuse unknown elements, event handlers, and links to other places."""
        self.scripts += tag == "script"
        names = [name for name, _ in attrs]
        if tag not in self.TAGS or any(name.startswith("on") for name in names) or "href" in names:
            raise UnfitResultError(f"the page has <{tag} {' '.join(names)}>")


def _targets() -> Iterator[tuple[str, Target]]:
    """Yield every target with its name."""
    gltf = ("glb", "gltf")
    yield "mesh glTF", Target(read_gltf_mesh, gltf, 6)
    yield "head glTF", Target(read_head, gltf, 4)
    yield "bake glTF to .glb", Target(bake_to(".glb"), gltf, 2)
    yield "bake glTF to .gltf", Target(bake_to(".gltf", smoothing=0, tensor=True), gltf, 2)
    yield (
        "bake glTF to .ply",
        Target(bake_to(".ply", thickness=True, rays=1, tracing="builtin"), gltf, 1),
    )
    yield "bake glTF with maps", Target(bake_to(".glb", map_size=4), gltf, 1)
    for form in ("obj", "ply", "stl"):
        yield f"mesh {form.upper()}", Target(read_other_mesh, (form,), 3)
        yield f"bake {form.upper()} to .glb", Target(bake_to(".glb"), (form,), 1)
    for form in ("png", "jpg", "hdr", "exr", "tif"):
        yield f"image {form.upper()}", Target(read_picture, (form,), 3)
    for form in ("exr", "png", "npz"):
        yield f"table {form.upper()}", Target(read_lut, (f"lut.{form}",), 3)
    yield "scene", Target(read_scene_file, ("scene",), 4, confined=False)
    yield "record", Target(read_record_file, ("record",), 4)
    yield "report", Target(write_reports, ("report",), 3)


TARGETS = dict(_targets())
"""All targets, by name."""
