"""Computation of viewsheds photo by photo, shared by photos from one place, and never repeated for results on disk."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ...core.base.errors import Cancelled, PhotoError
from ...core.base.progress import checkpoint, subtask
from .feedback import FeedbackProgress, announce, warn
from .i18n import tr
from .outputs import make_folder_of, unused
from .photo_points import PhotoPoint
from .styling import dress_file
from .visibility import sector_of

PACKED_CELLS = 500_000_000
"""Viewsheds of more cells than this are held at two bits per cell."""

SHARED_CELLS = 100_000_000
"""Photos from one place are swept together in windows of up to this many cells, each of which then takes four bytes."""


@dataclass(frozen=True, eq=False)
class Job:
    """One photo's viewshed to be computed: its inputs, and the file in which it is stored (None: no file)."""

    point: PhotoPoint
    sector: Any
    path: str | None = None
    mark: str = ""


class Viewer:
    """Computes viewsheds, and stores each in a file of its own if a folder is given.

    A repeated run reuses the results of an earlier one, perhaps killed. A file made with other settings or another DEM
    is computed again.

    Parameters
    ----------
    dem : core.io.raster.Dem
    kind : str
        One of `algorithms.shared.parameters.SECTORS`.
    options : ViewshedOptions
    feedback : QgsProcessingFeedback
    folder : str
        Folder for one GeoTIFF per photo; empty if not requested.
    """

    def __init__(self, dem, kind, options, feedback, folder=""):
        self.dem, self.kind, self.options = dem, kind, options
        self.feedback, self.folder, self._stems, self._taken_stems = feedback, folder, {}, set()

    def each(self, points, share=(0.0, 1.0)):
        """Yield (point, viewshed), each complete before the next; photos from one place come together."""
        progress, done = subtask(FeedbackProgress(self.feedback), *share), 0
        for group in stations(points):
            part = subtask(progress, done / len(points), (done + len(group)) / len(points))
            jobs = [job for job in map(self._job, group) if job is not None]
            results = self._work(jobs, part)
            end = done + len(group)
            try:
                for job in jobs:
                    announce(self.feedback, job.point.name, done, len(points))
                    found = next(results)
                    done += 1
                    if found is not None:
                        yield job.point, found
            except Cancelled:
                self.feedback.pushWarning(
                    tr("Cancelled after {done} of {count} viewsheds.").format(done=done, count=len(points))
                )
                raise
            done = end
        checkpoint(progress, 1.0)

    def view(self, point, progress):
        """Return one viewshed, or warn and return None."""
        job = self._job(point)
        return None if job is None else next(self._work([job], progress))

    def file_of(self, point, folder):
        """Path of a photo's own GeoTIFF in a folder, which is created; the name is the same in each folder."""
        if point.key not in self._stems:
            self._stems[point.key] = file_stem(point, self._taken_stems)
            self._taken_stems.add(self._stems[point.key].lower())
        path = str(Path(folder) / f"{self._stems[point.key]}.tif")
        make_folder_of(path)
        return path

    def _job(self, point):
        from ...core.io.viewshed_raster import fingerprint

        sector = sector_of(point, self.kind, self.feedback)
        if sector is None:
            return None
        if point.observer is None:
            warn(self.feedback, point.name, tr("The point has no usable position."))
            return None
        if not self.folder:
            return Job(point, sector)
        path = self.file_of(point, self.folder)
        return Job(point, sector, path, fingerprint(self.dem, point.observer, sector, self.options))

    def _work(self, jobs, progress):
        """Yield the viewshed of each job at one place, or warn and yield None."""
        from ...core.io.viewshed_raster import stored_facts

        missing = [job for job in jobs if job.path is None or stored_facts(job.path, job.mark) is None]
        fresh, fault = self._sweep(missing, progress), None
        for job in jobs:
            found = None if job in missing else self._taken(job)
            if found is None and fault is None:
                try:
                    found = next(fresh if job in missing else self._sweep([job], progress))
                    self._keep(job, found)
                except PhotoError as error:  # if one place fails, it fails for all of its photos
                    fault = error
            if found is None:
                warn(self.feedback, job.point.name, fault.message)
            yield found

    def _sweep(self, jobs, progress):
        """Yield the viewsheds of jobs at one place, from one sweep if its window is not too large."""
        from ...core.viewshed.station import AnyOf, station_viewsheds
        from ...core.viewshed.viewshed import FRAME_MARGIN, sector_window, viewshed

        if len(jobs) > 1:
            place = jobs[0].point.observer
            reach_m = self.options.max_distance_m
            frame = self.dem.frame(place.longitude_deg, place.latitude_deg, FRAME_MARGIN * reach_m)
            sectors = tuple(job.sector for job in jobs)
            window = sector_window(frame, self.dem.shape, AnyOf(sectors), reach_m)
            if window.rows * window.cols <= SHARED_CELLS:
                yield from station_viewsheds(self.dem, place, sectors, self.options, progress)
                return
        for index, job in enumerate(jobs):
            part = subtask(progress, index / len(jobs), (index + 1) / len(jobs))
            yield viewshed(self.dem, job.point.observer, job.sector, self.options, part, sink_for)

    def _keep(self, job, found):
        from ...core.io.viewshed_raster import write_viewshed

        if job.path is not None:
            point = job.point
            facts = {"PHOTO": point.path or "", "HEADING": point.heading_deg, "SOFTWARE": "Skyline Viewshed"}
            write_viewshed(job.path, found, self.dem, job.mark, facts)
            dress_file(job.path, "seen")

    def _taken(self, job):
        """Result of an earlier run, or None if it cannot be read after all."""
        from ...core.base.terrain import eye_elevation_m
        from ...core.base.viewed import Viewshed
        from ...core.io.viewshed_raster import read_viewshed
        from ...core.viewshed.viewshed import FRAME_MARGIN

        stored = read_viewshed(job.path, self.dem, job.mark, sink_for)
        if stored is None:
            return None
        self.feedback.pushInfo(tr("{name}: taken from {path}").format(name=job.point.name, path=job.path))
        dress_file(job.path, "seen")
        place = job.point.observer
        frame = self.dem.frame(place.longitude_deg, place.latitude_deg, FRAME_MARGIN * self.options.max_distance_m)
        eye_m = eye_elevation_m(self.dem, frame, place)
        window, values = stored
        return Viewshed(window, values, frame, eye_m, self.options, job.sector)


def sink_for(window):
    """Return the object that holds the cells of a window: one byte each, or two bits if there are very many."""
    from ...core.base.viewed import ArraySink
    from ...core.viewshed.viewshed import PackedSink

    return (PackedSink if window.rows * window.cols > PACKED_CELLS else ArraySink)(window)


def stations(points):
    """Groups of points from exactly one place and height, in the order of their first point."""
    groups = {}
    for point in points:
        groups.setdefault(point.observer, []).append(point)
    return list(groups.values())


def file_stem(point, taken):
    """Name for a photo's own raster that is not in use yet."""
    stem = Path(point.path).stem if point.path else f"point_{point.source_id}"
    return unused(stem, taken)
