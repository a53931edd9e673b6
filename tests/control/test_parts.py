"""A part of the program that fails must not keep the stop, or another part, from working."""

import can
import pytest

from armui.protocol.frame import Frame
from tests.control.jogger import bend
from tests.control.under_way import joint_jog, phase, run_moving
from tests.faulty_arm import HardOfHearing

STOP = Frame(0x150, bytes.fromhex("01 00 00 00 00 00 00 00"))


def fail(*_args, **_kwargs):
    raise RuntimeError("on purpose")


@pytest.mark.each_value(full="each part with both ends")
@pytest.mark.parametrize("act", ["halt", "follow_arm"])
@pytest.mark.parametrize(
    "part", ["motors", "motion", "gripper", "recorder", "transactions", "settings"]
)
def test_a_stop_ends_a_jog_whatever_else_fails(rig, monkeypatch, part, act):
    joint_jog(rig)
    monkeypatch.setattr(getattr(rig.controller, part), act, fail)
    rig.ear = HardOfHearing(rig.firmware)
    if act == "halt":
        rig.run(0.1)
        assert rig.controller.jogging.active
    rig.controller.emergency_stop()
    rig.step()
    assert STOP in rig.ear.heard
    assert not rig.controller.jogging.active
    rig.run_until(lambda: "stop_confirmed" in rig.codes())
    assert rig.codes().count("part_failed") == 1


def test_a_stop_ends_a_run_when_its_own_part_fails(rig, monkeypatch):
    rig.ready()
    run_moving(rig)
    monkeypatch.setattr(rig.controller.player, "follow_arm", fail)
    rig.run(0.1)
    assert phase(rig).name == "FAILED"
    rig.controller.emergency_stop()
    rig.run_until(lambda: "stop_confirmed" in rig.codes())


def test_a_stop_is_repeated_while_the_link_itself_fails(rig, monkeypatch):
    bend(rig)
    rig.ear = HardOfHearing(rig.firmware)
    rig.ear.deaf_to = {STOP.arbitration_id}
    rig.controller.emergency_stop()
    rig.controller._timer.stop()  # on a slow computer it would tick meanwhile
    monkeypatch.setattr(rig.controller._connection, "follow_arm", fail)
    rig._settle()
    rig.heard()
    rig.time_s += 0.2
    rig.controller.tick()
    assert rig.heard() == [STOP]
    monkeypatch.undo()


@pytest.mark.parametrize("error", [ValueError("driver"), AttributeError("driver")])
def test_a_driver_that_raises_anything_does_not_keep_the_program_from_stopping(
    rig, monkeypatch, error
):
    joint_jog(rig)

    def broken(*_args, **_kwargs):
        raise error

    monkeypatch.setattr(rig._host_bus, "send", broken)
    rig.controller.emergency_stop()
    assert not rig.controller.jogging.active
    assert "stop_not_sent" in rig.codes()
    rig.broken = can.CanOperationError("gone")  # the bus thread notices by itself
