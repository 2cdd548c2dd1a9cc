"""Measure the figures in docs/accuracy.md, and write its tables: `make accuracy-page [DATA=../shared/data]`.

The tool runs the accuracy benchmark on each folder of DATA that has a truth.csv, with and without the compass, into
build/measured, then replaces the marked blocks of docs/accuracy.md. Blocks without figures stay unchanged;
build/simulated.json, build/skyline.json and build/views.json come from `make bench-simulated`, `make bench-skyline` and
`make bench-views`. With --write-only nothing is measured.
"""

from __future__ import annotations

import argparse
import json
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "accuracy.md"
MEASURED = ROOT / "build" / "measured"
BLOCK = re.compile(r"(<!-- begin: ([\w-]+) -->\n).*?(<!-- end -->)", re.DOTALL)
COMPASS = ("ignore", "prior")
LIMITS = ("< 0.5", "< 1", "< 1.5", "< 3")
SHARES = (
    *("photos", "< 0.2°", "< 0.5°", "< 1°", "< 3°", "accepted", "of these wrong by 3° or more"),
    *("90 % interval holds the truth", "the same of accepted ones"),
)


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", type=Path, nargs="?", default=ROOT.parent / "shared" / "data")
    parser.add_argument("--write-only", action="store_true", help="do not measure, only renew the page")
    given = parser.parse_args(arguments)
    if not given.write_only:
        measure(given.data)
    PAGE.write_text(filled(PAGE.read_text(encoding="utf-8"), tables()), encoding="utf-8")


def measure(data):
    """Run the accuracy benchmark on each folder."""
    MEASURED.mkdir(parents=True, exist_ok=True)
    for folder in sorted(path.parent for path in data.glob("*/truth.csv")):
        for compass in COMPASS:
            target = MEASURED / f"{folder.name}-{compass}.json"
            command = [sys.executable, ROOT / "benchmarks" / "bench_accuracy.py", folder, "--compass", compass]
            command += ["--output", target] + (["--no-paper"] if compass == "prior" else [])
            subprocess.run(command, check=True, stdin=subprocess.DEVNULL)


def tables():
    """Return the text of each block that has figures."""
    reports = {path.stem: json.loads(path.read_text(encoding="utf-8")) for path in sorted(MEASURED.glob("*.json"))}
    blocks = {}
    if reports:
        blocks["real"] = real_table(reports)
        blocks["photos"] = photo_table(reports)
    for name, table in (("simulated", simulated_tables), ("skyline", skyline_table), ("views", views_tables)):
        path = ROOT / "build" / f"{name}.json"
        if path.exists():
            blocks[name] = table(json.loads(path.read_text(encoding="utf-8")))
    found = [ROOT / "build" / f"regions-{compass}.json" for compass in COMPASS]
    if all(path.exists() for path in found):
        blocks["regions"] = regions_table([json.loads(path.read_text(encoding="utf-8")) for path in found])
    return blocks


def regions_table(reports):
    """Table of `bench_regions.py`, without and with the compass."""
    words = {"ignore": "blind", "prior": "compass as a hint"}
    limits = ("< 0.5", "< 1", "< 1.5", "< 3", "< 10")
    head = (
        "region",
        "",
        "good photos",
        *(f"{limit}°" for limit in limits),
        "accepted",
        "of these wrong by more than 3°",
    )
    rows = []
    for report in reports:
        for region, found in report["regions"].items():
            counts = [found[key] for key in ("photos", *limits, "accepted", "of these wrong", "interval holds")]
            held = f"{counts[-1]} of {counts[-3]}"
            hard = f"{found['hard accepted']} of {found['hard']}"
            rows.append([region, words[report["compass"]], *counts[:-1], held, hard])
    return table_of([*head, "interval of these holds the truth", "photos without a usable skyline accepted"], rows)


def filled(text, blocks):
    """Replace the given blocks of a text."""
    return BLOCK.sub(
        lambda m: m.group(1) + blocks[m.group(2)] + m.group(3) if m.group(2) in blocks else m.group(0), text
    )


def table_of(head, rows):
    """Return the lines of a Markdown table."""
    lines = [head, ["---"] * len(head), *rows]
    return "".join("| " + " | ".join(map(str, line)) + " |\n" for line in lines)


def real_table(reports):
    """Tabulate the good photographs per folder and use of the compass, with the published method and the compass."""
    rows = []
    for name, report in reports.items():
        known = [p for p in report["photos"] if p["truth_deg"] is not None and p["group"] == "good"]
        folder, _, compass = name.rpartition("-")
        label = "robust, blind" if compass == "ignore" else "robust, compass as a hint"
        rows.append([folder, label, *counts(known, "error_deg"), *verdicts(known)])
        if compass == "ignore":
            rows.append([folder, "paper's method", *counts(known, "paper_error_deg"), "", "", ""])
            recorded = [photo for photo in known if photo["compass_error_deg"] is not None]
            if recorded:
                rows.append([folder, "compass alone", *counts(recorded, "compass_error_deg"), "", "", ""])
    head = ["photographs", "method", "good", *(f"{limit}°" for limit in LIMITS), "median", "accepted"]
    return table_of([*head, "of these wrong by 3° or more", "90 % interval holds the truth"], rows)


def counts(photos, key):
    """Return the number of photographs, the numbers within the limits, and the median error."""
    errors = sorted(abs(photo[key]) for photo in photos if photo[key] is not None)
    within = [sum(error < float(limit[2:]) for error in errors) for limit in LIMITS]
    errors += [float("inf")] * (len(photos) - len(errors))
    middle = errors[len(errors) // 2] if errors else float("inf")
    if errors and len(errors) % 2 == 0:
        middle = (middle + errors[len(errors) // 2 - 1]) / 2
    return [len(photos), *within, f"{middle:.2f}°" if middle < 1e9 else "none"]


def verdicts(photos):
    """Count accepted answers, accepted wrong answers, and intervals that contain the truth."""
    accepted = [photo for photo in photos if photo["status"] == "accepted"]
    wrong = sum(abs(photo["error_deg"]) >= 3 for photo in accepted)
    covered = [photo["covered"] for photo in photos if photo["covered"] is not None]
    return [len(accepted), wrong, f"{sum(covered)} of {len(covered)}"]


def photo_table(reports):
    """Tabulate the answers without the compass, photo by photo."""
    rows = []
    for name, report in reports.items():
        if not name.endswith("-ignore"):
            continue
        for photo in report["photos"]:
            sure = photo["p_correct"]
            rows.append(
                [
                    f"{name.rpartition('-')[0]}, {photo['group']}",
                    photo["photo"],
                    photo["status"],
                    signed(photo["error_deg"]),
                    "" if sure is None else f"{sure:.2f}",
                    signed(photo.get("paper_error_deg")),
                    signed(photo["compass_error_deg"]),
                ]
            )
    return table_of(["group", "photo", "status", "error", "`p_correct`", "paper's method", "compass"], rows)


def signed(value):
    """Format degrees with a sign, or None as a dash."""
    return "–" if value is None else f"{value:+.2f}°"


def simulated_tables(report):
    """Tabulate levels and kinds of weather, then predicted and observed correctness."""
    summary = report["summary"]
    rows = []
    for name, row in [*summary["levels"].items(), *summary["full_by"].items(), ("all pictures", summary["images"])]:
        if not row["photos"] or Path(name).suffix:  # figures by DEM are for developers only
            continue
        label = name if name in summary["levels"] or name == "all pictures" else f"full, {name}"
        rows.append([label, *shares(row)])
    return table_of(["scenes", *SHARES], rows) + "\n" + promise_table(summary["reliability"])


def views_tables(report):
    """Tabulate views cut from real photographs by folder, then predicted and observed correctness."""
    rows = [[name, *shares(row)] for name, row in report["summary"].items()]
    return table_of(["views from", *SHARES], rows) + "\n" + promise_table(report["reliability"])


def shares(row):
    """Return the cells under `SHARES` for one row of `bench_simulated.accuracy`."""
    within = [f"{100 * row[f'within_{limit}']:.0f} %" for limit in ("0.2", "0.5", "1", "3")]
    cover, sure = (
        "–" if row[key] is None else f"{100 * row[key]:.0f} %" for key in ("coverage_90", "coverage_90_accepted")
    )
    return [row["photos"], *within, f"{100 * row['accepted']:.0f} %", row["accepted_wrong"], cover, sure]


def promise_table(reliability):
    """Tabulate predicted p_correct against observed correctness."""
    kept = [
        [f"{r['from']:.2f} to {r['to']:.2f}", r["photos"], f"{r['promised']:.2f}", f"{r['kept']:.2f}"]
        for r in reliability
    ]
    return table_of(["`p_correct`", "photos", "mean promise", "share within 3°"], kept)


def skyline_table(report):
    """Tabulate the vertical errors of both methods' skylines."""
    names = (
        ("median_of_medians_px", "median of the images' medians", "{:.1f} px"),
        ("mean_of_medians_px", "mean of the images' medians", "{:.1f} px"),
        ("images_below_1_percent", "images with a median below 1 % of the height", "{:.0f} %"),
        ("columns_below_1_percent", "columns below 1 %", "{:.0f} %"),
        ("columns_below_3_percent", "columns below 3 %", "{:.0f} %"),
        ("mean_seconds", "CPU time per image", "{:.2f} s"),
    )
    both = report["summary"]
    rows = []
    for key, label, form in names:
        factor = 100 if "%" in form else 1
        rows.append([label, *(form.format(factor * both[method][key]) for method in ("robust", "paper"))])
    unseen = sum(image["cross_validated"] for image in report["images"])
    rows.append(["images scored by weights that never saw them", f"{unseen} of {len(report['images'])}", "no weights"])
    return table_of(["", "robust", "paper"], rows)


if __name__ == "__main__":
    main()
