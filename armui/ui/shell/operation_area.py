"""Region 7: the panel chosen in the menu; each is made when it is first shown."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from importlib import import_module
from typing import TYPE_CHECKING, Final, Protocol, runtime_checkable

from PySide6.QtWidgets import QStackedWidget, QWidget

from armui.ui.actions.places import PLACES
from armui.ui.shell.side_menu import MenuEntry

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.settings import SettingsStore


# key, module and class below `armui.ui.panels`, what the panel gets beside the controller
_PANELS: Final = (
    ("motion", "jogging.motion_panel.MotionPanel", "jog_step"),
    ("cartesian", "jogging.cartesian_panel.CartesianPanel", "preferences"),
    ("light", "light_panel.LightPanel", ""),
    ("linkage", "linkage_panel.LinkagePanel", ""),
    ("joint_settings", "parameters.joint_settings_panel.JointSettingsPanel", "open_backup"),
    ("end_limits", "parameters.listed_panels.EndLimitsPanel", "open_backup"),
    ("collision", "parameters.levels_panel.CollisionPanel", "open_backup"),
    ("motor", "motor_panel.MotorPanel", ""),
    ("gripper", "gripper_panel.GripperPanel", ""),
    ("gripper_settings", "parameters.listed_panels.GripperSettingsPanel", "open_backup"),
    ("end_load", "parameters.end_load_panel.EndLoadPanel", "preferences"),
    ("teaching", "teaching_panel.TeachingPanel", "open_backup"),
)


def menu_entries(
    controller: ArmController, preferences: SettingsStore, open_backup: Callable[[], object]
) -> tuple[MenuEntry, ...]:
    """The menu from top to bottom, in the manual's order where it has them.

    Args:
        controller: Whom the panels talk to.
        preferences: What the operator chose.
        open_backup: Opens the window 参数备份.
    """
    more: dict[str, Callable[[], Sequence[object]]] = {
        "": tuple,
        "jog_step": lambda: (preferences.settings.jog_step_deg,),
        "preferences": lambda: (preferences,),
        "open_backup": lambda: (open_backup,),
    }

    def make(place: str, needs: str) -> QWidget:
        module, _, name = place.rpartition(".")
        panel: QWidget = getattr(import_module(f"armui.ui.panels.{module}"), name)(
            controller, *more[needs]()
        )
        return panel

    return tuple(
        MenuEntry(key, PLACES[key], partial(make, place, needs)) for key, place, needs in _PANELS
    )


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
