"""The specification's side of every shader function: the same parameters as NumPy takes them."""

from __future__ import annotations

from functools import cache
from importlib import import_module

import numpy as np

from skinshade.codegen.signatures import twin_module
from skinshade.lut import build_curvature_lut, build_shadow_lut
from skinshade.lut.classic import classic_curvature_lut
from skinshade.profile import Profile
from skinshade.scene import Environment
from skinshade.shading.normals import NormalBlend

ONE_FOR_ALL = {
    "filter_width_mm", "map_size", "offset_mm", "radius_mm", "sharpening", "strength", "uv_scale_mm",
}  # fmt: skip
"""Numbers of a material: one for all pixels in the specification."""
LINEAR = {"mag_filter": "linear", "min_filter": "linear"}
AROUND = {**LINEAR, "address_mode_u": "repeat"}
NEAREST: dict[str, str] = {}
TRANSFER_SIZE, WIDEST_K = 2048, 2.0
SKIN = Profile.preset("skin-deon2007")


def twin_of(signature):
    module = import_module(twin_module(signature))
    return getattr(module, signature.twin)


def tables_for(signature):
    """Pairs of what the shader samples and what the twin is given, by name of the table."""
    tables = {}
    for parameter in signature.parameters:
        if parameter.kind == "lut" and parameter.name == "transfer":
            tables["transfer"] = transfer_table()
        elif parameter.name == "preconvolved":
            found = Environment.studio().preconvolved
            tables["preconvolved"] = (found.atlas, None, AROUND), found
        elif parameter.kind == "tex2d":
            depths = np.random.default_rng(7).random((96, 128)).astype(np.float32) * np.float32(
                0.97
            )
            texels = np.repeat(depths[..., None], 3, axis=2)
            tables[parameter.name] = (texels, None, NEAREST), depths.astype(np.float64)
        elif parameter.kind == "lut":
            tables[parameter.name] = lut_of(signature)
    return tables


def lut_of(signature):
    if signature.file == "shadow":
        lut = build_shadow_lut(SKIN, size=(512, 64), width_mm=(4.0, 400.0))
    elif signature.file == "classic":
        lut = classic_curvature_lut(SKIN, size=(512, 64))
    else:
        lut = curvature_table("sphere" if signature.twin == "direct_scalar" else "ring")
    return (lut.values, axes_of(lut), LINEAR), lut


@cache
def curvature_table(kernel):
    return build_curvature_lut(
        SKIN, size=(512, 128), radius_mm=(0.5, 4000.0), kernel=kernel, energy_gain=False
    )


def axes_of(lut):
    (left, right), (top, bottom) = lut.columns.warped_ends, lut.rows.warped_ends
    return left, 1.0 / (right - left), top, 1.0 / (bottom - top)


def transfer_table():
    root = (np.arange(TRANSFER_SIZE) + 0.5) / TRANSFER_SIZE * np.sqrt(WIDEST_K)
    texels = SKIN.transfer(np.square(root))[None].astype(np.float32)
    return (texels, (0.0, 1.0 / np.sqrt(WIDEST_K), 0.0, 1.0), LINEAR), SKIN.kernel.transfer


def expected(signature, values, tables):
    """What the specification gives for a batch, in the shader's form."""
    given = []
    for parameter in signature.parameters:
        name = parameter.name
        if parameter.kind in ("lut", "tex2d"):
            given.append(tables[name][1])
        elif name == "blend":
            given.append(NormalBlend(np.zeros(2), values["blend"]))
        elif name == "tensor_world":
            s = values[name]
            rows, columns = np.triu_indices(3)
            given.append(s[:, rows, columns])
        elif name == "taps":
            given.append(int(values[name][0]))
        elif name == "projection":
            given.append(values[name][0])
        elif name == "radiance_sh_red":
            channels = ("red", "green", "blue")
            each = [values[f"radiance_sh_{channel}"][0].ravel() for channel in channels]
            given.append(np.stack(each, axis=1))
        elif name.startswith("radiance_sh_"):
            continue
        elif name in ONE_FOR_ALL:
            given.append(float(values[name][0]))
        else:
            given.append(values[name])
    found = twin_of(signature)(*given)
    return np.stack(found, axis=-1) if isinstance(found, tuple) else found
