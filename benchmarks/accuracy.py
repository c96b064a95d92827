"""Compare pictures with a path-traced reference: FLIP and RMS of light, by shading, by term and by change.

Run as ``python benchmarks/accuracy.py``. It prints three Markdown tables and writes the FLIP error maps to
docs/images/flip.png. With ``--scene FILE --reference FILE`` it measures another scene of the schema, whose
reference is an EXR with R, G, B and coverage; ``--tables`` selects some of the tables.

Both pictures are linear light in float32, filtered like Cycles filters its samples, and go through the tone
curve of the scene in float.
"""

from __future__ import annotations

import argparse
import copy
import json
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import flip_evaluator
import numpy as np
from numpy.typing import NDArray

import skinshade as sk
from skinshade.cli.compare import side_by_side
from skinshade.params.choices import AmbientForm
from skinshade.params.vertex import column_slices
from skinshade.rendering.cpu.renderer import CpuRenderer
from skinshade.rendering.tone import display_values
from skinshade.scene.images import read_image, write_png

ROOT = Path(__file__).resolve().parents[1]
DATA = Path(os.environ.get("SKINSHADE_DATA", ROOT.parent / "shared" / "data"))
SCENE = "scene-head-v1.json"
REFERENCE, SECOND_REFERENCE, PASSES = (
    f"reference/cycles_skin_front_{name}.exr" for name in ("512spp_dn", "128spp", "passes_640")
)
SHADINGS = ("lambert", "classic", "transfer")
FINER = 2
"""Ratio of the side of a drawn picture to that of the reference. Pictures of 3 have the same FLIP to 1e-5."""
FILTER_PIXELS = 3
"""Width of Cycles' pixel filter "Blackman-Harris, 1.5 pixels": ±1.5 pixels. With it, coverage is that of the
reference to 2.5e-5 (6 × 6 samples a pixel); with a box to 1.8e-4, with ±1 and ±2 pixels to 2.2e-4."""
BLACKMAN_HARRIS = (0.35875, -0.48829, 0.14128, -0.01168)
"""Cosine coefficients of the window [Harris1978]."""
COVERED = 0.99
"""Least coverage, in both pictures, of the pixels whose light is compared."""
HEAD = (slice(20, 720), slice(400, 920))
"""Rows and columns of the picture that the error maps show."""
PASS_NAMES = ("diffuse_direct", "diffuse_indirect", "glossy_direct", "glossy_indirect")
PASS_CHANNELS = 16
"""Channels of the file of passes: coverage, colour, and three for each of `PASS_NAMES`."""

Image = NDArray[np.float32]


@dataclass(frozen=True)
class Case:
    """A scene, the file that describes it, the settings of its picture, and its ambient light."""

    file: Path
    scene: sk.Scene
    settings: sk.RenderSettings
    ambient: str = "static"
    bounces: bool = True


@dataclass(frozen=True)
class Score:
    """Error of a picture: mean FLIP, its map (H, W, 3), and the RMS (3,) of linear light."""

    flip: float
    error_map: NDArray[np.float64]
    rms: NDArray[np.float64]


# -- changes ---------------------------------------------------------------------------------------


def sun_in_the_sky(case: Case) -> Case | None:
    """Return the case without the extraction of the sun; None if there is no environment."""
    environment = case.scene.environment
    if environment is None:
        return None
    whole = replace(environment, extract_sun=False)
    return replace(case, scene=replace(case.scene, environment=whole))


def diffuse_mean_free_path(case: Case) -> Case | None:
    """Return the case with the radius of Blender's closure read as a diffuse mean free path.

    None if the file does not give such a radius.
    """
    profile = json.loads(case.file.read_text(encoding="utf-8"))["material"].get("profile") or {}
    if profile.get("length_kind") != "blender-skin-radius":
        return None
    other = sk.Profile.burley(
        length_mm=profile["length_mm"],
        kind="diffuse-mean-free-path",
        albedo=case.scene.material.profile.albedo,
    )
    return replace(case, scene=case.scene.with_profile(other))


def with_settings(**changes: object) -> Callable[[Case], Case]:
    """Return a change of some settings."""
    return lambda case: replace(case, settings=replace(case.settings, **changes))  # type: ignore[arg-type]  # of any field


def with_params(**changes: object) -> Callable[[Case], Case]:
    """Return a change of some parameters of the skin."""
    return lambda case: replace(case, scene=case.scene.with_params(**changes))


CHANGES: Mapping[str, Callable[[Case], Case | None]] = {
    "sun stays in the sky": sun_in_the_sky,
    "length as diffuse mean free path": diffuse_mean_free_path,
    "sky by harmonics of order 2": lambda case: replace(case, ambient="order-2"),
    "sky by harmonics of order 4": lambda case: replace(case, ambient="order-4"),
    "no bounced light": lambda case: replace(case, bounces=False),
    "view factor of a smooth boundary": with_params(boundary="smooth"),
    "Blinn-Phong lobes": with_params(specular="blinn-phong"),
    "two GGX lobes": with_params(specular="ggx-two-lobes"),
    "tier tensor": with_settings(tier="tensor"),
    "tier scalar": with_settings(tier="scalar"),
    "contact shadow off": with_settings(contact_shadow=False),
    "deep scatter off": with_settings(deep_scatter_taps=0),
}
"""Changes of `transfer`, each of which is measured alone. A change returns None if it does not apply."""

# -- pictures --------------------------------------------------------------------------------------


def filtered(image: Image, finer: int = FINER) -> Image:
    """Return an image (H, W, C) from one that is `finer` times as high and wide, by Cycles' pixel filter.

    The filter is the product of two Blackman-Harris windows; pixels at the border repeat.
    """
    taps = FILTER_PIXELS * finer
    phase = 2.0 * np.pi * (np.arange(taps) + 0.5) / taps
    weights = sum(c * np.cos(k * phase) for k, c in enumerate(BLACKMAN_HARRIS))
    weights = (weights / weights.sum()).astype(np.float32)
    beside = (taps - finer) // 2
    for axis in (0, 1):
        pads = [(beside, beside) if axis == other else (0, 0) for other in range(3)]
        rows = np.moveaxis(np.pad(image, pads, mode="edge"), axis, 0)
        count = image.shape[axis]
        total = weights[0] * rows[0:count:finer]
        for tap in range(1, taps):
            total += weights[tap] * rows[tap : tap + count : finer]
        image = np.moveaxis(total, 0, axis)
    return image


def drawn(
    renderer: CpuRenderer, settings: Sequence[sk.RenderSettings], size: tuple[int, int]
) -> list[Image]:
    """Return pictures (H, W, 4) of the scene of a renderer, filtered."""
    finer = (FINER * size[0], FINER * size[1])
    return [
        filtered(image) for image in renderer.draw_many(renderer.scene.camera, finer, 1, settings)
    ]


def read_reference(path: Path, background: NDArray[np.float64]) -> Image:
    """Return a reference (H, W, 4) over a background (3,); files without one are over black."""
    image = read_image(path, 4)
    if not np.median(image[image[..., 3] == 0.0, :3]) > 0.0:
        image[..., :3] += (1.0 - image[..., 3:]) * background.astype(np.float32)
    return image


def score(reference: Image, image: Image, case: Case) -> Score:
    """Return the error of a picture (H, W, 4)."""
    shown = [
        display_values(part, case.scene, case.settings).astype(np.float32)
        for part in (reference, image)
    ]
    error_map, flip, _ = flip_evaluator.evaluate(*shown, "LDR")
    return Score(flip, np.asarray(error_map, dtype=np.float64), rms(reference, image))


def rms(reference: Image, image: Image) -> NDArray[np.float64]:
    """Return the RMS (3,) of the difference of light in pixels that both images (H, W, 4) cover."""
    covered = (reference[..., 3] > COVERED) & (image[..., 3] > COVERED)
    difference = (image[..., :3] - reference[..., :3])[covered].astype(np.float64)
    return np.sqrt(np.square(difference).mean(axis=0))


# -- terms -----------------------------------------------------------------------------------------


def read_passes(path: Path) -> dict[str, Image]:
    """Return the light of each of `PASS_NAMES`, and coverage, (H, W, 4)."""
    image = read_image(path, PASS_CHANNELS)
    starts = range(4, PASS_CHANNELS, 3)
    return {
        name: np.concatenate([image[..., start : start + 3], image[..., :1]], axis=-1)
        for name, start in zip(PASS_NAMES, starts, strict=True)
    }


def light_of_passes(
    renderer: CpuRenderer, settings: sk.RenderSettings, size: tuple[int, int]
) -> dict[str, Image]:
    """Return the light of each of `PASS_NAMES` and coverage, (H/2, W/2, 4), over black.

    The size (W, H) is that of the reference; the passes are means of 2×2 of its pixels.
    Cycles counts light of the sky as direct. Indirect light is the difference between the ambient terms with
    and without light that the body bounces.
    """
    bounces = ("ambient", "ambient-specular")
    others = ("direct", "deep-scatter", "ambient-deep-scatter", "specular")
    views = {name: replace(settings, debug_view=name) for name in (*bounces, *others)}
    images = drawn(renderer, list(views.values()), size)
    terms = {name: _halved(image) for name, image in zip(views, images, strict=True)}
    images = drawn(_without_bounced_light(renderer), [views[name] for name in bounces], size)
    once = {name: _halved(image) for name, image in zip(bounces, images, strict=True)}
    coverage = terms["direct"][..., 3:]
    # Every view has the background, which the passes do not have.
    behind = (1.0 - coverage) * renderer.scene.background.astype(np.float32)

    def total(*images: Image) -> Image:
        light = sum(image[..., :3] - behind for image in images)
        return np.concatenate([light, coverage], axis=-1)

    direct = [terms[name] for name in ("direct", "deep-scatter", "ambient-deep-scatter")]
    result = {
        "diffuse_direct": total(*direct, once["ambient"]),
        "glossy_direct": total(terms["specular"], once["ambient-specular"]),
    }
    for name, view in (("diffuse_indirect", "ambient"), ("glossy_indirect", "ambient-specular")):
        light = terms[view][..., :3] - once[view][..., :3]
        result[name] = np.concatenate([light, coverage], axis=-1)
    return result


def _without_bounced_light(renderer: CpuRenderer) -> CpuRenderer:
    """Return a renderer of the same scene in which the body does not light itself."""
    prepared = renderer.prepared
    values = prepared.vertices.values.copy()
    values[:, column_slices()["bounced"]] = 0.0
    other = copy.copy(renderer)
    other.prepared = replace(prepared, vertices=replace(prepared.vertices, values=values))
    return other


# -- tables ----------------------------------------------------------------------------------------


def numbers(values: NDArray[np.float64]) -> str:
    return " ".join(f"{value:.4f}" for value in values)


def measure_shadings(case: Case, reference: Image, second: Image | None = None) -> dict[str, Score]:
    """Return the error of each shading, and of a second reference, which is the noise of path tracing."""
    size = (reference.shape[1], reference.shape[0])
    variants = [replace(case.settings, shading=name) for name in SHADINGS]
    images = drawn(CpuRenderer(case.scene), variants, size)
    scores = {
        name: score(reference, image, case) for name, image in zip(SHADINGS, images, strict=True)
    }
    if second is not None:
        scores["path tracing again"] = score(reference, second, case)
    return scores


def shading_table(scores: Mapping[str, Score]) -> str:
    """Return a table of FLIP and RMS."""
    head = "| shading | FLIP | RMS of linear light, R G B |\n|---|---|---|"
    rows = [f"| {name} | {one.flip:.4f} | {numbers(one.rms)} |" for name, one in scores.items()]
    return "\n".join([head, *rows])


def measure_changes(case: Case, reference: Image) -> dict[str, Score]:
    """Return the error of `transfer`, and that with each of `CHANGES` which applies."""
    size = (reference.shape[1], reference.shape[0])
    cases = {"transfer": case}
    for name, change in CHANGES.items():
        changed = change(case)
        if changed is not None:
            cases[name] = changed
    scores = {}
    keys = {name: (id(one.scene), one.ambient, one.bounces) for name, one in cases.items()}
    for key in dict.fromkeys(keys.values()):
        group = {name: one for name, one in cases.items() if keys[name] == key}
        first = next(iter(group.values()))
        renderer = CpuRenderer(first.scene, ambient=AmbientForm.of(first.ambient, "ambient"))
        if not first.bounces:
            renderer = _without_bounced_light(renderer)
        images = drawn(renderer, [one.settings for one in group.values()], size)
        for (name, one), image in zip(group.items(), images, strict=True):
            scores[name] = score(reference, image, one)
    return {name: scores[name] for name in cases}


def change_table(scores: Mapping[str, Score]) -> str:
    """Return a table of FLIP, its difference from that of `transfer`, and RMS."""
    head = "| change | FLIP | more by | RMS of linear light, R G B |\n|---|---|---|---|"
    base = scores["transfer"].flip
    rows = [
        f"| {name} | {one.flip:.4f} | {one.flip - base:+.4f} | {numbers(one.rms)} |"
        for name, one in scores.items()
    ]
    return "\n".join([head, *rows])


def term_table(passes: Mapping[str, Image], light: Mapping[str, Mapping[str, Image]]) -> str:
    """Return a table of the mean light of each pass and of its RMS by shading."""
    lines = ["| light | mean | " + " | ".join(light) + " |", "|---" * (len(light) + 2) + "|"]
    for name, reference in passes.items():
        mean = reference[..., :3][reference[..., 3] > COVERED].mean(axis=0, dtype=np.float64)
        errors = [numbers(rms(reference, terms[name])) for terms in light.values()]
        lines.append(f"| {name.replace('_', ' ')} | {numbers(mean)} | {' | '.join(errors)} |")
    return "\n".join(lines)


def error_maps(
    case: Case,
    scores: Mapping[str, Score],
    passes: Mapping[str, Image],
    light: Mapping[str, Mapping[str, Image]],
) -> NDArray[np.uint8]:
    """Return FLIP error maps: pictures, diffuse light and reflections in rows, shadings in columns."""
    halved = tuple(slice(part.start // 2, part.stop // 2) for part in HEAD)
    rows = [[_halved(scores[name].error_map[HEAD]) for name in light]]
    for kind in ("diffuse", "glossy"):
        names = [name for name in passes if name.startswith(kind)]
        rows.append(
            [
                score(_sum(passes, names), _sum(terms, names), case).error_map[halved]
                for terms in light.values()
            ]
        )
    labels = ("", ", diffuse", ", reflections")
    return np.concatenate(
        [
            side_by_side(row, [name + label for name in light])
            for row, label in zip(rows, labels, strict=True)
        ]
    )


def _sum(images: Mapping[str, Image], names: Sequence[str]) -> Image:
    """Return the sum of the light of some images (H, W, 4), with their coverage."""
    light = sum(images[name][..., :3] for name in names)
    return np.concatenate([light, images[names[0]][..., 3:]], axis=-1)


def _halved(image: NDArray[np.floating]) -> NDArray[np.floating]:
    """Return an image of half the height and width."""
    height, width, channels = image.shape
    return image.reshape(height // 2, 2, width // 2, 2, channels).mean(axis=(1, 3))


def main(arguments: Sequence[str] | None = None) -> None:
    """Print the tables and write the error maps."""
    parser = argparse.ArgumentParser(description="Compare pictures with a path-traced reference.")
    parser.add_argument("--scene", type=Path, help="scene in JSON")
    parser.add_argument("--reference", type=Path, help="EXR with R, G, B and coverage")
    parser.add_argument("--light", action="append", help="name of a light to turn on")
    tables = ("shadings", "terms", "changes")
    parser.add_argument("--tables", nargs="+", choices=tables, default=tables)
    given = parser.parse_args(arguments)
    if (given.scene is None) != (given.reference is None):
        parser.error("give both --scene and --reference, or neither")
    own = given.scene is not None
    file = given.scene or DATA / SCENE
    case = Case(file, sk.load_scene(file, lights=given.light), sk.RenderSettings())
    background = case.scene.background
    reference = read_reference(given.reference or DATA / REFERENCE, background)
    second = None if own else read_reference(DATA / SECOND_REFERENCE, background)
    if "shadings" in given.tables:
        scores = measure_shadings(case, reference, second)
        print(shading_table(scores), end="\n\n")
    if "terms" in given.tables and not own:
        passes = read_passes(DATA / PASSES)
        size = (reference.shape[1], reference.shape[0])
        renderer = CpuRenderer(case.scene)
        light = {
            name: light_of_passes(renderer, replace(case.settings, shading=name), size)
            for name in SHADINGS
        }
        print(term_table(passes, light), end="\n\n")
        if "shadings" in given.tables:
            maps = error_maps(case, scores, passes, light)
            write_png(ROOT / "docs" / "images" / "flip.png", maps)
    if "changes" in given.tables:
        print(change_table(measure_changes(case, reference)))


if __name__ == "__main__":
    main()
