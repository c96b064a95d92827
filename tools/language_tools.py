"""Fetch what runs the shader library in OpenGL, in a browser and as HLSL, for the tests alone.

Run as ``python tools/language_tools.py``. Chromium and OpenGL without a display come from Debian's
packages where the user is root and has apt-get; the DirectX shader compiler comes from inside a
Python package, which is neither built nor installed. What is missing in the end is named.
"""

from __future__ import annotations

import platform
import shutil
import subprocess
import sys
import tarfile
import tempfile
from pathlib import Path

from software_driver import install, succeeds

BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
DXC = Path(sys.prefix, "lib", "dxc", "libdxcompiler.so")
"""Where tests/parity/dxc.py looks for it."""
DXC_SOURCE = (
    "compushady==0.17.5"
    " --hash=sha256:5052caf9e955d8e7a48e22f536e82b44b72e83af46e824a9e99157c7809de691"
)
"""Its source archive holds DXC 1.7 for each kind of machine; the hash pins them all."""


def browser_is_there() -> bool:
    """Return whether Chromium, or its sister, is on the path."""
    return any(map(shutil.which, BROWSERS))


def opengl_is_there() -> bool:
    """Return whether a context of OpenGL 4.3 opens without a display."""
    return succeeds(
        "import moderngl; moderngl.create_context(standalone=True, backend='egl', require=430)"
    )


def fetch_dxc() -> str:
    """Put the DirectX shader compiler at `DXC`; return why not, or nothing."""
    if DXC.is_file():
        return ""
    if sys.platform != "linux":
        return "it is fetched for Linux only"
    with tempfile.TemporaryDirectory() as folder:
        wanted = Path(folder, "wanted.txt")
        wanted.write_text(DXC_SOURCE + "\n", encoding="utf-8")
        print("Fetching the DirectX shader compiler (67 MB)", flush=True)
        command = [
            sys.executable,
            "-m",
            "pip",
            "download",
            "--quiet",
            "--disable-pip-version-check",
        ]
        # From source, since the archive is what holds every machine's library.
        command += ["--no-deps", "--no-binary=compushady", "--require-hashes"]
        command += ["--requirement", str(wanted), "--dest", folder]
        if subprocess.run(command).returncode:
            return "the download failed"
        (archive,) = Path(folder).glob("*.tar.gz")
        return unpack_dxc(archive)


def unpack_dxc(archive: Path) -> str:
    """Take this machine's library out of the archive; return why not, or nothing."""
    name = f"libdxcompiler_{platform.machine()}.so.3.7"
    with tarfile.open(archive) as files:
        found = [each for each in files if each.isfile() and each.name.endswith(f"/{name}")]
        if not found:
            return f"the archive holds none for {platform.machine()}"
        DXC.parent.mkdir(parents=True, exist_ok=True)
        part = DXC.with_suffix(".part")  # a library that is cut off must not look whole
        with files.extractfile(found[0]) as library, part.open("wb") as copy:
            shutil.copyfileobj(library, copy)
        part.replace(DXC)
    return ""


def main() -> None:
    """Look, fetch where possible, and tell."""
    missing = [] if browser_is_there() else ["chromium"]
    missing += [] if opengl_is_there() else ["libegl1", "libgl1-mesa-dri"]
    install(missing)
    without_dxc = fetch_dxc()
    skipped = {
        "Chromium (Debian: chromium)": not browser_is_there(),
        "OpenGL by EGL (Debian: libegl1 libgl1-mesa-dri)": not opengl_is_there(),
        f"the DirectX shader compiler ({without_dxc})": bool(without_dxc),
    }
    for name in (name for name, skip in skipped.items() if skip):
        print(f"Missing, so the tests that need it will be skipped: {name}")


if __name__ == "__main__":
    main()
