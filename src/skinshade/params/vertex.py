"""Layout of a vertex in the renderer's passes: the only list of its columns.

From this list, code generation writes the structs and the unpacking code of the shaders
(``shading/generated/passes.slang``), and the renderer packs the vertices.
"""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["VERTEX_COLUMNS", "VERTEX_VECTORS", "VertexColumn", "column_slices"]

FLOATS = {"float": 1, "float2": 2, "float3": 3, "float4": 4, "symmetric": 6, "float3x3": 9}
"""Number of floats of each kind of column; ``symmetric`` is a 3×3 matrix stored as xx xy xz yy yz zz."""


@dataclass(frozen=True)
class VertexColumn:
    """One column of the vertex table.

    Attributes
    ----------
    kind
        Kind of the values, a key of `FLOATS`.
    unit
        Unit; ``1`` if the column has none.
    about
        Description in one sentence.
    """

    kind: str
    unit: str
    about: str

    @property
    def width(self) -> int:
        """Number of floats in the column."""
        return FLOATS[self.kind]


VERTEX_COLUMNS = {
    "position": VertexColumn("float3", "mm", "Position."),
    "normal": VertexColumn("float3", "1", "Unit normal."),
    "tangent": VertexColumn("float4", "1", "Unit tangent along +u; sign of the bitangent."),
    "uv": VertexColumn("float2", "1", "Texture coordinates, v down."),
    "curvature": VertexColumn("float", "1/mm", "Mean curvature, positive where convex."),
    "tensor": VertexColumn("symmetric", "1/mm", "Shape operator in world axes."),
    "diffused_normals": VertexColumn("float3x3", "1", "Normals diffused by the profile."),
    "diffused_curvature": VertexColumn("float3", "1/mm", "Mean curvature diffused by the profile."),
    "visibility": VertexColumn(
        "float3", "1", "Diffused irradiance of the sky, over that of its nine harmonics."
    ),
    "through": VertexColumn("float3", "1", "Irradiance over π that arrives through the body."),
    "bounced": VertexColumn(
        "float3", "1", "Diffused irradiance over π from lit parts of the body."
    ),
    "sky_harmonics": VertexColumn(
        "float3x3", "1", "Nine harmonics of the visible part of the sky, weighted by the cosine."
    ),
    "mesh_relief": VertexColumn(
        "float3", "1", "Length that diffused normals keep in folds of the mesh."
    ),
}
"""Columns of a vertex, in the order of the vertex buffer."""
VERTEX_VECTORS = -(-sum(column.width for column in VERTEX_COLUMNS.values()) // 4)
"""Number of vectors of four floats that hold all columns of a vertex."""


def column_slices() -> dict[str, slice]:
    """Return the range of floats of each column within a vertex, by name.

    Examples
    --------
    >>> from skinshade.params.vertex import column_slices
    >>> column_slices()["normal"]
    slice(3, 6, None)
    """
    slices, start = {}, 0
    for name, column in VERTEX_COLUMNS.items():
        slices[name] = slice(start, start + column.width)
        start += column.width
    return slices
