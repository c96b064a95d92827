"""moderngl: the library in a user's own program, and what is said where it does not fit."""

from __future__ import annotations

import numpy as np
import pytest

from gpu_device import absent
from skinshade._core.errors import ArgumentError, ShaderError
from skinshade.params import SkinParams
from skinshade.profile import Profile
from skinshade.shading.skin import Skin

moderngl = pytest.importorskip("moderngl")
from skinshade.integrations.moderngl import SkinProgram, shader_source  # noqa: E402

VERTEX = """#version 330
in vec2 corner;
void main() { gl_Position = vec4(corner, 0.0, 1.0); }
"""
FRAGMENT = """#version 330
out vec4 found;
void main()
{
    vec3 n = vec3(0.0, 0.0, 1.0);
    vec3 light = skin_direct_scalar(
        sphere_lut, scatter_block.sphere_axes, mat3(n, n, n), vec3(0.6, 0.0, 0.8), 0.05, vec3(1.0));
    found = vec4(skin_block.gloss, scatter_block.sphere_axes.y, light.x, skin_block.reflectance);
}
"""
CORNERS = np.array([-1, -1, 3, -1, -1, 3], dtype="f4")


@pytest.fixture(scope="module")
def context():
    try:
        made = moderngl.create_context(standalone=True, backend="egl", require=330)
    except Exception as error:  # the library raises whatever its loader met
        absent(f"no OpenGL context on EGL ({error})")
    with made:
        yield made
    made.release()


@pytest.fixture(scope="module")
def skin():
    return Skin.of(Profile.preset("skin-deon2007"), SkinParams(gloss=0.25))


def drawn(context, program):
    target = context.framebuffer([context.texture((1, 1), 4, dtype="f4")])
    target.use()
    program.use()
    corners = context.buffer(CORNERS.tobytes())
    context.vertex_array(program.program, [(corners, "2f", "corner")]).render()
    return np.frombuffer(target.read(components=4, dtype="f4"), dtype="f4")


def test_a_users_shader_reads_blocks_and_tables(context, skin):
    program = SkinProgram(context, skin, vertex_shader=VERTEX, fragment_shader=FRAGMENT)
    found = drawn(context, program)
    assert found[0] == np.float32(0.25)
    assert found[1] == np.float32(skin.sphere.axes[1])
    assert found[2] == pytest.approx(skin.sphere.sample(0.8, 0.05)[0], abs=1e-4)
    assert found[3] == np.float32(0.028)
    program.write(SkinParams(gloss=0.5))
    assert drawn(context, program)[0] == np.float32(0.5)
    with pytest.raises(ArgumentError, match="shadow_sharpening: the tables were made for 8"):
        program.write(SkinParams(shadow_sharpening=4.0))


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("skin_block.gloss", "skin_block.glos", "glos"),
        ("skin_direct_scalar(", "skin_direct_skalar(", "skin_direct_skalar"),
        ("sphere_lut, ", "sphere_lut, lut_sampler, ", "lut_sampler"),
        ("out vec4 found;", "uniform sampler3D sphere_lut; out vec4 found;", "sphere_lut"),
        ("scatter_block.sphere_axes, ", "scatter_block.normal_sigmas_mm, ", "skin_direct_scalar"),
    ],
    ids=["field", "function", "sampler", "kind of texture", "type of argument"],
)
def test_one_wrong_name_or_type_is_in_the_compilers_complaint(context, skin, old, new, told):
    assert FRAGMENT.count(old) == 1
    with pytest.raises(ShaderError, match=f"(?s)does not compile.*{told}"):
        SkinProgram(context, skin, vertex_shader=VERTEX, fragment_shader=FRAGMENT.replace(old, new))


def test_a_complaint_gives_the_users_own_line(context, skin):
    broken = FRAGMENT.replace("found = vec4", "nothing = vec4")
    line = broken.splitlines().index(next(x for x in broken.splitlines() if "nothing" in x)) + 1
    with pytest.raises(ShaderError, match=rf"0:{line}\b"):
        SkinProgram(context, skin, vertex_shader=VERTEX, fragment_shader=broken)


def test_a_block_of_another_size_is_named(context, skin, monkeypatch):
    from skinshade.integrations import moderngl as ours

    older = {name: {"size": 64} for name in ("SkinBlock", "ScatterBlock")}
    monkeypatch.setattr(ours, "layout", lambda: older)
    with pytest.raises(
        ShaderError, match="SkinUniforms: the driver gives it 80 bytes; this version"
    ):
        SkinProgram(context, skin, vertex_shader=VERTEX, fragment_shader=FRAGMENT)


def test_the_version_comes_first():
    with pytest.raises(ShaderError, match="does not begin with #version"):
        shader_source("void main() {}")
    assert shader_source("#version 300 es\nvoid main() {}").startswith("#version 300 es\nprecision")
