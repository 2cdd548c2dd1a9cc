"""The folder in which a run stores each photo's orientation, so that a repeated run does not compute it again."""

from __future__ import annotations

from pathlib import Path

from ...core.io.whole_file import unused_name
from . import parameters as shared
from .i18n import tr
from .outputs import write_whole


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

    `is_missing` is called for all requests of a run in order, which names their files, and then `orient`.

    Failures are not stored: they are quick to find, and their cause may lie outside the photo, such as a missing
    package.

    Parameters
    ----------
    folder : str
        Empty if not requested.
    feedback : QgsProcessingFeedback
    known : dict of int to OrientedPhoto
        Answers that this run has already, by the number of the request; they are used up.
    """

    def __init__(self, folder, feedback, known):
        self.folder, self.feedback, self.known, self._taken = folder, feedback, known, set()
        self._files: dict = {}

    def is_missing(self, number, request, job):
        """Tell whether a request must be oriented: neither this run nor a file of an earlier one has its result."""
        from ...core.io.orientation_file import holds, orientation_mark

        if self.folder:
            path = Path(self.folder) / f"{unused_name(Path(request.path).stem, self._taken)}.npz"
            mark = orientation_mark(request, job.dem, job.options)
            self._files[number] = path, mark, holds(path, mark)
        return number not in self.known and not (self.folder and self._files[number][2])

    def orient(self, number, request, team, progress):
        """Return the `OrientedPhoto` of a request as it is known, from its file, or else the next of the team."""
        from ...core.io.orientation_file import packed, unpacked

        path, mark, held = self._files.pop(number, (None, "", False))
        if number in self.known:
            oriented = self.known.pop(number)
        elif held:
            oriented = unpacked(path, mark)
            if oriented is not None:
                text = tr("{name}: taken from {path}").format(name=Path(request.path).name, path=path)
                self.feedback.pushInfo(text)
                return oriented
            oriented = team.job()((request, None), progress)  # its tree is whole, its arrays are not
        else:
            oriented = oriented_by(team, progress)
        if path is not None and oriented.orientation.status != "failed":
            write_whole(path, packed(oriented, mark))
        return oriented


def oriented_by(team, progress):
    """Next result of a team; raises what the computation raised, with the text of its traceback as `details`."""
    outcome = team.take(progress)
    if outcome.error is not None and outcome.details:
        outcome.error.details = outcome.details
    return outcome.result()
