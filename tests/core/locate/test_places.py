import numpy as np
import pytest
from skyline_viewshed.core.locate.places import Area, AreaError, IndexOptions, check_memory, lay_places


def test_a_hole_is_outside():
    outer = ((0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0))
    inner = ((1.0, 1.0), (3.0, 1.0), (3.0, 3.0), (1.0, 3.0))
    inside = Area((outer, inner)).holds(np.array([0.5, 2.0, 3.5, 5.0]), np.array([0.5, 2.0, 3.5, 2.0]))
    assert inside.tolist() == [True, False, True, False]


def test_a_circle_has_its_radius():
    circle = np.array(Area.circle(8.0, 46.0, 5_000.0).rings[0])
    north = (circle[:, 1] - 46.0) * 111_195.0
    east = (circle[:, 0] - 8.0) * 111_195.0 * np.cos(np.radians(46.0))
    assert np.hypot(east, north) == pytest.approx(5_000.0, rel=1e-3)


def test_the_places_are_whole_cells_apart_and_fill_the_area(cone, area_of):
    grid = lay_places(cone, area_of(cone), IndexOptions(spacing_m=250.0))
    assert (grid.step_rows, grid.step_cols) in ((2, 2), (3, 3), (2, 3), (3, 2))
    assert grid.count == sum(int(tile.inside.sum()) for tile in grid.tiles)
    rows = -(-153 // grid.step_rows)
    assert grid.count == pytest.approx(rows * rows, rel=0.05)


def test_an_area_outside_the_dem_is_refused(cone):
    with pytest.raises(AreaError, match="lies inside the DEM"):
        lay_places(cone, Area.box(20.0, 10.0, 20.1, 10.1))


def test_an_area_too_large_for_the_memory_is_refused_with_the_one_that_fits(cone, area_of):
    options = IndexOptions(spacing_m=200.0, memory_mb=1.0)
    grid = lay_places(cone, area_of(cone), options)
    with pytest.raises(AreaError, match=r"at most (\d+) km2") as caught:
        check_memory(grid, options)
    fits_km2 = float(caught.value.message.facts["km2"])
    assert fits_km2 == pytest.approx(1e6 / (4 * 720) * grid.spacing_m**2 / 1e6, abs=1)


@pytest.mark.parametrize("wrong", [{"spacing_m": 0.0}, {"azimuths": 10}, {"max_distance_m": -1.0}])
def test_unusable_options_are_refused(wrong):
    with pytest.raises(ValueError, match="positive"):
        IndexOptions(**wrong)
