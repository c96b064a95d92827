"""Every function of the shader library beside its twin in the specification, in every language."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from inputs import drawn
from twins import expected, tables_for

from parity_tolerances import FLOAT32, PARITY
from skinshade.codegen.signatures import signatures

FUNCTIONS = {each.name: each for each in signatures()}
BATCHES = 6


@cache
def case(name):
    """What a function is given, and what its twin makes of it: the same for every language."""
    signature = FUNCTIONS[name]
    tables = tables_for(signature)
    batches = [drawn(signature, seed) for seed in range(BATCHES)]
    want = np.concatenate([expected(signature, each, tables) for each in batches])
    values = {key: np.concatenate([each[key] for each in batches]) for key in batches[0]}
    return values, {table: pair[0] for table, pair in tables.items()}, want


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_function_equals_its_twin_on_random_and_limiting_inputs(runner, name):
    allowed = PARITY.get(name, FLOAT32)
    values, textures, want = case(name)
    found = runner(FUNCTIONS[name], values, textures)
    assert found.shape == want.shape
    assert np.isfinite(found).all()
    excess = np.abs(found - want) - allowed.absolute - allowed.relative * np.abs(want)
    worst = int(np.argmax(excess.reshape(len(want), -1).max(axis=1)))
    row = {key: value[worst] for key, value in values.items()}
    assert excess.max() <= 0.0, f"{row}: {found[worst]}, not {want[worst]}"
