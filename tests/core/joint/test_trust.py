"""What skylines say of a compass: Bayes' rule in closed form, and devices that are right, wrong and unknown."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from joint_walks import photo
from skyline_viewshed.core.joint.trust import FEWEST_READINGS, LARGEST_SHARE, shares_of, support, worthless_share
from skyline_viewshed.core.match.posterior import weigh
from skyline_viewshed.core.match.prior import CompassOptions, compass_prior, log_ratio

USUAL = CompassOptions().outlier_share
HEADINGS = np.array([40.0, 130.0, 250.0])


def density(reading_deg, heading_deg):
    return np.exp(log_ratio(compass_prior(reading_deg), heading_deg))


def hinted(name, alone, reading, **facts):
    """A photograph that has used its compass; `alone` are the probabilities of its answers without it."""
    weighed = weigh(np.asarray(alone), HEADINGS[: len(alone)], compass_prior(reading))
    hint = (1 - weighed.sum()) * compass_prior(reading).core_share
    answers = [*zip(HEADINGS, weighed), (reading, hint)]
    return photo(name, "accepted", sorted(answers, key=lambda answer: -answer[1]), compass=reading, **facts)


@given(
    st.lists(st.floats(0.001, 1), min_size=1, max_size=3),
    st.floats(0.01, 1),
    st.floats(0, 359.9).filter(lambda h: h % 1),
)
def test_the_compass_is_taken_out_of_the_answers_again(shares, none, reading):
    """The ratio from hinted answers is that of the answers without the hint."""
    alone = np.array(shares) / (sum(shares) + none)
    core = (density(reading, HEADINGS[: len(alone)]) - USUAL) / (1 - USUAL)
    wanted = float(alone @ core + 1 - alone.sum())
    assert support(hinted("a.jpg", alone, reading), density, USUAL) == pytest.approx(wanted, rel=1e-6, abs=1e-9)


def test_a_sure_skyline_supports_a_reading_beside_it_and_not_one_elsewhere():
    assert support(hinted("a.jpg", [0.98], 43.0), density, USUAL) > 10
    assert support(hinted("a.jpg", [0.98], 75.0), density, USUAL) < 0.25


def test_a_skyline_that_decides_nothing_says_nothing():
    assert support(hinted("a.jpg", [0.001], 43.0), density, USUAL) == pytest.approx(1, abs=0.05)


def test_photographs_without_reading_or_probability_say_nothing():
    assert support(photo("a.jpg", "accepted", [(40.0, 0.9)]), density, USUAL) is None
    assert support(photo("a.jpg", "failed", compass=40.0), density, USUAL) is None
    assert support(photo("a.jpg", "accepted", [(40.0, None)], compass=40.0), density, USUAL) is None


def test_few_readings_and_good_ones_leave_the_usual_share():
    assert worthless_share([0.0] * (FEWEST_READINGS - 1), USUAL) == USUAL
    assert worthless_share([15.0] * 8, USUAL) == USUAL
    assert worthless_share([1.0] * 8, USUAL) == pytest.approx(USUAL)


def test_the_share_is_that_of_the_beta_distribution():
    """Readings that are surely worthless or surely right count like those of an urn; the result is in tenths."""
    for wrong, right in ((4, 4), (6, 2), (3, 7)):
        expected = (wrong + USUAL) / (wrong + right + 1)
        assert worthless_share([0.0] * wrong + [1e9] * right, USUAL) == pytest.approx(expected, abs=0.051)


def test_a_ratio_that_rounding_made_negative_counts_as_none():
    one = photo("a.jpg", "accepted", [(40.0, 1.0)], compass=220.5)
    assert support(one, lambda *_: np.array([0.0999999]), 0.1) == 0


def test_a_compass_that_is_always_wrong_keeps_a_little_trust():
    assert worthless_share([0.0] * 50, USUAL) == LARGEST_SHARE


def test_each_device_is_judged_by_its_own_photographs():
    bad = [hinted(f"{k}.jpg", [0.98], 150.0 + 40 * k, device="Lost") for k in range(5)]
    good = [hinted(f"g{k}.jpg", [0.98], 38.0 + k, device="Sound") for k in range(5)]
    nameless = [hinted(f"n{k}.jpg", [0.98], 200.0, device=None) for k in range(5)]
    assert shares_of([*good, *bad, *nameless], density, USUAL) == (("Lost", 0.8),)
    assert shares_of(good, density, USUAL) == ()
