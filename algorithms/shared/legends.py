"""Legends of the styles in the user's language; the QML files are in English."""

from __future__ import annotations

import re
from xml.sax.saxutils import quoteattr

from qgis.core import QgsSingleBandPseudoColorRenderer

from .i18n import mark, marked

ENTRIES = (
    mark("visible"),
    mark("hidden"),
    mark("outside the picture"),
    mark("unknown"),
    mark("accepted: trust it"),
    mark("confirmed by a person"),
    mark("ambiguous: look at the report"),
    mark("rejected: no answer"),
    mark("failed: input at fault"),
    mark("not seen"),
    mark("1 photo"),
    mark("2 photos"),
    mark("3 photos"),
    mark("4 to 5 photos"),
    mark("6 to 10 photos"),
    mark("more than 10 photos"),
    mark("seen"),
    mark("hidden, 200 m or more too low"),
    mark("hidden, 50 m too low"),
    mark("hidden, 10 m too low"),
    mark("just hidden"),
    mark("just seen"),
    mark("seen, 10 m to spare"),
    mark("seen, 100 m or more to spare"),
    mark("1 (open sky)"),
)
"""The legend texts of the files in `styles/`; numbers and units need no translation."""

TABS = (mark("Answer"), mark("Match"), mark("Photo"), mark("Place"))
"""The tabs of their forms."""


def translate_legend(layer):
    """Translate a raster's legend into the user's language, after its style has been loaded."""
    renderer = layer.renderer()
    if isinstance(renderer, QgsSingleBandPseudoColorRenderer) and renderer.shader() is not None:
        ramp = renderer.shader().rasterShaderFunction()
        items = ramp.colorRampItemList()
        for item in items:
            item.label = marked(item.label)
        ramp.setColorRampItemList(items)


def translated_style(text):
    """Return the text of a style file with the legend of its colours in the user's language."""
    pattern = r'(?<=<item )([^>]*label=)"([^"]*)"'
    return re.sub(pattern, lambda found: found.group(1) + quoteattr(marked(found.group(2))), text)
