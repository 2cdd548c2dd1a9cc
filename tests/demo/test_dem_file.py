"""Invented terrain lies in its file where it lay in memory."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.terrain import ArrayTerrain, Window
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.demo.dem_file import write_dem


@pytest.mark.parametrize("latitude_deg", [0.0, 46.0, -70.0])
def test_synthetic_terrain_keeps_its_ground(tmp_path, latitude_deg):
    relief = np.random.default_rng(5).normal(2000, 300, (301, 401)).astype(np.float32)
    write_dem(tmp_path / "a.tif", relief, 30.0, 8.0, latitude_deg)
    found, in_memory = open_dem(tmp_path / "a.tif"), ArrayTerrain(relief, 30.0, 8.0, latitude_deg)
    assert np.array_equal(found.read(Window(0, 0, 301, 401)), relief)
    assert found.pixel_of(8.0, latitude_deg) == pytest.approx((200, 150), abs=1e-6)
    # From the centre, distances and azimuths are those of the array.
    frame = found.frame(8.0, latitude_deg, 6000.0)
    assert frame.convergence_deg == pytest.approx(0, abs=1e-6)
    assert frame.to_pixel(3000.0, -1500.0) == pytest.approx((300, 200), abs=1e-4)
    # The array's own positions are a plate carree: 0.7 % of the distance from the centre at most.
    col, row = in_memory.pixel_of(*found.position_of(300.0, 50.0))
    assert np.hypot(col - 300, row - 50) < 0.01 * np.hypot(100, 100)


def test_away_from_the_centre_the_columns_turn_as_meridians_do(tmp_path):
    write_dem(tmp_path / "a.tif", np.full((401, 401), 900.0, np.float32), 50.0, 8.0, 46.0)
    found = open_dem(tmp_path / "a.tif")
    place = found.position_of(300.0, 200.0)  # 5 km east
    convergence_deg = found.frame(*place, 1000.0).convergence_deg
    assert abs(convergence_deg) == pytest.approx(np.degrees(5000 / 6_389_000 * np.tan(np.radians(46))), rel=0.02)
