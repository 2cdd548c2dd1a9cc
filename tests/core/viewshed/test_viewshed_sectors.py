"""Viewsheds of a sector: the wedge and the photograph's frame are cut out of the full circle."""

import numpy as np
import pytest
from reference.landscapes import fractal
from reference.views import directions, look
from skyline_viewshed.core.base.camera import Camera, Pose, focal_of_fov_px, in_frame, project
from skyline_viewshed.core.viewshed.viewshed import PhotoFrame, Wedge

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
