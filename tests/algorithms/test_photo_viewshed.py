from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import QgsFeature, QgsGeometry, QgsPointXY, QgsProcessingException, QgsVectorLayer
from rasters import make_tif
from skyline_viewshed.core.io.raster import open_dem


@pytest.fixture(scope="session")
def solved(provider, scene, tmp_path_factory):
    """The whole pipeline over the scene's photographs and the odd ones, once."""
    import shutil

    import processing

    out = tmp_path_factory.mktemp("out")
    photos = out / "photos"
    photos.mkdir()
    for path in [*scene.folder.iterdir(), scene.odd / "no_gps.jpg", scene.odd / "empty.heic"]:
        shutil.copy(path, photos / path.name)
    parameters = {
        "FOLDER": str(photos),
        "DEM": str(scene.dem),
        "MAX_DISTANCE": 10_000,
        "OUTPUT": str(out / "deep" / "points.gpkg"),
        "POLYGONS": str(out / "polygons.gpkg"),
        "VIEWSHED": str(out / "viewshed.tif"),
        "REPORT": str(out / "report.html"),
        "FIGURES": str(out / "figures"),
    }
    return out, processing.run("skylineviewshed:photoviewshed", parameters)


def test_parameters_are_the_contract(algorithm):
    it = algorithm("photoviewshed")
    names = {definition.name() for definition in it.parameterDefinitions()}
    wanted = "FOLDER INPUT PHOTO_FIELD DEM BAND METHOD COMPASS HFOV_FIELD HEIGHT_FIELD EYE_HEIGHT MAX_DISTANCE "
    wanted += "USE_ALTITUDE REFRACTION SECTOR TARGET_HEIGHT MIN_DISTANCE OUTPUT POLYGONS VIEWSHED REPORT"
    assert set(wanted.split()) <= names


def test_few_parameters_are_visible_at_first(algorithm):
    from qgis.core import QgsProcessingParameterDefinition

    it = algorithm("photoviewshed")
    visible = [
        definition.name()
        for definition in it.parameterDefinitions()
        if not definition.flags() & QgsProcessingParameterDefinition.Flag.FlagAdvanced
        and not definition.isDestination()
    ]
    assert visible == ["FOLDER", "INPUT", "DEM", "MAX_DISTANCE", "SECTOR"]


def test_one_run_gives_points_polygons_raster_and_report(solved):
    out, results = solved
    points = {f["filename"]: f for f in QgsVectorLayer(str(out / "deep" / "points.gpkg")).getFeatures()}
    polygons = list(QgsVectorLayer(str(out / "polygons.gpkg")).getFeatures())
    assert {name: f["status"] for name, f in points.items()} == {
        "north": "accepted",
        "west": "accepted",
        "no_gps": "failed",
        "empty": "failed",
    }
    assert points["north"]["heading"] == pytest.approx(20.0, abs=0.5)
    assert points["north"].geometry().asPoint().x() == pytest.approx(float(points["north"]["longitude"]), abs=1e-9)
    assert points["no_gps"].geometry().isEmpty()
    assert sorted(Path(f["photo"]).name for f in polygons) == ["north.jpg", "west.jpg"]
    assert (gdal.Open(str(out / "viewshed.tif")).ReadAsArray() == 1).sum() > 50
    report = (out / "report.html").read_text(encoding="utf-8")
    assert "Ground in view" in report and "no_gps.jpg" in report
    assert (results["COUNT"], results["ACCEPTED"], results["VIEWSHEDS"]) == (4, 2, 2)


def test_each_viewshed_has_its_figure_in_folder_and_report(solved):
    from PIL import Image

    out, results = solved
    assert results["FIGURES"] == str(out / "figures")
    assert sorted(path.name for path in (out / "figures").iterdir()) == ["north.png", "west.png"]
    report = (out / "report.html").read_text(encoding="utf-8")
    assert report.count('<details class="ground" open>') == 2
    assert len(report) < 4_000_000
    with Image.open(out / "figures" / "north.png") as picture:
        width, height = picture.size
        sky, relief = picture.getpixel((20, 60)), picture.convert("RGB").crop((width - 400, 0, width, height))
    assert height == 480 and width > 2 * height
    assert sky[2] > sky[0]  # the photograph is on the left ...
    yellow = np.ptp(np.asarray(relief, int)[..., ::2], axis=2)
    assert yellow.max() > 60  # ... and ground in view is tinted on the right


def test_the_way_between_the_photographs_is_in_order_of_time_and_rests_at_night():
    from skyline_viewshed.algorithms.shared.result_figures import PAUSE_S, way

    points = way(sorted([(90.0, (5, 5)), (0.0, (1, 1)), (100.0 + PAUSE_S, (9, 9))]))
    assert points[:, 0].tolist()[:2] == [1, 5]
    assert str(points[2, 0]) == "nan" and points[3].tolist() == [9, 9]


def test_stations_take_positions_and_times_where_they_are(run, scene, tmp_path):
    from skyline_viewshed.algorithms.shared.fields import is_null
    from skyline_viewshed.algorithms.shared.layers import PointRow
    from skyline_viewshed.algorithms.shared.result_figures import PhotoPlace, stations_of

    run("importphotos", {"FOLDER": str(scene.folder), "OUTPUT": str(tmp_path / "points.gpkg")})
    features = list(QgsVectorLayer(str(tmp_path / "points.gpkg")).getFeatures())
    rows = [PointRow(feature, "", None, None) for feature in features]
    found = stations_of(rows)
    assert len(found) == len(features)
    for feature, station in zip(features, found):
        assert station.longitude_deg == pytest.approx(float(feature["longitude"]))
        assert (station.time_s is None) == is_null(feature["timestamp"])
    assert stations_of([PointRow(features[0], "", 7.0, 46.0)])[0].longitude_deg == 7.0
    assert isinstance(found[0], PhotoPlace)


def test_a_figure_without_its_photograph_has_the_maps_alone(solved, run, scene, tmp_path):
    from PIL import Image

    layer = QgsVectorLayer(
        "Point?crs=EPSG:4326&field=heading:double&field=hfov:double&field=photo:string", "", "memory"
    )
    source = next(QgsVectorLayer(str(solved[0] / "deep" / "points.gpkg")).getFeatures("\"filename\" = 'north'"))
    for photo in (None, str(tmp_path / "gone.jpg")):
        feature = QgsFeature(layer.fields())
        feature.setGeometry(source.geometry())
        feature.setAttributes([20.0, 50.0, photo])
        layer.dataProvider().addFeature(feature)
    parameters = {"INPUT": layer, "DEM": str(scene.dem), "SECTOR": 1, "MAX_DISTANCE": 5000}
    outputs = {"OUTPUT": str(tmp_path / "v.tif"), "FIGURES": str(tmp_path / "figures")}
    _, feedback = run("directedviewshed", {**parameters, **outputs})
    pictures = sorted((tmp_path / "figures").iterdir())
    assert [path.name for path in pictures] == ["Point 1.png", "gone.png"]
    for path in pictures:
        with Image.open(path) as picture:
            assert picture.size[0] < 3 * 480
    assert any("gone.jpg" in warning and "no such file" in warning for warning in feedback.warnings)


def test_a_temporary_folder_is_the_one_that_is_told(run, scene, tmp_path):
    outputs = {"OUTPUT": "memory:", "POLYGONS": "memory:", "VIEWSHED": str(tmp_path / "v.tif")}
    folders = {"RASTERS": "TEMPORARY_OUTPUT", "FIGURES": "TEMPORARY_OUTPUT", "METHOD": 1, "MAX_DISTANCE": 3000}
    results, _ = run("photoviewshed", {"FOLDER": str(scene.folder), "DEM": str(scene.dem), **outputs, **folders})
    assert len(list(Path(results["RASTERS"]).glob("*.tif"))) == 2
    assert len(list(Path(results["FIGURES"]).glob("*.png"))) == 2


def test_two_steps_give_the_same_as_one(solved, run, scene):
    import numpy as np

    out, _ = solved
    parameters = {"INPUT": str(out / "deep" / "points.gpkg"), "DEM": str(scene.dem), "MAX_DISTANCE": 10_000}
    outputs = {"OUTPUT": str(out / "again.tif"), "FIGURES": str(out / "again")}
    results, _ = run("directedviewshed", {**parameters, **outputs})
    assert results["COUNT"] == 2
    assert sorted(path.name for path in (out / "again").iterdir()) == ["north.png", "west.png"]
    one, two = (gdal.Open(str(out / name)).ReadAsArray() for name in ("viewshed.tif", "again.tif"))
    assert np.mean((one == 1) != (two == 1)) < 1e-4


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({}, "Choose a folder"),
        ({"FOLDER": "{folder}", "INPUT": "{points}"}, "not both"),
        ({"FOLDER": "/no/such/folder"}, "does not exist"),
        ({"FOLDER": "{folder}", "DEM": "{folder}/north.jpg"}, "is a colour picture"),
        ({"FOLDER": "{folder}", "DEM": "{nowhere}"}, "coordinate"),
        ({"FOLDER": "{folder}", "MIN_DISTANCE": 10_000, "MAX_DISTANCE": 10_000}, "smaller"),
        ({"FOLDER": "{folder}", "REPORT": "{dem}/report.html"}, "not a folder you may write to"),
    ],
)
def test_wrong_choices_are_named_before_anything_runs(refusal, run, scene, tmp_path, changes, words):
    texts = {"folder": scene.folder, "dem": scene.dem, "points": tmp_path / "points.gpkg"}
    texts["nowhere"] = make_tif(tmp_path / "nowhere.tif", np.full((20, 20), 900, np.int16), crs=None)
    run("importphotos", {"FOLDER": str(scene.folder), "OUTPUT": str(texts["points"])})
    given = {key: value.format(**texts) if isinstance(value, str) else value for key, value in changes.items()}
    parameters = {"DEM": str(scene.dem), "OUTPUT": "memory:", "POLYGONS": "memory:", "VIEWSHED": "TEMPORARY_OUTPUT"}
    assert words in refusal("photoviewshed", {**parameters, **given})


def test_an_empty_folder_is_refused(run, scene, tmp_path):
    parameters = {"FOLDER": str(tmp_path), "DEM": str(scene.dem), "OUTPUT": "memory:", "POLYGONS": "memory:"}
    with pytest.raises(QgsProcessingException, match="No photograph"):
        run("photoviewshed", {**parameters, "VIEWSHED": str(tmp_path / "v.tif")})
    assert list(tmp_path.iterdir()) == []


def test_the_paper_s_method_gives_viewsheds_too(run, scene, tmp_path):
    parameters = {"FOLDER": str(scene.folder), "DEM": str(scene.dem), "METHOD": 1, "SECTOR": 1, "MAX_DISTANCE": 5000}
    outputs = {"OUTPUT": "memory:", "POLYGONS": "memory:", "VIEWSHED": str(tmp_path / "v.tif")}
    results, _ = run("photoviewshed", {**parameters, **outputs})
    assert results["VIEWSHEDS"] == 2
    assert all(0 < f["ncc"] <= 1 for f in results["OUTPUT"].getFeatures())


def test_progress_only_grows(run, scene, listener, tmp_path):
    feedback = listener()
    parameters = {"FOLDER": str(scene.folder), "DEM": str(scene.dem), "METHOD": 1, "MAX_DISTANCE": 3000}
    outputs = {"OUTPUT": "memory:", "POLYGONS": "memory:", "VIEWSHED": str(tmp_path / "v.tif")}
    run("photoviewshed", {**parameters, **outputs}, feedback)
    assert len(feedback.fractions) > 10 and feedback.fractions == sorted(feedback.fractions)


def test_cancelling_leaves_nothing(run, scene, listener, tmp_path):
    parameters = {
        "FOLDER": str(scene.folder),
        "DEM": str(scene.dem),
        "OUTPUT": str(tmp_path / "points.gpkg"),
        "POLYGONS": str(tmp_path / "polygons.gpkg"),
        "VIEWSHED": str(tmp_path / "viewshed.tif"),
        "REPORT": str(tmp_path / "report.html"),
    }
    with pytest.raises(QgsProcessingException, match="Cancelled"):
        run("photoviewshed", parameters, listener(cancel_at=55))
    assert list(tmp_path.iterdir()) == []


@pytest.fixture(scope="session")
def with_extras(provider, scene, tmp_path_factory):
    """The pipeline with every extra, once; and the same photographs step by step."""
    import processing

    out = tmp_path_factory.mktemp("extras")
    ranges = {"DEM": str(scene.dem), "MAX_DISTANCE": 6_000}
    folders = {name: str(out / "one" / name) for name in ("LAYERS", "PROBABILITIES", "RASTERS")}
    whole = processing.run(
        "skylineviewshed:photoviewshed",
        {
            **ranges,
            **folders,
            "FOLDER": str(scene.folder),
            "OWN_SKYLINE": True,
            "MIN_AREA": 12_000.0,
            "OUTPUT": str(out / "points.gpkg"),
            "POLYGONS": str(out / "polygons.gpkg"),
            "VIEWSHED": str(out / "viewshed.tif"),
        },
    )
    skylines = processing.run(
        "skylineviewshed:extractskyline", {"INPUT": str(out / "points.gpkg"), "OUTPUT": str(out / "skylines.gpkg")}
    )
    steps = processing.run(
        "skylineviewshed:directedviewshed",
        {
            **ranges,
            "INPUT": str(out / "points.gpkg"),
            "HEIGHT_FIELD": "eye_z",
            "SKYLINES": skylines["OUTPUT"],
            "MIN_AREA": 12_000.0,
            "OUTPUT": str(out / "directed.tif"),
            "POLYGONS": str(out / "directed.gpkg"),
            **{name: folder.replace("one", "two") for name, folder in folders.items()},
        },
    )
    return out, whole, steps


def test_extras_are_those_of_the_single_steps(with_extras):
    out, whole, steps = with_extras
    assert {"LAYERS", "PROBABILITIES", "RASTERS"} <= set(whole) and whole["VIEWSHEDS"] == steps["COUNT"] == 2
    ours, theirs = (gdal.Open(str(out / name)).ReadAsArray() for name in ("viewshed.tif", "directed.tif"))
    assert (ours != theirs).sum() <= 0.01 * (ours == 1).sum()  # pixels of 4,000 there, of the photo here
    for name in ("north", "west"):
        layers = gdal.Open(str(out / "one" / "LAYERS" / f"{name}.tif"))
        column, row = layers.ReadAsArray()[3:]
        assert 790 < np.nanmax(column) < 800 and np.nanmin(column) < 10 and np.nanmax(row) < 600
        chance = gdal.Open(str(out / "one" / "PROBABILITIES" / f"{name}.tif")).ReadAsArray()
        assert np.nanmax(chance) > 0.9 and (chance[chance > 0] < 1).any()
    for path in ("polygons.gpkg", "directed.gpkg"):
        for feature in QgsVectorLayer(str(out / path)).getFeatures():
            assert 0.2 < feature["terr_share"] < 0.8
            assert 0 < feature["p90_m2"] < feature["p50_m2"]
            assert min(part.area() for part in feature.geometry().asGeometryCollection()) > 9_000


def test_the_own_skyline_hides_ground_only_where_it_stands_before_it(solved, with_extras, scene):
    """The scene's photographs have no foreground: their skylines are the DEM's, and cut off next to nothing."""
    free, limited = (gdal.Open(str(out / "viewshed.tif")).ReadAsArray() for out in (solved[0], with_extras[0]))
    row, col = np.nonzero(limited == 1)  # the range is shorter there, and the rays denser
    assert len(row) > 100 and (free[row, col] > 0).mean() > 0.99
    polygons = {}
    for out in (solved[0], with_extras[0]):
        layer = QgsVectorLayer(str(out / "polygons.gpkg"))
        polygons[out] = {Path(f["photo"]).name: f for f in layer.getFeatures()}
    dem = open_dem(str(scene.dem))
    for name in ("north", "west"):
        place = dem.frame(*scene.positions[name], 20_000.0)
        seen = gdal.Open(str(with_extras[0] / "one" / "RASTERS" / f"{name}.tif"))
        kept = (seen.ReadAsArray() == 1).sum()
        geometry = polygons[solved[0]][f"{name}.jpg"].geometry()
        disc = QgsGeometry.fromPointXY(QgsPointXY(*to_plane(place, dem))).buffer(6_000, 90)
        assert kept * 75.0**2 > 0.9 * geometry.intersection(disc).area()


def to_plane(frame, dem):
    x0, dx, _, y0, _, dy = dem.geotransform
    return x0 + (frame.col_px + 0.5) * dx, y0 + (frame.row_px + 0.5) * dy
