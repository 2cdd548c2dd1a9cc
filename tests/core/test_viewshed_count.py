import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.terrain import Window
from skyline_viewshed.core.viewshed_count import SeenCount


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 2**31), st.integers(1, 700), st.integers(1, 600), st.integers(1, 4))
def test_counts_equal_those_of_whole_arrays(seed, rows, cols, photos):
    rng = np.random.default_rng(seed)
    count = SeenCount((rows, cols))
    seen, unknown = np.zeros((rows, cols), int), np.zeros((rows, cols), bool)
    for _ in range(photos):
        top, left = int(rng.integers(rows)), int(rng.integers(cols))
        window = Window(top, left, int(rng.integers(1, rows - top + 1)), int(rng.integers(1, cols - left + 1)))
        values = rng.choice(np.array([0, 1, 255], np.uint8), (window.rows, window.cols))
        count.add(window, values)
        place = slice(top, top + window.rows), slice(left, left + window.cols)
        seen[place] += values == 1
        unknown[place] |= values == 255
    first = int(rng.integers(rows))
    last = int(rng.integers(first, rows)) + 1
    found, doubt = count.strip(first, last - first)
    np.testing.assert_array_equal(found, seen[first:last])
    np.testing.assert_array_equal(doubt, unknown[first:last] & (seen[first:last] == 0))


def test_ground_that_nobody_looks_at_takes_no_memory():
    count = SeenCount((10_000_000, 10_000_000))
    count.add(Window(9_999_990, 9_999_990, 10, 10), np.ones((10, 10), np.uint8))
    seen, unknown = SeenCount((5, 5)).strip(0, 5)
    assert len(count._tiles) == 1 and not seen.any() and not unknown.any()
