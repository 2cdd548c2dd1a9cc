"""The whole viewshed against exact sight lines, closed forms and symmetries; see also its sectors and pieces."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from reference.landscapes import fractal, stand
from reference.sight_lines import viewshed_by_lines
from reference.views import UNKNOWN, directions, look, overlap, spread
from skyline_viewshed.core.base.errors import ObserverOutsideDemError
from skyline_viewshed.core.horizon.horizon import HorizonOptions, horizon_profile
from skyline_viewshed.core.viewshed.viewshed import ViewshedOptions, viewshed


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
