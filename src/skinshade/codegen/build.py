"""All generated files, as one dictionary of texts."""

from __future__ import annotations

import json
from collections.abc import Callable
from hashlib import sha256
from pathlib import Path

from .._core.files import atomic_write
from .blocks import STRUCTS, block_layouts, block_source, block_text, echo_source
from .c_header import c_header
from .compiler import LIBRARY, translate, version
from .constants import constants_source
from .function_page import function_page
from .kernels import kernel_source
from .library import DIALECTS, library
from .poisson import poisson_source
from .signatures import signatures

__all__ = ["GENERATED", "PAGE", "PASSES", "generate", "write"]

GENERATED = LIBRARY.parent / "generated"
PAGE = "functions.md"
"""A page of ``docs``, beside the sources."""
PASSES = ("shadow_pass", "blur_pass", "skin_pass", "present_pass")
INCLUDED: dict[str, Callable[[], str]] = {
    "poisson.slang": poisson_source,
    "blocks.slang": block_source,
    "constants.slang": constants_source,
}
"""Sources that library and passes include: they must be new before anything is translated."""


def generate() -> dict[str, str]:
    """Return name and text of every file of ``shaders/generated``; the same on every machine."""
    files = {f"skin.{each.suffix}": library(each) for each in DIALECTS.values()}
    files |= {name: source() for name, source in INCLUDED.items()}
    files |= {f"blocks.{each}": block_text(each) for each in STRUCTS if each != "slang"}
    layouts = block_layouts()
    files["layout.json"] = _json({"blocks": layouts})
    files["skinshade.h"] = c_header(layouts)
    files["kernels.wgsl"] = translate(kernel_source(signatures()), "wgsl").text
    files |= {f"{name}.wgsl": _pass(name) for name in PASSES}
    files["echo.wgsl"] = translate(block_source() + echo_source(), "wgsl").text
    sources = {path.name: _hash(path) for path in sorted(LIBRARY.glob("*.slang"))}
    files["manifest.json"] = _json({"slangc": version(), "sources": sources})
    return files


def write(folder: Path = GENERATED) -> list[str]:
    """Write what `generate` gives, and return the names of the files that changed."""
    folder.mkdir(exist_ok=True)
    changed = [name for name, source in INCLUDED.items() if _written(folder / name, source())]
    texts = generate()
    changed += [name for name, text in texts.items() if _written(folder / name, text)]
    docs = GENERATED.parents[3] / "docs"
    new_page = docs.is_dir() and _written(docs / PAGE, function_page(texts))
    return changed + ([PAGE] if new_page else [])


def _written(path: Path, text: str) -> bool:
    """Write a file unless it says so already."""
    if path.exists() and path.read_text(encoding="utf-8") == text:
        return False
    with atomic_write(path) as temporary:
        temporary.write_text(text, encoding="utf-8")
    return True


def _pass(name: str) -> str:
    text = translate(f'#include "../passes/{name}.slang"', "wgsl").text
    # Two pipelines that draw the same body must agree on its depth to the last bit.
    return text.replace("@builtin(position)", "@invariant @builtin(position)")


def _json(content: object) -> str:
    return json.dumps(content, indent=1, ensure_ascii=False) + "\n"


def _hash(path: Path) -> str:
    return sha256(path.read_bytes()).hexdigest()
