"""Series and pyramids against what one would work out from every sample by hand."""

from __future__ import annotations

import math
import threading

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from armui.telemetry.quantities import RECORDS
from armui.telemetry.series import BASE_EXPONENT, Series, Shape, zeros

FIGURES = Shape("figures", 200.0, ("a", "b"), ("code",))
HELD = Shape("held", 200.0, ("a",), held=True)

GAPS_S = st.one_of(
    st.floats(0.0, 0.02), st.sampled_from([0.005, 0.005, 0.005, 0.3, 0.7, 4.0, 61.0])
)
VALUES = st.one_of(
    st.integers(-1000, 1000).map(float), st.sampled_from([math.nan, 0.0, -0.125, 1e6])
)
SAMPLES = st.lists(st.tuples(GAPS_S, VALUES, st.integers(0, 255)), max_size=300)


def filled(samples, shape=FIGURES, repeat=1, keep_s=1800.0):
    """A series, and what was written into it."""
    series, at_s, written = Series(shape, keep_s), 1000.0, []
    for _ in range(repeat):
        for gap_s, value, code in samples:
            at_s += gap_s
            row = (value, -value, code) if shape is FIGURES else (value,)
            series.write(at_s, row)
            written.append((at_s, value, code))
    return series, written


def by_hand(written, exponent, begin, end):
    """Minima and maxima of the buckets, by number."""
    width_s = 2.0**exponent
    lows: dict[int, float] = {}
    highs: dict[int, float] = {}
    for at_s, value, _code in written:
        number = math.floor(at_s / width_s)
        kept = float(np.float32(value))
        if begin <= number < end:
            lows[number] = np.fmin(lows.get(number, math.nan), kept)
            highs[number] = np.fmax(highs.get(number, math.nan), kept)
    empty = [math.nan] * (end - begin)
    low, high = list(empty), list(empty)
    for number, value in lows.items():
        low[number - begin], high[number - begin] = value, highs[number]
    return low, high


@given(SAMPLES, st.integers(-8, 4), st.integers(0, 40), st.integers(0, 60), st.integers(1, 8))
def test_an_envelope_is_that_of_all_samples(samples, exponent, skip, size, repeat):
    series, written = filled(samples, repeat=repeat)
    begin = math.floor(1000.0 / 2.0**exponent) + skip - 3
    envelope = series.envelope(exponent, begin, begin + size, ("a",))
    low, high = by_hand(written, exponent, begin, begin + size)
    np.testing.assert_array_equal(envelope.low[0], low)
    np.testing.assert_array_equal(envelope.high[0], high)
    numbers = {math.floor(at_s / 2.0**exponent) for at_s, _value, _code in written}
    assert envelope.heard.tolist() == [begin + place in numbers for place in range(size)]


@given(SAMPLES, st.integers(BASE_EXPONENT, 3))
def test_buckets_do_not_depend_on_where_the_window_begins(samples, exponent):
    series, _written = filled(samples, repeat=4)
    begin = math.floor(1000.0 / 2.0**exponent)
    whole = series.envelope(exponent, begin, begin + 64, ("a", "b"))
    for shift in (1, 7, 33):
        part = series.envelope(exponent, begin + shift, begin + 64, ("a", "b"))
        np.testing.assert_array_equal(part.low, whole.low[:, shift:])
        np.testing.assert_array_equal(part.high, whole.high[:, shift:])


@given(SAMPLES, st.integers(-6, 2))
def test_codes_have_an_envelope_too(samples, exponent):
    series, written = filled(samples, repeat=3)
    begin = math.floor(1000.0 / 2.0**exponent)
    envelope = series.envelope(exponent, begin, begin + 50, ("code",))
    for place in range(50):
        codes = [
            code for at_s, _v, code in written if math.floor(at_s / 2.0**exponent) == begin + place
        ]
        if codes:
            assert (envelope.low[0, place], envelope.high[0, place]) == (min(codes), max(codes))
        else:
            assert math.isnan(envelope.low[0, place])


@given(SAMPLES, st.integers(-6, 2))
def test_a_command_stands_until_the_next(samples, exponent):
    series, written = filled(samples, HELD)
    width_s = 2.0**exponent
    begin = math.floor(1000.0 / width_s)
    envelope = series.envelope(exponent, begin, begin + 50, ("a",))
    for place in range(50):
        number = begin + place
        inside = [v for at_s, v, _c in written if math.floor(at_s / width_s) == number]
        before = [v for at_s, v, _c in written if math.floor(at_s / width_s) < number]
        told = [v for v in (inside or before[-1:]) if not math.isnan(v)]
        if told:
            assert envelope.low[0, place] == np.float32(min(told))
            assert envelope.high[0, place] == np.float32(max(told))
        else:
            assert math.isnan(envelope.low[0, place])


@given(SAMPLES.filter(bool), st.floats(0.0, 5.0), st.floats(0.0, 20.0))
def test_samples_and_values_between_two_times(samples, skip_s, span_s):
    series, written = filled(samples)
    begin_s, end_s = 1000.0 + skip_s, 1000.0 + skip_s + span_s
    inside = [each for each in written if begin_s <= each[0] <= end_s]
    found = series.samples(begin_s, end_s)
    assert found["time_s"].tolist() == [at_s for at_s, _v, _c in inside]
    assert found["code"].tolist() == [code for _at, _v, code in inside]
    before = [each for each in written if each[0] <= end_s]
    value = series.value_at("code", end_s)
    assert value == ((before[-1][0], before[-1][2]) if before else None)


def test_a_time_before_the_last_counts_as_that_one():
    series = Series(FIGURES)
    series.write(10.0, (1.0, 1.0, 1))
    series.write(9.0, (2.0, 2.0, 2))
    assert series.samples(0.0, 20.0)["time_s"].tolist() == [10.0, 10.0]


def test_the_ring_forgets_the_oldest():
    series = Series(FIGURES, keep_s=10.0)  # 2000 samples
    for number in range(5000):
        series.write(number / 200.0, (float(number), 0.0, 0))
    found = series.samples(0.0, 100.0)
    assert found["a"].tolist() == list(range(3001, 5000))
    assert series.value_at("a", 1.0) is None
    old = series.envelope(0, 0, 8, ("a",))
    assert not old.heard.any()
    new = series.envelope(0, 20, 25, ("a",))
    assert new.low[0].tolist() == [4000.0, 4200.0, 4400.0, 4600.0, 4800.0]


def test_silence_for_longer_than_the_ring_leaves_nothing_of_before():
    series = Series(FIGURES, keep_s=16.0)
    for number in range(2000):
        series.write(number / 200.0, (1.0, 0.0, 0))
    for number in range(1200):
        series.write(1000.0 + number / 200.0, (2.0, 0.0, 0))
    envelope = series.envelope(-2, 4 * 990, 4 * 1006, ("a",))
    assert envelope.heard.tolist() == [False] * 40 + [True] * 24
    assert set(envelope.low[0, 40:]) == {2.0}


def test_a_sample_may_come_more_often_than_the_protocol_says():
    series = Series(FIGURES, keep_s=10.0)
    for number in range(60_000):  # 6,000 a second
        series.write(number / 6000.0, (float(number), 0.0, 0))
    # every sample of the last third of a second, and the extremes of all ten
    assert series.samples(0.0, 10.0).size == 1999
    envelope = series.envelope(0, 0, 10, ("a",))
    assert envelope.low[0].tolist() == [6000.0 * second for second in range(10)]


def test_a_reader_never_sees_a_torn_sample():
    """While one thread writes as fast as it can, what is read is what was written."""
    series = Series(Shape("torn", 200.0, ("a", "b")), keep_s=4.0)  # 1024 samples, soon overwritten
    ending = threading.Event()
    problems = []

    def write():
        number = 0
        while not ending.is_set():
            number += 1
            series.write(number / 200.0, (float(number % 10_000), float(-(number % 10_000))))

    def read():
        for _ in range(300):
            newest_s = series.newest_s or 0.0
            found = series.samples(newest_s - 5.0, newest_s)
            times = np.round(found["time_s"] * 200.0)
            if np.any(np.diff(times) != 1.0):
                problems.append("times")
            if np.any(found["a"] != -found["b"]) or np.any(found["a"] != times % 10_000):
                problems.append("figures")
            end = math.floor(newest_s)
            envelope = series.envelope(0, end - 3, end, ("a", "b"))
            told = ~np.isnan(envelope.low[0]) & ~np.isnan(envelope.high[1])
            if np.any(envelope.low[0, told] != -envelope.high[1, told]):
                problems.append("envelope")

    writer = threading.Thread(target=write)
    readers = [threading.Thread(target=read) for _ in range(2)]
    for thread in (writer, *readers):
        thread.start()
    for thread in readers:
        thread.join()
    ending.set()
    writer.join()
    assert problems == []


@pytest.mark.parametrize("keep_s", [3.0, 30.0])
def test_memory_is_what_was_announced(keep_s):
    series = Series(FIGURES, keep_s=keep_s)
    assert series.bytes_kept == 0
    for number in range(round(2 * keep_s * 200)):
        series.write(number / 200.0, (1.0, 2.0, 3))
    assert series.bytes_kept == series.most_bytes


def test_a_series_gives_its_memory_back_and_can_begin_anew():
    shape = RECORDS[0].shape
    series = Series(shape)
    row = (1,) * (len(shape.figures) + len(shape.codes))
    for k in range(100):
        series.write(float(k), row)
    assert series.bytes_kept > 0
    series.release()
    assert series.bytes_kept == 0
    assert series.latest(next(iter((*shape.figures, *shape.codes)))) is None
    series.write(1000.0, row)
    assert series.bytes_kept > 0


def test_an_ended_controller_keeps_no_samples(rig):
    rig.ready()
    rig.run(0.5)
    assert rig.controller.telemetry.bytes_kept > 0
    rig.controller.shutdown()
    assert rig.controller.telemetry.bytes_kept == 0


def test_large_and_small_arrays_are_zero_and_can_be_written():
    for count in (10, 1_000_000):
        array = zeros((2, count), "f4")
        assert array.shape == (2, count)
        assert not array.any()
        array[1, -1] = 3.0
        assert np.count_nonzero(array) == 1
