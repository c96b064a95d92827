"""The C header: the same bytes as Python's for any configuration, by a C and a C++ compiler."""

from __future__ import annotations

import re
import subprocess
from dataclasses import fields
from importlib.resources import files

import numpy as np
import pytest

from gpu_device import tool_or_skip
from skinshade.codegen.blocks import LIBRARY_BLOCKS
from skinshade.params import BLOCKS
from skinshade.params.fields import meaning

COUNT = 200
COMPILERS = {"gcc": ["gcc", "-std=c99", "-x", "c"], "g++": ["g++", "-std=c++11", "-x", "c++"]}
STRICT = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]
HEADER = files("skinshade.shaders").joinpath("generated")

PROGRAM = """
#include "skinshade.h"
#include <stdio.h>
#define STEM {stem}
int main(void)
{{
    skinshade_{stem}_config config;
    unsigned char bytes[SKINSHADE_{upper}_BLOCK_SIZE];
    while (fread(&config, sizeof config, 1, stdin) == 1) {{
        skinshade_result result = skinshade_pack_{stem}(&config, bytes, sizeof bytes);
        if (result.error != SKINSHADE_OK) memset(bytes, 255, sizeof bytes);
        fwrite(bytes, sizeof bytes, 1, stdout);
        fprintf(stderr, "%d %s\\n", (int)result.error, result.field ? result.field : "-");
    }}
    return 0;
}}
"""
DEFAULTS = """
#include "skinshade.h"
#include <stdio.h>
int main(void)
{{
    skinshade_{stem}_config config = skinshade_{stem}_defaults();
    unsigned char bytes[SKINSHADE_{upper}_BLOCK_SIZE];
    skinshade_result small = skinshade_pack_{stem}(&config, bytes, sizeof bytes - 1);
    skinshade_result none = skinshade_pack_{stem}(NULL, bytes, sizeof bytes);
    if (small.error != SKINSHADE_BUFFER_TOO_SMALL || none.error != SKINSHADE_NULL_POINTER) return 1;
    if (skinshade_pack_{stem}(&config, bytes, sizeof bytes).error != SKINSHADE_OK) return 2;
    fwrite(bytes, sizeof bytes, 1, stdout);
    fprintf(stderr, "%s", skinshade_error_message(small.error));
    return 0;
}}
"""


def stem_of(block):
    return block.removesuffix("Block").lower()


def run(compiler, program, block, folder, given=b""):
    tool_or_skip(compiler)
    stem = stem_of(block)
    source, binary = folder / "program.c", folder / "program"
    source.write_text(program.format(stem=stem, upper=stem.upper()))
    command = [*COMPILERS[compiler], *STRICT, f"-I{HEADER}", str(source), "-o", str(binary), "-lm"]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    ran = subprocess.run([str(binary)], input=given, capture_output=True)
    assert ran.returncode == 0, ran.returncode
    return ran.stdout, ran.stderr.decode().splitlines()


def drawn(block, seed):
    """Random configurations as float32 rows, every limit among them."""
    rng = np.random.default_rng(seed)
    columns = []
    for field in fields(BLOCKS[block]):
        m, size = meaning(field), np.atleast_1d(field.default).size
        low, high = np.float32(m.low), np.float32(m.high)
        values = rng.uniform(low, high, (COUNT, size)).astype(np.float32)
        values[0], values[1] = low, high
        columns.append(values)
    return columns


def packed_by_python(block, columns, row):
    of = fields(BLOCKS[block])
    given = {}
    for field, column in zip(of, columns, strict=True):
        m = meaning(field)
        # A limit that float32 rounds outwards is within the range that C compares in float32.
        values = tuple(min(max(float(v), m.low), m.high) for v in column[row])
        given[field.name] = values if isinstance(field.default, tuple) else values[0]
    return BLOCKS[block](**given).pack()


@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("block", LIBRARY_BLOCKS)
def test_c_packs_the_same_bytes(block, compiler, tmp_path):
    columns = drawn(block, 5)
    given = np.concatenate(columns, axis=1).tobytes()
    data, told = run(compiler, PROGRAM, block, tmp_path, given)
    size = len(data) // COUNT
    assert told == ["0 -"] * COUNT
    for row in range(COUNT):
        assert data[row * size : (row + 1) * size] == packed_by_python(block, columns, row)


@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("block", LIBRARY_BLOCKS)
def test_defaults_are_the_same_and_misuse_has_a_code(block, compiler, tmp_path):
    data, told = run(compiler, DEFAULTS, block, tmp_path)
    assert data == BLOCKS[block]().pack()
    assert told == ["the buffer is smaller than the block"]


@pytest.mark.parametrize("value", ["beyond", "nan", "inf"])
def test_a_field_out_of_its_range_is_named(value, tmp_path):
    rows, names = [], []
    for at, field in enumerate(fields(BLOCKS["SkinBlock"])):
        columns = [column[:1].copy() for column in drawn("SkinBlock", 1)]
        bad = {"beyond": meaning(field).high * 1.01 + 1.0, "nan": np.nan, "inf": np.inf}[value]
        columns[at][0, -1] = bad
        rows.append(np.concatenate(columns, axis=1))
        names.append(field.name)
    _, told = run("gcc", PROGRAM, "SkinBlock", tmp_path, np.concatenate(rows).tobytes())
    code = 4 if value == "beyond" else 3
    assert told == [f"{code} {name}" for name in names]


def test_the_header_explains_every_field_with_range_and_unit():
    text = HEADER.joinpath("skinshade.h").read_text("utf-8")
    for block in LIBRARY_BLOCKS:
        for field in fields(BLOCKS[block]):
            m = meaning(field)
            line = re.search(rf"^    float {field.name}[\[;].*$", text, re.M).group()
            assert f"{m.low:g}..{m.high:g}" in line
            assert m.unit == "1" or m.unit in line
