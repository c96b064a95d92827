"""What a pipeline leaves out costs nothing, by the driver's own count for GPUs that are not there."""

from __future__ import annotations

import json
import subprocess
import sys
from itertools import pairwise

import pytest

# In a process of its own: the driver must not offer its absent GPU to other tests.
COUNT = """
import json, sys
from benchmark_scripts import benchmark
script = benchmark("gpu_instructions")
try:
    device = script.AbsentDevice("NAVI21")
except script.AbsentDriverError as error:
    sys.exit(f"absent: {error}")
ids = script.override_ids(script.generated_text("skin_pass.wgsl"))
for changes in json.loads(sys.argv[1]):
    way = {**script.BASE, "SHADOW_FILTER": 0, **changes}
    told = device.statistics({int(ids[name]): value for name, value in way.items()})
    print(json.dumps({name: told[name] for name in ("Instructions", "Inverse Throughput", "VGPRs")}))
"""
SAME = {
    "tiers of a plain surface": [{"SHADING": 0, "TIER": tier} for tier in (0, 1, 2)],
    "shadows and depth without lights": [
        {"LIGHTS": 0, "SHADOW_FILTER": 0, "LAMPS": 0},
        {"LIGHTS": 0, "SHADOW_FILTER": 1, "LAMPS": 1},
    ],
    "light in a view of the albedo": [
        {"VIEW": 6},
        {"VIEW": 6, "TAPS": 32, "SHADOW_FILTER": 1, "ENVIRONMENT": 0, "TIER": 0},
    ],
}
MORE = {
    "tiers": [{"TIER": tier} for tier in (0, 1, 2)],
    "taps": [{"TAPS": taps} for taps in (0, 8, 32)],
    "fetches of the normal map": [{"FETCHES": fetches} for fetches in (1, 2, 3)],
    "surroundings": [{"ENVIRONMENT": 0}, {"ENVIRONMENT": 1}],
    "lamps": [{"LAMPS": 0}, {"LAMPS": 1}],
    "lights": [{"LIGHTS": 0}, {"LIGHTS": 1}],
    "maps": [{"MAPS": 0}, {"MAPS": 15}],
}


@pytest.fixture(scope="module")
def counted(repository):
    ways = [way for each in (SAME | MORE).values() for way in each]
    done = subprocess.run(
        [sys.executable, "-c", COUNT, json.dumps(ways)],
        cwd=repository / "tests",
        capture_output=True,
        text=True,
    )
    if "absent: " in done.stderr or "Unknown family" in done.stderr:
        pytest.skip(done.stderr.strip().splitlines()[-1])
    assert done.returncode == 0, done.stderr
    lines = iter(done.stdout.splitlines())
    return {name: [json.loads(next(lines)) for _ in each] for name, each in (SAME | MORE).items()}


@pytest.mark.parametrize("name", SAME)
def test_what_a_way_does_not_use_costs_nothing(counted, name):
    assert all(a == b for a, b in pairwise(counted[name]))


@pytest.mark.parametrize("name", MORE)
def test_what_a_way_adds_is_what_it_costs(counted, name):
    cycles = [each["Inverse Throughput"] for each in counted[name]]
    assert all(a < b for a, b in pairwise(cycles))
