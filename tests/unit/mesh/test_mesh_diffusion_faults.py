import numpy as np
import pytest

import shapes
from skinshade._core.errors import ArgumentError, MeshError
from skinshade.mesh import diffuse_on_mesh

SMALL = shapes.ellipsoid("random", 150, (3.0, 2.0, 1.0))


@pytest.mark.parametrize(
    ("positions", "faces", "values", "kind", "complaint"),
    [
        (
            SMALL.positions * np.nan,
            SMALL.faces,
            np.zeros(150),
            ArgumentError,
            r"positions_mm\[0, 0\]",
        ),
        (SMALL.positions, SMALL.faces + 1, np.zeros(150), ArgumentError, r"faces\[.*\] is 150"),
        (SMALL.positions, SMALL.faces, np.full(150, np.inf), ArgumentError, r"values\[0\] is inf"),
        (SMALL.positions, SMALL.faces, np.zeros(149), MeshError, r"values: shape is \(149,\)"),
        (SMALL.positions, SMALL.faces, 1.0, MeshError, r"values: shape is \(\)"),
        (
            SMALL.positions,
            np.zeros((0, 3), int),
            np.zeros(150),
            MeshError,
            "have no area|no faces|none",
        ),
        (np.zeros((3, 3)), [[0, 1, 2]], np.zeros(3), MeshError, "no area"),
    ],
)
def test_a_malformed_mesh_is_refused(positions, faces, values, kind, complaint, deon):
    with pytest.raises(kind, match=complaint):
        diffuse_on_mesh(positions, faces, values, deon)


def test_a_mesh_without_vertices_is_refused(deon):
    with pytest.raises((ArgumentError, MeshError)):
        diffuse_on_mesh(np.zeros((0, 3)), np.zeros((0, 3), int), np.zeros(0), deon)


def test_a_vertex_that_no_face_uses_is_named(deon):
    positions = np.vstack([SMALL.positions, [[9.0, 8.0, 7.0]]])
    with pytest.raises(MeshError, match=r"vertex \d+ at \[9\. 8\. 7\.\]"):
        diffuse_on_mesh(positions, SMALL.faces, np.zeros(151), deon)


@pytest.mark.parametrize("tolerance", [0.0, 1e-13, 0.2, np.nan])
def test_a_tolerance_out_of_range_is_refused(deon, tolerance):
    with pytest.raises(ArgumentError, match="tolerance is"):
        diffuse_on_mesh(SMALL.positions, SMALL.faces, np.zeros(150), deon, tolerance=tolerance)
