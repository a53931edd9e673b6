"""The facts about this computer and the bus, before they are judged. Plain data."""

from __future__ import annotations

import enum
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, ClassVar

from armui.system.sentence import Sentence

if TYPE_CHECKING:
    from armui.system.kept_folders import ClosedFolder


@dataclass(frozen=True, slots=True)
class PackageFacts:
    """A Python package that the program uses.

    Attributes:
        name: The name in pip.
        wanted: The suitable versions in pip's notation, "" for any.
        installed: The version found, None if there is none.
        satisfied: True if that version is suitable.
        extra: Its optional group, "" if the program needs it.
    """

    name: str
    wanted: str
    installed: str | None
    satisfied: bool
    extra: str = ""


@dataclass(frozen=True, slots=True)
class ProgramFacts:
    """The program and its environment.

    Attributes:
        armui: Its version.
        python: Python's version.
        python_suffices: True if it is new enough.
        executable: Python's path.
        system: Operating system and machine.
        families: The Linux distribution and those it comes from, as in /etc/os-release.
        packages: The packages that the program uses.
        goes_first: True if its threads may have priority over other programs; None if not tried.
        priority_reason: The system's reason for refusing it.
        packaged: It brings Python and all packages itself; pip can add nothing.
        closed: Folders of the user in which it can keep nothing.
    """

    armui: str
    python: str
    python_suffices: bool
    executable: str
    system: str
    families: tuple[str, ...] = ()
    packages: tuple[PackageFacts, ...] = ()
    goes_first: bool | None = None
    priority_reason: str = ""
    packaged: bool = False
    closed: tuple[ClosedFolder, ...] = ()


@dataclass(frozen=True, slots=True)
class ScreenFacts:
    """The facts about windows and the 3D picture.

    Attributes:
        has_display: A desktop session was found.
        qt: Qt's version, None if PySide6 cannot be loaded.
        platform: Qt's platform (xcb, wayland, windows, cocoa), None if it failed.
        qt_error: The error of Qt.
        missing_libraries: Files of system libraries that Qt needs and did not find.
        opengl: Renderer and version that the 3D picture draws with, None if it cannot draw.
        opengl_error: The error of OpenGL.
    """

    has_display: bool
    qt: str | None
    platform: str | None
    qt_error: str = ""
    missing_libraries: tuple[str, ...] = ()
    opengl: str | None = None
    opengl_error: str = ""


@dataclass(frozen=True, slots=True)
class LinkFacts:
    """A CAN interface of Linux, as ``ip`` shows it.

    Attributes:
        name: Its name, as can0.
        kind: Its kind, can or vcan.
        up: True if it is switched on.
        state: The controller's state: ERROR-ACTIVE, ERROR-PASSIVE, BUS-OFF…; "" for vcan.
        bitrate: In bit/s; None for vcan, or if none is set.
        listen_only: The controller acknowledges nothing and sends nothing.
        restart_ms: The time after which a controller in bus-off restarts by itself; 0 for never.
        tx_errors, rx_errors: The controller's error counters, None if the driver reports none.
        bus_offs: The number of times it was in bus-off.
        dropped: The number of received frames that the kernel dropped.
        sent, received: The number of frames since it was switched on.
        serial: The adapter's serial number, if it reports one.
    """

    name: str
    kind: str
    up: bool
    state: str = ""
    bitrate: int | None = None
    listen_only: bool = False
    restart_ms: int = 0
    tx_errors: int | None = None
    rx_errors: int | None = None
    bus_offs: int = 0
    dropped: int = 0
    sent: int = 0
    received: int = 0
    serial: str | None = None


@dataclass(frozen=True, slots=True)
class UsbAdapterFacts:
    """A CAN adapter on the USB, with or without a driver.

    Attributes:
        usb_id: Vendor and product, as 1d50:606f.
        name: The name it reports.
        serial: Its serial number.
        links: The CAN interfaces its driver has made of it.
    """

    usb_id: str
    name: str
    serial: str | None
    links: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class SerialPortFacts:
    """A serial port on the USB, possibly an slcan adapter.

    Attributes:
        path: The device, as /dev/ttyACM0.
        may_open: True if this user may open it.
        group: The group whose members may open it.
    """

    path: str
    may_open: bool
    group: str = ""


@dataclass(frozen=True, slots=True)
class DeviceFacts:
    """A device that python-can or one of its plug-ins found."""

    interface: str
    channel: str
    serial: str | None = None


@dataclass(frozen=True, slots=True)
class CanFacts:
    """The ways to reach an arm.

    Attributes:
        links: CAN interfaces of Linux.
        usb: Adapters known by their USB identifiers.
        ports: Serial ports of the USB.
        devices: The devices found by a search of all back-ends.
        error: The reason why no search was possible.
        kept: The names of settings that the adapter's helper applies at every start.
        shared: Adapters that share a USB controller, for each such controller by its address.
        wsl: True if Linux runs as a guest of Windows, which controls the USB.
    """

    links: tuple[LinkFacts, ...] = ()
    usb: tuple[UsbAdapterFacts, ...] = ()
    ports: tuple[SerialPortFacts, ...] = ()
    devices: tuple[DeviceFacts, ...] = ()
    error: str = ""
    kept: tuple[str, ...] = ()
    shared: tuple[tuple[str, tuple[str, ...]], ...] = ()
    wsl: bool = False


@dataclass(frozen=True, slots=True)
class LimitFacts:
    """An arm's limits of one joint; None for values it did not send."""

    joint: int
    min_deg: float | None = None
    max_deg: float | None = None
    max_speed_deg_s: float | None = None
    max_acceleration_deg_s2: float | None = None


@dataclass(frozen=True, slots=True)
class ArmFacts:
    """The facts in an arm's feedback; joints are numbered from 1.

    Attributes:
        generation: The generation of its protocol.
        reason: The reason for it, in words.
        firmware: Its version, None if it was not heard.
        identity: Hardware, node type and date of the firmware, as far as they were heard.
        feedback_offset: The offset of its identifiers (0x470).
        frames_per_s: The frames of this arm and all others per second.
        status_code: 0x2A1 byte 1, None if 0x2A1 was not heard.
        status_word: The protocol's English word for it.
        mode_word: 0x2A1 byte 2, likewise.
        teaching_input: True if 0x2A1 reports that the arm is a teaching input in a pair.
        joints_deg, pose: Angles, and X Y Z RX RY RZ in mm and degrees; None for values not heard.
        unreachable: Joints that do not answer the main controller.
        beyond_limit: Joints beyond their limits.
        driver_faults: Joint and fault, in English words of the protocol.
        lowest_voltage: The lowest of the drivers' voltages, V.
        teaching: Range, stroke limit and friction of 0x47E; 255 is known to silence the feedback.
        limits: The joints' limits that were read.
        models: The names of the models that fit its angles and its pose; None if not compared.
        chosen_model: The model chosen by the operator, None if not asked.
    """

    generation: int
    reason: str
    firmware: str | None = None
    identity: tuple[str, ...] = ()
    feedback_offset: int = 0
    frames_per_s: float = 0.0
    status_code: int | None = None
    status_word: str = ""
    mode_word: str = ""
    teaching_input: bool = False
    joints_deg: tuple[float | None, ...] = (None,) * 6
    pose: tuple[float | None, ...] = (None,) * 6
    unreachable: tuple[int, ...] = ()
    beyond_limit: tuple[int, ...] = ()
    driver_faults: tuple[tuple[int, str], ...] = ()
    lowest_voltage: float | None = None
    teaching: tuple[float, float, float] | None = None
    limits: tuple[LimitFacts, ...] = ()
    models: tuple[str, ...] | None = None
    chosen_model: str | None = None


@dataclass(frozen=True, slots=True)
class OtherFrames:
    """Frames of one identifier that no arm sends as feedback."""

    arbitration_id: int
    count: int
    rate_hz: float


@dataclass(frozen=True, slots=True)
class HeardFacts:
    """The facts heard on one device.

    Attributes:
        interface, channel: As python-can names them.
        seconds: The time of listening.
        frames: Data frames received.
        error_frames: Error frames received.
        bus_off: True if one of them reported bus-off.
        asked: True if questions were sent; they count as no other host's.
        answered: True if one of them was answered.
        problem: Code of a refusal (see `armui.bus.adapters.explain`) if it could not be opened.
        problem_text: The driver's own words.
        package: The package that its back-end needs, if it is missing.
        arm: An arm's feedback, None if there was none.
        other_offsets: Offsets other than the arm's under which feedback came: a second arm.
        shifted_feedback: Identifiers of 0x3A1–0x3A8 heard.
        leader: True if joint targets come in lockstep, as from a teaching-input arm.
        other_hosts: Frames that move or set an arm, by identifier.
        unknown_ids: Some identifiers that belong to no arm.
    """

    interface: str
    channel: str
    seconds: float = 0.0
    frames: int = 0
    error_frames: int = 0
    bus_off: bool = False
    asked: bool = False
    answered: bool = False
    problem: str = ""
    problem_text: str = ""
    package: str = ""
    arm: ArmFacts | None = None
    other_offsets: tuple[int, ...] = ()
    shifted_feedback: tuple[int, ...] = ()
    leader: bool = False
    other_hosts: tuple[OtherFrames, ...] = ()
    unknown_ids: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True)
class Facts:
    """All facts; a part that was not examined is None."""

    program: ProgramFacts | None = None
    screen: ScreenFacts | None = None
    can: CanFacts | None = None
    heard: tuple[HeardFacts, ...] = ()


class DiagnosisLevel(enum.Enum):
    """The severity of a finding."""

    OK = "ok"
    NOTE = "note"
    WARNING = "warning"
    FAULT = "fault"


class Section(enum.Enum):
    """The subject of a finding."""

    PROGRAM = "program"
    SCREEN = "screen"
    CAN = "can"
    ARM = "arm"


@dataclass(frozen=True, slots=True)
class DiagnosisKind(Sentence):
    """A kind of finding.

    Attributes:
        section: Its subject; each subject has a class.
        severity: Its usual severity.
    """

    context: ClassVar[str] = "Diagnosis"
    section: ClassVar[Section]
    severity: DiagnosisLevel = field(default=DiagnosisLevel.FAULT, compare=False)

    def __call__(self, *commands: str, **params: str) -> Diagnosis:
        """Return a finding with its remedy and with the values in its sentence."""
        return Diagnosis(self, self.severity, params, commands)


class OfProgram(DiagnosisKind):
    """A kind of finding about the program itself."""

    section = Section.PROGRAM


class OfScreen(DiagnosisKind):
    """A kind of finding about windows and the 3D picture."""

    section = Section.SCREEN


class OfCan(DiagnosisKind):
    """A kind of finding about CAN devices."""

    section = Section.CAN


class OfArm(DiagnosisKind):
    """A kind of finding about the traffic on a bus."""

    section = Section.ARM


@dataclass(frozen=True, slots=True)
class Diagnosis:
    """One finding.

    Attributes:
        kind: The kind of finding.
        severity: Its severity.
        params: The values in its sentence, and more for readers of the JSON report.
        commands: The remedy's commands, a line each.
        remedies: The same for the adapter's helper, which a button starts: verb and arguments.
    """

    kind: DiagnosisKind
    severity: DiagnosisLevel
    params: Mapping[str, str] = field(default_factory=dict)
    commands: tuple[str, ...] = ()
    remedies: tuple[tuple[str, ...], ...] = ()

    def mended_by(self, *remedies: tuple[str, ...]) -> Diagnosis:
        """Return the same finding with remedies for the adapter's helper."""
        return replace(self, remedies=remedies)

    @property
    def code(self) -> str:
        """The id of its kind."""
        return self.kind.id

    @property
    def section(self) -> Section:
        """The section of the report that it belongs to."""
        return self.kind.section
