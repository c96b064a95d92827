"""Profiles of your own: creature skin from mean free paths, compared with human skin and marble."""

import sys
from pathlib import Path

import numpy as np

import skinshade as sk

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")

creature = sk.Profile.burley(
    length_mm=(0.4, 1.8, 0.7), kind="diffuse-mean-free-path", albedo=(0.25, 0.55, 0.30)
)
for name, profile in (
    ("skin-deon2007", sk.Profile.preset("skin-deon2007")),
    ("marble", sk.Profile.preset("marble")),
    ("creature", creature),
):
    lut = sk.build_curvature_lut(profile, size=(256, 64))
    lut.save(folder / f"curvature-{name}.png")
    # Light of a body of 8 mm radius just past the terminator, per channel.
    past = lut.sample(np.array(-0.1), np.array(1.0 / 8.0))
    print(
        f"{name:<14} rms {np.round(profile.rms_radius_mm, 2)} mm, past the terminator {past.round(3)}"
    )
