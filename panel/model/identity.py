"""Whether what something was made from is still the same."""

from __future__ import annotations

from typing import Any


def same(before: tuple[Any, ...], now: tuple[Any, ...]) -> bool:
    """Return whether two tuples hold the same objects; equal ones would have to be compared value by value."""
    return len(before) == len(now) and all(one is other for one, other in zip(before, now))
