"""Compare designs for the full circle: processor time on B, agreement with the exact references on C.

Usage: python benchmarks/viewshed_designs.py
    Prints the table of docs/performance.md. Only the sweep is part of the plugin; the other designs exist only here.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path
from unittest import mock

import exact_viewshed as exact
import make_dems
import numpy as np
from bench_speed import BUILD, DROP, Scene
from scipy.ndimage import map_coordinates
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer
from skyline_viewshed.core.viewshed import blocks as viewshed_blocks
from skyline_viewshed.core.viewshed.viewshed import ViewshedOptions, viewshed


def sweep(cells, scene, rays_per_cell=1.0):
    """Run the plugin's own sweep, which drops hidden blocks."""
    plain = ArrayTerrain(cells, scene.cell_m)
    observer = Observer(*plain.position_of(scene.col, scene.row), 1.7)
    options = ViewshedOptions(max_distance_m=scene.radius_m, refraction_coefficient=1 / 7, rays_per_cell=rays_per_cell)
    result, seen = viewshed(plain, observer, options=options), np.zeros(cells.shape, bool)
    window = result.window
    seen[window.row : window.row + window.rows, window.col : window.col + window.cols] = result.visible
    return seen


def sweep_everything(cells, scene):
    """Run the same sweep without bounds, so that every ray is sampled on every line."""
    everything = lambda values, first, last: np.full(len(first), -np.inf, np.float32)  # noqa: E731
    with mock.patch.object(viewshed_blocks, "range_minimum", everything):
        return sweep(cells, scene)


def rings(cells, scene):
    """Run ring vectorisation (XDraw): the limit of a cell is interpolated from the previous line, at every line."""
    seen, reach = np.zeros(cells.shape, bool), int(scene.radius_m / scene.cell_m)
    seen[scene.row, scene.col] = True
    for turn in range(4):
        grid, target = np.rot90(cells, turn), np.rot90(seen, turn)
        row, col = _turned(scene.row, scene.col, cells.shape, turn)
        limit = np.full(3, -1e9, np.float32)
        for k in range(1, min(reach, row) + 1):
            left, right = min(k, col), min(k, grid.shape[1] - 1 - col)
            j = np.arange(-k, k + 1)
            distance = np.hypot(j, k).astype(np.float32) * np.float32(scene.cell_m)
            line = np.full(2 * k + 1, -1e4, np.float32)
            line[k - left : k + right + 1] = grid[row - k, col - left : col + right + 1]
            tangent = (line - np.float32(scene.eye_m)) / distance - np.float32(DROP) * distance
            if k > 1:
                place = j * ((k - 1) / k) + (len(limit) - 1) / 2
                low = np.clip(place.astype(int), 0, len(limit) - 2)
                limit = limit[low] + (limit[low + 1] - limit[low]) * (place - low)
            else:
                limit = np.full(len(j), -1e9, np.float32)
            visible = (tangent >= limit) & (distance <= scene.radius_m)
            target[row - k, col - left : col + right + 1] |= visible[k - left : k + right + 1]
            limit = np.maximum(limit, tangent)
    return seen


def _turned(row, col, shape, turn):
    for _ in range(turn):
        row, col, shape = shape[1] - 1 - col, row, (shape[1], shape[0])
    return row, col


def polar(cells, scene):
    """Resample into (azimuth, distance), accumulate, sample the limits back at the cells."""
    reach = int(scene.radius_m / scene.cell_m)
    rays = int(2 * np.pi * reach) + 1
    distance = (np.arange(1, reach + 1) * scene.cell_m).astype(np.float32)
    limit = np.full((rays + 2, reach + 1), -1e9, np.float32)
    for first in range(0, rays, 512):
        azimuth = (np.arange(first, min(first + 512, rays)) * (2 * np.pi / rays))[:, None]
        place = (
            scene.row - np.cos(azimuth) * distance / scene.cell_m,
            scene.col + np.sin(azimuth) * distance / scene.cell_m,
        )
        z = map_coordinates(cells, place, order=1, mode="constant", cval=-1e4, output=np.float32)
        part = (z - np.float32(scene.eye_m)) / distance - np.float32(DROP) * distance
        limit[first : first + len(part), 1:] = np.maximum.accumulate(part, axis=1)
    limit[rays:] = limit[:2]
    seen = np.zeros(cells.shape, bool)
    col = np.arange(cells.shape[1])[None, :] - scene.col
    for first in range(0, cells.shape[0], 64):
        row = np.arange(first, min(first + 64, cells.shape[0]))[:, None] - scene.row
        span = np.hypot(row, col)
        azimuth = np.arctan2(col, -row) % (2 * np.pi) * (rays / (2 * np.pi))
        before = map_coordinates(limit, (azimuth, np.maximum(span - 1, 0)), order=1, mode="nearest", output=np.float32)
        ground = np.maximum(span, 1e-3) * scene.cell_m
        mine = (cells[first : first + 64] - scene.eye_m) / ground - DROP * ground
        seen[first : first + 64] = (mine >= before) & (ground <= scene.radius_m)
    return seen


DESIGNS = {
    "sweep, hidden blocks dropped, rays a cell apart (the plugin)": sweep,
    "sweep, hidden blocks dropped, 2 rays per cell": lambda cells, scene: sweep(cells, scene, 2.0),
    "sweep, hidden blocks dropped, 1 ray per 2 cells": lambda cells, scene: sweep(cells, scene, 0.5),
    "sweep of everything": sweep_everything,
    "ring vectorisation (XDraw)": rings,
    "polar resampling and inverse mapping (SciPy)": polar,
}


def main():
    paths = make_dems.make(str(BUILD / "dems"), ("B", "C"))
    scenes = {name: Scene(name, path) for name, path in paths.items()}
    cells = {name: scene.in_memory()[1] for name, scene in scenes.items()}
    near = scenes["C"]
    rng = np.random.default_rng(5)
    targets = rng.integers(0, cells["C"].shape[0], (40_000, 2))
    far = np.hypot(*(targets - np.array([near.row, near.col])).T) * near.cell_m
    targets = targets[far <= near.radius_m][:10_000]
    place = (near.row, near.col), near.eye_m
    truth = [exact.sees(cells["C"], near.cell_m, *place, targets, DROP, model) for model in ("crossings", "bilinear")]
    print("| design | B, CPU s | IoU exact crossings, C | IoU exact bilinear, C |\n| --- | --- | --- | --- |")
    for name, design in DESIGNS.items():
        found = design(cells["C"], near)[tuple(targets.T)]
        agreement = [f"{exact.iou(found, one):.3f}" for one in truth]
        times = []
        for _ in range(3):
            start = time.process_time()
            design(cells["B"], scenes["B"])
            times.append(time.process_time() - start)
        print(f"| {name} | {sorted(times)[len(times) // 2]:.2f} | {' | '.join(agreement)} |", flush=True)


if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).parent))
    main()
