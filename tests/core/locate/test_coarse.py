import numpy as np
import pytest
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.locate.coarse import CoarseOptions, CoarsePlaces, compare
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


def test_each_place_keeps_several_headings_apart(index, match_scenes):
    seen, options = match_scenes.scene(seed=17, heading_deg=123.0, roll_deg=6.0), PictureOptions()
    pictures = hypotheses(seen.evidence, seen.camera, options)
    found = compare(index, pictures, options, coarse=CoarseOptions(headings=4, apart_deg=20.0))
    assert found.trials.shape == (len(index), 4, 5)
    assert (np.diff(found.scores, axis=1) <= 0).all()
    heading = found.trials[:, :, 0]
    apart = np.abs(difference(heading[:, :, None], heading[:, None]))[:, ~np.eye(4, dtype=bool)]
    assert apart.min() > 20.0


def test_another_heading_of_the_same_place_has_its_own_pitch(index, match_scenes):
    seen, options = match_scenes.scene(seed=17), PictureOptions()
    pictures = hypotheses(seen.evidence, seen.camera, options)
    free = compare(index, pictures, options)
    second = free.trials[16, 1]
    belief = np.where(np.arange(360) == second[0], 0.0, -50.0)
    alone = compare(index, pictures, options, belief)
    assert alone.trial[16] == pytest.approx(second)
    assert alone.score[16] == pytest.approx(free.scores[16, 1], abs=1e-5)


def test_the_best_poses_of_all_places_with_their_weights():
    trials = np.zeros((3, 2, 5))
    trials[..., 0] = [[10, 20], [30, 40], [50, 60]]
    found = CoarsePlaces(np.array([[3.0, 2.5], [2.0, 1.0], [9.0, 8.0]]), trials)
    places, poses = found.best(3, np.array([0.0, 0.7, -np.inf]))
    assert places.tolist() == [0, 1, 0]
    assert poses[:, 0].tolist() == [10, 30, 20]
