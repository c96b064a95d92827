"""Install what runs the shader library in OpenGL, in a browser and as HLSL, for the tests alone.

Run as ``python tools/language_tools.py``. Chromium and OpenGL without a display are Debian packages, which
are installed if the user is root and apt-get is available. The DirectX shader compiler is unpacked from the
source archive of a Python package, which is neither built nor installed. What is still missing afterwards
is printed.
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
"""Path at which tests/parity/dxc.py looks for the DirectX shader compiler."""
DXC_SOURCE = (
    "compushady==0.17.5"
    " --hash=sha256:5052caf9e955d8e7a48e22f536e82b44b72e83af46e824a9e99157c7809de691"
)
"""Source archive with DXC 1.7 for every processor architecture; the hash pins all of them."""


def browser_is_installed() -> bool:
    """Return whether Chromium or Chrome is on the path."""
    return any(map(shutil.which, BROWSERS))


def opengl_is_installed() -> bool:
    """Return whether a context of OpenGL 4.3 opens without a display."""
    return succeeds(
        "import moderngl; moderngl.create_context(standalone=True, backend='egl', require=430)"
    )


def install_dxc() -> str:
    """Install the DirectX shader compiler as `DXC`; return the reason of a failure, or an empty text."""
    if DXC.is_file():
        return ""
    if sys.platform != "linux":
        return "it is downloaded for Linux only"
    with tempfile.TemporaryDirectory() as folder:
        requirements = Path(folder, "requirements.txt")
        requirements.write_text(DXC_SOURCE + "\n", encoding="utf-8")
        print("Downloading the DirectX shader compiler (67 MB)", flush=True)
        command = [sys.executable, "-P", "-m", "pip", "download", "--quiet"]
        command += ["--disable-pip-version-check", "--no-deps", "--require-hashes"]
        # Only the source archive contains the libraries of all architectures.
        command += ["--no-binary=compushady"]
        command += ["--requirement", str(requirements), "--dest", folder]
        if subprocess.run(command).returncode:
            return "the download failed"
        (archive,) = Path(folder).glob("*.tar.gz")
        return unpack_dxc(archive)


def unpack_dxc(archive: Path) -> str:
    """Unpack the library of this architecture; return the reason of a failure, or an empty text."""
    name = f"libdxcompiler_{platform.machine()}.so.3.7"
    with tarfile.open(archive) as files:
        members = [m for m in files if m.isfile() and m.name.endswith(f"/{name}")]
        if not members:
            return f"the archive has none for {platform.machine()}"
        DXC.parent.mkdir(parents=True, exist_ok=True)
        partial = DXC.with_suffix(".part")  # an interrupted copy must not look complete
        with files.extractfile(members[0]) as library, partial.open("wb") as copy:
            shutil.copyfileobj(library, copy)
        partial.replace(DXC)
    return ""


def main() -> None:
    """Install what is missing, and print what could not be installed."""
    packages = [] if browser_is_installed() else ["chromium"]
    packages += [] if opengl_is_installed() else ["libegl1", "libgl1-mesa-dri"]
    install(packages)
    reason = install_dxc()
    missing = {
        "Chromium (Debian: chromium)": not browser_is_installed(),
        "OpenGL by EGL (Debian: libegl1 libgl1-mesa-dri)": not opengl_is_installed(),
        f"the DirectX shader compiler ({reason})": bool(reason),
    }
    for name in (name for name, is_missing in missing.items() if is_missing):
        print(f"Missing, so the tests that use it will be skipped: {name}")


if __name__ == "__main__":
    main()
