"""Rigs and z-up models as exporters write them: size, unit and curvature are those of the scene."""

import numpy as np
import pytest

import gltf_shapes
import shapes
from gltf_validator import validator_messages
from skinshade.baking import BakeSettings, bake
from skinshade.mesh import Mesh, load_mesh, vertex_attributes
from skinshade.mesh.curvature import mesh_curvature
from tolerances import CURVATURE_OF_ROUNDED, FLOAT32_FILE

AXES_M = (0.03, 0.05, 0.12)
"""Half axes of the body in the axes of its mesh; z is up."""
HALF_TURN = 0.7071068
QUARTER_BACK = [-HALF_TURN, 0.0, 0.0, HALF_TURN]
"""Rotation of −90° about x, as Blender writes it: z of the model becomes y of the scene."""
SKETCHFAB = [
    1,
    0,
    0,
    0,
    0,
    2.220446049250313e-16,
    -1,
    0,
    0,
    1,
    2.220446049250313e-16,
    0,
    0,
    0,
    0,
    1,
]
"""The same rotation as the matrix of the root node of Sketchfab's files, column by column."""
CENTIMETRE = 0.009999999776482582
"""0.01 in single precision, as converters from FBX write the scale of the centimetre."""


def body(scale=1.0):
    return shapes.ellipsoid("icosphere", 3, tuple(scale * axis for axis in AXES_M))


def model_of(shape, nodes, roots=None, joints=None, bind=None):
    """Return a model of a shape; `bind` (4, 4) is the inverse bind matrix of every joint."""
    model = gltf_shapes.empty_model()
    uvs = 0.5 + 0.5 * shape.normals[:, :2]
    attributes = gltf_shapes.add_attributes(model, shape.positions, shape.normals, uvs)
    if joints:
        count = len(shape.positions)
        attributes["JOINTS_0"] = model.add_accessor(np.tile([0, 1, 0, 0], (count, 1)), "u1")
        attributes["WEIGHTS_0"] = model.add_accessor(np.tile([0.5, 0.5, 0.0, 0.0], (count, 1)))
        columns = np.tile(np.asarray(bind).T.ravel(), (len(joints), 1))
        matrices = model.add_accessor(columns, target=None)
        model.document["skins"] = [{"joints": joints, "inverseBindMatrices": matrices}]
    model.add_mesh(gltf_shapes.primitive(model, shape.faces, **attributes))
    return model.with_nodes(*nodes, roots=roots)


def scaled(factor):
    return np.diag([factor, factor, factor, 1.0])


def assert_placed(path, tmp_path, shape_mm, turn, unit_mm):
    """Assert the mesh in the scene, the unit of the bake, and the curvature of both.

    Parameters
    ----------
    path, tmp_path
        File, and folder for the bake.
    shape_mm
        The body in the axes of its mesh, mm.
    turn
        (3, 3) rotation from the axes of the mesh to those of the scene.
    unit_mm
        Length of the mesh's unit, mm.
    """
    mesh = load_mesh(path)
    largest = np.abs(shape_mm.positions).max()
    positions, normals = shape_mm.positions @ turn.T, shape_mm.normals @ turn.T
    np.testing.assert_allclose(mesh.positions_mm, positions, atol=FLOAT32_FILE.value * largest)
    np.testing.assert_allclose(mesh.normals, normals, atol=FLOAT32_FILE.value)
    assert mesh.repairs == {}
    expected = mesh_curvature(shape_mm.positions, shape_mm.faces, shape_mm.normals)
    loaded = mesh_curvature(mesh.positions_mm, mesh.faces, mesh.normals)
    np.testing.assert_allclose(loaded, expected, rtol=CURVATURE_OF_ROUNDED.value)

    baked = bake(path, tmp_path / "baked.glb", BakeSettings(tensor=True))
    (result,) = baked.meshes
    assert result.mesh.unit_mm == pytest.approx(unit_mm, rel=FLOAT32_FILE.value)
    assert result.all_notes == {}
    np.testing.assert_allclose(
        result.analysis.attributes["curvature"][:, 0], expected, rtol=CURVATURE_OF_ROUNDED.value
    )
    own = Mesh.checked(positions, shape_mm.faces, unit_mm=1.0, normals=normals)
    return own, load_mesh(tmp_path / "baked.glb")


def assert_tensor_in_the_axes_of_the_scene(own, reloaded, profile):
    """Assert that the tensor of a baked file equals that of the placed body."""
    assert "tensor" in reloaded.attributes
    expected = vertex_attributes(own, profile)["tensor"]
    gap = np.abs(reloaded.attributes["tensor"] - expected).max()
    assert gap <= CURVATURE_OF_ROUNDED.value * np.abs(expected).max()


NO_TURN = np.eye(3)
UPRIGHT = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
"""x stays, z becomes y, and y becomes −z."""


# -- rigs ------------------------------------------------------------------------------------------


def rig(mesh_scale, armature, bind, unit=1.0):
    """Return a model whose armature holds two joints and the mesh with a scale of its own."""
    nodes = [
        {"name": "armature", "children": [1, 2], **armature},
        {"name": "mesh", "mesh": 0, "skin": 0, "scale": [mesh_scale] * 3},
        {"name": "hips", "children": [3]},
        {"name": "spine"},
    ]
    return model_of(body(unit), nodes, roots=[0], joints=[2, 3], bind=bind)


def test_the_skin_of_a_mesh_in_metres_cancels_the_armature_in_centimetres(tmp_path, deon):
    """The inverse bind matrices undo the scale of .01 of the armature, which the mesh node has too."""
    model = rig(1.0, {"scale": [CENTIMETRE] * 3}, scaled(1.0 / CENTIMETRE))
    path = gltf_shapes.write(model, tmp_path)
    pair = assert_placed(path, tmp_path, body(1000.0), NO_TURN, 1000.0)
    assert_tensor_in_the_axes_of_the_scene(*pair, deon)


@pytest.mark.parametrize("mesh_scale", [CENTIMETRE, 1.0, 100.0])
def test_the_scale_of_the_node_of_a_skinned_mesh_does_not_apply(tmp_path, deon, mesh_scale):
    path = gltf_shapes.write(rig(mesh_scale, {}, np.eye(4)), tmp_path)
    pair = assert_placed(path, tmp_path, body(1000.0), NO_TURN, 1000.0)
    assert_tensor_in_the_axes_of_the_scene(*pair, deon)


def test_a_scale_of_zero_of_the_node_of_a_skinned_mesh_does_not_apply(tmp_path):
    path = gltf_shapes.write(rig(0.0, {}, np.eye(4)), tmp_path)
    assert_placed(path, tmp_path, body(1000.0), NO_TURN, 1000.0)


def test_a_skinned_mesh_in_centimetres_has_the_scale_of_its_joints(tmp_path, deon):
    model = rig(1.0, {"scale": [CENTIMETRE] * 3}, np.eye(4), unit=100.0)
    path = gltf_shapes.write(model, tmp_path)
    pair = assert_placed(path, tmp_path, body(1000.0), NO_TURN, 10.0)
    assert_tensor_in_the_axes_of_the_scene(*pair, deon)


def test_an_armature_that_turns_z_up_turns_its_skinned_mesh(tmp_path, deon):
    armature = {"scale": [CENTIMETRE] * 3, "rotation": QUARTER_BACK}
    model = rig(CENTIMETRE, armature, np.eye(4), unit=100.0)
    path = gltf_shapes.write(model, tmp_path)
    pair = assert_placed(path, tmp_path, body(1000.0), UPRIGHT, 10.0)
    assert_tensor_in_the_axes_of_the_scene(*pair, deon)


def test_khronos_accepts_the_rig(tmp_path):
    model = rig(CENTIMETRE, {"scale": [CENTIMETRE] * 3}, scaled(1.0 / CENTIMETRE))
    (messages,) = validator_messages(gltf_shapes.write(model, tmp_path))
    assert not [message for message in messages if message.startswith("error")]


# -- z up ------------------------------------------------------------------------------------------

ROOTS = {
    "a rotation": ({"rotation": QUARTER_BACK}, [1, 1, 1], 1.0),
    "a matrix": ({"matrix": SKETCHFAB}, [1, 1, 1], 1.0),
    "a matrix over a node in centimetres": ({"matrix": SKETCHFAB}, [CENTIMETRE] * 3, 100.0),
}


@pytest.mark.parametrize(("root", "scale", "unit"), ROOTS.values(), ids=ROOTS)
def test_a_z_up_model_below_a_turned_root_stands_upright(tmp_path, deon, root, scale, unit):
    nodes = [root | {"children": [1]}, {"scale": scale, "children": [2]}, {"mesh": 0}]
    path = gltf_shapes.write(model_of(body(unit), nodes, roots=[0]), tmp_path)
    pair = assert_placed(path, tmp_path, body(1000.0), UPRIGHT, 1000.0 / unit)
    height = np.ptp(load_mesh(path).positions_mm, axis=0)
    assert height == pytest.approx(1000.0 * 2.0 * np.array(AXES_M)[[0, 2, 1]], rel=0.02)
    assert_tensor_in_the_axes_of_the_scene(*pair, deon)


def test_the_tensor_in_the_file_of_a_z_up_model_is_in_the_axes_of_its_mesh(tmp_path):
    nodes = [{"rotation": QUARTER_BACK, "children": [1]}, {"mesh": 0}]
    path = gltf_shapes.write(model_of(body(), nodes, roots=[0]), tmp_path)
    turned = bake(path, tmp_path / "turned.glb", BakeSettings(tensor=True)).meshes[0]
    plain = gltf_shapes.write(model_of(body(), [{"mesh": 0}]), tmp_path, stem="plain")
    upright = bake(plain, tmp_path / "plain_out.glb", BakeSettings(tensor=True)).meshes[0]
    for name, values in upright.analysis.attributes.items():
        np.testing.assert_array_equal(turned.analysis.attributes[name], values)
