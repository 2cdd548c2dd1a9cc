"""Marching of rays over one window of the DEM: in long steps through the air, patch by patch near the ground."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import ndimage

GROUND, SKY, VOID, BEYOND = 1, 0, 2, 3
"""What a ray reaches: terrain; sky as far as the DEM extends; a hole in the DEM; ground that must lie outside it."""


@dataclass(eq=False)
class MarchingRays:
    """Parabolas over the map, and how far each ray has advanced; one row per ray.

    Attributes
    ----------
    east_m, north_m : (N,) arrays
        Origins in local metres [m].
    sin_azimuth, cos_azimuth : (N,) arrays
    slope : (N,) array
        Tangent of the elevation angle.
    eye_m, end_m : (N,) arrays
        Elevation of the origin, and the distance at which the ray ends [m].
    bend_per_m : float
        Height gained over a straight line per squared metre, as the earth curves away below.
    distance_m : (N,) array
        How far each ray has advanced [m].
    """

    east_m: np.ndarray
    north_m: np.ndarray
    sin_azimuth: np.ndarray
    cos_azimuth: np.ndarray
    slope: np.ndarray
    eye_m: np.ndarray
    end_m: np.ndarray
    bend_per_m: float
    distance_m: np.ndarray

    def take(self, index):
        """Return some of the rays, as copies."""
        values = {name: getattr(self, name)[index] for name in self._arrays()}
        return MarchingRays(bend_per_m=self.bend_per_m, **values)

    @staticmethod
    def _arrays():
        return ("east_m", "north_m", "sin_azimuth", "cos_azimuth", "slope", "eye_m", "end_m", "distance_m")

    def height(self, distance_m):
        """Elevation of the parabola [m]."""
        return self.eye_m + distance_m * (self.slope + self.bend_per_m * distance_m)

    def lowest(self, start_m, stop_m):
        """Lowest elevation of the parabola between two distances [m]."""
        return self.height(np.clip(-self.slope / (2 * self.bend_per_m + 1e-300), start_m, stop_m))

    def place(self, distance_m):
        """Local (east, north) at a distance [m]."""
        return self.east_m + distance_m * self.sin_azimuth, self.north_m + distance_m * self.cos_azimuth


@dataclass(frozen=True, eq=False)
class _Track:
    """Positions of rays in a window [pixels], and their change along the rays [pixels per metre]: (N,) arrays."""

    row: np.ndarray
    col: np.ndarray
    per_m_row: np.ndarray
    per_m_col: np.ndarray

    def take(self, index):
        return _Track(self.row[index], self.col[index], self.per_m_row[index], self.per_m_col[index])


def march(pyramid, window, frame, rays, above, stop_m):
    """Move rays (in place) until they reach ground or a void, leave the window, or reach `stop_m`.

    Parameters
    ----------
    pyramid : SurfacePyramid
    window : Window
        Part of the raster that the pyramid covers.
    frame : LocalFrame
    rays : MarchingRays
    above : (N,) bool array
        Rays known to have been above the surface; changed in place.
    stop_m : (N,) array
        Distance at which each ray stops [m].

    Returns
    -------
    state : (N,) uint8
        `GROUND`, `SKY` or `VOID`.
    left : (N,) bool
        Rays that left the window before `stop_m`.
    """
    count = rays.distance_m.size
    state, left = np.full(count, SKY, np.uint8), np.zeros(count, bool)
    rays.distance_m[:] = np.where(rays.distance_m < stop_m, rays.distance_m, stop_m)
    active = np.flatnonzero(rays.distance_m < stop_m)
    level = np.full(count, min(3, len(pyramid.bound_m) - 1))
    nudge_m = 1e-3 * frame.cell_m
    while active.size:
        now = rays.take(active)
        track = _track(frame, window, now)
        row, col = track.row, track.col
        inside = (row >= 0) & (col >= 0) & (row < window.rows - 1) & (col < window.cols - 1)
        lev = level[active]
        exit_m = (
            now.distance_m
            + nudge_m
            + np.minimum(_to_edge(row, track.per_m_row, lev), _to_edge(col, track.per_m_col, lev))
        )
        exit_m = np.minimum(exit_m, stop_m[active])
        bound = _bound_at(pyramid, row, col, lev, inside)
        free = inside & (now.lowest(now.distance_m, exit_m) > bound)
        test = inside & ~free & (lev == 0)
        advance = free | test
        if test.any():
            _touch(pyramid, rays, active[test], track.take(test), exit_m[test], (above, state))
        entering = ~inside & _comes_in(track, window)
        left[active[~inside & ~entering]] = True
        above[active[free]] = True
        running = state[active] == SKY
        rays.distance_m[active] = np.where((advance | entering) & running, exit_m, rays.distance_m[active])
        level[active] = np.clip(np.where(free, lev + 1, np.where(test, 1, lev - 1)), 0, len(pyramid.bound_m) - 1)
        keep = running & (inside | entering) & (rays.distance_m[active] < stop_m[active])
        active = active[keep]
    return state, left


def _track(frame, window, rays):
    """Compute the `_Track` of rays."""
    col, row = frame.to_pixel(*rays.place(rays.distance_m))
    (a, b), (c, d) = frame.jacobian_px_per_m
    if frame.remainder_px is None:
        per_col = a * rays.sin_azimuth + b * rays.cos_azimuth
        per_row = c * rays.sin_azimuth + d * rays.cos_azimuth
    else:
        step = frame.cell_m
        ahead_col, ahead_row = frame.to_pixel(*rays.place(rays.distance_m + step))
        per_col, per_row = (ahead_col - col) / step, (ahead_row - row) / step
    return _Track(row - window.row, col - window.col, per_row, per_col)


def _to_edge(position, per_m, level):
    """Distance until a coordinate leaves its block of 2^level patches [m]."""
    size = np.ldexp(1.0, level)
    low = np.floor(position / size) * size
    gap = np.where(per_m > 0, low + size - position, position - low)
    # A track along an edge stays on it: rounding must not make it leave the block at every step.
    return np.where(np.abs(per_m) > 1e-9, gap / np.maximum(np.abs(per_m), 1e-9), np.inf)


def _bound_at(pyramid, row, col, level, inside):
    bound = np.full(row.shape, np.inf)
    r, c = row.astype(np.intp), col.astype(np.intp)
    for k in np.unique(level[inside]):
        pick = inside & (level == k)
        bound[pick] = pyramid.bound_m[k][r[pick] >> k, c[pick] >> k]
    return bound


def _comes_in(track, window):
    """Rays outside the window that are about to enter it."""
    row, col = track.row, track.col
    toward_row = np.where(row < 0, track.per_m_row > 0, (row < window.rows - 1) | (track.per_m_row < 0))
    toward_col = np.where(col < 0, track.per_m_col > 0, (col < window.cols - 1) | (track.per_m_col < 0))
    return toward_row & toward_col


def _touch(pyramid, rays, index, track, exit_m, marks):
    """Find the first crossing from above within one patch per ray, and record it in `marks` (above, state).

    Along a straight track the bilinear surface is quadratic in distance, and so is the parabola, so three samples give
    their difference exactly.
    """
    above, state = marks
    row, col, per_m_row, per_m_col = track.row, track.col, track.per_m_row, track.per_m_col
    now = rays.take(index)
    r, c = row.astype(np.intp), col.astype(np.intp)
    z00, z01, z10, z11 = pyramid.corners(r, c)
    start, span = now.distance_m, exit_m - now.distance_m
    gap = []
    for t in (0.0, 0.5, 1.0):  # written out: all three share the corners, which `bilinear` would fetch again
        fr, fc = row - r + t * span * per_m_row, col - c + t * span * per_m_col
        surface = z00 * (1 - fr) * (1 - fc) + z01 * (1 - fr) * fc + z10 * fr * (1 - fc) + z11 * fr * fc
        gap.append(surface - now.height(start + t * span))
    unknown = ~np.isfinite(gap[0] + gap[1] + gap[2])
    begins_above = above[index] | (gap[0] < 0)
    t = _first_rise(*gap, begins_above)
    hit = np.isfinite(t) & ~unknown
    state[index[hit]] = GROUND
    state[index[unknown]] = VOID
    rays.distance_m[index[hit]] = (start + t * span)[hit]
    above[index] = np.where(unknown, above[index], begins_above | (np.minimum(gap[1], gap[2]) < 0))


def _first_rise(g0, g1, g2, begins_above):
    """Find the first t in [0, 1] where the quadratic through g(0), g(1/2), g(1) rises to 0; NaN if it does not.

    A ray known to be above (g0 may exceed 0 by rounding after the last patch's edge) hits at once.
    """
    a, b = 2 * (g0 - 2 * g1 + g2), -3 * g0 + 4 * g1 - g2
    with np.errstate(invalid="ignore", divide="ignore"):
        root = np.sqrt(np.where(b * b - 4 * a * g0 >= 0, b * b - 4 * a * g0, np.nan))
        q = -0.5 * (b + np.where(b >= 0, root, -root))
        roots = np.stack([np.where(q != 0, g0 / q, np.nan), np.where(a != 0, q / a, np.nan)])
        rising = (2 * a * roots + b >= 0) & (roots >= 0) & (roots <= 1)
    first = np.where(rising, roots, np.inf).min(axis=0)
    first = np.where(begins_above & (g0 >= 0), 0.0, first)
    return np.where(np.isfinite(first), first, np.nan)


MAX_LEVEL = 10
"""Blocks of 2^10 patches are the largest level worth keeping."""


@dataclass(frozen=True, eq=False)
class SurfacePyramid:
    """A window's elevations and its block maxima.

    Attributes
    ----------
    elevation_m : (R, C) float32 array
        Elevations [m], NaN in voids.
    bound_m : tuple of arrays
        Level k holds the highest possible elevation of each block of 2^k x 2^k patches [m]. A void counts as
        `void_bound_m` at its position, so that a ray may pass high above it.
    void_patch : (R - 1, C - 1) bool array or None
        Patches with an unknown corner; None if there is none.
    """

    elevation_m: np.ndarray
    bound_m: tuple
    void_patch: np.ndarray | None = None

    def corners(self, row, col):
        """Elevations at (r, c), (r, c + 1), (r + 1, c), (r + 1, c + 1) of patches [m], as float64."""
        z = self.elevation_m
        width = z.shape[1]
        flat, first = z.reshape(-1), row * width + col
        return tuple(flat[first + step].astype(float) for step in (0, 1, width, width + 1))


def build_pyramid(elevation_m):
    """Build a `SurfacePyramid` of a window with at least 2 x 2 cells.

    Voids get the elevation of the highest known cell on their rim: ground in a void is assumed to be no higher.
    """
    elevation_m = np.ascontiguousarray(elevation_m, dtype=np.float32)
    unknown = ~np.isfinite(elevation_m)
    void_patch = None
    filled = elevation_m
    if unknown.any():
        filled = np.where(unknown, _rim_height(elevation_m, unknown), elevation_m)
        void_patch = _any_of_corners(unknown)
    patch = np.maximum(filled[:-1], filled[1:])
    bound = [np.maximum(patch[:, :-1], patch[:, 1:])]
    while max(bound[-1].shape) > 1 and len(bound) <= MAX_LEVEL:
        bound.append(_halve(bound[-1]))
    return SurfacePyramid(elevation_m, tuple(bound), void_patch)


def _any_of_corners(mask):
    pair = mask[:-1] | mask[1:]
    return pair[:, :-1] | pair[:, 1:]


def _halve(bound):
    rows, cols = bound.shape
    if rows % 2 or cols % 2:
        bound = np.pad(bound, ((0, rows % 2), (0, cols % 2)), constant_values=-np.inf)
    pair = np.maximum(bound[::2], bound[1::2])
    return np.maximum(pair[:, ::2], pair[:, 1::2])


def _rim_height(elevation_m, unknown):
    """Highest known elevation beside each void, spread over the void's cells; -inf if nothing is known."""
    label, count = ndimage.label(unknown, structure=np.ones((3, 3)))
    around = ndimage.maximum_filter(np.where(unknown, -np.inf, elevation_m), size=3, mode="nearest")
    highest = ndimage.maximum(around, label, index=np.arange(count + 1))
    return np.asarray(highest, dtype=np.float32)[label]
