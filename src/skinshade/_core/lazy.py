"""Public names of packages, imported at their first use."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping, Sequence
from importlib import import_module
from typing import Any

__all__ = ["names_on_demand"]


def names_on_demand(package: str, modules: Mapping[str, Sequence[str]]) -> Callable[[str], Any]:
    """Return the function ``__getattr__`` of a package that imports its names at their first use.

    Parameters
    ----------
    package
        Full name of the package.
    modules
        Public names by the modules that define them, which are relative to the package.

    Examples
    --------
    >>> from skinshade._core.lazy import names_on_demand
    >>> names_on_demand("skinshade.mesh", {".axes": ["UpAxis"]})("UpAxis").Y
    <UpAxis.Y: 'y'>
    """
    module_of = {name: module for module, names in modules.items() for name in names}

    def attribute(name: str) -> Any:
        if name not in module_of:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        value = getattr(import_module(module_of[name], package), name)
        setattr(sys.modules[package], name, value)
        return value

    return attribute
