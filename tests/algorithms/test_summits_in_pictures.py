"""Summits and places in pictures: labels, the panorama, and which photographs show them."""

from __future__ import annotations

import numpy as np
import pytest
from map_layers import REACH_M, base, memory_layer, pixel_table, rows_of
from qgis.PyQt.QtCore import QVariant


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
