"""The program: its commands, their help, and its exit codes."""

from __future__ import annotations

import re
import subprocess
import sys
import warnings

import pytest
from cli_runs import Run, contents, run, run_all
from typer.main import get_command

import skinshade
from skinshade._core.errors import ArgumentError, BackendError, UnitWarning
from skinshade.cli import app
from skinshade.cli.app import COMMANDS, command_line
from skinshade.heads import SCANS
from skinshade.params.choices import Shading, Tier, View
from skinshade.profile import presets

SUBCOMMANDS = {"lut": ["curvature", "shadow"], "shaders": ["export"], "assets": ["list", "get"]}
HELPED = [[], *([name] for name in COMMANDS)]
HELPED += [[group, name] for group, names in SUBCOMMANDS.items() for name in names]
NAMES = [" ".join(words) for words in HELPED]


# -- help ------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def helped(tmp_path_factory) -> dict[str, Run]:
    """Runs of every command with ``--help``, in empty folders."""
    folders = [tmp_path_factory.mktemp("help") for _ in HELPED]
    requests = [[*words, "--help"] for words in HELPED]
    return dict(zip(NAMES, run_all(list(zip(folders, requests, strict=True))), strict=True))


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_every_command_has_a_help(helped, name):
    outcome = helped[name]
    assert (outcome.code, outcome.err) == (0, "")
    assert re.search(rf"Usage: (python -m )?skinshade {name}".rstrip(), outcome.out)
    assert outcome.after == {}


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES[1:])
def test_the_help_shows_every_option_with_a_text(helped, name):
    words = name.split(" ")
    command = get_command(command_line(words[0]))
    for word in words:
        command = command.commands[word]
    options = [p for p in command.params if p.param_type_name == "option"]
    for option in options:
        assert option.help, option.name
        assert option.opts[0] in helped[name].out
    assert "--help" in helped[name].out


@pytest.mark.slow
def test_the_help_of_render_lists_the_values_and_the_groups_of_its_options(helped):
    text = helped["render"].out
    for choice in (Shading, Tier):
        assert "|".join(choice) in text
    assert all(view in re.sub(r"[^\w|-]", "", text) for view in View)
    for title in ("Lighting model and sampling", "Camera and light", "Material"):
        assert f"─ {title} ─" in text


@pytest.mark.parametrize("name", COMMANDS)
def test_the_list_of_commands_shows_the_help_of_the_command(name):
    """The list is written without importing the commands, whose docstrings say the same."""
    listed, imported = (get_command(command_line(*names)).commands[name] for names in ((), (name,)))
    assert listed.help == imported.help == COMMANDS[name].help
    if name not in SUBCOMMANDS:
        assert imported.callback.__doc__ == COMMANDS[name].help
    else:
        assert sorted(imported.commands) == sorted(SUBCOMMANDS[name])


def test_the_list_of_commands_appears_without_numpy():
    script = "import sys; sys.argv = ['skinshade', '--help']\nfrom skinshade.cli import main\n"
    script += "try:\n    main()\nexcept SystemExit:\n    print('numpy' in sys.modules)"
    process = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, encoding="utf-8", check=True
    )
    assert process.stdout.splitlines()[-1] == "False"
    assert "doctor" in process.stdout


# -- runs without input ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["--version"], [f"skinshade {skinshade.__version__}"]),
        (["profile"], presets()),
        (["assets", "list"], [*SCANS, SCANS["lee-perry-smith"].credit]),
        (["doctor"], ["numpy", "OpenImageIO", "backend cpu", "backend gpu"]),
    ],
    ids=lambda value: "-".join(value).strip("-") if isinstance(value, list) else None,
)
def test_a_command_without_input_prints_what_it_knows(tmp_path, words, expected):
    outcome = run(tmp_path, *words)
    assert outcome.code == 0, outcome.err
    assert [word for word in expected if word not in outcome.out] == []
    assert outcome.err == ""
    assert contents(tmp_path) == {}


@pytest.mark.parametrize("words", [[], ["lut"], ["shaders"], ["assets"]], ids=" ".join)
def test_a_missing_command_shows_the_help_with_exit_code_2(tmp_path, words):
    outcome = run(tmp_path, *words)
    assert outcome.code == 2
    assert "Usage: " in outcome.out + outcome.err
    assert (SUBCOMMANDS[words[0]][0] if words else "render") in outcome.out + outcome.err


@pytest.mark.parametrize("words", [["paint"], ["lut", "paint"], ["--paint"]], ids=" ".join)
def test_an_unknown_command_is_named_with_exit_code_2(tmp_path, words):
    outcome = run(tmp_path, *words)
    assert outcome.code == 2
    assert words[-1] in outcome.err
    assert "Traceback" not in outcome.err


# -- errors ----------------------------------------------------------------------------------------


def run_app(monkeypatch, program, words):
    """Run `app.run` with another program in place of the commands."""
    monkeypatch.setattr(app, "command_line", program)
    monkeypatch.setattr(sys, "argv", ["skinshade", *words])
    monkeypatch.setattr(warnings, "showwarning", warnings.showwarning)  # restored after the test
    app.run()


ERRORS = [
    (ArgumentError("gloss is 2"), 2, "gloss is 2"),
    (BackendError("no adapter"), 1, "no adapter"),
    (MemoryError(), 1, "out of memory; a smaller --size or fewer --samples need less"),
    (RuntimeError("a fault"), 1, "internal error: RuntimeError: a fault"),
    (OSError(5, "Input/output error"), 1, "internal error: OSError: "),
    (OSError(36, "File name too long", "a.glb"), 2, "a.glb: File name too long"),
    (OSError(36, "File name too long", b"a.glb"), 2, "a.glb: File name too long"),
    (ArgumentError("\x1b[31m\r"), 2, r"\x1b[31m\r"),
]


@pytest.mark.parametrize(("error", "code", "message"), ERRORS, ids=lambda value: str(value)[:20])
def test_an_error_is_one_line_with_its_exit_code(monkeypatch, capsys, error, code, message):
    def program(*_, **__):
        raise error

    with pytest.raises(SystemExit) as caught:
        run_app(monkeypatch, program, ["render"])
    assert caught.value.code == code
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith(f"skinshade: error: {message}")
    assert err.count("\n") == 1


def test_a_warning_about_units_is_one_line_and_others_are_not_shown(capsys):
    app._show_warning("a grain of sand", UnitWarning, "file.py", 1)
    app._show_warning("a deprecated call", DeprecationWarning, "file.py", 1)
    assert capsys.readouterr().err == "skinshade: warning: a grain of sand\n"


@pytest.mark.parametrize(
    ("words", "name"),
    [
        (["render", "--size", "2x2"], "render"),
        (["--version", "render"], "render"),
        (["--help"], ""),
        (["--version"], ""),
        ([], ""),
    ],
)
def test_only_the_requested_command_is_imported(monkeypatch, words, name):
    requested = []

    def program(*names, **_):
        requested.extend(names)
        return lambda: None

    run_app(monkeypatch, program, words)
    assert requested == [name]
