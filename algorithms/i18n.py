"""Translation of what the user reads. Every string stands as a literal inside `tr`, where the catalogue finds it."""

from __future__ import annotations

from qgis.PyQt.QtCore import QCoreApplication

CONTEXT = "SkylineViewshed"


def tr(text):
    """Give `text` in the user's language."""
    return QCoreApplication.translate(CONTEXT, text)
