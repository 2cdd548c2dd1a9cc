"""The graticule: each line has the azimuth or elevation angle that it names."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.base.camera import Camera, Pose, focal_of_fov_px, unproject
from skyline_viewshed.core.mapping.graticule import graticule

CAMERA = Camera(4000, 3000, focal_of_fov_px(4000, 65.0))


@pytest.mark.parametrize("pose", [Pose(2.0), Pose(181.0, 12.0, -4.0), Pose(300.0, -30.0, 10.0)])
def test_lines_are_where_they_say(pose):
    lines = graticule(CAMERA, pose)
    kinds = [line.kind for line in lines]
    assert 3 <= kinds.count("azimuth") <= 12 and 3 <= kinds.count("elevation") <= 12
    for line in lines:
        known = np.isfinite(line.x_px)
        azimuth, elevation = unproject(CAMERA, pose, line.x_px[known], line.y_px[known])
        off = difference(azimuth, line.value_deg) if line.kind == "azimuth" else elevation - line.value_deg
        assert np.abs(off).max() < 1e-6
        assert 0 <= line.value_deg < 360 or line.kind == "elevation"


def test_a_telephoto_has_close_lines():
    lines = graticule(Camera(4000, 3000, focal_of_fov_px(4000, 4.0)), Pose(10.0))
    azimuths = sorted(line.value_deg for line in lines if line.kind == "azimuth")
    assert np.diff(azimuths).max() == pytest.approx(0.5)
