"""Drape photo: the ground gets the colours of the picture, its sky none."""

from __future__ import annotations

import numpy as np
import pytest
from map_layers import REACH_M, base, memory_layer
from qgis.core import QgsPointXY, QgsProcessingException, QgsRasterLayer
from qgis.PyQt.QtCore import QVariant


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
