"""Resources of a skin in a user's wgpu renderer, bound by their names in the shader."""

from __future__ import annotations

import re
from functools import cached_property
from typing import Any, Protocol, Self

from .._core.errors import ShaderError
from ..params import ScatterParams, SkinParams
from ..params.packing import TYPE_NAMES, layout
from .bindings import BindPoint, bind_points
from .device import BufferUsage, GPUBuffer, GPUDevice, GPUSampler, GPUTexture
from .luts import LutSource, LutTextures
from .textures import buffer

__all__ = ["SkinContext"]

BLOCK_NAMES = {"skin_block": "SkinBlock", "scatter_block": "ScatterBlock"}
SAMPLER = "lut_sampler"
SHORT_TYPES = {"vec4f": "vec4<f32>", "vec2f": "vec2<f32>"}


def lut_names() -> tuple[str, ...]:
    """Return the names of the tables whose axes ``ScatterBlock`` contains."""
    fields = layout()["ScatterBlock"]["fields"]
    return tuple(name.removesuffix("_axes") for name in fields if name.endswith("_axes"))


class SkinSource(LutSource, Protocol):
    """Material of a context: `skinshade.Skin`."""

    @property
    def params(self) -> SkinParams:
        """Parameters of the material."""

    def with_params(self, params: SkinParams) -> Self:
        """Return the skin with new `params`; raise if they need other tables."""

    def scatter_params(self, fetches: int = ...) -> ScatterParams:
        """Return the profile's numbers and the axes of its tables."""


class SkinContext:
    """Resources of a material on a device, under the names of the shader library.

    The names are ``skin_block`` (``SkinBlock``), ``scatter_block`` (``ScatterBlock``), ``ring_lut``,
    ``sphere_lut``, ``transfer_lut``, ``shadow_lut``, ``coat_lut``, ``classic_lut``, ``classic_shadow_lut``
    and ``lut_sampler``. A shader declares the resources that it uses, in any group and at any binding.

    Parameters
    ----------
    device
        Device of the renderer.
    skin
        Material: ``skinshade.Skin.of(profile, params)``, with the tables that the shader declares.
    fetches
        Fetches of the normal map in the shader, 3 or 2.

    Examples
    --------
    >>> import skinshade as sk
    >>> from skinshade.gpu.device import open_device
    >>> skin = sk.Skin.of(sk.Profile.preset("skin-deon2007"), sk.SkinParams())
    >>> context = sk.gpu.SkinContext(open_device(), skin)
    >>> wgsl = "@group(1) @binding(0) var ring_lut : texture_2d<f32>;"
    >>> [entry["binding"] for entry in context.entries(wgsl, group=1)]
    [0]
    """

    def __init__(self, device: GPUDevice, skin: SkinSource, *, fetches: int = 3) -> None:
        self.device, self.skin = device, skin
        self._fetches = fetches
        self._luts = LutTextures(device)
        self._checked: dict[str, dict[str, BindPoint]] = {}

    def bind_points(self, wgsl: str) -> dict[str, BindPoint]:
        """Return the bind points of the context's resources in a shader.

        Parameters
        ----------
        wgsl
            Whole text of the user's shader module.

        Returns
        -------
        dict
            Bind points by name, for the resources that this context provides.

        Raises
        ------
        ShaderError
            If a resource is declared with a wrong type, the fields of a block differ from this version,
            or the shader declares none of the resources.
        """
        if wgsl not in self._checked:
            declared = bind_points(wgsl)
            points = {name: point for name, point in declared.items() if name in self._names}
            if not points:
                names = ", ".join(self._names)
                raise ShaderError(
                    f"the shader declares none of {names}; it declares {', '.join(declared)}"
                )
            for name, point in points.items():
                _check(name, point, wgsl)
            self._checked[wgsl] = points
        return self._checked[wgsl]

    def entries(self, wgsl: str, group: int) -> list[dict[str, Any]]:
        """Return the entries of a shader's bind group, for ``device.create_bind_group``.

        Parameters
        ----------
        wgsl
            Whole text of the user's shader module.
        group
            Number of the bind group.

        Raises
        ------
        ShaderError
            If `bind_points` raises, or the group declares none of the context's resources.
        """
        points = self.bind_points(wgsl)
        in_group = {name: point for name, point in points.items() if point.group == group}
        if not in_group:
            groups = sorted({point.group for point in points.values()})
            raise ShaderError(
                f"@group({group}) declares no resource of skinshade; groups {groups} do"
            )
        return [
            {"binding": point.binding, "resource": self._resource(name)}
            for name, point in in_group.items()
        ]

    def write(self, params: SkinParams) -> None:
        """Write both blocks; draws that are submitted later read the new values.

        Parameters
        ----------
        params
            New parameters of the material.

        Raises
        ------
        ArgumentError
            If the tables depend on a parameter that changes.
        """
        self.skin = self.skin.with_params(params)
        self.device.queue.write_buffer(self.skin_block, 0, params.pack())
        self.device.queue.write_buffer(self.scatter_block, 0, self._scatter().pack())

    def _scatter(self) -> ScatterParams:
        return self.skin.scatter_params(self._fetches)

    @cached_property
    def skin_block(self) -> GPUBuffer:
        """Uniform buffer of the material's parameters."""
        return buffer(self.device, self.skin.params.pack(), BufferUsage.UNIFORM)

    @cached_property
    def scatter_block(self) -> GPUBuffer:
        """Uniform buffer of the profile's numbers."""
        return buffer(self.device, self._scatter().pack(), BufferUsage.UNIFORM)

    @cached_property
    def lut_sampler(self) -> GPUSampler:
        """Linear sampler, clamped at the edges."""
        return self.device.create_sampler(mag_filter="linear", min_filter="linear")

    def lut(self, name: str) -> GPUTexture:
        """Return the texture of a table by its `name` without ``_lut``."""
        return self._luts.texture(name, self.skin)

    @cached_property
    def _names(self) -> tuple[str, ...]:
        return (*BLOCK_NAMES, *(f"{name}_lut" for name in lut_names()), SAMPLER)

    def _resource(self, name: str) -> Any:
        if name in BLOCK_NAMES:
            return {"buffer": getattr(self, name)}
        if name == SAMPLER:
            return self.lut_sampler
        return self.lut(name.removesuffix("_lut")).create_view()


def _check(name: str, point: BindPoint, wgsl: str) -> None:
    """Raise unless a bind point has the type of the resource with its name."""
    location = f"@group({point.group}) @binding({point.binding}) {name}"
    if name in BLOCK_NAMES:
        if point.space != "uniform":
            raise ShaderError(f"{location}: is var<{point.space}>; declare it var<uniform>")
        _check_fields(location, BLOCK_NAMES[name], point.kind, wgsl)
        return
    expected = "sampler" if name == SAMPLER else "texture_2d<f32>"
    if point.kind.replace(" ", "") != expected:
        raise ShaderError(f"{location}: is {point.kind}; declare it {expected}")


def _check_fields(location: str, block: str, kind: str, wgsl: str) -> None:
    """Raise unless the struct has the fields of this version, in order and type."""
    struct = re.search(rf"struct\s+{re.escape(kind)}\s*\{{(.*?)\}}", wgsl, re.DOTALL)
    if struct is None:
        raise ShaderError(f"{location}: is {kind}, which the shader does not define; paste {block}")
    text = re.sub(r"//[^\n]*", "", struct.group(1))
    declared = [
        (
            name.removesuffix("_0"),
            SHORT_TYPES.get(type_name.replace(" ", ""), type_name.replace(" ", "")),
        )
        for name, type_name in re.findall(r"(\w+)\s*:\s*([\w<> ]+?)\s*(?:,|;|$)", text)
    ]
    fields = layout()[block]["fields"]
    by_offset = sorted(fields, key=lambda name: fields[name]["offset"])
    expected = [(name, TYPE_NAMES["wgsl"][fields[name]["kind"]]) for name in by_offset]
    for index, (expected_name, expected_type) in enumerate(expected):
        name, type_name = declared[index] if index < len(declared) else ("nothing", "")
        if (name, type_name) != (expected_name, expected_type):
            raise ShaderError(
                f"{location}: field {index} of {kind} is {name} {type_name}".rstrip()
                + f"; this version's {block} has {expected_name} : {expected_type} there"
            )
    if len(declared) > len(expected):
        raise ShaderError(
            f"{location}: {kind} has a field {declared[len(expected)][0]} that {block} does not have"
        )
