"""The compass audit: closed forms, synthetic errors of known kind, and the compasses of a real trek."""

from __future__ import annotations

import csv
from dataclasses import replace
from datetime import datetime, timedelta

import numpy as np
import pytest
from skyline_viewshed.core.report.audit import Reading, audit, circular_median, drift, median_interval, reading_of

DAY = datetime(2024, 7, 1, 6)


def readings(difference_deg, device="Phone", hours=None):
    times = [None] * len(difference_deg) if hours is None else [DAY + timedelta(hours=float(h)) for h in hours]
    return [
        Reading(device, time, float((value + 180) % 360 - 180))
        for time, value in zip(times, np.asarray(difference_deg))
    ]


def of(difference_deg, hours=None):
    (one,) = audit(readings(difference_deg, hours=hours))
    return one


def test_bias_and_spread_are_median_and_scaled_median_deviation():
    one = of([1.0, 2.0, 4.0, 7.0, 11.0])
    assert (one.count, one.bias_deg, one.worthless, one.turned) == (5, 4.0, 0, (0, 0, 0))
    assert one.spread_deg == pytest.approx(1.4826 * 3)
    assert (one.bias_lo_deg, one.bias_hi_deg) == (1.0, 11.0)  # 1 - 2 / 2^5 = 94 %


@pytest.mark.parametrize(
    ("count", "rank"),
    [(4, None), (5, 1), (8, 2), (11, 3), (20, 6)],  # tables of the sign test, 5 % on each side
)
def test_the_interval_of_a_median_is_that_of_the_sign_test(count, rank):
    low, high = median_interval(np.arange(1.0, count + 1))
    assert (low, high) == ((None, None) if rank is None else (rank, count + 1 - rank))


def test_the_interval_holds_the_true_bias_as_often_as_it_says():
    draw = np.random.default_rng(5).standard_t(3, (2000, 15)) * 4 + 2
    ends = [median_interval(np.sort(values)) for values in draw]
    assert 0.9 <= np.mean([low <= 2 <= high for low, high in ends]) <= 0.97


def test_all_differences_may_turn_together():
    error = np.array([-6.0, -3.0, -2.0, 0.0, 1.0, 2.0, 5.0])
    here = of(error)
    for turn in (100.0, 178.0, 180.0, -90.0):
        there = of(error + turn)
        assert (there.bias_deg - here.bias_deg - turn + 180) % 360 == pytest.approx(180)
        assert there.spread_deg == pytest.approx(here.spread_deg)
        assert (there.bias_hi_deg - there.bias_lo_deg) % 360 == pytest.approx(here.bias_hi_deg - here.bias_lo_deg)
        assert there.worthless == 7


def test_a_third_of_worthless_readings_to_one_side_hardly_moves_the_bias():
    error = np.random.default_rng(1).normal(5, 3, 300)
    error[:100] += 90
    one = of(error)
    assert one.bias_deg == pytest.approx(5, abs=0.6) and one.spread_deg == pytest.approx(3, rel=0.25)
    assert one.worthless == 100 and one.turned == (100, 0, 0) and one.turned_fault


@pytest.mark.parametrize(("turn", "place"), [(90, 0), (-90, 1), (180, 2)])
def test_turned_readings_are_a_fault_and_scattered_ones_are_not(turn, place):
    draw = np.random.default_rng(2)
    error = draw.normal(0, 4, 60)
    turned, scattered = error.copy(), error.copy()
    turned[:6] += turn
    scattered[:6] = [40, 75, 130, -50, -120, -160]
    assert of(turned).turned_fault and of(turned).turned[place] == 6
    assert not of(scattered).turned_fault and of(scattered).worthless == 6


def test_chance_makes_a_fault_of_scattered_readings_rarely():
    draw = np.random.default_rng(3)
    found = [of(np.r_[draw.normal(0, 4, 40), draw.uniform(-180, 180, 20)]).turned_fault for _ in range(200)]
    assert np.mean(found) <= 0.02


def test_readings_that_agree_on_nothing_have_no_bias():
    one = of(np.linspace(-170, 170, 18))
    assert one.bias_deg is None and one.spread_deg is None and one.drift_deg_per_h is None and one.count == 18
    assert one.worthless > 12
    assert of([3.0, 4.0]).bias_deg is None


def test_the_circular_median_is_that_of_the_line_if_nothing_wraps():
    values = np.random.default_rng(4).normal(0, 20, 101)
    assert circular_median(values) == np.median(values)
    assert circular_median(np.array([179.0, -179.0, 178.0])) == 179.0


def test_a_drift_is_the_slope_within_days_whatever_differs_between_them():
    hours = np.r_[np.arange(0, 6, 0.5), 24 + np.arange(0, 6, 0.5)]
    error = 1.5 * (hours % 24) + np.where(hours < 24, 0.0, -8.0)
    one = of(error, hours)
    assert one.drift_deg_per_h == pytest.approx(1.5)
    assert one.drift_lo_deg_per_h == pytest.approx(1.5) and one.drift_hi_deg_per_h == pytest.approx(1.5)


def test_the_interval_of_the_drift_holds_zero_where_there_is_none():
    draw = np.random.default_rng(6)
    found = [
        drift([DAY + timedelta(hours=h) for h in draw.uniform(0, 10, 20)], draw.normal(0, 4, 20)) for _ in range(300)
    ]
    held = np.mean([low <= 0 <= high for _, low, high in found])
    assert 0.86 <= held <= 0.96


def test_without_times_or_hours_between_them_there_is_no_drift():
    assert of(np.arange(12.0)).drift_deg_per_h is None
    assert of(np.arange(12.0), np.arange(12) / 1000).drift_deg_per_h is None


def test_devices_are_judged_apart_and_the_most_frequent_comes_first():
    some = readings([1, 2, 3], "B") + readings([-5, -6, -7, -8], "A")
    assert [(one.device, one.count) for one in audit(some)] == [("A", 4), ("B", 3)]
    assert audit([]) == []


def test_only_reliable_photographs_with_a_compass_count(painted):
    assert reading_of(painted()).difference_deg == pytest.approx(121.0 - 123.4)
    assert reading_of(painted()).device == "Maker Model"
    photo = painted("confirmed")
    assert reading_of(replace(photo, metadata=replace(photo.metadata, software="17.1"))).device == "Maker Model · 17.1"
    assert reading_of(painted("ambiguous")) is None and reading_of(painted("rejected")) is None
    assert reading_of(painted(compass_true_deg=None)) is None


def test_the_phone_of_a_real_trek_reads_a_few_degrees_too_much(shared_data):
    with open(shared_data / "khumbu-trek" / "truth.csv", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["heading_deg"] and row["compass_heading_deg"]]
    one = of([float(row["compass_heading_deg"]) - float(row["heading_deg"]) for row in rows])
    assert one.count >= 20 and one.worthless == 0 and not one.turned_fault
    assert 2 < one.bias_lo_deg < one.bias_deg < one.bias_hi_deg < 6
    assert 2 < one.spread_deg < 5
