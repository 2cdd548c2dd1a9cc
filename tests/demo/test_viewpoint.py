from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scenes import small_mountains
from skyline_viewshed.core.base.camera import Camera
from skyline_viewshed.core.base.errors import TerrainError
from skyline_viewshed.core.base.terrain import ArrayTerrain
from skyline_viewshed.core.simulate.render import render_view
from skyline_viewshed.core.simulate.scene import SceneOptions
from skyline_viewshed.demo.viewpoint import ViewpointOptions, find_view

CAMERA = Camera(160, 120, 150.0)


@pytest.mark.parametrize("seed", range(4))
def test_the_view_found_has_a_far_ridge_in_the_frame(seed):
    terrain = small_mountains()
    generator = np.random.Generator(np.random.PCG64(seed))
    observer, pose = find_view(terrain, CAMERA, generator, terrain.position_of)
    view = render_view(terrain, observer, CAMERA, pose, SceneOptions(range_m=40_000.0))
    inside = np.isfinite(view.skyline_row_px)
    assert inside.mean() > 0.8
    rows = np.ceil(view.skyline_row_px[inside]).astype(int).clip(0, 119)
    far = view.distance_m[rows, np.flatnonzero(inside)] > 1_400
    assert far.mean() > 0.6
    assert abs(pose.roll_deg) <= 8


def test_a_plain_offers_no_view():
    plain = ArrayTerrain(np.zeros((64, 64), np.float32), 200.0)
    with pytest.raises(TerrainError, match="relief"):
        find_view(plain, CAMERA, np.random.Generator(np.random.PCG64(1)), plain.position_of, ViewpointOptions(tries=3))


def test_a_place_without_ground_in_the_finer_terrain_is_passed_over():
    terrain = small_mountains()
    half = terrain.elevation_m.copy()
    half[:, : half.shape[1] // 2] = np.nan
    finer = replace(terrain, elevation_m=half)
    middle = terrain.position_of(terrain.shape[1] / 2, 0)[0]
    for seed in range(4):
        generator = np.random.Generator(np.random.PCG64(seed))
        observer, _ = find_view(terrain, CAMERA, generator, terrain.position_of, finer=finer)
        assert observer.longitude_deg > middle
