"""Signatures of the library's functions, read from the Slang source."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from .compiler import LIBRARY, CompilerError

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
    """Parameter of a function.

    Attributes
    ----------
    kind
        A type of `NUMBERS`; ``tex2d``, a texture with its sampler where the language separates them; or
        ``lut``, a texture with its axes.
    name
        Name of the parameter, which is the same in the specification.
    """

    kind: str
    name: str


@dataclass(frozen=True)
class Signature:
    """Function of the library.

    Attributes
    ----------
    file
        Name of the file without suffix, which is also the name of the specification's module.
    name
        Name of the function, with the prefix ``skin_``.
    returns
        A type of `FLOATS`.
    parameters
        Parameters in order.
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
    """Return the module of the specification that holds a function's twin."""
    return f"skinshade.shading.{signature.file}"


def signatures(folder: Path = LIBRARY) -> list[Signature]:
    """Return all public functions, in the order in which the library includes them.

    Raises
    ------
    CompilerError
        If a parameter or result has a type that the languages do not share.
    """
    order = INCLUDE.findall((folder / "skin.slang").read_text(encoding="utf-8"))
    result = []
    for name in ["common.slang", *order]:
        text = (folder / name).read_text(encoding="utf-8")
        for returns, function, inside in FUNCTION.findall(text):
            parameters = tuple(_parameter(part, function) for part in _split(inside))
            if returns not in FLOATS:
                raise CompilerError(f"{name}: {function} returns {returns}")
            result.append(Signature(name.removesuffix(".slang"), function, returns, parameters))
    return result


def _split(inside: str) -> list[str]:
    return [" ".join(part.split()) for part in inside.split(",") if part.strip()]


def _parameter(text: str, function: str) -> Parameter:
    texture = TEXTURE.match(text)
    if texture:
        return Parameter(texture.group(1).lower(), texture.group(2))
    kind, _, name = text.partition(" ")
    if kind not in NUMBERS or not name.isidentifier():
        raise CompilerError(
            f"{function}: parameter {text!r} has a type that the languages do not share"
        )
    return Parameter(kind, name)
