"""Pictures of the scan compared with path tracing, as benchmarks/accuracy.py measures them."""

from __future__ import annotations

import re
from pathlib import Path

import flip_evaluator
import numpy as np
import pytest

import skinshade as sk
import tolerances as tol
from benchmark_scripts import benchmark
from skinshade.rendering.cpu.renderer import CpuRenderer
from skinshade.rendering.prepare.rasterizer import rasterize
from skinshade.scene.images import read_image

ROOT = Path(__file__).resolve().parents[2]
FINE = 4
"""Samples along a side of a pixel, of coverage."""
SHADINGS = ("lambert", "classic", "transfer")
FLOOR = "path tracing again"
ROW = re.compile(
    r"^\| (\w+[\w ]*?)(?: \(2014\))? \| \**([\d.]+)\** \| \**([\d. ]+?)\** \|$", re.MULTILINE
)
CHANGE = re.compile(r"^\| ([\w -]+) \| ([\d.]+) \| ([+-][\d.]+) \| ([\d. ]+) \|$", re.MULTILINE)


def rows(text):
    """Return FLIP and the RMS of red, green and blue (4,) of each row of a Markdown table."""
    return {
        name: np.array([flip, *rms.split()], dtype=np.float64)
        for name, flip, rms in ROW.findall(text)
        if name in (*SHADINGS, FLOOR)
    }


def flip(a, b):
    return flip_evaluator.evaluate(a, b, "LDR")[1]


@pytest.fixture(scope="module")
def accuracy(data_dir):
    """The benchmark, with the data of this machine."""
    module = benchmark("accuracy")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(module, "DATA", data_dir)
        yield module


@pytest.fixture(scope="module")
def case(accuracy):
    file = accuracy.DATA / accuracy.SCENE
    return accuracy.Case(file, sk.load_scene(file), sk.RenderSettings())


@pytest.fixture(scope="module")
def scores(accuracy, case):
    """The error of each shading, and that of a second render by the path tracer."""
    reference, second = (
        accuracy.read_reference(accuracy.DATA / name, case.scene.background)
        for name in (accuracy.REFERENCE, accuracy.SECOND_REFERENCE)
    )
    return accuracy.measure_shadings(case, reference, second)


@pytest.fixture(scope="module")
def measured(accuracy, scores):
    """The rows of the table that the benchmark prints."""
    return rows(accuracy.shading_table(scores))


@pytest.fixture(scope="module")
def renderer(case):
    """A renderer of the scene."""
    return CpuRenderer(case.scene)


@pytest.fixture(scope="module")
def references(data_dir):
    folder = data_dir / "reference"
    names = ("cycles_skin_front_128spp.png", "cycles_plain_front_32spp.png")
    return [read_image(folder / name) for name in names]


# -- figures ---------------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("name", SHADINGS)
def test_the_flip_of_a_shading_is_within_its_bound(measured, name):
    assert measured[name][0] <= tol.FLIP_OF_SHADING[name].value


@pytest.mark.slow
def test_two_path_traced_pictures_differ_less_than_any_shading(measured):
    assert 0.0 < measured[FLOOR][0] <= tol.FLIP_FLOOR.value
    assert all((measured[FLOOR] < measured[name]).all() for name in SHADINGS)


@pytest.mark.slow
def test_transfer_has_the_least_flip_and_classic_the_greatest(measured):
    error = {name: row[0] for name, row in measured.items()}
    assert error["transfer"] < error["lambert"] < error["classic"]


@pytest.mark.slow
def test_transfer_has_the_least_rms_of_every_channel_and_classic_the_greatest(measured):
    rms = {name: row[1:] for name, row in measured.items()}
    assert (rms["transfer"] < rms["lambert"]).all()
    assert (rms["lambert"] < rms["classic"]).all()


@pytest.mark.slow
@pytest.mark.parametrize("page", ["README.md", "docs/accuracy.md"])
def test_the_figures_of_the_pages_are_the_measured_ones(measured, page):
    published = rows((ROOT / page).read_text(encoding="utf-8"))
    assert published.keys() == measured.keys()
    for name, row in measured.items():
        digits = np.abs(published[name] - row) * 1e4
        assert digits.max() <= tol.PUBLISHED_DIGIT.value, f"{page}: {name} is {row}"


def test_the_page_has_every_change_of_the_benchmark():
    page = (ROOT / "docs" / "accuracy.md").read_text(encoding="utf-8")
    published = {name: (flip, more) for name, flip, more, _ in CHANGE.findall(page)}
    assert list(published) == ["transfer", *benchmark("accuracy").CHANGES]
    assert float(published["transfer"][0]) == rows(page)["transfer"][0]


@pytest.mark.slow
def test_the_committed_error_maps_have_the_size_and_the_order_of_the_measured_ones(
    accuracy, scores
):
    committed = read_image(ROOT / "docs" / "images" / "flip.png")
    height, width = scores["lambert"].error_map[accuracy.HEAD].shape[:2]
    assert committed.shape == (3 * height // 2, 3 * width // 2, 3)
    error = [part.mean() for part in np.split(committed[: height // 2], 3, axis=1)]
    assert error[2] < error[0] < error[1]


# -- the ruler -------------------------------------------------------------------------------------


def test_the_pixel_filter_keeps_even_light_and_is_symmetric(accuracy):
    even = accuracy.filtered(np.full((12, 20, 4), 0.3, dtype=np.float32))
    assert even.shape == (6, 10, 4)
    assert np.allclose(even, 0.3, atol=tol.FLOAT32.value)
    dot = np.zeros((14, 14, 1), dtype=np.float32)
    dot[6:8, 6:8] = 1.0
    spread = accuracy.filtered(dot)[..., 0]
    assert np.allclose(spread, spread[::-1, ::-1], atol=tol.FLOAT32.value)
    assert np.allclose(spread, spread.T, atol=tol.FLOAT32.value)
    assert np.count_nonzero(spread) == 9  # ±1.5 pixels


@pytest.mark.slow
def test_coverage_is_that_of_the_path_tracer_with_its_filter(accuracy, case):
    """The same samples, averaged over the pixel, differ from the reference four times as much."""
    reference = read_image(accuracy.DATA / accuracy.REFERENCE, 4)[..., 3]
    height, width = reference.shape
    size = (FINE * width, FINE * height)
    matrix = case.scene.camera.view_projection(width / height)
    clip = case.scene.mesh.positions_mm @ matrix[:, :3].T + matrix[:, 3]
    covered = np.zeros(size[0] * size[1], dtype=np.float32)
    covered[rasterize(clip, case.scene.mesh.faces, size, (0.5, 0.5)).pixel] = 1.0
    covered = covered.reshape(size[1], size[0], 1)
    boxed = covered.reshape(height, FINE, width, FINE).mean(axis=(1, 3))
    error = np.abs(accuracy.filtered(covered, FINE)[..., 0] - reference).mean()
    error_of_box = np.abs(boxed - reference).mean()
    assert error <= tol.PIXEL_FILTER.value
    assert error_of_box >= 2.0 * tol.PIXEL_FILTER.value


@pytest.mark.slow
def test_the_light_of_the_passes_adds_up_to_the_picture(accuracy, renderer, case):
    size = (160, 90)
    light = accuracy.light_of_passes(renderer, case.settings, size)
    picture = accuracy._halved(accuracy.drawn(renderer, [case.settings], size)[0])
    total = sum(part[..., :3] for part in light.values())
    background = (1.0 - picture[..., 3:]) * case.scene.background
    assert np.allclose(total + background, picture[..., :3], atol=tol.PASS_SUM.value)
    assert light["diffuse_indirect"].max() > 0.0


def test_a_reference_without_background_is_composited(accuracy, case):
    images = [
        accuracy.read_reference(accuracy.DATA / name, case.scene.background)
        for name in (accuracy.REFERENCE, accuracy.SECOND_REFERENCE)
    ]
    for image in images:
        assert np.allclose(image[0, 0], (0.05, 0.05, 0.05, 0.0))


def test_the_change_of_the_sun_does_not_apply_to_a_scene_without_a_sky(accuracy, case):
    dark = accuracy.replace(case.scene, environment=None)
    assert accuracy.sun_in_the_sky(accuracy.replace(case, scene=dark)) is None
    whole = accuracy.sun_in_the_sky(case)
    assert not whole.scene.environment.extract_sun


def test_the_change_of_the_length_gives_the_radius_of_a_diffuse_mean_free_path(accuracy, case):
    changed = accuracy.diffuse_mean_free_path(case).scene.material.profile
    digits = np.abs(changed.rms_radius_mm - (3.73, 1.46, 0.73)) * 100.0
    assert digits.max() <= tol.PUBLISHED_DIGIT.value


def test_flip_is_0_for_equal_pictures_and_rises_with_the_difference(references):
    skin = references[0][150:350, 560:760]  # brow, lid and half of the forehead
    assert flip(skin, skin) == 0.0
    errors = [flip(skin, skin * np.float32(1.0 - step)) for step in (0.01, 0.05, 0.2)]
    assert 0.0 < errors[0] < errors[1] < errors[2]


def test_the_flip_of_path_tracing_without_scattering_is_the_published_one(
    accuracy, case, references
):
    reference = accuracy.read_reference(accuracy.DATA / accuracy.REFERENCE, case.scene.background)
    shown = accuracy.display_values(reference, case.scene, case.settings)
    in_8_bits = (np.rint(shown * 255.0) / 255.0).astype(np.float32)
    page = (ROOT / "docs" / "accuracy.md").read_text(encoding="utf-8")
    published = re.search(r"without subsurface scattering.*?FLIP (0\.\d{3})\b", page, re.DOTALL)
    digits = abs(flip(in_8_bits, references[1]) - float(published[1])) * 1e3
    assert digits <= tol.PUBLISHED_DIGIT.value
