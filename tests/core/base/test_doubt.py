"""Answers that rest on contradictory or imprecise input are not accepted."""

import pytest
from skyline_viewshed.core.base.doubt import DOUBTED_PROBABILITY, doubted, position_doubt
from skyline_viewshed.core.base.messages import Message
from skyline_viewshed.core.base.model import Orientation

DOUBT = Message("The heights contradict each other.")


def answer(lo=99.0, hi=101.0, status="accepted", p_correct=0.97):
    return Orientation(status, "good", heading_lo_deg=lo, heading_hi_deg=hi, p_correct=p_correct)


def test_a_doubt_takes_acceptance_probability_and_interval():
    found = doubted(answer(), DOUBT)
    assert (found.status, found.message, found.p_correct) == ("ambiguous", DOUBT, 0.5)
    assert found.heading_lo_deg is found.heading_hi_deg is None
    kept = doubted(answer(), DOUBT, keep_interval=True)
    assert (kept.status, kept.heading_lo_deg, kept.heading_hi_deg) == ("ambiguous", 99.0, 101.0)


@pytest.mark.parametrize("status", ["rejected", "failed"])
def test_other_answers_stay_as_they_are(status):
    before = answer(status=status)
    assert doubted(before, DOUBT) is before
    accepted = answer()
    assert doubted(accepted, None) is accepted


@pytest.mark.parametrize(
    "error_m, lo, hi, doubt",
    [
        (8.0, 90, 110, False),
        (400.0, 95, 105, True),
        (400.0, 355, 5, True),
        (400.0, 98, 102, False),
        (400.0, None, None, False),
    ],
)
def test_an_imprecise_position_allows_only_a_narrow_interval(error_m, lo, hi, doubt):
    assert (position_doubt(answer(lo, hi), error_m) is not None) == doubt


def test_a_contradiction_limits_the_certainty_of_an_ambiguous_answer_too():
    certain = Orientation("ambiguous", "The compass contradicts.", p_correct=0.95)
    found = doubted(certain, Message("The recorded altitude lies 326 m below the DEM's surface."))
    assert found.p_correct == DOUBTED_PROBABILITY and "altitude" in found.message
    weak = Orientation("ambiguous", "The fit is weak.", p_correct=0.3)
    assert doubted(weak, Message("The recorded altitude lies 326 m below the DEM's surface.")) is weak
