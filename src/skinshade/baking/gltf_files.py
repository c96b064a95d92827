"""Files of baked glTF: the bytes of the source, followed by the new attributes."""

from __future__ import annotations

import copy
import itertools
from pathlib import Path
from typing import Any
from urllib.parse import quote

from .._core.errors import ArgumentError
from .._core.files import atomic_write
from ..gltf import GLTF_SUFFIXES, GltfDocument
from ..gltf.write import glb_bytes, json_bytes
from .gltf import GltfBake

__all__ = ["write_gltf"]


def write_gltf(gltf: GltfDocument, baked: GltfBake, output: Path) -> list[Path]:
    """Write a baked document, and copy the files that it refers to if it is written to another folder.

    Parameters
    ----------
    gltf
        Source document.
    baked
        Result of baking it.
    output
        ``.glb`` or ``.gltf``.

    Returns
    -------
    list
        Files that were written, the document last.

    Raises
    ------
    ArgumentError, OutputError, MeshFileError
        If the suffix is neither ``.glb`` nor ``.gltf``, a file cannot be written, or a buffer is missing.
    """
    suffix = output.suffix.lower()
    if suffix not in GLTF_SUFFIXES:
        raise ArgumentError(
            f"{output}: suffix {output.suffix!r}; baked glTF is written as .glb or .gltf"
        )
    document = copy.deepcopy(baked.json)
    buffers: list[dict[str, Any]] = document.setdefault("buffers", [])
    to_glb, from_glb = suffix == ".glb", gltf.binary is not None
    source_bytes = b""
    if buffers and (to_glb or from_glb):
        # The buffer of a GLB must be the first one.
        source_bytes, target = gltf.buffer(0, "the file"), 0
        buffers[0].pop("uri", None)
    else:
        target = len(buffers)
        buffers.append({})
    start = -(-len(source_bytes) // 4) * 4
    data = source_bytes + b"\0" * (start - len(source_bytes)) + baked.data
    buffers[target]["byteLength"] = len(data)
    for view in document["bufferViews"][len(gltf.items("bufferViews")) :]:
        view |= {"buffer": target, "byteOffset": view["byteOffset"] + start}
    contents: dict[Path, bytes] = _referred_files(gltf, document, output)
    if to_glb:
        contents[output] = glb_bytes(document, data, gltf.chunks)
    else:
        buffer_file = _unused_name(output, document, gltf)
        buffers[target]["uri"] = quote(buffer_file.name)
        contents |= {buffer_file: data, output: json_bytes(document)}
    for path, content in contents.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        with atomic_write(path) as temporary:
            temporary.write_bytes(content)
    return list(contents)


def _unused_name(output: Path, document: dict[str, Any], gltf: GltfDocument) -> Path:
    """Return a path for the new buffer that no buffer or image of the document uses."""
    used = {str(file) for file in GltfDocument(gltf.path, document).external_files()}
    names = (f"{output.stem}.skinshade{number or ''}.bin" for number in itertools.count())
    return output.with_name(next(name for name in names if name not in used))


def _referred_files(
    gltf: GltfDocument, document: dict[str, Any], output: Path
) -> dict[Path, bytes]:
    """Return the files that a document refers to, by their new paths; none in the same folder."""
    source_folder, target_folder = gltf.path.parent.resolve(), output.parent.resolve()
    if source_folder == target_folder:
        return {}
    return {
        output.parent / relative: (source_folder / relative).read_bytes()
        for relative in GltfDocument(gltf.path, document).external_files()
        if (source_folder / relative).is_file()  # missing images are not an error
    }
