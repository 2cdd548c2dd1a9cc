import numpy as np
import pytest
from reference.landscapes import fractal, stand
from reference.sight_lines import bilinear_at, crossings, tangent
from skyline_viewshed.core.base.camera import Camera, Pose, focal_of_fov_px, in_frame
from skyline_viewshed.core.base.posed import PosedPhoto
from skyline_viewshed.core.horizon.horizon import HorizonOptions, horizon_profile
from skyline_viewshed.core.viewshed.layers import clearance, layers, terrain_share
from skyline_viewshed.core.viewshed.viewshed import PhotoFrame, ViewshedOptions, Wedge, viewshed

CAMERA, POSE = Camera(400, 300, focal_of_fov_px(400, 60.0)), Pose(30.0, -5.0, 2.0)


@pytest.fixture(scope="module")
def scene():
    return stand(fractal(101, seed=7), 30.0, 50, 50, 40.0)


def test_clearance_is_positive_where_the_cell_is_seen_and_negative_elsewhere(scene):
    above = clearance(*scene).values
    seen = viewshed(*scene).values
    seen[50, 50] = 0
    assert np.array_equal(above > 0, seen == 1)


def test_clearance_is_the_height_over_the_exact_line_of_sight(scene):
    terrain, _ = scene
    ground, result = terrain.elevation_m, clearance(*scene)
    differences = []
    for row, col in np.random.default_rng(0).integers(0, 101, (300, 2)):
        span = np.hypot(row - 50, col - 50)
        if span < 3:
            continue
        way = [share for share in crossings(50, 50, row, col) if share * max(abs(row - 50), abs(col - 50)) >= 1]
        limit = max(
            tangent(
                bilinear_at(ground, 50 + (row - 50) * s, 50 + (col - 50) * s),
                result.eye_elevation_m, 30.0, s * span * 30.0, 0.87 / (2 * 6_371_000),
            )
            for s in way
        )  # fmt: skip
        mine = tangent(float(ground[row, col]), result.eye_elevation_m, 30.0, span * 30.0, 0.87 / (2 * 6_371_000))
        differences.append(result.values[row, col] - (mine - limit) * span * 30.0)
    assert np.median(np.abs(differences)) < 0.5
    assert np.percentile(np.abs(differences), 90) < 8


def test_raising_the_target_by_the_missing_height_makes_it_seen(scene):
    terrain, observer = scene
    below = clearance(terrain, observer).values
    row, col = np.unravel_index(np.nanargmin(np.where(below < -1, np.abs(below + 30), np.inf)), below.shape)
    missing = -float(below[row, col])
    hidden = viewshed(terrain, observer, options=ViewshedOptions(target_height_m=missing * 0.99))
    shown = viewshed(terrain, observer, options=ViewshedOptions(target_height_m=missing * 1.01))
    assert hidden.values[row, col] == 0
    assert shown.values[row, col] == 1


def test_layers_give_true_distance_bearing_angle_and_pixel(scene):
    terrain, observer = scene
    seen = viewshed(terrain, observer, PhotoFrame(CAMERA, POSE))
    strips = list(layers(terrain, seen, PosedPhoto(CAMERA, POSE, observer)))
    values = {name: np.concatenate([strip[name] for _, strip in strips]) for name in strips[0][1]}
    assert values["distance_m"].shape == seen.values.shape
    row, col = np.nonzero(seen.visible)
    down, right = row + seen.window.row - 50, col + seen.window.col - 50
    assert np.allclose(values["distance_m"][row, col], np.hypot(down, right) * 30.0, atol=0.01)
    expected = np.degrees(np.arctan2(right, -down)) % 360
    assert np.allclose((values["azimuth_deg"][row, col] - expected + 180) % 360, 180, atol=1e-3)
    assert in_frame(CAMERA, values["column_px"][row, col], values["row_px"][row, col]).all()
    assert (np.abs(values["elevation_deg"][row, col]) < 60).all()


def test_voids_have_no_layers():
    ground = fractal(61, seed=1)
    ground[10:12, 20:24] = np.nan
    terrain, observer = stand(ground, 30.0, 30, 30, 40.0)
    seen = viewshed(terrain, observer, Wedge(0.0, 360.0))
    (_, values), *_ = layers(terrain, seen)
    assert np.isnan(values["distance_m"][10:12, 20:24]).all()
    assert np.isnan(clearance(terrain, observer).values[10:12, 20:24]).all()


def test_half_of_a_level_frame_over_a_plane_is_terrain():
    terrain, observer = stand(np.zeros((201, 201)), 100.0, 100, 100, 2.0)
    profile = horizon_profile(terrain, observer, HorizonOptions(max_distance_m=9_000.0))
    ground, unknown = terrain_share(CAMERA, Pose(77.0), profile)
    assert ground == pytest.approx(0.5, abs=0.02)
    assert unknown == 0.0
    cut = horizon_profile(terrain, observer, HorizonOptions(max_distance_m=50_000.0, summit_m=1000.0))
    assert terrain_share(CAMERA, Pose(77.0), cut)[1] == pytest.approx(0.5, abs=0.02)
