"""Materials of glTF assets: which are skin, and their maps."""

from __future__ import annotations

import tempfile
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fnmatch import fnmatchcase
from pathlib import Path

import numpy as np

from .._core.arrays import FloatArray, ImageArray
from .._core.errors import ArgumentError, AssetWarning, FileError
from .._core.srgb import linear_from_srgb
from ..gltf import GltfDocument, read_gltf
from ..gltf.materials import GltfMaterial, MapReference, image_bytes, read_material
from ..mesh import Mesh
from ..params import SkinParams
from ..params.gloss import gloss_from_roughness
from .images import read_image, read_linear
from .maps import read_normal_map
from .material import Material
from .part import Part

__all__ = ["asset_parts", "skin_materials"]

SKIN_WORDS = (
    "skin",
    "face",
    "head",
    "body",
    "flesh",
    "ear",
    "neck",
    "nose",
    "hand",
    "arm",
    "leg",
    "torso",
)
"""Parts of names that mean skin, unless a word of `OTHER_WORDS` occurs too."""
OTHER_WORDS = (
    "hair", "eye", "lash", "brow", "beard", "teeth", "tooth", "gum", "tongue", "mouth", "cornea", "sclera",
    "iris", "pupil", "lens", "glass", "cloth", "shirt", "outfit", "pant", "shoe", "boot", "hat", "helmet",
    "metal", "plastic", "fabric", "leather", "nail", "lacrimal", "occlusion", "wear", "gear", "headphone",
    "headset", "headband", "armor", "legging", "beads", "earring",
)  # fmt: skip
"""Parts of names that mean another material."""


def skin_materials(materials: Mapping[int, GltfMaterial], names: Sequence[str] = ()) -> list[int]:
    """Return the numbers of the materials that are skin.

    Without names, materials with transparency are not skin, and neither are those whose name has a word such
    as hair, eye or glasses. If the names of others have a word such as skin, face or body, only these are
    skin; otherwise all others are.

    Parameters
    ----------
    materials
        Materials by their numbers.
    names
        Names of the skin materials, in which ``*`` stands for any text; upper and lower case are equal.

    Raises
    ------
    ArgumentError
        If a name fits no material.

    Examples
    --------
    >>> from skinshade.gltf.materials import GltfMaterial
    >>> from skinshade.scene.asset_parts import skin_materials
    >>> skin_materials({0: GltfMaterial("Wolf_Skin"), 1: GltfMaterial("Wolf_Hair"), 2: GltfMaterial("Top")})
    [0]
    """
    if names:
        for name in names:
            if not any(fnmatchcase(m.name.lower(), name.lower()) for m in materials.values()):
                known = ", ".join(repr(m.name) for m in materials.values())
                raise ArgumentError(f"skin material {name!r}: there is none; there are {known}")
        return [
            number
            for number, material in materials.items()
            if any(fnmatchcase(material.name.lower(), name.lower()) for name in names)
        ]
    possible = [
        number
        for number, material in materials.items()
        if material.alpha_mode == "OPAQUE" and not _has_word(material, OTHER_WORDS)
    ]
    certain = [number for number in possible if _has_word(materials[number], SKIN_WORDS)]
    return certain or possible


def asset_parts(
    path: Path, mesh: Mesh, names: Sequence[str] = ()
) -> tuple[Mesh, Material, list[Part]]:
    """Return a mesh with texture coordinates for its materials, the material of its skin, and its parts.

    Parameters
    ----------
    path
        glTF file of the mesh.
    mesh
        Mesh with material numbers.
    names
        Names of the skin materials, as in `skin_materials`.

    Raises
    ------
    MeshFileError, ArgumentError
        If a material or a reference is malformed, a name fits no material, or no material is skin.

    Warns
    -----
    AssetWarning
        If an image cannot be used; its material is drawn without it.
    """
    assert mesh.materials is not None
    gltf = read_gltf(path)
    numbers, counts = np.unique(mesh.materials, return_counts=True)
    by_size = numbers[np.argsort(-counts, kind="stable")]
    materials = {int(number): read_material(gltf, int(number)) for number in by_size}
    skin = skin_materials(materials, names)
    if not skin:
        known = ", ".join(repr(material.name) for material in materials.values())
        raise ArgumentError(
            f"{path}: none of its materials looks like skin: {known}; name it with --skin-material"
        )
    has_uvs = mesh.uvs is not None
    parts = {
        number: _part(gltf, number, material, number in skin, has_uvs)
        for number, material in materials.items()
    }
    first = parts.pop(skin[0])
    placed = mesh if mesh.uvs is None else replace(mesh, uvs=_placed_uvs(mesh, mesh.uvs, materials))
    return placed, first.material, list(parts.values())


def _has_word(material: GltfMaterial, words: Sequence[str]) -> bool:
    return any(word in material.name.lower() for word in words)


def _placed_uvs(mesh: Mesh, uvs: FloatArray, materials: Mapping[int, GltfMaterial]) -> FloatArray:
    """Return texture coordinates (V, 2) after the transform of each material's colour map."""
    result = uvs.copy()
    for number, material in materials.items():
        reference = material.color_map or material.normal_map
        if reference is not None and reference != MapReference(reference.image):
            own = np.unique(mesh.faces[mesh.materials == number])
            result[own] = uvs[own] * reference.scale + reference.offset
    return result


def _part(
    gltf: GltfDocument, number: int, material: GltfMaterial, is_skin: bool, has_uvs: bool
) -> Part:
    """Return a part with the maps of its material."""
    maps = (
        material
        if has_uvs
        else replace(material, color_map=None, normal_map=None, roughness_map=None)
    )
    albedo, opacity = _colour(gltf, maps)
    params = SkinParams(normal_strength=material.normal_strength)
    specular = None
    if maps.roughness_map is not None:
        roughness = _pixels(gltf, maps.roughness_map.image, lambda file: read_image(file)[..., 1:2])
        if roughness is not None:
            gloss = gloss_from_roughness(material.given_roughness * roughness.astype(np.float64))
            specular = np.concatenate([np.ones_like(gloss), gloss], axis=2).astype(np.float32)
    if material.roughness is not None or not is_skin:
        params = replace(params, gloss=float(gloss_from_roughness(material.given_roughness)))
    normal = None
    if maps.normal_map is not None:
        normal = _pixels(gltf, maps.normal_map.image, read_normal_map)
    if is_skin and not material.has_color:
        albedo = Material().albedo
    own = Material(
        params=params,
        albedo=albedo,
        normal=normal,
        specular=specular,
        name=material.name or f"material {number}",
    )
    transparent = material.alpha_mode != "OPAQUE" and not is_skin
    return Part(
        number,
        own,
        is_skin,
        opacity if transparent else None,
        material.alpha_cutoff if material.alpha_mode == "MASK" else 0.5,
    )


def _colour(gltf: GltfDocument, material: GltfMaterial) -> tuple[ImageArray, ImageArray]:
    """Return the linear colours (H, W, 3) and the opacity (H, W, 1) of a material."""
    factor = np.array(material.color, dtype=np.float32)
    image = None
    if material.color_map is not None:
        image = _pixels(gltf, material.color_map.image, _colour_and_opacity)
    if image is None:
        return factor[None, None, :3], factor[None, None, 3:]
    return image[..., :3] * factor[:3], image[..., 3:] * factor[3:]


def _colour_and_opacity(file: Path) -> ImageArray:
    """Return linear colours and opacity (H, W, 4) of an image."""
    try:
        image = read_image(file, 4)
    except FileError:  # no fourth channel
        colours = read_linear(file)
        return np.concatenate([colours, np.ones_like(colours[..., :1])], axis=2)
    colours = linear_from_srgb(image[..., :3].astype(np.float64)).astype(np.float32)
    return np.concatenate([colours, image[..., 3:]], axis=2)


def _pixels(
    gltf: GltfDocument, index: int, read: Callable[[Path], ImageArray]
) -> ImageArray | None:
    """Return an image of a document; None with a warning if it cannot be used."""
    try:
        data, suffix = image_bytes(gltf, index)
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / f"image {index}{suffix}"
            file.write_bytes(data)
            return read(file)
    except FileError as error:
        reason = str(error).rpartition(f"image {index}")[2].lstrip(".:")
        warnings.warn(
            f"{gltf.path}: image {index} is left out: {reason.partition(': ')[2] or reason}",
            AssetWarning,
            stacklevel=2,
        )
        return None
