"""Photographs of a camera whose compass is lost, made from those of the scene: `from misled import misled_photos`."""

from __future__ import annotations

from dataclasses import replace

from skyline_viewshed.core.io.photo import read_photo
from skyline_viewshed.core.io.write_photo import write_photo

CAMERA = "Lost Phone"
ERRORS_DEG = (75.0, 140.0, -110.0, 50.0)


def misled_photos(scene, folder, errors_deg=ERRORS_DEG):
    """Write photographs, north and west in turn, whose compasses are off by `errors_deg`; their paths."""
    folder.mkdir(exist_ok=True)
    paths = []
    for number, error in enumerate(errors_deg):
        name = ("north", "west")[number % 2]
        photo = read_photo(str(scene.folder / f"{name}.jpg"))
        reading = (scene.truth[name].heading_deg + error) % 360
        metadata = replace(photo.metadata, compass_heading_deg=reading, compass_reference="T", camera=CAMERA)
        path = folder / f"{number}_{name}.jpg"
        write_photo(str(path), photo.pixels, metadata)
        paths.append(str(path))
    return paths
