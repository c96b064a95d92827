"""Writing the package."""

from __future__ import annotations

import json
import os
import re
from dataclasses import asdict
from importlib.resources import files
from pathlib import Path

from .._core.errors import ArgumentError, OutputError
from .._core.files import atomic_write
from .._core.progress import Progress, silent
from .._core.version import __version__
from ..params import SkinParams
from ..profile import Profile
from ..shaders import generated_text
from ..shading.skin import ENGINE_LUTS, Skin
from .guide import guide
from .languages import LANGUAGES, ShadingLanguage

__all__ = ["LANGUAGES", "export_shaders"]

SHADERS = files("skinshade.shaders")
INCLUDE = re.compile(r'#include "(?:\.\./generated/)?(\w+)\.slang"')


def export_shaders(
    language: str,
    folder: str | os.PathLike[str],
    *,
    profile: Profile | None = None,
    params: SkinParams | None = None,
    progress: Progress = silent,
) -> list[Path]:
    """Write all that an engine needs to shade skin: functions, blocks, tables, C header and a guide.

    Parameters
    ----------
    language
        One of `LANGUAGES`.
    folder
        Made if it is not there; files of the same names in it are replaced.
    profile
        Diffusion profile of the tables; the preset ``skin-deon2007`` by default.
    params
        Of the material; the tables hold ``scatter_scale``, ``shadow_filter_width_mm`` and
        ``shadow_sharpening``.
    progress
        Called with what is being done and how far it is.

    Returns
    -------
    list
        The files, in the order of the guide.

    Raises
    ------
    ArgumentError, OutputError
        If there is no such language, or the folder cannot be written.
    """
    if language not in LANGUAGES:
        raise ArgumentError(f"language is {language!r}; it must be one of {', '.join(LANGUAGES)}")
    form = LANGUAGES[language]
    skin = Skin.of(profile or Profile.preset("skin-deon2007"), params or SkinParams())
    place = Path(folder)
    try:
        place.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise OutputError(f"{place}: cannot make the folder ({error.strerror})") from None
    texts = _library(form) | {
        f"blocks.{form.suffix}": generated_text(form.structs),
        "skinshade.h": generated_text("skinshade.h"),
        "skin.json": _numbers(skin, language),
        "README.md": guide(language, form, skin),
    }
    written = [_written(place / name, text.encode()) for name, text in texts.items()]
    scatter = skin.scatter_params()
    written.append(_written(place / "skin_block.bin", skin.params.pack()))
    written.append(_written(place / "scatter_block.bin", scatter.pack()))
    for at, name in enumerate(ENGINE_LUTS):
        progress("tables", at / len(ENGINE_LUTS))
        for suffix in (".exr", ".png"):
            path = place / f"{name}_lut{suffix}"
            skin.lut(name).save(path)
            written.append(path)
    progress("tables", 1.0)
    return written


def _library(form: ShadingLanguage) -> dict[str, str]:
    """The functions: one generated file, or the commented source, whose includes become flat."""
    if form.library:
        return {f"skin.{form.suffix}": form.prologue + generated_text(form.library)}
    sources = [each for each in SHADERS.joinpath("skin").iterdir() if each.name.endswith(".slang")]
    sources.append(SHADERS.joinpath("generated/poisson.slang"))
    flat = {}
    for each in sorted(sources, key=lambda source: source.name):
        text = INCLUDE.sub(rf'#include "\1.{form.suffix}"', each.read_text(encoding="utf-8"))
        flat[each.name.removesuffix("slang") + form.suffix] = text
    return flat


def _numbers(skin: Skin, language: str) -> str:
    """What the binary blocks and the tables were made of, to be read by a person or a tool."""
    content = {
        "version": __version__,
        "language": language,
        "profile": skin.profile.name,
        "skin_block": asdict(skin.params),
        "scatter_block": asdict(skin.scatter_params()),
        "luts": {f"{name}_lut": skin.lut(name).description() for name in ENGINE_LUTS},
    }
    return json.dumps(content, indent=1) + "\n"


def _written(path: Path, content: bytes) -> Path:
    with atomic_write(path) as temporary:
        temporary.write_bytes(content)
    return path
