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
from importlib.metadata import version
from pathlib import Path

import numpy as np

import skinshade as sk
from skinshade.lut.classic import classic_curvature_lut, classic_shadow_lut

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


def picture(arguments: list[str]) -> tuple[float, float]:
    """Return wall time (s) and peak memory (GiB) of the command line in a new process."""
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-m", "skinshade", "render", *arguments, "-o", f"{folder}/p.png"]
        start = time.perf_counter()
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        elapsed = time.perf_counter() - start
    return elapsed, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 2**20


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

    time_s, memory = picture([])
    work = "built-in head, 1280×720, 4 samples"
    yield work, f"{time_s:.1f} s", "≤ 8 s, ≤ 2 GiB", f"{memory:.2f} GiB"
    if DATA.is_dir():
        scan = DATA / "lps"
        arguments = [f"{scan}/LeePerrySmith.glb", "--unit-mm", "50.35"]
        arguments += ["--albedo", f"{scan}/color.jpg", "--normal-map", f"{scan}/normal.jpg"]
        arguments += ["--flip-v", "--env", f"{DATA}/env/venice_sunset_1k.hdr"]
        time_s, memory = picture(arguments)
        work = "scan with maps and HDR, 1280×720, 4 samples"
        yield work, f"{time_s:.1f} s", "≤ 8 s, ≤ 2 GiB", f"{memory:.2f} GiB"


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
