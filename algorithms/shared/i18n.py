"""Translation of the text that the user reads. Every string is a literal inside `tr`, where the catalogue finds it."""

from __future__ import annotations

from qgis.PyQt.QtCore import QCoreApplication

from ...core.base.messages import Message

CONTEXT = "SkylineViewshed"


def tr(text):
    """Return `text`, a literal, in the user's language."""
    return marked(text)


def mark(text):
    """Put a literal into the catalogue; `marked` translates it later, when it is shown."""
    return text


def marked(text):
    """Return a text that `mark` put into the catalogue in the user's language."""
    return QCoreApplication.translate(CONTEXT, text)


def in_users_language(text):
    """Return a `Message` in the user's language, with the messages among its facts; return any other text unchanged."""
    if not isinstance(text, Message):
        return text
    facts = {name: in_users_language(fact) for name, fact in text.facts.items()}
    return marked(text.template).format(**facts)
