import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from skyline_viewshed.core.base.camera import Camera, Pose, focal_of_fov_px, in_frame, project, unproject
from skyline_viewshed.core.viewshed.sector import FullCircle, PhotoFrame, Wedge

CAMERA = Camera(600, 400, focal_of_fov_px(600, 70.0))


@given(heading=st.floats(-360, 720), width=st.floats(0.1, 360), off=st.floats(-180, 180))
def test_a_wedge_accepts_what_is_within_half_its_width(heading, width, off):
    accepted = Wedge(heading, width).accepts(np.array([heading + off]), None, None)[0]
    if abs(abs(off) - width / 2) > 1e-6:
        assert accepted == (abs(off) < width / 2)


@given(heading=st.floats(0, 360), width=st.floats(0.1, 359))
def test_what_a_wedge_accepts_it_touches(heading, width):
    azimuth = np.arange(0, 360, 0.7)
    wedge = Wedge(heading, width)
    assert not (wedge.accepts(azimuth, None, None) & ~wedge.touches(azimuth, 0.001)).any()


@given(
    heading=st.floats(0, 360), pitch=st.floats(-89, 89), roll=st.floats(-30, 30),
    x=st.floats(-0.5, 599.5), y=st.floats(-0.5, 399.5),
)  # fmt: skip
def test_every_direction_of_the_frame_lies_in_its_wedge(heading, pitch, roll, x, y):
    frame = PhotoFrame(CAMERA, Pose(heading, pitch, roll))
    azimuth, elevation = unproject(CAMERA, frame.pose, np.array([x]), np.array([y]))
    assert frame.touches(azimuth, 0.05)[0]
    start, width = frame.azimuth_range_deg
    assert (azimuth[0] - start + 0.05) % 360 <= width + 0.1 or width == 360


def test_a_frame_accepts_exactly_what_projects_into_it():
    frame = PhotoFrame(CAMERA, Pose(350.0, -4.0, 3.0))
    rng = np.random.default_rng(0)
    azimuth, elevation = rng.uniform(0, 360, 2000), rng.uniform(-40, 40, 2000)
    expected = in_frame(CAMERA, *project(CAMERA, frame.pose, azimuth, elevation))
    assert np.array_equal(frame.accepts(azimuth, elevation, np.ones(2000)), expected)
    assert expected.any()


def test_a_frame_with_the_nadir_in_it_looks_all_around():
    assert PhotoFrame(CAMERA, Pose(10.0, -85.0)).azimuth_range_deg[1] == 360.0
    assert PhotoFrame(CAMERA, Pose(10.0, 0.0)).azimuth_range_deg[1] < 75.0


def test_unknown_heights_are_accepted_within_the_wedge_only():
    frame = PhotoFrame(CAMERA, Pose(10.0))
    assert list(frame.accepts(np.array([12.0, 100.0]), np.array([np.nan, np.nan]), np.ones(2))) == [True, False]


def test_the_skyline_cuts_with_its_tolerance():
    skyline = np.full(600, 200.0)
    directions = np.array([0.0, 0.0]), np.array([1.0, -1.0])
    strict = PhotoFrame(CAMERA, Pose(0.0), skyline)
    lenient = PhotoFrame(CAMERA, Pose(0.0), skyline, tolerance_px=10.0)
    assert list(strict.accepts(*directions, np.ones(2))) == [False, True]
    assert list(lenient.accepts(*directions, np.ones(2))) == [True, True]


def test_the_full_circle_accepts_everything():
    assert FullCircle().accepts(np.arange(360.0), np.zeros(360), np.ones(360)).all()


@pytest.mark.parametrize("width", [0.0, -5.0, 400.0])
def test_impossible_wedges_are_refused(width):
    with pytest.raises(ValueError):
        Wedge(0.0, width)
