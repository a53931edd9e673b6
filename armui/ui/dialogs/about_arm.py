"""The window «About this arm»: facts on it for the operator and for a support mail (B17).

Each value was received, read or set; values that the arm does not report are shown as unknown.
"""

from __future__ import annotations

import platform
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from PySide6.QtCore import QCoreApplication, Qt, Signal
from PySide6.QtGui import QGuiApplication, QShowEvent
from PySide6.QtWidgets import QFrame, QLabel, QScrollArea, QWidget

from armui import __version__
from armui.arm.device import Device
from armui.arm.limits import JOINTS
from armui.arm.models import model_data
from armui.arm.reference_record import ReferenceRecord
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.control.arm_controller import ArmController
from armui.control.link.link_state import LinkState
from armui.control.operating_state import OperatingState
from armui.doctor.facts import LinkFacts
from armui.doctor.probes.can_devices import probe_links
from armui.protocol.addressing import Addressing
from armui.protocol.generation import Generation
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act
from armui.ui.background import Background, Job
from armui.ui.dialogs.base import ArmDialog, CloseButton
from armui.ui.dialogs.online_since import OnlineSince
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import empty_grid, fill
from armui.ui.widgets.seen_timer import SeenTimer
from armui.ui.widgets.text_label import text_label
from armui.ui.words.reference import inspection_text, reference_text, resume_text
from armui.ui.words.text import Texts

_SIZE_PX: Final = (720, 720)
_REFRESH_MS: Final = 1000
_LEAST_S: Final = 0.5
"""The shortest time over which the rate of frames is measured."""
_COLUMN_GAP_PX: Final = 28
_ROW_GAP_PX: Final = 4
_FEEDBACK: Final = (0x2A1, 0x2A8)
_COMMANDS: Final = (0x150, 0x15F)
"""The first and last identifiers of feedback and commands, without the offsets of 0x470."""
_LABELS: Final = Texts("AboutArm") | {
    "model": "Model",
    "firmware": "Firmware",
    "date": "Date of the firmware",
    "hardware": "Hardware",
    "node": "Node on the bus",
    "generation": "Protocol",
    "device": "Adapter",
    "serial": "Serial number of the adapter",
    "bitrate": "Bit rate",
    "feedback": "Identifiers of the feedback",
    "commands": "Identifiers of the commands",
    "rate": "Frames received",
    "online": "Online without interruption for",
    "running": "Running time of the arm",
    "joint": "Joint {joint}",
    "end": "End",
    "reference": "Reference of the joints",
    "resume": "Slip at a resume",
    "inspection": "Joint inspection",
    "program": "Program",
}
_NO_BITRATE: Final = frozenset({"virtual", "udp_multicast"})


@dataclass(frozen=True, slots=True)
class AboutRow:
    """One line of the window.

    Attributes:
        key: Its name in the program.
        label, value: The texts in the operator's language.
    """

    key: str
    label: str
    value: str


def about_rows(
    state: ArmState,
    now: OperatingState,
    links: Sequence[LinkFacts],
    *,
    online_s: float | None,
    frames_per_s: float | None,
    reference: ReferenceRecord | None = None,
) -> list[AboutRow]:
    """Return the lines, always the same ones in the same order.

    Args:
        state: The arm's state.
        now: The connection.
        links: The operating system's facts on its CAN interfaces.
        online_s: The time for which the arm has been online; ``None`` if it is offline.
        frames_per_s: The rate of received frames; ``None`` if not measured yet.
        reference: What is known of the joints' reference; ``None`` if the arm has not named itself.
    """
    online = now.link is LinkState.ONLINE
    untold = translate("AboutArm", "unknown: the arm does not report it")
    system = f"{platform.system()} {platform.release()}, Python {platform.python_version()}"
    values = {
        "model": _model(now),
        "firmware": _untold(now) if state.firmware is None else state.firmware,
        "date": _identity_text(state, now, "iso_date"),
        "hardware": _identity_text(state, now, "hardware"),
        "node": _node(state, now),
        "generation": _generation(now),
        "device": _device(now.device),
        "serial": _serial(now.device, links),
        "bitrate": _bitrate(now.device, links),
        "feedback": _feedback(now, online=online),
        "commands": _commands(now, online=online),
        "rate": _rate(frames_per_s, online=online),
        "online": translate("AboutArm", "not heard")
        if online_s is None
        else fmt.duration(online_s, 0),
        "running": untold,
        **{f"joint_{joint}": _limits(state, joint) for joint in JOINTS},
        "end": _end_limits(state),
        "reference": _unknown() if reference is None else reference_text(reference),
        "resume": _unknown() if reference is None else resume_text(reference),
        "inspection": _unknown() if reference is None else inspection_text(reference),
        "program": f"armui {__version__}, {system}",
    }
    return [AboutRow(key, _label(key), value) for key, value in values.items()]


def _label(key: str) -> str:
    name, _, joint = key.partition("_")
    return _LABELS.text(name, {"joint": joint})


def _model(now: OperatingState) -> str:
    if now.device is None:
        return translate("AboutArm", "none connected")
    fit, name = now.model_fit, model_data(now.model).name
    if now.link is not LinkState.ONLINE or fit.fitting is None:
        text = translate("AboutArm", "{model}, as chosen; not checked yet")
    elif fit.confirmed:
        text = translate("AboutArm", "{model}, confirmed by the pose it reports")
    elif fit.wrong is None:
        text = translate("AboutArm", "{model}, as chosen; other models fit its pose as well")
    elif fit.other is not None:
        text = translate("AboutArm", "{model}, as chosen; its pose is that of a {other}")
        return text.format(model=name, other=model_data(fit.other).name)
    else:
        text = translate("AboutArm", "{model}, as chosen; its pose fits none of the models")
    if fit.older_zeros:
        text += translate("AboutArm", "; joints 2 and 3 use the zeros from before S-V1.6-3")
    return text.format(model=name)


def _identity_text(state: ArmState, now: OperatingState, field: str) -> str:
    """Return a field of the arm's identity, or in words why it is not known."""
    found = "" if state.identity is None else str(getattr(state.identity, field))
    return found or _untold(now)


def _node(state: ArmState, now: OperatingState) -> str:
    node_type = "" if state.identity is None else state.identity.node_type
    number = "" if state.identity is None else state.identity.node_number
    if node_type and number:
        text = translate("AboutArm", "{type}, number {number}")
        return text.format(type=node_type, number=number)
    return node_type or number or _untold(now)


def _untold(now: OperatingState) -> str:
    if now.generation is Generation.ONE:
        return translate("AboutArm", "unknown: generation 1 does not report it")
    return _unknown()


def _generation(now: OperatingState) -> str:
    if now.generation is None:
        return _unknown()
    return translate("AboutArm", "Generation {generation}").format(generation=int(now.generation))


def _device(device: Device | None) -> str:
    if device is None:
        return translate("AboutArm", "none connected")
    name = words.device_name(device)
    return name if device.simulated else f"{device.interface}, {name}"


def _serial(device: Device | None, links: Sequence[LinkFacts]) -> str:
    link = _link(device, links)
    serial = (device.serial if device is not None else None) or (link.serial if link else None)
    if device is not None and device.simulated:
        return translate("AboutArm", "none: simulated arm")
    return serial or _unknown()


def _bitrate(device: Device | None, links: Sequence[LinkFacts]) -> str:
    if device is not None and (device.simulated or device.interface in _NO_BITRATE):
        return translate("AboutArm", "none: not a CAN bus")
    link = _link(device, links)
    if link is not None and link.bitrate is not None:
        return translate("AboutArm", "{bitrate} bit/s, set by the operating system").format(
            bitrate=link.bitrate
        )
    if device is not None and device.bitrate is not None:
        return translate("AboutArm", "{bitrate} bit/s, set by this program").format(
            bitrate=device.bitrate
        )
    return _unknown()


def _link(device: Device | None, links: Sequence[LinkFacts]) -> LinkFacts | None:
    if device is None or device.interface != "socketcan":
        return None
    return next((each for each in links if each.name == str(device.channel)), None)


def _feedback(now: OperatingState, *, online: bool) -> str:
    return _range(_FEEDBACK, now.addressing.feedback_offset) if online else _unknown()


def _commands(now: OperatingState, *, online: bool) -> str:
    if not online:
        return _unknown()
    text = _range(_COMMANDS, now.addressing.control_offset)
    if now.control_certain or now.addressing == Addressing():
        return text
    return translate("AboutArm", "{ids}, not proven: the arm cannot be asked").format(ids=text)


def _range(ids: tuple[int, int], offset: int) -> str:
    first, last = (each + offset for each in ids)
    return translate("AboutArm", "0x{first} to 0x{last} (offset 0x{offset})").format(
        first=f"{first:03X}", last=f"{last:03X}", offset=f"{offset:02X}"
    )


def _rate(frames_per_s: float | None, *, online: bool) -> str:
    if frames_per_s is None or not online:
        return _unknown()
    return translate("AboutArm", "{rate} per second").format(rate=f"{frames_per_s:.0f}")


def _limits(state: ArmState, joint: int) -> str:
    limits, acceleration = state.limits[joint - 1], state.accelerations_deg_s2[joint - 1]
    if limits is None:
        return translate("AboutArm", "unknown: not read from the arm")
    text = translate("AboutArm", "{minimum}° to {maximum}°, at most {speed}°/s").format(
        minimum=fmt.number(limits.value.min_deg, 1),
        maximum=fmt.number(limits.value.max_deg, 1),
        speed=f"{limits.value.max_speed_deg_s:.1f}",
    )
    if acceleration is None:
        return text
    return translate("AboutArm", "{limits} and {acceleration}°/s²").format(
        limits=text, acceleration=f"{acceleration.value:.1f}"
    )


def _end_limits(state: ArmState) -> str:
    if state.end_limits is None:
        return translate("AboutArm", "unknown: not read from the arm")
    end = state.end_limits.value
    return translate("AboutArm", "at most {linear} m/s and {angular} rad/s").format(
        linear=f"{end.max_linear_speed_m_s:.3f}", angular=f"{end.max_angular_speed_rad_s:.3f}"
    )


def _unknown() -> str:
    return translate("AboutArm", "unknown")


def translate(context: str, text: str) -> str:
    """Return a text in the present language; Qt's tools find texts by this name."""
    return QCoreApplication.translate(context, text)


class AboutArmDialog(ArmDialog):
    """Shows the lines, updated every second while it is open.

    Args:
        controller: Gives the arm's state.
        online: Gives the time for which it has been online.
        background: Reads the bit rate of CAN interfaces from the operating system.
        parent: The main window.

    Signals:
        inspection_wanted: The joint inspection shall be opened.
    """

    inspection_wanted = Signal()

    copy_button = Act("Copy as text", named="about_arm_copy", key="about_arm.copy")
    inspect_button = Act("Joint inspection…", named="about_arm_inspection")

    def __init__(
        self,
        controller: ArmController,
        online: OnlineSince,
        background: Background,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(controller, parent)
        self._online = online
        self._background = background
        self._links: tuple[LinkFacts, ...] = ()
        self._looking = False
        self._before: tuple[int, float] | None = None
        self._rate: float | None = None
        self._rows: list[AboutRow] = []
        self._labels: list[tuple[QLabel, QLabel]] = []
        self._build()
        self.resize(*_SIZE_PX)
        self._timer = SeenTimer(self, _REFRESH_MS, self._refresh)
        controller.operating_state_changed.connect(self._on_state_changed)
        self.retranslate_ui()

    def _build(self) -> None:
        self._grid_widget = QWidget()
        self._grid = empty_grid(self._grid_widget, gaps=(_COLUMN_GAP_PX, _ROW_GAP_PX), margins=0)
        self._grid.setColumnStretch(1, 1)
        area = named("about_arm_values", QScrollArea())
        area.setWidgetResizable(True)
        area.setFrameShape(QFrame.Shape.NoFrame)
        area.setWidget(self._grid_widget)
        area.viewport().setAutoFillBackground(False)
        self._grid_widget.setAutoFillBackground(False)
        self._copied_label = text_label("about_arm_said", rank="muted")
        self.body.addWidget(area, 1)
        fill(self.footer, self.copy_button, self.inspect_button, (self._copied_label, 1))
        fill(self.footer, CloseButton(self, on_enter=True))

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("About this arm"))
        self.show_acts()
        self._refresh()

    def showEvent(self, event: QShowEvent) -> None:
        """Update everything that is shown."""
        super().showEvent(event)
        if not event.spontaneous():
            self._before = self._rate = None
            self._copied_label.clear()
            self._probe_links()
            self._refresh()

    def text(self) -> str:
        """Return everything that is shown as text, one line for each row."""
        return "".join(f"{row.label}: {row.value}\n" for row in self._rows)

    @copy_button.pressed
    def _on_copy(self) -> None:
        QGuiApplication.clipboard().setText(self.text())
        self._copied_label.setText(self.tr("Copied: paste it into a mail."))

    @inspect_button.pressed
    def _on_inspect(self) -> None:
        self.inspection_wanted.emit()

    def _on_state_changed(self) -> None:
        if self.isVisible():
            self._probe_links()
            self._refresh()

    def _probe_links(self) -> None:
        device = self._controller.operating_state.device
        if self._looking or device is None or device.interface != "socketcan":
            return
        self._looking = True
        self._background.begin_here(Job(self._on_links), probe_links)

    def _on_links(self, links: tuple[LinkFacts, ...] | Refusal) -> None:
        self._looking = False
        self._links = () if isinstance(links, Refusal) else links
        self._refresh()

    def _refresh(self) -> None:
        self._measure_rate()
        self._rows = about_rows(
            self._controller.state,
            self._controller.operating_state,
            self._links,
            online_s=self._online.seconds(),
            frames_per_s=self._rate,
            reference=self._controller.reference.known,
        )
        while len(self._labels) < len(self._rows):
            self._add_row()
        for (name, value), row in zip(self._labels, self._rows, strict=True):
            if value.text() != row.value or name.text() != row.label:
                name.setText(row.label)
                value.setText(row.value)
                value.setObjectName(f"about_{row.key}")
                value.setAccessibleName(f"{row.label}: {row.value}")

    def _measure_rate(self) -> None:
        """Measure the frames per second since the last look, by the times of the feedback."""
        state = self._controller.state
        if state.last_feedback_s is None:
            self._before = self._rate = None
            return
        now = (state.frames, state.last_feedback_s)
        if self._before is None or now[0] < self._before[0]:
            self._before = now
            return
        frames, seconds = now[0] - self._before[0], now[1] - self._before[1]
        if seconds >= _LEAST_S:
            self._rate = frames / seconds
            self._before = now

    def _add_row(self) -> None:
        name, value = text_label(rank="muted"), text_label(wraps=True, plain=True)
        name.setAlignment(Qt.AlignmentFlag.AlignTop)
        value.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        row = len(self._labels)
        self._grid.addWidget(name, row, 0)
        self._grid.addWidget(value, row, 1)
        self._grid.setRowStretch(row + 1, 1)
        self._grid.setRowStretch(row, 0)
        self._labels.append((name, value))
