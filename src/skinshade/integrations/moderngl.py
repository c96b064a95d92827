"""Shader library in a user's moderngl program, with its blocks and tables."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

import numpy as np

from .._core.errors import DependencyError, ShaderError
from .._core.generated import generated_text
from ..params import SkinParams
from ..params.packing import layout
from ..sdk.languages import LANGUAGES
from ..shading.skin import Skin
from ..shading.tables import LUTS

try:
    import moderngl
except ImportError as error:
    raise DependencyError('moderngl is not installed: pip install "skinshade[moderngl]"') from error

__all__ = ["SkinProgram", "shader_source"]

BLOCKS = {"SkinUniforms": "SkinBlock", "ScatterUniforms": "ScatterBlock"}
SAMPLER_2D = 0x8B5E
VERSION = re.compile(r"\A\s*#version[^\n]*\n")


def shader_source(text: str) -> str:
    """Return a fragment shader with the library inserted after its ``#version`` line.

    The shader can then call every function ``skin_…`` and read the blocks ``skin_block`` and
    ``scatter_block`` and the tables ``ring_lut``, ``sphere_lut``, ``transfer_lut``, ``shadow_lut`` and
    ``coat_lut``.

    Parameters
    ----------
    text
        Fragment shader in GLSL, 3.30 or later, or ES 3.00.

    Raises
    ------
    ShaderError
        If the text does not begin with ``#version``.
    """
    version = VERSION.match(text)
    if version is None:
        raise ShaderError("the shader does not begin with #version, which must come first")
    form = LANGUAGES["glsl-es" if " es" in version.group() else "glsl-gl"]
    parts = [generated_text(name) for name in (form.library, form.structs)]
    declared = "\n".join(form.declared())
    line = version.group().count("\n") + 1
    rest = text[version.end() :]
    # With #line, compiler messages refer to the lines of the user's text.
    return "\n".join(
        [version.group().strip(), form.prologue, *parts, declared, f"#line {line}", rest]
    )


class SkinProgram:
    """A program whose fragment shader calls the library, with the blocks and tables of one material.

    Parameters
    ----------
    context
        moderngl context of the user.
    skin
        Material: ``skinshade.Skin.of(profile, params)``, with the weights of `fetches`.
    vertex_shader, fragment_shader
        Shaders in GLSL. The library is inserted into the fragment shader.
    fetches
        Number of normal map fetches in the shader, 3 or 2.
    first_texture_unit, first_uniform_block
        First units of the tables and of the blocks. Lower units stay free for the user.

    Attributes
    ----------
    program
        ``moderngl.Program``, for uniforms and vertex arrays of the user.

    Raises
    ------
    ShaderError
        If the program does not compile, or declares a block or a table that differs from the library's.
    """

    def __init__(
        self,
        context: moderngl.Context,
        skin: Skin,
        *,
        vertex_shader: str,
        fragment_shader: str,
        fetches: int = 3,
        first_texture_unit: int = 8,
        first_uniform_block: int = 8,
    ) -> None:
        self.skin, self._fetches = skin, fetches
        self._context = context
        self._units, self._slots = first_texture_unit, first_uniform_block
        source = shader_source(fragment_shader)
        try:
            self.program = context.program(vertex_shader=vertex_shader, fragment_shader=source)
        except moderngl.Error as error:
            raise ShaderError(f"the program does not compile: {str(error).strip()}") from None
        self._textures = {name: self._table(name) for name in self._tables_used()}
        self._blocks = {
            name: context.buffer(packed)
            for name, packed in self._packed().items()
            if self._uses_block(name)
        }

    def write(self, params: SkinParams) -> None:
        """Write both blocks with new `params`.

        Raises
        ------
        ArgumentError
            If the tables depend on a parameter that changes.
        """
        self.skin = self.skin.with_params(params)
        for name, packed in self._packed().items():
            if name in self._blocks:
                self._blocks[name].write(packed)

    def _packed(self) -> dict[str, bytes]:
        scatter = self.skin.scatter_params(self._fetches)
        return {"SkinUniforms": self.skin.params.pack(), "ScatterUniforms": scatter.pack()}

    def use(self) -> None:
        """Bind blocks and tables. Call this before a draw if other resources were bound to their units."""
        for unit, (name, texture) in enumerate(self._textures.items(), self._units):
            texture.use(unit)
            self._member(f"{name}_lut").value = unit
        for slot, (name, block) in enumerate(self._blocks.items(), self._slots):
            self._member(name).binding = slot
            block.bind_to_uniform_block(slot)

    def _tables_used(self) -> Sequence[str]:
        """Return the names of the tables that the compiled program reads."""
        used = [name for name in LUTS if f"{name}_lut" in self.program]
        for name in used:
            kind = getattr(self._member(f"{name}_lut"), "gl_type", None)
            if kind != SAMPLER_2D:
                raise ShaderError(
                    f"{name}_lut: is not a sampler2D; remove its declaration from the shader"
                )
        return used

    def _member(self, name: str) -> Any:
        # The type hints of `moderngl.Program` do not distinguish uniforms from blocks.
        return self.program[name]

    def _uses_block(self, name: str) -> bool:
        if name not in self.program:
            return False
        size, expected = self._member(name).size, layout()[BLOCKS[name]]["size"]
        if size != expected:
            raise ShaderError(
                f"{name}: the shader's block has {size} bytes; the library's has {expected}; remove its"
                " declaration from the shader"
            )
        return True

    def _table(self, name: str) -> Any:
        values = self.skin.lut(name).values
        texture = self._context.texture(
            values.shape[1::-1], 3, np.ascontiguousarray(values).tobytes(), dtype="f4", alignment=4
        )
        texture.filter = (moderngl.LINEAR, moderngl.LINEAR)
        texture.repeat_x = texture.repeat_y = False
        return texture
