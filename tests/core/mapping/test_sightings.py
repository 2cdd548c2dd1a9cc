from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.camera import Camera, Pose
from skyline_viewshed.core.base.posed import PosedPhoto
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer
from skyline_viewshed.core.base.view import open_view
from skyline_viewshed.core.mapping.projecting import sample_area
from skyline_viewshed.core.mapping.sightings import find_sightings, place_of_height

CAMERA = Camera(600, 400, 500.0)


def walled():
    z = np.zeros((401, 401), np.float32)
    z[169:172] = 40.0
    return ArrayTerrain(z, 10.0)


def point(east, north):
    return np.array([east]), np.array([north])


def north_view(terrain, pitch_deg=-10.0):
    return open_view(terrain, PosedPhoto(CAMERA, Pose(0.0, pitch_deg), Observer(0, 0, 20.0)), 2500.0)


def test_seen_places_come_best_first_and_hidden_ones_not_at_all():
    terrain = walled()
    places = [point(0, 200), point(0, 100), point(0, 700), point(0, -100)]
    found = find_sightings(terrain, north_view(terrain), places)
    assert [sighting.place for sighting in found] == [1, 0]
    assert found[0].quality > found[1].quality


def test_the_numbers_of_a_point_follow_from_the_geometry():
    terrain = walled()
    view = open_view(terrain, PosedPhoto(CAMERA, Pose(0.0, -45.0), Observer(0, 0, 100.0)), 2500.0)
    (seen,) = find_sightings(terrain, view, [point(0, 100)])
    slant = np.sqrt(2) * 100
    assert (seen.visible_share, seen.framed_share) == (1, 1)
    assert (seen.x_px, seen.y_px) == pytest.approx(CAMERA.centre_px, abs=0.1)
    assert seen.pixels_per_metre == pytest.approx(500 / slant, rel=1e-3)
    assert seen.incidence_deg == pytest.approx(45, abs=0.1)
    assert seen.azimuth_deg == pytest.approx(0, abs=1e-6) and seen.elevation_deg == pytest.approx(-45, abs=0.1)
    assert seen.distance_m == pytest.approx(100)
    assert seen.quality == pytest.approx(500 / slant * np.cos(np.radians(45)), rel=0.01)


def test_of_an_area_the_visible_share_is_told():
    terrain = walled()
    # From 200 m before the wall to 200 m behind it: the far half is hidden.
    ring = np.array([-30, 30, 30, -30.0]), np.array([100, 100, 500, 500.0])
    (seen,) = find_sightings(terrain, north_view(terrain, 0.0), [sample_area([ring], 5.0)])
    assert seen.visible_share == pytest.approx(0.5, abs=0.05)
    assert seen.framed_share > 0.95


def pyramid():
    """Even ground with one mountain of 300 m, whose top lies 1,000 m north of the eye."""
    row, col = np.mgrid[:401, :401]
    z = np.maximum(300.0 - 0.5 * 10.0 * np.maximum(np.abs(row - 100), np.abs(col - 200)), 0.0)
    return ArrayTerrain(z.astype(np.float32), 10.0)


def test_a_published_summit_stands_on_the_top_of_the_dem_and_a_hut_where_it_is():
    terrain = pyramid()
    view = north_view(terrain, 5.0)
    summit = place_of_height(terrain, view.frame, (40.0, 1150.0), 320.0)
    assert (summit.east_m[0], summit.north_m[0]) == pytest.approx((0, 1000), abs=1)
    assert summit.elevation_m[0] == 320.0
    hut = place_of_height(terrain, view.frame, (40.0, 1150.0), 228.0)
    assert (hut.east_m[0], hut.north_m[0], hut.elevation_m) == (40.0, 1150.0, None)
    unmoved = place_of_height(terrain, view.frame, (40.0, 1150.0), 320.0, radius_m=0.0)
    assert (unmoved.east_m[0], unmoved.north_m[0]) == (40.0, 1150.0)


@pytest.mark.parametrize("published_m", [320 / 0.3048, 9999.0])
def test_a_height_that_the_dem_contradicts_is_not_used_and_this_is_asked_with_both_heights(published_m):
    terrain, asked = pyramid(), []
    view = north_view(terrain, 5.0)
    place = place_of_height(terrain, view.frame, (40.0, 1050.0), published_m)
    assert (place.east_m[0], place.north_m[0], place.elevation_m) == (
        pytest.approx(0, abs=1),
        pytest.approx(1000, abs=1),
        None,
    )

    def believed(published, top):
        asked.append((published, top))
        return False

    kept = place_of_height(terrain, view.frame, (40.0, 1050.0), published_m, 500.0, believed)
    assert kept.elevation_m[0] == published_m and asked == [(published_m, pytest.approx(300, abs=10))]


def test_a_summit_is_seen_though_its_published_place_lies_behind_the_top():
    terrain = pyramid()
    view = north_view(terrain, 5.0)
    places = [point(40.0, 1150.0), place_of_height(terrain, view.frame, (40.0, 1150.0), 320.0), point(0.0, 500.0)]
    found = find_sightings(terrain, view, places)
    assert sorted(sighting.place for sighting in found) == [1, 2]
    (summit,) = (sighting for sighting in found if sighting.place == 1)
    assert summit.distance_m == pytest.approx(1000, abs=1)
    assert summit.elevation_deg == pytest.approx(np.degrees(np.arctan((320 - 20) / 1000)), abs=0.05)


def test_no_places_give_no_sightings():
    terrain = walled()
    assert find_sightings(terrain, north_view(terrain), []) == ()
    assert find_sightings(terrain, north_view(terrain), [(np.zeros(0), np.zeros(0))]) == ()
