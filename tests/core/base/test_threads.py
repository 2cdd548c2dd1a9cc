"""Threads: results and errors reach the caller, cancelling ends them, and a worker process has one."""

from __future__ import annotations

import threading
import time

import pytest
from skyline_viewshed.core.base import threads
from skyline_viewshed.core.base.errors import Cancelled
from skyline_viewshed.core.base.progress import SILENT, checkpoint
from skyline_viewshed.core.base.threads import side_by_side, thread_count, use_one_thread
from skyline_viewshed.core.workers.pool import Pool
from worker_jobs import Squares


class Recorder:
    def __init__(self, stop_at=2.0):
        self.fractions, self.stop_at, self.threads = [], stop_at, set()

    def report(self, fraction):
        self.fractions.append(fraction)
        self.threads.add(threading.get_ident())

    def cancelled(self):
        return bool(self.fractions) and self.fractions[-1] >= self.stop_at


@pytest.mark.parametrize("count", [1, 2, 5])
def test_every_task_runs_and_only_the_caller_reports(count):
    done, recorder = [], Recorder()

    def task(number):
        def run(progress):
            progress.report(1.0)
            done.append((number, threading.get_ident()))

        return run

    side_by_side([task(number) for number in range(4)], recorder, count)
    assert sorted(number for number, _ in done) == [0, 1, 2, 3]
    assert recorder.threads == {threading.get_ident()}
    assert recorder.fractions[-1] == 1.0
    in_caller = {ident for _, ident in done} == {threading.get_ident()}
    assert in_caller is (count == 1)


def test_two_tasks_really_run_at_once():
    barrier = threading.Barrier(2, timeout=60)
    side_by_side([lambda _: barrier.wait()] * 2, threads=2)


@pytest.mark.parametrize("count", [1, 2])
def test_the_error_of_a_task_reaches_the_caller_and_stops_the_others(count):
    stopped, started = [], threading.Event()

    def fails(_):
        if count == 2:
            started.wait(60)
        raise ValueError("no")

    def waits(progress):
        started.set()
        while not progress.cancelled():
            time.sleep(0.01)
        stopped.append(True)

    with pytest.raises(ValueError, match="no"):
        side_by_side([fails, waits], threads=count)
    assert stopped == ([True] if count == 2 else [])


@pytest.mark.parametrize("count", [1, 2])
def test_a_cancel_ends_the_tasks_before_the_caller_goes_on(count):
    ended = []

    def endless(progress):
        try:
            for step in range(10**9):
                checkpoint(progress, min(0.5, step / 10))
                time.sleep(0.01)
        finally:
            ended.append(True)

    with pytest.raises(Cancelled):
        side_by_side([endless, endless], Recorder(stop_at=0.2), count)
    assert len(ended) == count


def test_a_process_may_be_limited_to_one_thread(monkeypatch):
    monkeypatch.setattr(threads, "_limit", [0])
    assert 1 <= thread_count() <= threads.MOST_THREADS
    use_one_thread()
    assert thread_count() == 1


def test_a_worker_process_uses_one_thread():
    with Pool(Squares(), 2) as pool:
        assert {outcome.result() for outcome in pool.map(["threads"] * 4, SILENT)} == {1}
