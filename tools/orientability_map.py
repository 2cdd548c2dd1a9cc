"""Draw the prediction of `orientability` over made-up mountains, for docs/locate.md: `orientability_map.py MAP.png`.

Each cell has the mean probability over all directions; the arrows point to the best direction of every third cell.
"""

from __future__ import annotations

import sys
from dataclasses import replace

import numpy as np
from PIL import Image
from skyline_viewshed.core.figures.hillshade import hillshade
from skyline_viewshed.core.figures.raster import draw_line, draw_words, resized
from skyline_viewshed.core.locate.build import build_index
from skyline_viewshed.core.locate.places import Area, IndexOptions
from skyline_viewshed.core.locate.unique import UniqueOptions, orientability
from skyline_viewshed.demo.mountains import MountainOptions, make_mountains

SEED, SIZE, CELL_M = 7, 360, 90.0
HALF_CELLS, TALL_CELLS, STRIDE_CELLS = 84, 90, 9
HFOVS_DEG = (15.0, 60.0)
PANEL_PX, GAP_PX, FOOT_PX, SHRINK = 440, 20, 58, 0.8
COLOURS = np.array([[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]], float)
"""Viridis, from probability 0 to 1."""
INK = (60, 66, 74)


def main():
    terrain = make_mountains(SEED, MountainOptions(size=SIZE, cell_m=CELL_M))
    first, last = SIZE // 2 - HALF_CELLS, SIZE // 2 + HALF_CELLS
    (west, north), (east, south) = terrain.position_of(first, first), terrain.position_of(last, first + TALL_CELLS)
    options = IndexOptions(spacing_m=STRIDE_CELLS * CELL_M, max_distance_m=40_000.0)
    index = build_index(terrain, Area.box(west, south, east, north), options)
    col, row = (np.rint(one).astype(int) for one in terrain.pixel_of(index.longitude_deg, index.latitude_deg))
    (at_row, row), (at_col, col) = (np.unique(one, return_inverse=True) for one in (row, col))
    half = STRIDE_CELLS // 2
    ground = terrain.elevation_m[at_row[0] - half : at_row[-1] + half + 1, at_col[0] - half : at_col[-1] + half + 1]
    grey = np.rint(255 * hillshade(ground, CELL_M)).astype(np.uint8)[..., None].repeat(3, 2)
    shade = resized(grey, PANEL_PX, PANEL_PX * len(at_row) // len(at_col))
    panels = [_panel(shade, index, (row, col), (len(at_row), len(at_col)), hfov) for hfov in HFOVS_DEG]
    gap = np.full((panels[0].shape[0], GAP_PX, 3), 255, np.uint8)
    picture = np.concatenate([panels[0], gap, panels[1]], axis=1)
    picture = np.concatenate([picture, _foot(picture.shape[1])])
    # A palette keeps the file small; the default method drops the ends of the scale and the colour of the text.
    image = Image.fromarray(picture).resize(
        [int(SHRINK * side) for side in picture.shape[1::-1]], Image.Resampling.LANCZOS
    )
    image.quantize(128, Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE).save(sys.argv[1], optimize=True)


def _panel(shade, index, at, shape, hfov_deg):
    """Colours and arrows of one field of view over the shaded ground."""
    mean, best = np.full(shape, np.nan), np.full(shape, np.nan)
    options = replace(UniqueOptions(), step_deg=4.0)
    for number in range(len(index)):
        elevation, distance = index.horizons(slice(number, number + 1))
        found = orientability(elevation[0], distance[0], hfov_deg, index.cell_m, options)
        place = at[0][number], at[1][number]
        mean[place] = found.mean
        if np.isfinite(found.probability).any():
            best[place] = found.heading_deg[np.nanargmax(found.probability)]
    print(f"{hfov_deg:.0f} degrees: {np.nanpercentile(mean, [0, 10, 50, 90, 100]).round(2)}")
    colour = _colour(np.nan_to_num(mean, nan=0.5))
    rows, cols = (np.arange(size) * count // size for size, count in zip(shade.shape[:2], shape))
    light = 0.45 + 0.75 * shade.astype(float) / 255
    pixels = np.clip(colour[rows][:, cols] * light, 0, 255).astype(np.uint8)
    size = shade.shape[1] / shape[1]
    for row in range(0, shape[0], 3):
        for col in range(0, shape[1], 3):
            if np.isfinite(best[row, col]):
                _arrow(pixels, (col + 0.5) * size, (row + 0.5) * size, np.radians(best[row, col]), 0.45 * size)
    head = np.full((30, shade.shape[1], 3), 255, np.uint8)
    draw_words(head, 2, 20, f"Field of view {hfov_deg:.0f}°: median {100 * np.nanmedian(mean):.0f} %", INK)
    return np.concatenate([head, pixels])


def _arrow(pixels, x, y, azimuth, length):
    east, south = np.sin(azimuth) * length, -np.cos(azimuth) * length
    tip, side = (x + east, y + south), (-south * 0.3, east * 0.3)
    draw_line(pixels, np.array([x - east, tip[0]]), np.array([y - south, tip[1]]), (255, 255, 255), 1.6)
    wing = np.array([tip[0] - 0.6 * east + side[0], tip[0], tip[0] - 0.6 * east - side[0]])
    draw_line(pixels, wing, np.array([tip[1] - 0.6 * south + side[1], tip[1], tip[1] - 0.6 * south - side[1]]),
              (255, 255, 255), 1.6)  # fmt: skip


def _colour(share):
    """(..., 3) colours of shares."""
    at = np.clip(share, 0, 1) * (len(COLOURS) - 1)
    return np.stack([np.interp(at, np.arange(len(COLOURS)), COLOURS[:, band]) for band in range(3)], axis=-1)


def _foot(width_px):
    """The scale of the colours."""
    foot = np.full((FOOT_PX, width_px, 3), 255, np.uint8)
    left, right = 20, PANEL_PX - 30
    foot[14:28, left:right] = _colour(np.linspace(0, 1, right - left))
    for share in (0, 0.25, 0.5, 0.75, 1):
        draw_words(foot, left + share * (right - left) - 12, 46, f"{100 * share:.0f} %", INK)
    draw_words(foot, right + 50, 26, "mean probability of a right heading", INK)
    draw_words(foot, right + 50, 46, "arrows: the best direction", INK)
    return foot


if __name__ == "__main__":
    main()
