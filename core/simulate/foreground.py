"""Trees and people close to a simulated camera: dark shapes in front of terrain and sky."""

from __future__ import annotations

import numpy as np

from .noise import noise_tile

NEEDLES = np.array([0.020, 0.030, 0.016])
JACKETS = np.array([[0.16, 0.03, 0.03], [0.03, 0.05, 0.12], [0.20, 0.13, 0.03], [0.03, 0.03, 0.03], [0.04, 0.09, 0.06]])


def draw_foreground(shape, ridge_row_px, scene):
    """Draw the objects near the camera.

    Parameters
    ----------
    shape : (height, width)
        Size of the picture [pixels].
    ridge_row_px : (W,) array
        Row of the skyline, which some tree tops reach [pixels].
    scene : SceneOptions

    Returns
    -------
    opacity : (H, W) float32 array
    colour : (H, W, 3) float32 array
        Linear albedo under open shade.
    """
    height, width = shape
    opacity, colour = np.zeros(shape, np.float32), np.zeros(shape + (3,), np.float32)
    if scene.foreground == "none":
        return opacity, colour
    generator = np.random.Generator(np.random.PCG64([scene.seed, 41]))
    tile = noise_tile(6100 + scene.seed, 0.8)
    covered = 0.0
    for _ in range(60):
        if covered >= scene.foreground_share * width:
            break
        if scene.foreground == "trees":
            place, shape_of = _tree(generator, height, width, ridge_row_px)
        else:
            place, shape_of = _person(generator, height, width)
        covered += _paint(opacity, colour, place, shape_of, tile, generator)
    return opacity, colour


def _tree(generator, height, width, ridge_row_px):
    """Position and outline of a conifer: clustered at the sides, its top around the ridge or below it."""
    side = generator.random()
    x = width * (side**2 * 0.5 if generator.random() < 0.5 else 1 - side**2 * 0.5)
    ridge = float(ridge_row_px[int(np.clip(x, 0, width - 1))])
    reach = height - ridge
    top = ridge + reach * (0.85 * generator.random() - 0.25)
    half = (height - top) * (0.13 + 0.13 * generator.random())
    return (x, max(top, -0.2 * height), half, NEEDLES * (0.5 + 0.8 * generator.random()), 1.0), _conifer_half_width


def _person(generator, height, width):
    """Position and outline of a person standing close by."""
    tall = height * (0.2 + 0.4 * generator.random())
    jacket = JACKETS[int(generator.random() * len(JACKETS))]
    x = width * generator.random()
    return (x, height * (1.03 + 0.1 * generator.random()) - tall, 0.2 * tall, 0.6 * jacket, 0.25), _person_half_width


def _conifer_half_width(down, half, noise):
    """Half width of a conifer at a share `down` from its top: whorls of drooping branches."""
    whorl = 0.62 + 0.38 * np.mod(down * 17 + 0.4 * noise, 1.0)
    return half * down**0.9 * whorl * (1 + 0.35 * noise)


def _person_half_width(down, half, noise):
    """Half width of a standing person: head, neck, shoulders, trunk."""
    head = np.sqrt(np.clip(1 - ((down - 0.08) / 0.08) ** 2, 0, 1)) * 0.36
    trunk = np.where(down > 0.13, 0.16 + 0.84 * np.sqrt(np.clip((down - 0.15) / 0.09, 0, 1)), 0.0)
    return half * np.maximum(head, trunk * (1 - 0.12 * down)) * (1 + 0.04 * noise)


def _paint(opacity, colour, place, shape_of, tile, generator):
    """Draw one shape into the picture and return the width that it newly covers [pixels]."""
    x, top, half, tint, rough = place
    height, width = opacity.shape
    first_row, rows = max(int(top), 0), np.arange(max(int(top), 0), height)
    left, right = max(int(x - 1.6 * half) - 2, 0), min(int(x + 1.6 * half) + 3, width)
    if not rows.size or left >= right:
        return 0.0
    cols = np.arange(left, right)
    shift = generator.random(2) * 256
    fine = max(height / 500.0, 0.3)
    side = np.sign(cols - x)[None, :]
    noise = tile.sample((side * 40 + rows[:, None] / fine + shift[0]), shift[1] + 0.6 * cols[None, :] / fine)[..., 0]
    noise = rough * noise
    down = np.clip((rows - top) / max(height - top, 1.0), 0, 1.2)[:, None]
    inside = shape_of(down, half, noise) - np.abs(cols[None, :] - x)
    mask = np.clip(inside + 0.5, 0, 1).astype(np.float32)
    before = (opacity[first_row:, left:right] > 0.5).any(axis=0)
    light = np.clip(1 + 0.3 * noise + 0.5 * (cols[None, :] - x) / max(half, 1.0), 0.25, 2.2)[..., None]
    part = colour[first_row:, left:right]
    part += mask[..., None] * (tint * light - part)
    seen = opacity[first_row:, left:right]
    np.maximum(seen, mask, out=seen)
    return float(((seen > 0.5).any(axis=0) & ~before).sum())
