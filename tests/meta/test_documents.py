"""What the documents say is there: files, commands, options, targets, and code that runs."""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
from pathlib import Path

import click
import pytest
import typer.main

from skinshade.cli.app import app
from skinshade.lut import Lut

ROOT = Path(__file__).resolve().parents[2]
DOCUMENTS = {
    str(path.relative_to(ROOT)): path.read_text(encoding="utf-8")
    for path in (*sorted(ROOT.glob("*.md")), *sorted((ROOT / "docs").rglob("*.md")))
}
EVERY_DOCUMENT = pytest.mark.parametrize("name", DOCUMENTS)
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\(([^)#\s]+)[^)]*\)")
INLINE = re.compile(r"`([^`\n]+)`")
PATH = re.compile(r"^[\w-][\w.-]*(/[\w.-]+)*/?$")
HOMES = ("", "src/skinshade")
"""Where a path begins that a document names in passing."""


def code(language):
    return [
        (name, body)
        for name, text in DOCUMENTS.items()
        for kind, body in BLOCK.findall(text)
        if kind == language
    ]


def commands():
    """Each command line that a document or the Makefile shows, without its comment."""
    shown = [line for _, body in code("sh") for line in body.splitlines()]
    shown += [text for page in DOCUMENTS.values() for text in INLINE.findall(page)]
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8").replace("\\\n", " ")
    shown += [line.strip().removeprefix("$(BIN)/") for line in makefile.splitlines()]
    lines = [shlex.split(line, comments=True) for line in shown if line.startswith("skinshade ")]
    return sorted({tuple(line[1:]) for line in lines})


def resolved(words):
    """The command that words name, and the words left over for it."""
    command, rest = typer.main.get_command(app), list(words)
    context = click.Context(command)
    while rest and (nested := getattr(command, "commands", {}).get(rest[0])):
        command, rest = nested, rest[1:]
        context = click.Context(command, info_name=words[0], parent=context)
    return command, rest


# -- files and targets -----------------------------------------------------------------------------


@EVERY_DOCUMENT
def test_every_link_to_a_file_leads_to_one(name):
    links = [link for link in LINK.findall(DOCUMENTS[name]) if "://" not in link]
    assert [link for link in links if not (ROOT / name).parent.joinpath(link).exists()] == []


@EVERY_DOCUMENT
def test_every_path_that_is_named_in_passing_is_there(name):
    prose = BLOCK.sub("", DOCUMENTS[name])
    paths = [text for text in INLINE.findall(prose) if "/" in text and PATH.match(text)]
    there = [any((ROOT / home / path).exists() for home in HOMES) for path in paths]
    assert [path for path, found in zip(paths, there, strict=True) if not found] == []


@EVERY_DOCUMENT
def test_every_make_target_that_is_named_is_one(name):
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    targets = set(re.findall(r"^([a-z]+):", makefile, re.MULTILINE))
    named = re.findall(r"(?:^|`)make ([a-z]+)", DOCUMENTS[name], re.MULTILINE)
    assert set(named) <= targets


def test_every_document_that_is_cited_by_its_section_is_in_the_repository():
    """``MODEL §2`` is of use only to who has it."""
    cited = {}
    for folder, suffix in (("src", "py"), ("tests", "py"), ("docs", "md"), ("benchmarks", "py")):
        for path in sorted((ROOT / folder).rglob(f"*.{suffix}")):
            for document in re.findall(r"\b([A-Z]{4,})(?:\.md)? §", path.read_text("utf-8")):
                cited.setdefault(document, []).append(path.name)
    there = {Path(name).stem.upper() for name in DOCUMENTS}
    assert {name: places for name, places in cited.items() if name not in there} == {}


# -- commands --------------------------------------------------------------------------------------


def test_the_documents_show_the_commands():
    shown = {words[0] for words in commands()}
    assert {"render", "profile", "lut", "assets"} <= shown


@pytest.mark.parametrize("words", commands(), ids=" ".join)
def test_every_command_and_option_that_is_shown_is_there(words):
    command, rest = resolved(words)
    assert not hasattr(command, "commands") or not rest, f"{words}: no such command"
    known = {o for p in command.params for o in (*p.opts, *p.secondary_opts)}
    used = {word.partition("=")[0] for word in rest if re.match(r"--?[a-z]", word)}
    assert used <= known


@pytest.mark.parametrize("words", [w for w in commands() if len(w) > 1], ids=" ".join)
def test_every_value_that_is_shown_is_one_that_the_command_takes(words):
    command, rest = resolved(words)
    with command.make_context("skinshade", rest) as context:
        assert context.command is command


def test_every_command_is_shown_by_a_document():
    prose = "\n".join(DOCUMENTS.values())
    for name in typer.main.get_command(app).commands:
        assert re.search(rf"\bskinshade {name}\b|`{name}`", prose), name


# -- code ------------------------------------------------------------------------------------------


def test_the_readme_has_code_that_is_run_here():
    assert [name for name, _ in code("python")] == ["README.md"]


@pytest.mark.slow
def test_the_code_of_the_readme_runs_and_does_what_its_comments_say(tmp_path):
    ((_, program),) = code("python")
    program += (
        "\nprint(image.shape, image.dtype, lut.values.shape, curvature.shape, len(mesh.faces))"
    )
    command = [sys.executable, "-W", "error", "-c", program]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    promised = re.search(r"render\(.*# (\([\d, ]+\)) linear (\w+)", program)
    assert done.stdout.startswith(f"{promised[1]} {promised[2]} (512, 512, 3)")
    assert [path.name for path in tmp_path.iterdir()] == ["curvature.exr"]
    assert Lut.load(tmp_path / "curvature.exr").kind == "curvature"
