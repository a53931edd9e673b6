"""The emergency stop, M6: at the press, from everywhere, never asked about."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QColor
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialog, QLineEdit, QVBoxLayout, QWidget

from armui.control.devices.joint_monitor import JointMonitor
from armui.control.operating_state import OperatingState, StopState
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.shell.top_bar import TopBar
from armui.ui.theme import colors_of
from armui.ui.widgets.halt_button import HaltButton
from armui.ui.widgets.stop_button import StopButton
from armui.ui.widgets.stop_shortcut import StopShortcut
from tests.ui.arm_states import operating_state

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def host(qtbot):
    window = QWidget()
    QVBoxLayout(window)
    qtbot.addWidget(window)
    return window


@pytest.fixture
def button(host, controller):
    button = TopBar(controller, lambda: None, JointMonitor(controller), host).findChild(StopButton)
    host.layout().addWidget(button)
    host.show()
    return button


def questions(host):
    return [dialog for dialog in host.findChildren(ConfirmDialog) if dialog.isVisible()]


def test_stops_when_pressed_not_when_let_go(button, controller, qtbot):
    qtbot.mousePress(button, LEFT)
    assert controller.calls == [("emergency_stop",)]
    qtbot.mouseRelease(button, LEFT)
    assert controller.calls == [("emergency_stop",)]


class Painted(QObject):
    """Notes when a button is painted."""

    def __init__(self, button, calls):
        super().__init__(button)
        self._calls = calls
        button.installEventFilter(self)

    def eventFilter(self, _button, event):
        if event.type() == QEvent.Type.Paint:
            self._calls.append(("painted",))
        return False


@pytest.mark.parametrize(
    ("kind", "done"), [(StopButton, "emergency_stop"), (HaltButton, "halt_and_hold")]
)
def test_acts_before_it_is_painted(host, controller, qtbot, kind, done):
    button = kind(controller)
    Painted(button, controller.calls)
    host.layout().addWidget(button)
    host.show()
    qtbot.waitUntil(lambda: ("painted",) in controller.calls)
    controller.calls.clear()
    qtbot.mousePress(button, LEFT)
    names = [name for (name, *_rest) in controller.calls]
    assert names[0] == done
    assert names.count(done) == 1
    assert "painted" in names


@pytest.mark.parametrize("button", [Qt.MouseButton.RightButton, Qt.MouseButton.MiddleButton])
def test_other_buttons_of_the_mouse_do_nothing(host, controller, qtbot, button):
    stop = StopButton(controller)
    host.layout().addWidget(stop)
    host.show()
    qtbot.mousePress(stop, button)
    assert controller.calls == []
    qtbot.mouseRelease(stop, button)


def test_stops_by_space(button, controller, qtbot):
    button.setFocus()
    qtbot.keyClick(button, Qt.Key.Key_Space)
    assert controller.calls == [("emergency_stop",)]


@pytest.mark.parametrize(
    "now",
    [
        OperatingState(),
        operating_state(stop=StopState.RUNNING),
        operating_state(stop=StopState.REQUESTED),
        operating_state(stop=StopState.REQUESTED, stop_unconfirmed=True),
        operating_state(stop=StopState.STOPPED),
        operating_state(stop=StopState.RESUMING),
    ],
)
def test_always_enabled_and_always_stops(button, controller, host, qtbot, now):
    controller.be(now)
    assert button.isEnabled()
    qtbot.mouseClick(button, LEFT)
    assert controller.calls == [("emergency_stop",)]
    assert not questions(host)


def test_every_state_has_its_word(button, controller):
    words = []
    for now in (
        operating_state(),
        operating_state(stop=StopState.REQUESTED),
        operating_state(stop=StopState.REQUESTED, stop_unconfirmed=True),
        operating_state(stop=StopState.STOPPED),
        operating_state(stop=StopState.RESUMING),
    ):
        controller.be(now)
        words.append(button.text())
    assert words == [
        "Emergency stop",
        "Stopping…",
        "Stop unconfirmed",
        "Emergency stop",
        "Emergency stop",
    ]


def test_a_press_while_stopped_stops_again_and_says_where_release_is(
    button, controller, host, qtbot
):
    controller.be(operating_state(stop=StopState.STOPPED))
    qtbot.mouseClick(button, LEFT)
    assert controller.calls == [("emergency_stop",)]
    assert not questions(host)
    assert "Release stands in the line of the next step" in button.toolTip()


def test_quick_presses_all_mean_stop(button, controller, host):
    # the arm stops between the two presses of one alarmed hand
    QTest.mousePress(button, LEFT)
    controller.be(operating_state(stop=StopState.STOPPED))
    QTest.mouseDClick(button, LEFT)
    assert set(controller.calls) == {("emergency_stop",)}
    assert len(controller.calls) >= 2
    assert not questions(host)


def test_the_stop_of_a_dialog_never_asks(host, controller, qtbot):
    button = StopButton(controller, host)
    controller.be(operating_state(stop=StopState.STOPPED))
    assert button.text() == "Emergency stop"
    qtbot.mouseClick(button, LEFT)
    assert controller.calls == [("emergency_stop",)]
    assert not questions(host)


def test_the_bar_stands_still(button, controller):
    sizes = set()
    for stop in StopState:
        controller.be(operating_state(stop=stop))
        sizes.add(button.sizeHint().toTuple())
    assert len(sizes) == 1


@pytest.mark.parametrize("slim", [False, True])
def test_halt_wears_a_full_square(host, controller, slim):
    """Two bars, as before, would promise that the motion goes on."""
    halt = HaltButton(controller, slim=slim)
    host.layout().addWidget(halt)
    host.show()
    image = halt.grab().toImage()
    ink = QColor(colors_of(halt).stop_ink)
    middle = image.height() // 2
    inked = [x for x in range(4, image.width() - 4) if image.pixelColor(x, middle) == ink]
    first = inked[0]
    side = next(at for at in range(1, image.width()) if first + at not in inked)
    assert 7 <= side <= 14
    square = [(x, y) for x in range(side) for y in range(side)]
    top = middle - side // 2
    for x, y in square:
        assert image.pixelColor(first + x, top + y) == ink, (x, y)


def test_the_red_place_stays_red(button, controller):
    for stop in StopState:
        controller.be(operating_state(stop=stop))
        ground = button.grab().toImage().pixelColor(6, button.height() // 2)
        assert ground.red() > 180, stop
        assert ground.green() < 80, stop


@pytest.fixture
def shortcut(qapp, controller):
    shortcut = StopShortcut(qapp, controller)
    yield shortcut
    qapp.removeEventFilter(shortcut)
    shortcut.deleteLater()


@pytest.mark.parametrize("key", [Qt.Key.Key_F12, Qt.Key.Key_Pause])
def test_keys_stop_from_any_field(host, shortcut, controller, qtbot, key):
    field = QLineEdit("text")
    host.layout().addWidget(field)
    host.show()
    qtbot.keyClick(field, key)
    assert controller.calls == [("emergency_stop",)]
    assert field.text() == "text"


@pytest.mark.usefixtures("shortcut")
def test_keys_stop_under_a_modal_dialog(host, controller, qtbot):
    host.show()
    dialog = QDialog(host)
    dialog.setModal(True)
    dialog.show()
    qtbot.keyClick(dialog, Qt.Key.Key_F12)
    qtbot.keyClick(host, Qt.Key.Key_F12)
    dialog.close()
    assert controller.calls == [("emergency_stop",)] * 2


@pytest.mark.usefixtures("shortcut")
def test_a_key_never_resumes(button, controller, host, qtbot):
    controller.be(replace(operating_state(), stop=StopState.STOPPED))
    qtbot.keyClick(button, Qt.Key.Key_F12)
    assert controller.calls == [("emergency_stop",)]
    assert not questions(host)


@pytest.mark.usefixtures("shortcut")
def test_other_keys_pass(host, controller, qtbot):
    field = QLineEdit()
    host.layout().addWidget(field)
    qtbot.keyClicks(field, "12.5")
    assert field.text() == "12.5"
    assert controller.calls == []


@pytest.fixture
def late_shortcut(qapp, controller, host):
    """As the program has it: it listens from the first window's first picture on."""
    shortcut = StopShortcut(qapp, controller, host)
    yield shortcut
    qapp.removeEventFilter(shortcut)
    shortcut.deleteLater()


@pytest.mark.usefixtures("late_shortcut")
@pytest.mark.parametrize("shown", [True, False])
def test_keys_stop_once_the_first_window_was_painted_or_might_have_been(
    host, controller, qtbot, shown
):
    """A window that is never painted, a minimised one, keeps no key from stopping the arm."""
    field = QLineEdit()
    qtbot.addWidget(field)
    host.setVisible(shown)

    def stopped():
        qtbot.keyClick(field, Qt.Key.Key_F12)
        return ("emergency_stop",) in controller.calls

    qtbot.waitUntil(stopped)
    controller.calls.clear()
    qtbot.keyClick(field, Qt.Key.Key_F12)
    assert controller.calls == [("emergency_stop",)]
