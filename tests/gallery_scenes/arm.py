"""The arm in the states an operator meets: online, moving, stopped, silent, and what leads out."""

from __future__ import annotations

import errno

import can

from armui.control.recovery_steps import Kind
from armui.control.run import Phase, Run
from armui.control.situation import LinkState, StopState
from armui.protocol.codes import MoveMode
from armui.sim.faults import fault
from armui.trajectory.program import Waypoint
from tests.desk import Desk

_PUSH = fault("collision", 2)

REACH_OUT_DEG = (35.0, 95.0, -70.0, 20.0, 45.0, -30.0)


def no_device(_desk: Desk) -> None:
    """The window as it opens."""


def online(desk: Desk) -> None:
    desk.connect()


def moving(desk: Desk) -> None:
    desk.click("collision_cancel_button")
    desk.click("menu_motion")
    desk.enable_by_hand()
    desk.controller.motion.set_speed_percent(20)
    for joint, angle_deg in enumerate(REACH_OUT_DEG, start=1):
        desk.type_into(f"target_field_{joint}", f"{angle_deg}")
    desk.click("send_button")
    desk.run_until(lambda: desk.controller.situation.moving)
    desk.run(1.2)


def refused(desk: Desk) -> None:
    desk.run_until(lambda: not desk.controller.situation.moving, seconds=60.0)
    desk.type_into("target_field_2", "200")
    desk.click("send_button")


def stopped(desk: Desk) -> None:
    desk.plug_in()
    desk.wait(lambda: desk.controller.situation.link is not LinkState.LOST)
    desk.run_until(lambda: desk.controller.situation.cannot_enable is None)
    desk.click("load_button")
    desk.click("stop_button")
    desk.run_until(lambda: desk.controller.situation.stop is StopState.STOPPED)
    desk.run(0.3)


def run(desk: Desk) -> None:
    """A run dwells, and the panel of the motors says what it keeps from being done."""
    point = Waypoint(MoveMode.MOVE_J, tuple(desk.firmware.joints_deg), dwell_s=600.0)
    player = desk.controller.player
    player.start(Run("Pick up", (point,), (600.0,)))
    desk.run_until(lambda: player.progress.phase is Phase.DWELLING)
    desk.click("menu_motor")


def offline(desk: Desk) -> None:
    desk.controller.end_motion()
    desk.run_until(lambda: not desk.controller.player.running)
    desk.click("menu_motion")
    desk.click("jog_keys_button")
    desk.find("jog_step").setCurrentIndex(1)
    desk.run(0.2)  # what a dialog's scene did to the arm is over before it falls silent
    desk.powered = False
    desk.run_until(lambda: "offline" in desk.codes())
    desk.powered = True


def lost(desk: Desk) -> None:
    desk.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    desk.wait(lambda: desk.controller.situation.link is LinkState.LOST)


def collision(desk: Desk) -> None:
    desk.click("recovery_button")
    desk.confirm()
    _until(desk, Kind.MOTORS_OFF)
    desk.click("recovery_button")
    _until(desk, Kind.READY)
    desk.node.faults.start(_PUSH)
    _until(desk, Kind.COLLISION)


def teaching(desk: Desk) -> None:
    desk.node.faults.end(_PUSH)
    desk.run(0.1)
    desk.click("recovery_button")
    _until(desk, Kind.READY)
    desk.click("menu_teaching")
    desk.click("teaching_start_recording")
    desk.confirm()
    _until(desk, Kind.RECORDING)
    desk.firmware.hand.lead_to(REACH_OUT_DEG)
    desk.run(2.0)


def way_out(desk: Desk) -> None:
    desk.click("teaching_stop_recording")
    _until(desk, Kind.DRAG_MODE)
    desk.run(0.2)


def _until(desk: Desk, kind: Kind) -> None:
    desk.run_until(lambda: desk.controller.recovery.step.kind is kind)
