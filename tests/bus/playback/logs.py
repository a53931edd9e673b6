"""Logs of the simulated arm, indexed, and a replay of them."""

from __future__ import annotations

import math
from pathlib import Path

from armui.bus.playback.log_cursor import LogClock
from armui.bus.playback.log_player import LogPlayer
from armui.control.log_replay import LogReplay
from armui.protocol.codec import Codec, Message
from armui.protocol.generation import Generation
from armui.session.foreign.indexed import IndexedLog
from armui.session.recording.recorded_session import RecordedSession
from armui.sim.faults.schedule import FAULTS, Fault
from armui.telemetry.store import Telemetry
from tests.session.indexed import open_indexed
from tests.session.recording.made import BASE, recorded
from tests.session.recordings import frames, greeting, write

EACH_FAULT = tuple(sorted(FAULTS))


def log_with(
    folder: Path, name: str, generation: Generation = Generation.TWO, seconds: float = 1.6
) -> IndexedLog:
    """An arm that is asked what it is, is switched on, and has a fault from 1.1 s to 1.4 s."""
    fault = Fault(name, FAULTS[name].default, 1.1, 1.4) if name else None
    path = folder / f"{name or 'sound'}.blf"
    faults = () if fault is None else (fault,)
    write(path, frames(seconds, generation, faults=faults, asked=greeting(generation)))
    return open_indexed(path)


def as_own(folder, session):
    """The same frames in a recording of this program, without a word beside them."""
    frames = [
        (None, each.time_s - BASE.shift_s, each.frame, int(each.flags))
        for batch in session.frames_between(-math.inf, math.inf)
        for each in batch
    ]
    return RecordedSession(recorded(folder / "own", frames, block=700))


class Player:
    """A player over a log, with series of its own; what it was answered."""

    def __init__(self, session: IndexedLog, generation: Generation = Generation.TWO) -> None:
        codec = Codec(generation)
        self.session = session
        self.clock = LogClock(session.start_s)
        self.telemetry = Telemetry(self.clock)
        self.telemetry.know_generation(generation)
        self.answers: list[Message] = []
        self.player = LogPlayer(
            session, session.channels[0], self.clock, codec=codec, listeners=(self.telemetry,),
            answered=self.answers.append,
        )  # fmt: skip
        self.player.processor.notifier.open(codec, None)

    @property
    def state(self):
        return self.player.processor.state

    def go_to(self, at_s: float) -> None:
        self.player.enter(at_s, self.player.look_up(at_s))
        self.player.use_codec(self.player.processor.codec)

    def play_to(self, until_s: float, speed: float) -> None:
        self.player.play(until_s, speed, lambda: True)
        self.player.settle()


def settled(qtbot, replay: LogReplay) -> None:
    """Until the replay is where it was sent."""
    qtbot.waitUntil(lambda: not replay.is_travelling, timeout=5000)
