import numpy as np
import pytest
from skyline_viewshed.core.base.camera import focal_of_fov_px
from skyline_viewshed.core.locate.picture import PictureOptions, hypotheses, unknown_lens


def test_one_hypothesis_for_each_assumption(match_scenes):
    seen = match_scenes.scene()
    options = PictureOptions(horizon_deg=(2.0, 10.0), rolls_deg=(-3.0, 0.0, 3.0))
    found = hypotheses(seen.evidence, seen.camera, options, (-0.1, 0.1))
    assert len(found) == 12
    assert {(one.roll_deg, one.log_focal) for one in found} == {(r, f) for r in (-3.0, 0.0, 3.0) for f in (-0.1, 0.1)}
    assert found[0].spectrum.shape == (options.harmonics, 360)
    assert found[3].pitch_deg - found[0].pitch_deg == pytest.approx(8.0)


def test_the_pitches_to_try_for_an_unknown_lens_span_the_limits():
    camera, sigma, log_focals = unknown_lens(4000, 3000, (30.0, 75.0))
    focal = camera.focal_px * np.exp(log_focals)
    assert focal.min() == pytest.approx(focal_of_fov_px(4000, 75.0))
    assert focal.max() == pytest.approx(focal_of_fov_px(4000, 30.0))
    assert np.diff(log_focals).max() <= 0.07 + 1e-9
    assert sigma == pytest.approx(log_focals.max())
