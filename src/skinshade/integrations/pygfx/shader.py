"""pygfx's mesh shader with skinshade's sum over lights."""

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

from ..._core.errors import ArgumentError, BackendError
from ..._core.generated import generated_text
from ...shading.ambient import sh_basis
from ...shading.shadow import ATTACHED_MM, DARK_BEYOND, SHADOW_BIAS_MM, SHADOW_TAPS
from ...shading.specular import SHARP_LOBE_SHARE
from .geometry import NUMBERS

__all__ = ["SkinShader", "mesh_source"]

HOOK = "{$ include 'pygfx.light_punctual.wgsl' $}"
NEEDED = (HOOK, "used_uv.items()", "RE_IndirectDiffuse(", "physical_albedo", "face_direction")
"""Text that pygfx's mesh shader must contain: the sum over lights, and names that skinshade uses."""
MOST_UNEVEN = 1e-3
"""Greatest relative difference between the scales of an object along its axes."""
CHANNELS = {100: (0, 1), 101: (1, 3), 102: (4, 3), 103: (7, 3)}
"""First number and count of each attribute, by the index of the texture coordinates that interpolate it."""
UNIFORM_SCALE = "curvature needs a uniform scale; apply the scale to the mesh"

CONSTANTS: dict[str, Any] = {
    "skin_numbers": NUMBERS,
    "skin_channels": CHANNELS,
    # pygfx's maps contain the nearest surface, which needs the bias of
    # `skinshade.shading.shadow.shadow_filter`.
    "skin_bias_mm": SHADOW_BIAS_MM + ATTACHED_MM,
    "skin_dark_beyond": DARK_BEYOND,
    "skin_filter_taps": SHADOW_TAPS[-1],
    "skin_sharp_lobe_share": SHARP_LOBE_SHARE,
    "skin_band_0_basis": float(sh_basis(np.array([0.0, 0.0, 1.0]))[0]),
}


def _source(name: str) -> str:
    if name == "skin.wgsl":
        return generated_text(name)
    return files(__package__).joinpath(name).read_text(encoding="utf-8")


register_wgsl_loader("skinshade", _source)


def mesh_source() -> str:
    """Return pygfx's mesh shader with skinshade's sum over lights instead of its own.

    Raises
    ------
    BackendError
        If the shader of pygfx differs from that of version 0.17.
    """
    text: str = load_wgsl("mesh.wgsl")
    missing = [name for name in NEEDED if name not in text]
    if missing or text.count(HOOK) != 1:
        raise BackendError(
            f"pygfx {pygfx.__version__}: mesh.wgsl contains {HOOK} {text.count(HOOK)} times and lacks"
            f" {missing}; skinshade's material needs pygfx 0.17:"
            ' pip install "skinshade[pygfx]"'
        )
    lights = "{$ include 'skinshade.lights.wgsl' $}"
    return text.replace(HOOK, lights) + "\n{$ include 'skinshade.functions.wgsl' $}\n"


class SkinShader(MeshShader):  # type: ignore[misc]  # pygfx has no types
    """Shader of a mesh with a `SkinMaterial`; pygfx creates it.

    Parameters
    ----------
    wobject
        Mesh with the material.

    Raises
    ------
    ArgumentError
        If the material cannot draw the object.
    """

    def __init__(self, wobject: pygfx.Mesh) -> None:
        super().__init__(wobject)
        _check(wobject)
        material = wobject.material
        self["lighting"] = "skin"
        self["flat_shading"] = False
        self["skin_tier"] = material.tier
        self["skin_taps"] = material.deep_scatter_taps
        self["skin_specular"] = material._store.skin_specular
        self["skin_boundary"] = material._store.skin_boundary
        for name, value in CONSTANTS.items():
            self[name] = value

    def get_bindings(self, wobject: Any, shared: Any, scene: Any) -> dict[int, Any]:
        """Return pygfx's bindings, and group 2 with the material and the attributes.

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
        bindings = [
            Binding("s_skin", "buffer/read_only_storage", attributes, "VERTEX"),
            Binding("u_skin", "buffer/uniform", material._store.skin_buffer, "FRAGMENT"),
            Binding("u_scatter", "buffer/uniform", material._store.scatter_buffer, "FRAGMENT"),
            Binding("s_table", "sampler/filtering", GfxSampler("linear", "clamp"), "FRAGMENT"),
        ]
        for name, texture in material._tables.items():
            view = GfxTextureView(texture)
            bindings.append(Binding(f"t_{name}_table", "texture/auto", view, "FRAGMENT"))
        result[2] = dict(enumerate(bindings))
        self.define_bindings(2, result[2])
        return result

    def get_code(self) -> str:
        """Return the template of the shader."""
        return mesh_source()


def _check(wobject: pygfx.Mesh) -> None:
    """Raise if the material cannot draw an object."""
    name = type(wobject).__name__
    if isinstance(wobject, pygfx.InstancedMesh):
        raise ArgumentError(f"{name}: skin cannot be drawn in instances; use one Mesh per instance")
    deforms = isinstance(wobject, pygfx.SkinnedMesh) or hasattr(wobject.geometry, "morph_positions")
    if deforms and wobject.material.tier == "tensor":
        raise ArgumentError(
            f'{name}: shape operators do not follow a deforming mesh; use SkinMaterial(tier="scalar")'
        )
    if "face" in str(wobject.material.color_mode):
        raise ArgumentError(
            f"color_mode is {wobject.material.color_mode}; skin needs attributes of vertices, not of faces"
        )
    scales = np.linalg.svd(wobject.world.matrix[:3, :3], compute_uv=False)
    if scales.max() > (1.0 + MOST_UNEVEN) * scales.min():
        raise ArgumentError(
            f"{name}: is scaled by {scales.min():.4g} to {scales.max():.4g} along its axes; {UNIFORM_SCALE}"
        )


def _uv_scale_mm(material: Any, geometry: pygfx.Geometry) -> float:
    scale = material.uv_scale_mm
    if scale is None:
        scale = getattr(geometry, "uv_scale_mm", None)
    if scale is None and material.normal_map is not None:
        raise ArgumentError(
            "a normal map is blurred in mm: give uv_scale_mm, or a geometry made with"
            " skinshade.integrations.pygfx.skin_geometry of a mesh with UVs"
        )
    return 1.0 if scale is None else float(scale)
