"""What the controller's parts are doing, gathered for the assessment."""

from __future__ import annotations

from typing import TYPE_CHECKING

from armui.control.assessment import Activity, AssessmentInputs
from armui.control.operating_state import Busy

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.control.authority import Authority
    from armui.control.link.connection import Connection
    from armui.control.operating_state import OtherHostReport
    from armui.control.safety.stopping import Stopping


def assessment_inputs(
    controller: ArmController,
    connection: Connection,
    stopping: Stopping,
    *,
    authority: Authority,
    other_host: OtherHostReport | None,
    now_s: float,
) -> AssessmentInputs:
    """What the program knows beside the arm's own words at monotonic time ``now_s``."""
    busy = controller.motors.busy or (Busy.ZEROING if controller.zeroing.busy else None)
    keeper = stopping.keeper
    return AssessmentInputs(
        link=connection.link,
        device=connection.device,
        link_problem=connection.problem,
        stop=stopping.state(controller.state, now_s, resuming=busy is Busy.RESUMING),
        stop_unconfirmed=keeper.unconfirmed(now_s),
        stop_lapsed=keeper.lapsed,
        busy=busy,
        speed_percent=controller.motion.speed_percent,
        generation=connection.generation,
        offsets=connection.offsets,
        authority=authority,
        other_host=other_host,
        activity=Activity(
            running=controller.player.running or controller.replayer.running,
            jogging=controller.jogging.active,
            recording=controller.recorder.recording,
            altering=controller.orders.altering,
            run_sets_lamps=controller.player.sets_lamps,
        ),
    )
