"""Honest minimal files of every format: the beginning of every case."""

from __future__ import annotations

import json
import struct
import sys
from functools import cache
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests"))  # its modules build glTF without skinshade

from . import seed_images, seed_models  # noqa: E402 — after the path of their imports is set

__all__ = ["SCENE_FILES", "companions", "honest_files"]

CORNERS = ((0, 0, 0), (30, 0, 0), (0, 30, 0), (0, 0, 30))
FACES = ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))
SCENE_FILES = ("mesh.glb", "map.png", "sky.hdr")
"""Names of the files to which the scenes refer."""


@cache
def honest_files() -> dict[str, list[bytes]]:
    """Return the honest files by format; the format is the key of the mutators, too."""
    luts = seed_images.lut_files()
    return {
        "glb": seed_models.glb_files(),
        "gltf": seed_models.gltf_files(),
        "obj": [text.encode() for text in _obj_texts()],
        "ply": _ply_files(),
        "stl": _stl_files(),
        "png": seed_images.png_images(),
        "jpg": seed_images.jpeg_images(),
        "hdr": seed_images.hdr_images(),
        "exr": seed_images.exr_images(),
        "tif": seed_images.tiff_images(),
        "lut.exr": luts[".exr"],
        "lut.png": luts[".png"],
        "lut.npz": luts[".npz"],
        "scene": [json.dumps(scene).encode() for scene in _scenes()],
        "record": [json.dumps(record()).encode()],
        "report": [json.dumps(results()).encode()],
    }


@cache
def companions(form: str) -> dict[str, bytes]:
    """Return the files beside a file of a format, by name."""
    if form in ("glb", "gltf"):
        return seed_models.companions()
    if form == "scene":
        contents = (
            seed_models.glb_files()[0],
            seed_images.png_images()[0],
            seed_images.hdr_images()[0],
        )
        return {**seed_models.companions(), **dict(zip(SCENE_FILES, contents, strict=True))}
    return {}


# -- meshes ----------------------------------------------------------------------------------------


def _obj_texts() -> list[str]:
    """Return OBJ files with every form of corners, colours, groups, quads and negative indices."""
    vertices = [" ".join(map(str, corner)) for corner in CORNERS]
    head = ["# a comment", "mtllib parts.mtl", "o body", *(f"v {v}" for v in vertices)]
    uvs = ["vt 0 0", "vt 1 0 0", "vt 0.5 1e0"]
    normals = ["vn 0 0 -1", "vn 0.0 -1.0 0.0", "vn -1 0 0", "vn 1 1 1"]
    textured = [
        f"f {a + 1}/1/{n} {b + 1}/2/{n} {c + 1}/3/{n}" for n, (a, b, c) in enumerate(FACES, 1)
    ]
    plain = [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in FACES]
    coloured = [f"v {v} 0.5 0.4 0.3" for v in vertices]
    shaded = [f"f {a + 1}//{n} {b + 1}//{n} {c + 1}//{n}" for n, (a, b, c) in enumerate(FACES, 1)]
    sheet = ["v 0 0 0", "v 1 0 0", "v 1 1 0 1.0", "v 0 1 0", "usemtl skin", "s 1"]
    files = [
        [*head, *uvs, *normals, "g front", *textured],
        [*coloured, *plain],
        [*head, *normals, *shaded, "l 1 2", "p 3"],
        [*sheet, "f -4 -3 -2 -1", "f 1 2 \\", "3"],
    ]
    return ["\n".join(lines) + "\n" for lines in files]


def _ply_files() -> list[bytes]:
    """Return PLY files: text, both byte orders, and a body with normals, UVs, colours and more elements."""
    plain = ["property float x", "property float y", "property float z"]
    faces = ["element face 4", "property list uchar int vertex_indices"]
    more = ["property float nx", "property float ny", "property float nz"]
    more += [
        "property float s",
        "property float t",
        "property uchar red",
        "property double curvature",
    ]
    files = []
    for form, order in (("ascii", ""), ("binary_little_endian", "<"), ("binary_big_endian", ">")):
        lines = ["ply", f"format {form} 1.0", "comment a comment", "element vertex 4"]
        header = "\n".join([*lines, *plain, *faces, "end_header", ""]).encode()
        if order:
            body = b"".join(struct.pack(f"{order}3f", *corner) for corner in CORNERS)
            body += b"".join(struct.pack(f"{order}B3i", 3, *face) for face in FACES)
        else:
            rows = [*CORNERS, *((3, *face) for face in FACES)]
            body = "".join(" ".join(map(str, row)) + "\n" for row in rows).encode()
        files.append(header + body)
    lines = ["ply", "format binary_little_endian 1.0", "element vertex 4", *plain, *more, *faces]
    lines += ["property uchar flags", "element edge 1", "property int vertex1", "end_header", ""]
    body = b"".join(struct.pack("<8fBd", *c, 0, 0, 1, 0.5, 0.25, 9, 0.1) for c in CORNERS)
    body += b"".join(struct.pack("<B3iB", 3, *face, 7) for face in FACES) + struct.pack("<i", 1)
    return [*files, "\n".join(lines).encode() + body]


def _stl_files() -> list[bytes]:
    """Return an ASCII and a binary STL file."""
    triangles = [[CORNERS[i] for i in face] for face in FACES]
    lines = ["solid body"]
    for triangle in triangles:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += [f"vertex {x} {y} {z}e0" for x, y, z in triangle]
        lines += ["endloop", "endfacet"]
    numbers = [[0, 0, 0, *(x for corner in triangle for x in corner)] for triangle in triangles]
    binary = b"binary".ljust(80, b"\0") + struct.pack("<I", len(triangles))
    binary += b"".join(struct.pack("<12fH", *row, 0) for row in numbers)
    return ["\n".join([*lines, "endsolid body", ""]).encode(), binary]


# -- JSON ------------------------------------------------------------------------------------------


def _scenes() -> list[dict[str, Any]]:
    """Return scenes that use every key of the schema."""
    mesh, image, sky = SCENE_FILES
    camera = {"position": [0, 0, 0.9], "target": [0, 0, 0]}
    sun: dict[str, Any] = {
        "kind": "sun",
        "name": "key",
        "to_light": [0, 1, 1],
        "irradiance": [3, 3, 3],
    }
    sun["angular_diameter_deg"] = 1.0
    spot = {"kind": "spot", "position": [1, 1, 1], "target": [0, 0, 0], "irradiance": [1, 1, 1]}
    minimal = {"skinshade": 1, "mesh": {"path": mesh}, "camera": camera, "lights": [sun]}
    profiles: list[dict[str, Any]] = [
        {"kind": "preset", "name": "marble"},
        {
            "kind": "burley",
            "length_mm": [0.6, 0.3, 0.2],
            "length_kind": "shape",
            "albedo": [0.6, 0.4, 0.3],
        },
        {
            "kind": "gaussians",
            "variances_mm2": [0.1, 1],
            "weights": [[0.5, 0.5, 0.5], [0.5, 0.5, 0.5]],
            "albedo": [0.6, 0.4, 0.3],
        },
        {"kind": "dipole", "sigma_s_prime_per_mm": [1, 1, 1], "sigma_a_per_mm": [0.1, 0.1, 0.1]},
    ]
    material = {
        "albedo": {"path": image, "color_space": "srgb", "v": "down"},
        "normal": {"path": image, "strength": 0.5},
        "deep_scatter": 0.5,
        "roughness": 0.4,
        "ior": 1.4,
    }
    full = [
        minimal | {"material": material | {"profile": profile}, "unit_mm": 1000.0}
        for profile in profiles
    ]
    full[1] |= {
        "mesh": {"path": mesh, "credit": "nobody", "skin_materials": ["skin*"]},
        "camera": camera | {"up": [0, 1, 0], "vertical_fov_deg": 30},
        "lights": [sun | {"enabled": False}, spot | {"name": "rim", "cone_deg": 40}],
        "environment": {"path": sky, "scale": 0.5, "visible": True},
        "background": [0.1, 0.1, 0.1],
        "tone": {"curve": "filmic", "exposure": 1},
    }
    return [minimal, *full]


def record() -> dict[str, Any]:
    """Return the content of a record of a baked asset with one mesh."""
    mesh = {
        "name": "head",
        "unit_mm": 1000.0,
        "vertices": 12,
        "triangles": 20,
        "size_mm": [160.0, 160.0, 160.0],
        "uv_scale_mm": None,
        "ranges": {"curvature": [-0.5, 0.5], "thickness": [1, 90.0]},
        "histograms": {"curvature": list(range(48)), "thickness": [0] * 48},
        "notes": {"normals computed": 12},
    }
    return {
        "source": "shelf/head.glb",
        "output": "shelf/head.glb",
        "key": "0" * 64,
        "files": {"head.glb": "1" * 64},
        "thumbnail": "2" * 64,
        "meshes": [mesh],
        "warnings": ["with the given unit of 1000 mm, the object is 3.46 m across"],
    }


def results() -> dict[str, Any]:
    """Return a record, and the names and errors of further results, for a report."""
    return {
        "record": record(),
        "failures": [
            {"name": "a.glb", "error": "a.glb: no such file"},
            {"name": "b", "error": "'x'"},
        ],
        "seconds": 71.5,
    }
