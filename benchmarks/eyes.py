"""Measure refraction and light on the iris of an eye beside a tracer of both surfaces of the cornea.

The tracer is that of the tests, ``tests/eye_truth.py``. Formulas of other renderers are restated on the same
eye. Run as ``python benchmarks/eyes.py``. It prints the tables of docs/eyes.md.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from eye_truth import TrueEye, irradiance_in_bins, parallel_view, tilted
from skinshade.lut import Lut
from skinshade.params import EyeParams
from skinshade.shading.eye import eye_iris_hit
from skinshade.shading.eye_light import eye_light
from skinshade.shading.eye_tables import build_eye_lut

EYE, TRUTH = EyeParams(), TrueEye()
VIEW_ANGLES = (0.0, 20.0, 40.0, 60.0, 70.0, 80.0)
LIGHT_ANGLES = (0.0, 28.0, 57.0, 76.0, 88.0, 98.0)
PHOTONS = 2_000_000
LIMBUS_PLANE_MM = float(np.sqrt(EYE.sclera_radius_mm**2 - EYE.limbus_radius_mm**2))
"""Height of the plane of the limbus."""
HDRP_DEPTH_MM = 0.48
"""Depth of the iris behind the plane of the limbus in HDRP's sample eye: .02 of a unit of 24 mm."""

Rays = tuple[np.ndarray, np.ndarray, np.ndarray]
"""Points of the cornea, unit normals, and unit vectors to the viewer, (n, 3) each."""


def bent(rays: Rays, index: float) -> np.ndarray:
    """Return the directions (n, 3) of rays that one surface of an index refracts."""
    _, normal, view = rays
    c = np.sum(normal * view, axis=-1, keepdims=True)
    return normal * (c / index - np.sqrt(1.0 - (1.0 - c**2) / index**2)) - view / index


def on_surface(rays: Rays) -> np.ndarray:
    """Return the points (n, 3) of the cornea themselves."""
    return rays[0]


def on_plane(rays: Rays, height_mm: float, index: float) -> np.ndarray:
    """Return the points (n, 3) of a plane on refracted rays, as in HDRP."""
    ray = bent(rays, index)
    return rays[0] + ray * ((height_mm - rays[0][:, 2:]) / ray[:, 2:])


def by_height_map(rays: Rays, index: float = 1.4) -> np.ndarray:
    """Return points (n, 3) by a height map of the iris, as in Unreal Engine.

    The depth below the surface is divided by lerp(.325, 1, (V·gaze)²).
    """
    point, _, view = rays
    iris = EYE.iris[0] - EYE.iris_slope * np.hypot(point[:, 0], point[:, 1])
    straight = view[:, 2] ** 2
    depth = (point[:, 2] - iris) / (0.325 + 0.675 * straight)
    return point + bent(rays, index) * depth[:, None]


def by_model(rays: Rays, index: float = EYE.refraction_index) -> np.ndarray:
    """Return the points (n, 3) of the iris of the model with an index."""
    return eye_iris_hit(*rays, np.array([*EYE.cornea[:3], index]), EYE.iris)


def best_plane() -> float:
    """Return the height of the plane of the iris with the least error, mm."""
    heights = np.arange(8.7, 9.6, 0.02)
    errors = [
        np.mean(np.square(refraction_errors(lambda r, h=h: on_plane(r, h, 1.3333))))
        for h in heights
    ]
    return float(heights[int(np.argmin(errors))])


@cache
def traced_view(angle_deg: float) -> tuple[np.ndarray, ...]:
    """Return points, normals, views, true points of the iris, and weights, at an angle to the gaze."""
    return parallel_view(TRUTH, angle_deg)


def refraction_errors(points: Callable[[Rays], np.ndarray]) -> list[float]:
    """Return the RMS error across the gaze, mm, of visible points at each of `VIEW_ANGLES`."""
    errors = []
    for angle in VIEW_ANGLES:
        *rays, truth, weight = traced_view(angle)
        apart = np.sum(np.square(points(tuple(rays)) - truth)[:, :2], axis=-1)
        errors.append(float(np.sqrt(np.sum(weight * apart) / np.sum(weight))))
    return errors


def refraction_table() -> dict[str, list[float]]:
    """Return the errors of every method, mm, at each of `VIEW_ANGLES`."""
    plane = best_plane()
    methods: dict[str, Callable[[Rays], np.ndarray]] = {
        "iris on the surface": on_surface,
        "HDRP, default depth": lambda rays: on_plane(rays, LIMBUS_PLANE_MM - HDRP_DEPTH_MM, 1.3333),
        "HDRP, best plane": lambda rays: on_plane(rays, plane, 1.3333),
        "UE, true height map": by_height_map,
        "index 1.336": lambda rays: by_model(rays, 1.336),
        "index 1.340": by_model,
    }
    return {name: refraction_errors(points) for name, points in methods.items()}


def light_table(lamp: Lut, count: int = PHOTONS) -> list[tuple[float, float, float, float]]:
    """Return, for each of `LIGHT_ANGLES`: mean, and RMS error of n·l, of the model and of other photons.

    n·l has the factor that serves all angles best.
    """
    cases = [(irradiance_in_bins(TRUTH, a, count), a) for a in LIGHT_ANGLES]
    normal = np.array([EYE.iris_slope, 1.0]) / np.hypot(EYE.iris_slope, 1.0)
    plain = []
    for (centres, _), angle in cases:
        outward = centres[:, 0] / np.hypot(centres[:, 0], centres[:, 1])
        light = tilted(angle)[0]
        plain.append(np.maximum(normal[0] * outward * light[0] + normal[1] * light[2], 0.0))
    both = [(own, truth) for own, ((_, truth), _) in zip(plain, cases, strict=True)]
    factor = sum(np.sum(own * truth) for own, truth in both) / sum(
        np.sum(own**2) for own, _ in both
    )
    rows = []
    for own, ((centres, truth), angle) in zip(plain, cases, strict=True):
        model = _in_bins(lamp, centres, angle)
        again = irradiance_in_bins(TRUTH, angle, count, seed=11)[1]
        errors = (factor * own - truth, model - truth, (again - truth) / np.sqrt(2.0))
        rows.append((float(truth.mean()), *(float(np.sqrt(np.mean(e**2))) for e in errors)))
    return rows


def _in_bins(lamp: Lut, centres: np.ndarray, angle_deg: float) -> np.ndarray:
    """Return the model's mean irradiance (n,) in bins of .5 mm."""
    steps = (np.arange(4) + 0.5) / 8.0 - 0.25
    offsets = np.stack(np.meshgrid(steps, steps), axis=-1).reshape(-1, 2)
    xy = centres[:, None] + offsets
    hit = np.concatenate([xy, np.zeros((*xy.shape[:-1], 1))], axis=-1)
    light = np.broadcast_to(tilted(angle_deg)[0], hit.shape)
    return eye_light(lamp, hit, light)[..., 0].mean(axis=1)


def main() -> None:
    """Print both tables."""
    print(
        "| RMS error on the iris, mm | " + " | ".join(f"{a:g}°" for a in VIEW_ANGLES) + " | all |"
    )
    print("|---|" + "---|" * (len(VIEW_ANGLES) + 1))
    for name, errors in refraction_table().items():
        cells = [*errors, float(np.sqrt(np.mean(np.square(errors))))]
        print(f"| {name} | " + " | ".join(f"{error:.3f}" for error in cells) + " |")
    print("\n| angle of the lamp | mean | n·l | table | photons |\n|---|---|---|---|---|")
    for angle, row in zip(LIGHT_ANGLES, light_table(build_eye_lut().lamp), strict=True):
        print(f"| {angle:g}° | " + " | ".join(f"{value:.3f}" for value in row) + " |", flush=True)


if __name__ == "__main__":
    main()
