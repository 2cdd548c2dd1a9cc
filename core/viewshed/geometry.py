r"""One quarter of the view as the sweep processes it: lines of cells, outwards from the observer, crossed by rays.

In each quarter the lines are whole rows (or columns) of the raster. A cell has two coordinates, `k` lines away and
`j` cells along its line, both counted from the observer::

        ray of constant u                 w = j / k   where the cell is on its line
          \\      | k                      u           the ray (a geodesic) that meets the cell
           \\_____|____ line k             d           true ground distance
            \\ j  |
             \\   |                        plane frames:   u = w,  d = k |inverse Jacobian (w, 1)|
              observer

In every other CRS a geodesic bends slightly against the grid and the scale drifts. Both are smooth, so they are
tabulated from the `LocalFrame` on a coarse grid: `u = w + bend(w, k)` and `d = k rho(w) (1 + stretch(w, k))`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.errors import UnusableDemError
from ..base.messages import Message
from .table import Table

FOLDED = Message(
    "The DEM's coordinate system distorts sight lines too strongly here. Use a DEM in a projected "
    "coordinate system, such as UTM."
)
NODES = 65
"""Nodes of the tables per side."""

ENOUGH_M = 1e-7
"""After steps of this length, which become a hundred times shorter each time, a place is exact to all digits [m]."""

NEGLIGIBLE_PX, NEGLIGIBLE_STRETCH = 0.05, 1e-5
"""Rays that bend by less than this at the far end, over a grid whose scale drifts by less, count as straight."""


@dataclass(frozen=True, eq=False)
class Quarter:
    """The geometry of one quarter of the view.

    Attributes
    ----------
    by_rows : bool
        The lines are rows of the raster (north and south quarters of a usual raster), else columns.
    sign : int
        +1 if the lines' row (column) numbers grow with the distance, else -1.
    origin_line, origin_along : float
        Position of the observer across and along the lines [pixels of the whole raster].
    to_metres : (2, 2) array
        (j, k) -> (east, north) near the observer [m/pixel].
    bend, stretch : Table
        Tables over (k, w) of cells; see the module.
    ray_bend, ray_stretch : Table
        The same tables as seen from the ray: w = u + ray_bend(u, k), d = k rho(u) (1 + ray_stretch(u, k)).
    side_m : (along, line) floats
        Ground size of the observer's cell [m].
    w_limit : float
        The quarter's cells have |w| up to this; the quarters meet at 45 degrees on the ground, not on the grid.
    u_min, u_max : float
        Range of rays that cover all cells with |w| <= w_limit.
    """

    by_rows: bool
    sign: int
    origin_line: float
    origin_along: float
    to_metres: np.ndarray
    bend: Table
    stretch: Table
    ray_bend: Table
    ray_stretch: Table
    side_m: tuple
    w_limit: float
    u_min: float
    u_max: float

    @property
    def plane(self):
        """Return whether rays are straight and the scale is constant."""
        return self.bend.values is None

    def rho_m(self, w):
        """Ground distance per line along the direction w at the observer [m]."""
        (a, b), (c, d) = self.to_metres
        return np.hypot(a * w + b, c * w + d)

    def azimuth_deg(self, u):
        """True azimuth of rays in (-180, 180] [degrees]."""
        (a, b), (c, d) = self.to_metres
        return np.degrees(np.arctan2(a * u + b, c * u + d))

    def owns(self, j, k):
        """Return whether cells belong to this quarter; every cell except the observer's own belongs to exactly one."""
        across, away = np.abs(j) * self.side_m[0], k * self.side_m[1]
        return across <= away if self.by_rows else across < away

    def to_pixel(self, j, k):
        """(col, row) of the whole raster."""
        line, along = self.origin_line + self.sign * k, self.origin_along + j
        return (along, line) if self.by_rows else (line, along)


def quarters(frame, k_max, touches=None):
    """Set up the four quarters around a frame's observer, still without tables.

    Parameters
    ----------
    frame : LocalFrame
    k_max : dict
        Farthest line of each quarter, keyed by (by_rows, sign) [lines]; quarters with less than one are left out.
    touches : callable or None
        The sector's `touches`: quarters in which it touches no azimuth are left out.

    Returns
    -------
    list of Quarter
    """
    plane = [_plane(frame, by_rows, sign, far) for (by_rows, sign), far in k_max.items() if far > 0]
    if touches is not None:  # a quarter's rays bend by less than half its width
        rays = np.linspace(-1.5, 1.5, 181)
        plane = [quarter for quarter in plane if touches(quarter.azimuth_deg(rays * quarter.w_limit), 2.0).any()]
    return plane


def _plane(frame, by_rows, sign, k_max):
    east_north = np.linalg.inv(frame.jacobian_px_per_m)  # columns: per col, per row
    along, line = (0, 1) if by_rows else (1, 0)
    to_metres = np.column_stack([east_north[:, along], sign * east_north[:, line]])
    origin = (frame.col_px, frame.row_px)
    none = Table(None, k_max, -1.0, 1.0)
    side = frame.cell_size_m[along], frame.cell_size_m[line]
    limit = side[1] / side[0]
    return Quarter(
        by_rows, sign, origin[line], origin[along], to_metres, none, none, none, none, side, limit, -limit, limit
    )


def tabulated(frame, plane, k_max):
    """Fill a quarter's tables from the frame, unless its sight lines are straight within the range.

    Parameters
    ----------
    frame : LocalFrame
    plane : Quarter
        One of `quarters`.
    k_max : float
        Its farthest line.

    Returns
    -------
    Quarter

    Raises
    ------
    UnusableDemError
        The CRS bends sight lines too much within range (a raster in longitude and latitude at a pole).
    """
    if frame.remainder_px is None:
        return plane
    reach = 1.0
    for _ in range(3):
        w, bend, stretch = _cell_tables(frame, plane, k_max, reach)
        core = np.abs(w) <= plane.w_limit * (1.0 + 1e-9)
        most = float(np.abs(bend[:, core]).max()) / plane.w_limit
        if not most < 0.5:
            raise UnusableDemError(
                Message(
                    "The DEM's coordinate system bends sight lines too strongly here (close to a pole of its grid). "
                    "Use a DEM in a projected coordinate system, such as UTM or polar stereographic."
                )
            )
        if reach >= 1.0 + 2 * most:
            break
        reach = 1.0 + 3 * most + 0.02
    if k_max * most * plane.w_limit < NEGLIGIBLE_PX and np.abs(stretch[:, core]).max() < NEGLIGIBLE_STRETCH:
        return plane
    u = w + bend
    ends = np.array([np.interp([-plane.w_limit, plane.w_limit], w, line) for line in u])  # nodes may lie inside these
    u_min, u_max = float(ends[:, 0].min()) - 1e-6, float(ends[:, 1].max()) + 1e-6
    rays = np.linspace(u_min, u_max, NODES)
    if not (np.diff(u, axis=1) > 0).all():
        raise UnusableDemError(FOLDED)
    ray_w = np.array([np.interp(rays, u_line, w) for u_line in u])
    ray_d = np.array([np.interp(at, w, line) for at, line in zip(ray_w, plane.rho_m(w) * (1 + stretch))])
    frame_of = (k_max, float(w[0]), float(w[-1]))
    ray_of = (k_max, u_min, u_max)
    return Quarter(
        plane.by_rows, plane.sign, plane.origin_line, plane.origin_along, plane.to_metres,
        Table(bend.astype(np.float32), *frame_of),
        Table(stretch.astype(np.float32), *frame_of),
        Table((ray_w - rays).astype(np.float32), *ray_of),
        Table((ray_d / plane.rho_m(rays) - 1).astype(np.float32), *ray_of),
        plane.side_m, plane.w_limit, u_min, u_max,
    )  # fmt: skip


def _cell_tables(frame, plane, k_max, reach):
    """Tabulate w nodes, bend (K, W) and stretch (K, W) of cells up to |w| = reach * w_limit."""
    w = np.linspace(-reach, reach, 2 * NODES - 1) * plane.w_limit
    k = np.linspace(0.0, k_max, NODES)[:, None]
    k = np.maximum(k, 1e-3)
    col, row = plane.to_pixel(w * k, k)
    east, north = frame.to_local(col, row, 8, ENOUGH_M)
    j_line, k_line = np.tensordot(np.linalg.inv(plane.to_metres), np.array([east, north]), axes=1)
    if not (k_line > 0).all():
        raise UnusableDemError(FOLDED)
    bend = j_line / k_line - w
    stretch = np.hypot(east, north) / (k * plane.rho_m(w)) - 1
    bend[0], stretch[0] = 0.0, 0.0
    return w, bend, stretch
