import numpy as np
import pytest
from skyline_viewshed.core.base.camera import Camera, Pose, unproject
from skyline_viewshed.core.base.terrain import Observer
from skyline_viewshed.core.horizon.ground_rays import cast_ground_rays
from skyline_viewshed.core.horizon.inner import ground_view
from skyline_viewshed.core.match.ground import GroundEvidence, GroundMatchOptions
from skyline_viewshed.demo.mountains import MountainOptions, make_mountains

CAMERA = Camera(64, 48, 60.0)
TRUE = Pose(130.0, -2.0, 3.0)
HEADINGS = np.arange(10.0, 370.0, 15.0)


@pytest.fixture(scope="module")
def view():
    terrain = make_mountains(11, MountainOptions(size=300, cell_m=60.0, relief_m=1800.0, latitude_deg=46.0))
    return ground_view(cast_ground_rays(terrain, Observer(terrain.longitude_deg, terrain.latitude_deg, 300.0)))


def lit(view, sun, seed=0, noise=6.0, haze_m=30_000.0):
    """A picture by Lambert's law under some sun, with haze, noise and a blue sky."""
    x, y = np.meshgrid(np.arange(64.0), np.arange(48.0))
    ground = view.at(*unproject(CAMERA, TRUE, x, y))
    shade = np.clip(np.tensordot(np.asarray(sun) / np.linalg.norm(sun), ground[:3], 1), 0, None)
    veil = 1 - np.exp(-np.exp(ground[3]) / haze_m)
    picture = (30 + 170 * shade)[..., None] * (1 - veil)[..., None] + veil[..., None] * np.array([170, 190, 220])
    picture = np.where(np.isfinite(picture), picture, np.array([120.0, 160.0, 230.0]))
    return np.clip(picture + np.random.default_rng(seed).normal(0, noise, picture.shape), 0, 255)


def trials_at(headings):
    count = len(headings)
    return np.column_stack([headings, np.full(count, -2.0), np.full(count, 3.0), np.zeros((count, 2))])


@pytest.mark.parametrize("sun", [(1.0, 0.2, 0.6), (-0.7, -0.7, 0.4), (0.0, -1.0, 1.5)])
def test_the_right_heading_explains_most_wherever_the_sun_stands(view, sun):
    scores = GroundEvidence(lit(view, sun), view).score(CAMERA, trials_at(HEADINGS))
    right = int(np.flatnonzero(np.isclose(HEADINGS, TRUE.heading_deg))[0])
    assert scores.argmax() == right
    assert scores[right] > np.delete(scores, right).max() + 0.3


def test_pictures_at_any_scale_are_asked_with_the_camera_of_any_scale(view):
    evidence = GroundEvidence(lit(view, (1.0, 0.2, 0.6)), view)
    small = evidence.score(CAMERA, trials_at(HEADINGS))
    large = evidence.score(CAMERA.scaled(640, 480), trials_at(HEADINGS))
    assert large == pytest.approx(small, abs=0.02)


def test_noise_says_next_to_nothing(view):
    noise = np.random.default_rng(3).uniform(0, 255, (48, 64, 3))
    assert GroundEvidence(noise, view).score(CAMERA, trials_at(HEADINGS)).max() < 0.1


def test_an_even_picture_says_nothing(view):
    scores = GroundEvidence(np.full((48, 64, 3), 140.0), view).score(CAMERA, trials_at(HEADINGS))
    assert np.abs(scores).max() < 1e-6


def test_a_plane_of_light_over_the_picture_says_nothing(view):
    x, y = np.meshgrid(np.arange(64.0), np.arange(48.0))
    vignette = np.exp(4 + 0.01 * x - 0.02 * y)[..., None] - 1 + np.zeros(3)
    assert np.abs(GroundEvidence(vignette, view).score(CAMERA, trials_at(HEADINGS))).max() < 1e-3


def test_a_picture_of_the_sky_scores_nothing(view):
    trials = trials_at(HEADINGS)
    trials[:, 1] = 70.0
    assert (GroundEvidence(lit(view, (1.0, 0.2, 0.6)), view).score(CAMERA, trials) == 0).all()


def test_a_border_does_not_count(view):
    picture = lit(view, (1.0, 0.2, 0.6))
    trials = trials_at(np.array([TRUE.heading_deg]))
    whole = GroundEvidence(picture, view).score(CAMERA, trials)
    picture[:, :8] = np.nan
    bordered = GroundEvidence(picture, view).score(CAMERA, trials)
    assert 0.5 * whole < bordered < 1.05 * whole


def test_the_weight_scales_the_score(view):
    picture, trials = lit(view, (1.0, 0.2, 0.6)), trials_at(HEADINGS[:4])
    once = GroundEvidence(picture, view, GroundMatchOptions(weight=1.0)).score(CAMERA, trials)
    assert GroundEvidence(picture, view, GroundMatchOptions(weight=3.0)).score(CAMERA, trials) == pytest.approx(
        3 * once
    )
