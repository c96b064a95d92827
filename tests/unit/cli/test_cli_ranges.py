"""Values whose products would overflow are refused on the command line, and no file is written."""

from __future__ import annotations

from pathlib import Path

import pytest
from cli_runs import run

CORPUS = Path(__file__).resolve().parents[2] / "corpus"
BEYOND = {
    "--light=0,0,1e300": "light irradiance[0] is 3.14",
    "--background=1e300,0,0": "background[0] is 1e+300",
    "--env-scale=1e308": "environment scale is 5.5",
    "--exposure=1e300": "exposure is 1e+300",
}


@pytest.mark.parametrize("option", BEYOND)
def test_a_value_beyond_its_range_is_refused_in_one_line(tmp_path, option):
    model = str(CORPUS / "obj" / "plain.obj")
    words = ("render", model, "--unit-mm", "100", "--size", "32x18", "-o", "out.png", option)
    outcome = run(tmp_path, *words)
    (line,) = outcome.err.splitlines()
    assert (outcome.code, line.startswith("skinshade: error: ")) == (2, True)
    assert BEYOND[option] in line
    assert list(tmp_path.iterdir()) == []
