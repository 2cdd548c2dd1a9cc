"""Pictures on which the sky network and the classical features learn to speak together (`tools/fit_skyline.py`).

The network must not have seen them, or they would teach too much trust in it: only held-out pictures of `mmp`, as
they are and under other weather, with things in the way.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
import augment  # noqa: E402
import clutter  # noqa: E402
import data  # noqa: E402
import skies  # noqa: E402

WIDENING = 1.4
"""The pictures of `mmp` are squeezed into squares; this is their usual aspect."""

MARGIN_PX = 8
"""Ignored rows between sky and ground may be this many at most."""


def skyline_of(label):
    """First ground row of each column with nothing but sky above it, NaN where there is no such row."""
    ground, sky = label == data.GROUND, label == data.SKY
    row = np.where(ground.any(0), ground.argmax(0), len(label)).astype(float)
    end = np.where((~sky).any(0), (~sky).argmax(0), len(label))
    middle = (row + end) / 2
    return np.where((row - end <= MARGIN_PX) & (end > 0) & (row < 0.97 * len(label)), middle, np.nan)


def held_out_pictures(folder, turns, seed=3):
    """Yield name, RGB pixels, skyline rows of held-out pictures, as they are and `turns` times under other weather."""
    import cv2

    cv2.setNumThreads(1)
    names = set(data.held_out()["mmp"])
    everything = [p for source in ("mmp", "uav") for p in data.load(folder, source, whole=True)]
    patches = [patch for patch in map(skies.sky_patch, everything) if patch is not None]
    for index, picture in enumerate(p for p in everything if p.source == "mmp" and p.name in names):
        size = (picture.label.shape[1], round(picture.label.shape[0] / WIDENING))
        image = cv2.resize(picture.pixels, size, interpolation=cv2.INTER_AREA)
        label = cv2.resize(picture.label, size, interpolation=cv2.INTER_NEAREST)
        for turn in range(turns + 1):
            generator = np.random.default_rng([seed, index, turn])
            made, changed = image.astype(np.float32), label
            if turn and (label == data.SKY).any():
                made, changed = augment.weather(generator, made, label, patches)
                for name in ("flags", "wires", "flare", "specks"):
                    if generator.random() < 0.12:
                        made = getattr(clutter, f"add_{name}")(generator, made)
            pixels = np.clip(made, 0, 255).astype(np.uint8)
            row, before = skyline_of(changed), skyline_of(label)
            # A ridge behind cloud is not where the cloud ends.
            yield f"{picture.name} turn {turn}", pixels, np.where(np.abs(row - before) <= MARGIN_PX, before, np.nan)
