"""The scene's photograph to the west at night, with the moon in its frame: `from moonlit import moonlit_photo`."""

from __future__ import annotations

from dataclasses import replace
from datetime import datetime, timedelta

from skyline_viewshed.core.base.camera import Camera, focal_from_35mm_px, project
from skyline_viewshed.core.base.sun_moon import direction_deg
from skyline_viewshed.core.io.photo import read_photo
from skyline_viewshed.core.io.write_photo import write_photo

ZONE_H = -7


def moonlit_photo(scene, folder):
    """Write west.jpg with such a time into a folder; return its path and the moon's pixel."""
    photo, place = read_photo(str(scene.folder / "west.jpg")), scene.positions["west"]
    width, height = photo.metadata.width_px, photo.metadata.height_px
    camera = Camera(width, height, focal_from_35mm_px(width, height, photo.metadata.focal_length_35mm))
    for hour in range(24 * 60):
        when = datetime(2024, 1, 1) + timedelta(hours=hour)
        x, y = project(camera, scene.truth["west"], *direction_deg("moon", *place, when))
        if 0 <= x < width and 0 <= y < height / 2 and direction_deg("sun", *place, when)[1] < -5:
            break
    else:
        raise AssertionError("the moon is never in the picture")
    path = str(folder / "west.jpg")
    clock = when + timedelta(hours=ZONE_H)
    write_photo(path, photo.pixels, replace(photo.metadata, taken_at=clock, utc_offset_s=3600.0 * ZONE_H))
    return path, float(x), float(y)
