from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from skyline_viewshed.core.base.camera import Camera, Pose
from skyline_viewshed.core.base.posed import PosedPhoto
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer
from skyline_viewshed.core.base.uncertainty import PoseUncertainty
from skyline_viewshed.core.base.view import open_view
from skyline_viewshed.core.mapping.monoplot import EllipseOptions, ground_ellipses, place_pixels
from skyline_viewshed.core.mapping.projecting import Places, PlaceState, project_places
from skyline_viewshed.core.simulate.render import render_view
from skyline_viewshed.demo.mountains import MountainOptions, make_mountains

CAMERA = Camera(640, 480, 560.0)
NONE = PoseUncertainty(0, 0, 0, 0, 0, 0, 0)


@pytest.fixture(scope="module")
def mountains():
    return make_mountains(3, MountainOptions(size=256))


@pytest.fixture(scope="module")
def rendered(mountains):
    """A simulated photograph with the ground behind each of its pixels."""
    place = mountains.position_of(90.0, 180.0)
    return render_view(mountains, Observer(*place, 40.0), CAMERA, Pose(35.0, -2.0, 1.5))


def view_of(terrain, seen, max_distance_m=9000.0):
    return open_view(terrain, PosedPhoto(seen.camera, seen.pose, seen.observer), max_distance_m)


def plane_view(pose, eye_m=100.0):
    terrain = ArrayTerrain(np.zeros((601, 601), np.float32), 10.0)
    return terrain, open_view(terrain, PosedPhoto(CAMERA, pose, Observer(0, 0, eye_m)), 2800.0)


def test_pixels_land_where_the_renderer_says(mountains, rendered):
    rows, cols = np.mgrid[5:475:9, 5:635:9]
    placed = place_pixels(mountains, view_of(mountains, rendered), cols.ravel(), rows.ravel())
    truth = rendered.distance_m[rows, cols].ravel()
    ground = np.isfinite(truth)
    assert 0.2 < ground.mean() < 0.95
    assert (placed.hits.on_ground == ground).mean() > 0.998
    both = ground & placed.hits.on_ground
    apart = np.hypot(
        placed.hits.east_m - rendered.east_m[rows, cols].ravel(),
        placed.hits.north_m - rendered.north_m[rows, cols].ravel(),
    )[both]
    assert np.median(apart) < 0.5
    assert np.quantile(apart, 0.95) < 0.5 * mountains.cell_m


def test_pixel_to_map_to_pixel_is_a_round_trip(mountains, rendered):
    view = view_of(mountains, rendered)
    rows, cols = np.mgrid[5:475:11, 5:635:11]
    placed = place_pixels(mountains, view, cols.ravel(), rows.ravel())
    ground = placed.hits.on_ground
    back = project_places(
        mountains,
        view,
        Places(placed.hits.east_m[ground], placed.hits.north_m[ground], placed.hits.elevation_m[ground]),
    )
    apart = np.hypot(back.x_px - placed.x_px[ground], back.y_px - placed.y_px[ground])
    assert apart.max() < 1e-3
    head_on = placed.incidence_deg[ground] < 75
    assert head_on.sum() > 200
    assert (back.state[head_on] == PlaceState.VISIBLE).mean() > 0.99
    # Asked for the surface instead of the exact height, the place still comes back within half a pixel.
    surface = project_places(mountains, view, Places(placed.hits.east_m[ground], placed.hits.north_m[ground]))
    apart = np.hypot(surface.x_px - placed.x_px[ground], surface.y_px - placed.y_px[ground])
    assert apart[head_on].max() < 0.5


def unsure(view, uncertainty):
    return replace(view, photo=replace(view.photo, uncertainty=uncertainty))


def test_sky_is_sky_and_has_no_place(mountains, rendered):
    view = view_of(mountains, rendered)
    placed = place_pixels(mountains, view, np.array([320.0]), np.array([0.0]))
    ellipse = ground_ellipses(mountains, view, placed)
    assert placed.hits.state[0] == 0 and np.isnan(placed.hits.east_m[0])
    assert np.isnan(ellipse.semi_major_m[0]) and np.isnan(ellipse.p_other[0])


def test_scale_and_incidence_follow_from_the_geometry():
    terrain, view = plane_view(Pose(0.0, -30.0))
    placed = place_pixels(terrain, view, *CAMERA.centre_px)
    slant = 100.0 / np.sin(np.radians(30))
    assert float(placed.metres_per_pixel) == pytest.approx(slant / CAMERA.focal_px, rel=1e-3)
    assert float(placed.incidence_deg) == pytest.approx(60.0, abs=0.1)


@pytest.mark.parametrize(
    ("sigma", "across_m", "along_m"),
    [
        # On a plane 100 m below, seen at 45 degrees, the ground is 100 m away and the slant 141 m.
        ({"heading_deg": 1.0}, 100 * np.radians(1), 0.0),
        ({"pitch_deg": 1.0}, 0.0, 141.4 * np.radians(1) / np.sin(np.radians(45))),
        ({"position_m": 3.0}, 3.0, 3.0),
        ({"dem_m": 2.0}, 0.0, 2.0),
        ({"eye_m": 2.0}, 0.0, 2.0),
    ],
)
def test_each_uncertainty_gives_its_own_axis(sigma, across_m, along_m):
    terrain, view = plane_view(Pose(90.0, -45.0))
    placed = place_pixels(terrain, view, *(np.array([c]) for c in CAMERA.centre_px))
    ellipse = ground_ellipses(terrain, unsure(view, replace(NONE, **sigma)), placed)
    scale = np.sqrt(-2 * np.log(0.1))
    major, minor = max(across_m, along_m), min(across_m, along_m)
    assert ellipse.semi_major_m[0] == pytest.approx(scale * major, rel=0.02)
    assert ellipse.semi_minor_m[0] == pytest.approx(scale * minor, rel=0.02, abs=0.06 * major)
    if abs(across_m - along_m) > 0.1:
        expected = 90.0 if along_m > across_m else 0.0
        off = (ellipse.azimuth_deg[0] - expected + 90) % 180 - 90
        assert abs(off) < 1.0
    assert ellipse.p_other[0] == 0


def test_heights_of_a_plane_are_as_sure_as_the_dem():
    terrain, view = plane_view(Pose(0.0, -30.0))
    placed = place_pixels(terrain, view, np.array([100.0]), np.array([300.0]))
    ellipse = ground_ellipses(terrain, unsure(view, PoseUncertainty(dem_m=4.0)), placed)
    assert ellipse.sigma_z_m[0] == pytest.approx(4.0, abs=0.05)
    assert ellipse.near_m[0] < placed.hits.distance_m[0] < ellipse.far_m[0]


def test_a_pixel_at_a_crest_says_that_it_may_lie_behind_it():
    z = np.zeros((601, 601), np.float32)
    z[270:275] = 30.0  # a terrace from 260 to 300 m north; the plane behind it is hidden as far as 430 m
    terrain = ArrayTerrain(z, 10.0)
    view = open_view(terrain, PosedPhoto(CAMERA, Pose(0.0, -10.0), Observer(0, 0, 100.0)), 2800.0)
    crest_x, crest_y = view.pixel_of(0.0, 296.0, 30.0)
    middle_x, middle_y = view.pixel_of(0.0, 150.0, 0.0)
    placed = place_pixels(terrain, view, np.array([crest_x, middle_x]), np.array([crest_y, middle_y]))
    sure = ground_ellipses(terrain, view, placed)
    assert 0.2 < sure.p_other[0] < 0.8
    assert sure.p_other[1] <= 0.05


def covered(mountains, trials, coverage, seed=0):
    """Share of true places inside the ellipses of simulated photographs whose pose is only known so well."""
    rng = np.random.default_rng(seed)
    sigma = PoseUncertainty(0.5, 0.2, 0.3, 0.01, 5.0, 2.0, 3.0)
    inside, edge = [], []
    for _ in range(trials):
        lon, lat = mountains.position_of(*rng.uniform(90, 170, 2))
        pose = Pose(rng.uniform(0, 360), rng.uniform(-8, 0), rng.uniform(-3, 3))
        truth = open_view(mountains, PosedPhoto(CAMERA, pose, Observer(lon, lat, 40.0)), 8000.0)
        x, y = rng.uniform(0, 640, 60), rng.uniform(100, 480, 60)
        true = place_pixels(mountains, truth, x, y)
        off = rng.standard_normal(7) * sigma.sigmas
        dlat = np.degrees(off[5] / 6_371_000)
        dlon = np.degrees(off[4] / 6_371_000) / np.cos(np.radians(mountains.latitude_deg))
        photo = PosedPhoto(
            replace(CAMERA, focal_px=CAMERA.focal_px * np.exp(off[3])),
            Pose(pose.heading_deg + off[0], pose.pitch_deg + off[1], pose.roll_deg + off[2]),
            Observer(lon + dlon, lat + dlat, eye_elevation_m=truth.eye_elevation_m + off[6]),
            sigma,
        )
        believed = open_view(mountains, photo, 8000.0)
        placed = place_pixels(mountains, believed, x, y)
        ellipse = ground_ellipses(mountains, believed, placed, EllipseOptions(coverage))
        on = placed.hits.on_ground
        east = (true.hits.east_m - placed.hits.east_m - off[4])[on]
        north = (true.hits.north_m - placed.hits.north_m - off[5])[on]
        angle = np.radians(ellipse.azimuth_deg[on])
        along, across = east * np.sin(angle) + north * np.cos(angle), east * np.cos(angle) - north * np.sin(angle)
        inside += ((along / ellipse.semi_major_m[on]) ** 2 + (across / ellipse.semi_minor_m[on]) ** 2 <= 1).tolist()
        edge += (ellipse.p_other[on] > 0.05).tolist()
    return np.array(inside), np.array(edge)


@pytest.mark.parametrize("coverage", [0.9, 0.5])
def test_ellipses_cover_the_truth_at_their_stated_rate(mountains, coverage):
    inside, edge = covered(mountains, 60, coverage)
    assert (~edge).sum() > 1500
    # Pixels of one photograph share its errors: 60 photographs tell the rate to about 0.03 (0.06 at one half).
    assert inside[~edge].mean() == pytest.approx(coverage, abs=0.06 if coverage == 0.9 else 0.12)


def test_coverage_must_be_a_share():
    with pytest.raises(ValueError, match="coverage"):
        EllipseOptions(coverage=90)
