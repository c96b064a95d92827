"""Two thousand corrupted files: a bake raises an error of skinshade or writes a complete result.

`python -m fuzz` changes many more files.

Failures are: numbers that are not finite, warnings, other errors, too much memory or time, and changed
files outside the output folder. Each fault that these tests revealed has its own test in another file.
"""

import copy
import json
import os
import struct
import sys
import time
from functools import cache

import numpy as np
import pytest
import trimesh
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import gltf_shapes
import shapes
from skinshade._core.errors import SkinshadeError
from skinshade.baking import BakeSettings, bake

NAMES = list(gltf_shapes.SHAPES)
SETTINGS = [
    BakeSettings(unit_mm=1000.0),
    BakeSettings(unit_mm=1000.0, smoothing=0, tensor=True),
    BakeSettings(unit_mm=1000.0, thickness=True, rays=1, tracing="builtin"),
    BakeSettings(unit_mm=1000.0, map_size=4),
]
MOST_SECONDS = 20.0
MORE_MEMORY = 1 << 30
ODD = [
    None, True, False, 0, 1, -1, 2, 3.5, 255, 65536, 2**31, 2**32, 10**9, 2**53, -(2**63), 10**30,
    1e-300, -1e30, 1e38, 5120, 5121, 5123, 5125, 5126, "", "0", "SCALAR", "VEC3", "MAT4", "\ud800",
    "../x.bin", "/etc/passwd", "data:;base64,AAAA", "a%00b", [], {}, [[]], [0], [0, 0], {"a": {}},
]  # fmt: skip
"""Values that replace an entry of the document."""


def fixed_examples(count):
    """Return settings for a number of examples, the same in every run."""
    return settings(
        max_examples=count,
        deadline=None,
        derandomize=True,
        database=None,
        suppress_health_check=list(HealthCheck),
    )


@pytest.fixture(scope="module", autouse=True)
def limited_memory():
    """Limit the address space to one gibibyte more than the process has."""
    if sys.platform != "linux":
        yield
        return
    import resource

    limits = resource.getrlimit(resource.RLIMIT_AS)
    with open("/proc/self/statm") as statistics:  # noqa: PTH123
        now = int(statistics.read().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (now + MORE_MEMORY, limits[1]))
    yield
    resource.setrlimit(resource.RLIMIT_AS, limits)


def tree(folder):
    return sorted(
        os.path.join(parent, name)  # noqa: PTH118
        for parent, folders, files in os.walk(folder)
        for name in folders + files
    )


def assert_complete(written):
    """Assert strict JSON, finite baked numbers, and accessors that match their views."""
    data = written.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    document, chunk = json.loads(data[20 : 20 + length]), data[28 + length :]
    assert "NaN" not in json.dumps(document)
    assert "Infinity" not in json.dumps(document)
    for mesh in document["meshes"]:
        for part in mesh["primitives"]:
            for name in ("_CURVATURE", "_CURVATURE_TENSOR_0", "_THICKNESS"):
                index = part.get("attributes", {}).get(name)
                if isinstance(mesh.get("extras"), dict) and "skinshade" in mesh["extras"] and index:
                    accessor = document["accessors"][index]
                    view = document["bufferViews"][accessor["bufferView"]]
                    start, size = view["byteOffset"], view["byteLength"]
                    assert view["buffer"] == 0
                    values = np.frombuffer(chunk[start : start + size], "<f4")
                    assert np.isfinite(values).all()
                    assert values.size == accessor["count"] * (3 if "TENSOR" in name else 1)


def assert_baked_or_refused(folder, source, suffix, choice):
    """Assert a complete bake, or an error that names the file; in time, and in the output folder."""
    out = folder / "out"
    out.mkdir(exist_ok=True)
    before = [path for path in tree(folder) if not path.startswith(f"{out}/")]
    started = time.process_time()
    try:
        baked = bake(source, out / f"out{suffix}", SETTINGS[choice])
    except SkinshadeError as error:
        assert source.stem in str(error)
    else:
        for mesh in baked.meshes:
            for values in mesh.analysis.attributes.values():
                assert np.isfinite(values).all()
        if suffix == ".glb" and source.suffix in (".glb", ".gltf"):
            assert_complete(baked.written[-1])
    assert time.process_time() - started < MOST_SECONDS
    after = [path for path in tree(folder) if not path.startswith(f"{out}/")]
    assert after == before


# -- documents -------------------------------------------------------------------------------------


def entries(document):
    """Return every container of the document with each of its keys."""
    pairs, waiting = [], [document]
    while waiting:
        container = waiting.pop()
        keys = container.keys() if isinstance(container, dict) else range(len(container))
        for key in list(keys):
            pairs.append((container, key))
            if isinstance(container[key], (dict, list)):
                waiting.append(container[key])
    return pairs


CHANGE = st.tuples(
    st.sampled_from(["odd", "odd", "number", "drop", "copy", "rename", "cut"]),
    st.integers(0, 10**6),
    st.integers(0, 10**6),
)


def change(document, kind, where, what):
    """Change the entry number `where` (modulo their number); `what` selects the new value."""
    pairs = entries(document)
    container, key = pairs[where % len(pairs)]
    value = container[key]
    if kind == "odd":
        container[key] = copy.deepcopy(ODD[what % len(ODD)])
    elif kind == "number" and isinstance(value, (int, float)) and not isinstance(value, bool):
        numbers = [value + 1, value - 1, value * 2, -value, value * 10**6, value + 0.5]
        container[key] = numbers[what % 6]
    elif kind == "drop":
        del container[key]
    elif kind == "copy":
        source, other = pairs[what % len(pairs)]
        container[key] = copy.deepcopy(source[other])
    elif kind == "rename" and isinstance(container, dict):
        container[str(what)] = container.pop(key)
    elif kind == "cut" and isinstance(value, list):
        del value[: what % (len(value) + 1)]


@cache
def valid_model(name):
    return gltf_shapes.SHAPES[name]()


def assert_changed_document_is_handled(folder, name, changes, suffix, choice):
    model = valid_model(name)
    document = copy.deepcopy(model.document)
    document["buffers"] = [{"byteLength": len(model.binary)}]
    for arguments in changes:
        change(document, *arguments)
    source = folder / "source.glb"
    source.write_bytes(gltf_shapes.pack_glb(document, model.binary))
    assert_baked_or_refused(folder, source, suffix, choice)


DOCUMENTS = {
    "name": st.sampled_from(NAMES),
    "changes": st.lists(CHANGE, min_size=1, max_size=4),
    "choice": st.sampled_from([0, 0, 0, 1, 2, 3]),
}


@pytest.mark.slow
@fixed_examples(300)
@given(**DOCUMENTS)
def test_a_changed_document_is_baked_to_glb_or_refused(tmp_path_factory, name, changes, choice):
    folder = shared_folder(tmp_path_factory)
    assert_changed_document_is_handled(folder, name, changes, ".glb", choice)


@pytest.mark.slow
@fixed_examples(300)
@given(**DOCUMENTS)
def test_a_changed_document_is_baked_to_gltf_or_refused(tmp_path_factory, name, changes, choice):
    folder = shared_folder(tmp_path_factory)
    assert_changed_document_is_handled(folder, name, changes, ".gltf", choice)


@pytest.mark.slow
@fixed_examples(300)
@given(**DOCUMENTS)
def test_a_changed_document_is_baked_to_ply_or_refused(tmp_path_factory, name, changes, choice):
    folder = shared_folder(tmp_path_factory)
    assert_changed_document_is_handled(folder, name, changes, ".ply", choice)


# -- bytes -----------------------------------------------------------------------------------------

FAULT = st.tuples(
    st.sampled_from(["change", "flip", "cut", "insert", "end", "repeat", "odd"]),
    st.integers(0, 10**6),
    st.integers(0, 255),
)
TOKENS = [b"nan", b"1e999", b"-1", b"0", b"999999999", b"1e-42", b"inf", b"\n", b"/", b"f 1 1 1\n"]


def corrupted(data, faults):
    """Return bytes with faults: each has a kind, an offset, and a number that selects a value."""
    result = bytearray(data)
    for kind, where, what in faults:
        offset = where % max(len(result), 1)
        if kind == "change" and result:
            result[offset] = what
        elif kind == "flip" and result:
            result[offset] ^= 1 << what % 8
        elif kind == "cut":
            del result[offset : offset + what % 16]
        elif kind == "insert":
            result[offset:offset] = bytes([what]) * (1 + what % 5)
        elif kind == "end" and what < 64:
            del result[offset:]
        elif kind == "repeat":
            result[offset:offset] = result[offset : offset + what]
        elif kind == "odd":
            token = TOKENS[what % len(TOKENS)]
            result[offset : offset + len(token)] = token
    return bytes(result)


def small_sphere(suffix):
    """Return the bytes of a sphere as trimesh writes them."""
    ball = shapes.sphere("icosphere", 1, 80.0)
    visual = trimesh.visual.TextureVisuals(uv=ball.normals[:, :2] * 0.5 + 0.5)
    mesh = trimesh.Trimesh(
        ball.positions, ball.faces, vertex_normals=ball.normals, visual=visual, process=False
    )
    content = mesh.export(file_type=suffix.lstrip("."))
    return content.encode() if isinstance(content, str) else content


def text_ply():
    """Return the bytes of a sphere as a PLY file of text."""
    ball = shapes.sphere("icosphere", 1, 80.0)
    return trimesh.Trimesh(ball.positions, ball.faces).export(file_type="ply", encoding="ascii")


FILES = {
    "in.glb": (240, lambda folder: gltf_shapes.write(gltf_shapes.sparse(), folder).read_bytes()),
    "skinned.glb": (
        160,
        lambda folder: gltf_shapes.write(gltf_shapes.skinned(), folder).read_bytes(),
    ),
    "in.gltf": (
        200,
        lambda folder: gltf_shapes.write(gltf_shapes.plain(), folder, "embedded").read_bytes(),
    ),
    "in.obj": (160, lambda folder: small_sphere(".obj")),
    "in.ply": (100, lambda folder: small_sphere(".ply")),
    "text.ply": (100, lambda folder: text_ply()),
    "in.stl": (140, lambda folder: small_sphere(".stl")),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", FILES)
def test_a_file_with_changed_bytes_is_baked_or_refused(tmp_path_factory, name):
    folder = shared_folder(tmp_path_factory)
    count, make = FILES[name]
    data = make(tmp_path_factory.mktemp("valid"))

    @fixed_examples(count)
    @given(st.lists(FAULT, min_size=1, max_size=5), st.sampled_from([0, 0, 0, 1, 2, 3]))
    def bake_corrupted(faults, choice):
        source = folder / name
        source.write_bytes(corrupted(data, faults))
        assert_baked_or_refused(folder, source, ".glb", choice)

    bake_corrupted()


def test_the_corrupted_files_are_two_thousand():
    assert sum(count for count, _ in FILES.values()) + 3 * 300 == 2_000


@pytest.mark.parametrize("name", NAMES)
def test_an_unchanged_document_is_baked(tmp_path, name):
    assert_changed_document_is_handled(tmp_path, name, [], ".glb", 1)
    assert (tmp_path / "out" / "out.glb").is_file()


def shared_folder(factory, cache={}):  # noqa: B006
    """Return one folder for all cases of this process: creating one takes longer than a case."""
    if "folder" not in cache:
        cache["folder"] = factory.mktemp("fuzz")
    return cache["folder"]
