"""DXIL for Direct3D 12: pixel shaders that call the library compile without warnings."""

from __future__ import annotations

import pytest
from in_hlsl import SOURCES, compiled, pixel_text

from codegen.signatures import signatures

PIXEL_SHADER = ["-T", "ps_6_0", "-E", "main"]
FUNCTIONS = {signature.name: signature for signature in signatures()}


@pytest.fixture(scope="module", params=SOURCES)
def dxil(request):
    _, folder = SOURCES[request.param]
    texts = [pixel_text(signature, request.param) for signature in FUNCTIONS.values()]
    results = compiled([(text, folder, PIXEL_SHADER) for text in texts])
    return dict(zip(FUNCTIONS, results, strict=True))


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_pixel_shader_that_calls_a_function_compiles_to_dxil_without_warnings(dxil, name):
    binary, messages = dxil[name]
    assert messages == ""
    assert binary[:4] == b"DXBC"


def test_a_source_with_a_warning_is_rejected(tmp_path):
    text = "float4 main() : SV_Target { float3 all = 1; float2 cut = all; return cut.xyxy; }"
    ((binary, messages),) = compiled([(text, tmp_path, PIXEL_SHADER)])
    assert binary == b""
    assert "implicit truncation" in messages
