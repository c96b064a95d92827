"""What skin costs on a GPU over plain diffuse and specular: same body, maps, lights and shadow maps.

Run by ``make bench``, or as ``python benchmarks/gpu_cost.py [ADAPTER]``; prints Markdown. Every repetition
runs each way once, in turn, so that a clock that drifts drifts for all. Times are the device's own, of the
pass that shades; those of the other passes stand below.
"""

from __future__ import annotations

import sys
from dataclasses import replace

import numpy as np

import skinshade as sk
from skinshade._core.errors import BackendError
from skinshade.render import RenderSettings
from skinshade.render.gpu.renderer import GpuRenderer

REPETITIONS = 9
SIZES = ((1280, 720), (1920, 1080))
PLAIN = RenderSettings(shading="lambert")
SCATTERING = RenderSettings(deep_scatter_taps=0)
WAYS = {
    "plain diffuse and specular": PLAIN,
    "subsurface scattering": SCATTERING,
    "the same, 2 normal fetches for 3": replace(SCATTERING, normal_fetches=2),
    "and deep scatter, 8 taps": RenderSettings(deep_scatter_taps=8),
    "and deep scatter, 32 taps": RenderSettings(deep_scatter_taps=32),
    "the formulas of 2014, 8 taps": RenderSettings(shading="classic", deep_scatter_taps=8),
}
TALK = ("", "1.30×", "", "1.5×", "2.2×", "")
"""Ratios that the talk of 2014 gives for the same steps."""
FILTERS = {
    "percentage-closer": {},
    "variance": {"shadow_filter": "variance"},
    "variance, multisampled": {"shadow_filter": "variance", "antialiasing": "multisampling"},
}
"""What all ways share: the wide filter, and whether a pixel is shaded once for 4 samples."""


def measured(
    renderer: GpuRenderer, size: tuple[int, int], shared: dict[str, str]
) -> dict[str, np.ndarray]:
    """Return the times (REPETITIONS,) of each way, ms."""
    camera = renderer.scene.camera
    ways = {name: replace(way, **shared) for name, way in WAYS.items()}
    for way in ways.values():  # pipelines are made here
        renderer.draw_shown(camera, size, 1, way)
    times: dict[str, list[float]] = {name: [] for name in ways}
    for _ in range(REPETITIONS):
        for name, way in ways.items():
            renderer.draw_shown(camera, size, 1, way)
            times[name].append(renderer.timings_ms["skin"][-1])
    return {name: np.array(each) for name, each in times.items()}


def main() -> None:
    """Print the tables of one adapter."""
    mesh, skin = sk.builtin_head()
    scene = sk.head_scene(mesh, skin, yaw_deg=28.0)
    try:
        renderer = GpuRenderer(scene, adapter=sys.argv[1] if len(sys.argv) > 1 else None)
    except BackendError as error:
        print(f"No table of costs on a GPU: {error}")
        return
    print(f"\n{renderer.place}, {len(scene.lights)} light, {REPETITIONS} repetitions in turn\n")
    print("| picture | wide filter | shading | median | cost | spread | talk |")
    print("|---|---|---|---|---|---|---|")
    for size in SIZES:
        for label, shared in FILTERS.items():
            times = measured(renderer, size, shared)
            plain = next(iter(times.values()))
            for (name, each), talk in zip(times.items(), TALK, strict=True):
                ratios = each / plain
                low, high = np.percentile(ratios, [25, 75])
                print(
                    f"| {size[0]}×{size[1]} | {label} | {name} | {np.median(each):.1f} ms"
                    f" | {np.median(ratios):.2f}× | {low:.2f}–{high:.2f} | {talk} |"
                )
    others = {name: times for name, times in renderer.timings_ms.items() if name != "skin"}
    print("\n| other pass, all sizes | runs | median |\n|---|---|---|")
    for name, times in others.items():
        print(f"| {name} | {len(times)} | {np.median(times):.2f} ms |")


if __name__ == "__main__":
    main()
