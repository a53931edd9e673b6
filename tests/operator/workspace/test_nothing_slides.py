"""Whatever comes or goes by itself moves no button that moves the arm: one may be held."""

import re

import pytest
from PySide6.QtWidgets import QAbstractButton, QWidget

from armui.control.motion.jog_stream import JOG_SINGULAR
from armui.control.safety.recovery_steps import Action, StepKind
from armui.system.failures import Failure
from armui.ui.widgets.hold_guard import HOLD_UNATTENDED
from tests.company import OtherHost
from tests.operator.workspace.actions import rect_in_window

pytestmark = [pytest.mark.styled, pytest.mark.timeout(240)]

SIZES = ((1280, 800), (1440, 900))
PANELS = ("motion", "cartesian", "gripper")
MOVES = re.compile(
    "jog_|box_|pose_|home_|own_home|load_|send_|move_|arc_|gripper_|capture_|run_send|run_resume"
)
LONG = (HOLD_UNATTENDED(seconds=60.0), JOG_SINGULAR(joint=3))


class Places:
    """The places of the buttons that move the arm, in the panel or page that is seen."""

    def __init__(self, driver, size, language):
        self.driver = driver
        driver.ready()
        driver.store.change(language=language)
        driver.window.resize(*size)
        self.host = OtherHost(driver)
        self.slid = []

    def now(self):
        self.driver.window.layout().activate()
        self.driver.run(0.1)
        seen = self.driver.window.findChildren(QAbstractButton)
        seen = [each for each in seen if each.isVisible() and MOVES.match(each.objectName())]
        return {each.objectName(): rect_in_window(each) for each in seen}

    def look(self, what, before):
        now = self.now()
        assert "run_send" in now or len(now) > 5, "nothing was looked at"
        moved = [name for name in before if name in now and now[name] != before[name]]
        if moved:
            self.slid.append(f"{what}: {moved}")

    def while_it_is_so(self, name, cause, undo):
        before = self.now()
        cause()
        self.look(f"{name} comes", before)
        undo()
        self.look(f"{name} goes", before)

    # what may come by itself -------------------------------------------------------------------

    def of_the_arm(self, where):
        """Stops, faults, others, silence; a failure of the program."""
        driver, window = self.driver, self.driver.window
        failure = Failure("ValueError: something", "of a test", (), 1)
        for name, cause, undo in (
            ("stop", driver.controller.emergency_stop, self.recover),
            ("motors off", lambda: self.host.say("471#0701000000000000"), self.recover),
            ("other host", lambda: self.host.move_to((1, 0, 0, 0, 0, 0)), self.recover),
            ("silence", lambda: setattr(driver, "powered", False), self.switch_on),
            (
                "failure",
                lambda: window.show_failure(failure, motion_ended=True),
                lambda: driver.click("failure_close_button"),
            ),
        ):
            self.while_it_is_so(
                f"{where}, {name}", lambda act=cause: (act(), driver.run(1.0)), undo
            )

    def switch_on(self):
        self.driver.powered = True
        self.recover()

    def recover(self):
        recovery = self.driver.controller.recovery
        for _ in range(25):
            if recovery.step.kind is StepKind.READY:
                return
            if recovery.step.action not in (None, Action.CONNECT):
                recovery.act(recovery.step)
            self.driver.run(1.0)
        raise AssertionError(recovery.step)

    def of_a_run(self, editor):
        """A run begins, is paused, and is ended by the stop; its end is put away."""
        driver, player = self.driver, self.driver.controller.player
        before = self.now()
        driver.click(editor.findChild(QWidget, "run_send"))
        accept = editor.findChild(QWidget, "accept_warnings")
        if accept.isVisible():
            self.look("the question", before)
            driver.click(accept)
        driver.run_until(lambda: player.running)
        self.look("a run", before)
        driver.click("run_pause")
        self.look("its pause", before)
        driver.controller.emergency_stop()
        driver.run(1.0)
        self.look("its end", before)
        self.recover()
        for panel in PANELS:
            driver.click(f"menu_{panel}")
            before_panel = self.now()
            driver.find("run_strip").hide()
            self.look(f"put away beside {panel}", before_panel)
            driver.find("run_strip").show()
        driver.click("library_button")
        driver.click("run_close")
        self.look("put away", before)
        assert player.progress.count


@pytest.mark.each_value(full="each size in both languages")
@pytest.mark.parametrize("language", ["en", "zh"])
@pytest.mark.parametrize("size", SIZES)
def test_in_the_panels(pages, size, language):
    places = Places(pages.driver, size, language)
    for key in PANELS:
        pages.driver.click(f"menu_{key}")
        panel = pages.driver.find("operation_area").currentWidget()
        places.of_the_arm(key)
        for reason in LONG:
            places.while_it_is_so(
                f"{key}, {reason}",
                lambda panel=panel, reason=reason: panel._accepted(reason),
                lambda panel=panel: panel._accepted(None),
            )
    assert not places.slid


@pytest.mark.each_value(full="each size in both languages")
@pytest.mark.parametrize("language", ["en", "zh"])
@pytest.mark.parametrize("size", SIZES)
def test_in_the_editor(pages, size, language):
    places = Places(pages.driver, size, language)
    editor = pages.open_editor()
    pages.driver.click("editor_jog")
    places.of_the_arm("editor")
    places.of_a_run(editor)
    controller = pages.driver.controller
    fit = controller.operating_state.model_fit
    for kind in ("joints", "base", "gripper"):
        pages.driver.click(f"box_{kind}")

        def everything():
            editor._find_bar.open()
            pages.driver.click(editor.findChild(QWidget, "editor_check"))
            editor._on_refused(LONG[0])
            editor._other_arm.show_arms("another arm", fit)
            controller.motion.set_speed_percent(50)
            controller.motion.set_speed_percent(100)

        def nothing():
            editor._find_bar.hide()
            editor._findings.clear()
            editor._on_refused(None)
            editor._other_arm.show_arms("", fit)
            controller.motion.set_speed_percent(100)
            controller.motion.set_speed_percent(5)

        places.while_it_is_so(f"everything at once, {kind}", everything, nothing)
    assert not places.slid


def test_a_message_beside_the_jog_buttons_is_in_sight_whatever_is_open_above(pages):
    pages.driver.ready()
    editor = pages.open_editor()
    pages.driver.click("editor_jog")
    editor._find_bar.open()
    pages.driver.click(editor.findChild(QWidget, "editor_check"))
    editor._on_refused(LONG[0])
    pages.driver.run(0.1)
    message = pages.driver.find("editor_message")
    middle = message.mapTo(pages.driver.window, message.rect().center())
    shown = pages.driver.window.childAt(middle)
    assert shown is not None
    assert message.isAncestorOf(shown)
