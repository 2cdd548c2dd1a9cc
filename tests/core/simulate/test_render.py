from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scenes import mountain_scene, small_mountains
from skyline_viewshed.core.base.camera import Camera, Pose, project
from skyline_viewshed.core.base.curvature import apparent_drop_m
from skyline_viewshed.core.base.errors import Cancelled, ObserverOutsideDemError
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer, bilinear
from skyline_viewshed.core.horizon.horizon import HorizonOptions, horizon_profile
from skyline_viewshed.core.simulate.render import render_view
from skyline_viewshed.core.simulate.scene import SceneOptions
from skyline_viewshed.core.simulate.weather import hard_scene

CAMERA = Camera(240, 180, 260.0)


def cone(height_m=1500.0, slope=0.6, cell_m=20.0, size=801):
    axis = (np.arange(size) - size // 2) * cell_m
    east, north = np.meshgrid(axis, -axis)
    return ArrayTerrain(np.maximum(height_m - slope * np.hypot(east, north), 0.0).astype(np.float32), cell_m)


def test_the_sea_horizon_dips_by_its_closed_form():
    sea = ArrayTerrain(np.zeros((600, 600), np.float32), 500.0)
    pose = Pose(77.0, 1.5, 4.0)
    view = render_view(sea, Observer(0, 0, eye_height_m=100.0), CAMERA, pose, SceneOptions(range_m=120_000.0))
    per_m2 = apparent_drop_m(1.0)
    dip_deg = np.degrees(np.arctan(-2 * np.sqrt(100.0 * per_m2)))
    azimuth = 77.0 + np.linspace(-35, 35, 2001)
    x, y = project(CAMERA, pose, azimuth, dip_deg)
    wanted = np.interp(np.arange(240), x, y)
    assert np.abs(view.skyline_row_px - wanted).max() < 0.05


@pytest.mark.parametrize("pose", [Pose(0.0, 8.0), Pose(12.0, 5.0, 7.0), Pose(-9.0, 10.0, -5.0)])
@pytest.mark.parametrize("k1", [0.0, -0.12])
def test_a_cone_stands_where_its_closed_form_puts_it(pose, k1):
    camera = replace(CAMERA, k1=k1)
    terrain = cone()
    distance_m, eye_m = 4000.0, 2.0
    longitude, latitude = terrain.position_of(400, 400 + distance_m / 20.0)
    view = render_view(terrain, Observer(longitude, latitude, eye_m), camera, pose, SceneOptions(range_m=9_000.0))
    along = np.linspace(10.0, 8_000.0, 3000)
    azimuth = np.linspace(-60, 60, 2401)
    turn = np.radians(azimuth)[:, None]
    to_apex = np.sqrt(along**2 + distance_m**2 - 2 * along * distance_m * np.cos(turn))
    height = np.maximum(1500.0 - 0.6 * to_apex, 0.0)
    horizon = ((height - eye_m - apparent_drop_m(along)) / along).max(axis=1)
    x, y = project(camera, pose, azimuth, np.degrees(np.arctan(horizon)))
    wanted = np.interp(np.arange(240), x, y)
    seen = np.isfinite(view.skyline_row_px)
    assert seen.mean() > 0.9
    difference = np.abs(view.skyline_row_px - wanted)[seen]
    assert np.median(difference) < 0.05
    assert difference.max() < 0.6  # at the apex, which 20 m cells cut off


def test_the_skyline_agrees_with_the_horizon_engine():
    scene = mountain_scene(2)
    profile = horizon_profile(
        scene.terrain, scene.observer, HorizonOptions(max_distance_m=80_000.0, azimuth_step_deg=0.02)
    )
    azimuth = np.append(profile.azimuth_deg, 360.0)
    elevation = np.append(profile.elevation_deg, profile.elevation_deg[0])
    offset = (azimuth - scene.pose.heading_deg + 180) % 360 - 180
    order = np.argsort(offset)
    x, y = project(scene.camera, scene.pose, azimuth[order], elevation[order])
    ahead = np.isfinite(x) & (np.abs(offset[order]) < 60)
    wanted = np.interp(np.arange(scene.camera.width_px), x[ahead], y[ahead])
    error = np.abs(scene.view.skyline_row_px - wanted)
    assert np.nanmedian(error) < 0.2
    assert np.nanpercentile(error, 95) < 1.0


def test_every_pixel_knows_the_ground_that_it_shows():
    scene = mountain_scene(1)
    view = scene.view
    solid = np.isfinite(view.distance_m)
    assert 0.2 < solid.mean() < 0.98
    rows, cols = np.nonzero(solid)
    east, north = view.east_m[solid].astype(float), view.north_m[solid].astype(float)
    distance = np.hypot(east, north)
    np.testing.assert_allclose(distance, view.distance_m[solid], rtol=1e-5)
    rise = view.elevation_m[solid] - apparent_drop_m(distance) - view.eye_elevation_m
    azimuth, elevation = np.degrees(np.arctan2(east, north)), np.degrees(np.arctan2(rise, distance))
    x, y = project(scene.camera, scene.pose, azimuth, elevation)
    far = distance > 30.0  # float32 elevations are good to 0.1 mm: an angle at arm's length
    assert np.abs(x - cols)[far].max() < 0.05
    assert np.abs(y - rows)[far].max() < 0.05
    col, row = view.frame.to_pixel(view.east_m.astype(float), view.north_m.astype(float))
    surface = bilinear(scene.terrain.elevation_m, row[solid], col[solid])
    across = np.abs(surface - view.elevation_m[solid]) / (distance / scene.camera.focal_px)
    assert np.median(across) < 0.3
    assert np.percentile(across, 95) < 1.5


def test_sky_has_no_ground_and_lies_above_the_skyline():
    view = mountain_scene(1).view
    sky = np.isinf(view.distance_m)
    assert np.isnan(view.elevation_m[sky]).all() and np.isnan(view.east_m[sky]).all()
    rows = np.arange(sky.shape[0])[:, None]
    agree = sky == (rows < view.skyline_row_px[None, :])
    assert agree[:, np.isfinite(view.skyline_row_px)].mean() > 0.999


def test_the_same_seed_gives_the_same_picture_and_another_one_another():
    terrain = small_mountains()
    observer, pose = Observer(*terrain.position_of(128, 128), eye_height_m=300.0), Pose(40.0, 3.0)
    first = render_view(terrain, observer, CAMERA, pose, hard_scene(3))
    again = render_view(terrain, observer, CAMERA, pose, hard_scene(3))
    other = render_view(terrain, observer, CAMERA, pose, hard_scene(4))
    assert np.array_equal(first.pixels, again.pixels)
    assert not np.array_equal(first.pixels, other.pixels)
    np.testing.assert_array_equal(first.skyline_row_px, other.skyline_row_px)  # weather moves no mountain


def test_sky_is_brighter_and_bluer_than_the_ground_on_a_clear_day():
    view = mountain_scene(1).view
    sky = np.isinf(view.distance_m)
    assert view.pixels[sky].mean() > view.pixels[~sky].mean() + 20
    blueness = view.pixels[..., 2].astype(float) - view.pixels[..., 0]
    assert blueness[sky].mean() > blueness[~sky].mean() + 10


@pytest.mark.parametrize("clouds, foreground", [("lid", "none"), ("none", "trees"), ("none", "people")])
def test_what_hides_the_ridge_is_told(clouds, foreground):
    terrain = small_mountains()
    scene = mountain_scene(1)
    weather = SceneOptions(5, clouds=clouds, foreground=foreground, cloud_share=0.5, foreground_share=0.6)
    view = render_view(terrain, scene.observer, scene.camera, scene.pose, weather)
    np.testing.assert_array_equal(view.skyline_row_px, scene.view.skyline_row_px)
    assert view.hidden.mean() > 0.02
    changed = np.abs(view.pixels.astype(int) - scene.view.pixels).mean(axis=-1)
    assert changed[view.hidden].mean() > 2 * changed[~view.hidden].mean() or clouds == "lid"
    if clouds == "lid":
        assert 0.1 < 1 - view.skyline_visible.mean() < 0.9


def test_fog_hides_the_whole_ridge_and_clear_air_none():
    scene = mountain_scene(1)
    fog = render_view(scene.terrain, scene.observer, scene.camera, scene.pose, SceneOptions(1, clouds="fog"))
    assert not fog.skyline_visible.any()
    assert scene.view.skyline_visible[np.isfinite(scene.view.skyline_row_px)].all()


def test_haze_takes_contrast_from_far_ground():
    scene = mountain_scene(1)
    far = (scene.view.distance_m > 5_000) & np.isfinite(scene.view.distance_m)
    hazy = render_view(scene.terrain, scene.observer, scene.camera, scene.pose, SceneOptions(1, visibility_m=15_000.0))
    assert hazy.pixels[far].std() < 0.7 * scene.view.pixels[far].std()


def test_an_eye_inside_the_hill_is_lifted_out():
    terrain = small_mountains()
    longitude, latitude = terrain.position_of(128, 128)
    buried = render_view(terrain, Observer(longitude, latitude, 1.7, eye_elevation_m=-500.0), CAMERA, Pose(0.0, 20.0))
    ground = float(bilinear(terrain.elevation_m, 128, 128))
    assert buried.eye_elevation_m == pytest.approx(ground + 0.5, abs=0.01)


def test_voids_and_the_edge_of_the_terrain_are_sky():
    elevation = np.full((200, 200), 100.0, np.float32)
    elevation[:90] = np.nan  # all the north, from 1 km on
    view = render_view(ArrayTerrain(elevation, 100.0), Observer(0, 0, 50.0), CAMERA, Pose(0.0, 0.0))
    assert np.nanmax(view.north_m) < 1_100.0
    assert np.isinf(view.distance_m[0]).all()


def test_a_lake_is_flat_and_mirrors_the_sky():
    elevation = np.full((200, 200), 400.0, np.float32)
    terrain, observer = ArrayTerrain(elevation, 50.0), Observer(0, 0, 30.0)
    dry = render_view(terrain, observer, CAMERA, Pose(0.0, -5.0), SceneOptions(2, snow_line_m=9e3, tree_line_m=0.0))
    options = SceneOptions(2, snow_line_m=9e3, tree_line_m=0.0, lake_elevation_m=400.0)
    wet = render_view(terrain, observer, CAMERA, Pose(0.0, -5.0), options)
    far = np.isfinite(wet.distance_m) & (wet.distance_m > 1_000)
    blueness = [v.pixels[far][:, 2].astype(float).mean() - v.pixels[far][:, 0].mean() for v in (wet, dry)]
    assert blueness[0] > blueness[1] + 5


def test_a_position_outside_the_terrain_is_told():
    with pytest.raises(ObserverOutsideDemError):
        render_view(small_mountains(), Observer(120.0, 0.0), CAMERA, Pose(0.0))


def test_a_user_can_stop_it():
    class Impatient:
        def report(self, fraction):
            pass

        def cancelled(self):
            return True

    terrain = small_mountains()
    with pytest.raises(Cancelled):
        render_view(terrain, Observer(*terrain.position_of(128, 128)), CAMERA, Pose(0.0), SceneOptions(), Impatient())
