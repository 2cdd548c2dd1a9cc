"""Summits in an OpenStreetMap extract (.osm, .osm.pbf) that the user has; nothing is fetched."""

from __future__ import annotations

import tempfile
from pathlib import Path

from osgeo import gdal

from ..base.errors import SkylineViewshedError
from ..base.messages import Message
from .gdal_quiet import quiet_gdal

SUFFIXES = (".osm", ".pbf")

# GDAL's own configuration leaves the height (ele) out.
CONFIGURATION = """[points]
osm_id=yes
attributes=name,natural,ele
"""


def is_extract(path):
    """Tell whether a file is an OpenStreetMap extract, by its name."""
    return str(path).lower().endswith(SUFFIXES)


def read_summits(path):
    """Read the named nodes with natural=peak or natural=volcano.

    Parameters
    ----------
    path : str

    Returns
    -------
    list of (str, float, float, str or None)
        Name, longitude and latitude [degrees], and the height as it is tagged.

    Raises
    ------
    SkylineViewshedError
    """
    with tempfile.TemporaryDirectory(prefix="skyline-") as folder, quiet_gdal() as messages:
        configuration = Path(folder) / "osmconf.ini"
        configuration.write_text(CONFIGURATION, encoding="ascii")
        options = [f"CONFIG_FILE={configuration}"]
        try:
            dataset = gdal.OpenEx(str(path), gdal.OF_VECTOR, allowed_drivers=["OSM"], open_options=options)
            summits = None if dataset is None else _summits_of(dataset)
            del dataset
        except RuntimeError as error:
            messages.append(str(error))
            summits = None
    if messages or summits is None:
        raise SkylineViewshedError(
            Message(
                "The OpenStreetMap extract {path} cannot be read: {reason}. Download it again.",
                path=path,
                reason=messages[0] if messages else Message("it has another format"),
            )
        )
    return summits


def _summits_of(dataset):
    dataset.ExecuteSQL("SET interest_layers = points")  # ways and relations are skipped
    points = dataset.GetLayerByName("points")
    points.SetAttributeFilter("natural IN ('peak', 'volcano')")
    summits = []
    for feature in points:
        name, place = feature.GetField("name"), feature.GetGeometryRef()
        if name and place is not None:
            summits.append((name, place.GetX(), place.GetY(), feature.GetField("ele")))
    return summits
