import numpy as np
import pytest
from skyline_viewshed.core.viewshed.table import Table, beside, between, held_places, shares


@pytest.fixture
def table():
    return Table(np.random.default_rng(3).normal(0, 1, (17, 33)).astype(np.float32), 500.0, -1.2, 1.1)


def test_values_between_nodes_are_bilinear_and_those_beyond_them_are_held(table):
    k, w = np.array([125.0, 140.0, 156.25]), np.linspace(-1.5, 1.5, 41).astype(np.float32)
    rows = np.array([np.interp(w, np.linspace(-1.2, 1.1, 33), row) for row in table.values])
    line = [np.array([np.interp(at, np.linspace(0, 500, 17), column) for column in rows.T]) for at in k]
    found = between(*table.along(table.lines(k[[0, -1], None]), table.place(w)), shares(k))
    assert np.allclose(found[[0, 2]], [line[0], line[2]], atol=1e-5)
    assert np.allclose(found[1], line[0] + (line[2] - line[0]) * shares(k)[1], atol=1e-5)


def test_each_place_at_its_own_distance_is_the_same_as_line_by_line(table):
    k, w = np.array([[0.0], [77.7], [499.0], [600.0]]), np.random.default_rng(4).uniform(-1.5, 1.5, (4, 50))
    one_by_one = [table.along(table.line(at), table.place(places)) for at, places in zip(k[:, 0], w)]
    assert np.allclose(table.each(k, w), one_by_one, atol=1e-6)


def test_interpolation_between_neighbours_reaches_both():
    values = np.array([1.0, 3.0, 7.0], np.float32)
    assert beside(values, np.array([0, 0, 1, 1]), np.array([0.0, 0.5, 0.25, 1.0], np.float32)).tolist() == [1, 2, 4, 7]


@pytest.mark.parametrize("first, last", [(0, 40), (5, 40), (-3, 60), (0, 2e9)])
@pytest.mark.parametrize("stretch", [1.0, 1e4, 1e9])
def test_places_are_held_where_one_of_them_lies_outside(first, last, stretch):
    whole = np.floor(np.linspace(0.2, 35.0, 50) * np.array([[1.0], [stretch]])).astype(np.float32)
    index, held = held_places(whole, first, int(last))
    assert np.array_equal(index, np.clip(whole.astype(np.int64) + first, 0, int(last)))
    assert held or np.array_equal(index, whole.astype(np.int64) + first)
    assert index.dtype == np.int32
