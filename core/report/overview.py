"""The report's head: counts, filters, and the table of all photographs, which sorts by a click."""

from __future__ import annotations

from collections import Counter

from ..figures.text import azimuth, compass_point, degrees, escape, is_known, with_unit
from .facts import STATUSES, percent, status_word

SIGNS = {"accepted": "✓", "ambiguous": "?", "rejected": "✕", "failed": "!"}
"""Beside the colour, for those who do not tell red from green."""

LAYERS = ("evidence", "extracted", "best", "alternative")
"""Of the overlays."""


def columns(say):
    """Heads of the table, and whether the column sorts by number."""
    return (
        (say("Status"), True),
        (say("Photo"), False),
        (say("Heading"), True),
        (say("90 %"), True),
        (say("Within 3°"), True),
        (say("Second"), True),
        (say("Compass − found"), True),
        (say("Pitch"), True),
        (say("Roll"), True),
        (say("HFOV"), True),
        (say("Residual"), True),
    )


def badge(status, say=str):
    """The coloured word of a status."""
    return f'<span class="badge">{SIGNS[status]} {escape(status_word(status, say))}</span>'


def switches():
    """Hidden inputs that filter photographs and switch layers without a script; they precede all they steer."""
    shown = "".join(
        f'<input class="switch" type="radio" name="show" id="show-{name}"{" checked" if name == "all" else ""}>'
        for name in ("all", *STATUSES)
    )
    layers = "".join(f'<input class="switch" type="checkbox" id="layer-{name}" checked>' for name in LAYERS)
    return f'{shown}{layers}<input class="switch" type="checkbox" id="layer-whole">\n'


def bar(summaries, say=str):
    """The bar that stays in sight: filters by status on the left, layers of the overlays on the right."""
    counts = Counter(summary.status for summary in summaries)
    filters = [f'<label for="show-all">{escape(say("all"))} {len(summaries)}</label>']
    filters += [
        f'<label for="show-{name}">{SIGNS[name]} {escape(status_word(name, say))} {counts[name]}</label>'
        for name in STATUSES
        if counts[name]
    ]
    words = say("evidence"), say("extracted skyline"), say("DEM horizon, answer"), say("alternatives")
    layers = [
        f'<label for="layer-{name}"><span class="key key-{name}"></span>{escape(said)}</label>'
        for name, said in zip(LAYERS, words)
    ]
    layers.append(f'<label for="layer-whole">{escape(say("whole picture"))}</label>')
    return f'<div class="bar"><div>{"".join(filters)}<span class="gap"></span>{"".join(layers)}</div></div>\n'


def overview_table(summaries, say=str):
    """The table of all photographs, in the order of the run."""
    heads = "".join(
        f'<th scope="col"{" data-numeric class=number" if numeric else ""}>{escape(name)}</th>'
        for name, numeric in columns(say)
    ).replace(" class=number", "", 1)
    rows = "".join(_row(number, summary, say) for number, summary in enumerate(summaries, 1))
    return (
        f'<section class="panel scroll"><table class="overview sortable"><thead><tr>{heads}</tr></thead>'
        f"<tbody>{rows}</tbody></table></section>\n"
    )


def _row(number, summary, say):
    failed = summary.heading_deg is None
    reason = f'<br><span class="quiet">{escape(summary.message)}</span>' if failed else ""
    name = f'<a href="#photo-{number}"><bdi>{escape(summary.name)}</bdi></a>{reason}'
    half = "–" if summary.half_interval_deg is None else f"±{summary.half_interval_deg:.2f}°"
    heading = "–" if failed else f"{azimuth(summary.heading_deg)} {compass_point(summary.heading_deg, say)}"
    residual = with_unit(summary.residual_px, "px", 1)
    if summary.residual_deg is not None:
        residual += f", {summary.residual_deg:.2f}°"
    cells = (
        (STATUSES.index(summary.status), badge(summary.status, say)),
        (None, ""),
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
    written = [
        f'<td class="number" data-sort="{f"{value:.6g}" if is_known(value) else ""}">{words}</td>'
        for value, words in cells
    ]
    written[0] = written[0].replace(' class="number"', "")
    written[1] = f'<td class="name-cell" data-sort="{escape(summary.name)}">{name}</td>'
    return f'<tr class="item is-{summary.status}">{"".join(written)}</tr>\n'
