"""Computation of viewsheds photo by photo, shared by photos from one place, and never repeated for results on disk."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ...core.base.errors import Cancelled, PhotoError
from ...core.base.progress import checkpoint, subtask
from ...core.io.whole_file import unused_name
from .feedback import FeedbackProgress, announce, warn
from .i18n import tr
from .outputs import make_folder_of
from .photo_points import PhotoPoint
from .styling import dress_file
from .visibility import sector_of
from .workers import team_for


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
        self.dem, self.kind, self.options, self._team = dem, kind, options, None
        self.feedback, self.folder, self._stems, self._taken_stems = feedback, folder, {}, set()

    def each(self, points, share=(0.0, 1.0), workers=1):
        """Yield (point, viewshed), each complete before the next; photos from one place come together.

        `workers` is the number of processes; see `core.workers.interpreter.worker_count`.
        """
        from ...core.many import ViewshedJob

        progress, done = subtask(FeedbackProgress(self.feedback), *share), 0
        groups = [[job for job in map(self._job, group) if job is not None] for group in stations(points)]
        tasks = [(jobs[0].point.observer, sectors_of(jobs)) for jobs in map(self._missing, groups) if jobs]
        workers = 1 if self._is_large(tasks) else workers
        with team_for(ViewshedJob(self.dem, self.options), workers, len(tasks), self.feedback) as team:
            if not team.alone:
                self._team = team
                team.begin(tasks, progress)
            for group, jobs in zip(stations(points), groups):
                part = subtask(progress, done / len(points), (done + len(group)) / len(points))
                yield from self._of_group(jobs, done, len(points), part)
                done += len(group)
        checkpoint(progress, 1.0)

    def _of_group(self, jobs, done, count, progress):
        results, finished = self._work(jobs, progress), 0
        try:
            for job in jobs:
                announce(self.feedback, job.point.name, done + finished, count)
                found = next(results)
                finished += 1
                if found is not None:
                    yield job.point, found
        except Cancelled:
            text = tr("Cancelled after {done} of {count} viewsheds.")
            self.feedback.pushWarning(text.format(done=done + finished, count=count))
            raise

    def _is_large(self, tasks):
        """Tell whether a viewshed has so many cells that handing it from process to process would not pay."""
        from ...core.base.errors import ObserverError
        from ...core.viewshed.station import SHARED_CELLS, cells_at

        try:
            return bool(tasks) and cells_at(self.dem, tasks[0][0], tasks[0][1], self.options) > SHARED_CELLS
        except ObserverError:
            return False

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
        missing = self._missing(jobs)
        fresh, fault = self._from_team() if self._team and missing else self._sweep(missing, progress), None
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

    def _missing(self, jobs):
        """Jobs whose result no earlier run has stored."""
        from ...core.io.viewshed_raster import stored_facts

        return [job for job in jobs if job.path is None or stored_facts(job.path, job.mark) is None]

    def _sweep(self, jobs, progress):
        """Yield the viewsheds of jobs at one place."""
        from ...core.viewshed.station import viewsheds_at

        if jobs:
            yield from viewsheds_at(self.dem, jobs[0].point.observer, sectors_of(jobs), self.options, progress)

    def _from_team(self):
        """Yield the viewsheds of the jobs at the next place, which another process has computed."""
        yield from self._team.take(None).result()  # type: ignore[union-attr]

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
        from ...core.viewshed.station import sink_for
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


def sectors_of(jobs):
    """Sectors of jobs, in order."""
    return tuple(job.sector for job in jobs)


def stations(points):
    """Groups of points from exactly one place and height, in the order of their first point."""
    groups = {}
    for point in points:
        groups.setdefault(point.observer, []).append(point)
    return list(groups.values())


def file_stem(point, taken):
    """Name for a photo's own raster that is not in use yet."""
    stem = Path(point.path).stem if point.path else f"point_{point.source_id}"
    return unused_name(stem, taken)
