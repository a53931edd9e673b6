"""Which panels there are, in the order of the menu; each is loaded when it is first chosen."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from importlib import import_module
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QT_TRANSLATE_NOOP
from PySide6.QtWidgets import QWidget

from armui.ui.shell.side_menu import MenuEntry

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.settings import SettingsStore

# key, title, module and class below `armui.ui.panels`, what the panel gets beside the controller
# fmt: off
_PANELS: Final = (
    ("motion", QT_TRANSLATE_NOOP("SideMenu", "Motion control"),
     "jogging.motion_panel.MotionPanel", "jog_step"),
    ("cartesian", QT_TRANSLATE_NOOP("SideMenu", "Tool control"),
     "jogging.cartesian_panel.CartesianPanel", "preferences"),
    ("light", QT_TRANSLATE_NOOP("SideMenu", "Light control"),
     "light.light_panel.LightPanel", ""),
    ("linkage", QT_TRANSLATE_NOOP("SideMenu", "Linkage control"),
     "linkage_panel.LinkagePanel", ""),
    ("joint_settings", QT_TRANSLATE_NOOP("SideMenu", "Joint settings"),
     "parameters.joint_settings_panel.JointSettingsPanel", "open_backup"),
    ("end_limits", QT_TRANSLATE_NOOP("SideMenu", "End speed limits"),
     "parameters.end_limits_panel.EndLimitsPanel", "open_backup"),
    ("collision", QT_TRANSLATE_NOOP("SideMenu", "Collision level"),
     "parameters.collision_panel.CollisionPanel", "open_backup"),
    ("motor", QT_TRANSLATE_NOOP("SideMenu", "Motor settings"),
     "motors.motor_panel.MotorPanel", ""),
    ("gripper", QT_TRANSLATE_NOOP("SideMenu", "Gripper control"),
     "gripper.gripper_panel.GripperPanel", ""),
    ("gripper_settings", QT_TRANSLATE_NOOP("SideMenu", "Gripper settings"),
     "parameters.gripper_settings_panel.GripperSettingsPanel", "open_backup"),
    ("end_load", QT_TRANSLATE_NOOP("SideMenu", "End load"),
     "parameters.end_load_panel.EndLoadPanel", "preferences"),
    ("teaching", QT_TRANSLATE_NOOP("SideMenu", "Drag teaching"),
     "teaching.teaching_panel.TeachingPanel", "open_backup"),
)
# fmt: on


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
        MenuEntry(key, str(title), partial(make, place, needs))
        for key, title, place, needs in _PANELS
    )
