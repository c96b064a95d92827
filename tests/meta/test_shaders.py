"""Shader library: generated files are current, functions have twins, every language compiles."""

from __future__ import annotations

import inspect
import re
import subprocess
from importlib import import_module

import pytest

from codegen.build import DOCS, GENERATED, generate, generate_docs
from codegen.compiler import LIBRARY, PASSES, CompilerError, translate, version
from codegen.signatures import signatures, twin_module
from gpu_device import absent, tool_or_skip
from skinshade.rendering.prepare.shadow_map import FILTER_TAPS
from skinshade.rendering.settings import TAP_COUNTS

HOST_ONLY = {
    "ambient": {"sh_basis": "inside skin_ambient_irradiance"},
    "contact": {"unhidden_share": "inside skin_contact_filter"},
    "deep_scatter": {
        "default_sigma_per_mm": "evaluated once per profile",
        "mean_thickness": "inside skin_thickness",
        "poisson_disk": "a constant table",
    },
    "image_light": {
        "LOBE_POWERS": "constants",
        "PreconvolvedRadiance": "its atlas is the texture",
        "bilinear": "the work of a sampler",
    },
    "normals": {
        "normal_blend": "a fit, once per profile",
        "NormalBlend": "ScatterParams holds it",
    },
    "shadow": {
        "lit_share": "inside skin_shadow_filter",
        "plane_slope": "inside skin_shadow_slope and skin_contact_slope",
        "shadow_disk": "a constant table",
    },
    "tonemap": {"tonemap": "a choice between two functions"},
}
"""Names of the specification without a twin, with the reasons."""
RENAMED = {
    name: tuple(f"{name}_{channel}" for channel in ("red", "green", "blue"))
    for name in ("ambient_transfer", "radiance_sh")
}
"""Parameters with another form in shaders: a matrix of nine coefficients for every channel."""
FILES = sorted({signature.file for signature in signatures()})


def specification(file):
    signature = next(signature for signature in signatures() if signature.file == file)
    return import_module(twin_module(signature))


@pytest.fixture(scope="module")
def compiler():
    try:
        return version()
    except CompilerError as error:
        absent(str(error))


@pytest.fixture(scope="module")
def texts(compiler):
    return generate()


def test_generated_files_are_current(texts):
    committed = {path.name: path.read_text("utf-8") for path in GENERATED.iterdir()}
    assert set(committed) == set(texts)
    for name, text in texts.items():
        assert committed[name] == text, f"{name} is stale: run `make shaders`"


def test_tap_counts_are_multiples_of_the_tap_group():
    text = (PASSES / "incident.slang").read_text("utf-8")
    group = int(re.search(r"TAP_GROUP = (\d+);", text).group(1))
    taps = (FILTER_TAPS, *TAP_COUNTS)
    assert [count % group for count in taps] == [0] * len(taps)


def test_generated_documents_are_current(texts):
    for name, text in generate_docs(texts).items():
        assert (DOCS / name).read_text("utf-8") == text, f"{name} is stale: run `make shaders`"


@pytest.mark.parametrize("file", FILES)
def test_shaders_and_specification_have_the_same_functions(file):
    in_shader = {signature.twin for signature in signatures() if signature.file == file}
    module = specification(file)
    in_numpy = {name for name in module.__all__ if name not in HOST_ONLY.get(file, {})}
    assert in_shader == in_numpy


@pytest.mark.parametrize("signature", signatures(), ids=lambda signature: signature.name)
def test_twins_take_the_same_parameters_in_the_same_order(signature):
    twin = getattr(specification(signature.file), signature.twin)
    expected = []
    for name in inspect.signature(twin).parameters:
        expected += RENAMED.get(name, (name,))
    assert [parameter.name for parameter in signature.parameters] == expected


@pytest.mark.parametrize("path", sorted(LIBRARY.glob("*.slang")), ids=lambda path: path.stem)
def test_every_source_begins_with_a_comment_and_is_short(path):
    lines = path.read_text("utf-8").splitlines()
    assert lines[0].startswith("// ")
    assert len(lines) <= 250


@pytest.mark.parametrize("path", sorted(LIBRARY.glob("*.slang")), ids=lambda path: path.stem)
def test_a_comment_precedes_every_public_function_of_more_than_a_few_lines(path):
    text = path.read_text("utf-8")
    for match in re.finditer(r"^SKIN_API[^{]*\{\n(.*?)^\}", text, re.MULTILINE | re.DOTALL):
        before = text[: match.start()].rstrip().splitlines()[-1]
        assert before.startswith("//") or match.group(1).count("\n") <= 6, match.group(0)[:80]


@pytest.mark.parametrize("file", FILES)
def test_twins_are_in_the_same_folder(file):
    assert (LIBRARY / f"{file}.slang").is_file()
    assert (LIBRARY / f"{file}.py").is_file()


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
