"""Names of files in records and reports are relative."""

from pathlib import Path

import pytest
from hypothesis import strategies as st

from skinshade._core.errors import FileError
from skinshade.baking.names import is_local_name, without_folders

ANY_TEXT = st.text(st.characters())  # includes lone surrogates


# -- local names -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "name", ["a.glb", "parts of it/a 1.bin", "..a", "a..", ".hidden", "\udcff"]
)
def test_a_name_below_a_folder_is_local(name):
    assert is_local_name(name)


@pytest.mark.parametrize(
    "name", ["", ".", "..", "../a", "a/../../b", "a/..", "/", "/a", "//host/a"]
)
def test_a_name_that_is_absolute_or_has_a_part_of_two_dots_is_not_local(name):
    assert not is_local_name(name)


# -- folders in messages ---------------------------------------------------------------------------

MODELS, BAKED = Path("/models/2024 heads"), Path("/models/2024 heads/baked")
MESSAGES = {
    "/models/2024 heads/a/b.glb: truncated": "a/b.glb: truncated",
    "/models/2024 heads/baked/b.glb: no space": "b.glb: no space",
    "b.glb: the folder /models/2024 heads/baked does not exist": "b.glb: the folder baked does not exist",
    "b: [Errno 13] Permission denied: '/models/2024 heads/x.bin'": "b: [Errno 13] Permission denied: 'x.bin'",
    "b: file:///models/2024 heads/x.bin": "b: file://x.bin",
    "/models/2024 heads2/a.glb: other": "/models/2024 heads2/a.glb: other",
    "/old/models/2024 heads/a.glb: other": "/old/models/2024 heads/a.glb: other",
    "radius is 3 1/mm, and/or 4": "radius is 3 1/mm, and/or 4",
}


@pytest.mark.parametrize("message", MESSAGES)
def test_paths_below_the_folders_become_relative_and_other_text_stays(message):
    assert without_folders(message, (MODELS, BAKED)) == MESSAGES[message]
    assert without_folders(message, (BAKED, MODELS)) == MESSAGES[message]


def test_a_folder_whose_name_is_quoted_with_escapes_is_recognised():
    """The operating system's errors quote file names in the form of Python."""
    folder = Path("/it's\n\udcff [1]+")
    error = OSError(13, "Permission denied", str(folder / "a.glb"))
    assert "\\udcff" in str(error)
    assert without_folders(str(error), [folder]) == '[Errno 13] Permission denied: "a.glb"'


def test_a_folder_with_unsafe_characters_is_recognised_in_errors_of_skinshade():
    folder = Path("/it's\n\udcff [1]+")
    assert without_folders(str(FileError(f"{folder}/a.glb: empty")), [folder]) == "a.glb: empty"


def test_a_relative_folder_is_removed_in_both_forms(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    message = f"baked/a.glb and {tmp_path}/baked/b.glb: textures/baked/c.png is missing"
    expected = "a.glb and b.glb: textures/baked/c.png is missing"
    assert without_folders(message, [Path("baked")]) == expected


@pytest.mark.parametrize("folder", ["/", ".", ".."])
def test_folders_without_a_name_of_their_own_change_no_ellipsis_and_no_slash(folder, monkeypatch):
    monkeypatch.chdir("/")
    message = "a.glb: 1/mm, 0..1, .. and /usr/a.glb"
    assert without_folders(message, [Path(folder)]) == message
