"""Which Python runs workers, and how many there are."""

from __future__ import annotations

import os
import sys

import pytest
from skyline_viewshed.core.workers.interpreter import WORKER_BYTES, interpreters, worker_count


def files(folder, *names):
    for name in names:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text("")
    return folder


def test_this_python_comes_first():
    assert interpreters()[0] == sys.executable


def test_on_windows_qgis_itself_is_never_started(tmp_path):
    root = files(
        tmp_path, "bin/qgis-bin.exe", "bin/python3.exe", "apps/Python312/python.exe", "apps/Python312/pythonw.exe"
    )
    found = interpreters(str(root / "bin/qgis-bin.exe"), [str(root / "apps/Python312"), str(root)], windows=True)
    assert str(root / "apps/Python312/python.exe") in found and str(root / "bin/python3.exe") in found
    assert all(os.path.basename(path).startswith("python") for path in found)


def test_on_macos_the_bundles_python_is_found(tmp_path):
    root = files(tmp_path, "QGIS.app/Contents/MacOS/QGIS", "QGIS.app/Contents/MacOS/bin/python3")
    found = interpreters(str(root / "QGIS.app/Contents/MacOS/QGIS"), [], windows=False)
    assert found == [str(root / "QGIS.app/Contents/MacOS/bin/python3")]


def test_where_there_is_none_the_list_is_empty(tmp_path):
    root = files(tmp_path, "qgis")
    assert interpreters(str(root / "qgis"), [str(tmp_path)], windows=False) == []
    assert interpreters("", [], windows=False) == []


@pytest.mark.parametrize(
    "wanted, tasks, cores, free, count",
    [
        (0, 100, 8, 100 * WORKER_BYTES, 7),
        (0, 100, 8, 3.5 * WORKER_BYTES, 3),
        (0, 100, 8, 0, 1),
        (0, 3, 8, None, 1),
        (0, 5, 8, None, 5),
        (0, 100, 1, None, 1),
        (1, 100, 8, None, 1),
        (4, 2, 1, 0, 2),
        (4, 0, 8, None, 1),
    ],
)
def test_number_of_workers(wanted, tasks, cores, free, count):
    free = WORKER_BYTES * 1000 if free is None else free
    assert worker_count(wanted, tasks, cores, free) == count
