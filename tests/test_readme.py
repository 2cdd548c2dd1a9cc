"""The README's commands, run as a newcomer would type them, in the checkout."""

from __future__ import annotations

from pathlib import Path

import pytest
from examples import run_block
from fenced import fenced_blocks

ROOT = Path(__file__).resolve().parent.parent
BLOCKS = fenced_blocks(ROOT / "README.md")


def test_every_command_is_run_or_says_why_not():
    assert any("make demo" in block.code for block in BLOCKS if block.run)
    for block in BLOCKS:
        assert block.language == "bash" or not block.run, str(block)


@pytest.mark.qgis
@pytest.mark.parametrize("block", [block for block in BLOCKS if block.run], ids=str)
def test_the_command_works(block):
    done = run_block(block)
    assert done.returncode == 0, done.stdout + done.stderr
    for line in block.code.split():
        name, _, path = line.partition("=")
        if name in ("OUTPUT", "POLYGONS", "VIEWSHED", "REPORT"):
            assert (ROOT / path).stat().st_size > 0, path


@pytest.mark.qgis
def test_the_demo_finds_headings_near_the_truth():
    """What `make demo` prints: most photographs within half a degree, and no accepted one wrong."""
    shown = [block for block in BLOCKS if block.run and "make demo" in block.code]
    lines = [line.split() for line in run_block(shown[0]).stdout.splitlines() if " to " in line]
    assert len(lines) == 4
    errors = {words[0]: (words[1], abs(float(words[4]))) for words in lines}
    assert sum(error < 0.5 for _, error in errors.values()) >= 3, errors
    assert all(error < 3 for status, error in errors.values() if status == "accepted"), errors
