"""Measure the curvature of meshes per triangle, from ten thousand to millions, in order and shuffled.

Run by ``make bench``, or as ``python benchmarks/bake_scale.py [--most 9]``. It prints a Markdown table. Each
size runs in its own process, so that the peak memory is that of one mesh.
"""

from __future__ import annotations

import argparse
import os
import resource
import subprocess
import sys
import time

import numpy as np
import trimesh

import skinshade as sk

LEAST, MOST = 5, 9
"""Subdivisions of an icosphere: 20,480 triangles, and 5.2 million."""
RUNS = 3


def measure(subdivisions: int, shuffled: bool) -> str:
    """Return a row of the table; the peak memory is that of this process."""
    mesh = trimesh.creation.icosphere(subdivisions)
    points, faces = np.asarray(mesh.vertices), np.asarray(mesh.faces, dtype=np.int64)
    if shuffled:
        rng = np.random.default_rng(1)
        order = rng.permutation(len(points))
        new_index = np.empty_like(order)
        new_index[order] = np.arange(len(points))
        points, faces = points[order], new_index[faces][rng.permutation(len(faces))]
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20
    times = []
    for _ in range(RUNS):
        start = time.perf_counter()
        sk.mesh_curvature(points, faces, points)
        times.append(time.perf_counter() - start)
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20
    order_name = "shuffled" if shuffled else "in order"
    best = min(times)
    return (
        f"| {len(points):,} | {len(faces):,} | {order_name} | {best:.3f} s"
        f" | {1e9 * best / len(faces):.0f} ns"
        f" | {memory:.2f} GiB, {before:.2f} of it before the analysis |"
    )


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--most", type=int, default=MOST, help="subdivisions of the largest mesh")
    parser.add_argument("--one", type=int, help="only this size, in this process")
    parser.add_argument("--shuffled", action="store_true", help="shuffle vertices and faces")
    options = parser.parse_args()
    if options.one is not None:
        print(measure(options.one, options.shuffled))
        return
    print(f"\nCurvature with 2 passes of smoothing, {os.cpu_count()} cores, best of {RUNS}\n")
    print("| vertices | triangles | order | time | per triangle | peak memory |")
    print("|---|---|---|---|---|---|", flush=True)
    for subdivisions in range(LEAST, options.most + 1):
        for order in ([], ["--shuffled"]):
            command = [sys.executable, __file__, "--one", str(subdivisions), *order]
            subprocess.run(command, check=True)


if __name__ == "__main__":
    main()
