"""The HTML report of a run: gathered photo by photo, written at the end."""

from __future__ import annotations


class PhotoReport:
    """Cards of oriented photographs.

    Parameters
    ----------
    algorithm, parameters, context
        As in `processAlgorithm`; the report goes to the parameter `REPORT`, if that is wanted.
    options : OrientOptions
    """

    def __init__(self, algorithm, parameters, context, options):
        self.path = algorithm.parameterAsFileOutput(parameters, "REPORT", context)
        self.options = options

    def add(self, oriented):
        """Take a photo in."""

    def write(self, feedback):
        """Write the file; gives the outputs."""
        return {}
