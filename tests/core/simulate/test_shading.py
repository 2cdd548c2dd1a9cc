"""Relief, light and cover of the ground."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.camera import Camera, Pose
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer, Window
from skyline_viewshed.core.simulate.patch import TerrainPatch
from skyline_viewshed.core.simulate.render import render_view
from skyline_viewshed.core.simulate.scene import SceneOptions
from skyline_viewshed.core.simulate.shading import Ground, Relief, cosine, shade_ground, sun_vector


def test_a_wall_shades_the_ground_behind_it():
    elevation = np.full((240, 240), 100.0, np.float32)
    elevation[:, 118:120] = 500.0  # a wall from north to south
    terrain = ArrayTerrain(elevation, 20.0)
    longitude, latitude = terrain.position_of(160, 200)
    options = {"snow_line_m": 9e3, "tree_line_m": -9e3, "texture": 0.0, "noise": 0.0, "sun_elevation_deg": 30.0}
    picture = [
        render_view(
            terrain,
            Observer(longitude, latitude, 60.0),
            Camera(120, 90, 90.0),
            Pose(0.0, -10.0),
            SceneOptions(1, sun_azimuth_deg=azimuth, exposure_ev=0.0, **options),
        )
        for azimuth in (270.0, 90.0)
    ]
    # With the sun in the west the shadow reaches 400 / tan(30) = 690 m to the east of the wall.
    east = picture[0].east_m + (160 - 119.5) * 20.0
    flat = np.isfinite(east) & (picture[0].elevation_m < 110)
    near, beyond = flat & (east > 150) & (east < 600), flat & (east > 900) & (east < 1500)
    assert near.sum() > 50 and beyond.sum() > 50
    in_west, in_east = (p.pixels.mean(axis=-1) for p in picture)
    assert in_west[near].mean() < 0.75 * in_west[beyond].mean()
    assert in_east[near].mean() > 0.85 * in_east[beyond].mean()


def plane(east=0.0, north=0.0, level=1000.0, **scene):
    """Relief of a plane that rises by so much per metre, with the sun in the south-east unless said otherwise."""
    axis = (np.arange(201) - 100) * 20.0
    elevation = (level + east * axis[None, :] - north * axis[:, None]).astype(np.float32)
    frame = ArrayTerrain(elevation, 20.0).frame(0.0, 0.0, 2000.0)
    return Relief(TerrainPatch(elevation, Window(0, 0, 201, 201)), frame, SceneOptions(**scene))


PLACES = np.array([-300.0, 0.0, 410.0]), np.array([200.0, 0.0, -150.0])


def test_the_slopes_of_a_plane_are_its_own_and_it_shades_nothing():
    slope_east, slope_north, sunlit, openness = plane(0.2, -0.1).at(*PLACES)
    assert slope_east == pytest.approx(0.2, abs=1e-3) and slope_north == pytest.approx(-0.1, abs=1e-3)
    assert sunlit == pytest.approx(1.0)
    assert np.ptp(openness) < 0.02


def test_ground_that_falls_away_from_a_low_sun_lies_in_its_own_shadow():
    steep = {"sun_azimuth_deg": 90.0, "sun_elevation_deg": 20.0}  # tan 20 = 0.36
    assert plane(east=0.6, **steep).at(*PLACES)[2] == pytest.approx(0.0)
    assert plane(east=0.2, **steep).at(*PLACES)[2] == pytest.approx(1.0)
    assert plane(east=-0.6, **steep).at(*PLACES)[2] == pytest.approx(1.0)


def test_a_hollow_sees_less_sky_than_a_crest():
    axis = (np.arange(201) - 100) * 20.0
    waves = (300 * np.cos(2 * np.pi * axis / 2000))[None, :].repeat(201, axis=0).astype(np.float32)
    frame = ArrayTerrain(waves, 20.0).frame(0.0, 0.0, 2000.0)
    relief = Relief(TerrainPatch(waves, Window(0, 0, 201, 201)), frame, SceneOptions())
    crest, hollow = relief.at(np.array([0.0, 1000.0]), np.zeros(2))[3]
    assert crest > hollow + 0.2


@pytest.mark.parametrize(
    ("azimuth", "elevation", "vector"),
    [(0, 0, (0, 1, 0)), (90, 0, (1, 0, 0)), (200, 90, (0, 0, 1)), (270, 30, (-np.sqrt(3) / 2, 0, 0.5))],
)
def test_the_sun_s_direction_is_clockwise_from_north(azimuth, elevation, vector):
    scene = SceneOptions(sun_azimuth_deg=azimuth, sun_elevation_deg=elevation)
    assert sun_vector(scene) == pytest.approx(vector, abs=1e-12)


def test_light_falls_by_the_cosine_to_the_surface_s_normal():
    up, south = np.array([0, 0, 1.0]), np.array([0, -np.sqrt(0.5), np.sqrt(0.5)])
    assert cosine(0.0, 0.0, up) == 1.0
    assert cosine(0.0, 1.0, south) == pytest.approx(1.0)  # rises to the north at 45 degrees, so it faces south
    assert cosine(0.0, -1.0, south) == pytest.approx(0.0, abs=1e-12)


def colour_of(relief, scene, levels, height=1000.0):
    count = 40
    east = np.linspace(-400, 400, count)
    far = np.full(count, 3000.0)
    sight = np.repeat([[0.0, -0.8, 0.6]], count, axis=0)
    ground = Ground(east, 0 * east, np.full(count, height), far, sight, np.full(count, 3.0))
    return shade_ground(ground, relief, scene, np.full(3, 2.0), np.full(3, 0.3), levels).mean(axis=0)


def test_snow_is_bright_forest_dark_and_water_darkest():
    relief, scene = plane(texture=0.0), SceneOptions(texture=0.0)
    snow, grass, forest = (colour_of(relief, scene, levels) for levels in ((-9e3, -9e3), (800.0, 9e3), (9e3, 9e3)))
    assert snow.mean() > 4 * grass.mean() > 4 * forest.mean()
    water = SceneOptions(texture=0.0, lake_elevation_m=1000.0)
    assert colour_of(plane(texture=0.0), water, (-9e3, -9e3)).mean() < 0.2 * snow.mean()
