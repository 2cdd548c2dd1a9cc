"""Runs of the whole pipeline in a separate process, shared by tests of the files that they leave behind."""

from __future__ import annotations

import os
import signal
from pathlib import Path

import pytest

PLAIN = {**os.environ, "PYTHONPATH": str(Path(__file__).resolve().parent.parent / "build" / "plugins")}
"""Environment in which a plain Python finds the package."""


def outputs_in(folder):
    """Outputs of `photoviewshed` in a folder."""
    return {
        "OUTPUT": folder / "points.gpkg",
        "POLYGONS": folder / "ground.gpkg",
        "VIEWSHED": folder / "viewshed.tif",
        "REPORT": folder / "report.html",
        "RASTERS": folder / "rasters",
        "ORIENTATIONS": folder / "orientations",
    }


def arguments(photos, dem, outputs):
    """Arguments of a `qgis_process` call."""
    given = {"FOLDER": photos, "DEM": dem, "MAX_DISTANCE": 8000, **outputs}
    pairs = [f"{name}={value}" for name, value in given.items()]
    return ["run", "skylineviewshed:photoviewshed", "--", *pairs]


def rows_of(path):
    """Attributes of all features of a layer; none if there is no layer."""
    ogr = pytest.importorskip("osgeo.ogr")
    source = ogr.Open(str(path))
    return [feature.items() for feature in source.GetLayer(0)] if source and source.GetLayerCount() else []


def as_from_a_terminal():
    """Undo a shell's settings for background jobs, in which these tests may run: such jobs ignore SIGINT."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
