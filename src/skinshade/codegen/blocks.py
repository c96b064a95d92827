"""Constant blocks: one dataclass is the struct of every language, or the build stops."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import Field, dataclass, fields
from typing import Any

from .._core.errors import CompilerError
from ..params import BLOCKS
from ..params.fields import meaning
from ..params.packing import TYPE_NAMES, float_count, kind_of
from .compiler import Language, translate

__all__ = [
    "LIBRARY_BLOCKS",
    "STRUCTS",
    "block_layouts",
    "block_source",
    "block_text",
    "echo_source",
    "explained",
]

LANGUAGES: tuple[Language, ...] = ("wgsl", "glsl", "hlsl", "metal")


HEADER = "// Generated from skinshade.params by `python -m skinshade.codegen`.\n"
LIBRARY_BLOCKS = ("SkinBlock", "ScatterBlock")
"""Those that engines fill; the others are the renderer's own."""


@dataclass(frozen=True)
class StructForm:
    """How a language writes a struct.

    Attributes
    ----------
    types
        Its names of ``float4``, ``float2`` and ``float``, where they are others.
    field
        Of a name, a type and a comment.
    """

    types: Mapping[str, str]
    field: str = "    {kind} {name}; // {about}"


C_LIKE = StructForm({})
STRUCTS = {
    "slang": C_LIKE,
    "hlsl": C_LIKE,
    "metal": C_LIKE,
    "glsl": StructForm(TYPE_NAMES["glsl"]),
    "wgsl": StructForm(
        TYPE_NAMES["wgsl"],
        "    {name} : {kind}, // {about}",
    ),
}


def block_source() -> str:
    """Return every block as a Slang struct, widest fields first, with unit and range of each."""
    return block_text("slang", BLOCKS)


def block_text(language: str, blocks: Iterable[str] = LIBRARY_BLOCKS) -> str:
    """Return blocks as structs of a language of `STRUCTS`."""
    form, lines = STRUCTS[language], [HEADER]
    for block in blocks:
        lines += [f"struct {block}", "{"]
        for field in _ordered(BLOCKS[block]):
            kind, _, count = _kind(field).partition("[")
            name = f"{field.name}[{count}" if count else field.name
            written = form.types.get(kind, kind)
            lines.append(form.field.format(kind=written, name=name, about=explained(field)))
        lines += ["};", ""]
    return "\n".join(lines)


def explained(field: Field[Any]) -> str:
    """Return range, unit and meaning of a field, as comments give them."""
    m = meaning(field)
    unit = "" if m.unit == "1" else f" {m.unit}"
    return f"{m.low:g}..{m.high:g}{unit}. {m.about}"


def block_layouts() -> dict[str, Any]:
    """Return size and fields (kind, offset in bytes) of every block, the same in every language.

    Raises
    ------
    CompilerError
        If two languages place a field differently.
    """
    source = block_source() + echo_source()
    found = {each: _reflected(source, each) for each in LANGUAGES}
    first = found[LANGUAGES[0]]
    for language, layouts in found.items():
        for block, offsets in layouts.items():
            if offsets != first[block]:
                raise CompilerError(
                    f"{block}: {language} lays it out as {offsets}, not {first[block]}"
                )
    result = {}
    for block, offsets in first.items():
        kinds = {field.name: _kind(field) for field in fields(BLOCKS[block])}
        ends = [offset + 4 * float_count(kinds[name]) for name, offset in offsets.items()]
        result[block] = {
            "size": -(-max(ends) // 16) * 16,
            "fields": {
                name: {"kind": kinds[name], "offset": offset} for name, offset in offsets.items()
            },
        }
    return result


def echo_source() -> str:
    """Return a kernel for each block that writes every field's floats, in the block's order."""
    lines = [f"ConstantBuffer<{name}> {_instance(name)};" for name in BLOCKS]
    lines.append("RWStructuredBuffer<float> echoed;")
    for name, of in BLOCKS.items():
        lines += ["", '[shader("compute")]', "[numthreads(1, 1, 1)]", f"void echo_{name}()", "{"]
        at = 0
        for field in _ordered(of):
            for part in _parts(_kind(field)):
                lines.append(f"    echoed[{at}] = {_instance(name)}.{field.name}{part};")
                at += 1
        lines.append("}")
    return "\n".join([*lines, ""])


def _instance(block: str) -> str:
    return block.replace("Block", "_block").lower()


def _ordered(of: type) -> list[Field[Any]]:
    return sorted(fields(of), key=lambda field: -float_count(_kind(field)))


def _kind(field: Field[Any]) -> str:
    return kind_of(field.default)


def _parts(kind: str) -> list[str]:
    """What picks each float of a field, in order."""
    vector, _, count = kind.partition("[")
    letters = [f".{letter}" for letter in "xyzw"[: float_count(vector)]]
    if not count:
        return letters
    return [f"[{row}]{letter}" for row in range(int(count.rstrip("]"))) for letter in letters]


def _reflected(source: str, language: Language) -> dict[str, dict[str, int]]:
    # Any kernel will do: every block of the source is told of, used or not.
    told = translate(source, language, entry=f"echo_{next(iter(BLOCKS))}").reflection
    types = [each["type"].get("elementType", {}) for each in told["parameters"]]
    return {
        of["name"]: {each["name"]: each["binding"]["offset"] for each in of["fields"]}
        for of in types
        if of.get("name") in BLOCKS
    }
