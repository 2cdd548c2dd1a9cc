"""Write points of photographs as GeoPackage, GeoJSON or CSV; a file appears complete or not at all."""

from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Any

from osgeo import ogr

from ..base.attributes import FieldSpec, Value, has_position, oriented_fields, oriented_values, photo_fields
from ..base.attributes import photo_values as values_of_metadata
from ..base.errors import PhotoError
from ..base.model import OrientedPhoto, PhotoMetadata
from .crs import WGS84, spatial_reference
from .gdal_quiet import quiet_gdal
from .photo import read_metadata
from .whole_file import staged

DRIVERS = {".gpkg": "GPKG", ".geojson": "GeoJSON", ".json": "GeoJSON", ".csv": "CSV",
           ".parquet": "Parquet"}  # fmt: skip
OPTIONS = {"GeoJSON": ["RFC7946=YES", "WRITE_NAME=NO"]}
WITHOUT_GEOMETRY = {"CSV"}
"""Drivers whose layers take no geometry; from version 3.10 on GDAL refuses features that have one."""

KINDS = {
    "text": ogr.OFTString,
    "real": ogr.OFTReal,
    "whole": ogr.OFTInteger,
    "yes": ogr.OFTInteger,
    "time": ogr.OFTDateTime,
}
LENS_FIELDS = ("hfov", "vfov")


@dataclass(frozen=True)
class PointRow:
    """A point to write.

    Attributes
    ----------
    position : (longitude, latitude, elevation) or None
        WGS 84 [degrees, degrees, m].
    values : dict
        Values by field name; missing values become NULL.
    """

    position: tuple[float, float, float] | None
    values: dict[str, Value]


def driver_of(path: str | os.PathLike) -> str:
    """Give the name of the OGR driver for a file's suffix.

    Raises
    ------
    ValueError
        If the suffix is not in `DRIVERS`.
    """
    suffix = Path(path).suffix.lower()
    if suffix not in DRIVERS:
        raise ValueError(f"{path} must end in one of {', '.join(DRIVERS)}")
    if ogr.GetDriverByName(DRIVERS[suffix]) is None:
        raise ValueError(f"{path}: this GDAL cannot write {DRIVERS[suffix]}; choose .gpkg")
    return DRIVERS[suffix]


def point_fields() -> list[FieldSpec]:
    """Give the fields of `photo_row`, as in QGIS layers: those of the photograph, then those of its orientation."""
    ours = oriented_fields()
    names = {spec.name for spec in ours}
    return [spec for spec in photo_fields() if spec.name not in names] + ours


def photo_row(oriented: OrientedPhoto, max_distance_m: float) -> PointRow:
    """Convert an oriented photograph to a point at the position that was used.

    `max_distance_m` is the search range of the run [m]. A photograph that failed keeps the values from its file.
    """
    metadata = oriented.metadata or _metadata(oriented.path)
    before = _of_path(oriented.path) if metadata is None else values_of_metadata(metadata)
    ours = oriented_values(oriented, max_distance_m)
    kept = {name: before.get(name) for name in LENS_FIELDS if ours[name] is None}
    return PointRow(_position(oriented, metadata), {**before, **ours, **kept})


def _metadata(path: str) -> PhotoMetadata | None:
    try:
        return read_metadata(path) if path else None
    except PhotoError:  # the message of the photograph already states this
        return None


def _of_path(path: str) -> dict[str, Value]:
    return {"photo": path, "filename": Path(path).stem, "directory": str(Path(path).parent)}


def _position(oriented: OrientedPhoto, metadata: PhotoMetadata | None) -> tuple[float, float, float] | None:
    altitude_m = (metadata.altitude_m if metadata else None) or 0.0
    if oriented.longitude_deg is not None and oriented.latitude_deg is not None:
        return oriented.longitude_deg, oriented.latitude_deg, altitude_m
    if metadata is not None and has_position(metadata):
        return metadata.longitude_deg, metadata.latitude_deg, altitude_m  # type: ignore[return-value]
    return None


def write_points(path: str | os.PathLike, fields: list[FieldSpec], rows: Iterable[PointRow]) -> None:
    """Write points with their attributes; the suffix of `path` decides the format.

    Parameters
    ----------
    path : str or Path
        File to write; an older file of that name is replaced once the new one is complete.
    fields : list of FieldSpec
    rows : iterable of PointRow

    Raises
    ------
    ValueError
        If the suffix is not in `DRIVERS`.
    OutputError
        If the folder is missing or read-only, the disk is full, ...
    """
    driver = ogr.GetDriverByName(driver_of(path))
    with staged(path) as folder, quiet_gdal() as messages:
        try:
            source = driver.CreateDataSource(str(folder / Path(path).name))
            name = driver.GetName()
            kind = ogr.wkbNone if name in WITHOUT_GEOMETRY else ogr.wkbPoint25D
            layer = source.CreateLayer(Path(path).stem, spatial_reference(WGS84), kind, OPTIONS.get(name, []))
            _define(layer, fields)
            layer.StartTransaction()
            for row in rows:
                _add(layer, row)
            layer.CommitTransaction()
            layer = source = None  # GDAL writes the rest; errors are only in the messages
        except (RuntimeError, AttributeError) as error:  # AttributeError: GDAL returned None
            raise OSError("; ".join(messages) or str(error)) from None
        if messages:
            raise OSError("; ".join(messages))


def _define(layer: Any, fields: list[FieldSpec]) -> None:
    for spec in fields:
        definition = ogr.FieldDefn(spec.name, KINDS[spec.kind])
        if spec.kind == "yes":
            definition.SetSubType(ogr.OFSTBoolean)
        if hasattr(definition, "SetAlternativeName"):  # from GDAL 3.2; GeoPackages store it from a later version on
            definition.SetAlternativeName(spec.alias)
        layer.CreateField(definition)


def _add(layer: Any, row: PointRow) -> None:
    feature = ogr.Feature(layer.GetLayerDefn())
    for name, value in row.values.items():
        if isinstance(value, datetime):
            feature.SetField(name, value.year, value.month, value.day, value.hour, value.minute, float(value.second), 0)
        elif value is not None:
            feature.SetField(name, value)
    if row.position is not None and layer.GetGeomType() != ogr.wkbNone:
        point = ogr.Geometry(ogr.wkbPoint25D)
        point.AddPoint(*row.position)
        feature.SetGeometry(point)
    if layer.CreateFeature(feature) != ogr.OGRERR_NONE:
        raise RuntimeError("a point could not be written")
