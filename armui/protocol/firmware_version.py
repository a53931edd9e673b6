"""What a firmware version of generation 2 does: the versions in order, and what each changed.

The facts are those of the table of firmware versions: public texts and code up to autumn 2026. A
row of `_CHANGES` stands for what is different from that version on; nothing else asks for a number.
"""

from __future__ import annotations

import enum
import re
from functools import cache
from typing import Any, Final, NamedTuple

from armui.protocol.piper_model import PiperModel

_TEXT: Final = re.compile(r"S-V(\d{1,3})\.(\d{1,3})-(\d{1,3})")


class FirmwareVersion(NamedTuple):
    """A version as numbers: as text 1.10 would stand before 1.9.

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
        """The version that a text is, as ``S-V1.8-9``; ``None`` if it is none."""
        found = _TEXT.fullmatch(text.strip())
        return None if found is None else cls(*map(int, found.groups()))


FIRST: Final = FirmwareVersion(1, 5, 2)
"""The first version of generation 2."""
RECOMMENDED: Final = FirmwareVersion(1, 8, 9)
"""The maker recommends this one or a later one; the simulated arm has it."""


class MitLayout(enum.Enum):
    """Where the torque stands in a MIT frame; no bit on the wire tells the two apart."""

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


SixSigns = tuple[int, int, int, int, int, int]
SixFactors = tuple[float, float, float, float, float, float]

_AS_MOVE_J: Final[SixSigns] = (1, 1, 1, 1, 1, 1)


class FirmwareQuirks(NamedTuple):
    """What an arm with one firmware version does, and which frames it has.

    Attributes:
        version: The version asked for.
        model: The arm asked for.
        mit_code: 0x151 byte 1 and 0x2A1 byte 2 of MOVE M, the MIT mode.
        mit_layout: How a MIT frame carries its torque.
        mit_signs: What a MIT command (position, speed and torque) of joints 1-6 is multiplied with
            to turn the joint as MOVE J does: 1 or -1. Feedback isn't affected.
        mit_signs_known: Whether the signs were seen on an arm of this model; else they are the
            PiPER's, or unflipped.
        mit_torque_factors: What the firmware multiplies the torque on the wire with, joints 1-6 (b
            of the table: 4, 4, 4, 1, 1, 1 up to S-V1.8-2). The host divides by it.
        mit_torque_nm: The largest torque on the wire.
        mode_exit: How MIT and high-follow are left. The maker's texts contradict one another about
            S-V1.8-5, so a mode word counts from S-V1.8-6 on.
        exits_by_mode_word: Whether a mode word does leave them in the better reading of the texts,
            from S-V1.8-5 on: what a simulated arm does.
        shifted_zeros: Joints 2 and 3 count from zeros 2° elsewhere (before S-V1.6-3).
        has_friction: 0x47D and 0x47E byte 2, the teaching handle's friction.
        has_leader_zero: 0x191 sends the leader arm to its zero.
        has_cpv: 0x181-0x187.
        cpv_position_signs: What ``po`` of joints 1-6 is multiplied with to turn as MOVE J does.
        cpv_speed_signs: The same for ``sp``.
        has_drag_assistance: 0x487 and 0x488.
        has_ik_solution: 0x2AA-0x2AC, after MOVE P.
        has_upside_down: Mounting 4 of 0x151 byte 5.
        has_gripper_angle: 0x159 byte 6 bit 2.
        bugs: What users reported of this very version.
    """

    version: FirmwareVersion
    model: PiperModel
    mit_code: int = 0x04
    mit_layout: MitLayout = MitLayout.A
    mit_signs: SixSigns = (-1, -1, 1, -1, 1, -1)
    mit_signs_known: bool = True
    mit_torque_factors: SixFactors = (4.0, 4.0, 4.0, 1.0, 1.0, 1.0)
    mit_torque_nm: float = 8.0
    mode_exit: ModeExit = ModeExit.RESET
    exits_by_mode_word: bool = False
    shifted_zeros: bool = True
    has_friction: bool = False
    has_leader_zero: bool = False
    has_cpv: bool = False
    cpv_position_signs: SixSigns = _AS_MOVE_J
    cpv_speed_signs: SixSigns = (1, -1, -1, -1, -1, 1)
    has_drag_assistance: bool = False
    has_ik_solution: bool = False
    has_upside_down: bool = False
    has_gripper_angle: bool = False
    bugs: frozenset[FirmwareBug] = frozenset()


_ALL: Final = frozenset(PiperModel)
_X: Final = frozenset({PiperModel.PIPER_X})
_HLX: Final = _ALL - {PiperModel.PIPER}
_ONE: Final[SixFactors] = (1.0,) * 6


class _Change(NamedTuple):
    since: FirmwareVersion
    models: frozenset[PiperModel]
    fields: dict[str, Any]


_CHANGES: Final = (
    _Change(FIRST, _HLX, {"mit_signs_known": False}),
    _Change(FIRST, _X, {
        "cpv_position_signs": (1, 1, 1, -1, -1, 1),
        "cpv_speed_signs": (1, -1, -1, 1, 1, 1),
    }),
    _Change(FirmwareVersion(1, 5, 8), _ALL, {"has_friction": True}),
    _Change(FirmwareVersion(1, 6, 3), _ALL, {"shifted_zeros": False}),
    _Change(FirmwareVersion(1, 7, 3), _ALL, {"mit_signs": _AS_MOVE_J}),
    _Change(FirmwareVersion(1, 7, 3), _HLX - _X, {"mit_signs_known": True}),
    _Change(FirmwareVersion(1, 7, 4), _ALL, {"has_leader_zero": True}),
    _Change(FirmwareVersion(1, 8, 1), _ALL, {"has_cpv": True, "has_drag_assistance": True}),
    _Change(FirmwareVersion(1, 8, 3), _ALL, {"mit_torque_factors": _ONE}),
    _Change(FirmwareVersion(1, 8, 5), _ALL, {"exits_by_mode_word": True}),
    _Change(FirmwareVersion(1, 8, 6), _ALL, {"mode_exit": ModeExit.MODE_WORD}),
    _Change(FirmwareVersion(1, 8, 8), _ALL, {
        "mit_code": 0x06,
        "mit_layout": MitLayout.B,
        "mit_torque_nm": 16.0,
        "has_ik_solution": True,
        "has_upside_down": True,
        "has_gripper_angle": True,
    }),
    _Change(FirmwareVersion(1, 8, 8), _X, {
        "mit_signs": (1, 1, 1, -1, -1, 1), "mit_signs_known": True,
    }),
    _Change(FirmwareVersion(1, 8, 9), _X, {"mit_signs": _AS_MOVE_J}),
)  # fmt: skip
"""In order of versions; of 1.9-0 no list of changes is public, it counts as 1.8-9."""

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
    """The first version in which a field of `FirmwareQuirks` that begins with ``has_`` holds.

    Raises:
        KeyError: No version changed it.
    """
    for change in _CHANGES:
        if change.fields.get(field) is True:
            return change.since
    raise KeyError(field)


@cache
def quirks_of(version: FirmwareVersion, model: PiperModel = PiperModel.PIPER) -> FirmwareQuirks:
    """What an arm with this firmware does.

    Args:
        version: As the arm named it; one before `FIRST` counts as that.
        model: The arm; what differs between the models is the signs.
    """
    quirks = FirmwareQuirks(version, model, bugs=_BUGS.get(version, frozenset()))
    for change in _CHANGES:
        if model in change.models and max(version, FIRST) >= change.since:
            quirks = quirks._replace(**change.fields)
    return quirks
