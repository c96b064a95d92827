"""The shader package is complete and current, and the example of its guide compiles."""

from __future__ import annotations

import json
import re
import subprocess

import numpy as np
import pytest

import shading_tolerances as tol
from codegen.signatures import signatures
from gpu_device import adapter_or_skip, tool_or_skip
from skinshade._core.errors import ArgumentError, OutputError
from skinshade.lut import Lut
from skinshade.params import EyeParams, SkinParams
from skinshade.profile import Profile
from skinshade.sdk import LANGUAGES, Language, export_shaders
from skinshade.sdk.example import INPUTS, example_calls
from skinshade.shading.eye_tables import build_eye_lut, eye_place
from skinshade.shading.skin import Skin
from skinshade.shading.tables import ENGINE_LUTS

PARAMS = SkinParams(scatter_scale=1.5, shadow_filter_width_mm=12.0, gloss=0.2)


@pytest.fixture(scope="module")
def packages(tmp_path_factory):
    """Folder that holds the package of every language."""
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


def example_function(language):
    """Return the calls of the guide in a function whose parameters are the example's inputs."""
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
def test_the_calls_of_the_guide_compile_as_glsl(packages, tmp_path, language):
    tool_or_skip("glslangValidator")
    version, flags = GLSL[language]
    skin, blocks = library(packages, language)
    declared = "\n".join(LANGUAGES[language].declared())
    text = "\n".join(
        [version + skin, blocks, declared, example_function(language), "void main() {}\n"]
    )
    compile_shader(text, tmp_path, ["glslangValidator", *flags, "-S", "frag"])


@pytest.mark.parametrize("language", ["hlsl", "slang"])
def test_the_calls_of_the_guide_compile_as_hlsl(packages, tmp_path, language):
    tool_or_skip("glslangValidator")
    suffix = LANGUAGES[language].suffix
    includes = [f'#include "{name}.{suffix}"' for name in ("skin", "blocks")]
    declared = "\n".join(LANGUAGES[language].declared())
    main = "float4 main() : SV_Target { return 0.0; }\n"
    text = "\n".join([*includes, declared, example_function(language), main])
    flags = ["-D", "-V", "-e", "main", "-S", "frag", f"-I{packages / language}"]
    compile_shader(text, tmp_path, ["glslangValidator", *flags])


def compile_shader(text, folder, command):
    file = folder / "shader.frag"
    file.write_text(text, encoding="utf-8")
    output = ["-o", str(folder / "shader.spv")] if "-V" in command else []
    done = subprocess.run([*command, *output, str(file)], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout


def test_the_calls_of_the_guide_compile_as_wgsl(packages):
    adapter_or_skip()
    import wgpu

    from skinshade.gpu.device import open_device

    declared = "\n".join(LANGUAGES["wgsl"].declared())
    text = "\n".join([*library(packages, "wgsl"), declared, example_function("wgsl")])
    device = open_device()
    assert device.create_shader_module(code=text) is not None
    with pytest.raises(wgpu.GPUError, match="radianse"):
        device.create_shader_module(code=text.replace("return radiance", "return radianse"))


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_package_defines_every_public_function_once(packages, language):
    folder = packages / language
    suffix = LANGUAGES[language].suffix
    text = "\n".join(path.read_text("utf-8") for path in folder.glob(f"*.{suffix}"))
    for signature in signatures():
        definition = rf"\b{signature.name}\s*\([^;{{]*\)[^;{{]*\n\{{"
        assert len(re.findall(definition, text)) == 1, signature.name


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_guide_names_every_file_and_no_other(packages, language):
    """Includes of a library that is exported as sources, and copies of tables as PNG, go unnamed."""
    folder, suffix = packages / language, LANGUAGES[language].suffix
    guide = (folder / "README.md").read_text("utf-8")
    named = set(re.findall(r"`([\w.]+\.(?:bin|exr|h|json|\w*sl|slang|metal))`", guide))
    files = {path.name for path in folder.iterdir()}
    assert named <= files
    unnamed = {name for name in files - named if not name.endswith((".png", ".md"))}
    sources = {"common", "constants", *(signature.file for signature in signatures())}
    assert unnamed <= {f"{source}.{suffix}" for source in sources}
    assert "{" not in re.sub(r"```.*?```", "", guide, flags=re.DOTALL)


def test_every_language_is_described():
    assert list(LANGUAGES) == list(Language)


def test_blocks_and_tables_are_those_of_the_material(packages):
    folder = packages / "wgsl"
    skin = Skin.of(Profile.preset("skin-deon2007"), PARAMS)
    assert (folder / "skin_block.bin").read_bytes() == PARAMS.pack()
    assert (folder / "scatter_block.bin").read_bytes() == skin.scatter_params().pack()
    for name in ENGINE_LUTS:
        exact, rounded = (Lut.load(folder / f"{name}_lut{kind}") for kind in (".exr", ".png"))
        assert np.array_equal(exact.values, skin.lut(name).values)
        assert exact.axes == skin.lut(name).axes
        low, high = exact.value_range
        error = np.abs(rounded.values - exact.values).max()
        assert error <= tol.PNG16_STEP.value * (high - low)
    numbers = json.loads((folder / "skin.json").read_text("utf-8"))
    assert numbers["skin_block"]["scatter_scale"] == 1.5
    assert numbers["scatter_block"]["shadow_axes"] == list(skin.lut("shadow").axes)


def test_a_package_with_an_eye_has_its_blocks_tables_and_guide(tmp_path):
    eye = EyeParams(pupil_radius_mm=3.0)
    names = {path.name for path in export_shaders("wgsl", tmp_path, eye=eye)}
    luts = build_eye_lut(eye)
    for name, lut in luts.by_name().items():
        loaded = Lut.load(tmp_path / f"eye_{name}_lut.exr")
        assert np.array_equal(loaded.values, lut.values)
    assert (tmp_path / "eye_block.bin").read_bytes() == eye.pack()
    assert (tmp_path / "eye_place_block.bin").read_bytes() == eye_place(luts.by_name()).pack()
    guide = (tmp_path / "README.md").read_text("utf-8")
    assert set(re.findall(r"`(eye_\w+\.(?:bin|exr))`", guide)) == {
        name for name in names if name.startswith("eye_") and not name.endswith(".png")
    }
    numbers = json.loads((tmp_path / "skin.json").read_text("utf-8"))
    assert numbers["eye_block"]["pupil_radius_mm"] == 3.0
    assert numbers["eye_place_block"]["lamp_axes"] == list(luts.lamp.axes)


def test_two_exports_have_the_same_bytes(packages, tmp_path):
    again = export_shaders("hlsl", tmp_path / "again", params=PARAMS)
    for path in again:
        if path.suffix not in (".exr", ".png"):  # image files hold the time of their creation
            assert path.read_bytes() == (packages / "hlsl" / path.name).read_bytes()


def test_a_wrong_language_or_output_folder_is_reported_by_name(tmp_path):
    with pytest.raises(ArgumentError, match="language is 'cg'; it must be one of slang, hlsl"):
        export_shaders("cg", tmp_path)
    (tmp_path / "file").write_text("content")
    with pytest.raises(OutputError, match="file: cannot create the folder"):
        export_shaders("wgsl", tmp_path / "file")
    assert (tmp_path / "file").read_text() == "content"
