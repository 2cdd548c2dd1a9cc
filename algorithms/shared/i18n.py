"""Translation of what the user reads. Every string stands as a literal inside `tr`, where the catalogue finds it."""

from __future__ import annotations

from qgis.PyQt.QtCore import QCoreApplication

CONTEXT = "SkylineViewshed"


def tr(text):
    """Give `text`, a literal, in the user's language."""
    return marked(text)


def mark(text):
    """Put a literal into the catalogue that `marked` translates later, when it is shown."""
    return text


def marked(text):
    """Give a text that `mark` put into the catalogue in the user's language."""
    return QCoreApplication.translate(CONTEXT, text)
