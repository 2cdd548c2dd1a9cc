"""Reports reach the disk whole or not at all."""

from __future__ import annotations

import os

import pytest
from skyline_viewshed.core.errors import OutputError
from skyline_viewshed.core.io.report_file import ReportFile


def test_head_body_and_tail_come_in_order(tmp_path):
    path = tmp_path / "ärgernis 🏔.html"
    file = ReportFile(path)
    for part in ("eins ", "zwei ", "⟨drei⟩\n"):
        file.write(part)
    file.finish("<head>", "<tail>")
    assert path.read_bytes() == "<head>eins zwei ⟨drei⟩\n<tail>".encode()
    assert os.listdir(tmp_path) == [path.name]


def test_until_the_end_there_is_no_file_and_the_older_one_stays(tmp_path):
    path = tmp_path / "report.html"
    path.write_text("older")
    file = ReportFile(path)
    file.write("newer" * 100_000)
    assert path.read_text() == "older"
    assert os.listdir(tmp_path) == ["report.html"]
    file.discard()
    assert path.read_text() == "older"
    assert os.listdir(tmp_path) == ["report.html"]


def test_a_missing_folder_is_said_in_a_sentence(tmp_path):
    with pytest.raises(OutputError, match="does not exist"):
        ReportFile(tmp_path / "missing" / "report.html")


def test_a_name_that_is_a_folder_is_refused_and_nothing_stays(tmp_path):
    (tmp_path / "report.html").mkdir()
    file = ReportFile(tmp_path / "report.html")
    with pytest.raises(OutputError, match="cannot be written"):
        file.finish("a", "b")
    assert os.listdir(tmp_path) == ["report.html"]


def test_a_full_disk_is_said_in_a_sentence():
    """/dev/full refuses every byte, as a full disk does."""
    if not os.path.exists("/dev/full"):
        pytest.skip("this system has no /dev/full")
    file = ReportFile(os.path.join(os.curdir, "never-written.html"))
    file._body.close()
    file._body = open("/dev/full", "w", encoding="utf-8")  # noqa: SIM115
    with pytest.raises(OutputError, match="free some space"):
        file.write("x" * 1_000_000)
    file.discard()
    assert not os.path.exists("never-written.html")


def test_what_waits_is_not_held_in_memory(tmp_path):
    import tracemalloc

    tracemalloc.start()
    file = ReportFile(tmp_path / "report.html")
    for _ in range(200):
        file.write("x" * 250_000)
    file.finish("", "")
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert (tmp_path / "report.html").stat().st_size == 50_000_000
    assert peak < 10_000_000
