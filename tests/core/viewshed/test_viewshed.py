from threading import Lock, get_ident
from time import sleep

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from reference.landscapes import fractal, stand
from reference.sight_lines import viewshed_by_lines
from reference.views import UNKNOWN, look, overlap, spread
from skyline_viewshed.core.base import threads
from skyline_viewshed.core.base.camera import Camera, Pose, focal_of_fov_px, in_frame, project
from skyline_viewshed.core.base.errors import Cancelled, ObserverOutsideDemError, UnusableDemError
from skyline_viewshed.core.base.frame import tabulate_frame
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer, Terrain, Window
from skyline_viewshed.core.base.viewed import ArraySink, Sink
from skyline_viewshed.core.horizon.horizon import HorizonOptions, horizon_profile
from skyline_viewshed.core.viewshed import viewshed as viewsheds
from skyline_viewshed.core.viewshed.viewshed import FullCircle, PackedSink, PhotoFrame, ViewshedOptions, Wedge, viewshed


def directions(shape, cell_m, row, col):
    """(azimuth [degrees], distance [m]) of every cell of a plane grid."""
    down, right = np.mgrid[: shape[0], : shape[1]]
    azimuth = np.degrees(np.arctan2(right - col, row - down)) % 360
    return azimuth, np.hypot(down - row, right - col) * cell_m


@pytest.mark.parametrize(("row", "col"), [(40, 40), (40.3, 39.6), (0, 0), (12.5, 70.25), (80.4, 3)])
@pytest.mark.parametrize("target", [0.0, 15.0])
def test_it_agrees_with_exact_sight_lines_to_every_cell(row, col, target):
    ground = fractal(81, seed=int(row * 10 + col))
    terrain, observer = stand(ground, 30.0, row, col, 10.0)
    found = viewshed(terrain, observer, options=ViewshedOptions(target_height_m=target))
    exact = viewshed_by_lines(ground, 30.0, row, col, found.eye_elevation_m, target)
    assert overlap(spread(found, ground.shape) == 1, exact) > 0.96


def test_it_agrees_with_the_bilinear_surface_too():
    ground = fractal(61, seed=3)
    terrain, observer = stand(ground, 30.0, 30, 30, 10.0)
    found = spread(viewshed(terrain, observer), ground.shape) == 1
    eye = float(ground[30, 30]) + 10.0
    lines = viewshed_by_lines(ground, 30.0, 30, 30, eye)
    bilinear = viewshed_by_lines(ground, 30.0, 30, 30, eye, model="bilinear")
    assert overlap(found, bilinear) > overlap(lines, bilinear) - 0.02  # the two exact models differ by themselves


def test_a_plane_earth_hides_nothing_and_leaves_no_hole():
    assert (look(np.zeros((301, 407)), 10.0, 151.2, 33.7, curvature=False) == 1).all()


def test_every_cell_of_the_disc_is_evaluated_and_none_outside():
    values = look(np.zeros((301, 301)), 10.0, 150.3, 149.8, curvature=False, max_distance_m=1200.0)
    _, distance = directions(values.shape, 10.0, 150.3, 149.8)
    assert np.array_equal(values == 1, distance <= 1200.0)


def test_the_curved_earth_hides_the_ground_beyond_its_horizon():
    values = look(np.zeros((1201, 1201), np.float32), 50.0, 600, 600, eye_height_m=30.0, max_distance_m=29_000.0)
    _, distance = directions(values.shape, 50.0, 600, 600)
    reach = np.sqrt(2 * 30 * 6_371_000 / 0.87)
    assert (values[distance < 0.97 * reach] == 1).all()
    assert not values[distance > 1.03 * reach].any()


def test_a_target_is_seen_to_the_range_of_both_heights():
    line = np.zeros((3, 1201), np.float32)
    radius = 6_371_000 / 0.87
    values = look(line, 50.0, 1, 0, eye_height_m=20.0, target_height_m=40.0, max_distance_m=60_000.0)
    last = np.flatnonzero(values[1]).max() * 50.0
    assert last == pytest.approx(np.sqrt(2 * radius * 20) + np.sqrt(2 * radius * 40), abs=100)


def test_an_infinite_wall_hides_what_lies_behind_it_up_to_its_shadow():
    ground = np.zeros((201, 201), np.float32)
    ground[58:61] = 50.0
    values = look(ground, 10.0, 100, 100, eye_elevation_m=100.0, curvature=False)
    assert (values[62:] == 1).all()  # the row at the wall's foot lies between rays that meet it and rays that do not
    assert (values[58:61] == 1).all()
    # The shadow of 50 m, 420 m away, under an eye at 100 m ends at 840 m, 84 rows off.
    assert not values[19:57].any()
    assert (values[:14] == 1).all()


def test_a_wall_of_one_cell_casts_a_shadow_one_cell_wide_growing_with_distance():
    ground = np.zeros((201, 201), np.float32)
    ground[80, 100] = 90.0
    values = look(ground, 10.0, 100, 100, eye_elevation_m=100.0, curvature=False)
    assert values[79, 100] == 0
    assert values[0, 100] == 0
    assert values[80, 100] == 1
    assert (values[:, :90] == 1).all()
    shadow = (values == 0).sum(axis=1)
    assert shadow[:80].sum() > 80
    assert not shadow[80:].any()


def test_the_rim_of_a_pit_is_the_last_thing_seen():
    row, col = np.mgrid[:101, :101]
    distance = np.hypot(row - 50, col - 50)
    values = look(np.where(distance > 20, 100.0, 0.0), 10.0, 50, 50, eye_height_m=2.0, curvature=False)
    assert (values[distance <= 20] == 1).all()
    assert not values[distance > 22].any()


@settings(max_examples=10, deadline=None)
@given(seed=st.integers(0, 500), lift=st.floats(1, 200))
def test_a_higher_target_is_never_harder_to_see(seed, lift):
    ground = fractal(97, seed)
    low = look(ground, 30.0, 48.2, 47.9) == 1
    assert not (low & (look(ground, 30.0, 48.2, 47.9, target_height_m=lift) != 1)).any()


@settings(max_examples=10, deadline=None)
@given(seed=st.integers(0, 500), far=st.floats(300, 3000))
def test_the_range_only_cuts_and_never_changes(seed, far):
    ground = fractal(97, seed)
    whole = look(ground, 30.0, 48.0, 48.0)
    near = look(ground, 30.0, 48.0, 48.0, max_distance_m=far)
    _, distance = directions(ground.shape, 30.0, 48.0, 48.0)
    inside = distance <= far
    # Ray spacing follows the range, so that grazing cells may differ.
    assert (whole[inside] != near[inside]).mean() < 0.03
    assert not near[~inside].any()


def test_eye_and_target_at_equal_heights_see_one_another():
    ground = fractal(61, seed=11)
    rng = np.random.default_rng(0)
    agree = []
    for a, b in rng.integers(0, 61, (60, 2, 2)):
        there = look(ground, 30.0, *a, eye_height_m=12.0, target_height_m=12.0, near_skip_cells=0.5)[tuple(b)]
        back = look(ground, 30.0, *b, eye_height_m=12.0, target_height_m=12.0, near_skip_cells=0.5)[tuple(a)]
        agree.append(there == back)
    assert np.mean(agree) > 0.95


@pytest.mark.parametrize("turns", [1, 2, 3])
def test_turned_terrain_turns_the_viewshed(turns):
    ground = fractal(121, seed=4)
    straight = look(ground, 30.0, 60, 60)
    turned = look(np.rot90(ground, turns), 30.0, 60, 60)
    assert (np.rot90(straight, turns) != turned).mean() < 1e-3  # cells on the diagonals change quarters


WEDGES = {
    "thin along a column": (0, 1.0),
    "thin along a row": (90, 1.0),
    "thin between": (17.3, 1.0),
    "across a diagonal": (45, 60.0),
    "across the diagonal before north": (315, 60.0),
    "a little more west than east of north": (359.9, 60.0),
    "half, cut along a row": (180, 180.0),
    "half, cut along a column": (270, 180.0),
    "half, cut along a diagonal": (135, 180.0),
    "most, open to the south": (0, 300.0),
    "most, open across a diagonal": (225, 300.0),
    "most, open between": (17.3, 300.0),
}


@pytest.mark.parametrize(("heading", "width"), WEDGES.values(), ids=WEDGES)
def test_a_wedge_is_the_circle_cut_by_azimuth(heading, width):
    ground = fractal(101, seed=2)
    circle = look(ground, 30.0, 50.3, 49.6, eye_height_m=30.0)
    wedge = look(ground, 30.0, 50.3, 49.6, eye_height_m=30.0, sector=Wedge(heading, width))
    azimuth, _ = directions(ground.shape, 30.0, 50.3, 49.6)
    off = np.abs((azimuth - heading + 180) % 360 - 180)
    inside, own = off < width / 2 - 1e-6, np.zeros(ground.shape, bool)
    own[50, 50] = True
    assert np.array_equal(wedge[inside], circle[inside])
    assert not wedge[(off > width / 2 + 1e-6) & ~own].any()


def test_wedge_edges_are_inclusive_and_the_observers_cell_is_seen():
    values = look(np.zeros((21, 21)), 10.0, 10, 10, sector=Wedge(45.0, 90.0), curvature=False)
    assert values[10, 10] == 1
    assert (values[0:11, 10] == 1).all()
    assert (values[10, 10:] == 1).all()
    assert not values[11:].any()


@pytest.mark.parametrize("pose", [Pose(30.0), Pose(350.0, -12.0, 4.0), Pose(200.0, 5.0, -10.0), Pose(90.0, -60.0)])
def test_the_photo_frame_is_the_circle_cut_by_projection(pose):
    ground, height = fractal(101, seed=7), 60.0
    camera = Camera(400, 300, focal_of_fov_px(400, 60.0))
    circle = look(ground, 30.0, 50, 50, eye_height_m=height) == 1
    frame = look(ground, 30.0, 50, 50, eye_height_m=height, sector=PhotoFrame(camera, pose)) == 1
    azimuth, distance = directions(ground.shape, 30.0, 50, 50)
    distance[50, 50] = 1.0
    rise = ground - (ground[50, 50] + height) - 0.87 * distance**2 / (2 * 6_371_000)
    x, y = project(camera, pose, azimuth, np.degrees(np.arctan2(rise, distance)))
    expected = circle & in_frame(camera, x, y)
    expected[50, 50] = frame[50, 50] = False
    on_the_edge = (np.abs(x + 0.5) < 0.05) | (np.abs(x - 399.5) < 0.05) | (np.abs(y + 0.5) < 0.05)
    assert np.array_equal(expected[~on_the_edge], frame[~on_the_edge])
    assert frame.sum() < circle.sum()


def test_ground_above_the_photographs_own_skyline_is_not_claimed():
    ground = fractal(101, seed=7)
    camera, pose = Camera(400, 300, focal_of_fov_px(400, 60.0)), Pose(30.0, -5.0)
    free = look(ground, 30.0, 50, 50, 60.0, sector=PhotoFrame(camera, pose)) == 1
    skyline = np.full(400, 150.0)  # level with the optical axis, all that rises above -5 degrees is hidden
    cut = look(ground, 30.0, 50, 50, 60.0, sector=PhotoFrame(camera, pose, skyline)) == 1
    assert cut.sum() < free.sum()
    assert not (cut & ~free).any()
    unknown = look(ground, 30.0, 50, 50, 60.0, sector=PhotoFrame(camera, pose, np.full(400, np.nan))) == 1
    assert np.array_equal(unknown, free)


def test_the_near_limit_hides_nothing_but_is_not_claimed():
    ground = fractal(101, seed=7)
    whole, limited = look(ground, 30.0, 50, 50), look(ground, 30.0, 50, 50, min_distance_m=300.0)
    _, distance = directions(ground.shape, 30.0, 50, 50)
    assert not limited[distance < 300.0].any()
    assert np.array_equal(whole[distance >= 300.0], limited[distance >= 300.0])


def test_voids_and_what_only_they_could_hide_are_unknown():
    ground = np.zeros((101, 101), np.float32)
    ground[30:35, 40:61] = np.nan
    values = look(ground, 10.0, 50, 50, eye_elevation_m=50.0, curvature=False)
    assert (values[30:35, 40:61] == UNKNOWN).all()
    assert values[10, 50] == UNKNOWN
    assert (values[36:] == 1).all()
    clear = look(ground, 10.0, 50, 50, eye_elevation_m=50.0, curvature=False, voids_block=False)
    assert clear[10, 50] == 1
    assert (clear[30:35, 40:61] == UNKNOWN).all()
    ground[40] = 60.0  # a wall before the void: what lies behind is hidden whatever the void holds
    walled = look(ground, 10.0, 50, 50, eye_elevation_m=50.0, curvature=False)
    assert walled[10, 50] == 0
    assert (walled[30:35, 40:61] == UNKNOWN).all()


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


class Bent(ArrayTerrain):
    """Cells on a grid whose lines bend and whose scale drifts, as those of a geographic CRS do."""

    def frame(self, longitude_deg, latitude_deg, radius_m):
        col, row = self.pixel_of(longitude_deg, latitude_deg)

        def to_pixel(east, north):
            return col + (east + 1e-6 * north**2) / self.cell_m, row - north * (1 + 1e-6 * east) / self.cell_m

        return tabulate_frame(longitude_deg, latitude_deg, to_pixel, radius_m)


@pytest.mark.parametrize("grid", [ArrayTerrain, Bent])
def test_dropping_hidden_blocks_changes_nothing(monkeypatch, grid):
    from skyline_viewshed.core.viewshed import blocks

    terrain, observer = stand(fractal(400, seed=14), 30.0, 210.3, 180.8, 5.0)
    terrain = grid(terrain.elevation_m, 30.0)
    quick = viewshed(terrain, observer).values
    monkeypatch.setattr(blocks, "range_minimum", lambda values, first, last: np.full(len(first), -np.inf, np.float32))
    assert np.array_equal(viewshed(terrain, observer).values, quick)


@pytest.mark.parametrize(("row", "col"), [(0, 0), (60, 0), (-0.4, 30), (60.4, 60.5), (30.5, 30.5)])
def test_the_observer_may_stand_on_the_edge_or_between_cells(row, col):
    assert (look(np.zeros((61, 61)), 10.0, row, col, curvature=False) == 1).all()


def test_a_dem_of_one_cell_sees_itself():
    assert look(np.zeros((1, 1)), 10.0, 0, 0).tolist() == [[1]]


def test_outside_the_dem_nothing_can_be_seen():
    with pytest.raises(ObserverOutsideDemError):
        look(np.zeros((50, 50)), 10.0, 80, 20)


@pytest.mark.parametrize("dtype", ["int16", "float64"])
def test_the_type_of_the_elevations_does_not_matter(dtype):
    ground = np.rint(fractal(101, seed=9))
    assert np.array_equal(look(ground.astype(dtype), 30.0, 50, 50), look(ground, 30.0, 50, 50))


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


@pytest.mark.parametrize(
    "wrong",
    [{"max_distance_m": 0}, {"min_distance_m": 5e4}, {"target_height_m": -1}, {"rays_per_cell": 0}],
)
def test_options_out_of_range_are_refused(wrong):
    with pytest.raises(ValueError):
        ViewshedOptions(**wrong)


def test_the_viewshed_ends_at_the_horizon():
    """The farthest cell seen along a bearing is the horizon point, or lies just before it."""
    ground = fractal(201, seed=15)
    terrain, observer = stand(ground, 30.0, 100, 100, 10.0)
    profile = horizon_profile(terrain, observer, HorizonOptions(azimuth_step_deg=1.0, near_skip_cells=1.0))
    values = spread(viewshed(terrain, observer), ground.shape)
    azimuth, distance = directions(ground.shape, 30.0, 100, 100)
    beyond = distance > np.interp(azimuth, np.append(profile.azimuth_deg, 360), np.append(profile.distance_m, 1e9)) + 90
    near_jump = np.zeros(ground.shape, bool)
    step = np.abs(np.diff(np.append(profile.distance_m, profile.distance_m[0]))) > 90
    near_jump |= step[azimuth.astype(int) % 360]
    assert (values[beyond & ~near_jump] == 1).mean() < 0.005


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
