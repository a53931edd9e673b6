"""The window 连接机械臂: lists devices, connects and disconnects (manual 1.0.1)."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Final

from PySide6.QtCore import QItemSelection, QItemSelectionModel, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QCheckBox,
    QComboBox,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QLineEdit,
    QTableView,
    QWidget,
)

from armui.arm.device import DEFAULT_BITRATE, Device, bitrate_is_ours
from armui.arm.refusal import Refusal
from armui.control.arm_controller import ArmController
from armui.control.events import Level
from armui.control.link.link_state import LinkState
from armui.control.operating_state import OperatingState
from armui.doctor.facts import Diagnosis
from armui.doctor.process import adapter_trouble
from armui.ui import words
from armui.ui.actions.act import Act, HasActs
from armui.ui.actions.command import Command, Target
from armui.ui.background import Background, Job
from armui.ui.dialogs.adapter_line import AdapterLine
from armui.ui.dialogs.base import ArmDialog, CloseButton
from armui.ui.dialogs.confirm_dialog import confirm
from armui.ui.dialogs.finding_row import FindingRow
from armui.ui.dialogs.kept_models import KeptModels
from armui.ui.dialogs.model_choice import (
    LINE_GAP_PX,
    SERIAL,
    STATE,
    DeviceModel,
    ModelChoice,
    bitrate_text,
    same_device,
)
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import STRETCH, fill, in_column, in_row
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.progress import quiet_progress
from armui.ui.widgets.table_model import list_rows
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import Text

_BITRATES: Final = (DEFAULT_BITRATE, 500_000)
"""The bit rates of today's hardware, and of generation 1's protocol text."""

_SIZE_PX: Final = (820, 620)
_LIST_PX: Final = 194
"""The height for the titles and five devices: adapters of a bench, and the simulated arm below
them.
"""
_BOX_PX: Final = 170

Leaving = Callable[[QWidget, Callable[[], object]], object]
"""Called with the window that asks and a function to go on with, now or once the operator agrees.
"""
_MOST: Final = 1
"""The most faults of an adapter shown here, the gravest first: 诊断 lists all of them."""


class ManualEntry(HasActs, Translated, QWidget):
    """Fields for interface and channel as python-can names them.

    Args:
        interfaces: The back-ends to offer; others can be typed.

    Signals:
        entered: The :class:`Device` that was entered.
    """

    entered = Signal(object)
    add_button = Act("Add to the list", named="connect_add")

    def __init__(self, interfaces: Sequence[str]) -> None:
        super().__init__()
        self.interface_label = QLabel()
        self.interface_box = QComboBox(editable=True)
        self.interface_box.addItems(list(interfaces))
        self.interface_box.setCurrentText("slcan")
        self.interface_label.setBuddy(self.interface_box)
        self._channel_label = QLabel()
        self.channel_edit = QLineEdit(placeholderText="COM5, can0")
        self._channel_label.setBuddy(self.channel_edit)
        of_interface = (self.interface_label, self.interface_box, 6)
        of_channel = (self._channel_label, (self.channel_edit, 1))
        in_row(*of_interface, *of_channel, self.add_button, on=self, spacing=8, margins=0)
        self.channel_edit.textChanged.connect(lambda _text: self.show_acts())
        self.interface_box.editTextChanged.connect(lambda _text: self.show_acts())
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.interface_label.setText(self.tr("Interface"))
        self._channel_label.setText(self.tr("Channel"))
        self.show_acts()

    @add_button.why_not
    def _why_not_add(self) -> str:
        complete = self._interface() and self._channel()
        return "" if complete else self.tr("Enter the interface and its channel first.")

    @add_button.pressed
    def _on_add(self) -> None:
        interface, channel = self._interface(), self._channel()
        self.entered.emit(
            Device(
                interface=interface,
                # some back-ends number their channels and expect an integer
                channel=int(channel) if channel.isdecimal() else channel,
                bitrate=DEFAULT_BITRATE if bitrate_is_ours(interface) else None,
            )
        )
        self.channel_edit.clear()

    def _interface(self) -> str:
        return self.interface_box.currentText().strip()

    def _channel(self) -> str:
        return self.channel_edit.text().strip()


class AdapterTrouble(Translated, QWidget):
    """A line shown while an adapter has a fault.

    Args:
        background: Runs the examination.
        find_faults: Returns the faults.
        adapter: Sets an adapter up by a click; without it commands are shown for copying.

    Signals:
        resized: The text has changed, and with it the height it needs.
    """

    resized = Signal()

    def __init__(
        self,
        background: Background,
        find_faults: Callable[[], list[Diagnosis]] = adapter_trouble,
        adapter: AdapterLine | None = None,
    ) -> None:
        super().__init__()
        self.setObjectName("adapter_trouble")
        self._background = background
        self._find_faults = find_faults
        self._adapter = adapter
        if adapter is not None:
            adapter.changed.connect(self.examine)
        self._findings: Sequence[Diagnosis] = ()
        self._rows: list[FindingRow] = []
        self._column = in_column(on=self, spacing=6, margins=(12, 0, 0, 0))
        self.hide()

    def examine(self) -> None:
        """Examine the adapters again."""
        self._background.begin_here(Job(self._take), self._find_faults)

    def _take(self, findings: list[Diagnosis] | Refusal) -> None:
        self._findings = () if isinstance(findings, Refusal) else findings[:_MOST]
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Set the text in the operator's language."""
        for row in self._rows:
            self._column.removeWidget(row)
            row.deleteLater()
        self._rows = [FindingRow(each, self._adapter) for each in self._findings]
        for row in self._rows:
            self._column.addWidget(row)
        self.setVisible(bool(self._rows))
        self.resized.emit()


class ConnectDialog(ArmDialog):
    """Lists the devices, searches whenever it is opened, connects and disconnects.

    Args:
        controller: Searches and connects.
        parent: The main window.
        before_leaving: Asks about unsaved work before the arm is disconnected or changed.
        kept_models: The models chosen for arms.
        background: Runs the examination of adapters; by default there is none.

    Signals:
        diagnosis_wanted: The operator wants to know why a device, or no arm, answers.
    """

    commands = (
        Command("connect.model", Text("Action", "Model of the arm")),
        Command("connect.listen_only", Text("ConnectDialog", "Listen only")),
    )
    refresh_button = Act("Refresh", named="connect_refresh")
    diagnosis_button = Act("Diagnosis…", named="connect_diagnosis")
    disconnect_button = Act("Disconnect", named="connect_disconnect")
    connect_button = Act("Connect", named="connect_connect", primary=True, on_enter=True)
    diagnosis_wanted = Signal(object)

    def __init__(
        self,
        controller: ArmController,
        parent: QWidget | None = None,
        before_leaving: Leaving | None = None,
        kept_models: KeptModels | None = None,
        background: Background | None = None,
    ) -> None:
        super().__init__(controller, parent)
        self._adapter = AdapterLine(controller)
        self._trouble = (
            None if background is None else AdapterTrouble(background, adapter=self._adapter)
        )
        self._wanted: Device | None = None
        self._before_leaving = before_leaving
        self._operating_state = controller.operating_state
        self._model = DeviceModel()
        self._searching = False
        self._build(kept_models or KeptModels())
        self.resize(*_SIZE_PX)

        self._model.modelAboutToBeReset.connect(self._keep_selection)
        self._model.modelReset.connect(self._restore_selection)
        self._table.selectionModel().selectionChanged.connect(self._on_selection_changed)
        self._table.doubleClicked.connect(self._on_connect)
        self._manual.entered.connect(self._on_entered)
        self.model_choice.chosen.connect(self._refresh)
        if self._trouble is not None:
            self._trouble.resized.connect(self._make_room)
            self._adapter.changed.connect(controller.search_devices)
        controller.devices_found.connect(self._on_devices_found)
        controller.searching_changed.connect(self._on_searching_changed)
        controller.operating_state_changed.connect(self._on_operating_state_changed)
        self._on_operating_state_changed(controller.operating_state)
        self.retranslate_ui()

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        return {
            **super().command_targets(),
            "connect.model": self.model_choice.box,
            "connect.listen_only": self.listen_only_box,
        }

    # Layout -----------------------------------------------------------------------------------

    def _build(self, kept_models: KeptModels) -> None:
        self._kept: Device | None = None
        self._message = MessageLine()
        self._table = QTableView()
        self._table.setModel(self._model)
        self._table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self._table.setMinimumHeight(_LIST_PX)
        self._table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        header = list_rows(self._table)
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(SERIAL, QHeaderView.ResizeMode.Stretch)
        self._progress = quiet_progress()
        self._progress.setRange(0, 0)
        said = in_row((self._message, 1), self.diagnosis_button, spacing=8)
        self.model_choice = ModelChoice(kept_models)
        fill(self.body, said)
        if self._trouble is not None:
            fill(self.body, self._trouble, self._adapter)
        self._manual = ManualEntry(self._controller.interfaces())
        self._manual_label = text_label(rank="muted")
        fill(self.body, (self._table, 1), self._progress, self.model_choice)
        fill(self.body, self._build_bitrate(), self._manual_label, self._manual)
        fill(self.footer, self.refresh_button, STRETCH)
        fill(self.footer, self.disconnect_button, self.connect_button, CloseButton(self))

    def _build_bitrate(self) -> QHBoxLayout:
        self._bitrate_label = QLabel()
        self.bitrate_box = QComboBox()
        for bitrate in _BITRATES:
            self.bitrate_box.addItem("", bitrate)
        for box in (self.bitrate_box, self.model_choice.box):
            box.setMinimumWidth(_BOX_PX)
            # texts of any language fit
            box.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
        self._bitrate_label.setBuddy(self.bitrate_box)
        self._bitrate_hint = text_label(rank="muted")
        self.listen_only_box = named("listen_only_box", QCheckBox())
        about = (8, (self._bitrate_hint, 1), self.listen_only_box)
        return in_row(self._bitrate_label, self.bitrate_box, *about, spacing=LINE_GAP_PX)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Connect arm"))
        self._table.setAccessibleName(self.tr("CAN devices"))
        self._bitrate_label.setText(self.tr("Bit rate"))
        self.model_choice.retranslate_ui()
        self.model_choice.line_up(self._bitrate_label, self._manual.interface_label)
        self.listen_only_box.setText(self.tr("Listen only"))
        self.listen_only_box.setToolTip(
            self.tr("For use beside another program: nothing but the emergency stop is sent.")
        )
        self.bitrate_box.setItemText(0, bitrate_text(_BITRATES[0]))
        generation_1 = self.tr("{bitrate} (generation 1)")
        self.bitrate_box.setItemText(1, generation_1.format(bitrate=bitrate_text(_BITRATES[1])))
        self._manual_label.setText(self.tr("The device is not in the list? Enter it:"))
        self._model.retranslate()
        self._refresh()

    # What the operator does -------------------------------------------------------------------

    def showEvent(self, event: QShowEvent) -> None:
        """Search for devices at each opening, as in the manual."""
        super().showEvent(event)
        if not event.spontaneous():
            self._table.setFocus()
            self._wanted = None
            self._search()

    @refresh_button.pressed
    def _search(self) -> None:
        self._controller.search_devices()
        if self._trouble is not None:
            self._trouble.examine()

    @connect_button.pressed
    def _on_connect(self) -> None:
        device = self._selected()
        if device is None or self._is_connected_so(device):
            return
        if bitrate_is_ours(device.interface) and not device.simulated:
            device = replace(device, bitrate=self.bitrate_box.currentData())
        chosen = replace(
            device,
            listen_only=self.listen_only_box.isChecked(),
            model=self.model_choice.model,
            model_assumed=self.model_choice.is_assumed,
        )
        self._leave_then(lambda: self._connect_as(chosen))

    def _connect_as(self, device: Device) -> None:
        self.model_choice.keep(device)
        self._wanted = device
        self._controller.connect_device(device)

    @diagnosis_button.pressed
    def _on_diagnosis(self) -> None:
        self.diagnosis_wanted.emit(self._selected())

    @disconnect_button.pressed
    def _on_disconnect(self) -> None:
        self._leave_then(self._controller.disconnect_device)

    def _leave_then(self, action: Callable[[], object]) -> None:
        if self._before_leaving is None or self._operating_state.device is None:
            self._leave_unless_moving(action)
        else:
            self._before_leaving(self, lambda: self._leave_unless_moving(action))

    def _leave_unless_moving(self, action: Callable[[], object]) -> None:
        """Act; but ask first if a moving arm would be left without the emergency stop."""
        if not self._operating_state.moving:
            action()
            return
        confirm(
            self,
            self._controller,
            title=self.tr("The arm is moving"),
            text=self.tr(
                "Without the connection the arm goes on to its target, and the emergency stop of "
                "this program cannot reach it."
            ),
            action_label=self.tr("Disconnect"),
            on_confirmed=action,
        )

    def _on_entered(self, device: Device) -> None:
        self._table.selectRow(self._model.add(device))
        self._table.setFocus()

    def _on_selection_changed(self, _now: QItemSelection, _before: QItemSelection) -> None:
        device = self._selected()
        if device is not None and device.bitrate is not None:
            index = self.bitrate_box.findData(device.bitrate)
            self.bitrate_box.setCurrentIndex(max(0, index))
        self.model_choice.show_device(device, self._operating_state)
        self._refresh()

    # Signals of the controller ----------------------------------------------------------------

    def _on_devices_found(self, devices: Sequence[Device]) -> None:
        self._model.show_found(devices)
        self._restore_selection()

    def _on_searching_changed(self, searching: bool) -> None:
        self._searching = searching
        self._progress.setVisible(searching)
        self._refresh()

    def _on_operating_state_changed(self, operating_state: OperatingState) -> None:
        self._operating_state = operating_state
        self._model.show_connected(operating_state.device, operating_state.link)
        self.model_choice.show_fit(self._selected(), operating_state)
        self._refresh()
        online = operating_state.link is LinkState.ONLINE
        if online and self._wanted is not None and self._is_connected(self._wanted):
            self.close()  # connected: it would only cover the arm

    def _make_room(self) -> None:
        """Grow until the text on the adapter's fault is visible as a whole."""
        layout = self.layout()
        if layout is None:
            return
        layout.activate()  # else the layout still has the height of the text before
        wanted = layout.totalMinimumHeightForWidth(self.width())
        self.resize(self.width(), max(self.height(), wanted))

    # Appearance -------------------------------------------------------------------------------

    def _selected(self) -> Device | None:
        rows = self._table.selectionModel().selectedRows()
        return self._model.device(rows[0].row()) if rows else None

    def _select(self, device: Device | None) -> None:
        row = self._model.row_of(device)
        if row >= 0:
            flags = QItemSelectionModel.SelectionFlag
            index = self._model.index(row, STATE)
            self._table.selectionModel().setCurrentIndex(index, flags.ClearAndSelect | flags.Rows)

    def _keep_selection(self) -> None:
        self._kept = self._selected()

    def _restore_selection(self) -> None:
        """Keep what was chosen; else choose the connected device, else the first."""
        if self._selected() is None:
            candidates = (self._kept, self._operating_state.device, self._model.device(0))
            known = [device for device in candidates if self._model.row_of(device) >= 0]
            self._select(known[0] if known else None)

    def _is_connected(self, device: Device) -> bool:
        return same_device(device, self._operating_state.device)

    def _is_connected_so(self, device: Device) -> bool:
        """Return whether it is connected as the model that is chosen."""
        return self._is_connected(device) and (
            self.model_choice.model is self._operating_state.model
        )

    def _refresh(self) -> None:
        self._refresh_message()
        self._refresh_bitrate()
        self.show_acts()

    @connect_button.why_not
    def _why_not_connect(self) -> str:
        device = self._selected()
        if device is None:
            return self.tr("Choose a device in the list first.")
        connected = self._is_connected_so(device)
        return self.tr("This device is connected.") if connected else ""

    @disconnect_button.why_not
    def _why_not_disconnect(self) -> str:
        nothing = self._operating_state.device is None
        return self.tr("No device is connected.") if nothing else ""

    @refresh_button.why_not
    def _why_not_search(self) -> str:
        return self.tr("The search is under way.") if self._searching else ""

    def _refresh_message(self) -> None:
        operating_state = self._operating_state
        failed = operating_state.link_problem is not None
        self.diagnosis_button.setVisible(failed or operating_state.link is LinkState.OFFLINE)
        device = operating_state.device
        name = "" if device is None else words.device_name(device)
        if operating_state.link_problem is not None:
            self._message.show_message(words.refusal(operating_state.link_problem), Level.FAULT)
        elif operating_state.link is LinkState.OFFLINE and operating_state.cannot_move is not None:
            self._message.show_message(words.refusal(operating_state.cannot_move), Level.WARNING)
        elif operating_state.link is LinkState.OPENING:
            self._message.show_message(self.tr("Connecting to {device}…").format(device=name))
        elif operating_state.link is LinkState.ONLINE:
            text = self.tr("Online: {device}").format(device=name)
            self._message.show_message(text, Level.DONE)
        elif self._searching:
            self._message.show_message(self.tr("Searching for devices…"))
        else:
            self._message.show_message(self.tr("Choose a device and press Connect."))

    def _refresh_bitrate(self) -> None:
        device = self._selected()
        if device is None:
            reason = ""
        elif device.simulated:
            reason = self.tr("The simulated arm has no bit rate.")
        elif not bitrate_is_ours(device.interface):
            reason = self.tr("Set by the operating system, not by this program.")
        elif self._is_connected(device):
            reason = self.tr("Disconnect to change it.")
        else:
            reason = ""
        self.bitrate_box.setEnabled(device is not None and not reason)
        self.bitrate_box.setToolTip(reason)
        self._bitrate_hint.setText(reason)
