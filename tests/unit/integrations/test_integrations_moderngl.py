"""The library within a user's moderngl program: blocks, tables, and the errors of wrong shaders."""

from __future__ import annotations

import numpy as np
import pytest

import shading_tolerances as tol
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
out vec4 result;
void main()
{
    vec3 n = vec3(0.0, 0.0, 1.0);
    vec3 light = skin_direct_scalar(
        sphere_lut, scatter_block.sphere_axes, mat3(n, n, n), vec3(0.6, 0.0, 0.8), 0.05, vec3(1.0));
    result = vec4(skin_block.gloss, scatter_block.sphere_axes.y, light.x, skin_block.reflectance);
}
"""
CORNERS = np.array([-1, -1, 3, -1, -1, 3], dtype="f4")


@pytest.fixture(scope="module")
def context():
    try:
        created = moderngl.create_context(standalone=True, backend="egl", require=330)
    except Exception as error:  # the type depends on the loader
        absent(f"no OpenGL context on EGL ({error})")
    with created:
        yield created
    created.release()


@pytest.fixture(scope="module")
def skin():
    return Skin.of(Profile.preset("skin-deon2007"), SkinParams(gloss=0.25))


def draw(context, program):
    """Return the colour (4,) of a picture of one pixel."""
    target = context.framebuffer([context.texture((1, 1), 4, dtype="f4")])
    target.use()
    program.use()
    corners = context.buffer(CORNERS.tobytes())
    context.vertex_array(program.program, [(corners, "2f", "corner")]).render()
    return np.frombuffer(target.read(components=4, dtype="f4"), dtype="f4")


def test_a_users_shader_reads_blocks_and_tables(context, skin):
    program = SkinProgram(context, skin, vertex_shader=VERTEX, fragment_shader=FRAGMENT)
    result, sphere = draw(context, program), skin.lut("sphere")
    assert result[0] == np.float32(0.25)
    assert result[1] == np.float32(sphere.axes[1])
    expected = sphere.sample(0.8, 0.05)[0]
    assert result[2] == pytest.approx(expected, abs=tol.GPU_LOOKUP.value)
    assert result[3] == np.float32(0.028)
    program.write(SkinParams(gloss=0.5))
    assert draw(context, program)[0] == np.float32(0.5)


def test_a_parameter_that_the_tables_depend_on_cannot_be_written(context, skin):
    program = SkinProgram(context, skin, vertex_shader=VERTEX, fragment_shader=FRAGMENT)
    message = "shadow_sharpening is 4.0, but the tables were built for 8.0"
    with pytest.raises(ArgumentError, match=message):
        program.write(SkinParams(shadow_sharpening=4.0))
    assert draw(context, program)[0] == np.float32(0.25)


def test_a_table_that_the_skin_was_made_without_is_reported_by_name(context):
    bare = Skin.of(Profile.preset("skin-deon2007"), SkinParams(), luts=("ring",))
    with pytest.raises(ArgumentError, match="the skin has no table 'sphere'; make it with luts="):
        SkinProgram(context, bare, vertex_shader=VERTEX, fragment_shader=FRAGMENT)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("skin_block.gloss", "skin_block.glos", "glos"),
        ("skin_direct_scalar(", "skin_direct_skalar(", "skin_direct_skalar"),
        ("sphere_lut, ", "sphere_lut, lut_sampler, ", "lut_sampler"),
        ("out vec4 result;", "uniform sampler3D sphere_lut; out vec4 result;", "sphere_lut"),
        ("scatter_block.sphere_axes, ", "scatter_block.normal_sigmas_mm, ", "skin_direct_scalar"),
    ],
    ids=["field", "function", "sampler", "kind of texture", "type of argument"],
)
def test_a_wrong_name_or_type_is_in_the_message_of_the_compiler(context, skin, old, new, message):
    assert FRAGMENT.count(old) == 1
    with pytest.raises(ShaderError, match=f"(?s)does not compile.*{message}"):
        SkinProgram(context, skin, vertex_shader=VERTEX, fragment_shader=FRAGMENT.replace(old, new))


def test_the_message_of_the_compiler_has_the_line_number_of_the_users_text(context, skin):
    broken = FRAGMENT.replace("result = vec4", "nothing = vec4")
    line = broken.splitlines().index(next(x for x in broken.splitlines() if "nothing" in x)) + 1
    with pytest.raises(ShaderError, match=rf"0:{line}\b"):
        SkinProgram(context, skin, vertex_shader=VERTEX, fragment_shader=broken)


def test_a_block_of_another_size_is_reported_by_name(context, skin, monkeypatch):
    from skinshade.integrations import moderngl as integration

    older = {name: {"size": 64} for name in ("SkinBlock", "ScatterBlock")}
    monkeypatch.setattr(integration, "layout", lambda: older)
    with pytest.raises(
        ShaderError, match="SkinUniforms: the shader's block has 80 bytes; the library's has 64"
    ):
        SkinProgram(context, skin, vertex_shader=VERTEX, fragment_shader=FRAGMENT)


def test_the_library_stands_after_the_version_line():
    with pytest.raises(ShaderError, match="does not begin with #version"):
        shader_source("void main() {}")
    assert shader_source("#version 300 es\nvoid main() {}").startswith("#version 300 es\nprecision")
