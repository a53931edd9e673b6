"""The window 设置: language, theme, jog step, robot description (manual 1.0.8 ③)."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QGridLayout,
    QLabel,
    QLineEdit,
    QWidget,
)

from armui.arm.models import model_data
from armui.arm.refusal import Refusal
from armui.control.arm_controller import ArmController
from armui.control.cell.cell_control import why_not_change
from armui.control.cell.cell_reasons import CELL_WHILE_MOVING
from armui.control.events import Level
from armui.setting_checks import JOG_STEP_NOT_A_NUMBER
from armui.setting_fields import JOG_FLOOR_MM, JOG_STEP_DEG, LIVE_PORT
from armui.settings import SettingsStore
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.command import Command, Target, also, with_simulated
from armui.ui.dialogs.base import ArmDialog, CloseButton
from armui.ui.dialogs.files import choose_file
from armui.ui.gamepad.gamepad_dialog import GamepadDialog
from armui.ui.widgets.buttons import (
    caption,
    describe,
    enable_or_explain,
    named,
    push_button,
    spin_box,
)
from armui.ui.widgets.layouts import STRETCH, empty_grid, fill, in_row
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.painting import repolish
from armui.ui.widgets.text_label import ElidedLabel, text_label
from armui.ui.words.settings import setting_label, setting_tip
from armui.ui.words.text import Text
from armui.viewport.messages import URDF_MISSING

if TYPE_CHECKING:
    from armui.control.operating_state import OperatingState

_SIZE_PX: Final = (680, 500)
_STEP_WIDTH_PX: Final = 90
_LANGUAGES: Final = (("zh", "中文"), ("en", "English"))
"""The languages, each in its own name, so that its readers find it."""
_BOXES: Final = ("stop_again", "live", "live_for_others")
"""The settings with a check box, from top to bottom."""


class SettingsDialog(ArmDialog):
    """Changes the program's settings; each takes effect at once and is saved.

    Args:
        store: The settings.
        controller: Receives the emergency stop.
        parent: The main window.

    Signals:
        diagnosis_wanted: The operator wants to know what is wrong.
        about_arm_wanted: The operator wants to know which arm this is.
        about_wanted: The operator wants to know which program this is.
    """

    commands = (
        Command(
            "settings.gamepad",
            Text("SettingsDialog", "Gamepad…"),
            synonyms=also("joystick spacemouse 摇杆"),
        ),
        Command("settings.jog_floor", setting_label("jog_floor_mm")),
        *(Command(f"settings.{name}", setting_label(name)) for name in _BOXES),
    )
    diagnosis_wanted = Signal()
    about_arm_wanted = Signal()
    about_wanted = Signal()

    def __init__(
        self, store: SettingsStore, controller: ArmController, parent: QWidget | None = None
    ) -> None:
        super().__init__(controller, parent)
        self._store = store
        self._controller = controller
        self._problem: Refusal | None = next(iter(store.problems), None)
        self._jog_step_wrong = False
        self._build()
        self.resize(*_SIZE_PX)
        controller.operating_state_changed.connect(self._on_operating_state)
        self._connected: tuple[object, ...] = ()
        self.language_box.activated.connect(self._on_language)
        self.theme_box.activated.connect(self._on_theme)
        self.jog_step_edit.editingFinished.connect(self._on_jog_step)
        for name, box in self._boxes.items():
            box.clicked.connect(partial(self._on_box, name))
        self.jog_floor_box.clicked.connect(self._on_jog_floor)
        self.jog_floor_spin.valueChanged.connect(self._on_jog_floor)
        self.live_port_spin.valueChanged.connect(self._on_live_port)
        self.browse_button.clicked.connect(self._on_browse)
        self.built_in_button.clicked.connect(self._on_built_in)
        self.diagnosis_button.clicked.connect(self.diagnosis_wanted)
        self.about_arm_button.clicked.connect(self.about_arm_wanted)
        self.about_button.clicked.connect(self.about_wanted)
        self.gamepad_button.clicked.connect(self._on_gamepad)
        self.language_box.setFocus()
        self.retranslate_ui()

    def show_robot_problem(self, reason: Refusal) -> None:
        """Show why the chosen robot description cannot be shown; the old one stays in view."""
        self._show_problem(reason)

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        return {
            "settings.gamepad": self.gamepad_button,
            "settings.jog_floor": self.jog_floor_box,
            **{f"settings.{name}": box for name, box in self._boxes.items()},
        }

    # Layout -----------------------------------------------------------------------------------

    def _build(self) -> None:
        self._language_label, self.language_box = QLabel(), QComboBox()
        self._theme_label, self.theme_box = QLabel(), QComboBox()
        self._jog_label, self.jog_step_edit = QLabel(), QLineEdit()
        self._jog_hint = text_label(rank="muted")
        self._urdf_label, self._urdf_name = QLabel(), named("urdf_name", ElidedLabel())
        self._boxes = {name: named(f"{name}_box", QCheckBox()) for name in _BOXES}
        self.jog_floor_box = named("jog_floor_box", QCheckBox())
        self.jog_floor_spin = named(
            "jog_floor_spin", spin_box(JOG_FLOOR_MM.least, JOG_FLOOR_MM.most, " mm", step=10)
        )
        self.live_port_spin = named("live_port_spin", spin_box(LIVE_PORT.least, LIVE_PORT.most))
        for spin in (self.jog_floor_spin, self.live_port_spin):
            spin.setKeyboardTracking(False)
        self.browse_button, self.built_in_button = (push_button(on_enter=False) for _ in range(2))
        self.diagnosis_button = push_button("diagnosis_button", on_enter=False)
        self.about_arm_button = push_button("about_arm_button", on_enter=False)
        self.about_button = push_button("about_button", on_enter=False)
        self.faults_button = push_button("faults_button", on_enter=False)
        self._gamepad_label, self._gamepad_state = QLabel(), ElidedLabel()
        self.gamepad_button = push_button("gamepad_button", on_enter=False)
        self._gamepad_dialog: GamepadDialog | None = None
        self._interface_label, self._interface_state = QLabel(), ElidedLabel()
        self.interface_button = push_button("interface_button", on_enter=False)
        for code, name in _LANGUAGES:
            self.language_box.addItem(name, code)
        for code in ("light", "dark", "system"):
            self.theme_box.addItem("", code)
        for field in (self.jog_step_edit, self.jog_floor_spin, self.live_port_spin):
            field.setFixedWidth(_STEP_WIDTH_PX)
        self.jog_step_edit.setAlignment(Qt.AlignmentFlag.AlignRight)
        grid = empty_grid(gaps=(18, 12))
        grid.setColumnStretch(1, 1)
        _add_row(grid, self._language_label, self.language_box)
        _add_row(grid, self._theme_label, self.theme_box)
        _add_row(grid, self._jog_label, self.jog_step_edit, self._jog_hint)
        row = in_row(self.jog_floor_box, self.jog_floor_spin, STRETCH, spacing=8)
        grid.addLayout(row, grid.rowCount(), 1)
        _add_row(grid, self._urdf_label, self._urdf_name)
        row = in_row(self.browse_button, self.built_in_button, STRETCH, spacing=8)
        grid.addLayout(row, grid.rowCount(), 1)
        for label, button, state in (
            (self._gamepad_label, self.gamepad_button, self._gamepad_state),
            (self._interface_label, self.interface_button, self._interface_state),
        ):
            place = grid.rowCount()
            grid.addWidget(label, place, 0)
            grid.addLayout(in_row(button, (state, 1), spacing=12), place, 1)
        for name, box in self._boxes.items():
            beside = (self.live_port_spin,) if name == "live" else ()
            grid.addLayout(in_row(box, *beside, STRETCH, spacing=8), grid.rowCount(), 1)
        self._message = MessageLine()
        fill(self.body, grid, STRETCH, self._message)
        told = (self.diagnosis_button, self.about_arm_button, self.about_button, self.faults_button)
        fill(self.footer, *told, STRETCH, CloseButton(self))

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Settings"))
        self._language_label.setText(setting_label("language").text())
        font = self.tr("Shown at once; its own font for quotation marks follows at the next start.")
        self.language_box.setToolTip(font)
        self._theme_label.setText(setting_label("theme").text())
        for index, text in enumerate((self.tr("Light"), self.tr("Dark"), self.tr("As the system"))):
            self.theme_box.setItemText(index, text)
        self._jog_label.setText(setting_label("jog_step_deg").text())
        self._jog_hint.setText(
            self.tr("{minimum}° to {maximum}°: how far − and + move a joint").format(
                minimum=f"{JOG_STEP_DEG.least:g}", maximum=f"{JOG_STEP_DEG.most:g}"
            )
        )
        self._urdf_label.setText(setting_label("urdf_path").text())
        for name, box in {**self._boxes, "jog_floor_mm": self.jog_floor_box}.items():
            caption(box, setting_label(name).text(), tip=setting_tip(name).text())
        describe(self.jog_floor_spin, self.jog_floor_box.text(), self.jog_floor_box.toolTip())
        describe(self.live_port_spin, setting_label("live_port").text())
        self.browse_button.setText(self.tr("Browse…"))
        self.built_in_button.setText(self.tr("Use the built-in one"))
        self._gamepad_label.setText(self.tr("Gamepad, SpaceMouse"))
        caption(self.gamepad_button, self.tr("Gamepad…"))
        self._interface_label.setText(setting_label("interface").text())
        caption(self.interface_button, self.tr("Local interface…"))
        self.diagnosis_button.setText(self.tr("Diagnosis…"))
        self.about_arm_button.setText(self.tr("About this arm…"))
        self.about_button.setText(self.tr("About armui…"))
        self.faults_button.setText(self.tr("Simulated faults…"))
        self._refresh()

    def showEvent(self, event: QShowEvent) -> None:
        """Show the present settings, which other parts may have changed."""
        super().showEvent(event)
        if not event.spontaneous():
            self._mark_jog_step(wrong=False)
            self._refresh()

    def hideEvent(self, event: QHideEvent) -> None:
        """Clear the message for the next opening."""
        super().hideEvent(event)
        if not event.spontaneous():
            self._problem = None

    def _on_operating_state(self, now: OperatingState) -> None:
        if self._connected != (now.model, now.device):
            self._connected = (now.model, now.device)
            self._refresh()

    def _refresh(self) -> None:
        now = self._store.settings
        self.language_box.setCurrentIndex(self.language_box.findData(now.language))
        self.theme_box.setCurrentIndex(self.theme_box.findData(now.theme))
        for name, box in self._boxes.items():
            box.setChecked(getattr(now, name))
        self.jog_floor_box.setChecked(now.jog_floor_mm is not None)
        self.jog_floor_spin.setEnabled(now.jog_floor_mm is not None)
        if now.jog_floor_mm is not None:
            with QSignalBlocker(self.jog_floor_spin):
                self.jog_floor_spin.setValue(now.jog_floor_mm)
        with QSignalBlocker(self.live_port_spin):
            self.live_port_spin.setValue(now.live_port)
        if not self._jog_step_wrong:
            self.jog_step_edit.setText(f"{now.jog_step_deg:g}°")
        model = model_data(self._controller.operating_state.model).name
        built_in_name = self.tr("Built-in model of the {model}").format(model=model)
        self._urdf_name.show_text(now.urdf_path or built_in_name)
        on, off = self.tr("On: jogs the arm"), self.tr("Off")
        self._gamepad_state.show_text(on if now.gamepad else off)
        on = self.tr("On: for your scripts")
        self._interface_state.show_text(on if now.interface else off)
        built_in = now.urdf_path is None
        self.built_in_button.setEnabled(not built_in)
        tip = self.tr("The built-in robot description is in use.") if built_in else ""
        self.built_in_button.setToolTip(tip)
        enable_or_explain(self.faults_button, with_simulated(self._controller.operating_state))
        self._show_problem(self._problem)

    def _show_problem(self, problem: Refusal | None) -> None:
        self._problem = problem
        text = "" if problem is None else words.refusal(problem)
        self._message.show_message(text, Level.WARNING)

    # What the operator does -------------------------------------------------------------------

    def _on_language(self) -> None:
        self._show_problem(self._store.change(language=self.language_box.currentData()))

    def _on_theme(self) -> None:
        self._show_problem(self._store.change(theme=self.theme_box.currentData()))

    def _on_box(self, name: str) -> None:
        chosen: dict[str, Any] = {name: self._boxes[name].isChecked()}
        self._show_problem(self._store.change(**chosen))

    def _on_jog_floor(self, *_: object) -> None:
        on = self.jog_floor_box.isChecked()
        self.jog_floor_spin.setEnabled(on)
        height = self.jog_floor_spin.value() if on else None
        refusal = self._store.change(jog_floor_mm=height)
        if refusal is None and why_not_change(self._controller.operating_state) is not None:
            refusal = CELL_WHILE_MOVING()  # it is stored, and takes effect at rest
        self._show_problem(refusal)

    def _on_live_port(self, port: int) -> None:
        self._show_problem(self._store.change(live_port=port))

    def _on_gamepad(self) -> None:
        if self._gamepad_dialog is None:
            self._gamepad_dialog = GamepadDialog(self._store, self._controller, self.parentWidget())
            self._gamepad_dialog.finished.connect(self._refresh)
        self._gamepad_dialog.open()

    def _on_jog_step(self) -> None:
        text = self.jog_step_edit.text()
        step_deg = fmt.parse_number(text)
        if step_deg is None:
            self._refuse_jog_step(JOG_STEP_NOT_A_NUMBER(value=text.strip()))
            return
        problem = self._store.change(jog_step_deg=step_deg)
        if self._store.settings.jog_step_deg != step_deg:
            self._refuse_jog_step(problem)
            return
        self._mark_jog_step(wrong=False)
        self.jog_step_edit.setText(f"{step_deg:g}°")
        self._show_problem(problem)

    def _refuse_jog_step(self, problem: Refusal | None) -> None:
        """Show the reason, and leave the typed figure in its field to be corrected."""
        self._mark_jog_step(wrong=True)
        self._show_problem(problem)

    def _mark_jog_step(self, *, wrong: bool) -> None:
        self._jog_step_wrong = wrong
        self.jog_step_edit.setProperty("attention", wrong)
        repolish(self.jog_step_edit)

    def _on_browse(self) -> None:
        now = self._store.settings.urdf_path
        choose_file(
            self,
            self._controller,
            title=self.tr("Choose a robot description"),
            name_filter=self.tr("Robot description") + " (*.urdf *.xacro)",
            start=Path(now) if now else None,
            on_chosen=self._on_urdf_chosen,
        )

    def _on_urdf_chosen(self, path: Path) -> None:
        if not path.is_file():
            self._show_problem(URDF_MISSING(path=str(path)))
            return
        self._problem = None
        problem = self._store.change(urdf_path=str(path))
        # during `change` the part that shows the robot may have reported a fault of the file
        self._problem = problem or self._problem
        self._refresh()

    def _on_built_in(self) -> None:
        self._problem = self._store.change(urdf_path=None)
        self._refresh()


def _add_row(grid: QGridLayout, label: QLabel, field: QWidget, hint: QLabel | None = None) -> None:
    label.setBuddy(field)
    row = grid.rowCount()
    grid.addWidget(label, row, 0)
    if hint is None:
        grid.addWidget(field, row, 1)
        return
    line = in_row(field, (hint, 1), spacing=12)
    grid.addLayout(line, row, 1)
