import numpy as np
import pytest
from skyline_viewshed.core.io.array_folder import ArrayFolder
from skyline_viewshed.core.locate.build import STORED, build_index, kept_index
from skyline_viewshed.core.locate.places import Area, AreaError, IndexOptions

SMALL = IndexOptions(spacing_m=1_500.0, azimuths=36, max_distance_m=6_000.0)


def test_voids_are_left_out(cone, area_of):
    full = build_index(cone, area_of(cone), SMALL)
    holed = type(cone)(cone.elevation_m.copy(), cone.cell_m, cone.longitude_deg, cone.latitude_deg)
    holed.elevation_m[:80] = np.nan
    part = build_index(holed, area_of(cone), SMALL)
    assert 0.4 * len(full) < len(part) < 0.6 * len(full)
    assert part.latitude_deg.max() < full.latitude_deg.max()


def test_an_area_in_a_void_is_refused_and_no_store_appears(cone, area_of, tmp_path):
    holed = type(cone)(cone.elevation_m * np.nan, cone.cell_m, cone.longitude_deg, cone.latitude_deg)
    with pytest.raises(AreaError, match="no heights in the area"):
        kept_index(holed, area_of(cone), SMALL, ArrayFolder(tmp_path / "index"))
    assert not any(tmp_path.iterdir())


def test_only_places_inside_the_area(cone):
    longitude, latitude = map(float, cone.position_of(80, 80))
    circle = Area.circle(longitude, latitude, 4_000.0)
    index = build_index(cone, circle, SMALL)
    assert circle.holds(index.longitude_deg, index.latitude_deg).all()
    assert len(index) == pytest.approx(np.pi * 4_000**2 / index.spacing_m**2, abs=6)


def test_the_memory_is_checked_first(cone, area_of):
    with pytest.raises(AreaError, match="MB"):
        build_index(cone, area_of(cone), IndexOptions(spacing_m=200.0, memory_mb=0.5))


def test_a_store_is_filled_once_and_then_read(cone, area_of, tmp_path, monkeypatch):
    store = ArrayFolder(tmp_path / "index")
    first = kept_index(cone, area_of(cone), SMALL, store)
    monkeypatch.setattr("skyline_viewshed.core.locate.build.build_index", None)
    again = kept_index(cone, area_of(cone), SMALL, store)
    assert isinstance(again.elevation, np.memmap)
    for name in ("longitude_deg", "latitude_deg", "ground_m", "elevation", "distance"):
        assert np.array_equal(getattr(first, name), getattr(again, name))
    assert (again.cell_m, again.spacing_m) == (first.cell_m, first.spacing_m)
    assert sorted(path.stem for path in (tmp_path / "index").iterdir()) == sorted(STORED)
