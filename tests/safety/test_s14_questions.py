"""S14: a question is carried out on the arm, the connection and the place it was asked about."""

import ast
import json
from collections import Counter
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QTableView

import armui.ui
from armui.cell.cell import Cell
from armui.cell.placement import Placement
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from armui.ui.dialogs.backup import BackupDialog
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.dialogs.connect import ConnectDialog
from armui.ui.dialogs.files import FileDialog
from armui.ui.dialogs.reference_check import ReferenceDialog
from armui.ui.widgets.hold_button import HoldButton
from tests.accepted import accepted

ASKING = {
    "ui/actions/act.py": {"HoldButton": 1},
    "ui/dialogs/backup.py": {"choose_file": 2, "confirm": 1},
    "ui/dialogs/confirm_dialog.py": {"ConfirmDialog": 1, "HoldButton": 1, "confirm": 1},
    "ui/dialogs/connect.py": {"confirm": 1},
    "ui/dialogs/files.py": {"FileDialog": 2, "choose_file": 1},
    "ui/dialogs/inspection.py": {"HoldButton": 1},
    "ui/dialogs/problem_report.py": {"choose_file": 1},
    "ui/dialogs/reference_check.py": {"HoldButton": 2, "choose_file": 1, "confirm": 2},
    "ui/dialogs/settings.py": {"choose_file": 1},
    "ui/panels/cell/cell_panel.py": {"choose_file": 2, "confirm": 4},
    "ui/panels/gripper_panel.py": {"_ask_to_hold": 2},
    "ui/panels/linkage_panel.py": {"_ask_to_hold": 1},
    "ui/panels/motor_panel.py": {"_ask_to_hold": 2},
    "ui/panels/panel.py": {"confirm": 1},
    "ui/panels/parameters/end_load_panel.py": {"_ask_to_hold": 1},
    "ui/panels/parameters/parameter_panel.py": {"confirm": 2},
    "ui/panels/teaching_panel.py": {"HoldButton": 2, "confirm": 1},
    "ui/shell/leaving.py": {"CloseQuestion": 1, "UnsavedQuestion": 1, "confirm": 2},
    "ui/shell/recovery_line.py": {"HoldButton": 1, "confirm": 1},
    "ui/shell/top_bar.py": {"confirm": 1},
    "ui/trajectory/editor/editor_page.py": {"LeaveQuestion": 1},
    "ui/trajectory/library/library_exchange.py": {
        "FileDialog": 2,
        "choose_file": 1,
        "choose_folder": 1,
    },
    "ui/trajectory/recording/recording_page.py": {"LeaveQuestion": 1, "SaveQuestion": 1},
    "ui/trajectory/running/run_strip.py": {"HoldButton": 1},
    "ui/watch/bus/send_box.py": {"HoldButton": 2},
    "ui/watch/export_dialog.py": {"choose_file": 2, "choose_folder": 1, "confirm": 1},
    "ui/watch/recordings/recording_card.py": {"choose_folder": 1},
    "ui/watch/replay/replay_window.py": {"choose_file": 1},
}
"""Everything that asks, by file. Who adds one adds it here, and below to `QUESTIONS` if it is about
an arm; a chosen file is only read, written or compared, and nothing is sent for it."""

ABOUT_FILES = {
    "ui/dialogs/confirm_dialog.py": 1,  # LeaveQuestion
    "ui/trajectory/recording/recording_page.py": 1,
    "ui/watch/export_dialog.py": 1,
}
"""How many of their questions stay when the arm is exchanged."""

SETS = frozenset({0x150, 0x151, 0x121, 0x159, *range(0x155, 0x158), *range(0x470, 0x480)}) - {
    0x472,
    0x477,
    0x47B,
    0x47E,
}


def called(path):
    """What a file calls to ask: each name with how often."""
    names = {name for asked in ASKING.values() for name in asked} | {"SaveQuestion"}
    found: Counter[str] = Counter()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Call):
            function = node.func
            name = getattr(function, "id", None) or getattr(function, "attr", None)
            if name == "Act" and any(each.arg == "held" for each in node.keywords):
                name = "HoldButton"
            if name in names and ast.unparse(function) not in {"app_driver.confirm"}:
                found[name] += 1
    return dict(found)


def test_whatever_asks_is_known_here():
    package = Path(armui.ui.__file__).parents[1]
    found = {
        path.relative_to(package).as_posix(): asked
        for path in sorted((package / "ui").rglob("*.py"))
        if (asked := called(path))
    }
    assert found == ASKING


def test_only_questions_about_files_stay_with_another_arm():
    package = Path(armui.ui.__file__).parents[1]
    stay = {
        path.relative_to(package).as_posix(): count
        for path in (package / "ui").rglob("*.py")
        if (count := path.read_text(encoding="utf-8").count("concerns_arm=False"))
    }
    assert stay == ABOUT_FILES


# Each question about an arm: how it comes to be asked -------------------------------------------


def panel(menu, *buttons):
    def ask(driver):
        driver.click(f"menu_{menu}")
        driver.run(0.5)
        for button in buttons:
            driver.click(button)

    return ask


def move(driver):
    driver.controller.motion.set_speed_percent(5)
    accepted(driver.controller.motion.send_joints((60.0, 40.0, -40.0, 0.0, 20.0, 0.0)))
    driver.run(0.5)


def disconnect(driver):
    move(driver)
    driver.click("communication_button")
    dialog = driver.dialog(ConnectDialog)
    driver.wait(lambda: dialog.findChild(QTableView).model().rowCount() > 0)
    driver.click(dialog.disconnect_button)


def close(driver):
    move(driver)
    driver.window.close()


def unsaved(driver):
    panel("end_limits", "end_limits_edit_button")(driver)
    driver.type_into("max_linear_speed_m_s", "0.5")
    driver.click("menu_motion")


def edit_backup(path):
    """Have the file say another speed of the end."""
    content = json.loads(path.read_text(encoding="utf-8"))
    (speed,) = [one for one in content["parameters"] if one["name"] == "max_linear_speed_m_s"]
    speed["value"] = 0.5
    path.write_text(json.dumps(content), encoding="utf-8")


def restore(driver):
    panel("end_limits", "end_limits_backup_button")(driver)
    driver.run_until(lambda: not driver.controller.settings.busy)
    box = driver.dialog(BackupDialog)
    path = driver.library_folder.parent / "mine.json"
    driver.click(box.save_button)
    chooser = driver.dialog(FileDialog)
    chooser.setDirectory(str(path.parent))
    chooser.selectFile(path.name)
    chooser.accept()
    edit_backup(path)
    box.open_file(path)
    box._model.choose(lambda _row: True)
    driver.click(box.restore_button)


def below_the_floor(driver):
    for joint, angle_deg in ((2, "125"), (3, "-60"), (5, "40")):
        driver.type_into(f"target_field_{joint}", angle_deg)
    driver.click("send_button")


def dangerous_step(driver):
    driver.firmware.condition.communication_fault[3] = True
    driver.run(1.0)
    driver.click("recovery_button")


def delete_the_cell(driver):
    accepted(driver.controller.cell.take(Cell("bench")))
    panel("cell", "cell_delete_button")(driver)


def compare_the_cell(driver):
    for name in ("bench", "table"):
        accepted(driver.controller.cell.take(Cell(name)))
    panel("cell")(driver)
    menu = driver.find("cell_compare_button").menu()
    menu.aboutToShow.emit()
    menu.actions()[0].trigger()


def limits_beside_the_arm(driver):
    panel("joint_settings", "joint_settings_edit_button")(driver)
    driver.type_into("min_angle_deg_2", "60")
    driver.click("joint_settings_save_button")


def motor_off_in_the_reference_check(driver):
    driver.run(1.5)
    driver.firmware.lost_reference.begin(4)
    driver.run(2.0)
    driver.click("recovery_button")
    dialog = driver.dialog(ReferenceDialog)
    driver.click(dialog.begin_button)
    driver.click(dialog.look_button)
    driver.click(dialog.off_button)


def teach_the_reference(driver):
    driver.window.pages.show("reference")
    driver.click(driver.dialog(ReferenceDialog).teach_button)


QUESTIONS = {
    "zero of a joint": panel("motor", "zero_motor_2"),
    "zero of all": panel("motor", "zero_motor_7"),
    "disable a motor": panel("motor", "disable_motor_2"),
    "disable all": lambda driver: driver.click("enable_button"),
    "linkage": panel("linkage", "linkage_input", "linkage_confirm_button"),
    "factory values of the end": panel("end_limits", "end_limits_reset_button"),
    "factory values of the joints": panel("joint_settings", "joint_settings_reset_button"),
    "collision off": panel(
        "collision", "collision_edit_button", "collision_level_2_level_0", "collision_save_button"
    ),
    "mounting": panel("end_load", "mounting_upside_down", "mounting_confirm_button"),
    "disable the gripper": panel("gripper", "gripper_disable_button"),
    "zero of the gripper": panel("gripper", "gripper_zero_button"),
    "drag teaching": panel("teaching", "teaching_start_recording"),
    "a dangerous step": dangerous_step,
    "below the floor": below_the_floor,
    "disconnect": disconnect,
    "close": close,
    "unsaved": unsaved,
    "restore": restore,
    "delete the cell": delete_the_cell,
    "compare the cell": compare_the_cell,
    "limits beside the arm": limits_beside_the_arm,
    "motor off in the reference check": motor_off_in_the_reference_check,
    "teach the reference": teach_the_reference,
}


def questions():
    return [
        each
        for each in QApplication.topLevelWidgets()
        if isinstance(each, ConfirmDialog) and each.isVisible()
    ]


def commands_heard(driver):
    return [each for each in driver.node.heard if each.arbitration_id in SETS]


def another_arm(driver):
    """Another arm in the place of this one, with its motors on; the program is not asked."""
    arm = Firmware(Generation.TWO, joints_deg=(33.0, 30.0, -30.0, 0.0, 20.0, 0.0))
    driver.powered = False
    driver.run(0.6)
    driver.powered = True
    driver.firmware = arm
    driver.node = Node(arm, driver._arm_bus)


@pytest.fixture(params=QUESTIONS)
def asked(app_driver, request):
    """A question is open, about an arm that may move."""
    app_driver.ready()
    app_driver.run(0.2)
    QUESTIONS[request.param](app_driver)
    assert len(questions()) == 1
    return app_driver


def agree(driver):
    """Press, or hold, the button as an operator does who has not looked up."""
    driver.confirm()
    driver.run(1.0)


def test_a_question_is_withdrawn_when_another_arm_comes(asked):
    another_arm(asked)
    asked.run(0.2)
    assert questions() == []
    assert asked.codes().count("question_withdrawn") == 1
    asked.run(1.0)
    assert commands_heard(asked) == []


def test_what_is_pressed_is_looked_at_again(asked):
    """The other arm has come between the last look and the press."""
    asked.controller._connection._arms += 1
    asked.node.heard.clear()
    asked.confirm()
    assert questions() == []
    assert asked.codes().count("question_withdrawn") == 1
    assert asked.controller.transactions.altering is None
    assert commands_heard(asked) == []


# What is asked about beside the arm ---------------------------------------------------------------


def test_a_zero_is_of_the_place_that_was_asked_about(app_driver):
    app_driver.ready()
    QUESTIONS["zero of a joint"](app_driver)
    app_driver.controller.motion.set_speed_percent(50)
    accepted(app_driver.controller.motion.jog(2, 5.0))
    app_driver.run(3.0)
    assert questions() == []
    assert 0x475 not in {each.arbitration_id for each in app_driver.node.heard}


def test_the_linkage_is_the_one_that_was_asked_about(app_driver):
    app_driver.ready()
    QUESTIONS["linkage"](app_driver)
    app_driver.find("linkage_feedback_offset").setCurrentIndex(1)
    app_driver.confirm()
    app_driver.run(0.5)
    assert questions() == []
    assert 0x470 not in {each.arbitration_id for each in app_driver.node.heard}


def test_a_height_is_over_the_floor_that_was_asked_about(app_driver):
    app_driver.ready()
    QUESTIONS["below the floor"](app_driver)
    sunk = Cell("sunk", placement=Placement((0.0, 0.0, -50.0, 0.0, 0.0, 0.0)))
    accepted(app_driver.controller.cell.take(sunk))
    app_driver.run(0.5)
    assert questions() == []
    assert 0x155 not in {each.arbitration_id for each in app_driver.node.heard}


def test_a_question_stays_with_its_arm(app_driver):
    app_driver.ready()
    QUESTIONS["disable all"](app_driver)
    app_driver.run(2.0)
    assert len(questions()) == 1
    agree(app_driver)
    app_driver.run(1.0)
    assert app_driver.controller.operating_state.enabled == (False,) * 6


# Buttons that are held ------------------------------------------------------------------------


def test_a_held_button_does_nothing_to_another_arm(app_driver, qtbot):
    app_driver.ready()
    button = HoldButton(app_driver.controller, "Go on")
    qtbot.addWidget(button)
    button.show()
    held = []
    button.held.connect(lambda: held.append(1))
    QTest.mousePress(button, Qt.MouseButton.LeftButton)
    app_driver.controller._connection._arms += 1
    button.progress.setCurrentTime(button.progress.duration())
    assert held == []
    assert app_driver.codes().count("question_withdrawn") == 1
    QTest.mousePress(button, Qt.MouseButton.LeftButton)
    button.progress.setCurrentTime(button.progress.duration())
    assert held == [1]
