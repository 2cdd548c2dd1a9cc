"""Noise, light, sky, foreground and sensor of simulated photographs."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.camera import Camera, Pose
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer
from skyline_viewshed.core.simulate.foreground import draw_foreground
from skyline_viewshed.core.simulate.noise import noise_tile, smoothstep
from skyline_viewshed.core.simulate.render import render_view
from skyline_viewshed.core.simulate.scene import SceneOptions
from skyline_viewshed.core.simulate.sensor import develop
from skyline_viewshed.core.simulate.sky import sky_radiance, sun_light, transmission


def test_a_tile_repeats_without_a_seam_and_has_unit_deviation():
    tile = noise_tile(3, 1.2)
    x = np.linspace(0, 256, 500)
    here, next_door = tile.sample(x, x * 0.7), tile.sample(x + 256, x * 0.7 - 512)
    np.testing.assert_allclose(here, next_door, atol=1e-5)
    grid = np.arange(256.0)
    value = tile.sample(*np.meshgrid(grid, grid))[..., 0]
    assert value.std() == pytest.approx(1.0, abs=1e-3)
    assert abs(value.mean()) < 1e-3


def test_a_tiles_gradient_is_its_slope():
    tile = noise_tile(3, 2.0)
    x = np.linspace(3.3, 90.1, 200)
    ahead = tile.sample(x + 1.0, 20.0 + 0 * x)[:, 0] - tile.sample(x - 1.0, 20.0 + 0 * x)[:, 0]
    assert np.corrcoef(ahead / 2, tile.sample(x, 20.0 + 0 * x)[:, 1])[0, 1] > 0.99


def test_a_large_footprint_averages_the_detail_away():
    tile = noise_tile(3, 0.5)
    x = np.arange(4000) * 0.37
    spread = [tile.sample(x, 0 * x, blur)[:, 0].std() for blur in (1.0, 4.0, 16.0)]
    assert spread[0] > 1.5 * spread[1] > 2 * spread[2]


def test_smoothstep_rises_and_falls():
    assert smoothstep(0, 1, 0.5) == 0.5
    assert smoothstep(2, 1, 0.5) == 1.0 and smoothstep(2, 1, 3) == 0.0


def test_haze_grows_with_distance_and_thins_with_height():
    distance = np.array([0.0, 1e3, 1e4, 5e4])
    low = transmission(distance, 500.0, np.full(4, 500.0), 40_000.0)
    high = transmission(distance, 4000.0, np.full(4, 4000.0), 40_000.0)
    assert (low[0] == 1).all()
    assert (np.diff(low, axis=0) < 0).all()
    assert (high[1:] > low[1:]).all()
    assert (low[1:, 2] < low[1:, 0]).all()  # blue goes first


def test_a_low_sun_is_weak_and_red():
    high, low = sun_light(50.0), sun_light(2.0)
    assert low.sum() < high.sum()
    assert low[0] / low[2] > 1.5 * high[0] / high[2]


def test_the_sky_pales_towards_the_horizon_and_glows_at_the_sun():
    scene = SceneOptions(sun_azimuth_deg=100.0, sun_elevation_deg=30.0)
    zenith, horizon = (sky_radiance(np.array([90.0]), np.array([t]), scene, 100.0)[0] for t in (3.0, 0.0))
    assert horizon[0] / horizon[2] > zenith[0] / zenith[2]
    at_sun = sky_radiance(np.array([0.0]), np.array([np.tan(np.radians(30.0))]), scene, 100.0)[0]
    beside = sky_radiance(np.array([90.0]), np.array([np.tan(np.radians(30.0))]), scene, 100.0)[0]
    assert at_sun.mean() > 2 * beside.mean()


def test_a_wall_shades_the_ground_behind_it():
    elevation = np.full((240, 240), 100.0, np.float32)
    elevation[:, 118:120] = 500.0  # a wall from north to south
    terrain = ArrayTerrain(elevation, 20.0)
    longitude, latitude = terrain.position_of(160, 200)
    options = {"snow_line_m": 9e3, "tree_line_m": -9e3, "texture": 0.0, "noise": 0.0, "sun_elevation_deg": 30.0}
    picture = [
        render_view(
            terrain,
            Observer(longitude, latitude, 60.0),
            Camera(120, 90, 90.0),
            Pose(0.0, -10.0),
            SceneOptions(1, sun_azimuth_deg=azimuth, exposure_ev=0.0, **options),
        )
        for azimuth in (270.0, 90.0)
    ]
    # With the sun in the west the shadow reaches 400 / tan(30) = 690 m to the east of the wall.
    east = picture[0].east_m + (160 - 119.5) * 20.0
    flat = np.isfinite(east) & (picture[0].elevation_m < 110)
    near, beyond = flat & (east > 150) & (east < 600), flat & (east > 900) & (east < 1500)
    assert near.sum() > 50 and beyond.sum() > 50
    in_west, in_east = (p.pixels.mean(axis=-1) for p in picture)
    assert in_west[near].mean() < 0.75 * in_west[beyond].mean()
    assert in_east[near].mean() > 0.85 * in_east[beyond].mean()


def test_foreground_covers_about_the_share_asked_and_nothing_without():
    ridge = np.full(320, 80.0)
    cover, _ = draw_foreground((240, 320), ridge, SceneOptions(seed=2))
    assert not cover.any()
    for kind in ("trees", "people"):
        cover, colour = draw_foreground((240, 320), ridge, SceneOptions(seed=2, foreground=kind, foreground_share=0.4))
        assert 0.3 < (cover > 0.5).any(axis=0).mean() < 0.9
        assert colour[cover > 0.5].mean() < 0.3


def test_sensor_noise_has_the_level_asked():
    grey = np.full((200, 300, 3), 0.2, np.float32)
    quiet = {"blur_px": 0.0, "sharpening": 0.0, "vignetting": 0.0}
    camera = Camera(300, 200, 300.0)
    clean = develop(grey, camera, SceneOptions(noise=0.0, **quiet))
    assert clean.std() == 0
    level = [develop(grey, camera, SceneOptions(noise=n, **quiet)).astype(float)[..., 1].std() for n in (1.0, 4.0)]
    assert 0.6 < level[0] < 1.6 and 3.0 < level[1] < 5.5


def test_vignetting_darkens_the_corners_and_sharpening_overshoots_edges():
    camera = Camera(300, 200, 300.0)
    grey = np.full((200, 300, 3), 0.2, np.float32)
    dark = develop(grey, camera, SceneOptions(noise=0.0, vignetting=0.4)).astype(int)
    assert dark[0, 0, 0] < dark[100, 150, 0] - 10
    edge = grey.copy()
    edge[100:] = 0.05
    sharp = develop(edge, camera, SceneOptions(noise=0.0, vignetting=0.0, sharpening=1.0)).astype(int)[:, 150, 1]
    assert sharp.max() > sharp[20] + 3 and sharp.min() < sharp[-20] - 3
