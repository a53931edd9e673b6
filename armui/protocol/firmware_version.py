"""The firmware versions of generation 2, and what each of them changed.

The facts are those of the table of firmware versions: public texts and code up to autumn 2026. A
row of `_CHANGES` holds what differs from that version on; no other code compares version numbers.
"""

from __future__ import annotations

import enum
import re
from functools import cache
from typing import Any, Final, NamedTuple

from armui.protocol.generation import PiperModel

_TEXT: Final = re.compile(r"S-V(\d{1,3})\.(\d{1,3})-(\d{1,3})")

SixSigns = tuple[int, int, int, int, int, int]
SixFactors = tuple[float, float, float, float, float, float]

_AS_MOVE_J: Final[SixSigns] = (1, 1, 1, 1, 1, 1)

_ALL: Final = frozenset(PiperModel)
_X: Final = frozenset({PiperModel.PIPER_X})
_ONE: Final[SixFactors] = (1.0,) * 6

VERSION_ID: Final = 0x4AF

ANSWER_BYTES: Final = 88
"""The length of a whole answer to 0x4AF: eleven frames of 8 bytes."""
ANSWER_S: Final = 0.5
"""A pause this long ends an answer; later frames belong to another one."""
LONGEST: Final = 16
"""More bytes than any version text has; text further back cannot be its beginning."""

_HEARD_TEXT: Final = re.compile(rb"S-V\d{1,3}\.\d{1,3}-\d")
"""The version in an answer. The patch is one digit: without padding the date follows at once
(S-V1.9-0260716).
"""
_HARDWARE: Final = re.compile(rb"H-V\d{1,3}\.\d{1,3}-\d")
_DATE: Final = re.compile(rb"[\0 ]*(\d{6})(?!\d)")
_NODE_NUMBER: Final = re.compile(rb"[\0 ]*(\d{1,3})(?!\d)")
_TOKEN: Final = re.compile(rb"[\x21-\x7e]+")
_LETTER: Final = re.compile(rb"[A-Za-z]")

_QUESTION: Final = b"\x01"


class FirmwareVersion(NamedTuple):
    """A version as numbers: compared as text, 1.10 would come before 1.9.

    Attributes:
        major: The first number of ``S-V1.8-9``.
        minor: The second.
        patch: The third.
    """

    major: int
    minor: int
    patch: int

    def __str__(self) -> str:
        return f"S-V{self.major}.{self.minor}-{self.patch}"

    @classmethod
    def parse(cls, text: str) -> FirmwareVersion | None:
        """Return the version in a text such as ``S-V1.8-9``, or ``None`` if it is none."""
        found = _TEXT.fullmatch(text.strip())
        return None if found is None else cls(*map(int, found.groups()))


FIRST: Final = FirmwareVersion(1, 5, 2)
"""The first version of generation 2."""
RECOMMENDED: Final = FirmwareVersion(1, 8, 9)
"""The oldest version that the maker recommends; the simulated arm has it."""


class MitLayout(enum.Enum):
    """The place of the torque in a MIT frame; no bit on the wire tells the two apart."""

    A = "A"  # 8 bits of ±8 N·m and a check of 4 bits
    B = "B"  # 12 bits of ±16 N·m


class ModeExit(enum.Enum):
    """The way from MIT or high-follow back to position-velocity."""

    RESET = "reset"  # 0x150 byte 0 = 2: power is cut and the arm drops
    MODE_WORD = "mode_word"  # 0x151 with the new mode


class FirmwareBug(enum.Enum):
    """A fault of some versions that users reported in public."""

    ZERO_FEEDBACK = "zero_feedback"  # all feedback 0 with 255 in 0x47E
    SILENT_LEADER = "silent_leader"  # 0x470 = 0xFA stops all that it sends, until a power cycle
    TEACHING_EXIT_DROPS = "teaching_exit_drops"  # leaving drag teaching drops the arm
    MIT_MOVES_ZERO = "mit_moves_zero"  # MOVE J, MIT, MOVE J fails and moves the zero of joint 1
    FALLS_BACK_TO_LEADER = "falls_back_to_leader"  # a teaching input again, by itself
    CORRUPTED_LIMITS = "corrupted_limits"  # limits read -0.1° / -0.1°, accelerations 0xFFFF
    FEEDBACK_PARTS = "feedback_parts"  # feedback and true position of a joint part, without a fault


class FirmwareQuirks(NamedTuple):
    """The behaviour of an arm with one firmware version, and the frames it has.

    Attributes:
        version: The version asked for.
        model: The arm asked for.
        mit_code: 0x151 byte 1 and 0x2A1 byte 2 of MOVE M, the MIT mode.
        mit_layout: How a MIT frame carries its torque.
        mit_signs: The factors, 1 or -1, by which a MIT command (position, speed and torque) of
            joints 1-6 is multiplied so that the joint turns as with MOVE J. Feedback is not
            affected.
        mit_torque_factors: The factors by which the firmware multiplies the torque on the wire,
            joints 1-6 (b of the table: 4, 4, 4, 1, 1, 1 up to S-V1.8-2). The host divides by it.
        mode_exit: The way to leave MIT and high-follow. The maker's texts contradict one another
            about S-V1.8-5, so a mode word counts from S-V1.8-6 on.
        exits_by_mode_word: True if a mode word leaves them by the likelier reading of the texts,
            from S-V1.8-5 on; the simulated arm does so.
        shifted_zeros: Joints 2 and 3 count from zeros 2° elsewhere (before S-V1.6-3).
        has_leader_zero: 0x191 sends the leader arm to its zero.
        has_cpv: The firmware has the CPV frames 0x181-0x187.
        cpv_position_signs: The factors for ``po`` of joints 1-6, so that the joint turns as with
            MOVE J.
        cpv_speed_signs: The same for ``sp``.
        has_drag_assistance: 0x487 and 0x488.
        has_ik_solution: 0x2AA-0x2AC, after MOVE P.
        has_upside_down: Mounting 4 of 0x151 byte 5.
        has_gripper_angle: 0x159 byte 6 bit 2.
        disable_frees_gripper: 0x471 «disable» for all joints (7) lets go of the gripper, too.
        bugs: The faults that users reported of this version.
    """

    version: FirmwareVersion
    model: PiperModel
    mit_code: int = 0x04
    mit_layout: MitLayout = MitLayout.A
    mit_signs: SixSigns = (-1, -1, 1, -1, 1, -1)
    mit_torque_factors: SixFactors = (4.0, 4.0, 4.0, 1.0, 1.0, 1.0)
    mode_exit: ModeExit = ModeExit.RESET
    exits_by_mode_word: bool = False
    shifted_zeros: bool = True
    has_leader_zero: bool = False
    has_cpv: bool = False
    cpv_position_signs: SixSigns = _AS_MOVE_J
    cpv_speed_signs: SixSigns = (1, -1, -1, -1, -1, 1)
    has_drag_assistance: bool = False
    has_ik_solution: bool = False
    has_upside_down: bool = False
    has_gripper_angle: bool = False
    disable_frees_gripper: bool = False
    bugs: frozenset[FirmwareBug] = frozenset()


class _Change(NamedTuple):
    since: FirmwareVersion
    models: frozenset[PiperModel]
    fields: dict[str, Any]


_CHANGES: Final = (
    _Change(FIRST, _X, {
        "cpv_position_signs": (1, 1, 1, -1, -1, 1),
        "cpv_speed_signs": (1, -1, -1, 1, 1, 1),
    }),
    _Change(FirmwareVersion(1, 6, 3), _ALL, {"shifted_zeros": False}),
    _Change(FirmwareVersion(1, 7, 3), _ALL, {"mit_signs": _AS_MOVE_J}),
    _Change(FirmwareVersion(1, 7, 4), _ALL, {"has_leader_zero": True}),
    _Change(FirmwareVersion(1, 8, 1), _ALL, {"has_cpv": True, "has_drag_assistance": True}),
    _Change(FirmwareVersion(1, 8, 3), _ALL, {"mit_torque_factors": _ONE}),
    _Change(FirmwareVersion(1, 8, 5), _ALL, {"exits_by_mode_word": True}),
    _Change(FirmwareVersion(1, 8, 6), _ALL, {"mode_exit": ModeExit.MODE_WORD}),
    _Change(FirmwareVersion(1, 8, 8), _ALL, {
        "mit_code": 0x06,
        "mit_layout": MitLayout.B,
        "has_ik_solution": True,
        "has_upside_down": True,
        "has_gripper_angle": True,
    }),
    _Change(FirmwareVersion(1, 8, 8), _X, {"mit_signs": (1, 1, 1, -1, -1, 1)}),
    _Change(FirmwareVersion(1, 8, 9), _X, {"mit_signs": _AS_MOVE_J}),
    _Change(FirmwareVersion(1, 9, 0), _ALL, {"disable_frees_gripper": True}),
)  # fmt: skip
"""The changes in order of versions. No list of changes is public for 1.9-0; it counts as 1.8-9 but
for the gripper, which an owner has reported.
"""

_BUGS: Final = {
    FirmwareVersion(1, 5, 8): frozenset({FirmwareBug.ZERO_FEEDBACK}),
    FirmwareVersion(1, 7, 3): frozenset(
        {FirmwareBug.SILENT_LEADER, FirmwareBug.TEACHING_EXIT_DROPS}
    ),
    FirmwareVersion(1, 8, 2): frozenset(
        {
            FirmwareBug.MIT_MOVES_ZERO,
            FirmwareBug.FALLS_BACK_TO_LEADER,
            FirmwareBug.CORRUPTED_LIMITS,
        }
    ),
    FirmwareVersion(1, 8, 6): frozenset({FirmwareBug.FEEDBACK_PARTS}),
}


def first_with(field: str) -> FirmwareVersion:
    """Return the first version that has a feature: a field of `FirmwareQuirks` named ``has_…``.

    Raises:
        KeyError: No version changed it.
    """
    for change in _CHANGES:
        if change.fields.get(field) is True:
            return change.since
    raise KeyError(field)


@cache
def quirks_of(version: FirmwareVersion, model: PiperModel = PiperModel.PIPER) -> FirmwareQuirks:
    """Return the behaviour of an arm with this firmware.

    Args:
        version: As the arm named it; one before `FIRST` counts as that.
        model: The arm's model; the models differ in their signs.
    """
    quirks = FirmwareQuirks(version, model, bugs=_BUGS.get(version, frozenset()))
    for change in _CHANGES:
        if model in change.models and max(version, FIRST) >= change.since:
            quirks = quirks._replace(**change.fields)
    return quirks


# The arm's identity in its answer to 0x4AF: eleven frames of text, joined (generation 2) -
#
# The frames have no number: one that is lost, or another answer in between, shifts the text, so
# nothing is looked for by its place alone.


class ArmIdentity(NamedTuple):
    """The content of an arm's answer to 0x4AF; "" for each text that could not be read.

    Attributes:
        software: The software version, as ``S-V1.8-5``.
        hardware: The hardware version, as ``H-V1.2-1``; its H does not mean PiPER H.
        node_type: The node type, as ``ARM_MC``.
        batch: The motors' ratio or batch, two figures.
        date: The software's date as six figures: year, month, day.
        node_number: The node's number, as ``15``.
    """

    software: str
    hardware: str = ""
    node_type: str = ""
    batch: str = ""
    date: str = ""
    node_number: str = ""

    def contradicts(self, other: ArmIdentity) -> bool:
        """Return whether a text that both have differs: another arm, or other firmware.

        Node type and batch do not count: a lost frame of an answer shortens them unnoticed.
        """
        ours = self.software, self.hardware, self.date, self.node_number
        theirs = other.software, other.hardware, other.date, other.node_number
        return any(one and two and one != two for one, two in zip(ours, theirs, strict=True))

    @property
    def iso_date(self) -> str:
        """The date as 2025-09-25; the text itself if it is no date, "" if there was none."""
        year, month, day = self.date[:2], self.date[2:4], self.date[4:]
        if "01" <= month <= "12" and "01" <= day <= "31":
            return f"20{year}-{month}-{day}"
        return self.date


def is_question(payload: bytes) -> bool:
    """Return whether a 0x4AF frame is a host's question: 01, alone or padded with zeros."""
    return payload.rstrip(b"\0") == _QUESTION


def find_version(text: bytes) -> str | None:
    """Return the version in the joined payloads of an answer, or ``None`` if it is cut."""
    found = _HEARD_TEXT.search(text)
    return None if found is None else found.group().decode("ascii")


def find_identity(text: bytes) -> ArmIdentity | None:
    """Return the content of joined answers, or ``None`` while they hold no whole version.

    Of several answers the last whole version counts, with the texts before and behind it.
    """
    wholes = list(_HEARD_TEXT.finditer(text))
    if not wholes:
        return None
    software = wholes[-1]
    before = text[max(0, software.start() - ANSWER_BYTES) : software.start()]
    hardware = next(reversed(list(_HARDWARE.finditer(before))), None)
    tokens = _TOKEN.findall(before[hardware.end() :] if hardware else before)
    named = [token for token in tokens if _LETTER.search(token)]
    batches = [token for token in tokens if token.isdigit()]
    date = _DATE.match(text, software.end())
    number = _NODE_NUMBER.match(text, date.end()) if date else None
    return ArmIdentity(
        software=_text(software.group()),
        hardware=_text(hardware.group()) if hardware else "",
        node_type=_text(named[-1]) if named and hardware else "",
        batch=_text(batches[0]) if batches and hardware else "",
        date=_text(date.group(1)) if date else "",
        node_number=_text(number.group(1)) if number else "",
    )


def _text(found: bytes) -> str:
    return found.decode("ascii")


class NamedVersion(NamedTuple):
    """A version in an arm's answer.

    Attributes:
        software: The version, as ``S-V1.8-5``.
        date: The six figures behind it; "" if other text is there, or none yet.
        began_s: The time of the frame in which its text begins.
    """

    software: str
    date: str
    began_s: float


class AnswerCollector:
    """Joins the frames of 0x4AF, and reads their content as they arrive.

    Attributes:
        identity: The arm's identity by its answers so far.
        named: The versions in the last answers, each with its time, the oldest first.
    """

    def __init__(self) -> None:
        self._text = bytearray()
        self._times_s: list[float] = []
        self.identity: ArmIdentity | None = None
        self.named: tuple[NamedVersion, ...] = ()

    def take(self, payload: bytes, at_s: float) -> ArmIdentity | None:
        """Add one frame of an answer, and return the arm's identity as known by then.

        Args:
            payload: Eight bytes; host questions must not be passed.
            at_s: The time of reception.
        """
        if self._times_s and not 0.0 <= at_s - self._times_s[-1] <= ANSWER_S:
            self._text.clear()
            self._times_s.clear()
        self._text += payload
        self._times_s += [at_s] * len(payload)
        whole = len(self._text) % ANSWER_BYTES == 0
        del self._text[: -2 * ANSWER_BYTES], self._times_s[: -2 * ANSWER_BYTES]
        self.named = tuple(
            NamedVersion(
                _text(found.group()),
                _text(date.group(1)) if (date := _DATE.match(self._text, found.end())) else "",
                self._times_s[found.start()],
            )
            for found in _HEARD_TEXT.finditer(self._text)
        )
        found = find_identity(bytes(self._text))
        if found is not None and not _less(found, self.identity, whole=whole):
            self.identity = found
        return self.identity


def _less(found: ArmIdentity, known: ArmIdentity | None, *, whole: bool) -> bool:
    """Return whether it has less than is known of the same version: the answer is incomplete.

    Other texts for the same version count once the answer is whole: a lost frame shifts them.
    """
    if known is None or found.software != known.software:
        return False
    if sum(map(bool, found)) < sum(map(bool, known)):
        return True
    return found.contradicts(known) and not whole
