"""Heads from files."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from .._core.errors import ArgumentError
from ..mesh import load_mesh
from ..scene import Material, Part
from ..scene.asset_parts import asset_parts
from ..scene.images import read_linear
from ..scene.maps import read_normal_map
from .head import Head

__all__ = ["load_head"]


def load_head(
    path: str | os.PathLike[str],
    *,
    unit_mm: float | None = None,
    up: str = "y",
    albedo: str | os.PathLike[str] | None = None,
    normal_map: str | os.PathLike[str] | None = None,
    flip_v: bool = False,
    skin_material: Sequence[str] = (),
) -> Head:
    """Return a head from a model and its maps.

    Materials of glTF are used: base colour, normal map, roughness and opacity. Parts that are not skin, such
    as hair and eyes, are drawn without scattering.

    Parameters
    ----------
    path, unit_mm, up
        File, unit and up axis of the mesh, as in `skinshade.load_mesh`.
    albedo, normal_map
        Images for the mesh's UVs: colours (sRGB, or linear HDR), and tangent-space normals (+y up).
    flip_v
        Flip v, for models and maps that were made for OpenGL, where v increases upwards.
    skin_material
        Names of the materials that are skin, in which ``*`` stands for any text. By default, skin is found
        by names and transparency, as `skinshade.scene.asset_parts.skin_materials` describes.

    Raises
    ------
    FileError, MeshError, ArgumentError
        If a file cannot be used, a map is given for a mesh without UVs, or no material is skin.

    Warns
    -----
    AssetWarning
        If an image of the asset cannot be used.

    Examples
    --------
    >>> import skinshade as sk
    >>> from importlib.resources import files
    >>> sk.load_head(files("skinshade") / "heads/assets/head.glb").material
    Material('skin-deon2007', albedo 1×1)
    """
    mesh = load_mesh(path, unit_mm=unit_mm, up=up)
    if mesh.uvs is None and (albedo or normal_map or flip_v):
        raise ArgumentError(f"{path}: the mesh has no UVs, which maps need")
    material, parts = Material(), list[Part]()
    has_materials = mesh.materials is not None and bool((mesh.materials >= 0).any())
    if has_materials:
        mesh, material, parts = asset_parts(Path(path), mesh, skin_material)
    elif skin_material:
        raise ArgumentError(f"{path}: has no materials; --skin-material has no effect")
    if flip_v:
        mesh = mesh.with_uvs_flipped()
        material, parts = material.with_maps_flipped(), [p.with_maps_flipped() for p in parts]
    if albedo is not None:
        material = replace(material, albedo=read_linear(albedo))
    if normal_map is not None:
        material = replace(material, normal=read_normal_map(normal_map))
    return Head(mesh, material, tuple(parts))
