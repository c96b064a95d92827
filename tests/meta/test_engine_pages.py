"""The pages for engines: whole, honest about what was run, and their shaders compile."""

from __future__ import annotations

import ast
import re
import subprocess

import numpy as np
import pytest

import skinshade as sk
from gpu_device import absent, adapter_or_skip, tool_or_skip
from parity import dxc
from skinshade.codegen.signatures import signatures
from skinshade.sdk import LANGUAGES, export_shaders

SECTIONS = ["What to put where", "Conventions", "In the shader", "What differs"]
STATUS = re.compile(r"^\*\*Status:\*\* (run in CI|compiled in CI|not run)\b", re.MULTILINE)
MATTERS = ["matrix order", "depth range", "handedness", "colour space", "UV origin", "units"]
LONGEST = 110
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
"""Which export a page is about."""
DECLARED = {"moderngl"}
"""Pages whose tool declares blocks and tables for the user."""
VERSIONS = {
    "glsl-vulkan": "#version 450\n",
    "glsl-gl": "#version 330\n",
    "glsl-es": "#version 300 es\n",
}
MAINS = {"hlsl": "float4 main() : SV_Target { return 0.0; }\n"}
"""For what a page leaves to the engine."""
SHADERS = ("hlsl", "glsl", "wgsl", "js", "gdshader", "shaderlab", "c", "rust")
"""Blocks that may call the library."""


@pytest.fixture(scope="module")
def folder(repository):
    return repository / "docs" / "engines"


@pytest.fixture(scope="module")
def packages(tmp_path_factory):
    place = tmp_path_factory.mktemp("packages")
    for language in {*FORMS.values()}:
        export_shaders(language, place / language)
    return place


def page(folder, name):
    return (folder / f"{name}.md").read_text("utf-8")


def blocks(text, *kinds):
    return [body for kind, body in BLOCK.findall(text) if kind in kinds]


def shader(folder, packages, name):
    """Library, blocks, and all that a page shows in its language, as one text."""
    form = LANGUAGES[FORMS[name]]
    own = "\n".join(blocks(page(folder, name), form.suffix))
    version = VERSION.match(own)
    parts = [packages.joinpath(FORMS[name], f"{each}.{form.suffix}") for each in ("skin", "blocks")]
    texts = [part.read_text("utf-8") for part in parts]
    if form.suffix == "hlsl":
        texts = ['#include "skin.hlsl"', '#include "blocks.hlsl"']
    if name in DECLARED:
        texts += form.declared()
    if "main(" not in own:
        own += MAINS.get(form.suffix, "")
    if version:
        return "\n".join([version.group(), *texts, own[version.end() :]])
    return "\n".join([VERSIONS.get(FORMS[name], ""), *texts, own])


def pages_in(suffix):
    return [name for name, form in FORMS.items() if LANGUAGES[form].suffix == suffix]


# -- the pages -------------------------------------------------------------------------------------


def test_there_is_a_page_for_every_engine_and_the_overview_leads_to_each(repository, folder):
    assert {path.stem for path in folder.iterdir()} == set(FORMS)
    overview = (repository / "docs" / "shaders.md").read_text("utf-8")
    rows = dict(re.findall(r"\]\(engines/(\w+)\.md\) \|[^|]*\| ([^|]*) \|", overview))
    assert rows == {name: STATUS.search(page(folder, name)).group(1) for name in FORMS}
    assert "(functions.md)" in overview


@pytest.mark.parametrize("name", FORMS)
def test_a_page_says_what_was_run_and_has_its_sections(folder, name):
    text = page(folder, name)
    assert len(STATUS.findall(text)) == 1
    assert text.splitlines()[2].startswith("**Status:** ")
    assert re.findall(r"^## (.*)$", text, re.MULTILINE) == SECTIONS
    assert len(text.splitlines()) <= LONGEST


@pytest.mark.parametrize("name", FORMS)
def test_a_page_tells_every_convention(folder, name):
    section = page(folder, name).split("## Conventions")[1].split("## In the shader")[0]
    rows = [line.strip("| ").split(" | ") for line in section.splitlines() if line.startswith("|")]
    assert [row[0] for row in rows[2:]] == MATTERS
    assert {len(row) for row in (rows[0], *rows[2:])} == {3}


# -- calls -----------------------------------------------------------------------------------------


def arguments(text, start):
    """Split what stands between the parenthesis that opens before a place and its end."""
    depth, last, found = 1, start, []
    for at in range(start, len(text)):
        if text[at] in "([{":
            depth += 1
        elif text[at] in ")]}":
            depth -= 1
        # WGSL's types bring no comma.
        if depth == 0 or (depth == 1 and text[at] == ","):
            found.append(text[last:at].strip())
            last = at + 1
        if depth == 0:
            return found
    raise AssertionError(f"no end of {text[start : start + 40]!r}")


def calls(text):
    """Name and arguments of each call of the library."""
    code = re.sub(r"//[^\n]*", "", text)
    return [
        (each.group(1), arguments(code, each.end()))
        for each in re.finditer(r"\b(skin_[a-z0-9_]+)\s*\(", code)
    ]


def wanted(signature, combined):
    apart = 0 if combined else 1
    takes = {"tex2d": 1 + apart, "lut": 2 + apart}
    return sum(takes.get(each.kind, 1) for each in signature.parameters)


def test_arguments_are_counted_as_a_compiler_would():
    text = "skin_f(a, g(b, c), float3(x, y[1, 2], z)); skin_g(skin_h(1), 2) // skin_none(1)"
    found = calls(text)
    assert [(name, len(given)) for name, given in found] == [
        ("skin_f", 3),
        ("skin_g", 2),
        ("skin_h", 1),
    ]


@pytest.mark.parametrize("name", FORMS)
def test_every_call_is_of_a_function_of_the_library_with_as_many_arguments(folder, name):
    text = page(folder, name)
    known = {each.name: wanted(each, LANGUAGES[FORMS[name]].combined) for each in signatures()}
    found = calls("\n".join(blocks(text, *SHADERS)))
    assert found or name == "pygfx"
    counts = {call: len(given) for call, given in found}
    assert {call: known.get(call) for call in counts} == counts
    prose = BLOCK.sub("", text)
    named = set(re.findall(r"`(skin_\w+)`", prose)) - {"skin_block", "skin_geometry", "skin_light"}
    assert named <= set(known)


@pytest.mark.parametrize("name", FORMS)
def test_a_table_is_given_with_its_own_axes(folder, name):
    """``ring_lut`` with ``shadow_axes`` compiles as well."""
    for call, given in calls("\n".join(blocks(page(folder, name), *SHADERS))):
        tables = re.findall(
            r"\b\w*?(ring|sphere|transfer|shadow)(?:_lut)?\b(?=,|$)", ",".join(given)
        )
        axes = re.findall(r"\b\w*?(ring|sphere|transfer|shadow)_axes\b", ",".join(given))
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


@pytest.mark.parametrize("name", [each for each in pages_in("glsl") if each != "godot"])
def test_the_reference_compiler_accepts_what_a_page_shows_as_glsl(folder, packages, tmp_path, name):
    flags = ["-V"] if FORMS[name] == "glsl-vulkan" else []
    accepted(shader(folder, packages, name), tmp_path, *flags)


def test_godots_page_shows_nothing_that_is_called_glsl(folder):
    """Its language is its own, and no compiler here knows it."""
    assert blocks(page(folder, "godot"), "gdshader")
    assert not blocks(page(folder, "godot"), "glsl")


@pytest.mark.parametrize("name", pages_in("hlsl"))
def test_the_reference_compiler_accepts_what_a_page_shows_as_hlsl(folder, packages, tmp_path, name):
    flags = ["-D", "-V", "-e", "main", f"-I{packages / 'hlsl'}", "--auto-map-bindings"]
    accepted(shader(folder, packages, name), tmp_path, *flags)


@pytest.mark.parametrize("name", pages_in("hlsl"))
def test_the_directx_compiler_accepts_what_a_page_shows(folder, packages, name):
    if not dxc.LIBRARY.is_file():
        absent("no DirectX shader compiler; see tools/language_tools.py")
    job = shader(folder, packages, name), packages / "hlsl", ["-T", "ps_6_0", "-E", "main"]
    ((binary, said),) = dxc.compiled([job])
    assert said == ""
    assert binary[:4] == b"DXBC"


@pytest.mark.parametrize("name", [each for each in pages_in("wgsl") if each != "pygfx"])
def test_naga_accepts_what_a_page_shows(folder, packages, name):
    adapter_or_skip()
    from skinshade.gpu.device import open_device

    assert open_device().create_shader_module(code=shader(folder, packages, name)) is not None


# -- Python ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", [*FORMS, "../shaders"])
def test_python_is_python_and_uses_public_names(folder, name):
    for body in blocks(page(folder, name), "py"):
        for node in ast.walk(ast.parse(body)):
            if isinstance(node, ast.Attribute) and getattr(node.value, "id", "") == "sk":
                assert node.attr in sk.__all__


def run_in(place, monkeypatch, body):
    monkeypatch.chdir(place)
    exec(compile(body, "page", "exec"), {})


def test_the_overviews_half_floats_are_the_tables_in_the_sizes_that_it_tells(
    repository, tmp_path, monkeypatch
):
    text = (repository / "docs" / "shaders.md").read_text("utf-8")
    export_shaders("wgsl", tmp_path / "skin")
    (body,) = [each for each in blocks(text, "py") if ".f16" in each]
    run_in(tmp_path, monkeypatch, body)
    told = {}
    for names, width, height in re.findall(r"(`[\w` and]+`) (\d+)×(\d+)", text):
        told |= dict.fromkeys(re.findall(r"\w+_lut", names), (int(height), int(width)))
    error = float(re.search(r"err by\s+(\S+) at most", text).group(1))
    assert len(told) == 4
    for name, size in told.items():
        table = sk.Lut.load(tmp_path / "skin" / f"{name}.exr").values
        halfs = np.fromfile(tmp_path / "skin" / f"{name}.f16", dtype="<f2").reshape(*size, 4)
        assert table.shape[:2] == size
        assert np.abs(halfs[..., :3] - table).max() <= error


def test_unreals_constants_are_the_blocks_and_compile_with_its_shader(
    folder, tmp_path, monkeypatch
):
    export_shaders("hlsl", tmp_path / "skin")
    (body,) = blocks(page(folder, "unreal"), "py")
    run_in(tmp_path, monkeypatch, body)
    names = ("skin", "blocks", "constants")
    text = "\n".join(f'#include "{name}.ush"' for name in names)
    main = (
        "float4 main() : SV_Target"
        " { return scatter_block.rms_radius_mm.x + scatter_block.normal_sigmas_mm.y + skin_block.gloss; }"
    )
    source = "\n".join([text, *blocks(page(folder, "unreal"), "hlsl"), main])
    accepted(source, tmp_path, "-D", "-V", "-e", "main", f"-I{tmp_path / 'skin'}")
    constants = (tmp_path / "skin" / "constants.ush").read_text("utf-8").splitlines()
    for line, block, count in zip(constants, ("skin", "scatter"), (18, 50), strict=True):
        inside = line[line.index("{") :].replace("float4", "").replace("float2", "")
        numbers = np.array(re.findall(r"[-\d.e]+", inside), dtype="<f4").tobytes()
        assert numbers == (tmp_path / "skin" / f"{block}_block.bin").read_bytes()[: 4 * count]
