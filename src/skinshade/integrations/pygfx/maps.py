"""Pictures and tables as pygfx's textures."""

from __future__ import annotations

from typing import Any

import numpy as np
import pygfx
from numpy.typing import NDArray

from ..._core.arrays import ImageArray
from ..._core.errors import ArgumentError
from ...gpu.textures import rgba
from ...scene.maps import steepened

__all__ = ["color_map", "normal_map", "table"]


def color_map(given: Any) -> Any:
    """Return linear colours (H, W, 3) as a map with mips; pygfx's own as they are."""
    if not isinstance(given, np.ndarray):
        return given
    return _placed(_with_mips(rgba(_picture("map", given), np.float16)))


def normal_map(given: Any, strength: float) -> pygfx.TextureMap | None:
    """Return a normal map with mips: normals (H, W, 3) in −1..1 at a strength, or one of pygfx's.

    Float32: what mips lose of a normal's length is relief, and that of half floats is light of .004, of
    8 bits .02.

    Raises
    ------
    ArgumentError
        If an array has another shape, or one of pygfx's textures cannot be given mips, or is to have
        another strength than 1.
    """
    if given is None:
        return None
    if isinstance(given, np.ndarray):
        normals = steepened(_picture("normal_map", given), strength)
        return _placed(_with_mips(rgba(0.5 + 0.5 * normals, np.float32)))
    if strength != 1.0:
        raise ArgumentError(
            f"params.normal_strength is {strength:g}; it is averaged into the mips: give normal_map as"
            " an array (H, W, 3) of normals in −1..1"
        )
    placed = pygfx.TextureMap(given) if isinstance(given, pygfx.Texture) else given
    placed.texture = _smooth(placed.texture)
    return placed


def table(values: ImageArray) -> pygfx.Texture:
    """Return a table (H, W, 3) as float32, which pygfx's devices can filter."""
    return pygfx.Texture(rgba(values, np.float32), dim=2, colorspace="physical")


def _smooth(texture: pygfx.Texture) -> pygfx.Texture:
    """Return a texture with mips that keep lengths: itself if it has them, or else its data anew."""
    if texture.data is None:
        if not texture.generate_mipmaps:
            raise ArgumentError(
                "normal_map: the texture has no mips, of which skin takes its blurred normals, and no"
                " data to make them of; make it with generate_mipmaps=True"
            )
        return texture
    data = np.asarray(texture.data)
    if data.ndim != 3 or data.shape[2] not in (3, 4) or data.dtype.kind not in "uf":
        raise ArgumentError(
            f"normal_map: is {data.dtype} {data.shape}; it must be (H, W, 3) or (H, W, 4), without signs"
        )
    if data.dtype.kind == "f" and texture.generate_mipmaps:
        return texture
    most = np.iinfo(data.dtype).max if data.dtype.kind == "u" else 1
    return _with_mips(rgba((data[..., :3] / most).astype(np.float32), np.float32))


def _picture(name: str, values: NDArray[Any]) -> ImageArray:
    if values.ndim != 3 or values.shape[2] != 3 or 0 in values.shape:
        raise ArgumentError(f"{name}: shape is {values.shape}; it must be (H, W, 3)")
    if not np.isfinite(values).all():
        raise ArgumentError(f"{name}: must be finite")
    return values.astype(np.float32)


def _placed(texture: pygfx.Texture) -> pygfx.TextureMap:
    return pygfx.TextureMap(texture, filter="linear", wrap="repeat")


def _with_mips(rgba: NDArray[Any]) -> pygfx.Texture:
    return pygfx.Texture(rgba, dim=2, colorspace="physical", generate_mipmaps=True)
