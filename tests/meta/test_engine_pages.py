"""Pages for engines: complete, with a status, and with shaders that compile."""

from __future__ import annotations

import ast
import re
import subprocess

import numpy as np
import pytest

import skinshade as sk
from codegen.signatures import signatures
from gpu_device import absent, adapter_or_skip, tool_or_skip
from parity import dxc
from skinshade.sdk import LANGUAGES, export_shaders

SECTIONS = ["What to put where", "Conventions", "In the shader", "What differs"]
STATUS = re.compile(r"^\*\*Status:\*\* (run in CI|compiled in CI|not run)\b", re.MULTILINE)
CONVENTIONS = ["matrix order", "depth range", "handedness", "colour space", "UV origin", "units"]
MOST_LINES = 110
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
VERSION = re.compile(r"\A#version[^\n]*\n")

FORMS = {
    "hlsl": "hlsl",
    "vulkan": "glsl-vulkan",
    "opengl": "glsl-gl",
    "webgl": "glsl-es",
    "webgpu": "wgsl",
    "pygfx": "wgsl",
    "moderngl": "glsl-gl",
    "unity": "hlsl",
    "unreal": "hlsl",
    "godot": "glsl-gl",
    "bevy": "wgsl",
}
"""Exported language that each page describes."""
DECLARED = {"moderngl"}
"""Pages of tools that declare blocks and tables for the user."""
VERSIONS = {
    "glsl-vulkan": "#version 450\n",
    "glsl-gl": "#version 330\n",
    "glsl-es": "#version 300 es\n",
}
MAINS = {"hlsl": "float4 main() : SV_Target { return 0.0; }\n"}
"""Entry points, by file suffix, for pages that leave them to the engine."""
SHADERS = ("hlsl", "glsl", "wgsl", "js", "gdshader", "shaderlab", "c", "rust")
"""Languages of code blocks that may call the library."""


@pytest.fixture(scope="module")
def folder(repository):
    return repository / "docs" / "engines"


@pytest.fixture(scope="module")
def packages(tmp_path_factory):
    folder = tmp_path_factory.mktemp("packages")
    for language in {*FORMS.values()}:
        export_shaders(language, folder / language)
    return folder


def page(folder, name):
    return (folder / f"{name}.md").read_text("utf-8")


def blocks(text, *kinds):
    return [body for kind, body in BLOCK.findall(text) if kind in kinds]


def shader(folder, packages, name):
    """Return one text of the library, the blocks, and all code of a page in its language."""
    language = LANGUAGES[FORMS[name]]
    own = "\n".join(blocks(page(folder, name), language.suffix))
    version = VERSION.match(own)
    names = [f"{stem}.{language.suffix}" for stem in ("skin", "blocks")]
    texts = [packages.joinpath(FORMS[name], file).read_text("utf-8") for file in names]
    if language.suffix == "hlsl":
        texts = ['#include "skin.hlsl"', '#include "blocks.hlsl"']
    if name in DECLARED:
        texts += language.declared()
    if "main(" not in own:
        own += MAINS.get(language.suffix, "")
    if version:
        return "\n".join([version.group(), *texts, own[version.end() :]])
    return "\n".join([VERSIONS.get(FORMS[name], ""), *texts, own])


def pages_in(suffix):
    return [name for name, language in FORMS.items() if LANGUAGES[language].suffix == suffix]


# -- the pages -------------------------------------------------------------------------------------


def test_every_engine_has_a_page_that_the_overview_lists_with_its_status(repository, folder):
    assert {path.stem for path in folder.iterdir()} == set(FORMS)
    overview = (repository / "docs" / "shaders.md").read_text("utf-8")
    rows = dict(re.findall(r"\]\(engines/(\w+)\.md\) \|[^|]*\| ([^|]*) \|", overview))
    assert rows == {name: STATUS.search(page(folder, name)).group(1) for name in FORMS}
    assert "(functions.md)" in overview


@pytest.mark.parametrize("name", FORMS)
def test_a_page_has_a_status_and_all_sections(folder, name):
    text = page(folder, name)
    assert len(STATUS.findall(text)) == 1
    assert text.splitlines()[2].startswith("**Status:** ")
    assert re.findall(r"^## (.*)$", text, re.MULTILINE) == SECTIONS
    assert len(text.splitlines()) <= MOST_LINES


@pytest.mark.parametrize("name", FORMS)
def test_a_page_states_every_convention(folder, name):
    section = page(folder, name).split("## Conventions")[1].split("## In the shader")[0]
    rows = [line.strip("| ").split(" | ") for line in section.splitlines() if line.startswith("|")]
    assert [row[0] for row in rows[2:]] == CONVENTIONS
    assert {len(row) for row in (rows[0], *rows[2:])} == {3}


# -- calls -----------------------------------------------------------------------------------------


def arguments(text, start):
    """Return the arguments of a call whose opening parenthesis is just before `start`."""
    depth, first, result = 1, start, []
    for index in range(start, len(text)):
        if text[index] in "([{":
            depth += 1
        elif text[index] in ")]}":
            depth -= 1
        # Types of WGSL in the pages contain no comma.
        if depth == 0 or (depth == 1 and text[index] == ","):
            result.append(text[first:index].strip())
            first = index + 1
        if depth == 0:
            return result
    raise AssertionError(f"no closing parenthesis after {text[start : start + 40]!r}")


def calls(text):
    """Return name and arguments of each call of the library."""
    code = re.sub(r"//[^\n]*", "", text)
    return [
        (match.group(1), arguments(code, match.end()))
        for match in re.finditer(r"\b(skin_[a-z0-9_]+)\s*\(", code)
    ]


def argument_count(signature, combined):
    """Return the number of arguments of a call; `combined` textures include their samplers."""
    samplers = 0 if combined else 1
    counts = {"tex2d": 1 + samplers, "lut": 2 + samplers}
    return sum(counts.get(parameter.kind, 1) for parameter in signature.parameters)


def test_arguments_are_counted_as_a_compiler_would():
    text = "skin_f(a, g(b, c), float3(x, y[1, 2], z)); skin_g(skin_h(1), 2) // skin_none(1)"
    assert [(name, len(values)) for name, values in calls(text)] == [
        ("skin_f", 3),
        ("skin_g", 2),
        ("skin_h", 1),
    ]


@pytest.mark.parametrize("name", FORMS)
def test_every_call_names_a_function_of_the_library_and_has_its_number_of_arguments(folder, name):
    text = page(folder, name)
    combined = LANGUAGES[FORMS[name]].combined
    known = {function.name: argument_count(function, combined) for function in signatures()}
    counts = {call: len(values) for call, values in calls("\n".join(blocks(text, *SHADERS)))}
    assert counts or name == "pygfx"
    assert {call: known.get(call) for call in counts} == counts
    prose = BLOCK.sub("", text)
    named = set(re.findall(r"`(skin_\w+)`", prose)) - {"skin_block", "skin_geometry", "skin_light"}
    assert named <= set(known)


@pytest.mark.parametrize("name", FORMS)
def test_every_table_is_passed_with_its_own_axes(folder, name):
    """A compiler would also accept ``ring_lut`` with ``shadow_axes``."""
    for call, values in calls("\n".join(blocks(page(folder, name), *SHADERS))):
        tables = re.findall(
            r"\b\w*?(ring|sphere|transfer|shadow)(?:_lut)?\b(?=,|$)", ",".join(values)
        )
        axes = re.findall(r"\b\w*?(ring|sphere|transfer|shadow)_axes\b", ",".join(values))
        assert not axes or tables == axes, call


# -- compilers -------------------------------------------------------------------------------------


def accepted(text, folder, *flags):
    program = tool_or_skip("glslangValidator")
    file = folder / "page.frag"
    file.write_text(text, encoding="utf-8")
    command = [program, *flags, "-S", "frag", str(file)]
    if "-V" in flags:
        command += ["-o", str(folder / "page.spv")]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout


@pytest.mark.parametrize("name", [name for name in pages_in("glsl") if name != "godot"])
def test_the_reference_compiler_accepts_the_glsl_of_a_page(folder, packages, tmp_path, name):
    flags = ["-V"] if FORMS[name] == "glsl-vulkan" else []
    accepted(shader(folder, packages, name), tmp_path, *flags)


def test_the_page_of_godot_has_no_glsl(folder):
    """Godot has its own shading language, which no compiler here accepts."""
    assert blocks(page(folder, "godot"), "gdshader")
    assert not blocks(page(folder, "godot"), "glsl")


@pytest.mark.parametrize("name", pages_in("hlsl"))
def test_the_reference_compiler_accepts_the_hlsl_of_a_page(folder, packages, tmp_path, name):
    flags = ["-D", "-V", "-e", "main", f"-I{packages / 'hlsl'}", "--auto-map-bindings"]
    accepted(shader(folder, packages, name), tmp_path, *flags)


@pytest.mark.parametrize("name", pages_in("hlsl"))
def test_the_directx_compiler_accepts_the_hlsl_of_a_page(folder, packages, name):
    if not dxc.LIBRARY.is_file():
        absent("the DirectX shader compiler is not installed; see tools/language_tools.py")
    job = shader(folder, packages, name), packages / "hlsl", ["-T", "ps_6_0", "-E", "main"]
    ((binary, messages),) = dxc.compiled([job])
    assert messages == ""
    assert binary[:4] == b"DXBC"


@pytest.mark.parametrize("name", [name for name in pages_in("wgsl") if name != "pygfx"])
def test_naga_accepts_the_wgsl_of_a_page(folder, packages, name):
    adapter_or_skip()
    from skinshade.gpu.device import open_device

    assert open_device().create_shader_module(code=shader(folder, packages, name)) is not None


# -- Python ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", [*FORMS, "../shaders"])
def test_the_python_of_a_page_parses_and_uses_public_names(folder, name):
    for body in blocks(page(folder, name), "py"):
        for node in ast.walk(ast.parse(body)):
            if isinstance(node, ast.Attribute) and getattr(node.value, "id", "") == "sk":
                assert node.attr in sk.__all__


def run_in(folder, monkeypatch, body):
    monkeypatch.chdir(folder)
    exec(compile(body, "page", "exec"), {})


def test_the_half_floats_of_the_overview_are_the_tables_in_the_sizes_that_it_states(
    repository, tmp_path, monkeypatch
):
    text = (repository / "docs" / "shaders.md").read_text("utf-8")
    export_shaders("wgsl", tmp_path / "skin")
    (body,) = [block for block in blocks(text, "py") if ".f16" in block]
    run_in(tmp_path, monkeypatch, body)
    sizes = {}
    for names, width, height in re.findall(r"(`[\w` and]+`) (\d+)×(\d+)", text):
        sizes |= dict.fromkeys(re.findall(r"\w+_lut", names), (int(height), int(width)))
    error = float(re.search(r"err by\s+(\S+) at most", text).group(1))
    assert len(sizes) == 5
    for name, size in sizes.items():
        table = sk.Lut.load(tmp_path / "skin" / f"{name}.exr").values
        halves = np.fromfile(tmp_path / "skin" / f"{name}.f16", dtype="<f2").reshape(*size, 4)
        assert table.shape[:2] == size
        assert np.abs(halves[..., :3] - table).max() <= error


def test_the_constants_for_unreal_are_the_blocks_and_compile_with_its_shader(
    folder, tmp_path, monkeypatch
):
    export_shaders("hlsl", tmp_path / "skin")
    (body,) = blocks(page(folder, "unreal"), "py")
    run_in(tmp_path, monkeypatch, body)
    names = ("skin", "blocks", "material")
    text = "\n".join(f'#include "{name}.ush"' for name in names)
    main = (
        "float4 main() : SV_Target"
        " { return scatter_block.rms_radius_mm.x + scatter_block.normal_sigmas_mm.y + skin_block.gloss; }"
    )
    source = "\n".join([text, *blocks(page(folder, "unreal"), "hlsl"), main])
    accepted(source, tmp_path, "-D", "-V", "-e", "main", f"-I{tmp_path / 'skin'}")
    constants = (tmp_path / "skin" / "material.ush").read_text("utf-8").splitlines()
    for line, block, count in zip(constants, ("skin", "scatter"), (18, 55), strict=True):
        inside = line[line.index("{") :].replace("float4", "").replace("float2", "")
        numbers = np.array(re.findall(r"[-\d.e]+", inside), dtype="<f4").tobytes()
        assert numbers == (tmp_path / "skin" / f"{block}_block.bin").read_bytes()[: 4 * count]
