"""Structs of the constant blocks in every language, from one dataclass for each block."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import Field, dataclass
from typing import Any

from skinshade.params import BLOCKS
from skinshade.params.fields import meaning, number_fields
from skinshade.params.packing import TYPE_NAMES, float_count, kind_of

from .compiler import CompilerError, Language, translate

__all__ = [
    "LIBRARY_BLOCKS",
    "STRUCTS",
    "block_layouts",
    "block_source",
    "block_text",
    "echo_source",
    "field_comment",
    "stem_of",
]

LANGUAGES: tuple[Language, ...] = ("wgsl", "glsl", "hlsl", "metal")

HEADER = "// Generated from skinshade.params by `python -m codegen`.\n"
LIBRARY_BLOCKS = ("SkinBlock", "ScatterBlock", "EyeBlock", "EyePlaceBlock")
"""Blocks that engines fill; only the renderer fills the others."""


@dataclass(frozen=True)
class StructForm:
    """Syntax of a struct in one language.

    Attributes
    ----------
    types
        Names of ``float4``, ``float2`` and ``float`` that differ in the language.
    field
        Format of a field, with the keys ``kind``, ``name`` and ``about``.
    """

    types: Mapping[str, str]
    field: str = "    {kind} {name}; // {about}"


C_LIKE = StructForm({})
STRUCTS = {
    "slang": C_LIKE,
    "hlsl": C_LIKE,
    "metal": C_LIKE,
    "glsl": StructForm(TYPE_NAMES["glsl"]),
    "wgsl": StructForm(TYPE_NAMES["wgsl"], "    {name} : {kind}, // {about}"),
}


def block_source() -> str:
    """Return all blocks as Slang structs, widest fields first, with unit and range of each field."""
    return block_text("slang", BLOCKS)


def block_text(language: str, blocks: Iterable[str] = LIBRARY_BLOCKS) -> str:
    """Return blocks as structs in a language of `STRUCTS`."""
    form, lines = STRUCTS[language], [HEADER]
    for block in blocks:
        lines += [f"struct {block}", "{"]
        for field in _ordered(BLOCKS[block]):
            kind, _, count = _kind(field).partition("[")
            name = f"{field.name}[{count}" if count else field.name
            type_name = form.types.get(kind, kind)
            lines.append(form.field.format(kind=type_name, name=name, about=field_comment(field)))
        lines += ["};", ""]
    return "\n".join(lines)


def field_comment(field: Field[Any]) -> str:
    """Return the range, the unit and the meaning of a field as one comment."""
    entry = meaning(field)
    unit = "" if entry.unit == "1" else f" {entry.unit}"
    return f"{entry.low:g}..{entry.high:g}{unit}. {entry.about}"


def block_layouts() -> dict[str, Any]:
    """Return the size and the fields (kind, offset in bytes) of every block, equal in all languages.

    Raises
    ------
    CompilerError
        If two languages place a field at different offsets.
    """
    source = block_source() + echo_source()
    layouts = {language: _reflected(source, language) for language in LANGUAGES}
    first = layouts[LANGUAGES[0]]
    for language, blocks in layouts.items():
        for block, offsets in blocks.items():
            if offsets != first[block]:
                raise CompilerError(
                    f"{block}: the offsets in {language} are {offsets}, not {first[block]}"
                )
    result = {}
    for block, offsets in first.items():
        kinds = {field.name: _kind(field) for field in number_fields(BLOCKS[block])}
        ends = [offset + 4 * float_count(kinds[name]) for name, offset in offsets.items()]
        result[block] = {
            "size": -(-max(ends) // 16) * 16,
            "fields": {
                name: {"kind": kinds[name], "offset": offset} for name, offset in offsets.items()
            },
        }
    return result


def echo_source() -> str:
    """Return a kernel for each block that writes the floats of all fields, in the block's order."""
    lines = [f"ConstantBuffer<{name}> {_instance(name)};" for name in BLOCKS]
    lines.append("RWStructuredBuffer<float> echoed;")
    for name, block in BLOCKS.items():
        lines += ["", '[shader("compute")]', "[numthreads(1, 1, 1)]", f"void echo_{name}()", "{"]
        index = 0
        for field in _ordered(block):
            for part in _parts(_kind(field)):
                lines.append(f"    echoed[{index}] = {_instance(name)}.{field.name}{part};")
                index += 1
        lines.append("}")
    return "\n".join([*lines, ""])


def stem_of(block: str) -> str:
    """Return the name of a block in lower case: ``eye_place`` of ``EyePlaceBlock``."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", block.removesuffix("Block")).lower()


def _instance(block: str) -> str:
    return f"{stem_of(block)}_block"


def _ordered(block: type) -> list[Field[Any]]:
    return sorted(number_fields(block), key=lambda field: -float_count(_kind(field)))


def _kind(field: Field[Any]) -> str:
    return kind_of(field.default)


def _parts(kind: str) -> list[str]:
    """Return the expressions that select each float of a field, in order."""
    vector, _, count = kind.partition("[")
    letters = [f".{letter}" for letter in "xyzw"[: float_count(vector)]]
    if not count:
        return letters
    return [f"[{row}]{letter}" for row in range(int(count.rstrip("]"))) for letter in letters]


def _reflected(source: str, language: Language) -> dict[str, dict[str, int]]:
    """Return the offset of each field of each block in one language."""
    # The reflection contains every block of the source; the choice of the kernel does not matter.
    reflection = translate(source, language, entry=f"echo_{next(iter(BLOCKS))}").reflection
    types = [parameter["type"].get("elementType", {}) for parameter in reflection["parameters"]]
    return {
        block["name"]: {field["name"]: field["binding"]["offset"] for field in block["fields"]}
        for block in types
        if block.get("name") in BLOCKS
    }
