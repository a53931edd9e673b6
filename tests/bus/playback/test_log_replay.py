"""A log with a controller of its own, played by a thread: where it stands, and what it refuses."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

import armui.bus.playback
from armui.arm.device import RecordedArm
from armui.arm.refusal import Refusal
from armui.control.devices.linkage import why_not_link
from armui.control.link.link_state import REPLAYED_LOG, LinkState
from armui.control.log_replay import LogReplay
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.session.foreign.indexed import IndexedLog
from armui.ui import words
from tests.bus.playback.logs import log_with, settled
from tests.session.indexed import open_indexed
from tests.session.recordings import frames, write


@pytest.fixture
def session(tmp_path: Path) -> Iterator[IndexedLog]:
    session = log_with(tmp_path, "overcurrent", seconds=2.4)
    yield session
    session.close()


@pytest.fixture
def replay(qtbot: QtBot, session: IndexedLog) -> Iterator[LogReplay]:
    replay = LogReplay(session, session.channels[0], RecordedArm(2), "overcurrent.blf")
    replay.open()
    settled(qtbot, replay)
    yield replay
    assert replay.close()


def go(qtbot: QtBot, replay: LogReplay, since_s: float) -> None:
    replay.go_to(replay.session.start_s + since_s)
    settled(qtbot, replay)


def test_it_begins_at_the_beginning_and_stands_still(replay: LogReplay) -> None:
    assert replay.position_s == replay.session.start_s
    assert not replay.is_playing


def test_at_any_place_the_arm_is_known_at_once(qtbot: QtBot, replay: LogReplay) -> None:
    for since_s in (1.3, 0.9, 2.0):
        go(qtbot, replay, since_s)

        controller = replay.controller
        assert controller.operating_state.link is LinkState.ONLINE
        assert controller.operating_state.generation is Generation.TWO
        assert controller.state.firmware == "S-V1.8-9"
        assert None not in controller.state.limits
        assert controller.state.angles_deg() is not None
        faulty = controller.state.drivers_slow[0]
        assert faulty is not None
        assert faulty.value.overcurrent is (since_s > 1.1)  # it latches


def test_time_stands_still_with_the_log(qtbot: QtBot, replay: LogReplay) -> None:
    go(qtbot, replay, 1.5)
    at_s = replay.clock()

    qtbot.wait(700)

    assert replay.clock() == at_s
    assert replay.controller.operating_state.link is LinkState.ONLINE


def test_it_plays_to_its_end_and_stops_there(qtbot: QtBot, replay: LogReplay) -> None:
    replay.set_speed(20.0)
    replay.play(on=True)

    qtbot.waitUntil(lambda: not replay.is_playing, timeout=5000)
    assert replay.is_at_end
    assert replay.position_s == replay.session.end_s

    replay.play(on=True)  # once more, from the beginning
    qtbot.waitUntil(lambda: not replay.is_travelling, timeout=5000)
    qtbot.waitUntil(lambda: not replay.is_playing, timeout=5000)
    assert replay.is_at_end


def test_frame_by_frame_and_back(qtbot: QtBot, replay: LogReplay) -> None:
    go(qtbot, replay, 1.0)
    with qtbot.waitSignal(replay.moved):
        replay.step()
    qtbot.waitUntil(lambda: replay.last_frame is not None and replay.last_frame.number > 0)
    first = replay.last_frame
    replay.step()
    qtbot.waitUntil(lambda: replay.last_frame is not first)
    second = replay.last_frame
    assert first is not None
    assert second is not None
    assert second.number == first.number + 1

    replay.step_back()
    settled(qtbot, replay)

    assert replay.position_s == first.at_s


def test_only_the_last_place_that_is_wanted_counts(qtbot: QtBot, replay: LogReplay) -> None:
    for since_s in (0.3, 2.2, 0.7, 1.9, 1.1):
        replay.go_to(replay.session.start_s + since_s)
    settled(qtbot, replay)

    assert replay.position_s == pytest.approx(replay.session.start_s + 1.1)


def test_the_curves_show_what_led_there(qtbot: QtBot, replay: LogReplay) -> None:
    go(qtbot, replay, 2.0)

    series = replay.controller.telemetry.series["DriverFast1"]
    qtbot.waitUntil(lambda: series.count > 300, timeout=5000)
    newest_s = series.newest_s
    assert newest_s is not None
    assert newest_s <= replay.position_s
    go(qtbot, replay, 0.5)
    assert all(each <= replay.position_s for each in series.samples(0, 1e12)["time_s"])


def test_everything_that_would_be_sent_is_refused_with_words(
    qtbot: QtBot, replay: LogReplay
) -> None:
    go(qtbot, replay, 2.0)
    controller = replay.controller
    refusals = [
        controller.motors.enable(),
        controller.halt_and_hold(),
        controller.motors.resume(),
        controller.joint_errors.clear(1),
        controller.lights.set(1, 1, 0, 0, 0) if hasattr(controller.lights, "set") else None,
        why_not_link(controller.operating_state),
    ]

    told = [each for each in refusals if isinstance(each, Refusal)]
    assert len(told) >= 4
    assert REPLAYED_LOG in {each.reason for each in told}
    for each in told:
        assert words.refusal(each)
    connection = controller._connection
    assert not connection.send([Frame(0x150, bytes(8))])
    assert not connection.send_urgent([Frame(0x150, bytes(8))])


def test_an_emergency_stop_of_its_controller_reaches_nothing(
    qtbot: QtBot, replay: LogReplay
) -> None:
    go(qtbot, replay, 1.0)
    codes: list[str] = []
    replay.controller.noticed.connect(lambda event: codes.append(event.code))

    replay.controller.emergency_stop()

    assert codes[-1] == "stop_not_sent"


def test_there_is_no_bus_in_it(replay: LogReplay) -> None:
    worker = replay.controller._connection._worker
    kept = {type(each).__module__.partition(".")[0] for each in vars(worker).values()}
    assert "can" not in kept
    for path in Path(armui.bus.playback.__file__).parent.glob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            names = [alias.name for alias in getattr(node, "names", ())]
            names.append(getattr(node, "module", None) or "")
            bus_side = ("can", "armui.bus.outbox", "armui.bus.outbox", "armui.bus.adapters")
            assert not any(name == side for name in names for side in bus_side), path


def test_an_arm_with_shifted_identifiers_is_heard(qtbot: QtBot, tmp_path: Path) -> None:
    moved = [
        (at_s, Frame(frame.arbitration_id + 0x10, frame.data))
        if 0x2A1 <= frame.arbitration_id <= 0x2A8
        else (at_s, frame)
        for at_s, frame in frames(1.0)
    ]
    write(tmp_path / "moved.blf", moved)
    session = open_indexed(tmp_path / "moved.blf")
    replay = LogReplay(session, session.channels[0], RecordedArm(2, 0x10), "moved.blf")
    replay.open()
    settled(qtbot, replay)
    go(qtbot, replay, 0.6)

    assert replay.controller.state.angles_deg() is not None
    assert replay.controller.operating_state.addressing.feedback_offset == 0x10
    assert replay.close()
    session.close()


def test_a_log_that_breaks_while_it_is_played_says_so(
    qtbot: QtBot, session: IndexedLog, replay: LogReplay, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(*_times: float) -> None:
        raise OSError("the disk is gone")

    monkeypatch.setattr(session, "snapshot_at", broken)
    with qtbot.waitSignal(replay.failed) as told:
        replay.go_to(session.end_s)

    assert told.args == ["the disk is gone"]
