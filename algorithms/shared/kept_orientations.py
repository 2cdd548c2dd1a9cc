"""The folder in which a run stores each photo's orientation, so that a repeated run does not compute it again."""

from __future__ import annotations

from pathlib import Path

from . import parameters as shared
from .i18n import tr
from .outputs import unused, write_whole


def orientations_out(name="ORIENTATIONS"):
    """Folder for one file per photo."""
    text = tr(
        "One file per photo (about 2 MB), for this plugin only. A repeated run reuses each orientation for "
        "which nothing has changed (photo, DEM, settings, version of the plugin), so a run that was stopped "
        "continues where it stopped."
    )
    return shared.advanced(shared.folder_out(name, tr("Folder for finished orientations"), text))


class KeptOrientations:
    """Orients photographs, or reads the result of an earlier run from the folder.

    Failures are not stored: they are quick to find, and their cause may lie outside the photo, such as a missing
    package.

    Parameters
    ----------
    folder : str
        Empty if not requested.
    feedback : QgsProcessingFeedback
    """

    def __init__(self, folder, feedback):
        self.folder, self.feedback, self._taken = folder, feedback, set()

    def orient(self, request, dem, options, cache, progress):
        """Return the `OrientedPhoto` of a request; see `core.batch.orient_request`."""
        from ...core.batch import orient_request
        from ...core.io.orientation_file import orientation_mark, packed, unpacked

        if not self.folder:
            return orient_request(request, dem, options, cache, progress)
        path = Path(self.folder) / f"{unused(Path(request.path).stem, self._taken)}.npz"
        mark = orientation_mark(request, dem, options)
        oriented = unpacked(path, mark)
        if oriented is not None:
            self.feedback.pushInfo(tr("{name}: taken from {path}").format(name=Path(request.path).name, path=path))
            return oriented
        oriented = orient_request(request, dem, options, cache, progress)
        if oriented.orientation.status != "failed":
            write_whole(path, packed(oriented, mark))
        return oriented
