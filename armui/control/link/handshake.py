"""The first questions to an arm that comes online: its generation and its limits."""

from __future__ import annotations

import enum
from collections.abc import Sequence
from typing import Final, Protocol

from armui.arm.state import ArmState, is_fresh
from armui.protocol import commands
from armui.protocol.addressing import Addressing
from armui.protocol.codec import Codec
from armui.protocol.firmware_version import ArmIdentity, FirmwareVersion
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation

_VERSION_WAIT_S: Final = 0.5
"""Answers are collected for this time; a second question within it would shift the text."""
_VERSION_ROUNDS: Final = 2
"""An arm that leaves this number of questions unanswered is of generation 1."""
_TORN_ROUNDS: Final = 4
"""The number of questions to an arm that answers: frames may be lost or mixed with others."""
_LEADER_WAIT_S: Final = 2.0
"""A teaching input may answer nothing (S-V1.7-3), so it is asked at this interval."""
_FAST_PER_S: Final = 1500.0
"""A rate between that of generation 1 (some 700 frames/s) and generation 2 (some 3,000)."""
_ASK_AGAIN_S: Final = 0.2
"""Limits that were not answered are asked for again after this time."""
_LIMIT_ROUNDS: Final = 5
"""The limits are asked for so often at most; then the handshake ends without them."""
_PAUSE_ROUNDS: Final = 2
"""The number of identity questions after each pause in which another arm may have come."""


class Wire(Protocol):
    """The functions of the bus thread that a handshake needs."""

    def send(self, frames: Sequence[Frame]) -> bool:
        """Queue frames and return whether they may go out at all."""

    def use_codec(self, codec: Codec, *, forget: bool = True) -> None:
        """Use another codec from now on; forget the feedback received so far if ``forget``."""


class HandshakePhase(enum.Enum):
    """The phases of a handshake."""

    GENERATION = enum.auto()
    LIMITS = enum.auto()
    DONE = enum.auto()


class Handshake:
    """Asks an arm the first questions; :meth:`follow_arm` drives it until it is :attr:`done`.

    It begins with nothing heard. The states it is given must have been heard since it began:
    the bus thread sees to that (:meth:`armui.bus.worker.BusWorker.use_codec`).

    Args:
        wire: Sends the questions.
        now_s: Monotonic time.
        addressing: The identifiers in use.
        known: The generation, if a replayed log states it.
        recorded_firmware: The firmware version that such a log states; "" for none.

    Attributes:
        generation: The protocol generation, once known.
        firmware: The version it named; ``None`` in generation 1, and where its text was unreadable.
        identity: The identity as reported so far.
        codec: The codec to use now.
    """

    def __init__(
        self,
        wire: Wire,
        now_s: float,
        addressing: Addressing = Addressing(),  # noqa: B008 - frozen
        known: Generation | None = None,
        recorded_firmware: str = "",
    ) -> None:
        self.phase = HandshakePhase.GENERATION
        self.generation: Generation | None = None
        self.firmware: str | None = None
        self.identity: ArmIdentity | None = None
        firmware = FirmwareVersion.parse(recorded_firmware)
        self.codec = Codec(known or Generation.TWO, addressing, firmware)
        self._wire = wire
        self._asked = False
        self._began_s = self._next_s = now_s
        self._rounds = 0
        self._pauses = 0
        self._paused_s: float | None = None
        wire.use_codec(self.codec)
        if known is not None:
            self._settle(known, now_s)

    @property
    def done(self) -> bool:
        """True if the arm has answered everything, or as much as it will."""
        return self.phase is HandshakePhase.DONE

    def follow_arm(self, state: ArmState, now_s: float) -> None:
        """Ask the questions that are due, and take in the answers."""
        self._take_firmware(state)
        if self.phase is HandshakePhase.GENERATION:
            self._find_generation(state, now_s)
        elif self.phase is HandshakePhase.LIMITS:
            self._read_limits(state, now_s)
        elif self.generation is Generation.TWO:
            self._ask_after_a_pause(state, now_s)

    def _take_firmware(self, state: ArmState) -> None:
        """Take the version over, whenever it is named: it says how other hosts' frames are read."""
        if state.firmware is None or self.generation is Generation.ONE:
            return
        if self.identity is None or (
            state.identity is not None and not self.identity.contradicts(state.identity)
        ):
            self.identity = state.identity
        if self.firmware is not None:
            return
        self.firmware = state.firmware
        before = self.codec
        firmware = FirmwareVersion.parse(state.firmware)
        self.codec = Codec(Generation.TWO, before.addressing, firmware)
        if self.codec.quirks.mit_layout is not before.quirks.mit_layout:
            self._wire.use_codec(self.codec, forget=False)

    def _find_generation(self, state: ArmState, now_s: float) -> None:
        if self.firmware is not None:
            self._settle(Generation.TWO, now_s)
        elif now_s < self._next_s:
            return
        elif self._rounds < self._rounds_wanted(state):
            self._ask_version(now_s, _VERSION_WAIT_S)
        elif self._leads(state, now_s):
            self._ask_version(now_s, _LEADER_WAIT_S)
        elif state.version_heard_s is not None or self._speaks_fast(state, now_s):
            # Only generation 2 answers at all, even if no version can be read in the answer.
            self._settle(Generation.TWO, now_s)
        else:
            self.codec = Codec(Generation.ONE, self.codec.addressing)
            self._wire.use_codec(self.codec)
            self._settle(Generation.ONE, now_s)

    def _ask_version(self, now_s: float, wait_s: float) -> None:
        self._rounds += 1
        self._asked |= self._wire.send(commands.query_firmware(self.codec))
        self._next_s = now_s + wait_s

    def _ask_after_a_pause(self, state: ArmState, now_s: float) -> None:
        """Ask who the arm is after a pause that is long enough to exchange it.

        Another version or another arm's number than before is noticed by the connection.
        """
        if state.pauses != self._pauses:
            self._pauses, self._paused_s, self._rounds = state.pauses, now_s, 0
        paused_s = self._paused_s
        if paused_s is None or now_s < self._next_s:
            return
        if self._rounds == _PAUSE_ROUNDS or any(
            each.began_s > paused_s for each in state.versions_named
        ):
            self._paused_s = None
        else:
            self._ask_version(now_s, _VERSION_WAIT_S)

    def _rounds_wanted(self, state: ArmState) -> int:
        return _VERSION_ROUNDS if state.version_heard_s is None else _TORN_ROUNDS

    def _leads(self, state: ArmState, now_s: float) -> bool:
        """Return whether it is a teaching input, which sends commands and no status."""
        return state.status is None and is_fresh(state.foreign_targets_s, now_s)

    def _speaks_fast(self, state: ArmState, now_s: float) -> bool:
        """Return whether an arm that must not be asked speaks as often as generation 2.

        On a listen-only connection no question is sent, so that silence is no evidence.
        """
        return not self._asked and state.frames / (now_s - self._began_s) > _FAST_PER_S

    def _settle(self, generation: Generation, now_s: float) -> None:
        self.generation = generation
        self.phase = HandshakePhase.LIMITS
        self._next_s = now_s
        self._rounds = 0

    def _read_limits(self, state: ArmState, now_s: float) -> None:
        missing = state.joints_without_limits()
        if not missing:
            self.phase = HandshakePhase.DONE
        elif now_s >= self._next_s:
            if self._rounds == _LIMIT_ROUNDS:
                self.phase = HandshakePhase.DONE
                return
            self._rounds += 1
            self._next_s = now_s + _ASK_AGAIN_S
            for joint in missing:
                self._wire.send(commands.query_limits(self.codec, joint))
                self._wire.send(commands.query_acceleration(self.codec, joint))
