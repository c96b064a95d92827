"""Limits: their values, the use of others, and the errors of what is beyond them."""

from __future__ import annotations

import contextvars
import pickle
import re
from concurrent.futures import ThreadPoolExecutor
from dataclasses import fields

import pytest

import skinshade as sk
from skinshade._core.errors import ArgumentError, MeshFileError
from skinshade._core.limits import (
    DEEPEST,
    GREATEST,
    Limits,
    check_file_size,
    check_limit,
    limit_range,
    limits,
    use_limits,
)

NAMES = [entry.name for entry in fields(Limits)]

# -- values ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", NAMES)
def test_every_limit_has_a_default_a_unit_and_a_meaning(name):
    meaning = Limits.__dataclass_fields__[name].metadata["meaning"]
    assert 1 <= getattr(Limits(), name) <= meaning.greatest
    assert meaning.unit
    assert meaning.group
    assert re.match(r"[A-Z].{20,}\.$", meaning.about)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("value", [0, -1, True, 1.0, "3", None, [], GREATEST + 1])
def test_a_limit_that_is_no_whole_number_in_range_is_refused_by_name(name, value):
    with pytest.raises(ArgumentError, match=f"limit {name} is .*; it must be a whole number, 1"):
        Limits(**{name: value})


def test_the_limit_of_nesting_cannot_exceed_what_recursive_readers_can_read():
    assert Limits(json_depth=DEEPEST).json_depth == DEEPEST
    with pytest.raises(ArgumentError, match=f"json_depth is {DEEPEST + 1}; .* 1..{DEEPEST}"):
        Limits(json_depth=DEEPEST + 1)


def test_limits_are_equal_after_pickling():
    changed = Limits(lights=5, triangles=7)
    assert pickle.loads(pickle.dumps(changed)) == changed


# -- use of other limits ---------------------------------------------------------------------------


def test_other_limits_apply_in_the_body_only_and_blocks_nest():
    assert limits() == Limits()
    with use_limits(lights=7):
        with use_limits(samples=3) as inner:
            assert limits() is inner
            assert (inner.lights, inner.samples) == (7, 3)
        assert limits() == Limits(lights=7)
    assert limits() == Limits()


def test_the_limits_are_restored_after_an_error():
    with pytest.raises(MeshFileError), use_limits(lights=7):
        raise MeshFileError("x")
    assert limits() == Limits()


def test_a_block_can_begin_with_given_limits():
    with use_limits(lights=7), use_limits(Limits(samples=2), frames=5):
        assert limits() == Limits(samples=2, frames=5)


@pytest.mark.parametrize("changes", [{"light": 7}, {"lights": 0}, {"lights": "7"}])
def test_an_unknown_limit_or_value_is_refused_and_changes_nothing(changes):
    with pytest.raises(ArgumentError, match="lights"), use_limits(**changes):
        pass
    assert limits() == Limits()


def test_a_thread_has_the_default_limits_unless_it_runs_in_a_copy_of_the_context():
    with use_limits(lights=7), ThreadPoolExecutor(1) as pool:
        assert pool.submit(limits).result() == Limits()
        assert pool.submit(contextvars.copy_context().run, limits).result() == Limits(lights=7)


def test_the_public_names_are_those_of_the_readers():
    assert (sk.Limits, sk.limits, sk.use_limits) == (Limits, limits, use_limits)


# -- errors ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", NAMES)
def test_a_value_beyond_a_limit_is_an_error_that_names_the_limit_its_value_and_the_option(name):
    most = getattr(Limits(), name)
    check_limit(name, most, "thing")
    with pytest.raises(MeshFileError) as caught:
        check_limit(name, most + 1, "thing", MeshFileError)
    message = str(caught.value)
    assert message.startswith(f"thing: {most + 1} ")
    assert f"the limit {name} is {most} (--limit {name}={most + 1} or" in message
    assert f"skinshade.use_limits({name}={most + 1})" in message
    with use_limits(**{name: most + 1}):
        check_limit(name, most + 1, "thing")


def test_the_advice_never_exceeds_the_greatest_value_of_a_limit():
    with pytest.raises(ArgumentError, match=f"is 128 and can be raised to {DEEPEST} at most$"):
        check_limit("json_depth", DEEPEST + 1, "text")


def test_a_range_has_advice_only_for_a_value_above_it():
    assert limit_range("samples", 1, 0) == "1..256 samples"
    assert limit_range("samples", 1, 300).startswith("1..256 samples; the limit samples is 256 (")


def test_the_size_of_a_file_is_checked_without_reading_it(tmp_path):
    path = tmp_path / "sparse.glb"
    with path.open("wb") as stream:
        stream.truncate(2**32 + 1)
    with pytest.raises(MeshFileError, match=r"sparse\.glb: 4294967297 bytes; the limit file_bytes"):
        check_file_size(path, MeshFileError)
    with use_limits(file_bytes=2**33):
        check_file_size(path, MeshFileError)
