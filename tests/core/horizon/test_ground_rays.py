import numpy as np
import pytest
from skyline_viewshed.core.base.errors import ObserverOutsideDemError
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer
from skyline_viewshed.core.horizon.ground_rays import RayOptions, cast_ground_rays

CELL = 50.0
EYE = Observer(0.0, 0.0, 2.0)


def terrain_of(height):
    """Terrain by a function of metres east and north of the centre."""
    axis = (np.arange(401) - 200) * CELL
    east, north = np.meshgrid(axis, -axis)
    return ArrayTerrain(height(east, north).astype(np.float32), CELL)


def test_a_ramp_is_sampled_at_its_own_height():
    rays = cast_ground_rays(terrain_of(lambda e, n: 0.1 * e + 0.02 * n + 500), EYE)
    turn = np.radians(rays.azimuth_deg)[:, None]
    east, north = rays.distance_m * np.sin(turn), rays.distance_m * np.cos(turn)
    expected = 0.1 * east + 0.02 * north + 500
    # The outer half of an edge cell holds the cell's own height.
    known = np.isfinite(rays.elevation_m) & (np.maximum(np.abs(east), np.abs(north)) < 10_000)
    assert known.mean() > 0.4
    assert rays.elevation_m[known] == pytest.approx(expected[known], abs=0.05)


def test_the_tangent_is_that_of_the_sight_line_less_curvature():
    options = RayOptions(refraction_coefficient=0.0)
    rays = cast_ground_rays(terrain_of(lambda e, n: 0 * e + 30.0), EYE, options)
    expected = -2.0 / rays.distance_m - rays.distance_m / (2 * 6_371_000)
    known = np.isfinite(rays.tangent[0])
    assert rays.tangent[0][known] == pytest.approx(expected[known], rel=0.01)


@pytest.mark.parametrize("cell_m", [5.0, 30.0, 50.0, 90.0, 100.0])
def test_samples_move_outwards_by_at_least_half_a_cell(cell_m):
    terrain = ArrayTerrain(np.zeros((801, 801), np.float32), cell_m)
    steps = np.diff(cast_ground_rays(terrain, EYE).distance_m)
    assert steps.min() >= 0.49 * cell_m


def test_a_terrain_smaller_than_the_first_sample_has_no_rays():
    terrain = ArrayTerrain(np.zeros((5, 5), np.float32), 10.0)
    rays = cast_ground_rays(terrain, EYE, RayOptions(max_distance_m=200.0))
    assert rays.distance_m.size == 0 and rays.tangent.shape == (1440, 0)


def test_voids_and_the_outside_are_unknown():
    def with_hole(east, north):
        height = 0 * east
        height[np.hypot(east - 3000, north) < 400] = np.nan
        return height

    rays = cast_ground_rays(terrain_of(with_hole), EYE)
    east_ray = rays.elevation_m[360]
    assert np.isnan(east_ray[np.abs(rays.distance_m - 3000) < 200]).all()
    assert np.isfinite(east_ray[rays.distance_m < 2400]).all()
    assert np.isnan(east_ray[rays.distance_m > 10_100]).all()


def test_an_observer_outside_is_told_so():
    with pytest.raises(ObserverOutsideDemError):
        cast_ground_rays(terrain_of(lambda e, n: 0 * e), Observer(5.0, 0.0, 2.0))


def test_unusable_options_are_refused():
    with pytest.raises(ValueError, match="unusable"):
        RayOptions(growth=0.0)
