"""The page of limits is current, and every limit is checked somewhere."""

from __future__ import annotations

import re
from dataclasses import fields
from pathlib import Path

import pytest

from codegen.limits_page import limits_page
from skinshade._core.limits import Limits

ROOT = Path(__file__).resolve().parents[2]
SOURCES = {
    path: path.read_text(encoding="utf-8")
    for path in sorted((ROOT / "src" / "skinshade").rglob("*.py"))
    if path.name != "limits.py"
}


def test_the_page_of_limits_is_current():
    assert (ROOT / "docs" / "limits.md").read_text(encoding="utf-8") == limits_page()


@pytest.mark.parametrize("name", [entry.name for entry in fields(Limits)])
def test_the_page_has_every_limit_and_the_package_checks_it(name):
    assert re.search(rf"^\| `{name}` \| .*{getattr(Limits(), name)} \|", limits_page(), re.M)
    used = re.compile(
        rf'check_limit\(\s*"{name}"|(?:limits\(\)|most)\.{name}\b|LIMITED = .*"{name}"'
    )
    with_limits = "from ._core.limits", "_core.limits import", "from .limits import"
    assert any(
        used.search(text) and any(line in text for line in with_limits) for text in SOURCES.values()
    )


def test_the_security_policy_refers_to_the_page():
    assert "(docs/limits.md)" in (ROOT / "SECURITY.md").read_text(encoding="utf-8")
