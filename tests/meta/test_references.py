"""Citations: every key that is cited is in REFERENCES.bib, and every entry there is cited."""

from __future__ import annotations

import ast
import json
import re
from collections import Counter

import pytest

from skinshade.params import SkinParams
from skinshade.profile import Profile

CITED = re.compile(r"\[([A-Za-z]+\d{4}[a-z]?)\]")
KEY = re.compile(r"\b[A-Z]?[A-Za-z]+\d{4}[a-z]?\b")
ENTRY = re.compile(r"^@(\w+)\{([^,\s]+),\n((?: .*\n)*)", re.MULTILINE)
FIELD = re.compile(r"\b(\w+) = \{((?:[^{}]|\{[^{}]*\})*)\}")


@pytest.fixture(scope="module")
def entries(repository):
    text = (repository / "REFERENCES.bib").read_text(encoding="utf-8")
    blocks = ENTRY.findall(text + "\n")
    count = text.count("\n@") + text.startswith("@")
    assert len(blocks) == count, "an entry does not have the form that ENTRY reads"
    return [(key, dict(FIELD.findall(body))) for _, key, body in blocks]


@pytest.fixture(scope="module")
def citations(repository):
    """Pairs of key and place: keys in brackets in code and documents, and sources of data."""
    pairs = []
    for folder, pattern in (("src", "*.py"), ("docs", "*.md"), ("tests", "*.py")):
        for path in sorted((repository / folder).rglob(pattern)):
            text = path.read_text(encoding="utf-8")
            pairs += [(key, str(path)) for key in CITED.findall(text)]
            if pattern == "*.py" and folder == "src":
                pairs += [(key, str(path)) for key in sources_in(ast.parse(text))]
    presets = repository / "src" / "skinshade" / "profile" / "presets.json"
    for name, record in json.loads(presets.read_text(encoding="utf-8")).items():
        for field in ("source", "albedo_source"):
            pairs += [(key, f"preset {name}") for key in KEY.findall(record.get(field, ""))]
    return pairs


def sources_in(tree):
    """Yield keys that are arguments ``source=``, or the sixth argument of ``number``."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call):
            texts = [k.value for k in node.keywords if k.arg == "source"]
            if ast.unparse(node.func) == "number":
                texts += node.args[5:6]
            yield from (t.value for t in texts if isinstance(t, ast.Constant) and t.value)


def test_every_cited_key_is_in_the_references(entries, citations):
    keys = {key for key, _ in entries}
    assert [f"{place}: {key}" for key, place in citations if key not in keys] == []


def test_every_reference_is_cited_by_the_package_or_its_documents(entries, citations):
    cited = {key for key, place in citations if "/tests/" not in place}
    assert [key for key, _ in entries if key not in cited] == []


def test_the_search_finds_every_form_of_citation(citations):
    """Brackets, and the sources of a preset, its albedo, a parameter and a profile."""
    skin = Profile.preset("skin-deon2007")
    gloss = SkinParams.__dataclass_fields__["gloss"].metadata["meaning"]
    burley = Profile.burley(length_mm=1.0, kind="shape", albedo=0.5)
    for key in (skin.source, gloss.source, burley.source, "KubelkaMunk1931", "Jensen2001"):
        assert key in {cited for cited, _ in citations}


def test_no_key_has_two_entries(entries):
    assert [key for key, n in Counter(key for key, _ in entries).items() if n > 1] == []


def test_every_entry_has_author_title_year_and_a_note_on_its_use(entries):
    for key, fields in entries:
        for name in ("author", "title", "year", "note"):
            assert fields.get(name), f"{key} lacks {name}"
        assert re.fullmatch(r"(18|19|20)\d\d", fields["year"]), key


def test_the_year_of_a_key_is_the_year_of_its_entry_or_in_its_note(entries):
    for key, fields in entries:
        year = re.search(r"\d{4}", key)[0]
        assert year == fields["year"] or year in fields["note"], key


def test_the_name_of_a_key_is_the_name_of_the_first_author(entries):
    for key, fields in entries:
        author = re.sub(r"\W", "", fields["author"].split(" and ")[0]).lower()
        surname = re.match(r"[A-Z]?[a-z]*?[A-Z]?[a-z]+", key)[0].lower()
        assert surname in author, key
