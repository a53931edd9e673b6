"""The lines that are drawn: all extremes, no wriggling, gaps where nothing was heard."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from armui.telemetry.series import Series, Shape
from armui.ui.watch.curve_cache import CurveCache
from armui.ui.watch.curve_shapes import (
    AutoHeight,
    bucket_exponent,
    envelope_lines,
    extent,
    is_dense,
    sample_lines,
    together,
)
from armui.ui.watch.time_axis import tick_step_s, time_label

MEASURED = Shape("measured", 200.0, ("a",))
HELD = Shape("held", 200.0, ("a",), held=True)


def series_of(samples, shape=MEASURED):
    series = Series(shape)
    for at_s, value in samples:
        series.write(at_s, (value,))
    return series


def wave(seconds, rate_hz=200.0, begin_s=100.0):
    steps = range(round(seconds * rate_hz))
    return [(begin_s + step / rate_hz, math.sin(step / 37.0)) for step in steps]


def test_few_samples_are_drawn_as_they_are():
    series = series_of([(100.0, 1.0), (100.1, 2.0), (100.2, 1.5)])
    ((times, figures),) = sample_lines(series, ("a",), 99.0, 101.0)[0]
    assert times.tolist() == [100.0, 100.1, 100.2]
    assert figures.tolist() == [1.0, 2.0, 1.5]


def test_a_line_ends_where_nothing_was_heard_for_half_a_second():
    series = series_of([(100.0, 1.0), (100.4, 2.0), (101.0, 3.0), (101.2, 4.0)])
    first, second = sample_lines(series, ("a",), 99.0, 102.0)[0]
    assert first[1].tolist() == [1.0, 2.0]
    assert second[1].tolist() == [3.0, 4.0]


def test_a_figure_that_was_not_told_is_not_drawn():
    series = series_of([(100.0, 1.0), (100.1, math.nan), (100.2, 3.0), (100.9, math.nan)])
    ((times, figures),) = sample_lines(series, ("a",), 99.0, 101.0)[0]
    assert figures.tolist() == [1.0, 3.0]
    assert times.tolist() == [100.0, 100.2]


def test_a_command_is_drawn_as_a_step_until_it_ends():
    series = series_of([(100.0, 1.0), (110.0, 2.0), (120.0, math.nan), (130.0, 3.0)], HELD)
    first, second = sample_lines(series, ("a",), 105.0, 140.0)[0]
    assert first[0].tolist() == [100.0, 110.0, 110.0, 120.0]
    assert first[1].tolist() == [1.0, 1.0, 2.0, 2.0]
    assert second[0].tolist() == [130.0, 140.0]


@given(st.integers(-6, 1), st.lists(st.integers(0, 60), min_size=1, unique=True))
def test_an_envelope_breaks_where_it_was_silent(exponent, seconds):
    samples = [
        (100.0 + second + step / 40.0, float(second)) for second in sorted(seconds)
        for step in range(20)
    ]  # fmt: skip
    width_s = 2.0**exponent
    begin = math.floor(100.0 / width_s)
    envelope = series_of(samples).envelope(exponent, begin, begin + round(64 / width_s), ("a",))
    lines = envelope_lines(envelope)[0]
    # half a second of samples, half a second of silence: as long as buckets show that
    if width_s < 0.03:
        assert len(lines) == len(seconds)
    for times_s, figures in lines:
        assert np.all(np.diff(times_s) >= 0.0)
        assert not np.isnan(figures).any()
        assert times_s.size == figures.size >= 2
    assert extent(lines) == (min(seconds), max(seconds))


def test_what_scrolls_keeps_its_shape():
    series = series_of(wave(120.0))
    exponent = bucket_exponent(60.0, 500)
    width_s = 2.0**exponent
    points = []
    for shift in (0, 1, 5):
        begin = math.floor(110.0 / width_s) + shift
        ((times_s, figures),) = envelope_lines(
            series.envelope(exponent, begin, begin + 200, ("a",))
        )[0]
        points.append(set(zip(times_s.tolist(), figures.tolist(), strict=True)))
    assert points[1] - points[0] <= {each for each in points[1] if each[0] > 110.0 + 199 * width_s}
    assert len(points[0] & points[2]) == 2 * 195


@pytest.mark.parametrize("span_s", [5.0, 10.0, 30.0, 60.0, 300.0, 1800.0])
@pytest.mark.parametrize("width_px", [200, 1000, 3000])
def test_no_more_points_than_a_screen_can_show(span_s, width_px):
    exponent = bucket_exponent(span_s, width_px)
    buckets = span_s / 2.0**exponent
    assert 0.37 * width_px <= buckets <= 0.751 * width_px


def points_of(cache):
    """What is drawn, as points."""
    return {point for piece in cache.drawn[0] for point in piece}


@pytest.mark.parametrize(("span_s", "step_s"), [(60.0, 0.08), (60.0, 3.7), (8.0, 0.08), (1.0, 0.3)])
def test_a_cache_draws_what_is_there(span_s, step_s):
    """After any number of pictures the lines are those made anew, but for the newest pixels."""
    series = series_of([])
    samples = iter(wave(150.0))
    make = lambda times, figures: list(zip(times.tolist(), figures.tolist(), strict=True))  # noqa: E731
    cache = CurveCache(series, ("a",), make)
    now_s, at_s = 100.0 + span_s / 2, 0.0
    while now_s < 100.0 + min(2.2 * span_s, 140.0):
        now_s += step_s
        while at_s < now_s:
            at_s, value = next(samples)
            series.write(at_s, (value,))
        cache.update(now_s - span_s, now_s, 400, turn=True)
    fresh = CurveCache(series, ("a",), make)
    fresh.update(now_s - span_s, now_s, 400)
    px_s = span_s / 400
    inside = lambda points: {  # noqa: E731
        point for point in points if now_s - span_s + 4 * px_s < point[0] < now_s - 6 * px_s
    }
    assert inside(points_of(fresh)) == inside(points_of(cache))
    assert is_dense(series, now_s - span_s, now_s, 400) is (span_s > 3.0)


def test_a_cache_makes_a_part_of_a_picture_only():
    """Running on costs the newest end, not all of it."""
    series = series_of(wave(120.0))
    made = []
    cache = CurveCache(series, ("a",), lambda times, _figures: made.append(times.size))
    cache.update(100.0, 160.0, 1000)
    whole = sum(made)
    made.clear()
    for picture in range(1, 50):
        cache.update(100.0 + 0.08 * picture, 160.0 + 0.08 * picture, 1000)
    assert sum(made) / 49 < whole / 8


@pytest.mark.parametrize("span_s", [1.0, 60.0])
def test_a_cache_draws_what_is_read_while_the_time_stands_still(span_s):
    """A log that is paused is filled after the jump, and its clock does not move."""
    series = series_of([])
    make = lambda times, figures: list(zip(times.tolist(), figures.tolist(), strict=True))  # noqa: E731
    cache = CurveCache(series, ("a",), make)
    for jump_s in (0.0, 20.0, -10.0):
        end_s = 200.0 + jump_s
        series.release()
        cache.update(end_s - span_s, end_s, 400)
        assert points_of(cache) == set()
        for at_s, value in wave(150.0):
            if at_s < end_s:
                series.write(at_s, (value,))
        for turn in (False, True):
            cache.update(end_s - span_s, end_s, 400, turn=turn)
        fresh = CurveCache(series, ("a",), make)
        fresh.update(end_s - span_s, end_s, 400)
        assert points_of(cache) == points_of(fresh) != set()


def test_the_axis_does_not_dance():
    height = AutoHeight()
    first = height.fit((0.0, 10.0))
    assert first[0] < 0.0
    assert first[1] > 10.0
    assert height.fit((0.5, 9.0)) == first
    assert height.fit((0.0, 10.2)) == first
    grown = height.fit((0.0, 20.0))
    assert grown[1] > 20.0
    assert height.fit(None) == grown
    assert height.fit((3.0, 4.0)) != grown
    assert together([None, (1.0, 2.0), (0.0, 1.5)]) == (0.0, 2.0)
    assert together([None]) is None


def test_flat_curves_and_codes_have_room():
    low, high = AutoHeight("°C").fit((31.0, 31.0))
    assert high - low >= 4.0
    low, high = AutoHeight().fit((0.0, 0.0), codes=True)
    assert low < 0.0
    assert high > 1.0


@pytest.mark.parametrize(
    ("time_s", "step_s", "text"),
    [
        (-2.5, 0.5, "−2.5 s"),
        (0.0, 1.0, "0 s"),
        (-30.0, 5.0, "−30 s"),
        (-750.0, 300.0, "−12:30"),
        (-0.0, 0.001, "0.000 s"),
        (-0.125, 0.005, "−0.125 s"),
    ],
)
def test_times_on_the_axis(time_s, step_s, text):
    assert time_label(time_s, step_s) == text


@given(st.floats(0.02, 1800.0), st.floats(100.0, 4000.0))
def test_labels_do_not_touch(span_s, width_px):
    step_s = tick_step_s(span_s, width_px)
    assert step_s / span_s * width_px >= 89.0 or step_s == 600.0
