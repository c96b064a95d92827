from dataclasses import dataclass, field
from typing import Annotated

import pytest
import typer
from typer.testing import CliRunner

from skinshade.cli.options import expand_options


@dataclass(frozen=True)
class Paint:
    """Colour of the paint.

    Further lines are not part of the title.
    """

    colour: Annotated[str, typer.Option(help="Name of the colour.")]
    layers: Annotated[int, typer.Option(help="Number of layers.")] = 2
    tags: Annotated[list[str], typer.Option(help="Tags.")] = field(default_factory=list)


@pytest.fixture
def command():
    """A command with a group of options, and the values of its last run."""
    values = {}

    @expand_options
    def paint_command(
        *,
        wall: Annotated[str, typer.Argument(help="Wall to paint.")],
        paint: Paint,
        quick: Annotated[bool, typer.Option("--quick", help="Do it quickly.")] = False,
    ) -> None:
        """Paint a wall."""
        values.update(wall=wall, paint=paint, quick=quick)

    app = typer.Typer()
    app.command()(paint_command)
    return app, values


def test_options_of_a_group_become_one_object(command):
    app, values = command
    words = ["north", "--colour", "red", "--layers", "3", "--tags", "a", "--tags", "b", "--quick"]
    result = CliRunner().invoke(app, words)
    assert result.exit_code == 0, result.output
    assert values == {"wall": "north", "paint": Paint("red", 3, ["a", "b"]), "quick": True}


def test_options_that_are_not_given_have_the_defaults_of_the_group(command):
    app, values = command
    assert CliRunner().invoke(app, ["north", "--colour", "red"]).exit_code == 0
    assert values["paint"] == Paint("red")


def test_an_option_without_default_is_required(command):
    app, values = command
    result = CliRunner().invoke(app, ["north"])
    assert result.exit_code == 2
    assert "--colour" in result.output
    assert values == {}


def test_the_help_shows_the_first_line_of_the_group_as_title(command):
    result = CliRunner().invoke(command[0], ["--help"], env={"COLUMNS": "100", "NO_COLOR": "1"})
    assert "Paint a wall." in result.output
    assert "─ Colour of the paint ─" in result.output
    assert "Further lines" not in result.output
    for text in ("Name of the colour.", "Number of layers.", "Do it quickly.", "Wall to paint."):
        assert text in result.output
