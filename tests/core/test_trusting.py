"""A sample of a run's photographs tests the compass of each camera before all of them use it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from joint_walks import photo
from misled import misled_photos
from skyline_viewshed.core import api, trusting
from skyline_viewshed.core.base.errors import OutputError, PhotoError
from skyline_viewshed.core.base.model import Photo, PhotoMetadata
from skyline_viewshed.core.base.progress import as_progress
from skyline_viewshed.core.batch import DISTRUSTED_NOTE, PhotoRequest
from skyline_viewshed.core.many import OrientJob
from skyline_viewshed.core.pipeline import OrientOptions
from skyline_viewshed.core.workers.pool import Outcome

PRIOR = OrientOptions(compass="prior")


def tasks_of(count, device="Phone", compass=40.0, **facts):
    """Photographs in memory."""
    metadata = PhotoMetadata("a.jpg", 80, 60, camera=device, compass_heading_deg=compass)
    pixels = np.zeros((60, 80, 3), np.uint8)
    return [(PhotoRequest(f"{k}.jpg", **facts), Photo(metadata, pixels)) for k in range(count)]


class Oriented:
    """Stands for the work: each photograph's skyline is sure of 40 degrees, and each reading is as given."""

    def __init__(self, reading):
        self.reading, self.done = reading, []

    def __call__(self, job, tasks, progress):
        """Give the outcomes, and note the task and the shares that it was given."""
        for request, _ in tasks:
            self.done.append((request.path, job.options.compass_shares))
            far = photo(request.path, "accepted", [(40.0, 0.97)], compass=self.reading, device="Phone")
            yield Outcome(far)


def test_the_sample_is_spread_over_the_run():
    numbers = trusting.sample_of(tasks_of(400), PRIOR)
    assert len(numbers) == trusting.SAMPLE
    assert np.diff([0, *numbers, 400]).max() <= 400 / 4
    assert trusting.sample_of(tasks_of(5), PRIOR) == [0, 1, 2, 3, 4]


@pytest.mark.parametrize(
    ("tasks", "options"),
    [
        (tasks_of(8), OrientOptions()),
        (tasks_of(8), OrientOptions(method="paper", compass="prior")),
        (tasks_of(8), replace(PRIOR, compass_shares=(("Phone", 0.5),))),
        (tasks_of(3), PRIOR),
        (tasks_of(8, compass=None), PRIOR),
        (tasks_of(8, device=None), PRIOR),
        (tasks_of(8, heading_deg=30.0), PRIOR),
        ([(PhotoRequest("not there.jpg"), None), (None, None)] * 4, PRIOR),
        ([], PRIOR),
    ],
    ids=["ignored", "paper", "tested", "few", "no reading", "no camera", "given", "unreadable", "none"],
)
def test_nothing_is_tested_where_no_compass_would_be_used(tasks, options):
    assert trusting.sample_of(tasks, options) == []


def test_a_sound_compass_costs_nothing():
    """Each photograph is oriented once, and the order is that of the run."""
    work, tasks = Oriented(42.0), tasks_of(20)
    job, outcomes = trusting.trusted_outcomes(OrientJob(None, PRIOR), tasks, work)
    assert [outcome.value.path for outcome in outcomes] == [f"{k}.jpg" for k in range(20)]
    assert sorted(path for path, _ in work.done) == sorted(f"{k}.jpg" for k in range(20))
    assert job.options == PRIOR


def test_a_misled_compass_is_distrusted_by_all_photographs():
    """The sample is oriented again, with the share that it told."""
    work, tasks = Oriented(200.0), tasks_of(20)
    job, outcomes = trusting.trusted_outcomes(OrientJob(None, PRIOR), tasks, work)
    assert [outcome.value.path for outcome in outcomes] == [f"{k}.jpg" for k in range(20)]
    assert job.options.compass_shares == (("Phone", 0.9),)
    assert [shares for _, shares in work.done[8:]] == [(("Phone", 0.9),)] * 20


def test_a_folder_keeps_the_result_of_the_test(scene, tmp_path):
    """A repeat with the same sample tests nothing; a damaged file is written again."""
    job = OrientJob(api.open_dem(str(scene.dem)), PRIOR)
    tasks = [(replace(request, path=str(scene.folder / "north.jpg")), photo) for request, photo in tasks_of(8)]
    for expected in ((("Phone", 0.9),), ()):
        folder = tmp_path / f"kept {len(expected)}"
        work = Oriented(200.0 if expected else 42.0)
        after, _ = trusting.with_trust(job, tasks, work, folder=folder)
        (file,) = folder.iterdir()
        assert after.options.compass_shares == expected and len(work.done) == 8
        again, known = trusting.with_trust(job, tasks, work, folder=folder)
        assert again.options == after.options and known == {} and len(work.done) == 8
        file.write_text("[[", encoding="utf-8")
        assert trusting.with_trust(job, tasks, work, folder=folder)[0].options == after.options and len(work.done) == 16
    with pytest.raises(OutputError):
        trusting.with_trust(job, tasks, work, folder=file / "inside")


@pytest.mark.parametrize("reading", [42.0, 200.0])
def test_the_progress_never_goes_back(reading):
    told = []
    oriented = Oriented(reading)

    def work(job, tasks, progress):
        for number, outcome in enumerate(oriented(job, tasks, progress), 1):
            progress.report(number / len(tasks))
            yield outcome

    _, outcomes = trusting.trusted_outcomes(OrientJob(None, PRIOR), tasks_of(12), work, as_progress(told.append))
    assert len(list(outcomes)) == 12
    assert told == sorted(told) and told[-1] == pytest.approx(1)


def test_a_photograph_that_fails_in_the_sample_stays_in_its_place():
    def work(job, tasks, progress):
        for request, _ in tasks:
            bad = request.path == "2.jpg"
            yield Outcome(error=PhotoError("gone")) if bad else next(Oriented(41.0)(job, [(request, None)], progress))

    _, outcomes = trusting.trusted_outcomes(OrientJob(None, PRIOR), tasks_of(6), work)
    assert [outcome.error is not None for outcome in outcomes] == [False, False, True, False, False, False]


def test_photographs_of_a_lost_compass_are_oriented_as_without_it(scene, tmp_path):
    """From files to answers: four readings far from the truth, which the skylines of the same four reveal."""
    paths = misled_photos(scene, tmp_path)
    dem = api.open_dem(str(scene.dem))
    trusted = list(api.orient_many(paths, dem, compass="prior"))
    ignored = list(api.orient_many(paths, dem))
    assert [photo.heading_deg for photo in trusted] == pytest.approx([photo.heading_deg for photo in ignored], abs=0.3)
    assert all(DISTRUSTED_NOTE in photo.orientation.notes for photo in trusted)
    assert not any(DISTRUSTED_NOTE in photo.orientation.notes for photo in ignored)
    one = api.orient(paths[0], dem, compass="prior")
    assert one.orientation.p_correct < trusted[0].orientation.p_correct, "alone it cannot know"
