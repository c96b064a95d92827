"""Measure mesh analysis: compiled kernels beside NumPy, and beside a loop in C++ of the method of 2014.

Run by ``make bench``, or as ``python benchmarks/mesh_analysis.py [--runs 9] [--largest 5000000]``. It prints
Markdown tables. All columns of a row are measured in this run, and a time is the best of several runs.
The loop in C++ (curvature_2014.cpp) is compiled with -O3 if a C++ compiler exists, and has one thread.
"""

from __future__ import annotations

import argparse
import ctypes
import os
import platform
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path

import numpy as np

import skinshade as sk
from performance import torus
from skinshade._core import native
from skinshade.mesh.normals import vertex_normals
from skinshade.mesh.topology import open_edge_counts, weld

SOURCE = Path(__file__).with_name("curvature_2014.cpp")
PASSES = 2
NUMPY_THICKNESS = 20_000
"""Greatest mesh whose thickness NumPy is measured on; it takes 4 s for 10,000 vertices."""
NUMPY_VERTICES = 1_000_000
"""Greatest mesh that NumPy is measured on; it takes 9 s for a million vertices without normals."""
MEMORY = """
import sys
from pathlib import Path
sys.path.insert(0, {folder!r})
from mesh_analysis import mesh
import skinshade as sk
def kib(name):
    text = Path("/proc/self/status").read_text()
    return int(text.split(name + ":")[1].split()[0])
arrays = mesh({side}, {in_order})
sk.mesh_curvature(*mesh(20, True))
Path("/proc/self/clear_refs").write_text("5")  # the peak starts anew
before = kib("VmRSS")
sk.mesh_curvature(*arrays{last})
print((kib("VmHWM") - before) * 1024 / len(arrays[0]))
"""
"""Program that prints the peak memory of mesh_curvature beyond its arguments, on Linux."""


def mesh(side: int, in_order: bool) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return positions, faces and normals of a torus, in the order of its grid or in a random one."""
    points, faces, normals = torus(side, side)
    if in_order:
        return points, faces, normals
    rng = np.random.default_rng(0)
    order = rng.permutation(len(points))
    number = np.empty_like(order)
    number[order] = np.arange(len(order))
    return points[order], number[faces[rng.permutation(len(faces))]], normals[order]


def best_ms(runs: int, work: Callable[[], object]) -> float:
    """Return the least wall time of several runs, ms."""
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return 1e3 * min(times)


@contextmanager
def numpy_twins() -> Iterator[None]:
    """Use NumPy although the library is available."""
    state = native._state
    native._state = lambda: (None, "switched off")
    try:
        yield
    finally:
        native._state = state


def loop_of_2014() -> Callable[..., None] | None:
    """Compile and return the loop in C++, or None without a compiler."""
    named = shlex.split(os.environ.get("CXX", ""))
    compiler = next(filter(None, map(shutil.which, [*named[:1], "c++", "g++", "clang++"])), None)
    if compiler is None:
        return None
    folder = tempfile.mkdtemp()
    library = Path(folder) / "curvature_2014.so"
    command = [compiler, "-O3", "-shared", "-fPIC", str(SOURCE), "-o", str(library)]
    subprocess.run(command, check=True)
    function = ctypes.CDLL(str(library)).curvature_2014
    shutil.rmtree(folder, ignore_errors=True)
    function.restype = None
    kinds = [ctypes.c_void_p] * 3 + [ctypes.c_int64] * 2 + [ctypes.c_int, ctypes.c_void_p]
    function.argtypes = kinds

    def loop(points: np.ndarray, faces: np.ndarray, normals: np.ndarray) -> np.ndarray:
        result = np.empty(len(points), dtype=np.float32)
        pointers = [array.ctypes.data for array in (points, normals, faces)]
        function(*pointers, len(points), len(faces), PASSES, result.ctypes.data)
        return result

    return loop


def bytes_per_vertex(side: int, in_order: bool) -> str:
    """Return the peak memory beyond the arguments in new processes, normals given / computed."""
    if not sys.platform.startswith("linux"):
        return "–"
    folder = str(Path(__file__).parent)
    figures = []
    for last in ("", "[:2]"):
        program = MEMORY.format(folder=folder, side=side, in_order=in_order, last=last)
        command = [sys.executable, "-c", program]
        done = subprocess.run(command, check=True, capture_output=True, text=True)
        figures.append(f"{float(done.stdout):.0f}")
    return " / ".join(figures)


def curvature_row(side: int, in_order: bool, runs: int, loop: Callable[..., object] | None) -> str:
    """Return the row of a mesh in the table of curvature."""
    points, faces, normals = mesh(side, in_order)
    given = best_ms(runs, lambda: sk.mesh_curvature(points, faces, normals))
    own = best_ms(runs, lambda: sk.mesh_curvature(points, faces))
    numpy_given = numpy_own = cpp = "–"
    if len(points) <= NUMPY_VERTICES:
        with numpy_twins():
            twin = best_ms(2, lambda: sk.mesh_curvature(points, faces, normals))
            numpy_given = f"{twin:.0f} ({twin / given:.0f}×)"
            twin = best_ms(1, lambda: sk.mesh_curvature(points, faces))
            numpy_own = f"{twin:.0f} ({twin / own:.0f}×)"
    if loop is not None:
        narrow = points.astype(np.float32), faces.astype(np.uint32), normals.astype(np.float32)
        baseline = best_ms(runs, lambda: loop(*narrow))
        cpp = f"{baseline:.1f} ({baseline / given:.2f}×)"
    return (
        f"| {len(faces):,} | {'grid' if in_order else 'random'} | {given:.1f} | {own:.1f} "
        f"| {1e6 * given / len(faces):.1f} / {1e6 * own / len(faces):.1f} "
        f"| {numpy_given} | {numpy_own} | {cpp} | {bytes_per_vertex(side, in_order)} |"
    )


def other_rows(side: int, runs: int) -> list[str]:
    """Return the rows of other functions."""
    points, faces, normals = mesh(side, True)
    uvs = np.ascontiguousarray(points[:, :2])
    profile = sk.Profile.preset("skin-deon2007")
    work = {
        "weld": lambda: weld(points),
        "vertex_normals": lambda: vertex_normals(points, faces),
        "open_edge_counts": lambda: open_edge_counts(points, faces),
        "mesh_curvature_tensor": lambda: sk.mesh_curvature_tensor(points, faces, normals),
        "mesh_diffused_normals": lambda: sk.mesh_diffused_normals(points, faces, normals, profile),
        "mesh_uv_scale": lambda: sk.mesh_uv_scale(points, uvs, faces),
        "Mesh.checked, normals given": lambda: sk.Mesh.checked(
            points, faces, unit_mm=1.0, normals=normals, uvs=uvs
        ),
        "Mesh.checked": lambda: sk.Mesh.checked(points, faces, unit_mm=1.0, uvs=uvs),
    }
    rows = []
    for name, function in work.items():
        compiled = best_ms(runs, function)
        with numpy_twins():
            twin = best_ms(1, function)
        rows.append(f"| {name} | {compiled:.1f} | {twin:.0f} | {twin / compiled:.0f}× |")
    return rows


def thickness_rows(side: int, runs: int) -> list[str]:
    """Return the rows of thickness for a small and a large torus, by all casters."""
    rows = []
    casters = ["embree"] if find_spec("embreex") else []
    for across in (side // 10, side):
        points, faces, normals = mesh(across, True)
        work = partial(sk.mesh_thickness, points, faces, normals)
        times = {"compiled": best_ms(min(runs, 3), partial(work, tracing="builtin"))}
        for tracing in casters:
            times[tracing] = best_ms(1, partial(work, tracing=tracing))
        if len(points) <= NUMPY_THICKNESS:
            with numpy_twins():
                times["NumPy"] = best_ms(1, partial(work, tracing="builtin"))
        for name, time_ms in times.items():
            ratio = f"{time_ms / times['compiled']:.1f}×"
            rows.append(f"| {len(points):,} | {name} | {time_ms:.0f} | {ratio} |")
    return rows


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=9, help="of which the best time counts")
    parser.add_argument("--largest", type=int, default=5_000_000, help="vertices")
    options = parser.parse_args()
    packages = ", ".join(f"{name} {version(name)}" for name in ("numpy", "scipy"))
    load = f", load {os.getloadavg()[0]:.1f}" if hasattr(os, "getloadavg") else ""
    print(
        f"skinshade {sk.__version__}, Python {platform.python_version()}, {packages}; "
        f"{platform.machine()}, {native.thread_count()} cores{load}\nkernels: {native.reason()}\n"
    )
    loop = loop_of_2014()
    print("Curvature with two passes of smoothing, ms; normals given / computed.\n")
    print(
        "| triangles | order | given | computed | ns per triangle | NumPy, given "
        "| NumPy, computed | C++ of 2014 | bytes per vertex |\n" + "|---" * 9 + "|"
    )
    for vertices in (50_000, 200_000, 1_000_000, 5_000_000):
        if vertices <= options.largest:
            for in_order in (True, False):
                side = round(vertices**0.5)
                print(curvature_row(side, in_order, options.runs, loop), flush=True)
    print("\nOther functions for a million vertices, ms.\n")
    print("| function | compiled | NumPy | ratio |\n|---|---|---|---|")
    for row in other_rows(1000, options.runs):
        print(row, flush=True)
    print("\nThickness with 64 rays, ms.\n")
    print("| vertices | caster | time | ratio |\n|---|---|---|---|")
    for row in thickness_rows(round(min(options.largest, 1_000_000) ** 0.5), options.runs):
        print(row, flush=True)


if __name__ == "__main__":
    main()
