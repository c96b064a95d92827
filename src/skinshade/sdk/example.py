"""The calls of a pixel shader in their order, written in any of the languages."""

from __future__ import annotations

from .languages import ShadingLanguage

__all__ = ["example_calls", "example_inputs"]

INPUTS = (
    ("float3x3", "fetched", "rows: the normal map's normal in world axes, sharp, and at two blurs"),
    ("float3", "mesh_normal", "unit, interpolated"),
    ("float3", "view", "unit, towards the eye"),
    ("float3", "to_light", "unit, towards the light"),
    ("float3", "light_radiance", "irradiance over π of the light on a surface that faces it"),
    ("float", "shadow_filter", "value of the wide shadow filter, 1 in light"),
    ("float", "thickness_mm", "of the body towards the light"),
    ("float3x3", "tensor_world", "shape operator, baked at the vertices, 1/mm"),
    ("float3", "curvature_per_mm", "mean curvature, for each channel if it was diffused"),
    ("float3", "albedo", "linear"),
    ("float", "gloss_map", "0..1"),
)
"""What the shader knows before the calls."""

CALLS = (
    (
        "1. The gloss that fits what the normal map's mip averaged away.",
        ("float", "gloss", "skin_gloss_of_relief(gloss_map, length({row0}))"),
    ),
    (
        "2. The normal that each channel sees; never normalise it.",
        ("float3x3", "normals", "skin_blend_normals(fetched, {weights})"),
    ),
    (
        "3. What curvature gives back of the light that leaves a flat body.",
        (
            "float3",
            "gain",
            "skin_energy_gain(scatter_block.albedo.xyz, scatter_block.rms_radius_mm.xyz,"
            " curvature_per_mm)",
        ),
    ),
    (
        "4. For each light: how the surface bends along it, and in all.",
        ("float2", "bends", "skin_directional_curvature(tensor_world, mesh_normal, to_light)"),
    ),
    (
        "5. Diffuse light.",
        (
            "float3",
            "diffuse",
            "skin_direct_tensor({ring}, {transfer}, normals, to_light, bends.x, bends.y, gain)",
        ),
    ),
    (
        "6. The shadow's edge, which bleeds.",
        (
            "float3",
            "shadow",
            "skin_diffused_shadow({shadow}, shadow_filter, dot(mesh_normal, to_light),"
            " skin_block.shadow_filter_width_mm)",
        ),
    ),
    (
        "7. The same edge where nothing scatters.",
        (
            "float",
            "sharp_shadow",
            "skin_sharpened_shadow(shadow_filter, skin_block.shadow_sharpening)",
        ),
    ),
    (
        "8. Both specular lobes, by the sharp normal.",
        ("float3", "sharp", "normalize({row0})"),
        (
            "float",
            "highlight",
            "skin_specular(sharp, view, to_light, gloss, skin_block.reflectance)",
        ),
    ),
    (
        "9. Light through thin parts, by the blurred normal.",
        (
            "float3",
            "passed",
            "skin_transmittance(thickness_mm, scatter_block.albedo.xyz, scatter_block.sigma_per_mm.xyz)"
            " / scatter_block.albedo.xyz",
        ),
        (
            "float3",
            "through",
            "skin_direct_deep_scatter(passed, dot(normalize({row2}), to_light),"
            " skin_block.deep_scatter_strength) * skin_block.deep_scatter_tint.xyz",
        ),
    ),
    (
        "10. The share that the specular coat lets in; then all together.",
        (
            "float3",
            "body",
            "albedo * skin_diffuse_share(dot(mesh_normal, view), gloss, skin_block.reflectance)",
        ),
        (
            "float3",
            "radiance",
            "light_radiance * (body * (diffuse * shadow + through) + {splat} * (highlight * sharp_shadow))",
        ),
    ),
)


def example_inputs(language: ShadingLanguage) -> list[str]:
    """Return the example's inputs as parameters with a comment each."""
    if language.suffix == "wgsl":
        return [f"{name} : {language.type_of(kind)}, // {about}" for kind, name, about in INPUTS]
    return [f"{language.type_of(kind)} {name}; // {about}" for kind, name, about in INPUTS]


def example_calls(language: ShadingLanguage) -> list[str]:
    """Return the body of a pixel shader, whose inputs have the names of `example_inputs`."""
    rows = [f"scatter_block.blend_{channel}.xyz" for channel in ("red", "green", "blue")]
    words = {
        "row0": "fetched[0]",
        "row2": "fetched[2]",
        "weights": f"{language.type_of('float3x3')}({', '.join(rows)})",
        "splat": _splat(language),
        **{name: language.lut(name) for name in ("ring", "transfer", "shadow")},
    }
    lines = []
    for about, *steps in CALLS:
        lines.append(f"// {about}")
        lines += [
            language.defined(kind, name, text.format_map(words)) for kind, name, text in steps
        ]
    return lines


def _splat(language: ShadingLanguage) -> str:
    vector = language.type_of("float3")
    return f"{vector}(1.0, 1.0, 1.0)"
