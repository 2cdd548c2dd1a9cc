"""What goes wrong in a slot or in the background becomes a sentence; the log has the details."""

from __future__ import annotations

import traceback
from functools import wraps

from qgis.core import Qgis, QgsMessageLog

from ...algorithms.shared.i18n import in_users_language, tr
from ...core.base.errors import SkylineViewshedError

LOG_TAG = "Skyline Viewshed"


def sentence_of(error):
    """Sentence for the user on an exception that is being handled; one that nobody foresaw is logged."""
    if isinstance(error, SkylineViewshedError):
        return in_users_language(error.message)
    QgsMessageLog.logMessage(traceback.format_exc(), LOG_TAG, Qgis.MessageLevel.Warning)
    return tr("An unexpected error occurred. Please report it and attach the log.")


def guarded(method):
    """Make a method safe to be called by Qt, where an exception would show a traceback: `self.say` gets a sentence."""

    @wraps(method)
    def slot(self, *args):
        try:
            return method(self, *args)
        except Exception as error:
            self.say(sentence_of(error))

    return slot
