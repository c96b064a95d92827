"""Build wheels for all systems on one machine, and run those that this machine can run.

``make wheels`` runs ``python tools/wheels.py``. Every wheel has the kernels compiled by zig for its system.
The wheel of this system is installed in a new environment, where its kernels must give the same curvature as
NumPy. The kernels of 64-bit ARM run on an emulator, if ``qemu-aarch64`` is installed, and must give the same
bytes as those of this machine.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import venv
import zipfile
from pathlib import Path

import native_library

ROOT = Path(__file__).resolve().parents[1]
CHECK = """
import os, subprocess, sys
import numpy as np
import skinshade as sk
from skinshade._core import native
mesh = sk.builtin_head().mesh
curvature = sk.mesh_curvature(mesh.positions_mm, mesh.faces)
if len(sys.argv) > 1:
    np.save(sys.argv[1], curvature)
else:
    assert native.available(), native.reason()
    environment = os.environ | {"SKINSHADE_NATIVE": "0"}
    subprocess.run([sys.executable, "-c", os.environ["CHECK"], "numpy.npy"], env=environment, check=True)
    assert np.allclose(curvature, np.load("numpy.npy"), rtol=1e-9, atol=1e-12)
    print(native.reason())
"""
"""Program that compares the curvature of the built-in head with that of NumPy in a second process."""
EMULATORS = ("qemu-aarch64-static", "qemu-aarch64")


def new_environment(folder: str, *packages: str) -> Path:
    """Create a virtual environment with packages, and return its Python."""
    venv.create(folder, with_pip=True)
    python = Path(folder) / ("Scripts" if os.name == "nt" else "bin") / "python"
    command = [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    subprocess.run([*command, *packages], check=True)
    return python


def build_wheel(target: str, folder: Path, python: Path) -> Path:
    """Build the wheel of a target with hatchling and zig of an environment, and return its path."""
    settings = {native_library.WHEEL_TARGET: target, "SKINSHADE_REQUIRE_NATIVE": "1"}
    with tempfile.TemporaryDirectory() as scratch:
        command = [str(python), "-m", "pip", "wheel", "--quiet", "--disable-pip-version-check"]
        command += ["--no-build-isolation", "--no-deps", "--wheel-dir", scratch, str(ROOT)]
        subprocess.run(command, check=True, env=os.environ | settings)
        (wheel,) = Path(scratch).glob("*.whl")
        folder.mkdir(parents=True, exist_ok=True)
        return Path(shutil.move(wheel, folder / wheel.name))


def run_wheel(wheel: Path) -> str:
    """Install a wheel in a new environment, and return which kernels it uses there."""
    with tempfile.TemporaryDirectory() as scratch:
        python = new_environment(scratch, str(wheel))
        environment = {k: v for k, v in os.environ.items() if not k.startswith(("PYTHON", "SKIN"))}
        done = subprocess.run(
            [python, "-c", CHECK],
            check=True,
            cwd=scratch,
            env=environment | {"CHECK": CHECK},
            capture_output=True,
            text=True,
        )
        return done.stdout.strip()


def kernel_digest(python: Path, triple: str | None, run: list[str]) -> str:
    """Compile tools/kernel_digest.c for a target by zig, and return the digest of the kernels' results."""
    with tempfile.TemporaryDirectory() as scratch:
        command = [str(python), str(ROOT / "tools" / "native_library.py"), "--digest", scratch]
        subprocess.run([*command, *([triple] if triple else [])], check=True)
        program = str(Path(scratch) / "kernel_digest")
        return subprocess.run(
            [*run, program], check=True, capture_output=True, text=True
        ).stdout.strip()


def check_content(wheel: Path, target: native_library.Target) -> None:
    """Raise an error unless a wheel has the library of its sources, once."""
    module = native_library.sources_module()
    name = module.library_name(module.source_hash(), target.system)
    names = [n for n in zipfile.ZipFile(wheel).namelist() if "skinshade_native-" in n]
    if names != [f"skinshade/_core/native/{name}"]:
        sys.exit(f"{wheel.name}: its libraries are {names}; it must have {name} alone")


def main() -> None:
    """Build and check the wheels."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("targets", nargs="*", default=list(native_library.TARGETS))
    parser.add_argument("--out", type=Path, default=ROOT / "dist")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        python = new_environment(scratch, "hatchling", native_library.ZIG_REQUIREMENT)
        for name in options.targets:
            wheel = build_wheel(name, options.out, python)
            check_content(wheel, native_library.TARGETS[name])
            result = checked(wheel, native_library.TARGETS[name], python)
            print(f"{wheel.name} ({wheel.stat().st_size / 1024:.0f} KiB): {result}", flush=True)


def checked(wheel: Path, target: native_library.Target, python: Path) -> str:
    """Run the wheel if this machine can, and return what was done."""
    own = native_library.Target.own()
    if (target.system, target.machine) == (own.system, own.machine):
        return f"built, run: {run_wheel(wheel)}"
    emulator = next(filter(None, map(shutil.which, EMULATORS)), None)
    if target.system != "linux" or target.machine != "aarch64" or emulator is None:
        return "built, not run"
    emulated = kernel_digest(python, "aarch64-linux-musl", [emulator])
    if emulated != kernel_digest(python, None, []):
        sys.exit(f"{wheel.name}: the kernels give other bytes on an emulator than on this machine")
    return "built; its kernels give the same bytes on an emulator as on this machine"


if __name__ == "__main__":
    main()
