"""Curves of half an hour before a place: read while the replay goes on, and then shown at once."""

from __future__ import annotations

import math
import threading

import numpy as np
import pytest

from armui.arm.device import RecordedArm
from armui.bus.playback import curve_history, log_player
from armui.bus.playback.log_cursor import LogCursor
from armui.control.log_replay import LogReplay
from armui.protocol.generation import Generation
from armui.telemetry.quantities import BUS, RECORDS
from armui.telemetry.series import Series, Shape
from armui.ui.watch.curve_cache import CurveCache
from tests.bus.playback.logs import Player, log_with, settled
from tests.session.indexed import open_indexed
from tests.session.recordings import frames, greeting, write

NEAR_S = 0.5
ARM = [each.name for each in RECORDS if each is not BUS]


@pytest.fixture(autouse=True)
def near(monkeypatch):
    """Half a second counts as near: logs of two minutes are long to make."""
    monkeypatch.setattr(log_player, "FILLED_S", NEAR_S)
    monkeypatch.setattr(curve_history, "_LONGEST_REST_S", 0.0)


@pytest.fixture
def log(tmp_path):
    session = log_with(tmp_path, "overcurrent", seconds=3.0)
    yield session
    session.close()


def reading(player, event):
    """What reads the rest; the event is set when it has."""
    history = player.player.read_history(event.set)
    assert history is not None
    return history


def samples(telemetry):
    """Everything that is kept, by series."""
    return {
        name: series.samples(-math.inf, math.inf)
        for name, series in telemetry.series.items()
        if name in ARM and series.count
    }


def same(one, other):
    assert one.keys() == other.keys()
    for name, rows in one.items():
        assert rows.tobytes() == other[name].tobytes(), name


@pytest.mark.parametrize("speed", [1.0, 20.0])
def test_history_is_what_playing_from_the_beginning_would_have_shown(log, speed):
    at_s = log.start_s + 1.5
    whole = Player(log)
    whole.go_to(log.start_s)
    whole.player.fill(lambda: True)
    whole.play_to(at_s, 1.0)
    whole.play_to(log.end_s, speed)

    player = Player(log)
    player.go_to(at_s)
    player.player.fill(lambda: True)
    read = threading.Event()
    history = reading(player, read)
    player.play_to(log.end_s, speed)  # meanwhile it goes on
    assert read.wait(10)
    assert player.telemetry.series["JointFeedback12"].samples(0, at_s - 0.6).size == 0
    player.player.take_history(history, lambda: True)

    same(samples(player.telemetry), samples(whole.telemetry))
    assert player.player.curves_from_s == log.start_s
    assert player.player.read_history(read.set) is None


def test_what_comes_after_is_added_to_it(log):
    player = Player(log)
    player.go_to(log.start_s + 1.5)
    player.player.fill(lambda: True)
    read = threading.Event()
    history = reading(player, read)
    assert read.wait(10)
    player.player.take_history(history, lambda: True)
    before = player.telemetry.series["JointFeedback12"].count
    player.play_to(log.end_s, 1.0)
    after = player.telemetry.series["JointFeedback12"]
    assert after.count > before
    times_s = after.samples(-math.inf, math.inf)["time_s"]
    assert (np.diff(times_s) > 0).all()
    assert times_s[-1] == pytest.approx(log.end_s, abs=0.02)


def test_elsewhere_it_is_not_taken(log):
    player = Player(log)
    player.go_to(log.start_s + 1.5)
    player.player.fill(lambda: True)
    read = threading.Event()
    history = reading(player, read)
    assert read.wait(10)
    player.go_to(log.start_s + 2.5)
    player.player.fill(lambda: True)
    kept = samples(player.telemetry)
    player.player.take_history(history, lambda: False)
    same(samples(player.telemetry), kept)
    assert player.player.curves_from_s == pytest.approx(log.start_s + 2.0)


def test_a_log_that_cannot_be_read_any_more_leaves_what_is_near(log, monkeypatch):
    player = Player(log)
    player.go_to(log.start_s + 1.5)
    player.player.fill(lambda: True)
    kept = samples(player.telemetry)
    monkeypatch.setattr(LogCursor, "columns_between", lambda *_: 1 / 0)
    over = threading.Event()
    history = reading(player, over)
    assert over.wait(10)
    assert history.is_over
    assert not history.is_whole
    same(samples(player.telemetry), kept)


@pytest.fixture
def replay(qtbot, log):
    replay = LogReplay(log, log.channels[0], RecordedArm(2), "log")
    replay.open()
    settled(qtbot, replay)
    yield replay
    assert replay.close()


def reaches_back(replay, to_s):
    found = replay.controller.telemetry.series["JointFeedback12"].samples(-math.inf, math.inf)
    return bool(found.size) and found["time_s"][0] < to_s + 0.05


def test_it_is_read_when_it_is_wanted_and_wherever_the_replay_goes(qtbot, replay, log):
    replay.go_to(log.start_s + 2.0)
    settled(qtbot, replay)
    qtbot.waitUntil(lambda: reaches_back(replay, log.start_s + 1.5), timeout=5000)
    assert not reaches_back(replay, log.start_s)

    replay.want_curves(30.0 * 60.0)
    qtbot.waitUntil(lambda: reaches_back(replay, log.start_s), timeout=5000)
    qtbot.waitUntil(lambda: replay.loading is None, timeout=5000)

    replay.go_to(log.start_s + 2.8)
    settled(qtbot, replay)
    assert not reaches_back(replay, log.start_s)
    qtbot.waitUntil(lambda: reaches_back(replay, log.start_s), timeout=5000)

    replay.want_curves(NEAR_S)
    replay.go_to(log.start_s + 2.4)
    settled(qtbot, replay)
    qtbot.waitUntil(lambda: reaches_back(replay, log.start_s + 1.9), timeout=5000)
    assert replay.loading is None


def test_while_it_is_read_its_share_is_told_and_the_replay_plays(qtbot, replay, log, monkeypatch):
    go_on = threading.Event()
    wait = curve_history.CurveHistory._goes_on

    def slowly(history, reached_s):
        goes_on = wait(history, reached_s)
        if reached_s > log.start_s + 0.9:
            go_on.wait(10)
        return goes_on

    monkeypatch.setattr(curve_history.CurveHistory, "_goes_on", slowly)
    replay.go_to(log.start_s + 2.0)
    settled(qtbot, replay)
    replay.want_curves(1800.0)

    def half_way():
        loading = replay.loading
        return loading is not None and loading[2] > 0.4

    qtbot.waitUntil(half_way, timeout=5000)
    begin_s, end_s, _share = replay.loading
    assert (begin_s, end_s) == pytest.approx((log.start_s, log.start_s + 1.5))
    replay.play(on=True)
    qtbot.waitUntil(lambda: replay.position_s > log.start_s + 2.3, timeout=5000)
    go_on.set()
    qtbot.waitUntil(lambda: reaches_back(replay, log.start_s), timeout=5000)


def test_curves_that_nobody_sees_are_read_when_they_are_shown(qtbot, replay, log):
    replay.want_curves(0.0)
    replay.go_to(log.start_s + 2.0)
    settled(qtbot, replay)
    assert not replay._fill_timer.isActive()
    assert replay._worker.lacks_curves
    replay.want_curves(NEAR_S)
    qtbot.waitUntil(lambda: reaches_back(replay, log.start_s + 1.5), timeout=5000)


@pytest.mark.parametrize("play", [lambda replay: replay.play(on=True), LogReplay.step])
def test_curves_that_nobody_sees_are_whole_once_the_log_goes_on(qtbot, replay, log, play):
    replay.want_curves(0.0)
    replay.go_to(log.start_s + 2.0)
    settled(qtbot, replay)
    play(replay)
    qtbot.waitUntil(lambda: replay.position_s > log.start_s + 2.0, timeout=5000)
    assert reaches_back(replay, log.start_s + 1.5)


def test_the_next_place_does_not_wait_for_the_curves_of_this_one(qtbot, replay, log, monkeypatch):
    go_on = threading.Event()
    wait = curve_history.CurveHistory._goes_on
    monkeypatch.setattr(
        curve_history.CurveHistory,
        "_goes_on",
        lambda history, at_s: go_on.wait(10) and wait(history, at_s),
    )
    replay.go_to(log.start_s + 2.0)
    settled(qtbot, replay)
    replay.want_curves(1800.0)
    qtbot.waitUntil(lambda: replay.loading is not None, timeout=5000)
    history = replay._worker.history
    replay.go_to(log.start_s + 2.5)
    assert replay.loading is None  # before the place is at hand
    assert not history._wanted
    go_on.set()
    settled(qtbot, replay)
    qtbot.waitUntil(lambda: reaches_back(replay, log.start_s), timeout=5000)


def test_series_are_adopted_and_caches_made_anew():
    shape = Shape("x", 10.0, ("a",))
    old, new = Series(shape, 400.0), Series(shape, 400.0)
    for number in range(3000):
        new.write(number / 10, (float(number % 7),))
        if number >= 2900:
            old.write(number / 10, (float(number % 7),))
    cache: CurveCache[np.ndarray] = CurveCache(old, ("a",), lambda times_s, _figures: times_s)
    cache.update(0.0, 299.9, 400)
    assert min(float(piece[0]) for piece in cache.drawn[0]) > 289.0

    old.adopt(new)
    cache.update(0.0, 299.9, 400)
    assert min(float(piece[0]) for piece in cache.drawn[0]) < 1.0
    assert (old.count, old.replaced) == (3000, 1)
    old.write(300.0, (1.0,))
    assert old.latest("a") == (300.0, 1.0)

    old.adopt(Series(shape, 400.0))  # nothing is in it: what there is stays
    assert old.count == 3001


def test_the_bus_load_goes_on_over_the_join(tmp_path):
    path = tmp_path / "long.blf"
    write(path, frames(3.0, asked=greeting(Generation.TWO)))
    log = open_indexed(path)
    player = Player(log)
    player.go_to(log.start_s + 1.5)
    player.player.fill(lambda: True)
    read = threading.Event()
    history = reading(player, read)
    assert read.wait(10)
    player.player.take_history(history, lambda: True)
    player.play_to(log.end_s, 20.0)
    rows = player.telemetry.series[BUS.name].samples(-math.inf, math.inf)
    assert np.diff(rows["time_s"]).max() < 0.25
    assert rows.size > 20
    log.close()
