"""Install the Slang compiler, which `make shaders` and the tests of generated files need.

Run as ``python tools/shader_compiler.py``. The compiler is inside the wheel of its PyTorch binding, which
is installed without PyTorch. Where there is no wheel for this machine, a message says so.
"""

from __future__ import annotations

import subprocess
import sys

PACKAGE = "slangtorch==1.3.22"


def main() -> None:
    """Install the package."""
    command = [
        sys.executable,
        "-P",
        "-m",
        "pip",
        "install",
        "--quiet",
        "--disable-pip-version-check",
    ]
    if subprocess.run([*command, "--no-deps", "--only-binary=:all:", PACKAGE]).returncode:
        print("Missing, so the tests that need it will be skipped: the Slang compiler")


if __name__ == "__main__":
    main()
