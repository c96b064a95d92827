"""Generated shader texts come from the package, as they are committed."""

import json
from pathlib import Path

import pytest

import skinshade
from skinshade._core.generated import generated_text

FOLDER = Path(skinshade.__file__).parent / "shading" / "generated"
NAMES = sorted(path.name for path in FOLDER.iterdir() if path.is_file())


def test_the_shader_of_every_language_is_in_the_package():
    expected = {"skin.wgsl", "skin.hlsl", "skin.metal", "skin.gl.glsl", "skin.vulkan.glsl"}
    assert expected | {"layout.json", "skinshade.h"} <= set(NAMES)


@pytest.mark.parametrize("name", NAMES)
def test_the_text_is_the_file_in_the_package(name):
    text = generated_text(name)
    assert text == (FOLDER / name).read_bytes().decode("utf-8")
    assert text.strip()


def test_the_layout_is_json_with_the_blocks():
    blocks = json.loads(generated_text("layout.json"))["blocks"]
    assert {"SkinBlock", "ScatterBlock", "FrameBlock", "LightBlock"} <= set(blocks)


def test_a_name_without_a_file_is_an_error():
    with pytest.raises(FileNotFoundError):
        generated_text("skin.spirv")
