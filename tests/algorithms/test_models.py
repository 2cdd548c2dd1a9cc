"""The models that ship with the provider, run: what each photo shows, and headings as the cameras recorded them."""

from __future__ import annotations

import numpy as np
import pytest
from qgis.core import QgsApplication, QgsFeature, QgsGeometry, QgsVectorLayer

pytestmark = pytest.mark.qgis

REACH_M = 5000.0


@pytest.fixture
def run_model(run, tmp_path):
    """Run a model with all its outputs in files; gives {last part of the output's name: path}."""

    def call(name, parameters):
        model = QgsApplication.processingRegistry().algorithmById(f"skylineviewshed:{name}")
        outputs = {}
        for item in model.destinationParameterDefinitions():
            suffix = {"rasterDestination": ".tif", "sink": ".gpkg"}.get(item.type(), ".html")
            outputs[item.name()] = str(tmp_path / f"{item.name().split(':')[-1]}{suffix}")
        results, feedback = run(name, {**parameters, **outputs})
        assert feedback.errors == []
        assert {key: results[key] for key in outputs} == outputs
        return {key.split(":")[-1]: path for key, path in outputs.items()}

    return call


def test_land_cover_in_view_counts_the_cells_of_each_class(run_model, scene, tmp_path):
    from osgeo import gdal
    from skyline_viewshed.core.io.raster import open_dem
    from skyline_viewshed.core.io.write_raster import write_raster

    dem = open_dem(str(scene.dem))
    classes = np.ones(dem.shape, np.uint8)
    classes[:, dem.shape[1] // 2 :] = 2
    write_raster(str(tmp_path / "cover.tif"), classes, dem)
    fields = "&".join(f"field={name}:double" for name in ("heading", "pitch", "roll", "hfov", "vfov"))
    points = QgsVectorLayer(f"Point?crs=EPSG:4326&{fields}", "oriented", "memory")
    pose, (longitude, latitude) = scene.truth["north"], scene.positions["north"]
    feature = QgsFeature(points.fields())
    feature.setGeometry(QgsGeometry.fromWkt(f"Point({longitude!r} {latitude!r})"))
    feature.setAttributes([pose.heading_deg, pose.pitch_deg, pose.roll_deg, scene.hfov_deg, 50.0])
    points.dataProvider().addFeature(feature)
    given = {"PHOTOS": points, "DEM": str(scene.dem), "LANDCOVER": str(tmp_path / "cover.tif"), "MAX_DISTANCE": REACH_M}
    found = run_model("viewshedlandcover", given)
    seen = gdal.Open(found["VIEWSHED"]).ReadAsArray() == 1
    layer = QgsVectorLayer(found["LAND_COVER"], "cover", "ogr")
    (row,) = layer.getFeatures()
    for number in (1, 2):
        count = row[f"class_{number}"] if layer.fields().lookupField(f"class_{number}") >= 0 else 0
        # QGIS counts through the polygon, whose single cells and corners it judges in its own way.
        assert count == pytest.approx((seen & (classes == number)).sum(), rel=0.02, abs=2), number
    assert seen.sum() > 100


def test_recorded_headings_give_wedges_without_solving(run_model, scene):
    given = {"FOLDER": str(scene.folder), "RECURSIVE": False, "DEM": str(scene.dem), "MAX_DISTANCE": REACH_M}
    found = run_model("compassviewsheds", given)
    photos = {row["filename"]: row for row in QgsVectorLayer(found["PHOTOS"], "photos", "ogr").getFeatures()}
    ground = {row["photo"]: row for row in QgsVectorLayer(found["POLYGONS"], "ground", "ogr").getFeatures()}
    assert set(photos) == {"north", "west"} and len(ground) == 2
    for name, pose in scene.truth.items():
        recorded = ground[str(scene.folder / f"{name}.jpg")]["heading"]
        assert recorded == pytest.approx((pose.heading_deg + 6) % 360, abs=0.01), "six degrees off, as the compass was"


def test_a_folder_of_geotagged_photos_becomes_viewsheds(run_model, scene):
    given = {"FOLDER": str(scene.folder), "RECURSIVE": False, "DEM": str(scene.dem), "MAX_DISTANCE": REACH_M}
    found = run_model("geotaggedphotos", given)
    headings = [row["heading"] for row in QgsVectorLayer(found["PHOTOS"], "photos", "ogr").getFeatures()]
    assert sorted(headings) == pytest.approx(sorted(pose.heading_deg for pose in scene.truth.values()), abs=0.5)
    assert QgsVectorLayer(found["POLYGONS"], "ground", "ogr").featureCount() == 2
