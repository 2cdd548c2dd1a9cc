"""The statuses of an oriented photograph, and which of them later steps rely on."""

from __future__ import annotations

STATUSES = ("accepted", "confirmed", "ambiguous", "rejected", "failed")
"""From best to worst. A matcher never gives 'confirmed': a person writes it for a heading that they have checked."""

RELIABLE = ("accepted", "confirmed")
"""Statuses of the headings that later steps use unless they are told otherwise."""


def known_status(text: object) -> str | None:
    """Return one of `STATUSES`, or None for NULL and any other text, such as that of a hand-made field."""
    word = text.strip().lower() if isinstance(text, str) else None
    return word if word in STATUSES else None
