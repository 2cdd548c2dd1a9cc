"""Pixels to map: points, lines and areas of a picture with their errors, on the simulated scene of known poses."""

from __future__ import annotations

import csv
import json

import numpy as np
import pytest
from map_layers import base, memory_layer, pixel_table, rows_of
from qgis.core import NULL, QgsProcessingException
from qgis.PyQt.QtCore import QVariant


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


def test_the_table_survives_a_csv_round_trip(run, scene, oriented, tmp_path):
    drawn, target = tmp_path / "drawn.csv", tmp_path / "placed.csv"
    drawn.write_text("photo,x,y,label\nnorth.jpg,400,500,a\n")
    run("pixeltomap", base(oriented, scene, PIXEL_FILE=str(drawn), OUTPUT=str(target)))
    with open(target, encoding="utf-8") as file:
        (row,) = csv.DictReader(file)
    assert row["status"] == "ground" and float(row["dist_m"]) > 0
