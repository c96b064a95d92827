"""Materials of glTF documents: colours, roughness, maps, and the bytes of images."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from typing import Any

from .._core.errors import MeshFileError
from .accessors import view_bytes
from .document import GltfDocument

__all__ = ["AlphaMode", "GltfMaterial", "MapReference", "image_bytes", "read_material"]

AlphaMode = str
"""``OPAQUE``, ``MASK`` or ``BLEND``."""
ALPHA_MODES = ("OPAQUE", "MASK", "BLEND")
TRANSFORM = "KHR_texture_transform"


@dataclass(frozen=True)
class MapReference:
    """Reference of a material to an image.

    Attributes
    ----------
    image
        Index of the image.
    scale, offset
        Factors and offsets of u and v.
    """

    image: int
    scale: tuple[float, float] = (1.0, 1.0)
    offset: tuple[float, float] = (0.0, 0.0)


@dataclass(frozen=True)
class GltfMaterial:
    """Material of metallic-roughness shading [glTF2], without its emission and metalness.

    Attributes
    ----------
    name
        Name in the document; may be empty.
    color
        Linear factor of the base colour and of the opacity, R, G, B, A.
    has_color
        Whether the document states a base colour, as a factor or a map.
    roughness
        Factor of the GGX roughness, 0..1; None if the document does not state it.
    color_map, normal_map, roughness_map
        Images, or None. The roughness is in the green channel.
    normal_strength
        Factor of the slopes of the normal map.
    alpha_mode
        ``OPAQUE``, ``MASK`` or ``BLEND``.
    alpha_cutoff
        Opacity below which ``MASK`` draws nothing.
    """

    name: str
    color: tuple[float, float, float, float] = (1.0, 1.0, 1.0, 1.0)
    has_color: bool = True
    roughness: float | None = None
    color_map: MapReference | None = None
    normal_map: MapReference | None = None
    roughness_map: MapReference | None = None
    normal_strength: float = 1.0
    alpha_mode: AlphaMode = "OPAQUE"
    alpha_cutoff: float = 0.5

    @property
    def given_roughness(self) -> float:
        """Factor of the roughness; 1, the default of glTF, if the document does not state it."""
        return 1.0 if self.roughness is None else self.roughness


def read_material(gltf: GltfDocument, index: int) -> GltfMaterial:
    """Return a material; values that are malformed or out of range are those of a material without them.

    Parameters
    ----------
    gltf
        Document.
    index
        Index of the material; −1 for a mesh without one.

    Raises
    ------
    MeshFileError
        If there is no such material, or a map refers to a texture or image that does not exist.
    """
    if index == -1:
        return GltfMaterial("")
    entry = gltf.item("materials", index, "a primitive")
    surface = _object(entry, "pbrMetallicRoughness")
    mode = entry.get("alphaMode", "OPAQUE")
    color = surface.get("baseColorFactor")
    numbers = color if isinstance(color, list) and len(color) == 4 else [1.0] * 4
    red, green, blue, alpha = (_share(number, 1.0) for number in numbers)
    name = entry.get("name")
    return GltfMaterial(
        name if isinstance(name, str) else "",
        (red, green, blue, alpha),
        not surface.keys().isdisjoint(("baseColorFactor", "baseColorTexture")),
        _share(surface["roughnessFactor"], 1.0) if "roughnessFactor" in surface else None,
        _map(gltf, surface, "baseColorTexture", index),
        _map(gltf, entry, "normalTexture", index),
        _map(gltf, surface, "metallicRoughnessTexture", index),
        _number(_object(entry, "normalTexture").get("scale"), 1.0, 0.0, 10.0),
        mode if mode in ALPHA_MODES else "OPAQUE",
        _share(entry.get("alphaCutoff"), 0.5),
    )


def image_bytes(gltf: GltfDocument, index: int) -> tuple[bytes, str]:
    """Return the bytes of an image and the suffix of its format.

    Raises
    ------
    MeshFileError
        If the image does not exist, or its file is missing or outside the asset's folder.
    """
    entry = gltf.item("images", index, "a texture")
    if "bufferView" in entry:
        data = bytes(view_bytes(gltf, entry["bufferView"], f"image {index}"))
    elif isinstance(entry.get("uri"), str):
        data = gltf.resource(entry["uri"], f"image {index}")
    else:
        raise MeshFileError(f"{gltf.path}: image {index} has neither a uri nor a bufferView")
    return data, _suffix(data)


def _suffix(data: bytes) -> str:
    """Return the suffix of an image's format, by its first bytes."""
    if data[:3] == b"\xff\xd8\xff":
        return ".jpg"
    if data[:4] == b"RIFF" and data[8:12] == b"WEBP":
        return ".webp"
    return ".png"


def _map(gltf: GltfDocument, entry: dict[str, Any], key: str, index: int) -> MapReference | None:
    """Return the reference at a key of a material; None without one, or for a second set of UVs."""
    reference = _object(entry, key)
    if not reference or reference.get("texCoord", 0) != 0:
        return None
    texture = gltf.item("textures", reference.get("index"), f"material {index}: {key}")
    source = texture.get("source")
    if source is None:  # an extension such as WebP may name the image instead
        source = _object(_object(texture, "extensions"), "EXT_texture_webp").get("source")
    if source is None:
        return None
    gltf.item("images", source, f"material {index}: {key}")
    transform = _object(_object(reference, "extensions"), TRANSFORM)
    return MapReference(
        source, _pair(transform.get("scale"), 1.0), _pair(transform.get("offset"), 0.0)
    )


def _object(entry: dict[str, Any], key: str) -> dict[str, Any]:
    value = entry.get(key)
    return value if isinstance(value, dict) else {}


def _pair(value: Any, default: float) -> tuple[float, float]:
    numbers = value if isinstance(value, list) and len(value) == 2 else [default] * 2
    first, second = (_number(number, default, -1e3, 1e3) for number in numbers)
    return first, second


def _share(value: Any, default: float) -> float:
    return _number(value, default, 0.0, 1.0)


def _number(value: Any, default: float, low: float, high: float) -> float:
    """Return a number within a range, or the default for anything else."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return default
    if not abs(value) <= sys.float_info.max:  # not a number, or an integer that is no float
        return default
    return float(min(max(value, low), high))
