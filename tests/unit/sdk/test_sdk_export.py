"""The package for engines: whole, current, and its own example compiles in every language."""

from __future__ import annotations

import json
import re
import subprocess

import numpy as np
import pytest

from gpu_device import adapter_or_skip, tool_or_skip
from skinshade._core.errors import ArgumentError, OutputError
from skinshade.codegen.signatures import signatures
from skinshade.lut import Lut
from skinshade.params import SkinParams
from skinshade.profile import Profile
from skinshade.sdk import LANGUAGES, export_shaders
from skinshade.sdk.example import INPUTS, example_calls
from skinshade.shading.skin import ENGINE_LUTS, Skin

PARAMS = SkinParams(scatter_scale=1.5, shadow_filter_width_mm=12.0, gloss=0.2)


@pytest.fixture(scope="module")
def packages(tmp_path_factory):
    """Every language's folder."""
    folder = tmp_path_factory.mktemp("packages")
    for language in LANGUAGES:
        export_shaders(language, folder / language, params=PARAMS)
    return folder


def library(folder, language):
    form = LANGUAGES[language]
    return [
        (folder / language / f"{name}.{form.suffix}").read_text("utf-8")
        for name in ("skin", "blocks")
    ]


def called_example(language):
    """The guide's calls inside a function whose parameters are the example's inputs."""
    form = LANGUAGES[language]
    body = "\n".join(f"    {line}" for line in example_calls(form))
    if form.suffix == "wgsl":
        inputs = ", ".join(f"{name} : {form.type_of(kind)}" for kind, name, _ in INPUTS)
        return f"fn shade({inputs}) -> vec3<f32> {{\n{body}\n    return radiance;\n}}\n"
    inputs = ", ".join(f"{form.type_of(kind)} {name}" for kind, name, _ in INPUTS)
    return f"{form.type_of('float3')} shade({inputs})\n{{\n{body}\n    return radiance;\n}}\n"


GLSL = {
    "glsl-vulkan": ("#version 450\n", ["-V"]),
    "glsl-gl": ("#version 330\n", []),
    "glsl-es": ("#version 300 es\n", []),
}


@pytest.mark.parametrize("language", GLSL)
def test_the_guides_calls_compile_as_glsl(packages, tmp_path, language):
    tool_or_skip("glslangValidator")
    version, flags = GLSL[language]
    skin, blocks = library(packages, language)
    declared = "\n".join(LANGUAGES[language].declared())
    text = "\n".join(
        [version + skin, blocks, declared, called_example(language), "void main() {}\n"]
    )
    compiled(text, tmp_path, ["glslangValidator", *flags, "-S", "frag"])


@pytest.mark.parametrize("language", ["hlsl", "slang"])
def test_the_guides_calls_compile_as_hlsl(packages, tmp_path, language):
    tool_or_skip("glslangValidator")
    suffix = LANGUAGES[language].suffix
    includes = [f'#include "{name}.{suffix}"' for name in ("skin", "blocks")]
    declared = "\n".join(LANGUAGES[language].declared())
    main = "float4 main() : SV_Target { return 0.0; }\n"
    text = "\n".join([*includes, declared, called_example(language), main])
    flags = ["-D", "-V", "-e", "main", "-S", "frag", f"-I{packages / language}"]
    compiled(text, tmp_path, ["glslangValidator", *flags])


def compiled(text, folder, command):
    file = folder / "shader.frag"
    file.write_text(text, encoding="utf-8")
    output = ["-o", str(folder / "shader.spv")] if "-V" in command else []
    done = subprocess.run([*command, *output, str(file)], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout


def test_the_guides_calls_compile_as_wgsl(packages):
    adapter_or_skip()
    import wgpu

    from skinshade.gpu.device import open_device

    declared = "\n".join(LANGUAGES["wgsl"].declared())
    text = "\n".join([*library(packages, "wgsl"), declared, called_example("wgsl")])
    device = open_device()
    assert device.create_shader_module(code=text) is not None
    with pytest.raises(wgpu.GPUError, match="radianse"):
        device.create_shader_module(code=text.replace("return radiance", "return radianse"))


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_package_holds_every_public_function_under_its_own_name(packages, language):
    folder = packages / language
    suffix = LANGUAGES[language].suffix
    text = "\n".join(path.read_text("utf-8") for path in folder.glob(f"*.{suffix}"))
    for each in signatures():
        assert len(re.findall(rf"\b{each.name}\s*\([^;{{]*\)[^;{{]*\n\{{", text)) == 1, each.name


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_guide_names_every_file_and_nothing_else(packages, language):
    folder = packages / language
    guide = (folder / "README.md").read_text("utf-8")
    named = set(re.findall(r"`([\w.]+\.(?:bin|exr|h|json|\w*sl|slang|metal))`", guide))
    there = {path.name for path in folder.iterdir()}
    assert named <= there
    hidden = {name for name in there - named if not name.endswith((".png", ".md"))}
    assert hidden <= {f"{each.file}.{LANGUAGES[language].suffix}" for each in signatures()} | {
        f"{name}.{LANGUAGES[language].suffix}" for name in ("common", "poisson")
    }
    assert "{" not in re.sub(r"```.*?```", "", guide, flags=re.DOTALL)


def test_blocks_and_tables_are_those_of_the_material(packages):
    folder = packages / "wgsl"
    skin = Skin.of(Profile.preset("skin-deon2007"), PARAMS)
    assert (folder / "skin_block.bin").read_bytes() == PARAMS.pack()
    assert (folder / "scatter_block.bin").read_bytes() == skin.scatter_params().pack()
    for name in ENGINE_LUTS:
        exact, eight = (Lut.load(folder / f"{name}_lut{kind}") for kind in (".exr", ".png"))
        assert np.array_equal(exact.values, skin.lut(name).values)
        assert exact.axes == skin.lut(name).axes
        low, high = exact.value_range
        assert np.abs(eight.values - exact.values).max() <= 0.51 * (high - low) / 65535.0
    told = json.loads((folder / "skin.json").read_text("utf-8"))
    assert told["skin_block"]["scatter_scale"] == 1.5
    assert told["scatter_block"]["shadow_axes"] == list(skin.shadow.axes)


def test_the_same_request_gives_the_same_bytes(packages, tmp_path):
    again = export_shaders("hlsl", tmp_path / "again", params=PARAMS)
    for path in again:
        if path.suffix not in (".exr", ".png"):  # image files carry the time of day
            assert path.read_bytes() == (packages / "hlsl" / path.name).read_bytes()


def test_a_language_or_a_folder_that_is_none_is_named(tmp_path):
    with pytest.raises(ArgumentError, match="'cg'; it must be one of slang, hlsl"):
        export_shaders("cg", tmp_path)
    (tmp_path / "file").write_text("here")
    with pytest.raises(OutputError, match="file: cannot make the folder"):
        export_shaders("wgsl", tmp_path / "file")
    assert (tmp_path / "file").read_text() == "here"
