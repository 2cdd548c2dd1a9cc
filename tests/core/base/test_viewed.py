from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.terrain import Window
from skyline_viewshed.core.base.viewed import UNKNOWN, VISIBLE, ArraySink, Sink, Viewshed


def test_an_array_sink_puts_pieces_in_their_place():
    sink = ArraySink(Window(10, 20, 3, 4))
    sink.add(Window(11, 21, 2, 2), np.array([[1, 0], [UNKNOWN, 1]], np.uint8))
    sink.set(10, 23, VISIBLE)
    assert sink.values.tolist() == [[0, 0, 0, 1], [0, 1, 0, 0], [0, UNKNOWN, 1, 0]]
    seen = Viewshed(sink.window, sink.values, None, 0.0, None, None)
    assert seen.visible.sum() == 3 and not seen.visible[2, 1]


def test_floats_ask_for_clearance():
    assert ArraySink(Window(0, 0, 1, 1), np.float32).wants_clearance
    assert not ArraySink(Window(0, 0, 1, 1), np.uint32).wants_clearance


def test_a_sink_of_ones_own_must_take_what_it_is_given():
    with pytest.raises(NotImplementedError):
        Sink().add(Window(0, 0, 1, 1), np.zeros((1, 1), np.uint8))
    with pytest.raises(NotImplementedError):
        Sink().set(0, 0, VISIBLE)
