"""Drawing of the folders of the package and of the imports between them."""

from __future__ import annotations

import ast
import tomllib
from html import escape
from pathlib import Path

from .compiler import PACKAGE

__all__ = ["architecture_svg", "folder_imports", "layers"]

SETTINGS = PACKAGE.parents[1] / "pyproject.toml"
WIDTH, ROW, BOX_HEIGHT, BOX_WIDTH, MARGIN = 920, 92, 48, 200, 20
STYLE = """
text { font: 14px system-ui, sans-serif; fill: #222; text-anchor: middle; }
text.about { font-size: 10px; fill: #666; }
rect { fill: #fbf6f2; stroke: #b98d74; rx: 6px; }
path { fill: none; stroke: #b9a79c; stroke-width: 1.2px; marker-end: url(#arrow); }
"""


def layers() -> list[list[str]]:
    """Return the folders of every layer, from the top, as the settings of import-linter list them."""
    settings = tomllib.loads(SETTINGS.read_text(encoding="utf-8"))
    contract = settings["tool"]["importlinter"]["contracts"][0]
    return [
        [name.strip().removeprefix("skinshade.") for name in layer.split("|")]
        for layer in contract["layers"]
    ]


def folder_imports() -> dict[str, set[str]]:
    """Return the folders that each folder of the package imports."""
    names = [name for layer in layers() for name in layer]
    imports: dict[str, set[str]] = {name: set() for name in names}
    for name in names:
        for path in _folder(name).rglob("*.py"):
            for module in _imported_modules(path):
                if module in imports and module != name:
                    imports[name].add(module)
    return imports


def architecture_svg() -> str:
    """Return the drawing as SVG, without imports that a chain of other imports implies."""
    rows = layers()
    centres = {
        name: (WIDTH * (2 * column + 1) / (2 * len(row)), MARGIN + ROW * index + BOX_HEIGHT / 2)
        for index, row in enumerate(rows)
        for column, name in enumerate(row)
    }
    height = MARGIN + ROW * len(rows)
    parts = [
        f"<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {WIDTH} {height}'>",
        f"<style>{STYLE}</style>",
        "<defs><marker id='arrow' viewBox='0 0 8 8' refX='7' refY='4' markerWidth='7'"
        " markerHeight='7' orient='auto'><path d='M0 0 L8 4 L0 8 z' style='fill:#b9a79c;"
        "stroke:none;marker-end:none'/></marker></defs>",
    ]
    for name, targets in _reduced(folder_imports()).items():
        parts += [_arrow(centres[name], centres[target]) for target in sorted(targets)]
    for name, (x, y) in centres.items():
        parts += [
            f"<rect x='{x - BOX_WIDTH / 2:g}' y='{y - BOX_HEIGHT / 2:g}' width='{BOX_WIDTH}'"
            f" height='{BOX_HEIGHT}'/>",
            f"<text x='{x:g}' y='{y - 4:g}'>{name}</text>",
            f"<text class='about' x='{x:g}' y='{y + 13:g}'>{escape(_about(name))}</text>",
        ]
    return "\n".join([*parts, "</svg>", ""])


def _folder(name: str) -> Path:
    return PACKAGE / name if (PACKAGE / name).is_dir() else SETTINGS.parent / name


def _imported_modules(path: Path) -> list[str]:
    """Return the folders of the package that a file imports."""
    inside = path.relative_to(PACKAGE if path.is_relative_to(PACKAGE) else SETTINGS.parent)
    modules = []
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if not isinstance(node, ast.ImportFrom):
            continue
        if node.level:
            base = list(inside.parts[: len(inside.parts) - node.level])
            parts = [*base, *(node.module or "").split(".")]
            modules.append(parts[0] or node.names[0].name)
        elif (node.module or "").startswith("skinshade."):
            modules.append(str(node.module).split(".")[1])
    return modules


def _reduced(imports: dict[str, set[str]]) -> dict[str, set[str]]:
    """Return the imports without those that a chain of other imports implies."""

    def reachable(name: str) -> set[str]:
        return imports[name] | {
            indirect for direct in imports[name] for indirect in reachable(direct)
        }

    return {
        name: {
            target
            for target in targets
            if not any(target in reachable(other) for other in targets - {target})
        }
        for name, targets in imports.items()
    }


def _arrow(start: tuple[float, float], end: tuple[float, float]) -> str:
    (x0, y0), (x1, y1) = start, end
    y0, y1 = y0 + BOX_HEIGHT / 2, y1 - BOX_HEIGHT / 2 - 2
    bend = (y1 - y0) / 2
    return f"<path d='M{x0:g} {y0:g} C{x0:g} {y0 + bend:g} {x1:g} {y1 - bend:g} {x1:g} {y1:g}'/>"


def _about(name: str) -> str:
    """Return the first clause of a folder's docstring."""
    text = (_folder(name) / "__init__.py").read_text(encoding="utf-8")
    docstring = ast.get_docstring(ast.parse(text)) or ""
    first = docstring.partition("\n")[0].rstrip(".")
    return first.partition(":")[0] if len(first) > 42 else first
