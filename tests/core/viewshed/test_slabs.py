import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.viewshed.slabs import CHUNK, range_minimum


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
