"""Examples in docstrings: every public function and class has one, and all of them run."""

from __future__ import annotations

import doctest
import importlib
import inspect
import pkgutil
import re

import pytest

import skinshade as sk

NEEDS = {"skinshade.integrations.pygfx": "pygfx", "skinshade.integrations.moderngl": "moderngl"}
"""Optional packages that modules need."""
WITHOUT = {"InputError", "SkinshadeError", "__version__", "gpu"}
"""Public names that need no example: base classes of errors, the version, a package."""


def modules():
    names = [module.name for module in pkgutil.walk_packages(sk.__path__, "skinshade.")]
    return [name for name in names if not name.endswith("__main__")]


def examples(name):
    """Return the examples of a module's own functions, classes and methods."""
    for package, needed in NEEDS.items():
        if name.startswith(package):
            pytest.importorskip(needed)
    return [
        test
        for test in doctest.DocTestFinder().find(importlib.import_module(name))
        if test.examples
    ]


def test_the_modules_have_examples():
    assert sum(len(examples(name)) for name in modules()) > 30


@pytest.mark.slow
@pytest.mark.parametrize("name", modules())
def test_the_examples_of_a_module_run(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    messages = []
    runner = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE)
    for test in examples(name):
        runner.run(test, out=messages.append)
    assert runner.summarize(verbose=False).failed == 0, "".join(messages)


@pytest.mark.parametrize("name", [name for name in sk.__all__ if name not in WITHOUT])
def test_every_public_function_and_class_has_an_example(name):
    value = getattr(sk, name)
    documents = [inspect.getdoc(value) or ""]
    if inspect.isclass(value):
        documents += [inspect.getdoc(member) or "" for member in vars(value).values()]
    assert any(re.search(r"^>>> ", document, re.MULTILINE) for document in documents)
