"""Output of the program: every text can be printed, on every stream, and none controls a terminal."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
import trimesh
from cli_runs import run_all

from processes import Started, program_environment
from skinshade.cli.terminal import echo, printable

LINUX = pytest.mark.skipif(
    sys.platform != "linux", reason="the names, terminals and shell are those of Linux"
)
TEXTS = {
    "head.glb": "head.glb",
    "π×µ 頭": "π×µ 頭",
    "a\x1b[31mb": r"a\x1b[31mb",
    "a\rb\bc\td\0": r"a\rb\x08c\td\x00",
    "\x9b31m": r"\x9b31m",
    "name\udcff": r"name\udcff",
    "\u202egbl.exe": r"\u202egbl.exe",
    "a\nb\u2028c": r"a\nb\u2028c",
    "\U000e0001": r"\U000e0001",
}


def start(folder: Path, *words: str, **variables: str) -> tuple[int, str, str]:
    return Started(folder, "-m", "skinshade", *words, **variables).finish()


def write_ball(path: Path, name: str = "ball") -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    scene = trimesh.Scene()
    scene.add_geometry(trimesh.creation.icosphere(radius=0.08), geom_name=name)
    path.write_bytes(scene.export(file_type="glb"))


# -- texts -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("text", TEXTS, ids=ascii)
def test_characters_that_are_not_printable_are_escaped(text):
    assert printable(text) == TEXTS[text]
    assert printable(printable(text)) == TEXTS[text]


def test_a_message_keeps_its_line_breaks(capsys):
    echo("a\nb\x1bc")
    echo("d\re", err=True)
    assert capsys.readouterr() == ("a\nb\\x1bc\n", "d\\re\n")


CONTROLS = {
    "the name of a file": (["render", "a\x1b[31m\r.glb"], r"a\x1b[31m\r.glb: no such file"),
    "the name of a mesh": (["bake", "in.glb", "-o", "out.glb"], r"out.glb: mesh a\x1b[31m\rb, one"),
    "a command": (["pa\x1b[31mint"], r"pa\x1b[31mint"),
    "an option": (["profile", "--pa\x1b[31mint"], r"--pa\x1b[31mint"),
    "a word that is not UTF-8": (["pa\udcff\u202eint"], r"pa\udcff\u202eint"),
}


@LINUX
@pytest.mark.slow
def test_the_text_from_files_and_words_is_escaped(tmp_path):
    write_ball(tmp_path / "in.glb", "a\x1b[31m\rb")
    runs = run_all([(tmp_path, words) for words, _ in CONTROLS.values()])
    for name, outcome in zip(CONTROLS, runs, strict=True):
        text = outcome.out + outcome.err
        assert CONTROLS[name][1] in text, name
        assert "Traceback" not in text
        assert all(line.isprintable() for line in text.split("\n")), name


@LINUX
def test_the_names_of_work_do_not_become_markup_or_control_codes_in_the_bar(tmp_path):
    import pty

    terminal_, end = pty.openpty()
    script = """
from skinshade.cli.progress import terminal_progress
with terminal_progress() as progress:
    progress("[/x] [bold]a\\x1b[31mb", 0.5)
"""
    run = Started(tmp_path, "-c", script, stderr=end, TERM="xterm", COLUMNS="100")
    os.close(end)
    output = os.read(terminal_, 100_000)
    code, out, _ = run.finish()
    output += os.read(terminal_, 100_000)
    os.close(terminal_)
    assert (code, out) == (0, "")
    assert b"[/x] [bold]a\\x1b[31mb" in re.sub(rb"\x1b\[[\d;]*m", b"", output)


# -- encodings -------------------------------------------------------------------------------------

ENCODINGS = [
    {"PYTHONIOENCODING": "ascii"},
    {"LC_ALL": "C", "PYTHONCOERCECLOCALE": "0", "PYTHONUTF8": "0"},
]


@pytest.mark.slow
@pytest.mark.parametrize("variables", ENCODINGS, ids=lambda v: "-".join(v))
def test_characters_that_the_encoding_lacks_are_printed_as_escapes(tmp_path, variables):
    code, out, err = start(tmp_path, "profile", "marble", **variables)
    assert (code, err) == (0, "")
    assert r"|\u0394T| \u2264 " in out
    code, _, err = start(tmp_path, "profile", "头", **variables)
    assert code == 2
    assert re.search(r"'\\u5934'|\\udce5\\udca4\\udcb4", err)
    assert "Traceback" not in err


@LINUX
@pytest.mark.slow
def test_files_with_names_in_other_encodings_are_baked(tmp_path):
    for name in ("ä", "b\udcff", "c\x1b[31m\nd"):
        write_ball(tmp_path / "in" / f"{name}.glb")
    code, out, err = start(tmp_path, "bake", "in", "-o", "out", "--jobs", "2", **ENCODINGS[-1])
    assert (code, err) == (0, "")
    assert [line.endswith(": baked") for line in out.splitlines()] == [True] * 3 + [False]
    names = {path.name for path in (tmp_path / "out").glob("*.glb")}
    assert names == {"ä.glb", "b\udcff.glb", "c\x1b[31m\nd.glb"}


# -- streams ---------------------------------------------------------------------------------------


def shell(folder: Path, command: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [
            "bash",
            "-c",
            f"set -o pipefail; skinshade() {{ {sys.executable} -m skinshade $*; }}; {command}",
        ],
        cwd=folder,
        env=program_environment(),
        capture_output=True,
        text=True,
        check=False,
    )


@LINUX
@pytest.mark.slow
@pytest.mark.parametrize("words", ["profile", "--help"])
def test_a_pipe_whose_reader_has_ended_is_no_error_message(tmp_path, words):
    outcome = shell(tmp_path, f"skinshade {words} | true")
    assert (outcome.returncode, outcome.stderr) == (1, "")


@LINUX
def test_a_full_disk_is_an_error(tmp_path):
    reason = "No space left on device"
    for words, code in (("profile", 2), ("--help", 1)):
        outcome = shell(tmp_path, f"skinshade {words} > /dev/full")
        assert outcome.returncode == code
        assert re.fullmatch(rf"skinshade: error: .*{reason}.*\n", outcome.stderr)


@LINUX
@pytest.mark.slow
@pytest.mark.parametrize(
    ("redirections", "code"),
    [(">&-", 0), ("2>&-", 0), ("<&- >&- 2>&-", 0), ("chalk 2>&-", 2), ("chalk 2>/dev/full", 2)],
)
def test_closed_streams_change_nothing(tmp_path, redirections, code):
    outcome = shell(tmp_path, f"skinshade profile {redirections}")
    assert (outcome.returncode, outcome.stderr) == (code, "")


@LINUX
def test_no_file_gets_the_number_of_a_closed_stream():
    """Messages would be written into the file."""
    script = """
import os
from skinshade.cli.terminal import prepare_streams
os.close(1)
os.close(2)
prepare_streams()
file = open(os.devnull)
assert file.fileno() > 2
print("printed to nowhere")
"""
    command = [sys.executable, "-c", script]
    done = subprocess.run(command, env=program_environment(), check=False)
    assert done.returncode == 0


# -- lines of a library ----------------------------------------------------------------------------


@pytest.fixture
def library(tmp_path) -> Path:
    """Folder with two models and a damaged one."""
    for name in ("a", "b"):
        write_ball(tmp_path / "in" / f"{name}.glb")
    (tmp_path / "in" / "c.glb").write_bytes(b"no model")
    return tmp_path


@pytest.mark.slow
def test_a_run_into_a_pipe_prints_a_line_for_every_model_and_errors_once(library):
    folder = library / "in"
    for status in ("baked", "current"):
        code, out, err = start(library, "bake", "in", "-o", "out")
        assert code == 2
        lines = out.splitlines()
        assert lines[:2] == [f"{folder / name}: {status}" for name in ("a.glb", "b.glb")]
        assert re.fullmatch(
            r"out: . baked, . current, 1 failed; out/skinshade-bake\.json", lines[2]
        )
        failed, summary = err.splitlines()
        assert re.fullmatch(rf"{re.escape(str(folder))}/c\.glb: failed: (?!/).*", failed)
        assert summary == "skinshade: error: 1 of 3 models failed"


@LINUX
@pytest.mark.slow
def test_the_line_of_a_model_is_flushed_before_the_next_model_is_baked(library):
    write_ball(library / "in" / "z.glb")
    fifo = library / "in" / "d.obj"
    os.mkfifo(fifo)  # reading it waits for a writer
    run = Started(library, "-m", "skinshade", "bake", "in", "-o", "out", "--unit-mm", "m")
    try:
        assert run.process.stdout.readline().endswith(b"a.glb: baked\n")
        assert run.process.poll() is None
    finally:
        run.process.kill()
        run.finish()


@LINUX
@pytest.mark.slow
def test_a_terminal_shows_a_bar_and_only_the_errors_as_lines(library):
    import pty

    terminal_, end = pty.openpty()
    words = ["-m", "skinshade", "bake", "in", "-o", "out"]
    process = subprocess.Popen(
        [sys.executable, *words],
        cwd=library,
        env=program_environment() | {"TERM": "xterm", "COLUMNS": "300"},
        stdout=end,
        stderr=end,
    )
    os.close(end)
    output = b""
    try:
        while part := os.read(terminal_, 1000):
            output += part
    except OSError:  # Linux reports the end of a terminal as an error
        pass
    os.close(terminal_)
    assert process.wait() == 2
    assert "━".encode() in output
    assert b": baked" not in output
    assert output.count(b"c.glb: failed: ") == 1
