"""Ten thousand spoiled files: each is an error of ours, or a whole result; never anything else.

Numbers that are not finite, warnings, memory beyond a bound, time without end and files elsewhere are
failures. What was found here has a test by name in the other files.
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
from skinshade.bake import BakeSettings, bake

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
    None,
    True,
    False,
    0,
    1,
    -1,
    2,
    3.5,
    255,
    65536,
    2**31,
    2**32,
    10**9,
    2**53,
    -(2**63),
    10**30,
]
ODD += [
    1e-300,
    -1e30,
    1e38,
    5120,
    5121,
    5123,
    5125,
    5126,
    "",
    "0",
    "SCALAR",
    "VEC3",
    "MAT4",
    "\ud800",
]
ODD += [
    "../x.bin",
    "/etc/passwd",
    "data:;base64,AAAA",
    "a%00b",
    [],
    {},
    [[]],
    [0],
    [0, 0],
    {"a": {}},
]
"""What stands in place of what was there."""


def many(count):
    return settings(
        max_examples=count,
        deadline=None,
        derandomize=True,
        database=None,
        suppress_health_check=list(HealthCheck),
    )


@pytest.fixture(scope="module", autouse=True)
def little_memory():
    """No case may take a gibibyte more than there was."""
    if sys.platform != "linux":
        yield
        return
    import resource

    limits = resource.getrlimit(resource.RLIMIT_AS)
    with open("/proc/self/statm") as told:  # noqa: PTH123
        now = int(told.read().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (now + MORE_MEMORY, limits[1]))
    yield
    resource.setrlimit(resource.RLIMIT_AS, limits)


def tree(folder):
    return sorted(
        os.path.join(at, name)  # noqa: PTH118
        for at, folders, files in os.walk(folder)
        for name in folders + files
    )


def assert_whole(written):
    """Strict JSON, every number of ours finite, every accessor within its bytes."""
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


def assert_good_end(folder, source, suffix, choice):
    """Baked whole, or refused by name."""
    out = folder / "out"
    out.mkdir(exist_ok=True)
    before = [each for each in tree(folder) if not each.startswith(f"{out}/")]
    started = time.process_time()
    try:
        baked = bake(source, out / f"out{suffix}", SETTINGS[choice])
    except SkinshadeError as error:
        assert source.stem in str(error)
    else:
        for mesh in baked.meshes:
            for values in mesh.analysed.attributes.values():
                assert np.isfinite(values).all()
        if suffix == ".glb" and source.suffix in (".glb", ".gltf"):
            assert_whole(baked.written[-1])
    assert time.process_time() - started < MOST_SECONDS
    after = [each for each in tree(folder) if not each.startswith(f"{out}/")]
    assert after == before


# -- documents -------------------------------------------------------------------------------------


def places(document):
    """Every container of the document and each of its keys."""
    found, left = [], [document]
    while left:
        here = left.pop()
        keys = here.keys() if isinstance(here, dict) else range(len(here))
        for key in list(keys):
            found.append((here, key))
            if isinstance(here[key], (dict, list)):
                left.append(here[key])
    return found


CHANGE = st.tuples(
    st.sampled_from(["odd", "odd", "number", "drop", "copy", "rename", "cut"]),
    st.integers(0, 10**6),
    st.integers(0, 10**6),
)


def change(document, kind, where, what):
    everywhere = places(document)
    here, key = everywhere[where % len(everywhere)]
    value = here[key]
    if kind == "odd":
        here[key] = copy.deepcopy(ODD[what % len(ODD)])
    elif kind == "number" and isinstance(value, (int, float)) and not isinstance(value, bool):
        here[key] = [value + 1, value - 1, value * 2, -value, value * 10**6, value + 0.5][what % 6]
    elif kind == "drop":
        del here[key]
    elif kind == "copy":
        source, other = everywhere[what % len(everywhere)]
        here[key] = copy.deepcopy(source[other])
    elif kind == "rename" and isinstance(here, dict):
        here[str(what)] = here.pop(key)
    elif kind == "cut" and isinstance(value, list):
        del value[: what % (len(value) + 1)]


@cache
def sound(name):
    return gltf_shapes.SHAPES[name]()


def spoil_document(folder, name, changes, suffix, choice):
    built = sound(name)
    document = copy.deepcopy(built.document)
    document["buffers"] = [{"byteLength": len(built.binary)}]
    for each in changes:
        change(document, *each)
    source = folder / "source.glb"
    source.write_bytes(gltf_shapes.pack_glb(document, built.binary))
    assert_good_end(folder, source, suffix, choice)


DOCUMENTS = {
    "name": st.sampled_from(NAMES),
    "changes": st.lists(CHANGE, min_size=1, max_size=4),
    "choice": st.sampled_from([0, 0, 0, 1, 2, 3]),
}


@pytest.mark.slow
@many(1500)
@given(**DOCUMENTS)
def test_a_document_that_was_changed_stays_gltf(tmp_path_factory, name, changes, choice):
    spoil_document(folder_of(tmp_path_factory), name, changes, ".glb", choice)


@pytest.mark.slow
@many(1500)
@given(**DOCUMENTS)
def test_a_document_that_was_changed_becomes_gltf(tmp_path_factory, name, changes, choice):
    spoil_document(folder_of(tmp_path_factory), name, changes, ".gltf", choice)


@pytest.mark.slow
@many(1500)
@given(**DOCUMENTS)
def test_a_document_that_was_changed_becomes_a_ply(tmp_path_factory, name, changes, choice):
    spoil_document(folder_of(tmp_path_factory), name, changes, ".ply", choice)


# -- bytes -----------------------------------------------------------------------------------------

FAULT = st.tuples(
    st.sampled_from(["change", "flip", "cut", "insert", "end", "repeat", "odd"]),
    st.integers(0, 10**6),
    st.integers(0, 255),
)
TOKENS = [b"nan", b"1e999", b"-1", b"0", b"999999999", b"1e-42", b"inf", b"\n", b"/", b"f 1 1 1\n"]


def spoil_bytes(data, faults):
    broken = bytearray(data)
    for kind, where, what in faults:
        at = where % max(len(broken), 1)
        if kind == "change" and broken:
            broken[at] = what
        elif kind == "flip" and broken:
            broken[at] ^= 1 << what % 8
        elif kind == "cut":
            del broken[at : at + what % 16]
        elif kind == "insert":
            broken[at:at] = bytes([what]) * (1 + what % 5)
        elif kind == "end" and what < 64:
            del broken[at:]
        elif kind == "repeat":
            broken[at:at] = broken[at : at + what]
        elif kind == "odd":
            token = TOKENS[what % len(TOKENS)]
            broken[at : at + len(token)] = token
    return bytes(broken)


def small_ball(suffix):
    ball = shapes.sphere("icosphere", 1, 80.0)
    visual = trimesh.visual.TextureVisuals(uv=ball.normals[:, :2] * 0.5 + 0.5)
    mesh = trimesh.Trimesh(
        ball.positions, ball.faces, vertex_normals=ball.normals, visual=visual, process=False
    )
    content = mesh.export(file_type=suffix.lstrip("."))
    return content.encode() if isinstance(content, str) else content


def text_ply():
    ball = shapes.sphere("icosphere", 1, 80.0)
    return trimesh.Trimesh(ball.positions, ball.faces).export(file_type="ply", encoding="ascii")


FILES = {
    "in.glb": (1200, lambda folder: gltf_shapes.write(gltf_shapes.sparse(), folder).read_bytes()),
    "skinned.glb": (
        800,
        lambda folder: gltf_shapes.write(gltf_shapes.skinned(), folder).read_bytes(),
    ),
    "in.gltf": (
        1000,
        lambda folder: gltf_shapes.write(gltf_shapes.plain(), folder, "embedded").read_bytes(),
    ),
    "in.obj": (800, lambda folder: small_ball(".obj")),
    "in.ply": (500, lambda folder: small_ball(".ply")),
    "text.ply": (500, lambda folder: text_ply()),
    "in.stl": (700, lambda folder: small_ball(".stl")),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", FILES)
def test_bytes_that_were_changed(tmp_path_factory, name):
    folder = folder_of(tmp_path_factory)
    count, make = FILES[name]
    data = make(tmp_path_factory.mktemp("sound"))

    @many(count)
    @given(st.lists(FAULT, min_size=1, max_size=5), st.sampled_from([0, 0, 0, 1, 2, 3]))
    def spoil(faults, choice):
        source = folder / name
        source.write_bytes(spoil_bytes(data, faults))
        assert_good_end(folder, source, ".glb", choice)

    spoil()


def test_they_are_ten_thousand():
    assert sum(count for count, _ in FILES.values()) + 3 * 1500 == 10_000


@pytest.mark.parametrize("name", NAMES)
def test_what_is_not_spoiled_is_baked(tmp_path, name):
    spoil_document(tmp_path, name, [], ".glb", 1)
    assert (tmp_path / "out" / "out.glb").is_file()


def folder_of(factory, kept={}):  # noqa: B006
    """One folder for all cases of this process: making one takes longer than a case."""
    if "folder" not in kept:
        kept["folder"] = factory.mktemp("fuzz")
    return kept["folder"]
