import numpy as np
import pytest
from fitted_places import places
from skyline_viewshed.core.locate.fitted import FittedPlaces, distance_m, distinct, joined


def test_the_distance_is_that_on_the_ground():
    found = places([8.0, 8.01, 8.0], [46.0, 46.0, 46.01], [3.0, 2.0, 1.0])
    assert distance_m(found, 0, 2) == pytest.approx(1111.9, abs=0.5)
    assert distance_m(found, 0, 1) == pytest.approx(1111.9 * np.cos(np.radians(46.0)), abs=0.5)


def test_only_the_best_of_near_places_is_kept():
    found = places([8.0, 8.001, 8.1], [46.0] * 3, [3.0, 2.0, 1.0])
    assert distinct(found, 500.0, 3).tolist() == [0, 2]
    assert distinct(found, 500.0, 1).tolist() == [0]


def test_scores_that_are_raised_are_sorted_anew():
    found = places([8.0, 8.1], [46.0, 46.0], [2.0, 1.0]).plus(np.array([0.0, 5.0]))
    assert found.longitude_deg.tolist() == [8.1, 8.0] and found.score.tolist() == [6.0, 2.0]


def test_a_place_counts_once_with_its_best_pose():
    found = places([8.0, 8.1, 8.0, 8.2], [46.0] * 4, [4.0, 3.0, 2.0, 1.0])
    found = FittedPlaces(np.array([7, 3, 7, 1]), *(getattr(found, name) for name in list(vars(found))[1:]))
    assert found.once().source.tolist() == [7, 3, 1] and found.once().score.tolist() == [4.0, 3.0, 1.0]


def test_parts_are_joined_in_their_order():
    found = places([8.0, 8.1, 8.2], [46.0] * 3, [3.0, 2.0, 1.0])
    both = joined([found.take([2]), found.take([0, 1])])
    assert both.longitude_deg.tolist() == [8.2, 8.0, 8.1] and both.trial.shape == (3, 5)
