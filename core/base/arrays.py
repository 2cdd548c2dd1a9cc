"""Names for the arrays in signatures."""

from __future__ import annotations

from typing import Any

FloatOrArray = Any
"""A float if all arguments are floats, otherwise an array of their common shape.

A union of the two would force every caller to narrow it, and one overload per combination would clutter the functions.
"""
