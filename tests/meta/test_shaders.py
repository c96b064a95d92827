"""The shader library: generated files current, every function with its twin, valid in every language."""

from __future__ import annotations

import inspect
import re
import subprocess
from importlib import import_module

import pytest

from gpu_device import tool_or_skip
from skinshade._core.errors import CompilerError
from skinshade.codegen.build import GENERATED, PAGE, generate
from skinshade.codegen.compiler import LIBRARY, translate, version
from skinshade.codegen.function_page import function_page
from skinshade.codegen.signatures import signatures, twin_module
from skinshade.render.cpu.shadow_map import FILTER_TAPS
from skinshade.render.renderer import TAP_COUNTS

HOST_ONLY = {
    "ambient": {"sh_basis": "inside skin_ambient_irradiance"},
    "deep_scatter": {
        "default_sigma_per_mm": "once a profile",
        "poisson_disk": "a constant table",
        "thickness_from_depths": "inside skin_thickness",
    },
    "image_light": {
        "LOBE_POWERS": "constants",
        "PreconvolvedRadiance": "its atlas is the texture",
        "bilinear": "what a sampler does",
    },
    "normals": {"normal_blend": "a fit, once a profile", "NormalBlend": "ScatterParams holds it"},
    "tonemap": {"ToneMap": "a type", "tonemap": "a choice between two functions"},
}
"""Names of the specification that no pixel calls, and why."""
RENAMED = {"radiance_sh": ("radiance_sh_red", "radiance_sh_green", "radiance_sh_blue")}
"""Nine coefficients a channel are a matrix each in a shader."""
FILES = sorted({each.file for each in signatures()})


def specification(file):
    return import_module(twin_module(next(each for each in signatures() if each.file == file)))


@pytest.fixture(scope="module")
def compiler():
    try:
        return version()
    except CompilerError as error:
        pytest.fail(str(error))


@pytest.fixture(scope="module")
def made(compiler):
    return generate()


def test_what_is_committed_is_what_the_generator_makes(made):
    committed = {path.name: path.read_text("utf-8") for path in GENERATED.iterdir()}
    assert set(committed) == set(made)
    for name, text in made.items():
        assert committed[name] == text, f"{name} is stale: run `make shaders`"


def test_taps_come_in_whole_groups():
    text = (LIBRARY.parent / "passes" / "incident.slang").read_text("utf-8")
    at_once = int(re.search(r"AT_ONCE = (\d+);", text).group(1))
    taps = (FILTER_TAPS, *TAP_COUNTS)
    assert [count % at_once for count in taps] == [0] * len(taps)


def test_the_page_of_functions_is_current(made, repository):
    current = function_page(made)
    assert (repository / "docs" / PAGE).read_text("utf-8") == current, "run `make shaders`"


@pytest.mark.parametrize("file", FILES)
def test_both_sides_have_the_same_functions(file):
    in_shader = {each.twin for each in signatures() if each.file == file}
    module = specification(file)
    in_numpy = {name for name in module.__all__ if name not in HOST_ONLY.get(file, {})}
    assert in_shader == in_numpy


@pytest.mark.parametrize("signature", signatures(), ids=lambda each: each.name)
def test_twins_take_the_same_parameters_in_the_same_order(signature):
    twin = getattr(specification(signature.file), signature.twin)
    wanted = []
    for name in inspect.signature(twin).parameters:
        wanted += RENAMED.get(name, (name,))
    assert [parameter.name for parameter in signature.parameters] == wanted


@pytest.mark.parametrize("path", sorted(LIBRARY.glob("*.slang")), ids=lambda path: path.stem)
def test_every_public_function_is_explained_where_it_stands(path):
    lines = path.read_text("utf-8").splitlines()
    assert lines[0].startswith("// ")
    assert len(lines) <= 250


GLSL = {
    "vulkan": (
        "skin.vulkan.glsl",
        "#version 450\n",
        "layout(local_size_x = 1) in;",
        ["-V"],
        "comp",
    ),
    "opengl-3.3": ("skin.gl.glsl", "#version 330\n", "", [], "frag"),
    "opengl-4.3": ("skin.gl.glsl", "#version 430\n", "", [], "frag"),
    "es-3.0": ("skin.gl.glsl", "#version 300 es\nprecision highp float;\n", "", [], "frag"),
}


def validated(source, folder, stage, flags):
    tool_or_skip("glslangValidator")
    file = folder / f"library.{stage}"
    file.write_text(source, encoding="utf-8")
    command = ["glslangValidator", *flags, "-S", stage, str(file)]
    if "-V" in flags:
        command += ["-o", str(folder / "library.spv")]
    return subprocess.run(command, capture_output=True, text=True)


@pytest.mark.parametrize("language", GLSL)
def test_the_reference_compiler_accepts_the_library_as_glsl(tmp_path, language):
    name, version_line, layout, flags, stage = GLSL[language]
    text = (GENERATED / name).read_text("utf-8")
    source = f"{version_line}{text}\n{layout}\nvoid main() {{}}\n"
    done = validated(source, tmp_path, stage, flags)
    assert done.returncode == 0, done.stdout


@pytest.mark.parametrize("source", ["generated", "commented"])
def test_the_reference_compiler_accepts_the_library_as_hlsl(tmp_path, source):
    text = (GENERATED / "skin.hlsl").read_text("utf-8")
    if source == "commented":
        text = '#include "skin.slang"\n'
    main = "float4 main() : SV_Target { return float4(skin_filmic(float3(1, 1, 1)), 1); }\n"
    flags = ["-D", "-V", "-e", "main", f"-I{LIBRARY}"]
    done = validated(f"{text}\n{main}", tmp_path, "frag", flags)
    assert done.returncode == 0, done.stdout


def test_slang_imports_the_library_as_a_module(compiler):
    source = """import skin;
    RWStructuredBuffer<float3> found;
    [shader("compute")] [numthreads(1, 1, 1)]
    void main() { found[0] = skin_filmic(found[0]); }
    """
    assert "skin_filmic" in translate(source, "wgsl").text


def test_a_source_that_does_not_compile_is_an_error_that_quotes_the_compiler(compiler):
    with pytest.raises(CompilerError, match="undefined identifier"):
        translate("void main() { nothing(); }", "wgsl")
