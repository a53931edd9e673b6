"""What is asked of which operation, what cannot be asked, and what is known to be broken."""

from __future__ import annotations

import enum
from collections.abc import Iterable, Mapping
from typing import Final

import pytest

from tests.safety.operations_table import ENTRIES, LEAD, STAND


class Question(enum.Enum):
    """A promise that can be asked of any operation."""

    FRAMES = "it sends what it is said to send"
    MOVES = "S9, S13: what sends a motion frame is declared to move, and so is refused"
    STOP = "S1, S2, S10: the stop is heard while it works, and it is not revived"
    HALT = "S10, S26: the halt is heard while it works, and it is not revived"
    UNHEARD = "S9: no motion frame while the arm is not heard"
    SPEED = "S12: never faster than shown"
    OTHER_HOST = "S13: no motion frame beside another host's"
    LATE = "S14: its first frame leaves within 1 s or not at all"
    EXCEPTION = "S23: an exception in its way ends every motion, is told, and leaves the stop alone"
    THREAD = "S2: it holds the window's thread for less than 20 ms in a cell of 20 boxes"
    ZONE = "S32: it leads into no zone"
    SMALL = "S32: nor by small steps"
    SECOND = "S32: nor begun while another motion is under way"
    LIMIT = "S36: nothing leads further beyond a limit"
    REST = "S36: nor out of the rest pose"
    AREA = "S36: nor deeper into a work area"
    FLOOR = "S36: nor further below the floor"
    BACK_LIMIT = "S36: back within a limit it may go"
    BACK_REST = "S36: and out of the rest pose"
    BACK_AREA = "S36: and out of a work area"
    BACK_FLOOR = "S36: and up from below the floor"


Reasons = Mapping[str, Iterable[str]]
"""Operations by the reason why something is not asked of them."""

_NO_LEAD: Final[Reasons] = {"It leads the arm nowhere.": [n for n in ENTRIES if n not in LEAD]}
_GOES_ON: Final[Reasons] = {
    "It goes on with a motion that was begun before: the one that begins it is asked.": (
        *("run.go_on", "replay.go_on", "planned.command"),
    )
}
_FIXED: Final[Reasons] = {
    "Where it leads is its own, and not this way.": ("motion.home", "reference.drive"),
    "The arm follows its own recording: no frame of this program says where.": (
        "teaching.command",
    ),
}
_BACK: Final[Reasons] = {
    **_NO_LEAD,
    **_GOES_ON,
    "It is no way for the operator to bring an arm back.": (
        *("reference.drive", "teaching.command"),
    ),
}
_NO_LINE: Final[Reasons] = {
    "The arm takes no line or arc that begins outside its limits: the way inside comes first.": (
        *("tool.step", "tool.arc"),
    ),
}

NOT_ASKED: Final[Mapping[Question, Reasons]] = {
    Question.MOVES: {
        "It is the operator's choice, kept in any state, and told where it sets nothing going: to "
        "refuse it would keep a motion under way from being slowed.": ("motion.set_speed",),
    },
    Question.HALT: {
        "It sends no motion frame, and a halt is no reason against it.": [
            name for name in STAND if name not in {"run.pause", "replay.pause"}
        ],
    },
    Question.LATE: {"It asks the arm, and changes nothing in it.": ("settings.read",)},
    Question.SPEED: {
        "It sends no motion frame.": STAND,
        "The gripper has no speed percentage.": ("gripper.move", "gripper.enable"),
        "The arm replays at the speed of its own recording.": ("teaching.command",),
    },
    Question.THREAD: {
        **_NO_LEAD,
        **_GOES_ON,
        "It is refused while zones are on.": ("teaching.command",),
    },
    Question.ZONE: _NO_LEAD,
    Question.SMALL: {
        **_NO_LEAD,
        **_GOES_ON,
        **_FIXED,
        "Each is a run of its own, which nobody begins sixty times.": ("run.start", "replay.start"),
    },
    Question.SECOND: {
        **_NO_LEAD,
        **_GOES_ON,
        **_FIXED,
        "It begins where the motion before ends, so that its straight way is another.": (
            *("motion.step", "tool.step", "tool.arc", "jog.begin"),
        ),
    },
    Question.LIMIT: {
        **_NO_LEAD,
        "The arm keeps its limits in its own recording: no frame names a place.": (
            "teaching.command",
        ),
    },
    Question.REST: {
        **_NO_LEAD,
        "The arm keeps its limits in its own recording: no frame names a place.": (
            "teaching.command",
        ),
    },
    Question.AREA: _NO_LEAD,
    Question.FLOOR: _NO_LEAD,
    Question.BACK_LIMIT: {**_BACK, **_NO_LINE},
    Question.BACK_REST: {
        **_BACK,
        **_NO_LINE,
        "It turns one joint or shifts the hand, and several joints have to come back.": (
            *("motion.step", "jog.begin"),
        ),
    },
    Question.BACK_AREA: _BACK,
    Question.BACK_FLOOR: _BACK,
}
"""What cannot be asked of an operation, and why."""

KNOWN: Final[Mapping[tuple[Question, str], str]] = {}
"""What is broken today, with the figure that was seen."""


def excused(question: Question) -> dict[str, str]:
    """Each operation that a question is not asked of, with the reason."""
    return {name: reason for reason, names in NOT_ASKED.get(question, {}).items() for name in names}


def asked(question: Question) -> pytest.MarkDecorator:
    """Ask a question of every operation that it can be asked of."""
    left_out = excused(question)
    cases = [
        pytest.param(
            name,
            marks=[pytest.mark.xfail(strict=True, raises=AssertionError, reason=known)]
            if (known := KNOWN.get((question, name)))
            else [],
        )
        for name in ENTRIES
        if name not in left_out
    ]
    return pytest.mark.parametrize("name", cases)
