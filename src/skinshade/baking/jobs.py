"""Jobs of a library: output of each asset, test whether it is current, and result of baking it."""

from __future__ import annotations

import hashlib
import os
import warnings
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Literal, get_args

from .._core.errors import ArgumentError, SkinshadeError, SkinshadeWarning
from .._core.files import remove_dead_files
from .._core.limits import Limits, limits, use_limits
from .._core.text import shortened
from .._core.version import __version__
from ..gltf import GLTF_SUFFIXES, read_gltf
from ..mesh.readers import SUFFIXES
from ..profile import Profile
from .asset import bake
from .names import without_folders
from .records import (
    LONGEST_WARNING,
    MeshRecord,
    Record,
    are_unchanged,
    file_hash,
    mesh_record,
    read_record,
    write_record,
)
from .settings import BakeSettings, OutputFormat
from .worker import failure_reason

__all__ = ["Job", "JobResult", "failure", "plan_jobs", "run_job", "status_counts"]

Status = Literal["baked", "current", "failed"]
RECORDS = ".skinshade"
"""Folder in the output with a record of each asset, so that current assets are not baked again."""


@dataclass(frozen=True)
class Job:
    """One asset to bake.

    Attributes
    ----------
    source, output
        Files of the asset.
    record, thumbnail
        Files of the record and of the thumbnails.
    settings
        Settings of the bake.
    with_thumbnail
        Whether thumbnails are drawn.
    source_folder, output_folder
        Folders to which records and reports state the names of files.
    problem
        Reason why the asset cannot be baked, else empty.
    active_limits
        Limits under which the asset is read, in any process: those that apply when the job is created.
    """

    source: Path
    output: Path
    record: Path
    thumbnail: Path
    settings: BakeSettings
    with_thumbnail: bool
    source_folder: Path
    output_folder: Path
    problem: str = ""
    active_limits: Limits = field(default_factory=limits)

    @property
    def source_name(self) -> str:
        """Source relative to its folder, with slashes."""
        return self.source.relative_to(self.source_folder).as_posix()

    @property
    def output_name(self) -> str:
        """Output relative to its folder, with slashes."""
        return self.output.relative_to(self.output_folder).as_posix()


@dataclass(frozen=True)
class JobResult:
    """Result of a job.

    Attributes
    ----------
    source, output
        Files of the job.
    status
        ``baked``, ``current`` (nothing to do) or ``failed``.
    error
        Reason of a failure, else empty.
    key
        Hash of the source, the files that it refers to, the settings and the version.
    files
        Hash of each file that was written, by its name relative to the folder of the output.
    meshes
        Description of each mesh.
    warnings
        Texts of the warnings, such as that the unit gives an implausible size, without the name of the
        source.
    """

    source: str
    output: str
    status: Status
    error: str = ""
    key: str = ""
    files: dict[str, str] = field(default_factory=dict)
    meshes: list[MeshRecord] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)


def plan_jobs(
    sources: Sequence[Path],
    folder: Path,
    settings: BakeSettings,
    output_format: str | None = None,
    *,
    with_thumbnails: bool = False,
) -> list[Job]:
    """Return a job for every model. Outputs keep the paths of the models below their common folder.

    The jobs of models whose outputs would have the same name have a problem, and fail alone.

    Parameters
    ----------
    sources
        Models, or folders whose models are all baked.
    folder
        Folder of the outputs.
    settings
        Settings of the bake.
    output_format
        ``glb``, ``ply``, ``usda`` or ``usdc``; if None, glTF files keep their suffix and other files
        become ``.glb``.
    with_thumbnails
        Whether thumbnails are drawn.

    Raises
    ------
    ArgumentError
        If there is no model, the format is unknown, or the output folder contains a model itself.
    """
    suffix = None
    if output_format is not None:
        suffix = f".{OutputFormat.of(output_format, 'output_format')}"
    missing = [source for source in sources if not source.exists()]
    if missing:
        raise ArgumentError(f"{missing[0]}: no such file or folder")
    # Symbolic links are not resolved: an output has the name of the link.
    models = sorted(
        {
            Path(os.path.abspath(path))  # noqa: PTH100 — Path.absolute keeps ".."
            for source in sources
            for path in _models(source, folder)
        }
    )
    if not models:
        raise ArgumentError(
            "there is no model to bake; give .glb, .gltf, .obj, .ply or .stl files outside the output"
        )
    common = _common_folder(models)
    resolved = {model.resolve() for model in models}
    jobs: list[Job] = []
    claims: dict[Path, list[Path]] = {}
    for source in models:
        is_gltf = source.suffix.lower() in GLTF_SUFFIXES
        ending = suffix or (source.suffix if is_gltf else ".glb")
        relative = source.relative_to(common).with_suffix(ending)
        output = folder / relative
        if output.resolve() in resolved:
            raise ArgumentError(f"{output}: is one of the sources; choose another output folder")
        claims.setdefault(_claim(output, settings), []).append(source)
        record, thumbnail = (folder / RECORDS / f"{relative}.{kind}" for kind in ("json", "png"))
        jobs.append(
            Job(source, output, record, thumbnail, settings, with_thumbnails, common, folder)
        )
    return [_with_problem(job, claims[_claim(job.output, settings)]) for job in jobs]


def _claim(output: Path, settings: BakeSettings) -> Path:
    """Return the name that no other job may use: maps are named after the asset without its suffix."""
    return output.with_suffix("") if settings.map_size else output


def _with_problem(job: Job, sources: Sequence[Path]) -> Job:
    if len(sources) == 1:
        return job
    names = ", ".join(map(str, sources))
    problem = f"{names}: all would be written to {job.output}; bake them into different folders"
    return replace(job, problem=problem)


def run_job(job: Job) -> JobResult:
    """Bake an asset unless it is current. The result has the errors and the warnings of skinshade."""
    if job.problem:
        return failure(job, job.problem)
    with use_limits(job.active_limits):
        return _run(job)


def _run(job: Job) -> JobResult:
    try:
        key = _key(job)
        current = _current_result(job, key)
        if current is not None:
            return current
        job.output.parent.mkdir(parents=True, exist_ok=True)
        remove_dead_files([job.record.parent])
        with _recorded_warnings(job) as texts:
            baked = bake(job.source, job.output, job.settings, replaceable=_recorded_files(job))
        job.record.parent.mkdir(parents=True, exist_ok=True)
        if job.with_thumbnail:
            from .thumbnails import write_thumbnails  # imports the renderer, which costs .2 s

            write_thumbnails(job.thumbnail, baked.meshes, Profile.preset(job.settings.profile))
        record = Record(
            source=job.source_name,
            output=job.output_name,
            key=key,
            files={
                path.relative_to(job.output.parent).as_posix(): file_hash(path)
                for path in baked.written
            },
            thumbnail=file_hash(job.thumbnail) if job.with_thumbnail else None,
            meshes=[mesh_record(mesh) for mesh in baked.meshes],
            warnings=texts,
        )
        write_record(record, job.record)
    except SkinshadeError as error:
        return failure(job, str(error))
    except OSError as error:
        return failure(job, f"{job.source}: {error}")
    except Exception as error:
        return failure(job, f"{job.source}: {failure_reason(error)}")
    return _result(job, "baked", record)


@contextmanager
def _recorded_warnings(job: Job) -> Iterator[list[str]]:
    """Collect the texts of warnings of skinshade in a list. Other warnings are issued at the end."""
    folders = (job.source_folder, job.output_folder)
    texts: list[str] = []
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", SkinshadeWarning)
        yield texts
        for item in caught:
            if isinstance(item.message, SkinshadeWarning):
                text = str(item.message).removeprefix(f"{job.source}: ")
                texts.append(shortened(without_folders(text, folders), LONGEST_WARNING))
    for item in caught:
        if not isinstance(item.message, SkinshadeWarning):
            warnings.warn_explicit(item.message, item.category, item.filename, item.lineno)


def failure(job: Job, error: str) -> JobResult:
    """Return the result of a job that failed with an error message."""
    return JobResult(str(job.source), str(job.output), "failed", error=error)


def status_counts(results: Iterable[JobResult]) -> dict[str, int]:
    """Return the number of results of each status."""
    counts = Counter(result.status for result in results)
    return {status: counts[status] for status in get_args(Status)}


def _models(source: Path, folder: Path) -> list[Path]:
    """Return a file itself, or the models in a folder except those in the output folder."""
    if not source.is_dir():
        return [source]
    outputs = folder.resolve()
    models = [
        path for path in source.rglob("*") if path.suffix.lower() in SUFFIXES and path.is_file()
    ]
    return [path for path in models if not path.resolve().is_relative_to(outputs)]


def _common_folder(models: list[Path]) -> Path:
    common = models[0].parent
    while not all(model.is_relative_to(common) for model in models):
        common = common.parent
    return common


def _key(job: Job) -> str:
    """Return the hash of the source, the files that it refers to, the settings and the version."""
    digest = hashlib.sha256(f"{__version__} {job.output.suffix} {job.settings}".encode())
    digest.update(job.source.read_bytes() if job.source.is_file() else b"")
    if job.source.suffix.lower() in GLTF_SUFFIXES:
        gltf = read_gltf(job.source)
        for name, file in gltf.external_files().items():
            digest.update(os.fsencode(name))
            digest.update(file.read_bytes() if file.is_file() else b"")
    return digest.hexdigest()


def _current_result(job: Job, key: str) -> JobResult | None:
    """Return the recorded result of a job if its key and all its files are unchanged."""
    record = read_record(job.record)
    if record is None or record.key != key or job.output.name not in record.files:
        return None
    if not are_unchanged(record.files, job.output.parent):
        return None
    if job.with_thumbnail:
        if record.thumbnail is None:
            return None
        if not are_unchanged({job.thumbnail.name: record.thumbnail}, job.thumbnail.parent):
            return None
    return _result(job, "current", record)


def _recorded_files(job: Job) -> list[Path]:
    """Return the files that the record of a job lists and that are unchanged since they were written."""
    record = read_record(job.record)
    files = {} if record is None else record.files
    return [
        job.output.parent / name
        for name, value in files.items()
        if are_unchanged({name: value}, job.output.parent)
    ]


def _result(job: Job, status: Status, record: Record) -> JobResult:
    return JobResult(
        str(job.source),
        str(job.output),
        status,
        key=record.key,
        files=record.files,
        meshes=record.meshes,
        warnings=record.warnings,
    )
