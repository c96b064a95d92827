"""Bodies that came from no glTF file: as GLB, PLY or USD, attributes with the geometry."""

from __future__ import annotations

from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from .._core.arrays import FloatArray
from .._core.errors import ArgumentError, DependencyError
from .._core.files import atomic_write
from .._core.version import __version__
from .analysis import Analysed, Body
from .gltf import glb_bytes
from .settings import BakeSettings

__all__ = ["write_table"]

METRE_MM = 1000.0
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
    data = bytearray()
    views: list[dict[str, Any]] = []
    accessors: list[dict[str, Any]] = []

    def added(values: FloatArray | np.ndarray[Any, Any], kind: str, target: int) -> int:
        stored = np.ascontiguousarray(values)
        views.append(
            {"buffer": 0, "byteOffset": len(data), "byteLength": stored.nbytes, "target": target}
        )
        data.extend(stored.tobytes())
        component = 5125 if stored.dtype.kind == "u" else 5126
        bounds = {
            "min": [float(value) for value in stored.min(axis=0)],
            "max": [float(value) for value in stored.max(axis=0)],
        }
        accessors.append(
            {
                "bufferView": len(views) - 1,
                "componentType": component,
                "count": len(stored),
                "type": kind,
                **({} if component == 5125 else bounds),
            }
        )
        return len(accessors) - 1

    def floats(values: FloatArray, kind: str) -> int:
        return added(values.astype("<f4"), kind, 34962)

    attributes = {"POSITION": floats(body.positions_mm / METRE_MM, "VEC3")}
    if body.normals is not None:
        attributes["NORMAL"] = floats(body.normals, "VEC3")
    if body.uvs is not None:
        attributes["TEXCOORD_0"] = floats(body.uvs, "VEC2")
    found = analysed.attributes
    attributes["_CURVATURE"] = floats(found["curvature"], "SCALAR")
    if "tensor" in found:
        attributes["_CURVATURE_TENSOR_0"] = floats(found["tensor"][:, :3], "VEC3")
        attributes["_CURVATURE_TENSOR_1"] = floats(found["tensor"][:, 3:], "VEC3")
    if "thickness" in found:
        attributes["_THICKNESS"] = floats(found["thickness"], "SCALAR")
    told = {
        "version": __version__,
        "unit_mm": METRE_MM,
        "profile": settings.profile,
        "uv_scale_mm": analysed.uv_scale_mm,
    }
    corners = added(body.faces.reshape(-1, 1).astype("<u4"), "SCALAR", 34963)
    document = {
        "asset": {"version": "2.0", "generator": f"skinshade {__version__}"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [
            {
                "primitives": [{"attributes": attributes, "indices": corners}],
                "extras": {"skinshade": told},
            }
        ],
        "buffers": [{"byteLength": len(data)}],
        "bufferViews": views,
        "accessors": accessors,
    }
    return glb_bytes(document, bytes(data))


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
