"""Finds calls of NumPy functions whose last digit depends on where their arrays lie in memory.

NumPy computes functions such as `exp` with vector instructions, or one by one with another last digit if the memory of
argument and result overlaps. For this it takes the whole range of memory of a strided view, which may reach into the
result's by chance.
"""

from __future__ import annotations

import sys
from contextlib import contextmanager
from pathlib import Path

import numpy as np

FUNCTIONS = (
    "exp", "log", "log1p", "expm1", "exp2", "log2", "log10", "sin", "cos", "tan", "arcsin", "arccos", "arctan",
    "sinh", "cosh", "arcsinh", "cbrt", "power",
)  # fmt: skip
CORE = Path(__file__).resolve().parent.parent / "core"


def has_gaps(array):
    """Whether a loop over the array steps over memory that is not its own."""
    steps = [abs(step) for step, size in zip(array.strides, array.shape) if size > 1]
    return array.size > 1 and array.dtype.kind == "f" and min(s for s in steps if s or len(steps) == 1) > array.itemsize


@contextmanager
def calls_with_gaps():
    """Collect 'module.py:line function' of such calls by the core while the block runs."""
    found, kept = set(), {}

    def watched(name, function):
        def call(*arguments, **options):
            if any(isinstance(a, np.ndarray) and a.ndim and has_gaps(a) for a in arguments):
                frame = sys._getframe(1)
                if str(CORE) in str(Path(frame.f_code.co_filename).resolve()):
                    found.add(f"{Path(frame.f_code.co_filename).name}:{frame.f_lineno} {name}")
            return function(*arguments, **options)

        return call

    for name in FUNCTIONS:
        kept[name] = getattr(np, name)
        setattr(np, name, watched(name, kept[name]))
    try:
        yield found
    finally:
        for name, function in kept.items():
            setattr(np, name, function)
