"""The seven algorithms between photo and map, on the simulated scene with its known poses."""

from __future__ import annotations

import csv
import json
from types import SimpleNamespace

import numpy as np
import pytest
from qgis.core import (
    NULL,
    QgsFeature,
    QgsField,
    QgsGeometry,
    QgsPointXY,
    QgsProcessingException,
    QgsRasterLayer,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QVariant

REACH_M = 12_000.0


def memory_layer(kind, fields, rows, crs="EPSG:4326"):
    """Layer from rows of (WKT or None, attributes); fields are (name, QVariant type)."""
    layer = QgsVectorLayer(f"{kind}?crs={crs}" if crs else kind, "layer", "memory")
    layer.dataProvider().addAttributes([QgsField(name, type_) for name, type_ in fields])
    layer.updateFields()
    for wkt, attributes in rows:
        feature = QgsFeature(layer.fields())
        if wkt:
            feature.setGeometry(QgsGeometry.fromWkt(wkt))
        feature.setAttributes(attributes)
        layer.dataProvider().addFeature(feature)
    return layer


@pytest.fixture(scope="session")
def oriented(qgis_app, scene):
    """The scene's photographs with their true poses, as orientphotos would write them."""
    real, text = QVariant.Double, QVariant.String
    fields = [("photo", text), ("heading", real), ("pitch", real), ("roll", real), ("hfov", real), ("vfov", real)]
    fields += [("eye_z", real), ("heading_lo", real), ("heading_hi", real), ("status", text)]
    rows = []
    for name, pose in scene.truth.items():
        lon, lat = scene.positions[name]
        values = [str(scene.folder / f"{name}.jpg"), pose.heading_deg, pose.pitch_deg, pose.roll_deg, scene.hfov_deg]
        values += [None, None, pose.heading_deg - 0.3, pose.heading_deg + 0.3, "accepted"]
        rows.append((f"Point({lon!r} {lat!r})", values))
    return memory_layer("Point", fields, rows)


@pytest.fixture(scope="session")
def known(scene):
    """The north photo as the core has it: view and terrain."""
    from skyline_viewshed.core.base.camera import Camera, focal_of_fov_px
    from skyline_viewshed.core.base.posed import PosedPhoto
    from skyline_viewshed.core.base.terrain import Observer
    from skyline_viewshed.core.base.view import open_view
    from skyline_viewshed.core.io.raster import open_dem

    dem = open_dem(str(scene.dem))
    camera = Camera(800, 600, focal_of_fov_px(800, scene.hfov_deg))
    view = open_view(dem, PosedPhoto(camera, scene.truth["north"], Observer(*scene.positions["north"], 1.7)), REACH_M)
    return SimpleNamespace(dem=dem, view=view, camera=camera)


def base(oriented, scene, **more):
    return {"INPUT": oriented, "DEM": str(scene.dem), "MAX_DISTANCE": REACH_M, **more}


def rows_of(layer):
    return [dict(zip(feature.fields().names(), feature.attributes())) for feature in layer.getFeatures()]


def pixel_table(rows):
    return memory_layer("NoGeometry", [("photo", QVariant.String), ("x", QVariant.Double), ("y", QVariant.Double),
                                       ("label", QVariant.String)], [(None, row) for row in rows], crs="")  # fmt: skip


def test_pixels_become_places_with_their_errors(run, scene, oriented, known):
    table = pixel_table([["north.jpg", 400, 500, "slope"], ["north.jpg", 400, 2, "sky"], ["WEST.JPG", 300, 450, "w"]])
    results, feedback = run("pixeltomap", base(oriented, scene, PIXELS=table, OUTPUT="memory:", ELLIPSES="memory:"))
    slope, sky, west = sorted(rows_of(results["OUTPUT"]), key=lambda row: ["slope", "sky", "w"].index(row["label"]))
    from skyline_viewshed.core.mapping.monoplot import place_pixels

    truth = place_pixels(known.dem, known.view, np.array([400.0]), np.array([500.0]))
    assert slope["status"] == "ground" and slope["dist_m"] == pytest.approx(truth.hits.distance_m[0], rel=1e-3)
    assert slope["z"] == pytest.approx(truth.hits.elevation_m[0], abs=0.5)
    assert slope["err_major"] >= slope["err_minor"] > 0 and slope["near_m"] < slope["dist_m"] < slope["far_m"]
    assert sky["status"] == "sky" and sky["dist_m"] == NULL and sky["err_major"] == NULL
    assert west["status"] == "ground"
    assert results["COUNT"] == 3 and results["SKY_COUNT"] == 1
    features = {f["label"]: f for f in results["OUTPUT"].getFeatures()}
    assert features["sky"].geometry().isNull() and features["slope"].geometry().constGet().is3D()
    ellipses = {f["label"]: f for f in results["ELLIPSES"].getFeatures()}
    assert set(ellipses) == {"slope", "w"}
    area = np.pi * slope["err_major"] * slope["err_minor"]
    assert ellipses["slope"].geometry().area() == pytest.approx(area, rel=0.02)
    assert not feedback.warnings


def test_a_labelling_tools_line_and_area_become_map_features(run, scene, oriented, tmp_path):
    shapes = [
        {"label": "trail", "points": [[200, 480], [420, 520], [600, 470]], "shape_type": "linestrip"},
        {"label": "glacier", "points": [[300, 430], [420, 430], [420, 520], [300, 520]], "shape_type": "polygon"},
        {"label": "summit to sky", "points": [[400, 500], [400, 5]], "shape_type": "line"},
        {"label": "cloud", "points": [[10, 2], [60, 2], [60, 12], [10, 12]], "shape_type": "polygon"},
    ]
    path = tmp_path / "north.json"
    path.write_text(json.dumps({"shapes": shapes, "imagePath": "north.jpg"}))
    results, _ = run("pixeltomap", base(oriented, scene, PIXEL_FILE=str(path), OUTPUT="memory:", LINES="memory:",
                                        POLYGONS="memory:"))  # fmt: skip
    lines = {f["label"]: f for f in results["LINES"].getFeatures()}
    areas = {f["label"]: f for f in results["POLYGONS"].getFeatures()}
    assert lines["trail"]["status"] == "ground" and lines["trail"].geometry().length() > 30
    assert lines["summit to sky"]["status"] == "partly ground" and 0 < lines["summit to sky"]["ground"] < 1
    assert areas["glacier"].geometry().area() > 100 and areas["glacier"]["err_med"] > 0
    assert areas["cloud"]["status"] == "sky" and areas["cloud"].geometry().isNull()
    assert results["OUTPUT"].featureCount() == 0


def test_pixels_outside_the_picture_are_not_placed(run, scene, oriented):
    """The picture has 800 x 600 pixels; what was drawn on another copy of it is refused, and the run says so."""
    table = pixel_table([["north.jpg", x, y, f"{x}/{y}"] for x, y in ((400, 500), (1600, 500), (400, 640), (-20, 500))])
    results, feedback = run("pixeltomap", base(oriented, scene, PIXELS=table, OUTPUT="memory:", ELLIPSES="memory:"))
    rows = rows_of(results["OUTPUT"])
    assert [row["status"] for row in rows] == ["ground", "outside", "outside", "outside"]
    assert [row["x_px"] for row in rows] == [400, 1600, 400, -20] and {row["dist_m"] for row in rows[1:]} == {NULL}
    assert [f.geometry().isNull() for f in results["OUTPUT"].getFeatures()] == [False, True, True, True]
    assert results["SKY_COUNT"] == 3 and results["ELLIPSES"].featureCount() == 1
    (told,) = feedback.warnings
    assert "3 of 4 image features" in told and "800 x 600" in told


def test_lines_and_areas_end_at_the_edge_of_the_picture(run, scene, oriented, tmp_path):
    shapes = [
        {"label": "inside", "points": [[500, 520], [790, 520]], "shape_type": "line"},
        {"label": "across", "points": [[500, 520], [1100, 520]], "shape_type": "line"},
        {"label": "beyond", "points": [[900, 520], [1000, 560], [950, 580]], "shape_type": "polygon"},
    ]
    path = tmp_path / "north.json"
    path.write_text(json.dumps({"shapes": shapes, "imagePath": "north.jpg"}))
    results, feedback = run("pixeltomap", base(oriented, scene, PIXEL_FILE=str(path), LINES="memory:",
                                               POLYGONS="memory:"))  # fmt: skip
    lines = {f["label"]: f for f in results["LINES"].getFeatures()}
    (area,) = results["POLYGONS"].getFeatures()
    assert lines["inside"]["status"] == "ground" and lines["across"]["status"] == "partly ground"
    assert lines["across"].geometry().length() == pytest.approx(lines["inside"].geometry().length(), rel=0.1)
    assert area["status"] == "outside" and area.geometry().isNull() and area["err_max"] == NULL
    (told,) = feedback.warnings
    assert "2 of 3 image features" in told


def test_features_of_unknown_photos_and_no_features_are_told(run, scene, oriented, refusal):
    table = pixel_table([["other.jpg", 1, 2, ""], ["north.jpg", 400, 500, ""]])
    _, feedback = run("pixeltomap", base(oriented, scene, PIXELS=table, OUTPUT="memory:"))
    assert any("other.jpg" in warning for warning in feedback.warnings)
    assert "Give image features" in refusal("pixeltomap", base(oriented, scene, OUTPUT="memory:"))
    empty = pixel_table([])
    with pytest.raises(QgsProcessingException, match="empty"):
        run("pixeltomap", base(oriented, scene, PIXELS=empty, OUTPUT="memory:"))


def test_the_map_comes_back_to_the_pixels_it_came_from(run, scene, oriented):
    drawn = [["north.jpg", x, y, f"{x}/{y}"] for x in (150, 400, 650) for y in (430, 500, 570)]
    placed, _ = run("pixeltomap", base(oriented, scene, PIXELS=pixel_table(drawn), OUTPUT="memory:"))
    back, _ = run(
        "maptopixel",
        base(oriented, scene, FEATURES=placed["OUTPUT"], NAME_FIELD="label", OUTPUT="memory:", LINES="memory:"),
    )
    found = [row for row in rows_of(back["OUTPUT"]) if row["photo"].endswith("north.jpg")]
    assert len(found) == 9
    for row in found:
        x, y = map(float, row["name"].split("/"))
        assert row["state"] == "visible"
        assert np.hypot(row["x_px"] - x, row["y_px"] - y) < 0.5
    feature = next(back["OUTPUT"].getFeatures())
    point = feature.geometry().asPoint()
    assert (point.x(), point.y()) == pytest.approx((feature["x_px"] + 0.5, -feature["y_px"] - 0.5))


def test_lines_and_areas_are_cut_by_what_hides_them_and_drawn(run, scene, oriented, known, tmp_path):
    east, north = known.view.frame.to_local(*known.dem.pixel_of(*scene.positions["north"]))
    angle = np.radians(scene.truth["north"].heading_deg)
    from skyline_viewshed.core.io.crs import to_wgs84

    def lonlat(distance, aside=0.0):
        e = distance * np.sin(angle) + aside * np.cos(angle)
        n = distance * np.cos(angle) - aside * np.sin(angle)
        x0, dx, _, y0, _, dy = known.dem.geotransform
        col, row = known.view.frame.to_pixel(e, n)
        return to_wgs84(known.dem.crs_wkt, x0 + dx * (col + 0.5), y0 + dy * (row + 0.5))

    places = [lonlat(d) for d in (100, 4000, 9000)]
    line = "LineString(" + ", ".join(f"{float(lon)!r} {float(lat)!r}" for lon, lat in places) + ")"
    trail = memory_layer("LineString", [("name", QVariant.String)], [(line, ["trail"])])
    folder = tmp_path / "pictures"
    results, _ = run("maptopixel", base(oriented, scene, FEATURES=trail, NAME_FIELD="name", OUTPUT="memory:",
                                        LINES="memory:", PICTURES=str(folder)))  # fmt: skip
    rows = [row for row in rows_of(results["LINES"]) if row["photo"].endswith("north.jpg")]
    states = {row["state"] for row in rows}
    assert "visible" in states and "hidden" in states
    assert rows[0]["from_share"] == 0 and rows[-1]["to_share"] == 1
    assert 0 < rows[0]["vis_share"] < 1
    assert sorted(path.name for path in folder.iterdir()) == ["north.png", "north.svg", "west.png", "west.svg"]


def test_draping_colours_what_the_photo_sees_as_the_photo_has_it(run, scene, oriented, known, tmp_path):
    from skyline_viewshed.core.io.photo import read_photo
    from skyline_viewshed.core.mapping.monoplot import place_pixels

    out, gsd = tmp_path / "draped.tif", tmp_path / "gsd.tif"
    results, _ = run("drapephoto", base(oriented, scene, OUTPUT=str(out), GSD=str(gsd)))
    layer = QgsRasterLayer(str(out))
    assert layer.isValid() and layer.bandCount() == 4 and results["COUNT"] == 2 and results["CELLS"] > 500
    assert layer.dataProvider().colorInterpretation(4) == 6  # alpha
    pixels = read_photo(scene.folder / "north.jpg").pixels
    x, y = np.array([200.0, 400.0, 600.0]), np.array([360.0, 350.0, 360.0])
    placed = place_pixels(known.dem, known.view, x, y)
    close = 0
    for k in range(3):
        x0, dx, _, y0, _, dy = known.dem.geotransform
        col, row = known.view.frame.to_pixel(placed.hits.east_m[k], placed.hits.north_m[k])
        point = QgsPointXY(x0 + dx * (np.rint(col) + 0.5), y0 + dy * (np.rint(row) + 0.5))
        values = [layer.dataProvider().sample(point, band)[0] for band in (1, 2, 3, 4)]
        if values[3] == 255:
            near = pixels[int(y[k]) - 25 : int(y[k]) + 25, int(x[k]) - 25 : int(x[k]) + 25].reshape(-1, 3)
            close += np.abs(near.mean(axis=0) - values[:3]).max() < 40
    assert close >= 2
    distance = QgsRasterLayer(str(gsd))
    statistics = distance.dataProvider().bandStatistics(1)
    assert 0 < statistics.minimumValue < statistics.maximumValue < REACH_M / known.camera.focal_px * 1.2
    finer, _ = run("drapephoto", base(oriented, scene, OUTPUT=str(tmp_path / "fine.tif"), REFINE=2))
    assert finer["CELLS"] == pytest.approx(4 * results["CELLS"], rel=0.05)


def test_the_sky_of_a_picture_is_not_draped(run, scene, oriented, known, tmp_path):
    """A camera that is said to look lower than it did puts its ground into the picture's sky."""
    fields = [(name, QVariant.Double) for name in ("heading", "pitch", "roll", "hfov")]
    pose, (lon, lat) = scene.truth["north"], scene.positions["north"]
    counts, told = [], []
    for lower in (0.0, 18.0):
        values = [str(scene.folder / "north.jpg"), pose.heading_deg, pose.pitch_deg - lower, pose.roll_deg]
        row = (f"Point({lon!r} {lat!r})", [*values, scene.hfov_deg])
        layer = memory_layer("Point", [("photo", QVariant.String), *fields], [row])
        out = tmp_path / f"{lower}.tif"
        results, feedback = run("drapephoto", base(layer, scene, OUTPUT=str(out), MIN_DISTANCE=300.0))
        counts.append(results["CELLS"])
        told.append([warning for warning in feedback.warnings if "shows sky" in warning])
    assert counts[0] > 3 * counts[1] > 0
    assert not told[0] and len(told[1]) == 1


def test_nothing_to_drape_is_said_and_leaves_no_file(run, scene, oriented, tmp_path):
    up = memory_layer("Point", [("photo", QVariant.String), ("heading", QVariant.Double), ("pitch", QVariant.Double),
                                ("hfov", QVariant.Double)],
                      [("Point({} {})".format(*scene.positions["north"]), [str(scene.folder / "north.jpg"), 0.0, 80.0,
                                                                           30.0])])  # fmt: skip
    out = tmp_path / "none.tif"
    with pytest.raises(QgsProcessingException, match="nothing to drape"):
        run("drapephoto", base(up, scene, OUTPUT=str(out)))
    assert not out.exists() and list(tmp_path.iterdir()) == []


def test_summits_are_found_in_the_dem_and_labelled(run, scene, oriented, tmp_path):
    folder = tmp_path / "labelled"
    results, _ = run("labelpeaks", base(oriented, scene, MIN_PROMINENCE=100.0, OUTPUT="memory:", PICTURES=str(folder)))
    rows = rows_of(results["OUTPUT"])
    visible = [row for row in rows if row["state"] == "visible"]
    assert visible and results["VISIBLE_COUNT"] == len(visible) and results["COUNT"] == len(rows)
    assert all(-0.5 <= row["x_px"] <= 799.5 and -0.5 <= row["y_px"] <= 599.5 for row in rows)
    assert all(row["prominence"] >= 100 for row in rows)
    svg = (folder / "north.svg").read_text()
    assert svg.count("<text") >= 1 and (folder / "north.png").read_bytes()[:4] == b"\x89PNG"


def test_named_summits_keep_their_names_and_are_set_on_the_dems_top(run, scene, oriented):
    found, _ = run("labelpeaks", base(oriented, scene, MIN_PROMINENCE=100.0, OUTPUT="memory:"))
    first = next(f for f in found["OUTPUT"].getFeatures() if f["state"] == "visible")
    point = first.geometry().asPoint()
    fields = [("name", QVariant.String), ("ele", QVariant.String)]
    rows = [(f"Point({point.x() + 120} {point.y()})", ["Piz & Test", f"{first['height_m'] + 5:.0f}"]),
            (f"Point({point.x()} {point.y()})", [None, "1"])]  # fmt: skip
    peaks = memory_layer("Point", fields, rows, crs="")
    peaks.setCrs(found["OUTPUT"].crs())
    results, _ = run("labelpeaks", base(oriented, scene, PEAKS=peaks, OUTPUT="memory:"))
    row = next(r for r in rows_of(results["OUTPUT"]) if r["photo"] == first["photo"])
    assert row["name"] == "Piz & Test" and row["state"] == "visible"
    assert row["moved_m"] == pytest.approx(120, abs=1) and row["dem_m"] == pytest.approx(first["dem_m"])
    assert row["x_px"] == pytest.approx(first["x_px"], abs=1)


def test_places_find_their_photos_best_first(run, scene, oriented):
    drawn = pixel_table([["north.jpg", 400, 560, "near"], ["north.jpg", 400, 480, "far"], ["west.jpg", 400, 560, "w"]])
    placed, _ = run("pixeltomap", base(oriented, scene, PIXELS=drawn, OUTPUT="memory:"))
    results, _ = run(
        "whichphotos", base(oriented, scene, PLACES=placed["OUTPUT"], NAME_FIELD="label", OUTPUT="memory:")
    )
    rows = rows_of(results["OUTPUT"])
    north = {row["place"]: row for row in rows if row["photo"].endswith("north.jpg")}
    assert {"near", "far"} <= set(north)
    assert (north["near"]["x_px"], north["near"]["y_px"]) == pytest.approx((400, 560), abs=0.6)
    assert north["near"]["px_per_m"] > north["far"]["px_per_m"] > 0
    assert any(row["place"] == "w" and row["photo"].endswith("west.jpg") and row["rank"] == 1 for row in rows)
    ids = {f.id() for f in oriented.getFeatures()}
    assert {row["photo_id"] for row in rows} <= ids
    assert results["UNSEEN"] == 0 and results["COUNT"] == len(rows)


def test_a_search_for_summits_finds_the_photos_in_which_they_are_labelled(run, scene, oriented, known):
    """Published 250 m behind its top in the DEM, as Lhotse is, a summit is hidden at its published place."""
    found, _ = run("labelpeaks", base(oriented, scene, MIN_PROMINENCE=100.0, OUTPUT="memory:"))
    frame, rows = known.view.frame, []
    x0, dx, _, y0, _, dy = known.dem.geotransform
    north = [f for f in found["OUTPUT"].getFeatures() if f["photo"].endswith("north.jpg") and f["state"] == "visible"]
    for number, summit in enumerate(north):
        point = summit.geometry().asPoint()
        east, up = (float(v) for v in frame.to_local((point.x() - x0) / dx - 0.5, (point.y() - y0) / dy - 0.5))
        away = 1 + 250 / np.hypot(east, up)
        col, row = frame.to_pixel(east * away, up * away)
        place = f"Point({x0 + dx * (col + 0.5)} {y0 + dy * (row + 0.5)})"
        rows.append((place, [str(number), summit["height_m"] + 10]))
    peaks = memory_layer("Point", [("name", QVariant.String), ("ele", QVariant.Double)], rows, crs="")
    peaks.setCrs(found["OUTPUT"].crs())
    shown = {}
    for snap in (500.0, 0.0):
        given = {"NAME_FIELD": "name", "SNAP": snap, "OUTPUT": "memory:"}
        labelled, _ = run("labelpeaks", base(oriented, scene, **{**given, "PEAKS": peaks}))
        searched, _ = run("whichphotos", base(oriented, scene, **{**given, "PLACES": peaks}))
        labels = {(row["photo"], row["name"]) for row in rows_of(labelled["OUTPUT"]) if row["state"] == "visible"}
        drawn, _ = run("maptopixel", base(oriented, scene, **{**given, "FEATURES": peaks}))
        shown[snap] = {(row["photo"], row["place"]) for row in rows_of(searched["OUTPUT"])}
        assert shown[snap] <= labels
        drawn = [row for row in rows_of(drawn["OUTPUT"]) if row["state"] == "visible"]
        assert {(row["photo"], row["name"]) for row in drawn} == shown[snap]
        if snap:
            places = {(row["photo"], row["name"]): (row["x_px"], row["y_px"]) for row in rows_of(labelled["OUTPUT"])}
            for row in drawn:
                assert (row["x_px"], row["y_px"]) == pytest.approx(places[row["photo"], row["name"]], abs=1e-6)
    assert shown[500.0] > shown[0.0]


@pytest.mark.parametrize(
    "name, layer, called", [("maptopixel", "FEATURES", "name"), ("whichphotos", "PLACES", "place")]
)
def test_heights_with_units_are_read_and_those_that_the_dem_contradicts_are_said(
    run, scene, oriented, name, layer, called
):
    found, _ = run("labelpeaks", base(oriented, scene, MIN_PROMINENCE=100.0, OUTPUT="memory:"))
    north = [f for f in found["OUTPUT"].getFeatures() if f["photo"].endswith("north.jpg") and f["state"] == "visible"]
    summit, place = north[0], north[0].geometry().asWkt(9).replace("PointZ", "Point Z")
    feet, metres = f"{summit['height_m'] / 0.3048:.1f} ft", f"{summit['height_m']:.1f} m"
    rows = [(place, [words, words]) for words in (metres, feet, "18941")]
    peaks = memory_layer("PointZ", [("name", QVariant.String), ("ele", QVariant.String)], rows, crs="")
    peaks.setCrs(found["OUTPUT"].crs())
    results, feedback = run(name, base(oriented, scene, **{layer: peaks, "NAME_FIELD": "name", "OUTPUT": "memory:"}))
    seen = {row[called]: row for row in rows_of(results["OUTPUT"]) if row["photo"].endswith("north.jpg")}
    at = {words: (row["x_px"], row["y_px"]) for words, row in seen.items()}
    assert at[feet] == pytest.approx(at[metres], abs=0.1)
    assert at["18941"] == pytest.approx((summit["x_px"], summit["y_px"]), abs=20)
    (told,) = [warning for warning in feedback.warnings if "contradicts the DEM" in warning]
    assert told.startswith("18941: ") and told.endswith("enlarge SNAP.")


def test_areas_are_asked_for_the_share_that_shows(run, scene, oriented):
    lon, lat = scene.positions["north"]
    box = f"Polygon(({lon} {lat}, {lon + 0.05} {lat}, {lon + 0.05} {lat + 0.05}, {lon} {lat + 0.05}, {lon} {lat}))"
    areas = memory_layer("Polygon", [("name", QVariant.String)], [(box, ["valley"])])
    results, _ = run("whichphotos", base(oriented, scene, PLACES=areas, OUTPUT="memory:"))
    (row, *_) = [r for r in rows_of(results["OUTPUT"]) if r["photo"].endswith("north.jpg")]
    assert 0 < row["vis_share"] < row["in_frame"] < 1
    none, _ = run("whichphotos", base(oriented, scene, PLACES=areas, MIN_SHARE=99.0, OUTPUT="memory:"))
    assert none["COUNT"] == 0 and none["UNSEEN"] == 1


def test_the_panorama_is_drawn_with_names_and_photos(run, scene, oriented, tmp_path):
    folder = tmp_path / "panoramas"
    results, _ = run("panorama", {"INPUT": oriented, "DEM": str(scene.dem), "MAX_DISTANCE": REACH_M,
                                  "PHOTOS": oriented, "AZIMUTH_STEP": 0.5, "SCALE": 6.0, "MIN_PROMINENCE": 200.0,
                                  "FOLDER": str(folder), "OUTPUT": "memory:"})  # fmt: skip
    assert results["COUNT"] == 2 and len(list(folder.glob("*.svg"))) == len(list(folder.glob("*.png"))) == 2
    text = "".join(path.read_text() for path in folder.glob("*.svg"))
    assert ">north<" in text and ">west<" in text and " m<" in text
    rows = rows_of(results["OUTPUT"])
    assert {row["kind"] for row in rows} == {"horizon", "ridge"}
    assert all(0 <= row["azim_from"] < 360 for row in rows)


def test_coverage_counts_blind_spots_and_the_fewest_photos(run, scene, oriented, tmp_path):
    out, gsd = tmp_path / "count.tif", tmp_path / "gsd.tif"
    twice = memory_layer("Point", [(f.name(), f.type()) for f in oriented.fields()],
                         [(f.geometry().asWkt(9), f.attributes()) for f in oriented.getFeatures()] * 2)  # fmt: skip
    results, _ = run("photocoverage", base(twice, scene, OUTPUT=str(out), GSD=str(gsd), TABLE="memory:"))
    assert results["COUNT"] == 4 and results["FEWEST"] == 2 and results["PROVEN"] is True
    assert 0 < results["SEEN_SHARE"] < 1 and results["BLIND_CELLS"] > 0
    layer = QgsRasterLayer(str(out))
    assert layer.dataProvider().bandStatistics(1).maximumValue in (2, 4)
    rows = rows_of(results["TABLE"])
    assert [row["pick"] for row in rows] == [1, 2, NULL, NULL]
    assert rows[1]["so_far"] == pytest.approx(results["SEEN_SHARE"])
    assert sum(row["adds"] for row in rows[:2]) == pytest.approx(
        results["SEEN_SHARE"] * results["BLIND_CELLS"] / (1 - results["SEEN_SHARE"]), rel=1e-6
    )


def test_coverage_of_an_area_only_counts_the_area(run, scene, oriented, known, tmp_path):
    lon, lat = scene.positions["north"]
    ring = [(0, 0), (0.04, 0), (0.04, 0.03), (0.0, 0.03)]
    wkt = "Polygon((" + ", ".join(f"{lon + a} {lat + b}" for a, b in [*ring, ring[0]]) + "))"
    area = memory_layer("Polygon", [("name", QVariant.String)], [(wkt, ["a"])])
    results, _ = run("photocoverage", base(oriented, scene, AREA=area, OUTPUT=str(tmp_path / "count.tif"),
                                           TABLE="memory:"))  # fmt: skip
    expected = 0.04 * 111_320 * np.cos(np.radians(lat)) * 0.03 * 111_320 / 75**2
    cells = results["BLIND_CELLS"] / (1 - results["SEEN_SHARE"])
    assert cells == pytest.approx(expected, rel=0.03)


def test_photos_without_heading_or_off_the_dem_are_warned_of(run, scene, oriented):
    fields = [("photo", QVariant.String), ("heading", QVariant.Double), ("hfov", QVariant.Double)]
    lon, lat = scene.positions["north"]
    photo = str(scene.folder / "north.jpg")
    layer = memory_layer("Point", fields, [(f"Point({lon} {lat})", [photo, None, 50.0]),
                                           ("Point(0.5 0.5)", [photo, 10.0, 50.0]),
                                           (f"Point({lon} {lat})", [photo, 10.0, None])])  # fmt: skip
    table = pixel_table([["north.jpg", 400, 500, ""]])
    results, feedback = run("pixeltomap", base(layer, scene, PIXELS=table, OUTPUT="memory:"))
    assert results["COUNT"] == 0
    assert len([w for w in feedback.warnings if "orient it first" in w]) == 2
    assert any("outside the DEM" in w for w in feedback.warnings)


def test_points_without_photos_cover_ground_and_say_what_their_pixels_are(run, scene, tmp_path):
    lon, lat = scene.positions["north"]
    pose = scene.truth["north"]
    fields = [("heading", QVariant.Double), ("pitch", QVariant.Double), ("hfov", QVariant.Double),
              ("vfov", QVariant.Double)]  # fmt: skip
    layer = memory_layer("Point", fields, [(f"Point({lon} {lat})", [pose.heading_deg, pose.pitch_deg, 60.0, 45.0])])
    results, feedback = run("photocoverage", base(layer, scene, OUTPUT=str(tmp_path / "count.tif")))
    assert 0 < results["SEEN_SHARE"] < 1
    assert not feedback.warnings
    _, feedback = run("whichphotos", base(layer, scene, PLACES=layer, OUTPUT="memory:"))
    assert any("4000 px" in warning for warning in feedback.warnings)
    table = pixel_table([["", 400, 500, ""]])
    placed, feedback = run("pixeltomap", base(layer, scene, PIXELS=table, OUTPUT="memory:"))
    assert placed["COUNT"] == 0 and any("size is unknown" in warning for warning in feedback.warnings)


@pytest.mark.parametrize("name", ["pixeltomap", "drapephoto", "photocoverage"])
def test_cancelling_leaves_nothing(run, scene, oriented, listener, tmp_path, name):
    out = tmp_path / "out.tif"
    more = {"PIXELS": pixel_table([["north.jpg", 400, 500, ""]])} if name == "pixeltomap" else {}
    with pytest.raises(QgsProcessingException, match="ancel"):
        run(name, base(oriented, scene, OUTPUT="memory:" if more else str(out), **more), listener(cancel_at=1))
    assert list(tmp_path.iterdir()) == []


def test_the_table_survives_a_csv_round_trip(run, scene, oriented, tmp_path):
    drawn, target = tmp_path / "drawn.csv", tmp_path / "placed.csv"
    drawn.write_text("photo,x,y,label\nnorth.jpg,400,500,a\n")
    run("pixeltomap", base(oriented, scene, PIXEL_FILE=str(drawn), OUTPUT=str(target)))
    with open(target, encoding="utf-8") as file:
        (row,) = csv.DictReader(file)
    assert row["status"] == "ground" and float(row["dist_m"]) > 0
