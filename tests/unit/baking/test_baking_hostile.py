"""Malicious files are refused with an error of skinshade, in time, within memory, in their folder."""

import json
import resource
import struct
import subprocess
import sys
import textwrap
import tracemalloc

import numpy as np
import pytest

import gltf_shapes
from malformed import assert_bake_refuses, plain_with
from skinshade._core.errors import InputError, MeshFileError
from skinshade.baking import BakeSettings, bake
from skinshade.baking.jobs import plan_jobs, run_job
from tolerances import MEMORY_OF_A_BOMB

MEBIBYTE = 1 << 20

# -- counts and memory -----------------------------------------------------------------------------


def peak_memory(path, output="out.glb"):
    """Return the peak of allocated bytes during a bake that may be refused."""
    tracemalloc.start()
    try:
        bake(path, path.parent / output)
    except InputError as error:
        assert str(path) in str(error)
    finally:
        peak = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
    return peak


@pytest.mark.parametrize("output", ["out.glb", "out.ply"])
@pytest.mark.parametrize("with_view", [True, False])
@pytest.mark.parametrize("name", ["POSITION", "NORMAL", "TEXCOORD_0", "indices"])
def test_a_count_of_a_billion_is_refused_within_8_mebibytes(tmp_path, name, with_view, output):
    model = gltf_shapes.plain()
    part = model.document["meshes"][0]["primitives"][0]
    index = part["indices"] if name == "indices" else part["attributes"][name]
    model.document["accessors"][index]["count"] = 10**9
    if not with_view:
        del model.document["accessors"][index]["bufferView"]
    path = gltf_shapes.write(model, tmp_path)
    assert peak_memory(path, output) < 8 * MEBIBYTE
    assert_bake_refuses(path, "needs|too many", output=output)


@pytest.mark.parametrize("count", [10**9, 1])
def test_a_sparse_count_of_a_billion_is_refused_within_8_mebibytes(tmp_path, count):
    model = gltf_shapes.sparse()
    position = model.document["meshes"][0]["primitives"][0]["attributes"]["POSITION"]
    accessor = model.document["accessors"][position]
    accessor["sparse"]["count"] = 10**9
    if count > 1:
        del accessor["bufferView"]
        accessor["count"] = count
    path = gltf_shapes.write(model, tmp_path)
    assert peak_memory(path) < 8 * MEBIBYTE
    assert_bake_refuses(path, "needs|too many")


def test_a_thousand_meshes_of_the_same_bytes_stay_within_400_mebibytes(tmp_path):
    """Without a limit, each accessor of the same bytes takes its own memory and analysis."""
    model = gltf_shapes.plain()
    first = model.document["meshes"][0]
    for index in range(1000):
        mesh = json.loads(json.dumps(first))
        accessor = dict(model.document["accessors"][0], name=str(index))
        model.document["accessors"].append(accessor)
        mesh["primitives"][0]["attributes"]["POSITION"] = len(model.document["accessors"]) - 1
        model.document["meshes"].append(mesh)
    large = model.add_view(bytes(2 * MEBIBYTE))
    for accessor in model.document["accessors"][4:]:
        accessor |= {"bufferView": large, "count": 170_000}
    path = gltf_shapes.write(model, tmp_path)
    assert peak_memory(path) < 400 * MEBIBYTE


@pytest.mark.slow
def test_sixty_thousand_instances_as_one_mesh_are_refused(tmp_path):
    nodes = [{"mesh": 0, "translation": [i, 0, 0]} for i in range(60_000)]
    path = plain_with(tmp_path, nodes=nodes, scenes=[{"nodes": list(range(60_000))}])
    assert_bake_refuses(path, "too many", output="out.ply")


def run_script(script, path):
    """Run a script in a new process, with a source and an output as arguments."""
    return subprocess.run(
        [sys.executable, "-c", script, str(path), str(path.parent / "out.glb")],
        capture_output=True,
        text=True,
        timeout=100,
        check=False,
    )


def process_memory(form, folder, size):
    """Return the peak memory of a new process that bakes a file with a texture of `size` bytes."""
    model = gltf_shapes.plain()
    model.add_view(np.random.default_rng(1).bytes(size))
    path = gltf_shapes.write(model, folder, form)
    script = textwrap.dedent("""
        import resource, sys
        from skinshade.baking import bake
        bake(sys.argv[1], sys.argv[2])
        print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
    """)
    process = run_script(script, path)
    process.check_returncode()
    return int(process.stdout) * 1024


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="ru_maxrss has other units elsewhere")
def test_a_data_uri_takes_less_than_twice_the_memory_of_a_glb_with_the_same_bytes(tmp_path):
    size = 100 * MEBIBYTE
    binary = process_memory("glb", tmp_path / "glb", size)
    embedded = process_memory("embedded", tmp_path / "embedded", size)
    assert embedded < MEMORY_OF_A_BOMB.value * binary


@pytest.mark.parametrize("suffix", [".ply", ".stl", ".obj"])
def test_a_header_with_a_count_of_a_billion_is_refused_within_64_mebibytes(tmp_path, suffix):
    path = tmp_path / f"in{suffix}"
    header = (
        "ply\nformat {} 1.0\nelement vertex 1000000000\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1000000000\nproperty list uchar int vertex_indices\n"
        "end_header\n"
    )
    contents = {
        ".ply": [header.format(kind).encode() + b"1 2 3\n" * 9 for kind in ("ascii", "binary_little_endian")],
        ".stl": [bytes(80) + struct.pack("<I", 10**9) + bytes(50)],
        ".obj": [b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 1000000000\n"],
    }  # fmt: skip
    for content in contents[suffix]:
        path.write_bytes(content)
        assert peak_memory(path) < 64 * MEBIBYTE
        assert_bake_refuses(path, "", InputError, unit_mm=1.0)


def test_a_count_of_a_billion_is_refused_in_a_process_with_limited_address_space(tmp_path):
    """The limit applies to reserved memory too, not only to memory that is used."""
    model = gltf_shapes.plain()
    model.document["accessors"][0] |= {"count": 10**9, "type": "VEC3"}
    del model.document["accessors"][0]["bufferView"]
    path = gltf_shapes.write(model, tmp_path)
    script = textwrap.dedent("""
        import resource, sys
        from skinshade.baking.asset import bake
        from skinshade._core.errors import MeshFileError
        now = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
        resource.setrlimit(resource.RLIMIT_AS, (now + (200 << 20), -1))
        try:
            bake(sys.argv[1], sys.argv[2])
        except MeshFileError as error:
            print("refused", error)
    """)
    if sys.platform != "linux":
        pytest.skip("the limit and /proc are those of Linux")
    assert resource.RLIMIT_AS
    process = run_script(script, path)
    assert process.stdout.startswith("refused"), process.stderr


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


@pytest.mark.parametrize("output", ["out.glb", "out.gltf", "out.ply"])
@pytest.mark.parametrize("kind", ["buffers", "images"])
@pytest.mark.parametrize("uri", ESCAPES)
def test_files_outside_the_folder_of_the_asset_are_neither_read_nor_written(
    tmp_path, uri, kind, output
):
    secret = tmp_path / "secret.bin"
    secret.write_bytes(bytes(100_000))
    folder = tmp_path / "asset"
    (folder / "inner").mkdir(parents=True)
    (folder / "link.bin").symlink_to(secret)
    (folder / "linked").symlink_to(tmp_path)
    uri = uri.replace("{absolute}", str(secret))
    path = gltf_shapes.write(gltf_shapes.plain(), folder, "external")
    document = json.loads(path.read_text())
    document.setdefault(kind, [{}])[0] = {"uri": uri, "byteLength": 100}
    path.write_text(json.dumps(document))
    target = tmp_path / "deep" / "out"
    target.mkdir(parents=True)
    before = sorted(tmp_path.rglob("*"))
    # A glTF file keeps URLs of images; a PLY file has no images.
    if kind == "buffers" or ("://" not in uri and output != "out.ply"):
        with pytest.raises(MeshFileError) as caught:
            bake(path, target / output)
        assert str(path) in str(caught.value)
        assert sorted(tmp_path.rglob("*")) == before
    else:
        written = bake(path, target / output).written
        assert all(file.is_relative_to(target) for file in written)
    assert secret.read_bytes() == bytes(100_000)
    (job,) = plan_jobs([path], tmp_path / "many", BakeSettings())
    status = "failed" if kind == "buffers" or "://" not in uri else "baked"
    assert run_job(job).status == status


@pytest.mark.parametrize(
    "uri", ["a\0b", "a%00b", "x" * 5000, "\ud800.bin", "circle", "", ".", "a/" * 3000, 5, True, []]
)
def test_a_uri_that_is_no_file_name_is_refused(tmp_path, uri):
    (tmp_path / "circle").symlink_to(tmp_path / "circle")
    path = gltf_shapes.write(gltf_shapes.plain(), tmp_path, "external")
    document = json.loads(path.read_text())
    document["buffers"][0]["uri"] = uri
    path.write_text(json.dumps(document))
    with pytest.raises(MeshFileError) as caught:
        bake(path, tmp_path / "out.glb")
    assert str(tmp_path) in str(caught.value)
    (job,) = plan_jobs([path], tmp_path / "many", BakeSettings())
    assert "internal error" not in run_job(job).error
