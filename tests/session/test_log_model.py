"""Which arm of the family a log holds: by its poses, or as its recording says."""

from __future__ import annotations

import json
from typing import Any

import pytest

from armui.arm.device import RecordedArm
from armui.cell.cell_in_force import CellInForce, to_entry
from armui.cell.held_objects import HeldObject
from armui.cell.placement import Placement
from armui.cell.user_frames import UserFrame
from armui.cell.work_area import Area, AreaBox, AreaPlane
from armui.control.log_replay import LogReplay
from armui.protocol.generation import Generation, PiperModel
from armui.session.log_model import told_cell, told_model
from armui.session.survey import survey
from armui.sim.firmware import Firmware
from tests.family import MODELS
from tests.session.indexed import open_indexed
from tests.session.recordings import START_S, write
from tests.waiting import wait_until

LEANING_DEG = (10.0, 60.0, -60.0, 5.0, 30.0, 0.0)


def log_of(path, model, version="S-V1.8-9"):
    arm = Firmware(Generation.TWO, joints_deg=LEANING_DEG, model=model, version=version)
    heard = [(START_S + n * 0.01, frame) for n in range(100) for frame in arm.step(0.01)]
    write(path, heard)
    return open_indexed(path)


@pytest.mark.parametrize("version", ["S-V1.8-9", "S-V1.5-2"])
@pytest.mark.parametrize("model", MODELS)
def test_the_poses_in_a_log_tell_the_model(tmp_path, model, version):
    session = log_of(tmp_path / "arm.blf", model, version)

    assert survey(session)[0].model is model
    session.close()


def test_the_replay_shows_the_model_of_the_log(qapp, tmp_path):
    session = log_of(tmp_path / "arm.blf", PiperModel.PIPER_L)
    own = survey(session)[0]
    arm = RecordedArm(int(own.generation), own.feedback_offset, own.firmware, own.model)
    replay = LogReplay(session, own.channel, arm, "arm.blf")

    replay.open()

    assert replay.controller.operating_state.model is PiperModel.PIPER_L
    replay.close()
    session.close()


@pytest.mark.parametrize("version", ["S-V1.8-9", "S-V1.5-2"])
def test_the_replay_has_the_zeros_of_the_log_while_it_stands_still(qapp, tmp_path, version):
    """The log names no version: its poses tell."""
    session = log_of(tmp_path / "arm.blf", PiperModel.PIPER, version)
    own = survey(session)[0]
    assert own.older_zeros is (version == "S-V1.5-2")
    arm = RecordedArm(
        int(own.generation), own.feedback_offset, own.firmware, own.model, own.older_zeros
    )
    replay = LogReplay(session, own.channel, arm, "arm.blf")
    replay.open()
    wait_until(lambda: not replay.is_travelling)

    controller = replay.controller
    assert controller.operating_state.model_fit.older_zeros is (version == "S-V1.5-2")
    angles_deg = controller.state.angles_deg()
    assert angles_deg is not None
    shown = controller.cartesian.kinematics().forward(angles_deg)
    assert tuple(shown) == pytest.approx(controller.state.end_pose(), abs=0.06)
    replay.close()
    session.close()


def test_the_sidecar_of_a_recording_says_what_was_chosen():
    lines = [
        {"kind": "session", "model": "piper_h"},
        {"kind": "arm", "model": "piper"},
        {"kind": "arm", "model": "piper_x"},
        {"kind": "arm"},
        {"kind": "event"},
    ]
    assert told_model(lines) is PiperModel.PIPER_X
    assert told_model([{"kind": "arm", "model": "nero"}, {"kind": "arm", "model": 3}]) is None
    assert told_model([]) is None


def cell_line(**changes):
    figures = dict.fromkeys(("x_mm", "y_mm", "rx_deg", "ry_deg", "rz_deg", "radius_mm"), 0.0)
    return {
        "kind": "cell",
        "cell": "a",
        "tool": {"name": "pen", **figures, "z_mm": 90.0, **changes},
    }


def told_tool(lines):
    return told_cell(lines).tool.pose


def test_the_tool_of_a_recording_is_the_one_that_held_all_through():
    pen, none = (0.0, 0.0, 90.0, 0.0, 0.0, 0.0), (0.0,) * 6
    assert told_tool([{"kind": "arm"}, cell_line()]) == pen
    assert told_tool([cell_line(), cell_line(name="pencil")]) == pen
    assert told_tool([cell_line(), cell_line(z_mm=91.0)]) == none
    assert told_tool([cell_line(z_mm="far")]) == none
    assert told_tool([cell_line(z_mm=9000.0)]) == none
    assert told_tool([{"kind": "cell", "tool": 3}]) == none
    assert told_tool([]) == none


PARTS: dict[str, Any] = {
    "held": HeldObject("cube", size_mm=(30.0, 40.0, 50.0)),
    "area": Area((AreaPlane("table"),), (AreaBox("crate", (300.0, 0.0, 50.0, 0.0, 0.0, 20.0)),)),
    "frame": UserFrame("tray", (300.0, 100.0, 20.0, 0.0, 0.0, 30.0)),
    "placement": Placement((1000.0, 0.0, 750.0, 0.0, 0.0, 90.0)),
}


@pytest.mark.parametrize("part", PARTS)
def test_what_else_held_of_the_cell_is_told_if_it_held_all_through(part):
    wanted, nothing = PARTS[part], getattr(CellInForce(), part)

    def told(*lines):
        return getattr(told_cell(lines), part)

    line = {"kind": "cell", **to_entry(CellInForce("a", **{part: wanted}))}
    assert told({"kind": "arm"}, line, line) == wanted
    assert told_cell([line]) == CellInForce("a", **{part: wanted})
    assert told(line, cell_line()) == nothing
    assert told(cell_line()) == nothing
    broken = json.loads(json.dumps(line[part]).replace(": 0.0", ": 9e9"))
    assert told({**line, part: broken}) == nothing
    assert told({**line, part: "cube"}) == nothing
    assert told({**line, part: None}) == nothing


def test_a_replay_shows_the_pose_of_the_tool_that_held(qapp, tmp_path):
    tool = (0.0, 0.0, 90.0, 0.0, 0.0, 0.0)
    session = log_of(tmp_path / "arm.blf", PiperModel.PIPER)
    channel = survey(session)[0].channel
    replay = LogReplay(session, channel, RecordedArm(2, tool=tool), "arm.blf")
    replay.open()
    assert replay.controller.cartesian.tool == tool
    replay.close()
    session.close()
