"""The whole program on the rig, in the hands of an operator who clicks and reads."""

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, Future
from contextlib import AbstractContextManager, contextmanager, nullcontext
from pathlib import Path
from typing import Any, TypeVar
from unittest.mock import patch

from PySide6.QtCore import QCoreApplication, QEvent, QEventLoop, QObject, QPoint, Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialog, QTableView, QWidget
from shiboken6 import isValid

from armui.app import Program
from armui.protocol.generation import Generation
from armui.settings import SettingsStore
from armui.sim.faults.schedule import fault
from armui.ui import theme
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.dialogs.connect import ConnectDialog
from armui.ui.shell import operation_area
from armui.ui.widgets.hold_button import HoldButton
from armui.ui.widgets.page import Page
from armui.viewport.client import PictureClient
from tests.arm_rig import TIMEOUT_MS, ArmRig

PANELS = tuple(entry.key for entry in operation_area.PANELS)
"""The keys of the panels, in the order of the menu."""

_Dialog = TypeVar("_Dialog", bound=QDialog)
_Page = TypeVar("_Page", bound=Page)


class AtOnce(Executor):
    """Does everything while it is being asked: nothing to wait for."""

    def submit(self, fn, /, *args, **kwargs):
        done: Future[Any] = Future()
        try:
            done.set_result(fn(*args, **kwargs))
        except Exception as error:  # noqa: BLE001 - whatever it is, it is in the answer
            done.set_exception(error)
        return done


class Slow(Executor):
    """Does nothing before it is told to: work may take any time, and fail."""

    def __init__(self):
        self.waiting = []

    def submit(self, fn, /, *args, **kwargs):
        future: Future[Any] = Future()
        self.waiting.append((future, fn, args, kwargs))
        return future

    def work(self):
        """Do everything that was asked for."""
        while self.waiting:
            future, fn, args, kwargs = self.waiting.pop(0)
            future.set_result(fn(*args, **kwargs))

    def break_down(self, text):
        """Fail at everything that was asked for."""
        while self.waiting:
            self.waiting.pop(0)[0].set_exception(RuntimeError(text))


class _Shutter(QObject):
    """Puts off what windows want painted; what has changed adds up meanwhile, as Qt keeps it."""

    def __init__(self) -> None:
        super().__init__()
        self._put_off: list[QWidget] | None = None

    @contextmanager
    def closed(self) -> Iterator[None]:
        """Paint the windows there are once it is over, and not before."""
        if self._put_off is not None:
            yield
            return
        self._put_off = []
        windows = [each for each in QApplication.topLevelWidgets() if each.isVisible()]
        for window in windows:
            window.installEventFilter(self)
        try:
            yield
        finally:
            put_off, self._put_off = self._put_off, None
            for window in filter(isValid, windows):
                window.removeEventFilter(self)
            for window in filter(isValid, put_off):
                QCoreApplication.sendEvent(window, QEvent(QEvent.Type.UpdateRequest))

    def eventFilter(self, window: QObject, event: QEvent) -> bool:
        """Keep a window from being painted."""
        if event.type() is not QEvent.Type.UpdateRequest or self._put_off is None:
            return False
        if isinstance(window, QWidget) and window not in self._put_off:
            self._put_off.append(window)
        return True


class RigHand:
    """The hand at the arm of a rig, as `LineHand` is at that of another process."""

    def __init__(self, rig: ArmRig) -> None:
        self._rig = rig
        self.faults: set[tuple[str, int]] = set()

    def lead_to(self, joints_deg: Sequence[float], speed_deg_s: float = 30.0) -> None:
        """Lead all joints to six angles."""
        self._rig.firmware.hand_guiding.lead_to(joints_deg, speed_deg_s)

    def release(self) -> None:
        """Release the arm."""
        self._rig.firmware.hand_guiding.release()

    def switch(self, name: str, joint: int, *, begins: bool) -> None:
        """Begin or end a fault."""
        (self.faults.add if begins else self.faults.discard)((name, joint))
        faults = self._rig.node.faults
        (faults.start if begins else faults.end)(fault(name, joint or None))


class AppDriver(ArmRig):
    """A rig with the main window on it.

    Args:
        app: Qt's application.
        channel: Of the virtual bus, this program's alone.
        settings: The file of the operator's settings; the library lies beside it.
        generation: Of the simulated arm's protocol.
        workers: Who does what takes long; whoever asks does it by default.
        files: Who does what waits for a disk; whoever asks does it by default.
        draws: Whether the 3D view is seen: drawing it costs more than most tests.
        pictures: Has the 3D picture drawn; several programs one after another may share one.
        styled: Whether it has the style sheet: half of what a window costs is to ask it.

    Attributes:
        program: The program, wired as it is for the operator.
        window: Its main window, shown.
        library_folder: Where its trajectories are kept.
        workers: As given.
        hand: At its simulated arm.
    """

    def __init__(
        self,
        app: QApplication,
        channel: str,
        settings: Path,
        generation: Generation,
        workers: Executor | None = None,
        *,
        files: Executor | None = None,
        draws: bool = False,
        pictures: PictureClient | None = None,
        styled: bool = True,
    ) -> None:
        super().__init__(channel, generation)
        self.store = SettingsStore(settings, for_this_run={"language": "en"})
        self.library_folder = settings.parent / "trajectories"
        self.workers = workers or AtOnce()
        self.hand = RigHand(self)
        if bool(app.styleSheet()) is not styled:
            _ask_style_sheet_anew(app)
        self._styled = styled
        with nullcontext() if styled else patch.object(theme, "style_sheet", return_value=""):
            self.program = Program(
                app,
                self.store,
                self.controller,
                self.workers,
                self.library_folder,
                files=files or AtOnce(),
                pictures=pictures,
                hand=lambda: self.hand,
                clock=lambda: self.time_s,
                socket=settings.parent / "r" / "api.sock",
            )
        self.window = self.program.window
        self.window.resize(1280, 800)
        self.program.view.setVisible(draws)
        self._shutter = None if draws else _Shutter()
        self.window.show()

    def run(self, seconds: float) -> None:
        """Let so much time pass; the windows are painted when it has, not at each step."""
        with self._unpainted():
            super().run(seconds)

    def run_until(self, condition: Callable[[], bool], seconds: float = 20.0) -> None:
        """Let time pass until something is so; the windows are painted then."""
        with self._unpainted():
            super().run_until(condition, seconds)

    def _unpainted(self) -> AbstractContextManager[None]:
        return nullcontext() if self._shutter is None else self._shutter.closed()

    def find(self, name: str) -> Any:
        """A widget of the main window by its object name; the test knows its kind."""
        found = [
            widget
            for widget in self.window.findChildren(QWidget, name)
            if widget.window() is self.window
        ]
        assert len(found) == 1, f"{name}: {found}"
        return found[0]

    def click(self, name_or_widget: str | QWidget | None) -> None:
        """Press and release the left button over the middle of a widget, which must be there."""
        widget = self.find(name_or_widget) if isinstance(name_or_widget, str) else name_or_widget
        assert widget is not None
        if isinstance(name_or_widget, str) and name_or_widget.startswith("menu_"):
            self._unfold_menu_for(widget)
        QTest.mouseClick(widget, Qt.MouseButton.LeftButton, pos=_middle(widget))

    def _unfold_menu_for(self, entry: QWidget) -> None:
        """Unfold the group of the menu in which an entry is hidden, as an operator would."""
        if not entry.isVisible():
            fold = self.find("menu_fold")
            QTest.mouseClick(fold, Qt.MouseButton.LeftButton, pos=_middle(fold))
            assert entry.isVisible()

    def press(self, widget: QWidget) -> None:
        """Press the left button over a widget and keep it down."""
        QTest.mousePress(widget, Qt.MouseButton.LeftButton, pos=_middle(widget))

    def type_into(self, name: str, text: str) -> None:
        """Replace what stands in a field and leave it with Enter."""
        field = self.find(name)
        field.setFocus()
        field.selectAll()
        QTest.keyClicks(field, text)
        QTest.keyClick(field, Qt.Key.Key_Return)

    def read(self, name: str) -> str:
        """The text a widget shows."""
        text: str = self.find(name).text()
        return text

    def dialog(self, kind: type[_Dialog]) -> _Dialog:
        """The one dialog of a kind that is open."""
        found = [
            widget
            for widget in QApplication.topLevelWidgets()
            if isinstance(widget, kind) and widget.isVisible()
        ]
        assert len(found) == 1, f"{kind.__name__}: {found}"
        return found[0]

    def page(self, kind: type[_Page]) -> _Page:
        """The one page of a kind that is seen, in the main window or taken out."""
        found = [
            widget
            for widget in QApplication.allWidgets()
            if isinstance(widget, kind) and widget.isVisible()
        ]
        assert len(found) == 1, f"{kind.__name__}: {found}"
        return found[0]

    def taken_out(self, kind: type[_Page]) -> _Page:
        """The page of a kind that is seen, in a window of its own by now."""
        page = self.page(kind)
        if page.window() is self.window:
            docked = self.find("drawer").isAncestorOf(page)
            self.click("drawer_take_out" if docked else "page_take_out")
        return page

    def connect_by_hand(self) -> None:
        """Open 连接机械臂, choose the arm in the list, connect, close the window."""
        self.click("communication_button")
        dialog = self.dialog(ConnectDialog)
        table = dialog.findChild(QTableView)
        self.wait(lambda: table.model().rowCount() > 0)
        table.selectRow(0)
        self.click(dialog.connect_button)
        self.run_until(lambda: "limits_read" in self.codes())
        self.run_until(lambda: None not in self.controller.operating_state.enabled)
        dialog.close()

    def confirm(self) -> None:
        """Press, or hold, the button of the open question that does it."""
        button = self.dialog(ConfirmDialog).action_button
        if isinstance(button, HoldButton):
            self.hold()
        else:
            self.click(button)

    def hold(self, share: float = 1.0) -> None:
        """Hold the button of the open question; its time passes at once, or a share of it."""
        self.hold_button(self.dialog(ConfirmDialog).action_button, share)

    def hold_button(self, button: QWidget | str, share: float = 1.0) -> None:
        """Hold a button; its time passes at once, or a share of it."""
        button = self.find(button) if isinstance(button, str) else button
        self.press(button)
        button.progress.setCurrentTime(round(share * button.progress.duration()))
        if share < 1.0:
            QTest.mouseRelease(button, Qt.MouseButton.LeftButton, pos=_middle(button))

    def enable_by_hand(self) -> None:
        """Press 使能 and wait for the arm's word."""
        self.click("enable_button")
        self.run_until(lambda: self.controller.operating_state.cannot_move is None)

    def wait(self, condition) -> None:
        """Let Qt and the threads work until something is so."""
        loop = QEventLoop()
        timer = QTimer(interval=1)
        timer.timeout.connect(lambda: loop.quit() if condition() else None)
        deadline = QTimer(interval=TIMEOUT_MS, singleShot=True)
        deadline.timeout.connect(loop.quit)
        timer.start()
        deadline.start()
        try:
            loop.exec()
        finally:  # what it looks at may be gone when the next test lets Qt work
            timer.stop()
        assert condition(), "it never came"

    def close(self) -> None:
        """End the program as it ends for the operator, then the rig."""
        for widget in QApplication.topLevelWidgets():
            if isinstance(widget, QDialog):
                widget.close()
        if self.store.settings.language != "en":
            self.store.change(language="en")  # the next test reads English
        self.program.shutdown()
        self.window.deleteLater()
        if not self._styled:
            _ask_style_sheet_anew(self.program._app)
        super().close()


def _ask_style_sheet_anew(app: QApplication) -> None:
    """Have the program not count on the style sheet that is there."""
    follower = app.property(theme._FOLLOWER)
    if follower is not None:
        follower._sheet = None


def _middle(widget: QWidget) -> QPoint:
    return widget.rect().center()
