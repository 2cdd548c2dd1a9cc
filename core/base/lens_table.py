"""Choose the distortion of a photograph's lens from a table of calibrated lenses.

Distortion depends on the lens and its focal length only, and EXIF records both, as far as it records them at all. Like
the databases of Lensfun and OpenSfM, a table names them as EXIF does.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import log

from .model import PhotoMetadata

SAME_FOCAL = 0.03
"""Relative difference of two focal lengths that rounding can explain; steps of zoom lenses are wider."""


@dataclass(frozen=True)
class LensRow:
    """One calibrated lens; an empty text and None fit any photograph.

    Attributes
    ----------
    number : int
        Number of the row, from 1.
    make, model, lens : str
        Maker and model of the camera and name of the lens, as EXIF has them.
    focal_mm, focal_35mm : float or None
        Focal length, and its 35 mm equivalent [mm].
    k1, k2 : float
        Radial distortion; see `Camera`.
    """

    number: int
    make: str = ""
    model: str = ""
    lens: str = ""
    focal_mm: float | None = None
    focal_35mm: float | None = None
    k1: float = 0.0
    k2: float = 0.0

    @property
    def named(self) -> tuple[str, str, str, float | None, float | None]:
        """What the row says of the photographs that it fits."""
        return _plain(self.make), _plain(self.model), _plain(self.lens), self.focal_mm, self.focal_35mm

    @property
    def count(self) -> int:
        """Number of values that a photograph must have."""
        return sum(value not in ("", None) for value in self.named)


def fitting_rows(table: Sequence[LensRow], metadata: PhotoMetadata) -> list[LensRow]:
    """Rows that fit a photograph best: most values named, then the nearest focal length. Usually one, or none."""
    found = [(row, miss) for row in table if (miss := _miss(row, metadata)) is not None]
    if not found:
        return []
    most = max(row.count for row, _ in found)
    nearest = min(miss for row, miss in found if row.count == most)
    return [row for row, miss in found if row.count == most and miss <= nearest + 1e-9]


def _miss(row: LensRow, metadata: PhotoMetadata) -> float | None:
    """Largest relative difference of the focal lengths; None if the row does not fit."""
    make, model, lens = (_plain(text or "") for text in (metadata.make, metadata.model, metadata.lens))
    if row.make and not _same_maker(_plain(row.make), make):
        return None
    if row.model and not _names_of(make or _plain(row.make), model) & _names_of(_plain(row.make) or make, row.model):
        return None
    if row.lens and _plain(row.lens) != lens:
        return None
    miss = 0.0
    for wanted, known in ((row.focal_mm, metadata.focal_length_mm), (row.focal_35mm, metadata.focal_length_35mm)):
        if wanted is None:
            continue
        if known is None or abs(log(known / wanted)) > SAME_FOCAL:
            return None
        miss = max(miss, abs(log(known / wanted)))
    return miss


def _plain(text: str) -> str:
    return " ".join(text.casefold().split())


def _same_maker(one: str, other: str) -> bool:
    """Tell whether two makers are the same: cameras write NIKON CORPORATION where people write Nikon."""
    return bool(one and other) and one.split()[0] == other.split()[0]


def _names_of(make: str, model: str) -> set[str]:
    """Names of a model, with and without the maker, which some cameras repeat in it."""
    model = _plain(model)
    if not model:
        return set()
    first, _, rest = model.partition(" ")
    return {model, rest} - {""} if make and make.split()[0] == first else {model}
