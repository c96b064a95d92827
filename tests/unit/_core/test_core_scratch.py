import numpy as np
import pytest

from skinshade._core.scratch import LINE, Scratch


@pytest.mark.parametrize("size", [0, 1000, 1 << 20])
def test_arrays_of_a_block_do_not_overlap_and_begin_at_cache_lines(size):
    scratch = Scratch(size)
    arrays = [scratch.take((count, 2), np.uint32) for count in (3, 1, 40)]
    for number, array in enumerate(arrays):
        array[...] = number
    assert [set(array.ravel().tolist()) for array in arrays] == [{0}, {1}, {2}]
    assert all(array.ctypes.data % LINE == 0 for array in arrays) or size == 0


def test_temporary_arrays_give_their_memory_back():
    scratch = Scratch(1 << 12)
    kept = scratch.take(16)
    with scratch.temporary():
        first = scratch.take(16)
    second = scratch.take(16)
    assert first.ctypes.data == second.ctypes.data
    assert not np.shares_memory(kept, second)


def test_memory_is_given_back_after_an_error():
    scratch = Scratch(1 << 12)
    with pytest.raises(ValueError, match="stop"), scratch.temporary():
        first = scratch.take(16)
        raise ValueError("stop")
    assert scratch.take(16).ctypes.data == first.ctypes.data


def test_arrays_beyond_the_size_have_memory_of_their_own():
    scratch = Scratch(256)
    inside, outside = scratch.take(32), scratch.take(1000)
    outside[...] = 1.0
    assert not np.shares_memory(inside, outside)
    assert outside.shape == (1000,)


@pytest.mark.parametrize("size", [256, 1 << 12])
def test_the_last_array_can_be_given_back(size):
    scratch = Scratch(size)
    kept, last = scratch.take(16), scratch.take(100)
    scratch.give_back(last)
    again = scratch.take(16)
    assert (again.ctypes.data == last.ctypes.data) == (size > 1000)
    assert not np.shares_memory(kept, again)
