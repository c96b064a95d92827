"""Library in every language: only its functions, with their names in the source."""

from __future__ import annotations

import re
from dataclasses import dataclass

from .compiler import Language, translate

__all__ = ["DIALECTS", "Dialect", "library"]


@dataclass(frozen=True)
class Dialect:
    """One generated form of the library.

    Attributes
    ----------
    language
        Target language of the compiler.
    suffix
        Suffix of the generated file.
    combined_samplers
        Whether a texture and its sampler are one object.
    prologue
        Lines before the functions.
    """

    language: Language
    suffix: str
    combined_samplers: bool = False
    prologue: str = ""


DIALECTS = {
    "wgsl": Dialect("wgsl", "wgsl"),
    "glsl-vulkan": Dialect("glsl", "vulkan.glsl"),
    "glsl-gl": Dialect("glsl", "gl.glsl", combined_samplers=True),
    "hlsl": Dialect("hlsl", "hlsl"),
    "metal": Dialect(
        "metal", "metal", prologue="#include <metal_stdlib>\nusing namespace metal;\n"
    ),
}
ANCHOR = """#include "skin.slang"
RWStructuredBuffer<float> anchor_output;
[shader("compute")]
[numthreads(1, 1, 1)]
void anchor() { anchor_output[0] = 0.0; }
"""
"""Source with an entry point, without which the compiler writes no HLSL, GLSL or Metal. The entry point
is removed from the translation."""
HEADER = "// The skinshade library, generated from shading/*.slang by `python -m codegen`.\n"


def library(dialect: Dialect) -> str:
    """Return the functions of the library in a dialect, without entry points and bindings."""
    definitions = {"SKIN_API": "export public"}
    if dialect.combined_samplers:
        definitions["SKIN_COMBINED_SAMPLERS"] = "1"
    text = translate(ANCHOR, dialect.language, definitions=definitions, entry="anchor").text
    return HEADER + dialect.prologue + _renamed(_functions(text, dialect.language))


def _functions(text: str, language: Language) -> str:
    """Return a translation without the anchor, the anchor's buffer, and lines about layout."""
    remaining = ANCHOR_BUFFER.sub("", ANCHOR_FUNCTION.sub("", text.replace("\r\n", "\n")))
    lines = [line for line in remaining.split("\n") if not re.match(DROPPED[language], line)]
    return re.sub(r"\n{3,}", "\n\n", "\n".join(lines)).strip("\n") + "\n"


ANCHOR_FUNCTION = re.compile(
    r"(^(\[num|@|layout\(local)[^\n]*\n)*^[^\n]*\b(main|anchor)\s*\([^\n]*\n\{.*?^\}\n", re.M | re.S
)
ANCHOR_BUFFER = re.compile(
    r"^layout\(std430[^}]*\} anchor_output_0;\n|^[^\n{}]*\banchor_output_0\b[^\n{}]*;\n", re.M
)
DROPPED: dict[Language, str] = {
    "wgsl": r"^@",
    "glsl": r"^#version|^layout\(",
    "hlsl": r"^#|^// warning",
    "metal": r"^#|^using",
}


def _renamed(text: str) -> str:
    """Remove the compiler's counters from the names of functions, tables and parameters.

    Functions that the compiler adds get the prefix of the library, so that their names differ from the
    user's functions.
    """
    text = re.sub(r"\b(skin_[a-z0-9_]*?)_0\b(?=\s*\()", r"\1", text)
    text = re.sub(r"\b(SKIN_[A-Z0-9_]*?)_0\b", r"\1", text)
    text = re.sub(r"\b(saturate|rsqrt)_(\d+)\b", r"skin_\1_\2", text)
    text = re.sub(r"\bmatrix<float,int\((\d)\),int\((\d)\)> ?", r"float\1x\2", text)
    return FUNCTION.sub(lambda match: _with_plain_parameters(match.group(0)), text)


FUNCTION = re.compile(r"^(?:fn |[\w<>, ]+? )\w+\([^\n{;]*\)[^\n;]*\n\{.*?^\}", re.M | re.S)


def _with_plain_parameters(function: str) -> str:
    head = function[: function.index("{")]
    inside = head[head.index("(") + 1 : head.rindex(")")]
    for name in re.findall(r"\b([A-Za-z]\w*?_\d+)\b", inside):
        function = re.sub(rf"\b{name}\b", re.sub(r"_\d+$", "", name), function)
    return re.sub(r"(?<=\() |(?<=, ) ", "", function, count=inside.count(",") + 1)
