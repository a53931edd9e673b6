"""The page 使用帮助: how to use the 3D area (manual 1.0.8 ①)."""

from __future__ import annotations

from typing import Final

from armui.ui.dialogs.sections import HelpSection, SectionsArea
from armui.ui.widgets.page import Page
from armui.ui.words.text import Text

_GAPS_PX: Final = (18, 8)

_HANDLING: Final = (
    HelpSection(
        Text("Help", "Mouse"),
        (
            (Text("Help", "Left drag"), Text("Help", "Turn the view around the arm")),
            (Text("Help", "Middle drag, Shift + left drag"), Text("Help", "Move the view")),
            (Text("Help", "Wheel"), Text("Help", "Zoom in and out")),
            (
                Text("Help", "Double click on a link"),
                Text("Help", "Mark the joint that moves it and go to its field"),
            ),
        ),
    ),
    HelpSection(
        Text("Help", "Keyboard"),
        (
            (Text("Help", "← → ↑ ↓"), Text("Help", "Turn the view")),
            (Text("Help", "+  −"), Text("Help", "Zoom in and out")),
            (Text("Help", "Home"), Text("Help", "The first view again")),
            (Text("Help", "Ctrl+1 … Ctrl+4"), Text("Help", "Front, side, top and oblique view")),
            (Text("Help", "Ctrl+5, Ctrl+9"), Text("Help", "Follow the tool; show all of the arm")),
            (
                Text("Help", "Ctrl+Shift+D"),
                Text(
                    "Help",
                    "Handles: drag the target, or the chosen point; Ctrl and Shift snap, Esc "
                    "gives up",
                ),
            ),
            (
                Text("Help", "F12, Pause"),
                Text("Help", "Emergency stop, from every window of the program"),
            ),
        ),
    ),
)
_READING: Final = (
    HelpSection(
        Text("Help", "Figures at the top left"),
        (
            (Text("Help", "X  Y  Z"), Text("Help", "Measured place of the flange, in mm")),
            (
                Text("Help", "RX  RY  RZ"),
                Text("Help", "Its measured rotation: roll, pitch, yaw, in degrees"),
            ),
            (
                Text("Help", "J1 … J6"),
                Text("Help", "Measured joint angles in degrees, J1 the lowest joint"),
            ),
        ),
        keys=False,
    ),
    HelpSection(
        Text("Help", "What the picture says"),
        (
            (Text("Help", "—"), Text("Help", "Not heard from the arm yet: no figure is made up")),
            (
                Text("Help", "Muted figures, faded arm"),
                Text("Help", "Older than half a second: where the arm was, not where it is"),
            ),
            (
                Text("Help", "Red, green, blue axis"),
                Text("Help", "X, Y and Z of the base, from the middle of its foot"),
            ),
            (
                Text("Help", "Band along the way"),
                Text(
                    "Help",
                    "Where the tool has been; thin violet: the setpoints sent one after another",
                ),
            ),
            (
                Text("Help", "Octagon, triangle"),
                Text(
                    "Help",
                    "An error or a warning of the check, where it would happen: click for its row",
                ),
            ),
        ),
        keys=False,
    ),
)


class HelpPage(Page):
    """Explains mouse, keyboard and figures of the 3D picture."""

    def __init__(self) -> None:
        super().__init__("help")
        self.setObjectName("help_page")
        self.area = SectionsArea(_HANDLING, _READING, gaps_px=_GAPS_PX)
        self.body.addWidget(self.area, 1)
        self.first = self.area
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Help: 3D view"))
