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


def adapters() -> int:
    """Return how many Vulkan adapters a new process finds."""
    script = (
        "import wgpu; print(sum(a.info['backend_type'] == 'Vulkan'"
        " for a in wgpu.gpu.enumerate_adapters_sync()))"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    return int(done.stdout.strip() or 0) if done.returncode == 0 else 0


def main() -> None:
    """Look, install where possible, and tell."""
    missing = [DRIVER] if not adapters() else []
    missing += [COMPILER] if shutil.which("glslangValidator") is None else []
    root = hasattr(os, "geteuid") and os.geteuid() == 0
    if missing and root and shutil.which("apt-get"):
        print(f"Installing {' and '.join(missing)}")
        quiet = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
        for command in (["update"], ["install", "--yes", "--no-install-recommends", *missing]):
            subprocess.run(["apt-get", "-qq", *command], env=quiet, check=False)
    if not adapters():
        print(HOW)


if __name__ == "__main__":
    main()
