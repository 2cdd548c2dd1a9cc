from dataclasses import replace

import numpy as np
import pytest
from skyline_viewshed.core.base.camera import Camera, Pose, project
from skyline_viewshed.core.horizon.ridges import RidgeEdges
from skyline_viewshed.core.match.ridges import RidgeEvidence, RidgeMatchOptions, crest_share, local_rank

CAMERA = Camera(256, 192, 250.0)


def crests():
    azimuth = np.arange(0, 360, 0.25)
    elevation = 2 + 1.5 * np.sin(np.radians(9 * azimuth)) + np.cos(np.radians(23 * azimuth))
    return RidgeEdges(azimuth, elevation, np.full(azimuth.shape, 8000.0), np.full(azimuth.shape, 2.0))


def picture(pose, seed=0):
    """Noise, and a brighter line where the crests are."""
    edges = crests()
    strength = np.random.default_rng(seed).random((192, 256)).astype(np.float32)
    x, y = project(CAMERA, pose, edges.azimuth_deg, edges.elevation_deg)
    seen = np.isfinite(x) & (x >= 0) & (x < 255) & (y >= 0) & (y < 191)
    strength[np.rint(y[seen]).astype(int), np.rint(x[seen]).astype(int)] += 2
    return strength


def test_the_right_pose_scores_above_wrong_ones_and_above_nothing():
    pose = Pose(40.0, 3.0, 1.0)
    evidence = RidgeEvidence(picture(pose), crests(), 90.0)
    headings = np.array([40.0, 47.0, 120.0, 300.0])
    trials = np.column_stack([headings, np.full(4, 3.0), np.full(4, 1.0), np.zeros((4, 2))])
    scores = evidence.score(CAMERA, trials, np.zeros((4, 256)))
    assert scores[0] > 0.1
    assert scores[1:].max() < scores[0] - 0.1


def test_crests_above_or_near_the_horizon_do_not_count():
    evidence = RidgeEvidence(picture(Pose(40.0, 3.0)), crests(), 90.0)
    trial = np.array([[40.0, 3.0, 0.0, 0.0, 0.0]])
    assert evidence.score(CAMERA, trial, np.full((1, 256), 191.0)) == 0


def test_the_field_of_view_may_lie_across_north():
    pose = Pose(359.0, 3.0)
    evidence = RidgeEvidence(picture(pose), crests(), 90.0)
    trial = np.array([[359.0, 3.0, 0.0, 0.0, 0.0]])
    assert evidence.score(CAMERA, trial, np.zeros((1, 256)))[0] > 0.1


def test_ranks_of_noise_are_uniform_and_those_of_a_line_are_high():
    noise = np.random.default_rng(1).random((400, 50))
    rank = local_rank(noise, 3, 20)
    assert abs(rank[30:-30].mean() - 0.5) < 0.02
    noise[200] = 5
    assert local_rank(noise, 3, 20)[200].min() > 0.95


def test_a_weight_of_zero_switches_crests_off():
    options = RidgeMatchOptions(weight=0.0)
    evidence = RidgeEvidence(picture(Pose(40.0, 3.0)), crests(), 90.0, options=options)
    assert evidence.score(CAMERA, np.array([[40.0, 3.0, 0.0, 0.0, 0.0]]), np.zeros((1, 256)))[0] == 0


def test_the_share_counts_columns_with_two_lines(plain_before_range):
    scene, evidence, crests = plain_before_range.scene, plain_before_range.evidence, plain_before_range.crests
    objective, pose = scene.objective(), scene.pose
    trial = np.array([pose.heading_deg, pose.pitch_deg, pose.roll_deg, 0.0, 0.0])
    assert crest_share(objective, trial, evidence, crests()) == 1.0
    assert crest_share(objective, trial, evidence, crests(-6.0)) == 0.0
    half = crests(azimuth_deg=np.arange(200.0, 260.0, 0.1))
    assert crest_share(objective, trial, evidence, half) == pytest.approx(0.5, abs=0.05)
    assert crest_share(objective, trial, replace(evidence, rival=evidence), crests()) == 0.0
