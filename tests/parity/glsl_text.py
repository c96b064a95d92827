"""Programs in GLSL that run the library on rows: compute shaders, and fragments where there are none."""

from __future__ import annotations

from rows import GLSL, call, parts, statements

from skinshade.codegen.kernels import WORKGROUP

COMPUTE = """#version {version}
layout(local_size_x = {group}) in;
layout(std430, binding = 0) readonly buffer Inputs {{ float inputs[]; }};
layout(std430, binding = 1) buffer Outputs {{ float outputs[]; }};
{declared}
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
"""One triangle over all that is drawn on."""
FRAGMENT = """uniform sampler2D inputs;
{declared}
out vec4 outputs;
{library}
float given(int column)
{{
    return texelFetch(inputs, ivec2(column, int(gl_FragCoord.y)), 0).x;
}}
void main()
{{
    {type} result = {call};
    float each_part[{width}] = float[{width}]({parts});
    int first = 4 * int(gl_FragCoord.x);
    outputs = vec4(each_part[first], each_part[first + 1], each_part[first + 2], each_part[first + 3]);
}}
"""
"""A row of numbers is a row of texels; a fragment writes four floats of one result."""


def combined_samplers(names):
    return "\n".join(f"uniform sampler2D {name};" for name in names)


def compute_text(functions, library, *, version, declared, main, combined):
    """A compute shader with a ``run_skin_...(row)`` for each function, which ``main`` calls."""
    kernels = [
        KERNEL.format(
            name=each.name,
            statements=statements(
                each, GLSL, index_type="uint", result_type=GLSL[each.returns], combined=combined
            ),
        )
        for each in functions
    ]
    return COMPUTE.format(
        version=version,
        group=WORKGROUP,
        declared=declared,
        library=library,
        kernels="\n".join(kernels),
        main=main,
    )


def fragment_text(signature, library, names):
    """A fragment shader without its version, for OpenGL 3.3 and WebGL 2."""
    each = parts(signature)
    each += ["0.0"] * (-len(each) % 4)
    return FRAGMENT.format(
        declared=combined_samplers(names),
        library=library,
        type=GLSL[signature.returns],
        call=call(signature, GLSL, lambda column: f"given({column})", combined=True),
        width=len(each),
        parts=", ".join(each),
    )
