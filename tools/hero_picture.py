"""Picture at the top of the README: a head, and details of it without and with scattering.

``python tools/hero_picture.py docs/images/hero.png``. All parts are cut from two renders of one scene with
one exposure; details are enlarged twice as much as the whole head.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

import skinshade as sk
from skinshade.params.choices import ToneCurve
from skinshade.shading.tonemap import tonemap

SIZE = (1120, 1680)
DETAIL = 280
DETAILS = {
    "terminator": (0.66, 0.52),
    "shadow of the nose": (0.38, 0.58),
    "ear, lit from behind": (0.86, 0.47),
}
"""Centres of the details, as shares of the width and height of the render."""
LIGHTS = (
    sk.DirectionalLight.from_angles(-38.0, 26.0, 0.75),
    sk.DirectionalLight.from_angles(152.0, 12.0, 1.6),
)


def main() -> None:
    """Write the picture to the path on the command line."""
    head = sk.builtin_head()
    scene = replace(sk.head_scene(head), lights=LIGHTS)
    renderer = sk.open_renderer(scene)
    settings = [sk.RenderSettings(shading="lambert", deep_scatter_taps=0), sk.RenderSettings()]
    plain, skin = (
        Image.fromarray(_display(image, scene))
        for image in renderer.draw_many(scene.camera, SIZE, 4, settings)
    )
    width = SIZE[0] // 2 + 2 * DETAIL
    sheet = Image.new("RGB", (width, SIZE[1] // 2))
    sheet.paste(skin.resize((SIZE[0] // 2, SIZE[1] // 2), Image.Resampling.LANCZOS))
    draw, font = ImageDraw.Draw(sheet), ImageFont.load_default(17)
    for row, (label, centre) in enumerate(DETAILS.items()):
        left, top = (
            round(share * side) - DETAIL // 2 for share, side in zip(centre, SIZE, strict=True)
        )
        for column, source in enumerate((plain, skin)):
            x, y = SIZE[0] // 2 + column * DETAIL, row * DETAIL
            sheet.paste(source.crop((left, top, left + DETAIL, top + DETAIL)), (x, y))
            kind = ("without scattering", "skinshade")[column]
            text = f"{label}\n{kind}" if column == 0 else kind
            draw.multiline_text(
                (x + 8, y + DETAIL - 8),
                text,
                fill="white",
                font=font,
                anchor="ld",
                stroke_width=2,
                stroke_fill="black",
            )
    sheet.save(Path(sys.argv[1]))


def _display(image: np.ndarray, scene: sk.Scene) -> np.ndarray:
    display = tonemap(image[..., :3].astype(np.float64), ToneCurve(scene.tone), scene.exposure)
    return np.rint(display * 255.0).astype(np.uint8)


if __name__ == "__main__":
    main()
