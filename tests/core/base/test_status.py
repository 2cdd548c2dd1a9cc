"""Statuses: one list for report, attributes and shell, and what a hand-made field may hold beside them."""

from __future__ import annotations

import pytest
from skyline_viewshed.core.base.status import RELIABLE, STATUSES, known_status


def test_a_persons_confirmation_is_relied_on_like_an_accepted_answer():
    assert set(RELIABLE) == {"accepted", "confirmed"} and set(RELIABLE) < set(STATUSES)


@pytest.mark.parametrize("text, status", [("accepted", "accepted"), (" Confirmed ", "confirmed"), ("done", None),
                                          ("", None), (None, None), (3, None)])  # fmt: skip
def test_only_our_own_words_are_statuses(text, status):
    assert known_status(text) == status
