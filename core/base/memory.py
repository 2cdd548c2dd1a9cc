"""Large arrays of zeros whose memory is fetched in large pages where the system has them."""

from __future__ import annotations

import mmap
from typing import Any

import numpy as np

LARGE_BYTES = 2**22
"""From this size on large pages pay, as NumPy also assumes for arrays without initial values."""


def zeros(shape: tuple[int, ...], dtype: Any = np.uint8) -> np.ndarray:
    """Make an array of zeros that takes memory only where it is written.

    Linux gives memory in pages of 4 kB, one interrupt each, or two if it is read before it is written. For the result
    of a viewshed these take longer than writing it. Pages of 2 MB, which NumPy asks for in `numpy.empty` only, reduce
    that to a tenth.

    Parameters
    ----------
    shape : tuple of int
    dtype : numpy.dtype
    """
    count = int(np.prod(shape, dtype=np.int64))
    size = count * np.dtype(dtype).itemsize
    if size < LARGE_BYTES or not hasattr(mmap, "MADV_HUGEPAGE"):
        return np.zeros(shape, dtype)
    try:
        memory = mmap.mmap(-1, size, flags=mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS)
        memory.madvise(mmap.MADV_HUGEPAGE)
    except OSError:  # no room, about which NumPy has an error of its own, or a kernel without large pages
        return np.zeros(shape, dtype)
    return np.frombuffer(memory, dtype, count).reshape(shape)
