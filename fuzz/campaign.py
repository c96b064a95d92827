"""The loop of the fuzzer: choose a target and a file, change the file, judge it, keep what is new."""

from __future__ import annotations

import importlib
import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from random import Random

from .case import Case, Limits, Outcome
from .findings import Findings
from .mutations import mutated
from .worker import Worker

__all__ = ["Campaign", "Tally"]

MOST_FOUND = 2000
"""Most files of a target that are kept as seeds."""
SHARE_OF_HONEST, SHARE_OF_REFUSED = 0.5, 0.15
"""Shares of the cases that begin with an honest file, and with a file that a new error has refused. Others
begin with a file that gave a new kind of result. Most changes of a refused file are refused again."""


@dataclass
class Tally:
    """Counts of a target.

    Attributes
    ----------
    cases, accepted, findings
        Numbers of cases, of files that were read without an error, and of cases with a fault.
    errors
        Cases by the type of the error.
    seconds
        Processor time of the cases in the worker, s.
    """

    cases: int = 0
    accepted: int = 0
    findings: int = 0
    errors: Counter[str] = field(default_factory=Counter)
    seconds: float = 0.0

    def add(self, outcome: Outcome) -> None:
        """Count a case."""
        self.cases += 1
        self.seconds += outcome.seconds
        if outcome.fault is not None:
            self.findings += 1
        elif outcome.error:
            self.errors[outcome.error] += 1
        else:
            self.accepted += 1


class Campaign:
    """A run of the fuzzer.

    Parameters
    ----------
    folder
        Folder that the worker may use.
    findings
        Findings of the run.
    seeds
        Honest files by format.
    companions
        Files beside the file of a case, by format and name.
    seed
        Number that decides all choices of the run.
    module
        Module that defines the targets.
    only
        Names of the targets to run; all if empty.
    limits
        Limits of a case.
    """

    def __init__(
        self,
        folder: Path,
        findings: Findings,
        seeds: Mapping[str, Sequence[bytes]],
        companions: Mapping[str, Mapping[str, bytes]],
        *,
        seed: int = 0,
        module: str = "fuzz.targets",
        only: Sequence[str] = (),
        limits: Limits | None = None,
    ) -> None:
        targets = importlib.import_module(module).TARGETS
        self.findings, self.seed = findings, seed
        self.targets = {name: t for name, t in targets.items() if not only or name in only}
        self.tallies = {name: Tally() for name in self.targets}
        self.honest = seeds
        self._found: dict[tuple[str, str, bool], list[bytes]] = {}
        self._known: set[tuple[str, str]] = set()
        honest = [
            Case(name, form, data)
            for name, target in self.targets.items()
            for form in target.forms
            for data in seeds[form]
        ]
        self.worker = Worker(folder, module, honest, companions, limits or Limits())
        self._order = [name for name, target in self.targets.items() for _ in range(target.weight)]

    def run(
        self,
        seconds: float,
        most: int | None = None,
        report: Callable[[int], None] = lambda _: None,
    ) -> int:
        """Run cases for some time, or up to a number of them; return the number of cases."""
        end = time.monotonic() + seconds
        with self.worker:
            for number, case in enumerate(self.cases()):
                if time.monotonic() >= end or number == most:
                    return number
                self.judge(case)
                report(number + 1)
        raise AssertionError("the cases have no end")

    def cases(self) -> Iterator[Case]:
        """Yield cases; they depend on the seed, and on the outcomes of the former ones."""
        number = 0
        while True:
            random = Random(f"{self.seed} {number}")
            name = self._order[number % len(self._order)]
            form = random.choice(self.targets[name].forms)
            pool = self._pool(name, form, random.random()) or self.honest[form]
            yield Case(name, form, mutated(random.choice(pool), form, random, self.honest[form]))
            number += 1

    def _pool(self, name: str, form: str, share: float) -> Sequence[bytes]:
        """Return files to begin with; the share, 0..1, decides their kind."""
        if share < SHARE_OF_HONEST:
            return self.honest[form]
        return self._found.get((name, form, share < SHARE_OF_HONEST + SHARE_OF_REFUSED), [])

    def judge(self, case: Case) -> Outcome:
        """Run a case, and count it."""
        outcome = self.worker.run(case)
        self.count(case, outcome)
        return outcome

    def count(self, case: Case, outcome: Outcome) -> None:
        """Count a case, and keep it as a seed if its outcome is new, or as a finding."""
        self.tallies[case.target].add(outcome)
        if outcome.fault is not None:
            self.findings.add(case, outcome.fault)
        elif (case.target, outcome.signature) not in self._known:
            self._known.add((case.target, outcome.signature))
            found = self._found.setdefault((case.target, case.form, bool(outcome.error)), [])
            if len(found) < MOST_FOUND:
                found.append(case.data)
