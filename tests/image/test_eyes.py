"""Refraction and light on the iris by the methods of benchmarks/eyes.py."""

from __future__ import annotations

import numpy as np
import pytest

from benchmark_scripts import benchmark
from skinshade.shading.eye_tables import build_eye_lut

eyes = benchmark("eyes")


@pytest.mark.slow
def test_the_model_shows_the_iris_more_exactly_than_a_plane_a_height_map_and_the_surface():
    rms = {name: np.sqrt(np.mean(np.square(row))) for name, row in eyes.refraction_table().items()}
    for other in ("HDRP, best plane", "HDRP, default depth", "UE, true height map"):
        assert rms["index 1.340"] < 0.2 * rms[other], other
    assert rms["index 1.340"] < rms["index 1.336"]
    assert max(rms, key=rms.get) == "iris on the surface"


@pytest.mark.slow
def test_the_table_of_a_lamp_errs_less_than_a_cosine_at_every_angle():
    rows = eyes.light_table(build_eye_lut().lamp, 60_000)
    assert all(table < 0.5 * cosine for _, cosine, table, _ in rows)
