"""An operator at 参数备份: the arm into a file, a file beside the arm, and back into the arm."""

import errno
import json

import can
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel, QLineEdit

from armui.arm.parameters import all_batches
from armui.control.link.link_state import LinkState
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.ui.dialogs.backup import BackupColumn, BackupDialog
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.dialogs.files import FileDialog
from armui.ui.widgets.message_line import MessageLine
from tests.company import OtherHost
from tests.faulty_arm import HardOfHearing
from tests.generations import ONE_IS_ENOUGH

SETTINGS_IDS = {0x474, 0x475, 0x479, 0x47A, 0x47D}


def frame(arbitration_id, payload):
    return Frame(arbitration_id, bytes.fromhex(payload))


@pytest.fixture
def arm(any_driver):
    """Connected, 参数备份 open and the arm read."""
    return read(any_driver)


def read(app_driver):
    """Connect, open 参数备份, and read the arm."""
    app_driver.connect()
    app_driver.ear = HardOfHearing(app_driver.firmware)
    app_driver.click("menu_end_limits")
    settled(app_driver)
    app_driver.click("end_limits_backup_button")
    app_driver.box = app_driver.dialog(BackupDialog)
    settled(app_driver)
    return app_driver


def settled(app_driver):
    app_driver.run_until(lambda: not app_driver.controller.settings.busy)


def generation(app_driver):
    return app_driver.controller.operating_state.generation


def said(app_driver):
    return app_driver.box.findChild(MessageLine, "backup_message").text()


def rows(app_driver):
    """The table as it is seen: name to file, arm, comparison."""
    model = app_driver.box.table.model()
    return {
        model.index(row, BackupColumn.NAME).data(): tuple(
            model.index(row, column).data()
            for column in (BackupColumn.FILED, BackupColumn.HELD, BackupColumn.STATE)
        )
        for row in range(model.rowCount())
    }


def ticks(app_driver):
    model = app_driver.box.table.model()
    return [
        model.index(row, BackupColumn.NAME).data()
        for row in range(model.rowCount())
        if model.index(row, BackupColumn.NAME).data(Qt.ItemDataRole.CheckStateRole)
        == Qt.CheckState.Checked
    ]


def untick(app_driver, name):
    model = app_driver.box.table.model()
    for row in range(model.rowCount()):
        if model.index(row, BackupColumn.NAME).data() == name:
            index = model.index(row, BackupColumn.NAME)
            model.setData(index, Qt.CheckState.Unchecked, Qt.ItemDataRole.CheckStateRole)


def save(app_driver, path):
    """Press 保存, type the file's name in the chooser and accept it."""
    app_driver.click(app_driver.box.save_button)
    chooser = app_driver.dialog(FileDialog)
    chooser.setDirectory(str(path.parent))
    field = chooser.findChild(QLineEdit, "fileNameEdit")
    field.clear()
    QTest.keyClicks(field, path.name)
    chooser.accept()


def open_file(app_driver, path):
    app_driver.click(app_driver.box.open_button)
    chooser = app_driver.dialog(FileDialog)
    chooser.setDirectory(str(path.parent))
    chooser.selectFile(path.name)
    chooser.accept()


def restore(app_driver):
    app_driver.click(app_driver.box.restore_button)
    app_driver.confirm()
    settled(app_driver)


def sent(app_driver):
    return [each for each in app_driver.ear.heard if each.arbitration_id in SETTINGS_IDS]


def kept_by(app_driver):
    """How many parameters an arm of the generation keeps."""
    second = generation(app_driver) is Generation.TWO
    batches = all_batches(teaching=second, drag_assistance=second)
    return sum(len(batch.parameters()) for batch in batches)


def test_everything_is_read_when_it_opens(arm):
    table = rows(arm)
    second = generation(arm) is Generation.TWO
    assert len(table) == kept_by(arm)
    assert table["J2 Max. angle"] == ("—", "180.0°", "only in the arm")
    assert table["J6 Collision level"] == ("—", "1", "only in the arm")
    assert ("Teaching friction" in table) is second
    assert ("J4 Drag assistance" in table) is second
    assert not arm.box.restore_button.isEnabled()
    assert "Open a file first" in arm.box.restore_button.toolTip()


def test_a_file_holds_everything_with_units_and_where_it_is_from(arm, tmp_path):
    save(arm, tmp_path / "mine.json")
    entries = json.loads((tmp_path / "mine.json").read_text(encoding="utf-8"))
    second = generation(arm) is Generation.TWO
    assert f"Saved {kept_by(arm)} parameters to" in said(arm)
    assert entries["arm"]["generation"] == int(generation(arm))
    assert entries["arm"]["firmware"] == ("S-V1.8-9" if second else None)
    assert entries["program"].startswith("armui ")
    held = {(row["name"], row.get("joint")): row for row in entries["parameters"]}
    assert held["max_angle_deg", 2] == {
        "name": "max_angle_deg",
        "joint": 2,
        "value": 180.0,
        "unit": "°",
    }
    assert held["max_linear_speed_m_s", None]["unit"] == "m/s"


def opened(app_driver, version):
    """The window over an arm with this firmware."""
    app_driver.lie((0.0,) * 6, version=version)
    return read(app_driver)


def test_drag_assistance_is_kept_and_restored(app_driver, tmp_path):
    arm = opened(app_driver, "S-V1.8-9")
    arm.firmware.settings.drag_assistance = (1, 2, 3, 4, 5, 6)
    arm.click(arm.box.read_button)
    settled(arm)
    save(arm, tmp_path / "mine.json")
    entries = json.loads((tmp_path / "mine.json").read_text(encoding="utf-8"))["parameters"]
    levels = [row["value"] for row in entries if row["name"] == "drag_assistance"]
    assert levels == [1, 2, 3, 4, 5, 6]

    arm.firmware.settings.drag_assistance = (1, 2, 9, 4, 5, 6)
    arm.click(arm.box.read_button)
    settled(arm)
    open_file(arm, tmp_path / "mine.json")
    assert ticks(arm) == ["J3 Drag assistance"]
    arm.ear.heard.clear()
    restore(arm)
    # joint 3 to level 3, the others FF: leave them
    orders = [each for each in arm.ear.heard if each.arbitration_id == 0x487]
    assert orders == [frame(0x487, "FF FF 03 FF FF FF 00 00")]
    assert arm.firmware.settings.drag_assistance == (1, 2, 3, 4, 5, 6)


def test_an_arm_without_drag_assistance_keeps_none_and_is_given_none(app_driver, tmp_path):
    arm = opened(app_driver, "S-V1.7-4")
    assert "J1 Drag assistance" not in rows(arm)
    save(arm, tmp_path / "older.json")
    text = (tmp_path / "older.json").read_text(encoding="utf-8")
    assert "drag_assistance" not in text
    rest = json.loads(text)
    rest["parameters"].append({"name": "drag_assistance", "joint": 1, "value": 7, "unit": ""})
    (tmp_path / "newer.json").write_text(json.dumps(rest), encoding="utf-8")
    open_file(arm, tmp_path / "newer.json")
    assert rows(arm)["J1 Drag assistance"][0] == "7"
    assert ticks(arm) == []  # it can't be ticked either
    arm.click(arm.box.all_button)
    assert "J1 Drag assistance" not in ticks(arm)


def test_what_differs_is_found_chosen_and_restored(arm, tmp_path):
    save(arm, tmp_path / "mine.json")
    limits = arm.firmware.settings.limits
    limits[1] = limits[1]._replace(max_deg=170.0)
    arm.firmware.settings.collision_levels = (1, 1, 5, 1, 1, 1)
    arm.click(arm.box.read_button)
    settled(arm)
    open_file(arm, tmp_path / "mine.json")
    assert rows(arm)["J2 Max. angle"] == ("180.0°", "170.0°", "≠ differs")
    assert rows(arm)["J1 Max. angle"] == ("150.0°", "150.0°", "= the same")
    assert "mine.json" in arm.box.findChild(QLabel, "backup_origin").text()
    arm.click(arm.box.only_differences)
    assert list(rows(arm)) == ["J2 Max. angle", "J3 Collision level"]
    assert ticks(arm) == ["J2 Max. angle", "J3 Collision level"]
    untick(arm, "J3 Collision level")
    arm.ear.heard.clear()
    restore(arm)
    # 1800 = 0708 in 0.1°, the rest is left, or sent as it was read
    rest = "7FFF 7FFF" if generation(arm) is Generation.TWO else "0000 001D"
    assert sent(arm) == [frame(0x474, f"02 0708 {rest} 00")]
    assert limits[1].max_deg == 180.0
    assert arm.firmware.settings.collision_levels[2] == 5
    assert "Restored 1 parameters; reading them back gave the same values." in said(arm)
    arm.click(arm.box.only_differences)
    assert rows(arm)["J2 Max. angle"] == ("180.0°", "180.0°", "✓ restored")


def test_a_speed_that_a_frame_can_only_carry_nearly_is_the_same(arm, tmp_path):
    save(arm, tmp_path / "mine.json")
    text = (tmp_path / "mine.json").read_text(encoding="utf-8")
    entries = json.loads(text)
    for row in entries["parameters"]:
        if row["name"] == "max_speed_deg_s":
            row["value"] += 0.01
    (tmp_path / "mine.json").write_text(json.dumps(entries), encoding="utf-8")
    open_file(arm, tmp_path / "mine.json")
    assert rows(arm)["J1 Max. speed"][2] == "= the same"


def test_what_the_arm_does_not_take_is_told_row_by_row(arm, tmp_path):
    save(arm, tmp_path / "mine.json")
    path = tmp_path / "mine.json"
    entries = json.loads(path.read_text(encoding="utf-8"))
    for row in entries["parameters"]:
        if (row["name"], row.get("joint")) == ("max_speed_deg_s", 3):
            row["value"] = 300.0
        if row["name"] == "max_linear_speed_m_s":
            row["value"] = 0.5
        if (row["name"], row.get("joint")) == ("max_angle_deg", 4):
            row["value"] = 6553.5
    path.write_text(json.dumps(entries), encoding="utf-8")
    open_file(arm, path)
    assert rows(arm)["J4 Max. angle"][2] == "≠ cannot be restored"
    assert ticks(arm) == ["J3 Max. speed", "Max. linear speed of the end"]
    arm.click(arm.box.restore_button)
    question = arm.dialog(ConfirmDialog)
    assert "J3 Max. speed: 300.0°/s goes beyond the factory's 171.9°/s." in question.text()
    arm.click(question.action_button)  # it wants to be held
    assert question.isVisible()
    arm.confirm()
    settled(arm)
    assert rows(arm)["J3 Max. speed"][2] == "✗ not restored"
    assert rows(arm)["Max. linear speed of the end"][2] == "✓ restored"
    assert "1 of 2 parameters were not restored. J3 Max. speed: 300.0°/s was sent" in said(arm)
    assert arm.firmware.settings.end_limits[0] == 0.5


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (lambda text: text[: len(text) // 2], "broken or cut short: line"),
        (lambda _text: "wait_s,j1,j2\n", "broken or cut short: line 1"),
        (lambda _text: '{"language": "zh"}', "not a parameter backup"),
        (lambda text: text.replace('"m/s"', '"mm/s"'), "“mm/s” in the field “parameters["),
        (lambda text: text.replace('"version": 1', '"version": 99'), "format version 99"),
    ],
)
@ONE_IS_ENOUGH
def test_a_file_that_is_wrong_is_refused_and_changes_nothing(arm, tmp_path, spoil, words):
    good, bad = tmp_path / "good.json", tmp_path / "bad.json"
    save(arm, good)
    open_file(arm, good)
    before = rows(arm)
    bad.write_text(spoil(good.read_text(encoding="utf-8")), encoding="utf-8")
    open_file(arm, bad)
    assert words in said(arm)
    assert rows(arm) == before
    assert "good.json" in arm.box.findChild(QLabel, "backup_origin").text()
    assert sent(arm) == []


def test_a_file_of_the_other_generation_is_warned_about_and_of_use(arm, tmp_path):
    path = tmp_path / "mine.json"
    save(arm, path)
    entries = json.loads(path.read_text(encoding="utf-8"))
    other = 3 - entries["arm"]["generation"]
    entries["arm"]["generation"] = other
    entries["parameters"].append({"name": "stroke_limit_mm", "value": 100.0, "unit": "mm"})
    entries["parameters"] = [
        row
        for place, row in enumerate(entries["parameters"])
        if row["name"] != "stroke_limit_mm" or place == len(entries["parameters"]) - 1
    ]
    path.write_text(json.dumps(entries), encoding="utf-8")
    open_file(arm, path)
    assert f"protocol generation {other}, this one speaks generation {3 - other}" in said(arm)
    second = generation(arm) is Generation.TWO
    verdict = "≠ differs" if second else "only in the file"
    assert rows(arm)["Gripper stroke limit"][2] == verdict
    assert ticks(arm) == (["Gripper stroke limit"] if second else [])


@ONE_IS_ENOUGH
def test_another_firmware_is_warned_about(arm, tmp_path):
    path = tmp_path / "mine.json"
    save(arm, path)
    entries = json.loads(path.read_text(encoding="utf-8"))
    entries["arm"]["firmware"] = "S-V1.5-2"
    path.write_text(json.dumps(entries), encoding="utf-8")
    open_file(arm, path)
    assert "The file is from firmware S-V1.5-2" in said(arm)


@ONE_IS_ENOUGH
def test_reading_can_be_stopped(arm):
    arm.ear.deaf_to = {0x472, 0x477}
    arm.click(arm.box.read_button)
    assert arm.box.progress.isVisible()
    assert arm.box.read_button.text() == "Stop reading"
    assert not arm.box.save_button.isEnabled()
    arm.run(2.4)
    assert 0 < arm.box.progress.value() < arm.box.progress.maximum()
    arm.click(arm.box.read_button)
    assert "Reading was stopped" in said(arm)
    settled(arm)
    asked = len([each for each in rows(arm).values() if each[2] == "… reading"])
    assert asked == 0
    assert not arm.box.progress.isVisible()
    assert arm.box.read_button.text() == "Read"


def test_what_could_not_be_read_is_not_in_the_file_and_that_is_said(any_driver, tmp_path):
    any_driver.connect()
    any_driver.ear = HardOfHearing(any_driver.firmware)
    any_driver.ear.mute_on = {0x47B}
    any_driver.click("menu_end_limits")
    any_driver.click("end_limits_backup_button")
    any_driver.box = any_driver.dialog(BackupDialog)
    any_driver.run_until(any_driver.box.save_button.isEnabled)
    assert rows(any_driver)["J1 Collision level"] == ("—", "—", "not read from the arm")
    save(any_driver, tmp_path / "mine.json")
    any_driver.ear.mute_on = set()
    host = OtherHost(any_driver)
    host.say("477#0200000000000000")  # it asks, and this program hears
    any_driver.run(0.3)
    host.close()
    assert rows(any_driver)["J1 Collision level"][1:] == ("1", "only in the arm")
    assert "6 could not be read from the arm and are not in the file." in said(any_driver)


@ONE_IS_ENOUGH
def test_a_link_lost_half_way_through_reading(arm):
    arm.ear.deaf_to = {0x472}
    arm.click(arm.box.read_button)
    arm.step()
    arm.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    arm.wait(lambda: arm.controller.operating_state.link is LinkState.LOST)
    assert "device is gone" in said(arm)
    assert not arm.box.progress.isVisible()
    assert not arm.box.read_button.isEnabled()
    assert not arm.box.restore_button.isEnabled()


@ONE_IS_ENOUGH
def test_a_folder_that_cannot_be_written_to_is_named(arm, tmp_path, monkeypatch):
    def disk_full(_file):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr("armui.system.atomic.os.fsync", disk_full)
    save(arm, tmp_path / "mine.json")
    assert "could not be written" in said(arm)
    assert "No space left on device" in said(arm)
    assert list(tmp_path.glob("mine*")) == []


def test_without_an_arm_a_file_can_still_be_read(any_driver, tmp_path):
    any_driver.click("menu_end_limits")
    any_driver.click("end_limits_backup_button")
    any_driver.box = any_driver.dialog(BackupDialog)
    assert "No arm is connected" in said(any_driver)
    assert not any_driver.box.save_button.isEnabled()
    path = tmp_path / "mine.json"
    path.write_text(
        '{"format": "armui-parameters", "version": 1, "saved_at": "2026-01-02T03:04:05+00:00",'
        '"program": "armui 0.1.0", "arm": {"generation": 2, "firmware": null, "device": "x"},'
        '"parameters": [{"name": "max_angle_deg", "joint": 1, "value": 150.0, "unit": "°"}]}',
        encoding="utf-8",
    )
    open_file(any_driver, path)
    assert list(rows(any_driver)) == ["J1 Max. angle"]
    assert not any_driver.box.restore_button.isEnabled()


def switched_off_at_the_question(arm, path):
    save(arm, path)
    arm.firmware.settings.collision_levels = [3, 3, 3, 3, 3, 3]
    arm.click(arm.box.read_button)
    settled(arm)
    open_file(arm, path)
    arm.click(arm.box.restore_button)
    arm.powered = False
    arm.run_until(lambda: arm.controller.operating_state.link is LinkState.OFFLINE)


@ONE_IS_ENOUGH
def test_a_question_that_goes_with_the_arm_says_so_in_this_window(arm, tmp_path):
    switched_off_at_the_question(arm, tmp_path / "mine.json")
    assert not [each for each in arm.box.findChildren(ConfirmDialog) if each.isVisible()]
    assert said(arm).startswith("“Restore parameters” was withdrawn. The arm was silent")


@ONE_IS_ENOUGH
def test_an_arm_that_is_back_is_read_again(arm):
    arm.powered = False
    arm.run_until(lambda: arm.controller.operating_state.link is LinkState.OFFLINE)
    arm.powered = True
    arm.run_until(lambda: arm.controller.operating_state.link is LinkState.ONLINE)
    arm.run(1.0)
    settled(arm)
    assert {each[2] for each in rows(arm).values()} == {"only in the arm"}
    assert said(arm) == ""


@ONE_IS_ENOUGH
def test_an_arm_that_comes_while_the_window_is_open_is_read(any_driver):
    any_driver.click("menu_end_limits")
    any_driver.click("end_limits_backup_button")
    any_driver.box = any_driver.dialog(BackupDialog)
    assert "No arm is connected" in said(any_driver)
    any_driver.connect()
    any_driver.run(1.0)
    settled(any_driver)
    assert {each[2] for each in rows(any_driver).values()} == {"only in the arm"}
    assert said(any_driver) == ""
