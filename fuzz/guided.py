"""The loop of the fuzzer with atheris, which keeps every file that reaches new lines of the package.

Atheris ends its process, so that every target and format has one. Its extra is ``fuzz``.
"""

from __future__ import annotations

import importlib
import multiprocessing
import os
import sys
import time
from collections.abc import Mapping, Sequence
from importlib.util import find_spec
from multiprocessing.connection import Connection
from pathlib import Path
from random import Random
from typing import Any

from .campaign import Campaign
from .case import Case, Fault, Limits, Outcome
from .mutations import LARGEST_CASE, mutated
from .worker import child_runner, sendable

__all__ = ["run_guided"]

SLACK = 20.0
"""Time after its end in which a process must end, s."""


def run_guided(campaign: Campaign, seconds: float, folder: Path) -> None:
    """Run every target and format for its share of the time, and count the cases in the campaign.

    Raises
    ------
    RuntimeError
        If atheris is not installed, or a process ends before its first case.
    """
    if find_spec("atheris") is None:
        raise RuntimeError('atheris is not installed: pip install "skinshade[fuzz]"')
    parts = [
        (name, form, target.weight / len(target.forms))
        for name, target in campaign.targets.items()
        for form in target.forms
    ]
    whole = sum(weight for _, _, weight in parts)
    for number, (name, form, weight) in enumerate(parts):
        duration = max(seconds * weight / whole, 1.0)
        _run_part(campaign, name, form, duration, folder / f"part{number}")


def _run_part(campaign: Campaign, name: str, form: str, seconds: float, folder: Path) -> None:
    folder.mkdir()
    context = multiprocessing.get_context("spawn")
    connection, other = context.Pipe()
    worker = campaign.worker
    arguments = (other, folder, worker.module, name, form, campaign.honest[form], worker.companions)
    process = context.Process(
        target=_fuzz, args=(*arguments, worker.limits, seconds, campaign.seed), daemon=True
    )
    process.start()
    other.close()
    last, count = Case(name, form, b""), 0
    end = time.monotonic() + seconds + SLACK
    try:
        while connection.poll(max(end - time.monotonic(), 0.0)):
            data, outcome = connection.recv()
            last = Case(name, form, data)
            if outcome is not None:
                campaign.count(last, outcome)
                count += 1
    except EOFError:
        pass
    process.join(1.0)
    if process.exitcode is None:
        process.kill()
        process.join()
    text = (folder / "log.txt").read_text(encoding="utf-8", errors="replace")
    if not count:
        raise RuntimeError(f"{name} ({form}): atheris ran no case: {text[-2000:]}")
    if process.exitcode:  # the process ended within its last case
        fault = Fault("exit", name, f"atheris ended with {process.exitcode}", text[-20_000:])
        campaign.count(last, Outcome(fault=fault))


def _fuzz(
    connection: Connection,
    folder: Path,
    module: str,
    name: str,
    form: str,
    honest: Sequence[bytes],
    companions: Mapping[str, Mapping[str, bytes]],
    limits: Limits,
    seconds: float,
    seed: int,
) -> None:
    """Fuzz one target; the process ends with the last case."""
    import atheris

    corpus = folder / "corpus"
    corpus.mkdir()
    for number, data in enumerate(honest):
        (corpus / str(number)).write_bytes(data)
    with (folder / "log.txt").open("wb") as log:
        os.dup2(log.fileno(), 2)
    with atheris.instrument_imports(include=["skinshade"]):
        importlib.import_module(module)
    runners: list[Any] = []

    def run(data: bytes) -> None:
        if not data:
            return
        if not runners:  # atheris has its own copies of standard output and error now
            runners.append(child_runner(folder, module, companions, limits))
            cases = [Case(name, form, content) for content in honest]
            problem = runners[0].read_honest(cases)
            if problem:
                raise RuntimeError(problem)
        case = Case(name, form, bytes(data))
        connection.send((case.data, None))
        connection.send((case.data, sendable(runners[0].run(name, form, case.suffix, case.data))))

    def mutate(data: bytes, largest: int, number: int) -> bytes:
        return mutated(bytes(data), form, Random(number), honest)[:largest]

    options = [
        f"-max_total_time={seconds:.0f}",
        f"-seed={seed + 1}",  # 0 is a random seed
        f"-max_len={LARGEST_CASE}",
        f"-artifact_prefix={folder}/",
        "-rss_limit_mb=0",
        "-timeout=0",  # the limits of the runner count
        "-close_fd_mask=3",
        str(corpus),
    ]
    atheris.Setup([sys.argv[0], *options], run, custom_mutator=mutate)
    atheris.Fuzz()
