"""Findings: faults without repetitions, written as files with the reason beside them."""

from __future__ import annotations

import hashlib
import re
from dataclasses import dataclass
from pathlib import Path

from .case import Case, Fault

__all__ = ["Finding", "Findings", "read_finding"]

NUMBERS = re.compile(r"\d+")
HEADER = re.compile(r"target: (.+)\nformat: (.+)\n")


@dataclass
class Finding:
    """A fault, and the smallest file that shows it.

    Attributes
    ----------
    case, fault
        The file and what is wrong.
    count
        Number of cases with this fault.
    """

    case: Case
    fault: Fault
    count: int = 1


class Findings:
    """All findings of a run, one for each kind and location."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.by_key: dict[tuple[str, str], Finding] = {}

    def add(self, case: Case, fault: Fault) -> bool:
        """Count a fault, write the file if it is new or smaller than before, and return whether it is new."""
        key = fault.kind, fault.location
        known = self.by_key.get(key)
        if known is not None:
            known.count += 1
            if len(case.data) < len(known.case.data):
                known.case, known.fault = case, fault
                self._write(known)
            return False
        self.by_key[key] = Finding(case, fault)
        self._write(self.by_key[key])
        return True

    def _write(self, finding: Finding) -> None:
        self.folder.mkdir(parents=True, exist_ok=True)
        case, fault = finding.case, finding.fault
        name = hashlib.sha256(f"{fault.kind} {fault.location}".encode()).hexdigest()[:12]
        for old in self.folder.glob(f"{name}.*"):
            old.unlink()
        (self.folder / f"{name}{case.suffix}").write_bytes(case.data)
        text = (
            f"target: {case.target}\nformat: {case.form}\n"
            f"{fault.kind} at {fault.location}\n{fault.message}\n\n{fault.details}\n"
        )
        (self.folder / f"{name}.txt").write_text(text, encoding="utf-8", errors="backslashreplace")


def read_finding(file: Path) -> Case:
    """Return the case of a file that `Findings` wrote.

    Raises
    ------
    ValueError
        If the text beside the file does not name its target.
    """
    match = HEADER.match(file.with_suffix(".txt").read_text(encoding="utf-8"))
    if match is None:
        raise ValueError(
            f"{file.with_suffix('.txt')}: does not begin with the target and the format"
        )
    return Case(match[1], match[2], file.read_bytes())
