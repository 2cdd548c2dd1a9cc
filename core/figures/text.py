"""Text from outside sources, made safe and legible before it enters a figure or a page.

The fixed words of figures and pages are English literals inside `say(...)`, where they are used. The caller passes
`say`: a shell passes a function that translates each into the reader's language, and `str` leaves them English.
"""

from __future__ import annotations

import html
import math
import unicodedata

LONGEST_TEXT = 400
"""Characters after which an outside text is cut; a file name has 255 bytes at most, an EXIF string may have 64 k."""

MOST_MARKS = 4
"""Combining marks kept in a row; more of them would overlap the neighbouring lines."""

_DIRECTION_MARKS = {0x061C, 0x200E, 0x200F, *range(0x202A, 0x202F), *range(0x2066, 0x206A)}


def plain(text, longest=LONGEST_TEXT):
    """Make a text of unknown origin safe to show on one line, without losing anything silently.

    Line breaks and tabs become spaces. Control characters, surrogates (bytes of a file name that are not UTF-8),
    and marks that turn the writing direction (with which `gpj.exe` can pose as `exe.jpg`) become visible code
    points such as ``<U+202E>`` in angle quotes. Over-long texts are cut with an ellipsis.
    """
    shown, marks = [], 0
    text = str(text)
    for character in text[:longest]:
        marks = marks + 1 if unicodedata.combining(character) else 0
        if character in "\t\n\r\u2028\u2029":
            shown.append(" ")
        elif ord(character) in _DIRECTION_MARKS or _is_unprintable(character):
            shown.append(f"\u27e8U+{ord(character):04X}\u27e9")
        elif marks <= MOST_MARKS:
            shown.append(character)
    return "".join(shown) + ("\u2026" if len(text) > longest else "")


def _is_unprintable(character):
    # Cc is control, Cs surrogate, Cn unassigned or noncharacter; Cf would also remove the joiners of emoji and Persian.
    return unicodedata.category(character) in ("Cc", "Cs", "Cn") or 0xE0000 <= ord(character) <= 0xE007F


def escape(text, longest=LONGEST_TEXT):
    """`plain`, then escaped for HTML and XML, for element content and quoted attributes alike."""
    return html.escape(plain(text, longest), quote=True)


def compass_point(azimuth_deg, say=str):
    """Name of the nearest of the sixteen compass points, 'N' to 'NNW', for an azimuth [degrees]."""
    points = say("N NNE NE ENE E ESE SE SSE S SSW SW WSW W WNW NW NNW").split()
    return points[round(azimuth_deg / 22.5) % 16]


def degrees(angle_deg, decimals=1, signed=False):
    """Write an angle with its sign: '45.5°', '+2.0°', or an en dash if it is None or not finite.

    Parameters
    ----------
    angle_deg : float or None
        [degrees]
    decimals : int
    signed : bool
        Whether positive angles get a plus sign.
    """
    return with_unit(angle_deg, "°", decimals, signed, space="")


def azimuth(azimuth_deg, decimals=1):
    """Write an azimuth in [0, 360): 359.97 becomes '0.0°', never '360.0°'."""
    if not is_known(azimuth_deg):
        return "–"
    return f"{round(azimuth_deg % 360.0, decimals) % 360.0:.{decimals}f}°"


def plus_minus(half_deg):
    """Write half the width of an interval, such as '±0.25°' or '±100°'."""
    return f"±{half_deg:.{decimals_of(half_deg)}f}°"


def decimals_of(half_deg):
    """Give the number of decimals that an angle deserves whose interval is this wide to either side [degrees]."""
    return 2 if half_deg < 1 else 1 if half_deg < 10 else 0


def with_unit(value, unit, decimals=0, signed=False, space="\u00a0"):
    """Write a number with its unit, a true minus sign and thousands separators, or an en dash if it is unknown.

    Parameters
    ----------
    value : float or None
        Unknown if it is None or not finite.
    unit : str
        '' for no unit.
    decimals : int
    signed : bool
        Whether positive numbers get a plus sign.
    space : str
        Space between number and unit.
    """
    if not is_known(value):
        return "–"
    value = round(float(value), decimals) + 0.0  # no '-0.0'
    text = f"{value:{'+' if signed and value else ''},.{decimals}f}".replace(",", "\u202f").replace("-", "\u2212")
    return f"{text}{space}{unit}" if unit else text


def is_known(value):
    """Return whether a number is given and finite."""
    return value is not None and math.isfinite(value)
