import numpy as np
import pytest
from skyline_viewshed.core.base.frame import tabulate_frame
from skyline_viewshed.core.horizon.rays import lay_rays


def frame(col=40.0, row=30.0, cell=10.0, bend=0.0):
    return tabulate_frame(
        0, 0, lambda e, n: (col + (e + bend * n**2) / cell, row - n / cell), 5_000.0, size=129 if bend else 3
    )


def test_rays_end_at_the_outer_cells_edges():
    rays = lay_rays(frame(), (61, 101), np.arange(0, 360, 45.0), 5_000.0)
    assert rays.reach_m[0] == pytest.approx(305.0)
    assert rays.reach_m[2] == pytest.approx(605.0)
    assert rays.reach_m[4] == pytest.approx(305.0)
    assert rays.reach_m[6] == pytest.approx(405.0)
    assert rays.reach_m[1] == pytest.approx(305.0 * np.sqrt(2))


def test_rays_end_at_the_range_where_the_raster_is_larger():
    rays = lay_rays(frame(), (61, 101), np.arange(0, 360, 10.0), 200.0)
    assert np.allclose(rays.reach_m, 200.0)


@pytest.mark.parametrize("bend", [0.0, 2e-5])
def test_positions_are_those_of_the_frame(bend):
    place = frame(bend=bend)
    azimuth = np.array([3.0, 77.0, 181.0, 290.0])
    rays = lay_rays(place, (1000, 1000), azimuth, 5_000.0)
    distance = np.array([50.0, 333.0, 4_321.0])
    turn = np.radians(azimuth)[:, None]
    expected = place.to_pixel(distance * np.sin(turn), distance * np.cos(turn))
    assert np.allclose(rays.at(distance), expected, atol=0.05)
    col, row = rays.at_pairs(np.array([0, 3]), np.array([333.0, 4_321.0]))
    assert np.allclose(
        [col, row], [[expected[0][0, 1], expected[0][3, 2]], [expected[1][0, 1], expected[1][3, 2]]], atol=0.05
    )


def test_an_observer_on_the_corner_has_no_reach_outwards():
    rays = lay_rays(frame(col=-0.5, row=-0.5), (50, 50), np.array([135.0, 315.0]), 5_000.0)
    assert rays.reach_m[0] > 600
    assert rays.reach_m[1] == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize("bend", [0.0, 2e-5])
@pytest.mark.parametrize(("row", "col"), [(500.0, 500.0), (3.0, 980.0)])
def test_columns_hold_all_that_rays_touch_between_two_rows(bend, row, col):
    rays = lay_rays(frame(col, row, bend=bend), (1000, 1000), np.arange(0, 360, 0.5), 3_500.0)
    touched_col, touched_row = rays.at(np.linspace(0, 3_500.0, 701))
    reached = np.linspace(0, 3_500.0, 701) <= rays.reach_m[:, None]
    spared = 0
    for first in range(0, 1000, 50):
        left, right = rays.columns(first, first + 49, 4)
        between = reached & (touched_row >= first) & (touched_row <= first + 49)
        if between.any():
            assert left <= touched_col[between].min() - 4 and right >= touched_col[between].max() + 4
            spared += 1000 - (right - left)
    assert spared > 1000
    assert lay_rays(frame(), (61, 101), np.arange(0, 360, 45.0), 5_000.0).columns(0, 10, 4) is None
