"""Compare pictures with a path-traced reference: FLIP and RMS of each lighting model.

Run as ``python benchmarks/accuracy.py``. It prints a Markdown table and writes the FLIP error maps to
docs/images/flip.png.
"""

from __future__ import annotations

import os
from pathlib import Path

import flip_evaluator
import numpy as np

import skinshade as sk
from skinshade.cli.compare import side_by_side
from skinshade.rendering.tone import display_values
from skinshade.scene.images import read_image, write_png

ROOT = Path(__file__).resolve().parents[1]
DATA = Path(os.environ.get("SKINSHADE_DATA", ROOT.parent / "shared" / "data"))
SIZE, SAMPLES = (1280, 720), 4
HEAD = (slice(20, 720), slice(400, 920))
"""Rows and columns of the picture that the error maps show."""
COVERED = 0.99
"""Least coverage of the pixels whose linear light is compared."""


def main() -> None:
    """Print the table and write the error maps."""
    reference = read_image(DATA / "reference" / "cycles_skin_front_128spp.png")
    reference_light = read_image(DATA / "reference" / "cycles_skin_front_128spp.exr")
    scene = sk.load_scene(DATA / "scene-head-v1.json")
    variants = [sk.RenderSettings(shading=name) for name in ("lambert", "classic", "transfer")]
    labels = [settings.shading.value for settings in variants]
    images = sk.open_renderer(scene).draw_many(scene.camera, SIZE, SAMPLES, variants)
    error_maps = []
    print("| shading | FLIP | RMS of linear light, R G B |\n|---|---|---|")
    for label, settings, image in zip(labels, variants, images, strict=True):
        display = display_values(image, scene, settings).astype(np.float32)
        error_map, flip, _ = flip_evaluator.evaluate(reference, display, "LDR")
        difference = (image[..., :3] - reference_light)[image[..., 3] > COVERED]
        rms = np.sqrt(np.square(difference).mean(axis=0))
        print(f"| {label} | {flip:.4f} | {rms[0]:.4f} {rms[1]:.4f} {rms[2]:.4f} |")
        error_maps.append(np.asarray(error_map[HEAD], dtype=np.float64))
    write_png(ROOT / "docs" / "images" / "flip.png", side_by_side(error_maps, labels))


if __name__ == "__main__":
    main()
