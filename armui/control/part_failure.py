"""What is ended when a part of the program has failed: the motion it was in charge of, no other."""

from __future__ import annotations

import logging
from collections.abc import Callable, Collection
from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.protocol.codes import TrajectoryCommand

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController

_LOG: Final = logging.getLogger(__name__)

_JOGS: Final = frozenset(
    {
        *(
            "armui.control.motion.jogging",
            "armui.control.motion.jog_stream",
            "armui.control.motion.jog_path",
            "armui.control.motion.steered_path",
            "armui.control.gamepad.pilot",
        ),
        *(
            "armui.control.motion.jog_pace",
            "armui.ui.widgets.jog_button",
            "armui.ui.panels.jogging.jog_panel",
        ),
    }
)
_RUNS: Final = frozenset(
    {
        *("armui.control.run.player", "armui.control.run.execution", "armui.control.run.progress"),
        *("armui.control.run.arrival", "armui.control.motion.point_frames"),
        *("armui.ui.trajectory.running.run_strip", "armui.ui.trajectory.running.runner"),
    }
)
_REPLAYS: Final = frozenset(
    {
        *("armui.control.run.replayer", "armui.control.run.replay"),
        "armui.ui.trajectory.recording.recording_page",
    }
)
_SINGLE_MOTIONS: Final = frozenset(
    {
        *(
            "armui.control.motion.joint_motion",
            "armui.control.motion.cartesian",
            "armui.control.motion.planned_motion",
        ),
        *("armui.control.authority", "armui.control.context", "armui.control.safety.overspeed"),
        "armui.control.devices.gripper",
        *("armui.ui.panels.jogging.motion_panel", "armui.ui.panels.jogging.cartesian_panel"),
    }
)
"""The modules of each kind of motion, from the button to the frames."""


def end_motion_of(controller: ArmController, modules: Collection[str]) -> None:
    """End what the failed modules drive; the arm comes to rest and keeps its power.

    Whatever fails meanwhile ends nothing else: where a part cannot end its motion itself, the arm
    is told to end it (终止, 0x150 byte 1 = 6).
    """
    failed = set(modules)
    streams = (controller.jogging.active, controller.player.running, controller.replayer.running)
    reason = Refusal(RefusalCode.PART_FAILED)
    if failed & _JOGS and controller.jogging.active:
        _have(controller, controller.jogging.stop)
    if failed & _RUNS and controller.player.running:
        _have(controller, lambda: controller.player.end(reason))
    if failed & _REPLAYS and controller.replayer.running:
        _have(controller, lambda: controller.replayer.end(reason))
    if failed & _SINGLE_MOTIONS and controller.operating_state.moving and not any(streams):
        _abort(controller)


def _have(controller: ArmController, end: Callable[[], object]) -> None:
    try:
        end()
    except Exception:  # noqa: BLE001 - it has failed before, anything may come
        _LOG.exception("A part that failed could not end its motion")
        _abort(controller)


def _abort(controller: ArmController) -> None:
    try:
        controller.planned_motion.command(TrajectoryCommand.ABORT)
    except Exception:  # noqa: BLE001 - as above
        _LOG.exception("The motion of a part that failed could not be ended")
