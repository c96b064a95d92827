"""Rendered images: display in notebooks, and saving to files."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import LARGEST_LIGHT, FloatArray, ImageArray, as_floats
from .._core.errors import ArgumentError, OutputError
from .._core.notebook import png_bytes
from ..params.choices import ToneCurve
from ..scene.images import write_exr, write_png
from ..shading.tonemap import tonemap

__all__ = ["RenderedImage", "check_image_path", "save_image"]


class RenderedImage(np.ndarray[Any, np.dtype[np.float32]]):
    """Linear light and coverage (H, W, 4) float32: an array that a notebook shows as a picture.

    Attributes
    ----------
    tone, exposure
        Tone curve and exposure of the displayed or saved picture. Results of arithmetic keep both.

    Examples
    --------
    >>> import skinshade as sk
    >>> image = sk.render(sk.head_scene(sk.builtin_head()), size=(32, 18), samples=1)
    >>> image.tone, (0.5 * image).exposure
    (<ToneCurve.FILMIC: 'filmic'>, 1.0)
    """

    tone: ToneCurve
    exposure: float

    @classmethod
    def of(cls, image: ImageArray, tone: ToneCurve, exposure: float) -> RenderedImage:
        """Return an image with its tone curve and exposure; it shares the data of `image`.

        Parameters
        ----------
        image
            (H, W, 4) linear light and coverage.
        tone
            Tone curve.
        exposure
            Factor before the tone curve.
        """
        result = image.view(cls)
        result.tone, result.exposure = tone, exposure
        return result

    def __array_finalize__(self, source: Any) -> None:
        self.tone = getattr(source, "tone", ToneCurve.FILMIC)
        self.exposure = getattr(source, "exposure", 1.0)

    def _repr_png_(self) -> bytes | None:
        if self.ndim != 3 or self.shape[2] not in (3, 4):
            return None
        return png_bytes(_display(self, self.tone, self.exposure))


def check_image_path(
    path: str | os.PathLike[str], suffixes: tuple[str, ...] = (".png", ".exr")
) -> None:
    """Raise if an image cannot be saved to a path, before it is drawn.

    Raises
    ------
    ArgumentError, OutputError
        If the suffix is not one of `suffixes`, or the folder does not exist.
    """
    file = Path(path)
    if file.suffix.lower() not in suffixes:
        raise ArgumentError(f"{file}: suffix {file.suffix!r}; it must be {' or '.join(suffixes)}")
    if not file.parent.is_dir():
        raise OutputError(f"{file}: the folder {file.parent} does not exist")


def save_image(
    path: str | os.PathLike[str],
    image: ImageArray | NDArray[np.uint8],
    *,
    tone: str | None = None,
    exposure: float | None = None,
) -> None:
    """Save an image: linear light as EXR, display values as PNG.

    Parameters
    ----------
    path
        ``.exr`` or ``.png``; the file is replaced when the new one is complete.
    image
        (H, W, 3 or 4) linear light, or display values as uint8. Display values are saved as PNG only.
    tone
        Tone curve of a PNG, ``filmic`` or ``srgb``. If None: the curve of the scene for an image from
        `render`, else ``filmic``.
    exposure
        Factor before the tone curve, 0..1e6. If None: the exposure of the scene for an image from `render`,
        else 1.

    Raises
    ------
    ArgumentError, OutputError
        If the suffix, the shape or a value is not allowed, or the file cannot be written.

    Examples
    --------
    >>> import numpy as np
    >>> import skinshade as sk
    >>> sk.save_image("grey.png", np.full((2, 2, 3), 0.18, np.float32), tone="srgb")
    """
    pixels: NDArray[Any] = np.asarray(image)
    if pixels.ndim != 3 or pixels.shape[2] not in (3, 4):
        raise ArgumentError(f"image: shape is {pixels.shape}; it must be (H, W, 3) or (H, W, 4)")
    if pixels.dtype.kind == "f" and not np.isfinite(pixels).all():
        raise ArgumentError("image: holds NaN or infinite values")
    suffix = Path(path).suffix.lower()
    if suffix == ".exr" and pixels.dtype != np.uint8:
        write_exr(path, pixels)
    elif suffix == ".png" and pixels.dtype == np.uint8:
        write_png(path, pixels)
    elif suffix == ".png":
        curve = getattr(image, "tone", ToneCurve.FILMIC) if tone is None else tone
        factor = getattr(image, "exposure", 1.0) if exposure is None else exposure
        as_floats("exposure", factor, (), low=0.0, high=LARGEST_LIGHT)
        write_png(path, _display(pixels, ToneCurve.of(curve, "tone"), factor))
    else:
        raise ArgumentError(
            f"{path}: suffix {suffix!r}; linear light is saved as .exr or .png, display values as .png"
        )


def _display(image: NDArray[Any], tone: ToneCurve, exposure: float) -> FloatArray:
    return tonemap(np.asarray(image[..., :3], dtype=np.float64), tone, exposure)
