"""Measure the times of tables, mesh analysis and pictures, each beside a baseline or a limit.

Run by ``make bench``, or as ``python benchmarks/performance.py [--side 1000]``. It prints a Markdown table.
Baselines are measured in the same run. Times are the best of several runs in this process; a picture is
drawn once by the command line in a new process, so that its time includes imports and loading.
"""

from __future__ import annotations

import argparse
import os
import platform
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib.metadata import version
from pathlib import Path

import numpy as np

import skinshade as sk
from skinshade._core import native
from skinshade.lut.classic import classic_curvature_lut, classic_shadow_lut
from skinshade.rendering.prepare.mips import build_texture
from skinshade.rendering.prepare.rasterizer import depth_maps, rasterize
from skinshade.scene.camera import look_at, perspective

DATA = Path(os.environ.get("SKINSHADE_DATA", Path(__file__).parents[2] / "shared" / "data"))


def best_of(runs: int, work: Callable[[], object]) -> float:
    """Return the least wall time of several runs, s."""
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return min(times)


def torus(around: int, along: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return positions, faces and normals of a grid on a torus of radii 60 and 25."""
    u, v = np.meshgrid(
        2.0 * np.pi * np.arange(around) / around,
        2.0 * np.pi * np.arange(along) / along,
        indexing="ij",
    )
    normals = np.stack([np.cos(v) * np.cos(u), np.cos(v) * np.sin(u), np.sin(v)], axis=-1)
    middle = np.stack([np.cos(u), np.sin(u), np.zeros_like(u)], axis=-1)
    i, j = np.meshgrid(np.arange(around), np.arange(along), indexing="ij")
    a, b = i * along + j, (i + 1) % around * along + j
    c, d = (i + 1) % around * along + (j + 1) % along, i * along + (j + 1) % along
    faces = np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)
    return (60.0 * middle + 25.0 * normals).reshape(-1, 3), faces, normals.reshape(-1, 3)


def picture(arguments: list[str]) -> tuple[float, float, float]:
    """Return wall time (s) and peak memory (GiB) of the command line in a new process.

    The third number is the wall time (s) without compiled kernels. Times are the best of two runs.
    """

    def seconds(environment: dict[str, str]) -> float:
        with tempfile.TemporaryDirectory() as folder:
            command = [sys.executable, "-m", "skinshade", "render", *arguments]
            command += ["--backend", "cpu", "-o", f"{folder}/p.png"]
            start = time.perf_counter()
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL, env=environment)
            return time.perf_counter() - start

    elapsed = min(seconds(dict(os.environ)) for _ in range(2))
    memory = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 2**20
    return elapsed, memory, min(seconds(os.environ | {"SKINSHADE_NATIVE": "0"}) for _ in range(2))


def kernels() -> Iterator[tuple[str, str, str, str]]:
    """Yield the rows of compiled kernels beside their NumPy twins, each on 2^16 points or a picture."""
    points, faces, _ = torus(150, 100)
    matrix = perspective(40.0, 16.0 / 9.0, 1.0, 1000.0) @ look_at(
        np.array([0.0, 60.0, 220.0]), np.zeros(3), np.array([0.0, 1.0, 0.0])
    )
    clip = points @ matrix[:, :3].T + matrix[:, 3]
    rng = np.random.default_rng(0)
    uv, levels = rng.random((1 << 16, 2)), rng.uniform(0.0, 3.0, 1 << 16)
    texture = build_texture(rng.random((1024, 1024, 3)).astype(np.float32))
    works: dict[str, Callable[[], object]] = {
        "rasterising 30,000 faces, 1280×720": lambda: rasterize(clip, faces, (1280, 720)),
        "depth maps of 30,000 faces, 1024²": lambda: depth_maps(
            clip, clip[:, 3], faces, (1024, 1024)
        ),
        "65,536 trilinear fetches": lambda: texture.sample(uv, levels),
    }
    for work, function in works.items():
        time_s = best_of(5, function)
        with without_kernels():
            numpy_s = best_of(2, function)
        ratio = f"{numpy_s / time_s:.1f}× faster than NumPy ({numpy_s:.3f} s)"
        yield work, f"{time_s:.4f} s", "", ratio


@contextmanager
def without_kernels() -> Iterator[None]:
    """Use NumPy although the library is available."""
    state = native._state
    native._state = lambda: (None, "switched off for a comparison")
    try:
        yield
    finally:
        native._state = state


def command_cpu_s(arguments: list[str]) -> float:
    """Return the least CPU time of five new processes of the command line in new folders, s."""
    times = []
    for _ in range(5):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        command = [sys.executable, "-m", "skinshade", *arguments]
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL, cwd=folder)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        times.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return min(times)


def rows(side: int) -> Iterator[tuple[str, str, str, str]]:
    """Yield the rows of the table.

    Parameters
    ----------
    side
        Vertices along each side of the torus's grid.
    """
    profile = sk.Profile.preset("skin-deon2007")

    def row(
        work: str, limit: str, time_s: float, baseline_s: float, baseline: str
    ) -> tuple[str, str, str, str]:
        ratio = f"{baseline_s / time_s:.1f}× faster than {baseline} ({baseline_s:.2f} s)"
        return work, f"{time_s:.3f} s", limit, ratio

    time_s = best_of(5, lambda: sk.build_curvature_lut(profile))
    baseline_s = best_of(1, lambda: classic_curvature_lut(profile))
    yield row("curvature table 512²", "≤ 0.15 s", time_s, baseline_s, "the construction of 2014")
    time_s = best_of(5, lambda: sk.build_shadow_lut(profile))
    baseline_s = best_of(1, lambda: classic_shadow_lut(profile))
    yield row("shadow table 512²", "≤ 0.2 s", time_s, baseline_s, "the construction of 2014")

    points, faces, normals = torus(side, side)
    time_s = best_of(2, lambda: sk.mesh_curvature(points, faces, normals))
    baseline_s = best_of(1, lambda: sk.mesh_curvature(points, faces, normals, method="edges"))
    work = f"curvature, {points.shape[0]:,} vertices, 2 passes"
    yield row(work, "≤ 1 s for 1 M", time_s, baseline_s, "the method of 2014")

    time_s = best_of(2, lambda: sk.mesh_thickness(points, faces, normals))
    work = f"thickness, {points.shape[0]:,} vertices, 64 rays"
    yield work, f"{time_s:.1f} s", "≤ 6 s for 1 M", "mesh_analysis.py measures NumPy and Embree"

    time_s = best_of(2, lambda: sk.mesh_diffused_normals(points, faces, normals, profile))
    yield f"diffused normals, {points.shape[0]:,} vertices", f"{time_s:.1f} s", "≤ 6 s for 1 M", "–"

    time_s = command_cpu_s(["--help"])
    yield "skinshade --help", f"{time_s:.2f} CPU-s", "≤ 0.25 CPU-s", "–"
    if DATA.is_dir():
        scan = str((DATA / "lps" / "LeePerrySmith.glb").resolve())
        time_s = command_cpu_s(["bake", scan, "--unit-mm", "50.35", "-o", "baked.glb"])
        yield "skinshade bake of the scan", f"{time_s:.2f} CPU-s", "–", "–"

    def picture_row(work: str, limit: str, arguments: list[str]) -> tuple[str, str, str, str]:
        time_s, memory, numpy_s = picture(arguments)
        ratio = f"{numpy_s / time_s:.1f}× faster than NumPy ({numpy_s:.1f} s); {memory:.2f} GiB"
        return work, f"{time_s:.1f} s", limit, ratio

    yield from kernels()
    yield picture_row("built-in head, 1280×720, 4 samples", "≤ 2.5 s, ≤ 2 GiB", [])
    if DATA.is_dir():
        scan = DATA / "lps"
        arguments = [f"{scan}/LeePerrySmith.glb", "--unit-mm", "50.35"]
        arguments += ["--albedo", f"{scan}/color.jpg", "--normal-map", f"{scan}/normal.jpg"]
        arguments += ["--flip-v", "--env", f"{DATA}/env/venice_sunset_1k.hdr"]
        yield picture_row(
            "scan with maps and HDR, 1280×720, 4 samples", "≤ 2 s, ≤ 2 GiB", arguments
        )


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "--side", type=int, default=1000, help="of the torus's grid; 1000 is a million vertices"
    )
    options = parser.parse_args()
    packages = ", ".join(f"{name} {version(name)}" for name in ("numpy", "scipy"))
    print(
        f"skinshade {sk.__version__}, Python {platform.python_version()}, {packages}; "
        f"{platform.machine()}, {os.cpu_count()} cores\n"
    )
    print("| work | time | limit | comparison |\n|---|---|---|---|")
    for row in rows(options.side):
        print("| " + " | ".join(row) + " |", flush=True)


if __name__ == "__main__":
    main()
