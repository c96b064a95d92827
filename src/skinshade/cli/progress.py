"""Progress bar on a terminal."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager

from .._core.progress import Progress, silent
from .terminal import printable

__all__ = ["has_bar", "terminal_progress"]


def has_bar() -> bool:
    """Return whether `terminal_progress` draws a bar."""
    return sys.stderr is not None and sys.stderr.isatty()


@contextmanager
def terminal_progress() -> Iterator[Progress]:
    """Yield a callback that draws a progress bar on standard error if that is a terminal."""
    if not has_bar():
        yield silent
        return
    from rich.console import Console
    from rich.progress import BarColumn, TextColumn, TimeElapsedColumn
    from rich.progress import Progress as Bar

    columns = TextColumn("{task.description:<28}", markup=False), BarColumn(), TimeElapsedColumn()
    # Text for standard output passes through the bar only if both appear on the same terminal.
    is_terminal = sys.stdout is not None and sys.stdout.isatty()
    console = Console(stderr=True)
    with Bar(*columns, console=console, transient=True, redirect_stdout=is_terminal) as bar:
        task = bar.add_task("", total=1.0)

        def show(work: str, fraction: float) -> None:
            bar.update(task, description=printable(work), completed=fraction)

        yield show
