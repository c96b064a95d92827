"""Constant blocks: a shader reads every field as the host packs it."""

from __future__ import annotations

from functools import partial
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from skinshade._core.errors import ArgumentError
from skinshade._core.generated import generated_text
from skinshade.params import BLOCKS
from skinshade.params.fields import meaning, number_fields
from skinshade.params.packing import float_count, layout


def filled(block):
    """Return a strategy for blocks with every field drawn from its range."""

    def values(field):
        m = meaning(field)
        # Drivers may flush numbers to zero that are subnormal in float32.
        strategy = st.floats(m.low, m.high).filter(lambda v: v == 0.0 or abs(v) > 1e-37)
        for size in reversed(np.shape(field.default)):
            strategy = st.tuples(*[strategy] * size)
        return strategy

    rows = st.fixed_dictionaries({field.name: values(field) for field in number_fields(block)})
    return rows.map(partial(consistent, block)).filter(lambda params: params is not None)


def consistent(block, row):
    """Return a block, or None if its fields do not fit each other."""
    try:
        return block(**row)
    except ArgumentError:
        return None


@pytest.fixture(scope="module")
def echo(device):
    import wgpu

    module = device.create_shader_module(code=generated_text("echo.wgsl"))
    usage = wgpu.BufferUsage

    def run(block, data):
        pipeline = device.create_compute_pipeline(
            layout="auto", compute={"module": module, "entry_point": f"echo_{block}"}
        )
        uniform = device.create_buffer_with_data(data=data, usage=usage.UNIFORM)
        output = device.create_buffer(size=len(data), usage=usage.STORAGE | usage.COPY_SRC)
        entries = [
            {"binding": list(BLOCKS).index(block), "resource": {"buffer": uniform}},
            {"binding": len(BLOCKS), "resource": {"buffer": output}},
        ]
        encoder = device.create_command_encoder()
        work = encoder.begin_compute_pass()
        work.set_pipeline(pipeline)
        group_layout = pipeline.get_bind_group_layout(0)
        work.set_bind_group(0, device.create_bind_group(layout=group_layout, entries=entries))
        work.dispatch_workgroups(1)
        work.end()
        device.queue.submit([encoder.finish()])
        return np.frombuffer(device.queue.read_buffer(output), dtype=np.float32)

    return run


@pytest.mark.parametrize("block", BLOCKS)
def test_a_shader_reads_every_field_as_it_is_packed(echo, block):
    @given(filled(BLOCKS[block]))
    def check(params):
        floats, start = echo(block, params.pack()), 0
        for name, field in layout()[block]["fields"].items():
            width = float_count(field["kind"])
            rows = np.atleast_2d(np.float32(getattr(params, name)))
            padded = np.zeros((len(rows), width // len(rows)), dtype=np.float32)
            padded[:, : rows.shape[1]] = rows
            assert np.array_equal(floats[start : start + width], padded.ravel()), name
            start += width

    check()


@pytest.mark.parametrize("block", BLOCKS)
def test_the_layout_has_every_field_once_without_overlap(block):
    block_layout = layout()[block]
    assert set(block_layout["fields"]) == {field.name for field in number_fields(BLOCKS[block])}
    spans = sorted(
        (f["offset"], f["offset"] + 4 * float_count(f["kind"]))
        for f in block_layout["fields"].values()
    )
    assert all(end <= start for (_, end), (start, _) in pairwise(spans))
    assert spans[-1][1] <= block_layout["size"] == len(BLOCKS[block]().pack())
