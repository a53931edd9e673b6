"""An operator with a gamepad before the whole program, and time in the test's hand."""

from __future__ import annotations

from armui.arm.refusal import Reason, Refusal
from armui.control.gamepad.pilot import GamepadPilot
from armui.gamepad.device_state import DeviceInfo
from tests.app_driver import AppDriver
from tests.arm_rig import ArmRig
from tests.control.jogger import TICK_S, bend
from tests.gamepad.pads import PAD, Pads, switch_on

STREAM = {0x155, 0x156, 0x157}


def pass_time(rig: ArmRig, seconds: float) -> None:
    """Let time pass; the pilot looks as often as its own timer would have it look."""
    for _ in range(round(seconds / TICK_S)):
        rig.step(TICK_S)
        rig.controller.gamepad.tick()


def angles(rig: ArmRig) -> list[float]:
    """Where the simulated arm is."""
    return [round(angle, 3) for angle in rig.firmware.joints_deg]


def pick_up(
    app_driver: AppDriver, pads: Pads, info: DeviceInfo = PAD, dead_man: str = "left_shoulder"
) -> None:
    """Plug a device in, wait until it was seen at rest, press its dead-man button."""
    pads.plug_in(info)
    pass_time(app_driver, 0.02)
    pads.press(dead_man, info=info)
    pass_time(app_driver, 0.02)


def drive(app_driver: AppDriver, pads: Pads, seconds: float = 0.3, **axes: float) -> None:
    """Push axes for a while; the arm has moved then."""
    before = angles(app_driver)
    pads.push(PAD, **(axes or {"left_x": -1.0, "right_trigger": 1.0}))  # type: ignore[arg-type]  # axes only
    pass_time(app_driver, seconds)
    assert app_driver.controller.jogging.active
    assert angles(app_driver) != before


def is_sent_nothing(app_driver: AppDriver, seconds: float = 0.3) -> bool:
    """Whether no setpoint goes out and the arm stays, although fingers are still down."""
    before = angles(app_driver)
    app_driver.heard()
    pass_time(app_driver, seconds)
    sent = {frame.arbitration_id for frame in app_driver.heard()} & STREAM
    return not sent and angles(app_driver) == before


def held_ready(app_driver: AppDriver, pads: Pads) -> AppDriver:
    """Bent, at 100 %, the window in front, gamepads switched on, the dead-man button held."""
    app_driver.window.activateWindow()
    bend(app_driver)
    switch_on(app_driver.program, pads)
    pick_up(app_driver, pads)
    app_driver.heard()
    return app_driver


def pilot(app_driver: AppDriver) -> GamepadPilot:
    """Who follows the devices."""
    return app_driver.controller.gamepad


def reasons(app_driver: AppDriver) -> list[Reason]:
    """Why jogs have ended."""
    found: list[Reason] = []
    for event in app_driver.events:
        if event.code == "jog_ended":
            reason = event.params["reason"]
            assert isinstance(reason, Refusal)
            found.append(reason.reason)
    return found
