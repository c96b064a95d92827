"""Loading the compiled kernels, the checks at their boundary, and their threads."""

import os
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from native_twins import needs_library, threads
from skinshade._core import native
from skinshade._core.errors import ArgumentError, SkinshadeError
from skinshade._core.native_sources import FOLDER, library_name, source_hash

C_TYPES = {
    "int32": ["int32_t"],
    "int64": ["int64_t"],
    "double": ["double"],
    "range": ["int64_t", "int64_t"],
    "points": ["void*", "int32_t"],
    "faces": ["void*", "int32_t"],
    "rows": ["void*", "int32_t"],
    "float*": ["float*"],
    "double*": ["double*"],
    "uint8*": ["uint8_t*"],
    "uint32*": ["uint32_t*"],
    "uint64*": ["uint64_t*"],
    "int64*": ["int64_t*"],
}


def in_process(program, **variables):
    """Return the output of a program in a new process with environment variables."""
    command = [sys.executable, "-c", program]
    environment = os.environ | variables
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    return done.stdout.strip()


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """Copy of the folder of sources without a library, which is looked up again."""
    for path in FOLDER.glob("*.[ch]"):
        shutil.copy(path, tmp_path)
    monkeypatch.setattr(native, "FOLDER", tmp_path)
    monkeypatch.delenv(native.SWITCH, raising=False)
    native._state.cache_clear()
    yield tmp_path
    native._state.cache_clear()


# -- loading ---------------------------------------------------------------------------------------


def test_without_a_library_the_reason_names_the_command_that_compiles_it(folder):
    assert not native.available()
    assert native.reason().startswith(f"no library: {library_name(source_hash(folder))} does not")
    assert native.reason().endswith("run `make native`")


def test_a_library_of_other_sources_is_named_and_not_loaded(folder):
    (folder / library_name("0" * 16)).touch()
    assert not native.available()
    assert f"{library_name('0' * 16)} is compiled from other sources" in native.reason()


def test_a_damaged_library_is_not_loaded(folder):
    (folder / library_name(source_hash(folder))).write_bytes(b"not a library")
    assert not native.available()
    assert native.reason().startswith("no library: ")


@needs_library
def test_a_library_whose_hash_differs_from_its_name_is_not_loaded(folder):
    with (folder / "abi.c").open("a") as stream:
        stream.write("/* changed */\n")
    changed = source_hash(folder)
    shutil.copy(FOLDER / library_name(source_hash(FOLDER)), folder / library_name(changed))
    assert not native.available()
    assert "is compiled from other sources" in native.reason()


@needs_library
def test_a_library_without_a_kernel_is_not_loaded(monkeypatch):
    monkeypatch.setitem(native.KERNELS, "no_such_kernel", "range")
    with pytest.raises(SkinshadeError, match="no_such_kernel"):
        native.Library.load(native.library_path(), source_hash())


def test_the_switch_chooses_numpy():
    program = "from skinshade._core import native; print(native.available(), native.reason())"
    assert in_process(program, SKINSHADE_NATIVE="0") == "False SKINSHADE_NATIVE=0"


@needs_library
def test_the_switch_can_name_the_folder_of_the_library(tmp_path):
    program = "from skinshade._core import native; print(native.available(), native.reason())"
    assert in_process(program, SKINSHADE_NATIVE=str(tmp_path)).startswith("False no library: ")
    shutil.copy(native.library_path(), tmp_path)
    assert in_process(program, SKINSHADE_NATIVE=str(tmp_path)).startswith("True compiled, ")


def test_the_import_of_mesh_analysis_does_not_load_the_library():
    program = "import skinshade.mesh; from skinshade._core import native; "
    program += "print(native._state.cache_info().currsize)"
    assert in_process(program) == "0"


def test_the_hash_does_not_depend_on_line_ends(folder):
    before = source_hash(folder)
    for path in folder.glob("*.[ch]"):
        path.write_bytes(path.read_bytes().replace(b"\n", b"\r\n"))
    assert source_hash(folder) == before


@pytest.mark.parametrize(
    ("platform", "name"),
    [
        ("linux", "libskinshade_native-1.so"),
        ("darwin", "libskinshade_native-1.dylib"),
        ("win32", "skinshade_native-1.dll"),
    ],
)
def test_the_library_has_the_name_of_its_system(platform, name):
    assert library_name("1", platform) == name


# -- the table of kernels --------------------------------------------------------------------------


def declarations():
    """Return result and parameter types of the kernels in kernels.h."""
    text = (FOLDER / "kernels.h").read_text(encoding="utf-8")
    found = {}
    for result, name, parameters in re.findall(
        r"SKN_EXPORT (\w+) SKN\((\w+)\)\(([^;]*)\);", text, re.DOTALL
    ):
        types = [
            re.sub(r"\s+", "", re.sub(r"\bconst\b|\w+$", "", parameter.strip()))
            for parameter in parameters.split(",")
        ]
        found[name] = result, types
    return found


def test_the_table_of_kernels_is_that_of_the_header():
    table = {}
    for name, text in native.KERNELS.items():
        result = "int64_t" if text.startswith("int64:") else "void"
        words = [word.rstrip("?") for word in native._parameters(name)]
        table[name] = result, [kind for word in words for kind in C_TYPES[word]]
    assert declarations() == table


# -- arguments -------------------------------------------------------------------------------------


@needs_library
@pytest.mark.parametrize(
    ("points", "faces", "areas"),
    [
        (np.zeros((3, 3), dtype=np.int64), np.zeros((1, 3), dtype=np.int64), np.zeros(1)),
        (np.zeros((3, 3)), np.zeros((1, 3), dtype=np.uint16), np.zeros(1)),
        (np.zeros((3, 3)), np.zeros((1, 3), dtype=np.int64), np.zeros(1, dtype=np.float32)),
        (np.zeros((3, 6))[:, ::2], np.zeros((1, 3), dtype=np.int64), np.zeros(1)),
        (None, np.zeros((1, 3), dtype=np.int64), np.zeros(1)),
        (np.zeros((3, 3)), [[0, 1, 2]], np.zeros(1)),
    ],
    ids=["points", "faces", "result", "strides", "none", "list"],
)
def test_arrays_of_other_types_or_with_gaps_are_refused(points, faces, areas):
    with pytest.raises(ArgumentError, match="face_areas"):
        native.run("face_areas", [0, 1], points, faces, areas)


@needs_library
def test_the_number_of_arguments_is_checked():
    with pytest.raises(ArgumentError, match="has 3 arguments, not 1"):
        native.run("face_areas", [0, 1], np.zeros((3, 3)))


def test_a_kernel_that_is_not_in_use_names_the_reason(monkeypatch):
    monkeypatch.setattr(native, "_state", lambda: (None, "no compiler"))
    with pytest.raises(SkinshadeError, match=r"face_areas: .*no compiler"):
        native.run("face_areas", [0, 1])


# -- ranges and threads ----------------------------------------------------------------------------

VALUES = np.random.default_rng(1).integers(0, 1000, (50_000, 3))


def counts_at_least(limit):
    """Return the positions of the first index that is not below a limit, by ranges of 1000."""
    bounds = list(range(0, VALUES.size + 1, 1000))
    return native.run("first_bad_index", bounds, VALUES, limit)


def expected_at_least(limit):
    blocks = VALUES.reshape(-1, 1000) >= limit
    first = blocks.argmax(axis=1) + 1000 * np.arange(len(blocks))
    return np.where(blocks.any(axis=1), first, -1).tolist()


@needs_library
@pytest.mark.parametrize("count", [1, 2, 7])
def test_results_are_in_the_order_of_the_ranges(count):
    with threads(count):
        assert counts_at_least(990) == expected_at_least(990)


@needs_library
def test_kernels_run_in_threads_of_the_caller():
    with threads(4), ThreadPoolExecutor(8) as pool:
        results = list(pool.map(lambda _: counts_at_least(990), range(32)))
    assert results == [expected_at_least(990)] * 32


@needs_library
@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork on this system")
def test_kernels_run_in_a_forked_process():
    program = """
import os, warnings
import numpy as np
from skinshade._core import native
native.thread_count = lambda: 3
warnings.simplefilter("ignore", DeprecationWarning)
faces = np.zeros((90_000, 3), dtype=np.int64)
check = lambda: native.run("first_bad_index", native.blocks(faces.size), faces, 1)
before = check()
child = os.fork()
if child == 0:
    os._exit(0 if check() == before else 1)
print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
"""
    assert in_process(program) == "0"


@pytest.mark.parametrize("count", [0, 1, 5, 100_000])
def test_ranges_cover_all_elements_once(count):
    for bounds in (native.blocks(count), native.parts(count), native.blocks(count, 1)):
        assert bounds[0] == 0
        assert bounds[-1] == count
        assert bounds == sorted(bounds)
        assert len(bounds) >= 2
