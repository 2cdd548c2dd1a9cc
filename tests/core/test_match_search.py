from dataclasses import replace

import numpy as np
import pytest
from skyline_viewshed.core.errors import Cancelled
from skyline_viewshed.core.match_evidence import EvidenceStack
from skyline_viewshed.core.match_geometry import HorizonCurve
from skyline_viewshed.core.match_search import SearchOptions, coarse_search, distinct_peaks


def search(scene, **options):
    probability = scene.evidence.probability
    camera = scene.camera.scaled(probability.shape[1], probability.shape[0])
    return coarse_search(
        EvidenceStack(probability), camera, HorizonCurve(scene.horizon), probability, SearchOptions(**options)
    )


@pytest.mark.parametrize("heading_deg", [0.0, 97.3, 359.9])
@pytest.mark.parametrize("hfov_deg", [35.0, 65.0])
def test_the_true_heading_pitch_and_roll_come_first(match_scenes, heading_deg, hfov_deg):
    scene = match_scenes.scene(4, heading_deg, pitch_deg=6.0, roll_deg=-4.0, hfov_deg=hfov_deg)
    heading, pitch, roll = search(scene).candidates[0]
    assert abs((heading - heading_deg + 180) % 360 - 180) < 0.9
    assert abs(pitch - 6.0) < 1.5
    assert roll == -5.0


def test_a_narrow_view_of_a_smooth_horizon_has_the_truth_among_its_candidates(match_scenes):
    candidates = search(match_scenes.scene(4, 97.3, pitch_deg=6.0, roll_deg=0.0, hfov_deg=12.0)).candidates
    assert np.abs(candidates[:10, 0] - 97.3).min() < 1.0


def test_a_narrow_field_is_searched_more_finely():
    options = SearchOptions()
    assert options.for_field(50.0) is options
    assert options.for_field(10.0).step_deg == options.step_deg / 2
    assert options.for_field(10.0).keep > options.keep


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

    scene = match_scenes.scene(1)
    probability = scene.evidence.probability
    with pytest.raises(Cancelled):
        coarse_search(
            EvidenceStack(probability),
            scene.camera.scaled(256, 192),
            HorizonCurve(scene.horizon),
            probability,
            progress=Impatient(),
        )
