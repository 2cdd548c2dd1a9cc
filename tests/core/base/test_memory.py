"""Large zeros behave like those of NumPy, and take memory only where they are written."""

from __future__ import annotations

import mmap
import pickle

import numpy as np
import pytest
from skyline_viewshed.core.base import memory
from skyline_viewshed.core.base.memory import LARGE_BYTES, zeros


@pytest.mark.parametrize("shape", [(3, 5), (0, 7), (3000, 2001)])
@pytest.mark.parametrize("dtype", [np.uint8, np.float32])
def test_they_are_zero_and_can_be_written_and_pickled(shape, dtype):
    values = zeros(shape, dtype)
    assert values.shape == shape
    assert values.dtype == dtype
    assert not values.any()
    values += 1
    assert np.array_equal(pickle.loads(pickle.dumps(values)), np.ones(shape, dtype))


@pytest.mark.skipif(not hasattr(mmap, "MADV_HUGEPAGE"), reason="the system has no large pages")
def test_a_refusal_of_large_pages_gives_usual_ones(monkeypatch):
    def refuse(*given, **named):
        raise OSError("no large pages")

    monkeypatch.setattr(memory.mmap, "mmap", refuse)
    assert not zeros((LARGE_BYTES + 1,)).any()
