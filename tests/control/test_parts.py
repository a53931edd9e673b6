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


@pytest.mark.parametrize("act", ["halt", "advance"])
@pytest.mark.parametrize("part", ["motors", "motion", "gripper", "recorder", "orders", "settings"])
def test_a_stop_ends_a_jog_whatever_else_fails(bench, monkeypatch, part, act):
    joint_jog(bench)
    monkeypatch.setattr(getattr(bench.controller, part), act, fail)
    bench.ear = HardOfHearing(bench.firmware)
    bench.run(0.1)
    assert bench.controller.jogging.active
    bench.controller.emergency_stop()
    bench.step()
    assert STOP in bench.ear.heard
    assert not bench.controller.jogging.active
    bench.run_until(lambda: "stop_confirmed" in bench.codes())
    assert bench.codes().count("part_failed") == 1


def test_a_stop_ends_a_run_when_its_own_part_fails(bench, monkeypatch):
    bench.ready()
    run_moving(bench)
    monkeypatch.setattr(bench.controller.player, "advance", fail)
    bench.run(0.1)
    bench.controller.emergency_stop()
    assert phase(bench).name == "FAILED"
    bench.run_until(lambda: "stop_confirmed" in bench.codes())


def test_a_stop_is_repeated_while_the_link_itself_fails(bench, monkeypatch):
    bend(bench)
    bench.ear = HardOfHearing(bench.firmware)
    bench.ear.deaf_to = {STOP.arbitration_id}
    bench.controller.emergency_stop()
    monkeypatch.setattr(bench.controller._connection, "advance", fail)
    bench._settle()
    bench.heard()
    bench.time_s += 0.2
    with pytest.raises(RuntimeError, match="on purpose"):
        bench.controller.tick()
    assert bench.heard() == [STOP]
    monkeypatch.undo()


@pytest.mark.parametrize("error", [ValueError("driver"), AttributeError("driver")])
def test_a_driver_that_raises_anything_does_not_keep_the_program_from_stopping(
    bench, monkeypatch, error
):
    joint_jog(bench)

    def broken(*_args, **_kwargs):
        raise error

    monkeypatch.setattr(bench._host_bus, "send", broken)
    bench.controller.emergency_stop()
    assert not bench.controller.jogging.active
    assert "stop_not_sent" in bench.codes()
    bench.broken = can.CanOperationError("gone")  # the bus thread notices by itself
