"""Chunks of photographs with result files, and on a Dask cluster of which a worker is killed."""

from __future__ import annotations

import os
import shutil
import signal

import numpy as np
import pytest
import worker_jobs
from misled import misled_photos
from skyline_viewshed.core import api, cli, cluster
from skyline_viewshed.core.base.errors import Cancelled
from skyline_viewshed.core.batch import DISTRUSTED_NOTE, PhotoRequest
from skyline_viewshed.core.cluster import RowsOfChunk, cluster_outcomes, rows_with_files
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.locate.index import ARRAYS
from skyline_viewshed.core.locate.places import Area, IndexOptions, lay_places
from skyline_viewshed.core.locating import index_of_area
from skyline_viewshed.core.many import OrientJob
from skyline_viewshed.core.pipeline import OrientOptions
from worker_jobs import Quick


@pytest.fixture(autouse=True)
def small_chunks(monkeypatch):
    monkeypatch.setattr(cluster, "CHUNK", 2)


@pytest.fixture
def tasks(scene, tmp_path):
    """Seven files, of which none is opened by `Quick`."""
    paths = [tmp_path / f"{number}.jpg" for number in range(7)]
    for path in paths:
        path.write_bytes(b"")
    return [(PhotoRequest(str(path)), None) for path in paths]


@pytest.fixture
def work(scene):
    return RowsOfChunk(Quick(open_dem(str(scene.dem)), OrientOptions()), 1000.0)


def headings(rows):
    return [row.values["heading"] for row in rows]


def test_chunks_lie_in_files_and_a_repeat_does_only_what_is_missing(work, tasks, tmp_path):
    folder = tmp_path / "chunks"
    rows = list(rows_with_files(work, tasks, folder))
    assert headings(rows) == [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0] and len(list(folder.iterdir())) == 4
    assert all(row.values["status"] == "accepted" for row in rows)
    for file in sorted(folder.iterdir())[1:3]:
        file.unlink()
    done = Quick.done()
    assert rows == list(rows_with_files(work, tasks, folder))
    assert Quick.done() - done == 4
    os.utime(tasks[0][0].path, ns=(1, 1))
    list(rows_with_files(work, tasks, folder))
    assert Quick.done() - done == 6, "a changed photograph makes its chunk anew"


def test_a_stopped_run_leaves_whole_files_only(work, tasks, tmp_path):
    class Stops:
        def report(self, fraction):
            self.at = fraction

        def cancelled(self):
            return getattr(self, "at", 0) >= 0.5

    with pytest.raises(Cancelled):
        list(rows_with_files(work, tasks, tmp_path / "chunks", progress=Stops()))
    assert 1 <= len(list((tmp_path / "chunks").iterdir())) <= 3
    assert headings(rows_with_files(work, tasks, tmp_path / "chunks")) == [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0]


def test_a_chunk_that_another_run_finishes_meanwhile_gets_no_other_rows(work, tasks, tmp_path):
    expected = list(rows_with_files(work, tasks, tmp_path / "theirs"))
    second = sorted((tmp_path / "theirs").iterdir())[1]

    class Meanwhile:
        cancelled = worker_jobs.Silence().cancelled

        def report(self, fraction):
            if not (tmp_path / "ours" / second.name).exists():
                shutil.copy(second, tmp_path / "ours")

    assert list(rows_with_files(work, tasks, tmp_path / "ours", progress=Meanwhile())) == expected
    for ours, theirs in zip(*(sorted((tmp_path / name).iterdir()) for name in ("ours", "theirs"))):
        assert ours.name == theirs.name and ours.read_bytes() == theirs.read_bytes()


def test_a_chunk_stops_at_the_next_photograph(work, tasks):
    class Stops:
        def report(self, fraction):
            self.at = fraction

        def cancelled(self):
            return getattr(self, "at", 0) > 0.2

    done = Quick.done()
    with pytest.raises(Cancelled):
        work(tasks, Stops())
    assert Quick.done() - done == 3


def test_a_photograph_that_kills_its_process_costs_nothing_else(work, tasks, tmp_path):
    deadly = tmp_path / "deadly.jpg"
    deadly.write_bytes(b"")
    tasks = [*tasks[:3], (PhotoRequest(str(deadly)), None), *tasks[3:]]
    rows = list(rows_with_files(work, tasks, tmp_path / "chunks", workers=2))
    assert headings(rows) == [0.0, 1.0, 2.0, None, 3.0, 4.0, 5.0, 6.0]
    assert rows[3].values["status"] == "failed" and "ended unexpectedly" in rows[3].values["message"]


def test_a_path_of_gdal_is_copied_and_keeps_its_name(scene):
    gdal = pytest.importorskip("osgeo.gdal")
    source = scene.folder / "north.jpg"
    gdal.FileFromMemBuffer("/vsimem/cloud/north.jpg", source.read_bytes())
    job = OrientJob(open_dem(str(scene.dem)), OrientOptions())
    rows = RowsOfChunk(job, 1000.0)([(PhotoRequest(path), None) for path in (
        "/vsimem/cloud/north.jpg", str(source), "/vsimem/cloud/missing.jpg")])  # fmt: skip
    gdal.Unlink("/vsimem/cloud/north.jpg")
    assert rows[0].values["photo"] == "/vsimem/cloud/north.jpg" and rows[2].values["status"] == "failed"
    assert rows[0].values["heading"] == rows[1].values["heading"] and rows[0].values["status"] == "accepted"


@pytest.fixture(scope="module")
def client():
    distributed = pytest.importorskip("distributed", reason="Dask is an optional package")
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None, processes=True) as local,
        distributed.Client(local) as client,
    ):
        yield client


def test_a_cluster_gives_the_same_table_although_a_worker_is_killed(client, work, tasks, tmp_path):
    alone = list(rows_with_files(work, tasks, tmp_path / "alone"))
    assert list(rows_with_files(work, tasks, tmp_path / "many", client)) == alone
    pids = client.run(os.getpid)
    killed = []

    class Kills:
        def report(self, fraction):
            if fraction > 0.2 and not killed:
                killed.append(next(iter(pids.values())))
                os.kill(killed[0], signal.SIGKILL)

        def cancelled(self):
            return False

    slow = RowsOfChunk(Quick(work.job.dem, work.job.options, 0.5), 1000.0)
    again = list(rows_with_files(slow, tasks, tmp_path / "killed", client, progress=Kills()))
    assert killed and again == alone


def test_outcomes_come_back_from_the_cluster_in_order(client, work, tasks):
    outcomes = list(cluster_outcomes(client, work.job, tasks, worker_jobs.Silence()))
    assert [round(outcome.result().heading_deg) for outcome in outcomes] == list(range(7))


def test_the_compasses_are_tested_on_the_cluster_too(client, scene, tmp_path):
    paths, dem = misled_photos(scene, tmp_path), open_dem(str(scene.dem))
    here, there = (list(api.orient_many(paths, dem, compass="prior", client=used)) for used in (None, client))
    assert [photo.heading_deg for photo in there] == [photo.heading_deg for photo in here]
    assert all(DISTRUSTED_NOTE in photo.orientation.notes for photo in there)


def test_a_repeat_with_result_files_does_not_test_the_compasses_again(scene, tmp_path):
    misled_photos(scene, tmp_path / "photos")
    command = ["orient", tmp_path / "photos", scene.dem, "-o", tmp_path / "p.csv", "--compass", "prior"]
    command = [str(word) for word in (*command, "--results", tmp_path / "chunks", "--workers", 1, "--quiet")]
    assert cli.main(command) == 0
    files = {file: file.stat().st_mtime_ns for file in (tmp_path / "chunks").iterdir()}
    assert sorted(file.stem.split("-")[0] for file in files) == ["chunk", "chunk", "compasses"]
    assert cli.main(command) == 0
    assert {file: file.stat().st_mtime_ns for file in (tmp_path / "chunks").iterdir()} == files


def test_an_index_from_the_cluster_is_the_same(client, scene):
    dem = open_dem(str(scene.dem))
    middle = dem.position_of(dem.shape[1] / 2, dem.shape[0] / 2)
    area = Area.circle(*map(float, middle), 3_000.0)
    options = IndexOptions(spacing_m=100.0, azimuths=36, max_distance_m=4_000.0)
    alone, many = index_of_area(dem, area, options), index_of_area(dem, area, options, client=client)
    assert len(lay_places(dem, area, options).tiles) > 1
    for name in ARRAYS:
        assert np.array_equal(getattr(alone, name), getattr(many, name))


def test_killing_the_whole_run_and_starting_again(scene, tmp_path):
    """The command line with two processes, killed once a chunk is finished; the repeat does not make it again."""
    import subprocess
    import sys
    import time

    from whole_runs import PLAIN, as_from_a_terminal, rows_of

    folder = tmp_path / "photos"
    folder.mkdir()
    for number in range(4):
        shutil.copy(scene.folder / "north.jpg", folder / f"{number}.jpg")
    code = "from skyline_viewshed.core import cli, cluster; cluster.CHUNK = 1; raise SystemExit(cli.main())"
    command = [sys.executable, "-c", code, "orient", folder, scene.dem, "-o", tmp_path / "p.gpkg",
               "--results", tmp_path / "chunks", "--workers", "2"]  # fmt: skip
    made = {}
    for least, kind in ((1, signal.SIGKILL), (2, signal.SIGINT)):
        process = subprocess.Popen(
            [str(word) for word in command], env=PLAIN, stderr=subprocess.DEVNULL, preexec_fn=as_from_a_terminal
        )
        deadline = time.monotonic() + 60
        while len(list((tmp_path / "chunks").glob("*.json"))) < least and time.monotonic() < deadline:
            time.sleep(0.01)
        process.send_signal(kind)
        process.wait(60)
        files = {file: file.stat().st_mtime_ns for file in (tmp_path / "chunks").glob("*.json")}
        assert len(files) >= least and made.items() <= files.items(), "a finished chunk is never made again"
        assert not (tmp_path / "p.gpkg").exists() or process.returncode == 0
        made = files
    done = subprocess.run([str(word) for word in command], env=PLAIN, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert [row["status"] for row in rows_of(tmp_path / "p.gpkg")] == ["accepted"] * 4
    files = {file: file.stat().st_mtime_ns for file in (tmp_path / "chunks").glob("*.json")}
    assert len(files) == 4 and made.items() <= files.items()
