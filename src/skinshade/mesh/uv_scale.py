"""Length that one unit of UV spans on a mesh (MODEL §8)."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from .._core.arrays import as_faces, as_floats, as_positions, dot
from .._core.errors import MeshError
from . import compiled

__all__ = ["mesh_uv_scale"]

NO_EXTENT = "uvs: no triangle spans an area of the texture; unwrap the mesh first"


def mesh_uv_scale(positions: ArrayLike, uvs: ArrayLike, faces: ArrayLike) -> float:
    """Return the length of the UV unit on a mesh: the geometric mean of longest edge over longest UV edge.

    Parameters
    ----------
    positions, uvs, faces
        (V, 3), (V, 2) and (F, 3). Triangles without an extent in space or in UV are ignored.

    Returns
    -------
    float
        Length in the unit of `positions`.

    Raises
    ------
    ArgumentError, MeshError
        If an array is malformed, or no triangle has an extent in both.

    Examples
    --------
    >>> import skinshade as sk
    >>> corners, uvs = [[0, 0, 0], [20, 0, 0], [0, 20, 0]], [[0, 0], [0.5, 0], [0, 0.5]]
    >>> round(sk.mesh_uv_scale(corners, uvs, [[0, 1, 2]]), 6)
    40.0
    """
    p = as_positions("positions", positions)
    t = as_floats("uvs", uvs, (p.shape[0], 2))
    f = as_faces("faces", faces, p.shape[0])
    if compiled.serves(f):
        scale = compiled.uv_log_scale(p, t, f)
        if scale is None:
            raise MeshError(NO_EXTENT)
        return float(np.exp(scale))
    in_space, in_uv = _longest_edge2(p[f]), _longest_edge2(t[f])
    usable = (in_space > 0.0) & (in_uv > 0.0)
    if not usable.any():
        raise MeshError(NO_EXTENT)
    return float(np.exp(0.5 * np.mean(np.log(in_space[usable]) - np.log(in_uv[usable]))))


def _longest_edge2(
    corners: np.ndarray[tuple[int, ...], np.dtype[np.float64]],
) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    step = corners - corners[:, [1, 2, 0]]
    return dot(step, step).max(axis=1, initial=0.0)
