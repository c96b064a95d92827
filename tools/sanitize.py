"""Run the tests of the compiled kernels with checks of addresses and undefined behaviour.

``make sanitize`` runs ``python tools/sanitize.py [files of tests]``. It needs GCC or Clang on Linux.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path

import native_library

TESTS = (
    "tests/unit/_core/test_core_native.py",
    "tests/unit/mesh",
    "tests/unit/rendering/test_rendering_compiled.py",
)


def main() -> None:
    """Compile the kernels with sanitizers, and run the tests with them."""
    command = native_library.system_compiler()
    if command is None or not sys.platform.startswith("linux"):
        sys.exit("the sanitizers need GCC or Clang on Linux")
    runtime = subprocess.run(
        [*command, "-print-file-name=libasan.so"], check=True, capture_output=True, text=True
    ).stdout.strip()
    with tempfile.TemporaryDirectory() as folder:
        native_library.build(command, Path(folder), sanitize=True)
        settings = {
            "SKINSHADE_NATIVE": folder,
            "LD_PRELOAD": runtime,
            "ASAN_OPTIONS": "detect_leaks=0",  # Python keeps memory until its end
            "UBSAN_OPTIONS": "print_stacktrace=1",
        }
        tests = sys.argv[1:] or TESTS
        done = subprocess.run(
            [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", *tests],
            cwd=native_library.ROOT,
            env=os.environ | settings,
            check=False,
        )
    sys.exit(done.returncode)


if __name__ == "__main__":
    main()
