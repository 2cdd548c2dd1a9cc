"""Run the engine once as a whole process, as `bench_speed` measures it: open the DEM, compute, write.

Usage: python engine_run.py horizon|circle|wedge|packed DEM X Y RADIUS_M OUTPUT [START_DEG END_DEG]
"""

from __future__ import annotations

import sys

from skyline_viewshed.core.base.terrain import Observer
from skyline_viewshed.core.io.crs import to_wgs84
from skyline_viewshed.core.io.raster import open_dem

REFRACTION = 1.0 / 7.0


def horizon(dem, observer, radius_m, output):
    """Compute the horizon and write it as a table."""
    from skyline_viewshed.core.horizon.horizon import (  # each task imports only what it needs, as in QGIS
        HorizonOptions,
        horizon_profile,
    )

    options = HorizonOptions(max_distance_m=radius_m, refraction_coefficient=REFRACTION)
    profile = horizon_profile(dem, observer, options)
    columns = profile.azimuth_deg, profile.elevation_deg, profile.distance_m, profile.clipped
    with open(output, "w", encoding="ascii") as file:
        file.writelines(
            "{:.4f},{:.4f},{:.4f},{:d}\n".format(*row) for row in zip(*(column.tolist() for column in columns))
        )


def ground(dem, observer, radius_m, output, wedge, packed):
    """Compute the viewshed as a raster; packed, it has more cells than fit into memory as bytes, and is not written."""
    from skyline_viewshed.core.base.viewed import ArraySink
    from skyline_viewshed.core.io.write_raster import RasterLayout, write_raster
    from skyline_viewshed.core.viewshed.viewshed import (
        FullCircle,
        PackedSink,
        ViewshedOptions,
        Wedge,
        viewshed,
    )

    sector = FullCircle()
    if wedge:
        start, end = map(float, wedge)
        sector = Wedge((start + (end - start) % 360 / 2) % 360, (end - start) % 360)
    options = ViewshedOptions(max_distance_m=radius_m, refraction_coefficient=REFRACTION)
    result = viewshed(dem, observer, sector, options, sink=PackedSink if packed else ArraySink)
    if not packed:
        write_raster(output, result.values, dem, result.window, RasterLayout(nodata=255))


def main(task, path, x, y, radius_m, output, *wedge):
    dem = open_dem(path)
    longitude, latitude = to_wgs84(dem.crs_wkt, float(x), float(y))
    observer, radius_m = Observer(float(longitude), float(latitude), 1.7), float(radius_m)
    if task == "horizon":
        horizon(dem, observer, radius_m, output)
    else:
        ground(dem, observer, radius_m, output, wedge, task == "packed")


if __name__ == "__main__":
    main(*sys.argv[1:])
