"""The transfer table: T(k) at its texels, between them, and in every row."""

import numpy as np
import pytest

from skinshade._core.errors import ArgumentError
from skinshade.lut import Lut, build_transfer_lut
from skinshade.profile import Profile, presets
from tolerances import TRANSFER_INTERPOLATED


@pytest.mark.parametrize("name", presets())
def test_columns_are_t_at_their_centres_and_lookups_are_t_between_them(name):
    profile = Profile.preset(name)
    lut = build_transfer_lut(profile)
    k = lut.columns.centres(lut.values.shape[1])
    assert np.array_equal(lut.values[0], profile.transfer(k).astype(np.float32))
    assert np.array_equal(lut.values[0], lut.values[-1])
    inside = np.linspace(0.01, 15.9, 5000)
    bend = 3e-4 * profile.rms_radius_mm.max()
    error = np.abs(lut.sample(inside, 0.5) - profile.transfer(inside)).max()
    assert error <= TRANSFER_INTERPOLATED.value + bend / lut.values.shape[1]


def test_t_decreases_from_1_and_is_smallest_in_red():
    lut = build_transfer_lut(Profile.preset("skin-deon2007"))
    assert lut.values[0, 0] == pytest.approx([1.0, 1.0, 1.0], abs=1e-5)
    assert (np.diff(lut.values[0], axis=0) <= 0.0).all()
    red, green, blue = lut.sample(2.0, 0.5)
    assert red < green < blue


def test_a_transfer_table_is_saved_and_loaded(tmp_path):
    lut = build_transfer_lut(Profile.preset("skin1"), size=(64, 2), k_per_mm=(0.0, 4.0))
    lut.save(tmp_path / "t.exr")
    loaded = Lut.load(tmp_path / "t.exr")
    assert loaded.kind == "transfer"
    assert loaded.axes == lut.axes == (0.0, 0.5, 0.0, 1.0)
    with pytest.raises(ArgumentError, match="1×2"):
        build_transfer_lut(Profile.preset("skin1"), size=(1, 2))
