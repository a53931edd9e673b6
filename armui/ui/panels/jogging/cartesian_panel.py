"""末端控制: sends the tool to a pose, on a line or an arc, steps and jogs it (0x152–0x154)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Final

from PySide6.QtWidgets import (
    QAbstractButton,
    QComboBox,
    QFrame,
    QLabel,
    QWidget,
)

from armui.arm.refusal import Reason, Refusal
from armui.arm.state import ArmState
from armui.cell.user_frames import UserFrame
from armui.control.arm_controller import ArmController
from armui.control.cell.cell_control import why_not_change
from armui.control.motion.cartesian import FRAME_NOT_IN_FORCE, POSE_UNKNOWN, Cartesian
from armui.control.motion.jog_path import MotionFrame, ToolJog
from armui.control.operating_state import OperatingState
from armui.control.operations.operation import operation_of
from armui.control.operations.started import refusal_of
from armui.kinematics.axes import AXES, LINEAR_AXES, JogFrame
from armui.protocol.codes import TARGET_REFUSALS, MoveMode
from armui.settings import SettingsStore
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act, HasActs
from armui.ui.actions.command import Command, Target, with_pose
from armui.ui.freshness import is_stale
from armui.ui.panels.jogging.jog_panel import JogPanel, TargetRow
from armui.ui.panels.jogging.pose_extras import ArcBox, PoseExtras, ToolBox
from armui.ui.theme import scaled_font
from armui.ui.widgets.buttons import caption, choice_group, describe, enable_or_explain, named
from armui.ui.widgets.curve_menu import set_quantities
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.layouts import STRETCH, in_column, in_row
from armui.ui.widgets.text_label import ValueLabel, text_label
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import Text

TARGET_REFUSED = Reason(
    "target_refused", "The arm itself refuses its last target: {status}. Send another one."
)
POSE_NOT_A_NUMBER = Reason(
    "pose_not_a_number", "{axis}: “{value}” is not a number. Enter mm or degrees, for example 12.5."
)


_KEYS: Final = (
    ("X", "↑", "↓"),
    ("Y", "←", "→"),
    ("Z", "PgUp", "PgDn"),
    ("RX", "Q", "A"),
    ("RY", "W", "S"),
    ("RZ", "E", "D"),
)
_WIDEST: Final = "-0000.000 mm"
_NAME_PX: Final = 34
_NARROW_PX: Final = 60
_TARGET: Final = Text("Action", "Target of")


class PoseRow(TargetRow):
    """The controls of one axis; its signals carry the axis' index.

    Args:
        place: 0–5 for X, Y, Z, RX, RY, RZ.
        name: One of them.
        unit: ``mm`` or ``°``.
    """

    def __init__(self, place: int, name: str, unit: str) -> None:
        field = named(f"pose_field_{name}", FigureField(fmt.DECIMALS, unit))
        field.setTextMargins(0, 0, 28 if unit == "mm" else 5, 0)
        measured = named(f"pose_measured_{name}", ValueLabel(_WIDEST))
        super().__init__("pose", name, place, field, measured)
        self.name = name
        self._unit = unit
        self._label = QLabel(name)
        self._label.setFont(scaled_font(self._label, 1.15, bold=True))
        self._label.setFixedWidth(_NAME_PX)
        parts = (self._label, self.minus, (self.field, 1), self.plus, self.measured)
        in_row(*parts, on=self, spacing=8, margins=0)
        self.retranslate_ui()

    def name_curves(self, *, of_tool: bool, in_base: bool) -> None:
        """Set the curves of the row; targets on the bus are those of the flange.

        Args:
            of_tool: True if the figures are those of the tool centre point, not of the flange.
            in_base: False if they are in a user frame: curves are always in the base.
        """
        axis = self.name.lower()
        of_flange = (f"{source}.pose_{axis}" for source in ("arm", "own", "other"))
        curves = (f"arm.tool_{axis}",) if of_tool else of_flange
        set_quantities(self, *(curves if in_base else ()))

    def show_measured(self, value: float | None, *, stale: bool) -> None:
        """Show the measured value."""
        self.measured.show_text(fmt.with_unit(value, self._unit), stale=stale)

    def _tips(self) -> tuple[str, str]:
        """Return the tooltips of − and +."""
        if self.minus.continuous:
            tip = self.tr("Moves along {axis} while it is held; let go to stop.")
        else:
            tip = self.tr("Moves along {axis} by {step} at once.")
        step = f"{self.field.step:g} {self._unit}"
        minus, plus = (tip.format(axis=self.name, step=f"{sign}{step}") for sign in "−+")
        return minus, plus

    def retranslate_ui(self) -> None:
        """Set names and tooltips in the operator's language."""
        self.minus.setAccessibleName(self.tr("{axis} minus").format(axis=self.name))
        self.plus.setAccessibleName(self.tr("{axis} plus").format(axis=self.name))
        target = self.tr("Target {axis}").format(axis=self.name)
        describe(self.field, target, self.tr("Not sent before you press MOVE P or MOVE L."))
        self.measured.setToolTip(self.tr("Measured by the arm"))


class FrameChoice(Translated, QWidget):
    """A button for each frame whose axes − and + follow, one of them chosen.

    Args:
        cartesian: Knows the user frame in force.
    """

    def __init__(self, cartesian: Cartesian) -> None:
        super().__init__()
        self._cartesian = cartesian
        self._label = QLabel()
        frames = (*(each.value for each in JogFrame), "user")
        self._buttons = choice_group(self, (f"frame_{frame}" for frame in frames))
        in_row(self._label, *((each, 1) for each in self.buttons), on=self, spacing=6, margins=0)
        self.retranslate_ui()

    @property
    def buttons(self) -> list[QAbstractButton]:
        """The buttons, in the order of the frames."""
        return self._buttons.buttons()

    @property
    def frame(self) -> MotionFrame:
        """The chosen frame; one without a name, which is refused, if none is in force."""
        frames: tuple[MotionFrame, ...] = (*JogFrame, self._cartesian.frame or UserFrame(""))
        return frames[self._buttons.checkedId()]

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language, and name the user frame in force."""
        self._label.setText(self.tr("− and + along"))
        for number, text in enumerate((self.tr("Base frame"), self.tr("Tool frame"))):
            caption(self._buttons.button(number), text)
        button, frame, name = self.buttons[-1], self._cartesian.frame, self.tr("User frame")
        none = words.refusal(FRAME_NOT_IN_FORCE()) if frame is None else ""
        caption(button, name if frame is None else fmt.short(frame.name), whose=name)
        enable_or_explain(button, none, "" if frame is None else frame.name)


class CartesianPanel(JogPanel):
    """Targets and measured pose of the tool centre point, or of the flange without a tool.

    Args:
        controller: Sends the motions.
        preferences: The settings, which keep the tool.
    """

    _of_joints = False

    commands = (
        Command("cartesian.base", Text("FrameChoice", "Base frame")),
        Command("cartesian.tool", Text("FrameChoice", "Tool frame")),
        Command("cartesian.user", Text("FrameChoice", "User frame")),
        Command("cartesian.shown_frame", Text("CartesianPanel", "Frame of the figures")),
        Command("cartesian.arc", Text("PoseExtras", "Arc by three poses")),
        Command("cartesian.tool_centre", Text("PoseExtras", "Tool centre point")),
        *ArcBox.commands,
        Command("cartesian.keys", Text("JogPanel", "Keyboard jogging")),
        Command("cartesian.step", operation=operation_of(Cartesian.step), presses=False),
        *(Command(f"cartesian.target_{axis}", replace(_TARGET, suffix=axis)) for axis in AXES),
    )

    load = Act(
        "Take current",
        named="load_pose_button",
        tip="Fills the fields with the measured pose; nothing moves.",
        key="cartesian.load",
        needs=with_pose,
    )
    move_p = Act(
        "MOVE P",
        named="move_p_button",
        does=Cartesian.move,
        tip="Moves to the pose, each joint on its own path.",
        key="cartesian.move_p",
        title=Text("Action", "MOVE P: to the pose"),
    )
    move_l = Act(
        "MOVE L",
        named="move_l_button",
        does=Cartesian.move,
        tip="Moves to the pose on a straight line.",
        key="cartesian.move_l",
        title=Text("Action", "MOVE L: on a straight line to the pose"),
    )

    def __init__(self, controller: ArmController, preferences: SettingsStore) -> None:
        super().__init__(
            controller,
            "tool",
            message_name="pose_message",
            keys=_KEYS,
            numbers=range(len(_KEYS)),
            write_step=lambda step: f"{step:g} mm / {step:g}°",
        )
        self._preferences = preferences
        self._sent = False
        self._heard = False
        self._unreachable: tuple[float, ...] | None = None
        self._shown_of = controller.cartesian.tool, controller.cartesian.frame
        self._frame = FrameChoice(controller.cartesian)
        self._shown_frame = named("shown_frame_box", QComboBox())
        self._shown_frame.setMinimumWidth(_NARROW_PX)
        self._point = text_label("point_label", rank="muted")
        self._rows: Sequence[PoseRow] = [
            PoseRow(place, name, "mm" if place < LINEAR_AXES else "°")
            for place, name in enumerate(AXES)
        ]
        self._tool = ToolBox()
        self._arc = ArcBox(controller)
        self._lay_out()
        self._connect()
        controller.cell_changed.connect(self._on_cell_changed)
        self._use_tool()
        self._list_frames()
        self._on_step_chosen()
        self.retranslate_ui()

    def _lay_out(self) -> None:
        card = QFrame()
        self._extras = PoseExtras(self._arc, self._tool)
        self._keys.toggled.connect(self._extras.setHidden)  # with both the panel would be too high
        head = in_row(self._point, (self._shown_frame, 1), spacing=8)
        rows = in_column(head, *self._rows, spacing=4)
        parts = (rows, self._extras, STRETCH)
        in_column(*parts, on=card, spacing=10, margins=(16, 8, 16, 10))
        self._finish(card, (self.load,), (self.move_p, self.move_l), above=(self._frame,))

    def _connect(self) -> None:
        self._follow_rows()
        self._tool.changed.connect(self._on_tool_changed)
        self._arc.capture_wanted.connect(self._on_capture)
        self._arc.wanted.connect(self._drive)
        self._shown_frame.activated.connect(self._on_frame_chosen)

    def act_parts(self) -> Iterable[HasActs]:
        """Return the arc, whose acts the panel offers."""
        return (self._arc,)

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        base, tool, user = self._frame.buttons
        arc, tool_centre = self._extras.buttons
        return {
            **super().command_targets(),
            "cartesian.base": base,
            "cartesian.tool": tool,
            "cartesian.user": user,
            "cartesian.shown_frame": self._shown_frame,
            "cartesian.arc": arc,
            "cartesian.tool_centre": tool_centre,
            "cartesian.keys": self._keys,
            "cartesian.step": self._rows[0].plus,
            **{f"cartesian.target_{row.name}": row.field for row in self._rows},
        }

    # -- the tool -----------------------------------------------------------------------------

    def _on_tool_changed(self, tool: tuple[float, ...]) -> None:
        if tool == self._controller.cartesian.tool:
            self._accepted(None)
            self._tool.mark(wrong=False)
            return
        refusal = why_not_change(self._operating_state) or self._preferences.change(tool=tool)
        self._tool.mark(wrong=refusal is not None)
        self._accepted(refusal)
        if self._preferences.settings.tool == tool:
            self._controller.cell.use_own_tool(tool)

    def _on_cell_changed(self, _cell: object) -> None:
        self._tool.name_tool(self._controller.cell)
        self._list_frames()
        cartesian = self._controller.cartesian
        if (cartesian.tool, cartesian.frame) != self._shown_of:
            self._use_tool()

    def _use_tool(self) -> None:
        """Show another tool or frame, and drop entries that were made for the one before."""
        cartesian = self._controller.cartesian
        other_tool = cartesian.tool != self._shown_of[0]
        self._shown_of = cartesian.tool, cartesian.frame
        self._tool.name_tool(self._controller.cell)
        self._tool.show_tool(cartesian.tool)
        for row in self._rows:
            row.name_curves(of_tool=any(cartesian.tool), in_base=cartesian.frame is None)
        if other_tool:
            self._arc.clear()
        self._arc.retranslate_ui()
        self._frame.retranslate_ui()
        self._sent = False
        self._fill(None)
        self._release()
        self._follow_arm()
        self._name_point()
        self._show_measured()

    def _list_frames(self) -> None:
        """List the frames that the figures can be in; the one in force is chosen."""
        cell = self._controller.cell.in_force
        box = self._shown_frame
        box.clear()
        box.addItem(self.tr("in the base frame"), "")
        for frame in () if cell is None else cell.all_frames:
            box.addItem(self.tr("in “{name}”").format(name=frame.name), frame.name)
        box.setCurrentIndex(max(0, box.findData("" if cell is None else cell.frame)))

    def _on_frame_chosen(self, place: int) -> None:
        cell = self._controller.cell.cell
        if cell is not None:
            chosen = replace(cell, frame=self._shown_frame.itemData(place))
            self._accepted(refusal_of(self._controller.cell.change(chosen)))
        self._list_frames()

    def _pose(self) -> tuple[float, ...] | None:
        """Return the measured pose of the tool in the base, or ``None``."""
        return self._controller.cartesian.tool_pose(self._controller.state)

    def _shown_pose(self) -> tuple[float, ...] | None:
        """Return the measured pose of the tool in the frame of the fields, or ``None``."""
        pose = self._pose()
        return None if pose is None else self._controller.cartesian.in_frame(pose)

    def targets(self) -> tuple[float, ...] | None:
        """Return the target in the fields as a pose of the base; ``None`` if one is invalid."""
        shown = super().targets()
        return None if shown is None else self._controller.cartesian.in_base(shown)

    def take_targets(self, values: Sequence[float], given: Sequence[bool] | None = None) -> None:
        """Set the fields to a pose of the base; see :meth:`JogPanel.take_targets`."""
        super().take_targets(self._controller.cartesian.in_frame(values), given)

    # -- jogging ------------------------------------------------------------------------------

    def _release(self) -> None:
        """Let all fields follow the arm again."""
        for row in self._rows:
            row.own = False

    def _on_stepped(self, place: int, direction: int) -> None:
        amount = direction * self._step_box.step
        if self._accepted(self._controller.cartesian.step(place, amount, self._frame.frame)):
            self._release()

    def _on_repeated(self, place: int, direction: int) -> None:
        """Jog by another step only when the arm is at rest: MOVE L plans anew at each target."""
        if not self._operating_state.moving:
            self._on_stepped(place, direction)

    def _on_held(self, place: int, direction: int) -> None:
        jog = ToolJog(place, direction, self._frame.frame)
        if self._accepted(self._controller.jogging.start(jog)):
            self._release()

    # -- targets ------------------------------------------------------------------------------

    @load.pressed
    def _on_load(self) -> None:
        pose = self._shown_pose()
        if pose is not None:
            self._sent = False
            self._release()
            self._follow_arm()
        self._accepted(None if pose is not None else POSE_UNKNOWN())

    @move_p.pressed
    def _move_p(self) -> None:
        self._send(MoveMode.MOVE_P)

    @move_l.pressed
    def _move_l(self) -> None:
        self._send(MoveMode.MOVE_L)

    def _send(self, move_mode: MoveMode) -> None:
        target = self._tried = self.targets()
        if target is None:
            self._accepted(self._nonsense() or POSE_UNKNOWN())
            return
        self._sent = False
        self._drive(partial(self._controller.cartesian.move, target, move_mode), self._on_sent)
        self.show_acts()

    def _given_figures(self) -> list[object]:
        return [*super()._given_figures(), *self._arc.poses]

    def _on_sent(self) -> None:
        self._sent = True
        self.show_acts()

    def _forget_outdated(self, old: OperatingState) -> None:
        """Let the fields follow the arm again when its motion to the sent pose has ended."""
        super()._forget_outdated(old)
        if self._sent and old.moving and not self._operating_state.moving:
            self._sent = False
            self._release()

    def _on_capture(self, place: int) -> None:
        pose, refusal = self._pose(), self._controller.cell.why_no_pose()
        if pose is not None and refusal is None:
            self._arc.take(place, pose)
        self._accepted(refusal)

    def typed(self) -> tuple[float, ...] | None:
        """Return the typed target; a sent one stays in the fields until the arm is there."""
        return None if self._sent else super().typed()

    def _on_edited(self) -> None:
        self._sent = False
        self._accepted(None)

    # -- what the arm says --------------------------------------------------------------------

    def _on_state_changed(self, state: ArmState) -> None:
        if self.isVisible():
            self._follow_now_and_then(state)
            self._show_measured()
            self._show_message()

    def _follow_arm(self) -> None:
        """Show the arm's present pose in the fields in which nothing was typed."""
        pose = None if self._operating_state.device is None else self._shown_pose()
        if pose is not None:
            self._follow(pose)
        if (pose is None) is self._heard:
            self._heard = pose is not None
            self._show_possible()
        CartesianPanel.move_p.show(self)
        self._arc.show_acts()  # its buttons need an arm at rest

    @move_p.lit
    def _is_elsewhere(self) -> bool:
        """Return true while a target was entered that the arm is not at, and may reach."""
        pose, typed = self._shown_pose(), self.typed()
        if pose is None or typed is None or typed == self._unreachable:
            return False
        return self._differ_from(pose) and self._may_work()

    def note_unreachable(self, pose: tuple[float, ...] | None) -> None:
        """Note a target that is known to be out of reach, or ``None``."""
        if pose != self._unreachable:
            self._unreachable = pose
            CartesianPanel.move_p.show(self)

    def _stale(self) -> bool:
        state = self._controller.state
        return any(is_stale(heard, state, self._operating_state) for heard in state.pose)

    def _show_measured(self) -> None:
        stale = self._stale()
        for row, value in zip(self._rows, self._shown_pose() or (None,) * len(AXES), strict=True):
            row.show_measured(value, stale=stale)

    def _forget_targets(self) -> None:
        self._fill(None)
        self._arc.clear()

    # -- appearance ---------------------------------------------------------------------------

    def _show_all(self) -> None:
        self._follow_arm()
        self._show_possible()
        self._show_message()
        self._show_measured()

    def _show_possible(self) -> None:
        self._allow_jog()
        self._arc.show_acts()
        self.show_acts()

    def _first_wrong(self) -> Refusal | None:
        """Return a text that is no figure, or the arm's own refusal of its last target."""
        nonsense = self._nonsense()
        if nonsense is not None:
            return nonsense
        status = self._controller.state.status
        if status is not None and status.value.arm_status in TARGET_REFUSALS:
            return TARGET_REFUSED(status=status.value.arm_status)
        return None

    def _nonsense(self) -> Refusal | None:
        """Return the refusal of the first text that is no figure, or ``None``."""
        for row in self._rows:
            if row.field.is_nonsense():
                params = {"axis": row.name, "value": row.field.text()}
                return POSE_NOT_A_NUMBER(**params)
        return None

    def _name_point(self) -> None:
        """Name the point whose pose is shown: the flange or the tool centre point."""
        with_tool = any(self._controller.cartesian.tool)
        text = self.tr("Tool centre point") if with_tool else self.tr("Flange (no tool set)")
        name = self._controller.cell.tool_name
        self._point.setText(f"{text}: {name}" if name else text)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._name_point()
        self._list_frames()
        self._shown_frame.setAccessibleName(self.tr("Frame of the figures"))
        self._title.setText(self.tr("Cartesian"))
        super().retranslate_ui()
