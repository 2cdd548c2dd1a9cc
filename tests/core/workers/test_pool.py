"""The pool: order, errors, deaths, cancelling, and that no process outlives its run."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections import deque
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from skyline_viewshed.core.base.errors import Cancelled, UnreadablePhotoError
from skyline_viewshed.core.base.progress import SILENT
from skyline_viewshed.core.workers import pool as pools
from skyline_viewshed.core.workers.pool import LOST, NoWorkersError, Pool, WorkerLostError
from skyline_viewshed.core.workers.team import Team
from worker_jobs import First, Refused, Squares

HERE = Path(__file__).resolve().parent

PACKAGES = HERE.parents[2] / "build" / "plugins"
TESTS = HERE.parents[1]


def alive(pid):
    try:
        state = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0]
    except OSError:
        return False
    return state != "Z"


def pids_of(pool):
    return [worker.process.pid for worker in pool._workers]


def test_results_come_in_order_and_arrays_unchanged():
    tasks = [np.arange(k, dtype=float) for k in range(9)]
    with Pool(Squares(0.1), 2) as pool:
        results = [outcome.result() for outcome in pool.map(tasks, SILENT)]
        pids = pids_of(pool)
    for task, result in zip(tasks, results):
        np.testing.assert_array_equal(result, 0.1 * np.square(task))
    assert len(pids) == 2 and not any(map(alive, pids))


def test_an_error_keeps_its_type_message_and_traceback():
    with Pool(Squares(), 2) as pool:
        one, two, three = pool.map([2.0, "raise", 3.0], SILENT)
    assert (one.result(), three.result()) == (4.0, 9.0)
    assert isinstance(two.error, UnreadablePhotoError) and two.error.message.facts["reason"] == "why not"
    assert two.error.path == "a.jpg" and "in work" in two.details


def test_a_worker_that_dies_costs_its_task_only():
    with Pool(Squares(), 2) as pool:
        outcomes = list(pool.map([1.0, "die", 2.0, 3.0, "die", "die", 4.0], SILENT))
        assert len(pool._workers) == 2
    lost = [index for index, outcome in enumerate(outcomes) if isinstance(outcome.error, WorkerLostError)]
    assert lost == [1, 4, 5] and outcomes[1].error.message == LOST
    assert [outcomes[index].result() for index in (0, 2, 3, 6)] == [1.0, 4.0, 9.0, 16.0]


def test_a_later_process_that_refuses_the_job_costs_no_task(tmp_path):
    with Pool(First(str(tmp_path / "marker")), 2) as pool:
        assert [outcome.result() for outcome in pool.map(list(range(8)), SILENT)] == list(range(8))
        assert len(pool._workers) == 1, "no more are started after some failed starts"


def test_what_libraries_print_does_not_disturb_the_messages():
    with Pool(Squares(), 1) as pool:
        assert [outcome.result() for outcome in pool.map(["print", 3.0], SILENT)][1] == 9.0


class Watching:
    """A progress that notes what it is told and cancels after some seconds."""

    def __init__(self, cancel_after_s=1e9):
        self.told, self._end = [], time.monotonic() + cancel_after_s

    def report(self, fraction):
        self.told.append(fraction)

    def cancelled(self):
        return time.monotonic() > self._end


def test_progress_within_a_task_arrives():
    progress = Watching()
    with Pool(Squares(), 1) as pool:
        assert next(pool.map(["report"], progress)).result() is False
    assert any(0.4 < fraction < 0.6 for fraction in progress.told) and max(progress.told) == 1.0


def test_cancelling_ends_all_workers_within_two_seconds():
    with Pool(Squares(), 2) as pool:
        pids, started = pids_of(pool), time.monotonic()
        with pytest.raises(Cancelled):
            list(pool.map(["sleep", "sleep"], Watching(0.5)))
        assert time.monotonic() - started < 2.5 and not any(map(alive, pids))


def test_tasks_of_one_station_go_to_one_worker():
    """Its own station first, then one that no other works on, and only then what is left."""
    one, two = (SimpleNamespace(key=None, tasks=[]) for _ in range(2))
    run = pools._Run(SimpleNamespace(_workers=[one, two], count=2), list("abcdef"), ["x", "x", "y", "x", "y", None])
    assert run._choice(one, 6) == 0
    one.key = "x"
    assert run._choice(two, 6) == 2
    two.key = "y"
    run.waiting = deque([1, 3, 4, 5])
    assert (run._choice(one, 6), run._choice(two, 6)) == (1, 4)
    run.waiting = deque([3, 5])
    assert (run._choice(two, 6), run._choice(two, 4)) == (5, 3)


PARENT = """
import sys, time
sys.path.insert(0, {here!r})
from worker_jobs import Squares
from skyline_viewshed.core.base.progress import SILENT
from skyline_viewshed.core.workers.pool import Pool
with Pool(Squares(), 4) as pool:
    print(*(worker.process.pid for worker in pool._workers), flush=True)
    list(pool.map(["sleep"] * 8, SILENT))
"""


@pytest.mark.parametrize("kind", [signal.SIGKILL, signal.SIGINT, signal.SIGTERM])
@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="looks into /proc")
def test_no_worker_outlives_a_killed_run(kind):
    environment = {**os.environ, "PYTHONPATH": str(PACKAGES)}
    parent = subprocess.Popen(
        [sys.executable, "-c", PARENT.format(here=str(TESTS))], env=environment, stdout=subprocess.PIPE, text=True,
        stderr=subprocess.DEVNULL, preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
    )  # fmt: skip
    pids = [int(word) for word in parent.stdout.readline().split()]
    assert len(pids) == 4
    time.sleep(0.5)
    parent.send_signal(kind)
    parent.communicate(timeout=30)
    deadline = time.monotonic() + 20  # on a busy machine a worker may still be loading NumPy
    while time.monotonic() < deadline and any(map(alive, pids)):
        time.sleep(0.05)
    assert not any(map(alive, pids))


def test_without_a_python_the_team_says_so_and_works_here(monkeypatch):
    monkeypatch.setattr(pools, "interpreters", lambda: ["/nowhere/python3"])
    with pytest.raises(NoWorkersError), Pool(Squares(), 2):
        pass
    with Team(Squares(), 2) as team:
        assert team.alone and "/nowhere/python3" in team.note
        team.begin([2.0, "raise"], SILENT)
        assert team.take(SILENT).result() == 4.0
        assert isinstance(team.take(SILENT).error, UnreadablePhotoError)


def test_a_job_that_other_processes_cannot_prepare_is_done_here():
    with Team(Refused(os.getpid()), 2) as team:
        assert team.alone and "only here" in team.note
        team.begin([5], SILENT)
        assert team.take(SILENT).result() == 5


def test_a_python_of_another_version_is_passed_over(tmp_path, monkeypatch):
    """The first candidate ends at once, as another version does; the second is this Python."""
    other = tmp_path / "python3"
    other.write_text("#!/bin/sh\nexit 3\n")
    other.chmod(0o755)
    monkeypatch.setattr(pools, "interpreters", lambda: [str(other), sys.executable])
    with Pool(Squares(), 1) as pool:
        assert pool.command == sys.executable and next(pool.map([3.0], SILENT)).result() == 9.0
