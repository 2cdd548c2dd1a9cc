"""The local frame: exact where it is affine, faithful where the raster's grid bends."""

import numpy as np
import pytest
from skyline_viewshed.core.frame import tabulate_frame


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
