"""Honest images and lookup tables of a few texels, in every format and with many features of the formats."""

from __future__ import annotations

import io
import struct
import tempfile
import zlib
from pathlib import Path
from typing import Any

import numpy as np
import OpenImageIO as oiio  # noqa: N813 — the name in its manual
from PIL import Image

from skinshade.lut import Axis, Lut

__all__ = ["exr_images", "hdr_images", "jpeg_images", "lut_files", "png_images", "tiff_images"]

WIDTH, HEIGHT = 5, 4


def _pixels(channels: int) -> Any:
    """Return values (H, W, channels) in 0..1 whose blue is above one half, as in a normal map."""
    values = np.random.default_rng(channels).uniform(0.3, 0.7, (HEIGHT, WIDTH, channels))
    values[..., 2:3] = np.linspace(0.8, 1.0, WIDTH)[:, None]
    return values.astype(np.float32)


def _chunk(kind: bytes, content: bytes) -> bytes:
    check = zlib.crc32(kind + content)
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", check)


def _png(colour_type: int, depth: int, channels: int, *more: bytes) -> bytes:
    """Return a PNG with rows of every filter; `more` are chunks before the pixels."""
    header = struct.pack(">IIBBBBB", WIDTH, HEIGHT, depth, colour_type, 0, 0, 0)
    row = -(-WIDTH * channels * depth // 8)
    rows = b"".join(bytes([y % 5]) + bytes([200 - 2 * y] * row) for y in range(HEIGHT))
    chunks = [_chunk(b"IHDR", header), *more, _chunk(b"IDAT", zlib.compress(rows))]
    return b"\x89PNG\r\n\x1a\n" + b"".join(chunks) + _chunk(b"IEND", b"")


def png_images() -> list[bytes]:
    """Return PNG images of every colour type, with depths of 1 to 16 bits and several chunks."""
    gamma = _chunk(b"gAMA", struct.pack(">I", 45455))
    text = _chunk(b"tEXt", b"Comment\0a text") + _chunk(
        b"zTXt", b"Author\0\0" + zlib.compress(b"x")
    )
    palette = _chunk(b"PLTE", bytes(range(128, 176))) + _chunk(b"tRNS", b"\x80\xff")
    return [
        _png(2, 8, 3, gamma, text),
        _png(2, 16, 3),
        _png(6, 8, 4, _chunk(b"pHYs", struct.pack(">IIB", 3000, 3000, 1))),
        _png(6, 16, 4),
        _png(0, 16, 1, _chunk(b"tRNS", b"\0\1")),
        _png(0, 1, 1),
        _png(4, 8, 2, _chunk(b"sRGB", b"\0")),
        _png(3, 4, 1, palette),
    ]


def jpeg_images() -> list[bytes]:
    """Return JPEG images: baseline, progressive, grey, and CMYK."""
    colours = Image.fromarray(np.rint(_pixels(3) * 255.0).astype(np.uint8))
    files = []
    for image, options in (
        (colours, {}),
        (colours, {"progressive": True, "comment": b"a comment"}),
        (colours.convert("L"), {"optimize": True}),
        (colours.convert("CMYK"), {}),
    ):
        stream = io.BytesIO()
        image.save(stream, "JPEG", quality=70, **options)
        files.append(stream.getvalue())
    return files


def _written(suffix: str, pixels: Any, kind: str, **attributes: Any) -> bytes:
    """Return the bytes of an image as OpenImageIO writes it; a tile width makes it tiled."""
    height, width, channels = pixels.shape
    spec = oiio.ImageSpec(width, height, channels, kind)
    tile = attributes.pop("tile", 0)
    if tile:
        spec.tile_width = spec.tile_height = tile
    for name, value in attributes.items():
        spec.attribute(name, value)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / f"image{suffix}"
        out = oiio.ImageOutput.create(str(file))
        if not (out and out.open(str(file), spec) and out.write_image(pixels) and out.close()):
            raise RuntimeError(f"cannot write a seed: {oiio.geterror()}")
        return file.read_bytes()


def hdr_images() -> list[bytes]:
    """Return Radiance images: with flat rows, and with rows of run lengths."""
    wide = np.repeat(_pixels(3), 3, axis=1)
    return [_written(".hdr", pixels, "float") for pixels in (_pixels(3), wide)]


def exr_images() -> list[bytes]:
    """Return EXR images of several compressions and types, one of them tiled."""
    forms = (
        ("none", "float"),
        ("zip", "half"),
        ("rle", "float"),
        ("piz", "half"),
        ("pxr24", "half"),
    )
    files = [_written(".exr", _pixels(3), kind, compression=name) for name, kind in forms]
    files.append(_written(".exr", _pixels(4), "half", compression="zips", ImageDescription="text"))
    files.append(_written(".exr", _pixels(1), "float", compression="b44"))
    return [*files, _written(".exr", _pixels(3), "float", compression="zip", tile=16)]


def tiff_images() -> list[bytes]:
    """Return TIFF images of several compressions and types, one of them tiled."""
    forms = (
        ("none", "uint8", 3),
        ("lzw", "uint16", 3),
        ("zip", "float", 3),
        ("packbits", "uint8", 1),
    )
    files = [_written(".tif", _pixels(n), kind, compression=name) for name, kind, n in forms]
    return [*files, _written(".tif", _pixels(4), "uint8", compression="zip", tile=16)]


def lut_files() -> dict[str, list[bytes]]:
    """Return a lookup table in every format, by suffix."""
    columns, rows = Axis("N·L", "1", -1.0, 1.0), Axis("curvature", "1/mm", 0.0, 1.0, "sqrt")
    table = Lut(_pixels(3), "curvature", columns, rows, {"profile": "a preset", "version": "0"})
    files = {}
    with tempfile.TemporaryDirectory() as folder:
        for suffix in (".exr", ".png", ".npz"):
            file = Path(folder) / f"table{suffix}"
            table.save(file)
            files[suffix] = [file.read_bytes()]
    return files
