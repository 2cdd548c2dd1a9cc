"""Drawing of the compass readings of a collection: over the hours of the day, and over the whole circle."""

from __future__ import annotations

import numpy as np

from ..figures.svg import Scale, element, figure, line, text
from ..figures.text import degrees

NEAR_DEG = 45.0
"""Differences beyond this are marks at the edge of the left panel; the right one shows the whole circle."""

MOST_DEVICES = 4
"""Devices with a colour of their own; those with fewer readings share the last one."""

BIN_DEG = 5.0


def compass_svg(groups, width=1280, height=300, say=str):
    """Draw recorded minus found headings.

    Parameters
    ----------
    groups : sequence of (hour, difference_deg, bias_deg)
        For each device the hours of the day (NaN if unknown), the differences in [-180, 180), and the bias or None.
    width, height : float
        Size of the drawing [px].
    say : callable
        Translates the fixed English words; see `core.figures.text`.

    Returns
    -------
    str
        An accessible SVG. Left: differences over the time of day, with the bias of each device. Right: how many
        readings have each difference, over the whole circle.
    """
    split = 0.66 * width
    hours = np.concatenate([hour for hour, _, _ in groups])
    known = hours[np.isfinite(hours)]
    low, high = (np.floor(known.min()), np.ceil(known.max())) if len(known) else (0, 24)
    x, y = Scale(low, max(high, low + 1), 54, split - 20), Scale(-NEAR_DEG, NEAR_DEG, height - 34, 14)
    parts = _frame(x, y, say)
    for number, (hour, difference, bias) in enumerate(groups):
        class_ = f"device{min(number, MOST_DEVICES - 1)}"
        parts.append(_dots(x, y, hour, difference, class_))
        if bias is not None and abs(bias) < NEAR_DEG:
            parts.append(line(x.start, float(y(bias)), x.stop, float(y(bias)), f"bias {class_}"))
    every = np.concatenate([difference for _, difference, _ in groups])
    parts += _histogram(every, Scale(-180, 180, split + 34, width - 20), height, say)
    title = say("Compass minus heading found")
    said = say("{count} readings, median difference {median}.").format(
        count=len(every), median=degrees(float(np.median(every)), 1, signed=True)
    )
    return figure(width, height, title, said, *parts)


def _frame(x, y, say):
    parts = []
    for value in (-30, 0, 30):
        level = float(y(value))
        parts += [line(x.start, level, x.stop, level, "axis" if value == 0 else "grid")]
        parts += [text(x.start - 6, level + 4, degrees(value, 0, signed=True), "label", "end")]
    step = max(1, round((x.high - x.low) / 12))
    for hour in np.arange(x.low, x.high + 0.5, step):
        parts += [line(float(x(hour)), y.start, float(x(hour)), y.start + 4, "axis")]
        parts += [text(float(x(hour)), y.start + 17, f"{hour:.0f}", "label", "middle")]
    return [*parts, text(x.stop, y.start + 30, say("hour of the day, camera's clock"), "label", "end")]


def _dots(x, y, hour, difference, class_):
    """One path of points, drawn as round ends of lines without length; those too far away lie at the edges."""
    known = np.isfinite(hour)
    at = np.column_stack([x(hour[known]), y(np.clip(difference[known], -NEAR_DEG, NEAR_DEG))])
    path = "".join(f"M{a:.1f} {b:.1f}h0" for a, b in at.tolist())
    return element("path", d=path, class_=f"dots {class_}") if path else ""


def _histogram(every, x, height, say):
    edges = np.arange(-180, 180 + BIN_DEG, BIN_DEG)
    counts, _ = np.histogram(every, edges)
    y = Scale(0, float(np.sqrt(counts.max())) or 1.0, height - 34, 30)  # roots, so that single readings can be seen
    bars = [
        element("rect", x=float(x(left)), y=float(y(np.sqrt(count))), width=float(x(left + BIN_DEG) - x(left)) - 0.5,
                height=y.start - float(y(np.sqrt(count))), class_="bars")
        for left, count in zip(edges.tolist(), counts.tolist())
        if count
    ]  # fmt: skip
    parts = [line(x.start, y.start, x.stop, y.start, "axis")]
    for value in (-180, -90, 0, 90, 180):
        parts += [line(float(x(value)), y.stop, float(x(value)), y.start + 4, "grid")]
        parts += [text(float(x(value)), y.start + 17, degrees(value, 0, signed=True), "label", "middle")]
    biggest = text(x.start, y.stop - 8, say("most in one bar: {count}").format(count=int(counts.max())), "label")
    return [*parts, *bars, biggest]
