r"""Labels on a picture without overlap: each name above its point, on a thin leader, or omitted.

Labels are placed greedily by priority. A label sits on a vertical leader and may slide sideways as long as the leader
still ends under it. It moves up line by line until it covers no label, point or leader placed before::

        Everest 8849 m
           |   Lhotse 8516 m
           |      |
         _/\_   _/\__
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

SLIDES = (0.5, 0.3, 0.7, 0.12, 0.88, 0.02, 0.98)
"""Positions along the label at which the leader may end, best first."""

BELOW_COST = 12.0
"""A label below its point covers the ground; it costs as much as this many lines of leader."""

BARRED_COST = 1.5
"""A label in the way of another point's leader costs this much per point."""


@dataclass(frozen=True)
class LabelOptions:
    """Sizes, all in pixels of the drawing.

    Attributes
    ----------
    line_px : float
        Height of a label's line.
    gap_px : float
        Free space between labels, and between a leader and its point.
    lead_px : float
        Shortest leader.
    longest_lead_px : float
        Longest leader; a label that would need a longer one is left out.
    """

    line_px: float = 16.0
    gap_px: float = 3.0
    lead_px: float = 14.0
    longest_lead_px: float = 260.0


@dataclass(frozen=True)
class PlacedLabel:
    """A label with its position.

    Attributes
    ----------
    index : int
        Index of the point to which it belongs.
    left_px, top_px, width_px, height_px : float
        Position and size of its box.
    point_x_px, point_y_px : float
        End of the leader at the point.
    """

    index: int
    left_px: float
    top_px: float
    width_px: float
    height_px: float
    point_x_px: float
    point_y_px: float

    @property
    def leader(self):
        """(x, y at the label, y at the point)."""
        below = self.top_px + self.height_px <= self.point_y_px
        return self.point_x_px, self.top_px + (self.height_px if below else 0.0), self.point_y_px


def lay_out_labels(x_px, y_px, width_px, canvas_px, options=None):
    """Find positions for labels.

    Parameters
    ----------
    x_px, y_px : (N,) arrays
        Points, most important first [pixels].
    width_px : (N,) array
        Width of each label's text [pixels].
    canvas_px : (float, float)
        Width and height of the drawing [pixels].
    options : LabelOptions or None

    Returns
    -------
    tuple of PlacedLabel
        The labels that found room, in the order of the points.
    """
    options = options or LabelOptions()
    x_px, y_px, width_px = (np.asarray(a, float) for a in (x_px, y_px, width_px))
    taken = np.zeros((0, 4))
    placed = []
    for index in range(x_px.size):
        later = np.column_stack([x_px[index + 1 :], y_px[index + 1 :]])
        room = _find_room((x_px[index], y_px[index]), width_px[index], canvas_px, taken, later, options)
        if room is None:
            continue
        placed.append(PlacedLabel(index, *room, float(x_px[index]), float(y_px[index])))
        taken = np.vstack([taken, _claims(placed[-1], options)])
    return tuple(placed)


def _find_room(point, width, canvas, taken, later, options):
    """Cheapest free box (left, top, width, height), or None."""
    x, y = point
    best, best_cost = None, np.inf
    for cost, box in _candidates(x, y, width, canvas, options):
        if cost >= best_cost:
            continue
        left, top = box[0], box[1]
        gap = 2 * options.gap_px
        crossed = (later[:, 0] > left - gap) & (later[:, 0] < left + width + gap) & (later[:, 1] > top)
        cost += BARRED_COST * np.count_nonzero(crossed)
        if cost < best_cost and not _meets(_claims(PlacedLabel(0, *box, x, y), options), taken):
            best, best_cost = tuple(float(v) for v in box), cost
    return best


def _candidates(x, y, width, canvas, options):
    """(cost, box) of all positions on the canvas: one line's height of leader costs 1."""
    height = options.line_px
    for step in np.arange(0.0, max(options.longest_lead_px - options.lead_px, 0) + 1, height / 2):
        for above in (True, False):
            lead = options.lead_px + step
            top = y - lead - height if above else y + lead
            if top < 0 or top + height > canvas[1]:
                continue
            for rank, slide in enumerate(SLIDES):
                left = x - slide * width
                if left >= 0 and left + width <= canvas[0]:
                    yield step / height + 0.1 * rank + (0 if above else BELOW_COST), (left, top, width, height)


def _claims(label, options):
    """Boxes (left, top, right, bottom) that a label keeps free: its text, its leader and its point."""
    gap = options.gap_px
    x, start, stop = label.leader
    low, high = min(start, stop), max(start, stop)
    right, bottom = label.left_px + label.width_px, label.top_px + label.height_px
    return np.array(
        [
            [label.left_px - gap, label.top_px - gap / 2, right + gap, bottom + gap / 2],
            [x - gap / 2, low, x + gap / 2, high],
        ]
    )


def _meets(boxes, taken):
    if not len(taken):
        return False
    a, b = boxes[:, None], taken[None]
    across = (a[..., 0] < b[..., 2]) & (b[..., 0] < a[..., 2])
    return bool((across & (a[..., 1] < b[..., 3]) & (b[..., 1] < a[..., 3])).any())
