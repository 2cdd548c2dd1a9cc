import numpy as np
import pytest
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.locate.coarse import compare
from skyline_viewshed.core.locate.index import HorizonIndex, stored_angles, stored_distances
from skyline_viewshed.core.locate.picture import PictureOptions, hypotheses


def index_of(horizons):
    at = np.arange(len(horizons), dtype=float)
    angle = np.array([one.elevation_deg for one in horizons])
    distance = np.array([one.distance_m for one in horizons])
    return HorizonIndex(8 + 0.003 * at, 46 + 0 * at, at, stored_angles(angle), stored_distances(distance), 30.0, 250.0)


@pytest.fixture(scope="module")
def index(match_scenes):
    return index_of([match_scenes.random_horizon(seed, step_deg=0.5) for seed in range(1, 41)])


@pytest.mark.parametrize(("heading_deg", "pitch_deg"), [(123.4, 3.0), (2.0, -4.0), (355.0, 9.0)])
def test_the_place_heading_and_pitch_of_a_picture(index, match_scenes, heading_deg, pitch_deg):
    seen = match_scenes.scene(seed=17, heading_deg=heading_deg, pitch_deg=pitch_deg, roll_deg=0.0)
    options = PictureOptions()
    found = compare(index, hypotheses(seen.evidence, seen.camera, options), options)
    best = int(found.score.argmax())
    assert best == 16
    assert abs(difference(found.trial[best, 0], heading_deg)) <= 1.0
    assert found.trial[best, 1] == pytest.approx(pitch_deg, abs=1.0)


def test_a_belief_moves_the_heading(index, match_scenes):
    seen = match_scenes.scene(seed=17)
    options = PictureOptions()
    belief = np.where(np.abs(difference(np.arange(360.0), 300.0)) < 10, 50.0, 0.0)
    found = compare(index, hypotheses(seen.evidence, seen.camera, options), options, belief)
    assert (np.abs(difference(found.trial[:, 0], 300.0)) <= 10).all()


def test_the_focal_length_of_an_unknown_lens(index, match_scenes):
    seen = match_scenes.scene(seed=17, focal_scale=1.25, roll_deg=0.0)
    options = PictureOptions()
    tried = np.log([0.8, 1.0, 1.25, 1.5])
    found = compare(index, hypotheses(seen.evidence, seen.camera, options, tried), options)
    best = int(found.score.argmax())
    assert best == 16 and found.trial[best, 3] == pytest.approx(np.log(1.25))


def test_azimuths_that_do_not_divide_are_refused(index, match_scenes):
    seen, options = match_scenes.scene(), PictureOptions(step_deg=0.7)
    with pytest.raises(ValueError, match="no step of"):
        compare(index, hypotheses(seen.evidence, seen.camera, options), options)
