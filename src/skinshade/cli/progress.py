"""Progress bar on a terminal."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager

from .._core.progress import Progress, silent

__all__ = ["terminal_progress"]


@contextmanager
def terminal_progress() -> Iterator[Progress]:
    """Yield a callback that draws a progress bar on standard error if that is a terminal."""
    if not sys.stderr.isatty():
        yield silent
        return
    from rich.console import Console
    from rich.progress import BarColumn, TextColumn, TimeElapsedColumn
    from rich.progress import Progress as Bar

    columns = TextColumn("{task.description:<28}"), BarColumn(), TimeElapsedColumn()
    with Bar(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("", total=1.0)

        def show(work: str, fraction: float) -> None:
            bar.update(task, description=work, completed=fraction)

        yield show
