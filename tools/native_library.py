"""Compile the native kernels; the only place of compile flags.

``make native`` runs it for developers: ``python tools/native_library.py`` compiles the library
next to its sources, where skinshade finds it. The build of wheels (hatch_build.py, tools/wheels.py) and
``make sanitize`` (tools/sanitize.py) use its functions.
"""

from __future__ import annotations

import argparse
import importlib.util
import os
import platform
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

ROOT = Path(__file__).resolve().parents[1]
COMMON = ("-O3", "-std=c11", "-fno-math-errno", "-fno-trapping-math", "-ffp-contract=off")
COMMON += ("-fvisibility=hidden",)
"""Flags of all compilers. Without contraction, results have the same bytes with and without FMA. Traps of
comparisons, which nothing uses, would keep GCC from vectors."""
WARNINGS = ("-Wall", "-Wextra", "-Wno-psabi")
SANITIZE = ("-O1", "-g", "-fno-omit-frame-pointer", "-fsanitize=address,undefined")
SANITIZE += ("-fno-sanitize-recover=undefined",)
LEVELS = {"x86_64": {"v2": "x86-64-v2", "v3": "x86-64-v3"}}
"""Levels of instructions of a processor, each compiled from the same files, and their architectures."""
ONCE = "abi.c"
"""The source without kernels, which is not compiled per level."""


WHEEL_TARGET = "SKINSHADE_WHEEL_TARGET"
"""Environment variable with the target of a wheel: a key of `TARGETS`. This machine's if it is not set."""
ZIG_REQUIREMENT = "ziglang>=0.13; platform_machine in 'x86_64 AMD64 aarch64 arm64 ARM64'"
"""Package with a C compiler, which also compiles for other systems."""


NO_COMPILER = "no C compiler; install one, or `pip install ziglang`"


class NoCompilerError(Exception):
    """No C compiler is installed."""


@dataclass(frozen=True)
class Target:
    """System and processor that the library is for.

    Attributes
    ----------
    system
        A value of `sys.platform`: linux, darwin or win32.
    machine
        x86_64, aarch64 or another name of the processor.
    tag
        Tag of the platform in names of wheels.
    triple
        Name of the target for zig; None for this machine.
    """

    system: str
    machine: str
    tag: str
    triple: str | None = None

    @classmethod
    def own(cls) -> Target:
        """Return the target of this machine."""
        machine = platform.machine().lower()
        machine = {"amd64": "x86_64", "arm64": "aarch64"}.get(machine, machine)
        # A Python for several processors of Apple loads libraries of the own one.
        tag = sysconfig.get_platform().replace("universal2", platform.machine())
        return cls(sys.platform, machine, tag.replace("-", "_").replace(".", "_"))


TARGETS = {
    "linux-x86_64": Target(
        "linux",
        "x86_64",
        "manylinux_2_17_x86_64.manylinux2014_x86_64",
        "x86_64-linux-gnu.2.17",
    ),
    "linux-aarch64": Target(
        "linux",
        "aarch64",
        "manylinux_2_17_aarch64.manylinux2014_aarch64",
        "aarch64-linux-gnu.2.17",
    ),
    "macos-x86_64": Target("darwin", "x86_64", "macosx_11_0_x86_64", "x86_64-macos.11.0"),
    "macos-arm64": Target("darwin", "aarch64", "macosx_11_0_arm64", "aarch64-macos.11.0"),
    "windows-x86_64": Target("win32", "x86_64", "win_amd64", "x86_64-windows-gnu"),
}
"""Targets of `make wheels`."""


def sources_module() -> ModuleType:
    """Return src/skinshade/_core/native_sources.py without an import of skinshade."""
    path = ROOT / "src" / "skinshade" / "_core" / "native_sources.py"
    spec = importlib.util.spec_from_file_location("native_sources", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def zig() -> list[str] | None:
    """Return the command of the C compiler in the ziglang package, or None."""
    if importlib.util.find_spec("ziglang") is None:
        return None
    return [sys.executable, "-m", "ziglang", "cc"]


def system_compiler() -> list[str] | None:
    """Return the command of the C compiler that $CC names or that is in PATH, or None."""
    named = shlex.split(os.environ.get("CC", ""), posix=os.name == "posix")
    if named and shutil.which(named[0]):
        return named
    path = next(filter(None, map(shutil.which, ("cc", "gcc", "clang", "clang-cl"))), None)
    # clang-cl has the options of another compiler; clang comes with it.
    return None if path is None else [path.replace("clang-cl", "clang")]


def compiler() -> list[str] | None:
    """Return the command of a C compiler: the system's, else that of ziglang, else None."""
    return system_compiler() or zig()


def build_for_wheel(name: str | None, folder: Path) -> tuple[Path, str]:
    """Compile the library for a target into a folder; return its path and the tag of the platform.

    Parameters
    ----------
    name
        Key of `TARGETS`, or None for this machine.
    folder
        Folder of the library.

    Raises
    ------
    NoCompilerError
        If no compiler is installed, or zig is not and the target is another one.
    subprocess.CalledProcessError
        If the compiler fails.
    """
    target = TARGETS[name] if name else Target.own()
    command = zig() if name else compiler()
    if command is None:
        raise NoCompilerError(NO_COMPILER)
    return build(command, folder, target), target.tag


def build(
    command: list[str], folder: Path, target: Target | None = None, *, sanitize: bool = False
) -> Path:
    """Compile the library into a folder, and return its path.

    Parameters
    ----------
    command
        Command of the compiler.
    folder
        Folder of the library.
    target
        System and processor; those of this machine if None.
    sanitize
        Check addresses and undefined behaviour at run time.

    Raises
    ------
    subprocess.CalledProcessError
        If the compiler fails; its messages are in `stderr`.
    """
    target = target or Target.own()
    module = sources_module()
    hash_of_sources = module.source_hash()
    selected = [] if target.triple is None else ["-target", target.triple]
    flags = [*COMMON, *WARNINGS, *selected, f'-DSKN_SOURCE_HASH="{hash_of_sources}"']
    flags += SANITIZE if sanitize else ()
    flags += [] if target.system == "win32" else ["-fPIC"]
    is_zig = "ziglang" in command
    if is_zig and not sanitize:
        flags.append("-fno-sanitize=undefined")  # zig checks for undefined behaviour by default
    with tempfile.TemporaryDirectory() as scratch:
        objects, jobs = [], []
        for source in sorted(module.FOLDER.glob("*.c")):
            levels = {} if source.name == ONCE else LEVELS.get(target.machine, {})
            for level, architecture in (levels or {"base": ""}).items():
                output = Path(scratch) / f"{source.stem}_{level}.o"
                special = [f"-DSKN_LEVEL={level}"]
                if architecture:  # zig's names have underscores
                    special += [
                        f"-march={architecture.replace('-', '_') if is_zig else architecture}"
                    ]
                jobs.append([*command, *flags, *special, "-c", str(source), "-o", str(output)])
                objects.append(str(output))
        with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
            list(pool.map(_run, jobs))
        library = Path(scratch) / module.library_name(hash_of_sources, target.system)
        linked = [*command, *selected, *(SANITIZE if sanitize else ()), "-shared"]
        linked += ["-Wl,-s"] if target.system == "linux" and not sanitize else []
        _run([*linked, *objects, "-o", str(library)])
        folder.mkdir(parents=True, exist_ok=True)
        # A library that a process has loaded must not be overwritten, but can be replaced.
        result = folder / library.name
        moved = shutil.copy2(library, result.with_suffix(f".{os.getpid()}"))
        Path(moved).replace(result)
    return result


def build_program(source: Path, folder: str, triple: str | None = None) -> Path:
    """Compile a program that calls the kernels of the baseline level into a folder; return its path.

    `triple` is the name of a target for zig; the program is for this machine if it is None.
    """
    command = compiler() if triple is None else zig()
    if command is None:
        raise NoCompilerError(NO_COMPILER)
    module = sources_module()
    sources = [str(path) for path in sorted(module.FOLDER.glob("*.c")) if path.name != ONCE]
    flags = [*COMMON, *WARNINGS, "-DSKN_LEVEL=base", f"-I{module.FOLDER}"]
    flags += [] if triple is None else ["-target", triple, "-static", "-fno-sanitize=undefined"]
    program = Path(folder) / source.stem
    _run([*command, *flags, str(source), *sources, "-lm", "-o", str(program)])
    return program


def _run(command: list[str]) -> None:
    subprocess.run(command, check=True, capture_output=True, text=True)


def main() -> None:
    """Compile the library for this machine, next to its sources."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "--digest",
        nargs="+",
        metavar=("FOLDER", "TARGET"),
        help="compile tools/kernel_digest.c into a folder instead, for a target of zig",
    )
    options = parser.parse_args()
    try:
        if options.digest:
            build_program(Path(__file__).with_name("kernel_digest.c"), *options.digest)
            return
        command = compiler()
        if command is None:
            raise NoCompilerError(NO_COMPILER)
        folder = sources_module().FOLDER
        library = build(command, folder)
    except NoCompilerError as error:
        sys.exit(str(error))
    except subprocess.CalledProcessError as error:
        sys.exit(f"{shlex.join(error.cmd)} failed:\n{error.stderr}")
    for stale in folder.glob("*skinshade_native-*"):
        if stale != library:
            stale.unlink()
    print(f"{library.relative_to(ROOT)} ({library.stat().st_size / 1024:.0f} KiB)")


if __name__ == "__main__":
    main()
