import numpy as np
from skyline_viewshed.core.ground_rays import RayOptions, cast_ground_rays
from skyline_viewshed.core.inner_terrain import InnerOptions, inner_terrain
from skyline_viewshed.core.mountains import MountainOptions, make_mountains
from skyline_viewshed.core.ridges import RidgeOptions, occlusion_edges
from skyline_viewshed.core.terrain import ArrayTerrain, Observer


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
