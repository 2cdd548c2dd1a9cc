"""Photographs that are solved together, block by block."""

from __future__ import annotations

import pytest
from joint_walks import photo
from skyline_viewshed.algorithms.shared import together
from skyline_viewshed.algorithms.shared.run_log import RunLog
from skyline_viewshed.core import many
from skyline_viewshed.core.base.errors import Cancelled
from skyline_viewshed.core.batch import PhotoRequest
from skyline_viewshed.core.many import OrientJob
from skyline_viewshed.core.pipeline import OrientOptions


@pytest.fixture
def solve(monkeypatch, listener):
    """Solve seven photographs in blocks of three; gives the names by block, the results and the feedback."""

    def call(block, fault=None):
        blocks, ended = [], []
        monkeypatch.setattr(together, "BLOCK", block)

        def solved(tasks, photos, orient_all, progress, options):
            if fault is not None:
                raise fault
            progress.report(0.5)
            blocks.append([one.path for one in photos])
            assert [request.path for request, _ in tasks] == blocks[-1]
            return photos

        def alone(share, workers):
            for number in range(7):
                yield photo(f"{number}.jpg", "accepted", [(40.0, 0.9)])
            ended.append(share)

        monkeypatch.setattr(many, "look_again", solved)
        feedback, requests = listener(), [PhotoRequest(f"{number}.jpg") for number in range(7)]
        job, told = OrientJob(None, OrientOptions()), RunLog(feedback, 7)
        found = together.oriented_together(requests, job, alone, told, (0.0, 0.8), 1)
        if isinstance(fault, Cancelled):
            with pytest.raises(Cancelled):
                list(found)
            return feedback
        return blocks, [one.path for one in found], feedback, ended

    return call


def test_all_are_solved_at_once_if_they_fit_into_memory(solve):
    blocks, found, feedback, ended = solve(300)
    assert blocks == [found] == [[f"{number}.jpg" for number in range(7)]]
    assert ended == [(0.0, pytest.approx(0.8 * many.JOINT_PART), 1.0)]
    assert feedback.fractions == [pytest.approx(100 * 0.8 * (1 + many.JOINT_PART) / 2)]


def test_more_photographs_are_solved_in_blocks_of_the_layer_s_order(solve):
    blocks, found, feedback, ended = solve(3)
    assert [len(block) for block in blocks] == [3, 3, 1] and sum(blocks, []) == found
    assert ended == [(0.0, 0.8, 1.0)], "the orientation has the whole bar, and its loop ran to its end"
    assert feedback.fractions == [], "a block moves no bar"


def test_the_photographs_of_a_run_are_solved_together_by_default(algorithm):
    for name in ("orientphotos", "photoviewshed"):
        assert algorithm(name).parameterDefinition("JOINT").defaultValue() is True


def test_a_fault_of_ours_leaves_each_photograph_its_own_answer(solve):
    _, found, feedback, _ = solve(300, RuntimeError("a matrix is singular"))
    assert found == [f"{number}.jpg" for number in range(7)]
    assert feedback.warnings == ["The photos could not be solved together, so each keeps its own answer."]
    assert any("a matrix is singular" in text for text in feedback.details)


def test_cancelling_says_where(solve):
    assert solve(300, Cancelled()).warnings == ["Cancelled while the photos were solved together."]


@pytest.mark.parametrize(
    ("joint", "count", "method", "wanted"),
    [(True, 2, "robust", True), (True, 1, "robust", False), (True, 2, "paper", False), (False, 2, "robust", False)],
)
def test_one_photograph_and_the_published_method_have_nothing_to_share(joint, count, method, wanted):
    assert together.are_together(joint, count, method) is wanted
