"""Export of the shader package."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Mapping
from dataclasses import asdict
from importlib.resources import files
from pathlib import Path
from typing import Any

from .._core.errors import OutputError
from .._core.files import atomic_write
from .._core.generated import generated_text
from .._core.progress import Progress, silent
from .._core.version import __version__
from ..lut import Lut
from ..params import EyeParams, SkinParams
from ..profile import Profile
from ..shading.eye_tables import build_eye_lut, eye_place
from ..shading.skin import Skin
from ..shading.tables import ENGINE_LUTS
from .guide import eye_guide, guide
from .languages import LANGUAGES, Language, ShadingLanguage

__all__ = ["export_shaders"]

LIBRARY = files("skinshade").joinpath("shading")
INCLUDE = re.compile(r'#include "(?:generated/)?(\w+)\.slang"')


def export_shaders(
    language: str,
    folder: str | os.PathLike[str],
    *,
    profile: Profile | None = None,
    params: SkinParams | None = None,
    eye: EyeParams | None = None,
    progress: Progress = silent,
) -> list[Path]:
    """Write a shader package for an engine: functions, blocks, tables, C header and a guide.

    Parameters
    ----------
    language
        Name of a shading language, see `Language`.
    folder
        Output folder. It is created if it does not exist; existing files are replaced.
    profile
        Diffusion profile of the tables; the preset ``skin-deon2007`` if None.
    params
        Parameters of the material; the defaults if None. The tables depend on ``scatter_scale``,
        ``shadow_filter_width_mm`` and ``shadow_sharpening``.
    eye
        Parameters of an eye, whose blocks and tables are written too; no eye if None.
    progress
        Called with the name of the work and the fraction that is done.

    Returns
    -------
    list
        Paths of the files, in the order of the guide.

    Raises
    ------
    ArgumentError, OutputError
        If the language is unknown, or the folder cannot be written.

    Examples
    --------
    >>> import skinshade as sk
    >>> paths = sk.export_shaders("wgsl", "skin-wgsl")
    >>> [path.name for path in paths][:3]
    ['skin.wgsl', 'blocks.wgsl', 'skinshade.h']
    """
    choice = Language.of(language, "language")
    form = LANGUAGES[choice]
    skin = Skin.of(profile or Profile.preset("skin-deon2007"), params or SkinParams())
    target = Path(folder)
    try:
        target.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise OutputError(f"{target}: cannot create the folder ({error.strerror})") from None
    luts = None if eye is None else build_eye_lut(eye).by_name()
    texts = _library(form) | {
        f"blocks.{form.suffix}": generated_text(form.structs),
        "skinshade.h": generated_text("skinshade.h"),
        "skin.json": _numbers(skin, choice.value, eye, luts),
        "README.md": guide(form, skin) + (eye_guide() if luts is not None else ""),
    }
    written = [_write(target / name, text.encode()) for name, text in texts.items()]
    scatter = skin.scatter_params()
    written.append(_write(target / "skin_block.bin", skin.params.pack()))
    written.append(_write(target / "scatter_block.bin", scatter.pack()))
    if luts is not None and eye is not None:
        written.append(_write(target / "eye_block.bin", eye.pack()))
        written.append(_write(target / "eye_place_block.bin", eye_place(luts).pack()))
        for name, lut in luts.items():
            for suffix in (".exr", ".png"):
                written.append(target / f"eye_{name}_lut{suffix}")
                lut.save(written[-1])
    for index, name in enumerate(ENGINE_LUTS):
        progress("tables", index / len(ENGINE_LUTS))
        for suffix in (".exr", ".png"):
            path = target / f"{name}_lut{suffix}"
            skin.lut(name).save(path)
            written.append(path)
    progress("tables", 1.0)
    return written


def _library(form: ShadingLanguage) -> dict[str, str]:
    """Return the functions by file name: one generated file, or one commented source for each term."""
    if form.library:
        return {f"skin.{form.suffix}": form.prologue + generated_text(form.library)}
    sources = [file for file in LIBRARY.iterdir() if file.name.endswith(".slang")]
    sources.append(LIBRARY.joinpath("generated/constants.slang"))
    texts = {}
    for source in sorted(sources, key=lambda file: file.name):
        text = INCLUDE.sub(rf'#include "\1.{form.suffix}"', source.read_text(encoding="utf-8"))
        texts[source.name.removesuffix("slang") + form.suffix] = text
    return texts


def _numbers(
    skin: Skin, language: str, eye: EyeParams | None, eye_luts: Mapping[str, Lut] | None
) -> str:
    """Return the numbers of the binary blocks and of the tables' axes, as JSON."""
    content: dict[str, Any] = {
        "version": __version__,
        "language": language,
        "profile": skin.profile.name,
        "skin_block": asdict(skin.params),
        "scatter_block": asdict(skin.scatter_params()),
        "luts": {f"{name}_lut": skin.lut(name).description() for name in ENGINE_LUTS},
    }
    if eye is not None and eye_luts is not None:
        content["eye_block"] = asdict(eye)
        content["eye_place_block"] = asdict(eye_place(eye_luts))
        content["luts"] |= {f"eye_{name}_lut": lut.description() for name, lut in eye_luts.items()}
    return json.dumps(content, indent=1) + "\n"


def _write(path: Path, content: bytes) -> Path:
    with atomic_write(path) as temporary:
        temporary.write_bytes(content)
    return path
