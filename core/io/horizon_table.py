"""The horizon of a place as a table of text."""

from __future__ import annotations

import csv

from .whole_file import staged

COLUMNS = "azimuth_deg", "elevation_deg", "distance_m"


def write_horizon(horizon, path, stream):
    """Write a horizon as CSV.

    Parameters
    ----------
    horizon : HorizonProfile
    path : Path or None
        Written whole or not at all; None writes to the stream.
    stream : text stream
    """
    if path is None:
        _write(horizon, stream)
        return
    with staged(path) as folder, open(folder / path.name, "w", newline="", encoding="utf-8") as table:
        _write(horizon, table)


def _write(horizon, table):
    writer = csv.writer(table, lineterminator="\n")
    writer.writerow(COLUMNS)
    rows = zip(*(getattr(horizon, name) for name in COLUMNS))
    writer.writerows([f"{a:.4f}", f"{e:.5f}", f"{d:.1f}"] for a, e, d in rows)
