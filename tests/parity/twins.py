"""Calls of the twins: parameters of shader functions in the form that NumPy takes."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from importlib import import_module

import numpy as np

from codegen.signatures import twin_module
from skinshade.lut import build_coat_lut, build_shadow_lut
from skinshade.lut.classic import classic_curvature_lut
from skinshade.profile import Profile
from skinshade.scene import Environment
from skinshade.shading.eye_tables import build_eye_lut
from skinshade.shading.normals import NormalBlend
from skinshade.shading.tables import build_curvature_lut

ONE_FOR_ALL = {
    "bias_mm", "coat_reflectance", "filter_width_mm", "map_size", "offset_mm", "radius_mm",
    "sharpening", "strength", "uv_scale_mm",
}  # fmt: skip
"""Numbers that all pixels of a batch share in the specification."""
SHARED_VECTORS = {"light_right", "light_up"}
"""Vectors that all pixels of a batch share."""
LINEAR = {"mag_filter": "linear", "min_filter": "linear"}
AROUND = {**LINEAR, "address_mode_u": "repeat"}
NEAREST: dict[str, str] = {}
TRANSFER_SIZE, WIDEST_K = 2048, 2.0
SKIN = Profile.preset("skin-deon2007")


def twin_of(signature):
    module = import_module(twin_module(signature))
    return getattr(module, signature.twin)


def tables_for(signature):
    """Return the texture of the shader and the argument of the twin, by name of the table."""
    tables = {}
    for parameter in signature.parameters:
        if parameter.kind == "lut" and parameter.name == "transfer":
            tables["transfer"] = transfer_table()
        elif parameter.name == "preconvolved":
            preconvolved = Environment.studio().preconvolved()
            tables["preconvolved"] = (preconvolved.atlas, None, AROUND), preconvolved
        elif parameter.kind == "tex2d":
            depths = depth_map(signature)
            texels = np.repeat(depths[..., None], 3, axis=2)
            tables[parameter.name] = (texels, None, NEAREST), depths.astype(np.float64)
        elif parameter.kind == "lut":
            tables[parameter.name] = lut_of(signature)
    return tables


def depth_map(signature):
    """Return depths (96, 128) as a projection stores them.

    Thickness is continuous in the depths. The shadow filters compare them: they get two depths that no
    receiver of the batch is near, because a rounding decides comparisons of equal depths.
    """
    values = np.random.default_rng(7).random((96, 128)).astype(np.float32)
    if signature.name in ("skin_shadow_filter", "skin_contact_filter"):
        return np.rint(values)
    return values * np.float32(0.97)


def eye_table(name):
    """Return a table with the axes of those of an eye and smooth values."""
    own = getattr(build_eye_lut(), name)
    height, width, _ = own.values.shape
    v, u = np.mgrid[:height, :width]
    waves = [np.sin(0.2 * u + 0.3 * (v % 16) + phase) for phase in range(3)]
    return replace(own, values=np.stack(waves, axis=-1).astype(np.float32))


def lut_of(signature):
    if signature.file == "eye_light":
        lut = eye_table("lamp" if signature.twin == "eye_light" else "surroundings")
    elif signature.file in ("shadow", "contact"):
        lut = build_shadow_lut(SKIN, size=(512, 64), width_mm=(4.0, 400.0))
    elif signature.file == "coat":
        lut = build_coat_lut()
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
    """Return the results of the specification for a batch, in the shader's form."""
    arguments = []
    for parameter in signature.parameters:
        name = parameter.name
        if parameter.kind in ("lut", "tex2d"):
            arguments.append(tables[name][1])
        elif name == "blend":
            arguments.append(NormalBlend(np.zeros(2), values["blend"]))
        elif name == "tensor_world":
            s = values[name]
            rows, columns = np.triu_indices(3)
            arguments.append(s[:, rows, columns])
        elif name == "taps":
            arguments.append(int(values[name][0]))
        elif parameter.kind == "float4x4" or name in SHARED_VECTORS:
            arguments.append(values[name][0])
        elif name == "radiance_sh_red":
            channels = ("red", "green", "blue")
            columns = [values[f"radiance_sh_{channel}"][0].ravel() for channel in channels]
            arguments.append(np.stack(columns, axis=1))
        elif name == "ambient_transfer_red":
            channels = ("red", "green", "blue")
            rows = [values[f"ambient_transfer_{channel}"].reshape(-1, 9) for channel in channels]
            arguments.append(np.stack(rows, axis=1))
        elif name.startswith(("radiance_sh_", "ambient_transfer_")):
            continue
        elif name == "sky_harmonics":
            arguments.append(values[name].reshape(-1, 9))
        elif name in ONE_FOR_ALL:
            arguments.append(float(values[name][0]))
        else:
            arguments.append(values[name])
    result = twin_of(signature)(*arguments)
    return np.stack(result, axis=-1) if isinstance(result, tuple) else result
