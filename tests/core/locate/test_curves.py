import numpy as np
import pytest
from skyline_viewshed.core.base.model import HorizonProfile
from skyline_viewshed.core.locate.curves import UNKNOWN_M, CurveSet
from skyline_viewshed.core.match.geometry import HorizonCurve


def test_each_row_is_the_curve_of_one_place(match_scenes):
    horizons = [match_scenes.random_horizon(seed, step_deg=0.5) for seed in (1, 2, 3)]
    curves = CurveSet(
        np.array([one.elevation_deg for one in horizons]), np.array([one.distance_m for one in horizons]), 30.0
    )
    azimuth = np.array([[0.2, 359.9, 120.3], [45.1, 200.0, 300.7], [10.0, 20.0, -5.0]])
    tangent, slope = curves.tangent_at(azimuth)
    nearest = curves.nearest(azimuth)
    for row, horizon in enumerate(horizons):
        single = HorizonCurve(horizon)
        expected = single.tangent_at(azimuth[row])
        assert tangent[row] == pytest.approx(expected[0]) and slope[row] == pytest.approx(expected[1])
        assert curves.distance_m[nearest[row]] == pytest.approx(single.distance_m[single.nearest(azimuth[row])])


def test_unknown_directions_are_marked_and_far():
    elevation = np.array([[1.0, np.nan, 2.0, 3.0]])
    curves = CurveSet(elevation, np.full((1, 4), 50.0), 90.0, np.array([[False, False, True, False]]))
    assert curves.known.tolist() == [True, False, True, True]
    assert curves.distance_m.tolist() == [90.0, UNKNOWN_M, 90.0, 90.0]
    assert curves.clipped.tolist() == [False, False, True, False]


def test_it_has_all_that_a_fit_asks_of_a_curve():
    none = np.zeros(4, bool)
    known = HorizonProfile(np.arange(4) * 90.0, np.ones(4), np.full(4, 5e3), none, none, 0.0, 30.0, np.full(4, 6e4))
    wanted = {name for name in vars(HorizonCurve(known)) if not name.startswith("_")}
    assert wanted <= set(vars(CurveSet(np.ones((1, 4)), np.ones((1, 4)), 30.0)))
