"""Texture maps of curvature, thickness and UV density, for engines that drop custom attributes."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from .._core.arrays import FloatArray
from .._core.errors import ArgumentError, MeshError, OutputError, SkinshadeError
from .._core.files import FileSet
from .._core.pixels import read_description, write_pixels
from ..mesh import Mesh
from ..mesh.topology import face_areas
from ..rendering.prepare.rasterizer import rasterize
from .analysis import Analysis

__all__ = ["texture_maps", "write_maps"]

PNG_STEPS = 65535.0
UNITS = {"curvature": "1/mm", "thickness": "mm", "uv_density": "mm"}


def texture_maps(mesh: Mesh, analysis: Analysis, size: int) -> dict[str, FloatArray]:
    """Return maps (size, size) by name: ``curvature`` 1/mm, ``thickness`` mm, ``uv_density`` mm.

    UV density is the length of one unit of UV on the surface. Texels that no face covers take the value
    of the nearest covered texel, so that filters and mips read no empty texels. Faces outside the tile
    0..1 are moved into it; where faces overlap, the map contains one of them.

    Raises
    ------
    MeshError, ArgumentError
        If the mesh has no UVs that span an area, or the size is out of range.
    """
    from scipy.ndimage import distance_transform_edt  # costs .2 s

    if not 4 <= size <= 16384:
        raise ArgumentError(f"map size is {size}; it must be 4..16384 texels")
    if mesh.uvs is None:
        raise MeshError("maps: the mesh has no UVs; unwrap it first")
    corners = mesh.uvs[mesh.faces]
    corners = corners - np.floor(corners.min(axis=1, keepdims=True) + 1e-6)
    clip = np.ones((corners.shape[0] * 3, 4))
    clip[:, :2] = (2.0 * corners.reshape(-1, 2) - 1.0) * (1.0, -1.0)
    separate = np.arange(len(clip)).reshape(-1, 3)
    fragments = rasterize(clip, separate, (size, size))
    if not fragments.pixel.size:
        raise MeshError("maps: no face spans a texel of the map; unwrap the mesh first")
    vertices = mesh.faces[fragments.face]
    area = face_areas(mesh.positions_mm, mesh.faces)
    density = np.sqrt(area / np.maximum(_areas(corners), 1e-18))
    covered = {"uv_density": density[fragments.face]}
    for name in ("curvature", "thickness"):
        if name in analysis.attributes:
            values = analysis.attributes[name][:, 0]
            covered[name] = np.einsum("nk,nk->n", values[vertices], fragments.barycentric)
    empty = np.ones(size * size, dtype=bool)
    empty[fragments.pixel] = False
    nearest = distance_transform_edt(
        empty.reshape(size, size), return_distances=False, return_indices=True
    )
    maps = {}
    for name, values in covered.items():
        flat = np.zeros(size * size)
        flat[fragments.pixel] = values
        maps[name] = flat.reshape(size, size)[tuple(nearest)]
    return maps


def write_maps(
    files: FileSet,
    maps: Mapping[str, FloatArray],
    base: Path,
    suffix: str,
    index: int | None = None,
) -> None:
    """Add maps to a set of files: EXR in their units, or 16-bit PNG scaled to their range.

    A map is called ``<base>.<name>.exr``, or ``<base>.<name>.<index>.exr`` for one of several meshes. The
    number comes last, so that no asset with another name has a map of this name. The metadata of a PNG state
    the range: ``value_low`` and ``value_span``.

    Parameters
    ----------
    files
        Set of files that is written together.
    maps
        Maps by name, from `texture_maps`.
    base
        Path of the asset without its suffix.
    suffix
        ``.exr`` or ``.png``.
    index
        Number of the mesh; None if the asset has one mesh.

    Raises
    ------
    ArgumentError, OutputError
        If the suffix is neither ``.exr`` nor ``.png``, a file cannot be written, or an image that is no map
        of skinshade has the name of a map.
    """
    if suffix not in (".exr", ".png"):
        raise ArgumentError(f"map suffix is {suffix!r}; it must be .exr or .png")
    ending = suffix if index is None else f".{index}{suffix}"
    for name, values in maps.items():
        path = base.with_name(f"{base.name}.{name}{ending}")
        _refuse_foreign_image(path)
        description = {"kind": name, "unit": UNITS[name]}
        if suffix == ".exr":
            pixels = np.repeat(values[..., None], 3, axis=2).astype(np.float32)
            write_pixels(path, pixels, json.dumps(description), files)
        else:
            low, span = float(values.min()), float(np.ptp(values)) or 1.0
            steps = np.rint((values - low) / span * PNG_STEPS).astype(np.uint16)
            ranged = description | {"value_low": low, "value_span": span}
            write_pixels(path, np.repeat(steps[..., None], 3, axis=2), json.dumps(ranged), files)


def _refuse_foreign_image(path: Path) -> None:
    """Raise if a file has the name of a map and is no map of skinshade."""
    if not path.exists():
        return
    try:
        description = json.loads(read_description(path))
    except (SkinshadeError, ValueError):
        description = None
    if not isinstance(description, dict) or description.get("kind") not in UNITS:
        raise OutputError(
            f"{path}: exists and is no map of skinshade; move it, or choose another output"
        )


def _areas(corners: FloatArray) -> FloatArray:
    """Return the areas (F,) of triangles (F, 3, 2)."""
    a, b = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    return 0.5 * np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])
