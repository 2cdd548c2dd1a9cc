"""Drawings of the heading search: the score against the heading as a curve (the paper's NCC figure) and as a rose."""

from __future__ import annotations

import numpy as np

from ..base.angles import difference, wrap_360
from .svg import Scale, area_path, element, figure, line, on_circle, polyline_path, sector_path, spans_360, text, ticks
from .text import azimuth, compass_point, is_known

MOST_POINTS = 720
"""Most points drawn of a curve: one per half degree. Finer curves keep the highest value of each half degree."""


def score_curve_svg(orientation, compass_true_deg=None, score_name="Score", width=620, height=190, say=str):
    """Draw the score over all headings, with the answer, its interval, the alternatives and the compass.

    Parameters
    ----------
    orientation : Orientation
        Its `curve_heading_deg` (true) and `curve_score` are drawn.
    compass_true_deg : float or None
        Recorded heading, converted to true north [degrees].
    score_name : str
        Name of the vertical axis, 'NCC' or 'Score', in the reader's language.
    width, height : float
        Size of the drawing [px].
    say : callable
        Translates the fixed English words; see `core.figures.text`.

    Returns
    -------
    str
        An accessible SVG; see `core.figures.svg.standalone` for a file of its own.
    """
    headings, scores = _thinned(orientation)
    x = Scale(0, 360, 44, width - 16)
    if not len(headings):
        return _empty(width, height, say("Score over all headings"), say("No heading was scored."))
    low, high = _range(scores)
    y = Scale(low, high, height - 34, 24)
    parts = [_frame(x, y, low, high, score_name, say)]
    parts += _interval(orientation, x, y)
    xs, ys = x(headings), y(scores)
    parts.append(element("path", d=area_path(xs, ys, float(y(low))), class_="curve under"))
    if is_known(compass_true_deg):
        at = float(x(wrap_360(compass_true_deg)))
        parts.append(line(at, y.stop, at, y.start, "compass"))
        parts.append(text(*_beside(at, y.start - 5, width), class_="name-compass", words=say("compass")))
    parts += _candidate_marks(orientation, (headings, scores), (x, y), width, say)
    title = say("{score} over all headings").format(score=score_name)
    return figure(width, height, title, _in_words(orientation, compass_true_deg, say), *parts)


def score_rose_svg(orientation, compass_true_deg=None, hfov_deg=None, size=220, say=str):
    """Draw the score as a rose, north up: the data of the curve, in the directions that a person on site would point.

    Parameters
    ----------
    orientation : Orientation
    compass_true_deg : float or None
        Recorded heading, converted to true north [degrees].
    hfov_deg : float or None
        Horizontal field of view, drawn as the wedge that the photo covers [degrees].
    size : float
        Side of the drawing [px].
    say : callable
        Translates the fixed English words; see `core.figures.text`.

    Returns
    -------
    str
        An accessible SVG.
    """
    centre, rim = size / 2, size / 2 - 17
    parts = _dial(centre, rim, say)
    best = orientation.best
    if best is not None and is_known(hfov_deg):
        wedge = sector_path(centre, centre, 0, rim, best.pose.heading_deg - hfov_deg / 2, hfov_deg)
        parts.append(element("path", d=wedge, class_="view"))
    parts += _petals(orientation, centre, rim)
    if is_known(compass_true_deg):
        parts.append(line(centre, centre, *on_circle(centre, centre, rim, compass_true_deg), "compass"))
    for rank, candidate in reversed(list(enumerate(orientation.candidates[:3]))):
        tip = on_circle(centre, centre, rim, candidate.pose.heading_deg)
        parts.append(line(centre, centre, *tip, "best" if rank == 0 else "alternative"))
        mark = "mark-best" if rank == 0 else "mark-alternative"
        parts.append(element("circle", cx=tip[0], cy=tip[1], r=4.5 if rank == 0 else 3.5, class_=mark))
    return figure(
        size, size, say("Score by direction, north up"), _in_words(orientation, compass_true_deg, say), *parts
    )


def probability_rose_svg(heading_deg, probability, size=220, say=str):
    """Draw a probability as a rose, north up; the outer circle stands for 1, and unknown directions for 0.

    Parameters
    ----------
    heading_deg : (H,) array
        Directions clockwise from true north, in order [degrees].
    probability : (H,) array
        NaN where it is not known.
    size : float
        Side of the drawing [px].
    say : callable
        Translates the fixed English words; see `core.figures.text`.

    Returns
    -------
    str
        An accessible SVG.
    """
    centre, rim = size / 2, size / 2 - 17
    parts, known = _dial(centre, rim, say), np.isfinite(probability)
    words = say("The DEM has no horizon here.")
    if known.any():
        x, y = on_circle(centre, centre, np.where(known, probability, 0.0) * rim, heading_deg)
        parts.append(element("path", d=polyline_path(x, y) + "Z", class_="curve under"))
        best = int(np.nanargmax(probability))
        words = say("The probability is highest at azimuth {heading}: {share} %.").format(
            heading=azimuth(heading_deg[best]), share=f"{100 * probability[best]:.0f}"
        )
    return figure(size, size, say("Probability of a unique answer by direction, north up"), words, *parts)


def _dial(centre, rim, say):
    """Circles at a third, two thirds and the whole of the radius, with the four cardinal directions."""
    parts = [element("circle", cx=centre, cy=centre, r=rim * share, class_="grid") for share in (1 / 3, 2 / 3)]
    parts.append(element("circle", cx=centre, cy=centre, r=rim, class_="axis"))
    for at in (0, 90, 180, 270):
        parts.append(line(*on_circle(centre, centre, rim, at), *on_circle(centre, centre, rim - 5, at), "axis"))
        label_x, label_y = on_circle(centre, centre, rim + 9, at)
        parts.append(text(label_x, label_y + 4, compass_point(at, say), "label" if at else "strong", "middle"))
    return parts


def _thinned(orientation):
    """Headings in [0, 360) in order and their scores, at most `MOST_POINTS`, keeping each step's highest."""
    headings = wrap_360(np.asarray(orientation.curve_heading_deg, float))
    scores = np.asarray(orientation.curve_score, float)
    known = np.isfinite(headings) & np.isfinite(scores)
    headings, scores = headings[known], scores[known]
    order = np.argsort(headings, kind="stable")
    headings, scores = headings[order], scores[order]
    if len(headings) <= MOST_POINTS:
        return headings, scores
    step = np.floor(headings * (MOST_POINTS / 360)).astype(int)
    starts = np.flatnonzero(np.r_[True, np.diff(step) > 0])
    highest = np.maximum.reduceat(scores, starts)
    stops = np.r_[starts[1:], len(scores)]
    at = [start + int(np.argmax(scores[start:stop])) for start, stop in zip(starts, stops)]
    return headings[at], highest


def _range(scores):
    """Vertical range with a margin; the lowest fifth of the circle may fall below the axis."""
    low, high = float(np.percentile(scores, 2)), float(scores.max())
    if not high > low:
        return low - 0.5, high + 0.5
    return low - 0.04 * (high - low), high + 0.06 * (high - low)


def _frame(x, y, low, high, score_name, say):
    parts = []
    for value in ticks(low, high, 4):
        at = float(y(value))
        parts += [
            line(x.start, at, x.stop, at, "grid"),
            text(x.start - 5, at + 4, f"{value:.3g}".replace("-", "−"), anchor="end"),
        ]
    for heading in range(0, 361, 45):
        at = float(x(heading))
        parts += [line(at, y.start, at, y.start + 4, "axis")]
        parts.append(text(at, y.start + 16, compass_point(heading, say), "name", "middle"))
        parts.append(text(at, y.start + 29, f"{heading}°", anchor="middle"))
    parts += [line(x.start, y.start, x.stop, y.start, "axis"), text(4, 13, score_name)]
    return "".join(parts)


def _interval(orientation, x, y):
    low, high = orientation.heading_lo_deg, orientation.heading_hi_deg
    if not (is_known(low) and is_known(high)):
        return []
    tall = y.start - y.stop
    return [
        element("rect", x=float(x(a)) - 0.5, y=y.stop, width=float(x(b) - x(a)) + 1, height=tall, class_="interval")
        for a, b in spans_360(low, wrap_360(high - low))
    ]


def _candidate_marks(orientation, curve, axes, width, say):
    """Mark the candidates on a curve (headings, scores), drawn along two axes (x, y)."""
    (headings, scores), (x, y) = curve, axes
    parts, labels = [], []
    for rank, candidate in enumerate(orientation.candidates[:3]):
        heading = float(wrap_360(candidate.pose.heading_deg))
        nearby = np.abs(difference(headings, heading)) <= 1.0
        value = scores[nearby].max() if nearby.any() else np.interp(heading, headings, scores, period=360)
        at, level = float(x(heading)), float(y(np.clip(value, y.low, y.high)))
        name = "best" if rank == 0 else "alternative"
        dot = element("circle", cx=at, cy=level, r=4.5 if rank == 0 else 3.5, class_=f"mark-{name}")
        parts.append(line(at, level, at, y.start, name) + dot)
        words = f"{azimuth(heading)} {compass_point(heading, say)}" if rank == 0 else f"{rank + 1}: {azimuth(heading)}"
        label_x, label_y = _beside(at, max(level - 6, 12) if rank == 0 else level - 4, width)
        while any(abs(label_x - a) < 80 and abs(label_y - b) < 12 for a, b in labels):
            label_y += 12
        labels.append((label_x, label_y))
        parts.append(text(label_x, label_y, words, f"name-{name}"))
    return parts[::-1]


def _beside(at, level, width):
    """Coordinates x, y for a label to the right of `at`, or to the left of it near the right edge."""
    return at + 7 if at < width - 90 else at - 78, level


def _petals(orientation, centre, rim):
    headings, scores = _thinned(orientation)
    if not len(headings):
        return []
    low, high = _range(scores)
    radius = np.clip((scores - low) / (high - low), 0, 1) * rim
    x, y = on_circle(centre, centre, radius, headings)
    path = polyline_path(x, y) + "Z"
    return [element("path", d=path, class_="curve under")]


def _in_words(orientation, compass_true_deg, say):
    """Describe the figure in words, for readers who cannot see it."""
    if orientation.best is None:
        return say("No heading was found.")
    best, *others = (azimuth(candidate.pose.heading_deg) for candidate in orientation.candidates[:3])
    said = [say("The best heading is {heading} from true north.").format(heading=best)]
    if others:
        said.append(say("Alternatives are at {headings}.").format(headings=", ".join(others)))
    if is_known(compass_true_deg):
        said.append(say("The compass recorded {heading}.").format(heading=azimuth(compass_true_deg)))
    return " ".join(said)


def _empty(width, height, title, words):
    return figure(width, height, title, words, text(width / 2, height / 2, words, "name", "middle"))
