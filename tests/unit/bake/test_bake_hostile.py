"""Files that mean harm, each by name: an error of ours, in time, within memory, and in its folder."""

import json
import resource
import struct
import subprocess
import sys
import textwrap
import time
import tracemalloc

import numpy as np
import pytest
from hostile import SOUND, changed, refused

import gltf_shapes
from skinshade._core.errors import InputError, MeshFileError
from skinshade.bake import BakeSettings, bake
from skinshade.bake.jobs import plan, run
from tolerances import MEMORY_OF_A_BOMB

MEBIBYTE = 1 << 20


# -- nodes -----------------------------------------------------------------------------------------


def nodes(folder, *described):
    return changed(folder, nodes=list(described), scenes=[{"nodes": [0]}])


@pytest.mark.parametrize(
    "cycle",
    [
        [{"mesh": 0, "children": [0]}],
        [{"mesh": 0, "children": [1]}, {"children": [0]}],
        [{"mesh": 0}, {"children": [2]}, {"children": [3]}, {"children": [1]}],
    ],
)
def test_a_cycle_of_nodes(tmp_path, cycle):
    refused(nodes(tmp_path, *cycle), "its own ancestor")


def test_a_node_of_two_parents(tmp_path):
    both = [{"children": [2]}, {"children": [2]}, {"mesh": 0}]
    refused(nodes(tmp_path, *both), "node 2 has two parents")
    refused(nodes(tmp_path, {"children": [1, 1]}, {"mesh": 0}), "node 1 has two parents")


@pytest.mark.parametrize("key", ["rotation", "scale", "translation", "matrix"])
@pytest.mark.parametrize(
    "value",
    [True, None, "1", {}, [], [1, 2], ["1"] * 3, [True] * 3, [1, 1, None], [10**400] * 3, ["x"] * 4,
     [1e300] * 3, [[1], [1], [1]], [[1, 2, 3]] * 4, [False] * 16, ["0"] * 16],
)  # fmt: skip
def test_numbers_of_a_node_that_are_none(tmp_path, key, value):
    refused(nodes(tmp_path, {"mesh": 0, key: value}), f"node 0: {key}")


@pytest.mark.parametrize("scale", [[0, 0, 0], [1, 0, 1], [1e-12] * 3, [1e11] * 3])
def test_a_scale_without_meaning(tmp_path, scale):
    refused(nodes(tmp_path, {"mesh": 0, "scale": scale}), "its node scales it by")


def test_a_chain_of_nodes_that_grows_beyond_numbers(tmp_path):
    chain = [{"scale": [1e12] * 3, "children": [i + 1]} for i in range(40)]
    refused(nodes(tmp_path, *chain, {"mesh": 0}), "finite place|scales it by")


def test_a_bind_pose_that_is_not_a_number(tmp_path):
    built = gltf_shapes.skinned()
    bind = built.document["skins"][0]["inverseBindMatrices"]
    view = built.document["bufferViews"][built.document["accessors"][bind]["bufferView"]]
    built.binary[view["byteOffset"] : view["byteOffset"] + 4] = struct.pack("<f", np.nan)
    refused(gltf_shapes.write(built, tmp_path), "node 0 does not stand at a finite place")


def test_many_nodes_take_time_in_proportion(tmp_path):
    """Every reference to a node looked at all nodes again: an hour for a megabyte."""
    count = 30_000
    many = [{"children": list(range(1, count))}, {"mesh": 0}, *[{} for _ in range(count - 2)]]
    started = time.process_time()
    bake(nodes(tmp_path, *many), tmp_path / "out.glb")
    assert time.process_time() - started < 20.0


# -- counts and memory -----------------------------------------------------------------------------


def peak_of(path, out="out.glb"):
    tracemalloc.start()
    try:
        bake(path, path.parent / out)
    except InputError as error:
        assert str(path) in str(error)
    finally:
        peak = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
    return peak


@pytest.mark.parametrize("out", ["out.glb", "out.ply"])
@pytest.mark.parametrize("bytes_too", [True, False])
@pytest.mark.parametrize("name", ["POSITION", "NORMAL", "TEXCOORD_0", "indices"])
def test_a_count_of_a_billion(tmp_path, name, bytes_too, out):
    built = SOUND()
    part = built.document["meshes"][0]["primitives"][0]
    index = part["indices"] if name == "indices" else part["attributes"][name]
    built.document["accessors"][index]["count"] = 10**9
    if not bytes_too:
        del built.document["accessors"][index]["bufferView"]
    path = gltf_shapes.write(built, tmp_path)
    assert peak_of(path, out) < 8 * MEBIBYTE
    refused(path, "needs|too many", out=out)


@pytest.mark.parametrize("count", [10**9, 1])
def test_a_sparse_count_of_a_billion(tmp_path, count):
    built = gltf_shapes.sparse()
    position = built.document["meshes"][0]["primitives"][0]["attributes"]["POSITION"]
    accessor = built.document["accessors"][position]
    accessor["sparse"]["count"] = 10**9
    if count > 1:
        del accessor["bufferView"]
        accessor["count"] = count
    path = gltf_shapes.write(built, tmp_path)
    assert peak_of(path) < 8 * MEBIBYTE
    refused(path, "needs|too many")


def test_meshes_that_all_show_the_same_bytes(tmp_path):
    """Of a thousand views of the same bytes each took memory and an analysis of its own."""
    built = SOUND()
    first = built.document["meshes"][0]
    for index in range(1000):
        mesh = json.loads(json.dumps(first))
        accessor = dict(built.document["accessors"][0], name=str(index))
        built.document["accessors"].append(accessor)
        mesh["primitives"][0]["attributes"]["POSITION"] = len(built.document["accessors"]) - 1
        built.document["meshes"].append(mesh)
    big = built.view(bytes(2 * MEBIBYTE))
    for accessor in built.document["accessors"][4:]:
        accessor |= {"bufferView": big, "count": 170_000}
    path = gltf_shapes.write(built, tmp_path)
    assert peak_of(path) < 400 * MEBIBYTE


def test_instances_beyond_number_as_one_mesh(tmp_path):
    shown = [{"mesh": 0, "translation": [i, 0, 0]} for i in range(60_000)]
    path = changed(tmp_path, nodes=shown, scenes=[{"nodes": list(range(60_000))}])
    refused(path, "too many", out="out.ply")


def in_its_own_process(script, path):
    """What a script says that is given a file and where to bake it."""
    return subprocess.run(
        [sys.executable, "-c", script, str(path), str(path.parent / "out.glb")],
        capture_output=True,
        text=True,
        timeout=100,
        check=False,
    )


def needed_by(form, folder, size):
    """Peak memory of a process of its own that bakes a file with a texture of a size."""
    built = SOUND()
    built.view(np.random.default_rng(1).bytes(size))
    path = gltf_shapes.write(built, folder, form)
    script = textwrap.dedent("""
        import resource, sys
        from skinshade.bake import bake
        bake(sys.argv[1], sys.argv[2])
        print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
    """)
    ended = in_its_own_process(script, path)
    ended.check_returncode()
    return int(ended.stdout) * 1024


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="ru_maxrss counts in other units elsewhere")
def test_a_data_uri_takes_less_than_twice_what_the_same_bytes_take_in_a_glb(tmp_path):
    size = 100 * MEBIBYTE
    honest = needed_by("glb", tmp_path / "glb", size)
    embedded = needed_by("embedded", tmp_path / "embedded", size)
    assert embedded < MEMORY_OF_A_BOMB.value * honest


@pytest.mark.parametrize("uri", ["data:;base64,AAAA", "data:;base64,", "data:text/plain,AAAA"])
def test_a_data_uri_that_is_shorter_than_it_says_or_of_another_form(tmp_path, uri):
    built = SOUND()
    path = gltf_shapes.write(built, tmp_path, "embedded")
    document = json.loads(path.read_text())
    document["buffers"][0]["uri"] = uri
    path.write_text(json.dumps(document))
    refused(path, "buffer 0")


@pytest.mark.parametrize("suffix", [".ply", ".stl", ".obj"])
def test_a_header_that_promises_a_billion(tmp_path, suffix):
    path = tmp_path / f"in{suffix}"
    header = (
        "ply\nformat {} 1.0\nelement vertex 1000000000\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1000000000\nproperty list uchar int vertex_indices\n"
        "end_header\n"
    )
    lies = {
        ".ply": [header.format(kind).encode() + b"1 2 3\n" * 9 for kind in ("ascii", "binary_little_endian")],
        ".stl": [bytes(80) + struct.pack("<I", 10**9) + bytes(50)],
        ".obj": [b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 1000000000\n"],
    }  # fmt: skip
    for lie in lies[suffix]:
        path.write_bytes(lie)
        assert peak_of(path) < 64 * MEBIBYTE
        refused(path, "", InputError, unit_mm=1.0)


def test_limits_hold_in_a_process_of_little_memory(tmp_path):
    """Even address space is bounded, not only what is touched."""
    built = SOUND()
    built.document["accessors"][0] |= {"count": 10**9, "type": "VEC3"}
    del built.document["accessors"][0]["bufferView"]
    path = gltf_shapes.write(built, tmp_path)
    script = textwrap.dedent("""
        import resource, sys
        from skinshade.bake.asset import bake
        from skinshade._core.errors import MeshFileError
        now = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
        resource.setrlimit(resource.RLIMIT_AS, (now + (200 << 20), -1))
        try:
            bake(sys.argv[1], sys.argv[2])
        except MeshFileError as error:
            print("refused", error)
    """)
    if sys.platform != "linux":
        pytest.skip("the limit and the figure are Linux's")
    assert resource.RLIMIT_AS
    ended = in_its_own_process(script, path)
    assert ended.stdout.startswith("refused"), ended.stderr


# -- paths -----------------------------------------------------------------------------------------

ESCAPES = [
    "../secret.bin",
    "%2e%2e/secret.bin",
    "..%2Fsecret.bin",
    "inner/../../secret.bin",
    "{absolute}",
    "link.bin",
    "linked/secret.bin",
    "file://{absolute}",
    "http://127.0.0.1:9/secret.bin",
    "//127.0.0.1/secret.bin",
]


@pytest.mark.parametrize("out", ["out.glb", "out.gltf", "out.ply"])
@pytest.mark.parametrize("kind", ["buffers", "images"])
@pytest.mark.parametrize("uri", ESCAPES)
def test_a_path_that_leaves_the_folder(tmp_path, uri, kind, out):
    secret = tmp_path / "secret.bin"
    secret.write_bytes(bytes(100_000))
    folder = tmp_path / "asset"
    (folder / "inner").mkdir(parents=True)
    (folder / "link.bin").symlink_to(secret)
    (folder / "linked").symlink_to(tmp_path)
    uri = uri.replace("{absolute}", str(secret))
    path = gltf_shapes.write(SOUND(), folder, "external")
    document = json.loads(path.read_text())
    document.setdefault(kind, [{}])[0] = {"uri": uri, "byteLength": 100}
    path.write_text(json.dumps(document))
    (tmp_path / "deep" / "out").mkdir(parents=True)
    known = sorted(tmp_path.rglob("*"))
    # Pictures of the net stay there, and a table has none.
    at_fault = kind == "buffers" or ("://" not in uri and out != "out.ply")
    if at_fault:
        with pytest.raises(MeshFileError) as caught:
            bake(path, tmp_path / "deep" / "out" / out)
        assert str(path) in str(caught.value)
        assert sorted(tmp_path.rglob("*")) == known
    else:
        written = bake(path, tmp_path / "deep" / "out" / out).written
        assert all(each.is_relative_to(tmp_path / "deep" / "out") for each in written)
    assert secret.read_bytes() == bytes(100_000)
    (job,) = plan([path], tmp_path / "many", BakeSettings())
    assert run(job).status == ("failed" if kind == "buffers" or "://" not in uri else "baked")


@pytest.mark.parametrize(
    "uri", ["a\0b", "a%00b", "x" * 5000, "\ud800.bin", "circle", "", ".", "a/" * 3000, 5, True, []]
)
def test_a_name_that_no_file_has(tmp_path, uri):
    (tmp_path / "circle").symlink_to(tmp_path / "circle")
    path = gltf_shapes.write(SOUND(), tmp_path, "external")
    document = json.loads(path.read_text())
    document["buffers"][0]["uri"] = uri
    path.write_text(json.dumps(document))
    with pytest.raises(MeshFileError) as caught:
        bake(path, tmp_path / "out.glb")
    assert str(tmp_path) in str(caught.value)
    (job,) = plan([path], tmp_path / "many", BakeSettings())
    assert "internal error" not in run(job).error
