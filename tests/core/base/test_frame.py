"""The local frame: exact where it is affine, faithful where the raster's grid bends."""

import numpy as np
import pytest
from skyline_viewshed.core.base import frame as frame_module
from skyline_viewshed.core.base.frame import tabulate_frame


def turned_grid(angle_deg, cell_m=30.0, south_up=False):
    """A plane grid whose columns point `angle_deg` clockwise from north."""
    angle = np.radians(angle_deg)
    sign = 1.0 if south_up else -1.0

    def transform(east, north):
        across = east * np.cos(angle) - north * np.sin(angle)
        along = east * np.sin(angle) + north * np.cos(angle)
        return 100 + across / cell_m, 200 + sign * along / cell_m

    return transform


@pytest.mark.parametrize("angle", [-104.5, -2.19, 0.0, 35.0, 170.0])
@pytest.mark.parametrize("south_up", [False, True])
def test_convergence_is_the_bearing_of_grid_north(angle, south_up):
    frame = tabulate_frame(0, 0, turned_grid(angle, south_up=south_up), 5000)
    assert frame.convergence_deg == pytest.approx(angle, abs=1e-6)
    assert frame.row_goes_south is not south_up
    assert frame.cell_size_m == pytest.approx((30, 30))
    assert frame.remainder_px is None


def test_a_bent_grid_round_trips_well_below_a_hundredth_of_a_cell():
    def bent(east, north):
        # What a longitude-latitude grid at 60 degrees north does to 200 km.
        return 500 + (east + east * north * 2.7e-7) / 30, 500 - (north - east**2 * 1.4e-7) / 30

    frame = tabulate_frame(0, 60, bent, 100_000)
    assert frame.remainder_px is not None
    rng = np.random.default_rng(1)
    east, north = rng.uniform(-99_000, 99_000, (2, 500))
    col, row = frame.to_pixel(east, north)
    exact_col, exact_row = bent(east, north)
    assert np.abs(col - exact_col).max() < 0.02
    assert np.abs(row - exact_row).max() < 0.02
    back_east, back_north = frame.to_local(col, row)
    assert np.abs(back_east - east).max() < 0.1
    assert np.abs(back_north - north).max() < 0.1


def test_corners_outside_the_projection_s_domain_do_not_spoil_the_rest():
    def partial(east, north):
        col = 10 + np.asarray(east, float) / 30
        return np.where(np.hypot(east, north) > 9e4, np.inf, col), 10 - np.asarray(north, float) / 30

    frame = tabulate_frame(0, 0, partial, 80_000)
    assert np.allclose(frame.to_pixel(300.0, 0.0), (20, 10))


def bent_grid(east, north):
    """A smooth grid with terms of high order, as none of the usual projections has in so small a range."""
    x, y = np.asarray(east, float) / 1e5, np.asarray(north, float) / 1e5
    return 500 + east / 30 + 9 * np.sin(2 * x + y) * y, 400 - north / 30 + 5 * np.exp(x * y)


def kinked_grid(east, north):
    return 500 + east / 30 + np.abs(np.asarray(east, float) - 3333.0) / 300, 400 - np.asarray(north, float) / 30


@pytest.mark.parametrize("grid", [bent_grid, kinked_grid])
def test_a_table_filled_from_a_polynomial_is_that_of_the_exact_points(grid, monkeypatch):
    asked = []

    def transform(east, north):
        asked.append(np.size(east))
        return grid(east, north)

    quick = tabulate_frame(0, 60, transform, 100_000)
    monkeypatch.setattr(frame_module, "_polynomial_table", lambda *_: None)
    exact = tabulate_frame(0, 60, grid, 100_000)
    assert np.abs(quick.remainder_px - exact.remainder_px).max() < 1e-3
    if grid is bent_grid:
        assert sum(asked) < 400, "a few hundred points suffice"
    else:
        np.testing.assert_array_equal(quick.remainder_px, exact.remainder_px)


def test_places_beyond_the_table_and_without_a_number_do_no_harm():
    frame = tabulate_frame(0, 60, bent_grid, 100_000)
    col, row = frame.to_pixel(np.array([0.0, np.nan, 5e5]), np.zeros(3))
    assert np.isfinite(col[[0, 2]]).all() and np.isnan(col[1]) and np.isfinite(row[[0, 2]]).all()
