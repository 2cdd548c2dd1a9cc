"""One thread of BLAS while photographs are computed, also if several threads of the program compute."""

from __future__ import annotations

import threading

import pytest
from skyline_viewshed.core.base import blas


@pytest.fixture
def library(monkeypatch):
    """A library with eight threads."""
    state = {"threads": 8}
    controls = [(lambda: state["threads"], lambda count: state.update(threads=count))]
    monkeypatch.setattr(blas, "_controls", lambda: controls)
    return state


def test_the_block_has_one_thread_and_then_the_number_is_restored(library):
    with pytest.raises(ValueError, match="a fault"), blas.one_blas_thread():
        with blas.one_blas_thread():
            assert library["threads"] == 1
        assert library["threads"] == 1
        raise ValueError("a fault")
    assert library["threads"] == 8


def test_the_last_of_several_threads_restores_the_number(library):
    """The first one to leave must neither restore it for the other, nor the other keep the 1 that it found."""
    inside, leave = threading.Event(), threading.Event()

    def other():
        with blas.one_blas_thread():
            inside.set()
            leave.wait(10)

    thread = threading.Thread(target=other)
    with blas.one_blas_thread():
        thread.start()
        assert inside.wait(10)
    assert library["threads"] == 1
    leave.set()
    thread.join(10)
    assert library["threads"] == 8


def test_the_librarys_own_number_is_read_and_set():
    """Old libraries that were started with a single thread (OPENBLAS_NUM_THREADS) keep it."""
    changed = 0
    for get, set_ in blas._controls():
        before = get()
        set_(2)
        if get() == 2:
            with blas.one_blas_thread():
                assert get() == 1
            assert get() == 2
            changed += 1
        set_(before)
    if not changed:
        pytest.skip("no BLAS library of this process can be controlled, or has more than one thread")
