"""Texts of files are safe and short enough to display."""

import os

import pytest
from hypothesis import given
from hypothesis import strategies as st

from skinshade._core.text import printable, shortened

ANY_TEXT = st.text(st.characters())  # includes lone surrogates


@given(ANY_TEXT)
def test_every_text_becomes_text_that_can_be_written_and_has_no_control_characters(text):
    result = printable(text)
    assert result.encode("utf-8").decode("utf-8") == result
    assert not any(
        ord(c) < 32 or 0x7F <= ord(c) < 0xA0 or c in "\u2028\u2029\u202e" for c in result
    )


@pytest.mark.parametrize(
    "text", ["head 01.glb", "頭部/模型.glb", "עברית.glb", "a\\b", "<&>\"'", "👩🏽‍🦰.glb"]
)
def test_ordinary_names_of_every_script_stay_as_they_are(text):
    assert printable(text) == text


def test_bytes_that_are_not_utf_8_become_replacement_characters():
    assert printable(os.fsdecode(b"latin\xe9.glb")) == "latin\ufffd.glb"
    assert printable("rtl\u202egpj.glb\n") == "rtl\\u202egpj.glb\\n"


def test_line_breaks_stay_on_request():
    assert printable("a\nb\x1b[31m", keep="\n") == "a\nb\\x1b[31m"


@given(ANY_TEXT, st.integers(6, 40))
def test_a_shortened_text_keeps_its_beginning_and_end_within_the_length(text, longest):
    result = shortened(text, longest)
    assert len(result) == min(len(text), longest)
    assert text.startswith(result[: longest // 3])
    assert text.endswith(result[-(longest // 3 - 1) :])


def test_the_middle_of_a_long_text_is_left_out():
    assert shortened("a" * 50 + "; say what to do", 30) == "a" * 18 + " … " + "hat to do"
