"""Map to pixels: features of the map in the picture, cut by what hides them."""

from __future__ import annotations

import numpy as np
import pytest
from map_layers import base, memory_layer, pixel_table, rows_of
from qgis.PyQt.QtCore import QVariant


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
