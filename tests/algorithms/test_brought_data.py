"""Layers and files as people bring them: places, names, parts and copies that an import would not have written."""

from __future__ import annotations

import json
import shutil
from types import SimpleNamespace

import numpy as np
import pytest
from map_layers import REACH_M, memory_layer
from qgis.core import (
    QgsFeature,
    QgsGeometry,
    QgsProcessingContext,
    QgsProcessingException,
    QgsVectorLayer,
    QgsWkbTypes,
)
from qgis.PyQt.QtCore import QVariant
from skyline_viewshed.algorithms.shared.fields import metres_of
from skyline_viewshed.algorithms.shared.layers import absolute_path, path_column, position_of, wgs84_transform
from skyline_viewshed.algorithms.shared.map_places import kind_of, of_one_kind, places_of, simple_parts
from skyline_viewshed.algorithms.shared.outputs import rehearse, write_features
from skyline_viewshed.algorithms.shared.photo_points import PoseReading, photo_point, pose_values
from skyline_viewshed.algorithms.shared.pixel_input import FeaturesByPhoto, _of_geometry, upright_features
from skyline_viewshed.algorithms.shared.placing import Placing
from skyline_viewshed.core.base.pixel_features import PixelFeature

TEXT, REAL, WHOLE = QVariant.String, QVariant.Double, QVariant.Int


def oriented(scene, *names, path=None, **more):
    """The scene's photographs with their true poses."""
    fields = ["heading", "pitch", "roll", "hfov", *more]
    rows = []
    for name in names:
        pose, place = scene.truth[name], scene.positions[name]
        values = [
            path or str(scene.folder / f"{name}.jpg"),
            "accepted",
            pose.heading_deg,
            pose.pitch_deg,
            pose.roll_deg,
        ]
        rows.append((f"Point({place[0]!r} {place[1]!r})", [*values, scene.hfov_deg, *more.values()]))
    return memory_layer("Point", [("photo", TEXT), ("status", TEXT), *((name, REAL) for name in fields)], rows)


# Places


@pytest.mark.parametrize(("wkb", "crs", "shown"), [
    (QgsWkbTypes.Type.Point, "EPSG:4326", "Point (8 46.5)"),
    (QgsWkbTypes.Type.PointZ, "EPSG:4326", "PointZ (8 46.5 1200)"),
    (QgsWkbTypes.Type.MultiPoint, "EPSG:4326", "MultiPoint ((8 46.5))"),
    (QgsWkbTypes.Type.Point, "EPSG:3857", "Point (890556 5860840)"),
])  # fmt: skip
def test_a_point_without_a_place_gets_that_of_its_photo(qgis_app, wkb, crs, shown):
    from qgis.core import QgsCoordinateReferenceSystem

    metadata = SimpleNamespace(altitude_m=1200.0)
    photo = SimpleNamespace(longitude_deg=8.0, latitude_deg=46.5, metadata=metadata)
    row = SimpleNamespace(feature=QgsFeature(), longitude_deg=None)
    placing = Placing(wkb, QgsCoordinateReferenceSystem(crs), QgsProcessingContext())
    assert placing.of(row, photo).asWkt(0 if crs.endswith("3857") else 1).replace(" Z ", "Z ") == shown
    row = SimpleNamespace(feature=QgsFeature(), longitude_deg=None)
    row.feature.setGeometry(QgsGeometry.fromWkt("Point (0 0)"))  # what importers write without a position
    assert placing.of(row, photo).asWkt(1) != "Point (0 0)"
    photo.longitude_deg = None  # the photo has none either
    assert placing.of(row, photo).asWkt(0) == "Point (0 0)"


def test_a_camera_has_no_place_between_several_points(qgis_app):
    layer = memory_layer("MultiPoint", [], [("MultiPoint((8 46),(8.2 46))", []), ("MultiPoint((8 46),(8 46))", [])])
    transform = wgs84_transform(SimpleNamespace(sourceCrs=layer.crs), QgsProcessingContext())
    assert [position_of(f, transform) for f in layer.getFeatures()] == [(None, None), (8.0, 46.0)]


# Paths


def column_of(fields, chosen="photo"):
    layer = memory_layer("Point", fields, [])
    it = SimpleNamespace(parameterAsString=lambda *_: chosen)
    return path_column(it, {}, None, layer, "PHOTO_FIELD")


def test_a_column_of_pictures_is_no_column_of_paths(qgis_app):
    blob = QVariant.ByteArray
    assert column_of([("photo", blob), ("photo_path", TEXT)]) == "photo_path"
    assert column_of([("Photo", TEXT)]) == "Photo"
    with pytest.raises(QgsProcessingException, match="holds pictures, not paths"):
        column_of([("photo", blob)])
    with pytest.raises(QgsProcessingException, match="shot holds pictures"):
        column_of([("shot", blob), ("photo_path", TEXT)], "shot")


@pytest.mark.parametrize(
    "text", ["data:image/jpeg;base64," + "A" * 9000, "/9j/" + "A" * 9000, "A" * 9000, "a\0b", "b'x'"]
)
def test_a_text_that_is_no_path_loses_only_its_own_photo(tmp_path, text):
    assert len(absolute_path(text, (tmp_path,))) < 60


def test_relative_paths_and_addresses_of_files(tmp_path):
    (tmp_path / "a b.jpg").write_bytes(b"x")
    assert absolute_path("a b.jpg", (tmp_path / "no", tmp_path)) == str(tmp_path / "a b.jpg")
    assert absolute_path((tmp_path / "a b.jpg").as_uri(), ()) == str(tmp_path / "a b.jpg")


# Field names

CLASHES = [
    ("gpkg", "fid", TEXT, ["x", "y"]), ("gpkg", "fid", REAL, [1.5, 2.5]), ("gpkg", "FID", WHOLE, [7, 7]),
    ("gpkg", "geom", TEXT, ["x", "y"]), ("sqlite", "ogc_fid", WHOLE, [7, 7]), ("sqlite", "GEOMETRY", TEXT, ["x", "y"]),
    ("gdb", "OBJECTID", WHOLE, [7, 9]), ("gdb", "shape", TEXT, ["x", "y"]),
]  # fmt: skip


def written(algorithm, tmp_path, suffix, fields, rows):
    it, path = algorithm("orientphotos"), str(tmp_path / f"out.{suffix}")
    layer = memory_layer("Point", fields, [])
    features = [(QgsGeometry.fromWkt("Point(8 46)"), values) for values in rows]
    kind = layer.fields(), QgsWkbTypes.Type.Point, layer.crs()
    rehearse(it, {"OUTPUT": path}, "OUTPUT", QgsProcessingContext(), kind)
    assert not list(tmp_path.iterdir())
    made = write_features(it, {"OUTPUT": path}, "OUTPUT", QgsProcessingContext(), *kind, features)
    return QgsVectorLayer(made, "out", "ogr")


@pytest.mark.parametrize(("suffix", "name", "kind", "values"), CLASHES)
def test_a_name_that_the_format_reserves_is_changed_and_its_values_stay(
    algorithm, tmp_path, suffix, name, kind, values
):
    fields = [(name, kind), ("status", TEXT)]
    layer = written(algorithm, tmp_path, suffix, fields, [[value, "ok"] for value in values])
    assert [f[f"{name}_1"] for f in layer.getFeatures()] == values
    assert all(f["status"] == "ok" and not f.geometry().isNull() for f in layer.getFeatures())


def test_numbers_that_can_number_the_features_stay(algorithm, tmp_path):
    layer = written(algorithm, tmp_path, "gpkg", [("fid", WHOLE), ("status", TEXT)], [[7, "a"], [3, "b"]])
    assert {f["fid"]: f["status"] for f in layer.getFeatures()} == {7: "a", 3: "b"}


def test_names_that_differ_in_case_only_stay_apart(algorithm, tmp_path):
    layer = written(algorithm, tmp_path, "gpkg", [("Name", TEXT), ("name", TEXT), ("name_1", TEXT)], [["a", "b", "c"]])
    assert [next(layer.getFeatures())[n] for n in ("Name", "name_2", "name_1")] == ["a", "b", "c"]


@pytest.mark.parametrize("suffix", ["dxf", "gpx"])
def test_a_format_without_fields_is_refused_before_the_first_photo(run, scene, tmp_path, suffix):
    points = oriented(scene, "north")
    with pytest.raises(QgsProcessingException, match="cannot hold the fields"):
        run("orientphotos", {"INPUT": points, "DEM": str(scene.dem), "OUTPUT": str(tmp_path / f"o.{suffix}")})
    assert not list(tmp_path.iterdir())


# Parts and arcs


def test_parts_keep_their_holes_and_arcs_are_followed(qgis_app):
    multi = QgsGeometry.fromWkt(
        "MultiPolygon(((0 -9,9 -9,9 -1,0 -1,0 -9),(2 -7,7 -7,7 -3,2 -3,2 -7)),((4 -6,5 -6,5 -5,4 -5,4 -6)))"
    )
    drawn = _of_geometry("a.jpg", "x", multi)
    assert [len(feature.parts) for feature in drawn] == [2, 1] and all(f.as_stored for f in drawn)
    circle = QgsGeometry.fromWkt("CurvePolygon(CircularString(0 0, 10 10, 20 0, 10 -10, 0 0))")
    ((x, y, _),) = places_of(circle, "polygon")
    assert len(x) > 30 and np.hypot(x - 10, y) == pytest.approx(10)
    assert len(places_of(QgsGeometry.fromWkt("CircularString(0 0, 10 10, 20 0)"), "line")[0][0]) > 15


def test_a_mixed_collection_is_split_by_kind(qgis_app):
    mixed = QgsGeometry.fromWkt(
        "GeometryCollection(Point(1 2), MultiPoint((3 4),(5 6)), LineString(0 0, 1 1), Polygon((0 0,1 0,1 1,0 0)))"
    )
    assert [kind_of(g) for g in of_one_kind(mixed)] == ["point", "line", "polygon"]
    assert len(list(simple_parts(mixed))) == 5
    assert sorted({f.kind for f in _of_geometry("", "", mixed)}) == ["line", "point", "polygon"]
    line = QgsGeometry.fromWkt("LineString(0 0, 1 1)")
    assert of_one_kind(line) == [line]


def mixed_and_separate(scene, path):
    """A point, a line and an area ahead of the north photo: as one collection, and as features of their own."""
    lon, lat = scene.positions["north"]
    corners = [(lon + east, lat + north) for east, north in ((0.004, 0.02), (0.008, 0.02), (0.008, 0.024))]
    ring = ",".join(f"{x} {y}" for x, y in (*corners, corners[0]))
    parts = [f"Point({lon + 0.006} {lat + 0.015})", f"LineString({ring})", f"Polygon(({ring}))"]
    fields = [("name", TEXT), ("ele", REAL)]
    _write_collection(path, f"GEOMETRYCOLLECTION({','.join(parts)})")
    mixed = QgsVectorLayer(str(path), "mixed", "ogr")
    assert mixed.featureCount() == 1
    kinds = ("Point", "LineString", "Polygon")
    return mixed, [memory_layer(kind, fields, [(part, [kind, None])]) for kind, part in zip(kinds, parts)]


def _write_collection(path, wkt):
    """GeoPackage with one collection, for which memory layers have no kind and which QGIS takes for a table."""
    from osgeo import ogr, osr

    wgs84 = osr.SpatialReference()
    wgs84.ImportFromEPSG(4326)
    dataset = ogr.GetDriverByName("GPKG").CreateDataSource(str(path))
    layer = dataset.CreateLayer("mixed", wgs84, ogr.wkbGeometryCollection)
    layer.CreateField(ogr.FieldDefn("name", ogr.OFTString))
    feature = ogr.Feature(layer.GetLayerDefn())
    feature["name"] = "all"
    feature.SetGeometry(ogr.CreateGeometryFromWkt(wkt))
    layer.CreateFeature(feature)
    del feature, layer, dataset


def test_a_mixed_collection_is_drawn_as_its_parts_would_be(run, scene, tmp_path):
    mixed, separate = mixed_and_separate(scene, tmp_path / "mixed.gpkg")
    base = {"INPUT": oriented(scene, "north"), "DEM": str(scene.dem), "MAX_DISTANCE": REACH_M, "OUTPUT": "memory:"}
    base.update(LINES="memory:", NAME_FIELD="name")

    def shapes(layer):
        results, _ = run("maptopixel", {**base, "FEATURES": layer})
        found = [*results["OUTPUT"].getFeatures(), *results["LINES"].getFeatures()]
        return sorted((f["state"], f.geometry().asWkt(3)) for f in found)

    alone = [shape for layer in separate for shape in shapes(layer)]
    assert len(alone) >= 3 and shapes(mixed) == sorted(alone)


def test_a_mixed_collection_is_searched_for_with_all_its_parts(run, scene, tmp_path):
    mixed, separate = mixed_and_separate(scene, tmp_path / "mixed.gpkg")
    base = {"INPUT": oriented(scene, "north"), "DEM": str(scene.dem), "MAX_DISTANCE": REACH_M, "OUTPUT": "memory:"}

    def seen(layer):
        results, _ = run("whichphotos", {**base, "PLACES": layer})
        return [(f["vis_share"], f["in_frame"], f["dist_m"]) for f in results["OUTPUT"].getFeatures()]

    alone = [row for layer in separate for row in seen(layer)]
    ((share, framed, distance_m),) = seen(mixed)
    assert len(alone) == 3 and framed == 1
    assert min(row[0] for row in alone) < share < max(row[0] for row in alone)
    assert min(row[2] for row in alone) < distance_m < max(row[2] for row in alone)


# Names that repeat


def test_labels_go_to_the_photo_in_their_folder_and_to_none_without(listener):
    day1, day2 = "/d/day1/IMG_1.jpg", "/d/day2/IMG_1.jpg"
    point = (np.zeros((1, 2)),)
    features = [PixelFeature(name, "point", point) for name in ("day1/IMG_1.jpg", "IMG_1.jpg", "", "IMG_9.jpg")]
    whose, feedback = FeaturesByPhoto(features, [day1, day2]), listener()
    assert whose.of(day1) == [features[0], features[2]] and whose.of(day2) == [features[2]]
    whose.tell_unused(feedback)
    assert "IMG_1.jpg" in feedback.warnings[0] and "day1/IMG_0001.jpg" in feedback.warnings[0]
    assert "IMG_9.jpg" in feedback.warnings[1]


def test_hints_for_repeated_names_need_their_folders(run, scene, tmp_path):
    for folder in ("day1", "day2"):
        (tmp_path / folder).mkdir()
        shutil.copy(scene.folder / "north.jpg", tmp_path / folder / "north.jpg")
    x, y = scene.positions["north"]
    rows = [(f"Point({x} {y})", [str(tmp_path / folder / "north.jpg")]) for folder in ("day1", "day2")]
    points = memory_layer("Point", [("photo", TEXT)], rows)
    table = memory_layer(
        "Point", [("photo", TEXT), ("x", REAL), ("y", REAL)], [(f"Point({x} {y + 0.03})", ["north.jpg", 4, 5])]
    )
    with pytest.raises(QgsProcessingException, match="LANDMARKS: several photos have the name north.jpg"):
        run("orientphotos", {"INPUT": points, "DEM": str(scene.dem), "LANDMARKS": table, "OUTPUT": "memory:"})


def test_the_sun_and_the_moon_are_landmarks_without_a_map_point(run, scene, tmp_path):
    """The scene's photo has no time, which is told; another word in the field is refused before the first photo."""
    x, y = scene.positions["north"]
    points = memory_layer("Point", [("photo", TEXT)], [(f"Point({x} {y})", [str(scene.folder / "north.jpg")])])
    fields = [("photo", TEXT), ("x", REAL), ("y", REAL), ("body", TEXT)]
    plain = {"INPUT": points, "DEM": str(scene.dem), "OUTPUT": "memory:"}
    moon = memory_layer("Point", fields, [(None, ["north.jpg", 400, 20, "Moon"])])
    results, _ = run("orientphotos", {**plain, "LANDMARKS": moon})
    (row,) = results["OUTPUT"].getFeatures()
    assert row["status"] == "failed" and "does not record its time with a time zone" in row["message"]
    comet = memory_layer("Point", fields, [(None, ["north.jpg", 400, 20, "comet"])])
    with pytest.raises(QgsProcessingException, match="the field body says comet; it may say sun or moon"):
        run("orientphotos", {**plain, "LANDMARKS": comet})


# Copies: rotated, reduced


@pytest.fixture
def portrait(scene, tmp_path):
    """The north photo stored on its side, with the EXIF orientation that turns it upright."""
    image = pytest.importorskip("PIL.Image")
    with image.open(scene.folder / "north.jpg") as picture:
        turned, exif = picture.rotate(90, expand=True), picture.getexif()
    exif[0x0112] = 6
    path = tmp_path / "north.jpg"
    turned.save(path, quality=95, exif=exif)
    return str(path)


def test_pixels_of_a_portrait_drawn_in_qgis_are_turned_and_come_back(run, scene, portrait):
    """QGIS shows a JPEG as it is stored; without the rotation the place would be another one."""
    base = {"DEM": str(scene.dem), "MAX_DISTANCE": REACH_M}
    fields = [("photo", TEXT)]
    upright = memory_layer("Point", fields, [("Point(500.5 -450.5)", ["north.jpg"])])
    truth, _ = run("pixeltomap", {**base, "INPUT": oriented(scene, "north"), "PIXELS": upright, "OUTPUT": "memory:"})
    (truth,) = truth["OUTPUT"].getFeatures()

    turned = oriented(scene, "north", path=portrait)
    # Orientation 6 moves the stored (x, y) to (799 - y, x) on the upright picture of 800 x 600.
    drawn = memory_layer("Point", fields, [("Point(450.5 -299.5)", ["north.jpg"])])
    results, feedback = run("pixeltomap", {**base, "INPUT": turned, "PIXELS": drawn, "OUTPUT": "memory:"})
    (found,) = results["OUTPUT"].getFeatures()
    assert (found["x_px"], found["y_px"]) == (500, 450)
    assert found.geometry().distance(truth.geometry()) < 1 and any("rotated" in text for text in feedback.warnings)

    results, _ = run("maptopixel", {**base, "INPUT": turned, "FEATURES": results["OUTPUT"], "OUTPUT": "memory:"})
    (back,) = results["OUTPUT"].getFeatures()
    assert (back["x_px"], back["y_px"]) == pytest.approx((500, 450), abs=1)
    place = back.geometry().asPoint()
    assert (place.x(), place.y()) == pytest.approx((450.5, -299.5), abs=1)


def test_labels_of_a_reduced_copy_are_scaled_and_those_of_a_crop_refused(run, scene, tmp_path):
    def labels(width, height, x, y):
        shape = {"label": "hut", "shape_type": "point", "points": [[x, y]]}
        path = tmp_path / f"{width}x{height}.json"
        path.write_text(
            json.dumps({"shapes": [shape], "imagePath": "north.jpg", "imageWidth": width, "imageHeight": height})
        )
        return str(path)

    base = {"INPUT": oriented(scene, "north"), "DEM": str(scene.dem), "MAX_DISTANCE": REACH_M, "OUTPUT": "memory:"}
    places = []
    for size in ((800, 600, 400.0, 500.0), (400, 300, 200.0, 250.0)):
        results, feedback = run("pixeltomap", {**base, "PIXEL_FILE": labels(*size)})
        (found,) = results["OUTPUT"].getFeatures()
        places.append(found.geometry().asPoint())
        assert (size[0] == 400) == any("scaled to the photo" in text for text in feedback.warnings)
    assert places[0].distance(places[1]) < 0.1
    results, feedback = run("pixeltomap", {**base, "PIXEL_FILE": labels(800, 450, 400.0, 300.0)})
    assert results["COUNT"] == 0 and any("no reduced copy of this photo" in text for text in feedback.warnings)


def test_a_label_file_that_records_only_bytes_warns_of_another_copy(listener, tmp_path):
    path = tmp_path / "a.jpg"
    path.write_bytes(b"\xff\xd8\xff not a whole picture")
    camera = SimpleNamespace(width_px=800, height_px=600)
    photo = SimpleNamespace(path=str(path), name="a.jpg", view=SimpleNamespace(camera=camera))
    feature = PixelFeature("a.jpg", "point", (np.zeros((1, 2)),), file_bytes=path.stat().st_size)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("skyline_viewshed.algorithms.shared.pixel_input.orientation_of", lambda path: 1)
        feedback = listener()
        assert upright_features(photo, [feature], feedback) == [feature] and not feedback.warnings
        other = PixelFeature("a.jpg", "point", (np.zeros((1, 2)),), file_bytes=5)
        assert upright_features(photo, [other], feedback) == [other] and "another copy" in feedback.warnings[0]


# Heights, lenses


def test_heights_in_tables_may_have_units():
    assert metres_of("7513 ft") == pytest.approx(2290, abs=0.1) and metres_of(2290) == 2290 and metres_of("x") is None


def test_the_distortion_of_a_point_s_lens_reaches_its_camera(scene):
    layer = oriented(scene, "north", k1=-0.08, k2=0.01)
    (feature,) = layer.getFeatures()
    row = SimpleNamespace(feature=feature, name="n", longitude_deg=8.0, latitude_deg=46.5)
    camera = photo_point(row, pose_values(feature), PoseReading(level=True), None, (800, 600)).posed.camera
    assert (camera.k1, camera.k2) == (-0.08, 0.01)
