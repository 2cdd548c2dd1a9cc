import numpy as np
import pytest
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer
from skyline_viewshed.core.horizon.ground_rays import cast_ground_rays
from skyline_viewshed.core.horizon.ridges import RidgeOptions, occlusion_edges

CELL = 50.0


def terrain_of(height):
    """Terrain by a function of metres east and north of the centre."""
    axis = (np.arange(401) - 200) * CELL
    east, north = np.meshgrid(axis, -axis)
    return ArrayTerrain(height(east, north).astype(np.float32), CELL)


def edges_of(height, options=None):
    return occlusion_edges(cast_ground_rays(terrain_of(height), Observer(0.0, 0.0, 2.0)), options or RidgeOptions())


def two_walls(east, north):
    """A wall of 100 m at 2 km and one of 600 m at 6 km to the north."""
    near = np.where(np.abs(north - 2000) < 100, 100.0, 0.0)
    return near + np.where(np.abs(north - 6000) < 200, 600.0, 0.0)


def test_the_nearer_of_two_walls_is_a_crest_with_its_angle_distance_and_jump():
    edges = edges_of(two_walls)
    ahead = np.flatnonzero((edges.azimuth_deg < 1) & (edges.distance_m > 1500))
    assert len(ahead) >= 1
    assert edges.distance_m[ahead] == pytest.approx(1950, abs=CELL)
    assert edges.elevation_deg[ahead] == pytest.approx(np.degrees(np.arctan(98 / 1950)), abs=0.15)
    assert edges.jump[ahead] == pytest.approx(5850 / 1950, rel=0.05)


def test_the_horizon_itself_is_not_a_crest():
    edges = edges_of(two_walls)
    assert edges.distance_m.max() < 5700


def test_a_plain_has_no_crests():
    assert len(edges_of(lambda e, n: 0 * e).azimuth_deg) == 0


def test_turned_terrain_turns_the_crests():
    def hills(east, north):
        return 150 * np.exp(-((east - 1500) ** 2 + (north - 2500) ** 2) / 4e5) + 400 * (np.hypot(east, north) > 7000)

    straight = edges_of(hills)
    turned = edges_of(lambda e, n: hills(n, -e))
    # (n, -e) at a point is (e, n) of the point a quarter turn clockwise further on.
    assert len(straight.azimuth_deg) == len(turned.azimuth_deg)
    assert np.median((straight.azimuth_deg - turned.azimuth_deg) % 360) in (90.0, 270.0)


def test_small_jumps_and_shallow_dips_are_left_out():
    options = RidgeOptions(least_jump=3.5)
    edges = edges_of(two_walls, options)
    ahead = (edges.azimuth_deg < 1) & (edges.distance_m > 1500)
    assert not ahead.any()


def test_voids_end_a_ray_without_inventing_crests():
    def with_hole(east, north):
        height = two_walls(east, north)
        height[np.abs(north - 4000) < 300] = np.nan
        return height

    edges = edges_of(with_hole)
    assert np.isfinite(edges.elevation_deg).all()
