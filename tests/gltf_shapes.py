"""glTF files of every form that the format has, built by hand: what comes back of them can be proven.

Spheres, whose curvature is one over their radius. Nothing here uses skinshade.
"""

from __future__ import annotations

import base64
import json
import struct
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

import shapes

CODES = {"i1": 5120, "u1": 5121, "i2": 5122, "u2": 5123, "u4": 5125, "f4": 5126}
TYPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}
PNG = base64.b64decode(
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5ErkJggg=="
)
"""One texel."""


@dataclass
class Built:
    """A document, its one buffer, and the radius in mm of the sphere that each mesh lies on."""

    document: dict[str, Any]
    binary: bytearray = field(default_factory=bytearray)
    radii_mm: list[float] = field(default_factory=list)

    def view(self, data: bytes, **more: Any) -> int:
        """Add a bufferView."""
        self.binary += b"\0" * (-len(self.binary) % 4)
        views = self.document.setdefault("bufferViews", [])
        views.append({"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)} | more)
        self.binary += data
        return len(views) - 1

    def accessor(self, values: np.ndarray, kind: str = "f4", *, target: int | None = 34962, **more):
        """Add an accessor with a view of its own; rows of vertex data begin at multiples of 4."""
        stored = np.asarray(values).astype(f"<{kind}").reshape(len(values), -1)
        row = stored.shape[1] * stored.itemsize
        padded = target == 34962 and row % 4 != 0
        stride = row + (-row % 4 if padded else 0)
        table = np.zeros((len(stored), stride), np.uint8)
        table[:, :row] = np.ascontiguousarray(stored).view(np.uint8)
        view = {"target": target} if target else {}
        view |= {"byteStride": stride} if padded else {}
        described = {"bufferView": self.view(table.tobytes(), **view)}
        return self.described(stored, kind, **described, **more)

    def described(self, stored: np.ndarray, kind: str, **more: Any) -> int:
        """Add an accessor for bytes that lie elsewhere."""
        entry = {
            "componentType": CODES[kind],
            "count": len(stored),
            "type": TYPES[stored.shape[1]],
            "min": stored.min(axis=0).tolist(),
            "max": stored.max(axis=0).tolist(),
        }
        self.document.setdefault("accessors", []).append(entry | more)
        return len(self.document["accessors"]) - 1

    def mesh(self, *primitives: dict[str, Any], radius_mm: float = 80.0, **more: Any) -> int:
        """Add a mesh on a sphere."""
        self.document.setdefault("meshes", []).append({"primitives": list(primitives)} | more)
        self.radii_mm.append(radius_mm)
        return len(self.document["meshes"]) - 1

    def show(self, *nodes: dict[str, Any], roots: list[int] | None = None) -> Built:
        """Make the nodes, of which the scene shows the roots, or all; and end."""
        shown = list(range(len(nodes))) if roots is None else roots
        self.document |= {"nodes": list(nodes), "scene": 0, "scenes": [{"nodes": shown}]}
        return self


def new(**more: Any) -> Built:
    return Built({"asset": {"version": "2.0", "generator": "by hand"}} | more)


# -- files -----------------------------------------------------------------------------------------


def pack_glb(document: dict[str, Any] | bytes, binary: bytes, *more: tuple[int, bytes]) -> bytes:
    """A GLB; `more` are chunks of other types."""
    text = document if isinstance(document, bytes) else json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = [(0x4E4F534A, text)]
    chunks += [(0x004E4942, bytes(binary) + b"\0" * (-len(binary) % 4))] if binary else []
    body = b"".join(struct.pack("<II", len(c), kind) + c for kind, c in [*chunks, *more])
    return struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body


def write(built: Built, folder: Path, form: str = "glb", stem: str = "head") -> Path:
    """Write as ``glb``, ``external`` (.bin in a folder), ``embedded`` or ``two`` (GLB and .bin)."""
    document, binary = json.loads(json.dumps(built.document)), bytes(built.binary)
    document["buffers"] = [{"byteLength": len(binary), "name": "all"}]
    folder.mkdir(parents=True, exist_ok=True)
    if form == "embedded":
        uri = "data:application/octet-stream;base64," + base64.b64encode(binary).decode()
        document["buffers"][0]["uri"] = uri
    if form == "external":
        (folder / "parts of it").mkdir(exist_ok=True)
        (folder / "parts of it" / f"{stem} 1.bin").write_bytes(binary)
        document["buffers"][0]["uri"] = f"parts%20of%20it/{stem}%201.bin"
    if form == "two":
        (folder / f"{stem}.bin").write_bytes(binary)
        document["buffers"].append({"byteLength": len(binary), "uri": f"{stem}.bin"})
        for view in document["bufferViews"][1::2]:
            view["buffer"] = 1
    path = folder / (f"{stem}.glb" if form in ("glb", "two") else f"{stem}.gltf")
    if path.suffix == ".glb":
        path.write_bytes(pack_glb(document, binary))
    else:
        path.write_text(json.dumps(document), encoding="utf-8")
    return path


def read(path: Path) -> tuple[dict[str, Any], list[bytes]]:
    """The document and the bytes of each buffer."""
    data, chunk = path.read_bytes(), b""
    if data[:4] == b"glTF":
        length = struct.unpack_from("<I", data, 12)[0]
        data, rest = data[20 : 20 + length], data[20 + length :]
        chunk = rest[8 : 8 + struct.unpack_from("<I", rest)[0]] if rest else b""
    document = json.loads(data)
    buffers = []
    for each in document["buffers"]:
        uri = each.get("uri")
        if uri is None:
            buffers.append(chunk)
        elif uri.startswith("data:"):
            buffers.append(base64.b64decode(uri.split(",")[1]))
        else:
            buffers.append((path.parent / uri.replace("%20", " ")).read_bytes())
    return document, buffers


def view_bytes(document: dict[str, Any], buffers: list[bytes]) -> list[bytes]:
    """The bytes of each bufferView."""
    found = []
    for view in document.get("bufferViews", []):
        start = view.get("byteOffset", 0)
        found.append(buffers[view["buffer"]][start : start + view["byteLength"]])
    return found


# -- parts -----------------------------------------------------------------------------------------


def ball(radius_m: float = 0.08, level: int = 2) -> tuple[np.ndarray, ...]:
    """Positions, normals, UVs and faces of a sphere."""
    shape = shapes.sphere("icosphere", level, radius_m)
    u = 0.5 + np.arctan2(shape.normals[:, 1], shape.normals[:, 0]) / (2.0 * np.pi)
    v = np.arccos(np.clip(shape.normals[:, 2], -1.0, 1.0)) / np.pi
    return shape.positions, shape.normals, np.stack([u, v], axis=1), shape.faces


def attributes(built: Built, positions, normals, uvs, *_: Any) -> dict[str, int]:
    return {
        "POSITION": built.accessor(positions),
        "NORMAL": built.accessor(normals),
        "TEXCOORD_0": built.accessor(uvs),
    }


def primitive(built: Built, faces: np.ndarray, kind: str = "u2", **attributes: int):
    indices = built.accessor(faces.reshape(-1, 1), kind, target=34963)
    return {"attributes": attributes, "indices": indices}


def plain() -> Built:
    """Indexed, with a textured material and a camera."""
    built = new()
    parts = ball()
    one = primitive(built, parts[3], **attributes(built, *parts)) | {"material": 0}
    image = built.view(PNG)
    built.document |= {
        "images": [{"bufferView": image, "mimeType": "image/png"}],
        "samplers": [{"wrapS": 33071}],
        "textures": [{"source": 0, "sampler": 0}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}, "name": "skin"}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.01}}],
    }
    built.mesh(one, name="ball")
    return built.show({"mesh": 0}, {"camera": 0, "translation": [0, 0, 1]})


def interleaved() -> Built:
    """All attributes in one view, u4 indices."""
    built = new()
    p, n, t, faces = ball()
    table = np.concatenate([p, n, t], axis=1).astype("<f4")
    view = built.view(table.tobytes(), byteStride=32, target=34962)
    named, at = {}, 0
    for name, values in (("POSITION", p), ("NORMAL", n), ("TEXCOORD_0", t)):
        named[name] = built.described(values.astype("<f4"), "f4", bufferView=view, byteOffset=at)
        at += 4 * values.shape[1]
    built.mesh(primitive(built, faces, "u4", **named))
    return built.show({"mesh": 0})


def skinned() -> Built:
    """In the bind pose half as large as its vertices say; its node's own scale means nothing."""
    built = new()
    parts = ball(0.16)
    named = attributes(built, *parts)
    count = len(parts[0])
    named["JOINTS_0"] = built.accessor(np.tile([0, 1, 0, 0], (count, 1)), "u1")
    named["WEIGHTS_0"] = built.accessor(np.tile([0.75, 0.25, 0.0, 0.0], (count, 1)))
    inverse = np.tile(np.diag([2.0, 2.0, 2.0, 1.0]), (2, 1, 1))
    inverse[:, 3, 1] = (0.0, -1.0)  # column after column
    bind = built.accessor(inverse.reshape(2, 16), target=None)
    built.document["skins"] = [{"joints": [1, 2], "inverseBindMatrices": bind, "name": "rig"}]
    built.mesh(primitive(built, parts[3], **named))
    nodes = [
        {"mesh": 0, "skin": 0},
        {"name": "root", "children": [2], "scale": [0.25, 0.25, 0.25]},
        {"name": "tip", "translation": [0, 1, 0]},
    ]
    return built.show(*nodes, roots=[0, 1])


def morphed() -> Built:
    """Two targets, one of them sparse without a base, and an animation of both."""
    built = new()
    parts = ball()
    one = primitive(built, parts[3], **attributes(built, *parts))
    moved = np.zeros_like(parts[0], dtype="<f4")
    moved[5] = (0.0, 0.01, 0.0)
    sparse = {
        "count": 1,
        "indices": {"bufferView": built.view(struct.pack("<H", 5)), "componentType": 5123},
        "values": {"bufferView": built.view(moved[5].tobytes())},
    }
    one["targets"] = [
        {"POSITION": built.accessor(0.1 * parts[0])},
        {"POSITION": built.described(moved, "f4", sparse=sparse)},
    ]
    built.mesh(one, weights=[0.25, 0.0], extras={"targetNames": ["wide", "nose"]})
    times = built.accessor(np.array([[0.0], [1.0]]), target=None)
    weights = built.accessor(np.array([[0.0], [1.0], [1.0], [0.0]]), target=None)
    turns = built.accessor(np.array([[0.0, 0, 0, 1], [0, 1, 0, 0]]), target=None)
    built.document["animations"] = [
        {
            "channels": [
                {"sampler": 0, "target": {"node": 0, "path": "weights"}},
                {"sampler": 1, "target": {"node": 0, "path": "rotation"}},
            ],
            "samplers": [
                {"input": times, "output": weights, "interpolation": "LINEAR"},
                {"input": times, "output": turns},
            ],
        }
    ]
    return built.show({"mesh": 0, "rotation": [0, 0, 0, 1]})


def sparse() -> Built:
    """Positions of a ball of which ten were moved away, and are put back by a sparse accessor."""
    built = new()
    p, n, t, faces = ball()
    places = np.arange(3, 103, 10)
    wrong = p.copy()
    wrong[places] *= 3.0
    named = attributes(built, wrong, n, t)
    entry = built.document["accessors"][named["POSITION"]]
    entry |= {
        "min": p.astype("f4").min(axis=0).tolist(),
        "max": p.astype("f4").max(axis=0).tolist(),
    }
    entry["sparse"] = {
        "count": len(places),
        "indices": {
            "bufferView": built.view(places.astype("u1").tobytes()),
            "componentType": 5121,
        },
        "values": {"bufferView": built.view(p[places].astype("<f4").tobytes())},
    }
    built.mesh(primitive(built, faces, "u1", **named))
    return built.show({"mesh": 0})


def several() -> Built:
    """Two halves of one set of vertices, lines and points between them; a mesh of two sets."""
    built = new()
    parts = ball()
    named, faces = attributes(built, *parts), parts[3]
    half = len(faces) // 2
    lines = primitive(built, faces[:4], **named) | {"mode": 1}
    points = {"attributes": {"POSITION": named["POSITION"]}, "mode": 0}
    first, second = (primitive(built, part, **named) for part in (faces[:half], faces[half:]))
    built.mesh(first, lines, second, points)
    p, n, t, faces = ball(0.02, 1)
    halves = []
    for part in (faces[:40], faces[40:]):  # with vertices of their own
        used, compact = np.unique(part, return_inverse=True)
        halves.append(primitive(built, compact, **attributes(built, p[used], n[used], t[used])))
    built.mesh(*halves, radius_mm=20.0)
    return built.show({"mesh": 0}, {"mesh": 1, "translation": [1, 0, 0]}, {"name": "empty"})


def instances() -> Built:
    """One mesh at two scales, of which the first counts, and one below a parent that is scaled."""
    built = new()
    parts = ball(0.04)
    one = primitive(built, parts[3], **attributes(built, *parts))
    built.mesh(one)
    built.mesh(dict(one), radius_mm=10.0)
    matrix = np.diag([-0.5, 0.5, 0.5, 1.0]).T.ravel().tolist()  # a mirror image
    nodes = [
        {"mesh": 0, "scale": [2, 2, 2]},
        {"mesh": 0, "scale": [4, 4, 4], "translation": [1, 0, 0]},
        {"children": [3], "matrix": matrix},
        {"mesh": 1, "scale": [0.5, 0.5, 0.5], "rotation": [0, 0.6, 0, 0.8]},
    ]
    return built.show(*nodes, roots=[0, 1, 2])


def strips() -> Built:
    """A band around the equator as a strip without indices, and as one with them."""
    built = new()
    around = np.arange(25) * (2.0 * np.pi / 24)
    n = np.stack(
        [
            np.stack(
                [np.cos(h) * np.cos(around), np.cos(h) * np.sin(around), 0 * around + np.sin(h)], 1
            )
            for h in (0.15, -0.15)
        ],
        axis=1,
    ).reshape(-1, 3)
    uvs = np.stack([np.repeat(around / 7.0, 2), np.tile([0.0, 1.0], 25)], axis=1)
    named = attributes(built, 0.08 * n, n, uvs)
    order = np.arange(len(n)).reshape(-1, 1)
    built.mesh({"attributes": named, "mode": 5})
    built.mesh(
        {"attributes": named, "mode": 5, "indices": built.accessor(order, "u1", target=34963)}
    )
    return built.show({"mesh": 0}, {"mesh": 1})


def fan() -> Built:
    """A cap of a sphere as a fan."""
    built = new()
    around = np.arange(13) * (2.0 * np.pi / 12)
    rim = np.stack([np.cos(around) * 0.3, np.sin(around) * 0.3, 0 * around + np.sqrt(0.91)], axis=1)
    n = np.concatenate([[[0.0, 0.0, 1.0]], rim])
    built.mesh({"attributes": attributes(built, 0.08 * n, n, n[:, :2]), "mode": 6})
    return built.show({"mesh": 0})


def bare() -> Built:
    """Neither indices nor normals nor UVs: three corners a face."""
    built = new()
    p, _, _, faces = ball()
    built.mesh({"attributes": {"POSITION": built.accessor(p[faces].reshape(-1, 3))}})
    return built.show({"mesh": 0})


def quantised() -> Built:
    """Positions in 16 bits whole, normals in 8 bits, UVs in 16: the node's scale makes them metres."""
    used = ["KHR_mesh_quantization"]
    built = new(extensionsUsed=used, extensionsRequired=used)
    p, n, t, faces = ball(1.0)
    named = {
        "POSITION": built.accessor(np.rint(p * 32000.0), "i2"),
        "NORMAL": built.accessor(np.rint(n * 127.0), "i1", normalized=True),
        "TEXCOORD_0": built.accessor(np.rint(t * 65535.0), "u2", normalized=True),
    }
    built.mesh(primitive(built, faces, **named))
    return built.show({"mesh": 0, "scale": [0.08 / 32000.0] * 3})


def foreign() -> Built:
    """Extensions and extras that nobody here knows, at every level, and numbers of every form."""
    unknown = {"VENDOR_freckles": {"density": 1e-9, "seeds": [1, 2**53, -0.5], "on": None}}
    built = new(extensionsUsed=["VENDOR_freckles"], extensions=unknown)
    parts = ball()
    named = attributes(built, *parts)
    named["_FRECKLES"] = built.accessor(parts[2])
    one = primitive(built, parts[3], **named)
    one |= {"extras": {"layer": "épiderme ☃"}, "extensions": unknown}
    built.mesh(one, extras={"skinshade-like": True}, extensions=unknown, name="tête")
    built.document["accessors"][0]["extras"] = [1, [2.5, {}], "three"]
    built.document["bufferViews"][0] |= {"name": "positions", "extras": {"a": 1}}
    built.document["asset"]["copyright"] = "nobody"
    return built.show({"mesh": 0, "extras": 7, "extensions": unknown})


SHAPES: dict[str, Callable[[], Built]] = {
    each.__name__: each for each in [plain, interleaved, skinned, morphed, sparse, several]
}
SHAPES |= {each.__name__: each for each in [instances, strips, fan, bare, quantised, foreign]}
FORMS = ("glb", "external", "embedded", "two")
