"""The operator presses Ctrl+K, types a piece of a name, and Enter: the button itself does it."""

import re

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from armui.control.run.progress import RunPhase
from armui.control.safety.recovery_steps import StepKind
from armui.ui.actions.command import while_editing
from armui.ui.actions.keys import SHORTCUTS
from armui.ui.actions.palette import CommandPalette
from armui.ui.actions.palette_items import nothing_to_do
from armui.ui.actions.search import rank
from armui.ui.actions.shortcut_list import KeyCap, ShortcutList
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.dialogs.settings import SettingsDialog
from armui.ui.panels.cell.cell_panel import TABS as CELL_TABS
from armui.ui.picture.view_bar import ViewBar
from armui.ui.shell.pages import PLACES
from armui.ui.trajectory.library.library_page import LibraryPage
from armui.ui.watch.bus.bus_page import BusPage
from armui.ui.widgets.hold_button import HoldButton
from tests.accepted import accepted
from tests.app_driver import PANELS
from tests.control.test_started import outside_limits
from tests.operator.test_running import BACK, OUT, Operator, to

RELEASE = "window.resume"
ONLY_AT_TIMES = {"view.close_preview", RELEASE, "window.come_inside"}
"""Commands whose button is seen only while there is something for it to do."""


def open_palette(app_driver, window=None):
    window = window or app_driver.window
    window.activateWindow()  # off the screen nobody gives it back when a dialog closes
    app_driver.wait(window.isActiveWindow)
    QTest.keyClick(window, Qt.Key.Key_K, Qt.KeyboardModifier.ControlModifier)
    palette = app_driver.dialog(CommandPalette)
    app_driver.wait(lambda: palette._names.known)
    return palette


def palette_items(app_driver):
    """Everything the palette offers now."""
    return app_driver.window.window_actions.palette_items().now()


def commands(app_driver):
    """Every command the palette knows."""
    return [item.command for item in palette_items(app_driver)]


def targets(app_driver):
    """What carries out the commands whose page is seen, by their names."""
    items = palette_items(app_driver)
    return {item.command.name: item.target for item in items if item.target is not None}


def rows(palette):
    model = palette.list.model()
    return [model.index(row, 0).data(Qt.ItemDataRole.UserRole) for row in range(model.rowCount())]


def command(app_driver, words):
    """Find something and press Enter."""
    palette = open_palette(app_driver)
    QTest.keyClicks(palette.search, words)
    QTest.keyClick(palette.search, Qt.Key.Key_Return)
    return palette


@pytest.mark.parametrize("words", ["tool control", "tool con", "末端", "mdkz", "moduankongzhi"])
def test_a_panel_is_found_by_any_of_its_names(app_driver, words):
    palette = open_palette(app_driver)
    palette.search.setText(words)
    QTest.keyClick(palette.search, Qt.Key.Key_Return)
    assert app_driver.find("menu_cartesian").isChecked()
    assert not palette.isVisible()


@pytest.mark.parametrize(
    ("words", "first"),
    [
        ("归零", "Home"),
        ("零点", "Home"),
        ("guiling", "Home"),
        ("jinjitingzhi", "Emergency stop"),
        ("jjtz", "Emergency stop"),
        ("bangzhu", "Help"),
        ("estop", "Emergency stop"),
        ("e-stop", "Emergency stop"),
        ("stop", "Emergency stop"),
        ("停止", "Emergency stop"),
        ("preferences", "Settings"),
        ("帮助", "Help"),
        ("quit", "Close the program"),
        *((each, "Back up, compare, restore") for each in ("backup", "备份", "保存参数")),
        *((each, "Drag teaching") for each in ("freedrive", "hand guide", "拖拽")),
        *((each, "Connect arm") for each in ("baud", "disconnect", "simulator", "断开", "仿真")),
        *((each, "Cell") for each in ("safety", "fence", "calibrate tcp", "安全", "标定")),
        *((each, "End load") for each in ("payload", "重量")),
        *((each, "Gamepad") for each in ("joystick", "spacemouse", "摇杆")),
        *((each, "Linkage") for each in ("leader", "主从")),
        *((each, "Gripper control") for each in ("torque", "力矩")),
        *((each, "Trajectory library") for each in ("waypoint", "路点")),
        *((each, "Help") for each in ("font", "text size", "字号")),
        *((each, "Import files") for each in ("open file", "打开 文件")),
        *((each, "Replay a log") for each in ("open recording", "打开 录制")),
        *((each, "Clear error") for each in ("clear alarm", "清错")),
        *((each, "Gripper control") for each in ("抓手", "夹具")),
        *((each, "Cell") for each in ("table", "禁区")),
        *((each, "Home") for each in ("go home", "回原点")),
        ("打开夹爪", "Open the gripper"),
        ("停止运动", "Halt"),
        ("led", "Light control"),
        ("断电", "Enable or disable"),
        ("connect", "Connect arm"),
        ("import", "Import files"),
        ("zone", "Cell"),
        ("sensitivity", "Collision level"),
        ("灵敏度", "Collision level"),
        ("camera", "Fit"),
        *((each, "Close the program") for each in ("shutdown", "关机")),
        *((each, "Operator's view") for each in ("unlock", "解锁")),
    ],
)
def test_what_an_operator_calls_a_thing_finds_it_first(app_driver, words, first):
    palette = open_palette(app_driver)
    palette.search.setText(words)
    assert rows(palette)[0].title.startswith(first)


@pytest.mark.parametrize(
    ("word", "named"),
    [
        ("stop", {"Emergency stop", "Halt"}),
        ("calibrate", {"Cell", "Set zero"}),
        ("标定", {"Cell", "Set zero J1–J6"}),
        ("csv", {"Export a log", "Import files"}),
        ("reset", {"Release the emergency stop", "Clear error J1–J6"}),
        ("复位", {"Release the emergency stop", "Clear error J1–J6"}),
    ],
)
def test_whatever_a_word_may_mean_is_found(app_driver, word, named):
    palette = open_palette(app_driver)
    palette.search.setText(word)
    found = {each.title for each in rows(palette)}
    assert named <= found
    assert "Home" not in found


def test_of_what_matches_alike_what_can_be_done_comes_first(app_driver):
    app_driver.connect()
    palette = open_palette(app_driver)
    palette.search.setText("zero")
    first, second = rows(palette)[:2]
    assert (first.title, first.reason) == ("Reference check", "")
    assert second.title == "Home"
    assert "not enabled" in second.reason
    app_driver.controller.motors.enable()
    app_driver.run_until(lambda: app_driver.controller.operating_state.cannot_move is None)
    app_driver.wait(lambda: not rows(palette)[1].reason)  # no row has left its place meanwhile


@pytest.mark.parametrize("language", ["en", "zh"])
def test_enter_moves_no_arm_by_a_word_that_is_not_its_name(app_driver, language):
    app_driver.ready()
    app_driver.click("menu_motion")
    app_driver.store.change(language=language)
    palette = open_palette(app_driver)
    moving = [each for each in palette_items(app_driver) if each.moves]
    assert {"motion.home", "motion.send"} <= {each.command.name for each in moving}
    asked = {word for each in moving for word in each.command.synonyms} - {"home"}
    for word in ("zero", "零", "h", "回", *sorted(asked)):
        palette.search.setText(word)
        chosen = palette._chosen()
        assert chosen is None or not chosen.moves, word
    app_driver.heard()
    palette.search.setText("归零")  # another word for it: it is found, and left to be chosen
    home = {"en": "Home", "zh": "回零"}[language]
    assert [each.title for each in rows(palette)] == [home]
    QTest.keyClick(palette.search, Qt.Key.Key_Return)
    assert palette.isVisible()
    assert palette.findChild(object, "palette_message").text()
    app_driver.run(0.3)
    assert not app_driver.controller.operating_state.moving
    for word in (home, home.lower(), "huiling", "home"):
        palette.search.setText(word)
        assert palette._chosen().title == home
    palette.search.setText("归零")
    QTest.keyClick(palette.search, Qt.Key.Key_Down)
    assert palette._chosen().title == home
    QTest.keyClick(palette.search, Qt.Key.Key_Return)
    assert not palette.isVisible()


def test_the_picture_is_found_as_a_screenshot(app_driver):
    commands, names = (
        {each.name: each for each in ViewBar.commands},
        open_palette(app_driver)._names,
    )
    for name in ("view.save", "view.copy"):
        text = names.search_text(("Save",), "", commands[name].synonyms)
        assert all(rank(each, text) for each in ("screenshot", "截图", "jietu"))


@pytest.mark.parametrize("language", ["en", "zh"])
def test_what_is_dangerous_is_never_first_where_anything_else_is_found(app_driver, language):
    app_driver.connect()
    app_driver.click("menu_motor")
    app_driver.store.change(language=language)
    palette = open_palette(app_driver)
    titles = [item.title.lower() for item in palette_items(app_driver)]
    words = {word for title in titles for word in title.split()}
    words |= {word[:3] for word in words} | {"zero", "off", "零", "失能", "恢复", "reset", "power"}
    for word in sorted(words):
        palette.search.setText(word)
        dangerous = [row.command.dangerous for row in rows(palette)]
        assert dangerous == sorted(dangerous), word
    palette.search.setText("zero")
    titles = [row.title for row in rows(palette)]
    assert any(row.command.dangerous for row in rows(palette)), titles  # it is found all the same


def test_it_moves_the_arm_by_the_panels_own_button(app_driver):
    app_driver.connect()
    app_driver.enable_by_hand()
    app_driver.click("menu_light")
    app_driver.controller.motion.send_joints([10.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    app_driver.run_until(lambda: abs(app_driver.controller.state.angles_deg()[0] - 10.0) < 0.1)
    command(app_driver, "motion home")
    assert app_driver.find("menu_motion").isChecked()
    app_driver.run_until(lambda: abs(app_driver.controller.state.angles_deg()[0]) < 0.1)


def test_what_is_dangerous_asks_what_its_button_asks(app_driver):
    app_driver.connect()
    app_driver.enable_by_hand()
    command(app_driver, "disable j3")
    question = app_driver.dialog(ConfirmDialog)
    assert "joint 3" in question.windowTitle()
    app_driver.run(0.2)
    assert all(app_driver.controller.operating_state.enabled)
    question.reject()


def test_what_cannot_be_done_says_why_and_is_not_done(app_driver):
    app_driver.connect()
    palette = open_palette(app_driver)
    QTest.keyClicks(palette.search, "motion home")
    first = rows(palette)[0]
    assert first.title == "Home"
    assert "not enabled" in first.reason
    sent = len(app_driver.codes())
    QTest.keyClick(palette.search, Qt.Key.Key_Return)
    assert palette.isVisible()
    assert palette.findChild(object, "palette_message").text() == first.reason
    assert len(app_driver.codes()) == sent


def test_what_a_button_is_for_is_no_reason_against_it(app_driver):
    app_driver.click("plots_button")
    undo = next(each for each in palette_items(app_driver) if each.command.name == "plots.undo")
    assert undo.target.toolTip()
    assert not undo.target.isEnabled()
    assert undo.reason == nothing_to_do()


def test_reasons_go_with_the_arm_while_the_palette_is_open(app_driver):
    app_driver.connect()
    palette = open_palette(app_driver)
    QTest.keyClicks(palette.search, "motion home")
    assert rows(palette)[0].reason
    app_driver.controller.motors.enable()
    app_driver.run_until(lambda: app_driver.controller.operating_state.cannot_move is None)
    app_driver.wait(lambda: not rows(palette)[0].reason)


def test_unsaved_values_are_asked_about_and_nothing_else_happens(app_driver):
    app_driver.connect()
    app_driver.click("menu_collision")
    app_driver.run_until(lambda: app_driver.find("collision_edit_button").isEnabled())
    app_driver.click("collision_edit_button")
    app_driver.click("collision_all_level_5")
    command(app_driver, "gripper control")
    assert app_driver.find("menu_collision").isChecked()
    command(app_driver, "tool frame")
    assert app_driver.find("menu_collision").isChecked()


def test_what_is_folded_away_on_its_page_is_led_to_and_not_changed_unseen(app_driver):
    palette = command(app_driver, "only unknown")
    bar = app_driver.page(BusPage).filter_bar
    app_driver.wait(bar.more.hasFocus)
    assert not palette.isVisible()
    assert not bar.only_unknown.isChecked()


def test_a_field_is_gone_to(app_driver):
    command(app_driver, "target j4")
    app_driver.wait(app_driver.find("target_field_4").hasFocus)


def test_another_window_and_its_own_buttons(app_driver):
    command(app_driver, "trajectory library")
    library = app_driver.page(LibraryPage)
    palette = open_palette(app_driver, library)
    titles = {offer.title for offer in rows(palette) if offer.place == "Trajectory library"}
    assert {"Import files", "Create", "Record motion"} <= titles


def test_it_opens_from_a_dialog(app_driver):
    app_driver.window.pages.show("settings")
    palette = open_palette(app_driver, app_driver.dialog(SettingsDialog))
    assert palette.search.hasFocus()


def test_nothing_found_says_what_can_be_found(app_driver):
    palette = command(app_driver, "qqqq")
    assert palette.isVisible()
    assert "pinyin" in palette.findChild(object, "palette_message").text()


def test_the_language_is_switched(app_driver):
    command(app_driver, "language")
    assert app_driver.store.settings.language == "zh"
    palette = open_palette(app_driver)
    palette.search.setText("回零")
    assert [offer.place for offer in rows(palette)] == ["运动控制"]


# What is said of buttons that are not seen --------------------------------------------------------


def no_device(app_driver):
    pass


def disabled(app_driver):
    app_driver.connect()


def enabled(app_driver):
    app_driver.connect()
    app_driver.enable_by_hand()


def stopped(app_driver):
    enabled(app_driver)
    app_driver.controller.emergency_stop()
    app_driver.run(0.3)


def teaching(app_driver):
    app_driver.connect()
    app_driver.click("menu_teaching")
    app_driver.click("teaching_start_recording")
    app_driver.run(0.3)


def moving(app_driver):
    enabled(app_driver)
    app_driver.controller.motion.send_joints([60.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    app_driver.run(0.3)


def show_all_of(app_driver, panel):
    """Open a panel, and each of its tabs: what is on one is made when it is first shown."""
    app_driver.click(f"menu_{panel}")
    for tab in CELL_TABS if panel == "cell" else ():
        app_driver.click(f"cell_tab_{tab.key}")


@pytest.mark.parametrize(
    "state",
    [no_device, disabled, enabled, stopped, teaching, moving],
    ids=lambda each: each.__name__,
)
def test_a_button_that_is_not_seen_has_the_reason_it_has_when_it_is(app_driver, state):
    state(app_driver)
    wrong = {}
    for panel in PANELS:
        show_all_of(app_driver, panel)
        app_driver.run_until(lambda: not app_driver.controller.settings.busy)
        now, seen = app_driver.controller.operating_state, targets(app_driver)
        for each in commands(app_driver):
            by_page = each.needs is while_editing or each.leads
            if each.place != panel or each.name.endswith(".open") or by_page:
                continue
            button, reason = seen[each.name], each.needs(now) or each.refusal(now)
            said = "" if button.isEnabled() else button.toolTip()
            if said != reason and (reason or each.operation is not None):
                wrong[each.name] = (said, reason)
    assert wrong == {}


def test_every_command_of_a_panel_has_its_button(app_driver):
    app_driver.connect()
    for panel in PANELS:
        show_all_of(app_driver, panel)
        seen = targets(app_driver)
        for each in commands(app_driver):
            if each.place in {panel, "window", "view"}:
                assert each.name in seen or each.name in ONLY_AT_TIMES, each.name


def test_names_are_used_once(app_driver):
    names = [each.name for each in commands(app_driver)]
    assert len(set(names)) == len(names)


# Shortcuts ----------------------------------------------------------------------------------------


def test_the_list_of_shortcuts_shows_each_of_them(app_driver):
    QTest.keyClick(app_driver.window, Qt.Key.Key_Question)
    dialog = app_driver.dialog(ShortcutList)
    shown = [cap.text() for cap in dialog.findChildren(KeyCap)]
    assert sorted(shown) == sorted(each.text() for each in SHORTCUTS.values())


@pytest.mark.parametrize("place", sorted({each.place for each in SHORTCUTS.values()}))
def test_the_function_keys_of_a_place_are_listed_in_their_order(place):
    keys = (each.keys.partition(",")[0] for each in SHORTCUTS.values() if each.place == place)
    numbers = [int(each[1:]) for each in keys if re.fullmatch(r"F\d+", each)]
    assert numbers == sorted(numbers)


def test_a_question_mark_can_be_typed(app_driver):
    field = app_driver.find("target_field_1")
    field.setFocus()
    QTest.keyClick(field, Qt.Key.Key_Question)
    assert not [each for each in app_driver.window.findChildren(ShortcutList) if each.isVisible()]


OVERLAPPING = [
    {"everywhere", "window", "view"},
    *({"everywhere", "window", panel} for panel in ("motion", "light", "gripper", "parameters")),
    *({"everywhere", place} for place in ("library", "editor", "plots", "events", "bus", "replay")),
]


@pytest.mark.parametrize("places", OVERLAPPING, ids=lambda each: "-".join(sorted(each)))
def test_no_key_means_two_things_at_one_place(places):
    keys = [
        each.keys
        for each in SHORTCUTS.values()
        if each.place in places and each.by_qt and each.keys != "Esc"
    ]
    assert len(set(keys)) == len(keys)


def test_every_place_of_a_shortcut_is_known(app_driver):
    places = PLACES.keys() | set(PANELS)
    assert {each.place for each in SHORTCUTS.values()} <= places
    assert {each.place for each in commands(app_driver)} <= places


def test_tooltips_name_the_keys_of_the_table(app_driver):
    app_driver.connect()
    app_driver.enable_by_hand()
    seen = targets(app_driver)
    for each in commands(app_driver):
        if each.place in ("motion", "window") and each.keys:
            assert f"({each.keys})" in seen[each.name].toolTip()


def test_release_is_found_with_its_reason_and_once_stopped_only_led_to(app_driver):
    app_driver.ready()

    def release():
        found = (each for each in palette_items(app_driver) if each.command.name == RELEASE)
        return next(found)

    assert release().reason == "The arm is not in emergency stop: there is nothing to release."
    app_driver.controller.emergency_stop()
    app_driver.run_until(lambda: app_driver.controller.recovery.step.kind is StepKind.STOPPED)
    app_driver.heard()
    assert not release().reason
    palette = command(app_driver, "release the emergency stop")
    held = app_driver.find("recovery_hold_button")
    assert not palette.isVisible()
    assert app_driver.window.focusWidget() is held
    app_driver.run(1.5)
    assert app_driver.firmware.condition.stopped, "it is to be held by hand"
    assert app_driver.heard() == []
    app_driver.hold_button(held)
    app_driver.run_until(lambda: not app_driver.firmware.condition.stopped)
    assert release().reason


def test_the_way_back_inside_the_limits_is_led_to(app_driver):
    app_driver.ready()
    outside_limits(app_driver)
    app_driver.run_until(lambda: app_driver.controller.recovery.step.kind is StepKind.OUTSIDE)
    command(app_driver, "bring the arm inside its limits")
    assert app_driver.window.focusWidget() is app_driver.find("recovery_hold_button")


def test_the_next_step_of_a_run_that_is_paused_leads_to_its_button(app_driver):
    operator = Operator(app_driver, to(OUT), to(BACK))
    operator.send()
    operator.until(lambda: operator.progress.phase is RunPhase.MOVING)
    app_driver.run(0.5)
    app_driver.click("run_pause")
    operator.until(lambda: operator.progress.phase is RunPhase.PAUSED)
    app_driver.run_until(lambda: app_driver.controller.recovery.step.kind is StepKind.RUN_PAUSED)
    command(app_driver, "next step")
    held = app_driver.find("run_continue")
    assert app_driver.window.focusWidget() is held
    app_driver.run(0.5)
    assert operator.progress.phase is RunPhase.PAUSED, "it is to be held by hand"
    app_driver.click("run_stop")


def test_the_next_step_of_a_run_that_waits_is_not_taken_unseen(app_driver):
    operator = Operator(app_driver, to(OUT), to(BACK))
    operator.child("run_steps").setChecked(True)
    operator.send()
    operator.until(lambda: operator.progress.phase is RunPhase.WAITING)
    app_driver.run_until(lambda: app_driver.controller.recovery.step.kind is StepKind.RUN_WAITS)
    command(app_driver, "next step")
    assert app_driver.window.focusWidget() is app_driver.find("run_next")
    assert operator.progress.phase is RunPhase.WAITING


def test_what_must_be_held_is_only_led_to(app_driver):
    """Enter in the list is no finger on a button: a held motion never goes on by it (S11)."""
    app_driver.ready()
    app_driver.click("menu_teaching")
    held = [each for each in palette_items(app_driver) if isinstance(each.target, HoldButton)]

    assert {each.command.name for each in held} >= {"teaching.continue", "teaching.plan_continue"}
    assert all(each.command.only_led_to for each in held)


def test_a_motion_that_is_held_back_does_not_go_on_by_the_palette(app_driver):
    app_driver.ready()
    accepted(app_driver.controller.motion.send_joints((60.0, 30.0, -30.0, 0.0, 0.0, 0.0)))
    app_driver.run(0.3)
    app_driver.click("menu_teaching")
    app_driver.click("plan_pause")
    app_driver.run(1.0)
    stands_deg = app_driver.firmware.joints_deg

    command(app_driver, "continue the held motion")
    app_driver.run(1.0)

    assert app_driver.firmware.joints_deg == pytest.approx(stands_deg, abs=0.05)
    assert app_driver.window.focusWidget() is app_driver.find("plan_continue")
