"""Lines of an overlay: where the DEM's horizon and the extracted skyline fall in the picture."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from skyline_viewshed.core.base.camera import Camera, Pose
from skyline_viewshed.core.base.model import HorizonProfile, Orientation, OrientedPhoto, Skyline
from skyline_viewshed.core.base.overlay_lines import (
    full_size,
    horizon_line,
    photo_lines,
    skyline_line,
    skyline_residuals_px,
)

CAMERA = Camera(4001, 3001, 3000.0)


def profile(elevation_deg=0.0, step_deg=0.1, clipped=(), void=()):
    azimuth = np.arange(0, 360, step_deg)
    no = np.zeros(azimuth.shape, bool)
    flags = [no.copy(), no.copy()]
    for flag, span in zip(flags, (clipped, void)):
        if span:
            flag[(azimuth >= span[0]) & (azimuth < span[1])] = True
    far = np.full(azimuth.shape, 9000.0)
    return HorizonProfile(azimuth, np.zeros(azimuth.shape) + elevation_deg, far, *flags, 1000.0, 30.0, far)


@pytest.mark.parametrize("heading_deg", [0.0, 0.04, 123.4, 359.98])
def test_a_level_horizon_crosses_the_middle_of_a_level_picture_at_every_heading(heading_deg):
    line = horizon_line(profile(), CAMERA, Pose(heading_deg))
    assert np.allclose(line.y_px[np.isfinite(line.y_px)], 1500)
    x = line.x_px[np.isfinite(line.x_px)]
    assert np.all(np.diff(x) > 0)
    assert x[0] < 0
    assert x[-1] > 4000
    assert np.diff(x).max() < 12  # nowhere torn, not at north either


def test_a_lone_tower_stands_at_its_azimuth():
    horizon = profile()
    horizon.elevation_deg[300] = 10.0  # at 30 degrees
    line = horizon_line(horizon, CAMERA, Pose(20.0))
    top = np.nanargmin(line.y_px)
    assert line.x_px[top] == pytest.approx(2000 + 3000 * np.tan(np.radians(10)))
    assert line.y_px[top] == pytest.approx(1500 - 3000 * np.tan(np.radians(10)) / np.cos(np.radians(10)))


def test_what_lies_behind_the_camera_is_not_drawn():
    horizon = profile(np.where(np.abs(np.arange(0, 360, 0.1) - 180) < 60, 20.0, np.nan))
    assert not np.isfinite(horizon_line(horizon, CAMERA, Pose(0.0)).x_px).any()
    assert np.isfinite(horizon_line(horizon, CAMERA, Pose(180.0)).x_px).any()


def test_a_camera_that_looks_high_above_the_horizon_sees_none_of_it():
    assert not np.isfinite(horizon_line(profile(), CAMERA, Pose(0.0, 60.0)).x_px).any()


def test_unknown_horizon_breaks_the_line():
    horizon = profile(np.where(np.abs(np.arange(0, 360, 0.1) - 90) < 1, np.nan, 3.0))
    line = horizon_line(horizon, CAMERA, Pose(90.0))
    assert not np.isfinite(line.y_px[np.abs(line.x_px - 2000) < 40]).any()
    assert np.isnan(line.x_px).sum() >= 1


def test_lower_bounds_are_told_from_firm_stretches():
    line = horizon_line(profile(clipped=(80, 88), void=(95, 97)), CAMERA, Pose(90.0))
    angle = 90 + np.degrees(np.arctan((line.x_px - 2000) / 3000))
    assert np.array_equal(line.doubtful, ((angle > 79.95) & (angle < 87.95)) | ((angle > 94.95) & (angle < 96.95)))
    firm, doubtful = (line.part(part) for part in (False, True))
    assert not (np.isfinite(firm[0]) & np.isfinite(doubtful[0])).sum() > 4


@pytest.mark.parametrize("factor", [1, 4])
def test_an_extracted_skyline_is_the_boundary_in_pixels_of_the_full_picture(factor):
    """Terrain from row 10 of the reduced picture on begins at the upper edge of row 10 x factor of the full one."""
    skyline = Skyline(np.full(50, 10.0), np.r_[np.zeros(5), np.ones(45)], 50, 40)
    line = skyline_line(skyline, 50 * factor, 40 * factor)
    assert np.allclose(line.y_px, 10 * factor - 0.5)
    assert line.x_px[0] == pytest.approx((factor - 1) / 2)
    assert line.x_px[-1] == pytest.approx(50 * factor - 1 - (factor - 1) / 2)
    assert line.doubtful.sum() == 5


def test_extracted_and_projected_lines_coincide_on_a_scene_with_exact_truth(painted):
    extracted, horizons = photo_lines(painted())
    best = horizons[0]
    known = np.isfinite(best.x_px)
    apart = np.interp(extracted.x_px, best.x_px[known], best.y_px[known]) - extracted.y_px
    assert len(horizons) == 3
    # The scene's line lies half a reduced pixel (2 px) below the boundary it was made from, 4 px to a reduced pixel.
    assert np.median(np.abs(apart)) < 4


def test_size_comes_from_whatever_is_known(painted):
    photo = painted()
    assert full_size(photo) == (1024, 768)
    assert full_size(painted(camera=None, metadata=None)) == (256, 192)
    assert full_size(painted(camera=None, metadata=None, preview=None)) == (256, 192)
    with pytest.raises(ValueError, match="neither"):
        full_size(OrientedPhoto("x", Orientation("failed", "no")))


def test_where_the_matcher_gave_no_residuals_they_come_from_the_lines(painted):
    photo = painted()
    assert skyline_residuals_px(photo) is photo.orientation.residual_px
    bare = replace(photo, orientation=replace(photo.orientation, residual_px=None))
    lower = replace(bare, skyline=replace(photo.skyline, row_px=photo.skyline.row_px + 5))
    shift = skyline_residuals_px(lower) - skyline_residuals_px(bare)
    assert np.allclose(shift, 20)  # 4 pixels of the full picture to one of the skyline's
    assert np.nanmedian(np.abs(skyline_residuals_px(bare))) < 4
    assert skyline_residuals_px(replace(bare, horizon=None)) is None
    assert skyline_residuals_px(replace(bare, skyline=None)) is None
