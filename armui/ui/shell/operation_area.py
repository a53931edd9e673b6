"""The panels of the menu, each created when it is first shown (region 7)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Final, Protocol, runtime_checkable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QStackedWidget, QWidget

from armui.ui.actions.command import CommandSource, also
from armui.ui.panels.cell.cell_panel import CellPanel
from armui.ui.panels.gripper_panel import GripperPanel
from armui.ui.panels.jogging.cartesian_panel import CartesianPanel
from armui.ui.panels.jogging.jog_panel import JogPanel
from armui.ui.panels.jogging.motion_panel import MotionPanel
from armui.ui.panels.light_panel import LightPanel
from armui.ui.panels.linkage_panel import LinkagePanel
from armui.ui.panels.motor_panel import MotorPanel
from armui.ui.panels.panel import Panel
from armui.ui.panels.parameters.end_load_panel import EndLoadPanel
from armui.ui.panels.parameters.figure_panels import (
    EndLimitsPanel,
    GripperSettingsPanel,
    JointSettingsPanel,
)
from armui.ui.panels.parameters.levels_panel import CollisionPanel
from armui.ui.panels.teaching_panel import TeachingPanel
from armui.ui.shell.side_menu import MenuEntry, MenuGroup
from armui.ui.words.text import Text

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.settings import SettingsStore


MakePanel = Callable[["ArmController", "SettingsStore", Callable[[], object]], Panel]
"""Creates a panel from a controller, the settings, and a function that opens 参数备份."""


@dataclass(frozen=True, slots=True)
class PanelEntry:
    """A panel in the menu.

    Attributes:
        key: Its stable name, also of its icon, of its section in the guide and of its commands.
        title: The title in the menu.
        kind: The class, which declares its commands.
        make: Creates it.
        synonyms: Other names of it, for the command palette.
        group: The heading of the menu above it.
    """

    key: str
    title: Text
    kind: type[Panel]
    make: MakePanel
    synonyms: tuple[str, ...] = ()
    group: MenuGroup = MenuGroup.OPERATE


# fmt: off
PANELS: Final = (
    PanelEntry("motion", Text("SideMenu", "Motion control"), MotionPanel,
               lambda arm, store, _: MotionPanel(arm, store)),
    PanelEntry("cartesian", Text("SideMenu", "Cartesian"), CartesianPanel,
               lambda arm, store, _: CartesianPanel(arm, store),
               also("tool control tcp pose linear xyz 位姿 直线")),
    PanelEntry("gripper", Text("SideMenu", "Gripper control"), GripperPanel,
               lambda arm, _store, _: GripperPanel(arm),
               also("torque force 力矩 抓手 夹具")),
    PanelEntry("teaching", Text("SideMenu", "Drag teaching"), TeachingPanel,
               lambda arm, _store, open_backup: TeachingPanel(arm, open_backup),
               also("freedrive free drive hand guide lead through 拖拽")),
    PanelEntry("cell", Text("SideMenu", "Cell"), CellPanel,
               lambda arm, store, _: CellPanel(arm, store),
               also("tool tcp frame work area zone box table safety fence calibrate "
                    "工具 坐标系 工作区 桌子 禁区 围栏 安全 标定")),
    PanelEntry("light", Text("SideMenu", "Light control"), LightPanel,
               lambda arm, _store, _: LightPanel(arm),
               also("led lamp color colour"),
               group=MenuGroup.SETTINGS),
    PanelEntry("linkage", Text("SideMenu", "Linkage control"), LinkagePanel,
               lambda arm, _store, _: LinkagePanel(arm),
               also("master slave leader follower 主从"),
               group=MenuGroup.SETTINGS),
    PanelEntry("joint_settings", Text("SideMenu", "Joint settings"), JointSettingsPanel,
               lambda arm, _store, open_backup: JointSettingsPanel(arm, open_backup),
               also("limits maximum minimum 限位 极限"),
               group=MenuGroup.SETTINGS),
    PanelEntry("end_limits", Text("SideMenu", "End speed limits"), EndLimitsPanel,
               lambda arm, _store, open_backup: EndLimitsPanel(arm, open_backup),
               group=MenuGroup.SETTINGS),
    PanelEntry("collision", Text("SideMenu", "Collision level"), CollisionPanel,
               lambda arm, _store, open_backup: CollisionPanel(arm, open_backup),
               also("protection crash sensitivity 碰撞 灵敏度"),
               group=MenuGroup.SETTINGS),
    PanelEntry("motor", Text("SideMenu", "Motor settings"), MotorPanel,
               lambda arm, _store, _: MotorPanel(arm),
               group=MenuGroup.SETTINGS),
    PanelEntry("gripper_settings", Text("SideMenu", "Gripper settings"), GripperSettingsPanel,
               lambda arm, _store, open_backup: GripperSettingsPanel(arm, open_backup),
               group=MenuGroup.SETTINGS),
    PanelEntry("end_load", Text("SideMenu", "End load"), EndLoadPanel,
               lambda arm, store, _: EndLoadPanel(arm, store),
               also("payload mass weight 重量"),
               group=MenuGroup.SETTINGS),
)
# fmt: on
"""The panels from top to bottom of the menu, in each group in the manual's order as far as it has
them.
"""


def menu_entries(
    controller: ArmController, preferences: SettingsStore, open_backup: Callable[[], object]
) -> tuple[MenuEntry, ...]:
    """Return the entries of the menu from top to bottom.

    Args:
        controller: The controller for the panels.
        preferences: The operator's settings.
        open_backup: Opens the window 参数备份.
    """
    return tuple(
        MenuEntry(
            *(panel.key, panel.title),
            make_panel=partial(panel.make, controller, preferences, open_backup),
            commands=panel.kind.commands,
            synonyms=panel.synonyms,
            group=panel.group,
        )
        for panel in PANELS
    )


@runtime_checkable
class ShowsJoints(Protocol):
    """A panel with controls for each joint."""

    def focus_joint(self, joint: int) -> None:
        """Focus the controls of a joint."""


class OperationArea(QStackedWidget):
    """Holds the panels that have been shown, and empty pages for the others.

    Args:
        entries: The panels, in the order of the menu.
    """

    def __init__(self, entries: Sequence[MenuEntry]) -> None:
        super().__init__()
        self.setObjectName("operation_area")
        self._entries = tuple(entries)
        self._made: dict[int, QWidget] = {}
        self._with_measured = True
        self._empty = {place: QWidget() for place in range(len(self._entries))}
        for page in self._empty.values():
            self.addWidget(page)
        self.show_panel(0)

    @property
    def current_key(self) -> str:
        """The key of the chosen panel."""
        return self._entries[self.currentIndex()].key

    def panel(self, key: str) -> Panel | None:
        """Return a panel by its key, or ``None`` if it has not been shown yet."""
        keys = [entry.key for entry in self._entries]
        panel = self._made.get(keys.index(key))
        return panel if isinstance(panel, Panel) else None

    def sources(self, open_panel: Callable[[str], object]) -> list[CommandSource]:
        """Return the commands of each panel.

        Args:
            open_panel: Opens a panel by its key, after asking about unsaved entries.
        """
        return [
            CommandSource(
                entry.commands,
                partial(self.panel, entry.key),
                partial(open_panel, entry.key),
                asks_first=True,
            )
            for entry in self._entries
        ]

    @property
    def panels(self) -> list[QWidget]:
        """The panels that have been shown, in the order of the menu."""
        return [self._made[place] for place in sorted(self._made)]

    def show_panel(self, place: int) -> None:
        """Show a panel, creating it the first time."""
        if place not in self._made:
            empty = self._empty.pop(place)
            panel = self._made[place] = self._entries[place].make_panel()
            self._show_measured_in(panel)
            self.insertWidget(place, panel)
            self.removeWidget(empty)
            empty.deleteLater()
        shown, focused = self.widget(place), QApplication.focusWidget()
        had = focused is not None and self.isAncestorOf(focused)
        new = shown is not None and shown.focusWidget() is None
        self.setCurrentIndex(place)
        if had and new and shown is not None:
            # Qt has focused the first control of the panel, and its frame would look like a choice
            shown.setFocus(Qt.FocusReason.OtherFocusReason)

    def show_measured_figures(self, *, wanted: bool) -> None:
        """Show the measured values in the panels that jog: the picture has none now."""
        if wanted != self._with_measured:
            self._with_measured = wanted
            for panel in self._made.values():
                self._show_measured_in(panel)

    def _show_measured_in(self, panel: QWidget) -> None:
        if isinstance(panel, JogPanel):
            panel.show_measured_figures(wanted=self._with_measured)

    def focus_joint(self, joint: int) -> None:
        """Focus a joint in the visible panel, if it has controls for one."""
        panel: object = self.currentWidget()
        if isinstance(panel, ShowsJoints):
            panel.focus_joint(joint)
