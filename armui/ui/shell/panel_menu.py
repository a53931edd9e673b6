"""Which panels there are, in the order of the menu; each is loaded when it is first chosen."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QT_TRANSLATE_NOOP
from PySide6.QtWidgets import QWidget

from armui.ui.panels.jogging.motion_panel import MotionPanel
from armui.ui.shell.side_menu import MenuEntry

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.settings import SettingsStore

# ruff: noqa: PLC0415 - a panel nobody has chosen does not delay the start


class PanelMaker:
    """Makes the panels.

    Args:
        controller: Whom they talk to.
        preferences: What the operator chose.
        open_backup: Opens the window 参数备份.
    """

    def __init__(
        self,
        controller: ArmController,
        preferences: SettingsStore,
        open_backup: Callable[[], object],
    ) -> None:
        self._controller = controller
        self._preferences = preferences
        self._open_backup = open_backup

    def entries(self) -> tuple[MenuEntry, ...]:
        """From top to bottom, in the manual's order where it has them."""
        return (
            MenuEntry(
                "motion",
                str(QT_TRANSLATE_NOOP("SideMenu", "Motion control")),
                "motion",
                self._motion,
            ),
            MenuEntry(
                "cartesian",
                str(QT_TRANSLATE_NOOP("SideMenu", "Tool control")),
                "cartesian",
                self._cartesian,
            ),
            MenuEntry(
                "light",
                str(QT_TRANSLATE_NOOP("SideMenu", "Light control")),
                "light",
                self._light,
            ),
            MenuEntry(
                "linkage",
                str(QT_TRANSLATE_NOOP("SideMenu", "Linkage control")),
                "linkage",
                self._linkage,
            ),
            MenuEntry(
                "joint_settings",
                str(QT_TRANSLATE_NOOP("SideMenu", "Joint settings")),
                "joint_settings",
                self._joint_settings,
            ),
            MenuEntry(
                "end_limits",
                str(QT_TRANSLATE_NOOP("SideMenu", "End speed limits")),
                "end_limits",
                self._end_limits,
            ),
            MenuEntry(
                "collision",
                str(QT_TRANSLATE_NOOP("SideMenu", "Collision level")),
                "collision",
                self._collision,
            ),
            MenuEntry(
                "motor",
                str(QT_TRANSLATE_NOOP("SideMenu", "Motor settings")),
                "motor",
                self._motor,
            ),
            MenuEntry(
                "gripper",
                str(QT_TRANSLATE_NOOP("SideMenu", "Gripper control")),
                "gripper",
                self._gripper,
            ),
            MenuEntry(
                "gripper_settings",
                str(QT_TRANSLATE_NOOP("SideMenu", "Gripper settings")),
                "gripper_settings",
                self._gripper_settings,
            ),
            MenuEntry(
                "end_load",
                str(QT_TRANSLATE_NOOP("SideMenu", "End load")),
                "load",
                self._end_load,
            ),
            MenuEntry(
                "teaching",
                str(QT_TRANSLATE_NOOP("SideMenu", "Drag teaching")),
                "teaching",
                self._teaching,
            ),
        )

    def _motion(self) -> QWidget:
        return MotionPanel(self._controller, self._preferences.settings.jog_step_deg)

    def _cartesian(self) -> QWidget:
        from armui.ui.panels.jogging.cartesian_panel import CartesianPanel

        return CartesianPanel(self._controller, self._preferences)

    def _light(self) -> QWidget:
        from armui.ui.panels.light.light_panel import LightPanel

        return LightPanel(self._controller)

    def _linkage(self) -> QWidget:
        from armui.ui.panels.linkage_panel import LinkagePanel

        return LinkagePanel(self._controller)

    def _joint_settings(self) -> QWidget:
        from armui.ui.panels.parameters.joint_settings_panel import JointSettingsPanel

        return JointSettingsPanel(self._controller, self._open_backup)

    def _end_limits(self) -> QWidget:
        from armui.ui.panels.parameters.end_limits_panel import EndLimitsPanel

        return EndLimitsPanel(self._controller, self._open_backup)

    def _collision(self) -> QWidget:
        from armui.ui.panels.parameters.collision_panel import CollisionPanel

        return CollisionPanel(self._controller, self._open_backup)

    def _motor(self) -> QWidget:
        from armui.ui.panels.motors.motor_panel import MotorPanel

        return MotorPanel(self._controller)

    def _gripper(self) -> QWidget:
        from armui.ui.panels.gripper.gripper_panel import GripperPanel

        return GripperPanel(self._controller)

    def _gripper_settings(self) -> QWidget:
        from armui.ui.panels.parameters.gripper_settings_panel import GripperSettingsPanel

        return GripperSettingsPanel(self._controller, self._open_backup)

    def _end_load(self) -> QWidget:
        from armui.ui.panels.parameters.end_load_panel import EndLoadPanel

        return EndLoadPanel(self._controller)

    def _teaching(self) -> QWidget:
        from armui.ui.panels.teaching.teaching_panel import TeachingPanel

        return TeachingPanel(self._controller)
