"""Draws when something has changed, and only then."""

import pickle
from dataclasses import replace

import numpy as np
import pytest

from armui.arm.refusal import Refusal
from armui.system.paths import URDF
from armui.viewport.process import frame_painter
from armui.viewport.process.frame_painter import FramePainter
from armui.viewport.process.urdf_file import URDF_JOINT_COUNT
from armui.viewport.view_state import PickRequest, RobotChoice, ViewState
from tests.viewport.foreign import write_arm

STATE = ViewState(
    RobotChoice(URDF / "piper" / "piper.urdf"),
    width_px=240,
    height_px=180,
    angles_deg=(0.0,) * 6,
    gripper_mm=0.0,
)


class PainterRig:
    """A painter and what it told."""

    def __init__(self) -> None:
        self.failures: list[Refusal] = []
        self.picked: list[int | None] = []
        self.marks: list[int] = []
        self.painter = FramePainter(self.failures.append, self.picked.append, self.marks.append)


@pytest.fixture
def rig():
    rig = PainterRig()
    yield rig
    rig.painter.close()


def test_an_unchanged_state_is_not_drawn_again(rig):
    assert rig.painter.paint(STATE).size_px == (240, 180)
    assert (
        rig.painter.paint(
            replace(
                STATE,
            )
        )
        is None
    )
    assert rig.painter.paint(replace(STATE, angles_deg=(1.0,) * 6)) is not None


@pytest.mark.parametrize(
    "change",
    [
        {"width_px": 200},
        {"camera": STATE.camera.orbit(5.0, 0.0)},
        {"palette": replace(STATE.palette, background="#101010")},
        {"gripper_mm": 70.0},
        {"stale": True},
        {"highlighted_joint": 2},
        {"angles_deg": None},
    ],
)
def test_each_change_gives_another_picture(rig, change):
    before = rig.painter.paint(STATE).top_down()
    after = rig.painter.paint(replace(STATE, **change)).top_down()
    assert after.shape != before.shape or (after != before).any()


def test_a_question_is_answered_once_and_draws_nothing(rig):
    rig.painter.paint(STATE)
    asked = replace(STATE, pick=PickRequest(1, 0.0, 0.0))
    assert rig.painter.paint(asked) is None
    assert rig.painter.paint(asked) is None
    assert rig.picked == [None]
    rig.painter.paint(replace(STATE, pick=PickRequest(2, 0.0, 0.0)))
    assert rig.picked == [None, None]


def test_a_robot_that_fails_is_told_and_the_old_one_stays(rig, tmp_path):
    before = rig.painter.paint(STATE).top_down()
    path = write_arm(tmp_path, hinges=3)
    after = rig.painter.paint(replace(STATE, robot=RobotChoice(path))).top_down()
    np.testing.assert_array_equal(before, after)
    (failure,) = rig.failures
    assert failure == URDF_JOINT_COUNT(path=str(path), found=3, wanted=6)


def test_the_same_file_is_read_again_when_asked_again(rig, tmp_path):
    path = write_arm(tmp_path, hinges=3)
    rig.painter.paint(replace(STATE, robot=RobotChoice(path, 0)))
    write_arm(tmp_path)
    rig.painter.paint(replace(STATE, robot=RobotChoice(path, 1)))
    assert len(rig.failures) == 1


def test_slow_smoothing_waits_until_the_picture_rests(rig, monkeypatch):
    monkeypatch.setattr(frame_painter, "_CHEAP_FRAME_S", 0.0)
    rough = rig.painter.paint(STATE).top_down()
    assert rig.painter.is_rough
    fine = rig.painter.refine().top_down()
    assert (fine != rough).any()
    assert not rig.painter.is_rough
    assert rig.painter.refine() is None
    rig.painter.paint(replace(STATE, stale=True))
    assert rig.painter.is_rough


def test_cheap_smoothing_is_used_at_once(rig, monkeypatch):
    monkeypatch.setattr(frame_painter, "_CHEAP_FRAME_S", 1e9)
    rig.painter.paint(STATE)
    rig.painter.refine()
    rig.painter.paint(replace(STATE, stale=True))
    assert not rig.painter.is_rough


def test_a_robot_that_was_read_before_is_not_read_again(rig, tmp_path):
    path = write_arm(
        tmp_path, visual='<visual><geometry><sphere radius="0.05"/></geometry></visual>'
    )
    state = replace(STATE, robot=RobotChoice(path))
    first = rig.painter.paint(state).top_down()
    known = pickle.loads(pickle.dumps(rig.painter.robot))
    path.unlink()
    later = PainterRig()
    np.testing.assert_array_equal(later.painter.paint(state, known).top_down(), first)
    later.painter.close()
    assert not later.failures


def test_the_image_is_written_as_windows_are_painted(rig):
    pixels = rig.painter.paint(STATE)
    target = bytearray(pixels.nbytes)
    assert pixels.copy_to(memoryview(target)) == (240, 180)
    written = np.frombuffer(target, np.uint8).reshape(180, 240, 4)
    # blue, green, red in memory is what a 0xffRRGGBB word is on every computer Qt runs on today
    np.testing.assert_array_equal(written[:, :, [2, 1, 0]], pixels.top_down()[:, :, :3])
