"""The simulated arm in a process of its own.

There neither the window's work nor Python's GIL delays it, nor does it delay the window: like a
real arm it sends every frame when it is due. Frames travel on one line, several in a message; the
hand's messages, which lead the arm or set faults, on another. The end of the frames' line ends the
process.
"""

from __future__ import annotations

import multiprocessing
import socket
from collections.abc import Sequence
from typing import Final

from armui.protocol.frame_records import RECORD_BYTES
from armui.sim.arm_choice import HAND, LETS_GO, ArmChoice
from armui.system.helper_process import end_with_the_program
from armui.system.record_socket import RecordSocket
from armui.system.thread_priority import raise_in_background

PROCESS_NAME: Final = "armui-simulated-arm"

_BEGINS_WITHIN_S: Final = 60.0
"""The process must be ready within this time; a loaded computer takes some seconds to import it."""
_ENDS_WITHIN_S: Final = 2.0


class LineHand:
    """The hand that leads the arm in another process, and sets its faults.

    If that process no longer takes messages, the line is closed, and so the hand lets go.

    Attributes:
        faults: The faults that it has begun and not ended: name and joint, 0 for none.
    """

    def __init__(self, line: RecordSocket) -> None:
        self._line = line
        self.faults: set[tuple[str, int]] = set()

    def lead_to(self, joints_deg: Sequence[float], speed_deg_s: float = 30.0) -> None:
        """Lead all joints to six angles; the joint with the longest way turns at this speed."""
        self._send_hand(b"", *joints_deg, speed_deg_s)

    def release(self) -> None:
        """Release the arm, which stays where it is."""
        self._send_hand(*LETS_GO)

    def switch(self, name: str, joint: int, *, begins: bool) -> None:
        """Begin or end a fault, by its name in `armui.sim.faults.schedule`; its joint, or 0."""
        (self.faults.add if begins else self.faults.discard)((name, joint))
        self._send_hand(name.encode(), joint, begins, *(0.0,) * 5)

    def _send_hand(self, name: bytes, *figures: float) -> None:
        try:
            self._line.send(HAND.pack(name, *figures))
        except OSError:
            self._line.close()


class ArmProcess:
    """One process with a simulated arm, from its start to `end`.

    Attributes:
        line: Our end of the line of frames.
        hand: The hand that leads the arm.

    Raises:
        OSError: The process cannot be started.
    """

    def __init__(self, choice: ArmChoice) -> None:
        frames, frames_there = socket.socketpair()
        hand, hand_there = socket.socketpair()
        self.line = RecordSocket(frames, RECORD_BYTES)
        self._hand_line = RecordSocket(hand, HAND.size)
        self.hand = LineHand(self._hand_line)
        # a fork would inherit Qt, its threads and every lock they hold
        self._process = multiprocessing.get_context("spawn").Process(
            target=live, args=(frames_there, hand_there, choice), name=PROCESS_NAME, daemon=True
        )
        try:
            self._process.start()
        except BaseException:
            self._close()
            raise
        finally:
            # Only the process holds these ends from now on, so that its end closes the lines.
            frames_there.close()
            hand_there.close()

    @property
    def pid(self) -> int | None:
        """The process's number."""
        return self._process.pid

    def wait_until_it_lives(self, within_s: float = _BEGINS_WITHIN_S) -> None:
        """Wait until the arm runs, and drop the frames it has sent before anybody listened.

        Raises:
            OSError: The process has ended before, or takes longer.
        """
        if not self._hand_line.receive(within_s):
            raise TimeoutError(f"the simulated arm has not begun within {within_s:.0f} s")
        while self.line.receive():
            pass

    def end(self) -> None:
        """Kill the process, which keeps nothing, and wait until it is gone."""
        self._close()
        self._process.kill()  # it has no files or settings to save
        self._process.join(_ENDS_WITHIN_S)

    def _close(self) -> None:
        self.line.close()
        self._hand_line.close()


def live(frames: socket.socket, hand: socket.socket, choice: ArmChoice) -> None:
    """Run the arm in the new process, until the other end of its line is closed.

    Args:
        frames: Its end of the line of frames.
        hand: Its end of the hand's line; a record from this end reports that the arm runs.
        choice: The kind of arm.
    """
    end_with_the_program()
    from armui.sim.line_arm import LineArm  # noqa: PLC0415 - needed in this process only

    hand_line = RecordSocket(hand, HAND.size)
    arm = LineArm(choice, RecordSocket(frames, RECORD_BYTES), hand_line)
    hand_line.send(HAND.pack(*LETS_GO))
    raise_in_background()  # as punctual as a real arm
    arm.run()
