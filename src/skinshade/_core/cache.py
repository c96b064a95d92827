"""Files of arrays that are expensive to compute, kept in the user's cache by the hash of their inputs."""

from __future__ import annotations

import hashlib
import os
import zipfile
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .errors import OutputError
from .files import atomic_write

__all__ = ["cache_folder", "content_hash", "load_cached", "store_cached"]

MOST_BYTES = 512 << 20
"""Size of the cache above which the files that were read longest ago are removed."""


def cache_folder() -> Path:
    """Return the folder of the user's cache; the environment variable ``SKINSHADE_CACHE`` chooses another."""
    chosen = os.environ.get("SKINSHADE_CACHE")
    if chosen:
        return Path(chosen)
    from platformdirs import user_cache_dir

    return Path(user_cache_dir("skinshade"))


def content_hash(kind: str, *inputs: NDArray[np.generic] | float) -> str:
    """Return a name for a result that has these inputs; `kind` names the computation and its version."""
    digest = hashlib.blake2b(kind.encode(), digest_size=16)
    for value in inputs:
        array = np.ascontiguousarray(value)
        digest.update(f"{array.dtype.str}{array.shape}".encode())
        digest.update(array.data)
    return f"{kind}-{digest.hexdigest()}"


def load_cached(name: str) -> dict[str, NDArray[np.generic]] | None:
    """Return the arrays that are stored under a name; None if they are absent or damaged."""
    path = _array_folder() / f"{name}.npz"
    try:
        with path.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
            arrays = dict(archive)
        path.touch()
    except (OSError, ValueError, EOFError, zipfile.BadZipFile):
        return None
    return arrays


def store_cached(name: str, arrays: Mapping[str, NDArray[np.generic]]) -> None:
    """Store arrays under a name. Where the cache cannot be written, nothing is stored."""
    with suppress(OSError, OutputError):
        folder = _array_folder()
        folder.mkdir(parents=True, exist_ok=True)
        with atomic_write(folder / f"{name}.npz") as path, path.open("wb") as stream:
            # NumPy's stubs do not tell named arrays from its own parameters.
            np.savez(stream, **arrays)  # type: ignore[arg-type]
        _remove_oldest(folder)


def _array_folder() -> Path:
    return cache_folder() / "arrays"


def _remove_oldest(folder: Path) -> None:
    """Remove files of a folder, beginning with those read longest ago, until the rest is small enough."""
    files = sorted(
        (
            (status.st_mtime, status.st_size, path)
            for path in folder.glob("*.npz")
            if (status := path.stat())
        ),
        reverse=True,
    )
    total = 0
    for _, size, path in files:
        total += size
        if total > MOST_BYTES:
            path.unlink(missing_ok=True)
