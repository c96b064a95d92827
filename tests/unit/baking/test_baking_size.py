"""A bake warns of an implausible size as `load_mesh` does, for the whole asset."""

import warnings

import numpy as np
import pytest

import gltf_shapes
from skinshade._core.errors import UnitWarning
from skinshade.baking import BakeSettings, bake
from skinshade.mesh import load_mesh

REMEDY = "give unit_mm, the length of one unit of the file in mm"


def balls(radius_m, centres_m, **node):
    """Return a model of a ball, once at every centre."""
    model = gltf_shapes.empty_model()
    parts = gltf_shapes.sphere(radius_m)
    model.add_mesh(
        gltf_shapes.primitive(model, parts[3], **gltf_shapes.add_attributes(model, *parts))
    )
    return model.with_nodes(*({"mesh": 0, "translation": list(c)} | node for c in centres_m))


def messages(function, *arguments):
    """Return the texts of the warnings about the size."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        function(*arguments)
    assert {warning.category for warning in caught} <= {UnitWarning}
    assert {warning.filename for warning in caught} <= {__file__}
    return [str(warning.message) for warning in caught]


@pytest.mark.parametrize("suffix", [".glb", ".gltf"])
@pytest.mark.parametrize(("radius_m", "unit_mm"), [(4.0, None), (0.08, 50_000.0), (0.008, None)])
def test_a_bake_of_gltf_warns_as_load_mesh_does(tmp_path, suffix, radius_m, unit_mm):
    source = gltf_shapes.write(balls(radius_m, [(0, 0, 0)]), tmp_path)
    (message,) = messages(bake, source, tmp_path / f"out{suffix}", BakeSettings(unit_mm=unit_mm))
    with pytest.warns(UnitWarning) as caught:
        load_mesh(source, unit_mm=unit_mm)
    assert message == str(caught[0].message)
    assert message.startswith(f"{source}: ")
    assert REMEDY in message


@pytest.mark.parametrize("output", ["out.glb", "out.ply"])
@pytest.mark.parametrize("unit_mm", [1.0, 10_000.0])
def test_a_bake_of_obj_with_an_implausible_unit_warns(tmp_path, output, unit_mm):
    source = tmp_path / "head.obj"
    source.write_text("v 0 0 0\nv 3 0 0\nv 0 4 0\nf 1 2 3\n")
    settings = BakeSettings(unit_mm=unit_mm)
    with pytest.warns(UnitWarning) as caught:
        bake(source, tmp_path / output, settings)
    (message,) = (str(warning.message) for warning in caught)
    size = "5 mm" if unit_mm == 1.0 else "50 m"
    start = f"{source}: with the given unit of {unit_mm:g} mm, the object is {size} across"
    assert message.startswith(start)


def test_the_size_is_that_of_all_meshes_of_the_asset(tmp_path):
    """Each ball is as small as an eye; six centimetres apart, they are as large as a face."""
    pair = [(-0.03, 0, 0), (0.03, 0, 0)]
    source = gltf_shapes.write(balls(0.012, pair), tmp_path)
    assert messages(bake, source, tmp_path / "out.glb") == []
    source = gltf_shapes.write(balls(0.012, pair[:1]), tmp_path, stem="one")
    assert len(messages(bake, source, tmp_path / "out.glb")) == 1


def test_the_size_includes_the_scale_of_the_node(tmp_path):
    source = gltf_shapes.write(balls(8.0, [(0, 0, 0)], scale=[0.01] * 3), tmp_path)
    assert messages(bake, source, tmp_path / "out.glb") == []
    source = gltf_shapes.write(balls(0.08, [(0, 0, 0)], scale=[100.0] * 3), tmp_path)
    (message,) = messages(bake, source, tmp_path / "out.glb")
    assert "in metres, the unit of glTF, the object is 27." in message


def test_a_plausible_asset_does_not_warn(tmp_path):
    source = gltf_shapes.write(gltf_shapes.plain(), tmp_path)
    assert messages(bake, source, tmp_path / "out.glb") == []
    assert messages(bake, source, tmp_path / "out.ply") == []


def test_an_asset_of_infinite_extent_warns_and_is_baked(tmp_path):
    """Scales of 1e-12 undo those of 1e12, but not the translations between them."""
    model = balls(0.08, [(0, 0, 0)])
    grown = [{"scale": [1e12] * 3, "children": [i + 1]} for i in range(25)]
    far = [{"translation": [1e7, 0, 0], "children": [26]}]
    shrunk = [{"scale": [1e-12] * 3, "children": [i + 27]} for i in range(25)]
    chain = [*grown, *far, *shrunk, {"mesh": 0}]
    roots = [0, len(chain), len(chain) + 1]
    opposite = [{"mesh": 0}, {"mesh": 0, "translation": [-1e12, 0, 0]}]
    model.with_nodes(*chain, *opposite, roots=roots)
    source = gltf_shapes.write(model, tmp_path)
    (message,) = messages(bake, source, tmp_path / "out.glb")
    assert np.isfinite(bake_curvature(tmp_path / "out.glb")).all()
    assert "e+307 m across" in message or "inf m across" in message


def bake_curvature(path):
    document, buffers = gltf_shapes.read(path)
    accessor = document["accessors"][
        document["meshes"][0]["primitives"][0]["attributes"]["_CURVATURE"]
    ]
    content = gltf_shapes.view_bytes(document, buffers)[accessor["bufferView"]]
    return np.frombuffer(content, "<f4")
