import sys
from dataclasses import replace

import numpy as np
import pytest
from skyline_viewshed.core.base.camera import Camera, Pose, focal_of_fov_px, project
from skyline_viewshed.core.base.errors import Cancelled
from skyline_viewshed.core.base.model import HorizonProfile
from skyline_viewshed.core.match.geometry import HorizonCurve
from skyline_viewshed.core.match.likelihood import EvidenceStack
from skyline_viewshed.core.match.search import SearchOptions, coarse_search, distinct_peaks
from skyline_viewshed.core.skyline.given import evidence_from_line


def search(scene, **facts):
    stack = EvidenceStack(scene.evidence.probability)
    return coarse_search(stack, scene.small_camera, [HorizonCurve(scene.horizon)], **facts)[0]


@pytest.mark.parametrize("heading_deg", [0.0, 97.3, 359.9])
@pytest.mark.parametrize("hfov_deg", [35.0, 65.0])
def test_the_true_heading_pitch_and_roll_come_first(match_scenes, heading_deg, hfov_deg):
    scene = match_scenes.scene(4, heading_deg, pitch_deg=6.0, roll_deg=-4.0, hfov_deg=hfov_deg)
    heading, pitch, roll = search(scene).candidates[0]
    assert abs((heading - heading_deg + 180) % 360 - 180) < 0.9
    assert abs(pitch - 6.0) < 1.5
    assert abs(roll + 4.0) < 3.0


def test_a_narrow_view_of_a_smooth_horizon_has_the_truth_among_its_candidates(match_scenes):
    candidates = search(match_scenes.scene(4, 97.3, pitch_deg=6.0, roll_deg=0.0, hfov_deg=12.0)).candidates
    assert np.abs(candidates[:10, 0] - 97.3).min() < 1.0


@pytest.mark.parametrize("hfov_deg, relief_deg", [(10.0, 2.0), (50.0, 0.3)])
def test_narrow_fields_and_flat_skylines_are_searched_more_finely(hfov_deg, relief_deg):
    options = SearchOptions()
    assert options.for_picture(50.0, 2.0) is options
    assert options.for_picture(hfov_deg, relief_deg).step_deg == options.step_deg / 2
    assert options.for_picture(hfov_deg, relief_deg).keep > options.keep


def test_a_skyline_like_the_sea_is_searched_more_finely_still():
    options = SearchOptions()
    fine, finer = options.for_picture(15.0, 0.3), options.for_picture(15.0, 0.1)
    assert finer.step_deg == fine.step_deg / 2 == options.step_deg / 4
    assert finer.keep > fine.keep


def test_the_truth_of_a_nearly_level_horizon_is_among_its_candidates():
    """Swells of 0.06 degrees, less than a third of the ordinary step."""
    azimuth = np.arange(0, 360, 0.05)
    knots = np.random.default_rng(11).normal(0, 0.06, 360)
    scene = _picture_of(azimuth, np.interp(azimuth, np.arange(360), knots, period=360), 14.0, Pose(26.7, -1.3, -2.9))
    found = _candidates(*scene, SearchOptions().for_picture(14.0, 0.06))
    assert np.abs(found[:10, 0] - 26.7).min() < 0.3


def test_rows_without_any_horizon_may_be_left_out(match_scenes, monkeypatch):
    scene = match_scenes.scene(4, 97.3, pitch_deg=6.0, roll_deg=2.0, hfov_deg=40.0)
    short = search(scene)
    monkeypatch.setattr(sys.modules[coarse_search.__module__], "_rows_held", lambda line: (0, len(line) - 1))
    whole = search(scene)
    assert np.array_equal(short.score, whole.score)
    assert np.array_equal(short.candidates, whole.candidates)


@pytest.mark.parametrize("hfov_deg", [4.0, 20.0, 45.0, 75.0])
def test_trial_rolls_lie_as_close_as_the_field_asks(hfov_deg):
    """Half-way between two rolls the skyline's tilt stays within 1.25 tolerances, root mean square over the columns."""
    options = SearchOptions()
    rolls = options.rolls_deg(hfov_deg)
    columns_deg = np.linspace(-hfov_deg / 2, hfov_deg / 2, 1001)
    tilt_deg = columns_deg * np.tan(np.radians(np.diff(rolls).max() / 2))
    assert np.sqrt(np.mean(tilt_deg**2)) <= 1.25 * options.tolerance_deg + 1e-9
    assert rolls[0] == -options.largest_roll_deg and rolls[-1] == options.largest_roll_deg and 0.0 in rolls


def test_a_nearly_flat_horizon_in_a_wide_and_tilted_picture_has_the_truth_among_its_candidates():
    azimuth = np.arange(0, 360, 0.1)
    knots = np.random.default_rng(5).normal(0, 0.3, 180)
    elevation = np.interp(azimuth, np.arange(0, 360, 2.0), knots, period=360)
    scene = _picture_of(azimuth, elevation, 70.0, Pose(211.0, 2.0, -2.5))
    found = _candidates(*scene, SearchOptions().for_picture(70.0, 0.3))
    assert np.abs(found[:5, 0] - 211.0).min() < 0.5


def _picture_of(azimuth_deg, elevation_deg, hfov_deg, pose):
    """Evidence that a camera of 512 by 384 pixels has of a horizon 30 km away; the camera, and the horizon's curve."""
    far, never = np.full(azimuth_deg.shape, 30_000.0), np.zeros(azimuth_deg.shape, bool)
    horizon = HorizonProfile(azimuth_deg, elevation_deg, far, never, never, 1500.0, 30.0, far)
    camera = Camera(512, 384, focal_of_fov_px(512, hfov_deg))
    x, y = project(camera, pose, azimuth_deg, elevation_deg)
    seen = np.isfinite(x) & (x > -20) & (x < 532)
    order = np.argsort(x[seen])
    return evidence_from_line(x[seen][order], y[seen][order], 512, 384), camera, HorizonCurve(horizon)


def _candidates(evidence, camera, curve, options):
    return coarse_search(EvidenceStack(evidence.probability), camera, [curve], options)[0].candidates


@pytest.mark.parametrize("roll_deg", [-14.0, 11.0])
@pytest.mark.parametrize("hfov_deg", [15.0, 40.0, 75.0])
def test_a_camera_held_at_a_large_roll_has_the_truth_among_its_candidates(match_scenes, hfov_deg, roll_deg):
    found = search(match_scenes.scene(4, 97.3, pitch_deg=6.0, roll_deg=roll_deg, hfov_deg=hfov_deg))
    best = np.abs(found.candidates[:, 0] - 97.3).argmin()
    assert abs(found.candidates[best, 0] - 97.3) < 1.0
    assert abs(found.candidates[best, 2] - roll_deg) < 5.0


def test_candidates_keep_their_distance_across_north():
    heading = np.arange(0, 360, 0.5)
    score = np.cos(np.radians(heading))
    peaks = heading[distinct_peaks(heading, score, 5, 3.0)]
    gaps = np.abs((peaks[:, None] - peaks + 180) % 360 - 180)[~np.eye(5, dtype=bool)]
    assert peaks[0] == 0
    assert gaps.min() >= 3.0


def test_a_taller_horizon_of_the_same_shape_scores_lower(match_scenes):
    scene = match_scenes.scene(5, hfov_deg=40.0)
    tall = replace(scene, horizon=replace(scene.horizon, elevation_deg=1.5 * scene.horizon.elevation_deg))
    assert search(tall).score.max() < search(scene).score.max()


def test_cancelling_stops_the_search(match_scenes):
    class Impatient:
        def report(self, fraction):
            pass

        def cancelled(self):
            return True

    with pytest.raises(Cancelled):
        search(match_scenes.scene(1), progress=Impatient())


def test_several_horizons_are_searched_as_each_of_them_alone(match_scenes):
    one, other = (match_scenes.scene(seed, 97.3, pitch_deg=6.0, roll_deg=2.0) for seed in (4, 7))
    stack, curves = EvidenceStack(one.evidence.probability), [HorizonCurve(s.horizon) for s in (one, other)]
    together = coarse_search(stack, one.small_camera, curves)
    assert len(together) == 2
    alone = coarse_search(stack, one.small_camera, curves[:1])[0]
    # The trial pitches are laid over the elevations of both horizons, so that the scores differ a little.
    assert abs(together[0].candidates[0, 0] - alone.candidates[0, 0]) < 0.9
    assert together[0].score.max() > together[1].score.max() + 0.5
    best = int(together[0].score.argmax())
    assert together[0].pitch_deg[best] == together[0].candidates[0, 1]
    assert together[0].roll_deg[best] == together[0].candidates[0, 2]
