"""How files that mean harm are made, and what it is for one to be refused."""

import numpy as np
import pytest

import gltf_shapes
from skinshade._core.errors import MeshFileError
from skinshade.bake import BakeSettings, bake

SOUND = gltf_shapes.plain


def refused(path, said, kind=MeshFileError, out="out.glb", **settings):
    """The file is refused with a short message that names it, and nothing is written."""
    before = sorted(path.parent.rglob("*"))
    with pytest.raises(kind, match=said or None) as caught:
        bake(path, path.parent / out, BakeSettings(**settings))
    assert str(path) in str(caught.value)
    assert len(str(caught.value)) < 1000
    assert sorted(path.parent.rglob("*")) == before
    return str(caught.value)


def changed(folder, **parts):
    """A sound file some of whose top-level entries are others."""
    built = SOUND()
    built.document |= parts
    return gltf_shapes.write(built, folder)


def one_triangle(folder, positions, indices=None, **more):
    built = gltf_shapes.new()
    part = {"attributes": {"POSITION": built.accessor(np.asarray(positions), **more)}}
    if indices is not None:
        part["indices"] = built.accessor(np.asarray(indices).reshape(-1, 1), "u4", target=34963)
    built.mesh(part)
    return gltf_shapes.write(built.show({"mesh": 0}), folder)
