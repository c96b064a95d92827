"""Pictures of the scan compared with path tracing, as benchmarks/accuracy.py measures them."""

from __future__ import annotations

import re
from pathlib import Path

import flip_evaluator
import numpy as np
import pytest

import tolerances as tol
from benchmark_scripts import benchmark
from skinshade.scene.images import read_image

ROOT = Path(__file__).resolve().parents[2]
SHADINGS = ("lambert", "classic", "transfer")
ROW = re.compile(r"^\| (\w+)[\w() ]*\| \**([\d.]+)\** \| \**([\d. ]+?)\** \|$", re.MULTILINE)


def rows(text):
    """Return FLIP and the RMS of red, green and blue (4,) of each shading in a Markdown table."""
    numbers = {name: [flip, *rms.split()] for name, flip, rms in ROW.findall(text)}
    return {name: np.array(numbers[name], dtype=np.float64) for name in SHADINGS}


def flip(a, b):
    return flip_evaluator.evaluate(a, b, "LDR")[1]


@pytest.fixture(scope="module")
def measured(data_dir, tmp_path_factory):
    """The table that the benchmark prints, and the error maps that it writes."""
    accuracy, printed = benchmark("accuracy"), []
    folder = tmp_path_factory.mktemp("flip")
    (folder / "docs" / "images").mkdir(parents=True)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(accuracy, "ROOT", folder)
        patch.setattr(accuracy, "DATA", data_dir)
        patch.setattr("builtins.print", lambda *words: printed.append(" ".join(map(str, words))))
        accuracy.main()
    return rows("\n".join(printed)), read_image(folder / "docs" / "images" / "flip.png")


@pytest.fixture(scope="module")
def references(data_dir):
    folder = data_dir / "reference"
    names = ("cycles_skin_front_128spp.png", "cycles_plain_front_32spp.png")
    return [read_image(folder / name) for name in names]


@pytest.mark.slow
def test_transfer_has_the_least_flip_and_classic_the_greatest(measured):
    error = {name: row[0] for name, row in measured[0].items()}
    assert error["transfer"] < error["lambert"] < error["classic"]


@pytest.mark.slow
def test_transfer_has_the_least_rms_of_every_channel_and_classic_the_greatest(measured):
    rms = {name: row[1:] for name, row in measured[0].items()}
    assert (rms["transfer"] < rms["lambert"]).all()
    assert (rms["lambert"] < rms["classic"]).all()


@pytest.mark.slow
@pytest.mark.parametrize("page", ["README.md", "docs/accuracy.md"])
def test_the_figures_of_the_pages_are_the_measured_ones(measured, page):
    published = rows((ROOT / page).read_text(encoding="utf-8"))
    for name, row in measured[0].items():
        digits = np.abs(published[name] - row) * 1e4
        assert digits.max() <= tol.PUBLISHED_DIGIT.value, f"{page}: {name} is {row}"


@pytest.mark.slow
def test_the_committed_error_maps_have_the_size_of_the_measured_ones(measured):
    committed = read_image(ROOT / "docs" / "images" / "flip.png")
    assert measured[1].shape == committed.shape
    error = [part.mean() for part in np.split(measured[1], 3, axis=1)]
    assert error[2] < error[0] < error[1]


def test_flip_is_0_for_equal_pictures_and_rises_with_the_difference(references):
    skin = references[0][150:350, 560:760]  # brow, lid and half of the forehead
    assert flip(skin, skin) == 0.0
    errors = [flip(skin, skin * np.float32(1.0 - step)) for step in (0.01, 0.05, 0.2)]
    assert 0.0 < errors[0] < errors[1] < errors[2]


def test_the_flip_of_path_tracing_without_scattering_is_the_published_one(references):
    page = (ROOT / "docs" / "accuracy.md").read_text(encoding="utf-8")
    published = re.search(r"without subsurface scattering.*?FLIP (0\.\d{3})\b", page, re.DOTALL)
    digits = abs(flip(*references) - float(published[1])) * 1e3
    assert digits <= tol.PUBLISHED_DIGIT.value
