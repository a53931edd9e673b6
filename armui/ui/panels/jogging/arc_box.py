"""An arc by three captured poses: start, middle and end (MOVE C)."""

from __future__ import annotations

from functools import partial
from typing import Final

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QWidget

from armui.ui import format as fmt
from armui.ui.theme import scaled_font
from armui.ui.widgets.buttons import caption, push_button
from armui.ui.widgets.enable_or_explain import enable_or_explain
from armui.ui.widgets.layouts import empty_grid, in_row
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

Pose = tuple[float, ...]
_POINTS = ("start", "middle", "end")
_TEXT_SCALE: Final = 0.85


class ArcBox(Translated, QWidget):
    """Three poses, each captured where the arm stands, and the two buttons that use them."""

    capture_wanted = Signal(int)
    """The place of a pose, 0–2, is to be taken from where the arm is."""
    start_wanted = Signal()
    """Go to the start of the arc."""
    send_wanted = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.poses: list[Pose | None] = [None, None, None]
        self._captures = [push_button(f"capture_{point}") for point in _POINTS]
        self._texts = [text_label(f"captured_{point}", rank="muted") for point in _POINTS]
        self.go_to_start = push_button("arc_start_button")
        self.send = push_button("move_c_button")
        grid = empty_grid(self, gaps=(6, 3), margins=0)
        for place, (button, text) in enumerate(zip(self._captures, self._texts, strict=True)):
            button.clicked.connect(partial(self.capture_wanted.emit, place))
            button.setProperty("compact", True)
            text.setAlignment(Qt.AlignmentFlag.AlignCenter)
            text.setFont(scaled_font(text, _TEXT_SCALE))
            grid.addWidget(button, 0, place)
            grid.addWidget(text, 1, place)
            grid.setColumnStretch(place, 1)
        buttons = in_row((self.go_to_start, 1), (self.send, 1), spacing=6)
        grid.addLayout(buttons, 2, 0, 1, len(_POINTS))
        grid.setRowStretch(3, 1)
        self.go_to_start.clicked.connect(self.start_wanted)
        self.send.clicked.connect(self.send_wanted)
        self.retranslate_ui()

    def take(self, place: int, pose: Pose) -> None:
        """A pose was captured."""
        self.poses[place] = pose
        self._show_poses()

    def clear(self) -> None:
        """The poses stand for nothing any more."""
        self.poses = [None, None, None]
        self._show_poses()

    def missing(self) -> str | None:
        """The name of the first pose that is not captured yet."""
        names = (self.tr("start"), self.tr("middle"), self.tr("end"))
        return next(
            (name for name, pose in zip(names, self.poses, strict=True) if pose is None), None
        )

    def allow(self, why_no_capture: str, why_no_move: str) -> None:
        """Enable the buttons, or disable them and say why."""
        for button in self._captures:
            use = self.tr("Takes the pose the arm has now; nothing moves.")
            enable_or_explain(button, why_no_capture, use)
        use = self.tr("Moves to the captured start with MOVE P.")
        enable_or_explain(self.go_to_start, why_no_move, use)
        use = self.tr("Moves from the start over the middle to the end. Some firmware has no arc.")
        enable_or_explain(self.send, why_no_move, use)

    def _show_poses(self) -> None:
        for text, pose in zip(self._texts, self.poses, strict=True):
            if pose is None:
                text.setText(fmt.NOTHING)
                text.setToolTip("")
                continue
            x, y, z, rx, ry, rz = (fmt.number(value, 1) for value in pose)
            text.setText(f"{' '.join(fmt.number(value, 0) for value in pose[:3])} mm")
            text.setToolTip(f"X {x}  Y {y}  Z {z} mm  RX {rx}°  RY {ry}°  RZ {rz}°")

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        names = (self.tr("Capture start"), self.tr("Capture middle"), self.tr("Capture end"))
        for button, text in zip(self._captures, names, strict=True):
            caption(button, text)
        caption(self.go_to_start, self.tr("Go to start"))
        caption(self.send, "MOVE C")
        self._show_poses()
