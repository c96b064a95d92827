"""Measure the cost of skin on a GPU over plain shading: same body, maps, lights and shadow maps.

Run by ``make bench``, or as ``python benchmarks/gpu_cost.py [ADAPTER]``. It prints Markdown tables. Every
repetition draws every variant once, in turn, so that a drifting clock affects all of them alike. Times
are the device's own timestamps of the pass that shades; a second table lists the other passes.
"""

from __future__ import annotations

import argparse
from dataclasses import replace

import numpy as np

import skinshade as sk
from skinshade._core.errors import BackendError
from skinshade.rendering import RenderSettings
from skinshade.rendering.gpu.renderer import GpuRenderer

REPETITIONS = 9
SIZES = ((1280, 720), (1920, 1080))
SCATTERING = RenderSettings(deep_scatter_taps=0)
VARIANTS = {
    "plain diffuse and specular": RenderSettings(shading="lambert"),
    "subsurface scattering": SCATTERING,
    "the same, 2 normal fetches for 3": replace(SCATTERING, normal_fetches=2),
    "and deep scatter, 8 taps": RenderSettings(deep_scatter_taps=8),
    "and deep scatter, 32 taps": RenderSettings(deep_scatter_taps=32),
    "the formulas of 2014, 8 taps": RenderSettings(shading="classic", deep_scatter_taps=8),
}
"""Settings by label; the first variant is the baseline of the ratios."""
TALK = ("", "1.30×", "", "1.5×", "2.2×", "")
"""Ratios that the talk of 2014 gives for the same variants."""
FILTERS = {
    "percentage-closer": {},
    "variance": {"shadow_filter": "variance"},
    "variance, multisampled": {"shadow_filter": "variance", "antialiasing": "multisampling"},
}
"""Settings that all variants of a table section share: the wide filter and the antialiasing."""


def shading_times_ms(
    renderer: GpuRenderer, size: tuple[int, int], shared: dict[str, str], repetitions: int
) -> dict[str, np.ndarray]:
    """Return the times (repetitions,) of the pass that shades, ms, by variant."""
    camera = renderer.scene.camera
    variants = {name: replace(settings, **shared) for name, settings in VARIANTS.items()}
    for settings in variants.values():  # the first picture of each variant creates its pipeline
        renderer.draw_display(camera, size, 1, settings)
    times: dict[str, list[float]] = {name: [] for name in variants}
    for _ in range(repetitions):
        for name, settings in variants.items():
            renderer.draw_display(camera, size, 1, settings)
            times[name].append(renderer.timings_ms["skin"][-1])
    return {name: np.array(values) for name, values in times.items()}


def main() -> None:
    """Print the tables of one adapter."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("adapter", nargs="?", help="part of the adapter's name")
    parser.add_argument("--repetitions", type=int, default=REPETITIONS)
    options = parser.parse_args()
    scene = sk.head_scene(sk.builtin_head())
    try:
        renderer = GpuRenderer(scene, adapter=options.adapter)
    except BackendError as error:
        print(f"The cost on a GPU is not measured: {error}")
        return
    print(
        f"\n{renderer.device_name}, {len(scene.lights)} light,"
        f" {options.repetitions} repetitions in turn\n"
    )
    print("| picture | wide filter | shading | median | cost | quartiles | talk |")
    print("|---|---|---|---|---|---|---|")
    for size in SIZES:
        for label, shared in FILTERS.items():
            times = shading_times_ms(renderer, size, shared, options.repetitions)
            baseline = next(iter(times.values()))
            for (name, values), talk in zip(times.items(), TALK, strict=True):
                ratios = values / baseline
                low, high = np.percentile(ratios, [25, 75])
                print(
                    f"| {size[0]}×{size[1]} | {label} | {name} | {np.median(values):.1f} ms"
                    f" | {np.median(ratios):.2f}× | {low:.2f}–{high:.2f} | {talk} |",
                    flush=True,
                )
    print("\n| other pass, all sizes | runs | median |\n|---|---|---|")
    for name, values in renderer.timings_ms.items():
        if name != "skin":
            print(f"| {name} | {len(values)} | {np.median(values):.2f} ms |")


if __name__ == "__main__":
    main()
