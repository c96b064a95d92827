"""A baked glTF file on disk: every byte that came, and the new ones behind them."""

from __future__ import annotations

import copy
import itertools
from pathlib import Path
from typing import Any
from urllib.parse import quote

from .._core.errors import ArgumentError
from .._core.files import atomic_write
from ..mesh.readers import GLTF_SUFFIXES
from .gltf import GltfFile, glb_bytes, json_bytes
from .gltf_bake import GltfBake

__all__ = ["write_gltf"]


def write_gltf(gltf: GltfFile, baked: GltfBake, output: Path) -> list[Path]:
    """Write a file, and beside it what it refers to if it moves to another folder.

    Parameters
    ----------
    gltf
        What it was made of.
    baked
        What was made of it.
    output
        ``.glb`` or ``.gltf``.

    Returns
    -------
    list
        The files written, the document last.

    Raises
    ------
    ArgumentError, OutputError, MeshFileError
        If the suffix is another, a place cannot be written, or a file referred to is not there.
    """
    suffix = output.suffix.lower()
    if suffix not in GLTF_SUFFIXES:
        raise ArgumentError(f"{output}: suffix {output.suffix!r}; a glTF file stays .glb or .gltf")
    document = copy.deepcopy(baked.document)
    buffers: list[dict[str, Any]] = document.setdefault("buffers", [])
    to_binary, inside = suffix == ".glb", gltf.binary is not None
    first = b""
    if buffers and (to_binary or inside):
        # The one buffer that a GLB carries must be the first.
        first, at = gltf.buffer(0, "the file"), 0
        buffers[0].pop("uri", None)
    else:
        at = len(buffers)
        buffers.append({})
    start = -(-len(first) // 4) * 4
    data = first + b"\0" * (start - len(first)) + baked.added
    buffers[at]["byteLength"] = len(data)
    for view in document["bufferViews"][len(gltf.items("bufferViews")) :]:
        view |= {"buffer": at, "byteOffset": view["byteOffset"] + start}
    contents: dict[Path, bytes] = _carried(gltf, document, output)
    if to_binary:
        contents[output] = glb_bytes(document, data, gltf.chunks)
    else:
        beside = _new_file(output, document, gltf)
        buffers[at]["uri"] = quote(beside.name)
        contents |= {beside: data, output: json_bytes(document)}
    for path, content in contents.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        with atomic_write(path) as temporary:
            temporary.write_bytes(content)
    return list(contents)


def _new_file(output: Path, document: dict[str, Any], gltf: GltfFile) -> Path:
    """A name for the new buffer that no other buffer or image bears, such as those of a bake before."""
    taken = {str(each) for each in GltfFile(gltf.path, document).external_files()}
    names = (f"{output.stem}.skinshade{number or ''}.bin" for number in itertools.count())
    return output.with_name(next(name for name in names if name not in taken))


def _carried(gltf: GltfFile, document: dict[str, Any], output: Path) -> dict[Path, bytes]:
    """Files that the document still refers to, where it moves to another folder."""
    here, there = gltf.path.parent.resolve(), output.parent.resolve()
    if here == there:
        return {}
    left = GltfFile(gltf.path, document)
    found = {}
    for relative in left.external_files():
        source = here / relative
        if source.is_file():  # an image that is missing was missing before
            found[output.parent / relative] = source.read_bytes()
    return found
