"""Draws when something has changed, and only then."""

import gc
from dataclasses import replace

import numpy as np
import pytest

from armui.arm.refusal import Refusal
from armui.paths import URDF
from armui.viewport.process import frame_painter
from armui.viewport.process.frame_painter import FramePainter
from armui.viewport.view_state import PickRequest, RobotChoice, ViewState
from tests.viewport.foreign import write_arm

STATE = ViewState(
    RobotChoice(URDF / "piper.urdf"),
    width_px=240,
    height_px=180,
    angles_deg=(0.0,) * 6,
    gripper_mm=0.0,
)


class Desk:
    """A painter and what it told."""

    def __init__(self) -> None:
        self.failures: list[Refusal] = []
        self.picked: list[int | None] = []
        self.marks: list[int] = []
        self.painter = FramePainter(self.failures.append, self.picked.append, self.marks.append)


@pytest.fixture
def desk():
    desk = Desk()
    yield desk
    desk.painter.close()


def test_an_unchanged_state_is_not_drawn_again(desk):
    assert desk.painter.paint(STATE).shape == (180, 240, 4)
    assert desk.painter.paint(replace(STATE)) is None
    assert desk.painter.paint(replace(STATE, angles_deg=(1.0,) * 6)) is not None


def test_garbage_is_collected_again_once_the_libraries_are_loaded():
    with frame_painter._no_garbage_collection():
        assert not gc.isenabled()
    assert gc.isenabled()
    assert gc.get_freeze_count() == 0
    with pytest.raises(ImportError), frame_painter._no_garbage_collection():
        raise ImportError
    assert gc.isenabled()


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
def test_each_change_gives_another_picture(desk, change):
    before = desk.painter.paint(STATE)
    after = desk.painter.paint(replace(STATE, **change))
    assert after.shape != before.shape or (after != before).any()


def test_a_question_is_answered_once_and_draws_nothing(desk):
    desk.painter.paint(STATE)
    asked = replace(STATE, pick=PickRequest(1, 0.0, 0.0))
    assert desk.painter.paint(asked) is None
    assert desk.painter.paint(asked) is None
    assert desk.picked == [None]
    desk.painter.paint(replace(STATE, pick=PickRequest(2, 0.0, 0.0)))
    assert desk.picked == [None, None]


def test_a_robot_that_fails_is_told_and_the_old_one_stays(desk, tmp_path):
    before = desk.painter.paint(STATE)
    path = write_arm(tmp_path, hinges=3)
    after = desk.painter.paint(replace(STATE, robot=RobotChoice(path)))
    np.testing.assert_array_equal(before, after)
    (failure,) = desk.failures
    assert failure == Refusal("urdf_joint_count", {"path": str(path), "found": 3, "wanted": 6})


def test_the_same_file_is_read_again_when_asked_again(desk, tmp_path):
    path = write_arm(tmp_path, hinges=3)
    desk.painter.paint(replace(STATE, robot=RobotChoice(path, 0)))
    write_arm(tmp_path)
    desk.painter.paint(replace(STATE, robot=RobotChoice(path, 1)))
    assert len(desk.failures) == 1


def test_slow_smoothing_waits_until_the_picture_rests(desk, monkeypatch):
    monkeypatch.setattr(frame_painter, "_CHEAP_FRAME_S", 0.0)
    rough = desk.painter.paint(STATE)
    assert desk.painter.is_rough
    fine = desk.painter.refine()
    assert (fine != rough).any()
    assert not desk.painter.is_rough
    assert desk.painter.refine() is None
    desk.painter.paint(replace(STATE, stale=True))
    assert desk.painter.is_rough


def test_cheap_smoothing_is_used_at_once(desk, monkeypatch):
    monkeypatch.setattr(frame_painter, "_CHEAP_FRAME_S", 1e9)
    desk.painter.paint(STATE)
    desk.painter.refine()
    desk.painter.paint(replace(STATE, stale=True))
    assert not desk.painter.is_rough
