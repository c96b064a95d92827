from dataclasses import replace

import numpy as np
import pytest

from skinshade._core.errors import ArgumentError
from skinshade.cli.compare import parse_variant, side_by_side
from skinshade.rendering import RenderSettings

SETTINGS = RenderSettings(seed=7)


@pytest.mark.parametrize(
    ("text", "label", "changes"),
    [
        ("lambert", "lambert", {"shading": "lambert"}),
        ("classic", "classic", {"shading": "classic"}),
        ("transfer", "transfer", {"shading": "transfer"}),
        (" transfer ", "transfer", {"shading": "transfer"}),
        ("transfer@scalar", "transfer, scalar", {"tier": "scalar"}),
        ("transfer+deep", "transfer + deep scatter", {"deep_scatter_taps": 8}),
        (
            "transfer@tensor+deep",
            "transfer, tensor + deep scatter",
            {"tier": "tensor", "deep_scatter_taps": 8},
        ),
    ],
)
def test_an_entry_is_a_label_and_changed_settings(text, label, changes):
    truth = replace(SETTINGS, **({"deep_scatter_taps": 0} | changes))
    assert parse_variant(text, SETTINGS) == (label, truth)


def test_deep_scatter_has_the_taps_of_the_settings():
    many = replace(SETTINGS, deep_scatter_taps=32)
    assert parse_variant("transfer+deep", many)[1].deep_scatter_taps == 32
    none = replace(SETTINGS, deep_scatter_taps=0)
    assert parse_variant("transfer+deep", none)[1].deep_scatter_taps == 8


@pytest.mark.parametrize("text", ["", "phong", "transfer@fourth", "+deep", "deep"])
def test_an_entry_that_is_none_is_quoted_with_the_allowed_values(text):
    with pytest.raises(ArgumentError, match="it must be one of") as caught:
        parse_variant(text, SETTINGS)
    assert str(caught.value).startswith(f"--compare {text!r}: ")


def test_pictures_stand_in_a_row_with_labels_below():
    pictures = [np.full((64, 96, 3), value) for value in (0.0, 0.5, 1.0)]
    row = side_by_side(pictures, ["one", "two", "three"])
    assert row.shape == (64, 288, 3)
    assert row.dtype == np.uint8
    for index, value in enumerate((0, 128, 255)):
        panel = row[:, 96 * index + 1 : 96 * (index + 1)]
        assert (panel[:32] == value).all()
        assert (panel[48:] != value).any()
