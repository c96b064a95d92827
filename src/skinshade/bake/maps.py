"""Curvature, thickness and UV density as texture maps, for engines without attributes of their own."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
from scipy.ndimage import distance_transform_edt

from .._core.arrays import FloatArray
from .._core.errors import ArgumentError, MeshError
from .._core.pixels import write_pixels
from ..mesh.topology import face_areas
from ..render.cpu.raster import rasterize
from .analysis import Analysed, Body

__all__ = ["texture_maps", "write_maps"]

PNG_STEPS = 65535.0
UNITS = {"curvature": "1/mm", "thickness": "mm", "uv_density": "mm"}


def texture_maps(body: Body, analysed: Analysed, size: int) -> dict[str, FloatArray]:
    """Return maps (size, size) by name: ``curvature`` 1/mm, ``thickness`` mm, ``uv_density`` mm.

    UV density is the length on the surface of the unit of UV. Texels that no face covers take the
    nearest covered one's value, so that filters and mips find no border. Faces in other tiles than 0..1
    are moved there; of faces that overlap one is seen.

    Raises
    ------
    MeshError, ArgumentError
        If the body has no UVs that span an area, or the size is out of range.
    """
    if not 4 <= size <= 16384:
        raise ArgumentError(f"maps are {size} texels wide; it must be 4..16384")
    if body.uvs is None or not np.isfinite(body.uvs).all():
        raise MeshError("maps: the mesh has no UVs; unwrap it first")
    corners = body.uvs[body.faces]
    corners = corners - np.floor(corners.min(axis=1, keepdims=True) + 1e-6)
    clip = np.ones((corners.shape[0] * 3, 4))
    clip[:, :2] = (2.0 * corners.reshape(-1, 2) - 1.0) * (1.0, -1.0)
    alone = np.arange(len(clip)).reshape(-1, 3)
    found = rasterize(clip, alone, (size, size))
    if not found.pixel.size:
        raise MeshError("maps: no face spans a texel of the map; unwrap the mesh first")
    at = body.faces[found.face]

    def spread(values: FloatArray) -> FloatArray:
        return np.einsum("nk,nk->n", values[at], found.barycentric)

    density = np.sqrt(
        face_areas(body.positions_mm, body.faces) / np.maximum(_areas(corners), 1e-18)
    )
    covered = {"uv_density": density[found.face]}
    for name in ("curvature", "thickness"):
        if name in analysed.attributes:
            covered[name] = spread(analysed.attributes[name][:, 0])
    empty = np.ones(size * size, dtype=bool)
    empty[found.pixel] = False
    nearest = distance_transform_edt(
        empty.reshape(size, size), return_distances=False, return_indices=True
    )
    maps = {}
    for name, values in covered.items():
        flat = np.zeros(size * size)
        flat[found.pixel] = values
        maps[name] = flat.reshape(size, size)[tuple(nearest)]
    return maps


def write_maps(maps: dict[str, FloatArray], beside: Path, suffix: str) -> list[Path]:
    """Write maps as ``<stem>.<name>.exr`` in their units, or as ``.png`` of 16 bits over their range.

    The range stands in the PNG's metadata: ``value_low`` and ``value_span``.

    Raises
    ------
    ArgumentError, OutputError
        If the suffix is another, or the place cannot be written.
    """
    if suffix not in (".exr", ".png"):
        raise ArgumentError(f"maps are {suffix!r}; it must be .exr or .png")
    written = []
    for name, values in maps.items():
        path = beside.with_name(f"{beside.stem}.{name}{suffix}")
        told = {"kind": name, "unit": UNITS[name]}
        if suffix == ".exr":
            pixels = np.repeat(values[..., None], 3, axis=2).astype(np.float32)
            write_pixels(path, pixels, json.dumps(told))
        else:
            low, span = float(values.min()), float(np.ptp(values)) or 1.0
            steps = np.rint((values - low) / span * PNG_STEPS).astype(np.uint16)
            ranged = told | {"value_low": low, "value_span": span}
            write_pixels(path, np.repeat(steps[..., None], 3, axis=2), json.dumps(ranged))
        written.append(path)
    return written


def _areas(corners: FloatArray) -> FloatArray:
    one, other = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    return 0.5 * np.abs(one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0])
