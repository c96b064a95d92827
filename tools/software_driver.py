"""Install a Vulkan driver and the GLSL reference compiler where they are missing, for the tests alone.

Run as ``python tools/software_driver.py``. It installs Debian packages if the user is root and apt-get is
available, otherwise it prints what to install. The driver is Mesa's software rasterizer.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys

DRIVER, COMPILER = "mesa-vulkan-drivers", "glslang-tools"
HINT = f"""No Vulkan driver was found, so the tests on the GPU will be skipped.
Install your GPU's driver, or Mesa's software rasterizer: {DRIVER} on Debian, Ubuntu and Fedora."""


def succeeds(script: str) -> bool:
    """Return whether a script runs to its end in a new process, which looks for drivers afresh.

    With ``-P``, the process does not import modules from the current folder.
    """
    return subprocess.run([sys.executable, "-P", "-c", script], capture_output=True).returncode == 0


def driver_is_installed() -> bool:
    """Return whether wgpu finds a Vulkan adapter."""
    return succeeds(
        "import wgpu; assert any(a.info['backend_type'] == 'Vulkan'"
        " for a in wgpu.gpu.enumerate_adapters_sync())"
    )


def install(packages: list[str]) -> None:
    """Install Debian packages one by one, if the user may; a failure does not stop the others."""
    root = hasattr(os, "geteuid") and os.geteuid() == 0
    if not (packages and root and shutil.which("apt-get")):
        return
    print(f"Installing {' and '.join(packages)}", flush=True)
    quiet = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    commands = [["update"]]
    commands += [["install", "--yes", "--no-install-recommends", name] for name in packages]
    for command in commands:
        subprocess.run(["apt-get", "-qq", *command], env=quiet, check=False)


def main() -> None:
    """Install what is missing, and print a hint if there is still no driver."""
    missing = [] if driver_is_installed() else [DRIVER]
    missing += [COMPILER] if shutil.which("glslangValidator") is None else []
    install(missing)
    if not driver_is_installed():
        print(HINT)


if __name__ == "__main__":
    main()
