"""Compare relief shading with exact diffusion: the formulas of 2014, and two and three normal map fetches.

A cylinder can be unrolled into a plane. Diffusion over it is then a product in the Fourier domain: T(k)
times the transform of the light on the relief. Run as ``python benchmarks/bumpy.py``. It prints a Markdown
table and writes docs/images/bumpy.png.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from skinshade.lut import Lut
from skinshade.lut.classic import classic_curvature_lut
from skinshade.profile import Profile
from skinshade.shading import classic
from skinshade.shading.direct import direct_tensor, directional_curvature
from skinshade.shading.normals import blend_normals, normal_blend
from skinshade.shading.tables import build_curvature_lut

ROOT = Path(__file__).resolve().parents[1]
PERIODS_MM = (0.5, 1.0, 2.0, 4.0)
"""Periods of the relief, from pores to wrinkles; all bands have the same RMS slope."""
CLASSIC_BLUR_MM = 1.35
"""Standard deviation of the blur of 2014: half a texel of its mip level, whose texels are 2.7 mm wide."""
MODELS = ("lambert", "classic", "2 fetches", "3 fetches")
DRAWN_ROW = 100
"""Row of texels along which the picture shows the light."""


@dataclass(frozen=True)
class BumpyCylinder:
    """A cylinder covered with relief, lit perpendicular to its axis or obliquely.

    Attributes
    ----------
    radius_mm
        Radius of the cylinder.
    slope
        RMS slope of the relief.
    tilt
        Angle between the light and the plane perpendicular to the axis, radians.
    size
        Texels along the axis and around it.
    """

    radius_mm: float
    slope: float
    tilt: float = 0.0
    size: tuple[int, int] = (512, 1024)

    @property
    def cell_mm(self) -> float:
        """Side length of a texel, mm."""
        return 2.0 * np.pi * self.radius_mm / self.size[1]

    @cached_property
    def frequencies(self) -> tuple[np.ndarray, np.ndarray]:
        """Spatial frequencies along the axis and around it, rad/mm, in the order of `numpy.fft.rfft2`."""
        along = 2.0 * np.pi * np.fft.fftfreq(self.size[0], self.cell_mm)
        around = 2.0 * np.pi * np.fft.rfftfreq(self.size[1], self.cell_mm)
        return along[:, None], around[None, :]

    @cached_property
    def tangent_normals(self) -> np.ndarray:
        """(H, W, 3) unit normals of random relief, in the tangent frame of a normal map."""
        along, around = self.frequencies
        k = np.hypot(along, around)
        rng, spectrum = np.random.default_rng(1), np.zeros(k.shape, dtype=complex)
        for period in PERIODS_MM:
            octaves = np.log(np.maximum(k, 1e-9) * period / (2.0 * np.pi))
            band = np.fft.rfft2(rng.normal(size=self.size)) * np.exp(-0.5 * (octaves / 0.25) ** 2)
            spectrum += band / np.hypot(*self._slopes(band)).std()
        slopes = self._slopes(spectrum)
        scale = self.slope / np.sqrt(np.mean(slopes[0] ** 2 + slopes[1] ** 2))
        n = np.stack([-scale * slopes[0], -scale * slopes[1], np.ones(self.size)], axis=-1)
        return n / np.linalg.norm(n, axis=-1, keepdims=True)

    @cached_property
    def frame(self) -> np.ndarray:
        """(W, 3 axes, 3) tangent frame of each column: around the cylinder, along it, and outward."""
        phi = np.arange(self.size[1]) * 2.0 * np.pi / self.size[1]
        zero, one = np.zeros_like(phi), np.ones_like(phi)
        around = np.stack([np.cos(phi), zero, -np.sin(phi)], axis=-1)
        outward = np.stack([np.sin(phi), zero, np.cos(phi)], axis=-1)
        return np.stack([around, np.stack([zero, one, zero], axis=-1), outward], axis=1)

    @property
    def light(self) -> np.ndarray:
        """(3,) unit vector towards the light."""
        return np.array([0.0, np.sin(self.tilt), np.cos(self.tilt)])

    def world(self, tangent: np.ndarray) -> np.ndarray:
        """Return tangent-space vectors (H, W, 3) in world axes."""
        return np.einsum("hwi,wij->hwj", tangent, self.frame)

    def blurred(self, sigma_mm: float) -> np.ndarray:
        """Return the normals (H, W, 3) blurred by a Gaussian, in world axes, unnormalised."""
        along, around = self.frequencies
        damping = np.exp(-0.5 * sigma_mm**2 * (along**2 + around**2))[..., None]
        spectrum = np.fft.rfft2(self.tangent_normals, axes=(0, 1)) * damping
        return self.world(np.fft.irfft2(spectrum, self.size, axes=(0, 1)))

    def truth(self, profile: Profile) -> np.ndarray:
        """Return the exact result (H, W, 3): light on the relief, diffused over the cylinder."""
        light = np.maximum(self.world(self.tangent_normals) @ self.light, 0.0)
        spectrum = np.fft.rfft2(light)[..., None] * profile.transfer(np.hypot(*self.frequencies))
        return np.fft.irfft2(spectrum, self.size, axes=(0, 1))

    def _slopes(self, spectrum: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the slopes around and along the cylinder of a height map, from its spectrum."""
        along, around = self.frequencies
        return (
            np.fft.irfft2(1j * around * spectrum, self.size),
            np.fft.irfft2(1j * along * spectrum, self.size),
        )


def shade(
    body: BumpyCylinder, profile: Profile, ring: Lut, classic_table: Lut
) -> dict[str, np.ndarray]:
    """Return the light (H, W, 3) of each of `MODELS`."""
    sharp = body.world(body.tangent_normals)
    light = np.broadcast_to(body.light, sharp.shape)
    kappa = np.full(body.size, 1.0 / body.radius_mm)
    lambert = np.maximum(sharp @ body.light, 0.0)
    result = {"lambert": np.repeat(lambert[..., None], 3, axis=-1)}
    blurred = body.blurred(CLASSIC_BLUR_MM)
    blurred /= np.linalg.norm(blurred, axis=-1, keepdims=True)
    result["classic"] = classic.direct(classic_table, sharp, blurred, light, kappa)
    around = body.frame[:, 0] / np.sqrt(body.radius_mm)
    tensor = np.stack(
        [around[:, i] * around[:, j] for i, j in ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))],
        axis=-1,
    )
    outward = np.broadcast_to(body.frame[:, 2], sharp.shape)
    curvatures = directional_curvature(np.broadcast_to(tensor, (*body.size, 6)), outward, light)
    for fetches in (2, 3):
        blend = normal_blend(profile, fetches=fetches)
        fetched = np.stack([sharp, *(body.blurred(s) for s in blend.sigmas_mm)], axis=-2)
        normals = blend_normals(fetched, blend)
        result[f"{fetches} fetches"] = direct_tensor(
            ring, profile.kernel.transfer, normals, light, *curvatures, np.ones(3)
        )
    return result


def tables(profile: Profile) -> tuple[Lut, Lut]:
    """Return the curvature tables that the models look up: for a ring, and of 2014."""
    ring = build_curvature_lut(
        profile, size=(512, 128), radius_mm=(0.5, 4000.0), kernel="ring", energy_gain=False
    )
    return ring, classic_curvature_lut(profile)


def errors(
    body: BumpyCylinder, profile: Profile, ring: Lut, classic_table: Lut
) -> dict[str, float]:
    """Return the RMS error of each of `MODELS`; light that falls perpendicularly is 1."""
    truth = body.truth(profile)
    return {
        name: float(np.sqrt(np.mean(np.square(value - truth))))
        for name, value in shade(body, profile, ring, classic_table).items()
    }


CASES = [BumpyCylinder(r, s) for r in (8.0, 20.0) for s in (0.15, 0.3, 0.6)]
CASES.append(BumpyCylinder(8.0, 0.3, tilt=0.6))


def main() -> None:
    """Print the table and draw the picture."""
    profile = Profile.preset("skin-deon2007")
    luts = tables(profile)
    rows = {}
    print("| radius, slope, tilt | " + " | ".join(MODELS) + " |\n|---|" + "---|" * len(MODELS))
    for body in CASES:
        label = f"{body.radius_mm:g} mm, {body.slope:g}" + (f", {body.tilt:g}" if body.tilt else "")
        rows[label] = errors(body, profile, *luts)
        cells = " | ".join(f"{rows[label][model]:.4f}" for model in MODELS)
        print(f"| {label} | {cells} |", flush=True)
    draw(rows, BumpyCylinder(8.0, 0.3), profile, luts)


def draw(
    rows: dict[str, dict[str, float]],
    body: BumpyCylinder,
    profile: Profile,
    luts: tuple[Lut, Lut],
) -> None:
    """Write docs/images/bumpy.png: the errors of all cases, and cuts across the terminator of one body."""
    from matplotlib.figure import Figure

    colours = dict(zip(MODELS, ("#9a9a9a", "#d08a2e", "#7fb3d5", "#1f6f8b"), strict=True))
    figure = Figure(figsize=(11.0, 8.0), layout="constrained")
    bars, *cuts = figure.subplots(3, 1, height_ratios=(1.1, 1.0, 1.0))
    positions = np.arange(len(rows))
    for index, model in enumerate(MODELS):
        heights = [case[model] for case in rows.values()]
        offset = 0.2 * (index - 1.5)
        bars.bar(positions + offset, heights, 0.19, color=colours[model], label=model)
    bars.set_xticks(positions, list(rows))
    bars.set(ylabel="RMS error", title="Error of bumpy cylinders (radius, RMS slope, tilt)")
    bars.legend(frameon=False, ncols=4)
    truth, light = body.truth(profile), shade(body, profile, *luts)
    distance = np.arange(body.size[1]) * body.cell_mm
    near_terminator = (distance > 6.0) & (distance < 18.0)
    for axes, channel, name in ((cuts[0], 0, "red"), (cuts[1], 2, "blue")):
        curves = {model: light[model] for model in MODELS[1:]} | {"exact diffusion": truth}
        for label, values in curves.items():
            axes.plot(
                distance[near_terminator],
                values[DRAWN_ROW, near_terminator, channel],
                color=colours.get(label, "black"),
                lw=1.4 if label in colours else 1.6,
                label=label,
            )
        axes.axvline(0.5 * np.pi * body.radius_mm, color="#cccccc", lw=0.8, zorder=0)
        axes.set(ylabel=f"{name} light", xlim=(6.0, 18.0), ylim=(-0.03, 0.95))
    cuts[0].set_title(f"Cut around a cylinder of {body.radius_mm:g} mm, slope {body.slope:g}")
    cuts[0].legend(frameon=False, ncols=4)
    cuts[1].set_xlabel("distance around the cylinder (mm); the grey line is the terminator")
    figure.savefig(ROOT / "docs" / "images" / "bumpy.png", dpi=110)


if __name__ == "__main__":
    main()
