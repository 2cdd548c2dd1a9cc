"""The benchmark that cuts views out of photographs: its geometry, its compass, and one run."""

import json
from types import SimpleNamespace

import numpy as np
import pytest
from scripts import script
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.base.camera import Camera, Pose, project

pytest.importorskip("cv2", reason="the views are cut with OpenCV")
CAMERA, POSE = Camera(800, 600, 900.0), Pose(350.0, 4.0, 2.0)
AZIMUTH = np.arange(0, 360, 0.1)


@pytest.fixture(scope="module")
def bench():
    return script("benchmarks/bench_views.py")


@pytest.fixture
def base():
    best = SimpleNamespace(camera=CAMERA, pose=POSE)
    horizon = SimpleNamespace(azimuth_deg=AZIMUTH, elevation_deg=4 + 2 * np.sin(np.radians(9 * AZIMUTH)))
    return SimpleNamespace(orientation=SimpleNamespace(best=best), horizon=horizon)


def test_a_point_of_the_landscape_keeps_its_direction(bench, base):
    """A bright spot at a known direction appears where the view's own camera projects that direction."""
    x, y = project(CAMERA, POSE, 352.0, 5.0)
    row, column = np.mgrid[0:600, 0:800]
    picture = 255 * np.exp(-0.5 * ((column - x) ** 2 + (row - y) ** 2) / 3**2)
    view_camera, view_pose = Camera(400, 300, 1200.0), Pose(351.0, 5.0, -6.0)
    view = bench.view_of(np.dstack([picture] * 3).astype(np.uint8), base.orientation.best, view_camera, view_pose)[
        ..., 0
    ]
    rows, columns = np.mgrid[0:300, 0:400]
    centre = (view * columns).sum() / view.sum(), (view * rows).sum() / view.sum()
    assert centre == pytest.approx(tuple(float(v) for v in project(view_camera, view_pose, 352.0, 5.0)), abs=0.2)


def test_drawn_views_lie_inside_the_photograph_and_show_the_horizon(bench, base):
    generator = np.random.default_rng(3)
    for _ in range(5):
        camera, pose = bench.draw_view(base, generator)
        assert bench.inside(base.orientation.best, camera, pose)
        assert camera.hfov_deg < CAMERA.hfov_deg
        assert abs(pose.roll_deg) <= 8


def test_a_photograph_without_a_horizon_in_it_gives_no_view(bench, base):
    base.horizon.elevation_deg[:] = 60.0
    assert bench.draw_view(base, np.random.default_rng(3)) is None


def test_the_compass_has_the_faults_that_are_believed_of_it(bench):
    generator = np.random.default_rng(8)
    off = np.array([abs(difference(bench.read_compass(200.0, generator), 200.0)) for _ in range(2000)])
    assert 0.80 < (off < 30).mean() < 0.95
    assert 0.02 < ((off > 70) & (off < 110)).mean() < 0.12


def test_one_view_of_a_real_photograph(bench, shared_data, tmp_path):
    output = tmp_path / "views.json"
    bench.main([str(shared_data / "aletsch"), "--count", "1", "--compass", "prior", "--joint", "--output", str(output)])
    report = json.loads(output.read_text(encoding="utf-8"))
    assert report["summary"]["all"]["photos"] == 1
    (view,) = report["views"]
    assert view["status"] in ("accepted", "ambiguous", "rejected")
    assert view["alone"]["error_deg"] == view["error_deg"], "one view has no neighbours"
