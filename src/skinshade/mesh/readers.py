"""Meshes from files of every format: dispatch, units, up axis and baked attributes."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from .._core.arrays import FloatArray
from .._core.errors import MeshFileError, SkinshadeError, UnitError
from .._core.files import existing_file
from .._core.units import GLTF_UNIT_MM, checked_unit_mm
from ..gltf import GLTF_SUFFIXES, TriangleSet, read_gltf, read_scene
from ..gltf.primitives import joined
from .axes import UpAxis, checked_up, turned_to_y_up
from .baked import (
    GLTF_NAMES,
    baked_attributes,
    baked_unit_mm,
    commented_unit_mm,
    gathered_columns,
)
from .model import Mesh
from .obj import read_obj
from .ply import read_ply
from .size import UnitSource, warn_of_size
from .stl import read_stl

__all__ = ["SUFFIXES", "load_mesh"]

READERS = {".obj": read_obj, ".ply": read_ply, ".stl": read_stl}
SUFFIXES = (*GLTF_SUFFIXES, *READERS)
SAME_UNIT = 1e-4
"""Relative difference of units that count as equal: node scales are single precision."""


@dataclass(frozen=True)
class _Part:
    """Triangles of a part of the file, and the length of its unit that the file states, mm."""

    triangles: TriangleSet
    stated_unit_mm: float | None


def load_mesh(path: str | os.PathLike[str], *, unit_mm: float | None = None, up: str = "y") -> Mesh:
    """Read a mesh: all parts of the file as one, placed as the file's scene places them, with y up.

    Parameters
    ----------
    path
        ``.glb``, ``.gltf``, ``.obj``, ``.ply`` or ``.stl``.
    unit_mm
        Length of one unit of the file, mm. It can be left out for glTF, whose unit is the metre, for
        files of `skinshade bake`, and for OBJ and PLY files with a comment such as ``unit_mm 10.0`` (in
        OBJ, before the first statement).
    up
        Up axis of an OBJ, PLY or STL file, ``y`` or ``z``. Files with z up are turned: (x, y, z) becomes
        (x, z, −y). glTF prescribes y.

    Returns
    -------
    Mesh
        UVs have v down, as in glTF, whatever the file's convention. Its attributes are the custom ones of
        glTF, the numbers of the vertices of PLY by their names, ``color`` for the colours of OBJ and PLY
        as the file stores them, and ``curvature``, ``tensor`` and ``thickness`` if the file was baked for
        this unit. Attributes of OBJ and PLY that are not finite are left out, as are UVs that a corner
        lacks; normals that a corner lacks are computed.

    Raises
    ------
    MeshFileError, MeshError, UnitError, ArgumentError
        If the file is missing, corrupt or of another kind, holds no usable triangle, or its unit is
        unknown; if a position is not finite or an index is out of range; if `up` does not apply.

    Warns
    -----
    UnitWarning
        If the unit makes the object smaller than an ear or larger than a person
        (`skinshade.mesh.size.PLAUSIBLE_MM`).

    Examples
    --------
    >>> import skinshade as sk
    >>> from importlib.resources import files
    >>> mesh = sk.load_mesh(files("skinshade") / "heads/assets/head.glb")
    >>> mesh
    Mesh(20560 vertices, 40034 faces, 174.2 × 322 × 213.1 mm, UVs, attributes: _REGION)
    """
    file = existing_file(path, MeshFileError)
    suffix = file.suffix.lower()
    if suffix not in SUFFIXES:
        raise MeshFileError(
            f"{file}: {suffix or 'no suffix'}; a mesh is one of {' '.join(SUFFIXES)}"
        )
    axis = checked_up(up, file)
    given = None if unit_mm is None else checked_unit_mm(unit_mm, str(file))
    is_gltf = suffix in GLTF_SUFFIXES
    parts, notes = _gltf_parts(file) if is_gltf else ([_part(file, axis, given)], {})
    triangles = joined([part.triangles for part in parts])
    stated = _common_unit([part.stated_unit_mm for part in parts])
    unit = given or stated or GLTF_UNIT_MM
    if stated is None or abs(unit / stated - 1.0) > SAME_UNIT:
        # Values that were baked for another unit, or for none that is known, do not hold.
        kept = {k: v for k, v in triangles.attributes.items() if k not in GLTF_NAMES}
        triangles = replace(triangles, attributes=kept)
    try:
        mesh = Mesh.checked(
            triangles.positions,
            triangles.faces,
            unit_mm=unit,
            normals=triangles.normals,
            uvs=triangles.uvs,
            attributes={name: _narrow(v) for name, v in triangles.attributes.items()},
            materials=triangles.materials,
            name=str(file),
        )
    except SkinshadeError as error:
        raise type(error)(str(error)) from None
    mesh = replace(mesh, repairs={**notes, **mesh.repairs})
    source: UnitSource = "given" if given else "baked" if stated else "format"
    warn_of_size(np.ptp(mesh.positions_mm, axis=0), file, unit, source)
    return mesh


def _narrow(values: FloatArray) -> FloatArray:
    """Return a column (V, 1) as (V,)."""
    return values[:, 0] if values.ndim == 2 and values.shape[1] == 1 else values


def _common_unit(units: Sequence[float | None]) -> float | None:
    """Return the unit that the file states for every part, or None if they differ or one is missing."""
    known = [unit for unit in units if unit is not None]
    if len(known) < len(units) or max(known) > min(known) * (1.0 + SAME_UNIT):
        return None
    return known[0]


def _gltf_parts(file: Path) -> tuple[list[_Part], dict[str, int]]:
    """Return the parts of a file, and counts of meshes that are skipped."""
    gltf = read_gltf(file)
    parts = []
    scene, notes = read_scene(gltf, custom=True)
    for placed in scene:
        extras = gltf.items("meshes")[placed.mesh].get("extras")
        note = extras.get("skinshade") if isinstance(extras, dict) else None
        unit = baked_unit_mm(note, placed.matrix)
        triangles = placed.triangles
        if unit is not None:
            baked = baked_attributes(triangles.attributes, placed.matrix)
            triangles = replace(triangles, attributes={**triangles.attributes, **baked})
        parts.append(_Part(triangles, unit))
    return parts, notes


def _part(file: Path, up: UpAxis, unit_mm: float | None) -> _Part:
    """Return the triangles of an OBJ, PLY or STL file with y up, and the unit that a comment states.

    A comment that states no valid unit is an error if no unit is given; otherwise it is ignored.
    """
    triangles, comments = READERS[file.suffix.lower()](file)
    try:
        stated = commented_unit_mm(comments, str(file))
    except UnitError:
        if unit_mm is None:
            raise
        stated = None
    if unit_mm is None and stated is None:
        raise UnitError(f"{file}: states no unit; give unit_mm (1 mm, 10 cm, 1000 m)")
    triangles = replace(triangles, attributes=gathered_columns(triangles.attributes))
    return _Part(turned_to_y_up(triangles) if up == UpAxis.Z else triangles, stated)
