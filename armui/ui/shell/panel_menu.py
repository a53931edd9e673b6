"""Which panels there are, in the order of the menu; each is loaded when it is first chosen."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from importlib import import_module
from typing import TYPE_CHECKING, Final

from PySide6.QtWidgets import QWidget

from armui.ui.actions.places import PLACES
from armui.ui.shell.side_menu import MenuEntry

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.settings import SettingsStore

# key, module and class below `armui.ui.panels`, what the panel gets beside the controller
_PANELS: Final = (
    ("motion", "jogging.motion_panel.MotionPanel", "jog_step"),
    ("cartesian", "jogging.cartesian_panel.CartesianPanel", "preferences"),
    ("light", "light.light_panel.LightPanel", ""),
    ("linkage", "linkage_panel.LinkagePanel", ""),
    ("joint_settings", "parameters.joint_settings_panel.JointSettingsPanel", "open_backup"),
    ("end_limits", "parameters.end_limits_panel.EndLimitsPanel", "open_backup"),
    ("collision", "parameters.collision_panel.CollisionPanel", "open_backup"),
    ("motor", "motors.motor_panel.MotorPanel", ""),
    ("gripper", "gripper.gripper_panel.GripperPanel", ""),
    ("gripper_settings", "parameters.gripper_settings_panel.GripperSettingsPanel", "open_backup"),
    ("end_load", "parameters.end_load_panel.EndLoadPanel", "preferences"),
    ("teaching", "teaching.teaching_panel.TeachingPanel", "open_backup"),
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
