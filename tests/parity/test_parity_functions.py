"""Every function of the shader library beside its twin in the specification, on a real driver."""

from __future__ import annotations

import numpy as np
import pytest
from inputs import drawn
from twins import expected, tables_for

from parity_tolerances import FLOAT32, PARITY
from skinshade.codegen.signatures import signatures

FUNCTIONS = {each.name: each for each in signatures()}
BATCHES = 6


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_function_equals_its_twin_on_random_and_limiting_inputs(runner, name):
    signature, allowed = FUNCTIONS[name], PARITY.get(name, FLOAT32)
    tables = tables_for(signature)
    textures = {table: pair[0] for table, pair in tables.items()}
    for seed in range(BATCHES):
        values = drawn(signature, seed)
        found = runner(signature, values, textures)
        want = expected(signature, values, tables)
        assert found.shape == want.shape
        assert np.isfinite(found).all()
        excess = np.abs(found - want) - allowed.absolute - allowed.relative * np.abs(want)
        worst = int(np.argmax(excess.reshape(len(want), -1).max(axis=1)))
        row = {key: value[worst] for key, value in values.items()}
        assert excess.max() <= 0.0, f"{row}: {found[worst]}, not {want[worst]}"
