"""Every function of the shader library equals its twin in the specification, in every language."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from inputs import drawn
from twins import expected, tables_for

from codegen.signatures import signatures
from parity_tolerances import FLOAT32, PARITY

FUNCTIONS = {signature.name: signature for signature in signatures()}
BATCHES = 6


@cache
def case(name):
    """Return values, textures and the twin's results of a function; the same for every language."""
    signature = FUNCTIONS[name]
    tables = tables_for(signature)
    batches = [drawn(signature, seed) for seed in range(BATCHES)]
    truth = np.concatenate([expected(signature, batch, tables) for batch in batches])
    values = {name: np.concatenate([batch[name] for batch in batches]) for name in batches[0]}
    return values, {table: pair[0] for table, pair in tables.items()}, truth


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_function_equals_its_twin_on_random_and_limiting_inputs(runner, name):
    allowed = PARITY.get(name, FLOAT32)
    values, textures, truth = case(name)
    result = runner(FUNCTIONS[name], values, textures)
    assert result.shape == truth.shape
    assert np.isfinite(result).all()
    excess = np.abs(result - truth) - allowed.absolute - allowed.relative * np.abs(truth)
    worst = int(np.argmax(excess.reshape(len(truth), -1).max(axis=1)))
    row = {key: value[worst] for key, value in values.items()}
    assert excess.max() <= 0.0, f"{row}: {result[worst]}, not {truth[worst]}"
