"""运动控制 and 末端控制 in a small box: jogging beside the points that are being edited."""

from __future__ import annotations

import enum
from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QButtonGroup, QCheckBox, QFrame, QLabel, QSizePolicy, QWidget

from armui.arm.refusal import Refusal
from armui.cell.user_frames import UserFrame
from armui.control.events import Event
from armui.control.motion.cartesian import FRAME_NOT_IN_FORCE
from armui.control.motion.jog_path import JointJog, MotionFrame, ToolJog
from armui.control.motion.jogging import JOG_ENDED
from armui.control.operations.started import refusal_of
from armui.kinematics.axes import AXES, LINEAR_AXES, JogFrame
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.freshness import is_stale
from armui.ui.panels.jogging.jog_panel import JogRow, StepBox, held_speed
from armui.ui.theme import scaled_font
from armui.ui.widgets.buttons import (
    caption,
    choice_button,
    describe,
    enable_or_explain,
    named,
    push_button,
)
from armui.ui.widgets.flow import Flow, in_flow
from armui.ui.widgets.hold_guard import HOLD_UNATTENDED, UNATTENDED_S
from armui.ui.widgets.layouts import in_column, in_row
from armui.ui.widgets.text_label import ValueLabel, text_label
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from PySide6.QtGui import QHideEvent, QShowEvent

    from armui.arm.state import ArmState
    from armui.control.arm_controller import ArmController
    from armui.control.operating_state import OperatingState


_ACROSS: Final = 3
_GAP_PX: Final = 8
_JOINTS: Final = tuple(f"J{joint}" for joint in range(1, 7))
_WIDEST: Final = "-0000.000 mm"
_NAME_PX: Final = 24


class JogCell(JogRow):
    """A cell for a joint or an axis in turn; its signals carry its index.

    Args:
        place: 0–5.
    """

    def __init__(self, place: int) -> None:
        super().__init__("box", place + 1, place)
        self._unit = "°"
        self._name = QLabel()
        self._name.setFont(scaled_font(self._name, 1.0, bold=True))
        self._name.setFixedWidth(_NAME_PX)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.measured = named(
            f"box_measured_{place + 1}",
            ValueLabel(_WIDEST, alignment=Qt.AlignmentFlag.AlignHCenter),
        )
        in_row(
            *(self._name, self.minus, (self.measured, 1), self.plus), on=self, spacing=4, margins=0
        )
        self.stand_for("", "°")

    def stand_for(self, name: str, unit: str) -> None:
        """Set the joint or axis of the cell.

        Args:
            name: ``J1`` or ``RX``.
            unit: ``°`` or ``mm``.
        """
        self._name.setText(name)
        self._unit = unit
        self.measured.show_text(fmt.NOTHING)
        self.retranslate_ui()

    def show_measured(self, value: float | None, *, stale: bool) -> None:
        """Show the measured value; muted if it is stale."""
        self.measured.show_text(fmt.with_unit(value, self._unit), stale=stale)

    def retranslate_ui(self) -> None:
        """Set the names in the operator's language."""
        name = self._name.text()
        self.minus.setAccessibleName(self.tr("{name} minus").format(name=name))
        self.plus.setAccessibleName(self.tr("{name} plus").format(name=name))
        describe(self.measured, self.tr("Measured {name}").format(name=name))


class GripperLine(Translated, QWidget):
    """The measured opening of the gripper, and buttons for the ends of its stroke.

    Args:
        controller: Moves the gripper.

    Signals:
        refused: A :class:`Refusal`, or ``None`` when the motion was sent.

    Attributes:
        inserted: The choice whether inserted points include the measured opening.
    """

    refused = Signal(object)

    def __init__(self, controller: ArmController) -> None:
        super().__init__()
        self._controller = controller
        self._name = QLabel()
        self._name.setFont(scaled_font(self._name, 1.0, bold=True))
        self._measured = named("box_gripper_measured", ValueLabel(_WIDEST))
        self._close = push_button("box_gripper_close", on_enter=False)
        self._open = push_button("box_gripper_open", on_enter=False)
        self.inserted = named("box_gripper_inserted", QCheckBox())
        parts = (self._name, self._measured, self._close, self._open, self.inserted)
        in_flow(*parts, on=self)
        self._close.clicked.connect(lambda _checked=False: self._move(opened=False))
        self._open.clicked.connect(lambda _checked=False: self._move(opened=True))
        self.retranslate_ui()

    def _move(self, *, opened: bool) -> None:
        self.refused.emit(refusal_of(self._controller.gripper.move_to_end(opened=opened)))

    def show_gripper(self) -> None:
        """Show the gripper's state, and whether it may be moved."""
        state, gripper = self._controller.state, self._controller.gripper
        heard = state.gripper
        stale = is_stale(heard, state, self._controller.operating_state)
        text = fmt.NOTHING
        if heard is not None:
            text = fmt.with_unit(heard.value.travel, heard.value.unit)
        self._measured.show_text(text, stale=stale)
        for button, opened, use in (
            (self._close, False, self.tr("Closes the gripper to 0.")),
            (self._open, True, self.tr("Opens the gripper to its stroke limit.")),
        ):
            why_not = words.why_not(gripper.why_no_end(opened=opened))
            enable_or_explain(button, why_not, use)

    def learn(self) -> None:
        """Read the stroke limit, if it is not known."""
        self._controller.gripper.learn_stroke()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._name.setText(self.tr("Gripper"))
        describe(self._measured, self.tr("Measured: gripper"), self.tr("Measured by the gripper"))
        caption(self._close, self.tr("Close fully"), whose=self._name.text())
        caption(self._open, self.tr("Open fully"), whose=self._name.text())
        self.inserted.setText(self.tr("Insert with opening"))
        self.inserted.setToolTip(
            self.tr(
                "An inserted point moves the gripper to the opening measured now, with 1 N·m "
                "(generation 1: 1 rad/s). To grip, enter less than the width of the workpiece."
            )
        )
        self.show_gripper()


class JogKind(enum.Enum):
    """The objects that − and + can move."""

    JOINTS = "joints"
    BASE = "base"
    TOOL = "tool"
    USER = "user"
    GRIPPER = "gripper"
    """The gripper's own buttons replace − and +: there is no room for both."""


_FRAMES: Final = {JogKind.BASE: JogFrame.BASE, JogKind.TOOL: JogFrame.TOOL}


class JogBox(Translated, QFrame):
    """Jogs like the panels, by the same parts of the controller; it holds no targets.

    Args:
        controller: Sends the motions.
        more: Further widgets needed while jogging, at the end of its first line.

    Signals:
        refused: A :class:`Refusal`, or ``None`` when something was done.

    Attributes:
        gripper: Moves the gripper.
    """

    refused = Signal(object)

    def __init__(self, controller: ArmController, *more: QWidget) -> None:
        super().__init__()
        self.setObjectName("jog_box")
        self.setProperty("card", True)
        self._controller = controller
        self._kinds = QButtonGroup(self)
        self._choices = {kind: choice_button(f"box_{kind.value}") for kind in JogKind}
        for kind, button in self._choices.items():
            self._kinds.addButton(button, tuple(JogKind).index(kind))
        self._choices[JogKind.JOINTS].setChecked(True)
        self._degrees = named("box_step_deg", StepBox(fmt.short_angle))
        self._lengths = named("box_step_mm", StepBox(lambda step: f"{step:g} mm / {step:g}°"))
        self._speed = text_label("box_speed", rank="muted")
        self._frame = text_label("box_frame", rank="muted")
        full_px = self._speed.fontMetrics().horizontalAdvance("100 %")
        self._speed.setMinimumWidth(full_px)  # room for three digits, so that no button moves
        self._cells = [JogCell(place) for place in range(len(AXES))]
        self.gripper = GripperLine(controller)
        self._lay_out(more)
        self._held = False
        self._connect()
        self._show_kind()
        self.retranslate_ui()

    def _lay_out(self, more: Sequence[QWidget]) -> None:
        head = Flow()
        for widget in (
            *self._choices.values(),
            self._degrees,
            self._lengths,
            self._speed,
            self._frame,
        ):
            head.addWidget(widget)
        for widget in more:
            head.push(widget)
        cells = Flow(spacing_px=_GAP_PX, most=_ACROSS)
        for cell in self._cells:
            cells.addWidget(cell)
        in_column(head, cells, self.gripper, on=self, spacing=6, margins=8)

    def _connect(self) -> None:
        self._kinds.idClicked.connect(self._on_kind)
        for cell in self._cells:
            cell.stepped.connect(self._on_stepped)
            cell.repeated.connect(self._on_repeated)
            cell.held.connect(self._on_held)
            cell.hold_ended.connect(self._on_hold_ended)
            cell.unattended.connect(self._on_unattended)
        self.gripper.refused.connect(self.refused)
        for box in (self._degrees, self._lengths):
            box.chosen.connect(self._on_step)
        self._controller.state_changed.connect(self._on_state)
        self._controller.operating_state_changed.connect(self._on_operating_state)
        self._controller.noticed.connect(self._on_noticed)
        self._controller.cell_changed.connect(self._on_cell_changed)

    @property
    def kind(self) -> JogKind:
        """The object that − and + move now."""
        return tuple(JogKind)[self._kinds.checkedId()]

    @property
    def _steps(self) -> StepBox:
        return self._degrees if self.kind is JogKind.JOINTS else self._lengths

    def _on_kind(self, _number: int) -> None:
        self._on_hold_ended()
        self._show_kind()

    def _on_cell_changed(self, _cell: object) -> None:
        self._name_frame()
        self._show_measured()

    def _name_frame(self) -> None:
        """Show the name of the user frame in force, in which the cells show their figures."""
        frame = self._controller.cartesian.frame
        none = words.refusal(FRAME_NOT_IN_FORCE()) if frame is None else ""
        enable_or_explain(self._choices[JogKind.USER], none, "" if frame is None else frame.name)
        # include a cell that is not confirmed yet, so that no button moves when it is confirmed
        cell = self._controller.cell.cell
        has_frames = cell is not None and bool(cell.all_frames)
        self._choices[JogKind.USER].setVisible(has_frames or self.kind is JogKind.USER)
        text, in_base = "", self.tr("in the base")
        if frame is not None and self.kind not in {JogKind.JOINTS, JogKind.GRIPPER}:
            text = self.tr("figures in “{name}”").format(name=fmt.short(frame.name))
        elif self.kind is JogKind.TOOL:
            text = in_base
        self._frame.setText(text)
        # keep the width when the text is shorter, so that no button moves
        widest_px = max(map(self._frame.fontMetrics().horizontalAdvance, (text, in_base)))
        self._frame.setMinimumWidth(max(self._frame.minimumWidth(), widest_px))

    @property
    def _motion_frame(self) -> MotionFrame:
        # if no frame is in force, one without a name is given, which the controller refuses
        if self.kind is JogKind.USER:
            return self._controller.cartesian.frame or UserFrame("")
        return _FRAMES[self.kind]

    def _show_kind(self) -> None:
        self._name_frame()
        joints, gripper = self.kind is JogKind.JOINTS, self.kind is JogKind.GRIPPER
        self._degrees.setVisible(joints)
        self._lengths.setVisible(not joints and not gripper)
        self.gripper.setVisible(gripper)
        for cell in self._cells:
            cell.setVisible(not gripper)
        for place, cell in enumerate(self._cells):
            if joints:
                cell.stand_for(_JOINTS[place], "°")
            else:
                cell.stand_for(AXES[place], "mm" if place < LINEAR_AXES else "°")
        self._on_step()
        self._show_measured()

    def _on_step(self) -> None:
        for cell in self._cells:
            cell.set_continuous(self._steps.continuous)
        self._show_speed()

    def _show_speed(self) -> None:
        """Show the speed of a held jog; a step has the percentage of the arm's own speed."""
        of_joints = self.kind is JogKind.JOINTS
        percent = f"{round(self._controller.operating_state.speed_percent)} %"
        held = self._steps.continuous and self.kind is not JogKind.GRIPPER
        speed = held_speed(self._controller, of_joints=of_joints) if held else percent
        self._speed.setText(speed)

    # Jogging ----------------------------------------------------------------------------------

    def _on_stepped(self, place: int, direction: int) -> None:
        amount, kind = direction * self._steps.step, self.kind
        if kind is JogKind.JOINTS:
            self.refused.emit(refusal_of(self._controller.motion.jog(place + 1, amount)))
        else:
            answer = self._controller.cartesian.step(place, amount, self._motion_frame)
            self.refused.emit(refusal_of(answer))

    def _on_repeated(self, place: int, direction: int) -> None:
        """Jog by another step unless the arm lags behind: letting go must end the motion."""
        if self.kind is JogKind.JOINTS:
            waits = self._controller.motion.jog_lagging(place + 1, self._steps.step)
        else:
            waits = self._controller.operating_state.moving
        if not waits:
            self._on_stepped(place, direction)

    def _on_held(self, place: int, direction: int) -> None:
        kind = self.kind
        self._held = True  # set first: if the start fails, letting go still ends the jog
        if kind is JogKind.JOINTS:
            answer = self._controller.jogging.start(JointJog(place + 1, direction))
        else:
            answer = self._controller.jogging.start(ToolJog(place, direction, self._motion_frame))
        refusal = refusal_of(answer)
        self._held = refusal is None
        self.refused.emit(refusal)

    def _on_hold_ended(self) -> None:
        if self._held:
            self._controller.jogging.stop()
            self._held = False

    def _on_unattended(self) -> None:
        self.refused.emit(HOLD_UNATTENDED(seconds=UNATTENDED_S))

    def _on_noticed(self, event: Event) -> None:
        reason = event.params.get("reason")
        if event.notice == JOG_ENDED and isinstance(reason, Refusal) and self.isVisible():
            self.refused.emit(reason)

    # What the arm says ------------------------------------------------------------------------

    def _on_state(self, _state: ArmState) -> None:
        if self.isVisible():
            self._show_measured()

    def _on_operating_state(self, _operating_state: OperatingState) -> None:
        if self.isVisible():
            self._show_all()

    def _show_all(self) -> None:
        operating_state = self._controller.operating_state
        self._show_speed()
        why_not = words.why_not(operating_state.cannot_move)
        for cell in self._cells:
            cell.allow_jog(why_not)
        self.gripper.learn()
        self._show_measured()

    def _show_measured(self) -> None:
        self.gripper.show_gripper()
        state, operating_state = self._controller.state, self._controller.operating_state
        stale = partial(is_stale, state=state, operating_state=operating_state)
        if self.kind is JogKind.JOINTS:
            for cell, heard in zip(self._cells, state.joints_deg, strict=True):
                cell.show_measured(None if heard is None else heard.value, stale=stale(heard))
            return
        pose = self._controller.cartesian.tool_pose(state)
        if pose is not None:
            pose = self._controller.cartesian.in_frame(pose)
        old = any(stale(heard) for heard in state.pose)
        for cell, value in zip(self._cells, pose or (None,) * len(AXES), strict=True):
            cell.show_measured(value, stale=old)

    # Appearance -------------------------------------------------------------------------------

    def showEvent(self, event: QShowEvent) -> None:
        """Update everything that is shown."""
        super().showEvent(event)
        self._show_all()

    def hideEvent(self, event: QHideEvent) -> None:
        """End jogging, because the buttons are hidden now."""
        self._on_hold_ended()
        super().hideEvent(event)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        texts = {
            JogKind.JOINTS: self.tr("Joints"),
            JogKind.BASE: self.tr("Base"),
            JogKind.TOOL: self.tr("Tool"),
            JogKind.USER: self.tr("Frame"),
            JogKind.GRIPPER: self.tr("Gripper"),
        }
        for kind, text in texts.items():
            caption(self._choices[kind], text)
        self._frame.setMinimumWidth(0)
        self._name_frame()
        self._speed.setAccessibleName(self.tr("Speed"))
        self._speed.setToolTip(
            self.tr(
                "The speed in the top bar: it counts for every jog and step, also while one goes "
                "on."
            )
        )
        for box in (self._degrees, self._lengths):
            box.setAccessibleName(self.tr("Step of − and +"))
            box.setToolTip(self.tr("How far one press of − or + moves"))
