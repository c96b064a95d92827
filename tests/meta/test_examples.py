"""The examples run and write the files that they name."""

from __future__ import annotations

import subprocess
import sys

import pytest

from gpu_device import adapter_or_skip
from skinshade.lut import Lut
from skinshade.scene.images import read_image


def run(repository, name, folder):
    command = [sys.executable, "-W", "error", str(repository / "examples" / name), str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.slow
def test_portrait_saves_a_table_and_a_picture_of_a_lit_head(repository, tmp_path):
    assert "vertices, curvature" in run(repository, "portrait.py", tmp_path)
    assert Lut.load(tmp_path / "curvature.exr").values.shape == (512, 512, 3)
    picture = read_image(tmp_path / "portrait.png")
    assert picture.shape == (180, 320, 3)
    middle, corner = picture[90, 160], picture[2, 2]
    assert middle.sum() > 2.0 * corner.sum()
    assert middle[0] > middle[1] > middle[2]  # skin is redder than green, greener than blue


def test_own_profile_distinguishes_materials(repository, tmp_path):
    lines = run(repository, "own_profile.py", tmp_path).splitlines()
    assert [line.split()[0] for line in lines] == ["skin-deon2007", "marble", "creature"]
    skin = Lut.load(tmp_path / "curvature-skin-deon2007.png")
    creature = Lut.load(tmp_path / "curvature-creature.png")
    # Just past the terminator, light on skin is red, and light on the creature green.
    assert skin.sample(-0.1, 0.125).argmax() == 0
    assert creature.sample(-0.1, 0.125).argmax() == 1


@pytest.mark.slow
@pytest.mark.parametrize("name", ["wgpu_skin", "moderngl_skin"])
def test_another_renderer_draws_a_head_lit_from_one_side(repository, tmp_path, name):
    adapter_or_skip()
    run(repository, f"{name}.py", tmp_path)
    picture = read_image(tmp_path / f"{name}.png")
    assert picture.shape == (480, 480, 3)
    forehead, past_terminator = picture[200, 190], picture[200, 300]
    assert forehead.sum() > 5.0 * past_terminator.sum()
    red, green, blue = picture[300:330, 160:200].mean(axis=(0, 1))
    assert red > green > blue


def test_the_wgpu_example_is_short(repository):
    lines = (repository / "examples" / "wgpu_skin.py").read_text("utf-8").splitlines()
    assert len(lines) < 120
