"""Heads from files."""

from __future__ import annotations

import os
from dataclasses import replace

from .._core.errors import ArgumentError
from ..mesh import load_mesh
from ..scene import Material
from ..scene.images import read_linear
from ..scene.maps import read_normal_map
from .head import Head

__all__ = ["load_head"]


def load_head(
    path: str | os.PathLike[str],
    *,
    unit_mm: float | None = None,
    albedo: str | os.PathLike[str] | None = None,
    normal_map: str | os.PathLike[str] | None = None,
    flip_v: bool = False,
) -> Head:
    """Return a head from a model and its maps.

    Parameters
    ----------
    path, unit_mm
        File and unit of the mesh, as in `skinshade.load_mesh`.
    albedo, normal_map
        Images for the mesh's UVs: colours (sRGB, or linear HDR), and tangent-space normals (+y up).
    flip_v
        Flip v, for models and maps that were made for OpenGL, where v increases upwards.

    Raises
    ------
    FileError, MeshError, ArgumentError
        If a file cannot be used, or a map is given for a mesh without UVs.

    Examples
    --------
    >>> import skinshade as sk
    >>> from importlib.resources import files
    >>> sk.load_head(files("skinshade") / "heads/assets/head.glb").material
    Material('skin-deon2007', albedo 1×1)
    """
    mesh = load_mesh(path, unit_mm=unit_mm)
    if mesh.uvs is None and (albedo or normal_map or flip_v):
        raise ArgumentError(f"{path}: the mesh has no UVs, which maps need")
    if flip_v:
        mesh = mesh.with_uvs_flipped()
    material = Material()
    if albedo is not None:
        material = replace(material, albedo=read_linear(albedo))
    if normal_map is not None:
        material = replace(material, normal=read_normal_map(normal_map))
    return Head(mesh, material)
