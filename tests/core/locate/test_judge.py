import numpy as np
import pytest
from skyline_viewshed.core.locate.judge import (
    Facts,
    JudgeOptions,
    apart_share,
    ellipse,
    near_share,
    p_correct,
    region,
    shares,
    table,
    verdict,
)

GOOD = Facts(5.2, 0.9, 0.97, 1.5, 62.0, 5000)
POOR = Facts(4.1, 0.01, 0.8, 1.5, 62.0, 5000)


def test_a_clear_place_is_accepted_and_one_of_many_is_not():
    assert p_correct(GOOD) > 0.85 > 0.25 > p_correct(POOR)
    assert verdict(GOOD, np.array([p_correct(GOOD)]))[0] == "accepted"
    status, message = verdict(POOR, np.array([p_correct(POOR)]))
    assert status == "rejected" and "not taken in this area" in message
    assert verdict(POOR, np.array([0.5, 0.4]), JudgeOptions())[0] == "ambiguous"


def test_more_places_make_a_chance_match_likelier():
    many = Facts(5.2, 0.9, 0.97, 1.5, 62.0, 500_000)
    assert p_correct(many) < p_correct(GOOD)


@pytest.mark.parametrize(("name", "better"), [("gap", 1.2), ("score", 5.6)])
def test_the_probability_grows_with_the_evidence(name, better):
    from dataclasses import replace

    assert p_correct(replace(POOR, **{name: better})) > p_correct(POOR)


def test_a_twin_on_the_line_of_sight_halves_the_probability():
    from types import SimpleNamespace

    north = np.array([0.0, 300.0, 800.0, 5000.0]) / 111_195
    found = SimpleNamespace(
        longitude_deg=np.full(4, 8.0), latitude_deg=46 + north, score=np.array([5.0, 3.0, 5.0, 5.0])
    )
    assert near_share(found, 6.5) == pytest.approx(0.5, abs=0.001)
    assert apart_share(found, 6.5) == pytest.approx(2 / 3, abs=0.001)


def test_shares_add_up_to_less_than_one():
    share = shares(np.array([5.0, 4.9, 3.0]), 0.6)
    assert share[0] == 0.6 and share.sum() < 1 and share[1] > share[2] > 0
    assert shares(np.array([5.0]), 0.9).tolist() == [0.9]


def test_the_region_holds_the_mass():
    score = np.array([1.0, 3.0, 2.0, -5.0])
    worth = 1.0
    probability = np.exp(score) / np.exp(score).sum()
    inside = region(score, worth)
    assert inside[0] == 1 and probability[inside].sum() >= 0.9 > probability[inside[:-1]].sum()


def test_the_ellipse_is_long_where_the_score_is_flat():
    effective = table()["effective_columns"]
    curvature = np.diag([1 / 100.0**2, 1 / 10.0**2]) / effective  # 100 m to the east, 10 m to the north
    around = ellipse(curvature, np.array([1e-4, 0.0]), 0.02, 40.0)
    assert around.major_m == pytest.approx(2.146 * np.hypot(100, 40)) and around.azimuth_deg == pytest.approx(90)
    assert around.minor_m == pytest.approx(2.146 * np.hypot(10, 40))


def test_field_of_view_and_place_hide_in_each_other():
    curvature = np.diag([1 / 200.0**2, 1 / 10.0**2]) / table()["effective_columns"]
    tight = ellipse(curvature, np.array([1e-6, 0.0]), 0.02, 10.0)
    bound = ellipse(curvature, np.array([1e-3, 0.0]), 0.02, 10.0)
    assert abs(tight.focal_correlation) < 0.05 < 0.9 < abs(bound.focal_correlation) <= 1
    assert ellipse(np.full((2, 2), np.nan), np.zeros(2), 0.02, 10.0) is None
