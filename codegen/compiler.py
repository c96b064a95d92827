"""Calls of the Slang compiler; no other file calls it."""

from __future__ import annotations

import json
import os
import subprocess
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any, Literal

__all__ = [
    "LIBRARY",
    "PASSES",
    "CompilerError",
    "Language",
    "Translation",
    "assemble",
    "translate",
    "version",
]

Language = Literal["wgsl", "glsl", "hlsl", "metal"]
"""Target languages of the compiler. Dialects of GLSL differ only in the macros that are defined."""

PACKAGE = Path(__file__).resolve().parents[1] / "src" / "skinshade"
LIBRARY = PACKAGE / "shading"
"""Folder of the shader library; each file stands beside its NumPy twin."""
PASSES = PACKAGE / "rendering" / "gpu" / "passes"
"""Folder of the renderer's own passes."""


class CompilerError(Exception):
    """The Slang compiler is not installed, or it rejects a source."""


@dataclass(frozen=True)
class Translation:
    """Result of translating a source.

    Attributes
    ----------
    text
        Text in the target language.
    reflection
        The compiler's description of bindings and layouts.
    """

    text: str
    reflection: dict[str, Any]


def translate(
    source: str,
    language: Language,
    *,
    definitions: dict[str, str] | None = None,
    entry: str | None = None,
) -> Translation:
    """Translate a Slang text, which may include files of the library and of the passes.

    Parameters
    ----------
    source
        Slang text.
    language
        Target language.
    definitions
        Macros by name.
    entry
        Compute entry point to translate. If None, all entry points are translated, which is only possible
        for WGSL and Metal.

    Raises
    ------
    CompilerError
        If the compiler is not installed or rejects the source; the message is the compiler's.
    """
    options = [f"-D{name}={value}" for name, value in (definitions or {}).items()]
    if entry is not None:
        options += ["-entry", entry, "-stage", "compute"]
    options += ["-line-directive-mode", "none", "-reflection-json", "reflection"]
    files = _compiled(source, language, options)
    return Translation(files["out"].decode("utf-8"), json.loads(files["reflection"]))


def _compiled(source: str, target: str, options: list[str]) -> dict[str, bytes]:
    """Return every file that the compiler writes, by name."""
    with tempfile.TemporaryDirectory() as folder:
        work_dir = Path(folder)
        # The output does not contain the name of this file, because line directives are off.
        (work_dir / "source.slang").write_text(source, encoding="utf-8")
        command = [str(_slangc()), "source.slang", "-target", target]
        command += ["-I", str(LIBRARY), "-I", str(PASSES)]
        process = subprocess.run(
            [*command, *options, "-o", "out"],
            cwd=work_dir,
            env=_environment(),
            capture_output=True,
            text=True,
        )
        if process.returncode:
            raise CompilerError(f"slangc, {target}: {process.stderr.strip()[:2000]}")
        return {path.name: path.read_bytes() for path in work_dir.iterdir()}


def assemble(source: str, stages: Mapping[str, str]) -> bytes:
    """Return the SPIR-V of a Slang text, without optimisation.

    Parameters
    ----------
    source
        Slang text, which may include files of the library and of the passes.
    stages
        Stage of each entry point, by the name of the entry point.

    Raises
    ------
    CompilerError
        If the compiler is not installed or rejects the source; the message is the compiler's.
    """
    options = ["-O0", "-fvk-use-entrypoint-name"]
    for entry, stage in stages.items():
        options += ["-entry", entry, "-stage", stage]
    return _compiled(source, "spirv", options)["out"]


@cache
def version() -> str:
    """Return the compiler's version."""
    process = subprocess.run(
        [str(_slangc()), "-v"], env=_environment(), capture_output=True, text=True, check=True
    )
    return (process.stdout + process.stderr).strip()


@cache
def _slangc() -> Path:
    # The wheel of slangtorch, a binding for PyTorch, contains the compiler. The binding is not imported.
    spec = find_spec("slangtorch")
    for folder in (spec.submodule_search_locations or []) if spec else []:
        program = Path(folder) / "bin" / ("slangc.exe" if os.name == "nt" else "slangc")
        if program.exists():
            return program
    raise CompilerError("slangc is not installed; run tools/shader_compiler.py")


def _environment() -> dict[str, str]:
    return {**os.environ, "LD_LIBRARY_PATH": str(_slangc().parent)}
