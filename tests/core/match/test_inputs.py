from dataclasses import replace

import numpy as np
from skyline_viewshed.core.match.inputs import Eye, EyeOptions, differs, eye_offsets_m
from skyline_viewshed.core.match.prior import CameraPrior


def test_the_lens_is_brought_to_the_size_of_the_evidence(match_scenes):
    scene = match_scenes.scene(2)
    prior = scene.inputs().reduced_prior
    assert (scene.camera.width_px, prior.camera.width_px, prior.camera.height_px) == (1024, 256, 192)
    assert prior.camera.hfov_deg == scene.camera.hfov_deg
    assert prior.focal_sigma == CameraPrior(scene.camera).focal_sigma


def test_behind_the_striking_line_only_the_evidence_is_another(match_scenes):
    scene = match_scenes.scene(2)
    rows = np.full(256, 100.0)
    striking = match_scenes.evidence_of_rows(rows, 256, 192, (1024, 768))
    inputs = scene.inputs(position_error_m=30.0)
    front = replace(inputs, evidence=replace(striking, rival=scene.evidence))
    assert front.behind.evidence is scene.evidence
    assert replace(front.behind, evidence=front.evidence).__dict__ == front.__dict__


def test_the_assumed_eye_comes_first(match_scenes):
    scene = match_scenes.scene(2)
    other = Eye(match_scenes.random_horizon(3), log_prior=-1.0)
    first, second = scene.inputs(other_eyes=(other,)).eyes
    assert first.horizon is scene.horizon and first.log_prior == 0.0
    assert second is other


def test_eyes_are_tried_at_shares_of_the_cell_and_at_the_recorded_altitude():
    options = EyeOptions(offsets_cells=(-0.2, 0.5), sigma_cells=0.25, largest_altitude_error_m=100.0)
    assert eye_offsets_m(90.0, None, options) == [(-18.0, -0.5 * 0.8**2), (45.0, -2.0)]
    assert eye_offsets_m(2.0, -30.0, options)[-1] == (-30.0, 0.0)
    assert len(eye_offsets_m(90.0, 140.0, options)) == 2, "an altitude that far off is not believed"


def test_an_eye_counts_only_if_it_moves_the_horizon(match_scenes):
    horizon = match_scenes.random_horizon(5, cell_m=90.0)
    error_deg = np.degrees(0.25 * 90.0 / horizon.distance_m)
    hidden = replace(horizon, elevation_deg=horizon.elevation_deg + 0.4 * error_deg)
    moved = replace(horizon, elevation_deg=np.where(np.arange(3600) < 40, 0.6, 0.0) * error_deg + horizon.elevation_deg)
    assert not differs(horizon, hidden, 0.25)
    assert differs(horizon, moved, 0.25)
