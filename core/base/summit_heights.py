"""Heights of summits as people write them, and whether the DEM agrees with them."""

from __future__ import annotations

import re

FOOT_M = 0.3048
FEET = ("ft", "feet", "foot", "'", "′", "’", "фт", "pieds", "pie", "pies", "fuß", "fuss")

CONTRADICTION_M = 250.0
"""A published height this far from the top in the DEM belongs to something else, or is a misprint [m]. A coarse DEM
lowers the sharpest summits by about 200 m."""

FEET_RATIO, FEET_SHARE, FEET_LEAST_M = 1 / FOOT_M, 0.05, 40.0
"""A height this many times that of the DEM, within this share, was given in feet if both differ by more than this
[m]."""

_NUMBER = re.compile(r"[-+]?\d[\d.,'’ \u00a0\u2009\u202f]*")
_THOUSANDS = re.compile(r"[-+]?\d{1,3}(?:[,'’ \u00a0\u2009\u202f]\d{3})+(?:\.\d+)?")


def height_m(text: str) -> float | None:
    """Read a height in metres from text such as '2290 m', '2,290', "7513'", '7513 ft', '~2290' or '2290;2300'.

    Of several heights the first is taken. Without a unit, a number counts as metres. A comma, apostrophe or space
    before three digits separates thousands; any other comma is a decimal one.

    Returns
    -------
    float or None
        [m]; None if the text has no number.
    """
    found = _NUMBER.search(str(text))
    if found is None:
        return None
    digits = found.group()
    thousands = _THOUSANDS.match(digits)
    plain = thousands or re.match(r"[-+]?\d+(?:[.,]\d+)?", digits)
    kept = plain.group() if plain else digits
    number = re.sub(r"[,'’\s]", "", kept) if thousands else kept.replace(",", ".")
    unit = str(text)[found.start() + len(kept) :].strip().lower()
    value = float(number)
    return value * FOOT_M if unit.startswith(FEET) else value


def contradicts(published_m: float, top_m: float) -> bool:
    """Tell whether a published height cannot be that of a top in the DEM; False where the DEM is unknown (NaN) [m]."""
    if abs(published_m - top_m) > CONTRADICTION_M:
        return True
    feet_of_top = abs(published_m - FEET_RATIO * top_m) < FEET_SHARE * abs(published_m)
    return feet_of_top and abs(published_m - top_m) > FEET_LEAST_M


def fits_in_feet(published_m: float, top_m: float) -> bool:
    """Tell whether a number that was read as metres agrees with a top in the DEM if it is taken as feet [m]."""
    return abs(published_m * FOOT_M - top_m) <= CONTRADICTION_M
