import numpy as np
import pytest
from skyline_viewshed.core.base.curvature import apparent_drop_m
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer
from skyline_viewshed.core.horizon.ground_rays import RayOptions, cast_ground_rays
from skyline_viewshed.core.horizon.inner import InnerOptions, ground_view, inner_terrain
from skyline_viewshed.core.horizon.ridges import RidgeOptions, occlusion_edges
from skyline_viewshed.demo.mountains import MountainOptions, make_mountains


def test_ridges_and_ground_come_from_the_same_rays():
    terrain = make_mountains(5, MountainOptions(size=200, cell_m=60.0, relief_m=1500.0))
    observer = Observer(terrain.longitude_deg, terrain.latitude_deg, 100.0)
    inner = inner_terrain(terrain, observer)
    edges = occlusion_edges(cast_ground_rays(terrain, observer))
    assert len(edges.azimuth_deg) > 100
    assert np.array_equal(inner.ridges.azimuth_deg, edges.azimuth_deg)
    # Just below a crest the ground lies at the crest's own distance.
    below = inner.ground.at(edges.azimuth_deg, edges.elevation_deg - 0.3)[3]
    known = np.isfinite(below)
    assert np.median(np.abs(below[known] - np.log(edges.distance_m[known]))) < 0.05


def test_options_reach_both():
    terrain = make_mountains(5, MountainOptions(size=200, cell_m=60.0, relief_m=1500.0))
    observer = Observer(terrain.longitude_deg, terrain.latitude_deg, 100.0)
    few = inner_terrain(terrain, observer, InnerOptions(RayOptions(azimuth_step_deg=1.0), RidgeOptions(least_jump=3.0)))
    assert few.ground.planes.shape[2] == 360
    assert (few.ridges.jump >= 3.0).all()


def test_a_tiny_terrain_has_neither():
    terrain, options = ArrayTerrain(np.zeros((4, 4), np.float32), 5.0), InnerOptions(RayOptions(max_distance_m=250.0))
    inner = inner_terrain(terrain, Observer(0.0, 0.0), options)
    assert inner.ground is None and len(inner.ridges.azimuth_deg) == 0


CELL = 50.0
EYE = Observer(0.0, 0.0, 200.0)


def view_of(height, options=None):
    axis = (np.arange(401) - 200) * CELL
    east, north = np.meshgrid(axis, -axis)
    terrain = ArrayTerrain(height(east, north).astype(np.float32), CELL)
    return ground_view(cast_ground_rays(terrain, EYE, options or RayOptions()))


@pytest.mark.parametrize("east_slope, north_slope", [(0.0, 0.0), (0.2, 0.0), (0.0, -0.3), (-0.15, 0.1)])
def test_a_ramp_shows_its_own_normal_in_all_directions(east_slope, north_slope):
    view = view_of(lambda e, n: east_slope * e + north_slope * n)
    normal = np.array([-east_slope, -north_slope, 1.0])
    normal /= np.linalg.norm(normal)
    azimuth, elevation = np.meshgrid(np.arange(0.0, 360.0, 7.0), np.arange(-8.0, -4.0))
    seen = view.at(azimuth, elevation)[:3]
    known = np.isfinite(seen).all(axis=0)
    assert known.mean() > 0.4
    assert np.abs(seen[:, known] - normal[:, None]).max() < 2e-3


def test_ground_is_as_far_as_the_sight_line_says():
    elevation = np.arange(-9.0, -2.0)
    log_distance = view_of(lambda e, n: 0 * e).at(np.full(elevation.shape, 33.0), elevation)[3]
    distance = np.exp(log_distance)
    fallen = distance * np.tan(np.radians(-elevation)) - apparent_drop_m(distance)
    assert fallen == pytest.approx(200.0, rel=0.035)


def test_the_nearer_of_two_walls_is_seen_and_the_sky_above_them_is_unknown():
    def walls(east, north):
        near = np.where(np.abs(north - 3000) < 200, 250.0, 0.0)
        return near + np.where(np.abs(north - 7000) < 200, 900.0, 0.0)

    view = view_of(walls)
    tangent = np.array([30.0 / 2850, 400.0 / 6850, 900.0 / 6850])
    _, _, _, log_distance, height_km = view.at(np.zeros(3), np.degrees(np.arctan(tangent)))
    assert np.exp(log_distance[0]) == pytest.approx(2850, abs=2.5 * CELL)
    assert np.exp(log_distance[1]) == pytest.approx(6850, abs=2.5 * CELL)
    assert 0.2 < height_km[1] < 0.9
    assert np.isnan(log_distance[2])


def test_ground_nearer_than_the_rays_is_unknown():
    assert np.isnan(view_of(lambda e, n: 0 * e).at(np.array([90.0]), np.array([-50.0]))).all()


def test_any_azimuth_and_elevation_may_be_asked_for():
    view = view_of(lambda e, n: 0.05 * e)
    north = view.at(np.array([-0.01, 359.99, 360.0, 720.0]), np.full(4, -5.0))
    assert (north == north[:, :1]).all()
    assert np.isnan(view.at(np.zeros(2), np.array([-89.0, 89.0]))).all()


def test_without_ground_there_is_no_view():
    assert view_of(lambda e, n: 0 * e, options=RayOptions(max_distance_m=200.0)) is None
