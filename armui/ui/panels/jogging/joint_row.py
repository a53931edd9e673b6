"""One joint of the motion panel: target, jog buttons, measured angle and limits."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel

from armui.arm.limits import ANGLE_STEP_DEG, JointLimits, check_joint
from armui.arm.refusal import Refusal
from armui.ui import format as fmt
from armui.ui.panels.jogging.jog_signals import JogSignals
from armui.ui.theme import scaled_font
from armui.ui.widgets import painting
from armui.ui.widgets.buttons import describe, named
from armui.ui.widgets.curve_menu import tell_quantities
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.jog_button import JogButton
from armui.ui.widgets.layouts import empty_grid
from armui.ui.widgets.track_slider import TrackSlider
from armui.ui.widgets.value_label import ValueLabel

SAME_DEG: Final = 0.0006
"""Two angles that are written alike are the same, however they were rounded."""

_WIDEST_ANGLE: Final = "-000.000°"
_WIDEST_LIMIT: Final = "-000.00°"


class JointRow(JogSignals):
    """The controls of one joint; its signals carry the joint's number.

    Its target follows the arm until the operator gives it another: sending the fields never takes
    a joint back to where it was some time ago.

    Args:
        joint: Its number, 1–6.
        limits: Its range until the arm tells another.

    Attributes:
        own: Whether the target was given by the operator, and so stands still.
    """

    def __init__(self, joint: int, limits: JointLimits) -> None:
        super().__init__()
        painting.fill_ground(self)
        self.joint = joint
        self.own = False
        self._limits = limits
        self._limits_read = False
        self._name = QLabel(f"J{joint}")
        self._name.setFont(scaled_font(self._name, 1.15, bold=True))
        self.minus = named(f"jog_minus_{joint}", JogButton("−"))
        self.plus = named(f"jog_plus_{joint}", JogButton("+"))
        self.field = named(f"target_field_{joint}", FigureField(fmt.DECIMALS, "°"))
        self.measured = named(f"measured_{joint}", ValueLabel(_WIDEST_ANGLE))
        tell_quantities(
            self, *(f"{source}.joint_angle.{joint}" for source in ("arm", "own", "other"))
        )
        self.slider = named(f"target_slider_{joint}", TrackSlider(ANGLE_STEP_DEG, marked=True))
        self.slider.setSingleStep(round(1.0 / ANGLE_STEP_DEG))
        self.slider.setPageStep(round(10.0 / ANGLE_STEP_DEG))
        self._minimum = ValueLabel(_WIDEST_LIMIT)
        self._maximum = ValueLabel(_WIDEST_LIMIT, alignment=Qt.AlignmentFlag.AlignLeft)
        for label in (self._minimum, self._maximum):
            label.setFont(scaled_font(label, 0.88))
        self._lay_out()
        self._tell_presses(joint, self.minus, self.plus)
        self.field.value_edited.connect(self._on_field_edited)
        self.slider.valueChanged.connect(self._on_slider_moved)
        self.show_target(None)
        self.retranslate_ui()

    def _lay_out(self) -> None:
        top = Qt.AlignmentFlag.AlignTop
        grid = empty_grid(self, gaps=(8, 0), margins=0)
        grid.addWidget(self._name, 0, 0)
        grid.addWidget(self.minus, 0, 1)
        grid.addWidget(self.field, 0, 2)
        grid.addWidget(self.plus, 0, 3)
        grid.addWidget(self.measured, 0, 4, Qt.AlignmentFlag.AlignRight)
        grid.addWidget(self._minimum, 1, 0, 1, 2, Qt.AlignmentFlag.AlignRight | top)
        grid.addWidget(self.slider, 1, 2, 1, 2, top)
        grid.addWidget(self._maximum, 1, 4, Qt.AlignmentFlag.AlignLeft | top)
        grid.setColumnMinimumWidth(0, 30)
        grid.setColumnMinimumWidth(4, self.measured.sizeHint().width() + 6)
        grid.setColumnStretch(2, 1)

    # -- target -------------------------------------------------------------------------------

    @property
    def target_deg(self) -> float | None:
        """The figure in the field, or ``None``."""
        return self.field.value

    def beyond_limits(self) -> Refusal | None:
        """What is to be said against the figure in the field, if it is out of limits."""
        target = self.target_deg
        return None if target is None else check_joint(self.joint, target, self._limits)

    def show_target(self, target_deg: float | None) -> None:
        """Give a target, into field and slider; ``None`` empties them."""
        self.own = target_deg is not None
        self.field.show_value(target_deg)
        self._after_target()

    def follow(self, angle_deg: float) -> None:
        """Have a target that nobody gave be where the arm is, or is sent to."""
        if not self.own and self.field.follow(angle_deg):
            self._after_target()

    def differs_from(self, angle_deg: float) -> bool:
        """Whether the operator has given a target, and it is another angle than this."""
        target = self.target_deg
        return self.own and (target is None or abs(target - angle_deg) > SAME_DEG)

    def _on_field_edited(self) -> None:
        self.own = bool(self.field.text())
        self._after_target()
        self.edited.emit(self.joint)

    def _on_slider_moved(self) -> None:
        self.own = True
        self.field.show_value(self.slider.requested)
        self._after_target()
        self.edited.emit(self.joint)

    def _after_target(self) -> None:
        """Slider, marks and colours go with the figure in the field."""
        beyond = self.beyond_limits() is not None
        self.slider.show_requested(self.target_deg, attention=beyond)
        self.field.show_attention(wanted=beyond or self.field.is_nonsense())
        self._show_limits()

    # -- what the arm says --------------------------------------------------------------------

    def show_measured(self, angle_deg: float | None, *, stale: bool) -> None:
        """Show the measured angle as figure and as mark on the slider."""
        self.measured.show_text(fmt.angle(angle_deg), stale=stale)
        self.slider.show_measured(None if stale else angle_deg)

    def set_limits(self, limits: JointLimits, *, read: bool) -> None:
        """Take other limits.

        Args:
            limits: The range.
            read: Whether the arm told it; otherwise it is the factory's.
        """
        if (limits, read) == (self._limits, self._limits_read):
            return
        self._limits, self._limits_read = limits, read
        self._after_target()
        self.retranslate_ui()

    def _show_limits(self) -> None:
        limits, target = self._limits, self.target_deg
        self.slider.set_limits(limits.min_deg, limits.max_deg)
        beyond = self.beyond_limits() is not None
        below = beyond and target is not None and target < limits.min_deg
        above = beyond and not below
        for label, bound_deg, sign, broken in (
            (self._minimum, limits.min_deg, "≥ ", below),
            (self._maximum, limits.max_deg, "≤ ", above),
        ):
            text = fmt.short_angle(bound_deg)
            label.show_text(sign + text if broken else text, stale=not self._limits_read)
            label.show_attention(wanted=broken)

    # -- use ----------------------------------------------------------------------------------

    def set_step(self, step_deg: float, *, continuous: bool) -> None:
        """How far one press of − or + goes, or whether it goes on while they are held."""
        self.field.step = step_deg
        for button in (self.minus, self.plus):
            button.continuous = continuous
        self._describe_jog("", step_deg)

    def allow_jog(self, why_not: str) -> None:
        """Enable − and +, or disable them and say why."""
        for button in (self.minus, self.plus):
            button.setEnabled(not why_not)
        self._describe_jog(why_not, self.field.step)

    def _describe_jog(self, why_not: str, step_deg: float) -> None:
        step = fmt.short_angle(step_deg)
        if self.minus.continuous:
            hold = self.tr("Moves joint {joint} while it is held; let go to stop.")
            tips = (hold, hold)
        else:
            tips = (
                self.tr("Moves joint {joint} by −{step} at once. Hold to go on."),
                self.tr("Moves joint {joint} by +{step} at once. Hold to go on."),
            )
        for button, tip in zip((self.minus, self.plus), tips, strict=True):
            button.setToolTip(why_not or tip.format(joint=self.joint, step=step))

    def retranslate_ui(self) -> None:
        """Put names and tooltips into the operator's language."""
        joint = self.joint
        self.minus.setAccessibleName(self.tr("Joint {joint} minus").format(joint=joint))
        self.plus.setAccessibleName(self.tr("Joint {joint} plus").format(joint=joint))
        self.field.setAccessibleName(self.tr("Target angle of joint {joint}").format(joint=joint))
        self.slider.setAccessibleName(self.tr("Target slider of joint {joint}").format(joint=joint))
        measured = self.tr("Measured angle of joint {joint}").format(joint=joint)
        describe(self.measured, measured, self.tr("Measured by the arm"))
        target = self.tr(
            "Target of joint {joint}: {minimum} to {maximum}. Not sent before you press Send."
        ).format(
            joint=joint,
            minimum=fmt.short_angle(self._limits.min_deg),
            maximum=fmt.short_angle(self._limits.max_deg),
        )
        self.field.setToolTip(target)
        self.slider.setToolTip(target)
        read = self.tr("Limit read from the arm")
        origin = read if self._limits_read else self.tr("Factory limit: not read from the arm yet")
        self._minimum.setToolTip(origin)
        self._maximum.setToolTip(origin)
