from dataclasses import replace

import numpy as np
import pytest
from scenes import mountain_scene, taken
from skyline_viewshed.core.base.camera import Camera, Pose, focal_from_35mm_px
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer
from skyline_viewshed.core.horizon.horizon import horizon_profile
from skyline_viewshed.core.horizon.inner import InnerTerrain, inner_terrain
from skyline_viewshed.core.match.geometry import HorizonCurve
from skyline_viewshed.core.match.ground import GroundMatchOptions
from skyline_viewshed.core.match.inputs import MatchInputs
from skyline_viewshed.core.match.likelihood import EvidenceStack
from skyline_viewshed.core.match.prior import CameraPrior, camera_prior
from skyline_viewshed.core.match.refine import Objective
from skyline_viewshed.core.match.ridges import RidgeMatchOptions
from skyline_viewshed.core.match.robust import RobustOptions
from skyline_viewshed.core.match.second import ForegroundEvidence, ForegroundOptions, InnerEvidence
from skyline_viewshed.core.pipeline import OrientOptions, Setting, orient_photo
from skyline_viewshed.core.simulate.scene import SceneOptions
from skyline_viewshed.core.skyline.evidence import skyline_evidence

NO_CRESTS, NO_GROUND = RidgeMatchOptions(weight=0.0), GroundMatchOptions(weight=0.0)


@pytest.fixture(scope="module")
def scene():
    return mountain_scene(3)


@pytest.fixture(scope="module")
def parts(scene):
    return parts_of(scene)


def parts_of(scene):
    evidence, horizon = skyline_evidence(scene.photo.pixels), horizon_profile(scene.terrain, scene.observer)
    inner = inner_terrain(scene.terrain, scene.observer)
    inputs = MatchInputs(evidence, CameraPrior(scene.camera, 0.02), horizon, inner=inner)
    objective = Objective(EvidenceStack(evidence.probability), inputs.reduced_prior, HorizonCurve(horizon))
    return objective, evidence, inner


def trials_of(pose, turns_deg):
    trials = np.zeros((len(turns_deg), 5))
    trials[:, 0], trials[:, 1], trials[:, 2] = pose.heading_deg + turns_deg, pose.pitch_deg, pose.roll_deg
    return trials


def test_the_right_pose_gains_more_than_nearly_all_others():
    """Second evidence is a tendency: in one scene a wrong pose may gain more, in several the right one leads."""
    turns = np.concatenate([[0.0], np.arange(20.0, 345.0, 12.0)])
    scenes = [mountain_scene(seed) for seed in (2, 3, 5, 6)]
    scores = [InnerEvidence(*parts_of(s), RobustOptions()).score(trials_of(s.pose, turns)) for s in scenes]
    beaten = [np.mean(one[1:] < one[0]) for one in scores]
    assert np.mean(beaten) > 0.85
    assert np.mean([one[0] - one[1:].mean() for one in scores]) > 0.3


def test_crests_and_ground_add_up(scene, parts):
    trials = trials_of(scene.pose, np.arange(0.0, 360.0, 40.0))
    options = RobustOptions()
    both = InnerEvidence(*parts, options).score(trials)
    crests = InnerEvidence(*parts, replace(options, ground=NO_GROUND)).score(trials)
    ground = InnerEvidence(*parts, replace(options, ridges=NO_CRESTS)).score(trials)
    assert crests.any() and ground.any()
    assert both == pytest.approx(crests + ground)


def test_what_is_unknown_adds_nothing(scene, parts):
    objective, evidence, inner = parts
    trials = trials_of(scene.pose, np.arange(0.0, 360.0, 40.0))
    no_picture = replace(evidence, thumbnail=None, ridge_score=None)
    for picture, terrain in ((evidence, None), (no_picture, inner)):
        second = InnerEvidence(objective, picture, terrain, RobustOptions())
        assert not second.score(trials).any()
    no_ground = InnerTerrain(inner.ridges, None)
    assert not InnerEvidence(objective, evidence, no_ground, RobustOptions(ridges=NO_CRESTS)).score(trials).any()


def twin_mountains():
    """A ring of mountains that looks the same in opposite directions, and hills inside that do not."""
    axis = (np.arange(301) - 150) * 80.0
    east, north = np.meshgrid(axis, -axis)
    distance, turn = np.hypot(east, north), np.arctan2(east, north)
    crest = 1 + 0.25 * np.cos(4 * turn + 1) + 0.2 * np.cos(10 * turn + 2) + 0.15 * np.cos(22 * turn)
    height = 1100 * crest * np.exp(-(((distance - 9000) / 1400) ** 2))
    generator = np.random.default_rng(8)
    for _ in range(60):
        away, side = generator.uniform(1500, 6000), generator.uniform(0, 2 * np.pi)
        hill = np.hypot(east - away * np.sin(side), north - away * np.cos(side)) / generator.uniform(250, 500)
        height += generator.uniform(60, 160) * np.exp(-(hill**2))
    return ArrayTerrain(height.astype(np.float32), 80.0)


def test_of_twin_horizons_the_ground_tells_the_right_one():
    terrain, observer = twin_mountains(), Observer(0.0, 0.0, 350.0)
    camera = Camera(640, 480, focal_from_35mm_px(640, 480, 35.0))
    scene = taken(terrain, observer, camera, Pose(57.0, 1.0, 0.5), SceneOptions(2), 35.0)
    setting = Setting(observer, camera_prior(scene.photo.metadata))
    blind = OrientOptions(robust=RobustOptions(ground=NO_GROUND, ridges=NO_CRESTS))
    twins = orient_photo(scene.photo, terrain, setting, blind).orientation
    assert twins.status == "ambiguous"
    assert sorted(c.pose.heading_deg for c in twins.candidates[:2]) == pytest.approx([57.0, 237.0], abs=0.5)
    told = orient_photo(scene.photo, terrain, setting).orientation
    assert told.best.pose.heading_deg == pytest.approx(57.0, abs=0.5)
    assert told.status == "accepted" and told.p_correct > 0.85 > 0.55 > twins.p_correct


def sky_over(row_px, height, width, size=(96, 128)):
    """Probability of sky that is 1 above some rows of a picture and 0 below them, on a coarser grid."""
    y = (np.arange(size[0]) + 0.5)[:, None] * height / size[0] - 0.5
    across = ((np.arange(size[1]) + 0.5) * width / size[1]).astype(int)
    return np.where(y < row_px[across], 1.0, 0.0)


@pytest.fixture(scope="module")
def placed(match_scenes):
    """A scene's objective, its true trial, and the horizon's row in each column."""
    scene = match_scenes.scene()
    objective = scene.objective()
    trial = np.array([[scene.pose.heading_deg, scene.pose.pitch_deg, scene.pose.roll_deg, 0, 0]])
    rows, _ = objective.rows(trial, np.arange(objective.stack.shape[1]))
    return objective, trial, rows[0]


@pytest.mark.parametrize("shift_px", [0, 60])
def test_sky_above_the_horizon_says_nothing_whatever_is_below(placed, shift_px):
    objective, trial, rows = placed
    sky = sky_over(rows + shift_px, *objective.stack.shape)
    assert ForegroundEvidence(objective, sky).score(trial) == pytest.approx(0.0, abs=1e-9)


def test_ground_high_above_the_horizon_nearly_reaches_the_limit(placed):
    objective, trial, rows = placed
    (score,) = ForegroundEvidence(objective, sky_over(rows - 60, *objective.stack.shape)).score(trial)
    assert 0.7 < score / ForegroundOptions().limit < 1


def test_the_share_is_that_of_the_picture(placed):
    """A tree of a tenth of the width, from the horizon to the top, by the formula."""
    objective, trial, rows = placed
    height, width = objective.stack.shape
    tree = np.where(np.abs(np.arange(width) / width - 0.5) < 0.05, -1.0, rows)
    options = ForegroundOptions(clearance=0.0)
    across = ((np.arange(128) + 0.5) * width / 128).astype(int)
    share = np.where(tree[across] < 0, (rows[across] + 0.5) / height, 0).mean()
    (score,) = ForegroundEvidence(objective, sky_over(tree, height, width), options).score(trial)
    assert score == pytest.approx(options.limit * share / (share + options.half_share), rel=0.03)


def test_what_was_cut_off_does_not_count(placed):
    objective, trial, rows = placed
    sky = sky_over(rows - 60, *objective.stack.shape)
    half = sky.copy()
    half[:, :64] = np.nan
    whole, part = (ForegroundEvidence(objective, one).score(trial)[0] for one in (sky, half))
    assert part == pytest.approx(whole, rel=0.15)
    for nothing in (np.full_like(sky, np.nan), None):
        assert ForegroundEvidence(objective, nothing).score(trial)[0] == 0.0


def test_trials_whose_horizon_is_not_in_the_picture_are_finite(placed):
    objective, trial, rows = placed
    evidence = ForegroundEvidence(objective, sky_over(rows, *objective.stack.shape))
    far = np.repeat(trial, 3, axis=0)
    far[:, 1] = -50.0, 0.0, 50.0
    scores = evidence.score(far)
    assert np.isfinite(scores).all()
    assert (np.abs(scores) <= ForegroundOptions().limit).all()
