"""Baking of one asset, from a file to a file."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

from .._core.errors import MeshError
from .._core.progress import Progress, silent
from ..gltf import GLTF_SUFFIXES, read_gltf
from ..mesh import load_mesh
from .analysis import BakedMesh, analyse
from .formats import write_mesh
from .gltf import bake_gltf
from .gltf_files import write_gltf
from .maps import texture_maps, write_maps
from .settings import BakeSettings

__all__ = ["BakedAsset", "bake"]


@dataclass(frozen=True)
class BakedAsset:
    """Result of baking one asset.

    Attributes
    ----------
    source
        File that was read.
    written
        Files that were written, the asset itself last.
    meshes
        Meshes that were baked.
    """

    source: Path
    written: list[Path]
    meshes: list[BakedMesh]


def bake(
    source: str | os.PathLike[str],
    output: str | os.PathLike[str],
    settings: BakeSettings | None = None,
    *,
    progress: Progress = silent,
) -> BakedAsset:
    """Write a copy of an asset with the vertex attributes that skin shading needs.

    Parameters
    ----------
    source
        ``.glb``, ``.gltf``, ``.obj``, ``.ply`` or ``.stl``.
    output
        A glTF source that is written as ``.glb`` or ``.gltf`` keeps all its other content. Other sources
        and formats are written as one mesh: ``.glb``, ``.ply``, or ``.usda`` and ``.usdc`` with the extra
        ``usd``.
    settings
        Attributes to bake; the mean curvature by default.
    progress
        Called with the name of the work and the fraction that is done.

    Raises
    ------
    MeshFileError, MeshError, UnitError, ArgumentError, OutputError
        If the source is faulty, its unit is unknown, a setting is not allowed, or the output cannot be
        written.

    Examples
    --------
    >>> import skinshade as sk
    >>> from importlib.resources import files
    >>> asset = sk.bake(files("skinshade") / "heads/assets/head.glb", "baked.glb")
    >>> [mesh.name for mesh in asset.meshes], [path.name for path in asset.written]
    (['head'], ['baked.glb'])
    """
    settings = settings or BakeSettings()
    file, target = Path(source), Path(output)
    is_gltf = file.suffix.lower() in GLTF_SUFFIXES
    if is_gltf and target.suffix.lower() in GLTF_SUFFIXES:
        gltf = read_gltf(file)
        baked = bake_gltf(gltf, settings, progress)
        maps = _write_maps(baked.meshes, file, target, settings)
        return BakedAsset(file, maps + write_gltf(gltf, baked, target), baked.meshes)
    mesh = load_mesh(file, unit_mm=settings.unit_mm)
    result = BakedMesh(file.stem, mesh, analyse(mesh, settings, str(file), progress))
    maps = _write_maps([result], file, target, settings)
    write_mesh(target, mesh, result.analysis, settings)
    return BakedAsset(file, [*maps, target], [result])


def _write_maps(
    meshes: list[BakedMesh], source: Path, output: Path, settings: BakeSettings
) -> list[Path]:
    """Write the maps of every mesh; several meshes are numbered."""
    if not settings.map_size:
        return []
    maps = []
    for baked in meshes:  # all maps are computed before the first one is written
        try:
            maps.append(texture_maps(baked.mesh, baked.analysis, settings.map_size))
        except MeshError as error:
            raise MeshError(f"{source}: mesh {baked.name}: {error}") from None
    written = []
    for index, images in enumerate(maps):
        stem = output.stem if len(meshes) == 1 else f"{output.stem}-{index}"
        written += write_maps(images, output.with_name(stem), f".{settings.map_format}")
    return written
