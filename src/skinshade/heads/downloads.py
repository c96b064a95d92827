"""Public scans of heads, which are downloaded on request and checked by their hashes."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from .._core.cache import cache_folder
from .._core.errors import ArgumentError, DownloadError

__all__ = ["SCANS", "Scan", "fetch_scan"]


@dataclass(frozen=True)
class Scan:
    """Location and hashes of a public scan.

    Attributes
    ----------
    base_url
        Address of the folder that holds the files.
    sha256
        Hash of each file by its name.
    credit
        Credit to show with every picture of the scan.
    unit_mm
        Length of one unit of the files, mm.
    """

    base_url: str
    sha256: Mapping[str, str]
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


def fetch_scan(
    name: str, folder: str | os.PathLike[str] | None = None, base_url: str | None = None
) -> list[Path]:
    """Download the files of a public scan that are not in the folder yet, and check their hashes.

    Parameters
    ----------
    name
        One of `SCANS`.
    folder
        Folder of the files; the user's cache if None.
    base_url
        Address of another folder with the same files.

    Returns
    -------
    list of Path
        Files of the scan.

    Raises
    ------
    ArgumentError, DownloadError
        If the scan is unknown, a file cannot be downloaded, or its hash differs.
    """
    if name not in SCANS:
        raise ArgumentError(f"there is no scan {name!r}; there are {', '.join(SCANS)}")
    scan = SCANS[name]
    target = Path(folder) if folder is not None else cache_folder()
    address = base_url or scan.base_url
    return [_fetch(address, file, sha256, target) for file, sha256 in scan.sha256.items()]


def _fetch(address: str, file: str, sha256: str, folder: Path) -> Path:
    import pooch

    try:
        path = pooch.retrieve(
            address + file,
            known_hash=f"sha256:{sha256}",
            fname=file,
            path=folder,
            progressbar=False,
        )
    except ValueError as error:
        raise DownloadError(f"{file}: the file has another hash than expected: {error}") from None
    except Exception as error:
        raise DownloadError(f"{address}{file}: cannot be fetched ({error})") from None
    return Path(path)
