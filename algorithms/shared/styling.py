"""The appearance of our layers when QGIS loads them: styles from `styles/`, aliases and layer metadata."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path

from qgis.core import QgsProcessingLayerPostProcessorInterface, QgsVectorLayer

from .legends import translate_legend, translated_style
from .outputs import write_whole
from .stored_style import STYLES, style_document

RASTERS = (".tif", ".tiff")
MOST_ALIVE = 200
_ALIVE = []
"""Post-processors in use. QGIS holds only a C++ pointer; without a Python reference they would be collected."""


class LayerStyler(QgsProcessingLayerPostProcessorInterface):
    """Style one output layer after QGIS has loaded it; one instance per layer."""

    def __init__(self, style, specs, title, method):
        super().__init__()
        self.style, self.specs, self.title, self.method = style, specs, title, method
        self.facts, self.software = {}, ""

    def postProcessLayer(self, layer, context, feedback):
        """Apply style, aliases and metadata."""
        if isinstance(layer, QgsVectorLayer):
            self._dress(layer, feedback)
        elif (STYLES / f"{self.style}.qml").exists():
            message, loaded = layer.loadNamedStyle(str(STYLES / f"{self.style}.qml"))
            if not loaded:
                feedback.pushWarning(message)
            translate_legend(layer)
        layer.setMetadata(self._described(layer.metadata()))
        layer.triggerRepaint()

    def _dress(self, layer, feedback):
        """Apply the style that a file carries; layers in memory and tables of databases have none of their own."""
        ours = {spec.name: spec.alias for spec in self.specs}
        aliases = {
            field.name(): ours.get(field.name(), layer.attributeAlias(index))
            for index, field in enumerate(layer.fields())
        }
        loaded, message = layer.importNamedStyle(style_document(self.style, aliases))
        if not loaded:
            feedback.pushWarning(message)

    def _described(self, metadata):
        """Record in the layer's metadata how it was made: method, parameters, software."""
        parameters = "\n".join(f"{label}: {value}" for label, value in self.facts.items())
        metadata.setTitle(self.title)
        metadata.setAbstract(f"{self.method}\n{parameters}".strip())
        metadata.setKeywords({"gmd:topicCategory": ["elevation"], "skyline_viewshed": [self.style]})
        if self.software:
            metadata.setHistory([f"{datetime.now():%Y-%m-%d %H:%M} {self.method}, {self.software}"])
        return metadata


def style_on_completion(context, identifier, style, title, specs=(), method=""):
    """Have the layer `identifier` styled, if QGIS is going to load it; a raster gets its style beside it in any case.

    Parameters
    ----------
    style : str
        Name in `styles/`; without a file of that name the layer keeps QGIS's own style.
    title : str
        Title for the layer's metadata.
    specs : sequence of FieldSpec
        Fields whose aliases the attributes get.
    method : str
        Method that made the layer.
    """
    if identifier is not None and identifier.lower().endswith(RASTERS) and (STYLES / f"{style}.qml").exists():
        dress_file(identifier, style)
    if identifier is None or not context.willLoadLayerOnCompletion(identifier):
        return
    styler = LayerStyler(style, tuple(specs), title, method)
    _ALIVE.append(styler)
    del _ALIVE[:-MOST_ALIVE]
    details = context.layerToLoadOnCompletionDetails(identifier)
    details.setPostProcessor(styler)
    if hasattr(details, "groupName"):  # from QGIS 3.32 on
        details.groupName = "Skyline Viewshed"


def dress_file(path, style):
    """Write a style beside a raster in a folder; QGIS applies it whenever that file is loaded.

    An existing style, perhaps the user's own, is kept.

    Parameters
    ----------
    path : str
        Path of the raster.
    style : str
        Name in `styles/`.

    Raises
    ------
    OutputError
    """
    target = Path(path).with_suffix(".qml")
    if not target.exists():
        write_whole(target, translated_style((STYLES / f"{style}.qml").read_text(encoding="utf-8")))


def tell_provenance(context, facts, software):
    """Add the parameters of the finished run to the layers that QGIS will load."""
    for details in context.layersToLoadOnCompletion().values():
        if isinstance(details.postProcessor(), LayerStyler):
            details.postProcessor().facts, details.postProcessor().software = facts, software
