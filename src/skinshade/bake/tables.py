"""Bodies that came from no glTF file: as GLB, PLY or USD, attributes with the geometry."""

from __future__ import annotations

from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from .._core.errors import ArgumentError, DependencyError
from .._core.files import atomic_write
from .._core.units import GLTF_UNIT_MM
from .._core.version import __version__
from ..mesh.baked import GLTF_NAMES
from .analysis import Analysed, Body
from .gltf import glb_bytes
from .gltf_attributes import AccessorWriter, baked_note
from .settings import BakeSettings

__all__ = ["write_table"]

COLUMNS = {
    "curvature": ("curvature",),
    "tensor": ("tensor_xx", "tensor_xy", "tensor_xz", "tensor_yy", "tensor_yz", "tensor_zz"),
    "thickness": ("thickness",),
}
"""Vertex properties of a PLY, by the analysis's names."""


def write_table(
    output: Path, body: Body, analysed: Analysed, unit_mm: float, settings: BakeSettings
) -> None:
    """Write a body and its attributes by the suffix of the output.

    Raises
    ------
    ArgumentError, OutputError, DependencyError
        If the suffix is none of these, the place cannot be written, or USD is not installed.
    """
    writers: dict[str, Callable[..., bytes]] = {".glb": _glb, ".ply": _ply}
    suffix = output.suffix.lower()
    if suffix in (".usda", ".usdc", ".usd"):
        _write_usd(output, body, analysed, settings)
        return
    if suffix not in writers:
        raise ArgumentError(
            f"{output}: suffix {output.suffix!r}; a baked mesh is .glb, .ply, .usda or .usdc"
        )
    content = writers[suffix](body, analysed, unit_mm, settings)
    with atomic_write(output) as temporary:
        temporary.write_bytes(content)


def _ply(body: Body, analysed: Analysed, unit_mm: float, settings: BakeSettings) -> bytes:
    columns = {name: body.positions_mm[:, i] / unit_mm for i, name in enumerate("xyz")}
    if body.normals is not None:
        columns |= {f"n{name}": body.normals[:, i] for i, name in enumerate("xyz")}
    if body.uvs is not None:
        columns |= {"s": body.uvs[:, 0], "t": 1.0 - body.uvs[:, 1]}  # PLY's v counts from below
    for key, values in analysed.attributes.items():
        columns |= dict(zip(COLUMNS[key], values.T, strict=True))
    vertices = np.stack(list(columns.values()), axis=1).astype("<f4")
    faces = np.zeros(len(body.faces), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    faces["count"], faces["corners"] = 3, body.faces
    header = [
        "ply",
        "format binary_little_endian 1.0",
        f"comment skinshade {__version__}, one unit is {unit_mm!r} mm",
        "comment curvature and tensor in 1/mm, thickness in mm",
        f"element vertex {len(vertices)}",
        *(f"property float {name}" for name in columns),
        f"element face {len(faces)}",
        "property list uchar int vertex_indices",
        "end_header\n",
    ]
    return "\n".join(header).encode() + vertices.tobytes() + faces.tobytes()


def _glb(body: Body, analysed: Analysed, unit_mm: float, settings: BakeSettings) -> bytes:
    document: dict[str, Any] = {}
    accessors = AccessorWriter(document)
    attributes = {"POSITION": accessors.vertices(body.positions_mm / GLTF_UNIT_MM)}
    if body.normals is not None:
        attributes["NORMAL"] = accessors.vertices(body.normals)
    if body.uvs is not None:
        attributes["TEXCOORD_0"] = accessors.vertices(body.uvs)
    for key, values in analysed.attributes.items():
        for name, numbers in GLTF_NAMES[key]:
            attributes[name] = accessors.vertices(values[:, numbers])
    primitive = {"attributes": attributes, "indices": accessors.corners(body.faces)}
    note = baked_note(analysed, GLTF_UNIT_MM, settings)
    document |= {
        "asset": {"version": "2.0", "generator": f"skinshade {__version__}"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [primitive], "extras": {"skinshade": note}}],
        "buffers": [{"byteLength": len(accessors.data)}],
    }
    return glb_bytes(document, bytes(accessors.data))


def _write_usd(output: Path, body: Body, analysed: Analysed, settings: BakeSettings) -> None:
    if find_spec("pxr") is None:
        raise DependencyError('USD is not installed: pip install "skinshade[usd]"')
    from pxr import Gf, Sdf, Usd, UsdGeom, Vt

    with atomic_write(output) as temporary:
        temporary.unlink()  # it refuses to make a file that is there
        stage = Usd.Stage.CreateNew(str(temporary))
        UsdGeom.SetStageMetersPerUnit(stage, 0.001)
        UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.y)
        mesh = UsdGeom.Mesh.Define(stage, "/mesh")
        stage.SetDefaultPrim(mesh.GetPrim())
        mesh.GetPointsAttr().Set(Vt.Vec3fArray.FromNumpy(body.positions_mm.astype(np.float32)))
        mesh.GetFaceVertexCountsAttr().Set(Vt.IntArray(len(body.faces), 3))
        corners = body.faces.ravel().astype(np.int32)
        mesh.GetFaceVertexIndicesAttr().Set(Vt.IntArray.FromNumpy(corners))
        mesh.GetSubdivisionSchemeAttr().Set(UsdGeom.Tokens.none)
        low, high = body.positions_mm.min(axis=0), body.positions_mm.max(axis=0)
        extent = [Gf.Vec3f(*(float(v) for v in each)) for each in (low, high)]
        mesh.GetExtentAttr().Set(Vt.Vec3fArray(extent))
        if body.normals is not None:
            mesh.GetNormalsAttr().Set(Vt.Vec3fArray.FromNumpy(body.normals.astype(np.float32)))
            mesh.SetNormalsInterpolation(UsdGeom.Tokens.vertex)
        primvars = UsdGeom.PrimvarsAPI(mesh)
        types = Sdf.ValueTypeNames
        if body.uvs is not None:
            st = primvars.CreatePrimvar("st", types.TexCoord2fArray, UsdGeom.Tokens.vertex)
            upward = (body.uvs * (1.0, -1.0) + (0.0, 1.0)).astype(
                np.float32
            )  # USD's v counts from below
            st.Set(Vt.Vec2fArray.FromNumpy(upward))
        for key, values in analysed.attributes.items():
            for name, column in zip(COLUMNS[key], values.T, strict=True):
                made = primvars.CreatePrimvar(name, types.FloatArray, UsdGeom.Tokens.vertex)
                made.Set(Vt.FloatArray.FromNumpy(np.ascontiguousarray(column, dtype=np.float32)))
        mesh.GetPrim().SetCustomDataByKey("skinshade:profile", settings.profile)
        mesh.GetPrim().SetCustomDataByKey("skinshade:version", __version__)
        stage.GetRootLayer().Save()
