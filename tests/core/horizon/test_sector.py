import numpy as np
import pytest
from skyline_viewshed.core.base.terrain import Observer
from skyline_viewshed.core.horizon.horizon import HorizonOptions, horizon_profile
from skyline_viewshed.core.horizon.sector import sector_profile
from skyline_viewshed.core.simulate.example import example_terrain


@pytest.mark.parametrize("middle_deg", [0.0, 200.0])
def test_a_sector_is_a_part_of_the_circle(middle_deg):
    terrain, options = example_terrain(size=120), HorizonOptions(0.5, 4_000.0)
    observer = Observer(*map(float, terrain.position_of(60.3, 58.8)), 2.0)
    whole = horizon_profile(terrain, observer, options)
    part = sector_profile(terrain, observer, options, middle_deg, 80.0)
    away = np.abs((whole.azimuth_deg - middle_deg + 180) % 360 - 180)
    assert np.isfinite(part.elevation_deg[away < 39.9]).all() and np.isnan(part.elevation_deg[away > 41]).all()
    known = np.isfinite(part.elevation_deg)
    for name in ("elevation_deg", "distance_m"):
        assert getattr(part, name)[known] == pytest.approx(getattr(whole, name)[known], abs=1e-4)
    assert np.array_equal(part.clipped[known], whole.clipped[known])
    assert np.array_equal(part.azimuth_deg, whole.azimuth_deg)


def test_a_wide_sector_is_the_circle():
    terrain, options = example_terrain(size=80), HorizonOptions(1.0, 2_000.0)
    observer = Observer(*map(float, terrain.position_of(40.0, 40.0)), 2.0)
    assert np.array_equal(
        sector_profile(terrain, observer, options, 10.0, 400.0).elevation_deg,
        horizon_profile(terrain, observer, options).elevation_deg,
    )
