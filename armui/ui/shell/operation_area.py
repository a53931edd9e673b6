"""The panels of the menu, each made when it is first shown (region 7)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Protocol, runtime_checkable

from PySide6.QtWidgets import QStackedWidget, QWidget

from armui.ui.actions.places import PLACES
from armui.ui.panels.gripper_panel import GripperPanel
from armui.ui.panels.jogging.cartesian_panel import CartesianPanel
from armui.ui.panels.jogging.motion_panel import MotionPanel
from armui.ui.panels.light_panel import LightPanel
from armui.ui.panels.linkage_panel import LinkagePanel
from armui.ui.panels.motor_panel import MotorPanel
from armui.ui.panels.parameters.end_load_panel import EndLoadPanel
from armui.ui.panels.parameters.figure_panels import (
    EndLimitsPanel,
    GripperSettingsPanel,
    JointSettingsPanel,
)
from armui.ui.panels.parameters.levels_panel import CollisionPanel
from armui.ui.panels.teaching_panel import TeachingPanel
from armui.ui.shell.side_menu import MenuEntry

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.settings import SettingsStore


def menu_entries(
    controller: ArmController, preferences: SettingsStore, open_backup: Callable[[], object]
) -> tuple[MenuEntry, ...]:
    """The menu from top to bottom, in the manual's order where it has them.

    Args:
        controller: Whom the panels talk to.
        preferences: What the operator chose.
        open_backup: Opens the window 参数备份.
    """
    panels: dict[str, Callable[[], QWidget]] = {
        "motion": lambda: MotionPanel(controller, preferences.settings.jog_step_deg),
        "cartesian": lambda: CartesianPanel(controller, preferences),
        "light": lambda: LightPanel(controller),
        "linkage": lambda: LinkagePanel(controller),
        "joint_settings": lambda: JointSettingsPanel(controller, open_backup),
        "end_limits": lambda: EndLimitsPanel(controller, open_backup),
        "collision": lambda: CollisionPanel(controller, open_backup),
        "motor": lambda: MotorPanel(controller),
        "gripper": lambda: GripperPanel(controller),
        "gripper_settings": lambda: GripperSettingsPanel(controller, open_backup),
        "end_load": lambda: EndLoadPanel(controller, preferences),
        "teaching": lambda: TeachingPanel(controller, open_backup),
    }
    return tuple(MenuEntry(key, PLACES[key], make_panel) for key, make_panel in panels.items())


@runtime_checkable
class ShowsJoints(Protocol):
    """A panel with something for each joint."""

    def focus_joint(self, joint: int) -> None:
        """Bring the operator to a joint's controls."""


class OperationArea(QStackedWidget):
    """Holds the panels that have been shown, and empty pages for the others.

    Args:
        entries: What can be shown, in the order of the menu.
    """

    def __init__(self, entries: Sequence[MenuEntry]) -> None:
        super().__init__()
        self.setObjectName("operation_area")
        self._entries = tuple(entries)
        self._made: dict[int, QWidget] = {}
        self._empty = {place: QWidget() for place in range(len(self._entries))}
        for page in self._empty.values():
            self.addWidget(page)
        self.show_panel(0)

    @property
    def panels(self) -> list[QWidget]:
        """The panels that have been shown, in the order of the menu."""
        return [self._made[place] for place in sorted(self._made)]

    def show_panel(self, place: int) -> None:
        """Show a panel, made at the first time."""
        if place not in self._made:
            empty = self._empty.pop(place)
            panel = self._made[place] = self._entries[place].make_panel()
            self.insertWidget(place, panel)
            self.removeWidget(empty)
            empty.deleteLater()
        self.setCurrentIndex(place)

    def focus_joint(self, joint: int) -> None:
        """Bring the operator to a joint in the panel that is shown, if it has one for it."""
        panel: object = self.currentWidget()
        if isinstance(panel, ShowsJoints):
            panel.focus_joint(joint)
