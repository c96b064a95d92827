import re

import pytest

from skinshade._core import errors


def classes() -> dict[str, type[BaseException]]:
    return {name: getattr(errors, name) for name in errors.__all__}


def drawn_parents() -> dict[str, str]:
    """Child to parent, as the tree in the module's docstring draws them."""
    parents: dict[str, str] = {}
    path: list[tuple[int, str]] = []
    for line in errors.__doc__.splitlines():
        found = re.match(r"^( {4}[ │├└─]*)(\w+(?:Error))\b", line)
        if found is None:
            continue
        depth, name = len(found[1]), found[2]
        path = [(d, n) for d, n in path if d < depth]
        if path:
            parents[name] = path[-1][1]
        path.append((depth, name))
    return parents


def test_the_drawn_tree_is_the_real_one():
    real = {
        name: kind.__mro__[1].__name__
        for name, kind in classes().items()
        if issubclass(kind, errors.SkinshadeError) and kind is not errors.SkinshadeError
    }
    assert drawn_parents() == real


@pytest.mark.parametrize("name", [n for n in errors.__all__ if n.endswith("Error")])
def test_the_exit_code_is_two_where_the_input_is_at_fault(name):
    kind = classes()[name]
    assert kind.exit_code == (2 if issubclass(kind, errors.InputError) else 1)


def test_a_bad_argument_is_a_value_error_too():
    assert issubclass(errors.ArgumentError, ValueError)


def test_a_doubtful_unit_is_a_warning_not_an_error():
    assert issubclass(errors.UnitWarning, UserWarning)
    assert not issubclass(errors.UnitWarning, errors.SkinshadeError)
