"""What skin costs on a GPU over plain diffuse and specular: same body, maps, lights and shadow maps.

Run by ``make bench``, or as ``python benchmarks/gpu_cost.py [ADAPTER]``; prints Markdown. Every repetition
runs each way once, in turn, so that a clock that drifts drifts for all. Times are the device's own.
"""

from __future__ import annotations

import sys

import numpy as np

import skinshade as sk
from skinshade._core.errors import BackendError
from skinshade.render import RenderSettings
from skinshade.render.gpu.renderer import GpuRenderer

REPETITIONS = 9
SIZES = ((1280, 720), (1920, 1080))
WAYS = {
    "plain diffuse and specular": RenderSettings(shading="lambert"),
    "subsurface scattering": RenderSettings(deep_scatter_taps=0),
    "and deep scatter, 8 taps": RenderSettings(deep_scatter_taps=8),
    "and deep scatter, 32 taps": RenderSettings(deep_scatter_taps=32),
    "the formulas of 2014, 8 taps": RenderSettings(shading="classic", deep_scatter_taps=8),
}
TALK = ("", "1.30×", "1.5×", "2.2×", "")
"""Ratios that the talk of 2014 gives for the same four steps."""


def measured(renderer: GpuRenderer, size: tuple[int, int]) -> dict[str, np.ndarray]:
    """Return the times (REPETITIONS,) of each way, ms."""
    camera = renderer.scene.camera
    for way in WAYS.values():  # pipelines are made here
        renderer.draw(camera, size, 1, way)
    times: dict[str, list[float]] = {name: [] for name in WAYS}
    for _ in range(REPETITIONS):
        for name, way in WAYS.items():
            renderer.draw(camera, size, 1, way)
            times[name].append(renderer.timings_ms["skin"][-1])
    return {name: np.array(each) for name, each in times.items()}


def main() -> None:
    """Print the table of one adapter."""
    mesh, skin = sk.builtin_head()
    scene = sk.head_scene(mesh, skin, yaw_deg=28.0)
    try:
        renderer = GpuRenderer(scene, adapter=sys.argv[1] if len(sys.argv) > 1 else None)
    except BackendError as error:
        print(f"No table of costs on a GPU: {error}")
        return
    print(f"\n{renderer.place}, {len(scene.lights)} light, {REPETITIONS} repetitions in turn\n")
    print("| picture | shading | median | cost | spread | talk |\n|---|---|---|---|---|---|")
    for size in SIZES:
        times = measured(renderer, size)
        plain = next(iter(times.values()))
        for (name, each), talk in zip(times.items(), TALK, strict=True):
            ratios = each / plain
            low, high = np.percentile(ratios, [25, 75])
            print(
                f"| {size[0]}×{size[1]} | {name} | {np.median(each):.1f} ms"
                f" | {np.median(ratios):.2f}× | {low:.2f}–{high:.2f} | {talk} |"
            )


if __name__ == "__main__":
    main()
