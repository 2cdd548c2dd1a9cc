"""The report of orientability."""

from __future__ import annotations

from documents import MemoryDocument
from skyline_viewshed.core.locate.unique import orientability
from skyline_viewshed.core.report.orientability import OrientabilityReportWriter


def test_a_place_has_its_horizon_and_a_rose_and_numbers_for_each_field_of_view(match_scenes):
    horizon, document = match_scenes.random_horizon(4), MemoryDocument()
    found = [(fov, orientability(horizon.elevation_deg, horizon.distance_m, fov, 90.0)) for fov in (20.0, 60.0)]
    with OrientabilityReportWriter(document, "Planned") as writer:
        writer.add_place("<b>Hut", (8.0, 46.5), horizon, found)
    text = document.text
    assert text.count("Horizon of the DEM over all azimuths</title>") == 1
    assert text.count("<svg") - text.count("<svg", 0, text.index("Hut")) >= 3
    assert text.count("Probability of a unique answer by direction, north up</title>") == 2
    for words in ("Field of view 20°", "Field of view 60°", "46.500000°", "8.000000°"):
        assert words in text
    for _, one in found:
        assert f"{100 * one.mean:.0f}" in text and f"{one.typical_error_deg:.2f}°" in text
    assert "<b>" not in text and text.rstrip().endswith("</html>")


def test_the_words_are_said_in_the_users_language(match_scenes):
    horizon, document = match_scenes.random_horizon(4), MemoryDocument()
    found = orientability(horizon.elevation_deg, horizon.distance_m, 50.0, 90.0)
    with OrientabilityReportWriter(document, "t", say=lambda text: f"¤{text}") as writer:
        writer.add_place("Hut", (8.0, 46.5), horizon, [(50.0, found)])
    for words in ("Mean probability of a unique answer", "Expected error of the heading", "Field of view 50°", "Place"):
        assert f">¤{words}<" in document.text and f">{words}<" not in document.text
