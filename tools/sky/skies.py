"""Other skies for training pictures: patches of other photographs, painted ones, fractal clouds, haze.

All pictures here are float32 (H, W, 3) RGB, 0 to 255, labels uint8 as in `data`; `generator` is a NumPy Generator.
"""

from __future__ import annotations

import cv2
import numpy as np
from data import GROUND, IGNORE, SKY

PAINTED_SKIES = {  # colour at the zenith, colour at the horizon, contrast of its clouds
    "blue": ((60, 110, 180), (170, 200, 225), 0.02),
    "deep": ((15, 45, 110), (80, 130, 190), 0.02),
    "white": ((235, 236, 238), (245, 245, 245), 0.01),
    "grey": ((165, 170, 178), (200, 203, 206), 0.06),
    "dark": ((70, 75, 85), (120, 125, 132), 0.12),
    "storm": ((45, 50, 60), (150, 152, 155), 0.25),
    "dusk": ((60, 60, 110), (235, 160, 110), 0.08),
}


def sky_patch(picture):
    """The largest clear rectangle of sky under a picture's upper edge, uint8 (h, w, 3), or None."""
    ground = picture.label != SKY
    height, width = ground.shape
    top = np.where(ground.any(0), ground.argmax(0), height)
    best, area = None, 0
    for share in (0.2, 0.3, 0.45, 0.6, 0.8):
        depth = int(share * height)
        edges = np.flatnonzero(np.diff(np.concatenate([[0], top >= depth, [0]])))
        for left, right in zip(edges[::2], edges[1::2]):
            if right - left > 0.35 * width and (right - left) * depth > area:
                best, area = picture.pixels[:depth, left:right], (right - left) * depth
    return best


def fractal(generator, shape, scale_px, gain=0.55):
    """Noise of mean 0 and deviation 1, (H, W) float32, from `scale_px` (across, down) to single pixels."""
    height, width = shape
    across, down = scale_px
    total, amplitude = np.zeros(shape, np.float32), 1.0
    for _ in range(5):
        size = max(2, int(height / down) + 2), max(2, int(width / across) + 2)
        grid = generator.standard_normal(size).astype(np.float32)
        total += amplitude * cv2.resize(grid, (width, height), interpolation=cv2.INTER_CUBIC)
        amplitude, across, down = amplitude * gain, max(2.0, across / 2), max(2.0, down / 2)
    return (total - total.mean()) / (total.std() + 1e-6)


def painted_sky(generator, shape):
    """A sky of one of `PAINTED_SKIES`: gradient, some clouds, some unevenness, (H, W, 3)."""
    height, width = shape
    high, low, contrast = PAINTED_SKIES[list(PAINTED_SKIES)[generator.integers(len(PAINTED_SKIES))]]
    way = np.linspace(0, 1, height, dtype=np.float32)[:, None, None] ** generator.uniform(0.5, 2)
    tilt = generator.uniform(-0.15, 0.15) * np.linspace(-1, 1, width, dtype=np.float32)[None, :, None]
    way = np.clip(way + tilt, 0, 1)
    sky = np.array(high, np.float32) * (1 - way) + np.array(low, np.float32) * way
    across = generator.uniform(0.2, 0.8) * width
    texture = fractal(generator, shape, (across, across * generator.uniform(0.15, 0.6)))
    sky = sky * (1 + contrast * generator.uniform(0.3, 1.5) * texture[..., None])
    return sky * generator.uniform(0.85, 1.1) * (1 + generator.normal(0, 0.02, 3))


def cumulus_sky(generator, shape):
    """Broken cumulus before blue: lit tops, grey undersides, hard edges, (H, W, 3).

    Seen against a dark blue their relief is as strong as that of rock and snow, above all where a telephone lifts
    local contrast.
    """
    height, width = shape
    sky = painted_sky(generator, shape)
    across = generator.uniform(0.15, 0.6) * width
    scale = across, across * generator.uniform(0.3, 0.8)
    billows = 0.8 - np.abs(fractal(generator, shape, scale, 0.6))
    thickness = fractal(generator, shape, (scale[0] * 2, scale[1] * 2)) + 0.8 * billows + generator.uniform(-0.7, 0.9)
    cover = np.clip(thickness * generator.uniform(2, 8), 0, 1)
    deep = cv2.GaussianBlur(np.maximum(thickness, 0), (0, 0), max(0.6, scale[1] / 12))
    sun = generator.normal(0, 0.6), -1.0  # the light comes from above, a little from one side
    slope = np.gradient(cv2.GaussianBlur(thickness, (0, 0), max(0.6, scale[1] / 30)))
    lit = slope[1] * sun[0] - slope[0] * sun[1]
    lit = lit / (lit.std() + 1e-6)
    bright, dark = generator.uniform(190, 255), generator.uniform(60, 170)
    shade = np.clip(deep * generator.uniform(0.2, 0.9) - generator.uniform(0.05, 0.3) * lit, 0, 1)
    cloud = (bright + (dark - bright) * shade)[..., None] * (1 + generator.normal(0, 0.015, 3))
    cloud = cloud + np.array([-4, 0, 6]) * shade[..., None]  # shadows are lit by the blue sky
    return np.clip(sky * (1 - cover[..., None]) + cloud * cover[..., None], 0, 255)


def replace_sky(generator, image, label, patches):
    """Set another sky, from a photograph or painted, behind the terrain."""
    height, width = label.shape
    # Ignored pixels beside the sky go with it, lest a rim of the old sky betrays the ridge.
    open_sky = (cv2.dilate((label == SKY).astype(np.uint8), np.ones((7, 7))) > 0) & (label != GROUND)
    share = np.clip(cv2.GaussianBlur(open_sky.astype(np.float32), (0, 0), generator.uniform(0.4, 1.0)), 0, 1)
    rows = np.flatnonzero((label == SKY).any(1))
    depth = max(8, min(height, rows[-1] + 3))
    kind = generator.random()
    if kind < 0.2:
        new = painted_sky(generator, (depth, width))
    elif kind < 0.4:
        new = cumulus_sky(generator, (depth, width))
    else:
        new = _cut(generator, patches[generator.integers(len(patches))], depth, width)
    if generator.random() < 0.25:  # clouds with the contrast of a telephone's tone mapping
        smooth = cv2.GaussianBlur(new, (0, 0), generator.uniform(0.05, 0.3) * min(depth, width))
        new = smooth + (new - smooth) * generator.uniform(1, 3)
    if generator.random() < 0.6:  # the terrain's light follows the new sky a little
        old_mean, new_mean = image[label == SKY].mean(0), new.reshape(-1, 3).mean(0)
        image = image * np.clip((new_mean + 30) / (old_mean + 30), 0.5, 1.6) ** generator.uniform(0.2, 0.8)
    full = np.empty_like(image)
    full[:depth], full[depth:] = new, new[-1:]
    return np.clip(full * share[..., None] + image * (1 - share[..., None]), 0, 255)


def _cut(generator, patch, depth, width):
    """A random window of a patch, enlarged at random, (depth, width, 3) float32."""
    tall, wide = int(depth * generator.uniform(1, 1.6)), int(width * generator.uniform(1, 1.8))
    enlarged = cv2.resize(patch, (wide, tall), interpolation=cv2.INTER_LINEAR)
    top, left = generator.integers(0, tall - depth + 1), generator.integers(0, wide - width + 1)
    window = enlarged[top : top + depth, left : left + width].astype(np.float32)
    return window[:, ::-1] if generator.random() < 0.5 else window


def add_cloud(generator, image, label, line):
    """Lay a fractal cloud, bank or veil behind the terrain, or before its ridge.

    Cloud that hides terrain is sky where it hangs together with the sky; half-hidden terrain, and cloud that lies
    wholly before terrain, are to be ignored.

    Parameters
    ----------
    generator : numpy.random.Generator
    image : float32 (H, W, 3) array
    label : uint8 (H, W) array
    line : (W,) array
        First ground row of each column [pixels].

    Returns
    -------
    tuple
        New image, new label.
    """
    height, width = label.shape
    kind = ("cumulus", "bank", "veil")[generator.integers(3)]
    across = generator.uniform(0.15, 0.8) * width
    down = across * generator.uniform(0.2, 0.7)
    shape = fractal(generator, label.shape, (across, down)) - generator.uniform(-0.6, 1.0)
    if kind == "bank":  # its middle runs somewhere near the skyline
        middle = np.median(line) + generator.normal(-0.05, 0.15) * height
        thickness = generator.uniform(0.03, 0.2) * height
        shape = shape * 0.6 + 1.2 - ((np.arange(height)[:, None] - middle) / thickness) ** 2
    softness = generator.uniform(0.4, 1.0) if kind == "veil" else generator.uniform(1.5, 8)
    opacity = np.clip(shape * softness, 0, 1) * generator.uniform(0.5, 1)
    before = kind != "veil" and generator.random() < 0.4
    if before:
        depth = generator.uniform(0.0, 0.25) * height  # how far below the ridge the cloud reaches
        below = np.arange(height)[:, None] - line[None]
        opacity = opacity * np.clip(1 - below / max(depth, 1), 0, 1)
    else:
        opacity = opacity * cv2.GaussianBlur((label == SKY).astype(np.float32), (0, 0), 0.6)
    shading = fractal(generator, label.shape, (across / 2, down / 2))
    dimmed = generator.uniform(0, 0.12) * np.maximum(shape, 0)
    light = generator.uniform(0.45, 1.0) * 255 * (1 + 0.13 * shading - dimmed)
    colour = np.clip(light, 0, 255)[..., None] * (1 + generator.normal(0, 0.03, 3))
    opacity = opacity[..., None].astype(np.float32)
    image = image * (1 - opacity) + colour.astype(np.float32) * opacity
    return image, (_behind_cloud(label, opacity[..., 0]) if before else label)


def _behind_cloud(label, opacity):
    """Labels where cloud of an opacity lies before the terrain."""
    sky = label == SKY
    thick = opacity > 0.8
    _, pieces = cv2.connectedComponents((sky | thick).astype(np.uint8), connectivity=4)
    joined = np.isin(pieces, np.unique(pieces[sky]))
    out = label.copy()
    out[(label == GROUND) & (opacity > 0.3)] = IGNORE
    out[(label == GROUND) & thick & joined] = SKY
    return out


def add_snow(generator, image, label, line):
    """Let the upper terrain turn bright and colourless, its relief kept: snow that is as white as cloud."""
    height = label.shape[0]
    below = np.arange(height)[:, None] - line[None]
    reach = height * generator.uniform(0.1, 0.6)
    across = generator.uniform(0.1, 0.4) * label.shape[1]
    snowline = 1 - below / reach + 0.4 * fractal(generator, label.shape, (across, across / 2))
    share = np.clip(snowline * generator.uniform(1.5, 6), 0, 1)
    share = share * (label != SKY) * generator.uniform(0.5, 1)
    share = cv2.GaussianBlur(share.astype(np.float32), (0, 0), 0.6)[..., None]
    grey = image.mean(2, keepdims=True)
    relief = (grey - grey[label == GROUND].mean()) * generator.uniform(0.4, 1.2)
    snow = (generator.uniform(170, 245) + relief) * (1 + generator.normal(0, 0.02, 3))
    return (image * (1 - share) + np.clip(snow, 0, 255) * share).astype(np.float32)


def add_haze(generator, image, label, line):
    """Let far terrain fade into the sky's colour; strongly at times, to a white-out."""
    height = label.shape[0]
    sky = label == SKY
    colour = image[sky].mean(0) * generator.uniform(0.85, 1.1)
    reach = height * generator.uniform(0.08, 0.6)
    near = np.clip((np.arange(height)[:, None] - line[None]) / reach, 0, 1)
    strongest = generator.uniform(0.8, 0.96) if generator.random() < 0.2 else generator.uniform(0.1, 0.85)
    share = strongest * (1 - near)
    share[sky] = 0
    share = cv2.GaussianBlur(share.astype(np.float32), (0, 0), 0.7)[..., None]
    return image * (1 - share) + colour * share
