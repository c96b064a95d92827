"""One asset baked: a file in, a file out."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from pathlib import Path

from .._core.errors import MeshError
from .._core.progress import Progress, silent
from .._core.units import GLTF_UNIT_MM
from ..mesh import Mesh, load_mesh
from ..mesh.readers import GLTF_SUFFIXES
from .analysis import Body, analyse
from .gltf import read_gltf
from .gltf_bake import BakedMesh, bake_gltf, read_scene
from .gltf_write import write_gltf
from .maps import texture_maps, write_maps
from .settings import BakeSettings
from .tables import write_table

__all__ = ["BakedAsset", "bake"]


@dataclass(frozen=True)
class BakedAsset:
    """What came of one asset.

    Attributes
    ----------
    source
        The file.
    written
        Files that were written, the asset itself last.
    meshes
        What was baked.
    """

    source: Path
    written: list[Path]
    meshes: list[BakedMesh] = field(default_factory=list)


def bake(
    source: str | os.PathLike[str],
    output: str | os.PathLike[str],
    settings: BakeSettings | None = None,
    *,
    progress: Progress = silent,
) -> BakedAsset:
    """Write an asset again with what skin shading needs at its vertices.

    Parameters
    ----------
    source
        ``.glb``, ``.gltf``, ``.obj``, ``.ply`` or ``.stl``.
    output
        ``.glb`` or ``.gltf`` of a glTF file, all else of which stays as it is; ``.glb``, ``.ply`` or
        ``.usda``, ``.usdc`` (extra ``usd``) of any file.
    settings
        What is baked.
    progress
        Called with what is being done and how far it is.

    Raises
    ------
    MeshFileError, MeshError, UnitError, ArgumentError, OutputError
        If the file is at fault, its unit unknown, or the place cannot be written.
    """
    settings = settings or BakeSettings()
    file, place = Path(source), Path(output)
    is_gltf = file.suffix.lower() in GLTF_SUFFIXES
    if is_gltf and place.suffix.lower() in GLTF_SUFFIXES:
        gltf = read_gltf(file)
        baked = bake_gltf(gltf, settings, progress)
        maps = _maps(baked.meshes, file, place, settings)
        return BakedAsset(file, maps + write_gltf(gltf, baked, place), baked.meshes)
    mesh = _scene(file, settings) if is_gltf else load_mesh(file, unit_mm=settings.unit_mm)
    body = Body(mesh.positions_mm, mesh.faces, mesh.normals, mesh.uvs)
    analysed = analyse(body, settings, str(file), progress)
    told = BakedMesh(file.stem, mesh.unit_mm, body, analysed, dict(mesh.repairs))
    maps = _maps([told], file, place, settings)
    write_table(place, body, analysed, mesh.unit_mm, settings)
    return BakedAsset(file, [*maps, place], [told])


def _scene(file: Path, settings: BakeSettings) -> Mesh:
    """A glTF scene as one mesh, read as carefully as one that stays glTF."""
    body, unit = read_scene(read_gltf(file), settings), settings.unit_mm or GLTF_UNIT_MM
    return Mesh.checked(
        body.positions_mm / unit,
        body.faces,
        unit_mm=unit,
        normals=body.normals,
        uvs=body.uvs,
        name=str(file),
    )


def _maps(
    meshes: list[BakedMesh], source: Path, output: Path, settings: BakeSettings
) -> list[Path]:
    """Write the maps of every mesh, under its name where there are several."""
    if not settings.map_size:
        return []
    made = []
    for mesh in meshes:  # all of them before the first is written
        try:
            made.append(texture_maps(mesh.body, mesh.analysed, settings.map_size))
        except MeshError as error:
            raise MeshError(f"{source}: mesh {mesh.name}: {error}") from None
    written = []
    for index, maps in enumerate(made):
        stem = output.stem if len(meshes) == 1 else f"{output.stem}-{index}"
        beside = output.with_name(f"{stem}.x")
        written += write_maps(maps, beside, f".{settings.map_format}")
    return written
