"""The C header packs the same bytes as Python for any configuration, in C and in C++."""

from __future__ import annotations

import re
import subprocess
from importlib.resources import files
from types import SimpleNamespace

import numpy as np
import pytest

from codegen.blocks import LIBRARY_BLOCKS, stem_of
from gpu_device import tool_or_skip
from skinshade.params import BLOCKS
from skinshade.params.fields import meaning, number_fields
from skinshade.params.packing import pack

COUNT = 200
COMPILERS = {"gcc": ["gcc", "-std=c99", "-x", "c"], "g++": ["g++", "-std=c++11", "-x", "c++"]}
STRICT = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]
GENERATED = files("skinshade").joinpath("shading/generated")

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


def run(compiler, program, block, folder, rows=b""):
    """Compile and run a program; return its output and the lines of its error stream."""
    tool_or_skip(compiler)
    stem = stem_of(block)
    source, binary = folder / "program.c", folder / "program"
    source.write_text(program.format(stem=stem, upper=stem.upper()))
    command = [
        *COMPILERS[compiler],
        *STRICT,
        f"-I{GENERATED}",
        str(source),
        "-o",
        str(binary),
        "-lm",
    ]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    ran = subprocess.run([str(binary)], input=rows, capture_output=True)
    assert ran.returncode == 0, ran.returncode
    return ran.stdout, ran.stderr.decode().splitlines()


def random_columns(block, seed):
    """Return random float32 values of every field, (COUNT, size) each; rows 0 and 1 are the limits."""
    rng = np.random.default_rng(seed)
    columns = []
    for field in number_fields(BLOCKS[block]):
        m, size = meaning(field), np.atleast_1d(field.default).size
        low, high = np.float32(m.low), np.float32(m.high)
        values = rng.uniform(low, high, (COUNT, size)).astype(np.float32)
        values[0], values[1] = low, high
        columns.append(values)
    return columns


def packed_by_python(block, columns, row):
    arguments = {}
    for field, column in zip(number_fields(BLOCKS[block]), columns, strict=True):
        m = meaning(field)
        # C compares in float32: a limit that float32 rounds outwards is within its range.
        values = tuple(min(max(float(v), m.low), m.high) for v in column[row])
        arguments[field.name] = values if isinstance(field.default, tuple) else values[0]
    return pack(block, SimpleNamespace(**arguments))  # C does not check that fields fit each other


@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("block", LIBRARY_BLOCKS)
def test_c_packs_the_same_bytes(block, compiler, tmp_path):
    columns = random_columns(block, 5)
    rows = np.concatenate(columns, axis=1).tobytes()
    data, results = run(compiler, PROGRAM, block, tmp_path, rows)
    size = len(data) // COUNT
    assert results == ["0 -"] * COUNT
    for row in range(COUNT):
        assert data[row * size : (row + 1) * size] == packed_by_python(block, columns, row)


@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("block", LIBRARY_BLOCKS)
def test_defaults_are_the_same_and_wrong_arguments_have_error_codes(block, compiler, tmp_path):
    data, messages = run(compiler, DEFAULTS, block, tmp_path)
    assert data == BLOCKS[block]().pack()
    assert messages == ["the buffer is smaller than the block"]


@pytest.mark.parametrize("value", ["beyond", "nan", "inf"])
def test_a_field_out_of_its_range_is_reported_by_name(value, tmp_path):
    rows, names = [], []
    for at, field in enumerate(number_fields(BLOCKS["SkinBlock"])):
        columns = [column[:1].copy() for column in random_columns("SkinBlock", 1)]
        bad = {"beyond": meaning(field).high * 1.01 + 1.0, "nan": np.nan, "inf": np.inf}[value]
        columns[at][0, -1] = bad
        rows.append(np.concatenate(columns, axis=1))
        names.append(field.name)
    _, results = run("gcc", PROGRAM, "SkinBlock", tmp_path, np.concatenate(rows).tobytes())
    code = 4 if value == "beyond" else 3
    assert results == [f"{code} {name}" for name in names]


def test_the_header_gives_the_range_and_unit_of_every_field():
    text = GENERATED.joinpath("skinshade.h").read_text("utf-8")
    for block in LIBRARY_BLOCKS:
        for field in number_fields(BLOCKS[block]):
            m = meaning(field)
            line = re.search(rf"^    float {field.name}[\[;].*$", text, re.M).group()
            assert f"{m.low:g}..{m.high:g}" in line
            assert m.unit == "1" or m.unit in line
