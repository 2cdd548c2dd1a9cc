"""The report of horizon profiles."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from documents import MemoryDocument, horizon_report_html
from skyline_viewshed.core.report.horizon import HorizonReportWriter


def test_every_place_has_a_drawing_and_its_numbers(match_scenes):
    horizon = match_scenes.random_horizon(4)
    horizon.elevation_deg[900] = 31.25
    text = horizon_report_html([("Hut", horizon, 8.0, 46.5, 0.871), ("Pass", horizon, None, None, None)], "Horizons")
    assert text.count("Horizon of the DEM over all azimuths</title>") == 2
    for words in ("+31.25°", "90.0°", "46.500000°", "0.871", "25.0\u00a0km", "2 places"):
        assert words in text


def test_the_table_sorts_by_number(match_scenes):
    text = horizon_report_html([("Hut", match_scenes.random_horizon(4), 8.0, 46.5, 0.871)], "Horizons")
    assert 'data-sort="0.871"' in text
    assert text.count('<th scope="col" data-numeric') == text.count('<td class="number"')


def test_a_place_without_any_horizon_is_drawn_as_such(match_scenes):
    horizon = match_scenes.random_horizon(4)
    blind = replace(horizon, elevation_deg=np.full(3600, np.nan), distance_m=np.full(3600, np.nan))
    text = horizon_report_html([("Void", blind, 8.0, 46.5, None)], "Horizons")
    assert "The DEM has no horizon here." in text
    assert "nan" not in text


def test_failed_places_say_why_and_nothing_is_injected(match_scenes):
    document = MemoryDocument()
    with HorizonReportWriter(document, "<i>t</i>") as writer:
        writer.add("</script><b>", match_scenes.random_horizon(4), extras={"<u>": "<s>"})
        writer.add_failed("<b>second", "<em>outside the DEM")
    for tag in ("<b>", "<u>", "<s>", "<em>", "<i>"):
        assert tag not in document.text
    assert "outside the DEM" in document.text
    assert document.text.count("</script>") == 1


def test_nothing_appears_after_an_error(match_scenes):
    document = MemoryDocument()
    with pytest.raises(RuntimeError), HorizonReportWriter(document, "t") as writer:
        writer.add("a", match_scenes.random_horizon(4))
        raise RuntimeError
    assert document.text == ""
