"""The page of all functions: what each does, and how it is called in every language."""

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

Generated from `shaders/skin` by `python -m skinshade.codegen`. Every function has the same name and the
same order of arguments in every language, and a twin in NumPy that the tests run it against
(`docs/shaders.md` says where each language was run). A texture is followed by its sampler where the
language parts them, and a lookup table by its axes.
"""


def function_page(library: Mapping[str, str]) -> str:
    """Return the page as Markdown, given the generated library by file name."""
    lines, file = [HEAD], ""
    for each in signatures():
        if each.file != file:
            file = each.file
            lines += [f"## `{file}.slang`", ""]
        lines += [f"### `{each.name}`", "", _comment(each), ""]
        lines += [f"Twin: `{twin_module(each)}.{each.twin}`.", ""]
        lines += ["| language | declaration |", "|---|---|"]
        lines += [
            f"| {language} | `{_declaration(each, library[name])}` |"
            for language, name in ROWS.items()
        ]
        lines.append("")
    return "\n".join(lines).rstrip() + "\n"


def _comment(signature: Signature) -> str:
    """The comment that stands above the function in its source."""
    text = (LIBRARY / f"{signature.file}.slang").read_text(encoding="utf-8")
    above = text[: text.index(f" {signature.name}(")].splitlines()[:-1]
    comment: list[str] = []
    while above and above[-1].startswith("//"):
        comment.insert(0, above.pop().removeprefix("//").strip())
    return " ".join(comment) or "As its name says."


def _declaration(signature: Signature, text: str) -> str:
    found = re.search(rf"^[^\n]*\b{signature.name}\s*\([^\n]*$", text, re.M)
    assert found is not None, signature.name
    return re.sub(r"\s+", " ", found.group()).replace(" >", ">").strip()
