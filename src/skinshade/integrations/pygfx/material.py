"""Skin material: parameters, profile and tables in pygfx's buffers and textures."""

from __future__ import annotations

from typing import Any, Literal, get_args

import numpy as np
import pygfx
from pygfx.utils import array_from_shadertype

from ..._core.errors import ArgumentError, BackendError
from ...params import SkinParams
from ...params.packing import layout
from ...profile import Profile
from ...rendering.settings import TAP_COUNTS
from ...scene import Material
from ...shading.skin import Skin
from .maps import color_map, normal_map, table
from .shader import SkinShader, mesh_source

__all__ = ["SkinMaterial"]

Tier = Literal["scalar", "tensor"]
TABLES: dict[Tier, tuple[str, ...]] = {
    "scalar": ("sphere", "shadow", "coat"),
    "tensor": ("ring", "transfer", "shadow", "coat"),
}
SHADER_TYPES = {"float4": "4xf4", "float2": "2xf4", "float": "f4"}


class SkinMaterial(pygfx.MeshPhongMaterial):  # type: ignore[misc]  # pygfx has no types
    """Material for skin and other translucent bodies under pygfx's lights, in a world in mm.

    It draws a `pygfx.Mesh` with a geometry of `skin_geometry`. The object can be moved, rotated and
    scaled uniformly. Instances are not supported; with ``tier="tensor"`` the mesh must be rigid. A
    `pygfx.AmbientLight` is a uniform environment, an ``ao_map`` dims it, and the red channel of a
    ``specular_map`` multiplies the reflectance. ``shininess``, ``specular``, ``normal_scale`` and
    ``flat_shading`` have no effect. Point lights have no deep scatter.

    Parameters
    ----------
    profile
        Diffusion profile; the profile of `skinshade.Material` if None.
    params
        Parameters of the material; the defaults of `skinshade.SkinParams` if None.
    tier
        Geometry of the diffusion: ``tensor`` (default), or ``scalar``, which is cheaper.
    uv_scale_mm
        Length of one unit of UV on the surface, mm, > 0; the value of the geometry if None.
    deep_scatter_taps
        Taps that measure the thickness for deep scatter: 0 (off), 8 or 32.
    map
        Colours: a map or texture of pygfx, or an array (H, W, 3), linear.
    normal_map
        Normals: a map or texture of pygfx, or an array (H, W, 3) in −1..1, +y up in the image. The mips
        hold the blurred normals. Textures with 8 bits or without mips are copied to float32; later changes
        of the original have no effect.
    kwargs
        Arguments of `pygfx.MeshPhongMaterial`. Without a map, ``color`` is the colour of pale skin.

    Raises
    ------
    ArgumentError
        If a value is not allowed.
    BackendError
        If the mesh shader of pygfx differs from that of version 0.17.

    Examples
    --------
    >>> from skinshade.integrations.pygfx import SkinMaterial
    >>> SkinMaterial(tier="scalar").deep_scatter_taps
    8
    """

    def __init__(
        self,
        profile: Profile | None = None,
        params: SkinParams | None = None,
        *,
        tier: Tier = "tensor",
        uv_scale_mm: float | None = None,
        deep_scatter_taps: int = 8,
        map: Any = None,  # noqa: A002  # pygfx's name
        normal_map: Any = None,
        **kwargs: Any,
    ) -> None:
        mesh_source()
        if tier not in get_args(Tier):
            raise ArgumentError(f"tier is {tier!r}; it must be {' or '.join(get_args(Tier))}")
        if map is None and "color" not in kwargs:
            kwargs["color"] = pygfx.Color.from_physical(*Material().albedo[0, 0].tolist())
        super().__init__(map=map, **kwargs)
        self._skin = Skin.of(
            Material().profile if profile is None else profile,
            params or SkinParams(),
            luts=TABLES[tier],
        )
        self._store.skin_tier = tier
        self._store.skin_buffer = _block("SkinBlock")
        self._store.scatter_buffer = _block("ScatterBlock")
        self._tables = {name: table(self._skin.lut(name).values) for name in TABLES[tier]}
        self._fill()
        self.uv_scale_mm = uv_scale_mm
        self.deep_scatter_taps = deep_scatter_taps
        self.normal_map = normal_map

    @property
    def params(self) -> SkinParams:
        """Parameters of the material; new parameters apply from the next frame.

        The setter raises ArgumentError if tables or mips depend on a parameter that changes.
        """
        return self._skin.params

    @params.setter
    def params(self, params: SkinParams) -> None:
        """Write both blocks."""
        changed = self._skin.with_params(params)
        old, new = self._skin.params.normal_strength, params.normal_strength
        if self.normal_map is not None and old != new:
            raise ArgumentError(
                f"normal_strength is {new:g}, but the mips of the normal map were computed for {old:g};"
                " create a SkinMaterial with the new parameters"
            )
        self._skin = changed
        self._fill()

    @property
    def skin(self) -> Skin:
        """Profile (already scaled), parameters and tables."""
        return self._skin

    @property
    def tier(self) -> Tier:
        """Geometry of the diffusion; it is read-only, because the tables depend on it."""
        result: Tier = self._store.skin_tier
        return result

    @property
    def uv_scale_mm(self) -> float | None:
        """Length of one unit of UV on the surface, mm, > 0; None for the value of the geometry."""
        result: float | None = self._store.uv_scale_mm
        return result

    @uv_scale_mm.setter
    def uv_scale_mm(self, value: float | None) -> None:
        """Check and store the length."""
        if value is not None and not 0.0 < value < np.inf:
            raise ArgumentError(f"uv_scale_mm is {value}; it must be a length above 0 mm, or None")
        self._store.uv_scale_mm = None if value is None else float(value)

    @property
    def deep_scatter_taps(self) -> int:
        """Taps that measure the thickness: 0, 8 or 32."""
        result: int = self._store.deep_scatter_taps
        return result

    @deep_scatter_taps.setter
    def deep_scatter_taps(self, value: int) -> None:
        """Check and store the number."""
        if value not in TAP_COUNTS:
            raise ArgumentError(f"deep_scatter_taps is {value!r}; it must be 0, 8 or 32")
        self._store.deep_scatter_taps = value

    @property
    def map(self) -> pygfx.TextureMap | None:
        """Colours: a map or texture of pygfx, or an array (H, W, 3), which becomes a map."""
        return self._store.map

    @map.setter  # noqa: A003
    def map(self, value: Any) -> None:
        """Store the colours as a map; None for none."""
        pygfx.MeshPhongMaterial.map.fset(self, color_map(value))

    @property
    def normal_map(self) -> pygfx.TextureMap | None:
        """Normals: a map or texture of pygfx, or an array (H, W, 3), scaled by ``normal_strength``."""
        return self._store.normal_map

    @normal_map.setter
    def normal_map(self, value: Any) -> None:
        """Store the normals as a map with mips; None for none."""
        result = normal_map(value, self._skin.params.normal_strength)
        pygfx.MeshPhongMaterial.normal_map.fset(self, result)

    def _fill(self) -> None:
        """Write both blocks. The decay of deep scatter in the scatter block depends on `params`."""
        scatter = self._skin.scatter_params()
        for buffer, data in (
            (self._store.skin_buffer, self._skin.params.pack()),
            (self._store.scatter_buffer, scatter.pack()),
        ):
            buffer.data[...] = np.frombuffer(data, dtype=buffer.data.dtype)[0]
            buffer.update_full()
        self._store.skin_specular = self._skin.params.specular.value
        self._store.skin_boundary = self._skin.boundary.value


pygfx.renderers.wgpu.register_wgpu_render_function(pygfx.Mesh, SkinMaterial)(SkinShader)


def _block(name: str) -> pygfx.Buffer:
    """Return an empty uniform buffer with the fields of a block at the offsets of its layout."""
    fields = layout()[name]["fields"]
    data = array_from_shadertype({n: SHADER_TYPES[f["kind"]] for n, f in fields.items()})
    offsets = {n: data.dtype.fields[n][1] for n in fields}
    if (
        offsets != {n: f["offset"] for n, f in fields.items()}
        or data.nbytes != layout()[name]["size"]
    ):
        raise BackendError(f"pygfx {pygfx.__version__} has other offsets of {name}: {offsets}")
    return pygfx.Buffer(data, force_contiguous=True)
