"""Rays from an eye to the ground: which point of the terrain lies behind a direction.

Seen from the eye, a point at ground distance d and elevation z has the elevation angle
atan((z - drop(d) - eye) / d), the drop being curvature less refraction. A ray of one elevation angle is therefore
the parabola eye + d tan(elevation) + drop(d) over the map, and it meets the terrain where the bilinear surface of
the DEM first reaches it. That crossing is found exactly, patch by patch; block maxima skip the air before it::

    eye *-.__
             `--.__        ________
                   `--.__ / ridge  \\      the parabola stays above the block's bound: one step
                         X          \\__   first patch that it can touch: solve a quadratic
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .curvature import EARTH_RADIUS_M, REFRACTION_COEFFICIENT
from .progress import SILENT, checkpoint, subtask
from .sightline_pyramid import build_pyramid
from .terrain import Window

GROUND, SKY, VOID, BEYOND = 1, 0, 2, 3
"""What a ray meets: terrain; sky as far as the DEM reaches; a hole in the DEM; ground that must lie outside it."""

STATE_NAMES = {GROUND: "ground", SKY: "sky", VOID: "void", BEYOND: "beyond"}

MAX_WINDOW_CELLS = 24_000_000
"""Cells read at once: about 100 MB, and half as much again for the bounds."""

BATCH_RAYS = 200_000


@dataclass(frozen=True)
class SightOptions:
    """How far rays go.

    Attributes
    ----------
    min_distance_m : float
        Nothing nearer stops a ray [m].
    max_distance_m : float
        Nothing farther is looked at [m].
    refraction_coefficient : float
        See `core.curvature`.
    """

    min_distance_m: float = 0.0
    max_distance_m: float = 60_000.0
    refraction_coefficient: float = REFRACTION_COEFFICIENT

    def __post_init__(self):
        if not 0 <= self.min_distance_m < self.max_distance_m:
            raise ValueError(f"distances must satisfy 0 <= min < max, not {self}")


@dataclass(frozen=True, eq=False)
class GroundHits:
    """Where rays end.

    Attributes
    ----------
    state : (N,) uint8 array
        `GROUND`, `SKY`, `VOID` or `BEYOND`.
    east_m, north_m : (N,) arrays
        Local metres in the observer's frame, NaN unless `GROUND` [m].
    elevation_m : (N,) array
        Of the surface there [m].
    distance_m : (N,) array
        Along the ground from the ray's origin [m].
    """

    state: np.ndarray
    east_m: np.ndarray
    north_m: np.ndarray
    elevation_m: np.ndarray
    distance_m: np.ndarray

    @property
    def on_ground(self):
        """(N,) bool: rays that meet known terrain."""
        return self.state == GROUND


@dataclass(eq=False)
class _Rays:
    """Parabolas over the map, and how far each has come; one row per ray."""

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
        values = {name: getattr(self, name)[index] for name in self._arrays()}
        return _Rays(bend_per_m=self.bend_per_m, **values)

    @staticmethod
    def _arrays():
        return ("east_m", "north_m", "sin_azimuth", "cos_azimuth", "slope", "eye_m", "end_m", "distance_m")

    def height(self, distance_m):
        """Elevation of the parabola [m]."""
        return self.eye_m + distance_m * (self.slope + self.bend_per_m * distance_m)

    def lowest(self, start_m, stop_m):
        """Its lowest elevation between two distances [m]."""
        return self.height(np.clip(-self.slope / (2 * self.bend_per_m + 1e-300), start_m, stop_m))

    def place(self, distance_m):
        """Local (east, north) at a distance [m]."""
        return self.east_m + distance_m * self.sin_azimuth, self.north_m + distance_m * self.cos_azimuth


def cast_rays(
    terrain, frame, eye_elevation_m, azimuth_deg, elevation_deg, options=None, progress=SILENT, *,
    east_m=0.0, north_m=0.0, end_m=None,
):
    """Find where rays first meet the terrain.

    Parameters
    ----------
    terrain : Terrain
    frame : LocalFrame
        Around the observer, reaching at least as far as the rays.
    eye_elevation_m : float or (N,) array
        Of the rays' origins [m].
    azimuth_deg, elevation_deg : (N,) arrays
        True azimuth and elevation angle above the horizontal [degrees].
    options : SightOptions or None
    progress : Progress
    east_m, north_m : float or (N,) array
        Origins in local metres, 0 at the observer [m].
    end_m : (N,) array or None
        Per ray, do not look beyond this distance [m].

    Returns
    -------
    GroundHits

    Notes
    -----
    A ray that starts inside the terrain (an eye below the DEM's coarse surface, or `min_distance_m` behind a hill)
    is taken to look out of it: only a surface reached from above stops a ray.
    """
    options = options or SightOptions()
    given = (azimuth_deg, elevation_deg, eye_elevation_m, east_m, north_m, np.inf if end_m is None else end_m)
    azimuth, elevation, eye, east, north, end = (np.array(a, float) for a in np.broadcast_arrays(*given))
    shape = azimuth.shape
    rays = _Rays(
        east.ravel(), north.ravel(), np.sin(np.radians(azimuth.ravel())), np.cos(np.radians(azimuth.ravel())),
        np.tan(np.radians(elevation.ravel())), eye.ravel(), np.minimum(end.ravel(), options.max_distance_m),
        (1 - options.refraction_coefficient) / (2 * EARTH_RADIUS_M), np.full(azimuth.size, options.min_distance_m),
    )
    count = azimuth.size
    state, reach = np.full(count, SKY, np.uint8), np.full(count, np.nan)
    for start in range(0, count, BATCH_RAYS):
        part = slice(start, min(start + BATCH_RAYS, count))
        share = subtask(progress, start / count, part.stop / count)
        state[part], reach[part] = _cast_batch(terrain, frame, rays.take(part), share)
    hit = state == GROUND
    place_east, place_north = rays.place(reach)
    columns = (state, place_east, place_north, np.where(hit, rays.height(reach), np.nan), reach)
    return GroundHits(*(column.reshape(shape) for column in columns))


def _cast_batch(terrain, frame, rays, progress):
    """March rays outwards through windows of bounded size; gives (state, distance)."""
    count = rays.distance_m.size
    state, reach = np.full(count, SKY, np.uint8), np.full(count, np.nan)
    alive = np.flatnonzero((rays.end_m > rays.distance_m) & np.isfinite(rays.slope))
    above = np.zeros(count, bool)
    lowest_ground = np.inf
    while alive.size:
        done = rays.distance_m[alive].min() / rays.end_m[alive].max()
        checkpoint(progress, float(np.clip(done, 0, 1)))
        stop, window = _next_window(terrain.shape, frame, rays.take(alive))
        if window is None:
            break
        pyramid = build_pyramid(terrain.read(window))
        lowest_ground = min(lowest_ground, float(np.nanmin(pyramid.elevation_m, initial=np.inf)))
        part = rays.take(alive)
        part_above = above[alive]
        part_stop = np.minimum(part.end_m, stop)
        found, left = _march(pyramid, window, frame, part, part_above, part_stop)
        state[alive], above[alive] = found, part_above
        reach[alive] = np.where(found == GROUND, part.distance_m, np.nan)
        rays.distance_m[alive] = part.distance_m
        alive = alive[(found == SKY) & ~left & (part.distance_m < part.end_m)]
    state[(state == SKY) & _must_land(rays, lowest_ground)] = BEYOND
    return state, reach


def _must_land(rays, lowest_ground_m):
    """Rays that, still free where the DEM ended, go on to dive below the lowest ground seen."""
    vertex = np.minimum(-rays.slope / (2 * rays.bend_per_m + 1e-300), 1e9)
    return (vertex > rays.distance_m) & (rays.height(vertex) < lowest_ground_m)


def _next_window(shape, frame, rays):
    """Choose how far to go next, and the window of patches that all rays cross until there."""
    start, end = rays.distance_m.min(), rays.end_m.max()
    stop = end
    for _ in range(40):
        window = _window_between(shape, frame, rays, start, stop)
        if window is None or window.rows * window.cols <= MAX_WINDOW_CELLS:
            break
        stop = start + (stop - start) / 2
    return stop, window


def _window_between(shape, frame, rays, start, stop, nodes=9):
    start_m, stop_m = np.maximum(rays.distance_m, start), np.minimum(rays.end_m, stop)
    steps = np.linspace(0.0, 1.0, nodes)[:, None]
    distance = start_m + (np.maximum(stop_m, start_m) - start_m) * steps
    col, row = frame.to_pixel(*rays.place(distance))
    low_row, low_col = int(np.floor(row.min())) - 2, int(np.floor(col.min())) - 2
    high_row, high_col = int(np.ceil(row.max())) + 3, int(np.ceil(col.max())) + 3
    window = Window(low_row, low_col, high_row - low_row, high_col - low_col).clipped(shape)
    return window if window.rows >= 2 and window.cols >= 2 else None


def _march(pyramid, window, frame, rays, above, stop_m):
    """Move rays (in place) until they meet ground or a void, leave the window, or reach `stop_m`.

    Returns
    -------
    state : (N,) uint8
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
        row, col, per_m_row, per_m_col = _track(frame, window, now)
        inside = (row >= 0) & (col >= 0) & (row < window.rows - 1) & (col < window.cols - 1)
        lev = level[active]
        exit_m = now.distance_m + nudge_m + np.minimum(
            _to_edge(row, per_m_row, lev), _to_edge(col, per_m_col, lev)
        )
        exit_m = np.minimum(exit_m, stop_m[active])
        bound = _bound_at(pyramid, row, col, lev, inside)
        free = inside & (now.lowest(now.distance_m, exit_m) > bound)
        test = inside & ~free & (lev == 0)
        advance = free | test
        if test.any():
            _touch(pyramid, rays, active[test], row[test], col[test], per_m_row[test], per_m_col[test],
                   exit_m[test], above, state)
        entering = ~inside & _comes_in(row, col, per_m_row, per_m_col, window)
        left[active[~inside & ~entering]] = True
        above[active[free]] = True
        running = state[active] == SKY
        rays.distance_m[active] = np.where((advance | entering) & running, exit_m, rays.distance_m[active])
        level[active] = np.clip(np.where(free, lev + 1, np.where(test, 1, lev - 1)), 0, len(pyramid.bound_m) - 1)
        keep = running & (inside | entering) & (rays.distance_m[active] < stop_m[active])
        active = active[keep]
    return state, left


def _track(frame, window, rays):
    """Window coordinates of rays and their change per metre."""
    col, row = frame.to_pixel(*rays.place(rays.distance_m))
    (a, b), (c, d) = frame.jacobian_px_per_m
    if frame.remainder_px is None:
        per_col = a * rays.sin_azimuth + b * rays.cos_azimuth
        per_row = c * rays.sin_azimuth + d * rays.cos_azimuth
    else:
        step = frame.cell_m
        ahead_col, ahead_row = frame.to_pixel(*rays.place(rays.distance_m + step))
        per_col, per_row = (ahead_col - col) / step, (ahead_row - row) / step
    return row - window.row, col - window.col, per_row, per_col


def _to_edge(position, per_m, level):
    """Metres until a coordinate leaves its block of 2^level patches."""
    size = np.ldexp(1.0, level)
    low = np.floor(position / size) * size
    gap = np.where(per_m > 0, low + size - position, position - low)
    return gap / np.maximum(np.abs(per_m), 1e-12)


def _bound_at(pyramid, row, col, level, inside):
    bound = np.full(row.shape, np.inf)
    r, c = row.astype(np.intp), col.astype(np.intp)
    for k in np.unique(level[inside]):
        pick = inside & (level == k)
        bound[pick] = pyramid.bound_m[k][r[pick] >> k, c[pick] >> k]
    return bound


def _comes_in(row, col, per_m_row, per_m_col, window):
    """Rays outside the window that are on their way into it."""
    toward_row = np.where(row < 0, per_m_row > 0, (row < window.rows - 1) | (per_m_row < 0))
    toward_col = np.where(col < 0, per_m_col > 0, (col < window.cols - 1) | (per_m_col < 0))
    return toward_row & toward_col


def _touch(pyramid, rays, index, row, col, per_m_row, per_m_col, exit_m, above, state):
    """Look for the first crossing from above within one patch each, and note what is found.

    Along a straight track the bilinear surface is a quadratic in distance, and so is the parabola: three samples
    give their difference exactly.
    """
    now = rays.take(index)
    r, c = row.astype(np.intp), col.astype(np.intp)
    z00, z01, z10, z11 = pyramid.corners(r, c)
    start, span = now.distance_m, exit_m - now.distance_m
    gap = []
    for t in (0.0, 0.5, 1.0):
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
    """First t in [0, 1] where the quadratic through g(0), g(1/2), g(1) comes up to 0; NaN where it does not.

    A ray known to be above (g0 may exceed 0 by a rounding, after the last patch's edge) hits at once.
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
