"""What a game on Direct3D 12 does with the library: DXIL of a pixel shader that calls it."""

from __future__ import annotations

import pytest
from in_hlsl import SOURCES, compiled, pixel_text

from skinshade.codegen.signatures import signatures

PIXEL_SHADER = ["-T", "ps_6_0", "-E", "main"]
FUNCTIONS = {each.name: each for each in signatures()}


@pytest.fixture(scope="module", params=SOURCES)
def dxil(request):
    _, folder = SOURCES[request.param]
    texts = [pixel_text(each, request.param) for each in FUNCTIONS.values()]
    found = compiled([(text, folder, PIXEL_SHADER) for text in texts])
    return dict(zip(FUNCTIONS, found, strict=True))


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_pixel_shader_that_calls_a_function_is_dxil_without_a_warning(dxil, name):
    binary, said = dxil[name]
    assert said == ""
    assert binary[:4] == b"DXBC"


def test_what_the_compiler_warns_of_is_rejected(tmp_path):
    text = "float4 main() : SV_Target { float3 all = 1; float2 cut = all; return cut.xyxy; }"
    ((binary, said),) = compiled([(text, tmp_path, PIXEL_SHADER)])
    assert binary == b""
    assert "implicit truncation" in said
