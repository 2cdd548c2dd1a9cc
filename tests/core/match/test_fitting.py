from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from skyline_viewshed.core.match import fitting
from skyline_viewshed.core.match.answers import Fits
from skyline_viewshed.core.match.inputs import Eye
from skyline_viewshed.core.match.posterior import table
from skyline_viewshed.core.match.robust import RobustOptions, find_answers, match_robust


class Inside:
    """Second evidence with a fixed score for each heading."""

    def __init__(self, scores):
        self.scores = scores

    def score(self, trials):
        return np.array([self.scores[heading] for heading in trials[:, 0]])


NOTHING = Inside({10.0: 0.0, 200.0: 0.0})


def two_fits(gap):
    trials = np.zeros((2, 5))
    trials[:, 0] = 10.0, 200.0
    return Fits(trials, np.zeros(2, int), np.array([4.0 + gap, 4.0]), np.ones(2))


def test_the_inside_of_the_picture_decides_between_equals_and_overrules_no_clear_skyline():
    options = RobustOptions()
    scorers = [SimpleNamespace(second=Inside({10.0: 0.0, 200.0: 2.5}), foreground=NOTHING)]
    level = fitting._with_second_evidence(two_fits(0.0), scorers, options)
    assert level.trials[0, 0] == 200.0
    limit = -np.log(options.second_misled) / table()["temperature"]
    assert level.score[0] - level.score[1] == pytest.approx(limit, rel=0.01)
    clear = fitting._with_second_evidence(two_fits(1.2 * limit), scorers, options)
    assert clear.trials[0, 0] == 10.0


def test_without_second_evidence_scores_and_order_stay():
    fits = two_fits(0.3)
    same = fitting._with_second_evidence(fits, [SimpleNamespace(second=NOTHING, foreground=NOTHING)], RobustOptions())
    assert same.score.tolist() == fits.score.tolist()


def test_the_foreground_is_a_log_likelihood_of_the_answers():
    """Only the difference between answers counts, so a picture full of trees is no more certain for it."""
    for shift in (0.0, 5.0):
        scorers = [SimpleNamespace(second=NOTHING, foreground=Inside({10.0: shift, 200.0: shift + 1.3}))]
        fits = fitting._with_second_evidence(two_fits(0.0), scorers, RobustOptions())
        assert fits.trials[0, 0] == 200.0
        assert fits.score == pytest.approx([4.0, 4.0 - 1.3 / table()["temperature"]])


def test_the_eye_that_explains_the_skyline_is_found(match_scenes):
    """The assumed eye shows another horizon altogether; one of the others shows the photographed one."""
    scene = match_scenes.scene(4, 97.3, hfov_deg=40.0)
    wrong = [match_scenes.random_horizon(seed) for seed in (21, 22)]
    inputs = replace(scene.inputs(), horizon=wrong[0], other_eyes=(Eye(wrong[1]), Eye(scene.horizon, log_prior=-1.0)))
    found = match_robust(inputs)
    assert found.eye == 2
    assert found.best.pose.heading_deg == pytest.approx(97.3, abs=0.3)
    answers = find_answers(inputs)
    assert len(np.unique(answers.eye)) > 1, "answers of the other eyes stay among the rivals"


def test_an_improbable_eye_needs_a_better_fit(match_scenes):
    scene = match_scenes.scene(4, 97.3, hfov_deg=40.0)
    lifted = replace(scene.horizon, elevation_deg=scene.horizon.elevation_deg + 1e-4)
    assert match_robust(replace(scene.inputs(), other_eyes=(Eye(lifted, log_prior=-2.0),))).eye == 0
