"""C99 header: configurations with their ranges, and packing into the constant blocks."""

from __future__ import annotations

from dataclasses import Field
from typing import Any

import numpy as np

from skinshade._core.version import __version__
from skinshade.params import BLOCKS
from skinshade.params.fields import meaning, number_fields

from .blocks import LIBRARY_BLOCKS, field_comment, stem_of

__all__ = ["c_header"]

PROLOGUE = """/* skinshade.h: the constant blocks of the skinshade shader library, for C99 and C++.
   Generated from skinshade.params by `python -m codegen`. It needs no other file.

   Take a configuration with its defaults, change it, and pack it into the bytes that the shader reads
   (the same bytes for std140, an HLSL cbuffer and a WGSL uniform):

       skinshade_skin_config config = skinshade_skin_defaults();
       config.gloss = 0.4f;
       unsigned char bytes[SKINSHADE_SKIN_BLOCK_SIZE];
       skinshade_result result = skinshade_pack_skin(&config, bytes, sizeof bytes);
       if (result.error != SKINSHADE_OK) { ... skinshade_error_message(result.error), result.field ... }

   Lengths are in millimetres and curvatures in 1/mm, whatever the unit of your scene is. */
#ifndef SKINSHADE_H
#define SKINSHADE_H

#define SKINSHADE_VERSION "VERSION"

#include <math.h>
#include <stddef.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__) || defined(__clang__)
#define SKINSHADE_FUNCTION static inline __attribute__((unused))
#else
#define SKINSHADE_FUNCTION static inline
#endif

typedef enum skinshade_error {
    SKINSHADE_OK = 0,
    SKINSHADE_NULL_POINTER = 1,
    SKINSHADE_BUFFER_TOO_SMALL = 2,
    SKINSHADE_NOT_FINITE = 3,
    SKINSHADE_OUT_OF_RANGE = 4
} skinshade_error;

/* Result of packing: the first error, and the name of the field at fault or NULL. */
typedef struct skinshade_result {
    skinshade_error error;
    const char *field;
} skinshade_result;

SKINSHADE_FUNCTION const char *skinshade_error_message(skinshade_error error)
{
    switch (error) {
    case SKINSHADE_OK: return "no error";
    case SKINSHADE_NULL_POINTER: return "the configuration or the buffer is a null pointer";
    case SKINSHADE_BUFFER_TOO_SMALL: return "the buffer is smaller than the block";
    case SKINSHADE_NOT_FINITE: return "a field is infinite or not a number";
    case SKINSHADE_OUT_OF_RANGE: return "a field lies outside the range that its comment gives";
    }
    return "unknown error";
}

SKINSHADE_FUNCTION skinshade_result skinshade_result_of(skinshade_error error, const char *field)
{
    skinshade_result result;
    result.error = error;
    result.field = field;
    return result;
}

SKINSHADE_FUNCTION skinshade_error skinshade_check(
    const float *values, size_t count, double low, double high)
{
    for (size_t i = 0; i < count; i++) {
        if (!isfinite(values[i])) return SKINSHADE_NOT_FINITE;
        if (values[i] < (float)low || values[i] > (float)high) return SKINSHADE_OUT_OF_RANGE;
    }
    return SKINSHADE_OK;
}
"""

EPILOGUE = """
#ifdef __cplusplus
}
#endif

#endif
"""


def c_header(layouts: dict[str, Any]) -> str:
    """Return the text of the header for the layouts of `codegen.blocks.block_layouts`."""
    parts = [PROLOGUE.replace('"VERSION"', f'"{__version__}"')]
    parts += [_block(block, layouts[block]) for block in LIBRARY_BLOCKS]
    text = "\n".join(parts) + EPILOGUE
    # Plain ASCII: some compilers read sources in the code page of the machine.
    return text.replace("√", "sqrt ").replace("−", "-")


def _block(block: str, layout: dict[str, Any]) -> str:
    stem = stem_of(block)
    block_fields = number_fields(BLOCKS[block])
    config, upper = f"skinshade_{stem}_config", stem.upper()
    lines = [f"#define SKINSHADE_{upper}_BLOCK_SIZE {layout['size']}", ""]
    lines += [f"typedef struct {config} {{"]
    lines += [
        f"    float {_declared(field)}; /* {field_comment(field)} */" for field in block_fields
    ]
    lines += [f"}} {config};", ""]
    lines += [f"SKINSHADE_FUNCTION {config} skinshade_{stem}_defaults(void)", "{"]
    lines += [f"    {config} config;"]
    lines += [f"    {line}" for field in block_fields for line in _assigned(field)]
    lines += ["    return config;", "}", ""]
    lines += [f"SKINSHADE_FUNCTION skinshade_result skinshade_pack_{stem}("]
    lines += [f"    const {config} *config, void *bytes, size_t size)", "{"]
    lines += ["    unsigned char *block = (unsigned char *)bytes;", "    skinshade_error error;"]
    lines += ["    if (config == NULL || bytes == NULL)"]
    lines += ["        return skinshade_result_of(SKINSHADE_NULL_POINTER, NULL);"]
    lines += [f"    if (size < SKINSHADE_{upper}_BLOCK_SIZE)"]
    lines += ["        return skinshade_result_of(SKINSHADE_BUFFER_TOO_SMALL, NULL);"]
    for field in block_fields:
        m, count = meaning(field), _count(field)
        lines += [
            f"    error = skinshade_check({_pointer(field)}, {count}, {m.low!r}, {m.high!r});",
            "    if (error != SKINSHADE_OK)",
            f'        return skinshade_result_of(error, "{field.name}");',
        ]
    lines += [f"    memset(block, 0, SKINSHADE_{upper}_BLOCK_SIZE);"]
    for field in block_fields:
        offset = layout["fields"][field.name]["offset"]
        width = 4 * _count(field)
        lines.append(f"    memcpy(block + {offset}, {_pointer(field)}, {width});")
    lines += ["    return skinshade_result_of(SKINSHADE_OK, NULL);", "}", ""]
    return "\n".join(lines)


def _count(field: Field[Any]) -> int:
    default: Any = field.default
    return np.atleast_1d(default).size


def _declared(field: Field[Any]) -> str:
    count = _count(field)
    return field.name if count == 1 else f"{field.name}[{count}]"


def _pointer(field: Field[Any]) -> str:
    return f"&config->{field.name}" if _count(field) == 1 else f"config->{field.name}"


def _assigned(field: Field[Any]) -> list[str]:
    values = np.atleast_1d(np.asarray(field.default, dtype=np.float64))
    names = [field.name] if values.size == 1 else [f"{field.name}[{i}]" for i in range(values.size)]
    return [
        f"config.{name} = {float(value)!r}f;" for name, value in zip(names, values, strict=True)
    ]
