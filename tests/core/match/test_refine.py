from dataclasses import replace

import numpy as np
import pytest
from skyline_viewshed.core.match.refine import RefineOptions, refine


def test_a_start_two_degrees_off_reaches_the_pose(match_scenes):
    scene = match_scenes.scene(6, 200.0, 2.0, 3.0, focal_scale=1.02)
    objective = scene.objective(options=RefineOptions(iterations=12))
    trials = np.array([[201.5, 3.0, 0.0, 0.0, 0.0]])
    for scale in (3.0, 1.0):
        trials, _ = refine(objective, trials, scale)
    heading, pitch, roll, log_focal, _ = trials[0]
    assert abs(heading - 200.0) < 0.05
    assert abs(pitch - 2.0) < 0.1
    assert abs(roll - 3.0) < 0.3
    assert abs(np.exp(log_focal) - 1.02) < 0.01


def test_no_step_lowers_the_score(match_scenes):
    objective = match_scenes.scene(7).objective()
    rng = np.random.default_rng(0)
    starts = np.column_stack([rng.uniform(0, 360, 20), rng.uniform(-5, 10, 20), *np.zeros((3, 20))])
    before = objective.score(starts, 3.0, 4)
    _, after = refine(objective, starts, 3.0, stride=4)
    assert (after >= before - 1e-12).all()


@pytest.mark.parametrize("roll_deg", [2.0, -13.0])
def test_the_gradient_is_that_of_the_penalties_where_there_is_no_evidence(match_scenes, roll_deg):
    objective = match_scenes.scene(8).objective()
    trial = np.array([[10.0, 70.0, roll_deg, 0.01, 0.0]])  # looks into the sky: the horizon is out of the frame
    _, gradient, _ = objective.expand(trial, 1.0, 4)
    step = 1e-5
    for parameter in (2, 3):
        up, down = trial.copy(), trial.copy()
        up[0, parameter] += step
        down[0, parameter] -= step
        slope = (objective.score(up, 1.0, 4) - objective.score(down, 1.0, 4)) / (2 * step)
        assert gradient[0, parameter] == pytest.approx(slope[0], rel=1e-3, abs=1e-6)


def test_far_terrain_is_held_to_a_tighter_tolerance_than_near(match_scenes):
    scene = match_scenes.scene(9)
    distance = np.where(scene.horizon.azimuth_deg < 123, 800.0, 40_000.0)
    objective = replace(scene, horizon=replace(scene.horizon, distance_m=distance)).objective()
    _, tolerance = objective.rows(np.array([[123.4, 3.0, 0.0, 0.0, 0.0]]), np.arange(256))
    options, focal = RefineOptions(), objective.camera.focal_px
    for column, distance_m in ((10, 800.0), (245, 40_000.0)):
        terrain = options.terrain_error_cells * scene.horizon.cell_m / distance_m * focal
        assert tolerance[0, column] == pytest.approx(np.hypot(options.pixel_error_px, terrain))


@pytest.mark.parametrize("scale", [1.0, 0.05])
def test_no_fit_is_finer_than_the_eyes_place_allows(match_scenes, scale):
    """The eye 20 m off sees a crest 800 m away, on ground that rises by half, 10 / 800 radians higher or lower."""
    scene = match_scenes.scene(9)
    scene = replace(scene, horizon=replace(scene.horizon, distance_m=np.full(scene.horizon.azimuth_deg.shape, 800.0)))
    trial, columns = np.array([[123.4, 3.0, 0.0, 0.0, 0.0]]), np.arange(256)
    still = scene.objective()
    moved = scene.objective(options=RefineOptions(ground_slope=0.5), position_error_m=20.0)
    _, certain = still.rows(trial, columns, scale)
    _, uncertain = moved.rows(trial, columns, scale)
    assert uncertain == pytest.approx(np.hypot(certain, 10 / 800 * moved.camera.focal_px))
    assert uncertain.min() >= 10 / 800 * moved.camera.focal_px


@pytest.mark.parametrize("wrong", [{"ground_slope": -0.1}, {"ground_slope": float("nan")}, {"pixel_error_px": 0.0}])
def test_weights_that_make_no_sense_are_refused(wrong):
    with pytest.raises(ValueError):
        RefineOptions(**wrong)
