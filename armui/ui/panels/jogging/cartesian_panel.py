"""末端控制: the tool is sent to a pose, on a line or an arc, stepped and jogged (0x152–0x154)."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Final

from PySide6.QtWidgets import QButtonGroup, QFrame, QLabel, QSizePolicy, QWidget

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.arm.state import ArmState
from armui.control.arm_controller import ArmController
from armui.control.motion.jog_path import ToolJog
from armui.control.operating_state import OperatingState
from armui.kinematics.poses import AXES, LINEAR_AXES, JogFrame
from armui.protocol.codes import ArmStatusCode, MoveMode
from armui.settings import SettingsStore
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.freshness import is_stale
from armui.ui.panels.jogging.jog_panel import JogPanel, JogSignals, take_figures
from armui.ui.panels.jogging.pose_extras import ArcBox, PoseExtras, ToolBox
from armui.ui.theme import scaled_font
from armui.ui.widgets import painting
from armui.ui.widgets.buttons import (
    caption,
    choice_button,
    describe,
    enable_or_explain,
    named,
    push_button,
    show_primary,
)
from armui.ui.widgets.curve_menu import tell_quantities
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.jog_button import JogButton
from armui.ui.widgets.layouts import STRETCH, in_column, in_row
from armui.ui.widgets.text_label import ValueLabel, text_label
from armui.ui.widgets.translated import Translated

_OWN_REFUSALS: Final = frozenset(
    {ArmStatusCode.NO_SOLUTION, ArmStatusCode.SINGULARITY, ArmStatusCode.TARGET_BEYOND_LIMIT}
)
"""What 0x2A1 says of a target the arm itself refuses."""
_KEYS: Final = (
    ("X", "↑", "↓"),
    ("Y", "←", "→"),
    ("Z", "PgUp", "PgDn"),
    ("RX", "Q", "A"),
    ("RY", "W", "S"),
    ("RZ", "E", "D"),
)
_TALLEST_CARD_PX: Final = 640
_WIDEST: Final = "-0000.000 mm"
_NAME_PX: Final = 34
_SAME: Final = 0.0006
"""Two figures that are written alike are the same."""


class PoseRow(JogSignals):
    """The controls of one axis; its signals carry the axis' place.

    Args:
        place: 0–5 for X, Y, Z, RX, RY, RZ.
        name: One of them.
        unit: ``mm`` or ``°``.

    Attributes:
        own: Whether the target was given by the operator; else it follows the arm.
    """

    def __init__(self, place: int, name: str, unit: str) -> None:
        super().__init__()
        painting.fill_ground(self)
        self.name = name
        self.own = False
        self._unit = unit
        self._label = QLabel(name)
        self._label.setFont(scaled_font(self._label, 1.15, bold=True))
        self._label.setFixedWidth(_NAME_PX)
        self.minus = named(f"pose_minus_{name}", JogButton("−"))
        self.plus = named(f"pose_plus_{name}", JogButton("+"))
        self.field = named(f"pose_field_{name}", FigureField(fmt.DECIMALS, unit))
        self.field.setTextMargins(0, 0, 28 if unit == "mm" else 5, 0)
        self.measured = named(f"pose_measured_{name}", ValueLabel(_WIDEST))
        kind = f"pose_{name.lower()}"
        tell_quantities(self, *(f"{source}.{kind}" for source in ("arm", "own", "other")))
        parts = (self._label, self.minus, (self.field, 1), self.plus, self.measured)
        in_row(*parts, on=self, spacing=8, margins=0)
        self._tell_presses(place, self.minus, self.plus)
        self.field.value_edited.connect(partial(self._on_edited, place))
        self.retranslate_ui()

    def _on_edited(self, place: int) -> None:
        self.own = bool(self.field.text())
        self.field.show_attention(wanted=self.field.is_nonsense())
        self.edited.emit(place)

    def show_target(self, value: float | None) -> None:
        """Give a target; ``None`` empties the field."""
        self.own = value is not None
        self.field.show_value(value)
        self.field.show_attention(wanted=False)

    def follow(self, value: float) -> None:
        """Have a target that nobody gave be where the arm is."""
        if not self.own:
            self.field.follow(value)

    def differs_from(self, value: float) -> bool:
        """Whether the operator has given a target, and it is another figure than this."""
        target = self.field.value
        return self.own and (target is None or abs(target - value) > _SAME)

    def show_measured(self, value: float | None, *, stale: bool) -> None:
        """Show the measured value."""
        self.measured.show_text(fmt.with_unit(value, self._unit), stale=stale)

    def set_step(self, step: float, *, continuous: bool) -> None:
        """How far one press of − or + goes, or whether it goes on while they are held."""
        self.field.step = step
        for button in (self.minus, self.plus):
            button.continuous = continuous
        self.retranslate_ui()

    def allow_jog(self, why_not: str) -> None:
        """Enable − and +, or disable them and say why."""
        for button, sign in ((self.minus, "−"), (self.plus, "+")):
            button.setEnabled(not why_not)
            if button.continuous:
                tip = self.tr("Moves along {axis} while it is held; let go to stop.")
            else:
                tip = self.tr("Moves along {axis} by {step} at once.")
            step = f"{sign}{self.field.step:g} {self._unit}"
            button.setToolTip(why_not or tip.format(axis=self.name, step=step))

    def retranslate_ui(self) -> None:
        """Put names and tooltips into the operator's language."""
        self.minus.setAccessibleName(self.tr("{axis} minus").format(axis=self.name))
        self.plus.setAccessibleName(self.tr("{axis} plus").format(axis=self.name))
        target = self.tr("Target {axis}").format(axis=self.name)
        describe(self.field, target, self.tr("Not sent before you press MOVE P or MOVE L."))
        self.measured.setToolTip(self.tr("Measured by the arm"))


class PoseRows(Translated, QWidget):
    """Targets to type and jog.

    Attributes:
        rows: One an axis.
    """

    def __init__(self) -> None:
        super().__init__()
        self._point = text_label("point_label", rank="muted")
        self._measured_head = text_label(rank="muted")
        self._with_tool = False
        self.rows = [
            PoseRow(place, name, "mm" if place < LINEAR_AXES else "°")
            for place, name in enumerate(AXES)
        ]
        head = in_row(self._point, STRETCH, self._measured_head)
        in_column(head, *self.rows, on=self, spacing=4, margins=0)
        self.retranslate_ui()

    def targets(self) -> list[float] | Refusal:
        """The six figures, or why one of them is none."""
        values = [row.field.value for row in self.rows]
        targets = [value for value in values if value is not None]
        if len(targets) == len(AXES):
            return targets
        return self.nonsense() or Refusal(RefusalCode.POSE_UNKNOWN)

    def nonsense(self) -> Refusal | None:
        """What is to be said against the first text that is no figure."""
        for row in self.rows:
            if row.field.is_nonsense():
                return Refusal(
                    RefusalCode.POSE_NOT_A_NUMBER, {"axis": row.name, "value": row.field.text()}
                )
        return None

    def fill(self, pose: Sequence[float] | None) -> None:
        """Put a pose into the fields; ``None`` empties them."""
        for row, value in zip(self.rows, pose or (None,) * len(AXES), strict=True):
            row.show_target(value)

    def follow(self, pose: Sequence[float]) -> None:
        """Show a pose in the fields in which no target was given."""
        for row, value in zip(self.rows, pose, strict=True):
            row.follow(value)

    def release(self) -> None:
        """No target is the operator's any more."""
        for row in self.rows:
            row.own = False

    def differ_from(self, pose: Sequence[float]) -> bool:
        """Whether a target was given that is not this pose."""
        return any(row.differs_from(value) for row, value in zip(self.rows, pose, strict=True))

    def show_measured(self, pose: Sequence[float] | None, *, stale: bool) -> None:
        """Show what is measured."""
        for row, value in zip(self.rows, pose or (None,) * len(AXES), strict=True):
            row.show_measured(value, stale=stale)

    def set_step(self, step: float, *, continuous: bool) -> None:
        """How far one press of − or + goes, or whether it goes on while they are held."""
        for row in self.rows:
            row.set_step(step, continuous=continuous)

    def allow_jog(self, why_not: str) -> None:
        """Enable − and +, or disable them and say why."""
        for row in self.rows:
            row.allow_jog(why_not)

    def name_point(self, *, with_tool: bool) -> None:
        """Say which point the figures are about."""
        self._with_tool = with_tool
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self._point.setText(
            self.tr("Tool centre point") if self._with_tool else self.tr("Flange (no tool set)")
        )
        self._measured_head.setText(self.tr("Measured"))


class FrameChoice(Translated, QWidget):
    """One button a frame; one of them is chosen."""

    def __init__(self) -> None:
        super().__init__()
        self._label = QLabel()
        self._buttons = QButtonGroup(self)
        layout = in_row(self._label, on=self, spacing=6, margins=0)
        for number, frame in enumerate(JogFrame):
            button = choice_button(f"frame_{frame.value}")
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            self._buttons.addButton(button, number)
            layout.addWidget(button, 1)
        self._buttons.button(0).setChecked(True)
        self.retranslate_ui()

    @property
    def frame(self) -> JogFrame:
        """The chosen one."""
        return tuple(JogFrame)[self._buttons.checkedId()]

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self._label.setText(self.tr("− and + along"))
        for number, text in enumerate((self.tr("Base frame"), self.tr("Tool frame"))):
            caption(self._buttons.button(number), text)


class CartesianPanel(JogPanel):
    """Targets and measured pose of one point: the tool centre point, or the flange without a tool.

    Args:
        controller: Whom to ask for motion.
        preferences: Keep the tool.
    """

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
        self._frame = FrameChoice()
        self._rows = PoseRows()
        self._tool = ToolBox()
        self._arc = ArcBox()
        self._load = push_button("load_pose_button")
        self._move_p = push_button("move_p_button")
        self._move_l = push_button("move_l_button")
        self._lay_out()
        self._connect()
        self._use_tool(preferences.settings.tool)
        self._on_step_chosen()
        self.retranslate_ui()

    def _lay_out(self) -> None:
        card = QFrame()
        self._extras = PoseExtras(self._arc, self._tool)
        self._keys.toggled.connect(self._extras.setHidden)  # the keys need the room
        parts = (self._rows, self._extras, STRETCH)
        in_column(*parts, on=card, spacing=10, margins=(16, 8, 16, 10))
        buttons = (self._load, self._move_p, self._move_l)
        self._finish(card, buttons, tallest_px=_TALLEST_CARD_PX, above=(self._frame,))

    def _connect(self) -> None:
        self._follow_rows(self._rows.rows)
        self._tool.changed.connect(self._on_tool_changed)
        self._arc.capture_wanted.connect(self._on_capture)
        self._arc.start_wanted.connect(self._on_go_to_start)
        self._arc.send_wanted.connect(self._on_send_arc)
        self._load.clicked.connect(self._on_load)
        self._move_p.clicked.connect(lambda: self._send(MoveMode.MOVE_P))
        self._move_l.clicked.connect(lambda: self._send(MoveMode.MOVE_L))

    # -- the tool -----------------------------------------------------------------------------

    def _on_tool_changed(self, tool: tuple[float, ...]) -> None:
        if tool == self._controller.cartesian.tool:
            self._accepted(None)
            self._tool.mark(wrong=False)
            return
        refusal = self._preferences.change(tool=tool)
        self._tool.mark(wrong=refusal is not None)
        self._accepted(refusal)
        if self._preferences.settings.tool == tool:
            self._use_tool(tool)

    def _use_tool(self, tool: tuple[float, ...]) -> None:
        """Poses of another point stand for nothing: they are taken anew."""
        self._controller.cartesian.tool = tool
        self._tool.show_tool(tool)
        self._arc.clear()
        self._rows.release()
        self._follow_arm()
        self._rows.name_point(with_tool=any(tool))
        self._show_measured()

    def _pose(self) -> tuple[float, ...] | None:
        return self._controller.cartesian.tool_pose(self._controller.state)

    # -- jogging ------------------------------------------------------------------------------

    def _take_step(self, step: float, *, continuous: bool) -> None:
        self._rows.set_step(step, continuous=continuous)

    def _on_stepped(self, place: int, direction: int) -> None:
        amount = direction * self._step_box.step
        refusal = self._controller.cartesian.step(place, amount, self._frame.frame)
        if self._accepted(refusal):
            self._rows.release()

    def _on_repeated(self, place: int, direction: int) -> None:
        """MOVE L plans anew at each target: a held button waits for the arm."""
        if not self._operating_state.moving:
            self._on_stepped(place, direction)

    def _on_held(self, place: int, direction: int) -> None:
        jog = ToolJog(place, direction, self._frame.frame)
        refusal = self._controller.jogging.start(jog)
        if self._accepted(refusal):
            self._rows.release()

    # -- targets ------------------------------------------------------------------------------

    def target_pose(self) -> tuple[float, ...] | None:
        """The pose in the fields; None while one of them is no figure."""
        pose = self._rows.targets()
        return None if isinstance(pose, Refusal) else tuple(pose)

    def given(self) -> tuple[bool, ...]:
        """Of each field, whether its target was given; else it follows the arm."""
        return tuple(row.own for row in self._rows.rows)

    def take_pose(self, pose: Sequence[float], given: Sequence[bool] | None = None) -> None:
        """Put a pose into the fields, as if the figures that differ were typed; nothing is sent.

        Args:
            pose: The pose.
            given: As in 运动控制: which of them stand still from now on.
        """
        take_figures(self._rows.rows, pose, given)
        self._follow_arm()
        self._on_edited()

    def _on_load(self) -> None:
        pose = self._pose()
        if pose is not None:
            self._rows.fill(pose)
            self._follow_arm()
        self._accepted(None if pose is not None else Refusal(RefusalCode.POSE_UNKNOWN))

    def _send(self, move_mode: MoveMode) -> None:
        target = self._rows.targets()
        if isinstance(target, Refusal):
            self._accepted(target)
            return
        self._sent = self._accepted(self._controller.cartesian.move(target, move_mode))

    def _forget_outdated(self, old: OperatingState) -> None:
        """Once a pose was driven to, the fields follow the arm again."""
        super()._forget_outdated(old)
        if self._sent and old.moving and not self._operating_state.moving:
            self._sent = False
            self._rows.release()

    def _on_capture(self, place: int) -> None:
        pose = self._pose()
        if pose is not None:
            self._arc.take(place, pose)
        self._accepted(None if pose is not None else Refusal(RefusalCode.POSE_UNKNOWN))

    def _on_go_to_start(self) -> None:
        start = self._arc.poses[0]
        if start is None:
            point = self._arc.missing() or ""
            self._accepted(Refusal(RefusalCode.ARC_INCOMPLETE, {"point": point}))
        else:
            self._accepted(self._controller.cartesian.move(start, MoveMode.MOVE_P))

    def _on_send_arc(self) -> None:
        points = [pose for pose in self._arc.poses if pose is not None]
        missing = self._arc.missing()
        if missing is not None:
            self._accepted(Refusal(RefusalCode.ARC_INCOMPLETE, {"point": missing}))
        else:
            self._accepted(self._controller.cartesian.move_arc(*points))

    def _on_edited(self) -> None:
        self._light_move()
        self._accepted(None)

    # -- what the arm says --------------------------------------------------------------------

    def _on_state_changed(self, state: ArmState) -> None:
        if self.isVisible():
            self._follow_now_and_then(state)
            self._show_measured()
            self._show_message()

    def _follow_arm(self) -> None:
        """Fields in which nothing was given show where the arm is."""
        pose = None if self._operating_state.device is None else self._pose()
        if pose is not None:
            self._rows.follow(pose)
        if (pose is None) is self._heard:
            self._heard = pose is not None
            self._show_possible()
        self._light_move()

    def _light_move(self) -> None:
        """Light MOVE P while a target was given that the arm is not at."""
        pose = self._pose()
        show_primary(self._move_p, wanted=pose is not None and self._rows.differ_from(pose))

    def _show_measured(self) -> None:
        state = self._controller.state
        stale = any(is_stale(heard, state, self._operating_state) for heard in state.pose)
        self._rows.show_measured(self._pose(), stale=stale)

    def _forget_targets(self) -> None:
        self._rows.fill(None)
        self._arc.clear()

    # -- appearance ---------------------------------------------------------------------------

    def _show_all(self) -> None:
        self._follow_arm()
        self._show_possible()
        self._show_message()
        self._show_measured()

    def _show_possible(self) -> None:
        why_not = self._why_not_move()
        self._rows.allow_jog(why_not)
        self._key_pad.allow(why_not)
        unknown = self._controller.state.end_pose() is None
        no_pose = words.refusal(Refusal(RefusalCode.POSE_UNKNOWN)) if unknown else ""
        self._arc.allow(no_pose, why_not)
        use = self.tr("Fills the fields with the measured pose; nothing moves.")
        enable_or_explain(self._load, no_pose, use)
        use = self.tr("Moves to the pose, each joint on its own way.")
        enable_or_explain(self._move_p, why_not, use)
        use = self.tr("Moves to the pose on a straight line.")
        enable_or_explain(self._move_l, why_not, use)

    def _first_wrong(self) -> Refusal | None:
        """A figure that is none, or what the arm itself says against its last target."""
        nonsense = self._rows.nonsense()
        if nonsense is not None:
            return nonsense
        status = self._controller.state.status
        if status is not None and status.value.arm_status in _OWN_REFUSALS:
            return Refusal(RefusalCode.TARGET_REFUSED, {"status": status.value.arm_status})
        return None

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self._title.setText(self.tr("Tool control"))
        caption(self._load, self.tr("Load"))
        caption(self._move_p, "MOVE P")
        caption(self._move_l, "MOVE L")
        super().retranslate_ui()
