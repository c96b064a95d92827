"""Fetch Khronos' glTF validator from npm, for the tests alone.

Run as ``python tools/gltf_validator_tool.py``. It goes into this environment; where npm is missing that
is said, and the tests that need it are skipped.
"""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path

VERSION = "2.0.0-dev.3.10"
FOLDER = Path(sys.prefix, "lib", "gltf-validator")
"""Where tests/gltf_validator.py looks for it."""


def installed_version() -> str:
    """Return the version that is there, or nothing."""
    described = FOLDER / "node_modules" / "gltf-validator" / "package.json"
    try:
        return str(json.loads(described.read_text(encoding="utf-8"))["version"])
    except (OSError, ValueError, KeyError):
        return ""


def fetch() -> str:
    """Put the validator into `FOLDER`; return why not, or nothing."""
    if installed_version() == VERSION:
        return ""
    npm = shutil.which("npm")
    if npm is None or shutil.which("node") is None:
        return "node and npm are not installed"
    FOLDER.mkdir(parents=True, exist_ok=True)
    command = [npm, "install", "--silent", "--no-audit", "--no-fund", "--ignore-scripts"]
    command += ["--prefix", str(FOLDER), f"gltf-validator@{VERSION}"]
    if subprocess.run(command).returncode or installed_version() != VERSION:
        return "npm could not install it"
    return ""


def main() -> None:
    """Fetch where possible, and tell."""
    why = fetch()
    if why:
        print(
            f"Missing, so the tests that need it will be skipped: Khronos' glTF validator ({why})"
        )


if __name__ == "__main__":
    main()
