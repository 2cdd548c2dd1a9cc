"""Draw how well `orientability` sorts and how far its probability can be trusted, for docs/locate.md."""

from __future__ import annotations

import numpy as np
from skyline_viewshed.core.figures.svg import Scale, element, figure, line, polyline_path, standalone, text

SIDE, LEFT, TOP, BETWEEN = 240.0, 46.0, 28.0, 70.0
HEIGHT = TOP + SIDE + 44.0
CLASSES = ("residual", "alternative", "best")
"""Classes of the style sheet, one for each group of pictures."""


def drawing(groups, bands):
    """Return the SVG text of two panels: the ROC curves, and the share of right answers by predicted probability.

    Parameters
    ----------
    groups : list of (str, (N,) array, (N,) bool array)
        Name, probability and whether the answer was right, of at most three groups; the last is shown on the right.
    bands : list of (float, float, int)
        Mean probability, share of right answers and number of pictures in each band of the last group.
    """
    right = LEFT + SIDE + BETWEEN
    parts = [*_panel(LEFT, "wrong ones above the threshold [%]", "right ones above it [%]")]
    parts += _panel(right, "predicted probability [%]", "oriented right [%]")
    x, y = Scale(0, 1, LEFT, LEFT + SIDE), Scale(0, 1, TOP + SIDE, TOP)
    for number, ((name, chance, is_right), class_) in enumerate(zip(groups, CLASSES)):
        wrong_share, right_share, area = roc(chance, is_right)
        parts.append(element("path", d=polyline_path(x(wrong_share), y(right_share)), class_=class_))
        at = TOP + SIDE - 46 + 16 * number
        parts.append(line(LEFT + 52, at - 4, LEFT + 70, at - 4, class_))
        parts.append(text(LEFT + 76, at, f"{name}: AUC {area:.2f}"))
    x = Scale(0, 1, right, right + SIDE)
    largest = max(count for _, _, count in bands)
    for predicted, share, count in bands:
        radius = 2 + 5 * np.sqrt(count / largest)
        spread = np.sqrt(max(share * (1 - share), 0.25 / count) / count)
        low, high = np.clip([share - spread, share + spread], 0, 1)
        parts.append(line(x(predicted), y(low), x(predicted), y(high), "best"))
        parts.append(element("circle", cx=x(predicted), cy=y(share), r=radius, class_="mark-best"))
    title = "Orientability: how it sorts, and what its probability is worth"
    description = "Left: ROC curves. Right: share of right answers against the predicted probability, in bands."
    return standalone(figure(right + SIDE + 20, HEIGHT, title, description, *parts))


def roc(chance, right):
    """Shares of wrong and of right answers above each threshold, and the area under the curve."""
    order = np.argsort(-chance, kind="stable")
    wrong_share = np.r_[0, np.cumsum(~right[order]) / max((~right).sum(), 1)]
    right_share = np.r_[0, np.cumsum(right[order]) / max(right.sum(), 1)]
    return wrong_share, right_share, float(np.sum(np.diff(wrong_share) * (right_share[1:] + right_share[:-1]) / 2))


def _panel(left, below, beside):
    """Frame, grid, diagonal and labels of one panel."""
    bottom = TOP + SIDE
    yield line(left, bottom, left + SIDE, TOP, "grid")
    for share in (0.0, 0.25, 0.5, 0.75, 1.0):
        x, y = left + share * SIDE, bottom - share * SIDE
        yield line(left, y, left + SIDE, y, "grid")
        yield line(x, TOP, x, bottom, "grid")
        yield text(left - 6, y + 4, f"{100 * share:.0f}", anchor="end")
        yield text(x, bottom + 16, f"{100 * share:.0f}", anchor="middle")
    yield text(left + SIDE / 2, bottom + 34, below, anchor="middle")
    yield text(left, TOP - 10, beside)
