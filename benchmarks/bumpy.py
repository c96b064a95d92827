"""Relief under diffusion: the formulas of 2014, two and three fetches, beside exact diffusion by FFT.

A cylinder is flat when unrolled, so that diffusion over it is multiplication by T(k) of the Fourier
transform of the light on it, relief included. Run as ``python benchmarks/bumpy.py``; prints Markdown and
writes docs/images/bumpy.png.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from skinshade.lut import Lut, build_curvature_lut
from skinshade.lut.classic import classic_curvature_lut
from skinshade.profile import Profile
from skinshade.shading import classic
from skinshade.shading.direct import direct_tensor, directional_curvature
from skinshade.shading.normals import blend_normals, normal_blend

ROOT = Path(__file__).resolve().parents[1]
PERIODS_MM = (0.5, 1.0, 2.0, 4.0)
"""From a pore to a wrinkle, each with the same share of the slopes."""
CLASSIC_BLUR_MM = 1.35
"""The mip level of 2014 has texels as wide as its diffusion radius of 2.7 mm: twice this σ."""
MODELS = ("lambert", "classic", "2 fetches", "3 fetches")


@dataclass(frozen=True)
class BumpyCylinder:
    """A cylinder with relief all over it, lit across its axis or obliquely.

    Attributes
    ----------
    radius_mm
        Of the cylinder.
    slope
        RMS slope of the relief.
    tilt
        Angle of the light out of the plane across the axis, radians.
    size
        Texels (along the axis, around it).
    """

    radius_mm: float
    slope: float
    tilt: float = 0.0
    size: tuple[int, int] = (512, 1024)

    @property
    def cell_mm(self) -> float:
        """Side of a texel, mm."""
        return 2.0 * np.pi * self.radius_mm / self.size[1]

    @cached_property
    def frequencies(self) -> tuple[np.ndarray, np.ndarray]:
        """Spatial frequencies along both axes, rad/mm, as `numpy.fft.rfft2` orders them."""
        along = 2.0 * np.pi * np.fft.fftfreq(self.size[0], self.cell_mm)
        around = 2.0 * np.pi * np.fft.rfftfreq(self.size[1], self.cell_mm)
        return along[:, None], around[None, :]

    @cached_property
    def tangent_normals(self) -> np.ndarray:
        """(H, W, 3) unit normals of random relief, as a normal map holds them."""
        along, around = self.frequencies
        k = np.hypot(along, around)
        rng, total = np.random.default_rng(1), np.zeros(k.shape, dtype=complex)
        for period in PERIODS_MM:
            octaves = np.log(np.maximum(k, 1e-9) * period / (2.0 * np.pi))
            band = np.fft.rfft2(rng.normal(size=self.size)) * np.exp(-0.5 * (octaves / 0.25) ** 2)
            total += band / np.hypot(*self._slopes(band)).std()
        slopes = self._slopes(total)
        scale = self.slope / np.sqrt(np.mean(slopes[0] ** 2 + slopes[1] ** 2))
        n = np.stack([-scale * slopes[0], -scale * slopes[1], np.ones(self.size)], axis=-1)
        return n / np.linalg.norm(n, axis=-1, keepdims=True)

    @cached_property
    def frame(self) -> np.ndarray:
        """(W, 3 axes, 3): around, along and out of the cylinder at each column."""
        phi = np.arange(self.size[1]) * 2.0 * np.pi / self.size[1]
        zero, one = np.zeros_like(phi), np.ones_like(phi)
        around = np.stack([np.cos(phi), zero, -np.sin(phi)], axis=-1)
        outward = np.stack([np.sin(phi), zero, np.cos(phi)], axis=-1)
        return np.stack([around, np.stack([zero, one, zero], axis=-1), outward], axis=1)

    @property
    def light(self) -> np.ndarray:
        """(3,) unit, towards the light."""
        return np.array([0.0, np.sin(self.tilt), np.cos(self.tilt)])

    def world(self, tangent: np.ndarray) -> np.ndarray:
        """Return (H, W, 3) vectors of the map as vectors of the world."""
        return np.einsum("hwi,wij->hwj", tangent, self.frame)

    def blurred(self, sigma_mm: float) -> np.ndarray:
        """Return the map blurred by a Gaussian, in world axes, unnormalised."""
        along, around = self.frequencies
        damping = np.exp(-0.5 * sigma_mm**2 * (along**2 + around**2))[..., None]
        spectrum = np.fft.rfft2(self.tangent_normals, axes=(0, 1)) * damping
        return self.world(np.fft.irfft2(spectrum, self.size, axes=(0, 1)))

    def truth(self, profile: Profile) -> np.ndarray:
        """Return (H, W, 3) the light on the relief, diffused over the cylinder."""
        light = np.maximum(self.world(self.tangent_normals) @ self.light, 0.0)
        spectrum = np.fft.rfft2(light)[..., None] * profile.transfer(np.hypot(*self.frequencies))
        return np.fft.irfft2(spectrum, self.size, axes=(0, 1))

    def _slopes(self, height: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        along, around = self.frequencies
        return (
            np.fft.irfft2(1j * around * height, self.size),
            np.fft.irfft2(1j * along * height, self.size),
        )


def shaded(body: BumpyCylinder, profile: Profile, ring: Lut, old: Lut) -> dict[str, np.ndarray]:
    """Return (H, W, 3) of each of `MODELS`."""
    sharp = body.world(body.tangent_normals)
    light = np.broadcast_to(body.light, sharp.shape)
    kappa = np.full(body.size, 1.0 / body.radius_mm)
    lambert = np.maximum(sharp @ body.light, 0.0)
    result = {"lambert": np.repeat(lambert[..., None], 3, axis=-1)}
    wide = body.blurred(CLASSIC_BLUR_MM)
    wide /= np.linalg.norm(wide, axis=-1, keepdims=True)
    result["classic"] = classic.direct(old, sharp, wide, light, kappa)
    around = body.frame[:, 0] / np.sqrt(body.radius_mm)
    tensor = np.stack(
        [around[:, i] * around[:, j] for i, j in ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))],
        axis=-1,
    )
    outward = np.broadcast_to(body.frame[:, 2], sharp.shape)
    bends = directional_curvature(np.broadcast_to(tensor, (*body.size, 6)), outward, light)
    for fetches in (2, 3):
        blend = normal_blend(profile, fetches=fetches)
        fetched = np.stack([sharp, *(body.blurred(s) for s in blend.sigmas_mm)], axis=-2)
        seen = blend_normals(fetched, blend)
        result[f"{fetches} fetches"] = direct_tensor(
            ring, profile.kernel.transfer, seen, light, *bends, np.ones(3)
        )
    return result


def tables(profile: Profile) -> tuple[Lut, Lut]:
    """Return the tables that the models look up: the ring's, and that of 2014."""
    ring = build_curvature_lut(
        profile, size=(512, 128), radius_mm=(0.5, 4000.0), kernel="ring", energy_gain=False
    )
    return ring, classic_curvature_lut(profile)


def errors(body: BumpyCylinder, profile: Profile, ring: Lut, old: Lut) -> dict[str, float]:
    """Return the RMS difference of each of `MODELS` from the truth, of light 1."""
    truth = body.truth(profile)
    return {
        name: float(np.sqrt(np.mean(np.square(value - truth))))
        for name, value in shaded(body, profile, ring, old).items()
    }


CASES = [BumpyCylinder(r, s) for r in (8.0, 20.0) for s in (0.15, 0.3, 0.6)]
CASES.append(BumpyCylinder(8.0, 0.3, tilt=0.6))


def main() -> None:
    """Print the table and draw the picture."""
    profile = Profile.preset("skin-deon2007")
    made = tables(profile)
    rows = {}
    print("| radius, slope, tilt | " + " | ".join(MODELS) + " |\n|---|" + "---|" * len(MODELS))
    for body in CASES:
        found = errors(body, profile, *made)
        name = f"{body.radius_mm:g} mm, {body.slope:g}" + (f", {body.tilt:g}" if body.tilt else "")
        rows[name] = found
        print(f"| {name} | " + " | ".join(f"{found[model]:.4f}" for model in MODELS) + " |")
    draw(rows, BumpyCylinder(8.0, 0.3), profile, made)


def draw(
    rows: dict[str, dict[str, float]],
    body: BumpyCylinder,
    profile: Profile,
    made: tuple[Lut, Lut],
) -> None:
    """Write docs/images/bumpy.png: bars of every case, and one cut across the terminator."""
    from matplotlib.figure import Figure

    colours = dict(zip(MODELS, ("#9a9a9a", "#d08a2e", "#7fb3d5", "#1f6f8b"), strict=True))
    figure = Figure(figsize=(11.0, 8.0), layout="constrained")
    bars, *cuts = figure.subplots(3, 1, height_ratios=(1.1, 1.0, 1.0))
    at = np.arange(len(rows))
    for index, model in enumerate(MODELS):
        heights = [found[model] for found in rows.values()]
        bars.bar(at + 0.2 * (index - 1.5), heights, 0.19, color=colours[model], label=model)
    bars.set_xticks(at, list(rows))
    bars.set(
        ylabel="RMS error", title="Bumpy cylinders against exact diffusion (radius, RMS slope)"
    )
    bars.legend(frameon=False, ncols=4)
    truth, seen = body.truth(profile), shaded(body, profile, *made)
    row, place = 100, np.arange(body.size[1]) * body.cell_mm
    shown = (place > 6.0) & (place < 18.0)
    for axes, channel, name in ((cuts[0], 0, "red"), (cuts[1], 2, "blue")):
        for model in MODELS[1:]:
            cut = seen[model][row, shown, channel]
            axes.plot(place[shown], cut, color=colours[model], lw=1.4, label=model)
        axes.plot(place[shown], truth[row, shown, channel], color="black", lw=1.6, label="truth")
        axes.axvline(0.5 * np.pi * body.radius_mm, color="#cccccc", lw=0.8, zorder=0)
        axes.set(ylabel=f"{name} light", xlim=(6.0, 18.0), ylim=(-0.03, 0.95))
    cuts[0].set_title(f"Around a cylinder of {body.radius_mm:g} mm, slope {body.slope:g}")
    cuts[0].legend(frameon=False, ncols=4)
    cuts[1].set_xlabel("place around it (mm); the terminator is the grey line")
    figure.savefig(ROOT / "docs" / "images" / "bumpy.png", dpi=110)


if __name__ == "__main__":
    main()
