import numpy as np
from skyline_viewshed.benchmarks import bench_regions


def row(region, error, status="accepted", group="good", covered=True):
    truth = None if error is None else 100.0
    return {
        "region": region,
        "group": group,
        "truth_deg": truth,
        "error_deg": error,
        "status": status,
        "covered": covered,
        "cpu_s": 2.0,
    }


def test_each_region_is_counted_by_itself_and_all_together():
    rows = [row("a", 0.2), row("a", -4.0, covered=False), row("b", 0.7, "ambiguous"), row("b", None, group="hard")]
    table = bench_regions.by_region(rows)
    assert list(table) == ["a", "b", "all"]
    assert (table["a"]["photos"], table["a"]["< 0.5"], table["a"]["accepted"], table["a"]["of these wrong"]) == (
        2,
        1,
        2,
        1,
    )
    assert (table["b"]["< 1"], table["b"]["accepted"], table["b"]["hard"], table["b"]["hard accepted"]) == (1, 0, 1, 1)
    assert (table["all"]["photos"], table["all"]["interval holds"]) == (3, 1)
    assert np.isclose(table["all"]["median CPU s"], 2.0)


def test_a_good_photograph_without_an_answer_counts_as_missed():
    missed = {**row("a", 0.0, "rejected"), "error_deg": None}
    assert bench_regions.by_region([missed])["a"]["< 10"] == 0
