"""One thread for NumPy's linear algebra, so that answers do not depend on the number of cores.

BLAS libraries split products among threads and then round differently in the last digits. Photographs gain nothing from
these threads: their matrices are small, and worker processes use the cores better.
"""

from __future__ import annotations

import ctypes
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

LIBRARIES = ("openblas", "libblis", "mkl_rt")
NAMES = (
    ("openblas_get_num_threads{}", "openblas_set_num_threads{}"),
    ("scipy_openblas_get_num_threads{}", "scipy_openblas_set_num_threads{}"),
    ("bli_thread_get_num_threads", "bli_thread_set_num_threads"),
    ("MKL_Get_Max_Threads", "MKL_Set_Num_Threads"),
)
SUFFIXES = ("", "64_", "_64")

_lock = threading.Lock()
_before: list[tuple[Any, int]] = []
_blocks = [0]


@contextmanager
def one_blas_thread() -> Iterator[None]:
    """Limit the BLAS libraries of this process to one thread while the block runs; without a known one, do nothing.

    The number is that of the whole process: if several threads are in such a block, the last one to leave restores it.
    """
    with _lock:
        _blocks[0] += 1
        if _blocks[0] == 1:
            for get, set_ in _controls():
                _before.append((set_, get()))
                set_(1)
    try:
        yield
    finally:
        with _lock:
            _blocks[0] -= 1
            while _blocks[0] == 0 and _before:
                set_, count = _before.pop()
                set_(count)


@lru_cache(maxsize=1)
def _controls() -> list[tuple[Any, Any]]:
    """Pairs of functions that read and set the number of threads, one pair per loaded library."""
    found = []
    for path in _libraries():
        with suppress(OSError):
            library = ctypes.CDLL(path)  # loaded already, so that this only counts one more use
            for get, set_ in ((g.format(s), t.format(s)) for g, t in NAMES for s in SUFFIXES):
                if hasattr(library, get) and hasattr(library, set_):
                    found.append((getattr(library, get), getattr(library, set_)))
                    break
    return found


def _libraries() -> list[str]:
    """Paths of the BLAS libraries that this process uses."""
    if sys.platform.startswith("linux"):
        with suppress(OSError):
            lines = Path("/proc/self/maps").read_text(errors="surrogateescape").splitlines()
            paths = {line[line.index("/") :] for line in lines if "/" in line}
            return sorted(path for path in paths if any(name in Path(path).name for name in LIBRARIES))
    package = Path(np.__file__).parent
    folders = (
        package.parent / "numpy.libs",
        package / ".libs",
        package / ".dylibs",
        Path(sys.exec_prefix) / "Library/bin",
    )
    files = [file for folder in folders if folder.is_dir() for file in folder.iterdir()]
    return sorted(str(file) for file in files if any(name in file.name for name in LIBRARIES))
