from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.camera import Camera, Pose, focal_of_fov_px
from skyline_viewshed.core.base.posed import PosedPhoto
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer
from skyline_viewshed.core.base.view import open_view
from skyline_viewshed.core.mapping.projecting import (
    Places,
    PlaceState,
    densify,
    project_line,
    project_places,
    sample_area,
)
from skyline_viewshed.core.mapping.sightline import SightOptions
from skyline_viewshed.core.viewshed.viewshed import PhotoFrame, ViewshedOptions, viewshed
from skyline_viewshed.demo.mountains import MountainOptions, make_mountains

CAMERA = Camera(600, 400, 500.0)


def stepped():
    """A plane at 0 m with a wall 40 m high, 300 m north of the middle."""
    z = np.zeros((401, 401), np.float32)
    z[169:172] = 40.0
    return ArrayTerrain(z, 10.0)


def looking_north(terrain, eye_m=20.0, pitch_deg=0.0):
    return open_view(terrain, PosedPhoto(CAMERA, Pose(0.0, pitch_deg), Observer(0, 0, eye_m)), 2500.0)


def test_places_before_on_and_behind_a_wall_and_beside_the_frame():
    terrain = stepped()
    view = looking_north(terrain)
    north = np.array([150.0, 290.0, 600.0, 0.0, -300.0])
    east = np.array([0.0, 0.0, 0.0, 500.0, 0.0])
    shown = project_places(terrain, view, Places(east, north))
    assert shown.state.tolist() == [
        PlaceState.VISIBLE,
        PlaceState.VISIBLE,
        PlaceState.HIDDEN,
        PlaceState.OUTSIDE,
        PlaceState.OUTSIDE,
    ]
    assert shown.x_px[0] == pytest.approx(CAMERA.centre_px[0])
    assert shown.y_px[0] == pytest.approx(CAMERA.centre_px[1] + 500 * 20 / 150, rel=1e-3)
    assert np.isfinite(shown.x_px[2]) and np.isnan(shown.x_px[4])
    assert shown.elevation_m.tolist() == [0, 40, 0, 0, 0]


def test_a_tower_behind_the_wall_is_seen_when_it_is_high_enough():
    terrain = stepped()
    view = looking_north(terrain)
    # The line of sight over the wall's near crest (290 m, 40 m) stands at 20 + 600 * 20 / 290 = 61 m at 600 m.
    shown = project_places(terrain, view, Places(np.zeros(2), np.full(2, 600.0), height_above_m=np.array([55.0, 70.0])))
    assert shown.state.tolist() == [PlaceState.HIDDEN, PlaceState.VISIBLE]


def test_all_round_asks_behind_the_camera_too():
    terrain = stepped()
    shown = project_places(
        terrain, looking_north(terrain), Places(np.zeros(2), np.array([-500.0, 600.0])), all_round=True
    )
    assert shown.state.tolist() == [PlaceState.VISIBLE, PlaceState.HIDDEN]
    assert shown.azimuth_deg[0] == pytest.approx(180)


def test_places_off_the_dem_in_voids_or_out_of_range_are_not_claimed():
    terrain = stepped()
    z = terrain.elevation_m.copy()
    z[185:187] = np.nan  # a void 140 to 150 m north...
    z[184] = 2.1  # ...that may be as high as its rim, just above the line of sight to the place behind
    terrain = ArrayTerrain(z, 10.0)
    view = looking_north(terrain, eye_m=5.0)
    shown = project_places(
        terrain, view, Places(np.zeros(4), np.array([145.0, 250.0, 100.0, 2300.0])), SightOptions(max_distance_m=2000.0)
    )
    assert shown.state.tolist() == [PlaceState.UNKNOWN, PlaceState.UNKNOWN, PlaceState.VISIBLE, PlaceState.OUTSIDE]
    beyond = project_places(terrain, view, Places(np.zeros(1), np.array([2300.0])))
    assert beyond.state[0] == PlaceState.UNKNOWN


def test_a_published_height_above_or_below_the_dem_does_not_hide_a_summit():
    row, col = np.mgrid[:201, :201]
    cone = np.maximum(500 - 0.5 * np.hypot((row - 60) * 10, (col - 100) * 10), 0).astype(np.float32)
    terrain = ArrayTerrain(cone, 10.0)
    view = looking_north(terrain, 10.0, 20.0)
    shown = project_places(terrain, view, Places(np.zeros(3), np.full(3, 400.0), np.array([540.0, 500.0, 440.0])))
    assert shown.state.tolist() == [PlaceState.VISIBLE] * 3
    assert np.diff(shown.y_px).min() > 0


def test_points_and_viewshed_give_one_answer():
    terrain = make_mountains(5, MountainOptions(size=256))
    row, col = np.unravel_index(np.argmax(terrain.elevation_m[64:192, 64:192]), (128, 128))
    observer = Observer(*terrain.position_of(64.3 + col, 64.6 + row), 30.0)
    camera = Camera(800, 600, focal_of_fov_px(800, 90))
    random = np.random.default_rng(0)
    seen, agree = 0, []
    for heading in (0.0, 90.0, 180.0, 270.0):
        pose = Pose(heading, -15.0, 2.0)
        ground = viewshed(terrain, observer, PhotoFrame(camera, pose), ViewshedOptions(max_distance_m=6000.0))
        row, col = (random.integers(0, side, 2000) for side in ground.values.shape)
        view = open_view(terrain, PosedPhoto(camera, pose, observer), 6000.0)
        east, north = view.frame.to_local(col + ground.window.col, row + ground.window.row)
        far = np.hypot(east, north) > 10 * terrain.cell_m
        shown = project_places(terrain, view, Places(east[far], north[far]), SightOptions(max_distance_m=6000.0))
        viewshed_says = ground.visible[row, col][far]
        seen += viewshed_says.sum()
        agree.append(shown.visible == viewshed_says)
    assert seen > 100
    # They interpolate between cells differently, so that they may differ on crests and grazing slopes.
    assert np.concatenate(agree).mean() > 0.985


def test_a_line_is_cut_where_it_goes_behind_and_out_of_frame():
    terrain = stepped()
    view = looking_north(terrain)
    runs = project_line(terrain, view, Places(np.array([0.0, 0.0]), np.array([-100.0, 900.0])))
    states = [run.state for run in runs]
    assert states[0] == PlaceState.OUTSIDE and PlaceState.VISIBLE in states and states[-1] == PlaceState.HIDDEN
    shares = [run.share for run in runs]
    assert shares[0][0] == 0 and shares[-1][1] == 1
    assert all(a[1] == b[0] for a, b in zip(shares[:-1], shares[1:]))
    hidden = next(run for run in runs if run.state == PlaceState.HIDDEN)
    assert hidden.share[0] == pytest.approx(0.4, abs=0.02)  # the wall stands at 300 of -100 to 900 m
    assert np.median(np.hypot(np.diff(hidden.x_px), np.diff(hidden.y_px))) < 2


def test_densify_keeps_vertices_and_steps_finely_across_the_view():
    view = looking_north(stepped())
    east, north, height, share = densify([-200.0, 200.0], [1000.0, 1000.0], view, 2.0, [5.0, 9.0])
    assert (east[0], east[-1], height[0], height[-1]) == (-200, 200, 5, 9)
    x, _ = view.pixel_of(east, north, np.zeros(east.size))
    assert 0 < np.diff(x).max() <= 2.01
    assert share[0] == 0 and share[-1] == 1 and (np.diff(share) > 0).all()
    assert densify([1.0], [2.0], view)[0].tolist() == [1.0]


def test_an_area_is_sampled_inside_and_not_in_its_hole():
    ring = np.array([0, 100, 100, 0.0]), np.array([0, 0, 100, 100.0])
    hole = np.array([40, 60, 60, 40.0]), np.array([40, 40, 60, 60.0])
    east, north = sample_area([ring, hole], 5.0)
    assert east.size == pytest.approx((100**2 - 20**2) / 25, rel=0.02)
    assert not ((east > 40) & (east < 60) & (north > 40) & (north < 60)).any()
    assert sample_area([ring], 1e-4)[0].size < 60_000
