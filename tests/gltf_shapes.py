"""glTF models that use every part of the format, built by hand, with known geometry.

Each mesh lies on a sphere, whose curvature is one over its radius. Nothing here uses skinshade.
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
"""An image of one texel."""


@dataclass
class GltfModel:
    """A document, its only buffer, and the radius in mm of the sphere that each mesh lies on."""

    document: dict[str, Any]
    binary: bytearray = field(default_factory=bytearray)
    radii_mm: list[float] = field(default_factory=list)

    def add_view(self, data: bytes, **more: Any) -> int:
        """Add a bufferView."""
        self.binary += b"\0" * (-len(self.binary) % 4)
        views = self.document.setdefault("bufferViews", [])
        views.append({"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)} | more)
        self.binary += data
        return len(views) - 1

    def add_accessor(self, values, kind: str = "f4", *, target: int | None = 34962, **more) -> int:
        """Add an accessor with its own view; rows of vertex data begin at multiples of 4 bytes."""
        stored = np.asarray(values).astype(f"<{kind}").reshape(len(values), -1)
        row = stored.shape[1] * stored.itemsize
        padded = target == 34962 and row % 4 != 0
        stride = row + (-row % 4 if padded else 0)
        table = np.zeros((len(stored), stride), np.uint8)
        table[:, :row] = np.ascontiguousarray(stored).view(np.uint8)
        view = {"target": target} if target else {}
        view |= {"byteStride": stride} if padded else {}
        source = {"bufferView": self.add_view(table.tobytes(), **view)}
        return self.add_accessor_entry(stored, kind, **source, **more)

    def add_accessor_entry(self, stored: np.ndarray, kind: str, **more: Any) -> int:
        """Add the entry of an accessor alone, without a view."""
        entry = {
            "componentType": CODES[kind],
            "count": len(stored),
            "type": TYPES[stored.shape[1]],
            "min": stored.min(axis=0).tolist(),
            "max": stored.max(axis=0).tolist(),
        }
        self.document.setdefault("accessors", []).append(entry | more)
        return len(self.document["accessors"]) - 1

    def add_mesh(self, *primitives: dict[str, Any], radius_mm: float = 80.0, **more: Any) -> int:
        """Add a mesh that lies on a sphere."""
        self.document.setdefault("meshes", []).append({"primitives": list(primitives)} | more)
        self.radii_mm.append(radius_mm)
        return len(self.document["meshes"]) - 1

    def with_nodes(self, *nodes: dict[str, Any], roots: list[int] | None = None) -> GltfModel:
        """Set the nodes and the roots of the scene (all nodes by default); return the model."""
        scene = {"nodes": list(range(len(nodes))) if roots is None else roots}
        self.document |= {"nodes": list(nodes), "scene": 0, "scenes": [scene]}
        return self


def empty_model(**more: Any) -> GltfModel:
    return GltfModel({"asset": {"version": "2.0", "generator": "by hand"}} | more)


# -- files -----------------------------------------------------------------------------------------


def pack_glb(document: dict[str, Any] | bytes, binary: bytes, *more: tuple[int, bytes]) -> bytes:
    """Return a GLB; `more` are chunks of other types."""
    text = document if isinstance(document, bytes) else json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = [(0x4E4F534A, text)]
    chunks += [(0x004E4942, bytes(binary) + b"\0" * (-len(binary) % 4))] if binary else []
    body = b"".join(struct.pack("<II", len(c), kind) + c for kind, c in [*chunks, *more])
    return struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body


def write(model: GltfModel, folder: Path, form: str = "glb", stem: str = "head") -> Path:
    """Write as ``glb``, ``external`` (.bin in a folder), ``embedded`` or ``two`` (GLB and .bin)."""
    document, binary = json.loads(json.dumps(model.document)), bytes(model.binary)
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
    """Return the document and the bytes of each buffer."""
    data, chunk = path.read_bytes(), b""
    if data[:4] == b"glTF":
        length = struct.unpack_from("<I", data, 12)[0]
        data, rest = data[20 : 20 + length], data[20 + length :]
        chunk = rest[8 : 8 + struct.unpack_from("<I", rest)[0]] if rest else b""
    document = json.loads(data)
    buffers = []
    for entry in document["buffers"]:
        uri = entry.get("uri")
        if uri is None:
            buffers.append(chunk)
        elif uri.startswith("data:"):
            buffers.append(base64.b64decode(uri.split(",")[1]))
        else:
            buffers.append((path.parent / uri.replace("%20", " ")).read_bytes())
    return document, buffers


def view_bytes(document: dict[str, Any], buffers: list[bytes]) -> list[bytes]:
    """Return the bytes of each bufferView."""
    contents = []
    for view in document.get("bufferViews", []):
        start = view.get("byteOffset", 0)
        contents.append(buffers[view["buffer"]][start : start + view["byteLength"]])
    return contents


# -- parts -----------------------------------------------------------------------------------------


def sphere(radius_m: float = 0.08, level: int = 2) -> tuple[np.ndarray, ...]:
    """Return positions, normals, UVs and faces of a sphere."""
    shape = shapes.sphere("icosphere", level, radius_m)
    u = 0.5 + np.arctan2(shape.normals[:, 1], shape.normals[:, 0]) / (2.0 * np.pi)
    v = np.arccos(np.clip(shape.normals[:, 2], -1.0, 1.0)) / np.pi
    return shape.positions, shape.normals, np.stack([u, v], axis=1), shape.faces


def add_attributes(model: GltfModel, positions, normals, uvs, *_: Any) -> dict[str, int]:
    return {
        "POSITION": model.add_accessor(positions),
        "NORMAL": model.add_accessor(normals),
        "TEXCOORD_0": model.add_accessor(uvs),
    }


def primitive(model: GltfModel, faces: np.ndarray, kind: str = "u2", **attributes: int):
    indices = model.add_accessor(faces.reshape(-1, 1), kind, target=34963)
    return {"attributes": attributes, "indices": indices}


# -- models ----------------------------------------------------------------------------------------


def plain() -> GltfModel:
    """A mesh with indices, a textured material, and a camera."""
    model = empty_model()
    parts = sphere()
    one = primitive(model, parts[3], **add_attributes(model, *parts)) | {"material": 0}
    image = model.add_view(PNG)
    model.document |= {
        "images": [{"bufferView": image, "mimeType": "image/png"}],
        "samplers": [{"wrapS": 33071}],
        "textures": [{"source": 0, "sampler": 0}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}, "name": "skin"}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.01}}],
    }
    model.add_mesh(one, name="ball")
    return model.with_nodes({"mesh": 0}, {"camera": 0, "translation": [0, 0, 1]})


def interleaved() -> GltfModel:
    """All attributes in one view, and 32-bit indices."""
    model = empty_model()
    p, n, t, faces = sphere()
    table = np.concatenate([p, n, t], axis=1).astype("<f4")
    view = model.add_view(table.tobytes(), byteStride=32, target=34962)
    attributes, offset = {}, 0
    for name, values in (("POSITION", p), ("NORMAL", n), ("TEXCOORD_0", t)):
        stored = values.astype("<f4")
        entry = model.add_accessor_entry(stored, "f4", bufferView=view, byteOffset=offset)
        attributes[name] = entry
        offset += 4 * values.shape[1]
    model.add_mesh(primitive(model, faces, "u4", **attributes))
    return model.with_nodes({"mesh": 0})


def skinned() -> GltfModel:
    """A sphere whose skin, in the bind pose, halves the stored positions."""
    model = empty_model()
    parts = sphere(0.16)
    attributes = add_attributes(model, *parts)
    count = len(parts[0])
    attributes["JOINTS_0"] = model.add_accessor(np.tile([0, 1, 0, 0], (count, 1)), "u1")
    attributes["WEIGHTS_0"] = model.add_accessor(np.tile([0.75, 0.25, 0.0, 0.0], (count, 1)))
    inverse = np.tile(np.diag([2.0, 2.0, 2.0, 1.0]), (2, 1, 1))
    inverse[:, 3, 1] = (-1.0, 0.0)  # matrices are stored column by column
    bind = model.add_accessor(inverse.reshape(2, 16), target=None)
    model.document["skins"] = [{"joints": [2, 1], "inverseBindMatrices": bind, "name": "rig"}]
    model.add_mesh(primitive(model, parts[3], **attributes))
    nodes = [
        {"mesh": 0, "skin": 0},
        {"name": "root", "children": [2], "scale": [0.25, 0.25, 0.25]},
        {"name": "tip", "translation": [0, 1, 0]},
    ]
    return model.with_nodes(*nodes, roots=[0, 1])


def morphed() -> GltfModel:
    """Two morph targets, one of them sparse without a base, and an animation of both."""
    model = empty_model()
    parts = sphere()
    one = primitive(model, parts[3], **add_attributes(model, *parts))
    moved = np.zeros_like(parts[0], dtype="<f4")
    moved[5] = (0.0, 0.01, 0.0)
    sparse = {
        "count": 1,
        "indices": {"bufferView": model.add_view(struct.pack("<H", 5)), "componentType": 5123},
        "values": {"bufferView": model.add_view(moved[5].tobytes())},
    }
    one["targets"] = [
        {"POSITION": model.add_accessor(0.1 * parts[0])},
        {"POSITION": model.add_accessor_entry(moved, "f4", sparse=sparse)},
    ]
    model.add_mesh(one, weights=[0.25, 0.0], extras={"targetNames": ["wide", "nose"]})
    times = model.add_accessor(np.array([[0.0], [1.0]]), target=None)
    weights = model.add_accessor(np.array([[0.0], [1.0], [1.0], [0.0]]), target=None)
    turns = model.add_accessor(np.array([[0.0, 0, 0, 1], [0, 1, 0, 0]]), target=None)
    channels = [
        {"sampler": 0, "target": {"node": 0, "path": "weights"}},
        {"sampler": 1, "target": {"node": 0, "path": "rotation"}},
    ]
    samplers = [
        {"input": times, "output": weights, "interpolation": "LINEAR"},
        {"input": times, "output": turns},
    ]
    model.document["animations"] = [{"channels": channels, "samplers": samplers}]
    return model.with_nodes({"mesh": 0, "rotation": [0, 0, 0, 1]})


def sparse() -> GltfModel:
    """A sphere with ten wrong positions in the base, which a sparse accessor corrects."""
    model = empty_model()
    p, n, t, faces = sphere()
    rows = np.arange(3, 103, 10)
    wrong = p.copy()
    wrong[rows] *= 3.0
    attributes = add_attributes(model, wrong, n, t)
    entry = model.document["accessors"][attributes["POSITION"]]
    entry |= {
        "min": p.astype("f4").min(axis=0).tolist(),
        "max": p.astype("f4").max(axis=0).tolist(),
    }
    indices = model.add_view(rows.astype("u1").tobytes())
    entry["sparse"] = {
        "count": len(rows),
        "indices": {"bufferView": indices, "componentType": 5121},
        "values": {"bufferView": model.add_view(p[rows].astype("<f4").tobytes())},
    }
    model.add_mesh(primitive(model, faces, "u1", **attributes))
    return model.with_nodes({"mesh": 0})


def several_primitives() -> GltfModel:
    """A mesh of two primitives that share vertices, lines and points; a mesh of two that do not."""
    model = empty_model()
    parts = sphere()
    attributes, faces = add_attributes(model, *parts), parts[3]
    half = len(faces) // 2
    lines = primitive(model, faces[:4], **attributes) | {"mode": 1}
    points = {"attributes": {"POSITION": attributes["POSITION"]}, "mode": 0}
    first, second = (primitive(model, part, **attributes) for part in (faces[:half], faces[half:]))
    model.add_mesh(first, lines, second, points)
    p, n, t, faces = sphere(0.02, 1)
    halves = []
    for part in (faces[:40], faces[40:]):
        used, compact = np.unique(part, return_inverse=True)
        own = add_attributes(model, p[used], n[used], t[used])
        halves.append(primitive(model, compact, **own))
    model.add_mesh(*halves, radius_mm=20.0)
    return model.with_nodes({"mesh": 0}, {"mesh": 1, "translation": [1, 0, 0]}, {"name": "empty"})


def instances() -> GltfModel:
    """A mesh with two nodes of different scale, and a mesh below a mirroring parent.

    The first node of a mesh defines its unit.
    """
    model = empty_model()
    parts = sphere(0.04)
    one = primitive(model, parts[3], **add_attributes(model, *parts))
    model.add_mesh(one)
    model.add_mesh(dict(one), radius_mm=10.0)
    mirroring = np.diag([-0.5, 0.5, 0.5, 1.0]).T.ravel().tolist()
    nodes = [
        {"mesh": 0, "scale": [2, 2, 2]},
        {"mesh": 0, "scale": [4, 4, 4], "translation": [1, 0, 0]},
        {"children": [3], "matrix": mirroring},
        {"mesh": 1, "scale": [0.5, 0.5, 0.5], "rotation": [0, 0.6, 0, 0.8]},
    ]
    return model.with_nodes(*nodes, roots=[0, 1, 2])


def strips() -> GltfModel:
    """A band around the equator as a strip without indices, and as a strip with indices."""
    model = empty_model()
    around = np.arange(25) * (2.0 * np.pi / 24)
    circles = [
        np.stack(
            [np.cos(h) * np.cos(around), np.cos(h) * np.sin(around), 0 * around + np.sin(h)], 1
        )
        for h in (0.15, -0.15)
    ]
    n = np.stack(circles, axis=1).reshape(-1, 3)
    uvs = np.stack([np.repeat(around / 7.0, 2), np.tile([0.0, 1.0], 25)], axis=1)
    one = {"attributes": add_attributes(model, 0.08 * n, n, uvs), "mode": 5}
    order = model.add_accessor(np.arange(len(n)).reshape(-1, 1), "u1", target=34963)
    model.add_mesh(one)
    model.add_mesh(one | {"indices": order})
    return model.with_nodes({"mesh": 0}, {"mesh": 1})


def fan() -> GltfModel:
    """A cap of a sphere as a triangle fan."""
    model = empty_model()
    around = np.arange(13) * (2.0 * np.pi / 12)
    rim = np.stack([np.cos(around) * 0.3, np.sin(around) * 0.3, 0 * around + np.sqrt(0.91)], axis=1)
    n = np.concatenate([[[0.0, 0.0, 1.0]], rim])
    model.add_mesh({"attributes": add_attributes(model, 0.08 * n, n, n[:, :2]), "mode": 6})
    return model.with_nodes({"mesh": 0})


def positions_only() -> GltfModel:
    """A sphere without indices, normals and UVs: each face has its own three vertices."""
    model = empty_model()
    p, _, _, faces = sphere()
    model.add_mesh({"attributes": {"POSITION": model.add_accessor(p[faces].reshape(-1, 3))}})
    return model.with_nodes({"mesh": 0})


def quantised() -> GltfModel:
    """16-bit positions, 8-bit normals and 16-bit UVs; the scale of the node converts to metres."""
    extensions = ["KHR_mesh_quantization"]
    model = empty_model(extensionsUsed=extensions, extensionsRequired=extensions)
    p, n, t, faces = sphere(1.0)
    attributes = {
        "POSITION": model.add_accessor(np.rint(p * 32000.0), "i2"),
        "NORMAL": model.add_accessor(np.rint(n * 127.0), "i1", normalized=True),
        "TEXCOORD_0": model.add_accessor(np.rint(t * 65535.0), "u2", normalized=True),
    }
    model.add_mesh(primitive(model, faces, **attributes))
    return model.with_nodes({"mesh": 0, "scale": [0.08 / 32000.0] * 3})


def unknown_extensions() -> GltfModel:
    """Unknown extensions and extras at every level, with numbers of every form."""
    unknown = {"VENDOR_freckles": {"density": 1e-9, "seeds": [1, 2**53, -0.5], "on": None}}
    model = empty_model(extensionsUsed=["VENDOR_freckles"], extensions=unknown)
    parts = sphere()
    attributes = add_attributes(model, *parts)
    attributes["_FRECKLES"] = model.add_accessor(parts[2])
    one = primitive(model, parts[3], **attributes)
    one |= {"extras": {"layer": "épiderme ☃"}, "extensions": unknown}
    model.add_mesh(one, extras={"skinshade-like": True}, extensions=unknown, name="tête")
    model.document["accessors"][0]["extras"] = [1, [2.5, {}], "three"]
    model.document["bufferViews"][0] |= {"name": "positions", "extras": {"a": 1}}
    model.document["asset"]["copyright"] = "nobody"
    return model.with_nodes({"mesh": 0, "extras": 7, "extensions": unknown})


BUILDERS = [plain, interleaved, skinned, morphed, sparse, several_primitives, instances, strips]
BUILDERS += [fan, positions_only, quantised, unknown_extensions]
SHAPES: dict[str, Callable[[], GltfModel]] = {build.__name__: build for build in BUILDERS}
FORMS = ("glb", "external", "embedded", "two")
