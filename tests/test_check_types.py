"""The comparison of mypy's errors with their baseline."""

from __future__ import annotations

import pytest
from skyline_viewshed.tools import check_types

VERSIONS = "mypy 2.0, NumPy 1.24"
OUTPUT = """\
core/match/search.py:154: error: Need type annotation for "peaks"  [var-annotated]
core/match/search.py:154: note: a note counts nothing
core/match/search.py:200:9: error: Need type annotation for "kept" (hint: "x: list[<type>]")  [var-annotated]
build/plugins/skyline_viewshed/core/io/metadata.py:138: error: Too many arguments for "_crop_factor"  [call-arg]
"""
BASELINE = """\
# mypy 2.0, NumPy 1.24
1 core/io/metadata.py call-arg
2 core/match/search.py var-annotated
"""


@pytest.fixture
def baseline(tmp_path):
    path = tmp_path / "baseline.txt"
    path.write_text(BASELINE)
    return path


def test_known_errors_pass_wherever_their_lines_have_moved(baseline):
    assert check_types.check(OUTPUT.replace(":154:", ":7:"), VERSIONS, path=baseline) == 0


@pytest.mark.parametrize("renew", [False, True])
def test_a_new_error_is_listed_and_never_enters_the_baseline(baseline, capsys, renew):
    line = 'core/io/metadata.py:9: error: Too many arguments for "other"  [call-arg]'
    assert check_types.check(f"{OUTPUT}{line}\n", VERSIONS, renew, baseline) == 1
    assert line in capsys.readouterr().out
    assert baseline.read_text() == BASELINE


def test_a_mended_error_is_no_licence_for_one_of_another_kind(baseline):
    changed = OUTPUT.replace("[call-arg]", "[arg-type]")
    assert check_types.check(changed, VERSIONS, True, baseline) == 1


def test_fewer_errors_demand_a_renewed_baseline(baseline, capsys):
    fewer = "\n".join(OUTPUT.splitlines()[1:])
    assert check_types.check(fewer, VERSIONS, path=baseline) == 1
    assert "core/match/search.py: 1 errors [var-annotated], 2 in the baseline" in capsys.readouterr().out
    assert check_types.check(fewer, VERSIONS, True, baseline) == 0
    assert check_types.check(fewer, VERSIONS, path=baseline) == 0
    assert check_types.check(OUTPUT, VERSIONS, path=baseline) == 1


@pytest.mark.parametrize("file", ["core/base/angles.py", "core/api.py", "core/cli.py"])
@pytest.mark.parametrize("versions", [VERSIONS, "mypy 2.0, NumPy 2.2"])
def test_strict_modules_have_no_baseline(baseline, file, versions):
    strict = f"{file}:3: error: Function is missing a type annotation  [no-untyped-def]\n"
    assert check_types.check(OUTPUT + strict, versions, path=baseline) == 1
    assert check_types.check(OUTPUT + strict, versions, True, baseline) == 1


def test_another_numpy_is_told_and_takes_a_baseline_of_its_own(baseline, capsys):
    other, more = "mypy 2.0, NumPy 2.2", f"{OUTPUT}core/io/exif.py:1: error: x  [operator]\n"
    assert check_types.check(more, other, path=baseline) == 0
    assert "only core/base, core/api.py and core/cli.py were enforced" in capsys.readouterr().out
    assert check_types.check(more, other, True, baseline) == 0
    assert check_types.read_baseline(baseline.read_text()) == (
        other,
        check_types.counts_of(check_types.errors_of(more)),
    )
