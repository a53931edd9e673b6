"""Creates the program's objects and connects them; no other module does."""

from __future__ import annotations

import gc
import importlib
import logging
import os
import pkgutil
import sys
import threading
from collections.abc import Callable, Collection, Iterator, Sequence
from contextlib import AbstractContextManager
from dataclasses import replace
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication, QEvent, QLocale, QObject, QTimer, Signal
from PySide6.QtWidgets import QApplication, QWidget

from armui import __version__
from armui.arm.device import DEFAULT_BITRATE, Device, bitrate_is_ours
from armui.arm.refusal import Refusal
from armui.control.arm_controller import ArmController
from armui.control.cell.cell_keeper import CellKeeper
from armui.control.event_log.keeper import EventKeeper
from armui.control.events import Event, Notice
from armui.control.link.instance_registry import InstanceRegistry
from armui.control.link.link_state import LinkState
from armui.control.operating_state import OperatingState
from armui.control.safety.kept_references import KeptReferences
from armui.control.sessions.choices import choices_of
from armui.ending import SystemEnd
from armui.interface.interface import Interface, Shelf
from armui.live.live_stream import LiveStream
from armui.protocol.generation import PiperModel
from armui.setting_fields import Settings
from armui.settings import SettingsStore, default_path
from armui.simulated_arms import SIMULATED, SimulatedArms
from armui.start import StartOptions
from armui.system import failures, paths
from armui.system.clock import steady_s
from armui.system.exact_timers import keep_timers
from armui.system.failures import Failure, FailureHandler
from armui.system.helper_process import FileThread, HelperProcess
from armui.system.kept_folders import ClosedFolder, closed_folders
from armui.system.log_file import log_to
from armui.system.plain_words import language_of_system
from armui.system.thread_priority import raise_in_background
from armui.system.version_record import TakenOver, note_version
from armui.telemetry.events import EventKind, Level
from armui.ui.background import Background
from armui.ui.dialogs.kept_models import KeptModels, NodeKeeper, last_model
from armui.ui.garbage import GarbageSearch
from armui.ui.main_window import MainWindow
from armui.ui.shell.trajectory_pages import open_library
from armui.ui.theme import Theme, apply_theme, make_application
from armui.ui.translation import Translator
from armui.ui.widgets.icons import load_all as load_icons
from armui.ui.widgets.stop_shortcut import StopShortcut
from armui.viewport.view import ArmView

if TYPE_CHECKING:
    from concurrent.futures import Executor, Future

    import can

    from armui.ui.picture.target_drag import HandGuide
    from armui.viewport.client import PictureClient

FILES_HANG = Notice(
    "files_hang",
    "A disk or network folder has spent more than 10 s on one file. Other files no longer "
    "wait for it. If it does not finish, check the cable or network. (Under way: {count})",
    Level.WARNING,
    EventKind.PROGRAM,
)
SETTINGS_UNSAVED = Notice(
    "settings_unsaved",
    "The change is in effect, but not saved. {reason}",
    Level.WARNING,
    EventKind.PROGRAM,
)
FOLDERS_CLOSED = Notice(
    "folders_closed",
    "Nothing is kept in these folders: {folders}. Let this user write there; Diagnosis gives the "
    "command.",
    Level.WARNING,
    EventKind.PROGRAM,
)

_LOG: Final = logging.getLogger(__name__)

DRIVE_NOTHING: Final = (
    "armui.bus.notifier",
    "armui.cell",
    "armui.session",
    "armui.settings",
    "armui.system",
    "armui.telemetry",
    "armui.trajectory",
    "armui.ui.dialogs.finding_row",
    "armui.ui.format",
    "armui.ui.garbage",
    "armui.ui.guide.guide_browser",
    "armui.ui.guide.place",
    "armui.ui.guide.text",
    "armui.ui.shell.layout_keeper",
    "armui.ui.shell.workspace_layout",
    "armui.ui.theme",
    "armui.ui.translation",
    "armui.ui.watch.bus.cells",
    "armui.ui.watch.cursor_table",
    "armui.ui.watch.curve_cache",
    "armui.ui.watch.curve_shapes",
    "armui.ui.watch.curves_item",
    "armui.ui.watch.figure",
    "armui.ui.watch.graph",
    "armui.ui.watch.layout_file",
    "armui.ui.watch.plot_bar",
    "armui.ui.watch.plot_board",
    "armui.ui.watch.plot_layout",
    "armui.ui.watch.plot_pane",
    "armui.ui.watch.quantity_list",
    "armui.ui.watch.round_figures",
    "armui.ui.watch.time_axis",
    "armui.ui.watch.time_frame",
    "armui.ui.watch.value_table",
    "armui.viewport",
    "armui.ways",
)
"""Modules, with those inside them, that can neither reach the bus nor affect a held jog.

A contract in pyproject.toml names the same modules, and import-linter checks it.
"""

_SWITCH_INTERVAL_S: Final = 0.0005
"""The time for which a thread may keep Python's lock while another wants it. With the default of 5
ms a pressed stop would wait for the bus thread and for the simulated arm's.
"""

_CONNECTED_MS: Final = 5000
"""By this time after the start a first connection has loaded its libraries."""
_PAINTED_MS: Final = 3000
_THREADS_BEGUN_MS: Final = 500
"""By this time after a device was opened its threads have begun, and can be raised."""
_LOOK_AT_FILES_MS: Final = 1000
"""Disks that hang, and settings changed by other programs, are noticed within this time."""

_LATE_ROOMS: Final = (
    "arm",
    "cell",
    "kinematics",
    "protocol",
    "session.recording",
    "telemetry",
    "trajectory",
    "ways",
    "bus",
    "control",
    "interface",
    "ui",
)
"""The packages with modules that a page imports when it is opened."""


def may_drive(modules: Collection[str]) -> bool:
    """Return whether a failure may leave the arm moving, by the modules in its traceback.

    A traceback without a module of ours counts as such: a slot called with wrong arguments leaves
    none.
    """
    rooms = tuple(f"{room}." for room in DRIVE_NOTHING)
    return not modules or not all(f"{name}.".startswith(rooms) for name in modules)


class _FailureRelay(QObject):
    """Carries what fails from the threads where it happens to the window's."""

    failed = Signal(object)
    unsaved = Signal(object)
    closed = Signal(object)


class Program:
    """All objects of one running program.

    Args:
        app: Qt's application.
        store: The operator's settings.
        controller: The controller of the arm.
        workers: Runs long work; ended with the program.
        trajectories: The folder of the library; the user's own by default.
        pictures: Has the 3D picture drawn, and is ended by its owner; one of the program's own by
            default.
        meeting_place: The folder in which running copies of the program find each other; by default
            none.
        files: Runs work that waits for a disk, in a thread of this process; ended with the program.
            By default the workers.
        events: The folder of the event log; by default none.
        hand: Gives access to the hand that leads the simulated arm of this program; by default
            none.
        clock: Monotonic time in seconds, the controller's.
        socket: The socket of the local interface; the user's own by default.
        for_clients: Runs the checks of clients, so that those of the operator never wait; by
            default the workers.

    Attributes:
        controller, view, window, interface, live: Its main objects.
        ended: True if, after `shutdown`, no thread of ours runs any more.
        closed: Set when the device is closed, as far as its driver lets it.
    """

    def __init__(
        self,
        app: QApplication,
        store: SettingsStore,
        controller: ArmController,
        workers: Executor,
        trajectories: Path | None = None,
        *,
        pictures: PictureClient | None = None,
        meeting_place: Path | None = None,
        files: Executor | None = None,
        events: Path | None = None,
        hand: Callable[[], HandGuide | None] = lambda: None,
        clock: Callable[[], float] = steady_s,
        socket: Path | None = None,
        for_clients: Executor | None = None,
    ) -> None:
        self._app, self._store = app, store
        self._translator = Translator(app)
        self._settings = settings = store.settings
        self._translator.set_language(settings.language)
        apply_theme(app, Theme(settings.theme), before_windows=True)
        self.controller = controller
        self.ended = self._is_down = False
        self.closed = threading.Event()
        self._workers, self._files, self._for_clients = workers, files, for_clients or workers
        urdf = Path(settings.urdf_path) if settings.urdf_path else None
        self.view = ArmView(urdf, client=pictures)
        folder = trajectories or paths.trajectories()
        self.interface = Interface(
            *(controller, socket or paths.runtime() / "api.sock", clock),
            shelf=Shelf(Background(self._for_clients, files), partial(open_library, folder, files)),
        )
        self.live = LiveStream(controller, clock)
        self.window = MainWindow(
            *(self.controller, self.view, store, workers, trajectories),
            files=files,
            hand=hand,
            interface=self.interface,
            live=self.live,
        )
        apply_theme(app, Theme(settings.theme))
        self._stop_shortcut = StopShortcut(app, self.controller, self.window)
        controller.stop_again_when_undone(settings.stop_again)
        controller.jog_floor.lowest_mm = settings.jog_floor_mm
        controller.model_watch.assume(last_model(settings.models))
        self._node_keeper = NodeKeeper(controller, KeptModels(store))
        controller.cell.use_own_tool(settings.tool)
        self._cell_keeper = CellKeeper(
            *(store, folder, files or workers),
            loaded=controller.cell.take_loaded,
            not_renamed=controller.cell.give_name,
            problem=controller.cell.report_problem,
        )
        controller.cell.store = self._cell_keeper
        self._cell_keeper.load()
        controller.session_choices = lambda: choices_of(store.settings)
        controller.reference_memory = KeptReferences(store)
        self._unsubscribe = store.subscribe(self._on_settings_changed)
        self._relay = _FailureRelay()
        self._relay.failed.connect(self._on_failed)
        self._relay.unsaved.connect(self._on_unsaved)
        if files is not None:
            store.write_by(files, self._relay.unsaved.emit)
        if isinstance(files, FileThread):
            timer = QTimer(self._relay, interval=_LOOK_AT_FILES_MS)
            timer.timeout.connect(partial(self._replace_hung, files))
            timer.timeout.connect(store.follow)
            timer.start()
        self._failure_handler = FailureHandler(self._relay.failed.emit)
        for name in failures.LOGGERS:
            logging.getLogger(name).addHandler(self._failure_handler)
        self._event_keeper: EventKeeper | None = None
        self._instances: InstanceRegistry | None = None
        # called by the event loop, once the window is built
        QTimer.singleShot(0, self._relay, self._switch_served)
        if events is not None:
            keep = partial(self._keep_events, events, files or workers)
            QTimer.singleShot(0, self._relay, keep)
        if meeting_place is not None:
            register = partial(self._register_instance, store.path, meeting_place)
            QTimer.singleShot(0, self._relay, register)
        for problem in store.problems:
            self.window.show_problem(problem)

    @property
    def unwritten(self) -> Sequence[str]:
        """The names of the functions that still wait for a disk."""
        return self._files.waiting if isinstance(self._files, FileThread) else ()

    def note_version(self, trajectories: Path) -> None:
        """Have the file thread note which version uses the user's files, and what it takes over."""
        settings = self._store.settings
        sessions = Path(settings.session_folder) if settings.session_folder else paths.sessions()
        places = {"trajectories": trajectories, "sessions": sessions}
        now = datetime.now().astimezone()
        noted = (self._files or self._workers).submit(
            note_version, __version__, self._store.path, places, now, nested={"trajectories"}
        )
        noted.add_done_callback(_log_unnoted)

    def check_folders(self) -> None:
        """Report once to the operator which folders cannot be written; the file thread checks."""

        def on_checked(looked: Future[tuple[ClosedFolder, ...]]) -> None:
            if not looked.cancelled() and looked.exception() is None and looked.result():
                self._relay.closed.emit(looked.result())

        self._relay.closed.connect(self._on_closed)
        (self._files or self._workers).submit(closed_folders).add_done_callback(on_checked)

    def _keep_events(self, folder: Path, files: Executor) -> None:
        self._event_keeper = EventKeeper(self.controller.event_collector, folder, files)

    def _switch_served(self) -> None:
        if not self._is_down:
            now = self._store.settings
            self.interface.switch(on=now.interface)
            self.live.switch(on=now.live, port=now.live_port, for_others=now.live_for_others)

    def _register_instance(self, settings: Path, place: Path) -> None:
        self._instances = InstanceRegistry(self.controller, settings, place)

    def shutdown(self) -> None:
        """End the motion and every thread.

        A driver may keep a thread of ours beyond the limit: see `ended`.
        """
        if self._is_down:
            return
        self._is_down = True
        self._unsubscribe()
        for name in failures.LOGGERS:
            logging.getLogger(name).removeHandler(self._failure_handler)
        self._app.removeEventFilter(self._stop_shortcut)
        self._stop_shortcut.deleteLater()
        # before the controller, so that no client begins anything while it ends
        served_no_more = self.interface.end()
        self.ended = self.controller.shutdown() and served_no_more
        self.closed.set()
        self.ended = self.live.end() and self.ended  # its process may need a moment to end
        if self._event_keeper is not None:
            self._event_keeper.close()
        if self._files is not None:
            self._files.shutdown()
        if isinstance(self._files, FileThread):
            self.ended = self.ended and self._files.ended
        self.view.shutdown()
        self._workers.shutdown()
        self._for_clients.shutdown()
        if self._instances is not None:
            self._instances.close()

    def _on_failed(self, failure: Failure) -> None:
        """End motion if the failing code may drive the arm; then show the failure (S23)."""
        ended = may_drive(failure.modules)
        if ended:
            self.controller.on_failure()
        self.window.show_failure(failure, motion_ended=ended)

    def _on_unsaved(self, reason: Refusal) -> None:
        self._emit_event(SETTINGS_UNSAVED, reason=reason)

    def _on_closed(self, closed: tuple[ClosedFolder, ...]) -> None:
        self._emit_event(FOLDERS_CLOSED, folders="; ".join(map(str, closed)))

    def _replace_hung(self, files: FileThread) -> None:
        if files.replace_hung():
            self._emit_event(FILES_HANG, count=files.hanging)

    def _emit_event(self, notice: Notice, **params: object) -> None:
        at = datetime.now().astimezone()
        self.controller.noticed.emit(Event(at, notice, params))

    def _on_settings_changed(self, settings: Settings) -> None:
        apply_theme(self._app, Theme(settings.theme))
        if settings.language != self._settings.language:
            self._translator.set_language(settings.language)
        self.controller.stop_again_when_undone(settings.stop_again)
        self.controller.jog_floor.lowest_mm = settings.jog_floor_mm
        self.controller.cell.use_own_tool(settings.tool)
        self.controller.on_sessions_chosen()
        self._switch_served()
        self._settings = settings


def _log_unnoted(noted: Future[TakenOver | None]) -> None:
    if not noted.cancelled() and (error := noted.exception()) is not None:
        _LOG.warning("The version was not noted: %s", error)


class _GoingFirst(QObject):
    """Asks the system to run our threads before other programs', again with those of each bus.

    While a device is open it is asked to keep our timers, too.
    """

    def __init__(self, app: QApplication, controller: ArmController) -> None:
        super().__init__(app)
        self._link = LinkState.NO_DEVICE
        self._wait = QTimer(self, singleShot=True, interval=_THREADS_BEGUN_MS)
        self._wait.timeout.connect(raise_in_background)
        self._wait.start()
        controller.operating_state_changed.connect(self._on_operating_state)

    def _on_operating_state(self, state: OperatingState) -> None:
        if state.link is not self._link:
            keep_timers(kept=state.link is not LinkState.NO_DEVICE)
            self._link = state.link
            self._wait.start()


def run(options: StartOptions) -> int:
    """Open the window and stay until it is closed; returns the exit code."""
    with failures.hooks(), log_to(paths.logs()):
        try:
            return _run(options)
        except Exception:
            # a program started from a desktop has no terminal: the error goes to the log
            _LOG.exception("The program ends before its window has done its work")
            raise


def _run(options: StartOptions) -> int:
    sys.setswitchinterval(_SWITCH_INTERVAL_S)
    QCoreApplication.setApplicationName("armui")
    QApplication.setDesktopFileName("org.armui.armui")  # by it a desktop finds the icon
    app = make_application(sys.argv[:1])
    GarbageSearch(app)  # before any other thread begins: it could run Python's own collector
    served = {"interface": options.api_on, "live": options.live_on}
    chosen: dict[str, object] = {name: True for name, on in served.items() if on}
    if options.language is not None:
        chosen["language"] = options.language
    spoken = language_of_system(interface=QLocale.system().uiLanguages())
    store = SettingsStore(default_path(), for_this_run=chosen, first={"language": spoken})
    arms = SimulatedArms(options.sim_firmware, options.sim_joints_deg)
    device = _started_with(options, store)
    if device is not None and device.simulated:
        arms.begin(device)  # it loads in a thread while the window is built
    controller = ArmController(partial(open_device, arms=arms), SIMULATED)
    program = Program(
        app,
        store,
        controller,
        HelperProcess(),
        meeting_place=paths.runtime(),
        files=FileThread(),
        events=paths.logs(),
        hand=lambda: arms.hand,
        for_clients=HelperProcess(),
    )
    app.aboutToQuit.connect(program.shutdown)
    program.note_version(paths.trajectories())
    program.check_folders()
    with SystemEnd(app, program) as system_end:
        code = _run_window(app, program, options, device, system_end)
    if not program.ended:
        # a driver hangs in a thread: a normal exit would wait for that thread without end
        logging.shutdown()
        os._exit(code)
    arms.end()
    return code


def _run_window(
    app: QApplication,
    program: Program,
    options: StartOptions,
    device: Device | None,
    system_end: SystemEnd,
) -> int:
    def begin() -> None:
        _load_pages_when_idle(app, then=program.window.page_actions.reopen)
        if device is not None:
            # the bus does not wait for the picture, which is loaded in a process of its own
            program.controller.connect_device(device)
        if options.replay is not None:
            program.window.pages.open_replay(options.replay)
        if options.file is not None:
            program.window.pages.trajectories.open_file(options.file)
        keep_from_collector()

    if device is not None:
        # the window shows from the start that it connects, although `begin` is called later
        program.controller.expect_device()
    program.window.show()
    AfterFirstPaint(program.window, begin)
    _GoingFirst(app, program.controller)
    QTimer.singleShot(_CONNECTED_MS, app, system_end.watch_sleep)
    return app.exec()


class AfterFirstPaint(QObject):
    """Begins long work once a window is painted: before, it would delay the window's first paint.

    The libraries of a connection alone take 20 s to load on a busy computer.

    Args:
        window: The window; one that is not painted, as a minimised one, is waited for 3 s.
        begin: Called once.
    """

    def __init__(self, window: QWidget, begin: Callable[[], object]) -> None:
        super().__init__(window)
        self._timer = QTimer(self, singleShot=True, interval=_PAINTED_MS)
        self._timer.timeout.connect(begin)
        # started by the event loop: time that the constructors still take does not count
        QTimer.singleShot(0, self._timer, self._timer.start)
        window.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Notice the event that paints the window."""
        if event.type() is QEvent.Type.Paint:
            watched.removeEventFilter(self)
            self._timer.setInterval(0)
        return False


def _load_pages_when_idle(app: QApplication, then: Callable[[], object]) -> None:
    """Load the pages' modules one by one while the event loop has nothing else to do.

    Args:
        app: Qt's application.
        then: Called when all are loaded.
    """
    left = load_pages()
    timer = QTimer(app, interval=0)

    def load() -> None:
        if next(left, None) is None:
            timer.stop()
            then()

    timer.timeout.connect(load)
    timer.start()


def load_pages() -> Iterator[str]:
    """Import the modules that pages import late, and read the icons, one at each step.

    If they were read from the disk only when a page is opened, they would block the GUI thread, and
    a stop pressed meanwhile, for half a second. They are imported as by a statement, because PySide
    reads the source of each module at the first statement that imports it, loaded or not.
    """
    for room in _LATE_ROOMS:
        package = importlib.import_module(f"armui.{room}")
        for module in pkgutil.walk_packages(package.__path__, f"armui.{room}."):
            __import__(module.name, fromlist=["__name__"])
            yield module.name
    load_icons()
    yield "icons"


def keep_from_collector() -> None:
    """Exclude the program's permanent objects from garbage collection.

    Searching them would stop every thread, the stop's too, for tens of milliseconds at a time. The
    libraries of a first connection are loaded within seconds, and excluded then.
    """
    gc.freeze()
    QTimer.singleShot(_CONNECTED_MS, gc.freeze)


def _started_with(options: StartOptions, store: SettingsStore) -> Device | None:
    """Return the device to connect to at the start with its model, or ``None``."""
    device = chosen_device(options)
    if device is None:
        return None
    model = options.model or KeptModels(store).of(device) or PiperModel.PIPER
    return replace(device, model=PiperModel(model), model_assumed=options.model is None)


def chosen_device(options: StartOptions) -> Device | None:
    """Return the device to connect to at the start, or ``None``."""
    if options.sim_generation is not None:
        return next(device for device in SIMULATED if device.generation == options.sim_generation)
    if options.interface is None or options.channel is None:
        return None
    ours = bitrate_is_ours(options.interface)
    return Device(
        interface=options.interface,
        channel=options.channel,
        bitrate=(options.bitrate or DEFAULT_BITRATE) if ours else None,
    )


def open_device(
    device: Device, arms: SimulatedArms | None = None
) -> AbstractContextManager[can.BusABC]:
    """Open a device.

    Args:
        device: The device.
        arms: Connects to a simulated one; by default to today's, in the rest pose.
    """
    if device.simulated:
        return (arms or SimulatedArms()).connected(device)
    from armui.bus.adapters import open_bus  # noqa: PLC0415 - python-can, loaded with the first device

    return open_bus(device)
