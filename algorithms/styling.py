"""How our layers look when QGIS loads them: styles from `styles/`, aliases, layer metadata."""

from __future__ import annotations

from pathlib import Path

from qgis.core import QgsProcessingLayerPostProcessorInterface

STYLES = Path(__file__).resolve().parent.parent / "styles"

_ALIVE = []
"""Post-processors in use. QGIS holds only a C++ pointer; without a Python reference they would be collected."""


class LayerStyler(QgsProcessingLayerPostProcessorInterface):
    """Dress one output layer after QGIS has loaded it; one instance per layer."""

    def __init__(self, style, specs, abstract):
        super().__init__()
        self.style, self.specs, self.abstract = style, specs, abstract

    def postProcessLayer(self, layer, context, feedback):
        """Apply style, aliases and metadata."""
        style = STYLES / f"{self.style}.qml"
        if style.exists():
            message, loaded = layer.loadNamedStyle(str(style))
            if not loaded:
                feedback.pushWarning(message)
        for spec in self.specs:
            index = layer.fields().lookupField(spec.name)
            if index >= 0:
                layer.setFieldAlias(index, spec.alias)
        metadata = layer.metadata()
        metadata.setTitle(layer.name())
        metadata.setAbstract(self.abstract)
        metadata.setKeywords({"gmd:topicCategory": ["elevation"], "skyline_viewshed": [self.style]})
        layer.setMetadata(metadata)
        layer.triggerRepaint()


def style_on_completion(context, identifier, style, name, specs=(), abstract=""):
    """Have the layer `identifier` dressed, if QGIS is going to load it."""
    if identifier is None or not context.willLoadLayerOnCompletion(identifier):
        return
    styler = LayerStyler(style, tuple(specs), abstract)
    _ALIVE.append(styler)
    del _ALIVE[:-50]
    details = context.layerToLoadOnCompletionDetails(identifier)
    details.setPostProcessor(styler)
