"""Runs the tests of accuracy and of topology with the compiled kernels and with their NumPy twins."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from native_twins import numpy_twins
from skinshade._core import native

BOTH_WAYS = (
    "test_mesh_curvature",
    "test_mesh_curvature_invariance",
    "test_mesh_curvature_tensor",
    "test_mesh_diffusion",
    "test_mesh_normals",
    "test_mesh_shape_operator",
    "test_mesh_topology",
    "test_mesh_uv_scale",
)
"""Modules whose tests run twice."""


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    if metafunc.module.__name__ in BOTH_WAYS and native.available():
        metafunc.parametrize("twin", ["compiled", "numpy"], indirect=True, scope="module")


@pytest.fixture(scope="module", autouse=True)
def twin(request: pytest.FixtureRequest) -> Iterator[None]:
    """Choose the kernels of a module's tests."""
    if getattr(request, "param", "compiled") == "numpy":
        with numpy_twins():
            yield
    else:
        yield
