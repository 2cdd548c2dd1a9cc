"""Plain `pytest` works without make: tests/conftest.py sets what NumPy, QGIS and our package need."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent


def pytest_in_a_clean_environment(*arguments):
    environment = {name: os.environ[name] for name in ("HOME", "PATH", "SYSTEMROOT") if name in os.environ}
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *arguments]
    return subprocess.run(
        command, cwd=ROOT, env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=300
    )


def test_a_test_of_the_core_runs_without_any_variable():
    done = pytest_in_a_clean_environment("tests/core/base/test_angles.py")
    assert done.returncode == 0, done.stdout + done.stderr
    assert "10 passed" in done.stdout


@pytest.mark.qgis
def test_a_test_of_the_shell_runs_without_any_variable():
    pytest.importorskip("qgis.core")
    done = pytest_in_a_clean_environment("tests/algorithms/test_tooltips.py")
    assert done.returncode == 0, done.stdout + done.stderr
    assert "2 passed" in done.stdout
