"""Heads to draw: the built-in one, any model on disk, and the public scan fetched on request."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from importlib.resources import as_file, files
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from .._core.errors import ArgumentError, DownloadError
from ..mesh import Mesh, load_mesh
from .camera import Camera
from .environment import Environment
from .head_maps import head_maps
from .images import read_linear
from .lights import DirectionalLight, Light
from .maps import read_normal_map
from .material import Material
from .scene import Scene

__all__ = ["SCANS", "Scan", "builtin_head", "fetch_scan", "head_scene", "model"]

MAP_SIZE = 2048
DEFAULT_LIGHT = DirectionalLight.from_angles(-38.0, 26.0, 1.0)


@dataclass(frozen=True)
class Scan:
    """A public scan: where each file of it is, and what it must hash to.

    Attributes
    ----------
    base_url
        Folder that holds the files.
    sha256
        File name to hash.
    credit
        Whom to name wherever a picture of it is shown.
    unit_mm
        Length of its unit, mm.
    """

    base_url: str
    sha256: dict[str, str]
    credit: str
    unit_mm: float


SCANS = {
    "lee-perry-smith": Scan(
        "https://raw.githubusercontent.com/mrdoob/three.js/dev/examples/models/gltf/LeePerrySmith/",
        {
            "LeePerrySmith.glb": "402b8a8ac9f03232e6d64b5962929703a069daf99d3c49ac8eb0e48bedc9c576",
        },
        "Lee Perry-Smith / Infinite-Realities, CC-BY 3.0",
        50.35,
    )
}


@cache
def builtin_head(seed: int = 0) -> tuple[Mesh, Material]:
    """Return the head that ships with skinshade, and its skin.

    Parameters
    ----------
    seed
        ≥ 0; another one gives other freckles, pores and hairs, the same one the same maps.

    Raises
    ------
    ArgumentError
        If the seed is no whole number or below 0.
    """
    with as_file(files(__package__).joinpath("assets/head.glb")) as path:
        mesh = load_mesh(path)
    assert mesh.uvs is not None
    regions = mesh.attributes["_REGION"] / 255.0  # bytes in the file
    maps = head_maps(
        mesh.positions_mm, mesh.normals, mesh.uvs, mesh.faces, regions, size=MAP_SIZE, seed=seed
    )
    skin = Material(
        albedo=maps.albedo,
        normal=maps.normal,
        specular=maps.specular,
        deep_scatter=maps.deep_scatter,
    )
    return mesh, skin


def model(
    path: str | os.PathLike[str],
    *,
    unit_mm: float | None = None,
    albedo: str | os.PathLike[str] | None = None,
    normal_map: str | os.PathLike[str] | None = None,
    flip_v: bool = False,
) -> tuple[Mesh, Material]:
    """Return a head from files.

    Parameters
    ----------
    path, unit_mm
        As in `skinshade.load_mesh`.
    albedo, normal_map
        Pictures for the mesh's UVs: colours (sRGB, or linear HDR), tangent-space normals (+y up).
    flip_v
        Whether v counts from below, as in files made for OpenGL.

    Raises
    ------
    FileError, MeshError, ArgumentError
        If a file cannot be used, or a map is given for a mesh without UVs.
    """
    mesh = load_mesh(path, unit_mm=unit_mm)
    if mesh.uvs is None and (albedo or normal_map or flip_v):
        raise ArgumentError(f"{path}: has no UVs, so no map can be placed on it")
    if flip_v:
        mesh = mesh.with_uvs_flipped()
    material = Material()
    if albedo is not None:
        material = replace(material, albedo=read_linear(albedo))
    if normal_map is not None:
        material = replace(material, normal=read_normal_map(normal_map))
    return mesh, material


def head_scene(
    mesh: Mesh,
    material: Material,
    *,
    yaw_deg: float = 28.0,
    pitch_deg: float = 4.0,
    lights: Sequence[Light] = (DEFAULT_LIGHT,),
    environment: Environment | None = None,
    background: ArrayLike = (0.035, 0.037, 0.04),
) -> Scene:
    """Return a portrait: the camera frames the head, the studio lights it.

    Parameters
    ----------
    mesh, material
        Of `builtin_head` or `model`.
    yaw_deg, pitch_deg
        Where the camera stands around the head; 0, 0 is in front.
    lights
        Lamps; a key light from the upper left by default.
    environment
        Light from all around; the built-in studio by default.
    background
        (3,) linear.
    """
    points = mesh.positions_mm
    low, high = points.min(axis=0), points.max(axis=0)
    # A head's height follows from its depth; shoulders, if any, only add below it.
    tall = min(high[1] - low[1], 1.25 * (high[2] - low[2]))
    around = points[points[:, 1] > high[1] - 0.6 * tall]
    centre = 0.5 * (around.min(axis=0) + around.max(axis=0))
    target = np.array([centre[0], high[1] - 0.5 * tall, centre[2]])
    camera = Camera.orbit(
        target, 3.65 * tall, yaw_deg=yaw_deg, pitch_deg=pitch_deg, vertical_fov_deg=19.0
    )
    surroundings = Environment.studio(scale=0.55) if environment is None else environment
    return Scene(
        mesh,
        camera,
        material,
        tuple(lights),
        surroundings,
        np.asarray(background, dtype=np.float64),
    )


def fetch_scan(
    name: str, folder: str | os.PathLike[str] | None = None, base_url: str | None = None
) -> list[Path]:
    """Fetch a public scan once, and refuse it if it is not the one that was promised.

    Parameters
    ----------
    name
        One of `SCANS`.
    folder
        Where to keep it; the user's cache by default.
    base_url
        Another place that serves the same files.

    Returns
    -------
    list of Path

    Raises
    ------
    ArgumentError, DownloadError
        If there is no such scan, it cannot be reached, or its hash is wrong.
    """
    import pooch  # only this needs it

    if name not in SCANS:
        raise ArgumentError(f"there is no scan {name!r}; there are {', '.join(SCANS)}")
    scan = SCANS[name]
    place = Path(folder) if folder is not None else Path(pooch.os_cache("skinshade"))
    address = base_url or scan.base_url
    fetched = []
    for file, sha256 in scan.sha256.items():
        try:
            fetched.append(
                Path(
                    pooch.retrieve(
                        address + file,
                        known_hash=f"sha256:{sha256}",
                        fname=file,
                        path=place,
                        progressbar=False,
                    )
                )
            )
        except ValueError as error:
            raise DownloadError(f"{file}: is not the file that was promised: {error}") from None
        except Exception as error:
            raise DownloadError(f"{address}{file}: cannot be fetched ({error})") from None
    return fetched
