"""The table of compasses that a run may write."""

from __future__ import annotations

from qgis.core import NULL
from skyline_viewshed.algorithms.shared.compass_audit import compass_audit_specs, values_of
from skyline_viewshed.core.report.audit import DeviceAudit


def test_each_value_stands_under_its_name():
    one = DeviceAudit("Phone", 40, 4.0, 3.0, 5.0, 2.0, 7, (5, 1, 0), True, 0.5, 0.1, 0.9)
    row = dict(zip([spec.name for spec in compass_audit_specs()], values_of(one)))
    assert len(row) == len(values_of(one)) == 14
    assert (row["device"], row["readings"], row["bias"], row["bias_lo"], row["bias_hi"]) == ("Phone", 40, 4.0, 3.0, 5.0)
    assert (row["spread"], row["worthless"], row["turned"]) == (2.0, 7, True)
    assert (row["plus_90"], row["minus_90"], row["opposite"]) == (5, 1, 0)
    assert (row["drift"], row["drift_lo"], row["drift_hi"]) == (0.5, 0.1, 0.9)
    assert all(len(name) <= 10 for name in row)


def test_a_run_writes_the_readings_of_its_reliable_photographs(run, scene, tmp_path):
    photos, _ = run("importphotos", {"FOLDER": str(scene.folder), "OUTPUT": "memory:"})
    given = {"INPUT": photos["OUTPUT"], "DEM": str(scene.dem), "OUTPUT": "memory:", "COMPASS_AUDIT": "memory:"}
    results, _ = run("orientphotos", given)
    oriented = [photo for photo in results["OUTPUT"].getFeatures() if photo["status"] == "accepted"]
    differences = [photo["compass_df"] for photo in oriented if photo["compass_df"] not in (None, NULL)]
    rows = list(results["COMPASS_AUDIT"].getFeatures())
    assert differences and sum(row["readings"] for row in rows) == len(differences)
    if len(differences) < 3:
        assert all(row["bias"] in (None, NULL) for row in rows)
    assert "COMPASS_AUDIT" not in run("orientphotos", {**given, "COMPASS_AUDIT": None, "MAX_DISTANCE": 5000})[0]


def test_the_table_is_optional_and_advanced(algorithm):
    it = algorithm("orientphotos")
    definition = it.parameterDefinition("COMPASS_AUDIT")
    assert definition.flags() & definition.FlagOptional and definition.flags() & definition.FlagAdvanced
    assert not definition.createByDefault()
