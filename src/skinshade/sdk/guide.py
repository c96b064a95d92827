"""README of the shader package."""

from __future__ import annotations

from functools import cache
from importlib.resources import files

from .._core.version import __version__
from ..shading.skin import Skin
from ..shading.tables import ENGINE_LUTS
from .example import example_calls, example_inputs
from .languages import ShadingLanguage

__all__ = ["eye_guide", "guide"]

ROWS = {
    "glsl": "; `mat3(a, b, c)` has `m[0] == a`, so pass them in order",
    "wgsl": "; `mat3x3(a, b, c)` has `m[0] == a`, so pass them in order",
    "metal": "; `float3x3(a, b, c)` has `m[0] == a`, so pass them in order",
}
"""Notes on the order of rows, for languages whose matrix constructors take columns."""
FENCES = {"slang": "hlsl", "metal": "cpp"}
"""Names of languages for syntax highlighting in Markdown, where they differ from the suffix."""


@cache
def _page() -> str:
    return files("skinshade.sdk").joinpath("guide.md").read_text(encoding="utf-8")


def eye_guide() -> str:
    """Return the section of the README about an eye, in Markdown."""
    return files("skinshade.sdk").joinpath("eye_guide.md").read_text(encoding="utf-8")


def guide(form: ShadingLanguage, skin: Skin) -> str:
    """Return the README for a language and a material, in Markdown."""
    if form.library:
        library = f"| `skin.{form.suffix}` | every function of the library |"
    else:
        library = (
            f"| `skin.{form.suffix}` | the library: include this file; it includes one file per term, with"
            " the source of every formula |"
        )
    declared = form.declared() or [
        "// Metal has no global declarations: pass textures, sampler and blocks as arguments."
    ]
    return _page().format(
        version=__version__,
        title=form.title,
        checked=form.checked,
        files=library,
        suffix=form.suffix,
        luts="_lut.exr`, `".join(ENGINE_LUTS),
        profile=skin.profile.name,
        fence=FENCES.get(form.suffix, form.suffix),
        declared="\n".join(declared),
        inputs="\n".join(example_inputs(form)),
        calls="\n".join(example_calls(form)),
        rows=ROWS.get(form.suffix, ""),
    )
