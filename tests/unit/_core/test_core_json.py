"""The strict JSON reader: equal to json.loads on valid JSON, and what it refuses."""

import json
import math

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from skinshade._core.errors import ArgumentError
from skinshade._core.json import parse_json
from skinshade._core.limits import DEEPEST, Limits, use_limits

DEPTH = Limits().json_depth
NUMBERS = st.integers(-(10**30), 10**30) | st.floats(allow_nan=False, allow_infinity=False)
LEAVES = st.none() | st.booleans() | NUMBERS | st.text()
VALUES = st.recursive(
    LEAVES, lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner), max_leaves=20
)
OBJECTS = st.dictionaries(st.text(max_size=8), VALUES, min_size=1, max_size=5)


def nested(levels, innermost="0"):
    """Return a JSON text of arrays and objects in turn, one inside the other."""
    opening = "".join("[" if level % 2 else '{"a":' for level in range(levels))
    closing = "".join("]" if level % 2 else "}" for level in reversed(range(levels)))
    return opening + innermost + closing


# -- valid JSON ------------------------------------------------------------------------------------


@given(VALUES, st.sampled_from([None, 0, 2]), st.booleans())
def test_valid_json_gives_the_value_of_json_loads(value, indent, ascii_only):
    text = json.dumps(value, indent=indent, ensure_ascii=ascii_only)
    # The representations differ between 1, 1.0 and true, which are equal.
    assert repr(parse_json(text)) == repr(json.loads(text)) == repr(value)


@pytest.mark.parametrize(
    "text",
    ["0", "-0.0", "1e308", "1E-400", "true", "null", '""', " [ ] ", "{\n}", r'"\ud83d\ude00"'],
)
def test_a_text_of_one_value_is_read(text):
    assert repr(parse_json(text)) == repr(json.loads(text))


def test_equal_keys_of_different_objects_are_allowed():
    text = '{"a": {"a": 1}, "b": [{"a": 2}, {"a": 3}]}'
    assert parse_json(text) == json.loads(text)


@pytest.mark.parametrize("levels", [1, 2, DEPTH - 1, DEPTH])
@pytest.mark.parametrize("innermost", ["0", '"text"', "null"])
def test_nesting_to_the_limit_is_read(levels, innermost):
    text = nested(levels, innermost)
    assert parse_json(text) == json.loads(text)


# -- refused ---------------------------------------------------------------------------------------


@given(OBJECTS, st.data())
def test_a_key_that_occurs_twice_is_refused_by_name(members, data):
    key = data.draw(st.sampled_from(sorted(members)))
    pairs = data.draw(st.permutations([*members.items(), (key, data.draw(VALUES))]))
    text = ", ".join(f"{json.dumps(name)}: {json.dumps(value)}" for name, value in pairs)
    outside = data.draw(st.sampled_from(["{%s}", "[0, {%s}]", '{"b": [{"c": {%s}}]}']))
    with pytest.raises(ArgumentError) as caught:
        parse_json(outside.replace("%s", text))
    assert f"an object has the key {key!r} twice" in str(caught.value)


def test_a_key_is_equal_to_its_escaped_form():
    with pytest.raises(ArgumentError, match="key 'a' twice"):
        parse_json(r'{"a": 1, "\u0061": 2}')


@pytest.mark.parametrize("outside", ["%s", "[1, %s]", '{"a": [%s]}'])
@pytest.mark.parametrize("constant", ["NaN", "Infinity", "-Infinity"])
def test_constants_that_are_no_json_are_refused_by_name(constant, outside):
    with pytest.raises(ArgumentError, match=f"{constant} is not a JSON number"):
        parse_json(outside.replace("%s", constant))


@pytest.mark.parametrize("outside", ["%s", "[1, %s]", '{"a": [%s]}'])
@pytest.mark.parametrize("number", ["1e309", "-1e309", "1e999999", "-12345.5E400"])
def test_a_number_that_overflows_is_refused_by_its_text(number, outside):
    with pytest.raises(ArgumentError) as caught:
        parse_json(outside.replace("%s", number))
    assert f"the number {number} is too large" in str(caught.value)


def test_a_long_number_and_a_long_key_are_cut_in_the_message():
    with pytest.raises(ArgumentError) as caught:
        parse_json("1" * 400 + ".0")
    assert len(str(caught.value)) < 100
    key = json.dumps("k" * 1000)
    with pytest.raises(ArgumentError) as caught:
        parse_json(f"{{{key}: 1, {key}: 2}}")
    assert len(str(caught.value)) < 100


@pytest.mark.parametrize("levels", [DEPTH + 1, 500, 1000, 100_000])
@pytest.mark.parametrize("opening", ["[", '{"a":', '[[{"a":'])
def test_deeper_nesting_is_refused(levels, opening):
    closing = "".join({"[": "]", "{": "}"}[c] for c in reversed(opening) if c in "[{")
    copies = -(-levels // len(closing))
    with pytest.raises(ArgumentError, match=r"it nests .* deep.*; the limit json_depth is 128"):
        parse_json(opening * copies + "0" + closing * copies)


@pytest.mark.parametrize("levels", [DEPTH + 1, DEEPEST])
def test_the_message_states_the_depth_and_how_to_raise_the_limit(levels):
    advice = rf"the limit json_depth is {DEPTH} \(--limit json_depth={levels} or"
    with pytest.raises(ArgumentError, match=f"it nests {levels} levels deep; {advice}"):
        parse_json(nested(levels))
    with use_limits(json_depth=levels):
        assert parse_json(nested(levels)) == json.loads(nested(levels))


def test_text_beyond_its_limits_is_refused_before_it_is_parsed():
    with use_limits(json_bytes=10):
        assert parse_json("[1, 2, 3 ]") == [1, 2, 3]
        with pytest.raises(ArgumentError, match="its JSON: 11 bytes; the limit json_bytes is 10"):
            parse_json("[1, 2, 3, x")
    with use_limits(json_values=4):
        assert parse_json('[1, 2, {"a": 3}]')
        with pytest.raises(ArgumentError, match="its JSON: 5 values; the limit json_values is 4"):
            parse_json('[1, 2, {"a": 3}, x')


@pytest.mark.parametrize(
    "text",
    ["", " ", "{", "[1,]", "{'a': 1}", "[1] 2", "01", "+1", ".5", "1.", "nan", "True", "\ufeff{}"],
)
def test_text_that_is_not_json_is_refused(text):
    with pytest.raises(ArgumentError, match="not JSON"):
        parse_json(text)


@settings(max_examples=200)
@given(VALUES, st.data())
@example(value=[1], data=None)
def test_a_damaged_text_gives_the_value_of_json_loads_or_an_argument_error(value, data):
    text = json.dumps(value)
    if data is not None:
        position = data.draw(st.integers(0, len(text)))
        inserted = data.draw(st.text(max_size=3) | st.sampled_from(list('{}[],:"\\e-9')))
        removed = data.draw(st.integers(0, 3))
        text = text[:position] + inserted + text[position + removed :]
    try:
        result = parse_json(text)
    except ArgumentError:
        return
    assert repr(result) == repr(json.loads(text))


@given(VALUES)
def test_every_number_of_the_result_is_finite(value):
    waiting = [parse_json(json.dumps([value]))]
    while waiting:
        item = waiting.pop()
        if isinstance(item, (dict, list)):
            waiting += item.values() if isinstance(item, dict) else item
        assert not isinstance(item, float) or math.isfinite(item)
