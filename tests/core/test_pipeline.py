from dataclasses import replace

import numpy as np
import pytest
from skyline_viewshed.core.base.camera import DOUBTFUL_FOCAL_SIGMA, FOCAL_SIGMA
from skyline_viewshed.core.base.errors import MissingMetadataError, ObserverOutsideDemError
from skyline_viewshed.core.base.model import Photo, PhotoMetadata
from skyline_viewshed.core.base.terrain import Observer
from skyline_viewshed.core.horizon.horizon import HorizonOptions
from skyline_viewshed.core.io.photo import read_photo
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.match.prior import camera_prior
from skyline_viewshed.core.paper.horizon import PaperHorizonOptions
from skyline_viewshed.core.pipeline import Hints, OrientOptions, Setting, orient_photo
from skyline_viewshed.core.skyline.given import evidence_from_line
from strided import calls_with_gaps, has_gaps

METADATA = PhotoMetadata("a.jpg", 4000, 3000, focal_length_35mm=35.0)


def test_a_given_field_of_view_comes_before_the_file_s_focal_length():
    assert camera_prior(METADATA, hfov_deg=60.0).camera.hfov_deg == pytest.approx(60.0)
    assert camera_prior(METADATA).camera.focal_px == pytest.approx(5000 * 35 / np.hypot(36, 24))


def test_the_file_s_doubt_about_its_focal_length_reaches_the_fit():
    doubted = replace(METADATA, focal_sigma=DOUBTFUL_FOCAL_SIGMA)
    assert camera_prior(doubted).focal_sigma == DOUBTFUL_FOCAL_SIGMA
    assert camera_prior(doubted, hfov_deg=60.0).focal_sigma == FOCAL_SIGMA, "a given field of view is not in doubt"


def test_no_focal_length_and_no_field_of_view_is_said_with_the_remedy():
    with pytest.raises(MissingMetadataError, match="HFOV_FIELD"):
        camera_prior(replace(METADATA, focal_length_35mm=None))


def test_unknown_methods_are_refused():
    with pytest.raises(ValueError, match="method"):
        OrientOptions(method="magic")


def test_the_paper_s_method_casts_its_own_rays_fifteen_kilometres_far():
    chosen = OrientOptions(method="paper", horizon=HorizonOptions(max_distance_m=80_000)).horizon_of_method
    assert chosen.max_distance_m == 15_000
    assert isinstance(chosen, PaperHorizonOptions)


@pytest.fixture(scope="module")
def taken(scene):
    photo = read_photo(str(scene.folder / "west.jpg"))
    return photo, open_dem(str(scene.dem)), Observer(*scene.positions["west"])


@pytest.mark.parametrize("method", ["robust", "paper"])
def test_no_last_digit_depends_on_where_arrays_lie_in_memory(taken, method):
    photo, dem, observer = taken
    with calls_with_gaps() as found:
        orient_photo(photo, dem, Setting(observer, camera_prior(photo.metadata)), OrientOptions(method=method))
    assert found == set()


def test_views_with_gaps_are_told_from_whole_arrays():
    table = np.ones((6, 5))
    assert has_gaps(table[:, 3:4]) and has_gaps(table[:, 2]) and has_gaps(table[:, ::2])
    assert not any(map(has_gaps, (table, table.T, table[:, 1:], table[2], table[:1, 3:4], table[2:])))


def test_everything_that_a_report_needs_comes_with_the_answer(scene, taken):
    photo, dem, observer = taken
    found = orient_photo(photo, dem, Setting(observer, camera_prior(photo.metadata)))
    truth = scene.truth["west"]
    assert abs((found.orientation.best.pose.heading_deg - truth.heading_deg + 180) % 360 - 180) < 0.5
    assert found.evidence.probability.shape == (found.skyline.height_px, found.skyline.width_px)
    assert len(found.orientation.residual_px) == found.skyline.width_px
    assert found.camera.width_px == photo.metadata.width_px
    assert found.horizon.eye_elevation_m == found.eye_elevation_m


def test_a_skyline_given_as_it_was_found_gives_the_same_heading(taken):
    photo, dem, observer = taken
    found = orient_photo(photo, dem, Setting(observer, camera_prior(photo.metadata)))
    drawn = evidence_from_line(
        np.arange(found.skyline.width_px) * photo.metadata.width_px / found.skyline.width_px,
        found.skyline.row_px * photo.metadata.height_px / found.skyline.height_px,
        photo.metadata.width_px,
        photo.metadata.height_px,
    )
    again = orient_photo(photo, dem, Setting(observer, camera_prior(photo.metadata), Hints(evidence=drawn)))
    heading_deg = found.orientation.best.pose.heading_deg
    assert again.orientation.best.pose.heading_deg == pytest.approx(heading_deg, abs=0.3)


def test_a_picture_of_one_colour_is_rejected_not_failed(taken):
    photo, dem, observer = taken
    blank = Photo(photo.metadata, np.full_like(photo.pixels, 130))
    found = orient_photo(blank, dem, Setting(observer, camera_prior(photo.metadata)))
    assert found.orientation.status == "rejected"
    assert found.orientation.best is None
    assert "sky mask" in found.orientation.message


def test_an_observer_outside_the_dem_is_the_photo_s_fault(taken):
    photo, dem, _ = taken
    with pytest.raises(ObserverOutsideDemError):
        orient_photo(photo, dem, Setting(Observer(0.0, 0.0), camera_prior(photo.metadata)))


def test_progress_never_runs_backwards(taken):
    class Recorder:
        def __init__(self):
            self.fractions = []

        def report(self, fraction):
            self.fractions.append(fraction)

        def cancelled(self):
            return False

    photo, dem, observer = taken
    recorder = Recorder()
    orient_photo(photo, dem, Setting(observer, camera_prior(photo.metadata)), progress=recorder)
    assert np.diff(recorder.fractions).min() > -1e-9
    assert 0 <= recorder.fractions[0] <= recorder.fractions[-1] <= 1
