"""The public face: examples run, arrays suffice, files give the same, reports of values are short."""

from __future__ import annotations

import csv
import doctest
import inspect
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import skyline_viewshed as sv
from skyline_viewshed.core import api, batch
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.base.errors import MissingPackageError

ROOT = Path(__file__).resolve().parent.parent.parent
PLACE = (8.0, 46.5)
FACTS = {"longitude_deg": 8.0, "latitude_deg": 46.5, "hfov_deg": 60.0}
FUNCTIONS = [name for name in api.__all__ if inspect.isfunction(getattr(api, name))]


@pytest.fixture(scope="module")
def mountains():
    return sv.example_terrain()


@pytest.fixture(scope="module")
def pixels(mountains):
    return sv.simulate(mountains, PLACE, heading_deg=300, pitch_deg=3, hfov_deg=60)


@pytest.fixture(scope="module")
def oriented(mountains, pixels):
    return sv.orient(pixels, mountains, **FACTS)


@pytest.fixture(scope="module")
def files(scene, tmp_path_factory):
    """A folder as the examples of the docstrings have it."""
    folder = tmp_path_factory.mktemp("files")
    shutil.copy(scene.dem, folder / "dem.tif")
    for photo in scene.folder.glob("*.jpg"):
        shutil.copy(photo, folder)
    return folder


@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_public_function_has_an_example_that_runs(name, files, monkeypatch):
    monkeypatch.chdir(files)
    function = getattr(api, name)
    finder = doctest.DocTestFinder(recurse=False)
    examples = finder.find(function, name, globs={**vars(api), **function.__globals__})
    assert sum(len(test.examples) for test in examples) >= 1
    runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS)
    for test in examples:
        assert runner.run(test).failed == 0


def test_every_public_function_says_what_its_parameters_mean():
    missing = [
        name
        for name in FUNCTIONS
        if len(inspect.signature(getattr(api, name)).parameters) >= 3
        and "Parameters\n    ----" not in inspect.getsource(getattr(api, name))
    ]
    assert missing == []


def test_the_package_offers_what_the_api_does_and_imports_it_late():
    assert sv.__all__ == api.__all__
    assert set(sv.__all__) <= set(dir(sv))
    with pytest.raises(AttributeError, match="no attribute 'nonsense'"):
        _ = sv.nonsense
    code = "import sys, skyline_viewshed as sv; assert not {'numpy', 'skyline_viewshed.core'} & set(sys.modules); "
    code += "assert callable(sv.classFactory) and 'orient' in dir(sv); sv.orient; assert 'numpy' in sys.modules"
    environment = {"PYTHONPATH": str(ROOT / "build" / "plugins")}
    done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def test_arrays_alone_suffice(mountains, oriented):
    assert oriented.status == "accepted"
    assert abs(difference(oriented.heading_deg, 300.0)) < 0.5
    assert abs(oriented.pitch_deg - 3.0) < 0.5 and abs(oriented.roll_deg) < 0.5
    low, high = oriented.heading_interval_deg
    assert difference(oriented.heading_deg, low) > 0 > difference(oriented.heading_deg, high)
    horizon = sv.horizon_profile(mountains, oriented.observer)
    np.testing.assert_array_equal(horizon.elevation_deg, oriented.horizon.elevation_deg)
    seen = sv.viewshed(mountains, oriented)
    everything = sv.viewshed(mountains, oriented.observer)
    assert 0 < seen.seen_cells < everything.seen_cells
    assert seen.seen_cells == seen.visible.sum()
    same = sv.viewshed(mountains, oriented.view)
    np.testing.assert_array_equal(same.values, seen.values)


def test_compasses_are_judged_by_the_photographs_that_can_be_relied_on(oriented):
    metadata = replace(oriented.metadata, camera="Maker 1")
    heading_deg = oriented.heading_deg
    photos = [replace(oriented, metadata=metadata, compass_true_deg=heading_deg + error) for error in (2.0, 3.0, 5.0)]
    (one,) = sv.compass_audit([oriented, *photos])
    assert (one.device, one.count) == ("Maker 1", 3) and one.bias_deg == pytest.approx(3.0)


def test_pixels_are_placed_where_they_were_drawn(mountains, oriented):
    """The renderer's own ground distances are the reference."""
    from skyline_viewshed.core.base.camera import Camera, Pose, focal_of_fov_px
    from skyline_viewshed.core.simulate.render import render_view

    camera = Camera(800, 600, focal_of_fov_px(800, 60.0))
    truth = render_view(mountains, sv.Observer(*PLACE), camera, Pose(300.0, 3.0, 0.0))
    x, y = np.array([[400, 150], [400, 650]]), np.array([[500, 480], [20, 520]])
    longitude, latitude = oriented.view.place(mountains, x, y)
    assert longitude.shape == latitude.shape == (2, 2)
    assert np.isnan(longitude[1, 0]) and np.isnan(latitude[1, 0])
    col, row = mountains.pixel_of(longitude, latitude)
    true_col, true_row = truth.frame.to_pixel(truth.east_m, truth.north_m)
    ground = np.isfinite(longitude)
    assert ground.sum() == 3
    offset = np.hypot(col - true_col[y, x], row - true_row[y, x])[ground] * mountains.cell_m
    assert (offset < 0.05 * truth.distance_m[y, x][ground] + 20).all()


@pytest.mark.parametrize("x, y", [(800, 300), (400, -1), (np.nan, 300)])
def test_pixels_outside_the_picture_are_refused(mountains, oriented, x, y):
    with pytest.raises(ValueError, match="1 of 2 pixels lie outside the picture of 800 x"):
        oriented.view.place(mountains, [400, x], [300, y])


def test_a_photo_instance_and_a_large_array_serve_too(mountains, pixels, oriented):
    large = pixels.repeat(2, axis=0).repeat(2, axis=1)
    found = sv.orient(large, mountains, **FACTS)
    assert (found.metadata.width_px, found.camera.width_px) == (1600, 1600)
    assert abs(difference(found.heading_deg, oriented.heading_deg)) < 0.3
    metadata = sv.PhotoMetadata("a.jpg", 800, 600, latitude_deg=46.5, longitude_deg=8.0, focal_length_35mm=31.2)
    assert abs(difference(sv.orient(sv.Photo(metadata, pixels), mountains).heading_deg, 300.0)) < 0.5


@pytest.mark.parametrize(
    "wrong", [np.zeros((60, 80, 3)), np.zeros((60, 80), np.uint8), np.zeros((60, 80, 1), np.uint8)], ids=str
)
def test_what_is_no_picture_is_refused(mountains, wrong):
    with pytest.raises(TypeError, match="uint8 array"):
        sv.orient(wrong, mountains, **FACTS)


def test_a_misspelt_fact_is_refused(mountains, pixels):
    with pytest.raises(TypeError, match="fov_deg"):
        sv.orient(pixels, mountains, fov_deg=60)
    with pytest.raises(TypeError, match="azimuth"):
        sv.simulate(mountains, PLACE, azimuth=3)


def test_missing_facts_are_named_as_the_functions_name_them(mountains, pixels):
    nowhere = sv.orient(pixels, mountains, hfov_deg=60)
    assert nowhere.status == "failed" and "longitude_deg and latitude_deg" in nowhere.message
    unknown_lens = sv.orient(pixels, mountains, longitude_deg=8.0, latitude_deg=46.5)
    assert unknown_lens.status == "failed" and "hfov_deg" in unknown_lens.message
    for photo in (nowhere, unknown_lens):
        assert photo.heading_deg is photo.view is photo.heading_interval_deg is None
        assert "FIELD" not in photo.message and "layer" not in photo.message
    with pytest.raises(ValueError, match="no heading: The photo has no GPS position"):
        sv.viewshed(mountains, nowhere)


def test_method_and_compass_override_the_options(scene):
    dem, path = sv.open_dem(scene.dem), scene.folder / "north.jpg"
    options = sv.OrientOptions(horizon=sv.HorizonOptions(max_distance_m=30_000))
    by_paper = sv.orient(path, dem, method="paper", options=options)
    assert by_paper.p_correct is None and by_paper.horizon.reach_m.max() <= 30_000
    blind, hinted = sv.orient(path, dem), sv.orient(path, dem, compass="prior")
    assert hinted.p_correct > blind.p_correct
    with pytest.raises(ValueError, match="method must be one of"):
        sv.orient(path, dem, method="guess")


def test_files_in_a_folder_are_oriented_as_one_by_one(scene):
    dem, fractions = sv.open_dem(scene.dem), []
    photos = list(sv.orient_many(scene.folder, dem, progress=fractions.append))
    assert [Path(photo.path).stem for photo in photos] == ["north", "west"]
    for photo in photos:
        true = scene.truth[Path(photo.path).stem]
        assert abs(difference(photo.heading_deg, true.heading_deg)) < 0.5
        assert photo.heading_deg == sv.orient(photo.path, dem).heading_deg
    assert fractions == sorted(fractions) and fractions[-1] == 1.0


def test_facts_of_one_photo_come_with_its_request(scene):
    dem, (longitude, latitude) = sv.open_dem(scene.dem), scene.positions["west"]
    request = sv.PhotoRequest(str(scene.odd / "no_gps.jpg"), longitude, latitude)
    lost, found = sv.orient_many([request.path, request], dem)
    assert lost.status == "failed"
    assert abs(difference(found.heading_deg, scene.truth["west"].heading_deg)) < 0.5


def test_no_photo_ends_a_run(scene, mountains, pixels, monkeypatch, caplog):
    real = api.orient_request

    def faulty(request, *arguments):
        if request.path == "bad.jpg":
            raise ZeroDivisionError("by zero")
        return real(request, *arguments)

    monkeypatch.setattr(batch, "orient_request", faulty)
    photos = list(sv.orient_many([pixels, "bad.jpg", "missing.jpg"], mountains, **FACTS))
    assert [photo.status for photo in photos] == ["accepted", "failed", "failed"]
    assert photos[1].message.startswith("An unexpected error occurred on this photo.") and photos[1].path == "bad.jpg"
    assert photos[1].orientation.notes == ("ZeroDivisionError: by zero",)
    assert "Traceback" in caplog.text
    assert "cannot be read" in photos[2].message


def test_masked_and_odd_elevations(mountains):
    masked = np.ma.masked_less(np.arange(20.0).reshape(4, 5), 3)
    dem = sv.dem_from_array(masked, 30)
    assert np.isnan(dem.elevation_m[0, :3]).all() and dem.elevation_m[3, 4] == 19
    for wrong in (np.zeros(4), np.full((3, 3), np.nan), np.zeros((1, 5))):
        with pytest.raises(ValueError, match="two dimensions"):
            sv.dem_from_array(wrong, 30)
    with pytest.raises(ValueError, match="positive"):
        sv.dem_from_array(np.zeros((3, 3)), 0)


def test_landmarks_serve_on_an_array(mountains, oriented, pixels):
    longitude, latitude = oriented.view.place(mountains, [400], [450])
    mark = sv.LandmarkHint(400.0, 450.0, float(longitude[0]), float(latitude[0]))
    found = sv.orient(pixels, mountains, landmarks=(mark,), **FACTS)
    assert found.status == "accepted" and abs(difference(found.heading_deg, 300.0)) < 0.5


def test_values_are_shown_in_one_short_line(scene, mountains, oriented):
    values = [oriented, oriented.horizon, sv.viewshed(mountains, oriented), mountains, sv.open_dem(scene.dem)]
    values.append(sv.orient(scene.odd / "no_gps.jpg", mountains))
    for value in values:
        assert "\n" not in repr(value) and len(repr(value)) < 240, repr(value)
    assert "accepted, heading 300.0" in repr(oriented)
    assert "failed. The photo has no GPS position" in repr(values[-1])


def test_a_notebook_shows_the_overlay(oriented):
    assert oriented._repr_html_().startswith('<img src="data:image/jpeg;base64,')


def test_the_overlay_is_a_picture(oriented):
    picture = sv.overlay(oriented, width_px=320, legend=False)
    assert picture.size == (320, 240)
    assert np.asarray(picture).std() > 10


def test_points_are_those_of_the_layers(scene, tmp_path):
    ogr = pytest.importorskip("osgeo.ogr")
    photos = list(
        sv.orient_many([*sorted(scene.folder.glob("*.jpg")), scene.odd / "empty.heic"], sv.open_dem(scene.dem))
    )
    for suffix in ("gpkg", "geojson", "csv"):
        sv.save_points(photos, tmp_path / f"photos.{suffix}")
    source = ogr.Open(str(tmp_path / "photos.gpkg"))
    rows = [feature.items() for feature in source.GetLayer(0)]
    assert [row["status"] for row in rows] == ["accepted", "accepted", "failed"]
    assert rows[0]["heading"] == pytest.approx(photos[0].heading_deg)
    assert rows[0]["radius"] == 100_000.0 and rows[0]["camera"] == "Test Camera"
    assert rows[2]["photo"] == str(scene.odd / "empty.heic") and rows[2]["heading"] is None
    with open(tmp_path / "photos.csv", newline="", encoding="utf-8") as table:
        assert [row["filename"] for row in csv.DictReader(table)] == ["north", "west", "empty"]
    with pytest.raises(ValueError, match="must end in one of"):
        sv.save_points(photos, tmp_path / "photos.shp")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["photos.csv", "photos.geojson", "photos.gpkg"]


def test_a_viewshed_file_is_known_again(scene, tmp_path):
    from skyline_viewshed.core.io.viewshed_raster import fingerprint, read_viewshed

    dem = sv.open_dem(scene.dem)
    photo = sv.orient(scene.folder / "west.jpg", dem)
    seen = sv.viewshed(dem, photo, options=sv.ViewshedOptions(max_distance_m=8_000))
    sv.save_viewshed(seen, dem, tmp_path / "seen.tif")
    mark = fingerprint(dem, photo.observer, seen.sector, seen.options)
    window, values = read_viewshed(tmp_path / "seen.tif", dem, mark)
    assert window == seen.window
    np.testing.assert_array_equal(values, seen.values)


@pytest.mark.parametrize(
    "call", ["open_dem('dem.tif')", "save_points([], 'a.csv')", "save_viewshed(None, None, 'a.tif')"]
)
def test_without_gdal_what_needs_it_says_so(call, monkeypatch):
    for module in ("osgeo", "osgeo.gdal", "osgeo.ogr"):
        monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(MissingPackageError, match=r"needs the Python package osgeo\.(gdal|ogr)\. .*"):
        eval(f"sv.{call}")
