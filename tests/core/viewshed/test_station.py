import numpy as np
import pytest
from reference.landscapes import fractal, stand
from skyline_viewshed.core.base.camera import Camera, Pose, focal_of_fov_px
from skyline_viewshed.core.base.terrain import Terrain
from skyline_viewshed.core.viewshed.station import AnyOf, station_viewsheds
from skyline_viewshed.core.viewshed.viewshed import FullCircle, PhotoFrame, ViewshedOptions, Wedge, viewshed

CAMERA = Camera(400, 300, focal_of_fov_px(400, 60.0))
SECTORS = (Wedge(350.0, 40.0), PhotoFrame(CAMERA, Pose(30.0, -8.0, 3.0)), Wedge(80.0, 50.0))


@pytest.mark.parametrize(
    "sectors", [SECTORS, (*SECTORS, Wedge(200.0, 30.0)), (FullCircle(), *SECTORS[:2]), SECTORS[:1]]
)
def test_photos_of_one_station_get_what_each_would_get_alone(sectors):
    ground = fractal(151, seed=4)
    ground[20:24, 90:99] = np.nan
    scene, options = stand(ground, 30.0, 75.3, 74.6, 30.0), ViewshedOptions(max_distance_m=2_000.0)
    found = list(station_viewsheds(*scene, sectors, options))
    assert [one.sector for one in found] == list(sectors)
    for one in found:
        alone = viewshed(*scene, one.sector, options)
        assert one.window == alone.window
        np.testing.assert_array_equal(one.values, alone.values)


def test_the_ground_is_read_for_one_sweep_only():
    terrain, observer = stand(fractal(301, seed=5), 30.0, 150, 150, 30.0)
    read = []

    class Counting(Terrain):
        shape, frame = terrain.shape, terrain.frame

        def read(self, window):
            read.append(window.rows * window.cols)
            return terrain.read(window)

    wedges = [Wedge(float(heading), 60.0) for heading in range(0, 90, 5)]
    list(station_viewsheds(Counting(), observer, wedges))
    together = sum(read)
    read.clear()
    for wedge in wedges:
        viewshed(Counting(), observer, wedge)
    assert together < sum(read)


def test_sectors_that_lie_apart_are_held_by_the_circle():
    assert AnyOf((Wedge(0.0, 40.0), Wedge(350.0, 40.0))).azimuth_range_deg == (-30.0, 50.0)
    start, width = AnyOf((Wedge(10.0, 40.0), Wedge(190.0, 40.0))).azimuth_range_deg
    assert width >= 220
