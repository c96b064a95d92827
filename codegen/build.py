"""Generated files: their texts, and writing them."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from hashlib import sha256
from pathlib import Path

from skinshade._core.files import atomic_write
from skinshade.scene.schema import json_schema

from .architecture import architecture_svg
from .blocks import STRUCTS, block_layouts, block_source, block_text, echo_source
from .c_header import c_header
from .compiler import LIBRARY, PASSES, translate, version
from .constants import constants_source
from .function_page import function_page
from .kernels import kernel_source
from .library import DIALECTS, library
from .limits_page import limits_page
from .passes import passes_source
from .signatures import signatures

__all__ = ["DOCS", "GENERATED", "generate", "generate_docs", "write"]

GENERATED = LIBRARY / "generated"
DOCS = Path(__file__).resolve().parents[1] / "docs"
INCLUDED: dict[str, Callable[[], str]] = {
    "constants.slang": constants_source,
    "blocks.slang": block_source,
    "passes.slang": passes_source,
}
"""Sources that the library and the passes include. They are written before sources are translated."""


def generate() -> dict[str, str]:
    """Return the texts of ``shading/generated`` by file name; they are equal on all machines."""
    texts = {f"skin.{dialect.suffix}": library(dialect) for dialect in DIALECTS.values()}
    texts |= {name: source() for name, source in INCLUDED.items()}
    texts |= {f"blocks.{name}": block_text(name) for name in STRUCTS if name != "slang"}
    layouts = block_layouts()
    texts["layout.json"] = _json({"blocks": layouts})
    texts["skinshade.h"] = c_header(layouts)
    texts["kernels.wgsl"] = translate(kernel_source(signatures()), "wgsl").text
    texts |= {f"{path.stem}.wgsl": _pass(path) for path in PASSES.glob("*_pass.slang")}
    texts["echo.wgsl"] = translate(block_source() + echo_source(), "wgsl").text
    sources = sorted([*LIBRARY.glob("*.slang"), *PASSES.glob("*.slang")])
    hashes = {path.name: sha256(path.read_bytes()).hexdigest() for path in sources}
    texts["manifest.json"] = _json({"slangc": version(), "sources": hashes})
    return texts


def write(folder: Path = GENERATED) -> list[str]:
    """Write the texts of `generate` and `generate_docs`; return the names of changed files."""
    folder.mkdir(exist_ok=True)
    changed = [name for name, source in INCLUDED.items() if _write(folder / name, source())]
    texts = generate()
    changed += [name for name, text in texts.items() if _write(folder / name, text)]
    for path in folder.iterdir():
        if path.name not in texts:
            path.unlink()
            changed.append(path.name)
    documents = generate_docs(texts)
    return changed + [name for name, text in documents.items() if _write(DOCS / name, text)]


def generate_docs(texts: Mapping[str, str]) -> dict[str, str]:
    """Return the texts of the generated documents by file name, given the texts of `generate`."""
    return {
        "functions.md": function_page(texts),
        "limits.md": limits_page(),
        "scene.schema.json": _json(json_schema()),
        "images/architecture.svg": architecture_svg(),
    }


def _write(path: Path, text: str) -> bool:
    """Write a file unless it already has this text; return whether it was written."""
    if path.exists() and path.read_text(encoding="utf-8") == text:
        return False
    with atomic_write(path) as temporary:
        temporary.write_text(text, encoding="utf-8")
    return True


def _pass(path: Path) -> str:
    """Return a pass as WGSL."""
    text = translate(f'#include "{path.name}"', "wgsl").text
    # Two pipelines that draw the same body must agree on its depth to the last bit.
    return text.replace("@builtin(position)", "@invariant @builtin(position)")


def _json(content: object) -> str:
    return json.dumps(content, indent=1, ensure_ascii=False) + "\n"
