"""Built-in head, which ships with skinshade."""

from __future__ import annotations

from functools import cache
from importlib.resources import as_file, files

from ..mesh import load_mesh
from ..scene import Material
from .head import Head
from .maps import head_maps

__all__ = ["builtin_head"]

MAP_SIZE = 2048
"""Texels along a side of the head's maps."""


@cache
def builtin_head(seed: int = 0) -> Head:
    """Return the head that ships with skinshade; the first call generates its maps.

    Parameters
    ----------
    seed
        Seed of freckles, pores and hairs, ≥ 0; the same seed gives the same maps.

    Raises
    ------
    ArgumentError
        If the seed is not a whole number, or is below 0.

    Examples
    --------
    >>> import skinshade as sk
    >>> head = sk.builtin_head()
    >>> head.mesh.faces.shape, head.material.albedo.shape
    ((40034, 3), (2048, 2048, 3))
    """
    with as_file(files(__package__).joinpath("assets/head.glb")) as path:
        mesh = load_mesh(path)
    assert mesh.uvs is not None
    maps = head_maps(
        mesh.positions_mm,
        mesh.normals,
        mesh.uvs,
        mesh.faces,
        mesh.attributes["_REGION"],
        size=MAP_SIZE,
        seed=seed,
    )
    material = Material(
        albedo=maps.albedo,
        normal=maps.normal,
        specular=maps.specular,
        deep_scatter=maps.deep_scatter,
    )
    return Head(mesh, material)
