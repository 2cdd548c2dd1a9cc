"""Photographs in chunks, on a Dask cluster or on this computer, with a result file per chunk so that a run can go on.

`dask` and `distributed` are never imported here: the caller's client brings them.
"""

from __future__ import annotations

import hashlib
import json
from collections import deque
from dataclasses import dataclass, replace
from datetime import datetime
from pathlib import Path
from typing import Any

from .base.errors import Cancelled, TerrainError
from .base.progress import SILENT, checkpoint, subtask
from .io.local_copy import local_copy
from .io.orientation_file import orientation_mark
from .io.whole_file import staged
from .many import OrientJob, fallen, outcomes_of
from .workers.interpreter import worker_count
from .workers.pool import LOST, Outcome, WorkerLostError
from .workers.team import Team

CHUNK = 20
"""Photographs per task: enough that opening the DEM and sharing horizons pay, and little to lose."""

IN_FLIGHT = 3
"""Chunks per thread of the cluster that are handed out at a time, so that the client's memory is bounded."""

POLL_S = 0.2


@dataclass(frozen=True, eq=False)
class PhotosOfChunk:
    """Orients the photographs of a chunk, and gives a list of `Outcome`; picklable.

    Attributes
    ----------
    job : OrientJob
    """

    job: OrientJob

    def __call__(self, tasks, progress=SILENT):
        """Orient (PhotoRequest, Photo or None) one after the other in the process that calls."""
        orient, outcomes = self.job(), []
        for number, (request, photo) in enumerate(tasks):
            part = subtask(progress, number / len(tasks), (number + 1) / len(tasks))
            checkpoint(part, 0.0)
            try:
                with local_copy(request.path) as path:
                    found = orient((replace(request, path=path), photo), part)
                outcomes.append(Outcome(_named(found, request.path)))
            except TerrainError:
                raise
            except Exception as error:  # one photograph's fault must not cost its chunk
                outcomes.append(Outcome(error=error))
        return outcomes

    def lost(self, task):
        """Give the result for a photograph whose process has died each time."""
        return Outcome(error=WorkerLostError(LOST))


@dataclass(frozen=True, eq=False)
class RowsOfChunk:
    """The same, giving rows for `write_points`, which are small.

    Attributes
    ----------
    job : OrientJob
    max_distance_m : float
        Search range of the run [m].
    """

    job: OrientJob
    max_distance_m: float

    def __call__(self, tasks, progress=SILENT):
        """Orient the photographs and give a list of `PointRow`."""
        outcomes = PhotosOfChunk(self.job)(tasks, progress)
        return [self._row(task, outcome) for task, outcome in zip(tasks, outcomes)]

    def lost(self, task):
        """Give the row for a photograph whose process has died each time."""
        return self._row(task, Outcome(error=WorkerLostError(LOST)))

    def _row(self, task, outcome):
        from .io.vector import photo_row

        oriented = outcome.value if outcome.error is None else fallen(task[0].path, outcome.error)
        return photo_row(oriented, self.max_distance_m)


def cluster_outcomes(client, job, tasks, progress):
    """Orient photographs on a Dask cluster.

    Parameters
    ----------
    client : dask.distributed.Client
    job : OrientJob
    tasks : list of (PhotoRequest, Photo or None)
    progress : Progress

    Yields
    ------
    Outcome
        In order.
    """
    # No chunk is so large that threads wait for it without one of their own.
    size = min(CHUNK, -(-len(tasks) // _threads(client)))
    for outcomes in _run(PhotosOfChunk(job), _chunks(tasks, size), client, 1, progress):
        yield from outcomes


def spread_over(client, workers):
    """Return how photographs are oriented: a callable of (job, tasks, progress) that gives outcomes in order.

    Parameters
    ----------
    client : dask.distributed.Client or None
        None works on this computer, with `workers` processes.
    workers : int
        See `worker_count`.
    """

    def orient_all(job, tasks, progress):
        return cluster_outcomes(client, job, tasks, progress) if client else outcomes_of(job, tasks, progress, workers)

    return orient_all


def tiles_on(client):
    """Return how `locate.build.build_index` spreads the tiles of an index over a Dask cluster.

    Parameters
    ----------
    client : dask.distributed.Client

    Returns
    -------
    callable
        (TileWork, tiles, progress) -> iterator; a tile whose process has died is computed by the caller.
    """

    def spread(work, tiles, progress):
        for done, (tile, found) in enumerate(zip(tiles, _on_cluster(work, tiles, client, progress)), 1):
            yield work(tile) if found is None else found
            progress.report(done / len(tiles))

    return spread


# parameters: the run, and where it is done
def rows_with_files(work, tasks, folder, client=None, workers=1, progress=SILENT):
    """Orient photographs chunk by chunk; finished chunks lie in files, which a repeated run takes up.

    Parameters
    ----------
    work : RowsOfChunk
    tasks : list of (PhotoRequest, None)
    folder : Path
        For one JSON file per chunk, each whole; the name contains the fingerprint of all on which it depends.
    client : dask.distributed.Client or None
        None works on this computer, with `workers` processes.
    workers : int
    progress : Progress

    Yields
    ------
    PointRow
        In order.
    """
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    chunks = _chunks(tasks, CHUNK)
    files = [folder / f"chunk-{number:06d}-{_mark(work, chunk)}.json" for number, chunk in enumerate(chunks)]
    # Asked once: another run may work in the same folder, and a chunk must not get the rows of another.
    missing = [(chunk, file) for chunk, file in zip(chunks, files) if not file.exists()]
    fresh = _run(work, [chunk for chunk, _ in missing], client, workers, progress)
    for rows, (_, file) in zip(fresh, missing):  # in this order, so that the work runs to its end
        with staged(file) as stage:
            (stage / file.name).write_text(json.dumps([_plain(row) for row in rows]), encoding="utf-8")
    for file in files:
        yield from map(_restored, json.loads(file.read_text(encoding="utf-8")))


def _chunks(tasks, size):
    return [tasks[start : start + size] for start in range(0, len(tasks), max(size, 1))]


def _threads(client):
    return max(sum(client.nthreads().values()), 1)


def _mark(work, chunk):
    dem, options = work.job.dem, work.job.options
    marks = [orientation_mark(request, dem, (options, work.max_distance_m)) for request, _ in chunk]
    return hashlib.sha256("".join(marks).encode()).hexdigest()[:16]


def _run(work, chunks, client, workers, progress):
    """Yield the list of results of each chunk, in order; a chunk whose process dies is done photo by photo."""
    for done, (chunk, result) in enumerate(zip(chunks, _results(work, chunks, client, workers, progress)), 1):
        if result is None:
            singles, part = [[task] for task in chunk], subtask(progress, (done - 1) / len(chunks), done / len(chunks))
            found = _results(work, singles, client, workers, part)
            result = [work.lost(task) if one is None else one[0] for task, one in zip(chunk, found)]
        progress.report(done / len(chunks))
        yield result


def _results(work, chunks, client, workers, progress):
    """Yield what `work` gives for each chunk; None for one whose process has died."""
    if client is not None:
        yield from _on_cluster(work, chunks, client, progress)
        return
    with Team(_Here(work), worker_count(workers, len(chunks))) as team:
        team.begin(chunks, progress)
        for index in range(len(chunks)):
            outcome = team.take(subtask(progress, index / len(chunks), (index + 1) / len(chunks)))
            yield None if isinstance(outcome.error, WorkerLostError) else outcome.result()


@dataclass(frozen=True, eq=False)
class _Here:
    """Chunks as the tasks of a `Team`."""

    work: Any

    def __call__(self):
        return self.work


def _on_cluster(work, chunks, client, progress):
    waiting: deque = deque(chunks)
    futures: deque = deque()
    most = IN_FLIGHT * _threads(client)
    try:
        while waiting or futures:
            while waiting and len(futures) < most:
                futures.append(client.submit(work, waiting.popleft(), pure=False))
            while not futures[0].done():
                if progress.cancelled():
                    raise Cancelled
                _wait(futures[0])
            error = futures[0].exception()
            if error is not None and type(error).__name__ != "KilledWorker":
                raise error
            yield None if error is not None else futures[0].result()
            futures.popleft()
    finally:
        client.cancel(list(futures))


def _wait(future):
    """Wait a moment, or until the task is done."""
    try:
        future.exception(timeout=POLL_S)
    except Exception as error:
        if "Timeout" not in type(error).__name__:
            raise


def _named(oriented, path):
    """Give a photograph the path by which its request names it."""
    metadata = oriented.metadata and replace(oriented.metadata, path=path)
    return replace(oriented, path=path, metadata=metadata)


def _plain(row):
    values = {n: {"time": v.isoformat()} if isinstance(v, datetime) else v for n, v in row.values.items()}
    return {"position": row.position, "values": values}


def _restored(row):
    from .io.vector import PointRow

    times = {n: datetime.fromisoformat(v["time"]) for n, v in row["values"].items() if isinstance(v, dict)}
    position = row["position"] and tuple(row["position"])
    return PointRow(position, {**row["values"], **times})
