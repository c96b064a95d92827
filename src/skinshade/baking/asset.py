"""Baking of one asset, from a file to a file."""

from __future__ import annotations

import os
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from .._core.errors import ArgumentError, MeshError, OutputError
from .._core.files import FileSet, atomic_files, remove_dead_files
from .._core.processes import output_lock
from .._core.progress import Progress, silent
from .._core.units import GLTF_UNIT_MM
from ..gltf import GLTF_SUFFIXES, read_gltf
from ..mesh import load_mesh
from ..mesh.axes import checked_up
from ..mesh.size import warn_of_size
from .analysis import BakedMesh, analyse
from .formats import write_mesh
from .gltf import bake_gltf
from .gltf_files import own_buffers, write_gltf
from .previous import without_bake
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
        Files that were written, the asset itself last. A file that the asset refers to and that has the
        right content already counts as written.
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
    in_place: bool = False,
    replaceable: Iterable[Path] = (),
    progress: Progress = silent,
) -> BakedAsset:
    """Write a copy of an asset with the vertex attributes that skin shading needs.

    All files are complete before the first one is replaced, and the asset is replaced last. An asset that was
    baked before gets new attributes in place of the old ones.

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
    in_place
        Whether `output` may be the source itself, which must be glTF.
    replaceable
        Files that an earlier bake of this asset wrote. Other files beside the output that have the name of a
        texture or buffer of the asset, and another content, are errors.
    progress
        Called with the name of the work and the fraction that is done.

    Raises
    ------
    MeshFileError, MeshError, UnitError, ArgumentError, OutputError
        If the source is faulty, its unit is unknown, a setting is not allowed, the output cannot be written,
        another process writes it, or another file would be replaced.

    Warns
    -----
    UnitWarning
        If the unit makes the asset smaller than an ear or larger than a person, as in
        `skinshade.load_mesh`.

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
    _check_target(file, target, in_place)
    remove_dead_files([target.parent])
    with output_lock(target), atomic_files() as files:
        outdated = own_buffers(target)
        meshes = _bake(files, file, target, settings, replaceable, progress)
        files.replace_targets()
        for buffer in outdated - set(files.written):
            with suppress(OSError):
                buffer.unlink()
    return BakedAsset(file, files.written, meshes)


def _bake(
    files: FileSet,
    file: Path,
    target: Path,
    settings: BakeSettings,
    replaceable: Iterable[Path],
    progress: Progress,
) -> list[BakedMesh]:
    """Add the files of a baked asset to a set, and return its meshes."""
    up = checked_up(settings.up, file)
    is_gltf = file.suffix.lower() in GLTF_SUFFIXES
    if is_gltf and target.suffix.lower() in GLTF_SUFFIXES:
        gltf = without_bake(read_gltf(file))
        baked = bake_gltf(gltf, settings, progress)
        if baked.extent_mm.any():
            unit_mm, is_given = settings.unit_mm or GLTF_UNIT_MM, settings.unit_mm is not None
            warn_of_size(baked.extent_mm, file, unit_mm, "given" if is_given else "format")
        _add_maps(files, baked.meshes, file, target, settings)
        write_gltf(files, gltf, baked, target, replaceable)
        return baked.meshes
    mesh = load_mesh(file, unit_mm=settings.unit_mm, up=up)
    result = BakedMesh(file.stem, mesh, analyse(mesh, settings, str(file), progress))
    _add_maps(files, [result], file, target, settings)
    write_mesh(files, target, mesh, result.analysis, settings)
    return [result]


def _check_target(file: Path, target: Path, in_place: bool) -> None:
    """Raise if the folder of an output is missing, or the output is the source and must not be."""
    try:
        if not target.parent.is_dir():
            raise OutputError(f"{target}: the folder {target.parent} does not exist")
        same = target.exists() and file.exists() and target.samefile(file)
    except (OSError, ValueError) as error:  # a name that is too long, or has a NUL
        raise OutputError(f"{target}: not the name of a file ({error})") from None
    if same and not in_place:
        raise ArgumentError(
            f"{target}: is the source itself; choose another output, or allow it with --in-place"
        )
    if same and file.suffix.lower() not in GLTF_SUFFIXES:
        raise ArgumentError(f"{file}: only glTF can be baked in place; other formats lose content")


def _add_maps(
    files: FileSet, meshes: list[BakedMesh], source: Path, output: Path, settings: BakeSettings
) -> None:
    """Add the maps of every mesh to a set of files; the maps of several meshes are numbered."""
    if not settings.map_size:
        return
    from .maps import texture_maps, write_maps  # imports the renderer, which costs .2 s

    maps = []
    for baked in meshes:  # all maps are computed before the first one is written
        try:
            maps.append(texture_maps(baked.mesh, baked.analysis, settings.map_size))
        except MeshError as error:
            raise MeshError(f"{source}: mesh {baked.name}: {error}") from None
    for index, images in enumerate(maps):
        number = None if len(meshes) == 1 else index
        write_maps(files, images, output.with_suffix(""), f".{settings.map_format}", number)
