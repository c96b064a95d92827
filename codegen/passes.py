"""Declarations of the renderer's passes: enumerations, renderer constants, and the vertex layout."""

from __future__ import annotations

from collections.abc import Iterable

from skinshade.params.choices import SHADER_CHOICES, MaterialMap
from skinshade.params.vertex import VERTEX_COLUMNS, VERTEX_VECTORS, VertexColumn, column_slices
from skinshade.rendering import settings
from skinshade.rendering.prepare import light_view, shadow_map
from skinshade.scene import lights

from .constants import definition

__all__ = ["passes_source"]

HEADER = "// Generated from skinshade.params and skinshade.rendering by `python -m codegen`."
RENDERER = {
    settings: ("CURVATURE_RANGE_PER_MM", "THICKNESS_RANGE_MM"),
    lights: ("LEAST_DISTANCE_MM",),
    light_view: ("MAP_SIZE",),
    shadow_map: ("BLUR_REACH", "FAR_MM", "FILTER_TAPS"),
}
"""Constants of the renderer by the module that defines them."""
TYPES = {"symmetric": "float3x3"}
"""Slang types of columns whose kind is not a Slang type."""
MATRIX_ROWS = {
    "symmetric": ((0, 1, 2), (1, 3, 4), (2, 4, 5)),
    "float3x3": ((0, 1, 2), (3, 4, 5), (6, 7, 8)),
}
"""Floats of each row of a matrix, as indices within the floats of its column."""


def passes_source() -> str:
    """Return the declarations as Slang."""
    lines = [HEADER, "#ifndef PASSES_SLANG", "#define PASSES_SLANG", ""]
    for module, names in RENDERER.items():
        lines += [definition(name, getattr(module, name)) for name in names]
    for prefix, choices in SHADER_CHOICES.items():
        lines.append("")
        for member in choices:
            lines.append(definition(f"{prefix}_{member.name}", member.number))
    lines.append("")
    lines += [definition(f"MAP_{member.name}", member.bit) for member in MaterialMap]
    lines += ["", *_structs()]
    return "\n".join([*lines, "", "#endif", ""])


def _structs() -> list[str]:
    vectors = range(VERTEX_VECTORS)
    slices = column_slices()
    return [
        "// Vertex buffer: the columns below, one after the other.",
        "struct Vertex",
        "{",
        *(f"    float4 v{i} : ATTRIBUTE{i};" for i in vectors),
        "};",
        "",
        "struct Fragment",
        "{",
        "    float4 clip : SV_Position;",
        *(f"    centroid float4 v{i} : ATTRIBUTE{i};" for i in vectors),
        "};",
        "",
        "struct Attributes",
        "{",
        *(f"    {_type(column)} {name}; // {_about(column)}" for name, column in _columns()),
        "};",
        "",
        "Fragment fragment_of(Vertex vertex, float4 clip)",
        "{",
        "    Fragment fragment;",
        "    fragment.clip = clip;",
        *(f"    fragment.v{i} = vertex.v{i};" for i in vectors),
        "    return fragment;",
        "}",
        "",
        "float3 position_of(Vertex vertex)",
        "{",
        f"    return {_value('vertex', VERTEX_COLUMNS['position'], slices['position'])};",
        "}",
        "",
        "Attributes attributes_of(Fragment fragment)",
        "{",
        "    Attributes a;",
        *(
            f"    a.{name} = {_value('fragment', column, slices[name])};"
            for name, column in _columns()
        ),
        "    return a;",
        "}",
    ]


def _columns() -> Iterable[tuple[str, VertexColumn]]:
    return VERTEX_COLUMNS.items()


def _type(column: VertexColumn) -> str:
    return TYPES.get(column.kind, column.kind)


def _about(column: VertexColumn) -> str:
    return column.about if column.unit == "1" else f"{column.about[:-1]}, {column.unit}."


def _value(variable: str, column: VertexColumn, floats: slice) -> str:
    """Return the expression that reads a column of a vertex or fragment."""
    names = [f"{variable}.v{i // 4}.{'xyzw'[i % 4]}" for i in range(floats.start, floats.stop)]
    if column.kind in MATRIX_ROWS:
        rows = (", ".join(names[i] for i in row) for row in MATRIX_ROWS[column.kind])
        return f"float3x3({', '.join(f'float3({row})' for row in rows)})"
    return names[0] if len(names) == 1 else f"{column.kind}({', '.join(names)})"
