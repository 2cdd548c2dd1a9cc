"""Points, lines and areas drawn on photographs, in pixels."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

KINDS = ("point", "line", "polygon")


@dataclass(frozen=True, eq=False)
class PixelFeature:
    """Something drawn on a photograph.

    Attributes
    ----------
    photo : str
        File name or path of the photograph as its source gives it; '' where it does not.
    kind : str
        'point', 'line' or 'polygon'.
    parts : tuple of (N, 2) arrays
        x and y of the vertices [pixels of the upright picture, the first one's centre at 0, y down]. A point has
        one part with one or more places; rings of a polygon are not closed; inner rings follow the outer one.
    label : str
        Class or name given to it.
    attributes : dict
        Further values of its source, plain text and numbers.
    """

    photo: str
    kind: str
    parts: tuple[np.ndarray, ...]
    label: str = ""
    attributes: dict[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise ValueError(f"kind must be one of {KINDS}, not {self.kind!r}")


def photo_key(photo: object) -> str:
    """What photographs are matched by: the file's name in lower case, without folders."""
    return str(photo).replace("\\", "/").rsplit("/", 1)[-1].lower()


def for_photo(features: Iterable[PixelFeature], path: object) -> list[PixelFeature]:
    """Features that belong to a photo: by its file's name, with or without the extension; '' belongs to any."""
    key = photo_key(path)
    stem = key.rsplit(".", 1)[0]
    return [
        f for f in features if photo_key(f.photo) in (key, stem, "") or photo_key(f.photo).rsplit(".", 1)[0] == stem
    ]


def downward(parts: Sequence[np.ndarray]) -> tuple[np.ndarray, ...]:
    """Turn y downwards where it was counted upwards from the top, as QGIS does on a picture without georeference.

    There the upper left corner is (0, 0) and the picture lies at negative y.
    """
    y = np.concatenate([part[:, 1] for part in parts]) if parts else np.zeros(0)
    if y.size and y.min() < -1.0 and y.max() <= 0.5:
        return tuple(np.column_stack([part[:, 0] - 0.5, -part[:, 1] - 0.5]) for part in parts)
    return tuple(parts)


def open_ring(points: ArrayLike) -> np.ndarray:
    """Drop the last vertex of a ring where it repeats the first."""
    points = np.asarray(points, float).reshape(-1, 2)
    return points[:-1] if len(points) > 1 and np.array_equal(points[0], points[-1]) else points
