"""Orient the demo's photographs as points for the pictures of the Photo view.

Usage: panel_points.py SAMPLE TARGET.gpkg
"""

from __future__ import annotations

import sys
from pathlib import Path

import skyline_viewshed as sv


def main(sample, target):
    dem = sv.open_dem(sample / "dem" / "mountains.tif")
    sv.save_points(sv.orient_many(sample / "photos", dem), target)


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
