"""Run mypy and compare its errors with tools/mypy_baseline.txt, which may only shrink.

Usage: check_types.py [--renew]

An error that the baseline does not know fails and is printed. Errors that are gone fail as well, until `--renew` has
taken them out of the baseline; `--renew` never adds any. Errors are counted per file and mypy code, so that moving
lines changes nothing. `core/base`, `core/api.py` and `core/cli.py` are checked strictly (pyproject.toml) and have no
baseline.

NumPy's own annotations differ between its versions. With a mypy or NumPy other than those that the baseline names, only
the strict modules are enforced; `--renew` then writes a new baseline for these versions.
"""

from __future__ import annotations

import argparse
import re
import subprocess
import sys
from collections import Counter
from importlib.metadata import version
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BASELINE = ROOT / "tools" / "mypy_baseline.txt"
PREFIX = "build/plugins/skyline_viewshed/"
"""Where mypy sees the package under its own name; `make link` sets the link."""
STRICT = re.compile(r"core/(base/.*|api|cli)\.py$")
ERROR = re.compile(r"(?P<file>[^:]+\.py):\d+(?::\d+)?: error: .*\[(?P<code>[\w-]+)\]$")


def errors_of(output):
    """Group mypy's error lines by (file, code)."""
    found = {}
    for line in output.replace("\\", "/").replace(PREFIX, "").splitlines():
        match = ERROR.match(line)
        if match:
            found.setdefault((match["file"], match["code"]), []).append(line)
    return found


def counts_of(errors):
    """Count the errors that a baseline may hold: all outside the strict modules."""
    return Counter({key: len(lines) for key, lines in errors.items() if not STRICT.match(key[0])})


def read_baseline(text):
    """Split a baseline into its versions (first line) and its counts by (file, code)."""
    head, *lines = text.splitlines()
    counts = Counter()
    for line in lines:
        count, file, code = line.split()
        counts[file, code] = int(count)
    return head.removeprefix("# "), counts


def baseline_text(versions, counts):
    """Write a baseline: the versions, then a line per file and code."""
    lines = [f"{count} {file} {code}" for (file, code), count in sorted(counts.items())]
    return "\n".join([f"# {versions}", *lines]) + "\n"


def compare(errors, baseline, same_versions):
    """Hold mypy's errors against a baseline.

    Parameters
    ----------
    errors : dict
        As `errors_of` gives them.
    baseline : Counter
        Allowed errors by (file, code).
    same_versions : bool
        The baseline was made with this mypy and this NumPy.

    Returns
    -------
    new, gone : list of str
        Lines to print: errors above the baseline, and entries of the baseline that have fewer errors by now.
    """
    counts = counts_of(errors)
    new = [line for (file, _), lines in errors.items() if STRICT.match(file) for line in lines]
    if not same_versions:
        return new, []
    for key, count in sorted(counts.items()):
        if count > baseline[key]:
            new += [f"{key[0]}: {count} errors [{key[1]}], {baseline[key]} allowed:", *errors[key]]
    gone = [
        f"{file}: {counts[file, code]} errors [{code}], {allowed} in the baseline"
        for (file, code), allowed in sorted(baseline.items())
        if counts[file, code] < allowed
    ]
    return new, gone


def versions_here():
    """Versions that decide which errors there are."""
    return f"mypy {version('mypy')}, NumPy {'.'.join(version('numpy').split('.')[:2])}"


def run_mypy():
    """Output of mypy over the files that pyproject.toml names."""
    command = [sys.executable, "-m", "mypy", "--no-error-summary", "--hide-error-context", "--no-pretty"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    if done.returncode not in (0, 1) or done.stderr:
        raise SystemExit(f"mypy itself failed:\n{done.stdout}{done.stderr}")
    return done.stdout


def check(output, versions, renew=False, path=BASELINE):
    """Compare mypy's output with the baseline file, print what is wrong, and return the exit code.

    Parameters
    ----------
    output : str
        What mypy printed.
    versions : str
        As `versions_here` gives them.
    renew : bool
        Write what is left into the baseline if nothing was added to it.
    path : Path
        The baseline.
    """
    made_with, baseline = read_baseline(path.read_text(encoding="utf-8"))
    errors = errors_of(output)
    new, gone = compare(errors, baseline, made_with == versions)
    if new:
        print(*new, sep="\n")
        print("New type errors. Mend them; the baseline does not grow.")
        return 1
    if renew:
        path.write_text(baseline_text(versions, counts_of(errors)), encoding="utf-8")
        print(f"{path.name}: {sum(counts_of(errors).values())} errors left.")
        return 0
    if gone:
        print(*gone, sep="\n")
        print("Fewer type errors than before. Run: python tools/check_types.py --renew, and commit the baseline.")
        return 1
    if made_with != versions:
        print(
            f"Types: the baseline is of {made_with}, here is {versions}; "
            "only core/base, core/api.py and core/cli.py were enforced."
        )
    return 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--renew", action="store_true", help="take errors that are gone out of the baseline")
    sys.exit(check(run_mypy(), versions_here(), parser.parse_args().renew))
