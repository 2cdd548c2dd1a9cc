"""Build models/*.model3 from scratch, so that nobody has to edit their XML by hand. Run by `make models`."""

from __future__ import annotations

import sys
from pathlib import Path

from qgis.core import (
    QgsApplication,
    QgsProcessing,
    QgsProcessingModelAlgorithm,
    QgsProcessingModelChildAlgorithm,
    QgsProcessingModelChildParameterSource,
    QgsProcessingModelOutput,
    QgsProcessingModelParameter,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterDistance,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterField,
    QgsProcessingParameterFile,
    QgsProcessingParameterRasterLayer,
    QgsProcessingParameterVectorLayer,
    QgsUnitTypes,
)
from qgis.PyQt.QtCore import QPointF, QSizeF

ROOT = Path(__file__).resolve().parent.parent
SOURCE = QgsProcessingModelChildParameterSource


def main():
    """Write all models."""
    application = QgsApplication([], False)
    application.initQgis()
    sys.path.insert(0, str(Path(QgsApplication.pkgDataPath()) / "python" / "plugins"))
    from processing.core.Processing import Processing

    Processing.initialize()
    from skyline_viewshed import classFactory

    plugin = classFactory(None)
    plugin.initProcessing()
    (ROOT / "models").mkdir(exist_ok=True)
    for model in (geotagged_photos(), compass_viewsheds(), viewshed_landcover(), orient_again()):
        faults = [fault for child in model.childAlgorithms() for fault in model.validateChildAlgorithm(child)[1]]
        if faults:
            raise SystemExit(f"{model.name()}: {faults}")
        path = ROOT / "models" / f"{model.name()}.model3"
        model.toFile(str(path))
        print(path.relative_to(ROOT))
    plugin.unload()


def geotagged_photos():
    """Build the model of QGIS's own import, orientation and viewshed."""
    text = "Reads geotagged JPEG photographs with QGIS's own importer, orients them, and computes the ground they show."
    model = new_model("geotaggedphotos", text)
    add_input(model, folder(), 0)
    add_input(model, QgsProcessingParameterBoolean("RECURSIVE", "Include subfolders", False), 1)
    add_input(model, dem(), 2)
    add_input(model, distance(), 3)
    add_step(model, "import", "native:importphotos", {"FOLDER": given("FOLDER"), "RECURSIVE": given("RECURSIVE")}, 0)
    add_step(
        model,
        "orient",
        "skylineviewshed:orientphotos",
        {"INPUT": result("import", "OUTPUT"), "PHOTO_FIELD": fixed("photo"), "DEM": given("DEM")},
        1,
        {"PHOTOS": ("OUTPUT", "Oriented photos"), "REPORT": ("REPORT", "Report")},
    )
    add_step(
        model,
        "viewshed",
        "skylineviewshed:directedviewshed",
        {"INPUT": result("orient", "OUTPUT"), "DEM": given("DEM"), "MAX_DISTANCE": given("MAX_DISTANCE")},
        2,
        {"VIEWSHED": ("OUTPUT", "Viewshed"), "POLYGONS": ("POLYGONS", "Ground in view")},
    )
    return model


def compass_viewsheds():
    """Build the model that uses the headings recorded by the cameras, without orientation."""
    text = (
        "Uses the headings that the cameras recorded, and computes the ground within the horizontal field of "
        "view. Phone compasses are often wrong by 5 to 10 degrees or more."
    )
    model = new_model("compassviewsheds", text)
    add_input(model, folder(), 0)
    add_input(model, QgsProcessingParameterBoolean("RECURSIVE", "Include subfolders", False), 1)
    add_input(model, dem(), 2)
    add_input(model, distance(), 3)
    add_step(
        model,
        "import",
        "skylineviewshed:importphotos",
        {"FOLDER": given("FOLDER"), "RECURSIVE": given("RECURSIVE")},
        0,
        {"PHOTOS": ("OUTPUT", "Photos")},
    )
    add_step(
        model,
        "viewshed",
        "skylineviewshed:directedviewshed",
        {
            "INPUT": result("import", "OUTPUT"),
            "DEM": given("DEM"),
            "HEADING_FIELD": fixed("direction"),
            "HFOV_FIELD": fixed("hfov"),
            "SECTOR": fixed(1),
            "MAX_DISTANCE": given("MAX_DISTANCE"),
        },
        1,
        {"VIEWSHED": ("OUTPUT", "Viewshed"), "POLYGONS": ("POLYGONS", "Ground in view")},
    )
    return model


def viewshed_landcover():
    """Build the model that counts the cells of each land-cover class in the ground that each photo shows."""
    text = (
        "Counts the cells of each class of a land-cover raster within the ground that each oriented photograph shows."
    )
    model = new_model("viewshedlandcover", text)
    points = QgsProcessingParameterFeatureSource(
        "PHOTOS", "Oriented photos", [QgsProcessing.SourceType.TypeVectorPoint]
    )
    add_input(model, points, 0)
    add_input(model, dem(), 1)
    add_input(model, QgsProcessingParameterRasterLayer("LANDCOVER", "Land-cover raster"), 2)
    add_input(model, distance(), 3)
    add_step(
        model,
        "viewshed",
        "skylineviewshed:directedviewshed",
        {"INPUT": given("PHOTOS"), "DEM": given("DEM"), "MAX_DISTANCE": given("MAX_DISTANCE")},
        0,
        {"VIEWSHED": ("OUTPUT", "Viewshed")},
    )
    add_step(
        model,
        "histogram",
        "native:zonalhistogram",
        {
            "INPUT_RASTER": given("LANDCOVER"),
            "RASTER_BAND": fixed(1),
            "INPUT_VECTOR": result("viewshed", "POLYGONS"),
            "COLUMN_PREFIX": fixed("class_"),
        },
        1,
        {"LAND_COVER": ("OUTPUT", "Land cover in view")},
    )
    return model


def orient_again():
    """Build the model that orients photographs again, updates their layer and renews the viewsheds."""
    text = (
        "Orients some photographs of a layer again, with an approximate heading or landmarks if you give them, "
        "updates the layer, and computes anew the ground that its photographs show."
    )
    model = new_model("orientagain", text)
    points = [QgsProcessing.SourceType.TypeVectorPoint]
    add_input(model, QgsProcessingParameterFeatureSource("AGAIN", "Photos to orient again", points), 0)
    add_input(model, QgsProcessingParameterVectorLayer("LAYER", "Layer to update", points), 1)
    add_input(model, dem(), 2)
    near = QgsProcessingParameterField(
        "NEAR",
        "Field with an approximate heading (°)",
        None,
        "AGAIN",
        QgsProcessingParameterField.DataType.Numeric,
        optional=True,
    )
    add_input(model, near, 3)
    add_input(model, QgsProcessingParameterFeatureSource("LANDMARKS", "Landmarks", points, optional=True), 4)
    add_input(model, distance(), 5)
    add_step(
        model,
        "orient",
        "skylineviewshed:orientphotos",
        {
            "INPUT": given("AGAIN"),
            "DEM": given("DEM"),
            "HEADING_HINT_FIELD": given("NEAR"),
            "LANDMARKS": given("LANDMARKS"),
        },
        0,
        {"REPORT": ("REPORT", "Report")},
    )
    add_step(
        model,
        "merge",
        "skylineviewshed:mergeoriented",
        {"INPUT": given("LAYER"), "SOLVED": result("orient", "OUTPUT")},
        1,
    )
    add_step(
        model,
        "viewshed",
        "skylineviewshed:directedviewshed",
        {"INPUT": result("merge", "UPDATED"), "DEM": given("DEM"), "MAX_DISTANCE": given("MAX_DISTANCE")},
        2,
        {"VIEWSHED": ("OUTPUT", "Viewshed"), "POLYGONS": ("POLYGONS", "Ground in view")},
    )
    return model


def new_model(name, text):
    """Create an empty model with its help."""
    model = QgsProcessingModelAlgorithm(name, "Models", "models")
    model.setHelpContent({"ALG_DESC": text, "ALG_CREATOR": "The Skyline Viewshed team"})
    return model


def folder():
    """Define the folder of photographs."""
    return QgsProcessingParameterFile("FOLDER", "Folder of photographs", QgsProcessingParameterFile.Behavior.Folder)


def dem():
    """Define the elevation model."""
    return QgsProcessingParameterRasterLayer("DEM", "Elevation model (DEM)")


def distance():
    """Define the range of the viewshed."""
    parameter = QgsProcessingParameterDistance("MAX_DISTANCE", "Maximum distance (m)", 30000.0, None, False, 1.0)
    parameter.setDefaultUnit(QgsUnitTypes.DistanceUnit.DistanceMeters)
    return parameter


def add_input(model, definition, place):
    """Add a parameter of the model."""
    component = QgsProcessingModelParameter(definition.name())
    component.setPosition(QPointF(120, 80 + 90 * place))
    component.setSize(QSizeF(200, 30))
    model.addModelParameter(definition, component)


def add_step(model, step, algorithm, parameters, place, outputs=None):
    """Add a child algorithm; `outputs` maps the model's output names to the child's and a title."""
    child = QgsProcessingModelChildAlgorithm(algorithm)
    child.setChildId(step)
    child.setDescription(child.algorithm().displayName())
    child.setPosition(QPointF(420 + 60 * place, 100 + 110 * place))
    child.setSize(QSizeF(240, 30))
    defaults = {
        definition.name(): fixed(definition.defaultValue())
        for definition in child.algorithm().parameterDefinitions()
        if not definition.isDestination() and definition.defaultValue() is not None
    }
    for name, source in {**defaults, **parameters}.items():
        child.addParameterSources(name, [source])
    results = {}
    for name, (output, title) in (outputs or {}).items():
        result_of_model = QgsProcessingModelOutput(name, title)
        result_of_model.setChildId(step)
        result_of_model.setChildOutputName(output)
        result_of_model.setPosition(QPointF(760, 80 + 70 * len(results) + 150 * place))
        result_of_model.setSize(QSizeF(200, 30))
        results[name] = result_of_model
    child.setModelOutputs(results)
    model.addChildAlgorithm(child)


def given(name):
    """Take the value from an input of the model."""
    return SOURCE.fromModelParameter(name)


def result(step, output):
    """Take the value from the output of an earlier step."""
    return SOURCE.fromChildOutput(step, output)


def fixed(value):
    """Use a constant as the value."""
    return SOURCE.fromStaticValue(value)


if __name__ == "__main__":
    main()
