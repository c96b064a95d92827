import pickle
import re
import warnings

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


def test_a_message_with_text_from_a_file_does_not_command_the_terminal():
    message = str(errors.MeshFileError("a.glb: name is '\x1b[2J\r\u202egpj\udcff\n'"))
    assert message == "a.glb: name is '\\x1b[2J\\r\\u202egpj\ufffd\\n'"


@pytest.mark.parametrize("unit", ["x", "\x1b", "\udcff"])
def test_a_long_message_keeps_the_file_and_the_advice(unit):
    message = str(errors.SceneFileError(f"a.json: is {unit * 10**6}; give a number"))
    assert len(message) <= 1000
    assert message.startswith("a.json: is ")
    assert message.endswith("; give a number")


def test_the_log_of_a_shader_compiler_keeps_its_lines():
    assert str(errors.ShaderError("line 1\n\tline 2\x1b")) == "line 1\n\tline 2\\x1b"


def test_an_error_that_is_raised_again_has_the_same_message():
    text = str(errors.ArgumentError("\x00" * 5000))
    assert str(errors.MeshError(text)) == text
    assert pickle.loads(pickle.dumps(errors.DependencyError(text))).args == (text,)


def test_a_warning_with_text_from_a_file_does_not_command_the_terminal():
    with pytest.warns(errors.AssetWarning) as caught:
        warnings.warn("a.glb: image \x1b[2J\n" + "x" * 5000, errors.AssetWarning, stacklevel=1)
    message = str(caught[0].message)
    assert message.startswith("a.glb: image \\x1b[2J\\n")
    assert len(message) == 1000
