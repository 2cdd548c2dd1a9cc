from dataclasses import replace

import numpy as np
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
