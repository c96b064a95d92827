"""The one page that goes with the package."""

from __future__ import annotations

from functools import cache
from importlib.resources import files

from .._core.version import __version__
from ..shading.skin import ENGINE_LUTS, Skin
from .example import example_calls, example_inputs
from .languages import ShadingLanguage

__all__ = ["guide"]

ROWS = {
    "glsl": "; `mat3(a, b, c)` has `m[0] == a`, so pass them in order",
    "wgsl": "; `mat3x3(a, b, c)` has `m[0] == a`, so pass them in order",
    "metal": "; `float3x3(a, b, c)` has `m[0] == a`, so pass them in order",
}
FENCES = {"slang": "hlsl", "metal": "cpp"}


@cache
def _page() -> str:
    return files("skinshade.sdk").joinpath("guide.md").read_text(encoding="utf-8")


def guide(language: str, form: ShadingLanguage, skin: Skin) -> str:
    """Return the page for a language and a material."""
    if form.library:
        library = f"| `skin.{form.suffix}` | every function of the library |"
    else:
        library = (
            f"| `skin.{form.suffix}` | the library: include this one; it includes a file for each term, with"
            " the source of every formula |"
        )
    declared = form.declared() or [
        "// Pass textures, sampler and blocks as arguments of your function."
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
