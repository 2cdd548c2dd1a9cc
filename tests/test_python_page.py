"""docs/python.md: its Python runs from top to bottom as one script, its commands run in a shell."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from fenced import fenced_blocks

pytest.importorskip("osgeo.gdal")
ROOT = Path(__file__).resolve().parent.parent
BLOCKS = fenced_blocks(ROOT / "docs" / "python.md")
ENVIRONMENT = {**os.environ, "PYTHONPATH": str(ROOT / "build" / "plugins")}


@pytest.fixture
def folder(scene, tmp_path):
    """The files that the page names, and nothing else."""
    shutil.copy(scene.dem, tmp_path / "dem.tif")
    shutil.copytree(scene.folder, tmp_path / "photos")
    return tmp_path


def written(folder):
    return {path.name for path in folder.iterdir()} - {"dem.tif", "photos", "bin"}


def test_the_page_is_run_but_for_the_installation():
    assert [block.language for block in BLOCKS if not block.run] == ["bash"]
    assert sum(block.language == "python" for block in BLOCKS) >= 4
    assert {block.language for block in BLOCKS} == {"python", "bash"}


def test_the_python_runs_from_top_to_bottom(folder):
    script = "import sys; sys.modules['qgis'] = None\n"
    script += "\n".join(block.code for block in BLOCKS if block.language == "python")
    done = subprocess.run(
        [sys.executable, "-c", script], cwd=folder, env=ENVIRONMENT, capture_output=True, text=True, timeout=600
    )
    assert done.returncode == 0, done.stderr
    assert written(folder) == {"overlay.png", "photos.gpkg", "report.html", "seen.tif"}
    first, second = done.stdout.splitlines()[:2]
    assert first.startswith("accepted ") and second.startswith("<OrientedPhoto north.jpg: accepted, heading ")


def test_the_ten_lines_are_ten():
    block = next(block for block in BLOCKS if block.language == "python")
    assert len([line for line in block.code.splitlines() if line]) <= 10


@pytest.mark.skipif(os.name == "nt", reason="the page's commands are for a POSIX shell")
def test_the_commands_run(folder):
    (folder / "bin").mkdir()
    command = folder / "bin" / "skyline-viewshed"
    command.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m skyline_viewshed "$@"\n')
    command.chmod(0o755)
    environment = {**ENVIRONMENT, "PATH": f"{command.parent}{os.pathsep}{ENVIRONMENT['PATH']}"}
    for block in BLOCKS:
        if block.language == "bash" and block.run:
            script = ["bash", "-euo", "pipefail", "-c", block.code]
            done = subprocess.run(script, cwd=folder, env=environment, capture_output=True, text=True, timeout=600)
            assert done.returncode == 0, f"{block}: {done.stderr}"
    made = {"photos.gpkg", "report.html", "seen", "north.csv", "horizon.csv", "around.tif"}
    assert written(folder) == made
    assert sorted(path.name for path in (folder / "seen").iterdir()) == ["north.tif", "west.tif"]
