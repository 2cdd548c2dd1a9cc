"""Determine how many metres one unit of a DEM's values has, from the choice of the user or the file itself."""

from __future__ import annotations

import json
import os
import re
from math import isfinite

from ..base.errors import UnusableDemError
from ..base.messages import Message
from .crs import spatial_reference
from .gdal_quiet import quiet_gdal

FOOT, SURVEY_FOOT = 0.3048, 1200 / 3937

SPELLINGS = {
    1.0: "m mtr metre meter metres meters msl masl gpm metermsl 9001",
    FOOT: "ft foot feet fts international foot ft_i foot_international 9002",
    SURVEY_FOOT: "ftus usft us_ft survey_foot us_survey_foot foot_us footus foot_us_survey ft_us sft sft_i us_foot "
    "feetus us_feet survey_feet us_survey_feet u_s_foot u_s_survey_foot u_s_feet u_s_survey_feet surveyfoot 9003",
    0.1: "dm decimetre decimeter decimetres decimeters",
    0.01: "cm centimetre centimeter centimetres centimeters 1033",
    0.001: "mm millimetre millimeter millimetres millimeters 1025",
    1000.0: "km kilometre kilometer kilometres kilometers 9036",
    0.9144: "yd yard yards international_yard yd_i 9096",
    1.8288: "fathom fathoms fth ftm 9014",
    0.3047972654: "clarke_s_foot clarkes_foot clarke_foot 9005",
    0.3047994715386762: "british_foot_sears_1922 9041",
    0.30480083333333: "british_foot_1865 9070",
    0.3047995102481469: "indian_foot indian_geodetic_foot 9080",
    0.304799841: "indian_foot_1937 9081",
    0.3047997101815088: "gold_coast_foot 9094",
    1.0000135965: "german_legal_metre german_legal_meter 9031",
}
"""Spellings of units, as GDAL, PROJ, EPSG, UCUM (GeoPackage) and GRIB write them, by metres per unit."""

METRES_PER_UNIT = {word.replace("_", ""): factor for factor, words in SPELLINGS.items() for word in words.split()}

UNKNOWN = ("", "none", "unknown", "na", "nil", "null", "unitless", "1", "height", "elevation", "unspecified")
"""Spellings of no unit."""


def metres_per_unit(dataset, band, crs_wkt, chosen=None):
    """Give the metres per unit of the values of a DEM.

    Parameters
    ----------
    dataset : osgeo.gdal.Dataset
    band : osgeo.gdal.Band
    crs_wkt : str
        CRS of the DEM; a vertical unit of it counts if the band has none.
    chosen : str, float or None
        What the user says: the name of a unit, or metres per unit. None means that of the file.

    Raises
    ------
    UnusableDemError
        If the unit is not known or is not that of a length.
    """
    if chosen is not None:
        return _chosen(chosen)
    unit = band.GetUnitType() or ""
    word = _plain(unit)
    if word in METRES_PER_UNIT:
        return METRES_PER_UNIT[word]
    first = _plain(re.split(r"[\s(,;]", unit.strip(), maxsplit=1)[0])
    if word not in UNKNOWN and first in METRES_PER_UNIT:  # "metre (EGM96)", "m above mean sea level"
        return METRES_PER_UNIT[first]
    if word not in UNKNOWN:  # degrees, percent, geopotential, ...
        raise UnusableDemError(
            Message(
                "The values of the DEM are in {unit}, which is not a unit of height that is known here. Choose an "
                "elevation raster, or set the unit of its heights (DEM_UNIT).",
                unit=repr(unit),
            )
        )
    return _of_sidecar(dataset) or _vertical(crs_wkt) or _vertical_of_file(dataset) or 1.0


def _chosen(unit):
    try:
        factor = float(unit)
    except ValueError:
        factor = METRES_PER_UNIT.get(_plain(unit), float("nan"))
    if not (isfinite(factor) and factor > 0):
        raise UnusableDemError(
            Message(
                "The unit of heights {unit} is not known. Give metres, feet, us-ft, dm, cm, km or a number of metres.",
                unit=repr(unit),
            )
        )
    return factor


def _plain(text):
    """Reduce a spelling to lower-case letters and digits, so that 'US_survey foot' and 'ussurveyfoot' are the same."""
    return re.sub(r"[^a-z0-9%°]", "", text.lower())


def _vertical(crs):
    """Give the metres per unit of the vertical axis of a CRS, compound or of three dimensions; None without one."""
    try:
        with quiet_gdal():
            tree = json.loads(spatial_reference(crs).ExportToPROJJSON())
    except (AttributeError, RuntimeError, ValueError, TypeError):  # GDAL before 3.1, or a CRS that PROJ cannot express
        return None
    return _vertical_of_tree(tree)


def _vertical_of_tree(tree):
    for part in (*tree.get("components", ()), tree.get("source_crs"), tree.get("base_crs"), tree):
        for axis in ((part or {}).get("coordinate_system") or {}).get("axis", ()):
            if axis.get("direction") in ("up", "down"):
                unit = axis.get("unit", "metre")
                if isinstance(unit, dict):
                    return float(unit["conversion_factor"])
                return METRES_PER_UNIT.get(_plain(unit))
    return None


def _vertical_of_file(dataset):
    """Give the same for the file's own CRS, whose heights stay what they are if another CRS is assigned."""
    reference = dataset.GetSpatialRef()
    return None if reference is None else _vertical(reference.ExportToWkt())


def _of_sidecar(dataset):
    """Give the unit in Esri's old .prj beside a grid (Zunits: a name, or units per metre), which GDAL ignores."""
    for path in dataset.GetFileList() or ():
        if not path.lower().endswith("prj.adf") and os.path.splitext(path)[1].lower() != ".prj":
            continue
        try:
            with open(path, encoding="latin-1") as file:
                found = re.search(r"^\s*zunits\s+(\S+)", file.read(10_000), re.IGNORECASE | re.MULTILINE)
        except OSError:
            continue
        if found:
            word = _plain(found[1])
            return METRES_PER_UNIT.get(word) or (1 / int(word) if word.isdigit() and int(word) else None)
    return None
