import pytest
from test_rendering_picture import KEY, scene

from skinshade._core.errors import ArgumentError
from skinshade.rendering import RenderSettings, render


def test_progress_rises_and_is_done_in_the_end():
    said = []
    render(
        scene(KEY),
        size=(8, 8),
        samples=3,
        progress=lambda what, share: said.append((what, share)),
    )
    assert said[-1] == ("shading", 1.0)
    assert all(0.0 <= share <= 1.0 for _, share in said)
    for what in {what for what, _ in said}:
        shares = [share for name, share in said if name == what]
        assert shares == sorted(shares)


@pytest.mark.parametrize(
    ("request_", "said"),
    [
        ({"size": (0, 5)}, "size is 0×5"),
        ({"size": (5, 16385)}, "16385"),
        ({"samples": 0}, "samples is 0"),
        ({"samples": 257}, "samples is 257"),
        ({"backend": "abacus"}, "'abacus'"),
    ],
)
def test_a_request_out_of_range_is_refused_by_name(request_, said):
    with pytest.raises(ArgumentError, match=said):
        render(scene(KEY), **({"size": (4, 4), "samples": 1} | request_))


@pytest.mark.parametrize(
    ("field", "value"),
    [("shading", "phong"), ("tier", "x"), ("deep_scatter_taps", 7), ("debug_view", "x-ray")],
)
def test_a_setting_that_does_not_exist_is_named_with_those_that_do(field, value):
    with pytest.raises(ArgumentError, match=f"{field} is {value!r}; it must be one of") as caught:
        RenderSettings(**{field: value})
    known = {"shading": "lambert", "tier": "tensor", "deep_scatter_taps": "32"}
    assert known.get(field, "ambient-specular") in str(caught.value)
    with pytest.raises(ArgumentError, match="seed is -1"):
        RenderSettings(seed=-1)
