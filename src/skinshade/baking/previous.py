"""Removal of the attributes of an earlier bake, so that a new bake does not append to them."""

from __future__ import annotations

import copy
from collections.abc import Container, Iterator
from dataclasses import dataclass
from typing import Any

from ..gltf import GltfDocument
from ..mesh.baked import GLTF_NAMES

__all__ = ["without_bake"]

NAMES = frozenset(name for parts in GLTF_NAMES.values() for name, _ in parts)
"""Names of the attributes that a bake adds to primitives."""
ACCESSOR_KEYS = ("indices", "input", "output", "inverseBindMatrices")
"""Keys whose values are indices of accessors, besides those of attributes and morph targets."""


def without_bake(gltf: GltfDocument) -> GltfDocument:
    """Return a document as it was before an earlier bake; the same document if it was not baked.

    A bake appends accessors, bufferViews and bytes. They are removed from the end, as long as nothing else
    refers to them. In a document that another program has rearranged since, some may remain unused.

    Parameters
    ----------
    gltf
        Document, which is not changed.

    Raises
    ------
    MeshFileError
        If an array of the document is malformed, or the buffer of the attributes cannot be read.
    """
    for key in ("meshes", "accessors", "bufferViews", "buffers"):
        gltf.items(key)  # an array of objects
    document = copy.deepcopy(gltf.json)
    accessors = {index for mesh in document.get("meshes", []) for index in _remove_note(mesh)}
    if not accessors:
        return gltf
    end = _remove_accessors(document, accessors)
    unchanged = GltfDocument(gltf.path, document, gltf.binary, gltf.chunks)
    buffers = document.get("buffers", [])
    if end is None or end.buffer >= len(buffers):
        return unchanged
    if end.start == 0 and end.buffer == len(buffers) - 1:
        buffers.pop()
        return GltfDocument(gltf.path, document, gltf.binary if end.buffer else None, gltf.chunks)
    if end.buffer > 0:  # a bake extends the first buffer only
        return unchanged
    binary = gltf.buffer(0, "the file")[: end.start]
    buffers[0]["byteLength"] = len(binary)
    buffers[0].pop("uri", None)
    return GltfDocument(gltf.path, document, binary, gltf.chunks)


@dataclass(frozen=True)
class _End:
    """Bytes at the end of a buffer that are removed: the buffer, and the offset of the first byte."""

    buffer: int
    start: int


def _remove_note(mesh: dict[str, Any]) -> Iterator[int]:
    """Remove the note and the attributes of a bake from a mesh, and yield the accessors of the attributes."""
    extras = mesh.get("extras")
    if not isinstance(extras, dict) or not isinstance(extras.pop("skinshade", None), dict):
        return
    if not extras:
        del mesh["extras"]
    for attributes in _objects(mesh.get("primitives"), "attributes"):
        for name in NAMES & attributes.keys():
            index = attributes.pop(name)
            if isinstance(index, int):
                yield index


def _remove_accessors(document: dict[str, Any], accessors: set[int]) -> _End | None:
    """Remove accessors and their bufferViews from the end of their lists.

    Returns
    -------
    _End or None
        Bytes to which no bufferView refers any more; None if nothing can be removed.
    """
    table, views = document.get("accessors", []), document.get("bufferViews", [])
    used = set(_numbers(document, ACCESSOR_KEYS))
    for attributes in _objects(document, "attributes"):
        used.update(value for value in attributes.values() if isinstance(value, int))
    for targets in _objects(document, "targets"):
        used.update(value for value in targets.values() if isinstance(value, int))
    while table and len(table) - 1 in accessors - used:
        table.pop()
    used_views = set(_numbers(document, ("bufferView",)))
    removed: list[dict[str, Any]] = []
    while views and len(views) - 1 not in used_views and views[-1].get("target") is not None:
        removed.append(views.pop())
    buffers: set[Any] = {view.get("buffer") for view in removed}
    numbers = [
        view.get(key, 0) for view in (*removed, *views) for key in ("byteOffset", "byteLength")
    ]
    if len(buffers) != 1 or not all(isinstance(number, int) for number in (*buffers, *numbers)):
        return None
    buffer = int(buffers.pop())
    start = min(view.get("byteOffset", 0) for view in removed)
    kept = [view for view in views if view.get("buffer") == buffer]
    ends = [view.get("byteOffset", 0) + view.get("byteLength", 0) for view in kept]
    return _End(buffer, start) if 0 <= max(ends, default=0) <= start else None


def _objects(value: Any, name: str) -> Iterator[dict[str, Any]]:
    """Yield every object at the key `name` in a part of a document, or in an array at this key."""
    if not isinstance(value, (dict, list)):
        return
    for key, entry in value.items() if isinstance(value, dict) else enumerate(value):
        if key == name:
            yield from (item for item in _listed(entry) if isinstance(item, dict))
        if isinstance(entry, (dict, list)):
            yield from _objects(entry, name)


def _numbers(value: Any, names: Container[str]) -> Iterator[int]:
    """Yield every whole number at one of the keys `names` in a part of a document."""
    for key, entry in value.items() if isinstance(value, dict) else enumerate(value):
        if isinstance(entry, int) and key in names:
            yield entry
        if isinstance(entry, (dict, list)):
            yield from _numbers(entry, names)


def _listed(value: Any) -> list[Any]:
    return value if isinstance(value, list) else [value]
