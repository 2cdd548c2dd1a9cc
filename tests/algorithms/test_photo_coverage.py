"""Photo coverage: counts, blind spots and the fewest photographs; and cancelling of the algorithms of maps."""

from __future__ import annotations

import numpy as np
import pytest
from map_layers import base, memory_layer, pixel_table, rows_of
from qgis.core import NULL, QgsProcessingException, QgsRasterLayer
from qgis.PyQt.QtCore import QVariant


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
