from __future__ import annotations

import xml.etree.ElementTree as ET

import numpy as np
import pytest
from skyline_viewshed.core.base.camera import Camera, Pose
from skyline_viewshed.core.base.posed import PosedPhoto
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer
from skyline_viewshed.core.base.view import open_view, outline_px
from skyline_viewshed.core.figures.panorama import (
    PanoramaFrame,
    PanoramaLabel,
    PanoramaLayout,
    lay_out_panorama,
    panorama_pixels,
    panorama_svg,
)
from skyline_viewshed.core.horizon.horizon import HorizonOptions, horizon_profile
from skyline_viewshed.core.horizon.panorama import PanoramaOptions, outline_panorama, sample_distances_m
from skyline_viewshed.demo.mountains import MountainOptions, make_mountains


def ringed():
    """A plane with a low round ridge at 1 km and a high one at 3 km."""
    row, col = np.mgrid[:801, :801]
    distance = np.hypot(row - 400, col - 400) * 10
    z = np.where(np.abs(distance - 1000) < 25, 80.0, 0.0) + np.where(np.abs(distance - 3000) < 25, 500.0, 0.0)
    return ArrayTerrain(z.astype(np.float32), 10.0)


OPTIONS = PanoramaOptions(step_deg=0.5, max_distance_m=3900.0)


@pytest.fixture(scope="module")
def rings():
    return outline_panorama(ringed(), Observer(0, 0, 20.0), OPTIONS)


def test_a_ring_within_a_ring_gives_two_outlines(rings):
    inner = [o for o in rings.outlines if not o.horizon]
    outer = [o for o in rings.outlines if o.horizon]
    assert sum(np.ptp(o.azimuth_deg) for o in outer) == pytest.approx(360, abs=1)
    assert sum(np.ptp(o.azimuth_deg) for o in inner) == pytest.approx(360, abs=3)
    assert np.concatenate([o.elevation_deg for o in outer]) == pytest.approx(
        np.degrees(np.arctan2(480, 2975)), abs=0.12
    )
    assert np.concatenate([o.distance_m for o in inner]) == pytest.approx(1000, abs=30)
    assert rings.outlines[0].horizon and not rings.outlines[-1].horizon  # farthest first


def test_the_horizon_is_the_engines_horizon():
    terrain = make_mountains(7, MountainOptions(size=256))
    observer = Observer(*terrain.position_of(120.0, 130.0), 5.0)
    panorama = outline_panorama(terrain, observer, PanoramaOptions(step_deg=0.25, max_distance_m=4000.0))
    engine = horizon_profile(
        terrain, observer, HorizonOptions(azimuth_step_deg=0.25, near_skip_cells=100 / 30, max_distance_m=4000.0)
    )
    assert panorama.eye_elevation_m == pytest.approx(engine.eye_elevation_m)
    apart = panorama.horizon_deg - np.interp(panorama.azimuth_deg, engine.azimuth_deg, engine.elevation_deg, period=360)
    # Samples half a cell apart may miss a crest, never rise above it.
    assert np.nanmedian(np.abs(apart)) < 0.02 and np.nanquantile(apart, 0.99) < 0.05
    assert np.nanquantile(np.abs(apart), 0.95) < 0.3


def test_every_outline_lies_on_or_below_the_horizon(rings):
    for outline in rings.outlines:
        horizon = np.interp(outline.azimuth_deg % 360, rings.azimuth_deg, rings.horizon_deg, period=360)
        assert (outline.elevation_deg <= horizon + 1e-6).all()


def test_a_flat_plain_has_a_horizon_and_nothing_else():
    terrain = ArrayTerrain(np.zeros((401, 401), np.float32), 10.0)
    panorama = outline_panorama(terrain, Observer(0, 0, 20.0), PanoramaOptions(step_deg=1.0, max_distance_m=1900.0))
    assert all(outline.horizon for outline in panorama.outlines)
    assert panorama.horizon_deg == pytest.approx(-np.degrees(np.arctan2(20, 1890)), abs=0.05)


def test_where_the_dem_knows_nothing_there_is_no_horizon():
    z = np.zeros((401, 401), np.float32)
    z[:, 150:] = np.nan
    z[195:206, 195:206] = 0.0
    panorama = outline_panorama(
        ArrayTerrain(z, 10.0), Observer(0, 0, 20.0), PanoramaOptions(step_deg=1.0, max_distance_m=1900.0)
    )
    assert np.isnan(panorama.horizon_deg[90]) and np.isfinite(panorama.horizon_deg[270])


def test_distances_grow_with_the_azimuth_step_and_reach_the_end():
    distance = sample_distances_m(30.0, PanoramaOptions(step_deg=0.1, max_distance_m=50_000))
    step = np.diff(distance)
    assert distance[0] == 100 and distance[-1] == 50_000 and distance.size < 3500
    assert step[0] == pytest.approx(1.0) and step.max() == pytest.approx(50_000 * np.radians(0.1) / 2, rel=0.01)
    assert step[(distance[:-1] > 2000) & (distance[:-1] < 10_000)] == pytest.approx(15.0)


def test_options_refuse_nonsense():
    with pytest.raises(ValueError, match="step_deg"):
        PanoramaOptions(step_deg=0)
    with pytest.raises(ValueError, match="min_distance_m"):
        PanoramaOptions(min_distance_m=0)


def drawing(rings):
    terrain = ringed()
    view = open_view(terrain, PosedPhoto(Camera(400, 300, 400.0), Pose(0.0, 5.0), Observer(0, 0, 20.0)), 3900.0)
    frame = PanoramaFrame("IMG <1>", *view.ray_of(*outline_px(view.camera)))
    labels = [PanoramaLabel("Ring & Co 500 m", 90.0, 9.0), PanoramaLabel("North 500 m", 0.0, 9.0)]
    return lay_out_panorama(rings, labels, [frame], PanoramaLayout(180.0, 6.0))


def test_the_drawing_puts_azimuths_and_heights_in_their_places(rings):
    drawn = drawing(rings)
    assert drawn.width == 360 * 6
    east, north = drawn.labels
    assert east.point_x_px == pytest.approx((90 - 180) % 360 * 6) and north.point_x_px == pytest.approx(180 * 6)
    assert east.point_y_px == pytest.approx(drawn.level_y - 9 * 6)
    (_, x, _) = drawn.frames[0]
    assert np.nanmin(x) < 180 * 6 < np.nanmax(x)


def test_the_svg_is_well_formed_and_words_are_harmless(rings):
    svg = panorama_svg(drawing(rings), "a <title>")
    root = ET.fromstring(svg)
    words = [element.text for element in root.iter("{http://www.w3.org/2000/svg}text")]
    assert "IMG <1>" in words and "Ring & Co 500 m" in words and "N" in words
    paths = [element.get("d") for element in root.iter("{http://www.w3.org/2000/svg}path")]
    assert len(paths) > 20 and not any("nan" in path for path in paths)


def test_the_pixels_show_outlines_photo_and_names(rings):
    pytest.importorskip("PIL")
    drawn = drawing(rings)
    pixels = panorama_pixels(drawn)
    assert pixels.shape == (round(drawn.height), round(drawn.width), 3)
    dark = (pixels.sum(axis=2) < 400).sum()
    orange = ((pixels[..., 0] > 180) & (pixels[..., 2] < 90)).sum()
    assert dark > 1000 and orange > 300
