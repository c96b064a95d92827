import re

import pytest

from skinshade._core import errors


def classes() -> dict[str, type[BaseException]]:
    return {name: getattr(errors, name) for name in errors.__all__}


def documented_parents() -> dict[str, str]:
    """Return the parent of each class by the tree in the module's docstring."""
    parents: dict[str, str] = {}
    path: list[tuple[int, str]] = []
    for line in errors.__doc__.splitlines():
        match = re.match(r"^( {4}[ │├└─]*)(\w+(?:Error))\b", line)
        if match is None:
            continue
        depth, name = len(match[1]), match[2]
        path = [(d, n) for d, n in path if d < depth]
        if path:
            parents[name] = path[-1][1]
        path.append((depth, name))
    return parents


def test_the_tree_in_the_docstring_is_the_class_hierarchy():
    real = {
        name: kind.__mro__[1].__name__
        for name, kind in classes().items()
        if issubclass(kind, errors.SkinshadeError) and kind is not errors.SkinshadeError
    }
    assert documented_parents() == real


@pytest.mark.parametrize("name", [n for n in errors.__all__ if n.endswith("Error")])
def test_the_exit_code_is_two_for_input_errors_and_one_for_others(name):
    kind = classes()[name]
    assert kind.exit_code == (2 if issubclass(kind, errors.InputError) else 1)


def test_an_argument_error_is_a_value_error():
    assert issubclass(errors.ArgumentError, ValueError)


def test_the_unit_warning_is_no_skinshade_error():
    assert issubclass(errors.UnitWarning, UserWarning)
    assert not issubclass(errors.UnitWarning, errors.SkinshadeError)
