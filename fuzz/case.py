"""Data of the fuzzer: targets, cases, limits and outcomes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

__all__ = ["Case", "Fault", "Limits", "Outcome", "Result", "Target"]


@dataclass(frozen=True)
class Target:
    """A reader, and the files that it reads.

    Attributes
    ----------
    run
        Reader of a file, with a folder in which it may write.
    forms
        Formats of its files, keys of `fuzz.seeds.honest_files` and `fuzz.mutations.MUTATORS`. The suffix of
        a file is the last part of the format.
    weight
        Share of the cases.
    confined
        Whether the reader must not read files outside the folder of its file.
    """

    run: Callable[[Path, Path], Result]
    forms: tuple[str, ...]
    weight: int = 2
    confined: bool = True


@dataclass(frozen=True)
class Limits:
    """Limits of a case.

    Attributes
    ----------
    seconds
        Processor time, s.
    memory_factor, memory
        Growth of memory: factor of the growth for honest files, plus bytes.
    address_space
        Bytes by which the address space of the process may grow, above which allocations fail.
    """

    seconds: float = 5.0
    memory_factor: float = 2.0
    memory: int = 64 << 20
    address_space: int = 2 << 30


@dataclass(frozen=True)
class Case:
    """A file for a target.

    Attributes
    ----------
    target
        Name of the target.
    form
        Format of the file; its suffix is the last part.
    data
        Content of the file.
    """

    target: str
    form: str
    data: bytes

    @property
    def suffix(self) -> str:
        """Suffix of the file, with the dot; JSON for scenes, records and reports."""
        last = self.form.rpartition(".")[2]
        return ".json" if last in ("scene", "record", "report") else f".{last}"


@dataclass(frozen=True)
class Result:
    """Result of a reader.

    Attributes
    ----------
    arrays
        Arrays whose numbers must be finite.
    written
        Files that the reader wrote into the output folder.
    label
        Kind of the result: a file whose kind is new becomes a seed.
    """

    arrays: list[Any] = field(default_factory=list)
    written: list[Path] = field(default_factory=list)
    label: str = ""


@dataclass(frozen=True)
class Fault:
    """Fault that a case reveals: an exception, a warning, a hang, or text on the terminal.

    Attributes
    ----------
    kind
        Type of the exception or warning, or a word such as ``hang``.
    location
        File and line; the name of the target if they are unknown.
    message, details
        Reason in a line, and the traceback.
    """

    kind: str
    location: str
    message: str
    details: str = ""


@dataclass(frozen=True)
class Outcome:
    """Outcome of a case.

    Attributes
    ----------
    error
        Type of the error about the input; empty if the file was accepted.
    signature
        Type of the error and the first words of its message, or the label of the result.
    fault
        What is wrong with the case, or None.
    seconds
        Processor time, s.
    memory
        Growth of the memory to its peak, bytes.
    """

    error: str = ""
    signature: str = ""
    fault: Fault | None = None
    seconds: float = 0.0
    memory: int = 0
