"""pygfx's mesh shader, with the loop over its lights replaced by skinshade's terms."""

from __future__ import annotations

from importlib.resources import files
from typing import Any

import numpy as np
import pygfx
from pygfx.renderers.wgpu import (
    Binding,
    GfxSampler,
    GfxTextureView,
    load_wgsl,
    register_wgsl_loader,
)
from pygfx.renderers.wgpu.shaders.meshshader import MeshShader

from ..._core.arrays import FloatArray
from ..._core.errors import ArgumentError, BackendError
from ...render.cpu.renderer import DARK_BEYOND
from ...render.cpu.shadow_map import (
    ATTACHED_MM,
    BIAS_MM,
    FILTER_TAPS,
    HOLLOW_PER_MM,
    STEEPEST_SLOPE,
    TERMINATOR_REACH_MM,
    hemisphere_disk,
)
from ...shaders import generated_text
from ...shading.ambient import sh_basis
from .geometry import NUMBERS

__all__ = ["SkinShader", "mesh_source"]

HOOK = "{$ include 'pygfx.light_punctual.wgsl' $}"
NEEDED = (HOOK, "used_uv.items()", "RE_IndirectDiffuse(", "physical_albedo", "face_direction")
"""What pygfx's mesh shader must have: where lights are summed, what goes on to fragments, what is used."""
MOST_UNEVEN = 1e-3
CHANNELS = {100: (0, 1), 101: (1, 3), 102: (4, 3), 103: (7, 3)}
"""Attributes travel as further texture coordinates, which pygfx hands on: first number, how many."""
EVEN_SCALE = "curvature holds for no other; apply the scale to the mesh"


def _disk(points: FloatArray) -> str:
    return ", ".join(f"vec2<f32>({float(x)!r}, {float(y)!r})" for x, y in points)


CONSTANTS: dict[str, Any] = {
    "skin_numbers": NUMBERS,
    "skin_channels": CHANNELS,
    # A map of the nearest surface, as `ShadowMap.occluders` has where nothing faces away before.
    "skin_bias_mm": BIAS_MM + ATTACHED_MM,
    "skin_dark_beyond": DARK_BEYOND,
    "skin_filter_taps": FILTER_TAPS,
    "skin_filter_disk": _disk(hemisphere_disk(FILTER_TAPS)),
    "skin_hollow_per_mm": HOLLOW_PER_MM,
    "skin_steepest_slope": STEEPEST_SLOPE,
    "skin_terminator_reach_mm": TERMINATOR_REACH_MM,
    "skin_even_basis": float(sh_basis(np.array([0.0, 0.0, 1.0]))[0]),
}


def _source(name: str) -> str:
    if name == "skin.wgsl":
        return generated_text(name)
    return files(__package__).joinpath(name).read_text(encoding="utf-8")


register_wgsl_loader("skinshade", _source)


def mesh_source() -> str:
    """Return pygfx's mesh shader with skinshade's sum over lights in place of its own.

    Raises
    ------
    BackendError
        If it is not the shader that this was written for.
    """
    text: str = load_wgsl("mesh.wgsl")
    missing = [each for each in NEEDED if each not in text]
    if missing or text.count(HOOK) != 1:
        raise BackendError(
            f"pygfx {pygfx.__version__}: its mesh.wgsl has {text.count(HOOK)} times {HOOK} and lacks"
            f" {missing}; skinshade's material is written for pygfx 0.17:"
            ' pip install "skinshade[pygfx]"'
        )
    lights = "{$ include 'skinshade.lights.wgsl' $}"
    return text.replace(HOOK, lights) + "\n{$ include 'skinshade.functions.wgsl' $}\n"


class SkinShader(MeshShader):  # type: ignore[misc]  # pygfx has no types
    """Draws a mesh with a `SkinMaterial`; pygfx makes it.

    Parameters
    ----------
    wobject
        The mesh.

    Raises
    ------
    ArgumentError
        If the object is none that skin can be drawn on.
    """

    def __init__(self, wobject: pygfx.Mesh) -> None:
        super().__init__(wobject)
        _check(wobject)
        material = wobject.material
        self["lighting"] = "skin"
        self["flat_shading"] = False
        self["skin_tier"] = material.tier
        self["skin_taps"] = material.deep_scatter_taps
        for name, value in CONSTANTS.items():
            self[name] = value

    def get_bindings(self, wobject: Any, shared: Any, scene: Any) -> dict[int, Any]:
        """Return pygfx's own bindings, and in a group of their own the material's and the attributes.

        Raises
        ------
        ArgumentError
            If the geometry lacks an attribute.
        """
        result: dict[int, Any] = super().get_bindings(wobject, shared, scene)
        material, geometry = wobject.material, wobject.geometry
        self["skin_uv_scale_mm"] = _uv_scale_mm(material, geometry)
        attributes = getattr(geometry, "skin_attributes", None)
        if attributes is None or attributes.nitems != NUMBERS * geometry.positions.nitems:
            raise ArgumentError(
                "the geometry has no curvature at its vertices; make it with"
                " skinshade.integrations.pygfx.skin_geometry(mesh, profile)"
            )
        for channel, (_, count) in CHANNELS.items():
            if channel < 102 or material.tier == "tensor":
                self["used_uv"][channel] = count
        found = [
            Binding("s_skin", "buffer/read_only_storage", attributes, "VERTEX"),
            Binding("u_skin", "buffer/uniform", material._store.skin_buffer, "FRAGMENT"),
            Binding("u_scatter", "buffer/uniform", material._store.scatter_buffer, "FRAGMENT"),
            Binding("s_table", "sampler/filtering", GfxSampler("linear", "clamp"), "FRAGMENT"),
        ]
        for name, texture in material._tables.items():
            view = GfxTextureView(texture)
            found.append(Binding(f"t_{name}_table", "texture/auto", view, "FRAGMENT"))
        result[2] = dict(enumerate(found))
        self.define_bindings(2, result[2])
        return result

    def get_code(self) -> str:
        """Return the shader before pygfx fills it in."""
        return mesh_source()


def _check(wobject: pygfx.Mesh) -> None:
    name = type(wobject).__name__
    if isinstance(wobject, pygfx.InstancedMesh):
        raise ArgumentError(f"{name}: skin is not drawn in instances; use a Mesh for each")
    bends = isinstance(wobject, pygfx.SkinnedMesh) or hasattr(wobject.geometry, "morph_positions")
    if bends and wobject.material.tier == "tensor":
        raise ArgumentError(
            f'{name}: a mesh that bends turns its tensors; use SkinMaterial(tier="scalar")'
        )
    if "face" in str(wobject.material.color_mode):
        raise ArgumentError(
            f"color_mode is {wobject.material.color_mode}; skin has attributes at vertices, not faces"
        )
    scales = np.linalg.svd(wobject.world.matrix[:3, :3], compute_uv=False)
    if scales.max() > (1.0 + MOST_UNEVEN) * scales.min():
        raise ArgumentError(
            f"{name}: is scaled by {scales.min():.4g} to {scales.max():.4g} along its axes; {EVEN_SCALE}"
        )


def _uv_scale_mm(material: Any, geometry: pygfx.Geometry) -> float:
    given = material.uv_scale_mm
    found = getattr(geometry, "uv_scale_mm", None) if given is None else given
    if found is None and material.normal_map is not None:
        raise ArgumentError(
            "a normal map is blurred in mm: give uv_scale_mm, or a geometry made with"
            " skinshade.integrations.pygfx.skin_geometry of a mesh with UVs"
        )
    return float(found or 1.0)
