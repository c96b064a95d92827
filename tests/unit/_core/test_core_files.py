import os
import stat
from pathlib import Path

import pytest

from skinshade._core.errors import FileError, LutFileError, OutputError
from skinshade._core.files import atomic_write, existing_file

AS_ROOT = hasattr(os, "geteuid") and os.geteuid() == 0


def test_a_readable_file_is_returned(tmp_path):
    file = tmp_path / "head.glb"
    file.write_bytes(b"x")
    assert existing_file(str(file)) == file


@pytest.mark.parametrize(
    ("make", "complaint"),
    [
        (lambda path: None, "no such file"),
        (lambda path: path.mkdir(), "not a file"),
        (lambda path: path.touch(), "the file is empty"),
    ],
    ids=["missing", "folder", "empty"],
)
@pytest.mark.parametrize("kind", [FileError, LutFileError])
def test_an_unreadable_file_is_named_by_an_error_of_the_requested_type(
    tmp_path, make, complaint, kind
):
    file = tmp_path / "head.glb"
    make(file)
    with pytest.raises(kind) as caught:
        existing_file(file, kind)
    assert str(file) in str(caught.value)
    assert complaint in str(caught.value)


@pytest.mark.skipif(AS_ROOT, reason="root can read every file")
def test_a_file_without_permission_is_named(tmp_path):
    file = tmp_path / "head.glb"
    file.write_bytes(b"x")
    file.chmod(0)
    with pytest.raises(FileError, match="no permission"):
        existing_file(file)


def test_the_file_appears_complete_and_no_temporary_file_remains(tmp_path):
    target = tmp_path / "table.exr"
    with atomic_write(target) as temporary:
        assert temporary.parent == tmp_path
        assert temporary.suffix == ".exr"
        temporary.write_bytes(b"half")
        assert not target.exists()
        temporary.write_bytes(b"whole")
        written = temporary.stat().st_ino
    assert target.read_bytes() == b"whole"
    assert target.stat().st_ino == written, (
        "the file was copied, so that a reader can get a part of it"
    )
    assert list(tmp_path.iterdir()) == [target]


def test_a_failure_keeps_the_old_file_and_no_temporary_file(tmp_path):
    target = tmp_path / "table.exr"
    target.write_bytes(b"old")

    def fail():
        with atomic_write(target) as temporary:
            temporary.write_bytes(b"half")
            raise RuntimeError("the device failed")

    with pytest.raises(RuntimeError, match="the device failed"):
        fail()
    assert target.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [target]


def test_a_full_disk_is_an_output_error_that_names_the_file(tmp_path):
    target = tmp_path / "table.exr"

    def fail():
        with atomic_write(target):
            raise OSError(28, "No space left on device")

    with pytest.raises(OutputError) as caught:
        fail()
    assert str(target) in str(caught.value)
    assert "No space left" in str(caught.value)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("umask", [0o022, 0o077])
def test_the_permissions_of_the_file_follow_the_umask(tmp_path, umask):
    old = os.umask(umask)
    try:
        with atomic_write(tmp_path / "a.npz") as temporary:
            temporary.write_bytes(b"x")
    finally:
        assert os.umask(old) == umask
    assert stat.S_IMODE((tmp_path / "a.npz").stat().st_mode) == 0o666 & ~umask


@pytest.mark.parametrize(
    ("path", "complaint"),
    [
        ("missing/a.exr", "does not exist"),
        ("file/a.exr", "does not exist"),
        ("folder", "is a folder"),
    ],
)
def test_a_path_that_cannot_be_written_is_named(tmp_path, path, complaint):
    (tmp_path / "file").write_bytes(b"x")
    (tmp_path / "folder").mkdir()
    before = sorted(tmp_path.rglob("*"))
    with pytest.raises(OutputError) as caught, atomic_write(tmp_path / path):
        pytest.fail("the body must not run")
    assert str(tmp_path / path) in str(caught.value)
    assert complaint in str(caught.value)
    assert sorted(tmp_path.rglob("*")) == before


@pytest.mark.skipif(AS_ROOT, reason="root can write to every folder")
def test_a_folder_without_permission_is_named(tmp_path):
    tmp_path.chmod(0o500)
    with (
        pytest.raises(OutputError, match="cannot write to its folder"),
        atomic_write(tmp_path / "a.exr"),
    ):
        pytest.fail("the body must not run")


@pytest.mark.skipif(
    not Path("/proc/self").is_dir(), reason="needs a file system that refuses new files"
)
def test_a_file_system_without_new_files_is_named():
    with (
        pytest.raises(OutputError, match=r"/proc/a\.exr: cannot write to its folder"),
        atomic_write("/proc/a.exr"),
    ):
        pytest.fail("the body must not run")
