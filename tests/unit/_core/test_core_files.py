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
def test_what_cannot_be_read_is_named_with_the_error_asked_for(tmp_path, make, complaint, kind):
    file = tmp_path / "head.glb"
    make(file)
    with pytest.raises(kind) as caught:
        existing_file(file, kind)
    assert str(file) in str(caught.value)
    assert complaint in str(caught.value)


@pytest.mark.skipif(AS_ROOT, reason="root may read every file")
def test_a_file_without_permission_is_named(tmp_path):
    file = tmp_path / "head.glb"
    file.write_bytes(b"x")
    file.chmod(0)
    with pytest.raises(FileError, match="no permission"):
        existing_file(file)


def test_a_file_appears_whole_and_alone(tmp_path):
    target = tmp_path / "table.exr"
    with atomic_write(target) as temporary:
        assert temporary.parent == tmp_path
        assert temporary.suffix == ".exr"
        temporary.write_bytes(b"half")
        assert not target.exists()
        temporary.write_bytes(b"whole")
        written = temporary.stat().st_ino
    assert target.read_bytes() == b"whole"
    assert target.stat().st_ino == written, "copied byte by byte, so that half of it could be seen"
    assert list(tmp_path.iterdir()) == [target]


def test_a_failure_leaves_the_old_file_and_nothing_else(tmp_path):
    target = tmp_path / "table.exr"
    target.write_bytes(b"old")

    def fail():
        with atomic_write(target) as temporary:
            temporary.write_bytes(b"half")
            raise RuntimeError("the pen broke")

    with pytest.raises(RuntimeError, match="the pen broke"):
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
def test_the_file_has_the_rights_that_the_user_gives_new_files(tmp_path, umask):
    old = os.umask(umask)
    try:
        with atomic_write(tmp_path / "a.npz") as temporary:
            temporary.write_bytes(b"x")
    finally:
        assert os.umask(old) == umask
    assert stat.S_IMODE((tmp_path / "a.npz").stat().st_mode) == 0o666 & ~umask


@pytest.mark.parametrize(
    ("place", "complaint"),
    [
        ("missing/a.exr", "there is no folder"),
        ("file/a.exr", "there is no folder"),
        ("folder", "is a folder"),
    ],
)
def test_a_place_that_cannot_be_written_is_named(tmp_path, place, complaint):
    (tmp_path / "file").write_bytes(b"x")
    (tmp_path / "folder").mkdir()
    before = sorted(tmp_path.rglob("*"))
    with pytest.raises(OutputError) as caught, atomic_write(tmp_path / place):
        pytest.fail("the body must not run")
    assert str(tmp_path / place) in str(caught.value)
    assert complaint in str(caught.value)
    assert sorted(tmp_path.rglob("*")) == before


@pytest.mark.skipif(AS_ROOT, reason="root may write everywhere")
def test_a_folder_without_permission_is_named(tmp_path):
    tmp_path.chmod(0o500)
    with pytest.raises(OutputError, match="cannot write here"), atomic_write(tmp_path / "a.exr"):
        pytest.fail("the body must not run")


@pytest.mark.skipif(
    not Path("/proc/self").is_dir(), reason="needs a file system that takes no files"
)
def test_a_file_system_that_takes_no_files_is_named():
    with (
        pytest.raises(OutputError, match=r"/proc/a\.exr: cannot write here"),
        atomic_write("/proc/a.exr"),
    ):
        pytest.fail("the body must not run")
