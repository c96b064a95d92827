"""Pictures beside path tracing: a FLIP table of each shading, and its error map as a picture.

Run as ``python benchmarks/accuracy.py``; writes docs/images/flip.png and prints Markdown.
"""

from __future__ import annotations

import os
from pathlib import Path

import flip_evaluator
import numpy as np

import skinshade as sk
from skinshade.cli.compare import side_by_side
from skinshade.render.renderer import display, open_renderer
from skinshade.scene.images import read_image, write_png

ROOT = Path(__file__).resolve().parents[1]
DATA = Path(os.environ.get("SKINSHADE_DATA", ROOT.parent / "shared" / "data"))
SIZE, SAMPLES = (1280, 720), 4
FRAME = (slice(20, 720), slice(400, 920))


def main() -> None:
    reference = read_image(DATA / "reference" / "cycles_skin_front_128spp.png")
    light = read_image(DATA / "reference" / "cycles_skin_front_128spp.exr")
    scene_file = DATA / "scene-head.json"
    scene = sk.load_scene(scene_file if scene_file.exists() else DATA.parent / "scene-head.json")
    renderer = open_renderer(scene)
    maps = []
    print("| shading | FLIP | RMS of linear light, R G B |\n|---|---|---|")
    labels = ["lambert", "classic", "transfer"]
    ways = [sk.RenderSettings(shading=shading) for shading in labels]
    images = renderer.draw_each(scene.camera, SIZE, SAMPLES, ways)
    for shading, settings, image in zip(labels, ways, images, strict=True):
        picture = display(image, scene, settings).astype(np.float32)
        error, mean, _ = flip_evaluator.evaluate(reference, picture, "LDR")
        inside = image[..., 3] > 0.99
        rms = np.sqrt(np.square(image[..., :3] - light)[inside].mean(axis=0))
        print(f"| {shading} | {mean:.4f} | {rms[0]:.4f} {rms[1]:.4f} {rms[2]:.4f} |")
        maps += [np.asarray(error[FRAME], dtype=np.float64)]
    write_png(ROOT / "docs" / "images" / "flip.png", side_by_side(maps, labels))


if __name__ == "__main__":
    main()
