"""The models that ship with the provider, run: what each photo shows, and headings as the cameras recorded them."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from qgis.core import (
    QgsApplication,
    QgsFeature,
    QgsGeometry,
    QgsProcessingContext,
    QgsProcessingModelAlgorithm,
    QgsProcessingParameterDefinition,
    QgsVectorLayer,
)

pytestmark = pytest.mark.qgis

REACH_M = 5000.0
ROOT = Path(__file__).resolve().parents[2]


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


def shipped(provider):
    """The models as the designer opens them, by name."""
    models = [it.create() for it in provider.algorithms() if hasattr(it, "childAlgorithms")]
    return {model.name(): model for model in models}


def faults_of(model):
    valid, faults = model.validate()
    children = [fault for child in model.childAlgorithms() for fault in model.validateChildAlgorithm(child)[1]]
    return [*([] if valid else faults), *children]


def test_every_shipped_model_is_valid_in_the_designer(provider):
    models = shipped(provider)
    assert {"geotaggedphotos", "compassviewsheds", "viewshedlandcover"} <= set(models)
    assert {name: faults_of(model) for name, model in models.items() if faults_of(model)} == {}


def test_a_model_saved_before_an_optional_parameter_existed_stays_valid(provider, tmp_path):
    optional, dropped = QgsProcessingParameterDefinition.Flag.FlagOptional, 0
    spare = {
        f"skylineviewshed:{it.name()}": [d.name() for d in it.parameterDefinitions() if d.flags() & optional]
        for it in provider.algorithms()
    }
    for name in shipped(provider):
        tree = ElementTree.parse(ROOT / "models" / f"{name}.model3")
        for child in tree.iterfind(".//Option[@name='params']/.."):
            values, step = child.find("Option[@name='params']"), child.find("Option[@name='alg_id']").get("value")
            for parameter in spare.get(step, ()):
                for value in values.findall(f"Option[@name='{parameter}']"):
                    values.remove(value)
                    dropped += 1
        tree.write(tmp_path / f"{name}.model3")
        model = QgsProcessingModelAlgorithm()
        assert model.fromFile(str(tmp_path / f"{name}.model3")) and faults_of(model) == [], name
    assert dropped > 30


MANDATORY = {
    "directedviewshed": "INPUT DEM SECTOR MAX_DISTANCE",
    "drapephoto": "INPUT DEM MAX_DISTANCE REFINE",
    "extractskyline": "INPUT METHOD",
    "horizonprofile": "INPUT DEM EYE_HEIGHT MAX_DISTANCE AZIMUTH_STEP",
    "importphotos": "FOLDER RECURSIVE",
    "labelpeaks": "INPUT DEM MAX_DISTANCE",
    "maptopixel": "FEATURES INPUT DEM MAX_DISTANCE",
    "measureoffsets": "INPUT",
    "orientphotos": "INPUT DEM METHOD COMPASS",
    "panorama": "INPUT DEM MAX_DISTANCE",
    "photocoverage": "INPUT DEM MAX_DISTANCE",
    "photoviewshed": "DEM MAX_DISTANCE SECTOR",
    "pixeltomap": "INPUT DEM MAX_DISTANCE",
    "positionphotos": "CLOCK",
    "simulatephotos": "INPUT DEM WIDTH HEIGHT FORMAT",
    "whichphotos": "PLACES INPUT DEM MAX_DISTANCE",
}
"""Parameters that a model must give a value. A new one would make every saved model with that step invalid."""


def test_no_algorithm_has_a_new_mandatory_parameter(provider):
    optional = QgsProcessingParameterDefinition.Flag.FlagOptional
    for algorithm in provider.algorithms():
        if algorithm.name() not in MANDATORY:
            continue
        needed = {it.name() for it in algorithm.parameterDefinitions() if not (it.flags() & optional)}
        needed -= {it.name() for it in algorithm.destinationParameterDefinitions()}
        assert needed == set(MANDATORY[algorithm.name()].split()), algorithm.name()


def test_an_optional_parameter_without_a_value_has_its_default(provider):
    context, seen = QgsProcessingContext(), 0
    advanced = QgsProcessingParameterDefinition.Flag.FlagAdvanced
    for algorithm in provider.algorithms():
        readers = {"number": "parameterAsDouble", "distance": "parameterAsDouble", "boolean": "parameterAsBoolean"}
        readers.update(enum="parameterAsEnum", band="parameterAsInt")
        for it in algorithm.parameterDefinitions():
            if not (it.flags() & advanced) or it.isDestination() or it.defaultValue() is None:
                continue
            several = it.type() == "enum" and it.allowMultiple()
            read = getattr(algorithm, "parameterAsEnums" if several else readers.get(it.type(), "parameterAsString"))
            for given in ({}, {it.name(): None}):
                assert read(given, it.name(), context) == it.defaultValue(), (algorithm.name(), it.name())
            seen += 1
    assert seen > 50
