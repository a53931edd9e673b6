"""A simulated arm on a line to the program that has started its process."""

from __future__ import annotations

from typing import Final

from armui.arm.models import model_data
from armui.arm.rest_pose import rest_pose_deg
from armui.protocol.frame import Frame
from armui.protocol.frame_records import NOT_ACKNOWLEDGED, pack, unpack
from armui.sim.arm_choice import HAND, LETS_GO, ArmChoice
from armui.sim.arm_loop import ArmLoop
from armui.sim.faults.schedule import fault
from armui.sim.firmware import Firmware
from armui.system.record_socket import RecordSocket

_REMEMBERED: Final = 0
"""The received frames kept in `heard`: none, as nobody reads them here."""


class LineArm(ArmLoop):
    """One simulated arm on one line; the end of the line ends its loop.

    Args:
        choice: The kind of arm.
        line: Its end of the line of frames.
        hand_line: Its end of the line by which a hand leads it, and breaks it.
    """

    def __init__(self, choice: ArmChoice, line: RecordSocket, hand_line: RecordSocket) -> None:
        older_zeros = model_data(choice.model).older_zeros(choice.version or "")
        arm = Firmware(
            choice.generation,
            model=choice.model,
            version=choice.version,
            joints_deg=choice.joints_deg or rest_pose_deg(older_zeros=older_zeros),
        )
        super().__init__(arm, remember=_REMEMBERED, faults=(), seed=0)
        self._line = line
        self._hand_line: RecordSocket | None = hand_line

    def _receive(self) -> list[Frame]:
        self._feel_hand()
        try:
            frames = unpack(self._line.receive())
            if frames and (self.link.off or not self.firmware.is_on):
                self._line.send(pack([NOT_ACKNOWLEDGED]))
        except OSError:  # the program has closed the line, or has ended
            self._ending.set()
            return []
        return frames

    def _send(self, frames: list[Frame]) -> int:
        """Sends a burst as one message, whole or not at all."""
        try:
            self._line.send(pack(frames))
        except OSError:
            return 0
        return len(frames)

    def _feel_hand(self) -> None:
        """Carries out the hand's messages; at the end of its line the hand lets go."""
        if self._hand_line is None:
            return
        try:
            told = self._hand_line.receive()
        except OSError:
            self._hand_line = None
            told = HAND.pack(*LETS_GO)
        for name, *joints_deg, speed_deg_s in HAND.iter_unpack(told):
            if name := name.rstrip(b"\0"):
                joint, begins, *_ = joints_deg
                switch = self.faults.start if begins else self.faults.end
                switch(fault(name.decode(), joint or None))
            elif speed_deg_s:
                self.firmware.hand_guiding.lead_to(joints_deg, speed_deg_s)
            else:
                self.firmware.hand_guiding.release()
