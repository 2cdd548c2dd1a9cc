"""Noise tiles: periodic, of unit deviation, with a true gradient."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.simulate.noise import noise_tile, power_spectrum, smoothstep, without_long_waves


def test_a_tile_repeats_without_a_seam_and_has_unit_deviation():
    tile = noise_tile(3, 1.2)
    x = np.linspace(0, 256, 500)
    here, next_door = tile.sample(x, x * 0.7), tile.sample(x + 256, x * 0.7 - 512)
    np.testing.assert_allclose(here, next_door, atol=1e-5)
    grid = np.arange(256.0)
    value = tile.sample(*np.meshgrid(grid, grid))[..., 0]
    assert value.std() == pytest.approx(1.0, abs=1e-3)
    assert abs(value.mean()) < 1e-3


def test_a_tiles_gradient_is_its_slope():
    tile = noise_tile(3, 2.0)
    x = np.linspace(3.3, 90.1, 200)
    ahead = tile.sample(x + 1.0, 20.0 + 0 * x)[:, 0] - tile.sample(x - 1.0, 20.0 + 0 * x)[:, 0]
    assert np.corrcoef(ahead / 2, tile.sample(x, 20.0 + 0 * x)[:, 1])[0, 1] > 0.99


def test_a_large_footprint_averages_the_detail_away():
    tile = noise_tile(3, 0.5)
    x = np.arange(4000) * 0.37
    spread = [tile.sample(x, 0 * x, blur)[:, 0].std() for blur in (1.0, 4.0, 16.0)]
    assert spread[0] > 1.5 * spread[1] > 2 * spread[2]


def test_smoothstep_rises_and_falls():
    assert smoothstep(0, 1, 0.5) == 0.5
    assert smoothstep(2, 1, 0.5) == 1.0 and smoothstep(2, 1, 3) == 0.0


def test_the_same_seed_gives_the_same_tile_and_another_one_another():
    spectrum, frequency = power_spectrum(3, 1.2, 64)
    assert np.array_equal(spectrum, power_spectrum(3, 1.2, 64)[0])
    assert not np.array_equal(spectrum, power_spectrum(4, 1.2, 64)[0])
    assert spectrum[0, 0] == 0 and not spectrum[frequency > 32].any()


def test_amplitudes_fall_by_the_power_asked():
    spectrum, frequency = power_spectrum(3, 1.5, 256)
    rings = [np.abs(spectrum[(frequency > low) & (frequency < 1.2 * low)]).mean() for low in (10, 20, 40, 80)]
    slopes = np.diff(np.log(rings)) / np.log(2)
    assert slopes == pytest.approx(-1.5, abs=0.15)


def test_long_waves_are_taken_out_and_short_ones_stay():
    waves_per_cell = np.array([0.0, 1 / 400, 1 / 40, 1 / 4])
    assert without_long_waves(waves_per_cell, 40.0) == pytest.approx([0.0, 0.01, 0.632, 1.0], abs=1e-3)
    assert without_long_waves(waves_per_cell[1:], np.inf) == pytest.approx(1.0)
