from dataclasses import replace

import numpy as np
import pytest
from skyline_viewshed.core.base.uncertainty import Z_90
from skyline_viewshed.core.match.finding import heading_sigma_deg, pose_uncertainty, relief_px
from skyline_viewshed.core.match.robust import find_answers, match_robust

TRIAL = np.array([[97.3, 6.0, 1.0, 0.0, 0.0]])


@pytest.fixture(scope="module")
def scene(match_scenes):
    return match_scenes.scene(4, 97.3, pitch_deg=6.0, roll_deg=1.0)


@pytest.fixture(scope="module")
def fitted(scene):
    return scene.objective(0.02)


@pytest.fixture(scope="module")
def narrow(match_scenes):
    return match_scenes.scene(4, 97.3, hfov_deg=20.0)


@pytest.fixture(scope="module")
def answers(narrow):
    return find_answers(narrow.inputs())


def sigma(objective, scale=1.0, position_error_m=0.0, floor_deg=0.0):
    return float(heading_sigma_deg(objective, TRIAL, np.array([scale]), position_error_m, floor_deg)[0])


def test_a_heading_is_less_sure_the_wider_the_tolerance_at_which_it_fits(fitted):
    spreads = [sigma(fitted, scale) for scale in (0.35, 0.7, 1.5, 3.0)]
    assert np.all(np.diff(spreads) > 0)
    assert spreads[-1] > 2 * spreads[0]


def test_position_error_and_floor_add_in_squares(scene, fitted):
    assert sigma(fitted, floor_deg=0.3) == pytest.approx(np.hypot(sigma(fitted), 0.3))
    horizon = replace(scene.horizon, distance_m=np.full(scene.horizon.distance_m.shape, 2000.0))
    near = replace(scene, horizon=horizon).objective(0.02)
    moved, still = sigma(near, position_error_m=35.0), sigma(near)
    assert np.sqrt(moved**2 - still**2) == pytest.approx(np.degrees(35.0 / 2000.0), rel=1e-3)


def test_relief_is_measured_about_a_straight_line():
    columns = np.arange(200)
    tilted = 30 + 0.4 * columns
    assert relief_px(columns, tilted) == pytest.approx(0.0, abs=1e-9)
    assert relief_px(columns, tilted + 5 * np.sin(columns / 3)) == pytest.approx(5 / np.sqrt(2), rel=0.02)
    assert relief_px(columns[:10], tilted[:10]) == 0.0


def test_a_finding_speaks_of_the_best_answer_and_answers_can_be_put_in_another_order(answers):
    finding = answers.finding
    assert finding.heading_deg[0] == answers.trials[0, 0] == pytest.approx(97.3, abs=0.3)
    assert finding.explained > 0.9 and finding.residual_px < 1 and finding.sureness > 0.8
    assert finding.gap == finding.score[0] - finding.score[1] > 0
    last = answers.reordered(np.arange(len(answers.trials))[::-1])
    assert last.finding.heading_deg.tolist() == finding.heading_deg[::-1].tolist()
    assert last.finding.score.tolist() == finding.score[::-1].tolist()
    assert last.finding.explained < finding.explained and last.finding.residual_px > finding.residual_px


def test_pitch_roll_and_focal_length_have_their_own_uncertainty(scene, fitted):
    tight, loose = (pose_uncertainty(fitted, TRIAL[0], scale, 0.0) for scale in (0.35, 3.0))
    for name in ("pitch_deg", "roll_deg", "focal_relative"):
        assert 0 < getattr(tight, name) < getattr(loose, name), name
    floor = pose_uncertainty(fitted, TRIAL[0], 0.35, 0.3)
    assert floor.pitch_deg == pytest.approx(np.hypot(tight.pitch_deg, 0.3))
    assert floor.focal_relative == tight.focal_relative < 0.02  # the prior's, which the picture narrows
    horizon = replace(scene.horizon, distance_m=np.full(scene.horizon.distance_m.shape, 2000.0))
    still = replace(scene, horizon=horizon).objective(0.02)
    moved = replace(scene, horizon=horizon).objective(0.02)
    moved.position_error_m = 35.0
    wider, narrower = (pose_uncertainty(objective, TRIAL[0], 1.0, 0.0).pitch_deg for objective in (moved, still))
    assert np.sqrt(wider**2 - narrower**2) == pytest.approx(np.degrees(0.5 * 35.0 / 2000.0), rel=1e-3)


@pytest.mark.parametrize("seed", range(3))
def test_the_intervals_hold_the_truth_of_simulated_photographs(match_scenes, seed):
    rng = np.random.default_rng(seed)
    scale = rng.uniform(0.98, 1.02)
    scene = match_scenes.scene(seed, rng.uniform(0, 360), rng.uniform(-3, 8), rng.uniform(-6, 6), focal_scale=scale)
    found = match_robust(scene.inputs())
    spread, pose = found.uncertainty, found.best.pose
    assert abs(pose.pitch_deg - scene.pose.pitch_deg) < Z_90 * spread.pitch_deg < 2
    assert abs(pose.roll_deg - scene.pose.roll_deg) < Z_90 * spread.roll_deg < 3
    assert 0 < spread.focal_relative < 0.026
