import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.viewshed.blocks import BAND, CHUNK, LOW, WIDE, _highest, bands_of, range_minimum


@settings(max_examples=60, deadline=None)
@given(seed=st.integers(0, 10_000), size=st.integers(1, 700))
def test_the_range_minimum_is_a_lower_bound_and_no_looser_than_whole_chunks(seed, size):
    rng = np.random.default_rng(seed)
    values = rng.normal(size=size).astype(np.float32)
    ends = np.sort(rng.integers(0, size, (40, 2)), axis=1)
    found = range_minimum(values, ends[:, 0], ends[:, 1])
    for (first, last), minimum in zip(ends, found):
        outward = values[first // CHUNK * CHUNK : (last // CHUNK + 1) * CHUNK]
        assert minimum == outward.min()
        assert minimum <= values[first : last + 1].min()


def test_the_highest_cell_of_each_block_is_known_also_beside_voids():
    rng = np.random.default_rng(7)
    bands = [rng.normal(0, 9, (lines, 2 * BAND)).astype(np.float32) for lines in (BAND, 3)]
    top, void = _highest(bands)
    blocks = [band.reshape(len(band), -1, WIDE) for band in bands]
    assert void is None
    assert np.array_equal(top, [block.max(axis=(0, 2)) for block in blocks])
    bands[1][1, 5], bands[1][:, WIDE : 2 * WIDE] = np.nan, np.nan
    top, void = _highest(bands)
    assert np.flatnonzero(void.ravel()).tolist() == [top.shape[1], top.shape[1] + 1]
    assert top[1, 1] == LOW
    assert top[1, 0] == np.nanmax(blocks[1][:, 0])


@pytest.mark.parametrize("lines", [np.arange(5, 70), np.arange(63, -1, -1), np.arange(3), np.arange(BAND, 2 * BAND)])
def test_bands_hold_every_line_once_and_cross_no_boundary(lines):
    bands = [lines[part] for part in bands_of(lines)]
    assert np.array_equal(np.concatenate(bands), lines)
    assert all(len(set(band // BAND)) == 1 for band in bands)
    assert len(bands) == len(set(lines // BAND))
