"""Install Khronos' glTF validator from npm into this environment, for the tests alone.

Run as ``python tools/gltf_validator_tool.py``. Without npm it prints why the tests that use the validator
will be skipped.
"""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path

VERSION = "2.0.0-dev.3.10"
FOLDER = Path(sys.prefix, "lib", "gltf-validator")
"""Folder in which tests/gltf_validator.py looks for the validator."""


def installed_version() -> str:
    """Return the installed version, or an empty text."""
    package = FOLDER / "node_modules" / "gltf-validator" / "package.json"
    try:
        return str(json.loads(package.read_text(encoding="utf-8"))["version"])
    except (OSError, ValueError, KeyError):
        return ""


def install() -> str:
    """Install the validator into `FOLDER`; return the reason of a failure, or an empty text."""
    if installed_version() == VERSION:
        return ""
    npm = shutil.which("npm")
    if npm is None or shutil.which("node") is None:
        return "node and npm are not installed"
    if Path(npm).resolve().parent == Path.cwd():  # where Windows looks first
        return f"{npm} is in the current folder; run this in another one"
    FOLDER.mkdir(parents=True, exist_ok=True)
    command = [npm, "install", "--silent", "--no-audit", "--no-fund", "--ignore-scripts"]
    command += ["--prefix", str(FOLDER), f"gltf-validator@{VERSION}"]
    if subprocess.run(command).returncode or installed_version() != VERSION:
        return "npm could not install it"
    return ""


def main() -> None:
    """Install the validator, or print why it is missing."""
    reason = install()
    if reason:
        print(
            f"Khronos' glTF validator is missing ({reason}); the tests that use it will be skipped"
        )


if __name__ == "__main__":
    main()
