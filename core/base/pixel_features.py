"""Points, lines and areas drawn on photographs, in pixels."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

CIRCLE_CORNERS = 32
KINDS = ("point", "line", "polygon")


@dataclass(frozen=True, eq=False)
class PixelFeature:
    """A point, line or area drawn on a photograph.

    Attributes
    ----------
    photo : str
        File name or path of the photograph as given in the source; '' if none is given.
    kind : str
        'point', 'line' or 'polygon'.
    parts : tuple of (N, 2) arrays
        x and y of the vertices [pixels of the upright picture, the centre of the first pixel at 0, y down]. A point
        has one part with one or more vertices; rings of a polygon are not closed; inner rings follow the outer one.
    label : str
        Class or name of the feature.
    attributes : dict
        Further values from the source, as plain text and numbers.
    size_px : (width, height) or None
        Size of the picture on which it was drawn, if the source states it; `upright.on_upright` compares it [pixels].
    as_stored : bool
        Drawn over the picture as GDAL and QGIS show it, without the rotation that EXIF prescribes.
    file_bytes : int or None
        Size of that picture's file, if the source states only this.
    """

    photo: str
    kind: str
    parts: tuple[np.ndarray, ...]
    label: str = ""
    attributes: dict[str, Any] = field(default_factory=dict)
    size_px: tuple[float, float] | None = None
    as_stored: bool = False
    file_bytes: int | None = None

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise ValueError(f"kind must be one of {KINDS}, not {self.kind!r}")


def counts_upwards(parts: Sequence[np.ndarray]) -> bool:
    """Tell whether y points up, as QGIS has it on a picture without georeference.

    There the upper left corner is (0, 0) and the picture lies at negative y.
    """
    y = np.concatenate([part[:, 1] for part in parts]) if parts else np.zeros(0)
    return bool(y.size and y.min() < -1.0 and y.max() <= 0.5)


def downward(parts: Sequence[np.ndarray]) -> tuple[np.ndarray, ...]:
    """Make y point down if it `counts_upwards`."""
    if counts_upwards(parts):
        return tuple(np.column_stack([part[:, 0] - 0.5, -part[:, 1] - 0.5]) for part in parts)
    return tuple(parts)


def open_ring(points: ArrayLike) -> np.ndarray:
    """Drop the last vertex of a ring if it repeats the first."""
    points = np.asarray(points, float).reshape(-1, 2)
    return points[:-1] if len(points) > 1 and np.array_equal(points[0], points[-1]) else points


def ellipse(centre: ArrayLike, radius_x: float, radius_y: float | None = None, turn_rad: float = 0.0) -> np.ndarray:
    """Give the vertices of an ellipse with `CIRCLE_CORNERS` corners, clockwise from the top.

    Parameters
    ----------
    centre : (2,) array
        x and y [pixels].
    radius_x, radius_y : float
        Half axes along x and y [pixels]; a circle without `radius_y`.
    turn_rad : float
        Rotation of the axes, clockwise in the picture [radians].

    Returns
    -------
    (CIRCLE_CORNERS, 2) array
        x and y [pixels].
    """
    turn = 2 * np.pi * np.arange(CIRCLE_CORNERS) / CIRCLE_CORNERS
    across, down = radius_x * np.sin(turn), -(radius_x if radius_y is None else radius_y) * np.cos(turn)
    cos, sin = np.cos(turn_rad), np.sin(turn_rad)
    return np.asarray(centre, float) + np.column_stack([across * cos - down * sin, across * sin + down * cos])
