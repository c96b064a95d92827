"""``skinshade profile``: numbers and plots of diffusion profiles."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import numpy as np
import typer

from .._core.errors import ArgumentError, OutputError
from .._core.files import atomic_write
from ..profile import Profile, presets
from ..profile.presets import preset_record
from .terminal import echo
from .values import check_output

__all__ = ["profile_command"]

LARGEST_SCALE = 1e6


def profile_command(
    name: Annotated[
        str | None, typer.Argument(help="Name of a profile; without it, all profiles are listed.")
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option(
            "--output",
            "-o",
            callback=check_output,
            help="PNG for a plot of R(r) and T(k).",
        ),
    ] = None,
    scale: Annotated[float, typer.Option(help="Factor of every length.")] = 1.0,
) -> None:
    """List the diffusion profiles, print the numbers of one, or plot it."""
    if name is None:
        _list()
        return
    if not 0.0 < scale <= LARGEST_SCALE:
        raise ArgumentError(f"--scale is {scale}; it must be above 0 and at most {LARGEST_SCALE:g}")
    profile = Profile.preset(name).scaled(scale)
    mixture, residual = profile.gaussian_fit()
    rows = {
        "albedo": _row(profile.albedo),
        "rms radius": f"{_row(profile.rms_radius_mm)} mm",
        "kind": f"{preset_record(name)['kind']}, from {profile.source}",
        "Gaussians": f"{mixture.variances_mm2.size}, |ΔT| ≤ {residual:.1e}",
    }
    for label, text in rows.items():
        echo(f"{label:<12}{text}")
    if output is not None:
        _plot(profile, name, output)


def _list() -> None:
    for name in presets():
        record = preset_record(name)
        rms = "  ".join(f"{value:6.3f}" for value in Profile.preset(name).rms_radius_mm)
        echo(
            f"{name:<14} {record['kind']:<10} rms {rms} mm  {record['about']} [{record['source']}]"
        )


def _row(values: np.ndarray) -> str:
    return "  ".join(f"{value:.4f}" for value in values)


def _plot(profile: Profile, name: str, output: Path) -> None:
    from matplotlib.figure import Figure

    if output.suffix.lower() != ".png":
        raise OutputError(f"{output}: suffix {output.suffix!r}; it must be .png")
    figure = Figure(figsize=(10.0, 4.0), layout="constrained")
    left, right = figure.subplots(1, 2)
    rms = profile.rms_radius_mm
    r = np.geomspace(rms.min() * 0.02, rms.max() * 6.0, 400)
    k = np.geomspace(0.02 / rms.max(), 60.0 / rms.min(), 400)
    radial, transfer = profile.radial(r), profile.transfer(k)
    for channel, colour in enumerate(("#c0392b", "#2e8b57", "#2e5fab")):
        left.loglog(r, radial[:, channel], color=colour, label="RGB"[channel])
        right.semilogx(k, transfer[:, channel], color=colour)
    left.set(xlabel="r (mm)", ylabel="R(r) (1/mm²)", ylim=(radial.max() * 1e-7, radial.max() * 2.0))
    right.set(xlabel="k (rad/mm)", ylabel="T(k)", ylim=(0.0, 1.05))
    left.legend(frameon=False)
    figure.suptitle(f"{name}: diffusion profile and transfer function")
    with atomic_write(output) as temporary:
        figure.savefig(temporary, dpi=120, format="png")
