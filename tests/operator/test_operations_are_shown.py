"""Each operation stands somewhere in the window, and in the guide of either language."""

from __future__ import annotations

from typing import NamedTuple

import pytest
from PySide6.QtWidgets import QApplication

from armui.control.operations.operation import Consent
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory
from armui.ui.guide.text import read_guide
from armui.ui.shell.pages import PLACES
from tests.accepted import accepted
from tests.app_driver import PANELS
from tests.control.test_started import checking, in_doubt, outside_limits
from tests.control.under_way import replay_moving, run_moving
from tests.operator.library.actions import POINT
from tests.operator.test_palette import commands


class Shown(NamedTuple):
    """Where an operation is.

    Attributes:
        place: A key of `OPEN`.
        button: The object name of what does it.
        section: Of the guide.
        english: What the guide says of it.
        chinese: In the other language.
    """

    place: str
    button: str
    section: str
    english: str
    chinese: str


SHOWN = {
    "motors.enable": Shown("motor", "enable_motor_7", "motor", "enable,", "使能、"),
    "motors.disable": Shown("motor", "disable_motor_7", "motor", "disable,", "失能、"),
    "motors.resume": Shown("stopped", "recovery_hold_button", "stop", "release", "解除急停"),
    "joints.set_zero": Shown("motor", "zero_motor_1", "motor", "set zero", "零点设置"),
    "joints.clear_error": Shown("motor", "clear_motor_1", "motor", "clear error", "清除错误"),
    "lamps.set": Shown(
        "light", "light_confirm_button", "light", "“Send colour” sends", "“确认”发送"
    ),
    "gripper.move": Shown(
        "gripper", "gripper_send_button", "gripper", "“Send” moves", "“发送”移动"
    ),
    "gripper.enable": Shown("gripper", "gripper_enable_button", "gripper", "“Enable”", "“使能”"),
    "gripper.disable": Shown("gripper", "gripper_disable_button", "gripper", "“Disable”", "“失能”"),
    "gripper.clear_error": Shown(
        "gripper", "gripper_clear_button", "gripper", "“Clear error”", "“清除错误”"
    ),
    "gripper.set_zero": Shown(
        "gripper", "gripper_zero_button", "gripper", "“Set zero”", "“零点设置”"
    ),
    "linkage.set": Shown("linkage", "linkage_confirm_button", "linkage", "leader", "主臂"),
    "end_load.set": Shown("end_load", "load_confirm_button", "end_load", "full load", "满载"),
    "end_load.report": Shown(
        "end_load", "end_feedback_button", "end_load", "speed and acceleration", "速度和加速度"
    ),
    "mounting.tell": Shown(
        "end_load", "mounting_confirm_button", "end_load", "mounted", "安装方式"
    ),
    "teaching.command": Shown(
        "teaching", "teaching_start_recording", "teaching", "Start recording", "开始记录"
    ),
    "planned.command": Shown("teaching", "plan_abort", "teaching", "is planning", "轨迹指令"),
    "motion.set_speed": Shown("window", "speed_field", "window", "Speed percentage", "速度百分比"),
    "motion.step": Shown("motion", "jog_plus_1", "motion", "by a step", "一个步长"),
    "motion.send": Shown("motion", "send_button", "motion", "**Send**", "**发送**"),
    "motion.home": Shown("motion", "home_button", "motion", "**Home**", "**回零**"),
    "motion.come_inside": Shown(
        "outside", "recovery_hold_button", "window", "**Move inside**", "**回到限位内**"
    ),
    "jog.begin": Shown("motion", "jog_plus_1", "motion", "“Continuous”", "“连续”"),
    "tool.move": Shown("cartesian", "move_p_button", "cartesian", "**MOVE P**", "**MOVE P**"),
    "tool.step": Shown("cartesian", "pose_plus_Z", "cartesian", "− and +", "− / +"),
    "tool.arc": Shown("cartesian", "move_c_button", "cartesian", "MOVE C", "MOVE C"),
    "settings.read": Shown(
        "joint_settings", "joint_settings_read_button", "joint_settings", "read from", "读取"
    ),
    "settings.save": Shown(
        "editing", "joint_settings_save_button", "joint_settings", "“Save”", "“保存”"
    ),
    "settings.reset_joint_limits": Shown(
        *("joint_settings", "joint_settings_reset_button", "joint_settings"),
        *("“Initialise”", "“初始化”"),
    ),
    "settings.reset_end_limits": Shown(
        "end_limits", "end_limits_reset_button", "end_limits", "joint settings", "关节设置"
    ),
    "run.start": Shown("library", "run_send", "library", "“Run” runs", "“发送”运行"),
    "run.pause": Shown("run", "run_pause", "library", "paused", "暂停"),
    "run.go_on": Shown("run_paused", "run_continue", "library", "gone on with (held)", "按住继续"),
    "replay.start": Shown("library", "run_send", "recording", "replayed", "回放"),
    "replay.pause": Shown("replay_run", "run_pause", "recording", "paused", "暂停"),
    "replay.go_on": Shown(
        "replay_paused", "run_continue", "recording", "gone on with (held)", "按住继续"
    ),
    "reference.allow": Shown(
        "in_doubt", "reference_allow", "reference", "**Move anyway**", "**仍要运动**"
    ),
    "reference.begin": Shown(
        "reference", "reference_begin", "reference", "**Begin the check**", "**开始检查**"
    ),
    "reference.drive": Shown(
        "checking", "reference_drive", "reference", "**Drive to the mark**", "**驱动到刻线**"
    ),
    "reference.finish": Shown(
        "answered", "reference_finish", "reference", "**Finish the check**", "**完成检查**"
    ),
    "reference.teach": Shown(
        "reference",
        "reference_teach",
        "reference",
        "**Teach reference pose…**",
        "**示教基准位姿…**",
    ),
    "cell.take": Shown("cell", "cell_new_button", "cell", "**New**", "**新建**"),
    "cell.choose": Shown("cell", "cell_box", "cell", "Choosing", "选择"),
    "cell.confirm": Shown(
        "cell", "cell_confirm_button", "cell", "**Confirm cell**", "**确认单元**"
    ),
    "cell.change": Shown("cell", "cell_tool_apply", "cell", "**Apply**", "**应用**"),
    "cell.delete": Shown("cell", "cell_delete_button", "cell", "**Delete**", "**删除**"),
    "cell.rename": Shown("cell", "cell_rename_button", "cell", "**Rename**", "**改名**"),
    "cell.hold": Shown("cell_held", "cell_hold", "cell", "**It is held**", "**已夹住**"),
    "inspection.start": Shown(
        "inspection", "inspection_start", "inspection", "**Inspect**", "**开始巡检**"
    ),
    "episode.begin": Shown(
        "sessions", "episode_begin", "sessions", "**Begin episode**", "**开始片段**"
    ),
    "episode.end": Shown("episode", "episode_end", "sessions", "**End episode**", "**结束片段**"),
    "episode.discard": Shown(
        "episode", "episode_discard", "sessions", "**Discard episode**", "**弃用片段**"
    ),
    "recorder.start": Shown("recording", "record", "recording", "Records what", "记录手拖动"),
}


def pause(driver, executed):
    accepted(executed.pause())
    driver.run(0.3)


def under_way(place):
    """The run strip with a run or a replay that goes on, or is paused."""

    def begin(driver):
        controller = driver.controller
        if place.startswith("replay"):
            replay_moving(driver)
        else:
            run_moving(driver)
        if place.endswith("paused"):
            pause(driver, controller.replayer if place.startswith("replay") else controller.player)

    return begin


def edit(driver):
    driver.click("menu_joint_settings")
    driver.run_until(driver.find("joint_settings_edit_button").isEnabled)
    driver.click("joint_settings_edit_button")


def open_library(driver):
    Library(driver.library_folder).save(Trajectory("one", points=(POINT, POINT)))
    driver.click("library_button")


def open_recording(driver):
    open_library(driver)
    driver.click("library_record")


def open_held(driver):
    driver.click("menu_cell")
    driver.click("cell_tab_held")


def open_reference(driver, state="reference"):
    if state == "in_doubt":
        in_doubt(driver)
    elif state != "reference":
        checking(driver, answered=state == "answered")
    driver.program.window.pages.show("reference")


def is_seen(name):
    return any(each.isVisible() for each in QApplication.allWidgets() if each.objectName() == name)


DIALOG = ("in_doubt", "reference", "checking", "answered")
"""The window of the reference check, at each of its stages."""
BESIDES = ("run", "run_paused", "replay_run", "replay_paused")
"""The run strip, which is seen from every panel."""


def stopped(driver):
    driver.controller.emergency_stop()
    driver.run(1.0)


def open_episode(driver):
    driver.click("sessions_button")
    driver.controller.sessions.start()
    accepted(driver.controller.episodes.begin())


OPEN = {
    "sessions": lambda driver: driver.click("sessions_button"),
    "episode": open_episode,
    "editing": edit,
    "window": lambda _driver: None,
    "library": open_library,
    "recording": open_recording,
    "cell_held": open_held,
    **{panel: lambda driver, panel=panel: driver.click(f"menu_{panel}") for panel in PANELS},
    **{place: under_way(place) for place in BESIDES},
    "outside": outside_limits,
    "stopped": stopped,
    "inspection": lambda driver: driver.program.window.pages.show("inspection"),
    **{stage: lambda driver, stage=stage: open_reference(driver, stage) for stage in DIALOG},
}


def test_each_has_a_place(rig):
    assert set(SHOWN) == set(rig.controller.operations)
    places = {each.place for each in SHOWN.values()}
    assert places - PLACES.keys() - set(PANELS) == {
        "editing",
        "cell_held",
        "episode",
        "outside",
        "stopped",
        *BESIDES,
        *DIALOG,
    } - {
        "run",
        "reference",
    }


@pytest.mark.parametrize("place", sorted({each.place for each in SHOWN.values()}))
def test_what_does_it_is_seen_at_its_place(app_driver, place):
    app_driver.ready()
    OPEN[place](app_driver)
    unseen = {
        name for name, shown in SHOWN.items() if shown.place == place and not is_seen(shown.button)
    }
    assert unseen == set()


@pytest.mark.parametrize(("language", "phrase"), [("en", "english"), ("zh", "chinese")])
def test_the_guide_has_a_line_of_each(language, phrase):
    texts = {section.anchor: section.text for section in read_guide(language)}
    missing = {
        name
        for name, shown in SHOWN.items()
        if getattr(shown, phrase).lower() not in texts[shown.section].lower()
    }
    assert missing == set()


BY_THE_BUTTON_OF_A_RUN = {"replay.start", "replay.pause", "replay.go_on"}


def test_each_is_found_by_its_title(app_driver):
    carried = {each.operation.id for each in commands(app_driver) if each.operation is not None}
    assert carried == set(app_driver.controller.operations) - BY_THE_BUTTON_OF_A_RUN


def test_what_is_shown_first_or_held_is_never_pressed_unseen(app_driver):
    for each in commands(app_driver):
        if each.operation is not None:
            assert each.shown_first or not each.operation.shown_first, each.name
            assert each.only_led_to or each.operation.consent is not Consent.HELD, each.name
            assert each.dangerous or each.operation.consent is not Consent.PRESS, each.name
