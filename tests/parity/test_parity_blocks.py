"""Constant blocks: what the host packs is what a shader reads, field by field."""

from __future__ import annotations

from dataclasses import fields
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from skinshade.params import BLOCKS
from skinshade.params.fields import meaning
from skinshade.params.packing import float_count, layout
from skinshade.shaders import generated_text


def filled(of):
    """Every field drawn from its range."""

    def value(field):
        m = meaning(field)
        # Drivers may flush what is too small to be normal in float32.
        one = st.floats(m.low, m.high).filter(lambda v: v == 0.0 or abs(v) > 1e-37)
        shape = np.shape(field.default)
        for size in reversed(shape):
            one = st.tuples(*[one] * size)
        return one

    return st.builds(of, **{field.name: value(field) for field in fields(of)})


@pytest.fixture(scope="module")
def echo(device):
    import wgpu

    module = device.create_shader_module(code=generated_text("echo.wgsl"))
    usage = wgpu.BufferUsage

    def run(block, data):
        pipeline = device.create_compute_pipeline(
            layout="auto", compute={"module": module, "entry_point": f"echo_{block}"}
        )
        given_bytes = device.create_buffer_with_data(data=data, usage=usage.UNIFORM)
        read = device.create_buffer(size=len(data), usage=usage.STORAGE | usage.COPY_SRC)
        entries = [
            {"binding": list(BLOCKS).index(block), "resource": {"buffer": given_bytes}},
            {"binding": len(BLOCKS), "resource": {"buffer": read}},
        ]
        encoder = device.create_command_encoder()
        work = encoder.begin_compute_pass()
        work.set_pipeline(pipeline)
        layout_of = pipeline.get_bind_group_layout(0)
        work.set_bind_group(0, device.create_bind_group(layout=layout_of, entries=entries))
        work.dispatch_workgroups(1)
        work.end()
        device.queue.submit([encoder.finish()])
        return np.frombuffer(device.queue.read_buffer(read), dtype=np.float32)

    return run


@pytest.mark.parametrize("block", BLOCKS)
def test_a_shader_reads_every_field_that_was_packed(echo, block):
    @given(filled(BLOCKS[block]))
    def holds(params):
        found, at = echo(block, params.pack()), 0
        for name, field in layout()[block]["fields"].items():
            width = float_count(field["kind"])
            rows = np.atleast_2d(np.float32(getattr(params, name)))
            want = np.zeros((len(rows), width // len(rows)), dtype=np.float32)
            want[:, : rows.shape[1]] = rows
            assert np.array_equal(found[at : at + width], want.ravel()), name
            at += width

    holds()


@pytest.mark.parametrize("block", BLOCKS)
def test_the_layout_holds_every_field_once_without_overlap(block):
    described = layout()[block]
    assert set(described["fields"]) == {field.name for field in fields(BLOCKS[block])}
    spans = sorted(
        (f["offset"], f["offset"] + 4 * float_count(f["kind"]))
        for f in described["fields"].values()
    )
    assert all(end <= start for (_, end), (start, _) in pairwise(spans))
    assert spans[-1][1] <= described["size"] == len(BLOCKS[block]().pack())
