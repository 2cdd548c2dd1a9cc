from dataclasses import replace

import numpy as np
import pytest
from skyline_viewshed.core.match_calibration import p_correct
from skyline_viewshed.core.match_judge import judge
from skyline_viewshed.core.match_posterior import answer_probabilities
from skyline_viewshed.core.match_robust import RobustOptions, find_answers
from skyline_viewshed.core.prior import CameraPrior, HeadingPrior


def answers_of(scene, heading_prior=None):
    return find_answers(
        scene.evidence, CameraPrior(scene.camera), scene.horizon, RobustOptions(), heading_prior, (), 8.0, None
    )


@pytest.fixture(scope="module")
def answers(match_scenes):
    return answers_of(match_scenes.scene(4, 97.3, hfov_deg=20.0))


def test_without_a_belief_the_picture_s_own_probabilities_stand(answers):
    same, probability = judge(answers)
    assert same is answers
    assert probability[0] == pytest.approx(p_correct(answers.finding))
    assert probability.sum() <= 1


def test_a_belief_in_the_same_heading_makes_surer_and_one_in_another_less_sure(answers):
    found = float(answers.trials[0, 0])
    alone = judge(answers)[1][0]
    _, agreeing = judge(answers, HeadingPrior(found + 5, 10.0))
    _, opposing = judge(answers, HeadingPrior(found + 150, 10.0))
    assert agreeing[0] > alone > opposing.max()


def test_a_belief_changes_no_score(match_scenes, answers):
    """The belief helps to choose what is looked at; how well an answer fits the picture is not its matter."""
    prior = HeadingPrior(97.3, 10.0)
    led = answers_of(match_scenes.scene(4, 97.3, hfov_deg=20.0), prior)
    assert led.finding.score[0] == pytest.approx(answers.finding.score[0], abs=1e-3)


def test_a_strong_belief_in_the_second_answer_brings_it_to_the_front(answers):
    finding = replace(answers.finding, score=answers.finding.score.copy())
    level = replace(answers, finding=replace(finding, score=np.full(len(finding.score), finding.score[0])))
    second = float(level.trials[1, 0])
    judged, probability = judge(level, HeadingPrior(second, 5.0))
    assert judged.trials[0, 0] == second
    assert judged.finding.heading_deg[0] == second
    assert (np.diff(probability) <= 0).all()
    assert sorted(judged.trials[:, 0]) == sorted(level.trials[:, 0])
    assert probability.sum() <= 1 + 1e-9
    assert answer_probabilities(level.finding, 0.5)[0] == 0.5
