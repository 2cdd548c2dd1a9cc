"""A report reaches its name whole or not at all, also with a folder of pages beside it."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path
from random import Random

import pytest
from skyline_viewshed.core.base.errors import OutputError
from skyline_viewshed.core.io import report_file
from skyline_viewshed.core.io.report_file import ReportFile


def test_head_body_and_tail_come_in_order(tmp_path):
    path = tmp_path / "ärgernis 🏔.html"
    file = ReportFile(path)
    for part in ("eins ", "zwei ", "⟨drei⟩\n"):
        file.write(part)
    file.finish("<head>", "<tail>")
    assert path.read_bytes() == "<head>eins zwei ⟨drei⟩\n<tail>".encode()
    assert os.listdir(tmp_path) == [path.name]


def test_until_the_end_there_is_no_report_and_the_older_one_stays(tmp_path):
    path = tmp_path / "report.html"
    path.write_text("older")
    file = ReportFile(path)
    file.write("newer" * 100_000)
    assert path.read_text() == "older"
    assert os.listdir(tmp_path) == ["report.html"]
    file.discard()
    assert path.read_text() == "older"
    assert os.listdir(tmp_path) == ["report.html"]


def test_a_missing_folder_of_a_report_is_said_in_a_sentence(tmp_path):
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
    file._body = open("/dev/full", "r+b", buffering=0)  # noqa: SIM115
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


def report_with_page(path, words="page"):
    file = ReportFile(path)
    file.write(words)
    file.add("page-0001.html", file.cut(1))
    return file


def files_of(folder):
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file())


def test_texts_are_cut_off_the_body_in_order(tmp_path):
    file = ReportFile(tmp_path / "report.html")
    for number in range(7):
        file.write(f"Ä{number} ")
    taken = [file.cut(2).decode(), file.cut(3).decode()]
    file.write("last ")
    assert [*taken, file.cut(1).decode()] == ["Ä0 Ä1 ", "Ä2 Ä3 Ä4 ", "Ä5 "]
    file.finish("<", ">")
    assert (tmp_path / "report.html").read_text(encoding="utf-8") == "<Ä6 last >"


def test_a_report_refers_to_pages_that_are_there_and_those_of_older_reports_go(tmp_path):
    path = tmp_path / "run.html"
    for words in ("older", "newer"):
        file = report_with_page(path, words)
        assert not (tmp_path / file.folder).exists()
        file.finish(f"<{file.folder}>", "")
    folder = path.read_text()[1:-1]
    assert files_of(tmp_path) == sorted(["run.html", f"{folder}/page-0001.html"])
    page = tmp_path / folder / "page-0001.html"
    assert page.read_text() == "newer"
    assert (page.parent / file.home).resolve() == path


def test_a_small_report_removes_the_pages_of_a_large_one_and_nothing_else(tmp_path):
    report_with_page(tmp_path / "run.html").finish("", "")
    report_with_page(tmp_path / "other.html").finish("", "")
    (tmp_path / "run_files" / "notes").mkdir()
    ReportFile(tmp_path / "run.html").finish("", "")
    assert os.listdir(tmp_path / "run_files") == ["notes"]
    assert len(files_of(tmp_path / "other_files")) == 1
    (tmp_path / "run_files" / "notes").rmdir()
    ReportFile(tmp_path / "run.html").finish("", "")
    assert not (tmp_path / "run_files").exists()


@pytest.mark.parametrize("step", [1, 2])
def test_wherever_publishing_fails_the_older_report_and_its_pages_stay(tmp_path, monkeypatch, step):
    path = tmp_path / "run.html"
    first = report_with_page(path, "older")
    first.finish("older", "")
    before, moves, replace = files_of(tmp_path), [], os.replace

    def failing(source, target):
        moves.append(target)
        if len(moves) == step:
            raise PermissionError(13, "Access is denied")
        replace(source, target)

    monkeypatch.setattr(report_file.os, "replace", failing)
    with pytest.raises(OutputError, match="Access is denied"):
        report_with_page(path, "newer").finish("newer", "")
    assert files_of(tmp_path) == before and path.read_text() == "older"
    assert sorted(os.listdir(tmp_path)) == ["run.html", "run_files"]


def test_a_report_that_was_given_up_leaves_no_pages(tmp_path):
    report_with_page(tmp_path / "run.html").discard()
    assert os.listdir(tmp_path) == []


def test_pages_of_a_killed_run_are_removed_a_day_later(tmp_path):
    for name in ("run.html", "other.html"):
        report_with_page(tmp_path / name)._body.close()  # neither finished nor discarded, as after a kill
    stages = {path.name.split("-")[1]: path for path in tmp_path.iterdir()}
    report_with_page(tmp_path / "run.html").finish("", "")
    assert all(stage.exists() for stage in stages.values()), "another run may still write them"
    for stage in stages.values():
        os.utime(stage, (0, 0))
    report_with_page(tmp_path / "run.html").finish("", "")
    assert not stages["run_files"].exists() and stages["other_files"].exists()


WRITER = """
import itertools, sys
from skyline_viewshed.core.io.report_file import ReportFile
for number in itertools.count():
    report = ReportFile(sys.argv[1])
    for page in range(20):
        report.write(str(number) * 10_000)
        report.add(f"page-{page:04d}.html", report.cut(1))
    report.finish(f"{report.folder} {number}", "</html>")
    print(flush=True)
"""


def test_a_report_and_its_pages_belong_together_whenever_the_writer_is_killed(tmp_path):
    path, random = tmp_path / "run.html", Random(5)
    environment = dict(os.environ, PYTHONPATH=str(Path(__file__).resolve().parents[3] / "build" / "plugins"))
    for _ in range(10):
        process = subprocess.Popen([sys.executable, "-c", WRITER, str(path)], env=environment, stdout=subprocess.PIPE)
        process.stdout.readline()
        time.sleep(random.uniform(0.0, 0.1))
        process.kill()
        process.communicate(timeout=60)
        folder, number = path.read_text()[: -len("</html>")].split(" ")
        pages = [page.read_text() for page in (tmp_path / folder).iterdir()]
        assert pages == [number * 10_000] * 20
    ReportFile(path).finish("", "")
    assert [file.name for file in tmp_path.iterdir() if not file.name.startswith(".")] == ["run.html"]
