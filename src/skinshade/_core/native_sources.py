"""Sources of the compiled kernels, and the name of the library that belongs to them.

The build loads this file by its path, before any package is installed: it imports the standard library only.
"""

from __future__ import annotations

import hashlib
import sys
from pathlib import Path

__all__ = ["FOLDER", "library_name", "source_hash"]

FOLDER = Path(__file__).with_name("native")
"""Folder of the sources and of the library."""


def source_hash(folder: Path = FOLDER) -> str:
    """Return the hash of all sources in a folder, 16 hexadecimal digits."""
    digest = hashlib.sha256()
    for path in sorted(folder.glob("*.[ch]"), key=lambda path: path.name):
        # Git may give text files the line ends of the system.
        text = path.read_bytes().replace(b"\r\n", b"\n")
        digest.update(f"{path.name}\0{len(text)}\0".encode())
        digest.update(text)
    return digest.hexdigest()[:16]


def library_name(hash_of_sources: str, platform: str = sys.platform) -> str:
    """Return the file name of the library for a value of `sys.platform`."""
    if platform == "win32":
        return f"skinshade_native-{hash_of_sources}.dll"
    suffix = "dylib" if platform == "darwin" else "so"
    return f"libskinshade_native-{hash_of_sources}.{suffix}"
