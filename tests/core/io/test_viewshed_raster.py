import os
from dataclasses import replace

import numpy as np
import pytest
from reference.landscapes import summits, write_summits
from skyline_viewshed.core.base.camera import Camera, Pose
from skyline_viewshed.core.base.terrain import Observer
from skyline_viewshed.core.base.viewed import ArraySink
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.io.viewshed_raster import fingerprint, read_viewshed, write_viewshed
from skyline_viewshed.core.viewshed.viewshed import PackedSink, PhotoFrame, ViewshedOptions, Wedge, viewshed

CENTRE = (-149.5, 61.1)
OPTIONS = ViewshedOptions(max_distance_m=5_000.0)


@pytest.fixture(scope="module")
def dem(tmp_path_factory):
    return open_dem(write_summits(tmp_path_factory.mktemp("dem") / "dem.tif", "EPSG:32606", (90, 90), CENTRE))


@pytest.fixture
def observer():
    return Observer(*CENTRE, eye_elevation_m=float(summits(*CENTRE, CENTRE)) + 20)


@pytest.mark.parametrize("sink", [ArraySink, PackedSink])
def test_a_finished_file_gives_its_values_back(tmp_path, dem, observer, sink):
    mark, path = fingerprint(dem, observer, Wedge(20.0, 60.0), OPTIONS), str(tmp_path / "photo.tif")
    seen = viewshed(dem, observer, Wedge(20.0, 60.0), OPTIONS)
    assert seen.visible.any()
    write_viewshed(path, seen, dem, mark)
    window, values = read_viewshed(path, dem, mark, sink)
    assert window == seen.window
    assert np.array_equal(values[:, :], seen.values)


def test_a_file_cut_short_or_of_other_facts_is_not_taken(tmp_path, dem, observer):
    path, mark = str(tmp_path / "photo.tif"), "a" * 32
    assert read_viewshed(path, dem, mark) is None
    write_viewshed(path, viewshed(dem, observer, Wedge(20.0, 60.0), OPTIONS), dem, mark)
    assert read_viewshed(path, dem, mark) is not None
    assert read_viewshed(path, dem, "b" * 32) is None
    with open(path, "r+b") as file:
        file.truncate(os.path.getsize(path) // 2)
    assert read_viewshed(path, dem, mark) is None
    with open(path, "wb") as file:
        file.write(b"no raster")
    assert read_viewshed(path, dem, mark) is None


def test_a_run_that_dies_while_it_writes_leaves_no_file(tmp_path, dem, observer):
    class Dying:
        def __getitem__(self, place):
            raise KeyboardInterrupt

    seen = replace(viewshed(dem, observer, Wedge(20.0, 60.0), OPTIONS), values=Dying())
    with pytest.raises(KeyboardInterrupt):
        write_viewshed(str(tmp_path / "photo.tif"), seen, dem, "a" * 32)
    assert list(tmp_path.iterdir()) == []


def test_the_fingerprint_changes_with_every_fact(dem, observer):
    camera, pose = Camera(400, 300, 350.0), Pose(20.0, 1.0, 0.5)
    skyline = np.arange(400.0)
    other = skyline.copy()
    other[200] += 1
    marks = [
        fingerprint(dem, observer, Wedge(20.0, 60.0), OPTIONS),
        fingerprint(dem, observer, Wedge(20.0, 61.0), OPTIONS),
        fingerprint(dem, replace(observer, eye_height_m=2.0), Wedge(20.0, 60.0), OPTIONS),
        fingerprint(dem, observer, Wedge(20.0, 60.0), replace(OPTIONS, target_height_m=1.0)),
        fingerprint(dem, observer, PhotoFrame(camera, pose), OPTIONS),
        fingerprint(dem, observer, PhotoFrame(camera, pose, skyline), OPTIONS),
        fingerprint(dem, observer, PhotoFrame(camera, pose, other), OPTIONS),
    ]
    assert len(set(marks)) == len(marks)
    assert marks[0] == fingerprint(dem, observer, Wedge(20.0, 60.0), OPTIONS)


def test_the_fingerprint_changes_with_the_dem(tmp_path, observer):
    path = write_summits(tmp_path / "dem.tif", "EPSG:32606", (400, 400), CENTRE)
    before = fingerprint(open_dem(path), observer, Wedge(20.0, 60.0), OPTIONS)
    os.utime(path, (1, 1))
    assert fingerprint(open_dem(path), observer, Wedge(20.0, 60.0), OPTIONS) != before
