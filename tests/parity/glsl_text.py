"""GLSL programs that run the library on rows: compute shaders, and fragment shaders for old versions."""

from __future__ import annotations

from rows import GLSL, call, components, statements

from codegen.kernels import WORKGROUP

COMPUTE = """#version {version}
layout(local_size_x = {group}) in;
layout(std430, binding = 0) readonly buffer Inputs {{ float inputs[]; }};
layout(std430, binding = 1) buffer Outputs {{ float outputs[]; }};
{declarations}
{library}
{kernels}
void main()
{{
    uint row = gl_GlobalInvocationID.x;
    {main}
}}
"""
KERNEL = """void run_{name}(uint row)
{{
{statements}
}}
"""
VERTEX = """void main()
{
    gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
"""
"""One triangle that covers the whole target."""
FRAGMENT = """uniform sampler2D inputs;
{declarations}
out vec4 outputs;
{library}
float input_at(int column)
{{
    return texelFetch(inputs, ivec2(column, int(gl_FragCoord.y)), 0).x;
}}
void main()
{{
    {type} result = {call};
    float values[{width}] = float[{width}]({values});
    int first = 4 * int(gl_FragCoord.x);
    outputs = vec4(values[first], values[first + 1], values[first + 2], values[first + 3]);
}}
"""
"""A row of numbers is a row of texels; a fragment writes four floats of one result."""


def combined_samplers(names):
    return "\n".join(f"uniform sampler2D {name};" for name in names)


def compute_text(functions, library, *, version, declarations, main, combined):
    """Return a compute shader with a ``run_skin_...(row)`` for each function, which ``main`` calls."""
    kernels = [
        KERNEL.format(
            name=function.name,
            statements=statements(
                function,
                GLSL,
                index_type="uint",
                result_type=GLSL[function.returns],
                combined=combined,
            ),
        )
        for function in functions
    ]
    return COMPUTE.format(
        version=version,
        group=WORKGROUP,
        declarations=declarations,
        library=library,
        kernels="\n".join(kernels),
        main=main,
    )


def fragment_text(signature, library, names):
    """Return a fragment shader without its version line, for OpenGL 3.3 and WebGL 2."""
    values = components(signature)
    values += ["0.0"] * (-len(values) % 4)
    return FRAGMENT.format(
        declarations=combined_samplers(names),
        library=library,
        type=GLSL[signature.returns],
        call=call(signature, GLSL, lambda column: f"input_at({column})", combined=True),
        width=len(values),
        values=", ".join(values),
    )
