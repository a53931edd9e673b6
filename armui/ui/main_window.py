"""The main window: the regions of the manual's figure 1-1, and the connections between them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QRect, QSize
from PySide6.QtGui import QCloseEvent, QContextMenuEvent, QShowEvent
from PySide6.QtWidgets import QWidget

from armui.arm.state import ArmState
from armui.control.devices.joint_monitor import JointMonitor
from armui.control.operating_state import OperatingState, StopState
from armui.ui.actions.command import CommandSource, Offering, source_of
from armui.ui.actions.operator_view import set_operator_view
from armui.ui.actions.window_actions import WindowActions
from armui.ui.background import Background
from armui.ui.gamepad.gamepad_strip import GamepadStrip
from armui.ui.interface.client_question import ClientQuestions
from armui.ui.interface.interface_mark import InterfaceMark, LiveMark
from armui.ui.interface.lease_bar import LeaseBar
from armui.ui.panels.jogging.motion_panel import MotionPanel
from armui.ui.picture.picture_work import PictureWork
from armui.ui.shell.drawer import Drawer
from armui.ui.shell.layout_keeper import LayoutKeeper
from armui.ui.shell.leaving import (
    close_unless_moving,
    end_motion_then,
    gives_way,
    is_taught,
    leave_then,
    unsaved,
)
from armui.ui.shell.operation_area import OperationArea, menu_entries
from armui.ui.shell.page_actions import PageActions
from armui.ui.shell.page_area import PageArea
from armui.ui.shell.page_entry import Home
from armui.ui.shell.page_opener import PageOpener
from armui.ui.shell.pages import PAGES, PLACES
from armui.ui.shell.recovery_line import RecoveryLine
from armui.ui.shell.robot_in_view import RobotInView, show_in_view
from armui.ui.shell.side_menu import (
    JointStatusButton,
    LibraryButton,
    MenuFoot,
    SideMenu,
    UnlockButton,
    WatchMenu,
)
from armui.ui.shell.status_bar import FailureLine, ModelMark, StatusBar
from armui.ui.shell.step_row import StepRow
from armui.ui.shell.top_bar import TopBar
from armui.ui.shell.trajectory_pages import TrajectoryPages
from armui.ui.shell.view_region import ViewRegion
from armui.ui.shell.work_area import WindowLayout, WorkArea, WorkColumn
from armui.ui.shell.workspace import Workspace
from armui.ui.theme import DARK, colors_of
from armui.ui.trajectory.preview.path_preview import PathPreview
from armui.ui.trajectory.preview.preview_bar import PreviewBar
from armui.ui.widgets.curve_menu import offer_curves
from armui.ui.widgets.keeps_focus import KeepsFocus
from armui.ui.widgets.layouts import in_column, in_row
from armui.ui.widgets.page import StackArea
from armui.ui.widgets.translated import Translated
from armui.viewport import palette as scene_palette

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from armui.arm.refusal import Refusal
    from armui.control.arm_controller import ArmController
    from armui.interface.interface import Interface
    from armui.live.live_stream import LiveStream
    from armui.setting_fields import Settings
    from armui.settings import SettingsStore
    from armui.system.failures import Failure
    from armui.ui.picture.target_drag import HandGuide
    from armui.viewport.view import ArmView

_FIRST_SIZE: Final = QSize(1440, 900)


class MainWindow(Translated, KeepsFocus, QWidget):
    """Shows the arm and receives the operator's commands; it has no access to the bus.

    Args:
        controller: The controller of the arm.
        view: The 3D picture.
        preferences: The operator's settings; changes take effect at once.
        workers: Runs long work.
        files: Runs work that waits for a disk, in a thread of this process; by default the workers.
        trajectories: The folder of the library; the user's own by default.
        hand: Gives access to the hand at the simulated arm of this program; by default
            none.
        interface: The local interface.
        live: The live stream.

    Attributes:
        window_actions: Opens the command palette, and collects its commands.
        pages: Opens pages and windows by their keys.
        page_actions: The actions on pages.
    """

    def __init__(
        self,
        controller: ArmController,
        view: ArmView,
        preferences: SettingsStore,
        workers: Executor,
        trajectories: Path | None = None,
        *,
        files: Executor | None = None,
        hand: Callable[[], HandGuide | None] = lambda: None,
        interface: Interface,
        live: LiveStream,
    ) -> None:
        super().__init__()
        self._controller = controller
        self._interface = interface
        self._view = view
        self._preferences = preferences
        self._settings = preferences.settings
        self._may_close = False
        self._entries = menu_entries(controller, preferences, self._opening("backup"))
        self._robot = RobotInView(view, controller, self._settings.urdf_path, self)
        self._joint_monitor = JointMonitor(controller, parent=self)
        background = self._background = Background(workers, files, self)
        self._keeper = LayoutKeeper(preferences.path, background, self)
        bar = partial(LeaseBar, interface, controller)
        self._workspace = Workspace(controller, self._keeper, self, bar)
        self._joint_status_button = JointStatusButton(self._joint_monitor)
        self._preview_bar = PreviewBar()
        self._preview = PathPreview(view, self._preview_bar, self)
        self._picture = PictureWork(
            controller,
            view,
            preferences,
            background,
            preview=self._preview,
            window=self,
            hand=hand,
        )
        self._view_region = ViewRegion(view, self._preview_bar, self._picture)
        self._page_area = PageArea()
        self._drawer = Drawer({k: page for k, page in PAGES.items() if page.home is Home.DRAWER})
        for home in (self._page_area, self._drawer):
            home.take_out_wanted.connect(self._workspace.take_out)
        self._trajectory_pages = TrajectoryPages(
            controller,
            self._workspace,
            self._page_area,
            preferences=preferences,
            workers=workers,
            files=files,
            folder=trajectories,
            preview=self._preview,
            picture=self._picture,
            parent=self,
        )
        self._status_bar = StatusBar(controller)
        self.pages = PageOpener(
            *(self, controller),
            pages=PAGES,
            view=view,
            joint_monitor=self._joint_monitor,
            preferences=preferences,
            background=background,
            workspace=self._workspace,
            drawer=self._drawer,
            trajectories=self._trajectory_pages,
            files=files or workers,
            leave_arm_then=self._leave_arm_then,
            hand=hand,
            interface=interface,
        )
        self.pages.show_marks_in(self._status_bar)
        self.window_actions = WindowActions(self, controller, preferences, background)
        self._status_bar.add_mark(ModelMark(controller, self._opening("connect")))
        self._status_bar.add_mark(InterfaceMark(interface, self._opening("interface")))
        self._status_bar.add_mark(LiveMark(live, self._opening("settings")))
        self._questions = ClientQuestions(interface, controller, self)
        self.page_actions = PageActions(self, self._workspace, self.pages, self._drawer)
        self._status_bar.add_mark(self.window_actions.language_button)
        self._status_bar.add_mark(self.window_actions.button)
        self._lay_out()
        self._connect()
        WindowLayout(self._keeper, self, self._work_column, _FIRST_SIZE)
        self.retranslate_ui()
        self._recolor()

    # -- layout -------------------------------------------------------------------------------

    def _lay_out(self) -> None:
        self._library_button = LibraryButton()
        watch_menu = WatchMenu({key: page for key, page in PAGES.items() if page.beside_menu})
        for tabs in (watch_menu, self._drawer):
            tabs.page_wanted.connect(self.pages.show)
        set_operator_view(wanted=self._keeper.layout.operator_view)
        self._foot, self._unlock = MenuFoot(), UnlockButton(self._controller)
        self._menu = SideMenu(
            self._entries,
            library=self._library_button,
            watch=watch_menu,
            joint_status=self._joint_status_button,
            foot=self._foot,
            unlock=self._unlock,
            folded=self._keeper.layout.menu_folded,
        )
        self._menu.folded_by_hand.connect(self._on_menu_folded)
        self._panels = OperationArea(self._entries)
        self._failure_line = FailureLine()
        picture = QWidget()
        in_column((self._view_region, 1), self._failure_line, on=picture, spacing=0, margins=0)
        self._work_area = WorkArea(StackArea(self._panels), self._page_area, picture)
        self._work_column = WorkColumn(self._work_area, self._drawer)

        top = TopBar(self._controller, self._opening("connect"), self._joint_monitor)
        recovery = RecoveryLine(
            self._controller, self._opening("connect"), self._opening("reference")
        )
        recovery.stand_back_for(self._work_area)
        run = self._run = StepRow(self._controller, recovery)
        self._trajectory_pages.run_asks.connect(recovery.show_asking)
        self.window_actions.link(
            *(recovery, run, self.pages),
            buttons={
                "library.open": self._library_button,
                "window.joint_status": self._joint_status_button,
            },
            lock=lambda: self._lock(wanted=True),
        )
        lease = LeaseBar(self._interface, self._controller)
        parts = (top, self.window_actions, watch_menu, self._foot, self._picture.bar)
        self._offer((*parts, self._preview_bar, self._menu, lease))
        gamepad = GamepadStrip(self._controller, self._preferences)
        work = in_column(run, gamepad, (self._work_column, 1), spacing=0)
        middle = (in_row(self._menu, (work, 1), spacing=0), 1)
        in_column(top, lease, middle, self._status_bar, on=self, spacing=0, margins=0)
        self.setFocus()  # no control has the focus at first: a key could press it by mistake

    def _offer(self, parts: Iterable[Offering]) -> None:
        """Pass the commands of all parts to the palette, the list of shortcuts and the guide."""

        def sources() -> list[CommandSource]:
            # loaded in idle time, or here if it is needed before
            from armui.ui.trajectory.running.run_strip import RunStrip  # noqa: PLC0415

            return [
                *map(source_of, parts),
                *self._panels.sources(self._menu.open_entry),
                *self.page_actions.sources(),
                CommandSource(RunStrip.commands, lambda: self._run.strip),
            ]

        panels = {entry.key: entry.title for entry in self._entries}
        self.window_actions.offer(
            sources,
            {**PLACES, **panels},
            lambda: ((self._page_area.current, self._drawer.current), self._panels.current_key),
        )

    def _connect(self) -> None:
        self._menu.chosen.connect(self._on_entry_chosen)
        self._joint_status_button.clicked.connect(self._opening("joint_status"))
        self._library_button.clicked.connect(self.open_library_window)
        self._library_button.clicked.connect(self._show_where)
        self._work_area.turned.connect(self._show_where)
        self._unlock.held.connect(lambda: self._lock(wanted=False))
        self._foot.help.clicked.connect(lambda: self.pages.open_guide("view"))
        self._foot.reset_view.clicked.connect(self._view.reset_view)
        self._foot.settings.clicked.connect(self._opening("settings"))
        self._picture.follow_panels(self._panels.currentWidget)
        self._view.joint_picked.connect(self._panels.focus_joint)
        self._view.load_failed.connect(self._status_bar.show_problem)
        self._status_bar.event_wanted.connect(self.pages.show_events)
        self._controller.state_changed.connect(self._show_in_view)
        self._controller.cell_changed.connect(self._on_cell_changed)
        self._controller.operating_state_changed.connect(self._on_operating_state_changed)
        self._unsubscribe = self._preferences.subscribe(self._on_settings_changed)

    # -- panels -------------------------------------------------------------------------------

    def _on_entry_chosen(self, place: int) -> None:
        """Switch the operation area; if entries would be lost, the operator is asked first."""
        self._show_where()
        left = [] if place == self._panels.currentIndex() else [self._panels.currentWidget()]
        leave_then(self, self._controller, left, lambda: self._show_panel(place))

    def _on_menu_folded(self, folded: bool) -> None:
        self._keeper.layout = replace(self._keeper.layout, menu_folded=folded)
        self._keeper.note()

    def _lock(self, *, wanted: bool) -> None:
        """Enter or leave the operator's view, and store that; a panel of settings is left."""
        set_operator_view(wanted=wanted)
        self._keeper.layout = replace(self._keeper.layout, operator_view=wanted)
        self._keeper.note()
        if wanted and self._menu.shows_setting:
            self._menu.open_entry(self._entries[0].key)

    def _show_panel(self, place: int) -> None:
        self._panels.show_panel(place)
        self._work_area.show_panels()
        self._show_where()

    def _show_where(self) -> None:
        """Mark what is shown beside the picture: an entry of the menu, or the library's button."""
        pages = self._work_area.shows_pages
        self._menu.choose(None if pages else self._panels.currentIndex())
        self._library_button.setChecked(pages)

    def _leave_arm_then(self, asking: QWidget, proceed: Callable[[], object]) -> None:
        """Leave the arm or the program; first ask about unsaved entries and motion under way."""
        leave_then(
            asking,
            self._controller,
            self._panels.panels,
            lambda: end_motion_then(asking, self._controller, proceed),
        )

    # -- the arm in 3D ------------------------------------------------------------------------

    def _on_operating_state_changed(self, operating_state: OperatingState) -> None:
        self._library_button.show_recording(recording=operating_state.recording)
        self._show_in_view(self._controller.state)

    def _on_cell_changed(self, _cell: object) -> None:
        self._show_in_view(self._controller.state)

    def _show_in_view(self, state: ArmState) -> None:
        if self.isVisible():
            controller = self._controller
            seen = self._view.isVisible() and not self._view.has_given_up
            self._panels.show_measured_figures(wanted=not seen)
            show_in_view(
                *(self._view, state, controller.operating_state, controller.cartesian.tool),
                calibrated=lambda gripper: controller.gripper.shown(gripper),  # noqa: PLW0108
                frame=controller.cartesian.frame,
            )

    def _recolor(self) -> None:
        dark = colors_of(self) is DARK
        self._view.set_theme(scene_palette.DARK if dark else scene_palette.LIGHT)

    # -- settings and pages -------------------------------------------------------------------

    def _on_settings_changed(self, settings: Settings) -> None:
        old, self._settings = self._settings, settings
        if old.jog_step_deg != settings.jog_step_deg:
            for panel in self._panels.panels:
                if isinstance(panel, MotionPanel):
                    panel.set_jog_step(settings.jog_step_deg)
        if old.urdf_path != settings.urdf_path:
            self._robot.choose(settings.urdf_path)

    def _opening(self, key: str) -> Callable[[], None]:
        """Return a function that shows a page or window."""
        return lambda: self.pages.show(key)

    def open_library_window(self) -> None:
        """Show 轨迹库 (manual 1.0.9): the last page, or the library if that page is visible."""
        if self._work_area.shows_pages or self._page_area.current is None:
            self._trajectory_pages.open_library()
        else:
            self._work_area.show_pages()

    def show_as_curves(self, keys: Sequence[str]) -> None:
        """Show quantities in the page 曲线, by their keys (`armui.telemetry.quantities`)."""
        self.pages.show_as_curves(keys)

    def show_failure(self, failure: Failure, *, motion_ended: bool) -> None:
        """Show that an unexpected error has happened in the program."""
        self._failure_line.show_failure(failure, motion_ended=motion_ended)

    def show_problem(self, reason: Refusal) -> None:
        """Show a problem of the program in the status bar."""
        self._status_bar.show_problem(reason)

    def room_for_questions(self) -> QRect:
        """Return the area for small windows: over the panel or page, beside picture and stops."""
        return self._work_area.left_of_picture()

    # -- window -------------------------------------------------------------------------------

    def retranslate_ui(self) -> None:
        """Set the title in the operator's language."""
        self.setWindowTitle(self.tr("armui – PiPER arm"))
        self._view.setAccessibleName(self.tr("3D view of the arm"))

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Offer to show the figure as a curve."""
        offer_curves(self, event)

    def showEvent(self, event: QShowEvent) -> None:
        """Update the picture, which was not updated while the window was hidden."""
        super().showEvent(event)
        self._show_in_view(self._controller.state)

    def keep_drafts(self) -> None:
        """Save unsaved trajectories as drafts; the program may go on."""
        self._trajectory_pages.keep_drafts()

    def keep_work(self) -> None:
        """Save all unsaved work without asking, to be offered at the next start."""
        self._trajectory_pages.keep_work()
        self._keeper.keep()

    def closeEvent(self, event: QCloseEvent) -> None:
        """Ask first if there is unsaved or running work, or the arm moves by itself."""
        operating_state = self._controller.operating_state
        stopping = operating_state.stop is StopState.REQUESTED
        under_way = operating_state.moving or stopping or operating_state.occupied is not None
        under_way |= gives_way(operating_state)
        at_stake = under_way or is_taught(self._controller) or unsaved(self._panels.panels)
        if at_stake and not self._may_close:
            event.ignore()  # questions do not block: `_close_now` closes again after the answers
            close = partial(close_unless_moving, self, self._controller, self._close_now)
            self._leave_arm_then(self, close)
            return
        self._unsubscribe()
        self.keep_work()
        self._workspace.close_windows()
        self.pages.close()
        super().closeEvent(event)

    def _close_now(self) -> None:
        self._may_close = True
        self.close()
