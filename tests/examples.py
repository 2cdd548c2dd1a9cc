"""Run the examples of README and docs as a reader would: in the checkout, in a separate shell."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
OURS = ("PYTHONPATH", "MAKEFLAGS", "MAKELEVEL", "MFLAGS", "QGIS_PLUGINPATH", "QGIS_CUSTOM_CONFIG_PATH", "PHOTOS", "DEM")
"""Variables of this test run that a reader's shell does not have."""

_FINISHED = {}
"""Blocks that have run, by their code: an example that appears twice runs once."""


def need_sample():
    """Make the sample of `make demo` if it is missing, or skip if there is nothing to make it with."""
    if not (ROOT / ".venv" / ".skyline-setup").exists() or shutil.which("make") is None:
        pytest.skip("the examples begin with make, and make setup has not been run here")
    folder = ROOT / "build" / "demo" / "sample"
    if not (folder / "truth.csv").exists():
        subprocess.run([sys.executable, ROOT / "tools" / "make_sample.py", folder], check=True, cwd=ROOT)


def run_block(block):
    """Run a fenced block, with the sample in place, and return the finished process."""
    need_sample()
    if block.code not in _FINISHED:
        _FINISHED[block.code] = _run(block)
    return _FINISHED[block.code]


def _run(block):
    environment = {key: value for key, value in os.environ.items() if key not in OURS}
    code = block.code
    if block.language == "python":
        script = ROOT / "build" / "example.py"
        script.write_text(code, encoding="utf-8")
        code = f'eval "$(make env)"\n.venv/bin/python {script.relative_to(ROOT)}'
    command = ["bash", "-euo", "pipefail", "-c", code]
    return subprocess.run(
        command, cwd=ROOT, env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=900
    )
