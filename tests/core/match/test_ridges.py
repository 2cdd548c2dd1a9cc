from dataclasses import replace

import numpy as np
import pytest
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.base.camera import Camera, Pose, project
from skyline_viewshed.core.horizon.inner import InnerTerrain
from skyline_viewshed.core.horizon.ridges import RidgeEdges
from skyline_viewshed.core.match import robust as matcher
from skyline_viewshed.core.match.ridges import RidgeEvidence, RidgeMatchOptions, crest_share, local_rank
from skyline_viewshed.core.match.robust import match_robust

CAMERA = Camera(256, 192, 250.0)
PLAIN_DEG = 0.5
"""Elevation of the edge of the plain; the horizon behind lies at 2 degrees and more."""


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


def edges_at(elevation_deg, azimuth_deg=None):
    azimuth = np.arange(0, 360, 0.1) if azimuth_deg is None else azimuth_deg
    same = np.ones(len(azimuth))
    return RidgeEdges(azimuth, elevation_deg * same, 2000.0 * same, 5.0 * same)


@pytest.fixture(scope="module")
def range_behind_a_plain(match_scenes):
    """A scene, and evidence whose striking line is the edge of a plain, with the range behind as its rival."""
    scene = match_scenes.scene(11, 200.0, 3.0, 1.0)
    plain = replace(scene.horizon, elevation_deg=np.full(len(scene.horizon.azimuth_deg), PLAIN_DEG))
    rows = match_scenes.seen_rows(plain, scene.small_camera, scene.pose)
    striking = match_scenes.evidence_of_rows(rows, 256, 192, (scene.camera.width_px, scene.camera.height_px))
    return scene, replace(striking, rival=scene.evidence)


def solve(scene, evidence, edges):
    return match_robust(replace(scene, evidence=evidence).inputs(inner=edges and InnerTerrain(edges, None)))


def away(found, scene):
    return abs(float(difference(found.best.pose.heading_deg, scene.pose.heading_deg)))


def test_the_range_behind_is_matched_where_the_dem_has_a_crest_on_the_striking_line(range_behind_a_plain):
    scene, evidence = range_behind_a_plain
    found = solve(scene, evidence, edges_at(PLAIN_DEG))
    assert found.behind and found.status == "accepted"
    assert away(found, scene) < 0.2
    assert np.nanmedian(np.abs(found.residual_px)) < 4, "the residuals are those to the line that was matched"
    assert any("near crest" in note for note in found.notes)


@pytest.mark.parametrize("elsewhere_deg", [-6.0, 1.9])
def test_it_is_not_where_the_dem_knows_no_such_crest(range_behind_a_plain, elsewhere_deg):
    scene, evidence = range_behind_a_plain
    found = solve(scene, evidence, edges_at(elsewhere_deg))
    assert not found.behind and found.status != "accepted"


def test_without_a_rival_or_terrain_there_is_one_look(range_behind_a_plain):
    scene, evidence = range_behind_a_plain
    for alone, edges in ((replace(evidence, rival=None), edges_at(PLAIN_DEG)), (evidence, None)):
        found = solve(scene, alone, edges)
        assert not found.behind and found.status != "accepted"


def test_an_accepted_answer_is_not_looked_behind(range_behind_a_plain, monkeypatch):
    scene, evidence = range_behind_a_plain
    looks, judged = [], matcher._judged
    monkeypatch.setattr(matcher, "_judged", lambda *given: looks.append(given[0]) or judged(*given))
    found = solve(scene, replace(scene.evidence, rival=replace(evidence, rival=None)), edges_at(PLAIN_DEG))
    assert found.status == "accepted" and not found.behind and len(looks) == 1


def test_the_share_counts_columns_with_two_lines(range_behind_a_plain):
    scene, evidence = range_behind_a_plain
    objective = scene.objective()
    trial = np.array([scene.pose.heading_deg, scene.pose.pitch_deg, scene.pose.roll_deg, 0.0, 0.0])
    assert crest_share(objective, trial, evidence, edges_at(PLAIN_DEG)) == 1.0
    assert crest_share(objective, trial, evidence, edges_at(-6.0)) == 0.0
    half = edges_at(PLAIN_DEG, np.arange(200.0, 260.0, 0.1))
    assert crest_share(objective, trial, evidence, half) == pytest.approx(0.5, abs=0.05)
    assert crest_share(objective, trial, replace(evidence, rival=evidence), edges_at(PLAIN_DEG)) == 0.0
