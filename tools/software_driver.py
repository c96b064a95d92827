"""Make sure that a Vulkan driver and the GLSL reference compiler are there.

Run as ``python tools/software_driver.py``. Where one is missing, and the user is root and has apt-get,
installs it (the driver is Mesa's software rasteriser); else says how.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys

DRIVER, COMPILER = "mesa-vulkan-drivers", "glslang-tools"
HOW = f"""No Vulkan driver was found, so tests on the GPU will be skipped.
Install your GPU's driver, or Mesa's software rasteriser: {DRIVER} on Debian, Ubuntu and Fedora."""


def succeeds(script: str) -> bool:
    """Return whether a new process runs a script to its end: this one may have looked before."""
    return subprocess.run([sys.executable, "-c", script], capture_output=True).returncode == 0


def driver_is_there() -> bool:
    """Return whether a Vulkan adapter is found."""
    return succeeds(
        "import wgpu; assert any(a.info['backend_type'] == 'Vulkan'"
        " for a in wgpu.gpu.enumerate_adapters_sync())"
    )


def install(packages: list[str]) -> None:
    """Install Debian's packages where the user may; one that fails leaves the others."""
    root = hasattr(os, "geteuid") and os.geteuid() == 0
    if not (packages and root and shutil.which("apt-get")):
        return
    print(f"Installing {' and '.join(packages)}", flush=True)
    quiet = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    one_by_one = (["install", "--yes", "--no-install-recommends", each] for each in packages)
    for command in (["update"], *one_by_one):
        subprocess.run(["apt-get", "-qq", *command], env=quiet, check=False)


def main() -> None:
    """Look, install where possible, and tell."""
    missing = [] if driver_is_there() else [DRIVER]
    missing += [COMPILER] if shutil.which("glslangValidator") is None else []
    install(missing)
    if not driver_is_there():
        print(HOW)


if __name__ == "__main__":
    main()
