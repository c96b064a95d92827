"""Signals to the program at every moment: one line, the exit code of the signal, and nothing else."""

import os
import random
import signal
import sys
import time

import pytest

from processes import Started, wait_until

LINUX = pytest.mark.skipif(sys.platform != "linux", reason="processes are found in /proc")
pytestmark = LINUX
EXPECTED = {
    signal.SIGINT: (130, "", "skinshade: interrupted\n"),
    signal.SIGTERM: (143, "", "skinshade: terminated\n"),
    signal.SIGHUP: (129, "", "skinshade: terminated\n"),
}
PROGRAM = """
import pathlib, sys, threading, time
from skinshade.cli import app, main
sys.argv = ["skinshade"]

def wait():
    pathlib.Path("ready").touch()
    time.sleep(60.0)

{definitions}
app.command_line = lambda *names, **options: run
main()
"""
"""The program with a function in place of its commands."""
IMPORTS = """
import importlib, os

class Loader:
    def create_module(self, spec):
        pass
    def exec_module(self, module):
        pathlib.Path("ready").touch()
        try:
            time.sleep(0.5)
        except KeyboardInterrupt:
            os.abort()  # as some modules in C do
        pathlib.Path("imported").touch()

class Finder:
    def find_spec(name, path, target=None):
        return importlib.machinery.ModuleSpec(name, Loader()) if name == "slow_module" else None

def run():
    sys.meta_path.insert(0, Finder)
    import slow_module
    time.sleep(60.0)
"""
WAITS = "def run():\n    wait()"
CONVERTS = """
def run():
    try:
        wait()
    except KeyboardInterrupt:
        raise ImportError("a library does not load") from None
"""
DROPS = """
class Dropping:
    def __del__(self):
        wait()

def run():
    Dropping()
    wait()
"""
REMOVES = """
def run():
    try:
        wait()
    finally:
        pathlib.Path("cleaning").touch()
        time.sleep(0.5)
        pathlib.Path("clean").touch()
"""
STUCK = """
def run():
    while True:
        try:
            wait()
        except KeyboardInterrupt:
            pass
"""
BAR = """
from skinshade.cli.progress import terminal_progress

def run():
    with terminal_progress() as progress:
        progress("work", 0.5)
        wait()
"""
STUCK_BAR = BAR.replace(
    "wait()",
    """while True:
            try:
                wait()
            except KeyboardInterrupt:
                pass""",
)
WAITS_FOR_A_THREAD = """
def run():
    threading.Thread(target=wait).start()
"""
WAITS_AT_EXIT = """
import atexit

def run():
    atexit.register(wait)
    sys.exit(2)
"""
WAITS_FOR_AN_EXECUTOR = """
from concurrent.futures import ThreadPoolExecutor

def run():
    with ThreadPoolExecutor(2) as pool:
        list(pool.map(lambda _: wait(), range(2)))
"""


def started(folder, definitions):
    run = Started(folder, "-c", PROGRAM.format(definitions=definitions))
    wait_until((folder / "ready").exists)
    return run


@pytest.mark.parametrize("number", EXPECTED)
def test_a_signal_ends_the_program_with_one_line_and_its_code(tmp_path, number):
    if signal.getsignal(number) == signal.SIG_IGN:  # as under nohup
        pytest.skip("a signal that the parent ignores stays ignored")
    run = started(tmp_path, WAITS)
    run.process.send_signal(number)
    assert run.finish() == EXPECTED[number]


@pytest.mark.parametrize(
    "definitions",
    [CONVERTS, DROPS, WAITS_FOR_A_THREAD, WAITS_AT_EXIT],
    ids=["error", "destructor", "thread", "exit"],
)
def test_an_interruption_is_one_line_whatever_it_interrupts(tmp_path, definitions):
    run = started(tmp_path, definitions)
    run.process.send_signal(signal.SIGINT)
    assert run.finish(30.0) == EXPECTED[signal.SIGINT]


def test_a_signal_during_an_import_takes_effect_after_it(tmp_path):
    run = started(tmp_path, IMPORTS)
    run.process.send_signal(signal.SIGINT)
    assert run.finish(30.0) == EXPECTED[signal.SIGINT]
    assert (tmp_path / "imported").exists()


@pytest.mark.slow
@pytest.mark.parametrize("definitions", [STUCK, WAITS_FOR_AN_EXECUTOR], ids=["stuck", "executor"])
def test_a_program_that_does_not_stop_is_ended_after_4_seconds(tmp_path, definitions):
    run = started(tmp_path, definitions)
    run.process.send_signal(signal.SIGTERM)
    start = time.monotonic()
    assert run.finish(30.0) == EXPECTED[signal.SIGTERM]
    assert time.monotonic() - start > 3.9


def test_a_second_signal_does_not_interrupt_the_clean_up(tmp_path):
    run = started(tmp_path, REMOVES)
    for number in (signal.SIGTERM, signal.SIGINT, signal.SIGTERM):
        run.process.send_signal(number)
        wait_until((tmp_path / "cleaning").exists)
    assert run.finish() == EXPECTED[signal.SIGTERM]
    assert (tmp_path / "clean").exists()


def test_signals_that_the_parent_ignores_stay_ignored(tmp_path):
    """As with nohup, or for jobs in the background of a script."""
    program = PROGRAM.format(definitions=WAITS.replace("wait()", "wait(); print('done')"))
    program = "import signal\nsignal.signal(signal.SIGHUP, signal.SIG_IGN)\n" + program
    run = Started(tmp_path, "-c", program.replace("60.0", "0.5"))
    wait_until((tmp_path / "ready").exists)
    run.process.send_signal(signal.SIGHUP)
    assert run.finish() == (0, "done\n", "")


@pytest.mark.slow
@pytest.mark.parametrize("trial", range(3))
def test_an_interruption_while_modules_are_imported_is_one_line(tmp_path, trial):
    run = Started(tmp_path, "-m", "skinshade", "lut", "shadow", "-o", "table.exr")
    run.wait_for_handler()
    time.sleep(random.Random(trial).uniform(0.0, 0.4))
    os.killpg(run.process.pid, signal.SIGINT)
    assert run.finish() == EXPECTED[signal.SIGINT]
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
@pytest.mark.parametrize("is_stuck", [False, True])
def test_an_interruption_removes_the_progress_bar_from_a_terminal(tmp_path, is_stuck):
    import pty

    terminal, end = pty.openpty()
    definitions = STUCK_BAR if is_stuck else BAR
    program = PROGRAM.format(definitions=definitions)
    run = Started(tmp_path, "-c", program, stderr=end, TERM="xterm")
    os.close(end)
    wait_until((tmp_path / "ready").exists)
    os.kill(run.process.pid, signal.SIGINT)
    output = b""
    try:
        while part := os.read(terminal, 1000):
            output += part
    except OSError:  # Linux reports the end of a terminal as an error
        pass
    os.close(terminal)
    assert run.finish()[0] == 130
    hidden, erased, shown = (
        output.rindex(code) for code in (b"\x1b[?25l", b"\x1b[2K", b"\x1b[?25h")
    )
    assert hidden < erased < shown
    assert output.endswith(b"skinshade: interrupted\r\n")
    assert output.count(b"skinshade: ") == 1
