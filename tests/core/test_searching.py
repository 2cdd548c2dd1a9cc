"""What a search takes from the other rooms, on a drawn skyline and a simulated range."""

import numpy as np
import pytest
from scenes import mountain_scene
from skyline_viewshed.core.base.model import PhotoMetadata
from skyline_viewshed.core.batch import PhotoRequest
from skyline_viewshed.core.io.write_photo import write_photo
from skyline_viewshed.core.locate.curves import CurveSet
from skyline_viewshed.core.locate.places import IndexOptions
from skyline_viewshed.core.match.prior import CameraPrior
from skyline_viewshed.core.searching import LocateOptions, SkylineProblem, horizons_at, lens, picture_of


def test_the_options_of_a_run_reach_the_exact_horizons_and_the_heights():
    index = IndexOptions(eye_height_m=2.0, max_distance_m=20_000.0, refraction_coefficient=0.2)
    options = LocateOptions.of(index, (20.0, 90.0), 32.0)
    assert options.eye_heights_m == pytest.approx((12.0, 22.0, 32.0))
    assert (options.horizon.max_distance_m, options.horizon.refraction_coefficient) == (20_000.0, 0.2)
    assert options.hfov_limits_deg == (20.0, 90.0)
    assert LocateOptions.of(index, (20.0, 90.0), 1.0).eye_heights_m == ()


def test_a_known_lens_has_one_focal_length_and_an_unknown_one_several():
    recorded = PhotoMetadata("a.jpg", 400, 300, focal_length_35mm=35.0)
    prior, log_focals = lens(recorded, None, (30.0, 75.0))
    assert log_focals.tolist() == [0.0]
    assert lens(recorded, 50.0, (30.0, 75.0))[0].camera.hfov_deg == pytest.approx(50.0) != prior.camera.hfov_deg
    unknown, log_focals = lens(PhotoMetadata("a.jpg", 400, 300), None, (30.0, 75.0))
    assert len(log_focals) > 10 and unknown.focal_sigma == pytest.approx(log_focals.max())


def test_the_fit_finds_the_pose_at_the_place_of_its_horizon(match_scenes):
    seen = match_scenes.scene(seed=17, heading_deg=120.0, pitch_deg=3.0, roll_deg=1.0)
    true, other = (match_scenes.random_horizon(seed) for seed in (17, 18))
    problem = SkylineProblem(seen.evidence, CameraPrior(seen.camera, 0.02))
    curves = CurveSet(
        np.array([true.elevation_deg, other.elevation_deg]), np.array([true.distance_m, other.distance_m]), true.cell_m
    )
    trial, score = problem.climb(curves, np.tile([121.5, 2.0, 0.0, 0.0, 0.0], (2, 1)), 10.0, 1.0, 2)
    assert trial[0, :3] == pytest.approx([120.0, 3.0, 1.0], abs=0.3)
    assert score[0] > score[1] + 1
    explained, relief_deg = problem.facts(curves, trial[0])
    assert explained > 0.8 and 0.1 < relief_deg < 10


def test_places_outside_the_dem_have_no_horizon_and_the_height_counts():
    scene = mountain_scene(1)
    place = scene.observer.longitude_deg, scene.observer.latitude_deg
    options = LocateOptions.of(IndexOptions(eye_height_m=3.0, max_distance_m=8_000.0), (30.0, 75.0), 0.0)
    inside, outside = horizons_at(scene.terrain, options, (place[0], 20.0), (place[1], 10.0), np.nan)
    assert outside is None
    (higher,) = horizons_at(scene.terrain, options, place[:1], place[1:], 103.0)
    assert higher.eye_elevation_m - inside.eye_elevation_m == pytest.approx(100.0)


def test_the_horizon_in_a_view_is_that_of_the_whole_circle_and_unknown_elsewhere():
    scene = mountain_scene(1)
    place = (scene.observer.longitude_deg,), (scene.observer.latitude_deg,)
    options = LocateOptions.of(IndexOptions(max_distance_m=8_000.0), (30.0, 75.0), 0.0)
    (whole,) = horizons_at(scene.terrain, options, *place, np.nan)
    (seen,) = horizons_at(scene.terrain, options, *place, np.nan, (355.0, 60.0))
    away = np.abs((whole.azimuth_deg - 355.0 + 180) % 360 - 180)
    known = np.isfinite(seen.elevation_deg)
    assert known[away < 45].all() and not known[away > 60].any()
    assert seen.elevation_deg[known] == pytest.approx(whole.elevation_deg[known], abs=1e-4)
    assert np.array_equal(seen.azimuth_deg, whole.azimuth_deg) and seen.clipped.shape == whole.clipped.shape
    (round_about,) = horizons_at(scene.terrain, options, *place, np.nan, (355.0, 300.0))
    assert np.isfinite(round_about.elevation_deg).all()


def test_a_drawn_skyline_and_a_given_focal_length_replace_those_of_the_picture(tmp_path):
    path = str(tmp_path / "photo.jpg")
    write_photo(path, np.full((300, 400, 3), 128, np.uint8), PhotoMetadata(path, 400, 300, focal_length_35mm=28.0))
    drawn = (0.0, 100.0), (200.0, 60.0), (399.0, 100.0)
    photo, evidence = picture_of(PhotoRequest(path, focal_length_35mm=50.0, drawn_skyline=drawn))
    assert photo.metadata.focal_length_35mm == 50.0
    width = evidence.probability.shape[1]
    row = evidence.best.row_px * 400 / width
    assert row[[width // 4, width // 2]] == pytest.approx([80.0, 60.0], abs=3)
