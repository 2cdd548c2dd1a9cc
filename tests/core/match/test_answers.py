from dataclasses import replace

import numpy as np
import pytest
from skyline_viewshed.core.match.answers import judge, probability_near
from skyline_viewshed.core.match.posterior import answer_probabilities, p_correct
from skyline_viewshed.core.match.prior import HeadingPrior
from skyline_viewshed.core.match.robust import find_answers, match_robust


@pytest.fixture(scope="module")
def narrow(match_scenes):
    return match_scenes.scene(4, 97.3, hfov_deg=20.0)


@pytest.fixture(scope="module")
def answers(narrow):
    return find_answers(narrow.inputs())


def test_without_a_heading_prior_the_probabilities_of_the_picture_stand(answers):
    same, probability, right = judge(answers)
    assert same is answers
    assert probability[0] == right == pytest.approx(p_correct(answers.finding))
    assert probability.sum() <= 1


def test_a_prior_near_the_answer_raises_its_probability_and_one_elsewhere_lowers_it(answers):
    found = float(answers.trials[0, 0])
    alone = judge(answers)[2]
    led, _, agreeing = judge(answers, HeadingPrior(found + 5, 10.0))
    _, opposing, _ = judge(answers, HeadingPrior(found + 150, 10.0))
    assert led.trials[0, 0] == found
    assert agreeing > alone > opposing.max()


def test_a_prior_changes_no_score(narrow, answers):
    """The prior helps to choose the candidates that are fitted; it does not change how well they fit the picture."""
    led = find_answers(narrow.inputs(heading_prior=HeadingPrior(97.3, 10.0)))
    assert led.finding.score[0] == pytest.approx(answers.finding.score[0], abs=1e-3)


def test_a_strong_prior_for_the_second_answer_brings_it_to_the_front(answers):
    level = level_scores(answers)
    second = float(level.trials[1, 0])
    judged, probability, right = judge(level, HeadingPrior(second, 5.0))
    assert judged.trials[0, 0] == judged.finding.heading_deg[0] == second
    assert (np.diff(probability[1:]) <= 0).all()
    assert sorted(judged.trials[:, 0]) == sorted([*level.trials[:, 0], second])
    assert probability.sum() <= 1 + 1e-9 and 0 < right <= 1
    assert answer_probabilities(level.finding, 0.5)[0] == 0.5


def test_a_hint_beside_the_answer_does_not_displace_it(answers):
    found = float(answers.trials[0, 0])
    for turn in (-4.0, -0.8, 2.0, 7.0):
        judged, _, right = judge(answers, HeadingPrior(found + turn, 10.0, outlier_share=0.15))
        assert judged.trials[0, 0] == found and right > 0.9


def test_if_the_picture_decides_nothing_the_hint_itself_is_the_answer(answers):
    """A heading far from all answers: none of them fits, so that the hint keeps its own spread."""
    level = level_scores(answers, 0.3)
    far = float(max(np.arange(0.0, 360.0, 5.0), key=lambda h: np.abs((level.trials[:, 0] - h + 180) % 360 - 180).min()))
    judged, probability, right = judge(level, HeadingPrior(far, 8.0))
    assert judged.hint == 0 and judged.trials[0, 0] == far
    assert judged.finding.sigma_deg[0] == 8.0
    assert probability[0] > probability[1:].max()
    assert right == pytest.approx(probability[0] * 0.292, abs=0.05)  # a Gaussian of 8 degrees within 3


def test_a_picture_without_a_telling_skyline_gets_the_hint_back(match_scenes):
    scene = match_scenes.scene(4, 97.3, hfov_deg=20.0)
    flat = np.full(scene.evidence.probability.shape, 1 / scene.evidence.probability.shape[0], np.float32)
    flat[10, ::2] += 0.02  # enough of an edge not to be refused, and no shape
    evidence = replace(scene.evidence, probability=flat / flat.sum(0), ridge_score=None, thumbnail=None, rival=None)
    found = match_robust(replace(scene.inputs(heading_prior=HeadingPrior(200.0, 10.0)), evidence=evidence))
    assert found.best.pose.heading_deg == pytest.approx(200.0, abs=20.0)
    width = (found.heading_hi_deg - found.heading_lo_deg) % 360
    assert found.status != "accepted" and width > 10


def test_probability_near_an_answer_counts_its_neighbours():
    heading, sigma = np.array([10.0, 11.0, 200.0]), np.array([0.1, 0.1, 10.0])
    near = probability_near(heading, sigma, np.array([0.3, 0.2, 0.5]), 3.0)
    assert near[0] == pytest.approx(0.5) and near[1] == pytest.approx(0.5)
    assert near[2] == pytest.approx(0.5 * 0.236, abs=0.002)
    across = probability_near(np.array([359.5, 0.5]), np.array([0.1, 0.1]), np.array([0.4, 0.4]), 3.0)
    assert across == pytest.approx([0.8, 0.8])


def level_scores(answers, score=None):
    """The same answers, all equally good."""
    finding = answers.finding
    level = np.full(len(finding.score), finding.score[0] if score is None else score)
    return replace(answers, finding=replace(finding, score=level))


def test_the_curve_agrees_with_the_answer_of_a_rolled_photo(match_scenes):
    """At a large roll the coarse search scores another heading higher than that of the answer."""
    rolled = match_scenes.scene(4, 97.3, roll_deg=9.0)
    found = find_answers(rolled.inputs())
    heading, score = found.curve()
    assert np.abs((heading[score.argmax()] - found.trials[0, 0] + 180) % 360 - 180) < 0.5
    assert score.max() == pytest.approx(found.finding.score[0])
    for trial, own in zip(found.trials, found.finding.score):
        near = np.abs((heading - trial[0] + 180) % 360 - 180) <= 1.0
        assert score[near].max() >= own - 1e-9


def test_the_curve_takes_no_score_from_a_hint(answers):
    judged, _, _ = judge(answers, HeadingPrior(answers.trials[0, 0] + 90.0, 10.0))
    assert judged.hint is not None
    np.testing.assert_allclose(judged.curve()[1], answers.curve()[1])
