"""Sky or ground, pixel by pixel: a small convolutional network that we trained (tools/sky), run in NumPy.

A U-Net of five levels with a global mean. It sees a picture reduced to `LONG_SIDE_PX` and gives the log-odds of sky
at half that size. Clouds, flags, wires and birds are sky to it; trees, people and window frames are ground. Batch
normalisation is folded into the convolutions; the file holds half-precision numbers and nothing else.
"""

from __future__ import annotations

import zipfile
from functools import lru_cache
from pathlib import Path

import numpy as np

from ..base import imaging

NETWORK_PATH = Path(__file__).with_name("sky_network.npz")

LONG_SIDE_PX = 256
"""Long side of the picture that the network sees; it was trained at this scale."""

STRIDE = 32
"""Both sides of that picture are multiples of this; so its aspect may be a few per cent off, as in training."""

ODDS_LIMIT = 4.0
"""Log-odds are clipped here: the network is wrong more often than it believes."""

SOFTNESS = 16.0
"""Neighbouring pixels share their mistakes, so their summed log-odds are divided by this."""

TRUSTED = 0.95
"""Share of a column's probability that the network distributes; the rest is spread evenly over the rows."""

STEPS_DOWN = (2, 2, 2, 2, 3)
"""Convolutions of each level on the way down."""


def network_input(pixels):
    """What the network takes, float32 (H, W, 4): RGB of -1 to 1 and the row's place, -1 at the top and 1 below."""
    height, width = pixels.shape[:2]
    values = np.empty((height, width, 4), np.float32)
    np.divide(pixels, np.float32(127.5), out=values[..., :3], casting="unsafe")
    values[..., :3] -= 1
    values[..., 3] = np.linspace(-1, 1, height, dtype=np.float32)[:, None]
    return values


def sky_log_odds(pixels, long_side_px=LONG_SIDE_PX):
    """Log-odds that a part of a picture is sky.

    Parameters
    ----------
    pixels : (H, W, 3) array
        Upright RGB, 0 to 255, of any size.
    long_side_px : int
        Size at which the network sees it, rounded to a multiple of `STRIDE` [pixels].

    Returns
    -------
    (h, w) float32 array
        Covers the whole picture; h and w are half of what the network sees. Above 0 is sky.

    Raises
    ------
    ValueError
        The weights cannot be read.
    """
    height, width = pixels.shape[:2]
    factor = long_side_px / max(height, width)
    shape = [max(STRIDE, round(side * factor / STRIDE) * STRIDE) for side in (height, width)]
    return _run(network_input(resized(pixels, *shape)), load_layers())


def row_probability(log_odds, softness=SOFTNESS):
    """Probability that a column's first ground row is each row, from log-odds of sky alone.

    Parameters
    ----------
    log_odds : (H, W) array
        `sky_log_odds` at the size of the picture.
    softness : float
        Divisor of the summed log-odds; the larger, the less certain.

    Returns
    -------
    (H, W) float32 array
        Columns sum to 1. No row is impossible, as the network may be wrong about a whole column.
    """
    odds = np.clip(log_odds, -ODDS_LIMIT, ODDS_LIMIT).astype(np.float32)
    height = len(odds)
    split = np.zeros_like(odds)
    split[1:] = imaging.accumulate_down(np.add, odds[:-1])
    chance = np.exp((split - split.max(0)) / softness)
    return TRUSTED * chance / chance.sum(0) + (1 - TRUSTED) / height


def resized(image, height_px, width_px):
    """Resample a picture or a map: sides that become smaller by areas, those that become larger linearly.

    Parameters
    ----------
    image : (H, W) or (H, W, C) array
    height_px, width_px : int
        New size [pixels].
    """
    height, width = image.shape[:2]
    smaller = imaging.shrink(image, min(width, width_px), min(height, height_px))
    for axis, size in ((0, height_px), (1, width_px)):
        smaller = _enlarged(smaller, size, axis)
    return smaller


def _enlarged(image, size, axis):
    """Linear interpolation to more pixels along one axis; edge pixels are held beyond their centres."""
    old = image.shape[axis]
    if size == old:
        return image
    place = np.clip((np.arange(size) + 0.5) * old / size - 0.5, 0, old - 1)
    first = np.minimum(place.astype(int), max(old - 2, 0))
    share = (place - first).astype(np.float32).reshape(-1, *[1] * (image.ndim - axis - 1))
    before, after = image.take(first, axis), image.take(np.minimum(first + 1, old - 1), axis)
    return before + (after - before) * share


@lru_cache(maxsize=1)
def load_layers(path=NETWORK_PATH):
    """Weights by layer: (kernel (taps x channels in, channels out), bias), float32.

    Raises
    ------
    ValueError
        The file is missing, damaged or of another network.
    """
    try:
        with open(path, "rb") as opened, np.load(opened, allow_pickle=False) as file:
            values = {name: file[name].astype(np.float32) for name in file.files}
        layers = {name: (values[f"{name}.kernel"], values[f"{name}.bias"]) for name in _layer_names()}
    except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile) as error:
        raise ValueError(f"The sky network's weights cannot be read from {path}: {error}") from error
    if not all(np.isfinite(part).all() for layer in layers.values() for part in layer):
        raise ValueError(f"The sky network's weights in {path} hold values that are not finite.")
    return layers


def _layer_names():
    levels = range(len(STEPS_DOWN))
    downs = [f"down{level}.{step}" for level in levels for step in range(STEPS_DOWN[level])]
    return [*downs, "everywhere", *(f"up{level}" for level in levels[:-1]), "last"]


def _run(values, layers):
    """Log-odds of sky (H / 2, W / 2) from `network_input`."""
    skips = []
    for level, steps in enumerate(STEPS_DOWN):
        for step in range(steps):
            kernel, bias = layers[f"down{level}.{step}"]
            values = _rectified(_convolved(values, kernel, bias, stride=1 if step else 2))
        skips.append(values)
    kernel, bias = layers["everywhere"]
    values = _rectified(values + (values.mean((0, 1)) @ kernel + bias))
    for level, skip in enumerate(skips[-2::-1]):
        doubled = values.repeat(2, 0).repeat(2, 1)
        values = _rectified(_convolved(np.concatenate([doubled, skip], -1), *layers[f"up{level}"]))
    return _convolved(values, *layers["last"])[..., 0]


def _convolved(values, kernel, bias, stride=1):
    """3 x 3 convolution of (H, W, C) values with zeros beyond the borders, as one product of matrices."""
    height, width, channels = values.shape
    padded = np.zeros((height + 2, width + 2, channels), np.float32)
    padded[1:-1, 1:-1] = values
    taps = np.empty((-(-height // stride), -(-width // stride), 9 * channels), np.float32)
    for tap in range(9):
        down, across = divmod(tap, 3)
        window = padded[down : down + height : stride, across : across + width : stride]
        taps[..., tap * channels : (tap + 1) * channels] = window
    out = taps.reshape(-1, 9 * channels) @ kernel
    out += bias
    return out.reshape(*taps.shape[:2], -1)


def _rectified(values):
    return np.maximum(values, 0, out=values)
