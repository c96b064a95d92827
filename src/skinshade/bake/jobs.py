"""One asset of a library: where it goes, whether it is current, and what became of it."""

from __future__ import annotations

import hashlib
import json
from collections import Counter
from collections.abc import Iterable
from dataclasses import asdict, dataclass, field
from glob import escape
from pathlib import Path
from typing import Any, Literal, get_args

import numpy as np

from .._core.arrays import FloatArray
from .._core.errors import ArgumentError, SkinshadeError
from .._core.files import atomic_write
from .._core.version import __version__
from ..mesh.readers import GLTF_SUFFIXES, SUFFIXES
from ..profile import Profile
from ..scene.images import write_png
from .asset import BakedAsset, bake
from .gltf import read_gltf
from .maps import UNITS as MAP_UNITS
from .settings import BakeSettings
from .thumbnails import thumbnails

__all__ = ["Job", "JobResult", "counted", "failed", "plan", "run"]

Status = Literal["baked", "current", "failed"]
RECORDS = ".skinshade"
"""Folder beside the assets: a record of each, so that what is current is not baked again."""
HISTOGRAM_BINS = 48


@dataclass(frozen=True)
class Job:
    """One asset to bake.

    Attributes
    ----------
    source, output
        Files.
    record, picture
        Where its record lies, and its thumbnails.
    settings
        What is baked.
    pictured
        Whether thumbnails are wanted.
    """

    source: Path
    output: Path
    record: Path
    picture: Path
    settings: BakeSettings
    pictured: bool = False


@dataclass(frozen=True)
class JobResult:
    """What became of it; JSON types only, the same whoever did the work.

    Attributes
    ----------
    source, output
        As in the job.
    status
        ``baked``, ``current`` (nothing to do) or ``failed``.
    error
        Why it failed.
    key
        Hash of all that goes in.
    files
        Hash of each file that came out, by its name.
    meshes
        Of each mesh: name, unit, counts, ranges, histograms, notes.
    """

    source: str
    output: str
    status: Status
    error: str = ""
    key: str = ""
    files: dict[str, str] = field(default_factory=dict)
    meshes: list[dict[str, Any]] = field(default_factory=list)


def plan(
    sources: Iterable[Path],
    folder: Path,
    settings: BakeSettings,
    suffix: str | None = None,
    *,
    pictured: bool = False,
) -> list[Job]:
    """Return a job for every source: its place below their common folder is its place in the output.

    Parameters
    ----------
    sources
        Files, or folders whose models are all meant.
    folder
        Of the outputs.
    settings
        What is baked.
    suffix
        Of the outputs; that of the source for glTF, ``.glb`` for all else, if None.
    pictured
        Whether thumbnails are wanted.

    Raises
    ------
    ArgumentError
        If there is no model, or two would be written to one place.
    """
    models = sorted({each.resolve() for source in sources for each in _models(source, folder)})
    if not models:
        raise ArgumentError(
            "there is no model to bake; give .glb, .gltf, .obj, .ply or .stl files outside the output"
        )
    common = _common_folder(models)
    jobs: dict[Path, Job] = {}
    taken: dict[Path, Path] = {}
    for source in models:
        kept = source.suffix.lower() in GLTF_SUFFIXES
        ending = suffix or (source.suffix if kept else ".glb")
        relative = source.relative_to(common).with_suffix(ending)
        output = folder / relative
        if output.resolve() in models:
            raise ArgumentError(f"{output}: is to be baked itself; choose another output folder")
        # Texture maps are named after the asset without its suffix.
        place = output.with_suffix("") if settings.map_size else output
        other = taken.setdefault(place, source)
        if other != source:
            raise ArgumentError(f"{other} and {source} would both become {place}; bake them apart")
        record, picture = (folder / RECORDS / f"{relative}.{kind}" for kind in ("json", "png"))
        jobs[output] = Job(source, output, record, picture, settings, pictured)
    return list(jobs.values())


def run(job: Job) -> JobResult:
    """Bake an asset unless it is current; what goes wrong is told, not raised."""
    try:
        key = _key(job)
        known = _known(job, key)
        if known is not None:
            return known
        job.output.parent.mkdir(parents=True, exist_ok=True)
        _sweep(job)
        baked = bake(job.source, job.output, job.settings)
        result = JobResult(
            str(job.source),
            str(job.output),
            "baked",
            key=key,
            files={str(path.relative_to(job.output.parent)): _hash(path) for path in baked.written},
            meshes=_told(baked),
        )
        job.record.parent.mkdir(parents=True, exist_ok=True)
        if job.pictured:
            profile = Profile.preset(job.settings.profile)
            write_png(job.picture, thumbnails(baked.meshes, profile))
        with atomic_write(job.record) as temporary:
            temporary.write_text(json.dumps(asdict(result), indent=1) + "\n", encoding="utf-8")
    except SkinshadeError as error:
        return failed(job, str(error))
    except (MemoryError, RecursionError):
        return failed(job, f"{job.source}: out of memory")
    except OSError as error:
        return failed(job, f"{job.source}: {error}")
    except Exception as error:
        return failed(job, f"{job.source}: internal error: {type(error).__name__}: {error}")
    return result


def _sweep(job: Job) -> None:
    """Remove what an earlier process was writing for this job when it was killed."""
    beside = job.output.with_suffix(".skinshade.bin")
    maps = [job.output.with_suffix(f".{name}.{job.settings.map_format}") for name in MAP_UNITS]
    for target in (job.output, job.record, beside, *maps):
        # As `atomic_write` names them: eight characters of tempfile's.
        for left in target.parent.glob(f".{escape(target.stem)}-????????{escape(target.suffix)}"):
            left.unlink(missing_ok=True)


def failed(job: Job, error: str) -> JobResult:
    """Return the result of a job that came to nothing, and why."""
    return JobResult(str(job.source), str(job.output), "failed", error=error)


def counted(results: Iterable[JobResult]) -> dict[str, int]:
    """Return how many there are of each status."""
    count = Counter(each.status for each in results)
    return {status: count[status] for status in get_args(Status)}


def _models(source: Path, folder: Path) -> list[Path]:
    """The models below a folder, but for those that were baked into it."""
    if not source.is_dir():
        return [source]
    baked = folder.resolve()
    found = [
        each for each in source.rglob("*") if each.suffix.lower() in SUFFIXES and each.is_file()
    ]
    return [each for each in found if not each.resolve().is_relative_to(baked)]


def _common_folder(models: list[Path]) -> Path:
    common = models[0].parent
    while not all(each.is_relative_to(common) for each in models):
        common = common.parent
    return common


def _key(job: Job) -> str:
    """Hash of the source, of what it refers to, of the settings and of the version."""
    digest = hashlib.sha256(f"{__version__} {job.output.suffix} {job.settings}".encode())
    digest.update(job.source.read_bytes() if job.source.is_file() else b"")
    if job.source.suffix.lower() in GLTF_SUFFIXES:
        gltf = read_gltf(job.source)
        for relative in gltf.external_files():
            file = gltf.path.parent / relative
            digest.update(str(relative).encode())
            digest.update(file.read_bytes() if file.is_file() else b"")
    return digest.hexdigest()


def _known(job: Job, key: str) -> JobResult | None:
    """The record of a job whose files are all there as it left them."""
    try:
        told = json.loads(job.record.read_text(encoding="utf-8"))
        files = {str(name): str(value) for name, value in told["files"].items()}
        if told["key"] != key or not files or (job.pictured and not job.picture.is_file()):
            return None
        for name, value in files.items():
            if _hash(job.output.parent / name) != value:
                return None
        return JobResult(
            str(job.source), str(job.output), "current", "", key, files, list(told["meshes"])
        )
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return None


def _hash(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def _histogram(values: FloatArray) -> list[int]:
    low, high = float(values.min()), float(values.max())
    # Values that are equal but for rounding still need bins between them.
    around = 1e-6 * max(abs(low), abs(high)) or 0.5
    count, _ = np.histogram(values, HISTOGRAM_BINS, (low - around, high + around))
    found: list[int] = count.tolist()
    return found


def _told(baked: BakedAsset) -> list[dict[str, Any]]:
    return [
        {
            "name": mesh.name,
            "unit_mm": mesh.unit_mm,
            "vertices": len(mesh.body.positions_mm),
            "triangles": len(mesh.body.faces),
            "size_mm": [float(each) for each in np.ptp(mesh.body.positions_mm, axis=0)],
            "uv_scale_mm": mesh.analysed.uv_scale_mm,
            "ranges": {
                name: [float(values.min()), float(values.max())]
                for name, values in mesh.analysed.attributes.items()
            },
            "histograms": {
                name: _histogram(values) for name, values in mesh.analysed.attributes.items()
            },
            "notes": {**mesh.notes, **mesh.analysed.notes},
        }
        for mesh in baked.meshes
    ]
