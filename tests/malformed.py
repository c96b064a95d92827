"""Malformed and malicious files, and assertions that they are refused."""

import numpy as np
import pytest

import gltf_shapes
from skinshade._core.errors import MeshFileError
from skinshade.baking import BakeSettings, bake
from skinshade.mesh import load_mesh


def assert_bake_refuses(path, message, kind=MeshFileError, output="out.glb", **settings):
    """Assert that a bake raises a short error that names the file, and writes nothing."""
    before = sorted(path.parent.rglob("*"))
    with pytest.raises(kind, match=message or None) as caught:
        bake(path, path.parent / output, BakeSettings(**settings))
    assert str(path) in str(caught.value)
    assert len(str(caught.value)) < 1000
    assert sorted(path.parent.rglob("*")) == before
    return str(caught.value)


def assert_refused(path, message, kind=MeshFileError, output="out.glb"):
    """Assert that `load_mesh` and a bake raise the same short error, and nothing is written."""
    with pytest.raises(kind, match=message or None) as caught:
        load_mesh(path)
    assert assert_bake_refuses(path, message, kind, output) == str(caught.value)


def plain_with(folder, **parts):
    """Write the plain model with some of its top-level entries replaced."""
    model = gltf_shapes.plain()
    model.document |= parts
    return gltf_shapes.write(model, folder)


def one_primitive(folder, positions, indices=None, **more):
    """Write a model of one primitive without normals; `more` are entries of its accessor."""
    model = gltf_shapes.empty_model()
    primitive = {"attributes": {"POSITION": model.add_accessor(np.asarray(positions), **more)}}
    if indices is not None:
        corners = np.asarray(indices).reshape(-1, 1)
        primitive["indices"] = model.add_accessor(corners, "u4", target=34963)
    model.add_mesh(primitive)
    return gltf_shapes.write(model.with_nodes({"mesh": 0}), folder)
