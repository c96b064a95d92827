"""Documents name files, commands, options and targets that exist, and show code that runs."""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest
import typer.main

from skinshade.cli.app import COMMANDS, command_line
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
FOLDERS = ("", "src/skinshade")
"""Folders to which paths in the text of a document are relative."""
PROGRAM = typer.main.get_command(command_line(*COMMANDS))


def code(language):
    return [
        (name, body)
        for name, text in DOCUMENTS.items()
        for kind, body in BLOCK.findall(text)
        if kind == language
    ]


def commands():
    """Return the arguments of every command in a document or the Makefile."""
    lines = [line for _, body in code("sh") for line in body.splitlines()]
    lines += [text for page in DOCUMENTS.values() for text in INLINE.findall(page)]
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8").replace("\\\n", " ")
    lines += [line.strip().removeprefix("$(BIN)/") for line in makefile.splitlines()]
    calls = [shlex.split(line, comments=True) for line in lines if line.startswith("skinshade ")]
    return sorted({tuple(call[1:]) for call in calls})


def resolved(words):
    """Return the command that words name, and the remaining words."""
    command, rest = PROGRAM, list(words)
    while rest and (nested := getattr(command, "commands", {}).get(rest[0])):
        command, rest = nested, rest[1:]
    return command, rest


# -- files and targets -----------------------------------------------------------------------------


@EVERY_DOCUMENT
def test_every_link_leads_to_a_file(name):
    links = [link for link in LINK.findall(DOCUMENTS[name]) if "://" not in link]
    assert [link for link in links if not (ROOT / name).parent.joinpath(link).exists()] == []


@EVERY_DOCUMENT
def test_every_path_in_the_text_exists(name):
    prose = BLOCK.sub("", DOCUMENTS[name])
    paths = [text for text in INLINE.findall(prose) if "/" in text and PATH.match(text)]
    exists = [any((ROOT / folder / path).exists() for folder in FOLDERS) for path in paths]
    assert [path for path, known in zip(paths, exists, strict=True) if not known] == []


@EVERY_DOCUMENT
def test_every_named_make_target_exists(name):
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    targets = set(re.findall(r"^([a-z]+):", makefile, re.MULTILINE))
    named = re.findall(r"(?:^|`)make ([a-z]+)", DOCUMENTS[name], re.MULTILINE)
    assert set(named) <= targets


def test_every_document_with_a_cited_section_exists():
    cited = {}
    for folder, suffix in (("src", "py"), ("tests", "py"), ("docs", "md"), ("benchmarks", "py")):
        for path in sorted((ROOT / folder).rglob(f"*.{suffix}")):
            for document in re.findall(r"\b([A-Z]{4,})(?:\.md)? §", path.read_text("utf-8")):
                cited.setdefault(document, []).append(path.name)
    names = {Path(name).stem.upper() for name in DOCUMENTS}
    assert {name: files for name, files in cited.items() if name not in names} == {}


# -- commands --------------------------------------------------------------------------------------


def test_the_documents_contain_commands():
    assert {"render", "profile", "lut", "assets"} <= {words[0] for words in commands()}


@pytest.mark.parametrize("words", commands(), ids=" ".join)
def test_every_command_and_option_in_a_document_exists(words):
    command, rest = resolved(words)
    assert not hasattr(command, "commands") or not rest, f"{words}: no such command"
    known = {o for p in command.params for o in (*p.opts, *p.secondary_opts)}
    used = {word.partition("=")[0] for word in rest if re.match(r"--?[a-z]", word)}
    assert used <= known


@pytest.mark.parametrize("words", [w for w in commands() if len(w) > 1], ids=" ".join)
def test_every_value_in_a_document_is_accepted_by_its_command(words):
    command, rest = resolved(words)
    with command.make_context("skinshade", rest) as context:
        assert context.command is command


def test_every_command_appears_in_a_document():
    prose = "\n".join(DOCUMENTS.values())
    for name in PROGRAM.commands:
        assert re.search(rf"\bskinshade {name}\b|`{name}`", prose), name


# -- code ------------------------------------------------------------------------------------------


def test_the_readme_has_code():
    assert [name for name, _ in code("python")] == ["README.md"]


@pytest.mark.slow
def test_the_code_of_the_readme_runs_and_its_comments_are_true(tmp_path):
    ((_, program),) = code("python")
    program += (
        "\nprint(image.shape, image.dtype, lut.values.shape, curvature.shape, len(mesh.faces))"
    )
    command = [sys.executable, "-W", "error", "-c", program]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    promised = re.search(r"render\(.*# (\([\d, ]+\)) linear (\w+)", program)
    assert done.stdout.startswith(f"{promised[1]} {promised[2]} (512, 512, 3)")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["curvature.exr", "head.png"]
    assert Lut.load(tmp_path / "curvature.exr").kind == "curvature"
