from dataclasses import replace

import numpy as np
import pytest
from reference.landscapes import fractal, stand
from skyline_viewshed.core.base.camera import Camera, Pose, focal_of_fov_px
from skyline_viewshed.core.base.posed import PosedPhoto
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer
from skyline_viewshed.core.base.uncertainty import PoseUncertainty
from skyline_viewshed.core.viewshed.probability import SampleOptions, visibility_probability
from skyline_viewshed.core.viewshed.viewshed import PhotoFrame, ViewshedOptions, viewshed

CAMERA, POSE = Camera(400, 300, focal_of_fov_px(400, 60.0)), Pose(30.0, -5.0, 2.0)
EXACT = PoseUncertainty(0, 0, 0, 0, 0, 0, 0)
ONE, MANY = SampleOptions(frames=1), SampleOptions(frames=200)


@pytest.fixture(scope="module")
def scene():
    return stand(fractal(101, seed=7), 30.0, 50, 50, 60.0)


def shown(scene, error=None, sampling=None, camera=CAMERA, pose=POSE, options=None):
    """Probability that a photograph shows each cell of a (terrain, observer)."""
    terrain, observer = scene
    photo = PosedPhoto(camera, pose, observer, error or PoseUncertainty())
    return visibility_probability(terrain, photo, options or ViewshedOptions(), sampling or SampleOptions())


def spread(result, shape=(101, 101)):
    values, window = np.zeros(shape, np.float32), result.window
    values[window.row : window.row + window.rows, window.col : window.col + window.cols] = result.values
    return values


def test_without_any_error_it_is_the_viewshed_of_the_frame(scene):
    probability = spread(shown(scene, EXACT, ONE))
    seen = spread(viewshed(*scene, PhotoFrame(CAMERA, POSE)))
    assert set(np.unique(probability)) <= {0.0, 1.0}
    assert ((probability == 1) != (seen == 1)).sum() <= 3  # cells on the frame's very edge


def test_it_lies_between_never_and_always_and_the_middle_is_surer_than_the_edge(scene):
    result = shown(scene, PoseUncertainty(heading_deg=3.0, dem_m=1.0))
    assert ((result.values >= 0) & (result.values <= 1)).all()
    seen = spread(viewshed(*scene, PhotoFrame(CAMERA, POSE))) == 1
    probability = spread(result)
    assert probability[seen].mean() > 0.7
    assert probability[~seen].mean() < 0.1
    assert result.share(0.9) < result.share(0.5) < 1
    assert 0 < result.area_m2(0.9) < result.area_m2(0.5)


def test_half_the_samples_have_a_direction_on_the_edge_of_the_frame():
    """A plane seen from high above: the cell on the frame's left edge is in or out by the heading's sign alone."""
    terrain, observer = stand(np.zeros((201, 201)), 10.0, 100, 100, 300.0)
    camera, pose = Camera(4000, 3000, focal_of_fov_px(4000, 60.0)), Pose(0.0, -30.0)
    error = replace(EXACT, heading_deg=2.0)
    probability = spread(shown((terrain, observer), error, MANY, camera, pose), (201, 201))
    line = probability[60]
    left = np.flatnonzero(line > 0)[0]
    edge = np.interp(0.5, line[left : left + 30], np.arange(left, left + 30))
    # Where the frame's left edge (30 degrees off, tilted camera) meets the row 400 m away.
    exact = spread(viewshed(terrain, observer, PhotoFrame(camera, pose)), (201, 201))[60]
    assert edge == pytest.approx(np.flatnonzero(exact == 1)[0], abs=2)


def turned_about_the_middle(pitch_deg, roll_errors_deg, cell_m):
    """Camera, and each plane cell's place in the picture from its middle (x, y) [px] with its probabilities."""
    terrain, observer = stand(np.zeros((241, 241)), cell_m, 60, 120, 300.0)
    camera, pose = Camera(4000, 3000, focal_of_fov_px(4000, 60.0)), Pose(180.0, pitch_deg)
    found = [
        spread(shown((terrain, observer), error, MANY, camera, pose), (241, 241))
        for error in (replace(EXACT, roll_deg=sigma) for sigma in roll_errors_deg)
    ]
    south, east = cell_m * np.array(np.meshgrid(np.arange(241) - 60, np.arange(241) - 120, indexing="ij"))
    down = np.radians(-pitch_deg)
    depth = south * np.cos(down) + 300.0 * np.sin(down)
    below = 300.0 * np.cos(down) - south * np.sin(down)
    depth[depth <= 0] = np.nan
    return camera.focal_px * -east / depth, camera.focal_px * below / depth, found


def test_roll_error_leaves_the_picture_s_middle_and_makes_its_corners_unsure():
    x, y, (none, small, large) = turned_about_the_middle(-60.0, (0.0, 2.0, 12.0), 5.0)
    radius, corner = np.hypot(x, y), np.hypot(2000, 1500)
    near_corner = (radius > 0.9 * corner) & (np.abs(x) < 1900) & (np.abs(y) < 1450)
    assert near_corner.sum() > 20 and (radius < 1450).sum() > 200
    for probability in (none, small, large):
        assert (probability[radius < 1450] == 1).all(), "the circle that touches the frame turns within it"
        assert (probability[radius > corner + 50] == 0).all()
    assert (none[near_corner] == 1).all()
    assert 1 > small[near_corner].mean() > large[near_corner].mean() + 0.1


def test_a_large_roll_error_reaches_ground_beside_the_level_frame():
    x, y, (probability,) = turned_about_the_middle(0.0, (30.0,), 20.0)
    ring = (np.hypot(x, y) > 2050) & (np.hypot(x, y) < 2350)
    beside = ring & (np.abs(x) > 2010)
    assert beside.sum() > 50
    # By the normal distribution of the roll about every tenth turn brings such a cell into the frame.
    assert probability[beside].min() > 0.02 and probability[beside].max() < 0.7


def test_dem_error_makes_grazing_cells_uncertain_and_leaves_clear_ones(scene):
    a, b = (shown(scene, error, ONE) for error in (EXACT, replace(EXACT, dem_m=20.0)))
    between = (b.values > 0.05) & (b.values < 0.95)
    assert not ((a.values > 0.05) & (a.values < 0.95)).any()
    assert between.any()
    assert ((a.values == 1) & (b.values >= 0.5)).sum() == (a.values == 1).sum()


def test_position_error_averages_over_places(scene):
    result = shown(scene, replace(EXACT, position_m=60.0), ONE)
    levels = np.unique(np.rint(result.values * 1000) / 1000).astype(float).round(3)
    assert set(levels) <= {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}
    assert len(levels) > 3


def test_voids_stay_unknown():
    ground = fractal(101, seed=7)
    ground[20:25, 60:70] = np.nan
    terrain, observer = stand(ground, 30.0, 50, 50, 60.0)
    values = spread(shown((terrain, observer)))
    assert np.isnan(values[22, 65])
    assert np.isnan(values).sum() <= 50


def test_places_off_the_dem_are_left_out():
    terrain = ArrayTerrain(fractal(61, seed=2), 30.0)
    observer = Observer(*terrain.position_of(0.0, 30.0), 20.0)
    result = shown((terrain, observer), options=ViewshedOptions(max_distance_m=900.0))
    assert (result.values <= 1).all()


def test_a_frame_is_sampled_at_least_once():
    with pytest.raises(ValueError, match="one sample"):
        SampleOptions(frames=0)
