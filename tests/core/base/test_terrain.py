"""Terrain in memory: windows, sampling between cells, the ground under an observer."""

import numpy as np
import pytest
from skyline_viewshed.core.base.errors import NoElevationAtObserverError, ObserverOutsideDemError
from skyline_viewshed.core.base.terrain import (
    ArrayTerrain,
    Observer,
    Window,
    bilinear,
    eye_elevation_m,
    ground_elevation_m,
)

PLANE = np.add.outer(10.0 * np.arange(6), 3.0 * np.arange(7)).astype(np.float32)


def test_bilinear_is_exact_on_a_plane():
    rng = np.random.default_rng(2)
    row, col = rng.uniform(0, 5, 50), rng.uniform(0, 6, 50)
    assert np.allclose(bilinear(PLANE, row, col), 10 * row + 3 * col, atol=1e-5)


def test_bilinear_knows_nothing_outside_and_holds_the_edge_for_half_a_cell():
    values = bilinear(PLANE, [-0.6, -0.4, 5.4, 5.6, np.nan], [0, 0, 0, 0, 0])
    assert np.isnan(values[[0, 3, 4]]).all()
    assert values[1] == PLANE[0, 0] and values[2] == PLANE[5, 0]


def test_an_unknown_cell_spoils_only_samples_that_give_it_weight():
    elevation = PLANE.copy()
    elevation[2, 2] = np.nan
    values = bilinear(elevation, [2.0, 2.0, 2.0], [1.0, 1.5, 3.0])
    assert np.isfinite(values).tolist() == [True, False, True]


def test_a_window_is_cut_to_the_raster():
    assert Window(-3, 4, 10, 10).clipped((6, 7)) == Window(0, 4, 6, 3)
    assert Window(20, 20, 5, 5).clipped((6, 7)).rows == 0


def test_positions_and_pixels_of_an_array_are_inverse():
    terrain = ArrayTerrain(PLANE, 30.0, 8.0, 46.0)
    assert np.allclose(terrain.pixel_of(*terrain.position_of(1.25, 4.5)), (1.25, 4.5))


def frame_at(terrain, col, row):
    return terrain.frame(*terrain.position_of(col, row), 100.0)


def test_the_eye_stands_on_the_ground_unless_its_elevation_is_given():
    terrain = ArrayTerrain(PLANE, 30.0)
    frame = frame_at(terrain, 2.5, 1.5)
    ground = 15 + 7.5
    assert ground_elevation_m(terrain, frame) == pytest.approx(ground, abs=1e-3)
    assert eye_elevation_m(terrain, frame, Observer(0, 0)) == pytest.approx(ground + 1.7, abs=1e-3)
    assert eye_elevation_m(terrain, frame, Observer(0, 0, eye_elevation_m=99.0)) == 99.0


def test_positions_off_the_raster_or_on_a_void_say_so():
    elevation = PLANE.copy()
    elevation[0:3, 0:3] = np.nan
    terrain = ArrayTerrain(elevation, 30.0)
    with pytest.raises(ObserverOutsideDemError, match="outside the DEM"):
        ground_elevation_m(terrain, frame_at(terrain, 40, 2))
    with pytest.raises(NoElevationAtObserverError, match="nodata"):
        ground_elevation_m(terrain, frame_at(terrain, 1, 1))


def test_beside_a_void_the_known_neighbours_speak():
    elevation = PLANE.copy()
    elevation[0, 0] = np.nan
    terrain = ArrayTerrain(elevation, 30.0)
    ground = ground_elevation_m(terrain, frame_at(terrain, 0.5, 0.5))
    assert ground == pytest.approx(np.mean([3, 10, 13]), abs=1e-3)


@pytest.mark.parametrize("step", [1, -1])
def test_terrain_is_read_into_memory_in_any_order(step):
    class OfItsOwn(ArrayTerrain):
        def read_into(self, window, out):
            out[...] = self.read(window) + 1000

    window, memory = Window(1, 2, 3, 4), np.zeros((9, 9), np.float32)
    ArrayTerrain(PLANE, 1.0).read_into(window, memory[2:5, 1:5][::step])
    assert np.array_equal(memory[2:5, 1:5][::step], PLANE[1:4, 2:6])
    assert memory.sum() == pytest.approx(PLANE[1:4, 2:6].sum())
    OfItsOwn(PLANE, 1.0).read_into(window, memory[2:5, 1:5][::step])
    assert np.array_equal(memory[2:5, 1:5][::step], PLANE[1:4, 2:6] + 1000)
