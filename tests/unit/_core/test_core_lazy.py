"""Names of packages that are imported at their first use."""

import sys
from types import ModuleType

import pytest

from skinshade._core.lazy import names_on_demand


def test_a_name_is_that_of_its_module_and_is_kept(monkeypatch):
    package = ModuleType("lazy_package")
    monkeypatch.setitem(sys.modules, "lazy_package", package)
    attribute = names_on_demand("lazy_package", {"json": ["dumps"], "math": ["pi", "tau"]})
    assert attribute("tau") == 2.0 * attribute("pi")
    assert vars(package)["tau"] == attribute("tau")
    assert "dumps" not in vars(package)


def test_another_name_is_an_attribute_error_that_names_the_package():
    with pytest.raises(AttributeError, match=r"module 'skinshade' has no attribute 'moon'"):
        names_on_demand("skinshade", {"math": ["pi"]})("moon")
