"""Styles stored with the layer: in the GeoPackage itself, or as a QML file beside a format that has no place for them.

QGIS applies both whenever the layer is loaded, in any project and without this plugin.
"""

from __future__ import annotations

import sqlite3
from contextlib import closing
from pathlib import Path

from qgis.core import QgsProviderRegistry
from qgis.PyQt.QtXml import QDomDocument

from .i18n import marked, tr

STYLES = Path(__file__).resolve().parents[2] / "styles"

DATABASES = (".gpkg", ".sqlite", ".db")
"""Files in which QGIS keeps styles in a table of their own, `layer_styles`."""

UNDRESSED = (".csv", ".xlsx", ".ods", ".tsv", ".txt")
"""Tables for other programs, which have no looks."""

EMPTY = '<!DOCTYPE qgis PUBLIC "http://mrcc.com/qgis.dtd" "SYSTEM"><qgis version="3.22" styleCategories="Fields"/>'


def style_document(style, aliases):
    """Return the style of a layer as QML: legend and form in the user's language, aliases, and the user's own fields.

    Parameters
    ----------
    style : str
        Name in `styles/`; without a file of that name the document holds the aliases only.
    aliases : dict
        Alias of each field of the layer, by the field's name.

    Returns
    -------
    QDomDocument
    """
    path, document = STYLES / f"{style}.qml", QDomDocument()
    document.setContent(path.read_text(encoding="utf-8") if path.exists() else EMPTY)
    for tag, attribute in (("category", "label"), ("item", "label"), ("attributeEditorContainer", "name")):
        for element in _elements(document, tag):
            element.setAttribute(attribute, marked(element.attribute(attribute)))
    _set_aliases(document, aliases)
    _fit_form(document, list(aliases))
    return document


def store_style(identifier, style, fields):
    """Store a style in or beside the file of a layer; other layers stay as they are.

    Parameters
    ----------
    identifier : str
        Path of a vector file, with `|layername=` where it holds several layers.
    style : str
        Name in `styles/`.
    fields : QgsFields

    Returns
    -------
    bool
        False if there should be a style but it could not be written.
    """
    path = Path(identifier.split("|", 1)[0])
    suffix = path.suffix.lower()
    if suffix in UNDRESSED or not path.is_file():
        return True
    text = style_document(style, {field.name(): field.alias() for field in fields}).toString(1)
    if suffix not in DATABASES:
        beside = path.with_suffix(".qml")
        if not beside.exists():
            beside.write_text(text, encoding="utf-8")
        return True
    ogr = QgsProviderRegistry.instance().providerMetadata("ogr")
    layer = ogr.decodeUri(identifier).get("layerName") or path.stem
    _forget_style(path, layer)
    given = identifier, text, "", layer, tr("Style of the Skyline Viewshed plugin"), "", True
    try:
        stored = ogr.saveStyle(*given, "")
    except TypeError:  # where Python gets the error's text as a second result
        stored = ogr.saveStyle(*given)
    return bool(stored[0] if isinstance(stored, tuple) else stored)


def _forget_style(path, layer):
    """Remove the layer's older style of this name; QGIS would ask in a dialog whether to replace it."""
    with closing(sqlite3.connect(str(path))) as database, database:
        if database.execute("SELECT 1 FROM sqlite_master WHERE name = 'layer_styles'").fetchone():
            database.execute("DELETE FROM layer_styles WHERE f_table_name = ? AND styleName = ?", (layer, layer))


def _elements(document, tag):
    found = document.elementsByTagName(tag)
    return [found.at(index).toElement() for index in range(found.count())]


def _set_aliases(document, aliases):
    """Replace the document's list of aliases."""
    for old in _elements(document, "aliases"):
        old.parentNode().removeChild(old)
    listed = document.createElement("aliases")
    for index, (field, alias) in enumerate(aliases.items()):
        element = document.createElement("alias")
        for name, value in (("field", field), ("index", str(index)), ("name", alias)):
            element.setAttribute(name, value)
        listed.appendChild(element)
    document.documentElement().appendChild(listed)


def _fit_form(document, fields):
    """Drop form entries of fields that the layer lacks, and add a tab for those that only the layer has."""
    forms = _elements(document, "attributeEditorForm")
    shown = _elements(document, "attributeEditorField")
    if not forms or not shown:
        return
    names = {name: index for index, name in enumerate(fields)}
    for element in shown:
        if element.attribute("name") in names:
            element.setAttribute("index", str(names[element.attribute("name")]))
        else:
            element.parentNode().removeChild(element)
    listed = {element.attribute("name") for element in shown}
    others = [name for name in names if name not in listed and name.lower() not in ("fid", "ogc_fid")]
    if not others:
        return
    tab = _elements(document, "attributeEditorContainer")[-1].cloneNode(False).toElement()
    tab.setAttribute("name", tr("Other fields"))
    for name in others:
        element = shown[0].cloneNode(True).toElement()
        element.setAttribute("name", name)
        element.setAttribute("index", str(names[name]))
        tab.appendChild(element)
    forms[0].appendChild(tab)
