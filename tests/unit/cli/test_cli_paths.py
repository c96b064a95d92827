"""Names of outputs and sources that cannot be used: an error with exit code 2, and nothing is written."""

from __future__ import annotations

import pytest
from cli_runs import Run, run_all, write_inputs

from skinshade.cli import bake

STANDARD_OUTPUT = [
    ["bake", "ball.glb"],
    ["bake", "."],
    ["render"],
    ["lut", "curvature"],
    ["lut", "shadow"],
    ["profile", "marble"],
    ["shaders", "export", "--language", "wgsl"],
]
LONG = "a" * 300
OUTPUTS = {
    "a folder as a model": (["bake", ".", "-o", "x.glb"], "x.glb: is the name of a file"),
    "a file for a page": (["bake", "ball.glb", "--report", "-o", "x.ply"], "x.ply: is the name"),
    "a folder to draw": (["render", ".", "-o", "x.png"], ".: not a file"),
    "a folder below a file": (
        ["bake", "ball.glb", "bare.obj", "-o", "ball.glb/x"],
        "ball.glb/x: cannot create",
    ),
    "a long source": (["bake", f"{LONG}.glb", "-o", "x.glb"], f"{LONG}.glb: File name too long"),
    "a long folder": (["bake", ".", "-o", LONG], f"{LONG}: File name too long"),
    "a long output": (["bake", "ball.glb", "-o", f"{LONG}.glb"], f"{LONG}.glb: File name too long"),
}


@pytest.fixture(scope="module")
def runs(tmp_path_factory) -> dict[str, Run]:
    folder = tmp_path_factory.mktemp("paths")
    write_inputs(folder)
    requests = {" ".join(words): [*words, "-o", "-"] for words in STANDARD_OUTPUT}
    requests |= {name: words for name, (words, _) in OUTPUTS.items()}
    done = run_all([(folder, words) for words in requests.values()])
    return dict(zip(requests, done, strict=True))


@pytest.mark.slow
@pytest.mark.parametrize("words", STANDARD_OUTPUT, ids=" ".join)
def test_standard_output_as_an_output_is_refused(runs, words):
    outcome = runs[" ".join(words)]
    assert (outcome.code, outcome.out) == (2, "")
    assert "--output is '-'; writing to standard output is not supported" in outcome.err
    assert outcome.before == outcome.after


@pytest.mark.slow
@pytest.mark.parametrize("name", OUTPUTS)
def test_an_output_or_a_source_that_cannot_be_used_is_an_error_with_exit_code_2(runs, name):
    outcome = runs[name]
    assert (outcome.code, outcome.out) == (2, "")
    assert outcome.err.startswith(f"skinshade: error: {OUTPUTS[name][1]}")
    assert outcome.err.count("\n") == 1
    assert outcome.before == outcome.after


def test_a_folder_without_permission_is_an_error(tmp_path, monkeypatch):
    """Tested by the call for permissions, because nothing is forbidden to the user root."""
    monkeypatch.setattr(bake.os, "access", lambda path, mode: path != tmp_path)
    with pytest.raises(bake.OutputError, match="no permission to write into this folder"):
        bake._create_folder(tmp_path)
