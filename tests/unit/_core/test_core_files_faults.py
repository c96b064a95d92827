"""Faults of the machine during writes: full disks, failed replacements, read-only folders, umasks."""

import os
import resource
import signal
import subprocess
import sys
import threading
from pathlib import Path

import numpy as np
import pytest

from skinshade._core.errors import OutputError
from skinshade._core.files import atomic_files, atomic_write
from skinshade._core.pixels import read_pixels, write_pixels
from skinshade.lut import Axis, Lut
from skinshade.mesh import Mesh

SMALL = 2 << 20
AS_ROOT = hasattr(os, "geteuid") and os.geteuid() == 0
NOISE = np.random.default_rng(1)


@pytest.fixture
def small_disk(tmp_path):
    """A file system of 2 MiB, or None where mounting is not permitted."""
    folder = tmp_path / "small"
    folder.mkdir()
    options = ["mount", "-t", "tmpfs", "-o", f"size={SMALL}", "tmpfs", str(folder)]
    mounted = AS_ROOT and subprocess.run(options, capture_output=True, check=False).returncode == 0
    if not mounted:
        pytest.skip("a file system of 2 MiB needs root and the right to mount")
    yield folder
    subprocess.run(["umount", "--lazy", str(folder)], check=True)


@pytest.fixture
def small_files(tmp_path):
    """A limit of 2 MiB for the size of files, which every user may set."""
    if sys.platform == "win32":
        pytest.skip("Windows has no limit of file sizes")
    former = resource.getrlimit(resource.RLIMIT_FSIZE)
    handler = signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (SMALL, former[1]))
    yield tmp_path
    resource.setrlimit(resource.RLIMIT_FSIZE, former)
    signal.signal(signal.SIGXFSZ, handler)


def image(kind):
    values = NOISE.integers(0, 256, (1200, 1200, 3))
    return values.astype(kind)


def write_table(path):
    values = NOISE.random((1024, 1024, 3), dtype=np.float32)
    axes = Axis("n_dot_l", "1", -1.0, 1.0), Axis("curvature", "1/mm", 0.0, 1.0)
    Lut(values, "curvature", *axes, {}).save(path)


def write_usd(path):
    pytest.importorskip("pxr")
    from skinshade.baking import BakeSettings
    from skinshade.baking.analysis import Analysis
    from skinshade.baking.formats import write_mesh

    points = NOISE.random((200_000, 3))
    faces = NOISE.permutation(200_000)[:199_998].reshape(-1, 3)
    mesh = Mesh(points, points, faces, 1.0)
    with atomic_files() as files:
        write_mesh(files, path, mesh, Analysis({}, None), BakeSettings())


WRITERS = {
    "a.png": lambda path: write_pixels(path, image(np.uint8)),
    "b.png": lambda path: write_pixels(path, image(np.uint16)),
    "c.exr": lambda path: write_pixels(path, image(np.float32) / 7.0),
    "d.npz": write_table,
    "e.exr": write_table,
    "f.usdc": write_usd,
    "g.usda": write_usd,
    "h.glb": lambda path: write_set(path, bytes(3 << 20)),
}


def write_set(path, content):
    with atomic_files() as files:
        files.add_bytes(path.with_suffix(".bin"), b"first")
        files.add_bytes(path, content)


@pytest.mark.parametrize("name", WRITERS)
@pytest.mark.parametrize("disk", ["small_disk", "small_files"])
def test_a_full_disk_is_an_error_and_the_former_file_is_kept(request, disk, name):
    folder = request.getfixturevalue(disk)
    path = folder / name
    path.write_bytes(b"former")
    with pytest.raises(OutputError, match=name):
        WRITERS[name](path)
    assert path.read_bytes() == b"former"
    assert list(folder.iterdir()) == [path]


def test_a_complete_image_is_written_to_the_small_disk(small_disk):
    pixels = image(np.uint8)[:400, :400]
    write_pixels(small_disk / "a.png", pixels)
    values, _ = read_pixels(small_disk / "a.png", OutputError)
    np.testing.assert_array_equal(np.rint(values * 255.0), pixels)


def test_a_file_that_stays_empty_is_an_error(tmp_path):
    with pytest.raises(OutputError, match="the result is empty"), atomic_write(tmp_path / "a"):
        pass
    assert list(tmp_path.iterdir()) == []


def test_no_file_of_a_set_is_replaced_before_all_are_written(tmp_path):
    (tmp_path / "a.bin").write_bytes(b"former")

    def fail():
        with atomic_files() as files:
            files.add_bytes(tmp_path / "a.bin", b"new")
            files.add_bytes(tmp_path / "new" / "deep" / "b.bin", b"new", make_folder=True)
            files.add(tmp_path / "c.glb")  # stays empty

    with pytest.raises(OutputError, match=r"c\.glb"):
        fail()
    assert (tmp_path / "a.bin").read_bytes() == b"former"
    assert [path.name for path in tmp_path.iterdir()] == ["a.bin"]


def test_the_last_file_of_a_set_is_replaced_last(tmp_path, monkeypatch):
    order = []
    replace = Path.replace
    monkeypatch.setattr(
        Path, "replace", lambda self, target: (order.append(target.name), replace(self, target))
    )
    with atomic_files() as files:
        for name in ("b.bin", "a.png", "head.gltf"):
            files.add_bytes(tmp_path / name, b"x")
    assert order == ["b.bin", "a.png", "head.gltf"]


@pytest.mark.skipif(AS_ROOT, reason="root can write to every folder")
def test_a_read_only_folder_is_an_output_error(tmp_path):
    tmp_path.chmod(0o500)
    with (
        pytest.raises(OutputError, match="cannot write to its folder"),
        atomic_write(tmp_path / "a"),
    ):
        pass
    tmp_path.chmod(0o700)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no umask")
def test_files_of_all_threads_respect_the_umask(tmp_path):
    """The umask of the process never changes, so that files of other threads have no other permissions."""
    former = os.umask(0o077)
    modes = set()

    def write(index):
        for number in range(150):
            path = tmp_path / f"{index}-{number}"
            with atomic_write(path) as temporary:
                temporary.write_bytes(b"x")
            modes.add(path.stat().st_mode & 0o777)
            other = tmp_path / f"other-{index}-{number}"
            other.touch()
            modes.add(other.stat().st_mode & 0o777)

    threads = [threading.Thread(target=write, args=(index,)) for index in range(4)]
    try:
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    finally:
        os.umask(former)
    assert modes == {0o600}


def test_a_link_at_the_target_stays_and_its_file_is_replaced(tmp_path):
    (tmp_path / "folder").mkdir()
    (tmp_path / "link").symlink_to(Path("folder") / "file")
    with atomic_write(tmp_path / "link") as temporary:
        assert temporary.parent == tmp_path / "folder"
        temporary.write_bytes(b"x")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "folder" / "file").read_bytes() == b"x"
