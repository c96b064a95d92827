"""Mutations of files: of their bytes, and by format of their JSON, text or headers."""

from __future__ import annotations

import struct
from collections.abc import Callable, Sequence
from contextlib import suppress
from random import Random

from .mutate_headers import (
    mutate_exr,
    mutate_glb,
    mutate_jpeg,
    mutate_npz,
    mutate_ply,
    mutate_png,
    mutate_stl,
    mutate_tiff,
)
from .mutate_json import mutate_json_bytes
from .mutate_text import mutate_text

__all__ = ["MUTATORS", "mutate_bytes", "mutated"]

Mutator = Callable[[bytes, Random, Sequence[bytes]], bytes]
"""Function of a file, a source of random numbers, and further files of the format."""

LARGEST_CASE = 1 << 18
"""Most bytes of a case: mutations that duplicate must not make all later cases slow."""
INTERESTING = (0, 1, 2, 3, 4, 7, 8, 16, 32, 64, 100, 127, 128, 255, 256, 512, 1000, 1024, 4096)
LARGE = (
    0x7FFF,
    0x8000,
    0xFFFF,
    0x10000,
    0x7FFFFFFF,
    0x80000000,
    0xFFFFFFFF,
    0x7F800000,
    0x7FC00000,
)
LARGER = (0x7FFFFFFFFFFFFFFF, 0x8000000000000000, 0xFFFFFFFFFFFFFFFF, 0x7FF0000000000000, 1 << 32)
"""Values at which lengths, indices and floating-point numbers change their meaning."""


def mutated(data: bytes, form: str, random: Random, seeds: Sequence[bytes]) -> bytes:
    """Return a changed file.

    Parameters
    ----------
    data
        File to change.
    form
        Format of the file, a key of `MUTATORS`.
    random
        Source of all choices.
    seeds
        Other files of the same format, of which parts are taken.
    """
    mutators, changed = MUTATORS[form], data
    while changed == data:  # a value may be replaced by an equal one
        for _ in range(random.choice((1, 1, 1, 1, 2, 2, 3, 5))):
            # A mutator that cannot read what the one before has changed leaves it unchanged.
            with suppress(Exception):
                changed = random.choice(mutators)(changed, random, seeds)
        changed = changed[:LARGEST_CASE]
    return changed


def mutate_bytes(data: bytes, random: Random, seeds: Sequence[bytes]) -> bytes:
    """Return a file with one change of its bytes."""
    changed = bytearray(data)
    start = random.randrange(len(changed) + 1)
    length = random.choice((1, 2, 4, 8, random.randrange(1, 64)))
    kind = random.randrange(9)
    if kind == 0 and start < len(changed):
        changed[start] ^= 1 << random.randrange(8)
    elif kind == 1 and start < len(changed):
        changed[start] = random.randrange(256)
    elif kind == 2:
        changed[start:start] = random.choice(
            (random.randbytes(length), b"\0" * length, b"\xff" * length)
        )
    elif kind == 3:
        del changed[start : start + length]
    elif kind == 4:
        changed[start:start] = changed[start : start + length] * random.choice((1, 1, 2, 100))
    elif kind == 5:
        del changed[start:]
    elif kind == 6:
        other = random.choice(seeds)
        cut = random.randrange(len(other) + 1)
        changed[start:] = other[cut:] if random.random() < 0.5 else other[start:]
    else:
        value = _interesting(random)
        changed[start : start + len(value)] = value
    return bytes(changed)


def _interesting(random: Random) -> bytes:
    """Return an interesting integer of 16, 32 or 64 bits, in either byte order."""
    value = random.choice(random.choice((INTERESTING, LARGE, LARGER))) + random.choice(
        (0, 0, 1, -1)
    )
    bits, code = random.choice(((16, "H"), (32, "I"), (64, "Q")))
    return struct.pack(random.choice("<>") + code, value % (1 << bits))


def _each_of(mutator: Mutator, share: int) -> list[Mutator]:
    """Return a mutator `share` times, and the mutator of bytes once."""
    return [*[mutator] * share, mutate_bytes]


MUTATORS: dict[str, list[Mutator]] = {
    "glb": _each_of(mutate_glb, 6),
    "gltf": _each_of(mutate_json_bytes, 6),
    "obj": _each_of(mutate_text, 4),
    "ply": [*_each_of(mutate_ply, 2), mutate_text],
    "stl": [*_each_of(mutate_stl, 1), mutate_text],
    "png": _each_of(mutate_png, 3),
    "jpg": _each_of(mutate_jpeg, 1),
    "hdr": [mutate_bytes, mutate_text],
    "exr": _each_of(mutate_exr, 1),
    "tif": _each_of(mutate_tiff, 1),
    "lut.exr": _each_of(mutate_exr, 2),
    "lut.png": _each_of(mutate_png, 3),
    "lut.npz": _each_of(mutate_npz, 4),
    "scene": _each_of(mutate_json_bytes, 8),
    "record": _each_of(mutate_json_bytes, 6),
    "report": [mutate_json_bytes],
}
"""Mutators by format; one of them is chosen for every change."""
