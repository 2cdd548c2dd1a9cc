"""Heights as people write them."""

from __future__ import annotations

import pytest
from skyline_viewshed.core.base.summit_heights import contradicts, fits_in_feet, height_m


@pytest.mark.parametrize(
    "text",
    ["2290", "2290 m", "2290m", "2290.0", "2,290", "2'290", "2 290 m", "2\u202f290", "7513 ft", "7,513 ft", "7513'",
     "7513 feet", "2290;2300", "2290-2300", "~2290", "ca. 2290 m ü. M.", "2290 m (7513 ft)",
     "\uff12\uff12\uff19\uff10"],
)  # fmt: skip
def test_every_spelling_of_2290_metres(text):
    assert height_m(text) == pytest.approx(2290, abs=0.1)


def test_decimals_signs_and_texts_without_a_number():
    assert height_m("8848.86") == 8848.86 and height_m("2290,5") == 2290.5 and height_m("-5 m") == -5
    assert height_m("") is None and height_m("unknown") is None


@pytest.mark.parametrize(("published", "top", "wrong"), [
    (2290, 2294, False), (4478, 4300, False), (18941, 2294, True), (7513, 2294, True), (300, 91, True),
    (8849, 8849 / 3.28, True), (20, 6, False), (2290, float("nan"), False),
])  # fmt: skip
def test_a_dem_contradicts_misprints_and_bare_feet_but_not_a_sharp_summit_on_coarse_cells(published, top, wrong):
    assert contradicts(published, top) is wrong


@pytest.mark.parametrize(("published", "top", "feet"), [
    (7513, 2294, True), (300, 91, True), (18941, 2294, False), (6782, 6042, False), (7513, float("nan"), False),
])  # fmt: skip
def test_feet_are_advised_only_where_they_would_agree(published, top, feet):
    assert fits_in_feet(published, top) is feet
