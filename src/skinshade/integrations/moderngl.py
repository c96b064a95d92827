"""moderngl: the library compiled into a user's own program, its blocks and tables set."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

import numpy as np

from .._core.errors import DependencyError, ShaderError
from ..params import SkinParams
from ..params.packing import layout
from ..sdk.languages import LANGUAGES
from ..shaders import generated_text
from ..shading.skin import LUTS, Skin

try:
    import moderngl
except ImportError as error:
    raise DependencyError('moderngl is not installed: pip install "skinshade[moderngl]"') from error

__all__ = ["SkinProgram", "shader_source"]

BLOCKS = {"SkinUniforms": "SkinBlock", "ScatterUniforms": "ScatterBlock"}
SAMPLER_2D = 0x8B5E
VERSION = re.compile(r"\A\s*#version[^\n]*\n")


def shader_source(text: str) -> str:
    """Return a fragment shader with the library put after its ``#version`` line.

    It then has every function ``skin_…``, the blocks ``skin_block`` and ``scatter_block``, and the
    tables ``ring_lut``, ``sphere_lut``, ``transfer_lut`` and ``shadow_lut``.

    Parameters
    ----------
    text
        GLSL, 3.30 or later, or ES 3.00.

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
    # Complaints of the compiler keep the user's own line numbers.
    return "\n".join(
        [version.group().strip(), form.prologue, *parts, declared, f"#line {line}", rest]
    )


class SkinProgram:
    """A program whose fragment shader calls the library, with one material's blocks and tables.

    Parameters
    ----------
    context
        The user's.
    skin
        Profile and parameters: ``skinshade.Skin.of(profile, params)``.
    vertex_shader, fragment_shader
        GLSL; the library is put into the fragment shader.
    fetches
        Of the normal map that the shader makes, 3 or 2.
    first_texture_unit, first_uniform_block
        Where tables and blocks are bound, upwards; the user's own stay below.

    Attributes
    ----------
    program
        The ``moderngl.Program``, for the user's own uniforms and vertex arrays.

    Raises
    ------
    ShaderError
        If a program does not compile, or declares a block or a table otherwise than the library.
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
        """Fill both blocks for the draws that follow.

        Raises
        ------
        ArgumentError
            If a parameter changes that the tables were made for.
        """
        self.skin = self.skin.with_params(params)
        for name, packed in self._packed().items():
            if name in self._blocks:
                self._blocks[name].write(packed)

    def _packed(self) -> dict[str, bytes]:
        scatter = self.skin.scatter_params(self._fetches)
        return {"SkinUniforms": self.skin.params.pack(), "ScatterUniforms": scatter.pack()}

    def use(self) -> None:
        """Bind blocks and tables; before a draw, if anything else has been bound since."""
        for at, (name, texture) in enumerate(self._textures.items()):
            texture.use(self._units + at)
            self._member(f"{name}_lut").value = self._units + at
        for at, (name, block) in enumerate(self._blocks.items()):
            self._member(name).binding = self._slots + at
            block.bind_to_uniform_block(self._slots + at)

    def _tables_used(self) -> Sequence[str]:
        """Tables that the compiler kept."""
        used = [name for name in LUTS if f"{name}_lut" in self.program]
        for name in used:
            kind = getattr(self._member(f"{name}_lut"), "gl_type", None)
            if kind != SAMPLER_2D:
                raise ShaderError(f"{name}_lut: is not a sampler2D; do not declare it yourself")
        return used

    def _member(self, name: str) -> Any:
        # Its type says nothing of which kind of member a name is.
        return self.program[name]

    def _uses_block(self, name: str) -> bool:
        if name not in self.program:
            return False
        size, wanted = self._member(name).size, layout()[BLOCKS[name]]["size"]
        if size != wanted:
            raise ShaderError(
                f"{name}: the driver gives it {size} bytes; this version's has {wanted}"
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
