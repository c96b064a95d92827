"""The Slang compiler: the one file that knows it."""

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

from .._core.errors import CompilerError

__all__ = ["LIBRARY", "Language", "Translation", "assemble", "translate", "version"]

Language = Literal["wgsl", "glsl", "hlsl", "metal"]
"""What the compiler writes; dialects of GLSL differ by definitions alone."""

LIBRARY = Path(__file__).resolve().parents[1] / "shaders" / "skin"


@dataclass(frozen=True)
class Translation:
    """What came of a source.

    Attributes
    ----------
    text
        In the language asked for.
    reflection
        The compiler's own description of bindings and layouts.
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
    """Translate a Slang text, which may include the library's files.

    Parameters
    ----------
    source
        The text.
    language
        Of the result.
    definitions
        Macros.
    entry
        The one compute entry point to write; all of them if None, which only WGSL and Metal can hold.

    Raises
    ------
    CompilerError
        With the compiler's first complaint.
    """
    options = [f"-D{name}={value}" for name, value in (definitions or {}).items()]
    if entry is not None:
        options += ["-entry", entry, "-stage", "compute"]
    options += ["-line-directive-mode", "none", "-reflection-json", "reflection"]
    made = _compiled(source, language, options)
    return Translation(made["out"].decode("utf-8"), json.loads(made["reflection"]))


def _compiled(source: str, target: str, options: list[str]) -> dict[str, bytes]:
    """Every file that the compiler writes, by name."""
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        # Its name reaches no output: line directives are off.
        (place / "source.slang").write_text(source, encoding="utf-8")
        command = [str(_slangc()), "source.slang", "-I", str(LIBRARY), "-target", target]
        done = subprocess.run(
            [*command, *options, "-o", "out"],
            cwd=place,
            env=_environment(),
            capture_output=True,
            text=True,
        )
        if done.returncode:
            raise CompilerError(f"slangc, {target}: {done.stderr.strip()[:2000]}")
        return {path.name: path.read_bytes() for path in place.iterdir()}


def assemble(source: str, stages: Mapping[str, str]) -> bytes:
    """Return SPIR-V of a Slang text; drivers optimise it, the compiler does not.

    Parameters
    ----------
    source
        The text, which may include the library's files.
    stages
        Names of entry points, and the stage of each.

    Raises
    ------
    CompilerError
        With the compiler's first complaint.
    """
    options = ["-O0", "-fvk-use-entrypoint-name"]
    for entry, stage in stages.items():
        options += ["-entry", entry, "-stage", stage]
    return _compiled(source, "spirv", options)["out"]


@cache
def version() -> str:
    """Return the compiler's version."""
    done = subprocess.run(
        [str(_slangc()), "-v"], env=_environment(), capture_output=True, text=True, check=True
    )
    return (done.stdout + done.stderr).strip()


@cache
def _slangc() -> Path:
    # The wheel of its PyTorch binding carries the compiler; the binding itself is not imported.
    found = find_spec("slangtorch")
    places = list(found.submodule_search_locations or []) if found else []
    for place in places:
        program = Path(place) / "bin" / "slangc"
        if program.exists():
            return program
    raise CompilerError("slangc is not installed; run `make shaders`")


def _environment() -> dict[str, str]:
    return {**os.environ, "LD_LIBRARY_PATH": str(_slangc().parent)}
