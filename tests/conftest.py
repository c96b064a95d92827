"""Fixtures that every folder of tests shares."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from hypothesis import settings

from skinshade.profile import Profile

REPOSITORY = Path(__file__).resolve().parents[1]

settings.register_profile("bounded", max_examples=40, deadline=None, derandomize=True)
settings.load_profile("bounded")


@pytest.fixture(scope="session", autouse=True)
def own_cache(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Keep the tests, and the processes that they start, away from the user's cache."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("SKINSHADE_CACHE", str(tmp_path_factory.getbasetemp() / "cache"))
        yield


@pytest.fixture(scope="session")
def repository() -> Path:
    return REPOSITORY


@pytest.fixture(scope="session")
def data_dir() -> Path:
    default = REPOSITORY.parent / "shared" / "data"
    folder = Path(os.environ.get("SKINSHADE_DATA", default))
    if not folder.is_dir():
        message = f"no measured data at {folder}; set SKINSHADE_DATA to its folder"
        if os.environ.get("SKINSHADE_REQUIRE_DATA") == "1":
            pytest.fail(message)
        pytest.skip(message)
    return folder


@pytest.fixture(scope="session")
def deon() -> Profile:
    return Profile.preset("skin-deon2007")


@pytest.fixture(scope="session")
def burley() -> Profile:
    return Profile.burley(length_mm=(0.6, 0.25, 0.15), kind="shape", albedo=(0.6, 0.4, 0.3))


@pytest.fixture(scope="session")
def halfspace(data_dir: Path) -> dict[str, np.ndarray]:
    with np.load(data_dir / "truth" / "mc_halfspace.npz") as archive:
        return dict(archive)


@pytest.fixture(scope="session")
def measured(halfspace: dict[str, np.ndarray]) -> Profile:
    """The profile of the Monte Carlo half-space with a matched boundary."""
    return Profile.tabulated(
        edges_mm=halfspace["edges_mm"],
        flux=halfspace["flux_matched"],
        albedo=halfspace["albedo_matched"],
    )
