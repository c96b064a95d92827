"""``skinshade profile``: list the diffusion profiles, show one, plot it."""

from __future__ import annotations

from pathlib import Path

import typer

from .._core.errors import ArgumentError, OutputError
from .._core.files import atomic_write
from ..profile import Profile, presets
from ..profile.presets import preset_record

__all__ = ["profile_command"]


LARGEST_SCALE = 1e6


def profile_command(
    name: str = typer.Argument(None, help="Which to show; all are listed without it."),
    output: Path = typer.Option(None, "--output", "-o", help="Plot R(r) and T(k) to this PNG."),
    scale: float = typer.Option(1.0, help="Multiply every length."),
) -> None:
    """List the diffusion profiles, show one, or plot it."""
    if name is None:
        for each in presets():
            record = preset_record(each)
            rms = "  ".join(f"{value:6.3f}" for value in Profile.preset(each).rms_radius_mm)
            typer.echo(
                f"{each:<14} {record['kind']:<10} rms {rms} mm  {record['about']} [{record['source']}]"
            )
        return
    if not 0.0 < scale <= LARGEST_SCALE:
        raise ArgumentError(f"--scale is {scale}; it must be positive, {LARGEST_SCALE:g} at most")
    chosen = Profile.preset(name).scaled(scale)
    for label, values, unit in (
        ("albedo", chosen.albedo, ""),
        ("rms radius", chosen.rms_radius_mm, " mm"),
    ):
        typer.echo(f"{label:<12}" + "  ".join(f"{value:.4f}" for value in values) + unit)
    typer.echo(f"{'kind':<12}{preset_record(name)['kind']}, from {chosen.source}")
    fit = chosen.mixture_residual
    typer.echo(f"{'Gaussians':<12}{chosen.mixture.variances_mm2.size}, |ΔT| ≤ {fit:.1e}")
    if output is not None:
        _plot(chosen, name, output)


def _plot(profile: Profile, name: str, output: Path) -> None:
    import numpy as np
    from matplotlib.figure import Figure

    if output.suffix.lower() != ".png":
        raise OutputError(f"{output}: a plot is saved as .png")
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
