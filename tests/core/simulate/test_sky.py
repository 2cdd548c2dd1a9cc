"""Light, haze and clouds."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.simulate.scene import SceneOptions
from skyline_viewshed.core.simulate.sky import (
    clouds_before,
    clouds_behind,
    daylight,
    sky_radiance,
    sun_light,
    transmission,
)


def test_haze_grows_with_distance_and_thins_with_height():
    distance = np.array([0.0, 1e3, 1e4, 5e4])
    low = transmission(distance, 500.0, np.full(4, 500.0), 40_000.0)
    high = transmission(distance, 4000.0, np.full(4, 4000.0), 40_000.0)
    assert (low[0] == 1).all()
    assert (np.diff(low, axis=0) < 0).all()
    assert (high[1:] > low[1:]).all()
    assert (low[1:, 2] < low[1:, 0]).all()  # blue goes first


def test_a_low_sun_is_weak_and_red():
    high, low = sun_light(50.0), sun_light(2.0)
    assert low.sum() < high.sum()
    assert low[0] / low[2] > 1.5 * high[0] / high[2]


def test_the_sky_pales_towards_the_horizon_and_glows_at_the_sun():
    scene = SceneOptions(sun_azimuth_deg=100.0, sun_elevation_deg=30.0)
    zenith, horizon = (sky_radiance(np.array([90.0]), np.array([t]), scene, 100.0)[0] for t in (3.0, 0.0))
    assert horizon[0] / horizon[2] > zenith[0] / zenith[2]
    at_sun = sky_radiance(np.array([0.0]), np.array([np.tan(np.radians(30.0))]), scene, 100.0)[0]
    beside = sky_radiance(np.array([90.0]), np.array([np.tan(np.radians(30.0))]), scene, 100.0)[0]
    assert at_sun.mean() > 2 * beside.mean()


def test_light_through_two_stretches_of_level_air_is_the_product_of_both():
    level = np.full(3, 800.0)
    first, second, both = transmission(np.array([4e3, 7e3, 11e3]), 800.0, level, 30_000.0)
    assert first * second == pytest.approx(both, rel=1e-5)


def test_the_air_between_two_heights_does_not_care_which_end_one_stands_at():
    up = transmission(np.array([9e3]), 500.0, np.array([3500.0]), 30_000.0)
    down = transmission(np.array([9e3]), 3500.0, np.array([500.0]), 30_000.0)
    assert up == pytest.approx(down, rel=1e-6)


def directions(rows=60, cols=90):
    turn, degrees = np.meshgrid(np.linspace(-30, 30, cols), np.linspace(20, -10, rows))
    return turn, np.tan(np.radians(degrees))


@pytest.mark.parametrize("clouds", ["none", "behind"])
def test_without_cloud_before_the_terrain_nothing_is_hidden(clouds):
    turn, tangent = directions()
    distance = np.where(tangent < 0, 5e3, np.inf)
    opacity, _ = clouds_before(turn, tangent, 0 * tangent, distance, 0 * tangent, SceneOptions(clouds=clouds))
    assert not opacity.any()


def test_fog_hides_the_far_and_spares_the_near():
    turn, tangent = directions()
    distance = np.where(tangent < -0.1, 200.0, 6000.0)
    opacity, _ = clouds_before(turn, tangent, 0 * tangent, distance, 0 * tangent, SceneOptions(clouds="fog"))
    assert not opacity[distance < 300].any()
    assert opacity[distance > 2500].min() > 0.9


def test_a_lid_hangs_about_the_ridge_over_the_share_asked():
    turn, tangent = directions()
    covered = []
    for share in (0.2, 0.5, 0.8):
        scene = SceneOptions(seed=3, clouds="lid", cloud_share=share)
        opacity, _ = clouds_before(turn, tangent, 0 * tangent, np.full(turn.shape, 5e3), 0 * tangent, scene)
        ridge = np.abs(np.degrees(np.arctan(tangent))) < 0.6
        covered.append((opacity[ridge] > 0.5).mean())
        assert not opacity[-1].any(), "ground far below the ridge is free"
    assert covered[0] < covered[1] < covered[2]
    assert covered[1] == pytest.approx(0.5, abs=0.3)


def test_more_cloud_covers_more_sky_and_dims_the_sun():
    turn, tangent = directions()
    scenes = [SceneOptions(seed=2, clouds="behind", cloud_share=share) for share in (0.1, 0.5, 0.9)]
    cover = [clouds_behind(turn, tangent, scene)[0].mean() for scene in scenes]
    assert 0 <= cover[0] < cover[1] < cover[2] < 1
    (clear_sun, _), (grey_sun, grey_sky) = daylight(scenes[0]), daylight(scenes[2])
    assert grey_sun.sum() < 0.3 * clear_sun.sum()
    assert np.ptp(grey_sky) / grey_sky.mean() < 0.3
