"""Why something cannot be done now, asked of the controller: its button need not exist for that."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.control.operating_state import LinkState
from armui.protocol.codes import TeachingState, TrajectoryCommand
from armui.ui import words
from armui.ui.actions.command import Command, Need

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController


def why_not(action: Command, controller: ArmController) -> str:
    """The reason in words; empty: it can be done."""
    if action.need is Need.EDITING:
        return QCoreApplication.translate("Action", "Press Edit in the panel first.")
    return words.why_not(_refusal(action, controller))


def _refusal(action: Command, controller: ArmController) -> Refusal | None:
    now = controller.operating_state
    if action.need is Need.NOTHING:
        return None
    if action.need is Need.ANGLES:
        known = controller.state.angles_deg() is not None
        return None if known else Refusal(RefusalCode.JOINTS_UNKNOWN)
    if action.need is Need.POSE:
        known = controller.state.end_pose() is not None
        return None if known else Refusal(RefusalCode.POSE_UNKNOWN)
    if action.need is Need.LINKAGE and now.link is LinkState.OFFLINE:
        return now.occupied  # an arm that only speaks under other identifiers can be told
    if now.unreachable is not None:
        return now.unreachable
    return _ASKED[action.need](controller, action)


def _of_teaching(controller: ArmController, action: Command) -> Refusal | None:
    name = action.target.removeprefix("teaching_").upper()
    return controller.teaching.why_not(TeachingState[name])


def _of_plan(controller: ArmController, action: Command) -> Refusal | None:
    name = action.target.removeprefix("plan_").upper()
    return controller.planned_motion.why_not(TrajectoryCommand[name])


def _busy(controller: ArmController) -> Refusal | None:
    if not controller.settings.busy:
        return None
    return Refusal(RefusalCode.BUSY, {"what": "settings"})


_Ask = Callable[["ArmController", Command], Refusal | None]

_ASKED: Final[Mapping[Need, _Ask]] = {
    Need.MOVE: lambda arm, _action: arm.operating_state.cannot_move,
    Need.SWITCH_ON: lambda arm, _action: arm.operating_state.cannot_switch_on,
    Need.SWITCH_OFF: lambda arm, _action: arm.operating_state.cannot_enable,
    Need.ZERO: lambda arm, _action: arm.zeroing.why_not(),
    Need.CLEAR: lambda arm, _action: arm.operating_state.occupied,
    Need.LAMPS: lambda arm, _action: arm.operating_state.cannot_set_lamps,
    Need.LINKAGE: lambda arm, _action: arm.operating_state.occupied,
    Need.REACH: lambda _arm, _action: None,
    Need.REACH_FREE: lambda arm, _action: arm.operating_state.occupied,
    Need.SETTINGS: lambda arm, _action: _busy(arm),
    Need.SETTINGS_FREE: lambda arm, _action: _busy(arm) or arm.operating_state.occupied,
    Need.GRIPPER_MOVE: lambda arm, _action: arm.gripper.why_not(moving=True),
    Need.GRIPPER: lambda arm, _action: arm.gripper.why_not(moving=False),
    Need.GRIPPER_LET_GO: lambda arm, _action: arm.gripper.why_not(moving=False, letting_go=True),
    Need.TEACHING: _of_teaching,
    Need.PLAN: _of_plan,
}
