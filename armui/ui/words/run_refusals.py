"""Every reason against running a trajectory, or why a run ended."""

from __future__ import annotations

from typing import Final

from armui.arm.refusal_codes import RefusalCode
from armui.ui.words.text import Texts

RUN_REFUSALS: Final = Texts("Refusal") | {
    RefusalCode.NO_ROWS_CHOSEN: "No row is chosen. Click one in the table first.",
    RefusalCode.FINDINGS_AGAINST: (
        "Not run: the check has found errors ({count}). Mend what is listed, then send again."
    ),
    RefusalCode.WORK_FAILED: "The program did not come to the end of its work: {text}. Try again.",
    RefusalCode.MOVED_SINCE_CHECK: (
        "Not run: the arm has moved by {value}° since it was checked. Send again."
    ),
    RefusalCode.LIMITS_CHANGED_SINCE_CHECK: (
        "Not run: the arm's joint limits are others than those of the check. Send again."
    ),
    RefusalCode.MODEL_CHANGED_SINCE_CHECK: (
        "Not run: the arm's model or zeros are others than those of the check. Send again."
    ),
    RefusalCode.CHANGED_SINCE_CHECK: (
        "Not run: tool, load, settings or choices are others than those of the check. Send again."
    ),
    RefusalCode.NOT_RUNNING: "No trajectory is running: nothing to pause.",
    RefusalCode.NOT_PAUSED: "No trajectory is paused: nothing to go on with.",
    RefusalCode.RUN_EMPTY: "“{name}” has no points. Add points, or choose another trajectory.",
    RefusalCode.RUN_NO_SUCH_ROW: (
        "There is no row {row}: the last one is {maximum}. Choose another row."
    ),
    RefusalCode.RUN_STOPPED: (
        "The arm is in emergency stop. Hold the arm, press Resume, enable the motors; then the "
        "run can go on from this row."
    ),
    RefusalCode.RUN_UNDER_WAY: (
        "A trajectory or recording is under way, be it paused or dwelling. Wait until it is done, "
        "or end the run first."
    ),
    RefusalCode.RUN_DISABLED: (
        "Motors were disabled while it ran: the arm was told to end its motion. Enable the motors; "
        "then the run can go on from this row."
    ),
    RefusalCode.RUN_LET_GO: (
        "The gripper was disabled while it ran: the arm was told to end its motion. See what it "
        "held; then the run can go on from this row."
    ),
    RefusalCode.RUN_LEFT: (
        "The device was disconnected while it ran: the arm was told before to end its motion."
    ),
    RefusalCode.PART_FAILED: (
        "A part of the program has failed: every motion of this program ends, and none begins "
        "while it fails. Copy the details of the error, then start the program again."
    ),
    RefusalCode.SYSTEM_ENDS: (
        "The computer was about to sleep, or to end this program: the arm was told before to end "
        "its motion."
    ),
    RefusalCode.RUN_SETS_LAMPS: (
        "The run under way sets the lamps itself. Wait until it is done, or end the run first."
    ),
    RefusalCode.JOG_UNDER_WAY: "The arm is being jogged. Let go first, then press again.",
    RefusalCode.PLAN_PAUSED: (
        "A motion of the arm is paused: it holds back every new target. Press Continue or a Clear "
        "button under Drag teaching, Planned trajectory."
    ),
    RefusalCode.RUN_TOO_SLOW: (
        "The point was not reached within {seconds} s. See what keeps the arm, then go on from "
        "this row."
    ),
    RefusalCode.RUN_ELSEWHERE: (
        "The arm says that it is there, but measures itself away from the point: {away}. See what "
        "keeps it, then go on from this row."
    ),
    RefusalCode.RUN_NOT_ENDED: (
        "The arm was told to end its motion and still moves. Press the emergency stop if it must "
        "not."
    ),
    RefusalCode.REPLAY_TOO_FAST: (
        "Joint {joint} would have to turn at {value}°/s; its limit is {maximum}°/s. Replay at "
        "{percent} % of the recorded speed at most."
    ),
    RefusalCode.REPLAY_LAGGING: (
        "Joint {joint} does not follow: it is {away}° behind. See what keeps it, or replay more "
        "slowly."
    ),
    RefusalCode.REPLAY_GAP: (
        "The program or the computer stood still for {seconds} s, so the replay was ended. Let the "
        "computer do less beside it, keep it from sleeping, and start the replay anew."
    ),
    RefusalCode.POSE_UNKNOWN: (
        "The arm has not reported its end pose: an arc has no beginning. Wait for it."
    ),
    RefusalCode.GRIPPER_OTHER_GENERATION: (
        "Row {row}: this arm's protocol moves the gripper by other figures (generation 1 by an "
        "angle, generation 2 by an opening). Change the gripper's action."
    ),
}
