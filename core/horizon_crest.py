"""The crest of the surface between two grid lines: where a bilinear cell bulges above the lines that bound it."""

from __future__ import annotations

import numpy as np

HAIR = 1e-9
"""A sample this near to a grid line lies on it [cells]."""


def crest(pieces, sight, ends, start, end, top, where):
    """Find the highest tangent between the two grid lines around each interval's best sample.

    Along a ray the bilinear surface of one cell is a parabola. Three samples give it, and the point at which a line
    from the eye touches it follows in closed form.

    Parameters
    ----------
    pieces : Pieces
    sight : Sight
    ends : tuple of four (J,) arrays
        Column and row of the intervals' starts, column and row of their ends [pixels].
    start, end : (J,) arrays
        Distances of both [m].
    top, where : (J,) arrays
        Highest tangent so far, and at which share of the interval; NaN where there is none: the interval crosses no
        line.

    Returns
    -------
    top, where : (J,) arrays
    """
    nodes = _lines_around(ends, where)
    share = np.empty((len(top), 2 * nodes.shape[1] - 1))
    share[:, ::2], share[:, 1::2] = nodes, (nodes[:, 1:] + nodes[:, :-1]) / 2
    col0, row0, col1, row1 = (place[:, None] for place in ends)
    distance = start[:, None] + (end - start)[:, None] * share
    height = pieces.elevation_m(row0 + (row1 - row0) * share, col0 + (col1 - col0) * share) - sight.eye_m
    three = slice(0, -2, 2), slice(1, None, 2), slice(2, None, 2)
    along, between = _touch(*(values[:, part] for values in (height, distance) for part in three), sight.drop_per_m2)
    share = np.concatenate([share, nodes[:, :-1] + np.diff(nodes) * along], axis=1)
    tangent = np.concatenate([height / distance - sight.drop_per_m2 * distance, between], axis=1)
    tangent[np.isnan(tangent)] = -np.inf
    pick = np.arange(len(top)), tangent.argmax(axis=1)
    better = tangent[pick] > top
    return np.where(better, tangent[pick], top), np.where(better, share[pick], where)


def _lines_around(ends, where):
    """Shares of each interval at which grid lines are crossed around one share: (J, 5), itself in the middle."""
    middle = np.where(np.isnan(where), 0.5, where)
    lines = [middle]
    for way in (1, -1):
        nearest, next_one = np.full(len(middle), np.inf), np.full(len(middle), np.inf)
        for first, last in zip(ends[:2], ends[2:]):
            step = (last - first) * way
            place = first + (last - first) * middle
            with np.errstate(divide="ignore"):
                line = np.where(step > 0, np.floor(place + HAIR) + 1 - place, place - np.ceil(place - HAIR) + 1)
                line, again = line / np.abs(step), 1 / np.abs(step)
            next_one = np.minimum(np.maximum(nearest, line), np.minimum(next_one, line + again))
            nearest = np.minimum(nearest, line)
        lines.append(middle + way * nearest)
        lines.append(middle + way * next_one)
    first, ahead, far_ahead, behind, far_behind = lines
    return np.clip(np.stack([far_behind, behind, first, ahead, far_ahead], axis=1), 0.0, 1.0)


def _touch(first, middle, last, near, _, far, drop_per_m2):
    """Where the line of sight over a parabola touches it.

    Parameters
    ----------
    first, middle, last : array
        Heights above the eye at the start, the middle and the end of a stretch [m].
    near, far : array
        Distances of its start and its end [m].
    drop_per_m2 : float

    Returns
    -------
    along, tangent : array
        Share of the stretch, and tangent of the elevation angle there; NaN where no line touches it from above.
    """
    reach = far - near
    slope, bend = 4 * middle - 3 * first - last, 2 * (first + last - 2 * middle)
    # (first + slope u + bend u^2) / d - drop d with d = near + reach u has its extremes where, written in d, the same
    # fraction's numerator of the derivative is zero: (bend - drop reach^2) (reach u^2 + 2 near u) + rest = 0.
    bent = bend - drop_per_m2 * reach**2
    rest = slope * near - reach * first - drop_per_m2 * reach * near**2
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = -rest / np.where(bent < 0, bent, np.nan)  # bent upwards, the highest point is one of the ends
        along = ratio / (np.sqrt(near**2 + reach * ratio) + near)
        along = np.where((along > 0) & (along < 1), along, np.nan)
        at = near + reach * along
        return along, (first + (slope + bend * along) * along) / at - drop_per_m2 * at
