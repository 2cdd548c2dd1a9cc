"""The head of the report: counts, filters, and the table of all photographs, which sorts by a click."""

from __future__ import annotations

from collections import Counter

from ..base.status import STATUSES
from ..figures.text import azimuth, compass_point, degrees, is_known, plus_minus, with_unit
from .facts import percent, status_word
from .pieces import fill, joined

SIGNS = {"accepted": "✓", "confirmed": "★", "ambiguous": "?", "rejected": "✕", "failed": "!"}
"""Signs shown beside the colour, for readers who cannot tell red from green."""

LAYERS = ("evidence", "extracted", "best", "alternative")
"""Layers of the overlays."""


def columns(say):
    """Headings of the table, and whether each column sorts by number."""
    return (
        (say("Status"), True),
        (say("Photo"), False),
        (say("Heading"), True),
        (say("90 %"), True),
        (say("Within 3°"), True),
        (say("Second best"), True),
        (say("Compass − found"), True),
        (say("Pitch"), True),
        (say("Roll"), True),
        (say("HFOV"), True),
        (say("Residual"), True),
    )


def badge(status, say=str):
    """The coloured word of a status."""
    return fill("badge", sign=SIGNS[status], word=status_word(status, say))


def switches():
    """Hidden inputs that filter photographs and switch layers without a script.

    They precede the elements that they control.
    """
    shown = [("show_switch", name, " checked" if name == "all" else "") for name in ("all", *STATUSES)]
    layers = [("layer_switch", name, " checked") for name in LAYERS] + [("layer_switch", "whole", "")]
    return joined([*(fill(piece, name=name, checked=checked) for piece, name, checked in shown + layers), "\n"])


def bar(summaries, say=str):
    """The bar that stays in view: filters by status on the left, layers of the overlays on the right."""
    counts = Counter(summary.status for summary in summaries)
    filters = [("all", f"{say('all')} {len(summaries)}")]
    filters += [(name, f"{SIGNS[name]} {status_word(name, say)} {counts[name]}") for name in STATUSES if counts[name]]
    words = say("evidence"), say("extracted skyline"), say("DEM horizon, answer"), say("alternatives")
    layers = [(name, fill("layer_key", name=name), said) for name, said in zip(LAYERS, words)]
    layers.append(("whole", "", say("whole picture")))
    return fill(
        "bar",
        filters=joined(fill("show_label", name=name, words=said) for name, said in filters),
        layers=joined(fill("layer_label", name=name, key=key, words=said) for name, key, said in layers),
    )


def overview_table(summaries, say=str, first=1):
    """The table of photographs, in the order of the run.

    Parameters
    ----------
    summaries : sequence of Summary
    say : callable
        Translates the fixed English words; see `core.figures.text`.
    first : int
        Number of the first photograph.
    """
    heads = [fill("number_head" if numeric else "text_head", words=name) for name, numeric in columns(say)]
    heads[0] = fill("status_head", words=columns(say)[0][0])
    rows = joined(_row(number, summary, say) for number, summary in enumerate(summaries, first))
    return fill("overview", heads=joined(heads), rows=rows)


def numbers_of(summary, say=str):
    """Values and words of a summary for all columns after status and name."""
    half = "–" if summary.half_interval_deg is None else plus_minus(summary.half_interval_deg)
    known = summary.heading_deg is not None
    heading = f"{azimuth(summary.heading_deg)} {compass_point(summary.heading_deg, say)}" if known else "–"
    residual = with_unit(summary.residual_px, "px", 1)
    if summary.residual_deg is not None:
        residual += f", {summary.residual_deg:.2f}°"
    return (
        (summary.heading_deg, heading),
        (summary.half_interval_deg, half),
        (summary.p_correct, percent(summary.p_correct)),
        (summary.second_deg, azimuth(summary.second_deg)),
        (summary.compass_difference_deg, degrees(summary.compass_difference_deg, 1, signed=True)),
        (summary.pitch_deg, degrees(summary.pitch_deg, 1, signed=True)),
        (summary.roll_deg, degrees(summary.roll_deg, 1, signed=True)),
        (summary.hfov_deg, degrees(summary.hfov_deg)),
        (summary.residual_px, residual),
    )


def _row(number, summary, say):
    reason = fill("reason", words=summary.message) if summary.heading_deg is None else ""
    cells = [
        fill("status_cell", sort=STATUSES.index(summary.status), words=badge(summary.status, say)),
        fill("name_cell", name=summary.name, anchor=f"photo-{number}", reason=reason),
        *(number_cell(value, words) for value, words in numbers_of(summary, say)),
    ]
    return fill("photo_row", status=summary.status, cells=joined(cells))


def number_cell(value, words):
    """A cell that sorts by its value, None or NaN if unknown."""
    return fill("number_cell", sort=sort_key(value), words=words)


def sort_key(value):
    """Text to sort a value by; '' if it is None or NaN."""
    return f"{value:.6g}" if is_known(value) else ""
