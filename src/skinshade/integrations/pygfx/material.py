"""The material: parameters, profile and tables as pygfx's buffers and textures."""

from __future__ import annotations

from typing import Any, Literal, get_args

import numpy as np
import pygfx
from pygfx.utils import array_from_shadertype

from ..._core.errors import ArgumentError, BackendError
from ...params import SkinParams
from ...params.packing import layout
from ...profile import Profile
from ...render.renderer import TAP_COUNTS
from ...scene import Material
from ...shading.skin import Skin
from .maps import color_map, normal_map, table
from .shader import SkinShader, mesh_source

__all__ = ["SkinMaterial"]

Tier = Literal["scalar", "tensor"]
TABLES: dict[Tier, tuple[str, ...]] = {
    "scalar": ("sphere", "shadow"),
    "tensor": ("ring", "transfer", "shadow"),
}
SHADER_TYPES = {"float4": "4xf4", "float2": "2xf4", "float": "f4"}


class SkinMaterial(pygfx.MeshPhongMaterial):  # type: ignore[misc]  # pygfx has no types
    """Skin, or any other translucent matter, lit by pygfx's lights in a world in mm.

    It draws a `pygfx.Mesh` whose geometry `skin_geometry` made. The object may be moved, turned and
    scaled evenly; the mesh must be rigid with ``tier="tensor"``, and no instances are drawn. A `pygfx.
    AmbientLight` is an even sky, an ``ao_map`` dims it, the red of a ``specular_map`` multiplies the
    reflectance. ``shininess``, ``specular``, ``normal_scale`` and ``flat_shading`` have no say. Of point
    lights nothing comes through the body.

    Parameters
    ----------
    profile
        How light diffuses; that of `skinshade.Material` by default.
    params
        Numbers; `skinshade.SkinParams`.
    tier
        Geometry of the diffusion: ``tensor`` (default), or ``scalar``, which is cheaper.
    uv_scale_mm
        Length of the unit of UV on the surface, mm, > 0; the geometry's by default.
    deep_scatter_taps
        Of the thickness: 0 (off), 8 or 32.
    map
        As for pygfx's materials, or linear colours (H, W, 3).
    normal_map
        As for pygfx's materials, or normals (H, W, 3) in −1..1, +y up in the picture. It is looked at
        sharp and at two blurs, which are its mips: they are made, in float32 of what has 8 bits or no
        mips, a copy that later changes of the texture do not reach.
    kwargs
        Of `pygfx.MeshPhongMaterial`. ``color`` is that of pale skin if there is no map.

    Raises
    ------
    ArgumentError
        If a value is not one of those above.
    BackendError
        If this pygfx has another mesh shader than the version that is asked for.
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
        params = params or SkinParams()
        self._skin = Skin.of(Material().profile if profile is None else profile, params)
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
        """The material's numbers; set others for the frames that follow.

        Raises ArgumentError if one changes that tables or mips were made for.
        """
        return self._skin.params

    @params.setter
    def params(self, params: SkinParams) -> None:
        """Write others for the frames that follow, if tables and mips hold for them."""
        changed = self._skin.with_params(params)
        was, wanted = self._skin.params.normal_strength, params.normal_strength
        if self.normal_map is not None and was != wanted:
            raise ArgumentError(
                f"normal_strength: the normal map's mips were made for {was:g}, not {wanted:g}; make a"
                " SkinMaterial of the new parameters"
            )
        self._skin = changed
        self._fill()

    @property
    def skin(self) -> Skin:
        """Profile, already scaled, and parameters that the tables were made for."""
        return self._skin

    @property
    def tier(self) -> Tier:
        """Geometry of the diffusion; each has its own tables, so that it stays."""
        result: Tier = self._store.skin_tier
        return result

    @property
    def uv_scale_mm(self) -> float | None:
        """Length of the unit of UV on the surface, mm; None: the geometry's."""
        result: float | None = self._store.uv_scale_mm
        return result

    @uv_scale_mm.setter
    def uv_scale_mm(self, value: float | None) -> None:
        """Take another, > 0, or the geometry's."""
        if value is not None and not 0.0 < value < np.inf:
            raise ArgumentError(f"uv_scale_mm is {value}; it must be a length above 0 mm, or None")
        self._store.uv_scale_mm = None if value is None else float(value)

    @property
    def deep_scatter_taps(self) -> int:
        """Taps of the thickness: 0, 8 or 32."""
        result: int = self._store.deep_scatter_taps
        return result

    @deep_scatter_taps.setter
    def deep_scatter_taps(self, value: int) -> None:
        """Take another number of them."""
        if value not in TAP_COUNTS:
            raise ArgumentError(f"deep_scatter_taps is {value!r}; it must be 0, 8 or 32")
        self._store.deep_scatter_taps = value

    @property
    def map(self) -> pygfx.TextureMap | None:
        """Colours: pygfx's texture or map; an array (H, W, 3) is made one."""
        return self._store.map

    @map.setter  # noqa: A003
    def map(self, value: Any) -> None:
        """Take another, or None."""
        pygfx.MeshPhongMaterial.map.fset(self, color_map(value))

    @property
    def normal_map(self) -> pygfx.TextureMap | None:
        """Normals: pygfx's texture or map; an array (H, W, 3) is made one at ``normal_strength``."""
        return self._store.normal_map

    @normal_map.setter
    def normal_map(self, value: Any) -> None:
        """Take another, or None."""
        made = normal_map(value, self._skin.params.normal_strength)
        pygfx.MeshPhongMaterial.normal_map.fset(self, made)

    def _fill(self) -> None:
        """Write both blocks: the decay through the body is a parameter, but stands with the profile."""
        scatter = self._skin.scatter_params(luts=TABLES[self._store.skin_tier])
        for buffer, data in (
            (self._store.skin_buffer, self._skin.params.pack()),
            (self._store.scatter_buffer, scatter.pack()),
        ):
            buffer.data[...] = np.frombuffer(data, dtype=buffer.data.dtype)[0]
            buffer.update_full()


pygfx.renderers.wgpu.register_wgpu_render_function(pygfx.Mesh, SkinMaterial)(SkinShader)


def _block(name: str) -> pygfx.Buffer:
    """Return an empty uniform buffer with the fields of a block where its layout has them."""
    fields = layout()[name]["fields"]
    data = array_from_shadertype({n: SHADER_TYPES[f["kind"]] for n, f in fields.items()})
    offsets = {n: data.dtype.fields[n][1] for n in fields}
    if (
        offsets != {n: f["offset"] for n, f in fields.items()}
        or data.nbytes != layout()[name]["size"]
    ):
        raise BackendError(f"pygfx {pygfx.__version__} lays {name} out otherwise: {offsets}")
    return pygfx.Buffer(data, force_contiguous=True)
