"""Example of a pixel shader that calls the library, in every language."""

from __future__ import annotations

from .languages import ShadingLanguage

__all__ = ["example_calls", "example_inputs"]

INPUTS = (
    (
        "float3x3",
        "fetched",
        "rows: normals of the normal map in world axes, sharp and with two blurs",
    ),
    ("float3", "mesh_normal", "unit, interpolated"),
    ("float3", "view", "unit, towards the camera"),
    ("float3", "to_light", "unit, towards the light"),
    ("float3", "light_radiance", "irradiance over π on a surface that faces the light"),
    ("float", "shadow_filter", "share of the wide shadow filter that is lit, 0..1"),
    ("float", "thickness_mm", "thickness of the body towards the light, mm"),
    ("float3x3", "tensor_world", "shape operator in world axes, baked at the vertices, 1/mm"),
    (
        "float3",
        "curvature_per_mm",
        "mean curvature, diffused for each channel or equal in all channels, 1/mm",
    ),
    ("float3", "albedo", "linear"),
    ("float", "gloss_map", "0..1"),
)
"""Type, name and meaning of the inputs of the calls."""

CALLS = (
    (
        "1. Gloss, reduced by the relief that the mips of the normal map average.",
        ("float", "gloss", "skin_gloss_of_relief(gloss_map, length({row0}))"),
    ),
    (
        "2. Normals of the three channels; they must not be normalised.",
        ("float3x3", "normals", "skin_blend_normals(fetched, {weights})"),
    ),
    (
        "3. Energy gain: a convex body re-emits more light than a flat one.",
        (
            "float3",
            "gain",
            "skin_energy_gain(scatter_block.albedo.xyz, scatter_block.rms_radius_mm.xyz,"
            " curvature_per_mm)",
        ),
    ),
    (
        "4. For each light: the curvature along it, and the total curvature.",
        ("float2", "curvatures", "skin_directional_curvature(tensor_world, mesh_normal, to_light)"),
    ),
    (
        "5. Diffuse light.",
        (
            "float3",
            "diffuse",
            "skin_direct_tensor({ring}, {transfer}, normals, to_light, curvatures.x, curvatures.y, gain)",
        ),
    ),
    (
        "6. Shadow of the diffuse light, blurred by scattering.",
        (
            "float3",
            "shadow",
            "skin_diffused_shadow({shadow}, shadow_filter, dot(mesh_normal, to_light),"
            " skin_block.shadow_filter_width_mm)",
        ),
    ),
    (
        "7. Shadow of the specular light, which does not scatter.",
        (
            "float",
            "sharp_shadow",
            "skin_sharpened_shadow(shadow_filter, skin_block.shadow_sharpening)",
        ),
    ),
    (
        "8. Highlight, with the sharp normal, and the share of all light that the coat reflects to the eye.",
        ("float3", "sharp", "normalize({row0})"),
        (
            "float",
            "highlight",
            "skin_coat_highlight(sharp, view, to_light, gloss, skin_block.reflectance)",
        ),
        (
            "float",
            "reflected",
            "skin_coat({coat}, dot(sharp, view), gloss, skin_block.reflectance,"
            " scatter_block.coat_reflectance).x",
        ),
    ),
    (
        "9. Light through thin parts of the body, with the blurred normal.",
        (
            "float3",
            "transmittance",
            "skin_transmittance(thickness_mm, scatter_block.albedo.xyz, scatter_block.sigma_per_mm.xyz)"
            " / scatter_block.albedo.xyz",
        ),
        (
            "float3",
            "through",
            "skin_direct_deep_scatter(transmittance, dot(normalize({row2}), to_light),"
            " skin_block.deep_scatter_strength)",
        ),
        (
            "float3",
            "beyond",
            "skin_through_beyond(through, diffuse * shadow) * skin_block.deep_scatter_tint.xyz",
        ),
    ),
    (
        "10. Share of the light that leaves the body towards the eye, and sum of all terms.",
        (
            "float3",
            "body",
            "albedo * skin_view_factor(albedo, dot(sharp, view), skin_block.reflectance) * (1.0 - reflected)",
        ),
        (
            "float3",
            "radiance",
            "light_radiance * (body * (diffuse * shadow + beyond) + {splat} * (highlight * sharp_shadow))",
        ),
    ),
)


def example_inputs(language: ShadingLanguage) -> list[str]:
    """Return the declarations of the inputs, with comments."""
    if language.suffix == "wgsl":
        return [f"{name} : {language.type_of(kind)}, // {about}" for kind, name, about in INPUTS]
    return [f"{language.type_of(kind)} {name}; // {about}" for kind, name, about in INPUTS]


def example_calls(language: ShadingLanguage) -> list[str]:
    """Return the body of a pixel shader that reads the inputs of `example_inputs`."""
    rows = [f"scatter_block.blend_{channel}.xyz" for channel in ("red", "green", "blue")]
    substitutions = {
        "row0": "fetched[0]",
        "row2": "fetched[2]",
        "weights": f"{language.type_of('float3x3')}({', '.join(rows)})",
        "splat": _splat(language),
        **{name: language.lut(name) for name in ("ring", "transfer", "shadow", "coat")},
    }
    lines = []
    for about, *steps in CALLS:
        lines.append(f"// {about}")
        lines += [
            language.defined(kind, name, text.format_map(substitutions))
            for kind, name, text in steps
        ]
    return lines


def _splat(language: ShadingLanguage) -> str:
    vector = language.type_of("float3")
    return f"{vector}(1.0, 1.0, 1.0)"
