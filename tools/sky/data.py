"""Pictures with sky labels, read once and reduced; which of them are held out.

Labels: 255 ground (all that is not sky), 0 sky (clouds, flags, wires and birds before it too), 128 ignore. `DATA.md`
says where each set comes from and on what terms.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np

GROUND, IGNORE, SKY = 255, 128, 0

KEPT_PX = 400
"""Long side at which pictures are kept; training windows are 256 px."""

SET_WEIGHTS = {"mmp": 1.0, "uav": 0.25, "pseudo": 0.04, "khumbu": 0.08}
"""How often a set is drawn, whatever its number of pictures; mountains matter most."""


@dataclass(frozen=True)
class Picture:
    """One labelled picture.

    Attributes
    ----------
    name, source : str
        File name without suffix; name of the set.
    pixels : uint8 (H, W, 3) array
        RGB.
    label : uint8 (H, W) array
        `GROUND`, `SKY` or `IGNORE`.
    """

    name: str
    source: str
    pixels: np.ndarray
    label: np.ndarray


def load(folder, source, whole=False):
    """List of `Picture` in `folder`/`source`; `whole` keeps their size."""
    pictures = []
    for path in sorted((Path(folder) / source / "images").iterdir()):
        label_path = Path(folder) / source / "labels" / f"{path.stem}.png"
        if not label_path.exists():
            continue
        pixels = cv2.cvtColor(cv2.imread(str(path)), cv2.COLOR_BGR2RGB)
        label = cv2.imread(str(label_path), cv2.IMREAD_GRAYSCALE)
        if not whole:
            pixels = reduce(pixels, KEPT_PX)
        if label.shape != pixels.shape[:2]:
            label = cv2.resize(label, pixels.shape[1::-1], interpolation=cv2.INTER_NEAREST)
        pictures.append(Picture(path.stem, source, pixels, label))
    return pictures


def reduce(pixels, long_side_px):
    """Shrink a picture to a long side [pixels]; a smaller one stays as it is."""
    factor = long_side_px / max(pixels.shape[:2])
    if factor >= 1:
        return pixels
    return cv2.resize(pixels, None, fx=factor, fy=factor, interpolation=cv2.INTER_AREA)


def held_out():
    """Names of the pictures that never train, by set; of the drone's frames all of one recording."""
    return json.loads(Path(__file__).with_name("held_out.json").read_text(encoding="utf-8"))


def draw_weights(pictures):
    """Probability of drawing each picture, (n,)."""
    counts = {source: sum(p.source == source for p in pictures) for source in SET_WEIGHTS}
    weights = np.array([SET_WEIGHTS[p.source] / counts[p.source] for p in pictures])
    return weights / weights.sum()
