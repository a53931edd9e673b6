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
from armui.ui.operation_area import OperationArea
from tests.desk import Desk
from tests.gallery_scenes.scene import settled

_PUSH = fault("collision", 2)

REACH_OUT_DEG = (35.0, 95.0, -70.0, 20.0, 45.0, -30.0)


def no_device(_desk: Desk) -> None:
    """The window as it opens."""


def online(desk: Desk) -> None:
    """Connected, every motor off."""
    desk.connect()


def moving(desk: Desk) -> None:
    """On the way to a target, slowly; every panel has been shown, and what it reads is read."""
    desk.connect()
    area = desk.window.findChild(OperationArea, "operation_area")
    for place in range(area.count()):
        area.show_panel(place)
        desk.step()
        settled(desk)
    _set_off(desk)


def _set_off(desk: Desk) -> None:
    desk.click("menu_motion")
    desk.enable_by_hand()
    desk.controller.motion.set_speed_percent(20)
    for joint, angle_deg in enumerate(REACH_OUT_DEG, start=1):
        desk.type_into(f"target_field_{joint}", f"{angle_deg}")
    desk.click("send_button")
    desk.run_until(lambda: desk.controller.situation.moving)
    desk.run(1.2)


def reached_out(desk: Desk) -> None:
    """At rest, at the target of `moving`."""
    desk.connect()
    _set_off(desk)
    desk.run_until(lambda: not desk.controller.situation.moving, seconds=60.0)


def refused(desk: Desk) -> None:
    """A target beyond the limits of a joint."""
    reached_out(desk)
    desk.type_into("target_field_2", "200")
    desk.click("send_button")


def stopped(desk: Desk) -> None:
    """After the emergency stop."""
    reached_out(desk)
    desk.click("load_button")
    desk.click("stop_button")
    desk.run_until(lambda: desk.controller.situation.stop is StopState.STOPPED)
    desk.run(0.3)


def run(desk: Desk) -> None:
    """A run dwells, and the panel of the motors says what it keeps from being done."""
    reached_out(desk)
    point = Waypoint(MoveMode.MOVE_J, tuple(desk.firmware.joints_deg), dwell_s=600.0)
    player = desk.controller.player
    refusal = player.start(Run("Pick up", (point,), (600.0,)))
    assert refusal is None, refusal
    desk.run_until(lambda: player.progress.phase is Phase.DWELLING)
    desk.click("menu_motor")


def offline(desk: Desk) -> None:
    """The arm has fallen silent while the jog keys were switched on."""
    reached_out(desk)
    desk.click("jog_keys_button")
    desk.find("jog_step").setCurrentIndex(1)
    desk.powered = False
    desk.run_until(lambda: "offline" in desk.codes())


def lost(desk: Desk) -> None:
    """The adapter has been pulled."""
    reached_out(desk)
    desk.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    desk.wait(lambda: desk.controller.situation.link is LinkState.LOST)


def collision(desk: Desk) -> None:
    """Something has been pushed against a joint."""
    _enabled(desk)
    desk.node.faults.start(_PUSH)
    _until(desk, Kind.COLLISION)


def teaching(desk: Desk) -> None:
    """The arm is led by hand and recorded."""
    _enabled(desk)
    desk.click("menu_teaching")
    desk.click("teaching_start_recording")
    desk.confirm()
    _until(desk, Kind.RECORDING)
    desk.firmware.hand.lead_to(REACH_OUT_DEG)
    desk.run(2.0)


def way_out(desk: Desk) -> None:
    """The recording has ended; the arm is still led by hand."""
    teaching(desk)
    desk.click("teaching_stop_recording")
    _until(desk, Kind.DRAG_MODE)
    desk.run(0.2)


def _enabled(desk: Desk) -> None:
    desk.connect()
    desk.click("menu_motion")
    desk.enable_by_hand()


def _until(desk: Desk, kind: Kind) -> None:
    desk.run_until(lambda: desk.controller.recovery.step.kind is kind)
