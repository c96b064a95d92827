"""What functions the library has, read from its commented source."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from .._core.errors import CompilerError
from .compiler import LIBRARY

__all__ = ["FLOATS", "NUMBERS", "Parameter", "Signature", "signatures", "twin_module"]

FUNCTION = re.compile(
    r"^SKIN_API\s+(\w+)\s+(skin_\w+)\s*\((.*?)\)\s*\n\{", re.MULTILINE | re.DOTALL
)
INCLUDE = re.compile(r'^#include "(\w+\.slang)"', re.MULTILINE)
TEXTURE = re.compile(r"SKIN_(LUT|TEX2D)\((\w+)\)$")
FLOATS = {"float": 1, "float2": 2, "float3": 3, "float4": 4, "float3x3": 9, "float4x4": 16}
NUMBERS = {**FLOATS, "int": 1}


@dataclass(frozen=True)
class Parameter:
    """One parameter.

    Attributes
    ----------
    kind
        A type of `NUMBERS`; ``tex2d``: a texture, and its sampler where the language parts them; or
        ``lut``: a texture with its axes.
    name
        As the specification calls it.
    """

    kind: str
    name: str


@dataclass(frozen=True)
class Signature:
    """One function of the library.

    Attributes
    ----------
    file
        Of the library, without suffix: also the specification's module.
    name
        With its prefix ``skin_``.
    returns
        A type of `FLOATS`.
    parameters
        In order.
    """

    file: str
    name: str
    returns: str
    parameters: tuple[Parameter, ...]

    @property
    def twin(self) -> str:
        """Name of the same function in the specification's module."""
        return self.name.removeprefix("skin_").removeprefix(
            f"{self.file}_" if self.file == "classic" else ""
        )


def twin_module(signature: Signature) -> str:
    """Return the module of the specification in which a function has its twin."""
    # The energy gain belongs to a profile, not to a pixel.
    package = "profile" if signature.file == "energy" else "shading"
    return f"skinshade.{package}.{signature.file}"


def signatures(folder: Path = LIBRARY) -> list[Signature]:
    """Return every public function, in the order in which the library includes them.

    Raises
    ------
    CompilerError
        If a type is none that every language passes alike.
    """
    order = INCLUDE.findall((folder / "skin.slang").read_text(encoding="utf-8"))
    found = []
    for name in ["common.slang", *order]:
        text = (folder / name).read_text(encoding="utf-8")
        for returns, function, inside in FUNCTION.findall(text):
            parameters = tuple(_parameter(each, function) for each in _split(inside))
            if returns not in FLOATS:
                raise CompilerError(f"{name}: {function} returns {returns}")
            found.append(Signature(name.removesuffix(".slang"), function, returns, parameters))
    return found


def _split(inside: str) -> list[str]:
    return [" ".join(part.split()) for part in inside.split(",") if part.strip()]


def _parameter(text: str, function: str) -> Parameter:
    texture = TEXTURE.match(text)
    if texture:
        return Parameter(texture.group(1).lower(), texture.group(2))
    kind, _, name = text.partition(" ")
    if kind not in NUMBERS or not name.isidentifier():
        raise CompilerError(
            f"{function}: parameter {text!r} is of no type that all languages share"
        )
    return Parameter(kind, name)
