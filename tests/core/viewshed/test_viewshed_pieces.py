"""Viewsheds in pieces: sinks, blocks, threads, terrains that are read in windows, and how a run ends early."""

from threading import Lock, get_ident
from time import sleep

import numpy as np
import pytest
from reference.landscapes import fractal, stand
from reference.views import UNKNOWN, look, spread
from skyline_viewshed.core.base import threads
from skyline_viewshed.core.base.camera import Camera, Pose
from skyline_viewshed.core.base.errors import Cancelled, UnusableDemError
from skyline_viewshed.core.base.frame import tabulate_frame
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer, Terrain, Window
from skyline_viewshed.core.base.viewed import ArraySink, Sink
from skyline_viewshed.core.viewshed import viewshed as viewsheds
from skyline_viewshed.core.viewshed.viewshed import FullCircle, PackedSink, PhotoFrame, ViewshedOptions, Wedge, viewshed


class Bent(ArrayTerrain):
    """Cells on a grid whose lines bend and whose scale drifts, as those of a geographic CRS do."""

    def frame(self, longitude_deg, latitude_deg, radius_m):
        col, row = self.pixel_of(longitude_deg, latitude_deg)

        def to_pixel(east, north):
            return col + (east + 1e-6 * north**2) / self.cell_m, row - north * (1 + 1e-6 * east) / self.cell_m

        return tabulate_frame(longitude_deg, latitude_deg, to_pixel, radius_m)


def test_the_result_does_not_depend_on_the_piece_of_raster_that_is_at_hand():
    """Only what lies between eye and target matters: cutting the DEM elsewhere changes nothing."""
    ground = fractal(300, seed=12)
    ground[200:205, 60:90] = np.nan
    whole = look(ground, 30.0, 150, 150, 20.0, max_distance_m=2500.0, sector=Wedge(300.0, 80.0))
    padded = np.full((700, 620), 9000.0, np.float32)
    padded[220:520, 110:410] = ground
    terrain, observer = stand(padded, 30.0, 370, 260, 20.0)
    moved = viewshed(terrain, observer, Wedge(300.0, 80.0), ViewshedOptions(max_distance_m=2500.0))
    assert np.array_equal(spread(moved, padded.shape)[220:520, 110:410], whole)


def test_a_sink_takes_the_same_result_piece_by_piece():
    class Pieces(Sink):
        def __init__(self, window):
            self.window, self.count = window, 0
            self.whole = np.zeros((window.rows, window.cols), np.uint8)

        def add(self, window, values):
            self.count += 1
            row, col = window.row - self.window.row, window.col - self.window.col
            self.whole[row : row + window.rows, col : col + window.cols] |= values

        def set(self, row, col, value):
            self.whole[row - self.window.row, col - self.window.col] = value

    made = []
    terrain, observer = stand(fractal(600, seed=13), 30.0, 300, 310, 20.0)
    result = viewshed(terrain, observer, sink=lambda window: made.append(Pieces(window)) or made[0])
    assert result.values is None
    assert made[0].count > 4
    assert np.array_equal(made[0].whole, viewshed(terrain, observer).values)


def test_the_packed_sink_holds_the_same_in_a_quarter_of_the_memory():
    ground = fractal(300, seed=13)
    ground[60:70, 100:111] = np.nan
    terrain, observer = stand(ground, 30.0, 150.2, 161, 20.0)
    options, sinks = ViewshedOptions(max_distance_m=3170.0), []
    whole = viewshed(terrain, observer, Wedge(340.0, 130.0), options)
    viewshed(terrain, observer, Wedge(340.0, 130.0), options, sink=lambda w: sinks.append(PackedSink(w)) or sinks[0])
    window = whole.window
    assert np.array_equal(sinks[0].read(window), whole.values)
    part = Window(window.row + 7, window.col + 5, 20, 31)
    assert np.array_equal(sinks[0].read(part), whole.values[7:27, 5:36])
    assert set(np.unique(whole.values)) == {0, 1, UNKNOWN}


@pytest.mark.parametrize("grid", [ArrayTerrain, Bent])
def test_dropping_hidden_blocks_changes_nothing(monkeypatch, grid):
    from skyline_viewshed.core.viewshed import blocks

    terrain, observer = stand(fractal(400, seed=14), 30.0, 210.3, 180.8, 5.0)
    terrain = grid(terrain.elevation_m, 30.0)
    quick = viewshed(terrain, observer).values
    monkeypatch.setattr(blocks, "range_minimum", lambda values, first, last: np.full(len(first), -np.inf, np.float32))
    assert np.array_equal(viewshed(terrain, observer).values, quick)


@pytest.mark.parametrize("kind", [np.uint8, np.float32])
@pytest.mark.parametrize(
    "sector", [FullCircle(), Wedge(340.0, 130.0), PhotoFrame(Camera(900, 600, 700.0), Pose(40, 2, 1))]
)
@pytest.mark.parametrize("grid", [ArrayTerrain, Bent])
def test_the_result_is_the_same_to_the_last_bit_for_any_number_of_threads(monkeypatch, grid, kind, sector):
    ground = fractal(301, seed=2)
    ground[40:60, 150:170] = np.nan
    terrain, observer = stand(ground, 30.0, 150.3, 120.7, 10.0)
    terrain = grid(terrain.elevation_m, 30.0)
    monkeypatch.setattr(viewsheds, "LEAST_CELLS", 0)
    results = []
    for count in (1, 2, 3, 4):
        monkeypatch.setattr(threads, "_limit", [count])
        results.append(viewshed(terrain, observer, sector, sink=lambda window: ArraySink(window, kind)).values)
    assert results[0].any()
    assert len({values.tobytes() for values in results}) == 1


class Watched(Terrain):
    """A terrain of which `look` sees every window before it is read."""

    def __init__(self, terrain, look):
        self.shape, self.terrain, self.look = terrain.shape, terrain, look

    def read(self, window):
        self.look(window)
        return self.terrain.read(window)

    def frame(self, *place):
        return self.terrain.frame(*place)


def test_threads_read_a_terrain_one_at_a_time(monkeypatch):
    terrain, observer = stand(fractal(301, seed=2), 30.0, 150, 150, 10.0)
    monkeypatch.setattr(viewsheds, "LEAST_CELLS", 0)
    monkeypatch.setattr(threads, "_limit", [4])
    busy, readers = Lock(), set()

    def guard(_):
        assert busy.acquire(blocking=False)
        readers.add(get_ident())
        sleep(0.01)
        busy.release()

    viewshed(Watched(terrain, guard), observer)
    assert len(readers) > 1


@pytest.mark.parametrize("count", [1, 2])
def test_an_error_of_the_terrain_reaches_the_caller(monkeypatch, count):
    terrain, observer = stand(fractal(301, seed=2), 30.0, 150, 150, 10.0)
    monkeypatch.setattr(viewsheds, "LEAST_CELLS", 0)
    monkeypatch.setattr(threads, "_limit", [count])

    def refuse(window):
        if window.rows * window.cols > 100:
            raise UnusableDemError("damaged")

    with pytest.raises(UnusableDemError, match="damaged"):
        viewshed(Watched(terrain, refuse), observer)


def test_cancelling_stops_it():
    class Stop:
        def report(self, fraction):
            pass

        def cancelled(self):
            return True

    terrain, observer = stand(fractal(101, seed=1), 30.0, 50, 50)
    with pytest.raises(Cancelled):
        viewshed(terrain, observer, progress=Stop())


def test_a_virtual_raster_of_ten_gigapixels_is_read_in_pieces_and_only_in_range():
    class Endless(Terrain):
        shape = (100_000, 100_000)
        most = total = 0

        def read(self, window):
            self.most, self.total = max(self.most, window.rows * window.cols), self.total + window.rows * window.cols
            row = np.arange(window.row, window.row + window.rows, dtype=np.float32)[:, None]
            col = np.arange(window.col, window.col + window.cols, dtype=np.float32)
            return 50 * np.sin(row / 300) * np.cos(col / 400) + np.float32(200)

        def frame(self, longitude_deg, latitude_deg, radius_m):
            return tabulate_frame(0, 0, lambda east, north: (5e4 + east / 10, 5e4 - north / 10), radius_m, size=3)

    terrain = Endless()
    result = viewshed(terrain, Observer(0, 0, 100.0), options=ViewshedOptions(max_distance_m=10_000.0))
    assert result.values.shape == (2003, 2003)
    assert result.visible.any()
    assert terrain.most <= 256 * 2100
    assert terrain.total < 1.5 * 2003**2
