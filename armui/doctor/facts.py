"""What was found out about this computer and the bus, before anybody judges it. Plain data."""

from __future__ import annotations

import enum
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import ClassVar

from armui.system.sentence import Sentence


@dataclass(frozen=True, slots=True)
class PackageFacts:
    """A Python package the program wants.

    Attributes:
        name: As pip knows it.
        wanted: The versions that do, as pip writes them, "" for any.
        installed: The version found, None if there is none.
        satisfied: Whether that does.
        extra: The optional group it belongs to, "" for what the program cannot do without.
    """

    name: str
    wanted: str
    installed: str | None
    satisfied: bool
    extra: str = ""


@dataclass(frozen=True, slots=True)
class ProgramFacts:
    """The program and what it runs on.

    Attributes:
        armui: Its version.
        python: Python's version.
        python_suffices: Whether it is new enough.
        executable: Python's path.
        system: Operating system and machine.
        families: The Linux distribution and those it comes from, as in /etc/os-release.
        packages: What the program wants.
        goes_first: Whether its threads may go before other programs'; None: that was not tried.
        priority_reason: What stood against it, in the system's words.
        packaged: It brings Python and all packages itself; pip can add nothing.
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


@dataclass(frozen=True, slots=True)
class ScreenFacts:
    """Whether windows and the 3D picture can be drawn.

    Attributes:
        has_display: A desktop session was found.
        qt: Qt's version, None if PySide6 cannot be loaded.
        platform: Qt's way to the screen (xcb, wayland, windows, cocoa), None if it failed.
        qt_error: What went wrong.
        missing_libraries: Files of system libraries that Qt wants and did not find.
        opengl: Renderer and version that the 3D picture draws with, None if it cannot draw.
        opengl_error: What went wrong.
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
        name: can0.
        kind: can or vcan.
        up: Switched on.
        state: Of the controller: ERROR-ACTIVE, ERROR-PASSIVE, BUS-OFF…; "" for vcan.
        bitrate: Bit/s; None for vcan, or where none is set.
        listen_only: The controller acknowledges nothing and sends nothing.
        restart_ms: After so long a controller in bus-off comes back by itself; 0: never.
        tx_errors, rx_errors: The controller's error counters, None where the driver tells none.
        bus_offs: How often it was in bus-off.
        dropped: Received frames that the kernel dropped.
        serial: Of the adapter, where it tells one.
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
    serial: str | None = None


@dataclass(frozen=True, slots=True)
class UsbAdapterFacts:
    """A CAN adapter on the USB, whether a driver serves it or not.

    Attributes:
        usb_id: Vendor and product, 1d50:606f.
        name: What it calls itself.
        serial: Its serial number.
        links: The CAN interfaces its driver has made of it.
    """

    usb_id: str
    name: str
    serial: str | None
    links: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class SerialPortFacts:
    """A serial port of the USB, which may be an slcan adapter.

    Attributes:
        path: /dev/ttyACM0.
        may_open: Whether this user may.
        group: Who may.
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
    """What there is to reach an arm by.

    Attributes:
        links: CAN interfaces of Linux.
        usb: Adapters known by their USB identifiers.
        ports: Serial ports of the USB.
        devices: What a search of all back-ends found.
        error: Why no search was possible.
        kept: What the adapter's helper keeps at every start, by the names it was given.
        wsl: Linux runs as a guest of Windows, which has the USB.
    """

    links: tuple[LinkFacts, ...] = ()
    usb: tuple[UsbAdapterFacts, ...] = ()
    ports: tuple[SerialPortFacts, ...] = ()
    devices: tuple[DeviceFacts, ...] = ()
    error: str = ""
    kept: tuple[str, ...] = ()
    wsl: bool = False


@dataclass(frozen=True, slots=True)
class LimitFacts:
    """What an arm says about one of its joints; None where it said nothing."""

    joint: int
    min_deg: float | None = None
    max_deg: float | None = None
    max_speed_deg_s: float | None = None
    max_acceleration_deg_s2: float | None = None


@dataclass(frozen=True, slots=True)
class ArmFacts:
    """What an arm's feedback says; joints are numbered from 1.

    Attributes:
        generation: Of its protocol.
        reason: What speaks for it, for people.
        firmware: Its version, None if it was not heard.
        identity: Hardware, node type and date of the firmware, as far as they were heard.
        feedback_offset: Of its identifiers (0x470).
        frames_per_s: Of this arm and everybody else.
        status_code: 0x2A1 byte 1, None if 0x2A1 was not heard.
        status_word: The same in the protocol's English word.
        mode_word: 0x2A1 byte 2, likewise.
        teaching_input: 0x2A1 says that the arm is a teaching input in a pair.
        joints_deg, pose: Angles, and X Y Z RX RY RZ in mm and degrees; None where not heard.
        unreachable: Joints that do not answer the main controller.
        beyond_limit: Joints beyond their limits.
        driver_faults: Joint and fault, in English words of the protocol.
        lowest_voltage: Of the drivers, V.
        teaching: Range, stroke limit and friction of 0x47E; 255 is known to silence the feedback.
        limits: What was read of the joints' limits.
        models: The names of the models that fit its angles and its pose; None: not compared.
        chosen_model: What the operator says it is, None where nobody was asked.
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
    """What one device let hear.

    Attributes:
        interface, channel: As python-can names them.
        seconds: So long it was listened to.
        frames: Data frames received.
        error_frames: Error frames received.
        bus_off: One of them said that the controller is off the bus.
        asked: Whether questions were sent; what was sent counts as nobody's.
        answered: Whether one of them was answered.
        problem: Code of a refusal (see `armui.bus.adapters.explain`) if it could not be opened.
        problem_text: The driver's own words.
        package: What its back-end wants, where that is missing.
        arm: An arm's feedback, None if there was none.
        other_offsets: Feedback that came under other offsets than the arm's: a second arm.
        shifted_feedback: Identifiers of 0x3A1–0x3A8 heard.
        leader: Somebody sends joint targets in lockstep, as a teaching-input arm does.
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
    """Everything; a part that was not looked at is None."""

    program: ProgramFacts | None = None
    screen: ScreenFacts | None = None
    can: CanFacts | None = None
    heard: tuple[HeardFacts, ...] = ()


class DiagnosisLevel(enum.Enum):
    """How grave a finding is."""

    OK = "ok"
    NOTE = "note"
    WARNING = "warning"
    FAULT = "fault"


class Section(enum.Enum):
    """What a finding is about."""

    PROGRAM = "program"
    SCREEN = "screen"
    CAN = "can"
    ARM = "arm"


@dataclass(frozen=True, slots=True)
class DiagnosisKind(Sentence):
    """Something that can be found out.

    Attributes:
        section: What it is about; each has a class.
        severity: How grave it is, as a rule.
    """

    context: ClassVar[str] = "Diagnosis"
    section: ClassVar[Section]
    severity: DiagnosisLevel = field(default=DiagnosisLevel.FAULT, compare=False)

    def __call__(self, *commands: str, **params: str) -> Diagnosis:
        """It with its remedy and with what its sentence mentions."""
        return Diagnosis(self, self.severity, params, commands)


class OfProgram(DiagnosisKind):
    """It is about the program itself."""

    section = Section.PROGRAM


class OfScreen(DiagnosisKind):
    """It is about windows and the 3D picture."""

    section = Section.SCREEN


class OfCan(DiagnosisKind):
    """It is about CAN devices."""

    section = Section.CAN


class OfArm(DiagnosisKind):
    """It is about what is heard on a bus."""

    section = Section.ARM


@dataclass(frozen=True, slots=True)
class Diagnosis:
    """One thing found out.

    Attributes:
        kind: What it is.
        severity: How grave it is.
        params: What its sentence mentions, and more for those who read the report as JSON.
        commands: The remedy, to be copied; a line each.
        remedies: The same for the adapter's helper, which a button starts: verb and words.
    """

    kind: DiagnosisKind
    severity: DiagnosisLevel
    params: Mapping[str, str] = field(default_factory=dict)
    commands: tuple[str, ...] = ()
    remedies: tuple[tuple[str, ...], ...] = ()

    def mended_by(self, *remedies: tuple[str, ...]) -> Diagnosis:
        """The same with what the adapter's helper can do about it."""
        return replace(self, remedies=remedies)

    @property
    def code(self) -> str:
        """The id of what was found out."""
        return self.kind.id

    @property
    def section(self) -> Section:
        """What it is about."""
        return self.kind.section
