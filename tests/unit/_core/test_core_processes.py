"""Locks of outputs, and tests whether a process is running."""

import os
import subprocess
import sys
import textwrap

import pytest

from skinshade._core.errors import OutputError
from skinshade._core.processes import LOCK_MARK, is_running, output_lock

HOLDER = textwrap.dedent("""
    import sys
    from pathlib import Path
    from skinshade._core.processes import output_lock
    with output_lock(Path(sys.argv[1])):
        print("locked", flush=True)
        sys.stdin.read()
""")


def start_holder(target):
    process = subprocess.Popen(
        [sys.executable, "-c", HOLDER, str(target)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    assert process.stdout.readline() == "locked\n"
    return process


def end(process):
    process.stdin.close()
    process.wait()
    process.stdout.close()


def test_a_second_process_learns_which_process_holds_the_lock(tmp_path):
    target = tmp_path / "head.glb"
    holder = start_holder(target)
    try:
        with (
            pytest.raises(OutputError, match=rf"head\.glb: process {holder.pid} on .* is writing"),
            output_lock(target),
        ):
            pass
        with output_lock(tmp_path / "other.glb"):
            pass
    finally:
        end(holder)
    with output_lock(target):
        pass
    assert list(tmp_path.iterdir()) == []


def test_a_killed_process_leaves_no_lock(tmp_path):
    holder = start_holder(tmp_path / "head.glb")
    holder.kill()
    holder.wait()
    holder.stdin.close()
    holder.stdout.close()
    assert [path.name[: len(LOCK_MARK)] for path in tmp_path.iterdir()] == [LOCK_MARK]
    with output_lock(tmp_path / "head.glb"):
        pass
    assert list(tmp_path.iterdir()) == []


def test_a_lock_excludes_a_second_lock_of_the_same_process(tmp_path):
    with (
        output_lock(tmp_path / "a"),
        pytest.raises(OutputError, match=f"process {os.getpid()} "),
        output_lock(tmp_path / "." / "a"),
    ):
        pass


def test_a_lock_in_a_missing_folder_is_an_output_error(tmp_path):
    with pytest.raises(OutputError, match="cannot write"), output_lock(tmp_path / "no" / "a"):
        pass


def test_a_process_is_running_until_it_ends():
    process = subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE)
    assert is_running(process.pid)
    process.stdin.close()
    process.wait()
    assert not is_running(process.pid)
    assert is_running(os.getpid())
    assert is_running(2**62)  # unknown
