"""Jobs of a library: output of each asset, test whether it is current, and result of baking it."""

from __future__ import annotations

import hashlib
import json
import os
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any, Literal, get_args

import numpy as np

from .._core.arrays import FloatArray
from .._core.errors import ArgumentError, SkinshadeError
from .._core.files import atomic_write, remove_dead_files
from .._core.version import __version__
from ..gltf import GLTF_SUFFIXES, read_gltf
from ..mesh.readers import SUFFIXES
from ..profile import Profile
from ..scene.images import write_png
from .analysis import BakedMesh
from .asset import BakedAsset, bake
from .settings import BakeSettings, OutputFormat
from .thumbnails import thumbnails

__all__ = ["Job", "JobResult", "failure", "plan_jobs", "run_job", "status_counts"]

Status = Literal["baked", "current", "failed"]
RECORDS = ".skinshade"
"""Folder in the output with a record of each asset, so that current assets are not baked again."""
HISTOGRAM_BINS = 48


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
    problem
        Reason why the asset cannot be baked, else empty.
    """

    source: Path
    output: Path
    record: Path
    thumbnail: Path
    settings: BakeSettings
    with_thumbnail: bool = False
    problem: str = ""


@dataclass(frozen=True)
class JobResult:
    """Result of a job, in JSON types.

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
        Hash of each file that was written, by its name.
    meshes
        Name, unit, counts, ranges, histograms and notes of each mesh.
    """

    source: str
    output: str
    status: Status
    error: str = ""
    key: str = ""
    files: dict[str, str] = field(default_factory=dict)
    meshes: list[dict[str, Any]] = field(default_factory=list)


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
        jobs.append(Job(source, output, record, thumbnail, settings, with_thumbnails))
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
    """Bake an asset unless it is current. Errors are returned in the result, not raised."""
    if job.problem:
        return failure(job, job.problem)
    try:
        key = _key(job)
        current = _current_result(job, key)
        if current is not None:
            return current
        job.output.parent.mkdir(parents=True, exist_ok=True)
        remove_dead_files([job.record.parent])
        baked = bake(job.source, job.output, job.settings, replaceable=_recorded_files(job))
        result = JobResult(
            str(job.source),
            str(job.output),
            "baked",
            key=key,
            files={str(path.relative_to(job.output.parent)): _hash(path) for path in baked.written},
            meshes=_mesh_records(baked),
        )
        job.record.parent.mkdir(parents=True, exist_ok=True)
        if job.with_thumbnail:
            profile = Profile.preset(job.settings.profile)
            write_png(job.thumbnail, thumbnails(baked.meshes, profile))
        with atomic_write(job.record) as temporary:
            temporary.write_text(json.dumps(asdict(result), indent=1) + "\n", encoding="utf-8")
    except SkinshadeError as error:
        return failure(job, str(error))
    except (MemoryError, RecursionError):
        return failure(job, f"{job.source}: out of memory")
    except OSError as error:
        return failure(job, f"{job.source}: {error}")
    except Exception as error:
        return failure(job, f"{job.source}: internal error: {type(error).__name__}: {error}")
    return result


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
    try:
        record = json.loads(job.record.read_text(encoding="utf-8"))
        files = {str(name): str(value) for name, value in record["files"].items()}
        if record["key"] != key or not files:
            return None
        if job.with_thumbnail and not job.thumbnail.is_file():
            return None
        for name, value in files.items():
            if _hash(job.output.parent / name) != value:
                return None
        return JobResult(
            str(job.source), str(job.output), "current", "", key, files, list(record["meshes"])
        )
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return None


def _recorded_files(job: Job) -> list[Path]:
    """Return the files that the record of a job lists and that are unchanged since they were written."""
    try:
        record = json.loads(job.record.read_text(encoding="utf-8"))
        files = {job.output.parent / str(name): value for name, value in record["files"].items()}
        return [path for path, value in files.items() if path.is_file() and _hash(path) == value]
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return []


def _hash(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def _histogram(values: FloatArray) -> list[int]:
    """Return the counts of values in bins of equal width."""
    low, high = float(values.min()), float(values.max())
    # The margin keeps the width of bins above 0 if all values are equal up to rounding.
    margin = 1e-6 * max(abs(low), abs(high)) or 0.5
    counts, _ = np.histogram(values, HISTOGRAM_BINS, (low - margin, high + margin))
    result: list[int] = counts.tolist()
    return result


def _mesh_records(baked: BakedAsset) -> list[dict[str, Any]]:
    return [_mesh_record(mesh) for mesh in baked.meshes]


def _mesh_record(baked: BakedMesh) -> dict[str, Any]:
    attributes = baked.analysis.attributes
    return {
        "name": baked.name,
        "unit_mm": baked.mesh.unit_mm,
        "vertices": len(baked.mesh.positions),
        "triangles": len(baked.mesh.faces),
        "size_mm": [float(side) for side in np.ptp(baked.mesh.positions_mm, axis=0)],
        "uv_scale_mm": baked.analysis.uv_scale_mm,
        "ranges": {
            name: [float(values.min()), float(values.max())] for name, values in attributes.items()
        },
        "histograms": {name: _histogram(values) for name, values in attributes.items()},
        "notes": baked.all_notes,
    }
