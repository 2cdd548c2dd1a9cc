from __future__ import annotations

import numpy as np
import pytest
from scenes import small_mountains
from scipy.ndimage import gaussian_filter
from skyline_viewshed.core.simulate.roughness import fractal_field, roughness
from skyline_viewshed.demo.mountains import MountainOptions, make_mountains


def test_a_seed_gives_one_range_and_another_seed_another():
    options = MountainOptions(size=64, cell_m=200.0)
    first, again = make_mountains(5, options), make_mountains(5, options)
    assert np.array_equal(first.elevation_m, again.elevation_m)
    assert np.abs(first.elevation_m - make_mountains(6, options).elevation_m).mean() > 50


def test_relief_and_slopes_are_those_of_mountains():
    terrain = small_mountains()
    elevation = terrain.elevation_m.astype(float)
    assert elevation.max() - elevation.min() == pytest.approx(2400, rel=0.1)
    slope = np.degrees(np.arctan(np.hypot(*np.gradient(elevation, terrain.cell_m))))
    assert 12 < np.median(slope) < 35
    assert np.percentile(slope, 99) < 62


def test_valleys_drain():
    """Rivers carved it: few cells lie in closed hollows, unlike in noise of the same relief."""

    def hollows(height):
        inner = height[1:-1, 1:-1]
        around = [
            height[1 + dr : height.shape[0] - 1 + dr, 1 + dc : height.shape[1] - 1 + dc]
            for dr in (-1, 0, 1)
            for dc in (-1, 0, 1)
            if dr or dc
        ]
        return (inner < np.min(around, axis=0)).mean()

    terrain = small_mountains().elevation_m.astype(float)[::3, ::3]
    shuffled = np.random.Generator(np.random.PCG64(1)).permutation(terrain.ravel()).reshape(terrain.shape)
    assert hollows(terrain) < 0.03 < hollows(shuffled)


def test_roughness_of_a_window_is_the_same_as_in_the_whole():
    surface = np.add.outer(np.arange(200.0), np.arange(220.0)) * 5
    whole = roughness(surface, 10.0, 40.0, seed=3)
    part = roughness(surface[60:160, 50:150], 10.0, 40.0, seed=3, origin_px=(60, 50))
    np.testing.assert_allclose(part[30:-30, 30:-30], whole[90:130, 80:120], atol=1e-3)


def test_flat_ground_stays_flat():
    assert np.abs(roughness(np.full((64, 64), 100.0), 10.0, 40.0, seed=3)).max() == 0


def test_senseless_options_are_refused():
    with pytest.raises(ValueError, match="at least 16"):
        MountainOptions(size=4)


def test_a_field_has_no_waves_longer_than_asked():
    field = fractal_field(4, 1.7, 256, 16.0)
    assert gaussian_filter(field, 20, mode="wrap").std() < 0.05
