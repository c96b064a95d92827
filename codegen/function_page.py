"""Page of all functions: purpose, twin, and declaration in every language."""

from __future__ import annotations

import re
from collections.abc import Mapping

from .compiler import LIBRARY
from .signatures import Signature, signatures, twin_module

__all__ = ["function_page"]

ROWS = {
    "HLSL, Slang": "skin.hlsl",
    "GLSL for Vulkan": "skin.vulkan.glsl",
    "GLSL for OpenGL, WebGL": "skin.gl.glsl",
    "WGSL": "skin.wgsl",
    "Metal": "skin.metal",
}
HEAD = """# Functions

Generated from `src/skinshade/shading/*.slang` by `python -m codegen`. Every function has the same name and
the same order of arguments in every language. Each has a twin in NumPy, and the tests compare the two
(`docs/shaders.md` says where each language runs). A sampler follows its texture in languages that
separate the two, and the axes follow their lookup table.
"""


def function_page(library: Mapping[str, str]) -> str:
    """Return the page as Markdown, given the generated library by file name."""
    lines, file = [HEAD], ""
    for signature in signatures():
        if signature.file != file:
            file = signature.file
            lines += [f"## `{file}.slang`", ""]
        lines += [f"### `{signature.name}`", "", _comment(signature), ""]
        lines += [f"Twin: `{twin_module(signature)}.{signature.twin}`.", ""]
        lines += ["| language | declaration |", "|---|---|"]
        lines += [
            f"| {language} | `{_declaration(signature, library[name])}` |"
            for language, name in ROWS.items()
        ]
        lines.append("")
    return "\n".join(lines).rstrip() + "\n"


def _comment(signature: Signature) -> str:
    """Return the comment above the function in its source."""
    text = (LIBRARY / f"{signature.file}.slang").read_text(encoding="utf-8")
    above = text[: text.index(f" {signature.name}(")].splitlines()[:-1]
    comment: list[str] = []
    while above and above[-1].startswith("//"):
        comment.insert(0, above.pop().removeprefix("//").strip())
    return " ".join(comment)


def _declaration(signature: Signature, text: str) -> str:
    line = re.search(rf"^[^\n]*\b{signature.name}\s*\([^\n]*$", text, re.M)
    assert line is not None, signature.name
    return re.sub(r"\s+", " ", line.group()).replace(" >", ">").strip()
