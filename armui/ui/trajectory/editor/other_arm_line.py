"""Shows above the points that they were taught on another arm, and offers to convert the zeros."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from armui.arm.model_check import ModelFit
from armui.control.events import Level
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act, HasActs
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.translated import Translated


class OtherArmLine(HasActs, Translated, QWidget):
    """A line shown while the chosen arm differs from the one a trajectory was taught on.

    Signals:
        convert_wanted: The points shall be converted to the zeros of the connected arm.
    """

    convert_wanted = Signal()
    _convert = Act("Convert zeros", named="convert_zeros")

    def __init__(self) -> None:
        super().__init__()
        self._taught_on = ""
        self._fit = ModelFit()
        self._asked = False
        self._message = named("editor_other_arm", MessageLine(keeps_room=False))
        in_row((self._message, 1), self._convert, on=self, spacing=8, margins=0)
        self.hide()

    def show_arms(self, taught_on: str, fit: ModelFit) -> bool:
        """Compare the arms.

        Args:
            taught_on: The arm the trajectory was taught on; "" if not known.
            fit: The connected or chosen arm.

        Returns:
            True if they are not those of before.
        """
        if (taught_on, fit) == (self._taught_on, self._fit):
            return False
        self._taught_on, self._fit = taught_on, fit
        self.retranslate_ui()
        return True

    @property
    def converts(self) -> bool:
        """True if only the zeros differ: the points can be converted."""
        return self._fit.zeros_from_deg(self._taught_on) is not None

    def give_way(self, asked: bool) -> None:
        """Style the button as the primary one, unless a question is asked."""
        self._asked = asked
        self.show_acts()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        other = self._taught_on not in {"", self._fit.kind}
        text = self.tr("This was taught on another arm: {taught}. Chosen is {arm}.")
        text = text.format(
            taught=words.arm_kind(self._taught_on), arm=words.arm_kind(self._fit.kind)
        )
        self._message.show_message(text if other else "", Level.WARNING)
        self._convert.setVisible(self.converts)
        self.show_acts()
        self.setVisible(other)

    @_convert.tip
    def _what_converts(self) -> str:
        turns = enumerate(self._fit.zeros_from_deg(self._taught_on) or (), start=1)
        each = fmt.listed(f"J{joint} {turn:+g}°" for joint, turn in turns if turn)
        return self.tr(
            "Turns the joints of every point by {degrees}, so that the arm comes to the same "
            "place. Poses stay: they count from the base. It can be undone."
        ).format(degrees=each)

    @_convert.lit
    def _leads(self) -> bool:
        return self.converts and not self._asked

    @_convert.pressed
    def _on_convert(self) -> None:
        self.convert_wanted.emit()
