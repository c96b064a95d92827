"""Limits of what a file or a request may ask for, and the use of other limits.

Readers check these limits before they allocate memory or begin long work. ``docs/limits.md`` is generated
from the fields of `Limits`.
"""

from __future__ import annotations

import operator
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field, fields, replace
from pathlib import Path
from typing import Any

from .errors import ArgumentError, SkinshadeError

__all__ = [
    "LimitMeaning",
    "Limits",
    "check_file_size",
    "check_limit",
    "limit_advice",
    "limit_range",
    "limits",
    "use_limits",
]

GREATEST = 2**53
"""Greatest value of a limit: JSON and float64 hold all whole numbers up to it."""
DEEPEST = 192
"""Greatest value of the limit of nesting: recursive readers of JSON reach the limits of Python above it."""


@dataclass(frozen=True)
class LimitMeaning:
    """Description of a limit.

    Attributes
    ----------
    group
        What the limit applies to.
    unit
        Unit of the value.
    about
        What is counted, and why the limit has its default.
    greatest
        Greatest value that the limit can be set to.
    """

    group: str
    unit: str
    about: str
    greatest: int


def _limit(default: int, group: str, unit: str, about: str, greatest: int = GREATEST) -> Any:
    meaning = LimitMeaning(group, unit, about, greatest)
    return field(default=default, metadata={"meaning": meaning})


@dataclass(frozen=True)
class Limits:
    """Limits of what a file or a request may ask for; every limit is a whole number, 1 or more.

    The metadata of each field holds its `LimitMeaning`.

    Examples
    --------
    >>> import skinshade as sk
    >>> sk.Limits().lights
    32
    """

    file_bytes: int = _limit(
        2**32,
        "Files",
        "bytes",
        "Size of a file, and of all buffers of a glTF document together; GLB files cannot be larger.",
    )
    json_bytes: int = _limit(
        2**29,
        "Files",
        "bytes",
        "Size of JSON text; it holds the geometry of glTF files with embedded buffers.",
    )
    json_values: int = _limit(
        2**22,
        "Files",
        "values",
        "Values in JSON text, by its commas and brackets; each takes about 100 bytes of memory.",
    )
    json_depth: int = _limit(
        128,
        "Files",
        "levels",
        "Nesting of arrays and objects in JSON text: ten times that of any exporter.",
        DEEPEST,
    )
    image_side: int = _limit(2**15, "Images", "pixels", "Width and height of an image.")
    image_pixels: int = _limit(
        2**28,
        "Images",
        "pixels",
        "Pixels of an image: 16384×16384, which take 3 GiB as linear light.",
    )
    image_channels: int = _limit(
        64,
        "Images",
        "channels",
        "Channels of an image. A reader decompresses all channels of an EXR file to return three.",
    )
    image_free_pixels: int = _limit(
        2**24,
        "Images",
        "pixels",
        "Pixels that an image of any file size may have, except JPEG: 4096×4096.",
    )
    image_pixels_per_byte: int = _limit(
        2**10,
        "Images",
        "pixels per byte",
        "Further pixels for every byte of the file: the greatest compression of PNG with 8 bits.",
    )
    image_text_bytes: int = _limit(
        2**26, "Images", "bytes", "Decompressed text and colour profiles of a PNG file."
    )
    vertices: int = _limit(
        2**25, "Meshes", "vertices", "Vertices of a mesh, after all instances are placed."
    )
    triangles: int = _limit(
        2**26, "Meshes", "triangles", "Triangles of a mesh, after all instances are placed."
    )
    nodes: int = _limit(2**17, "Meshes", "nodes", "Nodes of a glTF document.")
    meshes: int = _limit(2**16, "Meshes", "meshes", "Meshes of a glTF document.")
    primitives: int = _limit(
        2**17, "Meshes", "primitives", "Primitives of all meshes of a glTF document together."
    )
    accessor_free_bytes: int = _limit(
        2**24,
        "Meshes",
        "bytes",
        "Decoded numbers of all accessors of a glTF document that need no bytes of buffers.",
    )
    accessor_bytes_per_byte: int = _limit(
        32,
        "Meshes",
        "bytes per byte",
        "Further decoded numbers for every byte of the buffers: one stored byte becomes 8 as float64,"
        " and accessors can share bytes.",
    )
    table_side: int = _limit(2**14, "Tables", "texels", "Width and height of a lookup table.")
    table_texels: int = _limit(
        2**24, "Tables", "texels", "Texels of a lookup table: 4096×4096, 200 MB in float32."
    )
    lights: int = _limit(
        32, "Scenes", "lights", "Lights that are on in a scene; each takes about 45 MB."
    )
    gaussians: int = _limit(
        256, "Scenes", "Gaussians", "Gaussians of a diffusion profile in a scene file."
    )
    picture_side: int = _limit(
        2**14,
        "Pictures",
        "pixels",
        "Width and height of a picture: the largest texture of most devices.",
    )
    samples: int = _limit(
        256, "Pictures", "samples", "Samples per pixel; the time of a picture grows with them."
    )
    frames: int = _limit(
        3600, "Pictures", "frames", "Frames of a turntable: a minute at 60 frames per second."
    )

    def __post_init__(self) -> None:
        for entry in fields(self):
            value = getattr(self, entry.name)
            greatest = entry.metadata["meaning"].greatest
            try:
                number = 0 if isinstance(value, bool) else operator.index(value)
            except TypeError:
                number = 0
            if not 1 <= number <= greatest:
                raise ArgumentError(
                    f"limit {entry.name} is {value!r:.80}; it must be a whole number, 1..{greatest}"
                )
            object.__setattr__(self, entry.name, number)


_CURRENT: ContextVar[Limits] = ContextVar("skinshade_limits")
_DEFAULTS = Limits()


def limits() -> Limits:
    """Return the limits that apply to this thread or asynchronous task.

    Examples
    --------
    >>> import skinshade as sk
    >>> with sk.use_limits(lights=100):
    ...     sk.limits().lights
    100
    >>> sk.limits() == sk.Limits()
    True
    """
    return _CURRENT.get(_DEFAULTS)


@contextmanager
def use_limits(base: Limits | None = None, /, **changes: int) -> Iterator[Limits]:
    """Use other limits in the body of a ``with`` statement; keywords are fields of `Limits`, with new values.

    The limits apply to this thread and to asynchronous tasks that it starts, and `skinshade.bake` jobs carry
    the limits under which they are planned to other processes and machines. A thread that the body starts
    has the default limits, unless it runs in a copy of the context (`contextvars.copy_context`).

    Parameters
    ----------
    base
        Limits to begin with; those that apply now if None.

    Yields
    ------
    Limits
        The limits in the body.

    Raises
    ------
    ArgumentError
        If there is no such limit, or a value is not a whole number in its range.

    Examples
    --------
    >>> import skinshade as sk
    >>> with sk.use_limits(image_pixels=2**30, image_side=2**16) as changed:
    ...     changed.image_side
    65536
    """
    names = [entry.name for entry in fields(Limits)]
    for name in changes:
        if name not in names:
            raise ArgumentError(
                f"there is no limit {name[:80]!r}; the limits are {', '.join(names)}"
            )
    changed = replace(limits() if base is None else base, **changes)
    token = _CURRENT.set(changed)
    try:
        yield changed
    finally:
        _CURRENT.reset(token)


def check_limit(
    name: str, value: int, subject: str, error: type[SkinshadeError] = ArgumentError
) -> None:
    """Raise if a value is beyond a limit; the message says how to raise the limit.

    Parameters
    ----------
    name
        Name of the limit.
    value
        Number to check.
    subject
        Beginning of the message: what has this many.
    error
        Type of the error.

    Raises
    ------
    SkinshadeError
        Of the type `error`, if the value is greater than the limit.

    Examples
    --------
    >>> from skinshade._core.limits import check_limit
    >>> check_limit("lights", 40, "scene.json")
    Traceback (most recent call last):
    skinshade._core.errors.ArgumentError: scene.json: 40 lights; the limit lights is 32 (--limit lights=40 or
    skinshade.use_limits(lights=40) raises it)
    """
    if value > getattr(limits(), name):
        raise error(f"{subject}: {value} {_meaning(name).unit}; {limit_advice(name, value)}")


def limit_advice(name: str, value: int) -> str:
    """Return the end of an error message: a limit, its value, and how to raise it to `value`."""
    text = f"the limit {name} is {getattr(limits(), name)}"
    if value > _meaning(name).greatest:
        return f"{text} and can be raised to {_meaning(name).greatest} at most"
    return f"{text} (--limit {name}={value} or skinshade.use_limits({name}={value}) raises it)"


def limit_range(name: str, least: int, value: int) -> str:
    """Return the range of a request as text, such as ``1..256 samples``, and advice if `value` is above."""
    text = f"{least}..{getattr(limits(), name)} {_meaning(name).unit}"
    return text if value <= getattr(limits(), name) else f"{text}; {limit_advice(name, value)}"


def _meaning(name: str) -> LimitMeaning:
    meaning: LimitMeaning = Limits.__dataclass_fields__[name].metadata["meaning"]
    return meaning


def check_file_size(file: Path, error: type[SkinshadeError]) -> None:
    """Raise if a file that exists is larger than the limit `file_bytes`.

    Raises
    ------
    SkinshadeError
        Of the type `error`.
    """
    check_limit("file_bytes", file.stat().st_size, str(file), error)
