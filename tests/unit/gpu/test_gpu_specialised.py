"""The skin pass costs nothing for what its constants switch off.

The driver for AMD's GPUs compiles the pass for a GPU that is not installed, and counts its instructions.
"""

from __future__ import annotations

import json
import subprocess
import sys
from itertools import pairwise

import pytest

# A process of its own: the driver must not offer the simulated GPU to other tests.
COUNT = """
import json, sys
from benchmark_scripts import benchmark
from skinshade._core.generated import generated_text
from skinshade.gpu.bindings import override_ids
script = benchmark("gpu_instructions")
try:
    device = script.AbsentDevice("NAVI21")
except script.AbsentDriverError as error:
    sys.exit(f"absent: {error}")
ids = override_ids(generated_text("skin_pass.wgsl"))
for changes in json.loads(sys.argv[1]):
    constants = {**script.BASE, "SHADOW_FILTER": 0, **changes}
    counts = device.statistics({int(ids[name]): value for name, value in constants.items()})
    print(json.dumps({name: counts[name] for name in ("Instructions", "Inverse Throughput", "VGPRs")}))
"""
SAME_COST = {
    "tiers of a plain surface": [{"SHADING": 0, "TIER": tier} for tier in (0, 1, 2)],
    "shadow filters without lights": [
        {"LIGHTS": 0, "SHADOW_FILTER": 0, "SPOT_LIGHTS": 0},
        {"LIGHTS": 0, "SHADOW_FILTER": 1, "SPOT_LIGHTS": 1},
    ],
    "boundaries without scattering": [
        {"SHADING": 0, "BOUNDARY": 0},
        {"SHADING": 0, "BOUNDARY": 1},
    ],
    "light in a view of the albedo": [
        {"VIEW": 6},
        {"VIEW": 6, "TAPS": 32, "SHADOW_FILTER": 1, "ENVIRONMENT": 0, "TIER": 0},
    ],
}
RISING_COST = {
    "tiers": [{"TIER": tier, "ENVIRONMENT": 0} for tier in (0, 1, 2)],
    "taps": [{"TAPS": taps} for taps in (0, 8, 32)],
    "fetches of the normal map": [{"FETCHES": fetches} for fetches in (1, 2, 3)],
    "surroundings": [{"ENVIRONMENT": 0}, {"ENVIRONMENT": 1}],
    "spot lights": [{"SPOT_LIGHTS": lights, "CONTACT": 0} for lights in (0, 1)],
    "contact shadows": [{"CONTACT": 0}, {"CONTACT": 1}],
    "lights": [{"LIGHTS": 0}, {"LIGHTS": 1}],
    "maps": [{"MAPS": 0}, {"MAPS": 15}],
    "lobes of GGX": [{"SPECULAR": 0}, {"SPECULAR": 1}],
}


@pytest.fixture(scope="module")
def counts(repository):
    """Statistics of every variant, by the name of its list."""
    lists = SAME_COST | RISING_COST
    variants = [variant for variants in lists.values() for variant in variants]
    done = subprocess.run(
        [sys.executable, "-c", COUNT, json.dumps(variants)],
        cwd=repository / "tests",
        capture_output=True,
        text=True,
    )
    if "absent: " in done.stderr or "Unknown family" in done.stderr:
        pytest.skip(done.stderr.strip().splitlines()[-1])
    assert done.returncode == 0, done.stderr
    lines = iter(done.stdout.splitlines())
    return {name: [json.loads(next(lines)) for _ in variants] for name, variants in lists.items()}


@pytest.mark.parametrize("name", SAME_COST)
def test_constants_that_have_no_effect_cost_nothing(counts, name):
    assert all(first == second for first, second in pairwise(counts[name]))


@pytest.mark.parametrize("name", RISING_COST)
def test_constants_that_add_work_cost_more(counts, name):
    cycles = [statistics["Inverse Throughput"] for statistics in counts[name]]
    assert all(less < more for less, more in pairwise(cycles))
