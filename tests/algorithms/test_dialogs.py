"""The dialogs as a user meets them: opened through Processing, filled in and run, offscreen."""

import html
import re
from importlib import import_module
from pathlib import Path

import pytest
from qgis.core import QgsApplication, QgsProcessingParameterDefinition
from qgis.PyQt.QtCore import QUrl
from skyline_viewshed.processing_provider.provider import ALGORITHMS

PACKAGE = "skyline_viewshed"

OURS = [getattr(import_module(f"{PACKAGE}.algorithms.{module}"), name).ID for module, name in ALGORITHMS]
MODELS = sorted(path.stem for path in (Path(__file__).resolve().parents[2] / "models").glob("*.model3"))
IDS = [*OURS, *MODELS]


@pytest.fixture
def dialogs(provider, qgis_iface):
    """Typed models for the stub interface; without them opening a dialog ends the process on newer QGIS."""
    from qgis.gui import QgsBrowserGuiModel, QgsLayerTreeView

    model, tree = QgsBrowserGuiModel(), QgsLayerTreeView()
    qgis_iface.browserModel = lambda: model
    qgis_iface.layerTreeView = lambda: tree
    return qgis_iface


@pytest.mark.parametrize("name", IDS)
def test_every_dialog_opens(dialogs, name):
    import processing

    dialog = processing.createAlgorithmDialog(f"skylineviewshed:{name}", {})
    assert dialog is not None
    dialog.show()
    dialog.close()


def test_a_run_from_the_dialog(dialogs, scene, tmp_path):
    import processing
    from qgis.PyQt.QtTest import QTest

    parameters = {"FOLDER": str(scene.folder), "OUTPUT": str(tmp_path / "photos.gpkg")}
    dialog = processing.createAlgorithmDialog("skylineviewshed:importphotos", parameters)
    dialog.show()
    dialog.runButton().click()
    for _ in range(100):
        QTest.qWait(50)
        if dialog.results():
            break
    assert dialog.results()["COUNT"] == 2
    dialog.close()


def test_a_table_of_lenses_is_taken_from_the_dialog(dialogs, scene, tmp_path):
    import processing
    from osgeo import ogr
    from qgis.PyQt.QtTest import QTest
    from skyline_viewshed.core.io.photo import read_metadata

    (tmp_path / "lenses.csv").write_text(
        f"f35,k1\n{read_metadata(str(scene.folder / 'north.jpg')).focal_length_35mm},-0.01\n", encoding="utf-8"
    )
    given = {"FOLDER": scene.folder, "DEM": scene.dem, "LENS_TABLE": tmp_path / "lenses.csv"}
    files = {"OUTPUT": "o.gpkg", "POLYGONS": "g.gpkg", "VIEWSHED": "v.tif", "REPORT": "r.html"}
    given.update({name: tmp_path / file for name, file in files.items()})
    texts = {name: str(value) for name, value in given.items()}
    paper = 1  # which is faster
    dialog = processing.createAlgorithmDialog(
        "skylineviewshed:photoviewshed", {**texts, "METHOD": paper, "MAX_DISTANCE": 2000}
    )
    dialog.show()
    dialog.runButton().click()
    for _ in range(4000):
        QTest.qWait(50)
        if dialog.results():
            break
    assert dialog.results()["COUNT"] == 2
    dialog.close()
    source = ogr.Open(str(tmp_path / "o.gpkg"))
    assert [row["k1"] for row in source.GetLayer(0)] == [-0.01, -0.01]


def test_every_algorithm_and_model_explains_itself(algorithm):
    silent = []
    for name in IDS:
        it = algorithm(name)
        texts = {"help": it.shortHelpString(), "name": it.displayName(), "group": it.group()}
        if name in OURS:
            texts["description"] = it.shortDescription()
            texts["link"] = it.helpUrl() if it.helpUrl().endswith(name) else ""
            texts["tags"] = " ".join(it.tags()) if len(it.tags()) >= 4 else ""
            texts.update({parameter.name(): parameter.description() for parameter in it.parameterDefinitions()})
        silent += [(name, text) for text in texts if not texts[text].strip()]
        silent += [(name, "icon")] if it.icon().isNull() else []
    assert silent == []


def test_few_inputs_are_visible_at_first(algorithm):
    hidden = QgsProcessingParameterDefinition.Flag.FlagAdvanced
    visible = {
        it.name(): [
            parameter.name()
            for parameter in it.parameterDefinitions()
            if not parameter.isDestination() and not parameter.flags() & hidden
        ]
        for it in [algorithm(name) for name in OURS]  # which own their parameters
    }
    assert all(visible.values())
    assert {name: names for name, names in visible.items() if len(names) > 7} == {}


def test_lengths_are_metres_and_parameter_names_are_capitals(algorithm):
    from qgis.core import QgsUnitTypes

    ours = [algorithm(name) for name in OURS]  # which own their parameters
    parameters = [(it.name(), parameter) for it in ours for parameter in it.parameterDefinitions()]
    names = [(name, parameter.name()) for name, parameter in parameters]
    assert [entry for entry in names if entry[1] != entry[1].upper() or not entry[1].isascii()] == []
    lengths = [(name, parameter) for name, parameter in parameters if parameter.type() == "distance"]
    assert len(lengths) > 15
    assert [
        (name, length.name())
        for name, length in lengths
        if length.defaultUnit() != QgsUnitTypes.DistanceUnit.DistanceMeters or "(m)" not in length.description()
    ] == []


def test_icons_are_our_own_one_per_algorithm(provider):
    paths = [Path(algorithm.svgIconPath()) for algorithm in provider.algorithms() if algorithm.groupId() != "models"]
    assert len(paths) == len(set(paths)) >= 8
    for path in [*paths, Path(provider.svgIconPath())]:
        assert path.exists() and path.read_text().startswith("<svg")


def test_outputs_are_dressed_when_they_are_loaded(run, scene):
    from qgis.core import QgsProcessingContext, QgsProject

    context = QgsProcessingContext()
    context.setProject(QgsProject.instance())
    alg = QgsApplication.processingRegistry().algorithmById("skylineviewshed:importphotos").create()
    from qgis.core import QgsProcessingFeedback

    feedback = QgsProcessingFeedback()
    destination = "memory:photos"
    from qgis.core import QgsProcessingOutputLayerDefinition

    sink = QgsProcessingOutputLayerDefinition(destination, context.project())
    results, done = alg.run({"FOLDER": str(scene.folder), "OUTPUT": sink}, context, feedback)
    assert done
    identifier = results["OUTPUT"]
    details = context.layerToLoadOnCompletionDetails(identifier)
    layer = context.getMapLayer(identifier)
    assert details.postProcessor() is not None
    details.postProcessor().postProcessLayer(layer, context, feedback)
    fields = layer.fields()
    assert fields.at(fields.lookupField("hfov")).alias() == "Horizontal field of view (°)"
    assert layer.editorWidgetSetup(fields.lookupField("photo")).type() == "ExternalResource"
    assert "<img" in layer.mapTipTemplate()
    assert "wedge_buffer" in layer.renderer().symbol().symbolLayer(0).properties()["geometryModifier"]
    assert str(scene.folder) in layer.metadata().abstract() and "QGIS" in layer.metadata().history()[0]


@pytest.mark.parametrize("preview", [False, True], ids=["no preview", "preview"])
@pytest.mark.parametrize("style", ["oriented", "photos", "polygons"])
def test_a_hostile_file_name_stays_text_in_the_map_tip(qgis_app, style, preview):
    from qgis.core import QgsExpression, QgsExpressionContext, QgsExpressionContextUtils, QgsFeature, QgsVectorLayer
    from skyline_viewshed.algorithms.shared.styling import STYLES

    fields = "&".join(f"field={name}:string" for name in ("photo", "status", "message"))
    reals = "&".join(f"field={name}:double" for name in ("heading", "direction", "area_m2", "farthest_m"))
    kind = "Polygon" if style == "polygons" else "Point"
    own = "&field=preview:string" if preview else ""
    layer = QgsVectorLayer(f"{kind}?crs=EPSG:4326&{fields}&{reals}{own}", "layer", "memory")
    layer.loadNamedStyle(str(STYLES / f"{style}.qml"))
    feature = QgsFeature(layer.fields())
    name = 'it\'s "50 %" & #1? <img src=x onerror=alert(1)>.jpg'
    values = [f"/photos/{name}", "failed", "<script>no</script>", 12.0, 12.0, 1e6, 1e3]
    feature.setAttributes([*values, f"/seen/{name}"] if preview else values)
    context = QgsExpressionContext(QgsExpressionContextUtils.globalProjectLayerScopes(layer))
    context.setFeature(feature)
    shown = QgsExpression.replaceExpressionText(layer.mapTipTemplate(), context)
    assert "[%" not in shown and "<script" not in shown
    assert shown.count("<img") == (0 if style == "polygons" else 1)
    assert html.unescape(shown).count(name) == 1
    if style != "polygons":
        source = html.unescape(re.search(r'src="([^"]*)"', shown).group(1))
        assert QUrl(source).toLocalFile().lstrip("/") == f"{'seen' if preview else 'photos'}/{name}"
