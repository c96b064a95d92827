"""skin.gl.glsl in OpenGL without a display: fragment shaders of 3.3, compute shaders of 4.3."""

from __future__ import annotations

import numpy as np
from glsl_text import VERTEX, combined_samplers, compute_text, fragment_text
from rows import Runner, generated

from codegen.kernels import WORKGROUP
from codegen.signatures import FLOATS
from gpu_device import absent


class OpenGL(Runner):
    """Context of one version."""

    version: int

    def __init__(self):
        try:
            import moderngl

            self.context = moderngl.create_context(
                standalone=True, backend="egl", require=self.version
            )
        except Exception as error:  # a missing package, library or driver: all raise other types
            absent(f"OpenGL {self.version} does not open without a display ({error})")
        self.gl, self.library, self.programs = moderngl, generated("skin.gl.glsl"), {}

    def run(self, signature, rows, textures):
        with self.context:  # listing adapters or opening a context makes another one current
            if signature.name not in self.programs:
                self.programs[signature.name] = self.program(signature, list(textures))
            program, bound = self.programs[signature.name], []
            for unit, (name, texture) in enumerate(textures.items(), start=1):
                bound.append(self._bound(texture, unit))
                if name in program:  # a parameter that a function does not use is optimised away
                    program[name] = unit
            result = self.execute(program, rows, FLOATS[signature.returns])
            for texture in bound:
                texture.release()
            return result

    def program(self, signature, names):
        """Return the program that runs a function which samples textures of these names."""
        raise NotImplementedError

    def execute(self, program, rows, width):
        """Return the results (rows, width) of a program."""
        raise NotImplementedError

    def close(self):
        self.context.release()

    def _bound(self, texture, unit):
        size = texture.rgba.shape[1::-1]
        bound = self.context.texture(size, 4, texture.rgba.tobytes(), dtype="f4")
        kind = self.gl.LINEAR if texture.linear else self.gl.NEAREST
        bound.filter = kind, kind
        bound.repeat_x, bound.repeat_y = texture.repeats_u, False
        bound.use(unit)
        return bound


class Compute(OpenGL):
    """Reads rows from one buffer and writes them to another."""

    version = 430

    def program(self, signature, names):
        text = compute_text(
            [signature],
            self.library,
            version=self.version,
            declarations=combined_samplers(names),
            main=f"run_{signature.name}(row);",
            combined=True,
        )
        return self.context.compute_shader(text)

    def execute(self, program, rows, width):
        inputs = self.context.buffer(rows.tobytes())
        outputs = self.context.buffer(reserve=4 * len(rows) * width)
        inputs.bind_to_storage_buffer(0)
        outputs.bind_to_storage_buffer(1)
        program.run(len(rows) // WORKGROUP)
        self.context.memory_barrier()
        result = np.frombuffer(outputs.read(), dtype=np.float32).reshape(len(rows), width)
        for buffer in (inputs, outputs):
            buffer.release()
        return result


class Fragments(OpenGL):
    """Reads rows from one texture and writes them to another."""

    version = 330

    def program(self, signature, names):
        head = f"#version {self.version}\n"
        return self.context.program(
            vertex_shader=head + VERTEX,
            fragment_shader=head + fragment_text(signature, self.library, names),
        )

    def execute(self, program, rows, width):
        count, length = rows.shape
        inputs = self.context.texture((length, count), 1, rows.tobytes(), dtype="f4", alignment=4)
        inputs.filter = self.gl.NEAREST, self.gl.NEAREST
        inputs.use(0)
        program["inputs"] = 0
        texels = -(-width // 4)
        target = self.context.texture((texels, count), 4, dtype="f4")
        frame = self.context.framebuffer([target])
        frame.use()
        triangle = self.context.vertex_array(program, [])
        triangle.render(self.gl.TRIANGLES, vertices=3)
        result = np.frombuffer(target.read(alignment=4), dtype=np.float32)
        for resource in (triangle, frame, target, inputs):
            resource.release()
        return result.reshape(count, 4 * texels)[:, :width]
