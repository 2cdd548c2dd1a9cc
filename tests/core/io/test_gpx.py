"""Track points of GPX files: zones, gaps in the data, and files that hold no track."""

from __future__ import annotations

import math

import pytest
from skyline_viewshed.core.io.gpx import UnreadableTrackError, read_track_points

pytest.importorskip("osgeo.ogr")
FRAME = '<?xml version="1.0"?><gpx version="1.1" creator="t" xmlns="http://www.topografix.com/GPX/1/1">{}</gpx>'


def gpx(folder, content):
    path = folder / "walk.gpx"
    path.write_text(FRAME.format(content))
    return path


def test_times_count_from_1970_in_utc_whatever_zone_the_file_uses(tmp_path):
    times = ("2023-10-31T03:00:00Z", "2023-10-31T08:45:00+05:45", "2023-10-31T00:00:00.5-03:00")
    points = "".join(f'<trkpt lat="27.9" lon="86.{k}"><time>{time}</time></trkpt>' for k, time in enumerate(times))
    time_s, longitude, latitude, elevation = read_track_points(gpx(tmp_path, f"<trk><trkseg>{points}</trkseg></trk>"))
    assert time_s == [1_698_721_200.0, 1_698_721_200.0, 1_698_721_200.5]
    assert longitude == [86.0, 86.1, 86.2] and latitude == [27.9] * 3 and all(map(math.isnan, elevation))


def test_points_without_time_or_elevation_are_kept_as_unknown(tmp_path):
    points = '<trkpt lat="1" lon="2"><ele>30.5</ele></trkpt><trkpt lat="3" lon="4"/>'
    time_s, _, _, elevation = read_track_points(gpx(tmp_path, f"<trk><trkseg>{points}</trkseg></trk>"))
    assert all(map(math.isnan, time_s)) and elevation[0] == 30.5 and math.isnan(elevation[1])


@pytest.mark.parametrize("content", [None, FRAME.format(""), FRAME.format('<wpt lat="1" lon="2"/>'), "no XML"])
def test_a_file_without_track_points_is_named(tmp_path, content):
    path = tmp_path / "walk.gpx"
    if content is not None:
        path.write_text(content)
    with pytest.raises(UnreadableTrackError, match=r"walk\.gpx has no points"):
        read_track_points(path)
