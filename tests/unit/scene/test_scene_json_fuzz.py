"""Whatever a scene file holds, it gives a scene or an error about the input."""

import copy
import json

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from test_scene_json import SCENE, write_files

from skinshade._core.errors import InputError
from skinshade.scene import Scene, load_scene

EXAMPLES = 200
CHANGES = ["scale", "scale", "scale", "replace", "drop", "add", "move", "profile"]
NUMBERS = st.one_of(
    st.integers(-3, 3),
    st.integers(),
    st.floats(),
    st.sampled_from([1e-320, 1e-200, 1e-9, 1e6, 1e15, 1e16, 1e300, 10**400, -(10**400)]),
)
WORDS = ["sun", "spot", "preset", "burley", "gaussians", "dipole", "skin1", "up", "linear"]
WORDS += ["mean-of-map", "bare.obj", "albedo.png", "sky.exr", ".", "..", "\0", "\ud800"]
TEXTS = st.one_of(st.sampled_from(WORDS), st.text(max_size=8))
LEAVES = st.one_of(st.none(), st.booleans(), NUMBERS, TEXTS)
VECTORS = st.lists(NUMBERS, min_size=3, max_size=3)
VALUES = st.one_of(
    LEAVES,
    VECTORS,
    st.recursive(
        LEAVES,
        lambda inner: st.one_of(
            st.lists(inner, max_size=4), st.dictionaries(TEXTS, inner, max_size=3)
        ),
        max_leaves=6,
    ),
)
PROFILES = st.one_of(
    st.fixed_dictionaries({"kind": st.just("preset"), "name": TEXTS}),
    st.fixed_dictionaries(
        {
            "kind": st.just("gaussians"),
            "variances_mm2": st.lists(NUMBERS, max_size=3),
            "weights": st.lists(VECTORS, max_size=3),
            "albedo": st.lists(st.floats(0.0, 1.0), min_size=3, max_size=3),
        }
    ),
    st.fixed_dictionaries(
        {
            "kind": st.just("dipole"),
            "sigma_s_prime_per_mm": VECTORS,
            "sigma_a_per_mm": VECTORS,
            "ior": st.floats(1.0, 3.0),
        }
    ),
)


def containers(value):
    """Yield every object and list of a document."""
    if isinstance(value, (dict, list)):
        yield value
        for inner in list(value.values()) if isinstance(value, dict) else list(value):
            yield from containers(inner)


def keys_of(container):
    return sorted(container) if isinstance(container, dict) else list(range(len(container)))


def numbers_of(nodes):
    """Return container and key of every number of a document that float64 holds."""
    entries = [(node, key) for node in nodes for key in keys_of(node)]
    numbers = [(node, key) for node, key in entries if type(node[key]) in (int, float)]
    return [(node, key) for node, key in numbers if abs(node[key]) < 1e300]


@st.composite
def documents(draw):
    """Return the good document after one to three mutations of its tree."""
    document = copy.deepcopy(SCENE)
    for _ in range(draw(st.integers(1, 3))):
        nodes = list(containers(document))
        node = draw(st.sampled_from(nodes))
        keys = keys_of(node)
        change = draw(st.sampled_from(CHANGES))
        numbers = numbers_of(nodes)
        if change == "scale" and numbers:
            node, key = draw(st.sampled_from(numbers))
            node[key] *= draw(st.sampled_from([0, 0.5, 0.9, 1.1, 2, -1]))
        elif change == "profile" and isinstance(document.get("material"), dict):
            document["material"]["profile"] = draw(PROFILES)
        elif change == "add" and isinstance(node, dict):
            known = [key for inner in nodes if isinstance(inner, dict) for key in sorted(inner)]
            node[draw(st.one_of(st.sampled_from(known), TEXTS))] = draw(VALUES)
        elif change == "add":
            node.append(draw(VALUES))
        elif keys and change == "drop":
            del node[draw(st.sampled_from(keys))]
        elif keys and change == "move":
            node[draw(st.sampled_from(keys))] = copy.deepcopy(draw(st.sampled_from(nodes)))
        elif keys:
            node[draw(st.sampled_from(keys))] = draw(VALUES)
    return document


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    return write_files(tmp_path_factory.mktemp("fuzz")) / "scene.json"


def is_scene_or_input_error(file, content, lights=None):
    """Return whether a file with this content gives a scene of finite values, or an InputError."""
    file.write_bytes(content)
    try:
        with np.errstate(all="ignore"):  # a warning about an overflow is no exception to a user
            scene = load_scene(file, lights=lights)
    except InputError as error:
        return str(error) != ""
    material = scene.material
    values = [scene.camera.view_projection(1.5), scene.background, material.albedo]
    values += [material.profile.albedo]
    values += [light.irradiance for light in scene.lights]
    return isinstance(scene, Scene) and all(np.isfinite(value).all() for value in values)


@settings(max_examples=EXAMPLES)
@given(documents())
def test_a_mutated_document_gives_a_scene_or_an_input_error(file, document):
    assert is_scene_or_input_error(file, json.dumps(document).encode())


@settings(max_examples=EXAMPLES)
@given(VALUES)
def test_any_json_gives_an_input_error(file, value):
    file.write_text(json.dumps(value), encoding="utf-8")
    with pytest.raises(InputError):
        load_scene(file)


@settings(max_examples=EXAMPLES)
@given(st.data())
def test_damaged_bytes_give_a_scene_or_an_input_error(file, data):
    content = bytearray(json.dumps(SCENE).encode())
    for _ in range(data.draw(st.integers(1, 4))):
        position = data.draw(st.integers(0, len(content) - 1))
        length = data.draw(st.integers(0, 3))
        content[position : position + length] = data.draw(st.binary(max_size=3))
    assert is_scene_or_input_error(file, bytes(content))


@given(st.integers(0, len(json.dumps(SCENE)) - 1))
def test_a_document_that_is_cut_short_gives_an_input_error(file, length):
    file.write_text(json.dumps(SCENE)[:length], encoding="utf-8")
    with pytest.raises(InputError):
        load_scene(file)


@given(st.lists(TEXTS, max_size=3))
def test_any_names_of_lights_give_a_scene_or_an_input_error(file, names):
    assert is_scene_or_input_error(file, json.dumps(SCENE).encode(), lights=names)
