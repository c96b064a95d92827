"""Files of a mesh with its attributes: GLB, PLY or USD."""

from __future__ import annotations

from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from .._core.errors import ArgumentError, DependencyError, OutputError
from .._core.files import FileSet, atomic_write
from .._core.units import GLTF_UNIT_MM
from .._core.version import __version__
from ..gltf.write import AccessorWriter, glb_bytes
from ..mesh import Mesh
from ..mesh.baked import COLUMNS, GLTF_NAMES, UNIT_COMMENT
from .analysis import Analysis
from .gltf import bake_note
from .settings import BakeSettings

__all__ = ["write_mesh"]


def write_mesh(
    files: FileSet, output: Path, mesh: Mesh, analysis: Analysis, settings: BakeSettings
) -> None:
    """Add a file to a set: a mesh and its attributes, in the format of the output's suffix.

    Raises
    ------
    ArgumentError, OutputError, DependencyError
        If the suffix is unknown, the file cannot be written, or USD is not installed.
    """
    writers: dict[str, Callable[[Mesh, Analysis, BakeSettings], bytes]] = {
        ".glb": _glb,
        ".ply": _ply,
    }
    suffix = output.suffix.lower()
    if suffix in (".usda", ".usdc", ".usd"):
        _write_usd(files, output, mesh, analysis, settings)
        return
    if suffix not in writers:
        raise ArgumentError(
            f"{output}: suffix {output.suffix!r}; a baked mesh is .glb, .ply, .usda or .usdc"
        )
    files.add_bytes(output, writers[suffix](mesh, analysis, settings))


def _ply(mesh: Mesh, analysis: Analysis, settings: BakeSettings) -> bytes:
    columns = {name: mesh.positions[:, i] for i, name in enumerate("xyz")}
    columns |= {f"n{name}": mesh.normals[:, i] for i, name in enumerate("xyz")}
    if mesh.uvs is not None:
        columns |= {"s": mesh.uvs[:, 0], "t": 1.0 - mesh.uvs[:, 1]}  # v of PLY increases upwards
    for key, values in analysis.attributes.items():
        columns |= dict(zip(COLUMNS[key], values.T, strict=True))
    vertices = np.stack(list(columns.values()), axis=1).astype("<f4")
    faces = np.zeros(len(mesh.faces), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    faces["count"], faces["corners"] = 3, mesh.faces
    header = [
        "ply",
        "format binary_little_endian 1.0",
        f"comment skinshade {__version__}, one unit is {mesh.unit_mm!r} mm",
        "comment curvature and tensor in 1/mm, thickness in mm, y is up",
        f"comment {UNIT_COMMENT} {float(mesh.unit_mm)!r}",  # as `load_mesh` reads it
        f"element vertex {len(vertices)}",
        *(f"property float {name}" for name in columns),
        f"element face {len(faces)}",
        "property list uchar int vertex_indices",
        "end_header\n",
    ]
    return "\n".join(header).encode() + vertices.tobytes() + faces.tobytes()


def _glb(mesh: Mesh, analysis: Analysis, settings: BakeSettings) -> bytes:
    document: dict[str, Any] = {}
    accessors = AccessorWriter(document)
    attributes = {
        "POSITION": accessors.add_vertices(mesh.positions_mm / GLTF_UNIT_MM),
        "NORMAL": accessors.add_vertices(mesh.normals),
    }
    if mesh.uvs is not None:
        attributes["TEXCOORD_0"] = accessors.add_vertices(mesh.uvs)
    for key, values in analysis.attributes.items():
        for name, numbers in GLTF_NAMES[key]:
            attributes[name] = accessors.add_vertices(values[:, numbers])
    primitive = {"attributes": attributes, "indices": accessors.add_corners(mesh.faces)}
    note = bake_note(analysis, GLTF_UNIT_MM, settings)
    document |= {
        "asset": {"version": "2.0", "generator": f"skinshade {__version__}"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [primitive], "extras": {"skinshade": note}}],
        "buffers": [{"byteLength": len(accessors.data)}],
    }
    return glb_bytes(document, bytes(accessors.data))


def _write_usd(
    files: FileSet, output: Path, mesh: Mesh, analysis: Analysis, settings: BakeSettings
) -> None:
    if find_spec("pxr") is None:
        raise DependencyError('USD is not installed: pip install "skinshade[usd]"')
    from pxr import Gf, Sdf, Tf, Usd, UsdGeom, Vt

    with atomic_write(output, files) as temporary:
        temporary.unlink()  # USD refuses to create a file that exists
        stage = Usd.Stage.CreateNew(str(temporary))
        UsdGeom.SetStageMetersPerUnit(stage, 0.001)
        UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.y)
        prim = UsdGeom.Mesh.Define(stage, "/mesh")
        stage.SetDefaultPrim(prim.GetPrim())
        points = mesh.positions_mm.astype(np.float32)
        prim.GetPointsAttr().Set(Vt.Vec3fArray.FromNumpy(points))
        prim.GetFaceVertexCountsAttr().Set(Vt.IntArray(len(mesh.faces), 3))
        corners = mesh.faces.ravel().astype(np.int32)
        prim.GetFaceVertexIndicesAttr().Set(Vt.IntArray.FromNumpy(corners))
        prim.GetSubdivisionSchemeAttr().Set(UsdGeom.Tokens.none)
        extent = [Gf.Vec3f(*map(float, end)) for end in (points.min(axis=0), points.max(axis=0))]
        prim.GetExtentAttr().Set(Vt.Vec3fArray(extent))
        prim.GetNormalsAttr().Set(Vt.Vec3fArray.FromNumpy(mesh.normals.astype(np.float32)))
        prim.SetNormalsInterpolation(UsdGeom.Tokens.vertex)
        primvars = UsdGeom.PrimvarsAPI(prim)
        types = Sdf.ValueTypeNames
        if mesh.uvs is not None:
            st = primvars.CreatePrimvar("st", types.TexCoord2fArray, UsdGeom.Tokens.vertex)
            v_up = mesh.uvs * (1.0, -1.0) + (0.0, 1.0)  # v of USD increases upwards
            st.Set(Vt.Vec2fArray.FromNumpy(v_up.astype(np.float32)))
        for key, values in analysis.attributes.items():
            for name, column in zip(COLUMNS[key], values.T, strict=True):
                primvar = primvars.CreatePrimvar(name, types.FloatArray, UsdGeom.Tokens.vertex)
                column = np.ascontiguousarray(column, dtype=np.float32)
                primvar.Set(Vt.FloatArray.FromNumpy(column))
        prim.GetPrim().SetCustomDataByKey("skinshade:profile", settings.profile)
        prim.GetPrim().SetCustomDataByKey("skinshade:version", __version__)
        try:
            written = stage.GetRootLayer().Save()
        except Tf.ErrorException:  # its text repeats one line for every block of the file
            written = False
        if not written:
            raise OutputError(f"{output}: USD cannot write it; is the disk full?")
