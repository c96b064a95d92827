"""Honest glTF models of some hundred bytes to a few kilobytes: one for each group of features."""

from __future__ import annotations

import base64
import copy
import json
import struct
from collections.abc import Callable
from importlib.util import find_spec
from typing import Any

import numpy as np

import gltf_shapes

__all__ = ["companions", "glb_files", "gltf_files"]

COLOUR = gltf_shapes.PNG
"""A PNG of one texel."""
TEXTURE, BUFFER = "texture.png", "buffer.bin"


def _ball() -> tuple[Any, ...]:
    """Return positions, normals, UVs and faces of a ball of 12 vertices and 20 faces."""
    return gltf_shapes.sphere(0.08, 0)


def _material(name: str, **more: Any) -> dict[str, Any]:
    return {"name": name, "pbrMetallicRoughness": {"roughnessFactor": 0.5}} | more


def textured() -> Any:
    """Return a model with two materials, their maps, and a transform of texture coordinates."""
    model = gltf_shapes.empty_model()
    parts = _ball()
    attributes = gltf_shapes.add_attributes(model, *parts)
    skin = gltf_shapes.primitive(model, parts[3][:14], **attributes) | {"material": 0}
    hair = gltf_shapes.primitive(model, parts[3][14:], **attributes) | {"material": 1}
    transform = {"KHR_texture_transform": {"scale": [2, 2], "offset": [0.5, 0]}}
    model.document |= {
        "images": [
            {"bufferView": model.add_view(COLOUR), "mimeType": "image/png"},
            {"uri": TEXTURE},
            {"uri": "data:image/png;base64," + base64.b64encode(COLOUR).decode()},
        ],
        "samplers": [{"wrapS": 33071}],
        "textures": [{"source": 0, "sampler": 0}, {"source": 1}, {"source": 2}],
        "materials": [
            _material("skin", normalTexture={"index": 1, "scale": 0.5}),
            _material("hair", alphaMode="MASK", alphaCutoff=0.4),
        ],
        "extensionsUsed": ["KHR_texture_transform"],
    }
    surface = model.document["materials"][0]["pbrMetallicRoughness"]
    surface["baseColorTexture"] = {"index": 0, "texCoord": 0, "extensions": transform}
    surface["metallicRoughnessTexture"] = {"index": 2}
    model.document["materials"][1]["pbrMetallicRoughness"]["baseColorFactor"] = [0.5, 0.4, 0.3, 0.9]
    model.add_mesh(skin, hair, name="ball")
    return model.with_nodes({"mesh": 0}, {"translation": [0, 0, 1], "name": "empty"})


def skinned() -> Any:
    """Return a model that a skin places, below a parent with a scale."""
    model = gltf_shapes.empty_model()
    parts = _ball()
    attributes = gltf_shapes.add_attributes(model, *parts)
    attributes["JOINTS_0"] = model.add_accessor(np.tile([0, 1, 0, 0], (len(parts[0]), 1)), "u1")
    attributes["WEIGHTS_0"] = model.add_accessor(np.tile([0.75, 0.25, 0, 0], (len(parts[0]), 1)))
    inverse = model.add_accessor(np.tile(np.eye(4), (2, 1, 1)).reshape(2, 16), target=None)
    model.document["skins"] = [{"joints": [2, 1], "inverseBindMatrices": inverse}]
    model.add_mesh(gltf_shapes.primitive(model, parts[3], "u1", **attributes))
    nodes = [
        {"mesh": 0, "skin": 0},
        {"children": [2], "scale": [0.5, 0.5, 0.5], "rotation": [0, 0.6, 0, 0.8]},
        {"translation": [0, 1, 0]},
    ]
    return model.with_nodes(*nodes, roots=[0, 1])


def sparse() -> Any:
    """Return a model with a sparse accessor, a morph target and an animation."""
    model = gltf_shapes.empty_model()
    parts = _ball()
    attributes = gltf_shapes.add_attributes(model, *parts)
    moved = np.zeros_like(parts[0], dtype="<f4")
    moved[5] = parts[0][5]
    entry = {
        "count": 1,
        "indices": {"bufferView": model.add_view(struct.pack("<H", 5)), "componentType": 5123},
        "values": {"bufferView": model.add_view(moved[5].tobytes())},
    }
    model.document["accessors"][attributes["POSITION"]]["sparse"] = entry
    one = gltf_shapes.primitive(model, parts[3], **attributes)
    one["targets"] = [{"POSITION": model.add_accessor_entry(moved, "f4", sparse=entry)}]
    model.add_mesh(one, weights=[0.25])
    times = model.add_accessor(np.array([[0.0], [1.0]]), target=None)
    channels = [{"sampler": 0, "target": {"node": 0, "path": "weights"}}]
    samplers = [{"input": times, "output": times, "interpolation": "LINEAR"}]
    model.document["animations"] = [{"channels": channels, "samplers": samplers}]
    return model.with_nodes({"mesh": 0})


def strips() -> Any:
    """Return a strip, a fan with indices, lines and points, without normals and UVs."""
    model = gltf_shapes.empty_model()
    angles = np.arange(9) * 0.7
    rim = np.stack([np.cos(angles), np.sin(angles), np.where(np.arange(9) % 2, 0.3, -0.3)], axis=1)
    position = {"POSITION": model.add_accessor(0.08 * rim)}
    order = model.add_accessor(np.arange(9).reshape(-1, 1), "u4", target=34963)
    model.add_mesh(
        {"attributes": position, "mode": 5},
        {"attributes": position, "mode": 6, "indices": order},
        {"attributes": position, "mode": 1, "indices": order},
        {"attributes": position, "mode": 0},
    )
    return model.with_nodes({"mesh": 0})


def quantised() -> Any:
    """Return a model of integers with strides, two nodes of one mesh, a matrix and a custom attribute."""
    extensions = ["KHR_mesh_quantization"]
    model = gltf_shapes.empty_model(extensionsUsed=extensions, extensionsRequired=extensions)
    p, n, t, faces = gltf_shapes.sphere(1.0, 0)
    attributes = {
        "POSITION": model.add_accessor(np.rint(p * 32000.0), "i2"),
        "NORMAL": model.add_accessor(np.rint(n * 127.0), "i1", normalized=True),
        "TEXCOORD_0": model.add_accessor(np.rint(t * 65535.0), "u2", normalized=True),
        "_REGION": model.add_accessor(np.arange(12).reshape(-1, 1), "f4"),
    }
    model.add_mesh(gltf_shapes.primitive(model, faces, **attributes), extras={"note": [1, "☃"]})
    turned = (np.diag([-0.08, 0.08, 0.08, 1.0]) / np.array([32000.0, 32000.0, 32000.0, 1.0])).T
    nodes = [
        {"mesh": 0, "scale": [0.08 / 32000.0] * 3},
        {"children": [2], "extensions": {"VENDOR_thing": {"a": None}}},
        {"mesh": 0, "matrix": turned.ravel().tolist()},
    ]
    return model.with_nodes(*nodes, roots=[0, 1])


def noted() -> Any:
    """Return a model with the note and the attributes of an earlier bake."""
    model = gltf_shapes.empty_model()
    parts = _ball()
    attributes = gltf_shapes.add_attributes(model, *parts)
    one = gltf_shapes.primitive(model, parts[3], **attributes)
    attributes["_CURVATURE"] = model.add_accessor(np.full((12, 1), 0.0125))
    attributes["_THICKNESS"] = model.add_accessor(np.full((12, 1), 100.0))
    note = {
        "version": "0",
        "unit_mm": 1000.0,
        "profile": "skin-deon2007",
        "uv_scale_mm": 250.0,
        "attributes": {"_CURVATURE": "1/mm", "_THICKNESS": "mm"},
    }
    model.add_mesh(one | {"attributes": attributes}, extras={"skinshade": note})
    return model.with_nodes({"mesh": 0})


def compressed() -> Any:
    """Return a model that Draco has compressed."""
    import DracoPy

    model = gltf_shapes.empty_model()
    p, _, _, faces = _ball()
    data = DracoPy.encode(p, faces=faces, preserve_order=True)
    extension = {"bufferView": model.add_view(data), "attributes": {"POSITION": 0}}
    stored = p.astype("<f4")
    primitive = {
        "attributes": {"POSITION": model.add_accessor_entry(stored, "f4")},
        "indices": model.add_accessor_entry(faces.reshape(-1, 1).astype("<u2"), "u2"),
        "extensions": {"KHR_draco_mesh_compression": extension},
    }
    model.document["extensionsRequired"] = ["KHR_draco_mesh_compression"]
    model.add_mesh(primitive)
    return model.with_nodes({"mesh": 0})


BUILDERS: list[Callable[[], Any]] = [textured, skinned, sparse, strips, quantised, noted]
BUILDERS += [compressed] if find_spec("DracoPy") else []


def glb_files() -> list[bytes]:
    """Return every model as GLB."""
    files = []
    for build in BUILDERS:
        model = build()
        document = model.document | {"buffers": [{"byteLength": len(model.binary)}]}
        files.append(gltf_shapes.pack_glb(document, bytes(model.binary)))
    return files


def companions() -> dict[str, bytes]:
    """Return the files beside every glTF file, to which its URIs can refer."""
    return {TEXTURE: COLOUR, BUFFER: bytes(textured().binary)}


def gltf_files() -> list[bytes]:
    """Return two models as glTF: one with its buffer as data URI, one with `BUFFER` beside it."""
    files = []
    for build, uri in ((quantised, None), (textured, BUFFER)):
        model = build()
        data = bytes(model.binary)
        embedded = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
        document = copy.deepcopy(model.document)
        document["buffers"] = [{"byteLength": len(data), "uri": uri or embedded}]
        files.append(json.dumps(document).encode())
    return files
