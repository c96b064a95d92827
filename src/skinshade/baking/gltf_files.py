"""Files of baked glTF: the bytes of the source, followed by the new attributes."""

from __future__ import annotations

import copy
import hashlib
import re
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path
from typing import Any
from urllib.parse import quote

from .._core.errors import ArgumentError, MeshFileError, OutputError, SkinshadeError
from .._core.files import FileSet
from ..gltf import GLTF_SUFFIXES, GltfDocument, read_gltf
from ..gltf.write import glb_bytes, json_bytes
from .gltf import GltfBake

__all__ = ["COPIED_SUFFIXES", "own_buffers", "write_gltf"]

BUFFERS = (".bin", ".glbin")
IMAGES = (".png", ".jpg", ".jpeg", ".jpe", ".webp", ".avif", ".ktx", ".ktx2", ".basis", ".dds")
FURTHER_IMAGES = (".tga", ".bmp", ".gif", ".tif", ".tiff", ".hdr", ".exr")
COPIED_SUFFIXES = frozenset((*BUFFERS, *IMAGES, *FURTHER_IMAGES))
"""Suffixes of buffers and images. Other files that an asset refers to are not copied."""


def write_gltf(
    files: FileSet,
    gltf: GltfDocument,
    baked: GltfBake,
    output: Path,
    replaceable: Iterable[Path] = (),
) -> None:
    """Add a baked document, its buffer, and copies of the files that it refers to, to a set of files.

    Files that the document refers to are copied if the output is in another folder. The buffer beside a
    ``.gltf`` has the hash of its content in its name: a document and its buffer always fit, also while a
    later bake replaces them.

    Parameters
    ----------
    files
        Set of files that is written together; the document is added last.
    gltf
        Source document.
    baked
        Result of baking it.
    output
        ``.glb`` or ``.gltf``.
    replaceable
        Files that an earlier bake of this asset wrote, and which may be replaced.

    Raises
    ------
    ArgumentError, OutputError, MeshFileError
        If the suffix is neither ``.glb`` nor ``.gltf``, a file cannot be written, a buffer is missing, or a
        file that the document refers to is neither an image nor a buffer, is hidden, or would replace a file.
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
    _copy_files(files, gltf, document, output, {path.resolve() for path in replaceable})
    if to_glb:
        files.add_bytes(output, glb_bytes(document, data, gltf.chunks))
        return
    digest = hashlib.sha256(data).hexdigest()[:16]
    buffer_file = output.with_name(f"{output.stem}.skinshade-{digest}.bin")
    buffers[target]["uri"] = quote(buffer_file.name)
    files.add_bytes(buffer_file, data)
    files.add_bytes(output, json_bytes(document))


def own_buffers(output: Path) -> set[Path]:
    """Return the buffers of former bakes of an output to which the present output does not refer.

    The next bake removes them. Those of the output that it replaces stay, because other programs may have
    read that document and not yet its buffer.
    """
    if output.suffix.lower() != ".gltf":
        return set()
    pattern = re.compile(re.escape(output.stem) + r"\.skinshade-[0-9a-f]{16}\.bin")
    used: set[Path] = set()
    with suppress(SkinshadeError):
        used = {output.parent / name for name in read_gltf(output).external_files()}
    names = {path for path in output.parent.glob("*.bin") if pattern.fullmatch(path.name)}
    return names - used


def _copy_files(
    files: FileSet,
    gltf: GltfDocument,
    document: dict[str, Any],
    output: Path,
    replaceable: set[Path],
) -> None:
    """Add copies of the files that a document refers to; none if the output is in the same folder."""
    target_folder = output.parent.resolve()
    if gltf.path.parent.resolve() == target_folder:
        return
    for name, source in GltfDocument(gltf.path, document).external_files().items():
        if not source.is_file():  # a missing image is not an error
            continue
        hidden = any(part.startswith(".") for part in name.parts)
        if hidden or not {name.suffix.lower(), source.suffix.lower()} <= COPIED_SUFFIXES:
            raise MeshFileError(
                f"{gltf.path}: refers to {name}, which is"
                f" {'a hidden file' if hidden else 'neither an image nor a buffer by its suffix'} and is"
                " not copied; bake the asset into its own folder"
            )
        target = output.parent / name
        if not target.resolve().is_relative_to(target_folder):
            raise OutputError(f"{target}: leads out of the output folder; {source} is not copied")
        content = source.read_bytes()
        if target.exists() and target.resolve() not in replaceable:
            if not target.is_file() or target.read_bytes() != content:
                raise OutputError(
                    f"{target}: exists and differs from {source}, which {gltf.path} refers to; move it, or"
                    " choose another output folder"
                )
            files.keep(target)
            continue
        files.add_bytes(target, content, make_folder=True)
