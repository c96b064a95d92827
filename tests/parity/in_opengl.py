"""skin.gl.glsl in OpenGL: fragments of version 3.3, compute shaders of version 4.3; no display is needed."""

from __future__ import annotations

import numpy as np
from glsl_text import VERTEX, combined_samplers, compute_text, fragment_text
from rows import Runner, generated

from gpu_device import absent
from skinshade.codegen.kernels import WORKGROUP
from skinshade.codegen.signatures import FLOATS


class OpenGL(Runner):
    """A context of one version."""

    version: int

    def __init__(self):
        try:
            import moderngl

            self.context = moderngl.create_context(
                standalone=True, backend="egl", require=self.version
            )
        except Exception as error:  # no package, no library or no driver: each in words of its own
            absent(f"no OpenGL of version {self.version} without a display ({error})")
        self.gl, self.library, self.programs = moderngl, generated("skin.gl.glsl"), {}

    def run(self, signature, rows, textures):
        with self.context:  # whoever lists adapters or opens a context has made it another's turn
            if signature.name not in self.programs:
                self.programs[signature.name] = self.program(signature, list(textures))
            program, kept = self.programs[signature.name], []
            for unit, (name, texture) in enumerate(textures.items(), start=1):
                kept.append(self._bound(texture, unit))
                if name in program:  # what a function takes and does not use is optimised away
                    program[name] = unit
            found = self.drawn(program, rows, FLOATS[signature.returns])
            for each in kept:
                each.release()
            return found

    def program(self, signature, names):
        """Return what runs a function that samples textures of these names."""
        raise NotImplementedError

    def drawn(self, program, rows, width):
        """Return (rows, width) of a program."""
        raise NotImplementedError

    def close(self):
        self.context.release()

    def _bound(self, texture, unit):
        size = texture.rgba.shape[1::-1]
        made = self.context.texture(size, 4, texture.rgba.tobytes(), dtype="f4")
        kind = self.gl.LINEAR if texture.linear else self.gl.NEAREST
        made.filter = kind, kind
        made.repeat_x, made.repeat_y = texture.around, False
        made.use(unit)
        return made


class Compute(OpenGL):
    """Rows from one buffer to another."""

    version = 430

    def program(self, signature, names):
        text = compute_text(
            [signature],
            self.library,
            version=self.version,
            declared=combined_samplers(names),
            main=f"run_{signature.name}(row);",
            combined=True,
        )
        return self.context.compute_shader(text)

    def drawn(self, program, rows, width):
        inputs = self.context.buffer(rows.tobytes())
        outputs = self.context.buffer(reserve=4 * len(rows) * width)
        inputs.bind_to_storage_buffer(0)
        outputs.bind_to_storage_buffer(1)
        program.run(len(rows) // WORKGROUP)
        self.context.memory_barrier()
        found = np.frombuffer(outputs.read(), dtype=np.float32).reshape(len(rows), width)
        for each in (inputs, outputs):
            each.release()
        return found


class Fragments(OpenGL):
    """Rows from one texture to another."""

    version = 330

    def program(self, signature, names):
        head = f"#version {self.version}\n"
        return self.context.program(
            vertex_shader=head + VERTEX,
            fragment_shader=head + fragment_text(signature, self.library, names),
        )

    def drawn(self, program, rows, width):
        count, length = rows.shape
        inputs = self.context.texture((length, count), 1, rows.tobytes(), dtype="f4", alignment=4)
        inputs.filter = self.gl.NEAREST, self.gl.NEAREST
        inputs.use(0)
        program["inputs"] = 0
        fours = -(-width // 4)
        target = self.context.texture((fours, count), 4, dtype="f4")
        frame = self.context.framebuffer([target])
        frame.use()
        triangle = self.context.vertex_array(program, [])
        triangle.render(self.gl.TRIANGLES, vertices=3)
        found = np.frombuffer(target.read(alignment=4), dtype=np.float32)
        for each in (triangle, frame, target, inputs):
            each.release()
        return found.reshape(count, 4 * fours)[:, :width]
