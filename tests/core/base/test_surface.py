from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base import surface
from skyline_viewshed.core.base.camera import Camera, Pose
from skyline_viewshed.core.base.posed import PosedPhoto
from skyline_viewshed.core.base.surface import (
    elevation_at,
    incidence_deg,
    normal_at,
    normal_of,
    sample_pixels,
    sampling_distance_m,
)
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer, Window, bilinear
from skyline_viewshed.core.base.view import open_view


def tilted(size=61, east=0.5, north=-0.25):
    """A plane that rises to the east and falls to the north."""
    row, col = np.mgrid[:size, :size]
    return ArrayTerrain((10 * (east * col - north * row)).astype(np.float32), 10.0)


def test_tiles_give_what_the_whole_array_gives(monkeypatch):
    rng = np.random.default_rng(0)
    terrain = ArrayTerrain(rng.uniform(0, 100, (90, 70)).astype(np.float32), 10.0)
    col, row = rng.uniform(-3, 73, 500), rng.uniform(-3, 93, 500)
    expected = bilinear(terrain.elevation_m, row, col)
    monkeypatch.setattr(surface, "TILE_CELLS", 16)
    assert sample_pixels(terrain, col, row) == pytest.approx(expected, nan_ok=True)
    assert np.isnan(expected).any() and np.isfinite(expected).any()


def test_no_more_than_tiles_is_read(monkeypatch):
    class Counting(ArrayTerrain):
        largest = 0

        def read(self, window):
            Counting.largest = max(Counting.largest, window.rows * window.cols)
            return super().read(window)

    monkeypatch.setattr(surface, "TILE_CELLS", 16)
    terrain = Counting(np.zeros((400, 400), np.float32), 10.0)
    sample_pixels(terrain, np.array([5.0, 390.0]), np.array([5.0, 390.0]))
    assert Counting.largest < 400


def test_normals_of_a_plane_are_its_normal_everywhere():
    terrain = tilted()
    frame = terrain.frame(0, 0, 300)
    places = np.array([-105.0, 0.0, 33.3]), np.array([7.0, 0.0, -61.0])
    expected = np.array([-0.5, 0.25, 1.0]) / np.linalg.norm([-0.5, 0.25, 1.0])
    assert normal_at(terrain, frame, *places) == pytest.approx(np.repeat(expected[:, None], 3, axis=1), abs=1e-5)
    z = terrain.read(Window(0, 0, 61, 61))
    cells = normal_of(z, np.array([0.0, 30.0, 60.0]), np.array([0.0, 20.0, 60.0]), frame)
    assert np.array(cells) == pytest.approx(np.repeat(expected[:, None], 3, axis=1), abs=1e-5)
    assert elevation_at(terrain, frame, 0.0, 0.0) == pytest.approx(10 * (0.5 * 30 + 0.25 * 30), abs=1e-3)


def test_incidence_is_zero_head_on_and_ninety_along_the_ground():
    up = np.array([[0.0], [0.0], [1.0]])
    assert incidence_deg(up, np.array([0.0]), np.array([-90.0])) == pytest.approx(0, abs=1e-6)
    assert incidence_deg(up, np.array([77.0]), np.array([0.0])) == pytest.approx(90)
    south_wall = np.array([[0.0], [-1.0], [0.0]])
    assert incidence_deg(south_wall, np.array([0.0]), np.array([0.0])) == pytest.approx(0, abs=1e-5)


def test_a_void_has_neither_elevation_nor_normal():
    z = np.zeros((30, 30), np.float32)
    z[15, 15] = np.nan
    terrain = ArrayTerrain(z, 10.0)
    frame = terrain.frame(*terrain.position_of(15, 15), 100)
    assert np.isnan(elevation_at(terrain, frame, 0.0, 0.0))
    assert np.isnan(normal_at(terrain, frame, np.zeros(1), np.zeros(1))).all()


def test_sampling_distance_grows_with_depth_and_obliqueness():
    view = open_view(
        tilted(east=0, north=0), PosedPhoto(Camera(100, 100, 200.0), Pose(0.0, -45.0), Observer(0, 0, 50.0)), 300.0
    )
    up = tuple(np.array([v]) for v in (0.0, 0.0, 1.0))
    across, along = sampling_distance_m(view, np.zeros(1), np.array([50.0]), np.array([-50.0]), up)
    assert across[0] == pytest.approx(np.hypot(50, 50) / 200)
    assert along[0] == pytest.approx(across[0] * np.sqrt(2))
