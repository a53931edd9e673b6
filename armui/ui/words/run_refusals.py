"""Every reason against running a trajectory, or why a run ended."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.arm.refusal_codes import RefusalCode

RUN_REFUSALS: Final[Mapping[RefusalCode, object]] = {
    RefusalCode.NO_ROWS_CHOSEN: QT_TRANSLATE_NOOP(
        "Refusal", "No row is chosen. Click one in the table first."
    ),
    RefusalCode.FINDINGS_AGAINST: QT_TRANSLATE_NOOP(
        "Refusal",
        "Not run: the check has found errors ({count}). Correct the rows listed, then send again.",
    ),
    RefusalCode.WORK_FAILED: QT_TRANSLATE_NOOP(
        "Refusal", "The program did not come to the end of its work: {text}. Try again."
    ),
    RefusalCode.MOVED_SINCE_CHECK: QT_TRANSLATE_NOOP(
        "Refusal", "Not run: the arm has moved by {value}° since it was checked. Send again."
    ),
    RefusalCode.LIMITS_CHANGED_SINCE_CHECK: QT_TRANSLATE_NOOP(
        "Refusal", "Not run: the arm's joint limits are others than those of the check. Send again."
    ),
    RefusalCode.MODEL_CHANGED_SINCE_CHECK: QT_TRANSLATE_NOOP(
        "Refusal",
        "Not run: the arm's model or zeros are others than those of the check. Send again.",
    ),
    RefusalCode.NOT_RUNNING: QT_TRANSLATE_NOOP(
        "Refusal", "No trajectory is running: nothing to pause."
    ),
    RefusalCode.NOT_PAUSED: QT_TRANSLATE_NOOP(
        "Refusal", "No trajectory is paused: nothing to go on with."
    ),
    RefusalCode.RUN_EMPTY: QT_TRANSLATE_NOOP(
        "Refusal", "“{name}” has no points. Add points, or choose another trajectory."
    ),
    RefusalCode.RUN_NO_SUCH_ROW: QT_TRANSLATE_NOOP(
        "Refusal", "There is no row {row}: the last one is {maximum}. Choose another row."
    ),
    RefusalCode.RUN_STOPPED: QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm is in emergency stop. Hold the arm, press Resume, enable the motors; then the "
        "run can go on from this row.",
    ),
    RefusalCode.RUN_UNDER_WAY: QT_TRANSLATE_NOOP(
        "Refusal",
        "A trajectory or recording is under way, be it paused or dwelling. Wait until it is done, "
        "or end the run first.",
    ),
    RefusalCode.RUN_DISABLED: QT_TRANSLATE_NOOP(
        "Refusal",
        "Motors were disabled while it ran: the arm was told to end its motion. Enable the motors; "
        "then the run can go on from this row.",
    ),
    RefusalCode.RUN_LET_GO: QT_TRANSLATE_NOOP(
        "Refusal",
        "The gripper was disabled while it ran: the arm was told to end its motion. See what it "
        "held; then the run can go on from this row.",
    ),
    RefusalCode.RUN_LEFT: QT_TRANSLATE_NOOP(
        "Refusal",
        "The device was disconnected while it ran: the arm was told before to end its motion.",
    ),
    RefusalCode.PART_FAILED: QT_TRANSLATE_NOOP(
        "Refusal",
        "The part of the program that drove it has failed: the arm was told to end its motion. "
        "Copy the details of the error, then start the program again.",
    ),
    RefusalCode.RUN_SETS_LAMPS: QT_TRANSLATE_NOOP(
        "Refusal",
        "The run under way sets the lamps itself. Wait until it is done, or end the run first.",
    ),
    RefusalCode.JOG_UNDER_WAY: QT_TRANSLATE_NOOP(
        "Refusal", "The arm is being jogged. Let go first, then press again."
    ),
    RefusalCode.PLAN_PAUSED: QT_TRANSLATE_NOOP(
        "Refusal",
        "A motion of the arm is paused: it holds back every new target. Press Continue or a Clear "
        "button under Drag teaching, Planned trajectory.",
    ),
    RefusalCode.RUN_TOO_SLOW: QT_TRANSLATE_NOOP(
        "Refusal",
        "The point was not reached within {seconds} s. See what keeps the arm, then go on from "
        "this row.",
    ),
    RefusalCode.RUN_ELSEWHERE: QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm says that it is there, but measures itself away from the point: {away}. See what "
        "keeps it, then go on from this row.",
    ),
    RefusalCode.RUN_NOT_ENDED: QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm was told to end its motion and still moves. Press the emergency stop if it must "
        "not.",
    ),
    RefusalCode.REPLAY_TOO_FAST: QT_TRANSLATE_NOOP(
        "Refusal",
        "Joint {joint} would have to turn at {value}°/s; its limit is {maximum}°/s. Replay at "
        "{percent} % of the recorded speed at most.",
    ),
    RefusalCode.REPLAY_LAGGING: QT_TRANSLATE_NOOP(
        "Refusal",
        "Joint {joint} does not follow: it is {away}° behind. See what keeps it, or replay more "
        "slowly.",
    ),
    RefusalCode.REPLAY_GAP: QT_TRANSLATE_NOOP(
        "Refusal",
        "The program or the computer stood still for {seconds} s, so the replay was ended. Let the "
        "computer do less beside it, keep it from sleeping, and start the replay anew.",
    ),
    RefusalCode.POSE_UNKNOWN: QT_TRANSLATE_NOOP(
        "Refusal", "The arm has not reported its end pose: an arc has no beginning. Wait for it."
    ),
    RefusalCode.GRIPPER_OTHER_GENERATION: QT_TRANSLATE_NOOP(
        "Refusal",
        "Row {row}: this arm's protocol moves the gripper by other figures (generation 1 by an "
        "angle, generation 2 by an opening). Change the gripper's action.",
    ),
}
