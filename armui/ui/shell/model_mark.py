"""In the status bar: which arm of the family it is, and whether what the arm tells fits that."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QToolButton

from armui.arm.models import model_data
from armui.control.operating_state import LinkState, OperatingState
from armui.ui.theme import colors_of
from armui.ui.widgets import icons
from armui.ui.widgets.repolish import set_rank
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from collections.abc import Callable

    from armui.control.arm_controller import ArmController

_ICON_PX: Final = 14


class ModelMark(Translated, QToolButton):
    """The model's name while a device is open; a click opens the window that chooses it.

    Args:
        controller: Knows it.
        open_connection: Shows that window.
    """

    def __init__(self, controller: ArmController, open_connection: Callable[[], object]) -> None:
        super().__init__()
        self._controller = controller
        self.setObjectName("model_mark")
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.setIconSize(QSize(_ICON_PX, _ICON_PX))
        self.setAutoRaise(True)
        self.setProperty("narrow", True)
        self.setFixedHeight(self.fontMetrics().height())  # the bar keeps its height
        controller.operating_state_changed.connect(self._show)
        self.clicked.connect(lambda _checked: open_connection())
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self._show(self._controller.operating_state)

    def _recolor(self) -> None:
        self._show(self._controller.operating_state)

    def _show(self, now: OperatingState) -> None:
        self.setVisible(now.link is not LinkState.NO_DEVICE)
        fit, name = now.model_fit, model_data(now.model).name
        colors = colors_of(self)
        wrong = fit.wrong is not None or fit.before is not None
        if fit.other is not None:
            other = model_data(fit.other).name
            text = self.tr("{model}? The pose is that of a {other}").format(model=name, other=other)
            tip = self.tr("Click to connect it as a {other}.").format(other=other)
        elif fit.before is not None:
            before = model_data(fit.before).name
            text = self.tr("{model}? It was a {before}").format(model=name, before=before)
            tip = self.tr("This very arm was a {before} the last time. Click to choose.").format(
                before=before
            )
        elif wrong:
            text = self.tr("{model}? The pose fits none").format(model=name)
            tip = self.tr("The pose the arm reports fits none of the models.")
        elif fit.confirmed:
            text, tip = name, self.tr("Model of the arm, confirmed by the pose it reports.")
        else:
            text, tip = name, self.tr("Model of the arm, as chosen; not compared yet.")
        if fit.older_zeros:
            tip += "\n" + self.tr("Joints 2 and 3 count from the zeros before S-V1.6-3.")
        self.setText(text)
        self.setToolTip(tip)
        self.setAccessibleName(self.tr("Model of the arm: {text}").format(text=text))
        if wrong:
            self.setIcon(icons.icon("warning", colors.warn, _ICON_PX))
        style = (
            Qt.ToolButtonStyle.ToolButtonTextBesideIcon
            if wrong
            else Qt.ToolButtonStyle.ToolButtonTextOnly
        )
        self.setToolButtonStyle(style)
        set_rank(self, "warning" if wrong else "muted")
