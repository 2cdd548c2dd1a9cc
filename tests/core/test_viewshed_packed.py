"""Two bits per cell hold what a byte holds, and read like an array."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.terrain import Window
from skyline_viewshed.core.viewshed_packed import PackedSink


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 9), st.integers(1, 30), st.integers(1, 30), st.integers(0, 10_000), st.data())
def test_any_piece_reads_as_it_was_written(left, rows, cols, seed, data):
    window = Window(5, left, rows, cols)
    values = np.random.default_rng(seed).choice(np.array([0, 1, 255], np.uint8), (rows, cols))
    sink = PackedSink(window)
    half = data.draw(st.integers(0, cols))
    for first, last in ((0, half), (half, cols)):
        if first < last:
            sink.add(Window(5, left + first, rows, last - first), values[:, first:last])
    row, col = data.draw(st.integers(0, rows)), data.draw(st.integers(0, cols))
    assert sink.values.shape == values.shape and sink.dtype == values.dtype
    np.testing.assert_array_equal(sink.values[:, :], values)
    np.testing.assert_array_equal(sink.values[row:, :col], values[row:, :col])
    np.testing.assert_array_equal(sink.values[:row, col:], values[:row, col:])
    np.testing.assert_array_equal(sink.values[row : row + 3], values[row : row + 3])


def test_a_single_cell_is_set_anew():
    sink = PackedSink(Window(0, 3, 4, 4))
    sink.set(2, 5, 255)
    sink.set(2, 5, 1)
    assert sink.values[2:3, 2:3] == 1 and sink.values[:, :].sum() == 1
