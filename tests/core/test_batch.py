import csv
from dataclasses import replace
from datetime import datetime

import numpy as np
import pytest
from moonlit import moonlit_photo
from osgeo import gdal
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.base.camera import project
from skyline_viewshed.core.base.declination import declination_deg
from skyline_viewshed.core.base.errors import TerrainError, UnusableDemError
from skyline_viewshed.core.base.landmark_hint import LandmarkHint
from skyline_viewshed.core.batch import PhotoRequest, doubt_of_heights, orient_request
from skyline_viewshed.core.eyes import HorizonCache
from skyline_viewshed.core.io.dem_reading import DemReading
from skyline_viewshed.core.io.photo import read_photo
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.io.write_photo import write_photo
from skyline_viewshed.core.pipeline import OrientOptions


@pytest.fixture(scope="module")
def dem(scene):
    return open_dem(str(scene.dem))


@pytest.fixture(scope="module")
def north(scene, dem):
    return orient_request(PhotoRequest(str(scene.folder / "north.jpg")), dem)


def turn(oriented, pose):
    return abs(float(difference(oriented.orientation.best.pose.heading_deg, pose.heading_deg)))


def test_a_photo_on_disk_is_oriented_from_its_own_metadata(scene, north):
    truth = scene.truth["north"]
    assert turn(north, truth) < 0.5
    assert abs(north.orientation.best.pose.pitch_deg - truth.pitch_deg) < 0.3
    assert (north.longitude_deg, north.latitude_deg) == pytest.approx(scene.positions["north"], abs=1e-6)
    assert north.eye_elevation_m == pytest.approx(north.ground_elevation_m + 1.7)
    assert north.convergence_deg is not None


def test_the_compass_is_reported_and_in_blind_runs_not_looked_at(scene, dem, north):
    assert north.compass_true_deg == pytest.approx(26.0, abs=0.01)
    hinted = orient_request(PhotoRequest(str(scene.folder / "north.jpg")), dem, OrientOptions(compass="prior"))
    assert turn(hinted, scene.truth["north"]) < 0.5
    assert hinted.orientation.p_correct > north.orientation.p_correct


def test_a_magnetic_reading_is_turned_by_the_declination_of_place_and_time(scene, dem, tmp_path):
    photo = read_photo(str(scene.folder / "north.jpg"))
    metadata = replace(photo.metadata, compass_reference="M", taken_at=datetime(2024, 6, 1, 12, 0))
    path = str(tmp_path / "magnetic.jpg")
    write_photo(path, photo.pixels, metadata)
    found = orient_request(PhotoRequest(path), dem)
    expected = declination_deg(metadata.latitude_deg, metadata.longitude_deg, 0.0, metadata.taken_at)
    assert 2.0 < expected < 5.0  # the Alps in 2024
    assert found.compass_true_deg == pytest.approx(26.0 + expected, abs=0.05)


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("no_gps.jpg", "GPS position"),
        ("null_island.jpg", "GPS position"),
        ("no_focal.jpg", "HFOV_FIELD"),
        ("empty.heic", "cannot be read"),
        ("damaged.jpg", "cannot be read"),
        ("missing.jpg", "cannot be read"),
    ],
)
def test_a_photo_at_fault_fails_with_a_sentence_and_does_not_raise(scene, dem, name, words):
    found = orient_request(PhotoRequest(str(scene.odd / name)), dem)
    assert found.orientation.status == "failed"
    assert words in found.orientation.message
    assert found.orientation.best is None


def test_given_facts_stand_in_for_missing_ones(scene, dem):
    longitude, latitude = scene.positions["west"]
    lost = PhotoRequest(str(scene.odd / "no_gps.jpg"), longitude, latitude)
    assert turn(orient_request(lost, dem), scene.truth["west"]) < 0.5
    blind = PhotoRequest(str(scene.odd / "no_focal.jpg"), hfov_deg=scene.hfov_deg)
    assert turn(orient_request(blind, dem), scene.truth["west"]) < 0.5


def test_the_caller_decides_whose_position_counts(scene, dem):
    path, (longitude, latitude) = str(scene.folder / "north.jpg"), scene.positions["west"]
    assert orient_request(PhotoRequest(path, longitude, latitude), dem).longitude_deg == longitude
    own = orient_request(PhotoRequest(path, longitude, latitude, prefer_photo_position=True), dem)
    assert own.longitude_deg == pytest.approx(scene.positions["north"][0], abs=1e-6)


def test_a_position_outside_the_dem_fails_with_a_sentence(scene, dem):
    found = orient_request(PhotoRequest(str(scene.folder / "north.jpg"), 20.0, 10.0), dem)
    assert found.orientation.status == "failed"
    assert "outside the DEM" in found.orientation.message


def test_an_unusable_dem_stops_the_batch(scene, dem):
    class Broken:
        shape = dem.shape

        def frame(self, *_):
            raise UnusableDemError("broken")

    with pytest.raises(TerrainError):
        orient_request(PhotoRequest(str(scene.folder / "north.jpg")), Broken())


def test_photos_of_one_station_share_the_horizon(scene, dem):
    cache = HorizonCache()
    request = PhotoRequest(str(scene.folder / "north.jpg"))
    first, second = orient_request(request, dem, cache=cache), orient_request(request, dem, cache=cache)
    assert first.horizon is second.horizon
    moved = orient_request(replace(request, eye_height_m=5.0), dem, cache=cache)
    assert moved.horizon is not first.horizon


def test_an_eye_elevation_is_used(scene, dem, north):
    high = north.ground_elevation_m + 100.0
    found = orient_request(PhotoRequest(str(scene.folder / "north.jpg"), eye_elevation_m=high), dem)
    assert found.eye_elevation_m == pytest.approx(high)


@pytest.fixture(scope="module")
def aloft(scene, north, tmp_path_factory):
    """The photo with a recorded altitude, usually 60 m above the ground; takes the altitude's reference."""

    def write(reference, altitude_m=None):
        photo = read_photo(str(scene.folder / "north.jpg"))
        altitude_m = north.ground_elevation_m + 60.0 if altitude_m is None else altitude_m
        altitude = {"altitude_m": altitude_m, "altitude_reference": reference}
        path = str(tmp_path_factory.mktemp("aloft") / "aloft.jpg")
        write_photo(path, photo.pixels, replace(photo.metadata, **altitude))
        assert read_photo(path).metadata.altitude_reference == reference
        return path

    return write


def test_an_altitude_that_contradicts_the_dem_is_noted_and_used_only_where_it_is_trusted(dem, north, aloft):
    path = aloft("sea level")
    careful, trusting = (orient_request(PhotoRequest(path, use_altitude=use), dem) for use in (False, True))
    assert careful.eye_elevation_m == pytest.approx(north.eye_elevation_m)
    assert "60 m above the DEM's surface; the DEM was used" in " ".join(careful.orientation.notes)
    assert trusting.eye_elevation_m == pytest.approx(north.ground_elevation_m + 60.0, abs=0.1)
    assert "60 m above the DEM's surface and was used" in " ".join(trusting.orientation.notes)


def test_an_elevation_that_is_given_comes_before_a_trusted_altitude(dem, north, aloft):
    high = north.ground_elevation_m + 100.0
    found = orient_request(PhotoRequest(aloft("sea level"), use_altitude=True, eye_elevation_m=high), dem)
    assert found.eye_elevation_m == pytest.approx(high)


def test_an_altitude_above_the_ellipsoid_is_not_taken_for_one_above_the_sea(dem, north, aloft):
    found = orient_request(PhotoRequest(aloft("ellipsoid"), use_altitude=True), dem)
    assert found.eye_elevation_m == pytest.approx(north.eye_elevation_m)
    assert "refers to the ellipsoid" in " ".join(found.orientation.notes)


def test_an_altitude_of_zero_is_unknown_even_where_it_is_trusted(dem, north, aloft):
    found = orient_request(PhotoRequest(aloft("sea level", 0.0), use_altitude=True), dem)
    assert found.metadata.altitude_m == 0 and found.eye_elevation_m == pytest.approx(north.eye_elevation_m)
    assert not [note for note in found.orientation.notes if "altitude" in note]


def test_an_approximate_heading_and_a_landmark_are_used(scene, dem, north):
    camera, pose = north.orientation.best.camera, scene.truth["north"]
    index = int(np.rint(pose.heading_deg * 10))
    azimuth, distance = north.horizon.azimuth_deg[index], north.horizon.distance_m[index]
    elevation = north.horizon.elevation_deg[index]
    x, y = project(camera, pose, azimuth, elevation)
    metres = 111_195.0
    longitude = north.longitude_deg + distance * np.sin(np.radians(azimuth)) / (
        metres * np.cos(np.radians(north.latitude_deg))
    )
    latitude = north.latitude_deg + distance * np.cos(np.radians(azimuth)) / metres
    mark = LandmarkHint(float(x), float(y), float(longitude), float(latitude), sigma_px=20.0)
    request = PhotoRequest(str(scene.folder / "north.jpg"), heading_deg=25.0, landmarks=(mark,))
    found = orient_request(request, dem)
    assert turn(found, pose) < 0.5
    assert any("Landmark 1" in note for note in found.orientation.notes)


def test_a_drawn_skyline_replaces_the_extraction(scene, dem, north):
    rows = north.evidence.best.row_px * 800 / north.evidence.best.width_px
    columns = (np.arange(len(rows)) + 0.5) * 800 / len(rows) - 0.5
    drawn = tuple(zip(columns.tolist(), rows.tolist()))
    found = orient_request(PhotoRequest(str(scene.folder / "north.jpg"), drawn_skyline=drawn), dem)
    assert turn(found, scene.truth["north"]) < 0.5


@pytest.mark.parametrize("drawn", [((0, 300), (1600, 320)), ((-90, 300), (700, 320)), ((10, 300), (700, 900))])
def test_a_skyline_drawn_on_another_copy_of_the_picture_is_refused(scene, dem, drawn):
    found = orient_request(PhotoRequest(str(scene.folder / "north.jpg"), drawn_skyline=drawn), dem)
    assert found.status == "failed" and "beyond the picture of 800 x 600 pixels" in found.message


def test_a_landmark_of_another_copy_of_the_picture_is_refused_and_the_photo_is_solved(scene, dem, north):
    mark = LandmarkHint(1500.0, 200.0, north.longitude_deg, north.latitude_deg + 0.02)
    found = orient_request(PhotoRequest(str(scene.folder / "north.jpg"), landmarks=(mark,)), dem)
    assert turn(found, scene.truth["north"]) < 0.5 and found.status == "accepted"
    assert any("Landmark 1 lies outside the picture of 800 x 600" in note for note in found.orientation.notes)


def test_a_landmark_on_the_wrong_summit_does_not_turn_the_photo(scene, dem, north):
    mark = LandmarkHint(150.0, 250.0, north.longitude_deg + 0.02, north.latitude_deg + 0.02)
    found = orient_request(PhotoRequest(str(scene.folder / "north.jpg"), landmarks=(mark,)), dem)
    assert turn(found, scene.truth["north"]) < 0.5
    assert any("Landmark 1 contradicts the picture" in note for note in found.orientation.notes)


def test_the_paper_s_method_goes_through_the_same_entry(scene, dem):
    found = orient_request(PhotoRequest(str(scene.folder / "north.jpg")), dem, OrientOptions(method="paper"))
    assert found.orientation.p_correct is None
    assert found.horizon.reach_m.max() <= 15_000
    assert len(found.orientation.curve_score) == 720


@pytest.fixture(scope="module")
def moonlit(scene, tmp_path_factory):
    """The scene's photo to the west at night, with the moon in its frame, and the moon's pixel."""
    return moonlit_photo(scene, tmp_path_factory.mktemp("moon"))


def test_the_moon_is_a_landmark_without_a_map_point(scene, dem, moonlit):
    path, x, y = moonlit
    found = orient_request(PhotoRequest(path, landmarks=(LandmarkHint(x, y, body="moon"),)), dem)
    assert turn(found, scene.truth["west"]) < 0.5 and found.status == "accepted"
    miss = next(note for note in found.orientation.notes if note.startswith("Landmark 1 lies"))
    assert float(miss.facts["count"]) < 5


def test_a_body_that_cannot_be_in_the_picture_costs_the_photo_with_a_reason(scene, dem, moonlit):
    path, x, y = moonlit
    clockless = PhotoRequest(str(scene.folder / "west.jpg"), landmarks=(LandmarkHint(x, y, body="moon"),))
    found = orient_request(clockless, dem)
    assert found.status == "failed" and "does not record its time with a time zone" in found.message
    found = orient_request(PhotoRequest(path, landmarks=(LandmarkHint(x, y, body="sun"),)), dem)
    assert found.status == "failed" and "below the horizon at 2024-" in found.message


@pytest.mark.data
def test_the_moon_decides_a_photo_that_its_skyline_leaves_open(shared_data):
    folder = shared_data / "mont-blanc"
    dem = open_dem(str(next((folder / "dem").glob("*.tif"))))
    moon = LandmarkHint(922.3, 368.9, body="moon")
    photo = str(folder / "photos" / "hr_malatra_moonset.jpg")
    found = orient_request(PhotoRequest(photo, landmarks=(moon,)), dem)
    assert found.status == "accepted" and abs(found.heading_deg - 208.1) < 1.5  # the truth is known to a degree


@pytest.mark.data
def test_clear_real_photographs_are_found_blind_and_no_accepted_one_is_wrong(shared_data):
    folder = shared_data / "khumbu"
    dem = open_dem(str(folder / "dem" / "khumbu.tif"))
    with open(folder / "truth.csv", newline="") as file:
        good = [row for row in csv.DictReader(file) if row["group"] == "good"]
    errors = []
    for row in good[::2]:
        found = orient_request(PhotoRequest(str(folder / "photos" / row["photo"])), dem)
        errors.append(abs(float(difference(found.orientation.best.pose.heading_deg, float(row["heading_deg"])))))
        assert found.orientation.status != "accepted" or errors[-1] < 3
    assert max(errors) < 1.0


@pytest.mark.data
def test_a_photo_outside_its_dem_is_told_so(shared_data):
    folder = shared_data / "khumbu"
    dem = open_dem(str(folder / "dem" / "khumbu.tif"))
    found = orient_request(PhotoRequest(str(folder / "photos" / "IMG_1512.HEIC")), dem)
    assert found.orientation.status == "failed"
    assert "outside the DEM" in found.orientation.message


def test_the_same_dem_as_cog_and_in_other_coordinate_systems_gives_the_same_heading(scene, tmp_path):
    cog, utm, degrees = (str(tmp_path / f"{name}.tif") for name in ("cog", "utm", "degrees"))
    assert gdal.Translate(cog, str(scene.dem), format="COG") is not None
    gdal.Warp(utm, str(scene.dem), dstSRS="EPSG:32632", resampleAlg="cubic")
    gdal.Warp(degrees, str(scene.dem), dstSRS="EPSG:4326", resampleAlg="cubic")
    request = PhotoRequest(str(scene.folder / "north.jpg"))
    found = {
        path: orient_request(request, open_dem(path)).orientation.best.pose
        for path in (str(scene.dem), cog, utm, degrees)
    }
    first = found[str(scene.dem)]
    assert found[cog].heading_deg == pytest.approx(first.heading_deg, abs=1e-6)
    for path in (utm, degrees):
        assert found[path].heading_deg == pytest.approx(first.heading_deg, abs=0.15), path
        assert found[path].pitch_deg == pytest.approx(first.pitch_deg, abs=0.15), path


@pytest.fixture(scope="module")
def variant(scene, tmp_path_factory):
    """Write the northern photo with other metadata; takes them by name."""

    def write(**changes):
        photo = read_photo(str(scene.folder / "north.jpg"))
        path = str(tmp_path_factory.mktemp("variant") / "north.jpg")
        write_photo(path, photo.pixels, replace(photo.metadata, **changes))
        return path

    return write


def test_an_altitude_far_from_the_dem_is_not_accepted_and_has_no_interval(dem, north, variant):
    assert north.orientation.status == "accepted"
    path = variant(altitude_m=north.ground_elevation_m - 326.0, altitude_reference="sea level")
    found = orient_request(PhotoRequest(path), dem)
    assert found.orientation.status == "ambiguous"
    assert "326 m below the DEM's surface, more than GPS and DEM allow" in found.orientation.message
    assert found.orientation.p_correct <= 0.5
    assert found.orientation.heading_lo_deg is None


def test_a_dem_in_feet_is_suspected_before_the_run_and_right_once_its_unit_is_set(scene, dem, north, variant):
    path = variant(altitude_m=north.ground_elevation_m + 12.0, altitude_reference="sea level")
    in_metres = [PhotoRequest(path)]
    assert doubt_of_heights(in_metres, dem) is None
    feet = open_dem(str(scene.dem), reading=DemReading(unit=1 / 0.3048))  # as if a file in feet said metres
    assert "as if its heights were in feet" in doubt_of_heights(in_metres, feet)


@pytest.mark.parametrize("error_m", [65_000.0, 238_000.0])
def test_a_position_without_a_fix_has_no_heading(dem, variant, error_m):
    path = variant(position_error_m=error_m)
    metadata = read_photo(path).metadata
    for request in (PhotoRequest(path), PhotoRequest(path, metadata.longitude_deg, metadata.latitude_deg)):
        found = orient_request(request, dem)
        assert found.orientation.status == "failed"
        assert "uncertain by" in found.orientation.message
        assert found.orientation.best is None


def test_a_panorama_is_no_pinhole_picture_unless_its_field_of_view_is_given(scene, dem):
    photo = read_photo(str(scene.folder / "north.jpg"), 1024)
    stitched = replace(photo, metadata=replace(photo.metadata, panorama=True, focal_length_35mm=None))
    request = PhotoRequest(str(scene.folder / "north.jpg"))
    found = orient_request(request, dem, photo=stitched)
    assert (found.orientation.status, found.orientation.best) == ("failed", None)
    assert "stitched panorama" in found.orientation.message
    assert orient_request(replace(request, hfov_deg=60.0), dem, photo=stitched).orientation.best is not None
