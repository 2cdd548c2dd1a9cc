"""Slow, independent references for horizon and viewshed: one sight line after the other, in plain geometry.

Written from the definitions and not from the engine: a plane grid of square cells, observer anywhere, the terrain
either *crossings* (linear between the two cells beside each grid line that the sight line crosses) or *bilinear*
(sampled every tenth of a cell).
"""

from __future__ import annotations

import math

import numpy as np

DROP = 0.87 / (2 * 6_371_000.0)


def bilinear_at(z, row, col):
    """Bilinear elevation, indices held inside the grid."""
    rows, cols = z.shape
    r = min(max(int(math.floor(row)), 0), max(rows - 2, 0))
    c = min(max(int(math.floor(col)), 0), max(cols - 2, 0))
    fr, fc = min(max(row - r, 0.0), 1.0), min(max(col - c, 0.0), 1.0)
    r2, c2 = min(r + 1, rows - 1), min(c + 1, cols - 1)
    return float(
        z[r, c] * (1 - fr) * (1 - fc) + z[r, c2] * (1 - fr) * fc + z[r2, c] * fr * (1 - fc) + z[r2, c2] * fr * fc
    )


def crossings(row0, col0, row1, col1):
    """Shares of the way at which a line crosses lines of cell centres, ends excluded."""
    shares = []
    for start, stop in ((row0, row1), (col0, col1)):
        low, high = min(start, stop), max(start, stop)
        for line in range(math.ceil(low), math.floor(high) + 1):
            if start != stop:
                shares.append((line - start) / (stop - start))
    return sorted(share for share in shares if 1e-12 < share < 1 - 1e-9)


def tangent(z, eye, cell, distance, drop):
    """Tangent of the elevation angle."""
    return (z - eye - drop * distance**2) / distance


def sees(z, cell, row0, col0, eye, row, col, target=0.0, drop=DROP, model="crossings", near=1.0):
    """Whether the eye sees the centre of one cell (plus target height); exact for the model."""
    span = math.hypot(row - row0, col - col0)
    if span == 0:
        return True
    mine = tangent(float(z[row, col]) + target, eye, cell, span * cell, drop)
    if model == "crossings":
        shares = crossings(row0, col0, row, col)
    else:
        shares = list(np.arange(0.1, span - 0.05, 0.1) / span)
    for share in shares:
        r, c = row0 + (row - row0) * share, col0 + (col - col0) * share
        if max(abs(r - row0), abs(c - col0)) < near:
            continue
        if tangent(bilinear_at(z, r, c), eye, cell, share * span * cell, drop) > mine:
            return False
    return True


def viewshed_by_lines(z, cell, row0, col0, eye, target=0.0, drop=DROP, model="crossings", near=1.0, reach=math.inf):
    """Boolean viewshed of the whole grid, cell by cell."""
    seen = np.zeros(z.shape, bool)
    for row in range(z.shape[0]):
        for col in range(z.shape[1]):
            if math.hypot(row - row0, col - col0) * cell <= reach:
                seen[row, col] = sees(z, cell, row0, col0, eye, row, col, target, drop, model, near)
    return seen


def horizon_by_samples(z, cell, row0, col0, eye, azimuth_deg, start, stop, step, drop=DROP):
    """Highest elevation angle [degrees] along one azimuth over a plane grid whose rows run from north to south."""
    best = -math.inf
    sine, cosine = math.sin(math.radians(azimuth_deg)), math.cos(math.radians(azimuth_deg))
    for distance in np.arange(start, stop, step):
        row, col = row0 - cosine * distance / cell, col0 + sine * distance / cell
        if not (0 <= row <= z.shape[0] - 1 and 0 <= col <= z.shape[1] - 1):
            break
        best = max(best, tangent(bilinear_at(z, row, col), eye, cell, distance, drop))
    return math.degrees(math.atan(best)) if best > -math.inf else math.nan
