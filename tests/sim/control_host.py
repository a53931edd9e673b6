"""A host program around piper_control, which is not the maker's: it does as standard input says.

A line in is `["what", {arguments}]` as JSON; a line out is what came of it. piper_control is used
as its own users do; only the bus below it is the test's. The program ends with its input.
"""

from __future__ import annotations

import json
import os
import sys
import time
from collections.abc import Sequence
from typing import Any

from piper_control import piper_control, piper_init, piper_interface
from piper_sdk import C_PiperInterface_V2

RATE_HZ = 200.0
PATIENCE_S = 30.0


class Host:
    """What the test may ask for."""

    def __init__(self, channel: str) -> None:
        # the SDK keeps one object a channel, so piper_control gets the one on the test's bus
        sdk = C_PiperInterface_V2(channel, judge_flag=False, can_auto_init=False)
        sdk.CreateCanBus(channel, bustype="udp_multicast", judge_flag=False)
        sdk.ConnectPort()
        self._sdk = sdk
        self._piper = piper_interface.PiperInterface(can_port=channel)

    def version(self) -> str:
        try:
            return str(self._piper.get_piper_firmware_version())
        except RuntimeError:  # not heard whole, on a busy computer: ask again
            self._sdk.SearchPiperFirmwareVersion()
            return ""

    def enable(self, *, mit: bool) -> None:
        piper_init.enable_arm(
            self._piper,
            arm_controller=(
                piper_interface.ArmController.MIT
                if mit
                else piper_interface.ArmController.POSITION_VELOCITY
            ),
            move_mode=piper_interface.MoveMode.MIT if mit else piper_interface.MoveMode.JOINT,
            timeout_seconds=PATIENCE_S,
        )

    def mit(
        self,
        target_rad: Sequence[float],
        kp: float,
        kd: float,
        torques_nm: Sequence[float],
        for_s: float,
    ) -> None:
        """Commands a pose in MIT at 200 Hz."""
        controller = piper_control.MitJointPositionController(
            self._piper, kp_gains=[kp] * 6, kd_gains=[kd] * 6, rest_position=None
        )
        controller.start()
        end_s = time.monotonic() + for_s
        while time.monotonic() < end_s:
            controller.command_joints(target_rad, torques_ff=torques_nm)
            time.sleep(1.0 / RATE_HZ)

    def positions(self) -> list[float]:
        return list(self._piper.get_joint_positions())

    def move(self, target_rad: Sequence[float], timeout_s: float) -> bool:
        """Moves with the arm's own planner; whether it got there."""
        controller = piper_control.BuiltinJointPositionController(self._piper, rest_position=None)
        controller.start()
        return bool(controller.move_to_position(target_rad, threshold=0.005, timeout=timeout_s))

    def reset(self) -> None:
        """The way out of MIT of old firmware: the arm drops, and is enabled again."""
        piper_init.reset_arm(self._piper, timeout_seconds=PATIENCE_S)


def main(channel: str) -> None:
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # the SDK prints
    host = Host(channel)
    for line in sys.stdin:
        what, arguments = json.loads(line)
        result: Any = getattr(host, what)(**arguments)
        answers.write(json.dumps(result) + "\n")
        answers.flush()


if __name__ == "__main__":
    main(sys.argv[1])
