"""``python -m fuzz``: read changed files for some time, and report what no reader may do.

Exit codes: 0 without findings, 1 with findings, 2 if the request is at fault.
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path

from rich.console import Console
from rich.table import Table

from .campaign import Campaign
from .findings import Findings, read_finding

ROOT = Path(__file__).resolve().parents[1]
MEMORY_FOLDER = Path("/dev/shm")
"""File system in memory: a bake flushes every file to the disk."""
STEP = 0.5
"""Time between two updates of the line of progress, s."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the fuzzer, and return its exit code."""
    options = _parser().parse_args(arguments)
    if sys.platform == "win32":
        print("the fuzzer needs the signals and limits of Linux or macOS", file=sys.stderr)
        return 2
    from .seeds import companions, honest_files
    from .targets import TARGETS

    unknown = set(options.target) - TARGETS.keys()
    if unknown:
        print(
            f"there is no target {min(unknown)!r}; there are {', '.join(TARGETS)}", file=sys.stderr
        )
        return 2
    console = Console(highlight=False)
    findings = Findings(options.findings)
    seeds = honest_files()
    beside = {form: companions(form) for form in seeds}
    base = MEMORY_FOLDER if MEMORY_FOLDER.is_dir() else None
    with tempfile.TemporaryDirectory(dir=base) as folder:
        campaign = Campaign(
            Path(folder).resolve(), findings, seeds, beside, seed=options.seed, only=options.target
        )
        if options.replay:
            return _replayed(campaign, options.replay, console)
        if options.engine == "atheris":
            from .guided import run_guided

            with console.status(f"{options.seconds:.0f} s"):
                run_guided(campaign, options.seconds, Path(folder).resolve())
        else:
            _run(campaign, options.seconds, console)
    _print_report(campaign, console)
    return 1 if findings.by_key else 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        "python -m fuzz", description="Fuzz every reader of skinshade."
    )
    parser.add_argument(
        "--seconds", type=float, default=600.0, help="duration (default: %(default)s)"
    )
    parser.add_argument(
        "--seed", type=int, default=0, help="number that decides the cases (default: 0)"
    )
    parser.add_argument(
        "--target", action="append", default=[], help="run only this target; can be repeated"
    )
    parser.add_argument(
        "--replay", type=Path, nargs="+", help="run the files of earlier findings again"
    )
    parser.add_argument(
        "--findings",
        type=Path,
        default=ROOT / "fuzz" / "findings",
        help="folder of the findings (default: fuzz/findings)",
    )
    parser.add_argument(
        "--engine",
        choices=("plain", "atheris"),
        default="plain",
        help="atheris is guided by coverage; it needs the extra 'fuzz'",
    )
    return parser


def _run(campaign: Campaign, seconds: float, console: Console) -> None:
    started = last = time.monotonic()
    with console.status("starting") as status:

        def show(count: int) -> None:
            nonlocal last
            now = time.monotonic()
            if now - last >= STEP:
                last = now
                rate = count / (now - started)
                known = len(campaign.findings.by_key)
                status.update(
                    f"{now - started:.0f} s, {count:,} cases, {rate:.0f}/s, {known} findings"
                )

        try:
            campaign.run(seconds, report=show)
        except KeyboardInterrupt:
            console.print("interrupted")


def _replayed(campaign: Campaign, files: Sequence[Path], console: Console) -> int:
    """Run the files of findings again; return 1 if one of them is still at fault."""
    code = 0
    with campaign.worker:
        for file in files:
            outcome = campaign.worker.run(read_finding(file))
            if outcome.fault is None:
                console.print(f"{file}: {outcome.signature or 'accepted'}", markup=False)
                continue
            code = 1
            fault = outcome.fault
            console.print(
                f"{file}: {fault.kind} at {fault.location}: {fault.message}", markup=False
            )
            console.print(fault.details, markup=False)
    return code


def _print_report(campaign: Campaign, console: Console) -> None:
    table = Table(box=None, pad_edge=False)
    for name in ("target", "cases", "accepted", "findings", "cases/s"):
        table.add_column(name, justify="left" if name == "target" else "right")
    table.add_column("errors", overflow="fold")
    for name, tally in campaign.tallies.items():
        errors = ", ".join(f"{kind} {count:,}" for kind, count in tally.errors.most_common())
        rate = tally.cases / tally.seconds if tally.seconds else 0.0
        numbers = (tally.cases, tally.accepted, tally.findings, rate)
        table.add_row(name, *(f"{number:,.0f}" for number in numbers), errors)
    cases = sum(tally.cases for tally in campaign.tallies.values())
    seconds = sum(tally.seconds for tally in campaign.tallies.values())
    console.print(table)
    times = os.times()
    whole = times.user + times.system + times.children_user + times.children_system
    console.print(
        f"{cases:,} cases in {whole:.0f} s of processor time ({cases / whole:.0f}/s), {seconds:.0f} s of them"
        f" in the readers; {campaign.worker.starts} starts of the worker"
    )
    for finding in campaign.findings.by_key.values():
        fault = finding.fault
        console.print(
            f"{finding.count:,} × {fault.kind} at {fault.location}: {fault.message[:200]}",
            markup=False,
        )
    if campaign.findings.by_key:
        console.print(f"see {campaign.findings.folder}", markup=False)


if __name__ == "__main__":
    sys.exit(main())
