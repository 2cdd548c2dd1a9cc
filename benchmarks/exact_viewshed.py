"""Compute two exact references for viewshed and horizon, vectorised but independent of the engine's method.

*crossings* (R3) tests the sight line to each target at every line of cell centres that it crosses, with linear
interpolation between the two cells beside the crossing. *bilinear* (BIL) samples the bilinear surface every tenth of a
cell. The grid is plane, its cells are square, and the observer may stand on a cell's centre or between centres.
"""

from __future__ import annotations

import numpy as np


def bilinear(z, row, col):
    """Interpolate the elevation bilinearly at positions inside the grid of cell centres."""
    r, c = np.minimum(row.astype(np.int64), z.shape[0] - 2), np.minimum(col.astype(np.int64), z.shape[1] - 2)
    fr, fc = row - r, col - c
    width, flat = z.shape[1], z.reshape(-1)
    at = r * width + c
    upper = flat[at] * (1 - fc) + flat[at + 1] * fc
    lower = flat[at + width] * (1 - fc) + flat[at + width + 1] * fc
    return upper * (1 - fr) + lower * fr


def sees(z, cell_m, eye_rc, eye_m, targets_rc, drop_per_m2, model="crossings", near=1.0, batch=2_000_000):
    """Whether each target cell (N, 2) is visible from the eye."""
    z = z.astype(np.float64, copy=False)
    seen = np.zeros(len(targets_rc), bool)
    delta = targets_rc - np.asarray(eye_rc)
    span = np.hypot(delta[:, 0], delta[:, 1])
    order = np.argsort(span)
    first = 0
    while first < len(order):
        per_target = int(span[order[min(first + 999, len(order) - 1)]] * (12 if model == "bilinear" else 2.2)) + 4
        part = order[first : first + max(1, batch // per_target)]
        first += len(part)
        seen[part] = _sees(z, cell_m, eye_rc, eye_m, delta[part], span[part], drop_per_m2, model, near)
    return seen


def _sees(z, cell_m, eye_rc, eye_m, delta, span, drop, model, near):
    shares = _crossings(eye_rc, delta) if model == "crossings" else _tenths(span)
    row, col = eye_rc[0] + delta[:, :1] * shares, eye_rc[1] + delta[:, 1:] * shares
    distance = shares * span[:, None] * cell_m
    counts = (shares > 1e-12) & (shares < 1 - 1e-9)
    counts &= np.maximum(np.abs(delta[:, :1]), np.abs(delta[:, 1:])) * shares >= near
    with np.errstate(divide="ignore", invalid="ignore"):
        tangent = (bilinear(z, row, col) - eye_m) / distance - drop * distance
        target = eye_rc + delta
        rows, cols = np.rint(target[:, 0]).astype(int), np.rint(target[:, 1]).astype(int)
        mine = (z[rows, cols] - eye_m) / (span * cell_m) - drop * span * cell_m
    highest = np.where(counts, tangent, -np.inf).max(axis=1)
    return (mine >= highest) | (span == 0)


def _crossings(eye_rc, delta):
    """Fractions (N, K) of the way at which grid lines are crossed; those outside (0, 1) are ignored."""
    parts = []
    for axis in (0, 1):
        start, step = eye_rc[axis], delta[:, axis : axis + 1]
        count = int(np.abs(step).max()) + 2
        line = np.where(step > 0, np.floor(start) + 1 + np.arange(count), np.ceil(start) - 1 - np.arange(count))
        with np.errstate(divide="ignore", invalid="ignore"):
            share = (line - start) / step
        parts.append(np.where(np.isfinite(share) & (share > 0) & (share < 1), share, 0.0))
    return np.concatenate(parts, axis=1)


def _tenths(span):
    step = 0.1 / np.maximum(span, 1e-9)[:, None]
    shares = step * np.arange(1, int(span.max() * 10) + 2)
    return np.where(shares < 1 - step / 2, shares, 0.0)


def horizon(z, cell_m, eye_rc, eye_m, azimuth_deg, start_m, stop_m, drop_per_m2, step_cells=0.1):
    """Highest elevation angle [degrees] per azimuth of the bilinear surface, sampled densely."""
    z = z.astype(np.float64, copy=False)
    distance = np.arange(start_m, stop_m, step_cells * cell_m)
    best = np.full(len(azimuth_deg), -np.inf)
    for ray, azimuth in enumerate(np.radians(azimuth_deg)):
        row = eye_rc[0] - np.cos(azimuth) * distance / cell_m
        col = eye_rc[1] + np.sin(azimuth) * distance / cell_m
        inside = (row >= 0) & (row <= z.shape[0] - 1) & (col >= 0) & (col <= z.shape[1] - 1)
        d = distance[inside]
        if len(d):
            best[ray] = ((bilinear(z, row[inside], col[inside]) - eye_m) / d - drop_per_m2 * d).max()
    return np.degrees(np.arctan(best))


def iou(a, b):
    """Intersection over union of two masks."""
    union = (a | b).sum()
    return float((a & b).sum() / union) if union else 1.0
