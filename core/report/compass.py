"""The compass audit in the report: a table and a drawing."""

from __future__ import annotations

import numpy as np

from ..figures.text import degrees
from .audit import WORTHLESS_DEG, audit
from .facts import percent
from .overview import number_cell, sort_key
from .pieces import Html, fill, joined
from .readings import MOST_DEVICES, compass_svg

LEAST_READINGS = 3
"""A collection with fewer readings has no audit."""


def compass_panel(readings, say=str):
    """Panel with the audit of the compasses.

    Parameters
    ----------
    readings : list of Reading
    say : callable
        Translates the fixed English words; see `core.figures.text`.

    Returns
    -------
    Html
        Empty if there are hardly any readings.
    """
    if len(readings) < LEAST_READINGS:
        return Html()
    devices = audit(readings)
    drawing = Html(compass_svg([_points(readings, one) for one in devices], say=say))
    words = say(
        "Recorded heading minus heading found, of accepted and confirmed photographs. Bias is the median with its 90 % "
        "interval, spread is robust; both leave out readings farther than {limit} from the others."
    ).format(limit=degrees(WORTHLESS_DEG, 0))
    heads = [fill("text_head", words=""), fill("text_head", words=say("Device"))]
    heads += [fill("number_head", words=words) for words in _labels(say)]
    rows = joined(_row(number, one, say) for number, one in enumerate(devices))
    table = fill("compass_table", heads=joined(heads), rows=rows)
    return fill("compass", title=say("Compasses"), words=words, table=table, drawing=drawing)


def _labels(say):
    return (
        say("Readings"),
        say("Bias"),
        say("Spread"),
        say("Off by more than 30°"),
        say("Near +90°, −90°, 180°"),
        say("Drift per hour"),
    )


def _row(number, one, say):
    share = one.worthless / one.count
    turned = ", ".join(map(str, one.turned))
    if one.turned_fault:
        turned += " " + say("(turned)")
    numbers = (
        (one.count, str(one.count)),
        (one.bias_deg, _with_interval(one.bias_deg, one.bias_lo_deg, one.bias_hi_deg, say)),
        (one.spread_deg, degrees(one.spread_deg, 1)),
        (share, f"{one.worthless} ({percent(share)})"),
        (sum(one.turned), turned if sum(one.turned) else "0"),
        (one.drift_deg_per_h, _with_interval(one.drift_deg_per_h, one.drift_lo_deg_per_h, one.drift_hi_deg_per_h, say)),
    )
    cells = [fill("device_key", number=min(number, MOST_DEVICES - 1))]
    cells += [fill("text_cell", sort=one.device, words=one.device or say("unknown"))]
    cells += [number_cell(value, words) for value, words in numbers]
    return fill("place_row", cells=joined(cells))


def _with_interval(value, low, high, say):
    words = degrees(value, 1, signed=True)
    if not sort_key(low):
        return words
    between = degrees(low, 1, signed=True), degrees(high, 1, signed=True)
    return f"{words} ({say('{low} to {high}').format(low=between[0], high=between[1])})"


def _points(readings, one):
    mine = [reading for reading in readings if reading.device == one.device]
    hours = [np.nan if r.taken_at is None else r.taken_at.hour + r.taken_at.minute / 60 for r in mine]
    return np.array(hours, float), np.array([reading.difference_deg for reading in mine]), one.bias_deg
