"""The Slang compiler: the one file that knows it."""

from __future__ import annotations

import json
import os
import subprocess
import tempfile
from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any, Literal

from .._core.errors import CompilerError

__all__ = ["LIBRARY", "Language", "Translation", "translate", "version"]

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
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        # Its name reaches no output: line directives are off.
        (place / "source.slang").write_text(source, encoding="utf-8")
        command = [str(_slangc()), "source.slang", "-I", str(LIBRARY), "-target", language]
        command += [f"-D{name}={value}" for name, value in (definitions or {}).items()]
        if entry is not None:
            command += ["-entry", entry, "-stage", "compute"]
        command += ["-line-directive-mode", "none", "-o", "out.txt"]
        command += ["-reflection-json", "reflection.json"]
        done = subprocess.run(
            command, cwd=place, env=_environment(), capture_output=True, text=True
        )
        if done.returncode:
            raise CompilerError(f"slangc, {language}: {done.stderr.strip()[:2000]}")
        text = (place / "out.txt").read_text(encoding="utf-8")
        reflection = json.loads((place / "reflection.json").read_text(encoding="utf-8"))
    return Translation(text, reflection)


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
