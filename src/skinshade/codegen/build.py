"""All generated files, as one dictionary of texts."""

from __future__ import annotations

import json
from hashlib import sha256
from pathlib import Path

from .._core.files import atomic_write
from .blocks import block_layouts, block_source, echo_source
from .compiler import LIBRARY, translate, version
from .kernels import kernel_source
from .library import DIALECTS, library
from .poisson import poisson_source
from .signatures import signatures

__all__ = ["GENERATED", "generate", "write"]

GENERATED = LIBRARY.parent / "generated"


def generate() -> dict[str, str]:
    """Return name and text of every file of ``shaders/generated``; the same on every machine."""
    files = {f"skin.{each.suffix}": library(each) for each in DIALECTS.values()}
    files["poisson.slang"] = poisson_source()
    files["blocks.slang"] = block_source()
    files["layout.json"] = _json({"blocks": block_layouts()})
    files["kernels.wgsl"] = translate(kernel_source(signatures()), "wgsl").text
    files["skin_pass.wgsl"] = translate('#include "../passes/skin_pass.slang"', "wgsl").text
    files["echo.wgsl"] = translate(block_source() + echo_source(), "wgsl").text
    sources = {path.name: _hash(path) for path in sorted(LIBRARY.glob("*.slang"))}
    files["manifest.json"] = _json({"slangc": version(), "sources": sources})
    return files


def write(folder: Path = GENERATED) -> list[str]:
    """Write what `generate` gives, and return the names of the files that changed."""
    folder.mkdir(exist_ok=True)
    changed = []
    # The library includes the disks: they must be new before it is translated.
    for name, text in ({"poisson.slang": poisson_source()} | generate()).items():
        path = folder / name
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            with atomic_write(path) as temporary:
                temporary.write_text(text, encoding="utf-8")
            changed.append(name)
    return changed


def _json(content: object) -> str:
    return json.dumps(content, indent=1, ensure_ascii=False) + "\n"


def _hash(path: Path) -> str:
    return sha256(path.read_bytes()).hexdigest()
