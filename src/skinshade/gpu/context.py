"""Skin in anybody's wgpu renderer: tables, blocks and sampler, bound by the names in the user's shader."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cached_property
from typing import Any, Protocol, Self

import wgpu

from .._core.errors import ShaderError
from ..params import ScatterParams, SkinParams
from ..params.packing import TYPE_NAMES, layout
from .bindings import BindPoint, bind_points
from .luts import HasLuts, LutTextures
from .textures import buffer

__all__ = ["SkinContext"]

BLOCK_NAMES = {"skin_block": "SkinBlock", "scatter_block": "ScatterBlock"}
SAMPLER = "lut_sampler"
SHORT_TYPES = {"vec4f": "vec4<f32>", "vec2f": "vec2<f32>"}


def lut_names() -> tuple[str, ...]:
    """Return the tables that ``ScatterBlock`` has axes for."""
    fields = layout()["ScatterBlock"]["fields"]
    return tuple(name.removesuffix("_axes") for name in fields if name.endswith("_axes"))


class SkinSource(HasLuts, Protocol):
    """What a context is made of: `skinshade.shading.skin.Skin`."""

    @property
    def params(self) -> SkinParams:
        """Numbers of the material."""

    def with_params(self, params: SkinParams) -> Self:
        """Return the same with other parameters, or raise if its tables do not hold for them."""

    def scatter_params(self, fetches: int = ..., luts: Sequence[str] = ...) -> ScatterParams:
        """Return numbers of the profile and of its tables."""


class SkinContext:
    """One material's resources on a device, under the names of the shader library.

    A shader declares what it uses of ``skin_block`` (``SkinBlock``), ``scatter_block``
    (``ScatterBlock``), ``ring_lut``, ``sphere_lut``, ``transfer_lut``, ``shadow_lut``, ``classic_lut``,
    ``classic_shadow_lut`` and ``lut_sampler``, in any group and at any binding.

    Parameters
    ----------
    device
        The renderer's own.
    skin
        Profile and parameters: ``skinshade.Skin.of(profile, params)``.
    fetches
        Of the normal map that the shader makes, 3 or 2.
    """

    def __init__(self, device: wgpu.GPUDevice, skin: SkinSource, *, fetches: int = 3) -> None:
        self.device, self.skin = device, skin
        self._fetches = fetches
        self._luts = LutTextures(device, skin)
        self._checked: dict[str, dict[str, BindPoint]] = {}

    def bind_points(self, wgsl: str) -> dict[str, BindPoint]:
        """Find which of the context's resources a shader wants, and where.

        Parameters
        ----------
        wgsl
            The whole text of the user's shader module.

        Returns
        -------
        dict
            Group, binding and type by name; only the names that this context fills.

        Raises
        ------
        ShaderError
            If a name is declared with another type, a block with other fields than this version's, or
            the shader declares none of them.
        """
        if wgsl not in self._checked:
            declared = bind_points(wgsl)
            ours = {name: point for name, point in declared.items() if name in self._names}
            if not ours:
                names = ", ".join(self._names)
                raise ShaderError(
                    f"the shader declares none of {names}; found {', '.join(declared)}"
                )
            for name, point in ours.items():
                _check(name, point, wgsl)
            self._checked[wgsl] = ours
        return self._checked[wgsl]

    def entries(self, wgsl: str, group: int) -> list[dict[str, Any]]:
        """Return the bind group entries of a shader's group, for ``device.create_bind_group``.

        Raises
        ------
        ShaderError
            As `bind_points`, and if the group holds none of the context's resources.
        """
        points = self.bind_points(wgsl)
        found = {name: point for name, point in points.items() if point.group == group}
        if not found:
            groups = sorted({point.group for point in points.values()})
            raise ShaderError(f"@group({group}) has nothing of skinshade's; groups {groups} have")
        return [
            {"binding": point.binding, "resource": self._resource(name)}
            for name, point in found.items()
        ]

    def write(self, params: SkinParams) -> None:
        """Fill both blocks for the draws that are submitted next.

        Raises
        ------
        ArgumentError
            If a parameter changes that the tables were made for.
        """
        self.skin = self.skin.with_params(params)
        self.device.queue.write_buffer(self.skin_block, 0, params.pack())
        self.device.queue.write_buffer(self.scatter_block, 0, self._scatter().pack())

    def _scatter(self) -> ScatterParams:
        return self.skin.scatter_params(self._fetches, lut_names())

    @cached_property
    def skin_block(self) -> wgpu.GPUBuffer:
        """The material's parameters, a uniform buffer."""
        return buffer(self.device, self.skin.params.pack(), wgpu.BufferUsage.UNIFORM)

    @cached_property
    def scatter_block(self) -> wgpu.GPUBuffer:
        """The profile's numbers, a uniform buffer."""
        return buffer(self.device, self._scatter().pack(), wgpu.BufferUsage.UNIFORM)

    @cached_property
    def lut_sampler(self) -> wgpu.GPUSampler:
        """Linear, clamped."""
        return self.device.create_sampler(mag_filter="linear", min_filter="linear")

    def lut(self, name: str) -> wgpu.GPUTexture:
        """Return a table's texture by its name without ``_lut``."""
        return self._luts[name]

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
    where = f"@group({point.group}) @binding({point.binding}) {name}"
    if name in BLOCK_NAMES:
        if point.space != "uniform":
            raise ShaderError(f"{where}: is var<{point.space}>; declare it var<uniform>")
        _check_fields(where, BLOCK_NAMES[name], point.kind, wgsl)
        return
    wanted = "sampler" if name == SAMPLER else "texture_2d<f32>"
    if point.kind.replace(" ", "") != wanted:
        raise ShaderError(f"{where}: is {point.kind}; declare it {wanted}")


def _check_fields(where: str, block: str, kind: str, wgsl: str) -> None:
    """Raise unless the struct has this version's fields, in its order and types."""
    found = re.search(rf"struct\s+{re.escape(kind)}\s*\{{(.*?)\}}", wgsl, re.DOTALL)
    if found is None:
        raise ShaderError(f"{where}: is {kind}, which is no struct of the shader; paste {block}")
    text = re.sub(r"//[^\n]*", "", found.group(1))
    declared = [
        (name.removesuffix("_0"), SHORT_TYPES.get(of.replace(" ", ""), of.replace(" ", "")))
        for name, of in re.findall(r"(\w+)\s*:\s*([\w<> ]+?)\s*(?:,|;|$)", text)
    ]
    described = layout()[block]["fields"]
    by_offset = sorted(described, key=lambda name: described[name]["offset"])
    wanted = [(name, TYPE_NAMES["wgsl"][described[name]["kind"]]) for name in by_offset]
    for at, (want_name, want_type) in enumerate(wanted):
        name, of = declared[at] if at < len(declared) else ("nothing", "")
        if (name, of) != (want_name, want_type):
            raise ShaderError(
                f"{where}: field {at} of {kind} is {name} {of}".rstrip()
                + f"; this version's {block} has {want_name} : {want_type} there"
            )
    if len(declared) > len(wanted):
        raise ShaderError(
            f"{where}: {kind} has a field {declared[len(wanted)][0]} that {block} does not have"
        )
