"""pygfx textures of images and tables."""

from __future__ import annotations

from typing import Any

import numpy as np
import pygfx
from numpy.typing import NDArray

from ..._core.arrays import ImageArray
from ..._core.errors import ArgumentError
from ...gpu.textures import rgba
from ...scene.maps import scale_slopes

__all__ = ["color_map", "normal_map", "table"]


def color_map(colors: Any) -> Any:
    """Return a map with mips of linear colours (H, W, 3); return maps and textures unchanged."""
    if not isinstance(colors, np.ndarray):
        return colors
    return _texture_map(_with_mips(rgba(_image("map", colors), np.float16)))


def normal_map(normals: Any, strength: float) -> pygfx.TextureMap | None:
    """Return a map with float32 mips of normals (H, W, 3) in −1..1, or of a map or texture of pygfx.

    Relief shortens the averaged normals of the mips, and shading evaluates this length. Half floats would
    change the light by .004, 8 bits by .02.

    Parameters
    ----------
    normals
        Array, texture, map, or None.
    strength
        Factor of the slopes; it must be 1 unless the normals are an array.

    Raises
    ------
    ArgumentError
        If the shape of an array is wrong, or a texture can have no mips or has a strength other than 1.
    """
    if normals is None:
        return None
    if isinstance(normals, np.ndarray):
        scaled = scale_slopes(_image("normal_map", normals), strength)
        return _texture_map(_with_mips(rgba(0.5 + 0.5 * scaled, np.float32)))
    if strength != 1.0:
        raise ArgumentError(
            f"params.normal_strength is {strength:g}; the mips depend on it: give normal_map as an array"
            " (H, W, 3) of normals in −1..1"
        )
    result = pygfx.TextureMap(normals) if isinstance(normals, pygfx.Texture) else normals
    result.texture = _with_exact_mips(result.texture)
    return result


def table(values: ImageArray) -> pygfx.Texture:
    """Return a float32 texture of a table (H, W, 3); pygfx's devices can filter it."""
    return pygfx.Texture(rgba(values, np.float32), dim=2, colorspace="physical")


def _with_exact_mips(texture: pygfx.Texture) -> pygfx.Texture:
    """Return a texture with float mips: the texture if it has them, else a new one with its data."""
    if texture.data is None:
        if not texture.generate_mipmaps:
            raise ArgumentError(
                "normal_map: the texture has no mips, which hold the blurred normals of skin, and no data"
                " to compute them from; make it with generate_mipmaps=True"
            )
        return texture
    data = np.asarray(texture.data)
    if data.ndim != 3 or data.shape[2] not in (3, 4) or data.dtype.kind not in "uf":
        raise ArgumentError(
            f"normal_map: is {data.dtype} {data.shape}; it must be (H, W, 3) or (H, W, 4), unsigned or float"
        )
    if data.dtype.kind == "f" and texture.generate_mipmaps:
        return texture
    white = np.iinfo(data.dtype).max if data.dtype.kind == "u" else 1
    return _with_mips(rgba((data[..., :3] / white).astype(np.float32), np.float32))


def _image(name: str, values: NDArray[Any]) -> ImageArray:
    if values.ndim != 3 or values.shape[2] != 3 or 0 in values.shape:
        raise ArgumentError(f"{name}: shape is {values.shape}; it must be (H, W, 3)")
    if not np.isfinite(values).all():
        raise ArgumentError(f"{name}: must be finite")
    return values.astype(np.float32)


def _texture_map(texture: pygfx.Texture) -> pygfx.TextureMap:
    return pygfx.TextureMap(texture, filter="linear", wrap="repeat")


def _with_mips(values: NDArray[Any]) -> pygfx.Texture:
    return pygfx.Texture(values, dim=2, colorspace="physical", generate_mipmaps=True)
